// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/simulation/template_proof.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "streaming/run/job.h"
#include "streaming/simulation/faulty_link.h"
#include "streaming/simulation/scenario.h"
#include "templates/feed_cell.h"
#include "templates/flexible_program.h"
#include "trace/analysis/integrity.h"

namespace rivulet::streaming {

namespace {

using base::Duration;
using base::Instant;

/// Slow, and with much way between the points: far from every border of feasibility.
constexpr double kStepMm = 2.0;
constexpr double kDeltaMm = 1.0;
constexpr double kFeedMmPerS = 5.0;
constexpr double kSameMm = 1e-6;
constexpr double kStillMm = 1e-9;
/// A run that gets nowhere is stopped.
constexpr Duration kLimit = std::chrono::minutes{20};
/// Without a client a program of method window has to end: 1000 passes of its waiting loop.
constexpr Duration kAloneMax = std::chrono::minutes{30};
/// A program that waits for its client ends before that.
constexpr Duration kStandsMin = std::chrono::minutes{2};
/// Long enough to see whether something moves that must not.
constexpr Duration kWatched = std::chrono::seconds{20};

class Orders final : public RunSink, public RunOrders {
 public:
  std::optional<Instant> stopAt;
  void update(const LiveUpdate&) override {}
  void access(const trace::Access&) override {}
  void note(const trace::Note&) override {}
  bool stopRequested(Instant now) override { return stopAt && now >= *stopAt; }
  /// From one end of the range to the other, each axis in its own time, and beyond.
  base::Vec3 correctionMm(Instant now) override {
    const double s = base::toSeconds(now.time_since_epoch());
    const auto swing = [this, s](double perS) {
      return 1.5 * correctionLimitMm * std::sin(perS * s);
    };
    return {swing(0.7), swing(0.9), swing(1.1)};
  }
  double correctionLimitMm = 0.0;
};

/// To and fro within the axes' limits; on each way between the points of the ways before.
double wayMm(int step) {
  constexpr int kStepsPerWay = 100;
  constexpr double kBetweenMm = 0.15;
  const int way = step / kStepsPerWay;
  const int rest = step % kStepsPerWay;
  return kStepMm * (way % 2 == 0 ? rest : kStepsPerWay - rest) + kBetweenMm * way;
}

/// Some loops and a rest; no two points are alike, in none of the axes.
std::shared_ptr<const gcode::Program> proofProgram(const templates::TemplateParameters& parameters,
                                                   const machine::MachineConfig& config) {
  const int loops = base::hasWindows(parameters.method) ? parameters.windows + 2 : 3;
  const int count = loops * parameters.pointsPerLoop + std::min(2, parameters.pointsPerLoop);
  std::vector<base::Vec3> points;
  std::vector<base::RotaryDeg> angles;
  const base::AxisPosition start = config.start();
  for (int i = 0; i < count; ++i) {
    const auto at = [&](std::size_t axis, double scale) {
      return start.mm[axis] + (parameters.axes[axis] ? scale * wayMm(i + 1) : 0.0);
    };
    points.push_back({at(0, 1.0), at(1, 0.75), at(2, 0.5)});
    constexpr base::RotaryDeg kDegPerStep{0.3, 0.4, 0.5};
    base::RotaryDeg& turned = angles.emplace_back(start.deg);
    for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
      turned[axis] += kDegPerStep[axis] * wayMm(i + 1);
    }
  }
  return programOf(points, angles, parameters.rotaryAxes);
}

/// One run of the program under proof.
class Trial {
 public:
  Trial(std::string_view text, const templates::FlexibleProgram& meant,
        const machine::MachineConfig& config, const LinkFaults& faults, std::uint64_t seed)
      : m_program(proofProgram(meant.parameters, config)),
        m_meant(meant),
        m_machine(config, seed),
        m_link(m_machine, faults, seed) {
    m_link.programInstead = std::string(text);
    m_settings.placePauses = false;  // every window is to be full once
    m_settings.parameters = meant.parameters;
    m_settings.isCommissioned = true;  // the machine of the proof reads R when it passes a block
    m_settings.deltaMm = kDeltaMm;
    m_settings.feedMmPerS = kFeedMmPerS;
    m_settings.requestDeadline = std::chrono::seconds{20};
    m_settings.startDeadline = std::chrono::seconds{60};
    m_settings.stallDeadline = std::chrono::minutes{2};
    m_settings.stopDeadline = std::chrono::minutes{2};
    m_settings.monitor = false;
    m_start = config.start();
  }

  [[nodiscard]] machine::Machine& machine() { return m_machine; }
  [[nodiscard]] FaultyLink& link() { return m_link; }

  const RunReport& run(std::optional<Duration> stopAfter = {}) {
    Orders orders;
    orders.correctionLimitMm = m_settings.parameters.correctionLimitMm;
    orders.stopAt = m_machine.now() + stopAfter.value_or(kLimit);
    m_report = runJob(m_link, m_link, *m_program, m_meant, m_settings, orders, orders);
    return m_report;
  }

  /// Time the points take, without pauses.
  [[nodiscard]] Duration motionTime() const {
    double way = 0.0;
    base::AxisPosition at = m_start;
    for (const gcode::StreamPoint& point : points()) {
      way += base::wayAlongFeed(base::distance(at.mm, point.positionMm),
                                base::turnDeg(at.deg, point.rotaryDeg));
      at = {point.positionMm, point.rotaryDeg};
    }
    return base::fromSeconds(way / kFeedMmPerS);
  }

  /// What the axes have done wrong so far; empty: nothing.
  [[nodiscard]] std::string wrongMotion() const {
    const trace::Integrity seen = trace::judgeIntegrity(points(), m_machine.trace().blocks, kSameMm,
                                                        m_settings.parameters.rotaryAxes);
    if (seen.isFaultless()) {
      return wrongOverlay();
    }
    return fmt::format(
        "{} points repeated, {} skipped, {} out of order, {} moves to places without a point",
        seen.repeated, seen.skipped, seen.outOfOrder, seen.foreign);
  }

  /// Watches what lies over the path; to be called while the machine runs.
  void watchOverlay() {
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      const double overlayMm = std::abs(m_machine.state().overlayMm[axis]);
      m_overlayMmMax.set(axis, std::max(m_overlayMmMax[axis], overlayMm));
    }
  }
  [[nodiscard]] base::Vec3 overlayMmMax() const { return m_overlayMmMax; }

  /// What was laid over the path and should not have been; empty: nothing.
  [[nodiscard]] std::string wrongOverlay() const {
    const double limitMm = m_settings.parameters.correctionLimitMm;
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      const double allowedMm = m_settings.parameters.axes[axis] ? limitMm : 0.0;
      if (m_overlayMmMax[axis] > allowedMm + kSameMm) {
        return fmt::format("{} was corrected by {} mm, but the limit is {}", base::kAxisNames[axis],
                           m_overlayMmMax[axis], allowedMm);
      }
    }
    if (hasEnded() && base::norm(m_machine.state().overlayMm) > kStillMm) {
      return "the program ended with a correction still active";
    }
    return {};
  }

  [[nodiscard]] std::string notCompleted() const {
    if (m_report.outcome == Outcome::Completed) {
      return {};
    }
    const std::string alarm = m_machine.state().alarmText;
    return fmt::format("the run is {}{}{}", outcomeName(m_report.outcome),
                       m_report.error.code ? ": " + m_report.error.message : "",
                       alarm.empty() ? "" : " Alarm: " + alarm);
  }

  [[nodiscard]] bool hasEnded() const {
    return m_machine.state().channel == machine::ChannelStatus::Reset;
  }

  /// Nobody touches the control any more, until the program has ended or its axes are held for
  /// good.
  void leaveAlone() {
    const Instant until = m_machine.now() + kAloneMax;
    Instant movedAt = m_machine.now();
    while (m_machine.now() < until && !hasEnded() && m_machine.now() - movedAt < kStandsMin) {
      m_link.wait(m_machine.now() + std::chrono::milliseconds{500});
      const bool isHeld =
          m_meant.cells.hasFeedCell() && m_machine.ncRParameter(m_meant.cells.overrideActs) == 0.0;
      movedAt = isHeld ? movedAt : m_machine.now();
    }
  }

  /// Where a program that watches its client stands without it: not while it waits for a window.
  [[nodiscard]] bool standsInWindow() {
    const templates::CellMap& cells = m_meant.cells;
    return templates::watchesClient(cells) &&
           m_machine.ncRParameter(cells.executed) < m_machine.ncRParameter(cells.latched) &&
           !movesOn();
  }

  [[nodiscard]] bool movesOn() {
    m_machine.advance(m_machine.now() + std::chrono::seconds{1});  // the servo settles
    const machine::MachineState before = m_machine.state();
    m_machine.advance(m_machine.now() + kWatched);
    return base::distance(before.commandMm, m_machine.state().commandMm) > kStillMm ||
           base::turnDeg(before.commandDeg, m_machine.state().commandDeg) > kStillMm;
  }

 private:
  [[nodiscard]] std::vector<gcode::StreamPoint> points() const {
    return gcode::streamPoints(m_program->trajectory, m_start.mm, m_start.deg).points;
  }

  std::shared_ptr<const gcode::Program> m_program;
  const templates::FlexibleProgram& m_meant;
  machine::Machine m_machine;
  FaultyLink m_link;
  RunSettings m_settings;
  base::AxisPosition m_start;
  base::Vec3 m_overlayMmMax;
  RunReport m_report;
};

std::string firstOf(std::string a, const std::string& b) {
  return a.empty() ? b : a;
}

/// Collects the cases.
class Prover {
 public:
  Prover(std::string_view text, const templates::FlexibleProgram& meant,
         machine::MachineConfig config)
      : m_text(text),
        m_meant(meant),
        m_parameters(meant.parameters),
        m_cells(meant.cells),
        m_config(std::move(config)) {
    m_config = withRotaryAxes(std::move(m_config), m_parameters.rotaryAxes);
    m_config.rParameterCount = m_parameters.rParameterCount;
    // The program itself has to take corrections back: this control keeps what lies over its axes.
    constexpr int kKeepsOverlay = 2;
    m_config.overlay.mode = kKeepsOverlay;
  }

  std::vector<ProofCase> run() {
    const bool isWindow = base::hasWindows(m_parameters.method);
    add("on-time", !m_meant.isForStudy, 2, {}, [](Trial& trial) {
      trial.run();
      return firstOf(trial.wrongMotion(), trial.notCompleted());
    });
    add("stop", true, 3, {}, [isWindow](Trial& trial) {
      const RunReport& report = trial.run(trial.motionTime() / 2);
      if (report.outcome != Outcome::Stopped || !report.stopConfirmedAfter) {
        return firstOf(trial.notCompleted(), "the stop was not confirmed");
      }
      if (trial.movesOn()) {
        return std::string("the axes move after a confirmed stop");
      }
      return isWindow ? trial.wrongMotion() : std::string();
    });
    LinkFaults late;
    late.stallProbability = 0.05;
    late.stallMax = std::chrono::seconds{8};
    late.delayProbability = 0.05;
    late.delayMax = std::chrono::seconds{3};
    // The methods of [P1] repeat what the client is too late to replace: they do not promise more.
    add("late-client", isWindow, 4, late, [](Trial& trial) {
      trial.run();
      return firstOf(trial.wrongMotion(), trial.notCompleted());
    });
    if (isWindow) {
      addWindowCases();
    }
    return std::move(m_cases);
  }

 private:
  /// A foreign hand on the cells as well: what is beyond the limit.
  void addCorrectionCase() {
    const templates::CellMap& cells = m_cells;
    add("correction", true, 3, {}, [&](Trial& trial) {
      std::size_t written = 0;
      trial.link().onTime = [&] {
        trial.watchOverlay();
        constexpr std::array<double, 4> kWrong{2.0, -3.0, 1e9, -1e300};
        if (m_turn > 0 && ++written % 40 == 0) {
          const double wrong = kWrong[written / 40 % kWrong.size()];
          for (const int cell : cells.correction) {
            if (cell >= 0) {
              trial.machine().writeRParameter(cell, m_parameters.correctionLimitMm * wrong);
            }
          }
        }
      };
      trial.run();
      std::string missing;
      for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
        if (cells.correction[axis] >= 0 &&
            trial.overlayMmMax()[axis] < 0.5 * m_parameters.correctionLimitMm) {
          missing = "a correction was requested, but the axes did not follow it";
        }
      }
      return firstOf(firstOf(trial.wrongMotion(), trial.notCompleted()), missing);
    });
  }

  void addWindowCases() {
    if (m_parameters.correctionLimitMm > 0.0) {
      addCorrectionCase();
    }
    LinkFaults bad;
    bad.delayProbability = 0.05;
    bad.delayMax = std::chrono::seconds{5};
    bad.lostRequestProbability = 0.02;
    bad.lostAnswerProbability = 0.02;
    bad.disconnectProbability = 0.01;
    bad.strayMax = std::chrono::seconds{10};
    add("bad-network", true, 4, bad, [](Trial& trial) {
      trial.run();
      trial.leaveAlone();
      return firstOf(trial.wrongMotion(),
                     trial.hasEnded() || trial.standsInWindow()
                         ? ""
                         : "the program neither ends nor stands without its client");
    });
    if (m_cells.files > 0) {
      addWrongFile(m_cells);
    } else {
      addDamagedWindow(m_cells);
    }
    add("client-gone", true, 2, {}, [this](Trial& trial) {
      const Instant goneAt = trial.machine().now() + trial.motionTime() / 2;
      // Once the connection breaks, once nothing comes through any more.
      trial.link().onTime = [this, &trial, goneAt] {
        if (trial.machine().now() >= goneAt) {
          LinkFaults gone;
          (m_turn == 0 ? gone.disconnectProbability : gone.lostRequestProbability) = 1.0;
          trial.link().setFaults(gone);
        }
      };
      trial.run();
      trial.leaveAlone();
      return firstOf(trial.wrongMotion(),
                     trial.hasEnded() || trial.standsInWindow()
                         ? ""
                         : "the program neither ends nor stands without its client");
    });
  }

  /// The file of the second window is that of another, an older one.
  void addWrongFile(const templates::CellMap& cells) {
    add("damaged-window", true, 1, {}, [&](Trial& trial) {
      bool isDone = false;
      trial.link().onWrite = [&](int written, double value, bool) {
        if (written == cells.delivered && value >= 2.0 && !isDone) {
          isDone = true;
          const std::string older = *trial.machine().programText(templates::windowFileName(0));
          const int second = cells.windows > 1 ? 1 : 0;
          const std::string other =
              cells.windows > 1 ? older : "M17\n";  // of one file the second is all there is
          static_cast<void>(
              trial.machine().storeProgram(templates::windowFileName(second), other, true));
        }
      };
      return refusal(trial);
    });
  }

  /// @return empty: it was refused, and nothing has moved wrongly
  static std::string refusal(Trial& trial) {
    const RunReport& report = trial.run();
    const bool isRefused = report.error.code == StreamError::WindowDamaged;
    return firstOf(trial.wrongMotion(),
                   isRefused ? "" : "a window that does not match its check number was taken");
  }

  void addDamagedWindow(const templates::CellMap& cells) {
    // One coordinate of the second window is changed behind the client's back. Each in its turn.
    const int first = cells.windows > 1 ? cells.pointsPerLoop : 0;
    std::vector<int> slot = cells.slotCells(first);
    if (cells.packed && cells.pointsPerLoop > 1) {
      slot.push_back(cells.slotCells(first + 1).front());
    }
    add("damaged-window", true, slot.size(), {}, [&](Trial& trial) {
      const int cell = slot[m_turn % slot.size()];
      bool isDone = false;
      trial.link().onWrite = [&, cell](int written, double value, bool) {
        if (written == cells.delivered && value >= 2.0 && !isDone) {
          isDone = true;
          trial.machine().writeRParameter(cell, trial.machine().rParameter(cell) + 0.25);
        }
      };
      return refusal(trial);
    });
  }

  template <class Try>
  void add(const char* name, bool isRequired, std::size_t runs, const LinkFaults& faults,
           Try attempt) {
    ProofCase result;
    result.name = name;
    result.isRequired = isRequired;
    result.runs = runs;
    for (m_turn = 0; m_turn < runs; ++m_turn) {
      Trial trial(m_text, m_meant, m_config, faults, m_turn + 1);
      const std::string failure = attempt(trial);
      if (!failure.empty()) {
        result.message = result.failures == 0 ? failure : result.message;
        ++result.failures;
      }
    }
    m_cases.push_back(std::move(result));
  }

  std::string_view m_text;
  const templates::FlexibleProgram& m_meant;
  const templates::TemplateParameters& m_parameters;
  const templates::CellMap& m_cells;
  machine::MachineConfig m_config;
  std::size_t m_turn = 0;
  std::vector<ProofCase> m_cases;
};

}  // namespace

bool TemplateProof::holds() const {
  return templates::firstError(findings) == nullptr && !cases.empty() &&
         std::all_of(cases.begin(), cases.end(),
                     [](const ProofCase& one) { return one.holds() || !one.isRequired; });
}

base::Result<TemplateProof> proveTemplate(std::string_view text,
                                          const templates::FlexibleProgram& meant,
                                          const machine::MachineConfig& machine) {
  if (meant.parameters.target != templates::TargetControl::Sinumerik) {
    return base::fail(templates::TemplateError::NotOnTarget,
                      "The virtual machine executes programs of a SINUMERIK only: this one cannot "
                      "be tried on it.");
  }
  TemplateProof proof;
  proof.findings = templates::lintProgram(text, meant);
  if (templates::firstError(proof.findings) == nullptr) {
    proof.cases = Prover(text, meant, machine).run();
  }
  return proof;
}

base::Result<void> requireProven(const templates::FlexibleProgram& program) {
  if (program.parameters.target != templates::TargetControl::Sinumerik) {
    return {};  // the virtual machine does not know the language: tests on LinuxCNC stand for it
  }
  const auto machine = machine::loadPreset(machine::kDefaultPreset);
  if (!machine) {
    return base::fail(machine.error());
  }
  const auto proof = proveTemplate(program.text, program, *machine);
  if (!proof) {
    return base::fail(proof.error());
  }
  if (!proof->holds()) {
    return base::fail(templates::LintError::Rejected,
                      "The flexible program for these settings failed on the virtual machine and "
                      "is not written to the control. See template --verify.");
  }
  return {};
}

}  // namespace rivulet::streaming
