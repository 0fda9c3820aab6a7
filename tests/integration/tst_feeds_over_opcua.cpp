// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The feeds of a program over OPC UA: the axes take as long for each move as in the program
/// itself.

#include <fmt/format.h>

#include <QtTest>

#include "gcode/program.h"
#include "opcua/await.h"
#include "streaming/methods/feed_plan.h"
#include "streaming/run/job.h"
#include "support/loopback_machine.h"
#include "support/silent_run.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace std::chrono_literals;
using base::MethodKind;

namespace {

constexpr const char* kProgram =
    "G90 G94 G64\nG0 X0 Y0 Z50\nG1 X8 F600\nX30 F1800\nG0 X60\nG1 Y10 F1200\nX52 F900\nM30\n";

/// How long each move took, s; waiting between them is not counted.
std::vector<double> secondsOf(const trace::ControlTrace& trace) {
  std::vector<double> seconds;
  for (const trace::ExecutedBlock& block : trace.blocks) {
    if (block.moves()) {
      seconds.push_back(base::toSeconds(block.to - block.from));
    }
  }
  return seconds;
}

}  // namespace

class TestFeedsOverOpcua : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void eachMoveTakesAsLongAsInTheProgram_data() {
    QTest::addColumn<int>("method");
    QTest::addColumn<bool>("perPoint");
    QTest::newRow("window") << static_cast<int>(MethodKind::Window) << false;
    QTest::newRow("window, per point") << static_cast<int>(MethodKind::Window) << true;
    QTest::newRow("credit") << static_cast<int>(MethodKind::Credit) << false;
    QTest::newRow("credit, per point") << static_cast<int>(MethodKind::Credit) << true;
  }
  void eachMoveTakesAsLongAsInTheProgram() {
    QFETCH(int, method);
    QFETCH(bool, perPoint);
    tests::LoopbackMachine plain;
    const auto plainLink = plain.connect();
    QVERIFY(plainLink->uploadProgram("PLAIN.MPF", kProgram, true).has_value());
    QVERIFY(plainLink->selectProgram("PLAIN.MPF").has_value());
    QVERIFY(plainLink->cycleStart().has_value());
    const auto hasEnded = [&] {
      const auto numbers = opcua::readNumbers(
          *plainLink, std::array{opcua::Variable{opcua::VariableKind::ChannelStatus, 0}}, 20s);
      return numbers && numbers->front() == opcua::kChannelReset;
    };
    QTRY_VERIFY_WITH_TIMEOUT(hasEnded(), 60'000);
    const auto plainTrace = plainLink->fetchTrace();
    QVERIFY(plainTrace.has_value());
    const std::vector<double> expected = secondsOf(*plainTrace);

    tests::LoopbackMachine cell;
    const auto link = cell.connect();
    const machine::MachineConfig config = *machine::loadPreset("ideal");
    const auto program = gcode::interpretProgram("feeds.mpf", kProgram);
    QVERIFY(program.has_value());
    streaming::RunSettings settings;
    settings.parameters.method = static_cast<MethodKind>(method);
    settings.parameters.pointsPerLoop = 3;
    settings.parameters.feedPerPoint = perPoint;
    settings.parameters.slowDown = false;
    settings.programFeeds = gcode::ProgramFeeds{1.0, config.rapidMmPerS, config.feedMmPerSMax()};
    settings.isCommissioned = true;
    tests::SilentRun silent;
    const streaming::RunReport report =
        streaming::runJob(*link, *link, *program, settings, silent, silent);
    QVERIFY2(report.isFaultless(), report.error.text().c_str());
    const std::vector<double> streamed = secondsOf(*report.controlTrace);
    QCOMPARE(streamed.size(), expected.size());
    for (std::size_t move = 0; move < streamed.size(); ++move) {
      // Windows end at a standstill: braking and accelerating belong to the moves beside it.
      const double more = 0.15;
      QVERIFY2(streamed[move] > 0.95 * expected[move] - 0.02 &&
                   streamed[move] < 1.05 * expected[move] + more,
               fmt::format("move {}: {:.3f} s, in the program {:.3f} s", move, streamed[move],
                           expected[move])
                   .c_str());
    }
  }
};

RIVULET_TEST(TestFeedsOverOpcua)
#include "tst_feeds_over_opcua.moc"
