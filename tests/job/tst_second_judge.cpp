// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The path that a job executes, stretches and native blocks, against the second evaluator: preview,
// virtual machine and the proof of a job share one reader, so what it reads wrong they all do
// wrong. A reader that takes AC() for an increment, and one that keeps the frame of a subprogram
// with SAVE, pass the proof of the job and are found here.

#include <toml++/toml.h>

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QtTest>
#include <cmath>

#include "gcode/block_observer.h"
#include "gcode/feeds.h"
#include "machine/machine.h"
#include "nc/evaluated_path.h"
#include "streaming/control/control_axes.h"
#include "streaming/run/whole_job.h"
#include "streaming/simulation/fitted_machine.h"
#include "streaming/simulation/job_proof.h"
#include "streaming/simulation/simulated_link.h"
#include "support/test_program.h"

using namespace rivulet;
using tests::EvaluatedMove;

namespace {

const QString kCorpus = QStringLiteral(RIVULET_SOURCE_DIR "/../shared/corpus/");

/// Chords lie this far from their arc; the axes stand where they have been commanded to within the
/// same.
constexpr double kPathMm = streaming::kSameEndMm;

class QuietConsole final : public streaming::WholeJobSink, public streaming::RunOrders {
 public:
  bool stopRequested(base::Instant) override { return false; }
  void update(const streaming::LiveUpdate&) override {}
  void access(const trace::Access&) override {}
  void note(const trace::Note&) override {}
  void nativeBlocks(int) override {}
  void stretchBegins(const job::Stretch&, base::Vec3) override {}
  bool waitsForCycleStart() override { return true; }
};

streaming::RunSettings settingsOf(const job::Plan& plan, const machine::MachineConfig& machine) {
  streaming::RunSettings settings;
  settings.parameters.method = base::MethodKind::Window;
  settings.parameters.pointsPerLoop = 7;
  settings.parameters = streaming::withTurnedAxes(settings.parameters, plan.program.trajectory);
  settings.parameters.feedPerPoint = true;
  settings.isCommissioned = true;
  settings.programFeeds = gcode::ProgramFeeds{};
  settings.programFeeds->rapidMmPerS = machine.rapidMmPerS;
  settings.programFeeds->feedMmPerSMax = machine.feedMmPerSMax();
  settings.feedMmPerS = machine.feedMmPerSMax();
  return settings;
}

base::Result<job::Plan> planOf(const std::string& control, const std::string& text,
                               gcode::LoadOptions options = {}) {
  options.dialect = gcode::dialectOfName(control);
  options.defaultFeedMmPerS = streaming::kFittedFeedMmPerS;
  return job::makePlan("PART", text, options);
}

/// Where the blocks of the job end. @return nothing: the job does not run to its end
std::optional<std::vector<base::Vec3>> executed(const job::Plan& plan) {
  const streaming::FittedMachine fitted =
      streaming::fitMachine(*machine::loadPreset("dmu75-mill"), plan);
  machine::Machine machine(fitted.config, 1);
  streaming::SimulatedLink link(machine);
  QuietConsole console;
  const streaming::WholeJobReport done =
      streaming::runWholeJob(link, link, plan, settingsOf(plan, fitted.config), console, console);
  if (done.outcome != streaming::Outcome::Completed || done.controlTrace == nullptr) {
    return std::nullopt;
  }
  std::vector<base::Vec3> places;
  if (!done.stretches.empty()) {
    places.push_back(done.stretches.front().startMm);  // a first move may end where the tool stands
  }
  for (const trace::ExecutedBlock& block : done.controlTrace->blocks) {
    if (block.lengthMm > 0.0) {
      places.push_back(block.targetMm);
    }
  }
  return places;
}

struct Sent {
  std::vector<base::Vec3> places;
  double endMm = 1e-6;  ///< a move ends there within
};

/// What the control is told: the points, and where it moves by itself what it makes of its blocks.
/// @return nothing: the job does not run to its end
std::optional<Sent> sent(const job::Plan& plan) {
  for (const job::Part& part : plan.parts) {
    const auto* const native = std::get_if<job::NativeBlock>(&part);
    if (native != nullptr && native->moves && !native->isHalf) {
      auto places = executed(plan);
      return places ? std::optional(Sent{*std::move(places), kPathMm}) : std::nullopt;
    }
  }
  Sent made;
  for (const gcode::TrajectoryPoint& point : plan.program.trajectory.points) {
    made.places.push_back(point.positionMm);
  }
  return made;
}

double distanceTo(const EvaluatedMove& move, base::Vec3 start, base::Vec3 place) {
  if (move.kind != EvaluatedMove::Kind::Arc) {
    return base::distanceToSegment(place, start, tests::placeOf(move));
  }
  const base::Vec3 arm = start - move.centre;
  const base::Vec3 to = place - move.centre;
  const double height = base::dot(to, move.axis);
  const double rise = base::dot(tests::placeOf(move) - start, move.axis);
  const base::Vec3 flat = to - height * move.axis;
  double turned = std::atan2(base::dot(base::cross(arm, flat), move.axis), base::dot(arm, flat)) *
                  180.0 / std::acos(-1.0);
  turned += turned < -1e-6 ? 360.0 : 0.0;
  if (turned > move.sweepDeg + 1e-6) {
    return std::min(base::distance(place, start), base::distance(place, tests::placeOf(move)));
  }
  const double across = base::norm(flat) - base::norm(arm - base::dot(arm, move.axis) * move.axis);
  const double expected = base::dot(arm, move.axis) + rise * turned / move.sweepDeg;
  return std::hypot(across, height - expected);
}

/// The job reaches each end, in order, and leaves the path nowhere. @return the first fault, "";
/// none
std::string strays(const std::vector<EvaluatedMove>& path, const std::vector<base::Vec3>& places,
                   double endMm = kPathMm) {
  const std::vector<EvaluatedMove> moves = tests::withoutRests(path);
  std::size_t next = 0;
  bool isUnderWay = false;  // it has left the start of the move
  base::Vec3 start{std::nan(""), std::nan(""), std::nan("")};
  const auto areNear = [endMm](base::Vec3 a, base::Vec3 b) {
    bool same = true;
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      same = same && !(std::abs(a[axis] - b[axis]) > endMm);  // or one is not known
    }
    return same;
  };
  const auto isEnd = [&](base::Vec3 place) {
    // A full circle ends where it begins.
    const bool isCircle = next < moves.size() && moves[next].sweepDeg > 180.0 &&
                          areNear(tests::placeOf(moves[next]), start);
    return next < moves.size() && areNear(tests::placeOf(moves[next]), place) &&
           (isUnderWay || !isCircle);
  };
  for (const base::Vec3 place : places) {
    if (next == moves.size() && areNear(place, start)) {
      continue;
    }
    const bool isKnown =
        base::isFinite(start) && next < moves.size() && base::isFinite(tests::placeOf(moves[next]));
    if (next == moves.size() ||
        (isKnown && distanceTo(moves[next], start, place) > kPathMm + moves[next].mismatch)) {
      return "executed X" + base::formatFixed(place.x, 3) + " Y" + base::formatFixed(place.y, 3) +
             " Z" + base::formatFixed(place.z, 3) + ", which is not on the way" +
             (next == moves.size() ? " any more" : " of line " + std::to_string(moves[next].line));
    }
    isUnderWay = isUnderWay || !areNear(place, start);
    while (isEnd(place)) {
      start = place;
      isUnderWay = false;
      ++next;
    }
  }
  return next == moves.size() ? std::string()
                              : "line " + std::to_string(moves[next].line) + " is not reached";
}

struct Example {
  const char* control;
  const char* text;
};
constexpr std::array kExamples{
    Example{"sinumerik",
            "G17 G90 G71 G94 G54\nT3 M6\nD1\nS3000 M3\nG0 X0 Y0 Z50\nG1 Z-2 F2000\nX20 Y5\nM8\nG91 "
            "X=AC(30) Y10\nG90 G2 X40 Y25 CR=10\nM9\nTRANS X5\nAROT RPL=30\nG1 X50 Y0\nG3 X40 Y10 "
            "I=AC(40) J=AC(0)\nTRANS\nG70 G1 X1 Y2 Z0\nG71\nM5\nR1=0\nWHILE R1<3\nG91 G1 X=2+R1 "
            "Z1\nR1=R1+1\nENDWHILE\nG90 G0 Z60\nM30\n"},
    Example{"fanuc",
            "%\nO1234\nG17 G21 G40 G80 G90 G94 G54\nT3 M6\nS3000 M3\nG0 X0. Y0. Z50.\nG1 Z-2. "
            "F2000.\nM8\nG65 P9001 X20. Y5.\nG91 G1 X5.\nG90 G2 X35. Y15. R10.\nG52 X10.\nG1 X0. "
            "Y0.\nG52 X0.\nM9\nG0 Z60.\nM30\nO9001\nG1 X#24 Y#25\nM99\n%\n"},
    Example{"haas",
            "G17 G21 G40 G80 G90 G94 G54\nT3 M6\nS3000 M3\nG0 X0. Y0. Z50.\nG1 Z-2. F2000.\nM8\nG3 "
            "X20. Y0. I10.\nM9\n#101=3.\nG91 G1 X[#101*2.] Y#101\nG90 G0 Z60.\nM30\n"},
    Example{
        "linuxcnc",
        "G17 G21 G40 G49 G54 G90 G94\nT3 M6\nS3000 M3\nG0 X0 Y0 Z50\nG1 Z-2 F2000\nM8\n#1=0\no100 "
        "while [#1 LT 3]\nG91 G1 X5 Y2\n#1=[#1+1]\no100 endwhile\nG90 G2 X25 Y16 I5 J5\nM9\nG92 "
        "X0\nG1 X-5 "
        "Y20\nG92.1\nG20 G1 X1 Y1\nG21 G0 Z60\nM2\n"},
    Example{"grbl",
            "G17 G21 G90 G94\nS3000 M3\nG0 X0 Y0 Z50\nG1 Z-2 F2000\nM8\nX20\nG2 X30 Y-10 I0 "
            "J-10\nM9\nG91 G1 X-5 Y-5\nG90 G0 Z60\nM30\n"},
    Example{
        "heidenhain",
        "BEGIN PGM A MM\nTOOL CALL 3 Z S3000\nL X+0 Y+0 Z+50 FMAX M3\nL Z-2 F2000\nL X+20\nM8\nCC "
        "X+20 Y+10\nC X+30 Y+10 DR+\nM9\nL IX-5 IY+5\nL Z+60 FMAX\nEND PGM A MM\n"}};

}  // namespace

class TestSecondJudge : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void examples_data() {
    QTest::addColumn<int>("index");
    for (std::size_t i = 0; i < kExamples.size(); ++i) {
      QTest::newRow(kExamples[i].control) << static_cast<int>(i);
    }
  }
  void examples() {
    QFETCH(const int, index);
    const Example& example = kExamples[static_cast<std::size_t>(index)];
    const tests::Evaluation evaluation = tests::evaluate(example.control, example.text);
    QCOMPARE(evaluation.cannotFollow, std::string());
    const auto plan = planOf(example.control, example.text);
    QVERIFY2(plan.has_value(), plan ? "" : plan.error().text().c_str());
    QVERIFY(plan->isWhole());
    const auto places = executed(*plan);
    QVERIFY(places.has_value());
    const std::string fault = strays(evaluation.moves, *places);
    QVERIFY2(fault.empty(), fault.c_str());
  }

  /// What a reader makes of a program that misunderstands a word is what a right one makes of the
  /// program with another word in its place.
  void wrongReaders_data() {
    QTest::addColumn<QByteArray>("program");
    QTest::addColumn<QByteArray>("asRead");
    const QByteArray before = "G17 G90 G71 G94\nG0 X0 Y0 Z10\nG1 Z0 F2000\nM8\n";
    const QByteArray after = "M9\nG0 Z50\nM30\n";
    QTest::newRow("AC() read as an increment") << before + "X10\nG91 X=AC(5) Y3\nG90 X20\n" + after
                                               << before + "X10\nG91 X=IC(5) Y3\nG90 X20\n" + after;
    QTest::newRow("a frame that stays") << before + "TRANS X5\nX10\nTRANS\nX20 Y3\n" + after
                                        << before + "TRANS X5\nX10\nX20 Y3\n" + after;
    QTest::newRow("the other way round")
        << before + "G2 X20 Y0 I10 J0\n" + after << before + "G3 X20 Y0 I10 J0\n" + after;
    QTest::newRow("a move that is lost")
        << before + "X10 Y3\nX20 Y5\nX30 Y3\n" + after << before + "X10 Y3\nX30 Y3\n" + after;
  }
  void wrongReaders() {
    QFETCH(const QByteArray, program);
    QFETCH(const QByteArray, asRead);
    const auto plan = planOf("sinumerik", asRead.toStdString());
    QVERIFY(plan && plan->isWhole());
    // The proof compares the job with what the same reader made of the source.
    const machine::MachineConfig machine =
        streaming::fitMachine(*machine::loadPreset("dmu75-mill"), *plan).config;
    const auto proof = streaming::proveJob(*plan, machine, settingsOf(*plan, machine));
    QVERIFY(proof && proof->difference.empty());
    const auto places = executed(*plan);
    QVERIFY(places.has_value());
    const auto right = tests::evaluate("sinumerik", asRead.toStdString());
    QCOMPARE(strays(right.moves, *places), std::string());
    const auto evaluation = tests::evaluate("sinumerik", program.toStdString());
    QVERIFY(evaluation.cannotFollow.empty());
    QVERIFY(!strays(evaluation.moves, *places).empty());
  }

  /// Every case of tests/nc/meaning that gives a path.
  void meaningCases() {
    Tally tally;
    QDirIterator files(QStringLiteral(RIVULET_SOURCE_DIR "/tests/nc/meaning"),
                       {QStringLiteral("*.toml")}, QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext()) {
      const QFileInfo file(files.next());
      const std::string control = file.dir().dirName().toStdString();
      const toml::table table = toml::parse_file(file.filePath().toStdString());
      for (const toml::node& each : *table["case"].as_array()) {
        const toml::table& one = *each.as_table();
        const bool isPath = (one.contains("path") || one.contains("end")) &&
                            !one.contains("refused") && !one.contains("pending");
        if (!isPath || one.contains("accept") || one.contains("block_skip")) {
          continue;
        }
        const auto beside = [&one](std::string_view name) -> std::optional<std::string> {
          const toml::table* const texts = one["files"].as_table();
          for (auto it = texts != nullptr ? texts->begin() : toml::table::const_iterator();
               texts != nullptr && it != texts->end(); ++it) {
            if (tests::isFileOf(it->first.str(), name)) {
              return it->second.value_or(std::string());
            }
          }
          return std::nullopt;
        };
        judge(tally, control + ": " + one["name"].value_or(std::string()), control,
              one["program"].value_or(std::string()), beside);
      }
    }
    report(tally);
    QVERIFY(tally.compared >= 150);
  }

  /// Programs of others, as far as they are whole jobs that it follows.
  void programsOfOthers() {
    if (!QDir(kCorpus).exists()) {
      QSKIP("the collection of foreign NC programs is not beside this checkout");
    }
    Tally tally;
    QDirIterator files(kCorpus, QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext()) {
      const QString path = files.next();
      QFile file(path);
      if (!tests::isProgram(path.toStdString()) || !file.open(QIODevice::ReadOnly)) {
        continue;
      }
      const std::string text = file.readAll().toStdString();
      const std::string dialect(
          nc::dialectName(nc::detectDialect(text, path.toStdString()).dialect));
      judge(tally, path.mid(kCorpus.size()).toStdString(), dialect, text,
            [&path](std::string_view name) -> std::optional<std::string> {
              const auto found = gcode::subprogramsBeside(path.toStdString())(name);
              return found ? std::optional(found->text) : std::nullopt;
            });
    }
    report(tally);
    QVERIFY(tally.compared >= 30);
  }

 private:
  struct Tally {
    int compared = 0;
    int noJob = 0;   ///< the program is no whole job
    int notRun = 0;  ///< the virtual machine does not run it to its end
    std::map<std::string, int> notFollowed;
    std::string differing;
  };

  static void judge(Tally& tally, const std::string& name, const std::string& control,
                    const std::string& text,
                    const std::function<std::optional<std::string>(std::string_view)>& beside) {
    const tests::Evaluation evaluation = tests::evaluate(control, text, beside);
    if (!evaluation.cannotFollow.empty()) {
      ++tally.notFollowed[evaluation.cannotFollow];
      return;
    }
    gcode::LoadOptions options;
    options.repeatedLinesMax = 5000;
    options.subprogram = [&beside](std::string_view called) -> std::optional<nc::LoadedText> {
      auto found = beside(called);
      if (!found && called.starts_with('O')) {  // O100, O<NAME>
        const std::string_view bare = called.substr(called.starts_with("O<") ? 2 : 1);
        found = beside(bare.substr(0, bare.find('>')));
      }
      return found ? std::optional(nc::LoadedText{*std::move(found), std::string(called)})
                   : std::nullopt;
    };
    const auto plan = planOf(control, text, options);
    if (!plan || !plan->isWhole()) {
      ++tally.noJob;
      return;
    }
    const auto told = sent(*plan);
    if (!told) {
      ++tally.notRun;
      return;
    }
    ++tally.compared;
    if (const std::string fault = strays(evaluation.moves, told->places, told->endMm);
        !fault.empty()) {
      tally.differing += name + ": " + fault + "\n";
    }
  }

  static void report(const Tally& tally) {
    QString words;
    int stopped = 0;
    for (const auto& [word, times] : tally.notFollowed) {
      stopped += times;
      words += QStringLiteral(" %1: %2;").arg(QString::fromStdString(word)).arg(times);
    }
    qInfo().noquote() << tally.compared << "compared," << tally.noJob << "no whole job,"
                      << tally.notRun << "not run to the end," << stopped
                      << "not followed:" << words;
    QVERIFY2(tally.differing.empty(), tally.differing.c_str());
  }
};

RIVULET_TEST(TestSecondJudge)
#include "tst_second_judge.moc"
