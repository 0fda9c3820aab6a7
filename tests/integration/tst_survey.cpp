// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// A control is surveyed, and a virtual machine answers as it did, by the programs.

#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>
#include <nlohmann/json.hpp>

#include "support/machine_process.h"
#include "support/patience.h"
#include "support/test_program.h"

using namespace rivulet;
using nlohmann::json;

namespace {

const QString kMachine = QStringLiteral(RIVULET_MACHINE_PROGRAM);

/// What a survey says beside how long it took.
json facts(const json& survey) {
  json found{{"axes", survey.at("axes")},
             {"r_parameters", survey.at("r_parameters")},
             {"rights", survey.at("rights")},
             {"variables", survey.at("variables")}};
  for (const json& timed : survey.at("access")) {
    found["access"].push_back({timed.at("form"), timed.at("r_parameters"), timed.count("refused")});
  }
  return found;
}

}  // namespace

class TestSurvey : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;

  QString write(const char* name, const QByteArray& text) {
    QFile file(m_folder.filePath(QLatin1String(name)));
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size()) {
      qFatal("the test's folder cannot be written");
    }
    return file.fileName();
  }

  static json survey(const QStringList& machineArguments) {
    const tests::MachineProcess machine(kMachine, machineArguments);
    QProcess cli;
    cli.start(QStringLiteral(RIVULET_CLI), {QStringLiteral("survey"), QStringLiteral("--endpoint"),
                                            machine.endpoint(), QStringLiteral("--json")});
    cli.waitForFinished(tests::kRunMs);
    return json::parse(cli.readAllStandardOutput().toStdString(), nullptr, false);
  }

  /// @return what the machine says when it does not start
  static QString refusal(const QString& file) {
    QProcess machine;
    machine.start(kMachine,
                  {QStringLiteral("--port"), QStringLiteral("0"), QStringLiteral("--from"), file});
    if (!machine.waitForFinished(tests::kRunMs) || machine.exitCode() != 2) {
      machine.kill();
      machine.waitForFinished();
      return {};
    }
    return QString::fromUtf8(machine.readAllStandardError());
  }

 private Q_SLOTS:
  void aMachineAnswersAsTheSurveyedOne_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<bool>("hasRights");
    QTest::newRow("arrays") << QStringList{QStringLiteral("--preset"),
                                           QStringLiteral("dmu75-arrays")}
                            << true;
    QTest::newRow("lists, and no rights to files")
        << QStringList{QStringLiteral("--preset"), QStringLiteral("dmu75"),
                       QStringLiteral("--no-file-rights")}
        << false;
  }
  void aMachineAnswersAsTheSurveyedOne() {
    QFETCH(QStringList, arguments);
    QFETCH(bool, hasRights);
    json first = survey(arguments);
    QVERIFY(first.is_object());
    QCOMPARE(first.at("rights").at("write programs") != false, hasRights);
    first["r_parameters"] = 77;  // those of another control
    for (json& timed : first["access"]) {
      if (timed.at("r_parameters") == 100) {
        timed["form"] = "none";
      }
    }
    const QString file = write("survey.json", QByteArray::fromStdString(first.dump()));
    const json again = survey({QStringLiteral("--from"), file});
    QVERIFY(again.is_object());
    json expected = facts(first);
    std::erase_if(expected["access"].get_ref<json::array_t&>(),
                  [](const json& each) { return each[0] == "none"; });
    QCOMPARE(QString::fromStdString(facts(again).dump(1)),
             QString::fromStdString(expected.dump(1)));
  }

  void whatIsNoSurveyIsRefused_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("says");
    const QByteArray sound(
        R"({"rivulet_survey":1,"r_parameters":100,"axes":["X","Y","Z"],"access":[)"
        R"({"form":"list","r_parameters":3,"median_ms":4.0,"most_ms":5.0}]})");
    const auto without = [&sound](const char* what, const char* with) {
      QByteArray text = sound;
      return text.replace(what, with);
    };
    QTest::newRow("no JSON") << QByteArray("before") << QStringLiteral("not a survey");
    QTest::newRow("a later one") << without("survey\":1", "survey\":2")
                                 << QStringLiteral("not a survey");
    QTest::newRow("no R-parameters")
        << without(":100", ":\"many\"") << QStringLiteral("R-parameters");
    QTest::newRow("more than there can be")
        << without(":100", ":1000000") << QStringLiteral("R-parameters");
    QTest::newRow("no axes") << without("axes", "axles") << QStringLiteral("axes");
    QTest::newRow("no times") << without("median_ms", "mean_ms") << QStringLiteral("how long");
    QTest::newRow("negative times") << without("4.0", "-4.0") << QStringLiteral("how long");
  }
  void whatIsNoSurveyIsRefused() {
    QFETCH(QByteArray, text);
    QFETCH(QString, says);
    const QString said = refusal(write("bad.json", text));
    QVERIFY2(said.contains(says), qPrintable(said));
  }
};

RIVULET_TEST(TestSurvey)
#include "tst_survey.moc"
