// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The program itself: exit codes, JSON, and one clear sentence for bad input.

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "journal/audit.h"
#include "support/machine_process.h"
#include "support/patience.h"
#include "support/test_program.h"
#include "trace/frames.h"

using namespace rivulet;

using nlohmann::json;

namespace {

const QString kScorpion = QStringLiteral(RIVULET_SOURCE_DIR "/resources/programs/scorpion.tap");

/// The motion alone of a program that also changes the tool and turns the spindle.
QStringList streamMotion() {
  return {QStringLiteral("stream"), kScorpion, QStringLiteral("--motion-only")};
}

struct Outcome {
  int exit = -1;
  QString output;
  QString errors;
  [[nodiscard]] json parsed() const { return json::parse(output.toStdString(), nullptr, false); }
};

Outcome run(const QStringList& arguments) {
  QProcess process;
  process.start(QStringLiteral(RIVULET_CLI), arguments);
  Outcome outcome;
  if (process.waitForFinished(tests::kRunMs) && process.exitStatus() == QProcess::NormalExit) {
    outcome.exit = process.exitCode();
  }
  outcome.output = QString::fromUtf8(process.readAllStandardOutput());
  outcome.errors = QString::fromUtf8(process.readAllStandardError());
  return outcome;
}

QStringList words(const char* text) {
  return QString::fromUtf8(text).split(QLatin1Char(' '), Qt::SkipEmptyParts);
}

bool writeText(const QString& path, const QString& text) {
  QFile file(path);
  return file.open(QIODevice::WriteOnly | QIODevice::Truncate) && file.write(text.toUtf8()) >= 0;
}

}  // namespace

class TestCli : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;

  QString file(const char* name, const QByteArray& text) {
    QFile out(m_folder.filePath(QString::fromUtf8(name)));
    if (!out.open(QIODevice::WriteOnly) || out.write(text) < 0) {
      qFatal("the test's folder cannot be written");
    }
    return out.fileName();
  }

 private Q_SLOTS:
  void checks() {
    const Outcome outcome = run({QStringLiteral("check"), kScorpion, QStringLiteral("--json")});
    QCOMPARE(outcome.exit, 0);
    const json result = outcome.parsed();
    QCOMPARE(result["motions"]["g0"].get<int>(), 7);
    QCOMPARE(result["motions"]["g1"].get<int>(), 266);
    QCOMPARE(result["streamable"].get<bool>(), true);
    QCOMPARE(result["dialect"].get<std::string>(), std::string("fanuc"));
    QCOMPARE(result["facts"]["n_G1"].get<int>(), 266);
    QCOMPARE(result["facts"]["bbox_programmed"]["X"][1].get<double>(), 206.12);
    QCOMPARE(result["statistics"]["points"].get<int>(), 270);
    QVERIFY(result["statistics"]["distance_mm"]["min"].get<double>() > 0.0);
    QCOMPARE(result["facts"]["units"].get<std::string>(), std::string("mm"));
    QVERIFY(std::abs(result["facts"]["g1_length"].get<double>() - 2450.806) < 1e-3);
    QCOMPARE(run({QStringLiteral("check"), file("bad.nc", "G1 X1 F100\nG87 X2\n")}).exit, 1);
    QCOMPARE(run({QStringLiteral("check"), file("bad.nc", "G1 X1 F100\nG87 X2\n"),
                  QStringLiteral("--accept"), QStringLiteral("g87")})
                 .exit,
             0);
  }

  /// What a text leaves open is asked before anything moves.
  void asksWhatATextMeans() {
    const QString unclear = file("unclear.nc", "G21 G90\nG0 X1. Y0. Z5.\nG1 X9. F100 ; Y2.\nX3.\n");
    const Outcome asked = run({QStringLiteral("check"), unclear});
    QCOMPARE(asked.exit, 2);
    QVERIFY(asked.output.contains(QStringLiteral("as fanuc the tool goes to X9 Y2")));
    for (const char* const command : {"job", "stream"}) {
      const Outcome refused =
          run({QString::fromLatin1(command), unclear, QStringLiteral("--simulate")});
      QCOMPARE(refused.exit, 2);
      QVERIFY(refused.errors.contains(QStringLiteral("--dialect")));
    }
    QCOMPARE(
        run({QStringLiteral("check"), unclear, QStringLiteral("--dialect"), QStringLiteral("grbl")})
            .exit,
        0);
    // A virtual machine is metric; files for another one are not written on a guess.
    const QString silent = file("silent.nc", "O1\nG90 G0 X0. Y0. Z5.\nG1 X9. F100\nM30\n");
    const QStringList write{QStringLiteral("job"), silent, QStringLiteral("-o"),
                            m_folder.filePath(QStringLiteral("silent"))};
    const Outcome refused = run(write);
    QCOMPARE(refused.exit, 2);
    QVERIFY(refused.errors.contains(QStringLiteral("--units")));
    QCOMPARE(run(write + words("--units mm")).exit, 0);
    QCOMPARE(run({QStringLiteral("job"), silent, QStringLiteral("--simulate")}).exit, 0);
    // Files are for a control, also if the same job is tried on a virtual machine first.
    const struct {
      const char* name;  ///< word of the message
      const char* folder;
      QByteArray beginning;  ///< what a virtual machine has, and a control may not have
      QByteArray feed;
    } assumptions[] = {{"M163", "M163", "T1 M6\nG0 G43 H1 Z50.\nM163\n", " F500."},
                       {"H5", "H5", "G0 G43 H5 Z50.\n", " F500."},
                       {"F", "feed", "T1 M6\nG0 G43 H1 Z50.\n", ""}};
    for (const auto& [assumed, name, beginning, feed] : assumptions) {
      const QString part = file("assumed.nc", "O7\nG21 G90 G94 G17\nG54\n" + beginning +
                                                  "G0 X0. Y0.\nG1 X5." + feed + "\nM30\n");
      const QString folder = m_folder.filePath(QLatin1String(name));
      const Outcome alone =
          run({QStringLiteral("job"), part, QStringLiteral("--verify"), QStringLiteral("--json")});
      QVERIFY2(alone.exit == 0, qPrintable(alone.errors + alone.output));
      const Outcome written = run(
          {QStringLiteral("job"), part, QStringLiteral("--verify"), QStringLiteral("-o"), folder});
      QVERIFY(written.exit != 0);
      QVERIFY2(written.errors.contains(QLatin1String(assumed)), qPrintable(written.errors));
      QVERIFY(!QDir(folder).exists());
    }
    const QString points =
        run({QStringLiteral("points"), silent, QStringLiteral("--units"), QStringLiteral("inch")})
            .output;
    QVERIFY(points.contains(QStringLiteral("228.6")));
  }

  void saysWhatAJobWouldSay() {
    const QString good = file("good.mpf", "T1 M6\nS500 M3\nG0 X1 Y1 Z5\nG1 X2 F100\nM30\n");
    const QString bad = file("bad.nc", "O1\nG21 G0 X1. Y1. Z5.\nM777\nG1 X2. F100\nM30\n");
    for (const QString& path : {good, bad}) {
      const Outcome job = run({QStringLiteral("job"), path, QStringLiteral("--simulate")});
      const Outcome check = run({QStringLiteral("check"), path, QStringLiteral("--job")});
      QCOMPARE(check.exit, job.exit);
      const json result =
          run({QStringLiteral("check"), path, QStringLiteral("--job"), QStringLiteral("--json")})
              .parsed();
      QCOMPARE(result["job"]["runs"].get<bool>(), job.exit == 0);
    }
  }

  /// Every native block is listed with its reason.
  void listsTheStretches() {
    const QString path =
        file("part.mpf", "T1 M6\nS500 M3\nG0 X1 Y1 Z5\nG1 X2 F100\nSUPA G0 Z0 D0\nM30\n");
    const json stretches =
        run({QStringLiteral("check"), path, QStringLiteral("--json")}).parsed()["stretches"];
    QCOMPARE(stretches["whole"].get<bool>(), true);
    const json& parts = stretches["parts"];
    QCOMPARE(parts.size(), std::size_t{5});
    QCOMPARE(parts[0]["reason"].get<std::string>(), std::string("tool"));
    QCOMPARE(parts[2]["kind"].get<std::string>(), std::string("streamed"));
    QCOMPARE(parts[2]["points"].get<int>(), 2);
    QCOMPARE(parts[3]["text"].get<std::string>(), std::string("SUPA G0 Z0 D0"));
    const QString text = run({QStringLiteral("check"), path}).output;
    QVERIFY(text.contains(QStringLiteral("As a job: 1 streamed, 4 for the control")));
    QVERIFY(text.contains(QStringLiteral("retract              SUPA G0 Z0 D0")));
  }

  void checksFolders() {
    const QTemporaryDir folder;
    const auto put = [&folder](const char* name, const char* text) {
      QFile out(folder.filePath(QString::fromLatin1(name)));
      QVERIFY(out.open(QIODevice::WriteOnly));
      out.write(text);
    };
    put("a.nc", "G1 X1 F100\n");
    put("b.mpf", "TRAORI\nG1 X1 Y2 F100\n");
    put("readme.md", "no program");
    const Outcome table = run({QStringLiteral("check"), folder.path()});
    QCOMPARE(table.exit, 0);
    QVERIFY(table.output.contains(QStringLiteral("2 of 2 understood")));
    QCOMPARE(table.output.count(QStringLiteral("  streamable\n")), 2);
    put("d.nc", "M3 S500\n");
    const Outcome still = run({QStringLiteral("check"), folder.path()});
    QVERIFY(still.output.contains(QStringLiteral("  no motion\n")));
    QVERIFY(!still.output.contains(QStringLiteral("needs a transformation")));
    QVERIFY(QFile::remove(folder.filePath(QStringLiteral("d.nc"))));
    put("c.tap", "G1 X1 G87\n");
    const Outcome all = run({QStringLiteral("check"), folder.path(), QStringLiteral("--json")});
    QCOMPARE(all.exit, 1);
    const json list = all.parsed();
    QCOMPARE(list.size(), std::size_t{3});
    QCOMPARE(list[1]["dialect"].get<std::string>(), std::string("sinumerik"));
    const QTemporaryDir empty;
    QCOMPARE(run({QStringLiteral("check"), empty.path()}).exit, 2);
  }

  /// The page of Figure 13 in a folder that does not exist yet, and again in what was made of it.
  void writesFigure13IntoANewFolder() {
    const QString folder = m_folder.filePath(QStringLiteral("new/docs"));
    const QStringList command{QStringLiteral("petri"), QStringLiteral("figure13"),
                              QStringLiteral("--report"), folder};
    const auto page = [&] {
      QFile read(folder + QStringLiteral("/parallel.md"));
      return read.open(QIODevice::ReadOnly) ? read.readAll() : QByteArray();
    };
    const Outcome first = run(command);
    QVERIFY2(first.exit == 0 || first.exit == 1, qPrintable(first.errors));
    QVERIFY(page().startsWith("<!--"));
    QVERIFY(page().contains("## `figure13`"));
    QVERIFY(QFile::exists(folder + QStringLiteral("/images/parallel/figure13-9.svg")));
    const QByteArray before = page();
    QCOMPARE(run(command).exit, first.exit);
    QCOMPARE(page(), before);
  }

  void verifiesAuditTrails() {
    const QString path = m_folder.filePath(QStringLiteral("audit.jsonl"));
    for (int i = 0; i < 3; ++i) {
      QVERIFY(journal::appendAudit(path.toStdString(), {i, "anna", "", "start", {{"n", "1"}}})
                  .has_value());
    }
    const QString audit = QStringLiteral("audit");
    const QString verify = QStringLiteral("--verify");
    Outcome outcome = run({audit, path});
    QCOMPARE(outcome.exit, 0);
    QCOMPARE(outcome.output.count(QLatin1Char('\n')), 4);
    QVERIFY(outcome.output.contains(QLatin1String("\"anna\",\"\",\"start\",\"n=1\"")));
    outcome = run({audit, verify, path});
    QCOMPARE(outcome.exit, 0);
    QVERIFY(outcome.output.contains(QLatin1String("3 lines, no line was changed")));
    QFile trail(path);
    QVERIFY(trail.open(QIODevice::ReadWrite));
    QByteArray text = trail.readAll();
    text.replace(text.indexOf("anna"), 4, "otto");
    QVERIFY(trail.seek(0) && trail.write(text) == text.size());
    trail.close();
    outcome = run({audit, verify, path});
    QCOMPARE(outcome.exit, 1);
    QVERIFY(outcome.output.contains(QLatin1String("Line 1 was changed")));
    const json parsed = run({audit, path, QStringLiteral("--json")}).parsed();
    QCOMPARE(parsed["findings"].size(), std::size_t{2});
    QCOMPARE(run({audit, path + QLatin1Char('x')}).exit, 2);
  }

  void writesPoints() {
    const QString program = file("p.nc", "G0 X0 Y0 Z0\nG1 X1 F60\nX2\nX3 Y1\n");
    const Outcome all = run({QStringLiteral("points"), program});
    QCOMPARE(all.exit, 0);
    QCOMPARE(all.output,
             QString::fromLatin1("line,kind,x_mm,y_mm,z_mm,feed_mm_per_min\n1,rapid,0,0,0,\n"
                                 "2,line,1,0,0,60\n3,line,2,0,0,60\n4,line,3,1,0,60\n"));
    const Outcome thinned = run({QStringLiteral("points"), program, QStringLiteral("--tolerance"),
                                 QStringLiteral("0.001")});
    QCOMPARE(thinned.output.count(QLatin1Char('\n')), 4);
    QVERIFY(thinned.errors.contains(
        QStringLiteral("3 of 4 points are streamed, at most 0.0000 mm off the program.")));
    const Outcome split =
        run({QStringLiteral("points"), program, QStringLiteral("--split"), QStringLiteral("0.5")});
    QCOMPARE(split.output.count(QLatin1Char('\n')), 9);
  }

  void judges() {
    const auto judge = [](const char* point) {
      return run(words(point) << QStringLiteral("--program") << kScorpion
                              << QStringLiteral("--json"));
    };
    const Outcome yes = judge("feasibility --method signal --points 7 --delta 0.3 --feed 3000");
    QCOMPARE(yes.exit, 0);
    QCOMPARE(yes.parsed()["feasible"].get<bool>(), true);
    QCOMPARE(judge("feasibility --method signal --points 200 --feed 3000").exit,
             2);  // does not fit
    const Outcome no = judge("feasibility --method position --points 7 --delta 0.75 --feed 20000");
    QCOMPARE(no.exit, 1);
    const json verdict = no.parsed();
    QCOMPARE(verdict["feasible"].get<bool>(), false);
    QVERIFY(verdict["limiting"]["margin"].get<double>() < 1.0);
    QVERIFY(verdict["feed_mm_per_min_max"].get<double>() < 20000.0);
  }

  void generates() {
    const QString path = m_folder.filePath(QStringLiteral("t.mpf"));
    QCOMPARE(run(words("template --method position --points 9 -o") << path).exit, 0);
    QFile written(path);
    QVERIFY(written.open(QIODevice::ReadOnly));
    QCOMPARE(QString::fromUtf8(written.readAll()),
             run(words("template --method position --points 9")).output);
  }

  void verifiesTemplates() {
    const Outcome sound = run(words("template --points 3 --verify --json"));
    QCOMPARE(sound.exit, 0);
    QVERIFY(sound.parsed()["sound"].get<bool>());
    QVERIFY(sound.parsed()["verdict"]["findings"].empty());
    QCOMPARE(sound.parsed()["verdict"]["cases"].size(), std::size_t{6});
    const QString path = m_folder.filePath(QStringLiteral("lint.mpf"));
    QString text = run(words("template --method position --points 3")).output;
    QVERIFY(writeText(path, text));
    const QStringList lint = words("template --method position --points 3 --lint") << path;
    QCOMPARE(run(lint).exit, 0);
    QCOMPARE(run(QStringList(lint) << QStringLiteral("--verify")).exit, 0);
    // Made for other settings, the client must not drive it.
    QCOMPARE(run(words("template --method position --points 4 --lint") << path).exit, 1);
    text.replace(QStringLiteral("IF R2<1 GOTOB"), QStringLiteral("GOTOB"));
    QVERIFY(writeText(path, text));
    const Outcome broken = run(QStringList(lint) << QStringLiteral("--json"));
    QCOMPARE(broken.exit, 1);
    const json finding = broken.parsed()["findings"].front();
    QCOMPARE(finding["code"].get<std::string>(), std::string("stop-check-missing"));
    QCOMPARE(finding["severity"].get<std::string>(), std::string("error"));
    QCOMPARE(
        finding["line"].get<qsizetype>(),
        text.left(text.indexOf(QStringLiteral("GOTOB RIV_LOOP"))).count(QLatin1Char('\n')) + 1);
    QCOMPARE(run(words("template --lint /nowhere.mpf")).exit, 2);
  }

  void streamsAndAnalyses() {
    const QString path = m_folder.filePath(QStringLiteral("run.rivulet"));
    const Outcome stream =
        run(streamMotion() << words("--method signal --points 7 --delta 0.3 --feed 3000 "
                                    "--simulate --seed 2 --json --record")
                           << path);
    QCOMPARE(stream.exit, 0);
    const json report = stream.parsed();
    QCOMPARE(report["outcome"].get<std::string>(), std::string("completed"));
    QCOMPARE(report["points"].get<int>(), 270);
    QCOMPARE(report["executed"].get<int>(), 270);
    QCOMPARE(report["repeated"].get<int>() + report["skipped"].get<int>(), 0);
    QCOMPARE(report["pauses"].size(), std::size_t{77});
    for (const char* key : {"mean", "p50", "p95", "p99", "max"}) {
      QVERIFY(report["access_ms"][key].get<double>() > 0.0);
    }
    const Outcome analyse = run({QStringLiteral("analyse"), path, QStringLiteral("--json")});
    QCOMPARE(analyse.exit, 0);
    QCOMPARE(analyse.parsed()["executed"].get<int>(), 270);
    QCOMPARE(analyse.parsed()["pauses"].size(), std::size_t{77});
    QVERIFY(analyse.parsed()["complete"].get<bool>());
  }

  /// Run and recording say the same of a trace that is shorter than the run, and of a recording
  /// that a full disk has cut off.
  void incompleteTracesAreNotCalledGood() {
    QFile preset(QStringLiteral(RIVULET_SOURCE_DIR "/resources/presets/dmu75.toml"));
    QVERIFY(preset.open(QIODevice::ReadOnly));
    QByteArray text = preset.readAll();
    const qsizetype at = text.indexOf("traceMinutes");
    QVERIFY(at >= 0);
    text.replace(at, text.indexOf('\n', at) - at, "traceMinutes = 0.05");
    const QString forgetful = file("forgetful.toml", text);
    const QString path = m_folder.filePath(QStringLiteral("long.rivulet"));
    const Outcome stream = run(streamMotion() << words("--feed 3000 --simulate --json --record")
                                              << path << QStringLiteral("--preset") << forgetful);
    QCOMPARE(stream.exit, 0);
    const json report = stream.parsed();
    QVERIFY(!report["judged"].get<bool>());
    QVERIFY(!report["faultless"].get<bool>());
    QVERIFY(report["duration_s"].get<double>() > 30.0);
    QVERIFY(report["recording_complete"].get<bool>());
    const json analysed = run({QStringLiteral("analyse"), path, QStringLiteral("--json")}).parsed();
    for (const char* key : {"judged", "faultless", "finding", "duration_s"}) {
      QVERIFY2(analysed[key] == report[key], key);
    }

    const Outcome full =
        run(streamMotion() << words("--feed 3000 --simulate --json --record /dev/full"));
    QCOMPARE(full.exit, 1);
    QVERIFY(!full.parsed()["recording_complete"].get<bool>());
    QVERIFY(full.errors.contains(QStringLiteral("incomplete")));
    QFile recording(path);
    QVERIFY(recording.open(QIODevice::ReadOnly));
    const QByteArray all = recording.readAll();
    const QString cut = file("cut.rivulet", all.left(all.size() / 2));
    const Outcome half = run({QStringLiteral("analyse"), cut, QStringLiteral("--json")});
    QCOMPARE(half.exit, 1);
    QVERIFY(!half.parsed()["complete"].get<bool>());
    QVERIFY(!half.parsed()["faultless"].get<bool>());
    QVERIFY(run({QStringLiteral("analyse"), cut})
                .output.contains(QStringLiteral("cut off before the end")));
  }

  /// Output that cannot be written: a sentence and an exit code, and no program that is aborted.
  void outputThatCannotBeWritten() {
    const QString program = file("output.nc", "G90 G1 F1000 X1 Y1 Z0\nX2\nX3\nM30\n");
    const QList<QStringList> commands{
        {QStringLiteral("check"), program},
        {QStringLiteral("check"), program, QStringLiteral("--json")},
        {QStringLiteral("points"), program},
        {QStringLiteral("job"), program, QStringLiteral("--simulate"), QStringLiteral("--json")},
        {QStringLiteral("template")},
        {QStringLiteral("--help")},
    };
    struct Sink {
      const char* how;
      bool isLost;
    };
    for (const Sink& sink :
         {Sink{"exec \"$0\" \"$@\" >/dev/full", true}, Sink{"exec \"$0\" \"$@\" >&-", true},
          Sink{"set -o pipefail; \"$0\" \"$@\" | true", false}}) {
      for (const QStringList& command : commands) {
        QProcess process;
        process.start(QStringLiteral("bash"),
                      QStringList{QStringLiteral("-c"), QString::fromUtf8(sink.how),
                                  QStringLiteral(RIVULET_CLI)} +
                          command);
        QVERIFY(process.waitForFinished());
        const QByteArray errors = process.readAllStandardError();
        QVERIFY2(process.exitStatus() == QProcess::NormalExit &&
                     process.exitCode() == (sink.isLost ? 1 : 0),
                 (QByteArray(sink.how) + ' ' + command.join(QLatin1Char(' ')).toUtf8() + ' ' +
                  QByteArray::number(process.exitCode()) + ' ' + errors)
                     .constData());
        QCOMPARE(errors.contains("Not all output could be written"), sink.isLost);
      }
    }
  }

  /// A pipe that nobody empties holds up neither the run nor its end.
  void aRecordingThatHangsIsCut() {
    const QString pipe = m_folder.filePath(QStringLiteral("pipe"));
    QCOMPARE(mkfifo(pipe.toUtf8().constData(), 0600), 0);
    const int reader = ::open(pipe.toUtf8().constData(), O_RDONLY | O_NONBLOCK);
    QVERIFY(reader >= 0);
    const Outcome stream =
        run(streamMotion() << words("--feed 3000 --simulate --json --record") << pipe);
    ::close(reader);
    QCOMPARE(stream.exit, 1);
    QCOMPARE(stream.parsed()["outcome"].get<std::string>(), std::string("completed"));
    QVERIFY(!stream.parsed()["recording_complete"].get<bool>());
  }

  /// Method credit runs where its test is passed, without a pause; elsewhere it does not start.
  void creditNeedsItsTest() {
    const Outcome test = run(words("commission --simulate --json"));
    QCOMPARE(test.exit, 0);
    QVERIFY(test.parsed()["passed"].get<bool>());
    const QStringList credit =
        streamMotion() + words("--method credit --feed 400 --simulate --json");
    const Outcome stream = run(credit);
    QCOMPARE(stream.exit, 0);
    QCOMPARE(stream.parsed()["executed"].get<int>(), 270);
    QCOMPARE(stream.parsed()["pauses"].size(), std::size_t{0});
    QCOMPARE(stream.parsed()["settings"]["windows_ahead"].get<int>(), 3);
    QFile preset(QStringLiteral(RIVULET_SOURCE_DIR "/resources/presets/dmu75.toml"));
    QVERIFY(preset.open(QIODevice::ReadOnly));
    QByteArray text = preset.readAll();
    QVERIFY(text.contains("atInterpretation"));
    const QString cached =
        file("cached.toml", text.replace("atInterpretation", "cachedUntilStopre"));
    const Outcome failed = run(words("commission --simulate --preset") << cached);
    QCOMPARE(failed.exit, 1);
    QVERIFY(failed.output.contains(QStringLiteral("FAILS  answers-while-busy")));
    const Outcome refused = run(credit + words("--preset") << cached);
    QCOMPARE(refused.exit, 2);
    QVERIFY(refused.parsed()["error"]["message"].get<std::string>().find("method window") !=
            std::string::npos);
    const Outcome program = run(words("commission --print --base-cell 40"));
    QCOMPARE(program.exit, 0);
    QVERIFY(program.output.contains(QStringLiteral("\nR41=R40\n")));
  }

  /// The feed cell is tested without motion, or with a move that was asked for; a stop of a run
  /// says what it is worth.
  void theFeedCellIsTested() {
    const Outcome still = run(words("commission --feed-cell --simulate --json"));
    QCOMPARE(still.exit, 0);
    QVERIFY(still.parsed()["passed"].get<bool>());
    QVERIFY(!still.parsed().contains("air_move"));
    const Outcome moved =
        run(words("commission --feed-cell --air-move Z-20 --feed 400 --base-cell 50 --simulate"));
    QCOMPARE(moved.exit, 0);
    QVERIFY(moved.output.contains(QStringLiteral("holds  stays-held")));
    const Outcome program =
        run(words("commission --feed-cell --air-move Z-20 --print --base-cell 50"));
    QCOMPARE(program.exit, 0);
    QVERIFY(program.output.contains(QStringLiteral("\nG1 Z=IC(-20*RIV_SIGN) F400\n")));
    QVERIFY(!run(words("commission --feed-cell --print")).output.contains(QStringLiteral("G1")));
    QCOMPARE(run(words("commission --feed-cell --air-move W20 --simulate")).exit, 2);
    QCOMPARE(run(words("commission --feed-cell --air-move X1 --simulate")).exit, 2);
    QVERIFY(run(words("commission --air-move X20 --simulate")).exit != 0);
    const Outcome stream = run(streamMotion() + words("--feed 400 --simulate --json"));
    QCOMPARE(stream.parsed()["stop"]["acts"].get<std::string>(), std::string("at once"));
    QVERIFY(stream.parsed()["stop"]["within_s"].get<double>() < 1.0);
  }

  /// Without another word the method is window: always feasible, never wrong, one pause a window.
  void windowIsTheDefault() {
    const Outcome judged = run(words("feasibility --feed 20000 --json --program") << kScorpion);
    QCOMPARE(judged.exit, 0);
    QVERIFY(judged.parsed()["feasible"].get<bool>());
    // The reach says that it waits, at a feed that the axes never have: they brake too soon.
    QVERIFY(!judged.parsed()["waits"].get<bool>());
    QVERIFY(judged.parsed()["conditions"][0]["margin"].get<double>() < 1.0);
    QCOMPARE(judged.parsed()["limiting"]["equation"].get<std::string>(), std::string("machine"));
    QCOMPARE(judged.parsed()["planned_pauses"].get<int>(), 46);
    QCOMPARE(judged.parsed()["planned_pauses_in_cut"].get<int>(), 12);
    // Each with its place, and what all of them cost.
    const json pauses = judged.parsed()["pauses"];
    QCOMPARE(pauses.size(), std::size_t{46});
    QCOMPARE(std::count_if(pauses.begin(), pauses.end(),
                           [](const json& pause) { return pause["in_cut"].get<bool>(); }),
             std::ptrdiff_t{12});
    QVERIFY(pauses[0]["behind_point"].get<int>() >= 1 && pauses[0]["behind_point"].get<int>() <= 7);
    QVERIFY(pauses[0]["line"].get<int>() > pauses[0]["behind_point"].get<int>());
    QVERIFY(judged.parsed()["time_without_pauses_s"].get<double>() > 1.0);
    const double costS = judged.parsed()["pauses_cost_s"].get<double>();
    QVERIFY(costS > 12 * 0.04 && costS < 46 * 0.2);
    // More pauses, but where they cost less.
    QVERIFY(costS < judged.parsed()["even_pauses_cost_s"].get<double>());
    QCOMPARE(judged.parsed()["even_pauses"].get<int>(), 38);
    QCOMPARE(judged.parsed()["even_pauses_in_cut"].get<int>(), 28);
    const json made = run(words("template --windows 3 --base-cell 5 --points 5 --json")).parsed();
    QCOMPARE(made["name"].get<std::string>(), std::string("RIVULET_WINDOW_5X3B5.MPF"));
    QCOMPARE(made["cells"]["run"].get<int>(), 5);
    QCOMPARE(made["cells"]["windows"].get<int>(), 3);
    const Outcome outcome = run(streamMotion() << words("--feed 20000 --simulate --json"));
    QCOMPARE(outcome.exit, 0);
    const json report = outcome.parsed();
    QCOMPARE(report["method"].get<std::string>(), std::string("window"));
    QCOMPARE(report["executed"].get<int>(), 270);
    QVERIFY(report["faultless"].get<bool>());
    QVERIFY(report["pauses"].size() >= std::size_t{38});
    QVERIFY(report["checkpoint"]["run_number"].get<int>() > 0);
  }

  /// Without --feed each move has the feed of its own block; the one that limits is named.
  void feedsOfTheProgramAreTheDefault() {
    const auto stream = [](const char* options) {
      return run(streamMotion() << words("--simulate --json") << words(options));
    };
    const Outcome plain = stream("");
    QCOMPARE(plain.exit, 0);
    const json report = plain.parsed();
    QVERIFY(report["faultless"].get<bool>());
    QCOMPARE(report["executed"].get<int>(), 270);
    QCOMPARE(report["settings"]["feed"].get<std::string>(), std::string("program"));
    QCOMPARE(report["settings"]["program_feeds"]["override_percent"].get<double>(), 100.0);
    QCOMPARE(report["settings"]["feed_mm_per_min"].get<double>(), 40000.0);  // of the rapids
    const json limit = report["override_limit"];
    QVERIFY(limit["line"].get<int>() > 0);
    QVERIFY(limit["override_percent_max"].get<double>() > 0.0);
    // Half the override takes longer, whatever the windows are.
    const json half = stream("--override 50").parsed();
    QVERIFY(half["faultless"].get<bool>());
    QVERIFY(half["duration_s"].get<double>() > 1.2 * report["duration_s"].get<double>());
    QCOMPARE(half["settings"]["feed_mm_per_min"].get<double>(), 20000.0);

    const json judged =
        run(words("feasibility --json --override 50 --program") << kScorpion).parsed();
    QCOMPARE(judged["feed"].get<std::string>(), std::string("program"));
    QVERIFY(std::abs(judged["override_limit"]["override_percent_max"].get<double>() -
                     half["override_limit"]["override_percent_max"].get<double>()) < 1e-6);
    QVERIFY(judged["time_without_pauses_s"].get<double>() > 1.0);
    const Outcome text = run(words("feasibility --program") << kScorpion);
    QVERIFY2(text.output.contains(QStringLiteral("largest override")) &&
                 text.output.contains(QStringLiteral("limited by line")),
             qPrintable(text.output));

    // The methods of the paper have one feed; a program without feeds needs one.
    QCOMPARE(stream("--method signal").exit, 2);
    const QString without = file("without.nc", "G0 X0 Y0 Z0\nG1 X10\nX20\nM30\n");
    const Outcome refused =
        run(QStringList{QStringLiteral("stream"), without} << words("--simulate --json"));
    QCOMPARE(refused.exit, 2);
    QVERIFY(refused.parsed()["error"]["message"].get<std::string>().find("line 2") !=
            std::string::npos);
    QCOMPARE(run(words("check --json") << without).parsed()["line_without_feed"].get<int>(), 2);
    for (const char* wrong : {"--override 0", "--override 201", "--feed fast", "--feed 0"}) {
      QCOMPARE(stream(wrong).exit, 2);
    }
  }

  void takesTheBestFormOfAccess() {
    const auto stream = [](const char* options) {
      return run(streamMotion() << words("--feed 3000 --simulate --json") << words(options));
    };
    const json best = stream("--preset dmu75-arrays").parsed();
    QCOMPARE(best["settings"]["grouping"].get<std::string>(), std::string("array-count"));
    QCOMPARE(best["access_forms"].size(), std::size_t{4});
    QVERIFY(best["access_forms"][0]["writes"].get<bool>());
    QVERIFY(best["faultless"].get<bool>());
    const json none = stream("--preset plc").parsed();
    QCOMPARE(none["settings"]["grouping"].get<std::string>(), std::string("list"));
    QVERIFY(!none["access_forms"][0]["why_not"].get<std::string>().empty());
    for (const char* form : {"single", "list"}) {
      const json ordered = stream((std::string("--access ") + form).c_str()).parsed();
      QCOMPARE(ordered["settings"]["grouping"].get<std::string>(), std::string(form));
      QVERIFY(!ordered.contains("access_forms"));
    }
    QCOMPARE(stream("--preset plc --access array").exit, 3);
    QCOMPARE(stream("--access many").exit, 2);
    const Outcome measured =
        run(words("calibrate --simulate --preset dmu75-arrays --first-cell 10 --last-cell 60 "
                  "--shots 20 --json"));
    QCOMPARE(measured.exit, 0);
    const nlohmann::json result = measured.parsed();
    QCOMPARE(result["best_form"].get<std::string>(), std::string("array-count"));
    for (const auto& fit : result["fits"]) {
      const double node = fit["node_ms"].get<double>();
      const bool isArray = fit["form"].get<std::string>().substr(0, 5) == "array";
      QVERIFY2(isArray ? std::abs(node) < 0.2 : node > 4.0, std::to_string(node).c_str());
    }
  }

  /// The axes the program turns are chosen by themselves; without them the run is refused.
  void rotaryAxesAreStreamed() {
    const QString program = file("five.mpf",
                                 "G90 G94\nG1 X2 Z52 A2 C5 F3000\nX4 A3.5 C12\nA5\nX6 Y1 C20.25\n"
                                 "X8 Y2 A4 C28\nC-3\nX9 Y2 A0 C0\nM30\n");
    const auto stream = [&](const QStringList& more) {
      return run(QStringList{QStringLiteral("stream"), program, QStringLiteral("--feed"),
                             QStringLiteral("3000"), QStringLiteral("--points"),
                             QStringLiteral("3"), QStringLiteral("--json")} +
                 more);
    };
    const QString simulate = QStringLiteral("--simulate");
    const QString preset = QStringLiteral("--preset");
    const Outcome simulated = stream({simulate, preset, QStringLiteral("dmu75-5axis")});
    QVERIFY2(simulated.exit == 0, qPrintable(simulated.output + simulated.errors));
    const json result = simulated.parsed();
    QCOMPARE(result["settings"]["axes"].get<std::string>(), std::string("XYZAC"));
    QCOMPARE(result["executed"].get<int>(), 7);
    QCOMPARE(result["checkpoint"]["start_deg"].size(), std::size_t{3});
    const Outcome refused = stream({simulate});
    QVERIFY(refused.exit != 0);
    QVERIFY(refused.output.contains(QStringLiteral("has no axis A and C")));
    const Outcome beside = stream({simulate, preset, QStringLiteral("dmu75-5axis"),
                                   QStringLiteral("--axes"), QStringLiteral("XYZA")});
    QVERIFY(beside.output.contains(QStringLiteral("Select XYZAC")));
    QCOMPARE(stream({simulate, QStringLiteral("--axes"), QStringLiteral("XQ")}).exit, 2);
    const Outcome text = run(words("template --axes XYZAC --points 5 --verify"));
    QVERIFY2(text.exit == 0, qPrintable(text.output + text.errors));
    QVERIFY(text.output.contains(QStringLiteral("C=RIV_C[4]")));
    QCOMPARE(run(words("template --method signal --axes XYZA")).exit, 2);
  }

  /// The same over OPC UA, as an operator starts it.
  void rotaryAxesOverOpcUa() {
#ifdef RIVULET_MACHINE
    const QString machine = QStringLiteral(RIVULET_MACHINE);
    const tests::MachineProcess five(machine, words("--preset dmu75-5axis"));
    const QString program = file("five-ua.mpf",
                                 "G90 G94\nG1 X2 Z52 A2 C5 F3000\nX4 A3.5 C12\nA5\nX6 Y1 C20.25\n"
                                 "X8 Y2 A4 C28\nC-3\nX9 Y2 A0 C0\nM30\n");
    const auto stream = [&](const QString& endpoint) {
      return run({QStringLiteral("stream"), program, QStringLiteral("--feed"),
                  QStringLiteral("3000"), QStringLiteral("--points"), QStringLiteral("3"),
                  QStringLiteral("--json"), QStringLiteral("--endpoint"), endpoint});
    };
    const Outcome outcome = stream(five.endpoint());
    QVERIFY2(outcome.exit == 0, qPrintable(outcome.output + outcome.errors));
    const json result = outcome.parsed();
    QCOMPARE(result["outcome"].get<std::string>(), std::string("completed"));
    QCOMPARE(result["settings"]["axes"].get<std::string>(), std::string("XYZAC"));
    QCOMPARE(result["executed"].get<int>(), 7);
    QCOMPARE(result["judged"].get<bool>(), true);
    const tests::MachineProcess three(machine);
    const Outcome refused = stream(three.endpoint());
    QVERIFY(refused.exit != 0);
    QVERIFY(refused.output.contains(QStringLiteral("has no axis A and C")));
#else
    QSKIP("built without OPC UA");
#endif
  }

  void resumesOnlyFromAReport() {
    const QString path = file("none.json", "{\"checkpoint\": {\"run_number\": 3}}");
    const Outcome refused =
        run(streamMotion() << words("--feed 3000 --simulate --json --resume") << path);
    QCOMPARE(refused.exit, 2);
    QVERIFY(refused.parsed()["error"]["message"].get<std::string>().find("not the report") !=
            std::string::npos);
    // A machine that has never run it cannot say where it was left.
    const Outcome report =
        run(streamMotion() << words("--feed 3000 --simulate --json --stop-after 20"));
    const Outcome other =
        run(streamMotion() << words("--feed 3000 --simulate --json --resume")
                           << file("report.json", report.output.toUtf8().constData()));
    QCOMPARE(other.exit, 2);
    QVERIFY(other.parsed()["error"]["message"].get<std::string>().find("does not know") !=
            std::string::npos);
  }

  void wrongMotionIsExitOne() {
    const Outcome outcome =
        run(streamMotion() << words("--method position --points 7 --delta 0.02 --feed 3000 "
                                    "--simulate --json"));
    QCOMPARE(outcome.exit, 1);
    QVERIFY(outcome.parsed()["repeated"].get<int>() > 0);
    QCOMPARE(outcome.parsed()["feasible"].get<bool>(), false);
  }

  void experimentsWriteTheirFigures() {
    const QString path = m_folder.filePath(QStringLiteral("figures.json"));
    const QString plot = m_folder.filePath(QStringLiteral("figure.svg"));
    const Outcome outcome = run(words("experiment figure2 subscription --seeds 30 --json")
                                << path << QStringLiteral("--plot") << plot);
    QCOMPARE(outcome.exit, 0);
    QFile figures(path);
    QVERIFY(figures.open(QIODevice::ReadOnly));
    const auto parsed = nlohmann::json::parse(figures.readAll().toStdString());
    QCOMPARE(parsed.size(), std::size_t{2});
    QVERIFY(parsed[0]["passed"].get<bool>());
    QVERIFY(QFileInfo(plot).size() > 1000);
    // Another machine is not the paper's.
    QCOMPARE(run(words("experiment table1 --seeds 20 --preset plc")).exit, 1);
  }

  /// Every streamed axis is written: a window of five at N 7 has 40 cells, one of three 26.
  void judgesTheAxesThatAreStreamed() {
    const QStringList point = words("feasibility --points 7 --d-min 0.4 --feed 60 --json");
    const auto fastest = [](const Outcome& outcome) {
      return outcome.parsed()["feed_mm_per_min_max"].get<double>();
    };
    const double three = fastest(run(point));
    const Outcome five = run(QStringList(point) << words("--axes XYZAC"));
    QVERIFY(std::abs(fastest(five) * 40.0 - three * 26.0) < 1e-6 * three * 26.0);
    QCOMPARE(five.parsed()["axes"].get<std::string>(), std::string("XYZAC"));
    const QString turning = file("turning.mpf", "G1 X1 A1 F100\nX2 A2\nX3 A3\nX4 A4\nM30\n");
    const Outcome program =
        run(words("feasibility --points 7 --feed 60 --json --program") << turning);
    QCOMPARE(program.parsed()["axes"].get<std::string>(), std::string("XYZA"));
  }

  void measuredAccessTimesAreUsed() {
    const QString path = m_folder.filePath(QStringLiteral("access.json"));
    QCOMPARE(
        run(words("calibrate --simulate --preset plc --first-cell 0 --last-cell 19 -o") << path)
            .exit,
        0);
    const QStringList point = words(
        "feasibility --method signal --points 7 --d-min 0.3 --feed "
        "2000 --json");
    QCOMPARE(run(point).parsed()["feasible"].get<bool>(), false);
    QCOMPARE(run(point).parsed()["access_time"]["source"].get<std::string>(),
             std::string("assumed"));
    const auto judged = run(QStringList(point) << QStringLiteral("--calibration") << path).parsed();
    QCOMPARE(judged["feasible"].get<bool>(), true);
    QCOMPARE(judged["access_time"]["source"].get<std::string>(), std::string("calibrated"));
    QVERIFY(judged["access_time"]["time_per_cell_ms"].get<double>() < 4.3);
    QVERIFY(judged["access_time"]["write_p99_ms"].get<double>() > 0.0);
    QCOMPARE(run(QStringList(point) << QStringLiteral("--calibration") << kScorpion).exit, 2);
  }

  /// A live source is read during the run; what it holds at the start counts at once.
  void correctsFromALiveSource() {
    const json made = run(words("template --correction-limit 0.05 --json")).parsed();
    QCOMPARE(made["name"].get<std::string>(), std::string("RIVULET_WINDOW_7X2K50.MPF"));
    QCOMPARE(made["cells"]["correction"].get<std::vector<int>>(), (std::vector<int>{60, 61, 62}));
    const QString source =
        file("live.txt", "X 0.01\nwhat\n{\"y\": -0.02, \"x\": 0.9}\nneither\nZ 0.");
    const QString recording = m_folder.filePath(QStringLiteral("corrected.rivulet"));
    QStringList arguments = streamMotion();
    arguments << words("--feed 1000 --simulate --json --correction-limit 0.05 --correct") << source
              << QStringLiteral("--record") << recording;
    const Outcome outcome = run(arguments);
    QVERIFY2(outcome.exit == 0, qPrintable(outcome.errors));
    QVERIFY(outcome.parsed()["faultless"].get<bool>());
    QCOMPARE(outcome.parsed()["settings"]["correction_limit_mm"].get<double>(), 0.05);
    QCOMPARE(outcome.errors.count(QStringLiteral("is not a correction")), 1);
    QVERIFY(outcome.errors.contains(QStringLiteral("live.txt: line 2 is not a correction")));
    QFile written(recording);
    QVERIFY(written.open(QIODevice::ReadOnly));
    QVERIFY(trace::readFrames(written.readAll().toStdString())
                ->text.find("online correction in mm: X 0.0500 Y -0.0200 Z 0.0000") !=
            std::string::npos);

    QProcess process;  // standard input
    arguments.replaceInStrings(source, QStringLiteral("-"));
    process.start(QStringLiteral(RIVULET_CLI), arguments);
    process.write("Z -0.03\n");
    QVERIFY(process.waitForBytesWritten());
    QVERIFY(process.waitForFinished(tests::kRunMs));  // it does not wait for the end of the input
    QCOMPARE(process.exitCode(), 0);
    QFile again(recording);
    QVERIFY(again.open(QIODevice::ReadOnly));
    QVERIFY(trace::readFrames(again.readAll().toStdString())
                ->text.find("online correction in mm: X 0.0000 Y 0.0000 Z -0.0300") !=
            std::string::npos);
  }

  void badInput_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("exit");
    const QString empty = file("empty.nc", "");
    const QString still = file("still.nc", "(nothing)\nM30\n");
    const QStringList point = words("--points 7 --delta 0.3 --feed 500 --simulate");
    const auto stream = [](const QString& program) {
      return QStringList{QStringLiteral("stream"), program};
    };
    QTest::newRow("no command") << QStringList() << 2;
    QTest::newRow("no such experiment") << words("experiment figure9") << 2;
    QTest::newRow("no recordings") << words("experiment lookahead") << 2;
    QTest::newRow("nothing to learn from") << words("experiment p2") << 2;
    QTest::newRow("no cells") << words("calibrate --simulate") << 2;
    QTest::newRow("cells that are not there")
        << words("calibrate --simulate --first-cell 90 --last-cell 120") << 2;
    QTest::newRow("missing file") << stream(QStringLiteral("/nowhere.nc")) + point << 2;
    QTest::newRow("folder") << stream(m_folder.path()) + point << 2;
    QTest::newRow("empty") << stream(empty) + point << 2;
    QTest::newRow("no motion") << stream(still) + point << 2;
    QTest::newRow("N does not fit")
        << stream(kScorpion) + words("--points 60 --delta 0.3 --feed 500 --simulate") << 2;
    QTest::newRow("one point per loop")
        << stream(kScorpion) + words("--motion-only --points 1 --feed 500 --simulate") << 2;
    QTest::newRow("feed negative")
        << stream(kScorpion) + words("--points 7 --delta 0.3 --feed -5 --simulate") << 2;
    QTest::newRow("delta zero") << stream(kScorpion) +
                                       words("--points 7 --delta 0 --feed 500 --simulate")
                                << 2;
    QTest::newRow("unknown preset") << stream(kScorpion) + point + words("--preset dmu76") << 2;
    QTest::newRow("preset is a folder")
        << stream(kScorpion) + point + QStringList{QStringLiteral("--preset"), m_folder.path()}
        << 2;
    QTest::newRow("preset without an end")
        << stream(kScorpion) + point + words("--preset /dev/zero") << 2;
    const QString huge = file("huge.toml", "");
    QFile(huge).resize(qint64{20} << 30);  // a hole
    QTest::newRow("preset of 20 GB")
        << stream(kScorpion) + point + QStringList{QStringLiteral("--preset"), huge} << 2;
    const QString deep = file("deep.toml", QByteArray("a.").repeated(100'000) + "b = 1\n");
    QTest::newRow("preset with an endless key")
        << stream(kScorpion) + point + QStringList{QStringLiteral("--preset"), deep} << 2;
    const QString report = file("wrong.json",
                                "{\"checkpoint\": {\"run_number\": 1, \"granted\": 3}, "
                                "\"settings\": {\"method\": []}}");
    QTest::newRow("report with wrong types")
        << stream(kScorpion) + point + QStringList{QStringLiteral("--resume"), report} << 2;
    QTest::newRow("unknown method") << stream(kScorpion) + point + words("--method fast") << 2;
    QTest::newRow("neither endpoint nor simulation")
        << stream(kScorpion) + words("--feed 500") << 2;
    QTest::newRow("not reachable")
        << stream(kScorpion) + words("--feed 500 --endpoint opc.tcp://127.0.0.1:1") << 3;
    QTest::newRow("no recording") << QStringList{QStringLiteral("analyse"), kScorpion} << 2;
    QTest::newRow("template does not fit") << words("template --method signal --points 60") << 2;
    QTest::newRow("correction without a limit")
        << stream(kScorpion) + point + words("--correct -") << 2;
    QTest::newRow("limit of the correction too large")
        << stream(kScorpion) + point + words("--correction-limit 1.5") << 2;
    QTest::newRow("correction with another method")
        << stream(kScorpion) + point + words("--method signal --correction-limit 0.1") << 2;
    QTest::newRow("no source of corrections")
        << stream(kScorpion) + point + words("--correction-limit 0.1 --correct /nowhere") << 2;
    QTest::newRow("recording not writable")
        << stream(kScorpion) + point + words("--record /nowhere/run.rivulet") << 2;
  }
  void badInput() {
    QFETCH(QStringList, arguments);
    QFETCH(int, exit);
    const Outcome outcome = run(arguments);
    QCOMPARE(outcome.exit, exit);
    QVERIFY2(outcome.errors.trimmed().size() > 20, "a sentence is expected");
    QVERIFY(outcome.output.isEmpty());
  }
};

RIVULET_TEST(TestCli)
#include "tst_cli.moc"
