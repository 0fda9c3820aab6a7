// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Whole jobs over a network with faults, in real time: the real client, a proxy, the real server
/// of a virtual machine. Most jobs are interrupted, up to three times each: by a fault of the
/// network, a stop of the operator, or a reset at the control. Somebody then asks the control where
/// the job was left, and goes on. Each motion and each tool change of the source must be made once,
/// in its order. `scripts/soak --job-network` runs many more: RIVULET_SCENARIOS, RIVULET_FIRST,
/// RIVULET_JOBS (at the same time).

#include <fmt/format.h>

#include <QtTest>
#include <atomic>
#include <map>
#include <mutex>
#include <thread>

#include "base/random.h"
#include "base/units.h"
#include "opcua/await.h"
#include "support/chosen_link.h"
#include "support/drawn_job.h"
#include "support/fault_proxy.h"
#include "support/loopback_machine.h"
#include "support/setting.h"
#include "support/test_program.h"
#include "templates/window_protocol.h"

using namespace rivulet;
using namespace std::chrono_literals;
using base::Duration;
using base::Instant;
using streaming::Outcome;

namespace {

constexpr int kInterruptionsMax = 3;
constexpr int kPointsMax = 40;  ///< of a stretch: a job takes less than a minute
/// A job that does not end by itself.
constexpr Duration kJobMax = 10min;
constexpr Duration kLook = 100ms;

/// How a job is interrupted.
struct Interruption {
  enum class Kind { None, Network, Stop, Reset } kind = Kind::None;
  Duration after{};
  tests::NetworkFault fault;

  [[nodiscard]] std::string name() const {
    return kind == Kind::Network ? std::string(tests::faultName(fault.kind))
           : kind == Kind::Stop  ? "stop"
           : kind == Kind::Reset ? "reset at the control"
                                 : "nothing";
  }
};

/// @param most  it begins before that
Interruption drawInterruption(base::Random& random, Duration most) {
  Interruption drawn;
  drawn.after = base::fromSeconds(base::toSeconds(most) * random.uniform());
  switch (random.below(8)) {
    case 0:
      drawn.kind = Interruption::Kind::Stop;
      break;
    case 1:
      drawn.kind = Interruption::Kind::Reset;
      break;
    default:
      drawn.kind = Interruption::Kind::Network;
      drawn.fault = tests::drawNetworkFault(random.bits(), most);
  }
  return drawn;
}

/// Stops the job, or resets the control beside it, at the drawn moment.
class Operator final : public streaming::WholeJobSink, public streaming::RunOrders {
 public:
  Operator(const Interruption& interruption, tests::LoopbackMachine& cell)
      : m_interruption(interruption), m_cell(cell) {}

  std::vector<std::string> notes;

  void update(const streaming::LiveUpdate&) override {}
  void access(const trace::Access&) override {}
  void note(const trace::Note& note) override { notes.push_back(note.text); }
  void nativeBlocks(int) override {}
  void stretchBegins(const job::Stretch&, base::Vec3) override {}
  bool waitsForCycleStart() override { return true; }
  bool stopRequested(Instant now) override {
    m_begunAt = m_begunAt.value_or(now);
    const bool isDue = now - *m_begunAt > m_interruption.after;
    if (isDue && m_interruption.kind == Interruption::Kind::Reset && !m_hasReset) {
      m_cell.pressReset();
      m_hasReset = true;
    }
    return now - *m_begunAt > kJobMax || (isDue && m_interruption.kind == Interruption::Kind::Stop);
  }

 private:
  const Interruption& m_interruption;
  tests::LoopbackMachine& m_cell;
  std::optional<Instant> m_begunAt;
  bool m_hasReset = false;
};

/// What became of a job.
struct Evidence {
  std::vector<std::string> story;  ///< of its parts
  std::map<std::string, int> interruptedBy;
  std::size_t motions = 0;  ///< of the source
  int resumes = 0;
  bool isRefused = false;  ///< an operator has to choose where it goes on
  std::string wrong;       ///< empty: each motion and each tool change once
};

class Exposure {
 public:
  explicit Exposure(std::uint64_t seed)
      : m_seed(seed),
        m_text(tests::drawPart(seed, kPointsMax)),
        m_plan(tests::planOf(m_text)),
        m_source(tests::traceOfSource(m_text)),
        m_left{m_plan},
        m_motions(tests::motions(m_source), 4),
        m_tools(tests::toolChanges(m_source), 1),
        m_cell({"dmu75-mill", seed, 0}),
        m_proxy(m_cell.endpoint()) {
    m_settings.parameters.pointsPerLoop = 3 + static_cast<int>(seed % 6);
    m_settings.parameters.method =
        seed % 5 == 0 ? base::MethodKind::Credit : base::MethodKind::Window;
    m_settings.feedMmPerS = 50.0;
    m_settings.isCommissioned = true;
    m_settings.startDeadline = 60s;
    m_settings.origin = {"tester", "here", "2026-11-22T05:00:00Z"};  // the cells are claimed
  }

  Evidence run() {
    base::Random random = base::Random(m_seed).fork(11);
    m_evidence.motions = tests::motions(m_source).size();
    const Duration takes = m_source.samples.back().at - m_source.samples.front().at;
    const auto interruptions = static_cast<int>(random.below(kInterruptionsMax + 1));
    for (int part = 0; m_evidence.wrong.empty() && !m_evidence.isRefused; ++part) {
      const Interruption interruption =
          part < interruptions ? drawInterruption(random, takes * 3 / 2) : Interruption{};
      if (part > interruptions) {
        m_evidence.wrong = "not at its end, although nothing interrupted it\n";
      } else if (runPart(interruption, random)) {
        m_evidence.wrong = m_motions.verdict() + m_tools.verdict();
        break;
      }
    }
    return std::move(m_evidence);
  }

 private:
  /// @return true: the job is at its end
  bool runPart(const Interruption& interruption, base::Random& random) {
    Operator orders(interruption, m_cell);
    opcua::ConnectOptions options;
    options.security = opcua::unencrypted();
    options.endpoint = m_proxy.endpoint();
    m_proxy.begin(interruption.fault);
    streaming::WholeJobReport report;
    if (const auto link = tests::openChosen(options)) {
      const auto resume = m_left.restart ? m_left.restart->rest.resume : std::nullopt;
      report = streaming::runWholeJob(**link, **link, m_left.begin(), m_settings, orders, orders,
                                      {.resume = resume, .keeper = &m_left.keeper});
    } else {
      report.error = link.error();
    }
    m_proxy.begin({});
    m_beside = m_cell.connect();
    const bool isCompleted = report.outcome == Outcome::Completed;
    m_evidence.story.push_back(fmt::format(
        "{} after {:.1f} s: {} {}", interruption.name(), base::toSeconds(interruption.after),
        streaming::outcomeName(report.outcome), report.error.text()));
    if (qEnvironmentVariableIsSet("RIVULET_TELL")) {
      qInfo("seed %llu: %s", static_cast<unsigned long long>(m_seed),
            m_evidence.story.back().c_str());
    }
    for (const std::string& note : orders.notes) {
      m_evidence.story.push_back("  note: " + note);
    }
    if (!isCompleted) {
      ++m_evidence.interruptedBy[interruption.name()];
      leaveAlone(random.below(8) == 0 ? Duration(70s) : Duration(2s));
    }
    // A fault before the job could be kept: nothing of it was to be executed.
    const bool isKept = m_left.keeper.last.has_value();
    const base::Result<void> went = isCompleted || !isKept
                                        ? base::Result<void>()
                                        : m_left.goOn(*m_beside, *m_beside, m_settings);
    if (!awaitReset()) {
      return false;
    }
    judge(isCompleted || !isKept || !went);
    if (!went) {
      m_evidence.story.push_back("  does not go on: " + went.error().text());
      m_evidence.isRefused = went.error().code == streaming::StreamError::CannotResume;
      m_evidence.wrong = m_evidence.isRefused ? "" : "lost: " + went.error().text() + "\n";
    }
    m_evidence.resumes += went && !isCompleted && isKept ? 1 : 0;
    return isCompleted;
  }

  /// Until the program has ended, or its axes have been held so long.
  void leaveAlone(Duration heldFor) {
    const std::array<opcua::Variable, 2> looked{
        {{opcua::VariableKind::ChannelStatus, 0},
         opcua::rParameter(templates::WindowProtocol::OverrideActs)}};
    const Instant deadline = m_beside->now() + kJobMax;
    Instant movesAt = m_beside->now();
    for (Instant now = movesAt; now < deadline && now - movesAt < heldFor; now = m_beside->now()) {
      const auto values = opcua::readNumbers(*m_beside, looked, 5s);
      if (!values || (*values)[0] == opcua::kChannelReset) {
        return;
      }
      if ((*values)[1] != templates::FeedCell::kHold) {
        movesAt = now;
      }
      m_beside->wait(now + kLook);
    }
  }

  bool awaitReset() {
    const std::array<opcua::Variable, 1> channel{{{opcua::VariableKind::ChannelStatus, 0}}};
    const Instant deadline = m_beside->now() + kJobMax;
    while (m_beside->now() < deadline) {
      const auto status = opcua::readNumbers(*m_beside, channel, 5s);
      if (status && status->front() == opcua::kChannelReset) {
        return true;
      }
      m_beside->wait(m_beside->now() + kLook);
    }
    m_evidence.wrong = "its program does not end\n";
    return false;
  }

  /// What the machine has done since the last look.
  void judge(bool isDone) {
    const auto fetched = m_beside->fetchTrace();
    if (!fetched) {
      m_evidence.wrong = "no trace: " + fetched.error().text() + "\n";
      return;
    }
    trace::ControlTrace trace = *fetched;
    // A start that did not come about leaves the trace before it.
    std::erase_if(trace.blocks, [&](const auto& block) { return block.from <= m_judgedTo; });
    std::erase_if(trace.events, [&](const auto& event) { return event.from <= m_judgedTo; });
    m_judgedTo = fetched->samples.empty() ? m_judgedTo : fetched->samples.back().at;
    m_tools.add(tests::toolChanges(trace));
    const std::vector<std::string> made = tests::motions(trace);
    if (isDone) {
      m_motions.add(made);
      return;
    }
    tests::JobJudge soFar = m_motions;
    soFar.add(made);
    m_motions.add(made, tests::isAtNextEnd(m_source, soFar.done(), m_left.restart->rest,
                                           [this](std::size_t part) {
                                             return forecast::zeroAt(m_plan, tests::mill(), part);
                                           }));
  }

  std::uint64_t m_seed;
  std::string m_text;
  job::Plan m_plan;
  trace::ControlTrace m_source;
  tests::LeftJob m_left;
  tests::JobJudge m_motions;
  tests::JobJudge m_tools;
  tests::LoopbackMachine m_cell;
  std::unique_ptr<opcua::UaLink> m_beside;  ///< without faults, of whoever comes after the client
  tests::FaultProxy m_proxy;
  streaming::RunSettings m_settings;
  Instant m_judgedTo{};  ///< of the machine's trace
  Evidence m_evidence;
};

}  // namespace

class TestJobNetwork : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { RIVULET_SKIP_WITHOUT_LINK(); }

  /// Some jobs at the same time: they mostly wait.
  void drawnJobs() {
    const int first = tests::setting("RIVULET_FIRST", 1);
    const int count = tests::setting("RIVULET_SCENARIOS", 4);
    const int together = tests::setting("RIVULET_JOBS", 4);
    std::atomic<int> next{0};
    std::mutex mutex;
    std::map<std::string, int> interruptedBy;
    std::size_t motions = 0;
    int completed = 0;
    int resumed = 0;
    int refused = 0;
    int resumes = 0;
    std::vector<std::string> wrong;
    const auto work = [&] {
      for (int i = next++; i < count; i = next++) {
        const Evidence evidence = Exposure(static_cast<std::uint64_t>(first + i)).run();
        const std::lock_guard lock(mutex);
        for (const auto& [what, times] : evidence.interruptedBy) {
          interruptedBy[what] += times;
        }
        motions += evidence.motions;
        resumes += evidence.resumes;
        ++(evidence.isRefused ? refused : evidence.resumes > 0 ? resumed : completed);
        const std::string story = fmt::format("seed {}: {}{}", first + i, evidence.wrong,
                                              fmt::join(evidence.story, "\n"));
        if (!evidence.wrong.empty()) {
          wrong.push_back(story);
        } else if (evidence.isRefused) {
          qInfo("%s", story.c_str());
        }
      }
    };
    std::vector<std::thread> threads;
    for (int job = 0; job < std::min(together, count); ++job) {
      threads.emplace_back(work);
    }
    for (std::thread& thread : threads) {
      thread.join();
    }
    QStringList by;
    for (const auto& [what, times] : interruptedBy) {
      by << QStringLiteral("%1 %2").arg(QString::fromStdString(what)).arg(times);
    }
    qInfo(
        "%zu motions in the sources; %d jobs completed, %d after %d interruptions in all, %d "
        "refused, %zu wrong or lost; interrupted by: %s",
        motions, completed, resumed, resumes, refused, wrong.size(),
        qPrintable(by.join(QStringLiteral(", "))));
    for (const std::string& one : wrong) {
      qWarning("%s", one.c_str());
    }
    QVERIFY(wrong.empty());
    QVERIFY(count < 4 || resumed > 0);
    // Of an eighth of the parts.
    QVERIFY(count < 100 || interruptedBy.contains("reset at the control"));
  }
};

RIVULET_TEST(TestJobNetwork)
#include "tst_job_network.moc"
