// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Encryption, trust and passwords as their user meets them: the programs, over real sockets.

#include <QDirIterator>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>
#include <array>
#include <nlohmann/json.hpp>
#include <tuple>
#include <vector>

#include "machine/user.h"
#include "support/machine_process.h"
#include "support/patience.h"
#include "support/test_program.h"

using namespace rivulet;

namespace {

using rivulet::tests::kRunMs;
/// Occurs nowhere else.
constexpr const char* kPassword = "Zwetschgenkuchen-4711";

struct Outcome {
  int exit = -1;
  QString output;  ///< both channels
  nlohmann::json json;

  [[nodiscard]] std::string error() const {
    return json.contains("error") ? json["error"]["message"].get<std::string>() : std::string();
  }
};

}  // namespace

class TestTrust : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;
  QString m_preset;
  QString m_program;

  QString path(const char* name) const { return m_folder.filePath(QLatin1String(name)); }

  QString write(const char* name, const QByteArray& text) {
    QFile file(path(name));
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size()) {
      qFatal("the test's folder cannot be written");
    }
    return file.fileName();
  }

  /// @param user  the folder of all files of this user
  Outcome run(const char* user, const QStringList& arguments, const char* password = nullptr) {
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME"}) {
      environment.insert(QLatin1String(name), path(user) + QLatin1Char('/') + QLatin1String(name));
    }
    if (password != nullptr) {
      environment.insert(QStringLiteral("RIVULET_PASSWORD"), QLatin1String(password));
    }
    process.setProcessEnvironment(environment);
    process.start(QStringLiteral(RIVULET_CLI), arguments + QStringList{QStringLiteral("--json")});
    Outcome outcome;
    if (process.waitForFinished(kRunMs) && process.exitStatus() == QProcess::NormalExit) {
      outcome.exit = process.exitCode();
    }
    const QByteArray text = process.readAllStandardOutput();
    outcome.json = nlohmann::json::parse(text.toStdString(), nullptr, false);
    outcome.output = QString::fromUtf8(text + process.readAllStandardError());
    return outcome;
  }

  QStringList machineArguments(const char* certificates) {
    return {QStringLiteral("--preset"), m_preset, QStringLiteral("--encrypted"),
            QStringLiteral("--certificates"), path(certificates)};
  }

  static QString fingerprintIn(const Outcome& outcome) {
    const QRegularExpression pattern(QStringLiteral("fingerprint ([0-9A-F:]{95})"));
    return pattern.match(QString::fromStdString(outcome.error())).captured(1);
  }

  QStringList stream(const QString& endpoint, const QString& method) const {
    return {QStringLiteral("stream"),     m_program,
            QStringLiteral("--method"),   method,
            QStringLiteral("--feed"),     QStringLiteral("400"),
            QStringLiteral("--endpoint"), endpoint,
            QStringLiteral("--user"),     QStringLiteral("setter"),
            QStringLiteral("--record"),   path("run.rivulet")};
  }

 private Q_SLOTS:
  void initTestCase() {
    QFile preset(QStringLiteral(RIVULET_SOURCE_DIR "/resources/presets/dmu75.toml"));
    QVERIFY(preset.open(QIODevice::ReadOnly));
    const std::string users =
        "\n[[users.list]]\nname = \"setter\"\npassword = \"" +
        machine::passwordText(machine::hashPassword(kPassword, "salt")) +
        "\"\nrights = [\"StateRead\", \"StateWrite\", \"FsRead\", \"FsWrite\", \"ApWrite\"]\n" +
        "\n[[users.list]]\nname = \"reader\"\npassword = \"" +
        machine::passwordText(machine::hashPassword(kPassword, "pepper")) +
        "\"\nrights = [\"SinuReadAll\"]\n";
    m_preset = write("machine.toml", preset.readAll() + QByteArray::fromStdString(users));
    QByteArray program("G90 G1 F1000\n");
    for (int i = 1; i <= 20; ++i) {
      program += "X" + QByteArray::number(0.4 * i) + " Y" + QByteArray::number(0.1 * i) + "\n";
    }
    m_program = write("line.nc", program + "M30\n");
  }

  void aServerIsTrustedOnFirstUseAndAChangedOneIsNot() {
    const QStringList samePort{QStringLiteral("--port"), tests::portOfThisProcess()};
    tests::MachineProcess first(QStringLiteral(RIVULET_MACHINE_PROGRAM),
                                machineArguments("first") + samePort);
    const QString endpoint = first.endpoint();
    QVERIFY2(endpoint.startsWith(QLatin1String("opc.tcp://")), qPrintable(endpoint));
    const QStringList rights{QStringLiteral("rights"), QStringLiteral("--endpoint"), endpoint,
                             QStringLiteral("--user"), QStringLiteral("setter")};

    const Outcome unknown = run("anna", rights, kPassword);
    QCOMPARE(unknown.exit, 3);
    const QString fingerprint = fingerprintIn(unknown);
    QVERIFY2(!fingerprint.isEmpty(), qPrintable(unknown.output));

    const Outcome wrong =
        run("anna", rights + QStringList{QStringLiteral("--trust"), QString(64, QLatin1Char('A'))},
            kPassword);
    QCOMPARE(wrong.exit, 3);
    const Outcome accepted =
        run("anna", rights + QStringList{QStringLiteral("--trust"), fingerprint}, kPassword);
    QVERIFY2(accepted.exit == 0, qPrintable(accepted.output));
    QCOMPARE(accepted.json["rights"].size(), std::size_t{5});
    QCOMPARE(run("anna", rights, kPassword).exit, 0);

    const Outcome refused = run("anna", rights, "wrong");
    QCOMPARE(refused.exit, 3);
    QVERIFY2(QString::fromStdString(refused.error()).contains(QLatin1String("password")),
             qPrintable(refused.output));
    const Outcome plain =
        run("anna", QStringList(rights) << QStringLiteral("--security") << QStringLiteral("none"),
            kPassword);
    QCOMPARE(plain.exit, 3);

    // The same address, another certificate.
    first.kill();
    const tests::MachineProcess second(QStringLiteral(RIVULET_MACHINE_PROGRAM),
                                       machineArguments("second") + samePort);
    QCOMPARE(second.endpoint(), endpoint);
    const Outcome changed = run("anna", rights, kPassword);
    QCOMPARE(changed.exit, 3);
    QVERIFY2(QString::fromStdString(changed.error()).contains(QLatin1String("another certificate")),
             qPrintable(changed.output));
    QVERIFY(QDir(path("anna") + QStringLiteral("/XDG_CONFIG_HOME/rivulet/trust/rejected"))
                .entryList(QDir::Files)
                .size() >= 1);
  }

  void theRightsOfAUserAreSaid() {
    const tests::MachineProcess machine(QStringLiteral(RIVULET_MACHINE_PROGRAM),
                                        machineArguments("first"));
    const QStringList rights{QStringLiteral("rights"), QStringLiteral("--endpoint"),
                             machine.endpoint(), QStringLiteral("--user"),
                             QStringLiteral("reader")};
    const QString fingerprint = fingerprintIn(run("berta", rights, kPassword));
    const Outcome report =
        run("berta", rights + QStringList{QStringLiteral("--trust"), fingerprint}, kPassword);
    QCOMPARE(report.exit, 1);
    QCOMPARE(report.json["rights"][0]["given"], nlohmann::json(true));
    for (std::size_t i = 1; i < 5; ++i) {
      QCOMPARE(report.json["rights"][i]["given"], nlohmann::json(false));
    }
  }

  void encryptedRunsOfEveryMethodLeaveNoTraceOfThePassword() {
    const tests::MachineProcess machine(
        QStringLiteral(RIVULET_MACHINE_PROGRAM),
        machineArguments("first") + QStringList{QStringLiteral("--state"), path("state")});
    const QString fingerprint = fingerprintIn(
        run("clara", stream(machine.endpoint(), QStringLiteral("window")), kPassword));
    QVERIFY(!fingerprint.isEmpty());
    const QStringList trust{QStringLiteral("--trust"), fingerprint};

    const Outcome window =
        run("clara", stream(machine.endpoint(), QStringLiteral("window")) + trust, kPassword);
    QVERIFY2(window.exit == 0, qPrintable(window.output));
    QVERIFY(window.json["faultless"].get<bool>());
    QCOMPARE(window.json["executed"].get<int>(), 20);

    const Outcome test =
        run("clara",
            {QStringLiteral("commission"), QStringLiteral("--endpoint"), machine.endpoint(),
             QStringLiteral("--user"), QStringLiteral("setter")},
            kPassword);
    QVERIFY2(test.exit == 0, qPrintable(test.output));
    std::vector<Outcome> outcomes{window, test};
    for (const char* method : {"credit", "file", "signal", "position"}) {
      const Outcome& one = outcomes.emplace_back(
          run("clara", stream(machine.endpoint(), QString::fromUtf8(method)), kPassword));
      QVERIFY2(one.exit == 0, qPrintable(one.output));
      QVERIFY2(one.json["faultless"].get<bool>(), method);
      QCOMPARE(one.json["executed"].get<int>(), 20);
    }

    int files = 0;
    for (QDirIterator each(m_folder.path(), QDir::Files | QDir::Hidden,
                           QDirIterator::Subdirectories);
         each.hasNext(); ++files) {
      QFile file(each.next());
      QVERIFY2(file.open(QIODevice::ReadOnly), qPrintable(file.fileName()));
      QVERIFY2(!file.readAll().contains(kPassword), qPrintable(file.fileName()));
    }
    QVERIFY(files > 5);
    for (const Outcome& outcome : outcomes) {
      QVERIFY(!outcome.output.contains(QLatin1String(kPassword)));
    }
  }

  void aUserLogsInByCertificate() {
    // The certificate of another computer is as good as any.
    const Outcome made = run("emma", {QStringLiteral("certificate")});
    const QString files = path("emma") + QStringLiteral("/XDG_CONFIG_HOME/rivulet/trust/client/");
    const QString key = files + QStringLiteral("key.der");
    QFile preset(m_preset);
    QVERIFY(preset.open(QIODevice::ReadOnly));
    const QByteArray fingerprint =
        QByteArray::fromStdString(made.json["fingerprint"].get<std::string>());
    const QString withEmma = write(
        "emma.toml", preset.readAll() + "\n[[users.list]]\nname = \"emma\"\ncertificate = \"" +
                         fingerprint + "\"\nrights = [\"SinuReadAll\"]\n");
    QStringList arguments = machineArguments("first");
    arguments.replace(arguments.indexOf(m_preset), withEmma);
    const tests::MachineProcess machine(QStringLiteral(RIVULET_MACHINE_PROGRAM), arguments);
    QVERIFY2(machine.endpoint().startsWith(QLatin1String("opc.tcp://")),
             qPrintable(machine.endpoint()));

    const QStringList rights{QStringLiteral("rights"), QStringLiteral("--endpoint"),
                             machine.endpoint(), QStringLiteral("--user-certificate"),
                             files + QStringLiteral("certificate.der")};
    const QStringList withKey = rights + QStringList{QStringLiteral("--user-key"), key};
    const QString server = fingerprintIn(run("frieda", withKey));
    QVERIFY(!server.isEmpty());
    const Outcome report = run("frieda", withKey + QStringList{QStringLiteral("--trust"), server});
    QVERIFY2(report.exit == 1, qPrintable(report.output));  // a run needs more rights
    QCOMPARE(report.json["rights"][0]["given"], nlohmann::json(true));
    QCOMPARE(report.json["rights"][1]["given"], nlohmann::json(false));

    QFile(key).setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ReadOther);
    const Outcome open = run("frieda", withKey);
    QCOMPARE(open.exit, 2);
    QVERIFY2(QString::fromStdString(open.error()).contains(QLatin1String("chmod 600")),
             qPrintable(open.output));
    QCOMPARE(
        run("frieda", withKey + QStringList{QStringLiteral("--user"), QStringLiteral("setter")})
            .exit,
        2);
  }

  void aRevocationListIsTakenOver() {
    const QString list = QStringLiteral(RIVULET_SOURCE_DIR "/tests/data/certificates/shop.crl");
    const Outcome taken =
        run("gerda", {QStringLiteral("certificate"), QStringLiteral("--revocation-list"), list});
    QVERIFY2(taken.exit == 0, qPrintable(taken.output));
    QCOMPARE(taken.json["revocation_lists"][0]["issuer"], nlohmann::json("CN=Shop CA, O=Example"));
    QCOMPARE(taken.json["revocation_lists"][0]["certificates"], nlohmann::json(1));
    const Outcome refused = run(
        "gerda", {QStringLiteral("certificate"), QStringLiteral("--revocation-list"), m_preset});
    QVERIFY(refused.exit != 0);
    QVERIFY2(QString::fromStdString(refused.error()).contains(QLatin1String("no revocation list")),
             qPrintable(refused.output));
  }

  /// Only ways that the program has: it has no --password-file.
  void whereAPasswordCanBeGivenIsSaid() {
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.remove(QStringLiteral("RIVULET_PASSWORD"));
    environment.remove(QStringLiteral("CREDENTIALS_DIRECTORY"));
    process.setProcessEnvironment(environment);
    // Without a terminal.
    process.start(QStringLiteral("setsid"),
                  {QStringLiteral("--wait"), QStringLiteral(RIVULET_MACHINE_PROGRAM),
                   QStringLiteral("--hash-password")});
    QVERIFY(process.waitForFinished(kRunMs));
    QCOMPARE(process.exitCode(), 2);
    const QByteArray errors = process.readAllStandardError();
    QVERIFY2(errors.contains("RIVULET_PASSWORD") && !errors.contains("--"), errors.constData());
  }

  /// Clients keep what they know of a server under its address and application URI: a bridge that
  /// called itself the virtual machine would get the limits of travel that were entered for that.
  void serversOfOneUserHaveDifferentIdentities() {
    const QString folder = path("servers");
    const std::array<std::tuple<QString, QString, QStringList>, 3> servers{{
        {QStringLiteral(RIVULET_MACHINE_PROGRAM),
         QStringLiteral("machine"),
         {QStringLiteral("--port"), QStringLiteral("0")}},
        {QStringLiteral(RIVULET_LINUXCNC),
         QStringLiteral("linuxcnc"),
         {QStringLiteral("--helper"), QStringLiteral("/bin/false"), QStringLiteral("--programs"),
          folder}},
        {QStringLiteral(RIVULET_SERVICE),
         QStringLiteral("service"),
         {QStringLiteral("run"), QStringLiteral("opc.tcp://127.0.0.1:1"), QStringLiteral("--port"),
          QStringLiteral("0")}},
    }};
    for (const auto& [program, name, arguments] : servers) {
      QProcess server;
      QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
      for (const char* variable : {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME"}) {
        environment.insert(QLatin1String(variable), folder);
      }
      server.setProcessEnvironment(environment);
      server.start(program, arguments + QStringList{QStringLiteral("--certificates"), folder});
      QFile certificate(folder + QLatin1Char('/') + name + QStringLiteral("/certificate.der"));
      QTRY_VERIFY_WITH_TIMEOUT(certificate.exists(), kRunMs);
      QVERIFY(certificate.open(QIODevice::ReadOnly));
      const QByteArray der = certificate.readAll();
      for (const auto& [other, otherName, none] : servers) {
        QCOMPARE(der.contains("urn:rivulet:" + otherName.toLatin1()), otherName == name);
      }
      QCOMPARE(der.contains("virtual machine@"), name == QLatin1String("machine"));
      server.terminate();
      QVERIFY(server.state() == QProcess::NotRunning || server.waitForFinished(kRunMs));
    }
  }

  void aPasswordFileMustBePrivate() {
    const QString file = write("password", QByteArray(kPassword) + "\n");
    QFile(file).setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ReadGroup);
    const Outcome refused =
        run("dora", {QStringLiteral("rights"), QStringLiteral("--endpoint"),
                     QStringLiteral("opc.tcp://127.0.0.1:1"), QStringLiteral("--user"),
                     QStringLiteral("setter"), QStringLiteral("--password-file"), file});
    QCOMPARE(refused.exit, 2);
    QVERIFY(QString::fromStdString(refused.error()).contains(QLatin1String("Others may read")));
    QFile(file).remove();
  }
};

RIVULET_TEST(TestTrust)
#include "tst_trust.moc"
