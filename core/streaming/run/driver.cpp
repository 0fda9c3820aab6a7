// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/run/driver.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"

namespace rivulet::streaming {

namespace {

using base::Duration;
using base::Instant;

/// Orders of the operator are looked at this often while nothing else happens.
constexpr Duration kOrderInterval = std::chrono::milliseconds{20};
/// The same if orders act at once, and a live source.
constexpr Duration kSourceInterval = std::chrono::milliseconds{4};
/// The same for a source of factors: what it says is to act within one access.
constexpr Duration kFactorLook = std::chrono::milliseconds{1};
/// Answers with a refused item in a row that are taken for faults of the transmission.
constexpr int kRefusalsMax = 2;
/// From this much silence on the network is said to be interrupted.
constexpr Duration kSilenceNoticed = std::chrono::seconds{3};
/// Counters without a sample reach the display this often.
constexpr Duration kPublishInterval = std::chrono::milliseconds{40};
/// A display read may take this many times its estimate before the method is due.
constexpr int kSlackFactor = 2;

/// Where the stream leaves no time, the control's trace is fetched this late: before a piece is
/// full.
constexpr Duration kTraceOverdue = std::chrono::seconds{8};
/// Variables that can be read in the time of a piece of the trace.
constexpr int kTraceNodes = 3;

/// Files travel more slowly than variables.
constexpr Duration kStoreDeadline = std::chrono::seconds{10};

}  // namespace

Driver::Driver(opcua::Link& link, Method& method, const RunSettings& settings, RunOrders& orders,
               RunSink& sink, std::size_t total, const templates::CellMap& cells, FeedControl& feed)
    : m_link(link),
      m_method(method),
      m_settings(settings),
      m_orders(orders),
      m_sink(sink),
      m_ending{
          {opcua::rParameter(cells.endCell), static_cast<double>(cells.endValue)}, {}, {}, {}, {}},
      m_access(settings),
      m_reads(!method.readsPosition(), link.now()),
      m_correction(cells, settings.parameters),
      m_feed(feed),
      m_pauses(settings.nominalPause) {
  m_counters.total = total;
}

FeedOrder feedOrdered(RunOrders& orders, Instant now) {
  FeedOrder order = orders.feed(now);
  order.holds = order.holds || (orders.stopRequested(now) && !orders.letsEnd(now));
  return order;
}

bool LeftHeld::isDue(bool isTold, const FeedControl& feed, RunOrders& orders, Instant now) {
  const bool isHeld = isTold && feed.holds() && feed.state().stoodAfter && orders.leaves(now);
  m_since = isHeld ? std::optional(m_since.value_or(now)) : std::nullopt;
  return isHeld && now - *m_since >= kEndsAtOnce;
}

StreamEnd Driver::run() {
  m_turnedAt = m_link.now();
  while (!m_done) {
    turnSupplier();
    if (m_lastProgress.at != m_method.progress().lastProgress) {
      m_lastProgress.at = m_method.progress().lastProgress;
      m_lastProgress.lost = m_feed.lostTime(m_link.now());
    }
    checkOrders();
    submitFeed();
    submitBeat();
    if (m_ending.abandonedAt) {
      submitStop();
    }
    submitTrace();
    submitMonitor();
    if (!m_ending.abandonedAt) {
      submitMethod();
    }
    const std::optional<opcua::Event> event = m_link.wait(nextWakeUp());
    noticeOwnSilence();
    if (event && !m_done) {
      handle(*event);
    }
    noticeSilence();
    settlePauses(false);
    checkDeadlines();
    if (m_link.now() - m_lastPublished >= kPublishInterval) {
      publish();
    }
  }
  if (m_outstanding.feed && m_outstanding.feed->write) {
    m_feed.lost(m_link.now());
  }
  if (!m_end.programEnded) {
    confirmSuspicion();
  }
  settlePauses(true);
  noteCorrection(true);
  noticeSlowness();
  publish();
  return m_end;
}

Instant Driver::nextWakeUp() const {
  const Instant now = m_link.now();
  const bool isQuick = m_supplier != nullptr || m_feed.exists();
  Instant until = now + (m_feed.state().source ? kFactorLook
                         : isQuick             ? kSourceInterval
                                               : kOrderInterval);
  if (m_outstanding.method || m_outstanding.monitor) {
    return until;
  }
  for (const std::optional<Instant> due :
       {std::optional(m_reads.next(MonitorReads::Kind::Status)),
        m_method.progress().expected.deadline(Expectation::Poll)}) {
    if (due && *due > now) {
      until = std::min(until, *due);
    }
  }
  return until;
}

/// A turn takes milliseconds, unless this computer did nothing: it was suspended, or too busy. The
/// control has been waiting meanwhile, and somebody may stand in the machine.
void Driver::noticeOwnSilence() {
  const Duration turn = m_link.now() - m_turnedAt;
  m_turnedAt = m_link.now();
  if (turn > opcua::kSilenceMax) {
    loseConnection(base::makeError(
        opcua::LinkError::ConnectionLost,
        fmt::format("This computer did nothing for {:.0f} s: it was suspended, or too busy to run "
                    "Rivulet. Keep it from sleeping while a program runs.",
                    base::toSeconds(turn))));
  }
}

void Driver::loseConnection(base::Error error) {
  m_end.error = std::move(error);
  m_end.error.message += " " + std::string(m_method.adviceWhenLost());
  if (m_feed.holds()) {
    m_end.error.message +=
        " The override of the client is 0: the axes stand until the program is reset.";
  }
  m_done = true;
}

void Driver::noticeSilence() {
  const Duration silence = m_link.silence();
  if (m_done || m_isSilent == (silence >= kSilenceNoticed)) {
    return;
  }
  m_isSilent = !m_isSilent;
  m_sink.note({m_link.now(), m_isSilent ? fmt::format("network: nothing has come from the control "
                                                      "for {:.0f} s",
                                                      base::toSeconds(kSilenceNoticed))
                                        : std::string("network: the control answers again")});
  publish();
}

void Driver::noticeSlowness() {
  if (!m_end.slowedBy.empty()) {
    return;
  }
  m_end.slowedBy = m_access.slowness();
  if (!m_end.slowedBy.empty()) {
    m_sink.note({m_link.now(), "slowed: " + m_end.slowedBy});
  }
}

RunState Driver::state() const {
  if (m_ending.wantedAt) {
    return RunState::Stopping;
  }
  return m_holds.inForce || m_feed.holds() ? RunState::Holding : RunState::Running;
}

void Driver::turnSupplier() {
  if (m_supplier != nullptr && !m_ending.wantedAt && !m_ending.abandonedAt) {
    m_supplier->turn(m_link.now());
    m_counters.total = m_supplier->accepted();
  }
}

void Driver::checkOrders() {
  FeedOrder order = feedOrdered(m_orders, m_link.now());
  if (m_correction.lifts()) {
    takeLift(order);
  }
  m_feed.want(order, m_link.now());
  noteFeed();
  const bool isOrdered = m_orders.holdRequested(m_link.now()) || isLifted();
  m_holds.bySupplier = !isOrdered && m_supplier != nullptr && m_supplier->wantsHold(m_link.now());
  const bool hold = isOrdered || m_holds.bySupplier;
  if (hold != m_holds.inForce && !m_ending.wantedAt) {
    m_holds.inForce = hold;
    m_method.requestHold(hold);
    m_sink.note({m_link.now(), std::string(hold ? kHoldNote : kContinueNote)});
    publish();
  }
  if (m_correction.exists() && !m_correction.lifts() && !m_ending.wantedAt &&
      !m_ending.abandonedAt) {
    m_correction.want(m_orders.correctionMm(m_link.now()), m_link.now());
    noteCorrection(false);
  }
  if (m_ending.wantedAt || !m_orders.stopRequested(m_link.now())) {
    return;
  }
  m_ending.wantedAt = m_link.now();
  m_ending.lostBefore = m_feed.lostTime(m_link.now());
  m_end.stopped = true;
  m_method.requestStop();
  m_sink.note({m_link.now(), std::string(kStopNote)});
  publish();
}

void Driver::takeLift(FeedOrder& order) {
  const FeedSeen& feed = m_feed.state();
  const double askedMm = m_correction.value().askedMm.z;
  // Down at any time; up only where nothing moves.
  if (order.liftMm <= askedMm || (feed.holds && feed.stoodAfter)) {
    m_correction.want({0.0, 0.0, std::max(order.liftMm, 0.0)}, m_link.now());
    noteCorrection(false);
  }
  order.holds = order.holds || isLifted();
}

bool Driver::isLifted() const {
  return m_correction.lifts() &&
         (m_correction.value().askedMm.z != 0.0 || m_correction.value().confirmedMm.z != 0.0 ||
          m_feed.state().isLifted());
}

void Driver::submitFeed() {
  const Instant now = m_link.now();
  const bool isWriting = m_outstanding.feed && m_outstanding.feed->write;
  if (m_feed.mustWrite(now) && !isWriting) {
    const auto cells = m_feed.write(now);  // the answer to a read in progress is of before
    m_outstanding.feed = FeedAccess{
        m_link.write(cells, m_access.patient(m_settings.requestDeadline), opcua::Grouping::List),
        true, static_cast<int>(cells.size())};
    publish();
  } else if (!m_outstanding.feed &&
             (m_feed.mustRead(now) || (m_feed.mayRead(now) && hasSlackFor(2) &&
                                       !m_outstanding.method && !m_outstanding.monitor))) {
    const auto cells = m_feed.read(now);
    m_outstanding.feed = FeedAccess{
        m_link.read(cells, m_access.patient(m_settings.requestDeadline), opcua::Grouping::List),
        false, static_cast<int>(cells.size())};
  }
}

void Driver::submitBeat() {
  Heartbeat& beat = m_feed.beat();
  if (!m_outstanding.beat && beat.isDue(m_link.now())) {
    // It is not repeated: the next one goes out soon enough.
    m_outstanding.beat = m_link.write(beat.next(m_link.now()),
                                      m_access.patient(2 * beat.interval()), opcua::Grouping::List);
  }
}

std::span<const opcua::Assignment> Driver::withBeats(std::span<const opcua::Assignment> cells) {
  Heartbeat& beat = m_feed.beat();
  const auto count = static_cast<double>(cells.size());
  const double intervals = base::toSeconds(m_access.expected(static_cast<int>(cells.size()))) /
                           base::toSeconds(beat.interval());
  if (!beat.exists() || opcua::isArray(m_settings.grouping) || intervals <= 1.0) {
    return cells;
  }
  const auto between = std::max<std::size_t>(1, static_cast<std::size_t>(count / intervals));
  m_withBeats.clear();
  for (const opcua::Assignment& cell : cells) {
    m_withBeats.push_back(cell);
    if (m_withBeats.size() % (between + 1) == between) {
      m_withBeats.push_back(beat.next(m_link.now()).front());
    }
  }
  return m_withBeats;
}

void Driver::takeFeed(const opcua::Event& event) {
  const FeedAccess access = *m_outstanding.feed;
  m_outstanding.feed.reset();
  const bool isDone = event.kind != opcua::EventKind::RequestFailed;
  if (isDone) {
    noteAccess(event, {access.id, access.write, access.nodes, 0, false});
  }
  if (access.write && (!isDone || refusedItem(event))) {
    m_feed.lost(event.at);
  } else if (access.write) {
    m_feed.written(event.at);
  } else if (isDone) {
    const FeedSeen before = m_feed.state();
    m_feed.seen(event.readings, event.at);
    noteFeed();
    if (!(before == m_feed.state())) {
      publish();
    }
  }
}

void Driver::noteFeed() {
  for (const trace::Note& note : m_feed.takeNotes()) {
    m_sink.note(note);
  }
}

Duration Driver::lostSince(Duration since) const {
  return m_feed.lostTime(m_link.now()) - since;
}

void Driver::noteCorrection(bool now) {
  if (const auto confirmedMm = m_correction.toNote(m_link.now(), now)) {
    m_sink.note(
        {m_link.now(), m_correction.lifts()
                           ? fmt::format("lift of the tool in mm: {:.3f}", confirmedMm->z)
                           : fmt::format("online correction in mm: X {:.4f} Y {:.4f} Z {:.4f}",
                                         confirmedMm->x, confirmedMm->y, confirmedMm->z)});
  }
}

bool Driver::submitCorrection() {
  // Behind a stop the program takes back by itself what is laid over the axes. Axes that are held
  // do not move for a correction, and for nothing but a lift.
  const bool isBarred = !m_correction.lifts() && (m_ending.wantedAt || m_feed.holds());
  if (isBarred || m_ending.abandonedAt || !m_correction.isDue(m_link.now())) {
    return false;
  }
  const int nodes = m_correction.nodeCount();
  if (!hasSlackFor(nodes) && !m_correction.isOverdue(m_link.now())) {
    return false;
  }
  m_methodsTurn = true;
  m_outstanding.monitorKind.reset();
  m_outstanding.monitor =
      Pending{m_link.write(m_correction.take(m_link.now()),
                           m_access.patient(m_settings.requestDeadline), opcua::Grouping::List),
              true, nodes, 0, false};
  return true;
}

bool Driver::hasSlackFor(int nodes) const {
  if (m_holds.inForce || m_feed.holds()) {
    return true;  // the machine waits anyway
  }
  const Duration needed = kSlackFactor * m_access.expected(nodes + 1);
  return m_method.progress().expected.isAhead(Expectation::Access, m_link.now() + needed - late());
}

bool Driver::wantsStatus() const {
  const Instant now = m_link.now();
  if (!m_reads.isDue(MonitorReads::Kind::Status, now)) {
    return false;
  }
  // Once the program has been told to end, or once it is later than it could be, the channel is
  // asked whether it still runs; before that only where nobody waits.
  return m_ending.abandonedAt ||
         !m_method.progress().expected.isAhead(Expectation::Progress, now - late()) ||
         hasSlackFor(m_reads.count(MonitorReads::Kind::Status));
}

bool Driver::wantsDisplay() const {
  const Instant now = m_link.now();
  if (!m_settings.monitor || m_ending.abandonedAt ||
      !m_reads.isDue(MonitorReads::Kind::Display, now)) {
    return false;
  }
  // Where a late client means wrong motion, the display waits.
  return (m_method.waitsForClient() && m_reads.isDisplayOverdue(now)) ||
         hasSlackFor(m_reads.count(MonitorReads::Kind::Display));
}

bool Driver::wantsEquipment() const {
  return m_settings.monitor && !m_ending.abandonedAt &&
         m_reads.isDue(MonitorReads::Kind::Equipment, m_link.now()) &&
         hasSlackFor(m_reads.count(MonitorReads::Kind::Equipment));
}

void Driver::submitMonitor() {
  const bool started = m_method.progress().lastProgress || m_ending.abandonedAt;
  const bool isMethodsTurn = m_methodsTurn && !m_ending.abandonedAt;
  if (m_outstanding.method || m_outstanding.monitor || !started || isMethodsTurn ||
      submitCorrection()) {
    return;
  }
  if (wantsStatus()) {
    submitMonitorRead(MonitorReads::Kind::Status);
  } else if (wantsEquipment()) {
    submitMonitorRead(MonitorReads::Kind::Equipment);
  } else if (wantsDisplay()) {
    submitMonitorRead(MonitorReads::Kind::Display);
  }
}

void Driver::submitMonitorRead(MonitorReads::Kind kind) {
  m_methodsTurn = true;
  m_outstanding.monitorKind = kind;
  m_reads.asked(kind, m_link.now());
  m_outstanding.monitor =
      Pending{m_link.read(m_reads.variables(kind), m_access.patient(m_settings.requestDeadline),
                          opcua::Grouping::List),
              false, m_reads.count(kind), 0, false};
}

void Driver::submitMethod() {
  if (m_outstanding.method || m_outstanding.monitor) {
    return;
  }
  const std::optional<Action> action = m_method.poll(m_link.now());
  m_methodsTurn = false;
  if (m_supplier != nullptr && m_place.path) {
    m_place.path->extend(m_supplier->points());
  }
  if (!action) {
    return;
  }
  Pending pending;
  pending.points = action->points;
  if (action->kind == Action::Kind::Read) {
    pending.nodes = static_cast<int>(action->variables.size());
    pending.id = m_link.read(action->variables, m_access.patient(m_settings.requestDeadline),
                             m_settings.grouping);
  } else if (action->kind == Action::Kind::Store) {
    pending.write = true;
    pending.nodes = 0;
    pending.id = m_link.store(std::string(action->name), std::string(action->text),
                              m_access.patient(m_settings.requestDeadline) + kStoreDeadline);
    m_counters.sent += action->points;
  } else {
    const auto cells = withBeats(action->assignments);
    pending.write = true;
    pending.nodes = static_cast<int>(cells.size());
    pending.beats = cells.size() > action->assignments.size();
    // A large fill at the start takes its time: the deadline grows with the number of nodes.
    const Duration deadline =
        m_settings.requestDeadline + 4 * m_settings.accessTime * pending.nodes;
    pending.id = m_link.write(cells, m_access.patient(deadline), m_settings.grouping);
    m_counters.sent += action->points;
  }
  m_outstanding.method = pending;
}

void Driver::handle(const opcua::Event& event) {
  if (event.kind == opcua::EventKind::ConnectionLost) {
    loseConnection(event.error);
    return;
  }
  if (m_ending.pending == event.request) {
    m_ending.pending.reset();
    // Whether it worked shows in the state of the channel; an order that was lost is given again.
    m_ending.isSent = event.kind != opcua::EventKind::RequestFailed;
    return;
  }
  if (m_outstanding.beat == event.request) {
    m_outstanding.beat.reset();
    if (event.kind != opcua::EventKind::RequestFailed) {
      noteAccess(event, {event.request, true, 1, 0, false});
      if (!refusedItem(event)) {
        m_feed.beaten(event.sent, event.at);
        noteFeed();
      }
    }
    return;
  }
  if (m_trace.pending() == event.request) {
    m_trace.answered(&event, m_link.now());
    return;
  }
  if (m_outstanding.feed && m_outstanding.feed->id == event.request) {
    takeFeed(event);
    return;
  }
  const bool forMethod = m_outstanding.method && m_outstanding.method->id == event.request;
  const bool forMonitor = m_outstanding.monitor && m_outstanding.monitor->id == event.request;
  if (!forMethod && !forMonitor) {
    return;  // the late answer of a request that was given up
  }
  const Pending pending = forMethod ? *m_outstanding.method : *m_outstanding.monitor;
  (forMethod ? m_outstanding.method : m_outstanding.monitor).reset();
  const bool isCorrection = !forMethod && !m_outstanding.monitorKind;
  const bool isEquipment = !forMethod && m_outstanding.monitorKind == MonitorReads::Kind::Equipment;
  if (event.kind == opcua::EventKind::RequestFailed) {
    const bool isFalsified = opcua::mayBeFalsified(event.error.code) && repeats(event, forMethod);
    if (!isFalsified && !forgives(event, forMethod)) {
      abandon(event.error);
    } else if (forMethod) {
      m_counters.sent -= pending.points;
    } else if (isCorrection) {
      m_correction.lost();
    }
    return;
  }
  noteAccess(event, pending);
  if (isEquipment) {  // a control need not serve all of it
    publish(std::nullopt, m_reads.takeEquipment(event));
    return;
  }
  if (const std::error_code refused = refusedItem(event)) {
    if (!repeats(event, forMethod)) {
      abandon(itemError(refused, event.kind == opcua::EventKind::ReadDone));
    } else if (forMethod) {
      m_counters.sent -= pending.points;
    } else if (isCorrection) {
      m_correction.lost();
    }
    return;
  }
  m_refusals = 0;
  if (pending.beats) {
    m_feed.beaten(event.sent, event.at);
  }
  if (forMethod) {
    m_counters.accepted += pending.points;
    handleMethod(event);
  } else if (isCorrection) {
    m_correction.confirm();
    publish();
  } else {
    handleMonitor(event);
  }
}

void Driver::submitTrace() {
  const std::optional<Duration> late = m_trace.lateness(m_link.now());
  const bool mayAsk =
      late && !m_outstanding.method && !m_outstanding.monitor && !m_ending.abandonedAt;
  if (mayAsk && (*late >= kTraceOverdue || hasSlackFor(kTraceNodes))) {
    m_trace.ask(m_link, m_access.patient(m_settings.requestDeadline));
  }
}

std::error_code Driver::refusedItem(const opcua::Event& event) {
  for (const opcua::Reading& reading : event.readings) {
    if (reading.status) {
      return reading.status;
    }
  }
  for (const std::error_code& status : event.statuses) {
    if (status) {
      return status;
    }
  }
  return {};
}

base::Error Driver::itemError(const std::error_code& status, bool isRead) const {
  // In the middle of a run it is hardly the access rights: the same cells were accessible before.
  return base::makeError(
      status,
      fmt::format("{} {}",
                  isRead ? "A variable that the stream needs cannot be read."
                         : "A cell that the stream needs cannot be written.",
                  m_counters.accepted == 0
                      ? opcua::remedyForItem(status)
                      : "It was accessible before in this run: the request was falsified on its "
                        "way, or the control has withdrawn the access. Check network and server."));
}

bool Driver::repeats(const opcua::Event& event, bool forMethod) {
  if (m_ending.abandonedAt || ++m_refusals > kRefusalsMax) {
    return false;
  }
  if (forMethod ? !m_method.answerLost(event.at) : !m_method.waitsForClient()) {
    return false;
  }
  m_sink.note({event.at, std::string(kRefusedNote)});
  return true;
}

void Driver::noteAccess(const opcua::Event& event, const Pending& pending) {
  const Duration took = event.at - event.sent;
  m_sink.access({event.sent, took, pending.write, pending.nodes});
  m_access.add(took, pending.nodes);
  noticeSlowness();
}

bool Driver::forgives(const opcua::Event& event, bool forMethod) {
  if (event.error.code != opcua::LinkError::DeadlineExceeded || m_ending.abandonedAt) {
    return false;
  }
  if (forMethod ? !m_method.answerLost(event.at) : !m_method.waitsForClient()) {
    return false;
  }
  m_access.lost();
  m_sink.note({event.at, std::string(kLostNote)});
  return true;
}

void Driver::handleMethod(const opcua::Event& event) {
  m_method.handle({event.sent, event.at, event.readings}, event.at);
  if (std::optional<base::Error> failure = m_method.failure()) {
    m_sink.note({event.at, "stream given up: " + failure->text()});
    m_end.error = *std::move(failure);
    m_done = true;
    return;
  }
  const Progress& progress = m_method.progress();
  if (progress.granted && !m_grantSeen) {
    m_grantSeen = true;
    m_sink.granted();
  }
  m_counters.executed = progress.executed;
  if (progress.brokenSignals > m_brokenSeen) {
    m_brokenSeen = progress.brokenSignals;
    m_sink.note({event.at, "a signal was out of sequence: a window has been executed again"});
    noteWrong({WrongMotion::Kind::Repeated, progress.executed, 0.0});
  }
  m_pauses.infer(progress.stopsPassed, m_link.now());
  if (const std::optional<base::Vec3> position = m_method.positionMm();
      position && !event.readings.empty()) {
    checkPlace(*position, event.at);
    publishPosition(*position, event.at);
  }
}

void Driver::publishPosition(base::Vec3 positionMm, Instant at) {
  // A stop is shorter than the time between two samples of the display: it is shown at once.
  const auto standstill = m_standstill.add(at, positionMm, m_settings.feedMmPerS);
  if (standstill || at >= m_nextSample) {
    m_nextSample = at + kDisplayInterval;
    publish(trace::LiveSample{at, positionMm, standstill, {}});
  }
}

/// After its end, also by a reset at the control, the positions are those of another frame: what is
/// read off the path counts once the program was seen to be active after that. A tool that is
/// lifted is meant to be beside the path, which waits.
void Driver::checkPlace(base::Vec3 positionMm, Instant at) {
  if (!m_place.path || m_end.wrong || m_place.suspicion || isLifted()) {
    return;
  }
  const std::size_t executed = m_method.progress().executed;
  if (const auto offMm = m_place.path->add(positionMm, executed, m_counters.sent)) {
    m_place.suspicion = {{WrongMotion::Kind::OffPath, executed, *offMm}, at};
    if (m_settings.monitor) {
      m_reads.askStatusAt(m_link.now());
    } else {
      confirmSuspicion();
    }
  }
}

void Driver::confirmSuspicion() {
  if (m_place.suspicion) {
    noteWrong(m_place.suspicion->wrong);
    m_place.suspicion.reset();
  }
}

void Driver::noteWrong(WrongMotion wrong) {
  if (m_end.wrong) {
    return;  // the first is the one to look at
  }
  m_end.wrong = wrong;
  m_sink.note({m_link.now(), "wrong motion: " + describe(wrong)});
  publish();
}

void Driver::handleMonitor(const opcua::Event& event) {
  if (m_outstanding.monitorKind == MonitorReads::Kind::Status) {
    m_reads.statusAnswered(event);
    const bool isReset = event.readings[0].number == opcua::kChannelReset;
    if (m_place.suspicion && !isReset && event.sent > m_place.suspicion->at) {
      confirmSuspicion();
    }
    if (isReset) {
      m_end.programEnded = true;
      if (m_ending.wantedAt) {
        m_end.stopConfirmedAfter = event.at - *m_ending.wantedAt;
      }
      m_done = true;
    } else if (m_ending.held.isDue(m_ending.wantedAt && m_method.progress().stopWritten, m_feed,
                                   m_orders, event.sent)) {
      m_end.leftHeld = true;
      m_sink.note({m_link.now(), "stopped: the axes are held, and the program is left"});
      m_done = true;
    } else if (const double alarm = event.readings[1].number; alarm != 0.0) {
      m_end.error =
          base::makeError(StreamError::ControlAlarm,
                          fmt::format("The control stopped with alarm {}. Clear it at the control.",
                                      base::formatNumber(alarm)));
      m_done = true;
    }
    return;
  }
  const trace::LiveSample sample = m_reads.takeDisplay(event);
  if (sample.positionMm) {
    checkPlace(*sample.positionMm, event.at);
  }
  if (const auto measured = m_pauses.measure(event.at, *sample.feedMmPerS)) {
    publishPause(*measured);
  }
  publish(sample);
}

void Driver::settlePauses(bool all) {
  while (const auto inferred = m_pauses.settle(all, m_link.now())) {
    publishPause(*inferred);
  }
}

void Driver::publishPause(const trace::Pause& pause) {
  LiveUpdate update;
  update.state = state();
  update.at = m_link.now();
  update.counters = m_counters;
  update.wrong = m_end.wrong;
  if (m_correction.exists()) {
    update.correction = m_correction.value();
  }
  if (m_feed.exists()) {
    update.feed = m_feed.state();
  }
  update.pause = pause;
  m_sink.update(update);
}

void Driver::checkDeadlines() {
  if (m_done) {
    return;
  }
  const Instant now = m_link.now();
  const Progress& progress = m_method.progress();
  const std::optional<Instant> endingSince =
      m_ending.abandonedAt ? m_ending.abandonedAt : m_ending.wantedAt;
  const Duration held = m_orders.leaves(now) ? Duration{} : lostSince(m_ending.lostBefore);
  if (endingSince && now - *endingSince > m_settings.stopDeadline + held) {
    const std::string unconfirmed = fmt::format(
        "The control did not confirm the stop within {:.0f} s. Stop it at the control.{}",
        base::toSeconds(m_settings.stopDeadline),
        m_feed.holds() ? " The override of the client is 0: the axes stand until the program is "
                         "reset."
                       : "");
    if (m_end.error.code) {
      m_end.error.message += " " + unconfirmed;
    } else {
      m_end.error = base::makeError(StreamError::StopNotConfirmed, unconfirmed);
    }
    m_done = true;
    return;
  }
  const std::optional<Instant> expected = progress.expected.deadline(Expectation::Progress);
  // A window takes several accesses, however slow these are.
  const Duration patience =
      m_settings.stallDeadline + 10 * m_access.slow().value_or(Duration{}) + late();
  if (!m_ending.abandonedAt && progress.lastProgress && expected && now > *expected + patience) {
    abandon(base::makeError(StreamError::StreamStalled,
                            m_end.slowedBy.empty()
                                ? std::string(m_method.adviceWhenStalled())
                                : "The stream made no progress. " + m_end.slowedBy));
  }
}

void Driver::abandon(base::Error error) {
  m_sink.note({m_link.now(), "stream abandoned: " + error.text()});
  // What comes later is no new cause, and must not put off the end of the wait for the stop.
  if (!m_ending.abandonedAt) {
    m_end.error = std::move(error);
    m_ending.abandonedAt = m_link.now();
    m_ending.lostBefore = m_feed.lostTime(m_link.now());
  }
  m_outstanding.method.reset();
  m_reads.askStatusAt(m_link.now());
}

void Driver::submitStop() {
  if (m_ending.isSent) {
    return;
  }
  m_ending.isSent = true;
  m_ending.pending = m_link.write({&m_ending.stop, 1}, m_access.patient(m_settings.requestDeadline),
                                  opcua::Grouping::List);
}

void Driver::publish(std::optional<trace::LiveSample> sample,
                     std::optional<EquipmentSeen> equipment) {
  LiveUpdate update;
  update.state = state();
  update.at = m_link.now();
  update.counters = m_counters;
  update.wrong = m_end.wrong;
  if (m_correction.exists()) {
    update.correction = m_correction.value();
  }
  if (m_feed.exists()) {
    update.feed = m_feed.state();
  }
  update.sample = std::move(sample);
  update.equipment = std::move(equipment);
  if (m_supplier != nullptr) {
    update.source = m_supplier->level();
    update.source->holdsRun = m_holds.inForce && m_holds.bySupplier;
    update.waitingFor = update.source->waiting == 0 ? "source" : "";
  }
  if (m_isSilent) {
    update.waitingFor = "network";
  }
  const Progress& progress = m_method.progress();
  const std::optional<Duration> slow = m_access.slow();
  // The axes need points, or the method an access. A control that waits for its client needs
  // nothing before it has taken the first window: nothing moves yet, so nothing is too late.
  const std::optional<Instant> needed = progress.expected.deadline(
      m_method.waitsForClient() ? Expectation::Points : Expectation::Access);
  if (slow && needed && progress.lastProgress && !progress.allSent && !m_feed.holds()) {
    const Duration margin = *needed + late() - update.at - *slow;
    // Windows that are all there wait for a machine slower than planned: that is not too late.
    if (margin >= Duration{0} || !progress.hasNothingToBring) {
      update.margin = margin;
    }
  }
  m_lastPublished = update.at;
  m_sink.update(update);
}

}  // namespace rivulet::streaming
