// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// A run of method window that is broken off twice and taken up again, by the programs themselves:
/// rivulet-cli against a live rivulet-machine over OPC UA, in real time. The judge has nothing but
/// the list of points and what the machine itself recorded.

#include <QElapsedTimer>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>
#include <csignal>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "gcode/program.h"
#include "report/run_history.h"
#include "support/machine_process.h"
#include "support/patience.h"
#include "support/test_program.h"
#include "trace/analysis/integrity.h"
#include "trace/frames.h"
#include "trace/recording.h"

using namespace rivulet;
using nlohmann::json;

namespace {

using rivulet::tests::kRunMs;
using rivulet::tests::kSoonMs;

QStringList words(const char* text) {
  return QString::fromUtf8(text).split(QLatin1Char(' '), Qt::SkipEmptyParts);
}

/// Rows with corners at their ends, and the tool's first coordinates left open.
QByteArray rows() {
  QByteArray text("G0 Z20\nG0 X0 Y0\nG1 Z10 F1000\n");
  for (int row = 0; row < 12; ++row) {
    for (int i = 0; i <= 5; ++i) {
      text += QByteArray("G1 X") + QByteArray::number(row % 2 == 0 ? 6 * i : 30 - 6 * i) + " Y" +
              QByteArray::number(4 * row) + '\n';
    }
  }
  return text;
}

}  // namespace

class TestResume : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;
  std::unique_ptr<tests::MachineProcess> m_machine;
  QString m_endpoint;
  QString m_program;

  [[nodiscard]] QString path(const QString& name) const { return m_folder.filePath(name); }

  [[nodiscard]] QStringList streamed(const QString& recording) const {
    return QStringList{QStringLiteral("stream"), m_program} + words("--feed 2000 --json") +
           QStringList{QStringLiteral("--endpoint"), m_endpoint, QStringLiteral("--record"),
                       path(recording)};
  }

  /// The same with time to look at it.
  [[nodiscard]] QStringList slowly(const QString& recording) const {
    return streamed(recording).replaceInStrings(QStringLiteral("2000"), QStringLiteral("500"));
  }

  /// Blocks the machine executed in a run, by its own trace.
  [[nodiscard]] std::vector<trace::ExecutedBlock> executed(const QString& recording) const {
    const auto text = base::readFile(path(recording).toStdString());
    const auto parsed = text ? trace::parseRecording(*text) : base::fail(text.error());
    return parsed && parsed->controlTrace ? parsed->controlTrace->blocks
                                          : std::vector<trace::ExecutedBlock>{};
  }

  /// Words of a command that was printed for a person.
  [[nodiscard]] static QStringList resumeWords(const json& run) {
    QStringList words =
        QProcess::splitCommand(QString::fromStdString(run["resume"].get<std::string>())
                                   .replace(QLatin1Char('\''), QLatin1Char('"')));
    words.removeFirst();  // the program
    return words;
  }
  [[nodiscard]] json ask(const QStringList& arguments, int exit) const {
    QProcess process;
    process.start(QStringLiteral(RIVULET_CLI), arguments);
    if (!process.waitForFinished(kRunMs) || process.exitCode() != exit) {
      qWarning("exit %d: %s", process.exitCode(), process.readAllStandardError().constData());
      return {};
    }
    return json::parse(process.readAllStandardOutput().toStdString(), nullptr, false);
  }
  [[nodiscard]] json onControl() const {
    const json found = ask(words("runs --json --endpoint") << m_endpoint, 0);
    return found.is_object() ? found["on_control"] : json();
  }

  /// Windows executed by the run on the control, if it is another one than that.
  [[nodiscard]] int windowsOf(int otherThan) const {
    const json found = onControl();
    return found.is_object() && found["run_number"].get<int>() != otherThan
               ? found["windows_executed"].get<int>()
               : -1;
  }

 private Q_SLOTS:
  void initTestCase() {
    qputenv("XDG_STATE_HOME", path(QStringLiteral("state")).toUtf8());
    m_program = path(QStringLiteral("rows.nc"));
    QFile program(m_program);
    QVERIFY(program.open(QIODevice::WriteOnly));
    QVERIFY(program.write(rows()) > 0);
    program.close();
    m_machine =
        std::make_unique<tests::MachineProcess>(QStringLiteral(RIVULET_MACHINE), words("--seed 1"));
    m_endpoint = m_machine->endpoint();
    QVERIFY(m_endpoint.startsWith(QStringLiteral("opc.tcp://")));
  }

  void cleanupTestCase() { m_machine.reset(); }

  void everyPointOnceOverThreeRuns() {
    // Once at a time set beforehand, once by a signal to the program in the middle.
    QProcess first;
    first.start(QStringLiteral(RIVULET_CLI),
                streamed(QStringLiteral("1.rivulet")) + words("--stop-after 4"));
    QVERIFY(first.waitForFinished(kRunMs));
    QCOMPARE(first.exitCode(), 0);
    const QByteArray report1 = first.readAllStandardOutput();
    const json parsed1 = json::parse(report1.toStdString(), nullptr, false);
    QCOMPARE(parsed1["outcome"].get<std::string>(), std::string("stopped"));
    QVERIFY(parsed1["executed"].get<int>() > 0);
    QVERIFY(parsed1["executed"].get<int>() < parsed1["points"].get<int>());

    const auto resumed = [this](const QString& recording, const QByteArray& report) {
      QFile file(path(recording + QStringLiteral(".json")));
      if (!file.open(QIODevice::WriteOnly) || file.write(report) < 0) {
        qFatal("the test's folder cannot be written");
      }
      return streamed(recording) << QStringLiteral("--resume") << file.fileName();
    };
    QProcess second;
    second.start(QStringLiteral(RIVULET_CLI), resumed(QStringLiteral("2.rivulet"), report1));
    QVERIFY(second.waitForStarted(kSoonMs));
    // Its recording says when the stream has got going.
    const auto accesses = [this] {
      QFile file(path(QStringLiteral("2.rivulet")));
      const std::string bytes =
          file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
      const std::string text = trace::readFrames(bytes)->text;
      return std::count(text.begin(), text.end(), '\n');
    };
    QTRY_VERIFY_WITH_TIMEOUT(accesses() > 400, kRunMs);
    ::kill(static_cast<pid_t>(second.processId()), SIGINT);
    QVERIFY(second.waitForFinished(kRunMs));
    const QByteArray report2 = second.readAllStandardOutput();
    const json parsed2 = json::parse(report2.toStdString(), nullptr, false);
    QCOMPARE(parsed2["outcome"].get<std::string>(), std::string("stopped"));
    const int firstPoint = parsed2["checkpoint"]["first_point"].get<int>();
    QVERIFY(firstPoint >= parsed1["executed"].get<int>());
    QVERIFY(parsed2["executed"].get<int>() > 0);
    // What was judged before the judge below: the points from there on.
    QCOMPARE(parsed2["points"].get<int>(), parsed1["points"].get<int>() - firstPoint);

    QProcess third;
    third.start(QStringLiteral(RIVULET_CLI), resumed(QStringLiteral("3.rivulet"), report2));
    QVERIFY(third.waitForFinished(kRunMs));
    QCOMPARE(third.exitCode(), 0);
    const json parsed3 = json::parse(third.readAllStandardOutput().toStdString(), nullptr, false);
    QCOMPARE(parsed3["outcome"].get<std::string>(), std::string("completed"));

    std::vector<trace::ExecutedBlock> blocks;
    for (const char* recording : {"1.rivulet", "2.rivulet", "3.rivulet"}) {
      const auto part = executed(QString::fromLatin1(recording));
      QVERIFY(!part.empty());
      blocks.insert(blocks.end(), part.begin(), part.end());
    }
    const auto program = gcode::loadProgram(m_program.toStdString());
    QVERIFY(program.has_value());
    const json start = parsed1["checkpoint"]["start_mm"];
    const auto points =
        gcode::streamPoints(program->trajectory, {start[0].get<double>(), start[1].get<double>(),
                                                  start[2].get<double>()})
            .points;
    QCOMPARE(static_cast<int>(points.size()), parsed1["points"].get<int>());
    const trace::Integrity integrity = trace::judgeIntegrity(points, blocks, 1e-6);
    // The signal has held the axes in the middle of a window. What they executed of the windows
    // that the control had then, before the third run, is in no recording (tst_kills judges it by
    // the machine's own list).
    constexpr std::size_t kDelivered = 14;
    QVERIFY(parsed2["left_held"].get<bool>());
    QCOMPARE(integrity.repeated + integrity.foreign + integrity.outOfOrder, std::size_t{0});
    QCOMPARE(integrity.executed + integrity.skipped, points.size());
    QVERIFY2(integrity.skipped <= kDelivered, qPrintable(QString::number(integrity.skipped)));

    // There is nothing left to be resumed, and nothing moves for the question.
    QProcess again;
    again.start(QStringLiteral(RIVULET_CLI), resumed(QStringLiteral("4.rivulet"), report2));
    QVERIFY(again.waitForFinished(kRunMs));
    QCOMPARE(again.exitCode(), 2);
    QVERIFY(!QFile::exists(path(QStringLiteral("4.rivulet"))));
  }

  /// The client is killed. Whoever comes next is told whose run it is and how to go on.
  void aRunThatIsFoundIsOffered() {
    QProcess first;
    first.start(QStringLiteral(RIVULET_CLI), slowly(QStringLiteral("5.rivulet")));
    QTRY_VERIFY_WITH_TIMEOUT(windowsOf(0) > 1, kRunMs);
    const json alive = onControl();
    QVERIFY(alive["has_client"].get<bool>());
    QVERIFY(!alive["can_resume"].get<bool>());
    QVERIFY(!alive["started_by"]["user"].get<std::string>().empty());
    // As long as its client is there, the run is nobody else's.
    const json busy = ask(slowly(QStringLiteral("6.rivulet")), 2);
    const std::string who = busy["error"]["message"].get<std::string>();
    QVERIFY(who.find("started by " + alive["started_by"]["user"].get<std::string>()) !=
            std::string::npos);
    QVERIFY(who.find("--resume") == std::string::npos);
    first.kill();
    QVERIFY(first.waitForFinished(kSoonMs));

    const json waiting = onControl();
    QVERIFY(!waiting["has_client"].get<bool>());
    QVERIFY(waiting["can_resume"].get<bool>());
    QCOMPARE(waiting["run_number"].get<int>(), alive["run_number"].get<int>());
    const json offered = ask(slowly(QStringLiteral("6.rivulet")), 2);
    QVERIFY(offered["error"]["message"].get<std::string>().find("--resume") != std::string::npos);

    // The command as it is offered goes on; a terminal that is closed holds it.
    QProcess second;
    second.start(QStringLiteral(RIVULET_CLI), resumeWords(waiting["saved_run"]));
    QVERIFY(second.waitForStarted(kSoonMs));
    const int before = waiting["run_number"].get<int>();
    QTRY_VERIFY_WITH_TIMEOUT(windowsOf(before) > 0, kRunMs);
    ::kill(static_cast<pid_t>(second.processId()), SIGHUP);
    QVERIFY(second.waitForFinished(kRunMs));
    const json report = json::parse(second.readAllStandardOutput().toStdString(), nullptr, false);
    QVERIFY2(report["outcome"] == "stopped", report.dump(1).c_str());
    QVERIFY(report["faultless"].get<bool>());
    QVERIFY(report["checkpoint"]["first_point"].get<int>() > 0);
    QVERIFY(QFile::exists(QString::fromStdString(report["saved_run"].get<std::string>())));
    QVERIFY(report["left_held"].get<bool>() && !onControl().is_null());
    QVERIFY(ask(words("runs --end --json --endpoint") << m_endpoint, 0).contains("ended"));
    QVERIFY(onControl().is_null());
    const json kept = ask(words("runs --json"), 0)["runs"];
    QCOMPARE(kept.size(), std::size_t{1});
    QVERIFY(ask(words("runs --json --forget") << QString::number(kept[0]["run_number"].get<int>()),
                0)["runs"]
                .empty());
  }

  /// Every run over a connection, with a recording although none was asked for.
  void everyRunIsInTheHistory() {
    const report::RunHistory history;
    const std::size_t before = history.list().runs.size();
    QVERIFY2(before >= 3, qPrintable(QString::number(before)));
    const json report =
        ask(QStringList{QStringLiteral("stream"), m_program} +
                words("--feed 2000 --json --stop-after 1 --endpoint") + QStringList{m_endpoint},
            0);
    QVERIFY(report.is_object());
    const report::HistoryList list = history.list();
    QCOMPARE(list.runs.size(), before + 1);
    const streaming::RunSummary& run = list.runs.front();
    QCOMPARE(run.programFile, m_program.toStdString());
    QCOMPARE(run.endpoint, m_endpoint.toStdString());
    QVERIFY(run.outcome == streaming::Outcome::Stopped);
    // On a computer that is busy, points may come too late: the history says what the report says.
    QCOMPARE(run.finding == streaming::RunFinding::Faultless, report["faultless"].get<bool>());
    QVERIFY(run.ownsRecording);
    const auto text = base::readFile(run.recording);
    QVERIFY(text.has_value());
    QVERIFY(trace::parseRecording(*text)->complete);
    const auto whole = report::readFinishedRun(history.reportFile(run.id));
    QVERIFY(whole.has_value());
    QCOMPARE(whole->report.counters.executed, report["executed"].get<std::size_t>());
    // A recording that the user has named stays his.
    QVERIFY(!list.runs.back().ownsRecording);
    QVERIFY(list.runs.back().recording.ends_with("1.rivulet"));
  }

  /// The points of a run within a tolerance are those of the run that goes on, whether it is given
  /// again or not; another one is refused.
  void aToleranceIsThatOfTheRun() {
    const QString program = path(QStringLiteral("dense.nc"));
    QByteArray text("G1 X0 Y0 Z10 F3000\n");
    for (int i = 1; i <= 600; ++i) {
      const double angle = 0.01 * i;
      text += "X" + QByteArray::number(20.0 * std::sin(angle), 'f', 3) + " Y" +
              QByteArray::number(20.0 - 20.0 * std::cos(angle), 'f', 3) + '\n';
    }
    QFile file(program);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) > 0);
    file.close();
    const auto stream = [&](const char* recording, const char* more) {
      return QStringList{QStringLiteral("stream"), program} +
             words("--feed 500 --json --packed --record") +
             QStringList{path(QString::fromLatin1(recording)), QStringLiteral("--endpoint"),
                         m_endpoint} +
             words(more);
    };
    const json stopped = ask(stream("t-1.rivulet", "--tolerance 0.02 --stop-after 3"), 0);
    QVERIFY2(stopped.is_object() && stopped["outcome"] == "stopped", stopped.dump(1).c_str());
    const json& merged = stopped["merged"];
    QCOMPARE(merged["of"], 601);
    QCOMPARE(merged["to"], stopped["points"]);
    QVERIFY(merged["to"] < 100 && merged["deviation_mm"] <= 0.02 && merged["deviation_mm"] > 0.01);
    QCOMPARE(stopped["settings"]["tolerance_mm"], 0.02);
    const QString run = QString::fromStdString(stopped["saved_run"].get<std::string>());
    const json refused =
        ask(stream("t-2.rivulet", "--tolerance 0.01 --resume") + QStringList{run}, 2);
    QVERIFY(refused.dump().find("Leave out --tolerance") != std::string::npos);
    const json resumed = ask(stream("t-3.rivulet", "--resume") + QStringList{run}, 0);
    QVERIFY2(resumed.is_object() && resumed["outcome"] == "completed" && resumed["faultless"],
             resumed.dump(1).c_str());
    QCOMPARE(resumed["merged"], merged);
    gcode::Program whole = *gcode::interpretProgram("dense.nc", text.toStdString());
    gcode::MoveRules rules;
    rules.tolerance = 0.02;
    rules.onSteps = true;
    QVERIFY(gcode::applyRules(whole, rules));
    const auto points = gcode::streamPoints(whole.trajectory, {}).points;
    std::vector<trace::ExecutedBlock> blocks = executed(QStringLiteral("t-1.rivulet"));
    const auto after = executed(QStringLiteral("t-3.rivulet"));
    blocks.insert(blocks.end(), after.begin(), after.end());
    QCOMPARE(blocks.size(), points.size());
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      QVERIFY(base::distance(blocks[i].targetMm, points[i].positionMm) < 1e-6);
    }
  }

  /// Stopped in the middle of a row, driven back by 20 mm along the path, once more to where the
  /// rapid ended being refused beyond it, and resumed: the machine's traces have each point once,
  /// and from where the tool stood then once more.
  void theToolIsDrivenBackAndTheRunGoesOn() {
    const json stopped =
        ask(streamed(QStringLiteral("back-1.rivulet")) + words("--stop-after 8"), 0);
    QVERIFY(stopped.is_object() && stopped["outcome"] == "stopped");
    const QString run = QString::fromStdString(stopped["saved_run"].get<std::string>());
    const QStringList back{QStringLiteral("back"), run, QStringLiteral("--endpoint"), m_endpoint};
    QVERIFY(ask(back + words("--by 9999 --feed 500 --json"), 2).is_object());  // it begins before
    const json driven = ask(back + words("--by 20 --feed 800 --json"), 0);
    QVERIFY2(driven.is_object() && driven["outcome"] == "completed" && driven["repeated"] == 0 &&
                 driven["foreign"] == 0,
             driven.dump(1).c_str());
    const json resumed =
        ask(streamed(QStringLiteral("back-2.rivulet")) << QStringLiteral("--resume") << run, 0);
    QVERIFY2(resumed.is_object() && resumed["outcome"] == "completed" && resumed["faultless"],
             resumed.dump(1).c_str());
    const auto before = executed(QStringLiteral("back-1.rivulet"));
    const auto after = executed(QStringLiteral("back-2.rivulet"));
    QVERIFY(!before.empty() && !after.empty());
    const auto text = base::readFile(m_program.toStdString());
    const auto points =
        gcode::streamPoints(gcode::interpretProgram("rows.nc", *text)->trajectory, {}).points;
    const std::size_t left = resumed["points"].get<std::size_t>();
    const std::size_t first = stopped["points"].get<std::size_t>() - left;
    const std::size_t done = stopped["executed"].get<std::size_t>();
    // 6 mm a move, and 4 mm to the next row: 20 mm are four moves or five.
    QVERIFY(first < done && done - first >= 3 && done - first <= 5);
    QCOMPARE(after.size(), left);
    for (std::size_t i = 0; i < left; ++i) {
      QVERIFY(base::distance(after[i].targetMm, points[points.size() - left + i].positionMm) <
              1e-6);
    }
  }

  /// What a control is and costs, by reading alone: what it has is the same afterwards.
  void theControlIsSurveyed() {
    const QString file = path(QStringLiteral("survey.json"));
    const json survey = ask(QStringList{QStringLiteral("survey"), QStringLiteral("--endpoint"),
                                        m_endpoint, QStringLiteral("-o"), file} +
                                words("--json"),
                            0);
    QVERIFY(survey.is_object());
    QCOMPARE(survey["r_parameters"].get<int>(), 100);
    QCOMPARE(survey["axes"].size(), std::size_t{3});
    QCOMPARE(survey["rights"].size(), std::size_t{5});
    double three = 0.0;
    double hundred = 0.0;
    for (const json& timed : survey["access"]) {
      if (timed["form"] == "list" && timed["r_parameters"] == 3) {
        three = timed["median_ms"];
      } else if (timed["form"] == "list" && timed["r_parameters"] == 100) {
        hundred = timed["median_ms"];
      }
    }
    QVERIFY(three > 0.0 && hundred > 5.0 * three);  // each node costs
    const auto written = base::readFile(file.toStdString());
    QVERIFY(written && json::parse(*written) == survey);
    QVERIFY(survey.dump().find(m_endpoint.toStdString()) == std::string::npos);  // nothing private
  }

  /// Out of the cut, by a run of its own; never down.
  void theToolIsRaised() {
    QFile place(path(QStringLiteral("place.nc")));
    QVERIFY(place.open(QIODevice::WriteOnly) && place.write("G1 X10 Y10 Z-5 F3000\n") > 0);
    place.close();
    tests::MachineProcess own(QStringLiteral(RIVULET_MACHINE), words("--seed 1"));
    const auto run = [&](const QStringList& words, int exit) {
      return ask(words + QStringList{QStringLiteral("--json"), QStringLiteral("--endpoint"),
                                     own.endpoint()},
                 exit);
    };
    const QStringList stream{QStringLiteral("stream"), place.fileName(), QStringLiteral("--feed"),
                             QStringLiteral("9000")};
    QVERIFY(run(stream, 0).is_object());
    QVERIFY(run(words("raise --feed 500 --to -8"), 2).is_object());
    const json raised = run(words("raise --feed 500 --to 20"), 0);
    QVERIFY2(raised.is_object() && raised["executed"] == 1, raised.dump().c_str());
  }
};

RIVULET_TEST(TestResume)
#include "tst_resume.moc"
