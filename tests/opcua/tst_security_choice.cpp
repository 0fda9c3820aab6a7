// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QFile>
#include <QtTest>
#include <set>
#include <string>
#include <vector>

#include "base/file.h"
#include "opcua/certificate.h"
#include "opcua/error.h"
#include "opcua/security.h"
#include "support/test_program.h"

using namespace rivulet;
using opcua::EndpointOffer;
using opcua::LinkError;
using opcua::LoginKind;
using opcua::MessageMode;
using opcua::SecurityChoice;
using opcua::SecurityPolicy;

namespace {

EndpointOffer offer(SecurityPolicy policy, MessageMode mode) {
  EndpointOffer made;
  made.security = {policy, mode};
  made.takesAnonymous = true;
  made.takesUserName = true;
  return made;
}

const EndpointOffer kNone = offer(SecurityPolicy::None, MessageMode::None);
const EndpointOffer kOld = offer(SecurityPolicy::Basic128Rsa15, MessageMode::SignAndEncrypt);
const EndpointOffer kSigned = offer(SecurityPolicy::Basic256Sha256, MessageMode::Sign);
const EndpointOffer kGood = offer(SecurityPolicy::Basic256Sha256, MessageMode::SignAndEncrypt);
const EndpointOffer kBest = offer(SecurityPolicy::Aes256Sha256RsaPss, MessageMode::SignAndEncrypt);

SecurityChoice choice(const char* text) {
  return opcua::securityChoiceOf(text).value_or(SecurityChoice());
}

}  // namespace

class TestSecurityChoice : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theStrongestIsTaken() {
    const std::vector offers{kNone, kOld, kGood, kBest, kSigned};
    QCOMPARE(opcua::chooseOffer(offers, {}, LoginKind::Anonymous).value_or(99), std::size_t{3});
    QCOMPARE(
        opcua::chooseOffer(offers, choice("Basic256Sha256"), LoginKind::Anonymous).value_or(99),
        std::size_t{2});
    QCOMPARE(
        opcua::chooseOffer(offers, choice("basic256sha256/sign"), LoginKind::UserName).value_or(99),
        std::size_t{4});
    QCOMPARE(opcua::chooseOffer(offers, choice("Basic128Rsa15"), LoginKind::UserName).value_or(99),
             std::size_t{1});
    QCOMPARE(opcua::chooseOffer(offers, opcua::unencrypted(), LoginKind::Anonymous).value_or(99),
             std::size_t{0});
  }

  void weakProtectionIsNeverTakenUnasked() {
    for (const EndpointOffer& weak : {kNone, kOld, kSigned}) {
      const auto refused = opcua::chooseOffer({&weak, 1}, {}, LoginKind::Anonymous);
      QVERIFY(!refused);
      QVERIFY(refused.error().code == LinkError::EncryptionMissing);
      QVERIFY(refused.error().message.find(opcua::securityText(weak.security)) !=
              std::string::npos);
    }
  }

  void thisComputerNeedsNoEncryption() {
    SecurityChoice local;
    local.prefersNone = true;
    const std::vector both{kBest, kNone};
    QCOMPARE(opcua::chooseOffer(both, local, LoginKind::Anonymous).value_or(99), std::size_t{1});
    QCOMPARE(opcua::chooseOffer({&kBest, 1}, local, LoginKind::Anonymous).value_or(99),
             std::size_t{0});
    QVERIFY(!opcua::chooseOffer({&kOld, 1}, local, LoginKind::Anonymous));
  }

  void aServerThatTakesNoSuchUserIsSaidSo() {
    EndpointOffer users = kBest;
    users.takesAnonymous = false;
    const auto refused = opcua::chooseOffer({&users, 1}, {}, LoginKind::Anonymous);
    QVERIFY(!refused);
    QVERIFY(refused.error().code == LinkError::LoginRefused);
    QVERIFY(opcua::chooseOffer({&users, 1}, {}, LoginKind::UserName));
  }

  void choicesAreText() {
    for (const char* text :
         {"strongest", "None", "Basic256Sha256", "Aes256_Sha256_RsaPss/Sign", "strongest/Sign"}) {
      const auto read = opcua::securityChoiceOf(text);
      QVERIFY2(read, text);
      QCOMPARE(opcua::securityChoiceText(*read), std::string(text));
    }
    for (const char* text : {"", "nix", "None/Sign", "Basic256Sha256/None", "Basic256Sha256/"}) {
      QVERIFY2(!opcua::securityChoiceOf(text), text);
    }
  }

  void loopbackIsAnAddressNotAName() {
    for (const char* local : {"opc.tcp://127.0.0.1:4840", "opc.tcp://127.8.9.1",
                              "opc.tcp://[::1]:1", "opc.tcp://LOCALHOST:4840/x"}) {
      QVERIFY2(opcua::isLoopback(local), local);
    }
    for (const char* other : {"opc.tcp://127.0.0.1.example.org:4840", "opc.tcp://10.0.0.1",
                              "opc.tcp://localhost.lan", "opc.tcp://[fe80::1]", ""}) {
      QVERIFY2(!opcua::isLoopback(other), other);
    }
  }

  void fingerprintsAreReadInEveryForm() {
    const std::string digits(64, 'a');
    QCOMPARE(opcua::fingerprintOf(opcua::fingerprintText(digits)), digits);
    QVERIFY(opcua::fingerprintOf("aa:bb").empty());
    QVERIFY(opcua::fingerprintOf(digits + "g").empty());
  }

  void damagedCertificatesAreRefused() {
    QVERIFY(!opcua::readCertificate(""));
    QVERIFY(!opcua::readCertificate("\x30"));
    QVERIFY(!opcua::readCertificate("\x30\x84\xFF\xFF\xFF\xFF"));
    QVERIFY(!opcua::readCertificate("\x30\x03\x30\x01\x02"));
  }

  void addressesHaveAPort() {
    QCOMPARE(int{opcua::portOf("opc.tcp://host:4841")}, 4841);
    QCOMPARE(int{opcua::portOf("opc.tcp://host")}, 4840);
    QCOMPARE(int{opcua::portOf("opc.tcp://[::1]:4850/x")}, 4850);
    QCOMPARE(int{opcua::portOf("opc.tcp://[::1]")}, 4840);
    for (const char* wrong : {"opc.tcp://host:", "opc.tcp://host:99999", "opc.tcp://host:abc",
                              "opc.tcp://host:-1", "opc.tcp://host:0"}) {
      QVERIFY2(opcua::portOf(wrong) == 0, wrong);
    }
  }

  void everyStatusIsInTheTableOfTheManual() {
    QFile manual(QStringLiteral(RIVULET_SOURCE_DIR "/docs/trust.md"));
    QVERIFY(manual.open(QIODevice::ReadOnly));
    const std::string text = manual.readAll().toStdString();
    std::set<std::uint32_t> codes;
    for (const opcua::StatusAdvice& advice : opcua::statusAdvice()) {
      QVERIFY2(codes.insert(advice.code).second, advice.name.data());
      const std::string row = "| " + std::string(advice.name) + " | " + std::string(advice.cause) +
                              " | " + std::string(advice.nextStep) + " |";
      QVERIFY2(text.find(row) != std::string::npos, row.c_str());
    }
  }

  void whatCanBeAllowedByNameIsListedFromStrongToWeak() {
    EndpointOffer contradiction = offer(SecurityPolicy::None, MessageMode::Sign);
    std::vector offers{kNone, kOld, kSigned, kOld, contradiction};
    std::vector<std::string> names;
    for (const opcua::SecurityChoice& choice : opcua::choicesByName(offers, LoginKind::Anonymous)) {
      names.push_back(opcua::securityChoiceText(choice));
      QVERIFY(opcua::chooseOffer(offers, choice, LoginKind::Anonymous));
    }
    QCOMPARE(names, (std::vector<std::string>{"Basic256Sha256/Sign", "Basic128Rsa15", "None"}));
    for (EndpointOffer& one : offers) {
      one.takesUserName = false;  // or only with a password that can be read
    }
    QVERIFY(opcua::choicesByName(offers, LoginKind::UserName).empty());
  }

  void theProtectionOfAConnectionIsNamed() {
    using opcua::Protection;
    const char* far = "opc.tcp://192.168.214.1:4840";
    const opcua::ChannelSecurity none{};
    QCOMPARE(opcua::protectionOf(none, far), Protection::None);
    QCOMPARE(opcua::protectionOf(none, "opc.tcp://127.0.0.1:4840"), Protection::LocalOnly);
    QCOMPARE(opcua::protectionOf({SecurityPolicy::Basic256, MessageMode::SignAndEncrypt}, far),
             Protection::Weak);
    QCOMPARE(opcua::protectionOf({SecurityPolicy::Basic256Sha256, MessageMode::Sign}, far),
             Protection::Signed);
    QCOMPARE(
        opcua::protectionOf({SecurityPolicy::Aes256Sha256RsaPss, MessageMode::SignAndEncrypt}, far),
        Protection::Encrypted);
  }

  void theHostOfAnEndpointIsTheOneOfItsCertificate() {
    QCOMPARE(opcua::hostOf("opc.tcp://Cell-4.shop:4840/path"), std::string("Cell-4.shop"));
    QCOMPARE(opcua::hostOf("opc.tcp://[fe80::1]:4840"), std::string("fe80::1"));
    QCOMPARE(opcua::hostOf("opc.tcp://[fe80::1"), std::string("fe80::1"));
    QCOMPARE(opcua::hostOf(""), std::string());
    const auto der =
        base::readFile(RIVULET_SOURCE_DIR "/tests/fuzz/seeds/certificate/self-signed.der", 65536);
    QVERIFY(der);
    const auto facts = opcua::readCertificate(*der);
    QVERIFY(facts);
    QCOMPARE(facts->applicationUris, std::vector<std::string>{"urn:cell-4:opcua"});
    QVERIFY(opcua::isForHost(*facts, "CELL-4.shop.example"));
    QVERIFY(opcua::isForHost(*facts, "192.168.214.1"));
    QVERIFY(!opcua::isForHost(*facts, "192.168.214.11"));
    QVERIFY(!opcua::isForHost(*facts, ""));
    QVERIFY(opcua::isValidAt(*facts, facts->validFrom) && opcua::isValidAt(*facts, facts->validTo));
    QVERIFY(!opcua::isValidAt(*facts, facts->validTo + 1));
  }
};

RIVULET_TEST(TestSecurityChoice)
#include "tst_security_choice.moc"
