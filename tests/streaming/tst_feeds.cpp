// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The feeds of the program, streamed: each move with that of its own block.

#include <fmt/format.h>

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <map>

#include "base/random.h"
#include "base/units.h"
#include "feasibility/verdict.h"
#include "gcode/feeds.h"
#include "streaming/methods/feed_plan.h"
#include "streaming/methods/pause_placement.h"
#include "streaming/recovery/resume.h"
#include "streaming/run/job.h"
#include "streaming/simulation/faulty_link.h"
#include "streaming/simulation/scenario.h"
#include "support/silent_run.h"
#include "support/test_program.h"
#include "templates/flexible_program.h"
#include "templates/lint/lint.h"

using namespace rivulet;
using namespace std::chrono_literals;
using base::MethodKind;
using streaming::Outcome;
using streaming::RunReport;
using streaming::RunSettings;
using streaming::StreamError;

namespace {

constexpr double kRapidMmPerMin = 9000.0;
constexpr double kLimitMmPerMin = 10000.0;

gcode::ProgramFeeds feeds(double overrideFactor = 1.0) {
  return {overrideFactor, base::mmPerSFromMmPerMin(kRapidMmPerMin),
          base::mmPerSFromMmPerMin(kLimitMmPerMin)};
}

gcode::Program programOf(const std::string& text) {
  auto program = gcode::interpretProgram("feeds.mpf", text);
  if (!program) {
    qFatal("%s", program.error().text().c_str());
  }
  return std::move(*program);
}

/// Cuts with feeds of their own and rapids between them, as text; the feeds in mm/min, 0 for
/// rapids.
struct Drawn {
  std::string text = "G90 G94\n";
  std::vector<double> feedsMmPerMin;
};

Drawn draw(std::uint64_t seed, std::size_t count = 60) {
  base::Random random(seed);
  Drawn drawn;
  base::Vec3 at;
  double feed = 600.0;
  drawn.text += "G0 X0 Y0 Z40\n";
  drawn.feedsMmPerMin.push_back(0.0);
  for (std::size_t i = 0; i < count; ++i) {
    at = at + base::Vec3{1.0 + random.uniform(), 4.0 * random.uniform() - 2.0, 0.0};
    const bool isRapid = random.below(6) == 0;
    if (random.below(3) == 0) {
      feed = 300.0 + 50.0 * static_cast<double>(random.below(60));
    }
    drawn.text += isRapid ? fmt::format("G0 X{:.3f} Y{:.3f}\n", at.x, at.y)
                          : fmt::format("G1 X{:.3f} Y{:.3f} F{:.0f}\n", at.x, at.y, feed);
    drawn.feedsMmPerMin.push_back(isRapid ? 0.0 : feed);
  }
  drawn.text += "M30\n";
  return drawn;
}

RunSettings settingsOf(MethodKind method, std::optional<gcode::ProgramFeeds> programFeeds,
                       bool feedPerPoint) {
  RunSettings settings;
  settings.parameters.method = method;
  settings.parameters.pointsPerLoop = 5;
  settings.parameters.feedPerPoint = feedPerPoint;
  settings.feedMmPerS = base::mmPerSFromMmPerMin(1500.0);
  settings.programFeeds = programFeeds;
  settings.isCommissioned = true;
  settings.monitor = false;
  return settings;
}

/// What the client has written for each point of a run: mm/min, in order.
struct Commanded {
  RunReport report;
  std::vector<double> feedsMmPerMin;
  std::vector<base::Vec3> executed;
};

Commanded run(const gcode::Program& program, const RunSettings& settings,
              const std::string& preset = "ideal") {
  machine::Machine machine(*machine::loadPreset(preset), 1);
  streaming::FaultyLink link(machine, {}, 1);
  Commanded seen;
  const templates::CellMap cells = templates::makeProgram(settings.parameters)->cells;
  std::map<int, double> values;
  link.onWrite = [&](int cell, double value, bool) {
    values[cell] = value;
    if (cell == cells.delivered && cells.files == 0 && value > 0.0) {
      const int slot = (static_cast<int>(value) - 1) % cells.windows;
      const int count = static_cast<int>(std::abs(values[cells.windowCount(slot)]));
      for (int i = 0; i < count; ++i) {
        const std::vector<int> numbers = cells.slotCells(slot * cells.pointsPerLoop + i);
        seen.feedsMmPerMin.push_back(cells.feedPerPoint ? values[numbers.back()]
                                                        : values[cells.windowFeed(slot)]);
      }
    }
  };
  tests::SilentRun silent;
  seen.report = streaming::runJob(link, link, program, settings, silent, silent);
  if (seen.report.controlTrace) {
    for (const trace::ExecutedBlock& block : seen.report.controlTrace->blocks) {
      if (block.moves()) {
        seen.executed.push_back(block.targetMm);
      }
    }
  }
  return seen;
}

}  // namespace

class TestFeeds : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void eachMoveHasTheFeedOfItsBlock_data() {
    QTest::addColumn<int>("method");
    QTest::addColumn<bool>("perPoint");
    QTest::newRow("window") << static_cast<int>(MethodKind::Window) << false;
    QTest::newRow("window, per point") << static_cast<int>(MethodKind::Window) << true;
    QTest::newRow("credit") << static_cast<int>(MethodKind::Credit) << false;
    QTest::newRow("credit, per point") << static_cast<int>(MethodKind::Credit) << true;
  }
  /// Within rounding, the override times the feed of the block; rapids at the rapid feed; never
  /// above the machine's limits. And the path is that of a run with one feed.
  void eachMoveHasTheFeedOfItsBlock() {
    QFETCH(int, method);
    QFETCH(bool, perPoint);
    const auto kind = static_cast<MethodKind>(method);
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      const Drawn drawn = draw(seed);
      const gcode::Program program = programOf(drawn.text);
      const Commanded fixed = run(program, settingsOf(kind, std::nullopt, false));
      QVERIFY2(fixed.report.isFaultless(), fixed.report.error.text().c_str());
      for (const double factor : {1.0, 0.37, 1.9}) {
        const Commanded seen = run(program, settingsOf(kind, feeds(factor), perPoint));
        QVERIFY2(seen.report.isFaultless(), seen.report.error.text().c_str());
        QVERIFY(seen.executed == fixed.executed);
        QCOMPARE(seen.feedsMmPerMin.size(), drawn.feedsMmPerMin.size());
        for (std::size_t i = 0; i < drawn.feedsMmPerMin.size(); ++i) {
          const bool isRapid = drawn.feedsMmPerMin[i] == 0.0;
          const double wanted = isRapid ? std::min(1.0, factor) * kRapidMmPerMin
                                        : std::min(factor * drawn.feedsMmPerMin[i], kLimitMmPerMin);
          QVERIFY2(
              std::abs(seen.feedsMmPerMin[i] - wanted) <= 1e-9 * wanted,
              fmt::format("seed {} point {}: {} for {}", seed, i, seen.feedsMmPerMin[i], wanted)
                  .c_str());
        }
      }
    }
  }

  /// The axes obey: no sample of the control's trace is faster than the feeds of the blocks around
  /// it, and a long move reaches its feed.
  void theAxesMoveAtTheFeedsOfTheBlocks() {
    const gcode::Program program =
        programOf("G90 G94 G0 X0 Y0 Z40\nG1 X30 F600\nX60 F2400\nG0 X100\nG1 X130 F1200\nM30\n");
    const std::vector<double> feedsMmPerMin{kRapidMmPerMin, 600.0, 2400.0, kRapidMmPerMin, 1200.0};
    for (const MethodKind method : {MethodKind::Window, MethodKind::Credit, MethodKind::File}) {
      for (const bool perPoint : {false, true}) {
        RunSettings settings = settingsOf(method, feeds(0.5), perPoint);
        settings.parameters.slowDown = false;
        const Commanded seen = run(program, settings, "dmu75");
        QVERIFY2(seen.report.isFaultless(), seen.report.error.text().c_str());
        const trace::ControlTrace& trace = *seen.report.controlTrace;
        std::size_t move = 0;
        for (const trace::ExecutedBlock& block : trace.blocks) {
          if (!block.moves()) {
            continue;
          }
          double fastest = 0.0;
          for (const trace::ControlSample& sample : trace.samples) {
            if (sample.at > block.from + 300ms && sample.at < block.to - 300ms) {
              fastest = std::max(fastest, base::mmPerMinFromMmPerS(sample.feedMmPerS));
            }
          }
          const double wanted = 0.5 * feedsMmPerMin[move++];
          if (block.to - block.from > 900ms) {
            QVERIFY2(std::abs(fastest - wanted) < 0.5,
                     fmt::format("{} move {}: {:.1f} for {}", base::methodName(method), move,
                                 fastest, wanted)
                         .c_str());
          }
          QVERIFY(fastest <= wanted + 0.5);
        }
        QCOMPARE(move, feedsMmPerMin.size());
      }
    }
  }

  void filesHaveTheWordsOfTheBlocks() {
    const gcode::Program program =
        programOf("G90 G94 G0 X1 Y0 Z40\nG1 X2 F600\nX3\nG0 X9\nG1 X10 F1200\nM30\n");
    const auto textAt = [&](double factor) {
      machine::Machine machine(*machine::loadPreset("ideal"), 1);
      streaming::FaultyLink link(machine, {}, 1);
      tests::SilentRun silent;
      const RunReport report = streaming::runJob(
          link, link, program, settingsOf(MethodKind::File, feeds(factor), false), silent, silent);
      return report.isFaultless() ? *machine.programText("RIVULET_W1.SPF") : std::string();
    };
    const std::string text = textAt(1.0);
    QVERIFY(text.find("G0 X1.000000 Y0.000000 Z40.000000\nG1 X2.000000 Y0.000000 Z40.000000 F600\n"
                      "G1 X3.000000 Y0.000000 Z40.000000\nG0 X9.000000") != std::string::npos);
    QVERIFY(text.find("G1 X10.000000 Y0.000000 Z40.000000 F1200\n") != std::string::npos);
    // The override does not scale G0: a slower rapid is a G1.
    QVERIFY(textAt(0.5).find("G1 X9.000000 Y0.000000 Z40.000000 F4500\n") != std::string::npos);
  }

  void windowsEndWhereTheFeedChanges() {
    std::vector<gcode::StreamPoint> points(9);
    for (std::size_t i = 0; i < points.size(); ++i) {
      points[i].positionMm = {static_cast<double>(i), 0, 0};
      points[i].feedMmPerS = i < 2 || i > 6 ? 10.0 : 20.0;
    }
    const auto begins = [&](streaming::WindowCut cut) {
      return streaming::cutWindows(points, 4, cut).begins;
    };
    QCOMPARE(begins({false, false}), (std::vector<std::size_t>{0, 2, 6, 7}));
    QCOMPARE(begins({true, false}).size(), std::size_t{4});
    QCOMPARE(begins({false, true}), (std::vector<std::size_t>{0, 4, 8}));
  }

  /// A program whose feed changes at almost every block is streamed with a feed in each point; one
  /// with long stretches of the same feed is not.
  void cellsOfTheFeedsAreThoseOfTheShorterRun() {
    const auto planned = [](bool changes, MethodKind method) {
      std::string text = "G90 G94 G0 X0 Y0 Z40\n";
      for (int i = 1; i <= 200; ++i) {
        text += fmt::format("G1 X{:.1f} F{}\n", 0.3 * i, changes ? 1000 + i : 1000);
      }
      const gcode::Program program = programOf(text + "M30\n");
      RunSettings settings = settingsOf(method, feeds(), false);
      streaming::planFeeds(
          settings, gcode::streamPoints(program.trajectory, {}, {}, &*settings.programFeeds).points,
          {});
      return settings;
    };
    for (const MethodKind method : {MethodKind::Window, MethodKind::Credit}) {
      QVERIFY(planned(true, method).parameters.feedPerPoint);
      QVERIFY(!planned(false, method).parameters.feedPerPoint);
    }
    QVERIFY(!planned(true, MethodKind::File).parameters.feedPerPoint);  // F is in the file
    // Verdict and scales refer to the largest feed.
    QCOMPARE(base::mmPerMinFromMmPerS(planned(true, MethodKind::Window).feedMmPerS),
             kRapidMmPerMin);
  }

  /// The choice is right on the virtual machine, too: the run it calls shorter is shorter.
  void theModelChoosesTheShorterRun() {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      base::Random random(seed);
      // The feed changes every 1 to 16 points.
      std::string text = "G90 G94 G0 X0 Y0 Z40\n";
      const std::uint64_t every = std::uint64_t{1} << (seed + 0U);
      double feed = 900.0;
      for (int i = 1; i <= 140; ++i) {
        feed =
            random.below(every) == 0 ? 600.0 + 20.0 * static_cast<double>(random.below(30)) : feed;
        text += fmt::format("G1 X{:.2f} F{:.0f}\n", 0.5 * i, feed);
      }
      const gcode::Program program = programOf(text + "M30\n");
      for (const MethodKind method : {MethodKind::Window, MethodKind::Credit}) {
        RunSettings settings = settingsOf(method, feeds(), false);
        streaming::planFeeds(
            settings,
            gcode::streamPoints(program.trajectory, {}, {}, &*settings.programFeeds).points, {});
        const bool chosen = settings.parameters.feedPerPoint;
        std::array<double, 2> seconds{};
        for (const bool perPoint : {false, true}) {
          settings.parameters.feedPerPoint = perPoint;
          const Commanded seen = run(program, settings, "dmu75");
          QVERIFY2(seen.report.isFaultless(), seen.report.error.text().c_str());
          seconds[perPoint ? 1 : 0] = base::toSeconds(seen.report.duration);
        }
        qInfo("feed changes every %d points, %s: per window %.2f s, per point %.2f s, chosen %s",
              static_cast<int>(every), std::string(base::methodName(method)).c_str(), seconds[0],
              seconds[1], chosen ? "point" : "window");
        // Where both are nearly equal it does not matter.
        QVERIFY(seconds[chosen ? 1 : 0] <= 1.05 * seconds[chosen ? 0 : 1]);
      }
    }
  }

  void whatHasNoFeedIsNamed_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("line");
    QTest::newRow("no F") << QStringLiteral("G0 X0 Y0 Z0\nG1 X1\nM30\n") << 2;
    QTest::newRow("G95 without S") << QStringLiteral("G0 X0 Y0 Z0\nG95 F0.1\nG1 X1\nM30\n") << 3;
    QTest::newRow("all known") << QStringLiteral("G0 X0 Y0 Z0\nG1 X1 F100\nX2\nM30\n") << 0;
    QTest::newRow("G95 with S") << QStringLiteral("G0 X0 Y0 Z0\nG95 F0.1\nS1000 M3\nG1 X1\nM30\n")
                                << 0;
    QTest::newRow("G93") << QStringLiteral("G0 X0 Y0 Z0\nG93\nG1 X1 F2\nM30\n") << 0;
  }
  void whatHasNoFeedIsNamed() {
    QFETCH(QString, text);
    QFETCH(int, line);
    const gcode::Program program = programOf(text.toStdString());
    const RunSettings settings = settingsOf(MethodKind::Window, feeds(), false);
    const Commanded seen = run(program, settings);
    QCOMPARE(seen.report.error.code == StreamError::FeedUnknown, line > 0);
    QCOMPARE(seen.report.isFaultless(), line == 0);
    if (line > 0) {
      QVERIFY2(seen.report.error.message.find(fmt::format("line {} ", line)) != std::string::npos,
               seen.report.error.text().c_str());
    }
  }

  /// G93: moves per minute; G95: mm per revolution, with the spindle speed of that moment.
  void feedsAreConverted() {
    const auto feedOf = [](const std::string& text) {
      const gcode::Program program = programOf("G90 G0 X0 Y0 Z0\n" + text + "\nM30\n");
      return base::mmPerMinFromMmPerS(program.trajectory.points.back().feedMmPerS);
    };
    QCOMPARE(feedOf("G93\nG1 X3 Y4 F2"), 10.0);
    QCOMPARE(feedOf("S1000 M3\nG95 F0.1\nG1 X1"), 100.0);
    QCOMPARE(feedOf("G95 F0.1\nS1000 M3\nG1 X1\nS2000\nG1 X2"), 200.0);
    QCOMPARE(feedOf("G71\nG94 G1 X1 F100"), 100.0);
    QCOMPARE(feedOf("G94 G1 X1 F100\nA90 F30"), 30.0);  // deg/min
  }

  void methodsOfThePaperHaveOneFeed() {
    const gcode::Program program = programOf(draw(1).text);
    for (const MethodKind method : base::kPaperMethods) {
      const Commanded seen = run(program, settingsOf(method, feeds(), false));
      QVERIFY(seen.report.error.code == StreamError::OneFeedOnly);
      QVERIFY(seen.executed.empty());
    }
  }

  void theOverrideHasARange() {
    const gcode::Program program = programOf(draw(1).text);
    for (const double factor : {0.0, -1.0, 2.1, std::nan("")}) {
      const Commanded seen = run(program, settingsOf(MethodKind::Window, feeds(factor), false));
      QVERIFY(seen.report.error.code == StreamError::BadOverride);
    }
  }

  /// The verdict goes by the times of the moves: a slow block with close points does not limit, and
  /// the block that does is named.
  void theVerdictNamesTheBlockThatLimits() {
    std::string text = "G90 G94 G0 X0 Y0 Z40\n";
    for (int i = 1; i <= 30; ++i) {
      text += fmt::format("G1 X{:.2f} F100\n", 0.05 * i);  // close, but slow
    }
    for (int i = 1; i <= 30; ++i) {
      text += fmt::format("G1 X{:.2f} F4000\n", 1.5 + 0.4 * i);
    }
    const gcode::Program program = programOf(text + "M30\n");
    const RunSettings settings = settingsOf(MethodKind::Window, feeds(0.5), false);
    const auto points =
        gcode::streamPoints(program.trajectory, {}, {}, &*settings.programFeeds).points;
    feasibility::OperatingPoint point;
    point.pointsPerLoop = settings.parameters.pointsPerLoop;
    point.feedMmPerS = base::mmPerSFromMmPerMin(2000.0);
    const auto verdict = feasibility::judge(
        point, feasibility::programDistances(points, point.pointsPerLoop, point.feedMmPerS));
    QVERIFY(verdict.has_value());
    const auto limit = streaming::overrideLimit(*verdict, points, settings);
    QVERIFY(limit.has_value());
    QVERIFY(limit->line.value > 31);
    QCOMPARE(base::mmPerMinFromMmPerS(limit->feedMmPerS), 4000.0);
    QVERIFY(std::abs(limit->stepMm - 0.4) < 1e-9);
    QVERIFY(!limit->isRapid);
    // At the override it names, the condition just holds.
    RunSettings atLimit = settings;
    atLimit.programFeeds = feeds(limit->overrideFactor);
    const auto there =
        gcode::streamPoints(program.trajectory, {}, {}, &*atLimit.programFeeds).points;
    const auto again = feasibility::judge(
        point, feasibility::programDistances(there, point.pointsPerLoop, point.feedMmPerS));
    QVERIFY(std::abs(again->limiting.margin - 1.0) < 1e-9);
    QVERIFY(streaming::describe(*limit).find("F 4000, 0.400 mm") != std::string::npos);
  }

  /// Without a stop between windows and with free access, streaming takes as long as the program.
  void timeIsThatOfPlainExecution() {
    machine::MachineConfig config = *machine::loadPreset("ideal");
    const std::string text =
        "G90 G94 G64\nG0 X0 Y0 Z40\nG1 X20 F600\nX40 F1800\nG0 X80\nG1 Y20 F1200\nX60 F900\nM30\n";
    machine::Machine plain(config, 1);
    QVERIFY(plain.storeProgram("PLAIN.MPF", text, true) && plain.selectProgram("PLAIN.MPF") &&
            plain.cycleStart());
    while (plain.state().channel != machine::ChannelStatus::Reset) {
      plain.advance(plain.now() + 100ms);
    }
    const auto motion = [](const trace::ControlTrace& trace) {
      return base::toSeconds(trace.blocks.back().to - trace.blocks.front().from);
    };
    const double plainS = motion(plain.trace());
    const gcode::Program program = programOf(text);
    for (const bool perPoint : {false, true}) {
      RunSettings settings = settingsOf(
          MethodKind::Credit, gcode::ProgramFeeds{1.0, config.rapidMmPerS, config.feedMmPerSMax()},
          perPoint);
      settings.parameters.slowDown = false;
      const RunReport report = streaming::simulate(
          {config, std::make_shared<const gcode::Program>(program), settings, 1});
      QVERIFY2(report.isFaultless(), report.error.text().c_str());
      const double streamedS = motion(*report.controlTrace);
      QVERIFY2(std::abs(streamedS - plainS) < 0.02 * plainS,
               fmt::format("{:.3f} s, plain {:.3f} s", streamedS, plainS).c_str());
    }
  }

  void templatesWithAFeedPerPointAreSound() {
    for (const MethodKind method : {MethodKind::Window, MethodKind::Credit}) {
      templates::TemplateParameters parameters;
      parameters.method = method;
      parameters.feedPerPoint = true;
      const auto program = templates::makeProgram(parameters);
      const auto findings = templates::lintProgram(program->text, *program);
      QVERIFY(templates::firstError(findings) == nullptr);
      // The same program without the feeds would leave cells unread, which the lint finds.
      templates::TemplateParameters without = parameters;
      without.feedPerPoint = false;
      const auto other = templates::makeProgram(without);
      QVERIFY(program->layoutNumber != other->layoutNumber);
      QVERIFY(program->name != other->name);
    }
  }
};

RIVULET_TEST(TestFeeds)
#include "tst_feeds.moc"
