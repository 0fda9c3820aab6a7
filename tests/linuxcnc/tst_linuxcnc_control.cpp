// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The bridge with a helper that only says what a test lets it say: no LinuxCNC is needed.

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QFile>
#include <QTemporaryDir>
#include <QtTest>
#include <cmath>

#include "linuxcnc/linuxcnc_control.h"
#include "linuxcnc/sampler.h"
#include "support/test_program.h"
#include "trace/control_trace.h"

using namespace rivulet;
using linuxcnc::LinuxCncControl;
using linuxcnc::LinuxCncOptions;

namespace {

/// A shell script in the place of the helper: says `ready`, writes what it is told to "heard", and
/// repeats to us the lines after "echo".
class Helper {
 public:
  explicit Helper(const QByteArray& first = "ready 1.0 0.001 7 2.9.0 mill") {
    QFile script(m_folder.filePath(QStringLiteral("helper")));
    if (!script.open(QIODevice::WriteOnly)) {
      qFatal("no temporary file");
    }
    script.write("#!/bin/sh\necho '" + first + "'\nwhile read -r line; do\n  echo \"$line\" >>'" +
                 heardFile().toUtf8() +
                 "'\n  case $line in\n"
                 "    \"open \"*) set -- $line; echo \"done $2\" ;;\n"
                 "    \"run \"*) set -- $line; echo \"failed $2 not homed\" ;;\n"
                 "  esac\n"
                 "  if mv '" +
                 sayFile().toUtf8() + "' '" + sayFile().toUtf8() +
                 ".taken' 2>/dev/null; then cat '" + sayFile().toUtf8() + ".taken'; fi\ndone\n");
    script.close();
    script.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    m_options.helper = script.fileName().toStdString();
    m_options.cells = 30;
    m_options.programs = m_folder.path().toStdString();
  }

  LinuxCncOptions& options() { return m_options; }

  /// Lets the helper say the lines, and waits until `control` has understood them.
  bool say(LinuxCncControl& control, const QByteArray& lines, const std::function<bool()>& done) {
    // The helper must not see half of it.
    QFile file(sayFile() + QStringLiteral(".new"));
    if (!file.open(QIODevice::WriteOnly)) {
      return false;
    }
    file.write(lines);
    file.close();
    if (!file.rename(sayFile())) {
      return false;
    }
    control.writeRParameter(29, ++m_count);  // any line wakes the helper
    return QTest::qWaitFor([&] {
      control.advance(control.now() + std::chrono::milliseconds{1});
      return done();
    });
  }
  QByteArray heard() const {
    QFile file(heardFile());
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }

 private:
  QString heardFile() const { return m_folder.filePath(QStringLiteral("heard")); }
  QString sayFile() const { return m_folder.filePath(QStringLiteral("say")); }

  QTemporaryDir m_folder;
  LinuxCncOptions m_options;
  double m_count = 0.0;
};

/// In the place of halsampler: hands over the samples that a test lets it have.
class Sampler {
 public:
  explicit Sampler(LinuxCncOptions& options) {
    const QByteArray pipe = m_folder.filePath(QStringLiteral("pipe")).toUtf8();
    QFile script(m_folder.filePath(QStringLiteral("halsampler")));
    if (mkfifo(pipe.constData(), 0600) != 0 || !script.open(QIODevice::WriteOnly)) {
      qFatal("no temporary file");
    }
    script.write("#!/bin/sh\nexec cat '" + pipe + "'\n");
    script.close();
    script.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    options.hasSampler = true;
    options.sampler = script.fileName().toStdString();
    m_pipe = open(pipe.constData(), O_RDWR | O_CLOEXEC);
  }
  ~Sampler() { end(); }
  Sampler(const Sampler&) = delete;
  Sampler& operator=(const Sampler&) = delete;

  void give(int first, int last) {
    QByteArray lines;
    for (int number = first; number <= last; ++number) {
      lines += QByteArray::number(number) + " 1.0 2.0 3.0 1.0 2.0 3.0 50.0 12 \n";
    }
    QCOMPARE(write(m_pipe, lines.constData(), static_cast<std::size_t>(lines.size())),
             static_cast<ssize_t>(lines.size()));
  }
  void overrun() { QCOMPARE(write(m_pipe, "overrun\n", 8), ssize_t{8}); }
  void end() {
    if (m_pipe >= 0) {
      close(std::exchange(m_pipe, -1));
    }
  }

 private:
  QTemporaryDir m_folder;
  int m_pipe = -1;
};

/// Numbers of the first and the last sample of the trace, in cycles of a millisecond; and whether
/// it says that samples are missing.
QString traceOf(LinuxCncControl& control) {
  const auto trace = trace::parseControlTrace(control.traceText());
  if (!trace || trace->samples.empty()) {
    return QStringLiteral("no trace");
  }
  const auto number = [](const trace::ControlSample& sample) {
    return qRound(base::toSeconds(sample.at) * 1000.0);
  };
  return QStringLiteral("%1 to %2%3")
      .arg(number(trace->samples.front()))
      .arg(number(trace->samples.back()))
      .arg(trace->truncated ? QStringLiteral(", incomplete") : QString());
}

/// "state": on, interpreter, line, queue, speed, tool, spindle, flood, mist; then 4 positions.
QByteArray state(int interpreter, int line, double xIs, double xOffset) {
  return QStringLiteral(
             "state 4 %1 %2 3 12.5 2 0.0 1 0 %3 0 0 0 0 0 %3 0 0 0 0 0 %4 0 0 0 0 0 1 0 0 "
             "0 0 0 | /tmp/PART.MPF\n")
      .arg(interpreter)
      .arg(line)
      .arg(xIs)
      .arg(xOffset)
      .toUtf8();
}

/// A program that has run up to line 7, and of which three samples have arrived.
class RecordedProgram {
 public:
  bool start() {
    auto made = LinuxCncControl::connect(m_helper.options());
    if (!made) {
      return false;
    }
    m_control = std::move(*made);
    if (!reach(7, state(1, 0, 0.0, 0.0) + state(2, 7, 0.0, 0.0))) {
      return false;
    }
    m_sampler.give(101, 103);
    return QTest::qWaitFor([&] { return nextTrace() == u"101 to 103"; });
  }
  bool reach(unsigned line, const QByteArray& said) {
    return m_helper.say(*m_control, said, [&] { return m_control->state().line == line; });
  }
  /// @param behind  what LinuxCNC says of the samples that have not been taken
  bool end(const QByteArray& behind) {
    return m_helper.say(*m_control, behind + state(1, 0, 0.0, 0.0), [&] {
      return m_control->state().channel == machine::ChannelStatus::Reset;
    });
  }
  Sampler& sampler() { return m_sampler; }
  QString trace() { return traceOf(*m_control); }
  /// With what has arrived since.
  QString nextTrace() {
    m_control->advance(m_control->now());
    return trace();
  }

 private:
  Helper m_helper;
  Sampler m_sampler{m_helper.options()};
  std::unique_ptr<LinuxCncControl> m_control;
};

}  // namespace

class TestLinuxCncControl : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void tellsWhyThereIsNoLinuxCnc() {
    Helper helper("fatal LinuxCNC is not installed for this Python.");
    const auto control = LinuxCncControl::connect(helper.options());
    QVERIFY(!control);
    QVERIFY(control.error().code == linuxcnc::LinuxCncError::NotRunning);
    QCOMPARE(QString::fromStdString(control.error().message),
             QStringLiteral("LinuxCNC is not installed for this Python."));
  }

  void facts() {
    Helper helper;
    helper.options().mayStart = true;
    const auto control = LinuxCncControl::connect(helper.options());
    QVERIFY(control);
    QCOMPARE(QString::fromStdString((*control)->facts().name),
             QStringLiteral("mill (LinuxCNC 2.9.0)"));
    QVERIFY(!(*control)->facts().isVirtual);
    QVERIFY((*control)->facts().abilities.startsOnRequest);
    QVERIFY(!(*control)->facts().abilities.keepsTrace);
    QVERIFY((*control)->shows("State", "actFeedRateIpo"));
    QVERIFY(!(*control)->shows("State", "actDNumber"));
    QVERIFY((*control)->shows("", "acAuxfuMValue"));
    QVERIFY(!(*control)->shows("", "ncFktAct"));
  }

  /// The program counts its start: the cells of the run before are cleared, then it is answered.
  void startClearsTheHeader() {
    Helper helper;
    const auto made = LinuxCncControl::connect(helper.options());
    QVERIFY(made);
    LinuxCncControl& control = **made;
    // Base 10; latched 5 and executed 4 of an earlier run.
    QVERIFY(helper.say(control, "out 1.0 5.0 4.0 77.0 1.0 9.0 10.0 0.0 0.0 0.0 -0.5\n",
                       [&] { return control.rParameter(12) == 5.0; }));
    QCOMPARE(control.rParameter(13), 4.0);
    QCOMPARE(control.rParameter(14), 77.0);
    QCOMPARE(control.rParameter(17), 9.0);
    control.writeRParameter(10, 1.0);
    control.writeRParameter(11, 6.0);
    control.writeRParameter(18, 3.0);
    QVERIFY(helper.say(control, "out 2.0 5.0 4.0 0.0 1.0 9.0 10.0 0.5 0.0 0.0 -0.5\n",
                       [&] { return control.rParameter(12) == 0.0; }));
    for (const int cell : {10, 11, 12, 13, 15, 16, 17}) {
      QCOMPARE(control.rParameter(cell), 0.0);
    }
    QCOMPARE(control.rParameter(18), 3.0);  // the client's heartbeat
    QTRY_VERIFY(helper.heard().contains("started 2 0.5\n"));
    // Only a change is copied: what the client has written since stays.
    control.writeRParameter(11, 1.0);
    QVERIFY(helper.say(control, "out 2.0 1.0 0.0 78.0 0.0 4.0 10.0 0.5 0.0 0.0 -0.5\n",
                       [&] { return control.rParameter(12) == 1.0; }));
    QCOMPARE(control.rParameter(11), 1.0);
    QCOMPARE(control.rParameter(14), 78.0);
    QTRY_VERIFY(helper.heard().contains("set 17 4\n"));
  }

  /// The loop of a whole job: each stretch clears the cells of the client, and leaves the feed cell
  /// and the call cell as they are. Between two stretches the block cell is the program's.
  void stretchesOfAJob() {
    Helper helper;
    const auto made = LinuxCncControl::connect(helper.options());
    QVERIFY(made);
    LinuxCncControl& control = **made;
    const auto says = [&](const QByteArray& outputs, int cell, double value) {
      return helper.say(control, "out " + outputs + "\n",
                        [&] { return control.rParameter(cell) == value; });
    };
    control.writeRParameter(19, 70'000.0);  // as a job before has left it
    QVERIFY(says("1.0 0.0 0.0 77.0 0.0 0.0 10.0 1.0 0.0 70000.0 -3.0", 14, 77.0));
    QCOMPARE(control.rParameter(16), -3.0);
    // All of the start arrives at once.
    QVERIFY(says("2.0 0.0 0.0 0.0 0.0 0.0 10.0 1.0 0.0 0.0 -0.5", 19, 0.0));
    QCOMPARE(control.rParameter(16), 0.0);
    QTRY_VERIFY(helper.heard().endsWith("started 2 1\n"));
    QVERIFY(says("2.0 0.0 0.0 77.0 0.0 0.0 10.0 1.0 0.0 70000.0 -0.5", 19, 70'000.0));
    control.writeRParameter(16, 555.0);  // number of the client's run
    QVERIFY(says("2.0 0.0 0.0 77.0 1.0 555.0 10.0 1.0 0.0 -70000.0 -0.5", 19, -70'000.0));
    QCOMPARE(control.rParameter(16), 555.0);
    QVERIFY(says("2.0 0.0 0.0 77.0 1.0 555.0 10.0 1.0 0.0 -70000.0 0.0", 16, 0.0));
    QVERIFY(says("2.0 0.0 0.0 77.0 1.0 555.0 10.0 1.0 0.0 -70000.0 7.0", 16, 7.0));
    control.writeRParameter(20, 50.0);
    control.writeRParameter(10, 3.0);
    control.writeRParameter(11, 9.0);
    QVERIFY(says("3.0 0.0 0.0 77.0 1.0 555.0 10.0 1.0 1.0 -70000.0 -0.5", 11, 0.0));
    for (const int cell : {10, 11, 12, 13, 15, 16, 17}) {
      QCOMPARE(control.rParameter(cell), 0.0);
    }
    QCOMPARE(control.rParameter(14), 77.0);
    QCOMPARE(control.rParameter(19), -70'000.0);
    QCOMPARE(control.rParameter(20), 50.0);
    QTRY_VERIFY(helper.heard().endsWith("called 3\n"));
    QVERIFY(!helper.heard().contains("started 3"));
  }

  /// What is not an override holds; a sign of life is a change of the heartbeat.
  void feedCell() {
    Helper helper;
    const auto made = LinuxCncControl::connect(helper.options());
    QVERIFY(made);
    LinuxCncControl& control = **made;
    const QByteArray idle = "out 1.0 0.0 0.0 77.0 0.0 0.0 10.0 1.0 0.0 0.0 -0.5\n";
    QVERIFY(helper.say(control, idle, [&] { return control.rParameter(14) == 77.0; }));
    control.writeRParameter(20, 30.0);  // what an earlier program has left
    QVERIFY(helper.say(control, "acts 40.0\n", [&] { return control.rParameter(21) == 40.0; }));
    QVERIFY(helper.say(control, "out 2.0 0.0 0.0 0.0 0.0 0.0 10.0 1.0 0.0 0.0 -0.5\n",
                       [&] { return control.rParameter(21) == 0.0; }));
    QCOMPARE(control.rParameter(20), 100.0);
    QTRY_VERIFY(helper.heard().endsWith("started 2 1\n"));
    for (const double wanted : {50.0, 0.0, 200.0, 200.5, -1.0, std::nan(""), HUGE_VAL, 120.0}) {
      control.writeRParameter(20, wanted);
    }
    for (const double beat : {7.0, 7.0, 8.0, std::nan("")}) {
      control.writeRParameter(18, beat);
    }
    QByteArray lines;
    QTRY_VERIFY([&] {
      lines.clear();
      const QByteArray heard = helper.heard();
      for (const QByteArray& line : heard.mid(heard.indexOf("started 2 1\n")).split('\n')) {
        lines += line.startsWith("set ") || line.isEmpty() ? QByteArray() : line + ", ";
      }
      return lines.count("beat") >= 2;
    }());
    QCOMPARE(lines, QByteArray("started 2 1, override 50, override 0, override 200, override 0, "
                               "override 0, override 0, override 0, override 120, beat, beat, "));
    QVERIFY(helper.say(control, "ignored the HAL has no signal rivulet-beat\n",
                       [&] { return !control.state().message.empty(); }));
    QVERIFY(control.state().message.find("rivulet-beat. Put the lines of") != std::string::npos);
    QCOMPARE(control.state().alarm, 0);
  }

  /// Where no client is watched, the bridge itself is.
  void signsOfLifeOfTheBridge() {
    Helper helper;
    const auto made = LinuxCncControl::connect(helper.options());
    QVERIFY(made);
    LinuxCncControl& control = **made;
    QVERIFY(helper.say(
        control, "out 1.0 0.0 0.0 0.0 0.0 0.0 10.0 0.0 0.0 0.0 -0.5\n" + state(2, 7, 0.0, 0.0),
        [&] { return control.state().line == 7; }));
    QVERIFY(helper.say(control,
                       "out 2.0 0.0 0.0 77.0 0.0 0.0 10.0 0.0 0.0 0.0 -0.5\n"
                       "out 2.0 0.0 0.0 78.0 0.0 0.0 10.0 0.0 0.0 0.0 -0.5\n",
                       [&] { return control.rParameter(14) == 78.0; }));
    QTRY_VERIFY(helper.heard().contains("started 2 1\n"));
    const auto beats = [&] { return helper.heard().count("beat\n"); };
    const auto before = beats();
    control.writeRParameter(18, 7.0);  // that of a client does not count
    for (int i = 0; i < 4; ++i) {
      control.advance(control.now() + std::chrono::milliseconds{250});
    }
    QTRY_COMPARE(beats(), before + 4);
  }

  /// A program that was opened and started while the bridge had no processor: its start is seen
  /// before its file.
  void countsWindowsOfAFileSeenLate() {
    Helper helper;
    const auto made = LinuxCncControl::connect(helper.options());
    QVERIFY(made);
    LinuxCncControl& control = **made;
    QVERIFY(control.storeProgram(
        "PART.MPF", "G90\nG1 X1 ;window 0\nG1 X2 ;window 1\nG1 X3 ;window 2\nM2\n", false));
    QVERIFY(helper.say(control, "out 1.0 0.0 0.0 77.0 0.0 0.0 10.0 1.0 0.0 0.0 -0.5\n",
                       [&] { return control.rParameter(14) == 77.0; }));
    QByteArray seen = state(2, 2, 0.0, 0.0);
    seen.replace("/tmp", QByteArray::fromStdString(helper.options().programs.string()));
    QVERIFY(helper.say(control,
                       "out 2.0 0.0 0.0 0.0 0.0 0.0 10.0 1.0 0.0 0.0 -0.5\n" + seen + "line 3\n",
                       [&] { return control.state().line == 2; }));
    QCOMPARE(control.rParameter(12), 2.0);  // begun
    QCOMPARE(control.rParameter(13), 1.0);  // executed
  }

  void stateOfTheProgram() {
    Helper helper;
    const auto made = LinuxCncControl::connect(helper.options());
    QVERIFY(made);
    LinuxCncControl& control = **made;
    QVERIFY(
        helper.say(control, state(2, 7, 30.0, 10.0), [&] { return control.state().line == 7; }));
    QCOMPARE(control.state().channel, machine::ChannelStatus::Active);
    QCOMPARE(control.state().program, machine::ProgramStatus::Running);
    QCOMPARE(control.state().actualMm.x, 20.0);  // workpiece frame
    QCOMPARE(control.state().distanceToGoMm.x, 1.0);
    QCOMPARE(control.state().feedMmPerS, 12.5);
    QVERIFY(control.state().equipment.flood && !control.state().equipment.mist);
    QCOMPARE(QString::fromStdString(control.state().programName), QStringLiteral("PART.MPF"));
    QVERIFY(control.selectProgram("PART.MPF").error().code ==
            machine::MachineError::ProgramMissing);
    QVERIFY(helper.say(control, "error 11 Linear move on line 7 would exceed X's limit\n",
                       [&] { return control.state().alarm == 11; }));
    QVERIFY(helper.say(control, state(1, 0, 30.0, 10.0),
                       [&] { return control.state().channel == machine::ChannelStatus::Reset; }));
    QCOMPARE(control.state().alarm, 11);  // for a moment: it stops no other program
    control.advance(control.now() + std::chrono::seconds{3});
    QCOMPARE(control.state().alarm, 0);
    QVERIFY(!control.state().message.empty());
    QVERIFY(helper.say(control, "state 2" + state(1, 0, 30.0, 10.0).mid(7),
                       [&] { return control.state().alarm == 1; }));
  }

  void saysThatLinuxCncGetsNoProcessor() {
    Helper helper;
    const auto made = LinuxCncControl::connect(helper.options());
    QVERIFY(made);
    LinuxCncControl& control = **made;
    // What it waited before the program does not count.
    QVERIFY(helper.say(control, "waited 90.0\n" + state(2, 7, 0.0, 0.0) + "waited 90.4\n",
                       [&] { return control.state().line == 7; }));
    QVERIFY(control.state().message.empty());
    QVERIFY(helper.say(control, "waited 91.5\n", [&] { return !control.state().message.empty(); }));
    QVERIFY(control.state().message.find("waited 1.5 s") != std::string::npos);
    QCOMPARE(control.state().alarm, 0);
    // Little of a long program.
    QVERIFY(helper.say(control, state(1, 0, 0.0, 0.0) + state(2, 8, 0.0, 0.0),
                       [&] { return control.state().line == 8; }));
    control.advance(control.now() + std::chrono::seconds{30});
    QVERIFY(helper.say(control, "waited 95.5\n" + state(2, 9, 0.0, 0.0),
                       [&] { return control.state().line == 9; }));
    QVERIFY(control.state().message.empty());
    QVERIFY(helper.say(control, "waited 99.5\n", [&] { return !control.state().message.empty(); }));
    // LinuxCNC's own message is more important.
    QVERIFY(helper.say(control, "error 11 joint 0 following error\nwaited 110.0\n",
                       [&] { return control.state().alarm == 11; }));
    QCOMPARE(QString::fromStdString(control.state().message),
             QStringLiteral("joint 0 following error"));
  }

  /// A client asks for the trace as soon as it hears of the end, and halsampler may not have got a
  /// processor since then.
  void waitsForTheLastSamples() {
    RecordedProgram program;
    QVERIFY(program.start());
    // 5 in the sampler, and one that halsampler may have taken already.
    QVERIFY(program.end("behind 5 0\n"));
    program.sampler().give(104, 150);
    QCOMPARE(program.trace(), QStringLiteral("101 to 109"));
    // What comes later is not of this program.
    QCOMPARE(program.trace(), QStringLiteral("101 to 109"));
  }

  void saysThatTheLastSamplesAreMissing() {
    RecordedProgram program;
    QVERIFY(program.start());
    QVERIFY(program.end("behind 5 0\n"));
    program.sampler().give(104, 108);
    program.sampler().end();
    QCOMPARE(program.trace(), QStringLiteral("101 to 108, incomplete"));
  }

  /// A sampler that is full loses samples, and those after them have later numbers.
  void saysThatTheSamplerLostTheEnd() {
    RecordedProgram program;
    QVERIFY(program.start());
    QVERIFY(program.end("behind 5 0\n"));
    program.sampler().give(104, 106);
    program.sampler().overrun();
    program.sampler().give(200, 250);
    QCOMPARE(program.trace(), QStringLiteral("101 to 202, incomplete"));
    QVERIFY(program.reach(8, state(2, 8, 0.0, 0.0)));
    program.sampler().give(251, 253);
    QTRY_VERIFY(program.nextTrace().endsWith(u"to 253"));
    // What comes later has not been taken by the sampler.
    QVERIFY(program.end("behind 5 1\n"));
    QVERIFY(program.trace().endsWith(u"to 253, incomplete"));
  }

  /// The samples of a program that nobody asked for come after the start of the next one.
  void doesNotMixPrograms() {
    RecordedProgram program;
    QVERIFY(program.start());
    QVERIFY(program.reach(8, "behind 5 0\n" + state(1, 0, 0.0, 0.0) + state(2, 8, 0.0, 0.0)));
    program.sampler().give(104, 120);
    QTRY_COMPARE(program.nextTrace(), QStringLiteral("110 to 120"));
  }

  void programs() {
    Helper helper;
    const auto made = LinuxCncControl::connect(helper.options());
    QVERIFY(made);
    LinuxCncControl& control = **made;
    QVERIFY(control.storeProgram("a.MPF", "M2\n", false));
    QVERIFY(control.storeProgram("A.MPF", "M30\n", false).error().code ==
            machine::MachineError::FileExists);
    QVERIFY(!control.storeProgram("../A.MPF", "M2\n", true));
    QCOMPARE(QString::fromStdString(*control.programText("A.mpf")), QStringLiteral("M2\n"));
    QVERIFY(control.selectProgram("A.MPF"));
    QTRY_VERIFY(helper.heard().contains("/A.MPF\n"));
    QCOMPARE(QString::fromStdString(control.state().programName), QStringLiteral("A.MPF"));
    QVERIFY(helper.say(control, state(1, 0, 0.0, 0.0),
                       [&] { return !control.state().programName.empty(); }));
    const auto started = control.cycleStart();
    QVERIFY(!started);
    QCOMPARE(QString::fromStdString(started.error().message), QStringLiteral("not homed"));
  }

  void samples() {
    const linuxcnc::SampleScale scale{std::chrono::milliseconds{1}, 25.4, {1.0, 0.0, 0.0}};
    trace::ControlTrace trace;
    QVERIFY(linuxcnc::addSample(trace, "5 1.0 2.0 3.0 0.5 2.0 3.0 0.25 12 ", scale));
    QCOMPARE(trace.samples.size(), std::size_t{1});
    const trace::ControlSample& sample = trace.samples.front();
    QCOMPARE(base::toSeconds(sample.at), 0.005);
    QCOMPARE(sample.commandMm.x, 24.4);
    QCOMPARE(sample.actualMm.x, 11.7);
    QCOMPARE(sample.feedMmPerS, 6.35);
    QCOMPARE(sample.line.value, 12U);
    QVERIFY(!trace.truncated);
    QVERIFY(!linuxcnc::addSample(trace, "6 1.0 2.0", scale));
    QVERIFY(!linuxcnc::addSample(trace, "9e16 1 2 3 0 2 3 0.25 12", scale));  // counts in 32 bits
    QVERIFY(!linuxcnc::addSample(trace, "6 1 2 3 0 2 3 0.25 5e9", scale));
    QVERIFY(linuxcnc::addSample(trace, "overrun", scale));
    QVERIFY(trace.truncated);
  }
};

RIVULET_TEST(TestLinuxCncControl)
#include "tst_linuxcnc_control.moc"
