// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What the client of the test of the feed cell does in each of its steps: it writes a cell, gives
/// a sign of life, and looks. @threadsafety one object, one thread.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "streaming/setup/feed_test_cells.h"
#include "streaming/setup/program_test.h"
#include "templates/window_protocol.h"

namespace rivulet::streaming {

class FeedTestSteps : protected ProgramTest {
 public:
  FeedTestSteps(opcua::Link& link, opcua::Control& control, const FeedTestPlan& plan,
                const std::function<bool(CommissioningStep)>& progress)
      : ProgramTest(link, control, plan, progress), m_feedPlan(plan) {}

  /// One look at the cells.
  struct Look {
    double acts = 0.0;
    double done = 0.0;
    double moved = 0.0;
    double late = 0.0;
    double moving = 0.0;
    double step = 0.0;
    double liftedMm = 0.0;
    double inAir = 0.0;
  };

  [[nodiscard]] base::Result<void> set(TestCell which, double value) {
    return ProgramTest::set(static_cast<int>(which), value);
  }
  [[nodiscard]] base::Result<double> number(const opcua::Variable& variable);
  [[nodiscard]] opcua::Variable cell(TestCell which) const {
    return ProgramTest::cell(static_cast<int>(which));
  }
  /// Writes the feed cell.
  [[nodiscard]] base::Result<void> want(double percent);

  /// Gives a sign of life, waits a little, and looks.
  [[nodiscard]] base::Result<Look> look();

  /// Looks until `holds` is true of what is seen. @return nothing: it was not, in that time
  template <class Condition>
  [[nodiscard]] base::Result<std::optional<Look>> await(base::Duration longest, Condition holds) {
    const base::Instant until = m_link.now() + longest;
    for (;;) {
      const base::Result<Look> seen = look();
      if (!seen) {
        return base::fail(seen.error());
      }
      if (holds(*seen)) {
        return *seen;
      }
      if (m_foreign || m_link.now() >= until) {
        return std::nullopt;
      }
    }
  }

  void add(const char* name, bool passed, std::string message) {
    m_result.checks.push_back({name, passed, std::move(message)});
  }
  /// Nobody else writes the feed cell, and no check has failed.
  [[nodiscard]] bool goesOn() const {
    return !m_foreign && (m_result.checks.empty() || m_result.passed());
  }
  [[nodiscard]] const FeedTestPlan& feedPlan() const { return m_feedPlan; }
  [[nodiscard]] FeedCommissioning& result() { return m_result; }
  [[nodiscard]] const std::optional<double>& foreign() const { return m_foreign; }

 protected:
  CommissioningStep m_step = CommissioningStep::Running;

 private:
  const FeedTestPlan& m_feedPlan;
  double m_wanted = templates::FeedCell::kProgrammed;
  double m_beats = 0.0;
  std::optional<double> m_foreign;
  FeedCommissioning m_result;
};

}  // namespace rivulet::streaming
