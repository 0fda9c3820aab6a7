// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The program of method window does what the model of the protocol does
/// (tests/model/window_protocol.pml): the writes of tests/model/traces.txt are made on a simulated
/// link, one after the other, and after each one the program has to obey, to copy, to move and to
/// end as the model did. `tests/model/check` compares the traces with the model.

#include <QtTest>
#include <array>
#include <cmath>
#include <sstream>

#include "base/file.h"
#include "base/text.h"
#include "machine/config.h"
#include "opcua/variable.h"
#include "streaming/simulation/simulated_link.h"
#include "support/test_program.h"
#include "templates/flexible_program.h"

using namespace rivulet;
using templates::WindowProtocol;

namespace {

constexpr double kFeedMmPerMin = 3000.0;
constexpr double kStepMm = 2.0;
/// Longer than the program's look at its cells and its moves take together.
constexpr base::Duration kSettled = std::chrono::milliseconds{800};

/// The program on the virtual machine, and the writes of the model on a link to it.
class Replay {
 public:
  Replay() {
    templates::TemplateParameters parameters;
    parameters.pointsPerLoop = 2;
    parameters.windows = 2;
    parameters.silenceLimitS = 0.0;  // the model has no heartbeat
    m_program = *templates::makeProgram(parameters);
    const bool isReady = m_link.uploadProgram(m_program.name, m_program.text, true).has_value() &&
                         m_link.selectProgram(m_program.name).has_value() &&
                         m_link.cycleStart().has_value();
    if (!isReady) {
      qFatal("the program does not start");
    }
    settle();
    m_blocks = m_machine.trace().blocks.size();
    m_startMm = m_machine.state().commandMm;
  }

  /// A write of the model, and what the program has done after it, in the words of the model.
  std::string make(const std::vector<std::string>& words) {
    const auto number = [&](std::size_t word) { return *base::parseInteger(words[word]); };
    const templates::CellMap& cells = m_program.cells;
    std::vector<opcua::Assignment> writes;
    if (words[0] == "content") {
      writes = content(number(1), number(2), number(3));
    } else if (words[0] == "point") {
      writes.push_back({opcua::rParameter(pointCell(number(1))), placeMm(number(2))});
    } else if (words[0] == "delivered") {
      writes.push_back({opcua::rParameter(cells.delivered), 1.0 * number(1)});
    } else if (words[0] == "run") {
      writes.push_back({opcua::rParameter(cells.run), 1.0 * number(1)});
    } else if (words[0] == "asked") {
      writes.push_back({opcua::rParameter(cells.client), 1.0 * number(1)});
    } else {
      qFatal("no write of the model: %s", words[0].c_str());
    }
    m_link.write(writes, std::chrono::seconds{10}, opcua::Grouping::List);
    settle();
    return did();
  }

 private:
  /// A point of the model is a place on X.
  [[nodiscard]] double placeMm(int point) const { return m_startMm.x + kStepMm * point; }

  [[nodiscard]] int pointCell(int window) const {
    constexpr int kPoints = 2;
    return m_program.cells.slotCells((window - 1) % 2 * kPoints)[0];
  }

  /// As the client writes a window of one point (streaming/methods/window); the last one is that of
  /// point 3.
  [[nodiscard]] std::vector<opcua::Assignment> content(int run, int window, int point) const {
    constexpr int kLastPoint = 3;
    const templates::CellMap& cells = m_program.cells;
    const int slot = (window - 1) % 2;
    const double count = point == kLastPoint ? -1.0 : 1.0;
    std::vector<opcua::Assignment> writes;
    double check = run + WindowProtocol::kCheckNumber * window +
                   WindowProtocol::kCheckCount * count + WindowProtocol::kCheckFeed * kFeedMmPerMin;
    int place = 0;
    for (int i = 0; i < 2; ++i) {
      for (const int cell : cells.slotCells(2 * slot + i)) {
        const std::array<double, 3> targetMm{placeMm(point), m_startMm.y, m_startMm.z};
        const double value = targetMm[static_cast<std::size_t>(place) % targetMm.size()];
        writes.push_back({opcua::rParameter(cell), value});
        check += WindowProtocol::checkFactor(place++) * value;
      }
    }
    writes.push_back({opcua::rParameter(cells.windowCount(slot)), count});
    writes.push_back({opcua::rParameter(cells.windowFeed(slot)), kFeedMmPerMin});
    writes.push_back({opcua::rParameter(cells.windowCheck(slot)), check});
    return writes;
  }

  void settle() {
    const base::Instant until = m_link.now() + kSettled;
    while (m_link.wait(until)) {
    }
    m_machine.advance(until);
  }

  std::string did() {
    const templates::CellMap& cells = m_program.cells;
    std::string text;
    const auto say = [&text](const std::string& what) {
      text += (text.empty() ? "" : "; ") + what;
    };
    if (const int owner = cell(cells.owner); owner != m_owner) {
      m_owner = owner;
      say("obeys " + std::to_string(owner));
    }
    const auto& blocks = m_machine.trace().blocks;
    const int latched = cell(cells.latched);
    for (; m_blocks < blocks.size(); ++m_blocks) {
      // A short window is filled up with its last point, which the program leaves out.
      say("takes " + std::to_string(++m_latched) + " moves " +
          std::to_string(static_cast<int>(
              std::lround((blocks[m_blocks].targetMm.x - m_startMm.x) / kStepMm))));
    }
    if (latched != m_latched) {
      say("latched " + std::to_string(latched) + " is not what was moved");
    }
    if (!m_hasEnded && m_machine.state().channel == machine::ChannelStatus::Reset) {
      m_hasEnded = true;
      say("ends");
    }
    return text;
  }

  [[nodiscard]] int cell(int number) const {
    return static_cast<int>(std::lround(m_machine.rParameter(number)));
  }

  machine::Machine m_machine{*machine::loadPreset("ideal"), 1};
  streaming::SimulatedLink m_link{m_machine};
  templates::FlexibleProgram m_program;
  base::Vec3 m_startMm;
  std::size_t m_blocks = 0;
  int m_owner = 0;
  int m_latched = 0;
  bool m_hasEnded = false;
};

std::vector<std::string> split(const std::string& text, const std::string& separator) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t end = text.find(separator); end != std::string::npos;
       end = text.find(separator, begin)) {
    parts.push_back(text.substr(begin, end - begin));
    begin = end + separator.size();
  }
  parts.push_back(text.substr(begin));
  return parts;
}

bool isWrite(const std::string& step) {
  return !step.starts_with("obeys") && !step.starts_with("takes") && step != "ends";
}

}  // namespace

class TestWindowModel : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theProgramDoesWhatTheModelDoes() {
    const auto text =
        base::readFile(std::filesystem::path(RIVULET_SOURCE_DIR) / "tests/model/traces.txt");
    QVERIFY(text);
    std::istringstream lines(*text);
    int moves = 0;
    int traces = 0;
    for (std::string line; std::getline(lines, line); ++traces) {
      const std::vector<std::string> steps = split(line, "; ");
      Replay replay;
      for (std::size_t i = 0; i < steps.size();) {
        const std::string& write = steps[i++];
        std::string expected;
        for (; i < steps.size() && !isWrite(steps[i]); ++i) {
          expected += (expected.empty() ? "" : "; ") + steps[i];
          moves += steps[i].starts_with("takes") ? 1 : 0;
        }
        const std::string did = replay.make(split(write, " "));
        QVERIFY2(did == expected, ("trace " + std::to_string(traces + 1) + ", " + write + ": \"" +
                                   did + "\", the model: \"" + expected + "\"")
                                      .c_str());
      }
    }
    QVERIFY(traces >= 100 && moves >= 25);
  }
};

RIVULET_TEST(TestWindowModel)
#include "tst_window_model.moc"
