// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// A control of one's own is one class that is given to a run: `Link` and `Control` are all that
/// job, driver and methods know of it.

#include <QtTest>
#include <deque>
#include <map>
#include <regex>

#include "base/text.h"
#include "streaming/run/job.h"
#include "streaming/simulation/scenario.h"
#include "support/silent_run.h"
#include "support/test_program.h"

using namespace rivulet;
using templates::LoopProtocol;

namespace {

/// It knows no language: it does what the program of method signal does, one half of the loop at a
/// time, and waits until the half before has been refilled.
class OwnControl final : public opcua::Link, public opcua::Control {
 public:
  explicit OwnControl(const templates::CellMap& cells) : m_cells(cells) {}

  std::vector<base::Vec3> moves;

  base::Instant now() const override { return m_now; }
  base::RequestId read(std::span<const opcua::Variable> variables, base::Duration,
                       opcua::Grouping) override {
    opcua::Event& done = m_events.emplace_back(event(opcua::EventKind::ReadDone));
    for (const opcua::Variable& variable : variables) {
      done.readings.push_back({{}, m_values[variable], {}});
    }
    return done.request;
  }
  base::RequestId write(std::span<const opcua::Assignment> assignments, base::Duration,
                        opcua::Grouping) override {
    opcua::Event& done = m_events.emplace_back(event(opcua::EventKind::WriteDone));
    for (const opcua::Assignment& assignment : assignments) {
      m_values[assignment.variable] = assignment.value;
      done.statuses.emplace_back();
    }
    return done.request;
  }
  base::RequestId store(const std::string&, const std::string&, base::Duration) override {
    return {};
  }
  std::optional<opcua::Event> wait(base::Instant until) override {
    m_now = std::min(m_now + std::chrono::milliseconds{20}, until);
    if (channel() != opcua::kChannelReset) {
      work();
    }
    if (m_events.empty()) {
      return std::nullopt;
    }
    opcua::Event next = std::move(m_events.front());
    m_events.pop_front();
    next.at = m_now;
    return next;
  }

  base::Result<void> uploadProgram(const std::string&, const std::string& text, bool) override {
    m_text = text;
    return {};
  }
  base::Result<std::string> downloadProgram(const std::string&) override { return m_text; }
  base::Result<void> selectProgram(const std::string&) override { return {}; }
  bool isVirtualMachine() const override { return true; }
  opcua::Abilities abilities() const override { return {true, false}; }
  base::Result<void> cycleStart() override {
    std::smatch number;
    std::regex_search(m_text, number, std::regex("R4=([0-9]+)"));
    channel() = 1;
    cell(m_cells.layout) = base::parseNumber(number[1].str()).value();
    cell(m_cells.signal) = LoopProtocol::kRefilled;
    return {};
  }
  base::Result<void> reset() override { return {}; }
  base::Result<trace::ControlTrace> fetchTrace() override { return trace::ControlTrace{}; }

 private:
  double& cell(int number) { return m_values[opcua::rParameter(number)]; }
  double& channel() { return m_values[{opcua::VariableKind::ChannelStatus, 0}]; }
  opcua::Event event(opcua::EventKind kind) {
    return {kind, base::RequestId{++m_requests}, m_now, m_now, {}, {}, {}, {}};
  }
  void work() {
    if (cell(m_cells.run) != LoopProtocol::kRun ||
        cell(m_cells.signal) != LoopProtocol::kRefilled) {
      return;
    }
    const bool isSecond = m_halves++ % 2 == 1;
    const int half = m_cells.pointsPerLoop / 2;
    for (int slot = isSecond ? half : 0; slot < (isSecond ? m_cells.pointsPerLoop : half); ++slot) {
      const std::vector<int> at = m_cells.slotCells(slot);
      moves.push_back({cell(at[0]), cell(at[1]), cell(at[2])});
    }
    cell(m_cells.signal) = isSecond ? LoopProtocol::kSecondPassed : LoopProtocol::kFirstPassed;
    if (isSecond && cell(m_cells.stop) == LoopProtocol::kStop) {
      channel() = opcua::kChannelReset;
    }
  }

  templates::CellMap m_cells;
  base::Instant m_now{};
  std::uint32_t m_requests = 0;
  int m_halves = 0;
  std::string m_text;
  std::map<opcua::Variable, double> m_values;
  std::deque<opcua::Event> m_events;
};

}  // namespace

class TestOwnControl : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void executesEachPointInItsTurn() {
    base::Random random(1);
    std::vector<base::Vec3> path = streaming::drawContour({30, 0.3, 0.3}, random);
    path.erase(path.begin());  // there the tool is already
    streaming::RunSettings settings;
    settings.parameters.method = base::MethodKind::Signal;
    const auto flexible = templates::makeProgram(settings.parameters);
    OwnControl control(flexible->cells);
    tests::SilentRun silent;
    const streaming::RunReport report = streaming::runJob(
        control, control, *streaming::programOf(path), *flexible, settings, silent, silent);
    QVERIFY2(report.outcome == streaming::Outcome::Completed, report.error.text().c_str());
    control.moves.erase(std::unique(control.moves.begin(), control.moves.end()),
                        control.moves.end());  // after the last point comes the last point again
    QVERIFY(control.moves == path);
  }
};

RIVULET_TEST(TestOwnControl)
#include "tst_own_control.moc"
