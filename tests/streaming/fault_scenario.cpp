// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fault_scenario.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "base/packing.h"
#include "base/units.h"
#include "machine/braking.h"
#include "streaming/recovery/resume.h"
#include "streaming/run/job.h"
#include "streaming/start/stop_bound.h"
#include "templates/flexible_program.h"

namespace rivulet::streaming {

namespace {

using base::Duration;
using base::Instant;
using base::MethodKind;
using base::Random;

constexpr int kAttemptsMax = 2000;
/// Some windows at a slow feed, then the 1000 passes after which the program stops waiting for the
/// client.
constexpr Duration kAloneMax = std::chrono::minutes{30};
/// A program that waits for its client ends before that.
constexpr Duration kHeldMin = std::chrono::minutes{2};
/// Long enough to see whether something moves that must not.
constexpr Duration kWatched = std::chrono::seconds{30};
constexpr double kStillMm = 1e-9;
constexpr double kSlowPercent = 20.0;

/// The operator's requests, and a limit so that every attempt ends.
class Operator final : public RunSink, public RunOrders {
 public:
  std::optional<Instant> stopAt;
  std::optional<Instant> holdAt;
  Instant holdUntil{};
  std::vector<std::pair<Instant, FeedOrder>> orders;
  void update(const LiveUpdate& update) override {
    // Whoever sees that somebody else has changed the override sets it again.
    if (update.feed && update.feed->isForeign && update.at >= m_correctedAt + kCorrects) {
      m_correctedAt = update.at;
      m_percent = m_percent < 100.0 ? 100.0 : 99.0;
    }
  }
  FeedOrder feed(Instant now) override {
    FeedOrder order{false, m_percent};
    for (const auto& [at, ordered] : orders) {
      if (now >= at) {
        order = {ordered.holds, std::min(ordered.percent, m_percent)};
      }
    }
    order.holds = order.holds || holdRequested(now);
    return order;
  }
  void access(const trace::Access&) override {}
  void note(const trace::Note&) override {}
  bool stopRequested(Instant now) override { return stopAt && now >= *stopAt; }
  bool holdRequested(Instant now) override { return holdAt && now >= *holdAt && now < holdUntil; }

 private:
  static constexpr Duration kCorrects = std::chrono::seconds{5};
  double m_percent = 100.0;
  Instant m_correctedAt{};
};

double wayOf(const gcode::Program& program) {
  const std::vector<gcode::StreamPoint> points = gcode::streamPoints(program.trajectory, {}).points;
  double way = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    way += base::wayAlongFeed(base::distance(points[i - 1].positionMm, points[i].positionMm),
                              base::turnDeg(points[i - 1].rotaryDeg, points[i].rotaryDeg));
  }
  return way;
}

/// One or two rotary axes beside X, Y and Z; now and then only they turn, or none of them.
void addRotaryAxes(FaultScenario& drawn, Random random) {
  constexpr double kReachDeg = 100.0;
  base::RotarySet axes{};
  axes[random.below(axes.size())] = true;
  axes[random.below(axes.size())] = true;
  const double stepDeg = 0.01 * std::pow(1000.0, random.uniform());
  std::vector<base::RotaryDeg> angles;
  base::RotaryDeg at{};
  for (std::size_t i = 0; i < drawn.run.pointsMm.size(); ++i) {
    const std::uint64_t kind = random.below(6);
    if (kind == 0 && i > 0) {
      drawn.run.pointsMm[i] = drawn.run.pointsMm[i - 1];
    }
    for (double& angle : at) {
      angle =
          kind == 1 ? angle : std::clamp(angle + stepDeg * random.normal(), -kReachDeg, kReachDeg);
    }
    angles.push_back(at);
  }
  Scenario& scenario = drawn.run.scenario;
  scenario.program = programOf(drawn.run.pointsMm, angles, axes);
  scenario.machine = withRotaryAxes(scenario.machine, axes);
  scenario.settings.parameters.rotaryAxes = axes;
}

/// One scenario, step by step.
class Exposure {
 public:
  explicit Exposure(const FaultScenario& scenario)
      : m_scenario(scenario),
        m_settings(scenario.run.scenario.settings),
        m_machine(scenario.run.scenario.machine, scenario.run.scenario.seed),
        m_link(m_machine, scenario.faults, Random(scenario.run.scenario.seed).fork(31).bits()),
        m_random(Random(scenario.run.scenario.seed).fork(32)),
        m_cells(templates::makeProgram(m_settings.parameters)->cells),
        m_isWindow(base::hasWindows(m_settings.parameters.method)) {}

  FaultEvidence run() {
    m_link.onWrite = [this](int cell, double value, bool stray) { seeWrite(cell, value, stray); };
    m_link.onTime = [this] { actUpon(); };
    m_link.onCycleStart = [this] { takeSegment(); };
    if (m_scenario.wrongProgram) {
      m_link.programInstead = otherProgram();
    }
    for (int attempt = 0; attempt < kAttemptsMax; ++attempt) {
      const RunReport& report = attemptOnce(attempt == 0);
      leaveAlone(report);
      if (!m_isWindow || !m_scenario.resumes || report.outcome == Outcome::Completed ||
          !m_evidence.violations.empty()) {
        break;
      }
      m_link.programInstead.clear();
      if (!findResume()) {
        break;
      }
    }
    takeSegment();
    return std::move(m_evidence);
  }

 private:
  const RunReport& attemptOnce(bool first) {
    m_startedAt = m_machine.now();
    Operator orders;
    orders.stopAt = m_startedAt + m_scenario.run.scenario.limit;
    if (first && m_scenario.stopAfter) {
      orders.stopAt = m_startedAt + *m_scenario.stopAfter;
    }
    if (first && m_scenario.holdAfter) {
      orders.holdAt = m_startedAt + *m_scenario.holdAfter;
      orders.holdUntil = *orders.holdAt + m_scenario.holdFor;
    }
    for (const FaultScenario::Order& each : m_scenario.orders) {
      orders.orders.emplace_back(m_startedAt + each.after, each.order);
    }
    if (first && m_scenario.resetAfter) {
      m_resetAt = m_startedAt + *m_scenario.resetAfter;
    }
    if (first && m_scenario.intruderAfter) {
      m_intrusionAt = m_startedAt + *m_scenario.intruderAfter;
    }
    m_evidence.reports.push_back(
        runJob(m_link, m_link, *m_scenario.run.scenario.program, m_settings, orders, orders));
    if (m_evidence.reports.back().checkpoint) {
      m_checkpoint = m_evidence.reports.back().checkpoint;
      m_checkpointSettings = m_evidence.reports.back().settings;
    }
    return m_evidence.reports.back();
  }

  [[nodiscard]] double overrideActs() const { return m_machine.ncRParameter(m_cells.overrideActs); }
  /// Held, or as good as held by a value that was falsified on its way; or without a client.
  [[nodiscard]] bool isSlow() const {
    return m_cells.hasFeedCell() && m_machine.state().channel != machine::ChannelStatus::Reset &&
           overrideActs() < kSlowPercent;
  }
  /// Nothing but another client lets it go on: one that is gone has said so.
  [[nodiscard]] bool isOrderedSlow() const {
    if (!isSlow()) {
      return false;
    }
    const double wanted = m_machine.ncRParameter(m_cells.overrideWanted);
    return !(wanted >= kSlowPercent && wanted <= templates::FeedCell::kMax);
  }

  /// The client is gone; nobody touches the machine. Delivered windows may still be executed; then
  /// the axes stop, and the channel goes to reset by itself. Axes that the client has held stay
  /// where they are, until an operator resets the control; those that stand because it is gone go
  /// on when the run is resumed.
  void leaveAlone(const RunReport& report) {
    m_intrusionAt.reset();
    if (!m_isWindow ||
        (m_scenario.hurries && report.error.code == opcua::LinkError::ConnectionLost)) {
      return;
    }
    const bool stopped = report.outcome == Outcome::Stopped && report.stopConfirmedAfter;
    if (stopped) {
      watchStanding("after a confirmed stop");
    }
    // A client that has lost the connection sends nothing more; requests in transit still arrive.
    if (m_link.isConnected() && report.outcome != Outcome::Stopped &&
        m_machine.state().channel != machine::ChannelStatus::Reset) {
      m_link.reconnect();
    }
    const Instant until = m_machine.now() + kAloneMax;
    Instant slowSince = m_machine.now();
    while (m_machine.now() < until && m_machine.state().channel != machine::ChannelStatus::Reset) {
      if (report.error.code == StreamError::WrongProgram) {
        break;  // it is not ours: an operator has to reset it
      }
      m_link.wait(m_machine.now() + std::chrono::milliseconds{200});
      slowSince = isSlow() ? slowSince : m_machine.now();
      // A program that waits for its client ends before that, and no late request lets it go on.
      if (m_machine.now() - slowSince > kHeldMin) {
        break;
      }
    }
    if (m_machine.state().channel != machine::ChannelStatus::Reset && isSlow()) {
      if (overrideActs() == templates::FeedCell::kHold) {
        watchStanding("while held");
      }
      if (m_scenario.resumes && !isOrderedSlow() && m_checkpoint) {
        return;
      }
      reset();
      m_link.wait(m_machine.now() + std::chrono::seconds{2});
    }
    if (m_machine.state().channel != machine::ChannelStatus::Reset) {
      if (report.error.code != StreamError::WrongProgram) {
        m_evidence.endedByItself = false;
      }
      m_machine.reset();
      m_link.wait(m_machine.now() + std::chrono::seconds{2});
    }
    watchStanding("in reset");
  }

  void reset() {
    m_wasReset = m_wasReset || m_machine.state().channel != machine::ChannelStatus::Reset;
    m_evidence.wasResetWhileHeld = m_evidence.wasResetWhileHeld || isOrderedSlow();
    m_machine.reset();
  }

  void watchStanding(const char* where) {
    // The servo settles first.
    m_machine.advance(m_machine.now() + std::chrono::seconds{1});
    const std::size_t blocks = m_machine.trace().blocks.size();
    const machine::MachineState before = m_machine.state();
    m_link.wait(m_machine.now() + kWatched);
    if (m_machine.trace().blocks.size() != blocks ||
        base::distance(before.commandMm, m_machine.state().commandMm) > kStillMm ||
        base::turnDeg(before.commandDeg, m_machine.state().commandDeg) > kStillMm) {
      m_evidence.violations.push_back(fmt::format("motion {}", where));
    }
  }

  /// The operator connects again and asks the control, until it answers.
  /// @return false if there is nothing to resume
  bool findResume() {
    if (!m_checkpoint) {
      // Nothing has been streamed: from the beginning.
      m_link.reconnect();
      return true;
    }
    for (int question = 0; question < kAttemptsMax; ++question) {
      m_link.reconnect();
      const auto ask = [this](ActiveProgram active) {
        return resumeFrom(m_link, *m_scenario.run.scenario.program, m_checkpointSettings,
                          *m_checkpoint, {}, active);
      };
      // What is foreseen while the program stands comes, unless it is reset or a window arrives
      // late.
      const auto copied = [this] { return m_machine.ncRParameter(m_cells.latched); };
      const double copiedThen = copied();  // a program that is just copying goes on meanwhile
      const base::Result<Resume> foreseen = ask(ActiveProgram::Stays);
      const bool wasReset = std::exchange(m_wasReset, false);
      const base::Result<Resume> resume = ask(ActiveProgram::IsEnded);
      const bool isUndisturbed = copied() == copiedThen && !m_wasReset;
      m_wasReset = m_wasReset || wasReset;
      if (foreseen && resume && isUndisturbed && foreseen->point != resume->point) {
        m_evidence.violations.push_back(fmt::format("resumed at point {}, foreseen at {}",
                                                    resume->point + 1, foreseen->point + 1));
      }
      if (resume) {
        m_settings.resume = *resume;
        m_settings.runNumber = 0;
        return true;
      }
      if (resume.error().code == StreamError::CannotResume) {
        return false;
      }
      // A program without a client ends by itself after a while, unless the axes are held. What
      // does not know our run any more ends with a reset only.
      const bool isUnknown = resume.error().code == StreamError::ChannelBusy;
      if (isOrderedSlow() || (isSlow() && isUnknown)) {
        reset();
      }
      m_link.wait(m_machine.now() + std::chrono::seconds{5});
    }
    return false;
  }

  void takeSegment() {
    lookForWindowsBehindStop();
    FaultSegment segment;
    segment.trace = m_machine.trace();
    lookForMotionInSilence(segment.trace);
    segment.endMm = m_machine.state().commandMm;
    segment.endDeg = m_machine.state().commandDeg;
    segment.wasReset = m_wasReset;
    m_wasReset = false;
    m_delivered = 0;
    m_evidence.segments.push_back(std::move(segment));
  }

  /// After a stop no window is copied any more, except one that the program was just reading. (A
  /// control that does not read cells when it passes a block sees the stop later.)
  void lookForWindowsBehindStop() {
    const bool reads =
        m_scenario.run.scenario.machine.rRead == machine::RParameterReading::AtInterpretation;
    if (m_latchedAtStop && reads && m_evidence.intrusions == 0 && m_evidence.strayWrites == 0 &&
        m_machine.ncRParameter(m_cells.latched) > *m_latchedAtStop + 1.0) {
      m_evidence.violations.emplace_back("a window was taken after a stop");
    }
    m_latchedAtStop.reset();
  }

  /// A client that has been silent for the limit holds the axes, wherever the program is.
  void lookForMotionInSilence(const trace::ControlTrace& trace) {
    const double limitS = m_settings.parameters.silenceLimitS;
    if (!m_isWindow || !m_cells.hasFeedCell() || limitS <= 0.0 || m_evidence.intrusions > 0 ||
        m_scenario.wrongProgram) {
      return;
    }
    auto beat = m_beats.begin();
    // What an earlier program has left in the cell counts as a sign when the next one starts.
    Instant last = std::exchange(m_segmentFrom, m_machine.now());
    double fastest = 0.0;  // since the sign
    for (const trace::ControlSample& sample : trace.samples) {
      for (; beat != m_beats.end() && *beat <= sample.at + trace.cycle; ++beat) {
        last = std::max(last, *beat);
        fastest = 0.0;
      }
      fastest = std::max(fastest, sample.feedMmPerS);
      const Duration due = base::fromSeconds(limitS) +
                           2 * machine::brakingTime(m_scenario.run.scenario.machine, fastest) +
                           4 * trace.cycle;
      if (sample.feedMmPerS > 0.0 && sample.at > last + due) {
        m_evidence.violations.push_back(
            fmt::format("motion {:.3f} s after the last sign of the client",
                        base::toSeconds(sample.at - last)));
        return;
      }
    }
  }

  /// A window's cells must not be written between its number and the control's copy.
  void seeWrite(int cell, double value, bool stray) {
    m_evidence.strayWrites += stray ? 1 : 0;
    if (cell == m_cells.heartbeat && value != m_beat) {
      m_beat = value;
      m_beats.push_back(m_machine.now());
    }
    if (m_isWindow && !stray && cell == m_cells.delivered) {
      m_delivered = static_cast<long long>(value);
    }
    if (m_isWindow && !stray && cell == m_cells.run && value > 1.0 && !m_latchedAtStop) {
      m_latchedAtStop = m_machine.ncRParameter(m_cells.latched);
    }
    if (!m_isWindow || stray || cell < m_cells.windowCount(0)) {
      return;
    }
    if (m_evidence.intrusions > 0) {
      return;  // the numbers are no longer those of our run
    }
    const int window = (cell - m_cells.windowCount(0)) / m_cells.windowStride;
    const auto latched = static_cast<long long>(m_machine.ncRParameter(m_cells.latched));
    for (long long number = latched + 1; number <= m_delivered; ++number) {
      if ((number - 1) % m_cells.windows == window) {
        m_evidence.violations.push_back(
            fmt::format("R{} written while window {} waits to be copied", cell, number));
      }
    }
  }

  void actUpon() {
    if (m_resetAt && m_machine.now() >= *m_resetAt) {
      m_resetAt.reset();
      reset();
    }
    if (m_intrusionAt && m_machine.now() >= *m_intrusionAt) {
      m_intrusionAt = m_machine.now() + base::fromSeconds(3.0 * m_random.exponential());
      intrude();
    }
  }

  /// Another client writes cells that it considers its own: numbers, content, whole windows.
  void intrude() {
    ++m_evidence.intrusions;
    const int first = m_cells.run;
    const int last = m_cells.last();
    const auto any = [&] {
      return first + static_cast<int>(m_random.below(static_cast<std::uint64_t>(last - first + 1)));
    };
    switch (m_random.below(4)) {
      case 0:  // one cell, a plausible whole number
        m_machine.writeRParameter(any(), static_cast<double>(m_random.below(20)));
        break;
      case 1:  // one cell, a coordinate
        m_machine.writeRParameter(any(), 40.0 * m_random.normal());
        break;
      case 2: {  // the content of a window
        const int cell = any();
        for (int i = cell; i <= std::min(last, cell + m_cells.windowStride); ++i) {
          m_machine.writeRParameter(i, 20.0 * m_random.normal());
        }
        break;
      }
      default:  // the header, as for starting a program of [P1]
        for (int i = 0; i < 5; ++i) {
          m_machine.writeRParameter(first + i, i == 1 ? 1.0 : 0.0);
        }
        break;
    }
  }

  /// An older generator, or other settings under the same name.
  std::string otherProgram() {
    templates::TemplateParameters parameters = m_settings.parameters;
    if (m_random.below(2) == 0) {
      std::string text = templates::makeProgram(parameters)->text;
      const std::string number =
          fmt::format("={}\n", templates::makeProgram(parameters)->layoutNumber);
      const std::size_t at = text.find(number);
      return text.replace(at, number.size(), "=17\n");
    }
    ++parameters.pointsPerLoop;
    parameters.rParameterCount += 100;
    return templates::makeProgram(parameters)->text;
  }

  const FaultScenario& m_scenario;
  RunSettings m_settings;
  machine::Machine m_machine;
  FaultyLink m_link;
  Random m_random;
  templates::CellMap m_cells;
  bool m_isWindow;
  bool m_wasReset = false;
  long long m_delivered = 0;  ///< windows, as the client of this connection has said
  std::optional<double>
      m_latchedAtStop;  ///< windows that the control had when it was commanded to end
  Instant m_startedAt{};
  std::optional<Instant> m_resetAt;
  std::optional<Instant> m_intrusionAt;
  std::vector<Instant> m_beats;  ///< signs of the client, ascending
  Instant m_segmentFrom{};       ///< when the program was started
  double m_beat = 0.0;           ///< the last one
  std::optional<Checkpoint> m_checkpoint;
  RunSettings m_checkpointSettings;
  FaultEvidence m_evidence;
};

}  // namespace

/// The points of some runs share cells. They lie on whole steps then.
void packSome(FaultScenario& drawn, std::uint64_t seed) {
  RunSettings& settings = drawn.run.scenario.settings;
  const bool fits = base::fillsWindows(settings.parameters.method) &&
                    settings.parameters.slotStride == 0 &&
                    !base::any(settings.parameters.rotaryAxes);
  if (!fits || Random(seed).fork(36).below(2) == 0) {
    return;
  }
  std::vector<base::Vec3> points;
  for (const base::Vec3 mm : drawn.run.pointsMm) {
    points.push_back(
        {base::Packing::rounded(mm.x), base::Packing::rounded(mm.y), base::Packing::rounded(mm.z)});
    if (points.size() > 1 && points[points.size() - 2] == points.back()) {
      return;  // refused by name
    }
  }
  drawn.run.pointsMm = std::move(points);
  drawn.run.scenario.program = programOf(drawn.run.pointsMm);
  settings.parameters.packed = true;
}

/// Some runs have a tolerance, and points on and near their moves that fall within it.
void mergeSome(FaultScenario& drawn, std::uint64_t seed) {
  constexpr double kShortMm = 0.05;
  RunSettings& settings = drawn.run.scenario.settings;
  Random random = Random(seed).fork(37);
  if (random.below(2) == 0) {
    return;
  }
  settings.tolerance = 0.002 * std::pow(50.0, random.uniform());
  gcode::Program program = *drawn.run.scenario.program;
  const gcode::Trajectory coarse = std::move(program.trajectory);
  gcode::Trajectory& dense = program.trajectory;
  dense = {};
  for (std::size_t i = 0; i < coarse.points.size(); ++i) {
    const gcode::TrajectoryPoint& to = coarse.points[i];
    const bool isLong =
        i > 0 && base::distance(coarse.points[i - 1].positionMm, to.positionMm) > kShortMm;
    const auto parts = isLong ? 1 + random.below(8) : 1;
    for (std::uint64_t part = 1; part <= parts; ++part) {
      const double share = static_cast<double>(part) / static_cast<double>(parts);
      dense.points.push_back(to);
      if (!coarse.rotary.empty()) {
        dense.rotary.push_back(coarse.rotary[i]);
      }
      if (part == parts) {
        continue;
      }
      for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
        const double from = coarse.points[i - 1].positionMm[axis];
        const double at = from + share * (to.positionMm[axis] - from) +
                          settings.tolerance * (random.uniform() - 0.5);
        dense.points.back().positionMm.set(
            axis, settings.parameters.packed ? base::Packing::rounded(at) : at);
      }
      for (std::size_t axis = 0; !coarse.rotary.empty() && axis < base::kRotaryAxisCount; ++axis) {
        const double from = coarse.rotary[i - 1].degrees[axis];
        dense.rotary.back().degrees[axis] = from + share * (coarse.rotary[i].degrees[axis] - from);
      }
    }
  }
  drawn.whole = dense;
  if (!gcode::applyRules(program, moveRules(settings))) {
    std::abort();
  }
  drawn.run.scenario.program = std::make_shared<const gcode::Program>(std::move(program));
}

FaultScenario drawFaults(std::uint64_t seed, const machine::MachineConfig& preset,
                         MethodKind method) {
  FaultScenario drawn;
  drawn.run = drawScenario(seed, preset);
  Random random = Random(seed).fork(30);
  Scenario& scenario = drawn.run.scenario;
  scenario.machine.rParameterCount = 300;
  RunSettings& settings = scenario.settings;
  settings.parameters.method = method;
  settings.parameters.rParameterCount = 300;
  settings.isCommissioned = true;
  if (base::hasWindows(method)) {
    Random axesRandom = Random(seed).fork(34);
    if (method != MethodKind::Credit && axesRandom.below(3) == 0) {
      addRotaryAxes(drawn, axesRandom);
    }
    settings.parameters.pointsPerLoop = 1 + static_cast<int>(random.below(14));
    settings.parameters.windows = 1 + static_cast<int>(random.below(4));
    settings.parameters.baseCell = random.below(3) == 0 ? static_cast<int>(random.below(40)) : 0;
    settings.parameters.slotStride = random.below(4) == 0 ? 5 : 0;
    packSome(drawn, seed);
    mergeSome(drawn, seed);
    settings.parameters.pointsPerLoop = std::min(settings.parameters.pointsPerLoop,
                                                 templates::pointsPerLoopMax(settings.parameters));
  }
  if (method == MethodKind::Credit) {
    Random ofItsOwn = Random(seed).fork(33);  // the other methods keep their draws
    settings.parameters.windowsAhead = 1 + static_cast<int>(ofItsOwn.below(8));
    settings.parameters.slowDown = ofItsOwn.below(4) != 0;
  }
  settings.stallDeadline = std::chrono::seconds{120};
  settings.stopDeadline = std::chrono::seconds{120};
  settings.requestDeadline = base::fromSeconds(0.5 + 3.0 * random.uniform());
  scenario.limit = std::chrono::hours{1};

  const double motionS = wayOf(*scenario.program) / settings.feedMmPerS;
  const double lastsS = 2.0 + motionS +
                        0.07 * static_cast<double>(drawn.run.pointsMm.size()) /
                            std::max(1, settings.parameters.pointsPerLoop) * 3.0;
  const auto sometime = [&] { return base::fromSeconds(lastsS * random.uniform()); };
  LinkFaults& faults = drawn.faults;
  const auto often = [&](std::uint64_t of, double most) {
    return random.below(of) == 0 ? most * random.uniform() : 0.0;
  };
  faults.delayProbability = often(2, 0.05);
  faults.delayMax = base::fromSeconds(10.0 * random.uniform());
  faults.lostRequestProbability = often(3, 0.03);
  faults.lostAnswerProbability = often(3, 0.03);
  faults.stallProbability = often(3, 0.02);
  faults.stallMax = base::fromSeconds(10.0 * random.uniform());
  faults.disconnectProbability = often(3, 0.02);
  faults.strayMax = random.below(3) == 0 ? Duration{} : base::fromSeconds(20.0 * random.uniform());
  if (random.below(4) == 0) {
    drawn.stopAfter = sometime();
  }
  if (random.below(5) == 0) {
    drawn.holdAfter = sometime();
    drawn.holdFor = base::fromSeconds(60.0 * random.uniform());
  }
  if (random.below(5) == 0) {
    drawn.resetAfter = sometime();
  }
  if (random.below(6) == 0) {
    drawn.intruderAfter = sometime();
  }
  drawn.wrongProgram = random.below(25) == 0;
  drawn.resumes = random.below(5) != 0;
  drawn.hurries = random.below(2) == 0;
  Random ofOrders = Random(seed).fork(35);  // the others keep their draws
  if (base::hasWindows(method) && ofOrders.below(2) == 0) {
    double atS = 0.0;
    for (std::uint64_t left = 1 + ofOrders.below(8); left > 0; --left) {
      atS += lastsS * ofOrders.uniform() / 4.0;
      const bool holds = ofOrders.below(2) == 0;
      drawn.orders.push_back({base::fromSeconds(atS), {holds, 5.0 + 115.0 * ofOrders.uniform()}});
      atS += holds ? 4.0 * ofOrders.uniform() : 0.0;
    }
    drawn.orders.push_back({base::fromSeconds(atS), {false, 100.0}});
  }
  return drawn;
}

FaultEvidence expose(const FaultScenario& scenario) {
  return Exposure(scenario).run();
}

}  // namespace rivulet::streaming
