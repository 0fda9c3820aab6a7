// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/methods/window.h"

#include "templates/generator.h"

namespace rivulet::streaming {

namespace {

using base::Duration;
using base::Instant;

/// Values of the run cell.
constexpr double kHold = 0.0;
constexpr double kRun = 1.0;
constexpr double kEnd = 2.0;

/// Between signs of life. The program gives up after 20 s without one, at the earliest.
constexpr Duration kBeatInterval = std::chrono::seconds{1};
/// Beyond the time planned, before all header cells are read to see why nothing goes on.
constexpr Duration kLookInterval = std::chrono::milliseconds{250};
/// Stand-still between windows, the pre-run's work on a window, and scatter.
constexpr Duration kSlowerThanPlanned = std::chrono::milliseconds{400};
/// No progress is expected while the client itself has something to bring.
constexpr Duration kOurTurn = std::chrono::hours{1};

}  // namespace

WindowMethod::WindowMethod(MethodSetup setup)
    : m_plan(std::move(setup)),
      m_perWindow(static_cast<std::size_t>(m_plan.cells().pointsPerLoop)),
      m_slots(static_cast<std::size_t>(m_plan.cells().windows)),
      m_begins(m_plan.windowBegins(m_perWindow)),
      m_windowCount(m_begins.size() - 1),
      m_ownerCell{opcua::rParameter(m_plan.cells().owner)},
      m_saysExecuted(m_plan.settings().parameters.method != base::MethodKind::Window),
      m_isCredit(m_plan.settings().parameters.method == base::MethodKind::Credit),
      m_watched{opcua::rParameter(m_plan.cells().latched)},
      m_header{opcua::rParameter(m_plan.cells().latched),
               opcua::rParameter(m_plan.cells().delivered), opcua::rParameter(m_plan.cells().owner),
               opcua::rParameter(m_plan.cells().state), opcua::rParameter(m_plan.cells().run)} {
  RIVULET_ASSERT(m_slots >= 1);
  RIVULET_ASSERT(m_plan.settings().runNumber > 0);
  if (m_saysExecuted) {
    m_watched.push_back(opcua::rParameter(m_plan.cells().executed));
    m_header.push_back(opcua::rParameter(m_plan.cells().executed));
  }
}

std::size_t WindowMethod::windowBegin(std::size_t window) const {
  return m_begins[std::min(window, m_windowCount)];
}

Duration WindowMethod::windowTime(std::size_t window) const {
  const std::size_t begin = windowBegin(window);
  const std::size_t end = windowBegin(window + 1);
  if (begin == 0) {
    return m_plan.approachTime() + m_plan.travelTime(0, std::max<std::size_t>(end, 1) - 1);
  }
  return m_plan.travelTime(begin - 1, end - 1);
}

Duration WindowMethod::takenTime() const {
  if (!m_isCredit) {
    return windowTime(m_latched == 0 ? 0 : m_latched - 1);
  }
  Duration sum{};
  for (std::size_t window = m_executed; window < std::max(m_latched, m_executed + 1); ++window) {
    sum += windowTime(window);
  }
  return sum;
}

void WindowMethod::reckonNeed() {
  const std::size_t freed = m_plan.cells().inFiles ? m_executed : m_latched;
  m_progress.hasNothingToBring =
      m_delivered == m_filled && (m_filled == m_windowCount || m_filled >= freed + m_slots);
  if (m_latched == 0) {
    return;  // nothing moves yet
  }
  Duration enough{};
  for (std::size_t window = m_executed; window < m_delivered; ++window) {
    enough += windowTime(window);
  }
  m_progress.neededAt = m_takenAt + enough;
}

Duration WindowMethod::takenTimeMax() const {
  const bool slows = m_isCredit && m_plan.settings().parameters.slowDown;
  return slows ? takenTime() * 100 / templates::kCreditSlowPercent : takenTime();
}

Action WindowMethod::write(Step step, std::size_t points) {
  m_step = step;
  m_waiting = true;
  return {Action::Kind::Write, {}, m_plan.writes(), points};
}

Action WindowMethod::read(Step step, std::span<const opcua::Variable> variables) {
  m_step = step;
  m_waiting = true;
  return {Action::Kind::Read, variables, {}, 0};
}

/// Coordinates, number of points, feed, check: what the control adds up is added up here, term by
/// term in the same order.
void WindowMethod::addContent(std::size_t window) {
  const templates::CellMap& cells = m_plan.cells();
  const std::size_t begin = windowBegin(window);
  const std::size_t end = windowBegin(window + 1);
  const std::size_t slot = window % m_slots;
  const double count = (end == m_plan.pointCount() ? -1.0 : 1.0) * static_cast<double>(end - begin);
  const double feedMmPerMin = base::mmPerMinFromMmPerS(m_plan.settings().feedMmPerS);
  double check = static_cast<double>(m_plan.settings().runNumber) +
                 templates::kCheckNumber * static_cast<double>(window + 1) +
                 templates::kCheckCount * count + templates::kCheckFeed * feedMmPerMin;
  for (std::size_t i = 0; i < m_perWindow; ++i) {
    // A short window is filled up with its last point: the check covers every slot.
    m_plan.addPointAt(slot * m_perWindow + i, std::min(begin + i, end - 1));
  }
  int place = 0;
  for (const opcua::Assignment& coordinate : m_plan.writes()) {
    check += templates::checkFactor(place++) * coordinate.value;
  }
  const int windowCell = static_cast<int>(slot);
  m_plan.addCell(cells.windowCount(windowCell), count);
  m_plan.addCell(cells.windowFeed(windowCell), feedMmPerMin);
  m_plan.addCell(cells.windowCheck(windowCell), check);
  if (opcua::isArray(m_plan.settings().grouping)) {
    m_plan.lastToFront(3);  // where they stand on the control: the window is one array
  }
}

Action WindowMethod::store(std::size_t window) {
  const std::size_t begin = windowBegin(window);
  const std::size_t end = windowBegin(window + 1);
  templates::WindowFile file;
  file.run = m_plan.settings().runNumber;
  file.number = window + 1;
  file.isLast = end == m_plan.pointCount();
  file.feedMmPerMin = base::mmPerMinFromMmPerS(m_plan.settings().feedMmPerS);
  for (std::size_t point = begin; point < end; ++point) {
    m_plan.forEachCoordinate(point, [&](double value) { file.coordinates.push_back(value); });
  }
  m_fileName = templates::windowFileName(static_cast<int>(window % m_slots));
  m_fileText = templates::windowFileText(m_plan.cells(), file);
  m_step = Step::Content;
  m_waiting = true;
  return {Action::Kind::Store, {}, {}, end - begin, m_fileName, m_fileText};
}

double WindowMethod::runWanted() const {
  if (m_stopWanted) {
    return kEnd;
  }
  // The first windows are all there before anything moves: the start has the full margin.
  const bool filled = m_delivered >= std::min(m_slots, m_windowCount);
  return filled && !m_holdWanted ? kRun : kHold;
}

std::optional<Action> WindowMethod::poll(Instant now) {
  if (m_waiting || m_trouble != Trouble::None) {
    return std::nullopt;
  }
  m_plan.clearWrites();
  const templates::CellMap& cells = m_plan.cells();
  if (m_stopWanted && m_run != kEnd) {
    m_runAsked = kEnd;
    m_plan.addCell(cells.run, kEnd);
    return write(Step::Run);
  }
  if (!m_owned && !m_stopWanted) {
    if (m_step == Step::Claim) {
      m_plan.addCell(cells.client, static_cast<double>(m_plan.settings().runNumber));
      return write(Step::Claim);
    }
    return read(Step::AwaitOwner, m_ownerCell);
  }
  if (m_run != runWanted()) {
    m_runAsked = runWanted();
    m_plan.addCell(cells.run, m_runAsked);
    return write(Step::Run);
  }
  // After a stop nothing is delivered any more: what could still be executed only gets less.
  if (!m_stopWanted) {
    if (m_filled > m_delivered || m_renumber) {
      m_plan.addCell(cells.delivered, static_cast<double>(m_filled));
      return write(Step::Number);
    }
    const std::size_t freed = cells.inFiles ? m_executed : m_latched;
    if (m_filled < m_windowCount && m_filled < freed + m_slots) {
      if (cells.inFiles) {
        return store(m_filled);
      }
      addContent(m_filled);
      return write(Step::Content, windowBegin(m_filled + 1) - windowBegin(m_filled));
    }
  }
  if (now >= m_nextBeat) {
    m_beat += 1.0;
    m_plan.addCell(cells.heartbeat, m_beat);
    return write(Step::Beat);
  }
  if (now > m_progress.nextLatest && now >= m_nextLook) {
    m_nextLook = now + kLookInterval;
    return read(Step::Look, m_header);
  }
  return read(Step::Watch, m_watched);
}

bool WindowMethod::answerLost(Instant) {
  // Whether it was carried out or not: `poll` asks for the same again.
  m_waiting = false;
  return true;
}

void WindowMethod::handle(const Answer& answer, Instant now) {
  RIVULET_ASSERT(m_waiting);
  m_waiting = false;
  switch (m_step) {
    case Step::Claim:
      m_step = Step::AwaitOwner;
      m_progress.lastProgress = now;
      m_progress.nextEarliest = now;
      m_progress.nextLatest = now + kSlowerThanPlanned;
      break;
    case Step::AwaitOwner: {
      const double owner = answer.readings[0].number;
      m_owned = owner == static_cast<double>(m_plan.settings().runNumber);
      if (m_owned) {
        m_progress.granted = true;
        m_progress.lastProgress = now;
        m_progress.nextLatest = now + kOurTurn;
      } else if (owner != 0.0) {
        m_trouble = Trouble::OtherClient;
      } else if (now > m_progress.nextLatest) {
        m_step = Step::Claim;  // it may have been overwritten on its way
      }
      break;
    }
    case Step::Content:
      ++m_filled;
      break;
    case Step::Number:
      if (m_delivered < m_filled) {
        // What the control had not taken so far it takes at once, or behind the window it is in.
        m_progress.nextLatest = now + takenTimeMax() + kSlowerThanPlanned;
      }
      m_delivered = m_filled;
      m_renumber = false;
      if (m_filled == m_windowCount || m_filled >= m_latched + m_slots) {
        m_progress.nextEarliest = m_windowEnds;  // until then there is nothing to be brought
      }
      break;
    case Step::Run:
      m_run = m_runAsked;
      m_progress.lastProgress = now;
      if (m_run != kHold) {
        // Behind a stop as well: the control goes on to the end of what it has taken.
        m_progress.nextLatest = now + takenTimeMax() + kSlowerThanPlanned;
      } else {
        m_progress.nextLatest = now + kOurTurn;
      }
      m_progress.stopWritten = m_run == kEnd;
      break;
    case Step::Beat:
      m_nextBeat = now + kBeatInterval;
      if (m_run == kHold) {
        m_progress.nextLatest = now + kOurTurn;
      }
      break;
    case Step::Watch:
      observe(answer.readings[0].number, m_saysExecuted ? answer.readings[1].number : 0.0, answer,
              now);
      break;
    case Step::Look:
      look(answer, now);
      break;
  }
  m_progress.allSent = m_delivered == m_windowCount;
  reckonNeed();
}

void WindowMethod::observe(double latched, double executed, const Answer& answer, Instant now) {
  if (!(latched >= 0.0) || latched > static_cast<double>(m_delivered) ||
      latched < static_cast<double>(m_latched)) {
    // The program on the control never says this to us: someone else has written the cell, or the
    // program has been started again. The header says which.
    m_nextLook = now;
    m_progress.nextLatest = std::min(m_progress.nextLatest, now - Duration{1});
    return;
  }
  const auto windows = static_cast<std::size_t>(latched);
  // With method window, one that is copied has everything in front of it executed. With the others
  // the control says so; what it cannot have meant is left out of account.
  std::size_t passed = windows == 0 ? 0 : windows - 1;
  if (m_saysExecuted) {
    const bool isMeant = executed >= static_cast<double>(m_executed) && executed <= latched;
    passed = isMeant ? static_cast<std::size_t>(executed) : m_executed;
  }
  if (windows == m_latched && passed == m_executed) {
    return;
  }
  m_latched = windows;
  m_executed = passed;
  m_takenAt = answer.sent;
  m_progress.lastProgress = now;
  m_progress.executed = windowBegin(m_executed);
  m_progress.stopsPassed = m_isCredit ? 0 : m_executed;
  const bool moreToBring = m_filled < m_windowCount && !m_stopWanted;
  m_windowEnds = answer.sent + takenTime();
  m_progress.nextEarliest = moreToBring ? now : m_windowEnds;
  m_progress.nextLatest = moreToBring && m_delivered == m_latched
                              ? now + kOurTurn
                              : now + takenTimeMax() + kSlowerThanPlanned;
}

void WindowMethod::look(const Answer& answer, Instant now) {
  const double owner = answer.readings[2].number;
  if (owner != static_cast<double>(m_plan.settings().runNumber)) {
    m_trouble = owner == 0.0 ? Trouble::Restarted : Trouble::OtherClient;
    return;
  }
  if (answer.readings[3].number != static_cast<double>(templates::WindowState::Runs)) {
    // The driver sees that the channel is in reset; nothing more is to be written.
    m_trouble = Trouble::Ended;
    m_progress.nextEarliest = now + kOurTurn;
    return;
  }
  // An earlier write that was late may have put back our number or our stop.
  m_renumber = m_owned && answer.readings[1].number != static_cast<double>(m_delivered);
  if (m_stopWanted && answer.readings[4].number != kEnd) {
    m_run = kHold;
  }
  observe(answer.readings[0].number, m_saysExecuted ? answer.readings[5].number : 0.0, answer, now);
}

std::optional<base::Error> WindowMethod::failure() const {
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

}  // namespace rivulet::streaming
