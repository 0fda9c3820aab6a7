// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cnc/cnc_run.h"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <thread>
#include <utility>

#include "cnc/axes.h"
#include "cnc/segment.h"
#include "cnc/worker.h"
#include "pipeline/error.h"

namespace rivulet::cnc {

namespace {

using pipeline::kTaskCount;
using pipeline::Need;
using pipeline::Task;

constexpr std::int64_t kNsPerMs = 1'000'000;
/// How often the scheduler looks around when nothing calls it.
constexpr std::int64_t kLookNs = 20 * kNsPerMs;
/// How often the events are handed out.
constexpr std::int64_t kWatchNs = 100 * kNsPerMs;
/// A task that has not begun to wait for instructions by then never will.
constexpr std::int64_t kStartNs = 20'000 * kNsPerMs;
/// How long tasks may take to end.
constexpr std::int64_t kQuitNs = 2'000 * kNsPerMs;

constexpr int kExitNoSegment = 2;

/// Rung when a process ends; a signal handler can do nothing more.
std::atomic<Semaphore*> g_bell{nullptr};

extern "C" void onChildEnds(int /*signal*/) {
  if (Semaphore* const bell = g_bell.load()) {
    bell->post();
  }
}

/// Watches child processes for the time of a run.
class ChildWatch {
 public:
  explicit ChildWatch(Semaphore& bell) {
    g_bell.store(&bell);
    struct sigaction action {};
    action.sa_handler = &onChildEnds;
    action.sa_flags = SA_NOCLDSTOP | SA_RESTART;
    sigaction(SIGCHLD, &action, &m_before);
  }
  ~ChildWatch() {
    sigaction(SIGCHLD, &m_before, nullptr);
    g_bell.store(nullptr);
  }
  ChildWatch(const ChildWatch&) = delete;
  ChildWatch& operator=(const ChildWatch&) = delete;

 private:
  struct sigaction m_before {};
};

/// The tasks at work.
class Crew {
 public:
  virtual ~Crew() = default;
  /// A task that has ended though nobody told it to, and how.
  struct Loss {
    Task task = Task::Receive;
    std::string how;
  };
  [[nodiscard]] virtual std::optional<Loss> lost() = 0;
};

class ThreadCrew final : public Crew {
 public:
  explicit ThreadCrew(Segment& segment) : m_segment(segment) {
    for (std::size_t i = 0; i < kTaskCount; ++i) {
      m_threads[i] = std::thread([&segment, i] { runWorker(segment, static_cast<Task>(i)); });
    }
  }
  ~ThreadCrew() override {
    for (std::size_t i = 0; i < kTaskCount; ++i) {
      m_segment.mailboxes[i].instruction.store(Instruction::Quit);
      m_segment.mailboxes[i].wake.post();
      m_threads[i].join();
    }
  }
  ThreadCrew(const ThreadCrew&) = delete;
  ThreadCrew& operator=(const ThreadCrew&) = delete;

  [[nodiscard]] std::optional<Loss> lost() override { return std::nullopt; }

 private:
  Segment& m_segment;
  std::array<std::thread, kTaskCount> m_threads;
};

class ProcessCrew final : public Crew {
 public:
  ProcessCrew(Segment& segment, const std::string& name, const RunOptions& options)
      : m_segment(segment) {
    const pid_t parent = ::getpid();
    for (std::size_t i = 0; i < kTaskCount; ++i) {
      const std::string number = std::to_string(i);
      m_processes[i] = ::fork();
      if (m_processes[i] == 0) {
        // Ends with its parent, even if that is killed.
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (::getppid() == parent) {
          ::execl("/proc/self/exe", "rivulet-cnc", "task", name.c_str(), number.c_str(), nullptr);
        }
        ::_exit(kExitNoSegment);
      }
      if (options.say) {
        options.say(
            fmt::format("task {}: process {}", nameOf(static_cast<Task>(i)), m_processes[i]));
      }
    }
  }
  ~ProcessCrew() override {
    for (Mailbox& mailbox : m_segment.mailboxes) {
      mailbox.instruction.store(Instruction::Quit);
      mailbox.wake.post();
    }
    const std::int64_t deadline = monotonicNs() + kQuitNs;
    for (const pid_t process : m_processes) {
      while (process > 0 && ::waitpid(process, nullptr, WNOHANG) == 0) {
        if (monotonicNs() > deadline) {
          ::kill(process, SIGKILL);
        }
        sleepUntil(monotonicNs() + kNsPerMs);
      }
    }
  }
  ProcessCrew(const ProcessCrew&) = delete;
  ProcessCrew& operator=(const ProcessCrew&) = delete;

  [[nodiscard]] std::optional<Loss> lost() override {
    for (std::size_t i = 0; i < kTaskCount; ++i) {
      int status = 0;
      const pid_t process = m_processes[i];
      if (process > 0 && ::waitpid(process, &status, WNOHANG) == process) {
        m_processes[i] = 0;
        return Loss{
            static_cast<Task>(i),
            WIFSIGNALED(status)
                ? fmt::format("process {} was ended by signal {}", process, WTERMSIG(status))
                : fmt::format("process {} ended with code {}", process, WEXITSTATUS(status))};
      }
    }
    return std::nullopt;
  }

 private:
  Segment& m_segment;
  std::array<pid_t, kTaskCount> m_processes{};
};

class Scheduler {
 public:
  Scheduler(Segment& segment, Crew& crew, const RunOptions& options,
            const pipeline::SchedulingPolicy& policy, Axes& axes)
      : m_segment(segment),
        m_crew(crew),
        m_options(options),
        m_axes(axes),
        m_dispatcher(options.dispatch, policy,
                     {Need::Input, Need::Data, Need::Data, Need::Data, Need::Data, Need::Data}) {
    m_dispatcher.setRecorder([this](const pipeline::Event& event) { m_events.push_back(event); });
  }

  RunResult run(const std::atomic<bool>& stop) {
    if (awaitWorkers(stop)) {
      m_originNs = monotonicNs();
      while (!m_dispatcher.hasEnded() && m_failure.empty() && !stop.load() &&
             now().time_since_epoch() < m_options.until) {
        turn();
        handOut(false);
      }
    }
    follow();
    handOut(true);
    return result();
  }

 private:
  [[nodiscard]] base::Instant now() const {
    return base::Instant{base::Duration{monotonicNs() - m_originNs}};
  }
  [[nodiscard]] std::int64_t monotonicOf(base::Instant at) const {
    return m_originNs + at.time_since_epoch().count();
  }

  /// @return false if a task is not there
  [[nodiscard]] bool awaitWorkers(const std::atomic<bool>& stop) {
    const std::int64_t deadline = monotonicNs() + kStartNs;
    const auto isReady = [](const Mailbox& mailbox) { return mailbox.isReady.load(); };
    while (!std::all_of(m_segment.mailboxes.begin(), m_segment.mailboxes.end(), isReady)) {
      m_segment.bell.wait(monotonicNs() + kLookNs);
      for (const Mailbox& mailbox : m_segment.mailboxes) {
        if (mailbox.hasAnswered.load() && mailbox.hasFailed) {
          m_failure = mailbox.error.view();
        }
      }
      checkCrew();
      if (m_failure.empty() && monotonicNs() > deadline) {
        m_failure = "The tasks of the pipeline did not start in time. Start it again.";
      }
      if (!m_failure.empty() || stop.load()) {
        return false;
      }
    }
    if (m_options.program.empty() && m_options.say) {
      m_options.say(fmt::format("port {}", m_segment.port.load()));
    }
    return true;
  }

  /// One turn: what has happened, who runs next, what the axes do; then it waits.
  void turn() {
    base::Instant at = now();
    collect(at);
    advance(at);
    releaseEarly();
    follow();
    checkCrew();
    if (m_isStopping && !m_dispatcher.isUnderWay(Task::Position) &&
        m_dispatcher.levels().back() == 0) {
      m_failure = std::move(m_reason);
      return;
    }
    std::int64_t until = monotonicNs() + kLookNs;
    if (const auto next = m_dispatcher.nextRelease(at)) {
      until = std::min(until, monotonicOf(*next));
    }
    m_segment.bell.wait(until);
  }

  /// @param at  now; later afterwards if position control has begun in between
  void collect(base::Instant& at) {
    for (std::size_t i = 0; i < kTaskCount; ++i) {
      Mailbox& mailbox = m_segment.mailboxes[i];
      const Task task = static_cast<Task>(i);
      // Input that a step has asked for arrives after its answer. Looked at first and handled last,
      // it is never taken for input that nobody waits for.
      const bool hasInput = mailbox.inputHasArrived.exchange(false);
      if (mailbox.hasAnswered.exchange(false)) {
        takeAnswer(task, mailbox, at);
      }
      if (hasInput) {
        m_dispatcher.inputArrived();
      }
    }
  }

  /// @param at  as in `collect`
  void takeAnswer(Task task, const Mailbox& mailbox, base::Instant& at) {
    if (mailbox.hasFailed) {
      stopFor(fmt::format("The task {} has failed: {}", nameOf(task), mailbox.error.view()), task);
      return;
    }
    if (mailbox.next > static_cast<std::uint8_t>(Need::Ended)) {
      stopFor(fmt::format("The task {} says what cannot be.", nameOf(task)), task);
      return;
    }
    if (task == Task::Position) {
      if (m_isReleased) {
        // It has begun by itself at its instant: that comes before its end, and after what has
        // happened so far.
        advance(at);
        at = now();
        advance(at);
      }
      m_wakeUps.push_back(base::Duration{mailbox.beganNs - m_dueNs});
    }
    const auto ended =
        m_dispatcher.complete(task, {mailbox.made != 0, static_cast<Need>(mailbox.next)}, at);
    if (!ended) {
      stopFor(ended.error().text(), task);
    }
  }

  void advance(base::Instant at) {
    m_commands.clear();
    m_dispatcher.advance(at, m_commands);
    for (const pipeline::Command& command : m_commands) {
      if (command.kind != pipeline::Command::Kind::Run) {
        continue;  // who has lost its processor is held up by the system, or ends unnoticed
      }
      if (command.task != Task::Position) {
        if (!m_isStopping) {
          instruct(command.task, 0);
        }
      } else if (!std::exchange(m_isReleased, false)) {
        m_dueNs = monotonicOf(at);
        instruct(Task::Position, 0);
      }
    }
  }

  /// Position control waits for its instant by itself: nobody's delay adds to its own.
  void releaseEarly() {
    if (m_isReleased) {
      return;
    }
    if (const auto release = m_dispatcher.certainRelease()) {
      m_isReleased = true;
      m_release = *release;
      m_dueNs = monotonicOf(*release);
      instruct(Task::Position, m_dueNs);
    }
  }

  void instruct(Task task, std::int64_t notBeforeNs) {
    Mailbox& mailbox = m_segment.mailbox(task);
    mailbox.notBeforeNs.store(notBeforeNs);
    mailbox.instruction.store(Instruction::Run);
    mailbox.wake.post();
  }

  void follow() {
    if (const auto done = m_axes.follow(); !done && m_failure.empty()) {
      m_failure = done.error().text();
    }
  }

  /// @param isLast  all of them, and now
  void handOut(bool isLast) {
    const std::int64_t at = monotonicNs();
    if (!m_options.watch || (!isLast && at - m_handedOutNs < kWatchNs)) {
      return;
    }
    m_handedOutNs = at;
    m_options.watch(std::span<const pipeline::Event>(m_events).subspan(m_handedOut));
    m_handedOut = m_events.size();
  }

  void checkCrew() {
    const auto loss = m_crew.lost();
    if (!loss) {
      return;
    }
    // A task that has failed says why before it ends.
    const Mailbox& mailbox = m_segment.mailbox(loss->task);
    stopFor(
        mailbox.hasAnswered.load() && mailbox.hasFailed
            ? fmt::format("The task {} has failed: {}", nameOf(loss->task), mailbox.error.view())
            : fmt::format("The task {} has died: {}", nameOf(loss->task), loss->how),
        loss->task);
  }

  void stopFor(const std::string& reason, Task task) {
    if (!m_isStopping) {
      m_isStopping = true;
      m_reason = reason;
    }
    if (task == Task::Position || m_originNs == 0) {
      m_failure = m_reason;
    }
  }

  RunResult result() {
    RunResult result;
    result.hasEnded = m_dispatcher.hasEnded();
    result.trace = m_axes.trace();
    result.events = std::move(m_events);
    for (std::size_t i = 0; i < kTaskCount; ++i) {
      result.records[i] = m_dispatcher.record(static_cast<Task>(i));
    }
    result.wakeUps = std::move(m_wakeUps);
    const std::vector<std::int64_t>& sent = m_axes.sentNs();
    for (std::size_t i = 1; i < sent.size(); ++i) {
      result.cycles.emplace_back(sent[i] - sent[i - 1]);
    }
    if (m_originNs != 0) {
      result.duration = now().time_since_epoch();
    }
    const pipeline::CycleHead& last = m_axes.last();
    if (!m_failure.empty()) {
      result.failure =
          fmt::format("{} The axes stand after set point {}; start the program again.",
                      m_failure.ends_with('.') ? m_failure : m_failure + ".", m_axes.pointCount());
    } else if (last.kind == pipeline::CycleKind::Alarm && last.alarm.number != 0) {
      result.failure = fmt::format("Alarm {}: {}", last.alarm.number, last.alarm.text.view());
    } else if (last.kind == pipeline::CycleKind::Alarm) {
      result.failure = last.alarm.text.view();
    }
    return result;
  }

  Segment& m_segment;
  Crew& m_crew;
  const RunOptions& m_options;
  Axes& m_axes;
  pipeline::Dispatcher m_dispatcher;
  std::int64_t m_originNs = 0;
  std::vector<pipeline::Command> m_commands;
  std::vector<pipeline::Event> m_events;
  std::size_t m_handedOut = 0;  ///< of them
  std::int64_t m_handedOutNs = 0;
  std::vector<base::Duration> m_wakeUps;
  bool m_isReleased = false;  ///< position control has its instruction for `m_release`
  base::Instant m_release{};
  std::int64_t m_dueNs = 0;
  bool m_isStopping = false;
  std::string m_reason;
  std::string m_failure;
};

base::Result<RunResult> runOn(Segment& segment, const std::string& sharedName,
                              const RunOptions& options, const std::atomic<bool>& stop) {
  segment.setup.preset = decltype(segment.setup.preset)(options.preset);
  segment.setup.program = decltype(segment.setup.program)(options.program);
  segment.setup.cycleNs = options.dispatch.positionCycle.count();
  segment.setup.priority = options.priority;
  segment.setup.core = options.core;
  segment.port.store(options.port);
  const auto config = machineOf(segment.setup);
  if (!config) {
    return base::fail(config.error());
  }
  auto axes = Axes::open(segment.axes, *config);
  if (!axes) {
    return base::fail(axes.error());
  }
  const auto policy = pipeline::factsOf(options.policy).make();
  const ChildWatch watch(segment.bell);
  std::unique_ptr<Crew> crew;
  if (options.inProcesses) {
    crew = std::make_unique<ProcessCrew>(segment, sharedName, options);
  } else {
    crew = std::make_unique<ThreadCrew>(segment);
  }
  return Scheduler(segment, *crew, options, *policy, *axes).run(stop);
}

}  // namespace

base::Result<RunResult> runCnc(const RunOptions& options, const std::atomic<bool>& stop) {
  if (!options.inProcesses) {
    const auto segment = std::make_unique<Segment>();
    return runOn(*segment, {}, options, stop);
  }
  const std::string name = fmt::format("rivulet-cnc-{}-{}", ::getpid(), monotonicNs());
  auto shared = SharedSegment::make(name);
  if (!shared) {
    return base::fail(shared.error());
  }
  return runOn(shared->segment(), name, options, stop);
}

int runTaskProcess(const std::string& name, int task) {
  auto shared = SharedSegment::open(name);
  if (!shared || task < 0 || task >= static_cast<int>(kTaskCount)) {
    std::fputs(
        ((shared ? std::string("There is no such task.") : shared.error().text()) + "\n").c_str(),
        stderr);
    return kExitNoSegment;
  }
  // What ends the run is the scheduler's business; it tells the tasks.
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGTERM, SIG_IGN);
  runWorker(shared->segment(), static_cast<Task>(task));
  return 0;
}

}  // namespace rivulet::cnc
