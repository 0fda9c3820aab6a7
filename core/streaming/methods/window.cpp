// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/methods/window.h"

#include "opcua/await.h"
#include "streaming/methods/list_supplier.h"

namespace rivulet::streaming {

namespace {

using base::Duration;
using base::Instant;
using templates::WindowProtocol;

/// Time in addition to the planned one before all header cells are read to find out why there is no
/// progress.
constexpr Duration kLookInterval = std::chrono::milliseconds{250};
/// The control is asked for its progress this often: its cells change once per interpolation cycle.
constexpr Duration kWatchInterval = std::chrono::milliseconds{4};
/// The same while no progress can be expected.
constexpr Duration kIdleWatchInterval = std::chrono::milliseconds{20};
/// Standstill between windows, the pre-run's work on a window, and scatter.
constexpr Duration kSlowerThanPlanned = std::chrono::milliseconds{400};
/// The run cell is written again, whatever it is to be.
constexpr int kRunUnknown = -1;

std::unique_ptr<live::PointSupplier> listOf(MethodSetup& setup) {
  RIVULET_ASSERT(!setup.points.empty());
  return std::make_unique<ListSupplier>(std::move(setup.points),
                                        static_cast<std::size_t>(setup.cells.pointsPerLoop),
                                        windowCut(setup.settings));
}

}  // namespace

WindowedMethod::WindowedMethod(MethodSetup&& setup, bool saysExecuted)
    : m_list(setup.supplier == nullptr ? listOf(setup) : nullptr),
      m_supplier(m_list ? *m_list : *setup.supplier),
      m_plan(std::move(setup), &m_supplier.points()),
      m_slots(static_cast<std::size_t>(m_plan.cells().windows)),
      m_ownerCell{opcua::rParameter(m_plan.cells().owner)},
      m_watched{opcua::rParameter(m_plan.cells().latched)},
      m_header{opcua::rParameter(m_plan.cells().latched),
               opcua::rParameter(m_plan.cells().delivered), opcua::rParameter(m_plan.cells().owner),
               opcua::rParameter(m_plan.cells().state), opcua::rParameter(m_plan.cells().run)},
      m_saysExecuted(saysExecuted) {
  RIVULET_ASSERT(m_slots >= 1);
  RIVULET_ASSERT(m_plan.settings().runNumber > 0);
  m_timers.set(Timer::Look, Instant{});
  if (m_saysExecuted) {
    m_watched.push_back(opcua::rParameter(m_plan.cells().executed));
    m_header.push_back(opcua::rParameter(m_plan.cells().executed));
  }
  while (m_supplier.isComplete() && takeWindow({})) {
  }
}

std::size_t WindowedMethod::windowBegin(std::size_t window) const {
  return m_begins[std::min(window, m_windowCount)];
}

Duration WindowedMethod::windowTime(std::size_t window) const {
  const std::size_t begin = windowBegin(window);
  const std::size_t end = windowBegin(window + 1);
  if (end == begin) {
    return {};  // the supplier has had none yet
  }
  if (begin == 0) {
    return m_plan.approachTime() + m_plan.travelTime(0, std::max<std::size_t>(end, 1) - 1);
  }
  return m_plan.travelTime(begin - 1, end - 1);
}

Duration WindowedMethod::takenTime() const {
  return windowTime(m_latched == 0 ? 0 : m_latched - 1);
}

void WindowedMethod::expectTaken(Instant now) {
  m_progress.expected.set(Expectation::Progress, now + takenTimeMax() + kSlowerThanPlanned);
}

void WindowedMethod::estimateNeed() {
  m_progress.hasNothingToBring =
      m_delivered == m_filled && (m_filled == m_windowCount || m_filled >= freed() + m_slots);
  if (m_latched == 0) {
    return;  // nothing moves yet
  }
  Duration enough{};
  for (std::size_t window = m_executed; window < m_delivered; ++window) {
    enough += windowTime(window);
  }
  m_progress.expected.set(Expectation::Points, m_takenAt + enough);
}

Action WindowedMethod::write(Step step, std::size_t points) {
  m_step = step;
  m_waiting = true;
  return {Action::Kind::Write, {}, m_plan.writes(), points};
}

Action WindowedMethod::read(Step step, std::span<const opcua::Variable> variables) {
  m_step = step;
  m_waiting = true;
  return {Action::Kind::Read, variables, {}, 0};
}

std::optional<Action> WindowedMethod::watch(Step step, std::span<const opcua::Variable> variables,
                                            Instant now) {
  base::TimerTable<Expectation>& expected = m_progress.expected;
  if (expected.deadline(Expectation::Poll) && expected.isAhead(Expectation::Poll, now)) {
    return std::nullopt;
  }
  const bool isIdle =
      m_owned && expected.isAhead(Expectation::Access, now + 2 * kIdleWatchInterval);
  expected.set(Expectation::Poll, now + (isIdle ? kIdleWatchInterval : kWatchInterval));
  return read(step, variables);
}

int WindowedMethod::runWanted() const {
  if (m_stopWanted || m_endWanted) {
    return WindowProtocol::kEnd;
  }
  // The first windows are all there before anything moves: the start has the full margin. Points
  // that arrive meanwhile do not wait for others.
  const std::size_t first = m_supplier.isComplete() ? std::min(m_slots, m_windowCount) : 1;
  const bool filled = m_delivered >= first;
  return filled && !m_holdWanted ? WindowProtocol::kRun : WindowProtocol::kHold;
}

bool WindowedMethod::takeWindow(Instant now) {
  const std::optional<std::size_t> count = m_supplier.takeWindow(now);
  if (count) {
    m_plan.append(*count);
    m_begins.push_back(m_plan.pointCount());
    ++m_windowCount;
    m_isClosed = m_supplier.isDry();
  }
  return count.has_value();
}

void WindowedMethod::pullWindow(Instant now) {
  if (!isOpen() || !m_owned || m_stopWanted || m_filled < m_windowCount ||
      m_filled >= freed() + m_slots) {
    return;
  }
  if (!takeWindow(now) && m_supplier.isDry() && m_executed == m_windowCount) {
    // Windows that the control has not copied yet would not be executed after this.
    m_isClosed = m_endWanted = true;
  }
}

void WindowedMethod::tellSupplier(Instant now) {
  for (; m_begun < m_latched && m_begun <= m_executed; ++m_begun) {
    m_supplier.windowMoves(now);
  }
  m_supplier.executed(m_progress.executed);
}

std::optional<Action> WindowedMethod::pollContent() {
  if (m_filled > m_delivered || m_renumber) {
    m_plan.addCell(m_plan.cells().delivered, static_cast<double>(m_filled));
    return write(Step::Number);
  }
  if (m_filled < m_windowCount && m_filled < freed() + m_slots) {
    m_step = Step::Content;
    m_waiting = true;
    return bring(m_filled, windowBegin(m_filled + 1) - windowBegin(m_filled));
  }
  return std::nullopt;
}

std::optional<Action> WindowedMethod::poll(Instant now) {
  if (m_waiting || m_trouble != Trouble::None) {
    return std::nullopt;
  }
  m_plan.clearWrites();
  pullWindow(now);
  const templates::CellMap& cells = m_plan.cells();
  if (!m_owned && !m_stopWanted) {
    if (m_step == Step::Claim) {
      m_plan.addCell(cells.client, static_cast<double>(m_plan.settings().runNumber));
      return write(Step::Claim);
    }
    return watch(Step::AwaitOwner, m_ownerCell, now);
  }
  if (m_run != runWanted()) {
    m_runAsked = runWanted();
    m_plan.addCell(cells.run, m_runAsked);
    return write(Step::Run);
  }
  // After a stop nothing is delivered any more: so that no further points can be executed.
  if (!m_stopWanted && !m_endWanted) {
    if (std::optional<Action> action = pollContent()) {
      return action;
    }
  }
  if (!m_progress.expected.isAhead(Expectation::Progress, now) &&
      m_timers.isExpired(Timer::Look, now)) {
    m_timers.set(Timer::Look, now + kLookInterval);
    return read(Step::Look, m_header);
  }
  return watch(Step::Watch, m_watched, now);
}

bool WindowedMethod::answerLost(Instant) {
  // Whether it was carried out or not: `poll` repeats the request.
  m_waiting = false;
  if (m_step == Step::Run) {
    m_run = kRunUnknown;  // it may hold although it is to run again by now
  }
  return true;
}

void WindowedMethod::handle(const Answer& answer, Instant now) {
  RIVULET_ASSERT(m_waiting);
  m_waiting = false;
  switch (m_step) {
    case Step::Claim:
      m_step = Step::AwaitOwner;
      m_progress.lastProgress = now;
      m_progress.expected.set(Expectation::Access, now);
      m_progress.expected.set(Expectation::Progress, now + kSlowerThanPlanned);
      break;
    case Step::AwaitOwner:
      takeOwner(answer.readings[0].number, now);
      break;
    case Step::Content:
      ++m_filled;
      break;
    case Step::Number:
      confirmNumber(now);
      break;
    case Step::Run:
      confirmRun(now);
      break;
    case Step::Watch:
      observe(answer.readings[0].number,
              m_saysExecuted ? std::optional(answer.readings[1].number) : std::nullopt, answer,
              now);
      break;
    case Step::Look:
      look(answer, now);
      break;
  }
  m_progress.allSent = m_delivered == m_windowCount && !isOpen();
  estimateNeed();
}

void WindowedMethod::takeOwner(double owner, Instant now) {
  m_owned = owner == static_cast<double>(m_plan.settings().runNumber);
  if (m_owned) {
    m_progress.granted = true;
    m_progress.lastProgress = now;
    m_progress.expected.stop(Expectation::Progress);  // the client has to deliver the first windows
  } else if (owner != 0.0) {
    m_trouble = Trouble::OtherClient;
  } else if (!m_progress.expected.isAhead(Expectation::Progress, now)) {
    m_step = Step::Claim;  // it may have been overwritten meanwhile
  }
}

void WindowedMethod::confirmNumber(Instant now) {
  if (m_delivered < m_filled) {
    // The control copies pending windows at once, or after its present window.
    expectTaken(now);
  }
  m_delivered = m_filled;
  m_renumber = false;
  if (m_filled == m_windowCount || m_filled >= m_latched + m_slots) {
    // Until then there is nothing to deliver.
    m_progress.expected.set(Expectation::Access,
                            m_timers.deadline(Timer::WindowEnds).value_or(Instant{}));
  }
}

void WindowedMethod::confirmRun(Instant now) {
  m_run = m_runAsked;
  m_progress.lastProgress = now;
  m_progress.stopWritten = m_run == WindowProtocol::kEnd;
  const bool waitsForSource = isOpen() && m_executed == m_delivered;
  if (m_run == WindowProtocol::kHold || waitsForSource) {
    m_progress.expected.stop(Expectation::Progress);
  } else {
    // After a stop as well: the control continues to the end of the copied windows.
    expectTaken(now);
  }
}

void WindowedMethod::observe(double latched, std::optional<double> executed, const Answer& answer,
                             Instant now) {
  if (!(latched >= 0.0) || latched > static_cast<double>(m_delivered) ||
      latched < static_cast<double>(m_latched)) {
    // The program on the control never writes this value for this run: another client has written
    // the cell, or the program has been restarted. The header shows which.
    m_timers.set(Timer::Look, now);
    if (m_progress.expected.isAhead(Expectation::Progress, now)) {
      m_progress.expected.set(Expectation::Progress, now);
    }
    return;
  }
  const auto windows = static_cast<std::size_t>(latched);
  // When a window is copied, everything before it has been executed, unless the control reports the
  // executed windows itself; impossible values are ignored.
  std::size_t passed = windows == 0 ? 0 : windows - 1;
  if (executed) {
    const bool isMeant = *executed >= static_cast<double>(m_executed) && *executed <= latched;
    passed = isMeant ? static_cast<std::size_t>(*executed) : m_executed;
  }
  if (windows == m_latched && passed == m_executed) {
    return;
  }
  m_latched = windows;
  m_executed = passed;
  m_takenAt = answer.sent;
  m_progress.lastProgress = now;
  m_progress.executed = windowBegin(m_executed);
  m_progress.stopsPassed = stopsPassed();
  tellSupplier(now);
  const bool moreToBring = m_filled < m_windowCount && !m_stopWanted;
  const Instant windowEnds = answer.sent + takenTime();
  m_timers.set(Timer::WindowEnds, windowEnds);
  m_progress.expected.set(Expectation::Access, moreToBring ? now : windowEnds);
  if (isOpen() && m_executed == m_delivered) {
    // The machine waits for points.
    m_progress.expected.stop(Expectation::Progress);
    m_progress.expected.stop(Expectation::Access);
  } else if (m_run == WindowProtocol::kHold || (moreToBring && m_delivered == m_latched)) {
    m_progress.expected.stop(Expectation::Progress);  // the client has to deliver more, or go on
  } else {
    expectTaken(now);
  }
}

void WindowedMethod::look(const Answer& answer, Instant now) {
  const double owner = answer.readings[Owner].number;
  if (owner != static_cast<double>(m_plan.settings().runNumber)) {
    m_trouble = owner == 0.0 ? Trouble::Restarted : Trouble::OtherClient;
    return;
  }
  if (answer.readings[State].number != static_cast<double>(templates::WindowState::Runs)) {
    // The driver sees that the channel is in reset; nothing more is to be written.
    m_trouble = Trouble::Ended;
    m_progress.expected.stop(Expectation::Access);
    return;
  }
  // A late earlier write may have restored an old number or stop.
  m_renumber = m_owned && answer.readings[Delivered].number != static_cast<double>(m_delivered);
  // Not if somebody else has told the program to end.
  const double run = answer.readings[Run].number;
  if (run < WindowProtocol::kEnd && run != static_cast<double>(runWanted())) {
    m_run = kRunUnknown;
  }
  observe(answer.readings[Latched].number,
          m_saysExecuted ? std::optional(answer.readings[Executed].number) : std::nullopt, answer,
          now);
}

std::optional<base::Error> WindowedMethod::failure() const {
  switch (m_trouble) {
    case Trouble::OtherClient:
      return base::makeError(
          StreamError::OtherClient,
          "Another client is using the program on the control. Rivulet writes nothing more: wait "
          "until the other client has finished, or reset the control.");
    case Trouble::Restarted:
      return base::makeError(StreamError::Restarted,
                             "The program on the control has been restarted. It is waiting: reset "
                             "the control, then resume the run.");
    case Trouble::None:
    case Trouble::Ended:
      break;
  }
  return std::nullopt;
}

std::string_view WindowedMethod::adviceWhenLost() const {
  return "Without its client the program holds the axes where they are, at the latest when it has "
         "executed its windows; it repeats nothing. Connect again and resume the run, or reset the "
         "control.";
}

std::string_view WindowedMethod::adviceWhenStalled() const {
  return "The stream made no progress although the program was active: the control was on hold, "
         "something else writes the R-parameters of the run, or a value was changed on its way. "
         "Nothing was repeated. Release the hold, look for another client, or connect encrypted, "
         "then resume.";
}

/// Coordinates, number of points, feed, check: the same sum as on the control, term by term in the
/// same order, of what it moves to.
Action WindowMethod::bring(std::size_t window, std::size_t points) {
  const templates::CellMap& cells = m_plan.cells();
  const std::size_t begin = windowBegin(window);
  const std::size_t end = begin + points;
  const std::size_t slot = window % m_slots;
  const auto perWindow = static_cast<std::size_t>(cells.pointsPerLoop);
  const double count = (isLast(end) ? -1.0 : 1.0) * static_cast<double>(points);
  // With a feed in each point the window has none.
  const double feedMmPerMin = cells.feedPerPoint ? 0.0 : m_plan.feedMmPerMin(begin);
  RIVULET_ASSERT(cells.feedPerPoint || m_plan.feedMmPerMin(end - 1) == feedMmPerMin);
  double check = static_cast<double>(m_plan.settings().runNumber) +
                 WindowProtocol::kCheckNumber * static_cast<double>(window + 1) +
                 WindowProtocol::kCheckCount * count + WindowProtocol::kCheckFeed * feedMmPerMin;
  int place = 0;
  for (std::size_t i = 0; i < perWindow; ++i) {
    // A short window is filled up with its last point: the check covers every slot.
    const std::size_t point = std::min(begin + i, end - 1);
    if (cells.packed && i > 0) {
      m_plan.addPackedAt(slot * perWindow + i, point, begin);
    } else {
      m_plan.addPointAt(slot * perWindow + i, point);
    }
    m_plan.forEachTaken(
        begin, point, [&](double value) { check += WindowProtocol::checkFactor(place++) * value; });
  }
  const int windowCell = static_cast<int>(slot);
  m_plan.addCell(cells.windowCount(windowCell), count);
  m_plan.addCell(cells.windowFeed(windowCell), feedMmPerMin);
  m_plan.addCell(cells.windowCheck(windowCell), check);
  if (opcua::isArray(m_plan.settings().grouping)) {
    // As on the control: the window is one array.
    m_plan.lastToFront(WindowProtocol::WindowCells);
  }
  return {Action::Kind::Write, {}, m_plan.writes(), points};
}

std::unique_ptr<Method> WindowMethodType::make(MethodSetup setup) const {
  return std::make_unique<WindowMethod>(std::move(setup));
}

void WindowMethodType::complete(RunSettings& settings, std::uint64_t entropy) const {
  if (settings.runNumber == 0) {
    settings.runNumber = runNumberFrom(entropy);
  }
}

std::vector<std::size_t> WindowMethodType::pausesBefore(std::span<const gcode::StreamPoint> points,
                                                        std::size_t pointsPerLoop,
                                                        WindowCut cut) const {
  return cutWindows(points, pointsPerLoop, cut).begins;
}

std::optional<Checkpoint> WindowMethodType::checkpoint(const RunSettings& settings,
                                                       const Resume& from) const {
  Checkpoint checkpoint;
  checkpoint.runNumber = settings.runNumber;
  checkpoint.firstPoint = from.point;
  checkpoint.startMm = from.startMm;
  checkpoint.startDeg = from.startDeg;
  checkpoint.pausesPlaced = settings.placePauses;
  const WindowCut cut = windowCut(settings);
  checkpoint.windowSMax = cut.secondsMax;
  checkpoint.windowFeedMmPerS = cut.secondsMax > 0.0 ? cut.feedMmPerS : 0.0;
  return checkpoint;
}

std::optional<ProgramEnd> WindowMethodType::askEnd(
    opcua::Link& link, const templates::CellMap& cells, const RunSettings& settings,
    std::span<const gcode::StreamPoint> points) const {
  const std::array<opcua::Variable, 3> watched{opcua::rParameter(cells.state),
                                               opcua::rParameter(cells.executed),
                                               opcua::rParameter(cells.owner)};
  ProgramEnd end;
  const auto numbers = opcua::readNumbers(link, watched, settings.setupDeadline);
  if (!numbers) {
    end.error = base::makeError(StreamError::EndedEarly,
                                "The program on the control has ended, but the reason could not be "
                                "read. Resume the run to check it again.");
    return end;
  }
  end.isKnown = true;
  const auto state = static_cast<templates::WindowState>((*numbers)[0]);
  const double executed = (*numbers)[1];
  if ((*numbers)[2] == 0.0) {
    return end;  // it was ended before it obeyed any run
  }
  if ((*numbers)[2] != static_cast<double>(settings.runNumber)) {
    end.error = base::makeError(StreamError::Restarted,
                                "The program on the control has been started for another run. "
                                "Rivulet writes nothing more.");
    return end;
  }
  if (executed >= 0.0) {
    end.windows = static_cast<std::size_t>(executed);
  }
  if (executed >= 0.0 && !points.empty()) {
    const auto perWindow = static_cast<std::size_t>(cells.pointsPerLoop);
    const PausePlacement placement = cutWindows(points, perWindow, windowCut(settings));
    end.executed = executed < static_cast<double>(placement.windows())
                       ? placement.begins[static_cast<std::size_t>(executed)]
                       : points.size();
  }
  end.isDone = state == templates::WindowState::Done;
  end.isStopped = state == templates::WindowState::Stopped;
  if (state == templates::WindowState::Damaged) {
    end.error = base::makeError(
        StreamError::WindowDamaged,
        "The control rejected a window whose check number did not match: something else writes "
        "these R-parameters, or a value was changed on its way. The window was not executed. Look "
        "for another client, or connect encrypted, then resume.");
  } else if (state == templates::WindowState::Abandoned) {
    end.error = base::makeError(
        StreamError::ClientSilent,
        "The control ended its program because it received nothing from Rivulet for too long. "
        "Check the network, then resume.");
  }
  return end;
}

}  // namespace rivulet::streaming
