// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The command analyse on files of other tools, on many files, and with rules.

#include <fmt/format.h>

#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>
#include <nlohmann/json.hpp>

#include "report/rule.h"
#include "report/run_trend.h"
#include "report/stream_quality.h"
#include "streaming/run/driver.h"
#include "support/patience.h"
#include "support/test_program.h"
#include "trace/frames.h"
#include "trace/hdf5.h"

using namespace rivulet;
using nlohmann::json;
using nlohmann::ordered_json;

namespace {

constexpr const char* kProgram = "G90 G94\nG1 X10 Y0 F600\nG1 X10 Y5\nG1 X0 Y5\nM30\n";

/// Along the program at 10 mm/s, sampled every 10 ms; without the line to (10, 5) if `skips`.
QByteArray traceText(const char* heading, bool skips) {
  QByteArray text(heading);
  double seconds = 0.0;
  const auto go = [&](double x, double y, double toX, double toY) {
    const double length = std::hypot(toX - x, toY - y);
    for (double at = 0.0; at < length; at += 0.1) {
      text += QByteArray::fromStdString(fmt::format("{:.3f};{:.5f};{:.5f}\n", seconds,
                                                    x + at / length * (toX - x),
                                                    y + at / length * (toY - y)));
      seconds += 0.01;
    }
  };
  go(0, 0, 10, 0);
  if (!skips) {
    go(10, 0, 10, 5);
    go(10, 5, 0, 5);
  } else {
    go(10, 0, 0, 5);
  }
  return text + QByteArray::fromStdString(fmt::format("{:.3f};0;5\n", seconds));
}

}  // namespace

class TestAnalyse : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;

  QString file(const char* name, const QByteArray& text) {
    QFile out(m_folder.filePath(QString::fromUtf8(name)));
    if (!out.open(QIODevice::WriteOnly) || out.write(text) < 0) {
      qFatal("the test's folder cannot be written");
    }
    return out.fileName();
  }

  struct Outcome {
    int exit = -1;
    std::string output;
    std::string errors;
    [[nodiscard]] json parsed() const { return json::parse(output, nullptr, false); }
  };
  Outcome run(const QStringList& arguments) {
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("XDG_CONFIG_HOME"),
                       m_folder.filePath(QStringLiteral("config")));
    process.setProcessEnvironment(environment);
    process.start(QStringLiteral(RIVULET_CLI), QStringList{QStringLiteral("analyse")} + arguments);
    Outcome outcome;
    if (process.waitForFinished(tests::kRunMs) && process.exitStatus() == QProcess::NormalExit) {
      outcome.exit = process.exitCode();
    }
    outcome.output = process.readAllStandardOutput().toStdString();
    outcome.errors = process.readAllStandardError().toStdString();
    return outcome;
  }

 private Q_SLOTS:
  /// A program that takes an address for a file says that it cannot be read (exit code 2).
  void refusesSourcesThatAreNotThere() {
    const QString nobody = QStringLiteral("http://127.0.0.1:1");
#ifdef RIVULET_TEST_CURL
    QCOMPARE(run({nobody}).exit, 3);
#else
    QCOMPARE(run({nobody}).exit, 2);
#endif
    QCOMPARE(run({nobody + QStringLiteral("?interval=1")}).exit, 2);
    const QStringList history{QStringLiteral("opc.tcp://127.0.0.1:1"),
                              QStringLiteral("--node"),
                              QStringLiteral("x=i=5"),
                              QStringLiteral("--since"),
                              QStringLiteral("2026-01-02T03:00:00Z"),
                              QStringLiteral("--to")};
    QCOMPARE(run(history + QStringList{QStringLiteral("2026-01-02T04:00:00Z")}).exit, 3);
    QCOMPARE(run(history + QStringList{QStringLiteral("2026-01-02T02:00:00Z")}).exit, 2);
    const QString csv = file("good.csv", traceText("t_s;x_cmd;y_cmd\n", false));
    for (const char* option : {"--record", "--keep", "--node", "--since"}) {
      QCOMPARE(run({csv, QString::fromUtf8(option), QStringLiteral("1")}).exit, 2);
    }
  }

  /// The document of an agent is a trace as a table is; its refusal is repeated.
  void readsMtconnect() {
    QByteArray text =
        "<MTConnectStreams><Streams><DeviceStream name=\"m\"><ComponentStream "
        "component=\"Linear\" name=\"X\"><Samples>";
    for (int i = 0; i < 100; ++i) {
      text += QStringLiteral(
                  "<Position dataItemId=\"x\" sequence=\"%1\" "
                  "timestamp=\"2026-01-02T03:04:05.%2Z\">%1</Position>")
                  .arg(i + 1)
                  .arg(i, 2, 10, QLatin1Char('0'))
                  .toUtf8();
    }
    text += "</Samples></ComponentStream></DeviceStream></Streams></MTConnectStreams>";
    const Outcome read = run({file("agent.xml", text), QStringLiteral("--json")});
    QCOMPARE(read.exit, 0);
    QCOMPARE(read.parsed()["format"].get<std::string>(), std::string("MTConnect"));
    QCOMPARE(read.parsed()["columns"].get<std::string>(), std::string("x_act=x:mm"));
    QCOMPARE(read.parsed()["samples"].get<int>(), 100);
    const Outcome refused = run({file("refused.xml",
                                      "<MTConnectError><Error errorCode=\"NO_DEVICE\">who?</Error>"
                                      "</MTConnectError>")});
    QCOMPARE(refused.exit, 2);
    QVERIFY(refused.errors.find("who? (NO_DEVICE)") != std::string::npos);
  }

  void comparesATraceWithItsProgram() {
    const QString program = file("part.mpf", kProgram);
    const QString good = file("good.csv", traceText("t_s;x_cmd;y_cmd\n", false));
    const QString bad = file("bad.csv", traceText("t_s;x_cmd;y_cmd\n", true));
    const QStringList options{QStringLiteral("--program"), program, QStringLiteral("--json")};
    const Outcome first = run(QStringList{good} + options);
    QCOMPARE(first.exit, 0);
    QCOMPARE(first.parsed()["executed"].get<int>(), 3);
    QVERIFY(first.parsed()["contour_error"]["max_mm"].get<double>() < 1e-6);
    const Outcome second = run(QStringList{bad} + options);
    QCOMPARE(second.exit, 1);
    QCOMPARE(second.parsed()["skipped"].get<int>(), 1);
    QCOMPARE(second.parsed()["path"]["faults"][0]["line"].get<int>(), 3);
  }

  void summarisesAndObeysRules() {
    const QString program = file("part.mpf", kProgram);
    const QString good = file("good.csv", traceText("t_s;x_cmd;y_cmd\n", false));
    const QString bad = file("bad.csv", traceText("t_s;x_cmd;y_cmd\n", true));
    const QStringList options{QStringLiteral("--program"), program, QStringLiteral("--summary"),
                              QStringLiteral("--fail-if"), QStringLiteral("skipped>0")};
    const Outcome both = run(QStringList{good, bad} + options);
    QCOMPARE(both.exit, 4);
    QCOMPARE(std::count(both.output.begin(), both.output.end(), '\n'), 3);
    QCOMPARE(run(QStringList{good} + options).exit, 0);
    QCOMPARE(run({good, QStringLiteral("--fail-if"), QStringLiteral("skipped >")}).exit, 2);
    // What is not known is not allowed.
    const Outcome unknown = run({good, QStringLiteral("--fail-if"), QStringLiteral("skipped>0")});
    QCOMPARE(unknown.exit, 4);
    QVERIFY(unknown.errors.find("not known") != std::string::npos);
    // A file that cannot be read does not keep the others from being analysed.
    const Outcome some = run({file("rubbish.csv", "not a trace\n"), good,
                              QStringLiteral("--summary"), QStringLiteral("--json")});
    QCOMPARE(some.exit, 2);
    QCOMPARE(some.parsed().size(), std::size_t{2});
  }

  /// The second run goes 0.02 mm beside the first one and a quarter slower.
  void comparesRuns() {
    const auto table = [](double beside, double slower) {
      QByteArray text("t_s;x_cmd;y_cmd\n");
      for (int i = 0; i <= 1000; ++i) {
        text += QByteArray::fromStdString(
            fmt::format("{:.4f};{:.5f};{:.5f}\n", 0.01 * i * slower, 0.01 * i, beside));
      }
      return text;
    };
    const QString a = file("first.csv", table(0.0, 1.0));
    const QString b = file("second.csv", table(0.02, 1.25));
    const Outcome byPath =
        run({a, b, QStringLiteral("--compare"), QStringLiteral("path"), QStringLiteral("--json")});
    QCOMPARE(byPath.exit, 0);
    const json shown = byPath.parsed();
    QCOMPARE(shown["of_program"].get<bool>(), false);
    QCOMPARE(shown["runs"].size(), std::size_t{1});
    bool hasY = false;
    for (const json& one : shown["runs"][0]["differences"]) {
      const double max = one["max"].get<double>();
      if (one["signal"] == "x_set") {
        QVERIFY(std::abs(max) < 1e-6);
      } else if (one["signal"] == "y_set") {
        hasY = true;
        QVERIFY(std::abs(max - 0.02) < 1e-9 && std::abs(one["rms"].get<double>() - 0.02) < 1e-9);
      } else if (one["signal"] == "time") {
        QVERIFY(std::abs(max - 2.5) < 1e-6 && std::abs(one["at_mm"].get<double>() - 10.0) < 1e-6);
      }
    }
    QVERIFY(hasY);
    const Outcome byTime = run({a, b, QStringLiteral("--compare"), QStringLiteral("time"),
                                QStringLiteral("--signal"), QStringLiteral("x_set")});
    QCOMPARE(byTime.exit, 0);
    QVERIFY2(byTime.output.find("x_set, mm") != std::string::npos, byTime.output.c_str());
    QVERIFY(byTime.output.find("y_set") == std::string::npos);
    const QString program = file("line.mpf", "G90 G94\nG1 X5 F600\nG1 X10\nM30\n");
    const Outcome byPoint = run({a, b, QStringLiteral("--compare"), QStringLiteral("point"),
                                 QStringLiteral("--program"), program, QStringLiteral("--json")});
    QCOMPARE(byPoint.exit, 0);
    QCOMPARE(byPoint.parsed()["of_program"].get<bool>(), true);
    const Outcome unknown = run({a, b, QStringLiteral("--compare"), QStringLiteral("point")});
    QCOMPARE(unknown.exit, 2);
    QVERIFY2(unknown.errors.find("which NC program") != std::string::npos, unknown.errors.c_str());
    QVERIFY(run({a, QStringLiteral("--compare"), QStringLiteral("time")}).exit != 0);
  }

  /// Two machines; the access of one becomes slower by 2 ms a day.
  void showsTrends() {
    QStringList files;
    for (int day = 1; day <= 5; ++day) {
      for (const char* machine : {"opc.tcp://mill:4840", "opc.tcp://lathe:4840"}) {
        const bool isMill = std::string(machine).find("mill") != std::string::npos;
        const int took = 10'000'000 + (isMill ? 2'000'000 * day : 0);
        const std::string text = fmt::format(
            "rivulet-recording 1\nrun method=\"window\" program=\"part.mpf\" endpoint=\"{}\" "
            "started_utc=\"2026-11-{:02d}T12:00:00Z\"\npoints count=0 merged=0\n"
            "l 0 1 2 3 10\na 1000000 {} r 1\nl 1500000000 5 -2 3 10\n"
            "end outcome=\"completed\" duration_ns=1600000000\n",
            machine, day, took);
        files.prepend(file(fmt::format("{}{}.rivulet", isMill ? "mill" : "lathe", day).c_str(),
                           QByteArray::fromStdString(text)));
      }
    }
    const QString path = m_folder.filePath("trend.json");
    const QStringList options{QStringLiteral("--summary"), QStringLiteral("--trend")};
    const Outcome outcome = run(files + options + QStringList{path});
    QVERIFY2(outcome.errors.empty(), outcome.errors.c_str());
    QVERIFY2(outcome.output.find("per_day") != std::string::npos, outcome.output.c_str());
    QFile written(path);
    QVERIFY(written.open(QIODevice::ReadOnly));
    const json trends = json::parse(written.readAll().toStdString(), nullptr, false);
    QCOMPARE(trends.size(), std::size_t{2});
    QCOMPARE(trends[1]["machine"].get<std::string>(), std::string("opc.tcp://mill:4840"));
    QCOMPARE(trends[1]["runs"].get<int>(), 5);
    QVERIFY(std::abs(trends[1]["span_days"].get<double>() - 4.0) < 1e-9);
    QVERIFY(std::abs(trends[1]["access_ms"]["mean"].get<double>() - 16.0) < 1e-9);
    QVERIFY(std::abs(trends[1]["access_ms"]["per_day"].get<double>() - 2.0) < 1e-9);
    QVERIFY(std::abs(trends[1]["access_ms"]["per_run"].get<double>() - 2.0) < 1e-9);
    QVERIFY(std::abs(trends[0]["access_ms"]["per_run"].get<double>()) < 1e-9);
    const QString page = m_folder.filePath("trend.html");
    QCOMPARE(run(files + options + QStringList{page}).exit, outcome.exit);
    QFile html(page);
    QVERIFY(html.open(QIODevice::ReadOnly));
    const QByteArray shown = html.readAll();
    QCOMPARE(shown.count("<svg"), 2);
    // By their dates; the line of a machine has the colour of its runs.
    QCOMPARE(shown.count("Days since 2026-11-01"), 2);
    for (const char* colour : {"#0072B2", "#D55E00"}) {
      QVERIFY(shown.contains(QByteArray("fill=\"") + colour));
      QVERIFY(shown.contains(QByteArray("stroke=\"") + colour));
    }
    QVERIFY(!shown.contains("#009E73"));
    // English ones have a point, German ones a comma.
    QVERIFY(shown.contains("<html lang=\"en\"") && shown.contains("<td>16</td><td>+2.00</td>"));
    const QStringList german{QStringLiteral("--language"), QStringLiteral("de")};
    QCOMPARE(run(files + options + QStringList{page} + german).exit, outcome.exit);
    html.close();
    QVERIFY(html.open(QIODevice::ReadOnly));
    const QByteArray translated = html.readAll();
    QCOMPARE(translated.count("Tage seit 2026-11-01"), 2);
    QVERIFY(translated.contains("<html lang=\"de\"") && translated.contains("Trend der Läufe"));
    QVERIFY(translated.contains("<td>16</td><td>+2,00</td>") && translated.contains(">0,5</text>"));
    for (const char* english : {"Trend of", "Machine", "per run", "Access", "Days", ", trend"}) {
      QVERIFY2(!translated.contains(english), english);
    }
    QVERIFY(run(files + QStringList{QStringLiteral("--summary")} + german).exit != outcome.exit);
    QCOMPARE(run(files + options + QStringList{m_folder.filePath("trend.txt")}).exit, 2);
    QVERIFY(!report::daysOf("yesterday") && !report::daysOf("2026-13-01T00:00:00Z"));
    QCOMPARE(*report::daysOf("1970-01-02T12:00:00Z"), 1.5);
  }

  /// What is saved is analysed like the file itself.
  void savesSignals() {
    const QString whole = file("saved.csv", traceText("t_s;x_cmd;y_cmd\n", false));
    const json expected = run({whole, QStringLiteral("--json")}).parsed();
    for (const char* name : {"out.csv", "out.h5"}) {
      const QString path = m_folder.filePath(QLatin1String(name));
      const Outcome outcome = run({whole, QStringLiteral("--save"), path});
      if (path.endsWith(QStringLiteral(".h5")) && !trace::hasHdf5()) {
        QCOMPARE(outcome.exit, 2);
        QVERIFY2(outcome.errors.find("built without HDF5") != std::string::npos,
                 outcome.errors.c_str());
        continue;
      }
      QCOMPARE(outcome.exit, 0);
      const Outcome again = run({path, QStringLiteral("--json")});
      QVERIFY2(again.exit == 0, again.errors.c_str());
      const json shown = again.parsed();
      QCOMPARE(shown["format"].get<std::string>(),
               std::string(path.endsWith(QStringLiteral(".h5")) ? "HDF5" : "CSV"));
      QCOMPARE(shown["samples"], expected["samples"]);
      QCOMPARE(shown["standstill_count"], expected["standstill_count"]);
      QCOMPARE(shown["step_ms"].get<double>(), expected["step_ms"].get<double>());
    }
    const QString save = QStringLiteral("--save");
    QVERIFY(run({whole, save, m_folder.filePath("out.txt")}).exit != 0);
    QVERIFY(run({whole, whole, save, m_folder.filePath("out.csv")}).exit != 0);
    QCOMPARE(run({whole, save, m_folder.filePath("nowhere/out.csv")}).exit, 2);
  }

  /// Half of the motion: the other half is not missing.
  void analysesAPartOfTheTime() {
    const QString program = file("part.mpf", kProgram);
    const QString whole = file("whole.csv", traceText("t_s;x_cmd;y_cmd\n", false));
    const Outcome part = run({whole, QStringLiteral("--program"), program, QStringLiteral("--from"),
                              QStringLiteral("0.5"), QStringLiteral("--until"),
                              QStringLiteral("1.2"), QStringLiteral("--json")});
    const json shown = part.parsed();
    QCOMPARE(shown["samples"].get<int>(), 71);
    QCOMPARE(shown["executed"].get<int>(), 1);
    QCOMPARE(shown["skipped"].get<int>(), 0);
    QCOMPARE(run({whole, QStringLiteral("--from"), QStringLiteral("2"), QStringLiteral("--until"),
                  QStringLiteral("1")})
                 .exit,
             2);
  }

  /// The overview of a recording is that of the whole file, also if it was cut off.
  void showsAnOverview() {
    trace::FrameWriter frames;
    std::string bytes = frames.frame(
        "rivulet-recording 1\nrun method=\"window\" program=\"part.mpf\"\npoints count=0 "
        "merged=0\n");
    bytes += frames.frame("l 0 1 2 3 10\nl 500000000 4 2 3 10\na 1000000 4000000 r 3\n");
    bytes += frames.frame("l 1500000000 5 -2 3 10\nn 1600000000 \"running\"\n");
    const std::string cut = bytes;
    bytes += frames.frame("end outcome=\"completed\" duration_ns=1600000000\n");
    bytes += frames.table();
    for (const std::string& content : {bytes, cut}) {
      const QString path = file("long.rivulet", QByteArray::fromStdString(content));
      const Outcome outcome = run({path, QStringLiteral("--overview"), QStringLiteral("--json")});
      QCOMPARE(outcome.exit, 0);
      const json shown = outcome.parsed();
      QCOMPARE(shown["program"].get<std::string>(), std::string("part.mpf"));
      QCOMPARE(shown["had_index"].get<bool>(), content == bytes);
      QCOMPARE(shown["outcome"].is_null(), content == cut);
      QCOMPARE(shown["span_s"].get<double>(), 1.6);
      QCOMPARE(shown["samples"].get<int>(), 3);
      QCOMPARE(shown["requests"].get<int>(), 1);
      QCOMPARE(shown["position_mm"]["y"], (json{-2.0, 2.0}));
    }
    const Outcome refused = run({file("rubbish", "rubbish\n"), QStringLiteral("--overview")});
    QCOMPARE(refused.exit, 2);
    QVERIFY(!refused.errors.empty());
  }

  /// Every kind of file that is not as it should be: what can be read is shown, and one sentence
  /// says the rest.
  void saysWhatIsWrongWithAFile_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("exit");
    QTest::addColumn<QString>("sentence");
    const QByteArray good = traceText("t_s;x_cmd;y_cmd\n", false);
    QByteArray backwards = good;
    backwards.replace("\n0.500;", "\n0.100;");
    QByteArray doubled("t_s;x_cmd;x_cmd\n");
    QByteArray twoTimes("t_s;x_cmd;t2_s;y_cmd\n");
    for (int i = 0; i < 50; ++i) {
      const QByteArray at = QByteArray::number(0.01 * i);
      doubled += at + ';' + at + ';' + at + '\n';
      twoTimes += at + ';' + at + ';' + at + ';' + at + '\n';
    }
    QByteArray commas = good;
    commas.replace('.', ',');
    QTest::newRow("cut") << good.chopped(4) << 0 << QStringLiteral("cut off");
    QTest::newRow("rubbish") << QByteArray("\x01\x02 nothing \xff\n") << 2
                             << QStringLiteral("no rows of numbers");
    QTest::newRow("empty") << QByteArray() << 2 << QStringLiteral("no rows of numbers");
    QTest::newRow("time runs backwards") << backwards << 0 << QStringLiteral("runs backwards");
    QTest::newRow("columns twice") << doubled << 0 << QStringLiteral("more than once");
    QTest::newRow("two time bases") << twoTimes << 0 << QStringLiteral("2 columns of time");
    QTest::newRow("commas as decimal signs") << commas << 0 << QStringLiteral("2 signals");
  }
  void saysWhatIsWrongWithAFile() {
    QFETCH(QByteArray, text);
    QFETCH(int, exit);
    QFETCH(QString, sentence);
    const Outcome outcome = run({file("wrong.csv", text)});
    QCOMPARE(outcome.exit, exit);
    const QString said = QString::fromStdString(outcome.output + outcome.errors);
    QVERIFY2(said.contains(sentence), qPrintable(said));
  }
  void refusesAFileLargerThanTheMemory() {
    QFile huge(file("huge.rivulet", "rivulet-recording 1\n"));
    QVERIFY(huge.open(QIODevice::ReadWrite) && huge.resize(qint64{50} << 30));
    huge.close();
    for (const char* option : {"--json", "--overview"}) {
      const Outcome outcome = run({huge.fileName(), QString::fromUtf8(option)});
      QCOMPARE(outcome.exit, 2);
      QVERIFY((outcome.output + outcome.errors).find("--memory-limit") != std::string::npos);
    }
    QVERIFY(huge.remove());
  }
  /// The place where the motion leaves a program that is not its own is named.
  void saysWhereTheMotionLeavesTheProgram() {
    const QString other =
        file("other.mpf", "G90 G94\nG1 X0 Y0 F600\nG1 X10 Y0\nG1 X10 Y-40\nG1 X-30 Y-40\nM30\n");
    const Outcome outcome = run({file("good.csv", traceText("t_s;x_cmd;y_cmd\n", false)),
                                 QStringLiteral("--program"), other, QStringLiteral("--json")});
    QCOMPARE(outcome.exit, 1);
    const json departure = outcome.parsed()["path"]["departure"];
    QVERIFY(departure.is_object());
    QCOMPARE(departure["line"].get<int>(), 4);
    QVERIFY(std::abs(departure["place_mm"][0].get<double>() - 10.0) < 0.2);
  }

  void remembersTheColumns() {
    const QString trace = file("own.csv", traceText("clock;a;b\n", false));
    const Outcome unknown = run({trace});
    QCOMPARE(unknown.exit, 2);
    QVERIFY2(unknown.errors.find("the columns are a, b. Say which with --map") != std::string::npos,
             unknown.errors.c_str());
    QCOMPARE(
        run({trace, QStringLiteral("--map"), QStringLiteral("time=clock:s,x_set=a,y_set=b")}).exit,
        0);
    const json again = run({trace, QStringLiteral("--json")}).parsed();
    QCOMPARE(again["columns"].get<std::string>(), std::string("time=clock:s,x_set=a,y_set=b"));
    QVERIFY(again["samples"].get<int>() > 100);
  }

  /// The same page in each language, with the numbers of that language; no words are left over.
  void writesAPage_data() {
    QTest::addColumn<QString>("language");
    QTest::addColumn<QString>("title");
    QTest::addColumn<QString>("number");
    QTest::newRow("en") << QStringLiteral("en") << QStringLiteral("Report on a motion")
                        << QStringLiteral("10.000");
    QTest::newRow("de") << QStringLiteral("de") << QStringLiteral("Bericht über eine Bewegung")
                        << QStringLiteral("10,000");
    QTest::newRow("fr") << QStringLiteral("fr") << QStringLiteral("Rapport sur un mouvement")
                        << QStringLiteral("10,000");
    QTest::newRow("it") << QStringLiteral("it") << QStringLiteral("Rapporto su un movimento")
                        << QStringLiteral("10,000");
    QTest::newRow("es") << QStringLiteral("es") << QStringLiteral("Informe de un movimiento")
                        << QStringLiteral("10,000");
  }
  void writesAPage() {
    QFETCH(QString, language);
    QFETCH(QString, title);
    QFETCH(QString, number);
    const QString trace = file("good.csv", traceText("t_s;x_cmd;y_cmd\n", false));
    const auto write = [&](const char* name) {
      const QString page = m_folder.filePath(QString::fromUtf8(name));
      const Outcome done =
          run({trace, QStringLiteral("--program"), file("part <1>.mpf", kProgram),
               QStringLiteral("--report"), page, QStringLiteral("--language"), language});
      QFile written(page);
      return done.exit == 0 && written.open(QIODevice::ReadOnly) ? written.readAll() : QByteArray();
    };
    const QString html = QString::fromUtf8(write("page.html"));
    QVERIFY(html.contains(QStringLiteral("<html lang=\"%1").arg(language)));
    QVERIFY(html.contains(title) && html.contains(number));
    QVERIFY(html.contains(QStringLiteral("<svg")));
    QVERIFY(html.contains(QStringLiteral("part &lt;1&gt;.mpf")) &&
            !html.contains(QStringLiteral("<1>")));
    QVERIFY(html.contains(QStringLiteral("name=\"viewport\"")));  // telephones scale it otherwise
    // It needs no other file.
    QVERIFY(!html.contains(QStringLiteral("src=")) && !html.contains(QStringLiteral("href")));
    const QByteArray pdf = write("page.pdf");
    QVERIFY(pdf.startsWith("%PDF-"));
    QCOMPARE(pdf.count("/Type /Page\n"), 1);
  }
  void refusesOtherKindsOfReport() {
    const QString trace = file("good.csv", traceText("t_s;x_cmd;y_cmd\n", false));
    const Outcome done =
        run({trace, QStringLiteral("--report"), m_folder.filePath(QStringLiteral("page.doc"))});
    QCOMPARE(done.exit, 2);
    QVERIFY(done.errors.find(".pdf") != std::string::npos);
  }

  void judgesRules_data() {
    QTest::addColumn<QString>("rule");
    QTest::addColumn<bool>("applies");
    QTest::newRow("one") << "skipped>0" << true;
    QTest::newRow("none") << "skipped > 2" << false;
    QTest::newRow("nested, without its unit") << "contour_error.max>0.05" << true;
    QTest::newRow("nested, with its unit") << "contour_error.max_mm<=0.05" << false;
    QTest::newRow("or") << "skipped>5 or contour_error.max>0.05" << true;
    QTest::newRow("and") << "skipped>0 and contour_error.max>0.07" << false;
    QTest::newRow("and before or") << "skipped==2 or skipped>5 and faultless==0" << true;
    QTest::newRow("a truth") << "faultless!=1" << true;
    QTest::newRow("a list") << "pauses>=3" << true;
    QTest::newRow("unknown") << "nothing>0" << false;
  }
  void judgesRules() {
    QFETCH(QString, rule);
    QFETCH(bool, applies);
    const ordered_json result{{"skipped", 2},
                              {"faultless", false},
                              {"contour_error", {{"max_mm", 0.06}}},
                              {"pauses", {1, 2, 3}}};
    const auto parsed = report::Rule::parse(rule.toStdString());
    QVERIFY(parsed.has_value());
    QCOMPARE(parsed->judge(result).applies, applies);
    QCOMPARE(parsed->judge(result).unknown.size(), std::size_t{rule.startsWith(u"nothing")});
  }
  void refusesBadRules() {
    for (const char* text : {"", "skipped", "skipped>", ">0", "skipped=0", "skipped>0 or "}) {
      QVERIFY2(!report::Rule::parse(text), text);
    }
  }

  /// Slow writes limit a run; arrays and other windows would have helped.
  void saysWhatLimitedARun() {
    trace::Recording recording;
    recording.start.method = "window";
    recording.start.pointsPerLoop = 4;
    recording.start.feedMmPerS = 50.0;
    for (int i = 0; i < 200; ++i) {
      gcode::StreamPoint point;
      point.positionMm = {0.2 * i, 0.0, 0.0};
      recording.points.points.push_back(point);
      const base::Instant at{std::chrono::milliseconds{100 * i}};
      recording.accesses.push_back({at, std::chrono::milliseconds{64}, true, 15});
      recording.accesses.push_back({at, std::chrono::milliseconds{5}, true, 1});
      recording.accesses.push_back({at, std::chrono::milliseconds{5}, false, 1});
    }
    recording.notes.push_back({base::Instant{}, std::string(streaming::kLostNote)});
    recording.notes.push_back({base::Instant{}, std::string(streaming::kRefusedNote)});
    recording.notes.push_back({base::Instant{}, std::string(streaming::kLostNote)});
    const report::StreamQuality quality = report::judgeStream(recording, {});
    QCOMPARE(quality.kinds.size(), std::size_t{3});
    QCOMPARE(quality.periods.size(), std::size_t{10});
    QVERIFY(quality.feedMmPerSMax && *quality.feedMmPerSMax < 50.0);
    QVERIFY(quality.limit == report::StreamLimit::AccessTime);
    QVERIFY(!quality.advice.empty());
    QVERIFY(quality.advice.front().feedMmPerSMax > *quality.feedMmPerSMax);
    QVERIFY(!report::streamQualityText(quality).empty());
    QCOMPARE(quality.lostRequests, std::size_t{2});
    QCOMPARE(quality.refusedRequests, std::size_t{1});
    QCOMPARE(quality.loops, std::size_t{50});
    // All requests of a kind take the same time, so all figures of the margin are one. A window of
    // four points is 0.8 mm long, and takes the client 64 + 5 + 5 ms.
    QVERIFY(quality.margin && quality.marginOfSlowest);
    QCOMPARE(*quality.margin, *quality.feedMmPerSMax / 50.0);
    QVERIFY(std::abs(*quality.margin - 0.8 / 0.074 / 50.0) < 1e-3);
    QVERIFY(std::abs(*quality.marginOfSlowest - *quality.margin) < 1e-9);
    for (const report::AccessPeriod& period : quality.periods) {
      QCOMPARE(period.reads.count, std::size_t{20});
      QCOMPARE(period.writes.count, std::size_t{40});
      QVERIFY(period.margin && std::abs(*period.margin - *quality.margin) < 1e-9);
    }
  }
  /// The part of a run in which the network was slow is seen in its figures alone.
  void showsWhenAccessWasSlow() {
    trace::Recording recording;
    recording.start.method = "window";
    recording.start.pointsPerLoop = 4;
    recording.start.feedMmPerS = 1.0;
    for (int i = 0; i < 1000; ++i) {
      gcode::StreamPoint point;
      point.positionMm = {0.2 * i, 0.0, 0.0};
      recording.points.points.push_back(point);
      const base::Instant at{std::chrono::milliseconds{100 * i}};
      const std::chrono::milliseconds slow{i >= 700 && i < 800 ? 90 : 0};
      recording.accesses.push_back({at, std::chrono::milliseconds{64} + slow, true, 15});
      recording.accesses.push_back({at, std::chrono::milliseconds{5} + slow, true, 1});
      recording.accesses.push_back({at, std::chrono::milliseconds{5} + slow, false, 1});
    }
    const report::StreamQuality quality = report::judgeStream(recording, {});
    QVERIFY(quality.margin && quality.marginOfSlowest);
    QVERIFY(*quality.marginOfSlowest < *quality.margin);
    for (std::size_t i = 0; i < quality.periods.size(); ++i) {
      const bool isSlow = i == 7;
      QCOMPARE(*quality.periods[i].margin < *quality.margin, isSlow);
      QCOMPARE(quality.periods[i].reads.p50,
               base::Duration(std::chrono::milliseconds{isSlow ? 95 : 5}));
    }
  }
};

RIVULET_TEST(TestAnalyse)
#include "tst_analyse.moc"
