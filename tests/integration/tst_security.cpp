// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Encryption, certificates and users, over real sockets.

#include <QTemporaryDir>
#include <QtTest>
#include <array>
#include <atomic>
#include <filesystem>
#include <map>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include "base/contract.h"
#include "base/file.h"
#include "machine/config.h"
#include "machine/front/clients.h"
#include "machine/front/login.h"
#include "machine/front/server.h"
#include "machine/machine.h"
#include "opcua/await.h"
#include "opcua/certificate.h"
#include "opcua/open62541/encryption.h"
#include "opcua/open62541/ua_link.h"
#include "opcua/revocation.h"
#include "opcua/user_certificate.h"
#include "support/plain_server.h"
#include "support/test_program.h"
#include "trust/connect.h"
#include "trust/trust_store.h"

using namespace rivulet;
using namespace std::chrono_literals;
using opcua::LinkError;

namespace {

constexpr const char* kPassword = "correct horse";

/// Keys take time; all tests of this file share these.
const opcua::OwnCertificate& certificateOf(const std::string& name) {
  static std::map<std::string, opcua::OwnCertificate> made;
  if (!made.contains(name)) {
    auto certificate = opcua::makeCertificate({name, "urn:test:" + name, {"localhost"}, 30});
    RIVULET_ASSERT(certificate.has_value());
    made[name] = *certificate;
  }
  return made[name];
}

machine::User user(const std::string& name, std::set<std::string> rights) {
  return {name, machine::hashPassword(kPassword, "salt of " + name), std::move(rights)};
}

/// A virtual machine with a thread of its own.
class Cell {
 public:
  explicit Cell(machine::ServerOptions options, machine::UserManagement users = {})
      : m_machine(config(std::move(users)), 1) {
    auto server = machine::Server::start(m_machine, options);
    RIVULET_ASSERT(server.has_value());
    m_server = std::move(*server);
    m_thread = std::thread([this] { m_server->run(m_stop); });
  }
  ~Cell() {
    m_stop = true;
    m_thread.join();
  }
  Cell(const Cell&) = delete;
  Cell& operator=(const Cell&) = delete;

  [[nodiscard]] const std::string& endpoint() const { return m_server->endpoint(); }

 private:
  static machine::MachineConfig config(machine::UserManagement users) {
    auto config = machine::loadPreset("ideal");
    RIVULET_ASSERT(config.has_value());
    config->users = std::move(users);
    return std::move(*config);
  }

  machine::Machine m_machine;
  std::unique_ptr<machine::Server> m_server;
  std::atomic<bool> m_stop{false};
  std::thread m_thread;
};

machine::ServerOptions encrypted() {
  machine::ServerOptions options;
  options.certificate = certificateOf("machine");
  options.unencrypted = false;
  return options;
}

base::Result<void> trustAll(const opcua::CertificateFacts&, std::string_view) {
  return {};
}

opcua::ConnectOptions client(const Cell& cell, const std::string& security = "strongest") {
  opcua::ConnectOptions options;
  options.endpoint = cell.endpoint();
  options.connectDeadline = 20s;
  options.commandDeadline = 20s;
  const auto choice = opcua::securityChoiceOf(security);
  RIVULET_ASSERT(choice.has_value());
  options.security = *choice;
  options.own = [] { return base::Result<opcua::OwnCertificate>(certificateOf("client")); };
  options.trust = &trustAll;
  return options;
}

opcua::ConnectOptions login(opcua::ConnectOptions options, const std::string& name,
                            const std::string& password) {
  options.user = name;
  options.password = password;
  return options;
}

opcua::UserCertificate userCertificate(const std::string& name) {
  const opcua::OwnCertificate& made = certificateOf(name);
  return {made.certificate, made.privateKey};
}

opcua::ConnectOptions loginByCertificate(opcua::ConnectOptions options,
                                         opcua::UserCertificate certificate) {
  options.userCertificate = std::move(certificate);
  return options;
}

std::string fingerprintOf(const std::string& name) {
  return opcua::readCertificate(certificateOf(name).certificate)->fingerprint;
}

/// Without a password. @param certificate  name of `certificateOf`
machine::User certifiedUser(const std::string& name, std::set<std::string> rights,
                            const std::string& certificate) {
  return {name, {}, std::move(rights), fingerprintOf(certificate)};
}

machine::UserManagement only(std::vector<machine::User> users) {
  return {false, std::move(users)};
}

std::string element(char tag, const std::string& content) {
  RIVULET_ASSERT(content.size() < 65536);
  std::string head{tag, '\x82'};
  head += static_cast<char>(content.size() / 256);
  head += static_cast<char>(content.size() % 256);
  return head + content;
}

/// The first element of a text, as a whole. @param rest  what comes after it
std::string firstElement(std::string_view text, std::string_view* rest = nullptr) {
  const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(text[at]); };
  std::size_t length = 2 + byte(1);
  if (byte(1) > 0x80) {
    length = 2 + (byte(1) & 0x7FU);
    std::size_t content = 0;
    for (std::size_t i = 2; i < length; ++i) {
      content = 256 * content + byte(i);
    }
    length += content;
  }
  if (rest != nullptr) {
    *rest = text.substr(length);
  }
  return std::string(text.substr(0, length));
}

/// What the issuer of a certificate would give out to revoke it.
std::string listThatRevokes(const std::string& certificate) {
  constexpr char kSequence = 0x30;
  const std::size_t headBytes = 4;  // a certificate is longer than 255 bytes
  std::string_view rest = std::string_view(certificate).substr(2 * headBytes);
  firstElement(rest, &rest);  // version
  const std::string serial = firstElement(rest, &rest);
  const std::string algorithm = firstElement(rest, &rest);
  const std::string issuer = firstElement(rest);
  const std::string now =
      "\x17\x0d"
      "260101000000Z";
  return element(kSequence,
                 element(kSequence, algorithm + issuer + now +
                                        element(kSequence, element(kSequence, serial + now))));
}

const opcua::Variable kFirst = opcua::rParameter(0);

}  // namespace

class TestSecurity : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyPolicyAndModeWorks_data() {
    QTest::addColumn<QString>("security");
    for (const char* policy : {"Basic256Sha256", "Aes128_Sha256_RsaOaep", "Aes256_Sha256_RsaPss"}) {
      for (const char* mode : {"Sign", "SignAndEncrypt"}) {
        const QString name =
            QStringLiteral("%1/%2").arg(QLatin1String(policy), QLatin1String(mode));
        QTest::newRow(qPrintable(name)) << name;
      }
    }
  }

  void everyPolicyAndModeWorks() {
    QFETCH(QString, security);
    const Cell cell(encrypted());
    const auto link = opcua::UaLink::connect(client(cell, security.toStdString()));
    QVERIFY2(link, link ? "" : link.error().text().c_str());
    QCOMPARE(QString::fromStdString(opcua::securityText((*link)->security())),
             QString(security).replace(QLatin1Char('/'), QStringLiteral(", ")));
    const std::array assignment{opcua::Assignment{kFirst, 1.5}};
    QVERIFY(opcua::writeNow(**link, assignment, 20s));
    const auto numbers = opcua::readNumbers(**link, {&kFirst, 1}, 20s);
    QVERIFY(numbers);
    QCOMPARE(numbers->front(), 1.5);
  }

  void theStrongestIsTaken() {
    machine::ServerOptions options = encrypted();
    options.unencrypted = true;
    const Cell cell(options);
    const auto link = opcua::UaLink::connect(client(cell));
    QVERIFY(link);
    QCOMPARE(opcua::securityText((*link)->security()),
             std::string("Aes256_Sha256_RsaPss, SignAndEncrypt"));
    QVERIFY((*link)->serverCertificate());
    QCOMPARE((*link)->serverCertificate()->subject, std::string("CN=machine, O=Rivulet"));
  }

  void withoutEncryptionNobodyIsLetIn() {
    const Cell cell(encrypted());
    opcua::ConnectOptions options = client(cell);
    options.security = opcua::unencrypted();
    const auto refused = opcua::UaLink::connect(options);
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, make_error_code(LinkError::EncryptionMissing));
  }

  void noneIsRefusedUnlessItIsNamed() {
    machine::ServerOptions plain;
    const Cell cell(plain);
    const auto refused = opcua::UaLink::connect(client(cell));
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, make_error_code(LinkError::EncryptionMissing));
    QVERIFY(refused.error().message.find("It offers: None") != std::string::npos);
    QVERIFY(opcua::UaLink::connect(client(cell, "none")));
  }

  void anUntrustedServerIsNotConnected() {
    const Cell cell(encrypted());
    opcua::ConnectOptions options = client(cell);
    std::string seen;
    options.trust = [&](const opcua::CertificateFacts& facts,
                        std::string_view) -> base::Result<void> {
      seen = facts.fingerprint;
      return base::fail(LinkError::CertificateUnknown, "not known");
    };
    const auto refused = opcua::UaLink::connect(options);
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, make_error_code(LinkError::CertificateUnknown));
    QCOMPARE(seen, opcua::readCertificate(certificateOf("machine").certificate)->fingerprint);
  }

  void anUntrustedClientIsRefusedAndKept() {
    std::string refusedFingerprint;
    machine::ServerOptions options = encrypted();
    options.trustedClients = std::set<std::string>{};
    options.onRefusedClient = [&](const opcua::CertificateFacts& facts, std::string_view) {
      refusedFingerprint = facts.fingerprint;
    };
    {
      const Cell cell(options);
      opcua::ConnectOptions asking = client(cell);
      asking.connectDeadline = 2s;
      const auto refused = opcua::UaLink::connect(asking);
      QVERIFY(!refused);
      QVERIFY2(refused.error().code == LinkError::ClientNotTrusted, refused.error().text().c_str());
    }
    const std::string expected =
        opcua::readCertificate(certificateOf("client").certificate)->fingerprint;
    QCOMPARE(refusedFingerprint, expected);

    options.trustedClients = std::set<std::string>{expected};
    const Cell cell(options);
    QVERIFY(opcua::UaLink::connect(client(cell)));
  }

  void onlyUsersWithTheirPasswordAreLetIn() {
    machine::UserManagement users;
    users.anonymous = false;
    users.users = {user("setter", machine::userRights())};
    const Cell cell(encrypted(), users);
    QVERIFY(opcua::UaLink::connect(login(client(cell), "setter", kPassword)));
    for (const auto& [name, password] :
         {std::pair("setter", "wrong"), std::pair("nobody", kPassword), std::pair("setter", "")}) {
      const auto refused = opcua::UaLink::connect(login(client(cell), name, password));
      QVERIFY(!refused);
      QVERIFY2(refused.error().code == LinkError::LoginRefused, refused.error().text().c_str());
      QVERIFY(refused.error().text().find(kPassword) == std::string::npos);
    }
    const auto anonymous = opcua::UaLink::connect(client(cell));
    QVERIFY(!anonymous);
    QCOMPARE(anonymous.error().code, make_error_code(LinkError::LoginRefused));
  }

  void aUserHasTheRightsOfThePreset() {
    machine::UserManagement users;
    users.anonymous = false;
    users.users = {user("reader", {"SinuReadAll", "FsRead"}),
                   user("setter", machine::userRights())};
    const Cell cell(encrypted(), users);

    const auto reader = opcua::UaLink::connect(login(client(cell), "reader", kPassword));
    QVERIFY(reader);
    QCOMPARE((*reader)->accessRights().value_or("?"), std::string("FsRead;SinuReadAll"));
    QVERIFY(opcua::readNumbers(**reader, {&kFirst, 1}, 20s));
    QCOMPARE((*reader)->mayWrite(kFirst).value_or(true), false);
    const std::array assignment{opcua::Assignment{kFirst, 2.0}};
    const auto written = opcua::writeNow(**reader, assignment, 20s);
    QVERIFY(!written);
    QCOMPARE(written.error().code, make_error_code(LinkError::NotWritable));
    QVERIFY(!(*reader)->uploadProgram("A.MPF", "M30\n", true));
    QVERIFY(!(*reader)->selectProgram("A.MPF"));
    QVERIFY(!(*reader)->cycleStart());

    const auto setter = opcua::UaLink::connect(login(client(cell), "setter", kPassword));
    QVERIFY(setter);
    QCOMPARE((*setter)->mayWrite(kFirst).value_or(false), true);
    QVERIFY(opcua::writeNow(**setter, assignment, 20s));
    QVERIFY((*setter)->uploadProgram("A.MPF", "M30\n", true));
    QVERIFY((*setter)->selectProgram("A.MPF"));
    QVERIFY((*reader)->downloadProgram("A.MPF"));
  }

  void aUserLogsInByCertificate() {
    const Cell cell(encrypted(),
                    only({user("reader", {"SinuReadAll", "FsRead"}),
                          certifiedUser("setter", {"StateRead", "StateWrite"}, "setter")}));
    for (const char* security : {"strongest", "Basic256Sha256", "Aes128_Sha256_RsaOaep/Sign"}) {
      const auto link = opcua::UaLink::connect(
          loginByCertificate(client(cell, security), userCertificate("setter")));
      QVERIFY2(link, link ? "" : link.error().text().c_str());
      QCOMPARE((*link)->accessRights().value_or("?"), std::string("StateRead;StateWrite"));
      QCOMPARE((*link)->mayWrite(kFirst).value_or(false), true);
    }
    // The other way in is still there, but not for who has no password.
    QVERIFY(opcua::UaLink::connect(login(client(cell), "reader", kPassword)));
    QVERIFY(!opcua::UaLink::connect(login(client(cell), "setter", kPassword)));
    QVERIFY(!opcua::UaLink::connect(login(client(cell), "setter", "")));
    QVERIFY(!opcua::UaLink::connect(client(cell)));
  }

  void aCertificateIsNothingWithoutItsKey() {
    const Cell cell(encrypted(), only({certifiedUser("setter", {"StateRead"}, "setter")}));
    const opcua::UserCertificate stolen{certificateOf("setter").certificate,
                                        certificateOf("client").privateKey};
    for (const auto& shown : {stolen, userCertificate("client")}) {
      const auto refused = opcua::UaLink::connect(loginByCertificate(client(cell), shown));
      QVERIFY(!refused);
      QVERIFY2(refused.error().code == LinkError::LoginRefused, refused.error().text().c_str());
    }
    const auto mixed = opcua::readUserCertificate(stolen.certificate, stolen.privateKey);
    QVERIFY(!mixed && mixed.error().message.find("does not belong") != std::string::npos);
    QVERIFY(opcua::readUserCertificate(certificateOf("setter").certificate,
                                       certificateOf("setter").privateKey));
  }

  void aServerWithoutSuchUsersTakesNoCertificate() {
    const Cell cell(encrypted(), only({user("setter", machine::userRights())}));
    const auto refused =
        opcua::UaLink::connect(loginByCertificate(client(cell), userCertificate("setter")));
    QVERIFY(!refused);
    QVERIFY2(refused.error().message.find("takes no certificate") != std::string::npos,
             refused.error().text().c_str());
  }

  void theServerRefusesWhatIsRevoked() {
    machine::ServerOptions options = encrypted();
    const auto list =
        opcua::readRevocationList(listThatRevokes(certificateOf("setter").certificate));
    QVERIFY(list.has_value());
    options.revocations = {*list};
    const Cell cell(options, only({certifiedUser("setter", {"StateRead"}, "setter"),
                                   certifiedUser("other", {"StateRead"}, "client")}));
    const opcua::ConnectOptions other = loginByCertificate(client(cell), userCertificate("client"));
    QVERIFY(opcua::UaLink::connect(other));
    const auto user =
        opcua::UaLink::connect(loginByCertificate(client(cell), userCertificate("setter")));
    QVERIFY(!user);
    QVERIFY2(user.error().code == LinkError::LoginRefused, user.error().text().c_str());
    QVERIFY2(user.error().message.find("revoked") != std::string::npos,
             user.error().text().c_str());
    opcua::ConnectOptions computer = other;
    computer.own = [] { return base::Result<opcua::OwnCertificate>(certificateOf("setter")); };
    QVERIFY(!opcua::UaLink::connect(computer));
  }

  void theClientRefusesWhatIsRevoked() {
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.path().toStdString();
    const trust::TrustStore store(path);
    const Cell cell(encrypted(), only({certifiedUser("setter", {"StateRead"}, "setter")}));
    opcua::ConnectRequest request{cell.endpoint()};
    request.userCertificate = userCertificate("setter");
    request.fingerprint = fingerprintOf("machine");
    const opcua::Attempt before = trust::connect(request, path);
    QVERIFY2(before.connection, before.connection ? "" : before.connection.error().text().c_str());

    const auto whyRefused = [&] {
      const opcua::Attempt attempt = trust::connect(request, path);
      return attempt.connection ? std::string() : attempt.connection.error().message;
    };
    QVERIFY(store.addRevocations(listThatRevokes(certificateOf("machine").certificate)));
    QVERIFY2(whyRefused().find("of the server has been revoked") != std::string::npos,
             whyRefused().c_str());
    QVERIFY(store.addRevocations(listThatRevokes(certificateOf("setter").certificate)));
    QCOMPARE(store.revocations()->size(), std::size_t{2});
    QVERIFY2(whyRefused().find("of the user has been revoked") != std::string::npos,
             whyRefused().c_str());

    // A list that cannot be read is not taken for an empty one.
    QVERIFY(base::writeFile(path / "revoked" / "damaged.crl", "nothing"));
    QVERIFY(whyRefused().find("no revocation list") != std::string::npos);
  }

  void anOlderListDoesNotReplaceANewerOne() {
    const QTemporaryDir folder;
    const trust::TrustStore store(folder.path().toStdString());
    const std::string list = listThatRevokes(certificateOf("machine").certificate);
    std::string older = list;
    older.replace(older.find("260101"), 6, "250101");
    QVERIFY(store.addRevocations(older));
    QVERIFY(store.addRevocations(list));
    QVERIFY(!store.addRevocations(older));
    QCOMPARE(store.revocations()->size(), std::size_t{1});
  }

  void aNewServerIsAskedAboutOnce() {
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.path().toStdString();
    machine::ServerOptions options = encrypted();
    options.unencrypted = true;
    const Cell cell(options);
    // On this computer, what was never encrypted need not be.
    const opcua::Attempt local = trust::connect({cell.endpoint()}, path);
    QVERIFY2(local.connection, local.connection ? "" : local.connection.error().text().c_str());
    QCOMPARE(*local.connection->security, opcua::ChannelSecurity{});
    QCOMPARE(opcua::protectionOf(*local.connection->security, cell.endpoint()),
             opcua::Protection::LocalOnly);

    opcua::ConnectRequest request{cell.endpoint()};
    request.security = opcua::SecurityChoice{};
    const opcua::Attempt unknown = trust::connect(request, path);
    QVERIFY(!unknown.connection);
    QVERIFY(unknown.question);
    QCOMPARE(unknown.question->kind, opcua::TrustQuestion::Kind::NewServer);
    QVERIFY(unknown.question->isValidNow);
    QCOMPARE(trust::TrustStore(path).rejected().size(), std::size_t{1});
    request.fingerprint = std::string(64, 'a');
    QVERIFY(!trust::connect(request, path).connection);
    request.fingerprint = unknown.question->shown.fingerprint;
    QVERIFY(trust::connect(request, path).connection);
    QVERIFY(trust::TrustStore(path).rejected().empty());
    const opcua::Attempt known = trust::connect({cell.endpoint()}, path);
    QVERIFY2(known.connection, known.connection ? "" : known.connection.error().text().c_str());
    QCOMPARE(known.connection->security->mode, opcua::MessageMode::SignAndEncrypt);
  }

  /// A certificate that was made for another application may be a copy.
  void aCertificateOfAnotherApplicationIsSaid() {
    const tests::PlainServer server({{"X", 0.0}}, {}, {}, {}, {}, tests::PlainServer::Kind::Server,
                                    &certificateOf("server"));
    const QTemporaryDir folder;
    const std::filesystem::path store = folder.path().toStdString();
    opcua::ConnectRequest request;
    request.endpoint = server.endpoint();
    request.security = opcua::SecurityChoice{};
    request.nodes[{opcua::VariableKind::ActualPosition, 0}] = "ns=1;s=X";
    const std::string stranger =
        "made for another application (urn:test:server) than the server says it is (urn:";
    auto attempt = trust::connect(request, store);
    QVERIFY(!attempt.connection && attempt.question);
    const std::string said = attempt.connection.error().text();
    QVERIFY2(said.find(stranger) != std::string::npos, said.c_str());
    QVERIFY(!attempt.question->shown.strangerUri.empty());
    request.fingerprint = attempt.question->shown.fingerprint;
    attempt = trust::connect(request, store);
    QVERIFY2(attempt.connection,
             attempt.connection ? "" : attempt.connection.error().text().c_str());
    QVERIFY(trust::warningOn(*attempt.connection).find(stranger) != std::string::npos);
    // One of its own needs no word.
    Cell cell(encrypted());
    request.endpoint = cell.endpoint();
    request.nodes.clear();
    request.fingerprint = fingerprintOf("machine");
    attempt = trust::connect(request, store);
    QVERIFY2(attempt.connection,
             attempt.connection ? "" : attempt.connection.error().text().c_str());
    QCOMPARE(trust::warningOn(*attempt.connection), std::string());
  }

  void aChangedServerIsAskedAboutWithBothCertificates() {
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.path().toStdString();
    const Cell cell(encrypted());
    const std::string& before = certificateOf("before").certificate;
    const auto facts = opcua::readCertificate(before);
    QVERIFY(facts);
    const trust::TrustStore store(path);
    QVERIFY(store.accept(cell.endpoint(), *facts, before));
    const opcua::Attempt changed = trust::connect({cell.endpoint()}, path);
    QVERIFY(!changed.connection && changed.question);
    QCOMPARE(changed.question->kind, opcua::TrustQuestion::Kind::ChangedServer);
    QCOMPARE(changed.question->acceptedFingerprint, facts->fingerprint);
    QVERIFY(changed.question->accepted && *changed.question->accepted == *facts);
    QVERIFY(changed.question->wasEncrypted);
    const std::string shown = changed.question->shown.fingerprint;
    QVERIFY(shown != facts->fingerprint);
    const auto rejected = store.rejected();
    QCOMPARE(rejected.size(), std::size_t{1});
    QCOMPARE(rejected.front().endpoint, cell.endpoint());
    QVERIFY(store.acceptRejected(shown));
    QVERIFY(store.rejected().empty());
    QVERIFY(trust::connect({cell.endpoint()}, path).connection);
    QVERIFY(!store.acceptRejected("../servers"));
  }

  void aServerWithoutEncryptionHasToBeNamedOnce() {
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.path().toStdString();
    const Cell cell(machine::ServerOptions{});
    opcua::ConnectRequest request{cell.endpoint()};
    request.security = opcua::SecurityChoice{};
    const opcua::Attempt refused = trust::connect(request, path);
    QVERIFY(!refused.connection && refused.question);
    QCOMPARE(refused.connection.error().code, make_error_code(LinkError::EncryptionMissing));
    QCOMPARE(refused.question->kind, opcua::TrustQuestion::Kind::Protection);
    QCOMPARE(refused.question->choices, std::vector{opcua::unencrypted()});
    request.user = "setter";  // its password could be read
    const opcua::Attempt withUser = trust::connect(request, path);
    QVERIFY(!withUser.connection && withUser.question);
    QVERIFY(withUser.question->choices.empty());
    request.user.clear();
    request.security = refused.question->choices.front();
    QVERIFY(trust::connect(request, path).connection);
    const auto known = trust::TrustStore(path).find(cell.endpoint());
    QVERIFY(known && *known);
    QCOMPARE((*known)->security, std::string("None"));
  }

  void whatSeveralProgramsAllowAtATimeStays() {
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.path().toStdString();
    constexpr int kPrograms = 4;
    constexpr int kServersOfEach = 10;
    std::vector<std::thread> programs;
    for (int program = 0; program < kPrograms; ++program) {
      programs.emplace_back([path, program] {
        for (int i = 0; i < kServersOfEach; ++i) {
          const std::string endpoint =
              "opc.tcp://machine-" + std::to_string(program * kServersOfEach + i);
          static_cast<void>(trust::TrustStore(path).allow(endpoint, "Basic256Sha256"));
        }
      });
    }
    for (std::thread& program : programs) {
      program.join();
    }
    const auto known = trust::TrustStore(path).servers();
    QVERIFY(known);
    QCOMPARE(known->size(), std::size_t{kPrograms * kServersOfEach});
  }

  void aDamagedListOfServersIsNotTakenForEmpty() {
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.path().toStdString();
    const trust::TrustStore store(path);
    for (const char* text :
         {"", "{", "[]", R"({"format":"rivulet-servers","servers":[{}]})",
          R"({"format":"rivulet-servers","servers":[{"endpoint":"a","fingerprint":"b"}]})"}) {
      QVERIFY(base::writeFile(path / "servers.json", text));
      QVERIFY2(!store.servers(), text);
    }
  }

  /// Whoever guesses is locked out, longer each time; the user elsewhere is not.
  void wrongPasswordsLockAUserWhereTheyCameFrom() {
    machine::UserManagement users;
    users.users = {user("setter", {})};
    machine::Login book(users);
    base::Instant now{};
    const auto isIn = [&](const char* password, const char* network) {
      return book.check("setter", password, network, now).user != nullptr;
    };
    for (int i = 1; i <= machine::kWrongPasswordsMax; ++i) {
      const auto outcome = book.check("setter", "wrong", "10.0.0.7", now);
      QVERIFY(outcome.user == nullptr && outcome.failure && outcome.failure->user == "setter");
      QCOMPARE(outcome.failure->wrong, i);
      QCOMPARE(outcome.failure->lockedFor > base::Duration::zero(),
               i == machine::kWrongPasswordsMax);
    }
    QVERIFY(!isIn(kPassword, "10.0.0.7"));
    QVERIFY(!book.check("setter", "wrong", "10.0.0.7", now).failure);  // not told again and again
    QVERIFY(isIn(kPassword, "10.0.0.8"));
    // The right password of the one takes nothing from the lock of the other.
    base::Duration lock = machine::kLockTime;
    for (int i = 0; i < 10; ++i) {
      now += lock - std::chrono::milliseconds(1);
      QVERIFY(!isIn(kPassword, "10.0.0.7"));
      now += std::chrono::milliseconds(1);
      const auto outcome = book.check("setter", "wrong", "10.0.0.7", now);
      lock = std::min<base::Duration>(2 * lock, machine::kLockTimeMax);
      QVERIFY(outcome.failure && outcome.failure->lockedFor == lock);
    }
    now += lock;
    QVERIFY(isIn(kPassword, "10.0.0.7"));
  }

  void networksTellClientsApart() {
    using machine::networkOf;
    QCOMPARE(networkOf("10.0.0.7"), std::string("10.0.0.7"));
    QCOMPARE(networkOf("::ffff:10.0.0.7"), std::string("10.0.0.7"));
    QCOMPARE(networkOf("2001:db8:1:2:3:4:5:6"), networkOf("2001:db8:1:2::9"));
    QVERIFY(networkOf("2001:db8:1:2::9") != networkOf("2001:db8:1:3::9"));
    QCOMPARE(networkOf(""), std::string());
  }

  void wrongNamesDoNotLockAUser() {
    machine::UserManagement users;
    users.users = {user("setter", {})};
    machine::Login book(users);
    for (int i = 0; i < 2 * machine::kWrongPasswordsMax; ++i) {
      QVERIFY(book.check("guess", "wrong", "10.0.0.7", base::Instant{}).user == nullptr);
    }
    QVERIFY(book.check("setter", kPassword, "10.0.0.7", base::Instant{}).user != nullptr);
  }

  void theLibraryThatEncryptsIsKnown() { QVERIFY(!opcua::encryptionLibrary().empty()); }
};

RIVULET_TEST(TestSecurity)
#include "tst_security.moc"
