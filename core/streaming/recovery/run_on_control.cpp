// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/recovery/run_on_control.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "base/text.h"
#include "job/main_program.h"
#include "opcua/await.h"
#include "streaming/run/driver.h"
#include "streaming/run/feed_control.h"
#include "templates/flexible_program.h"
#include "templates/job_loop.h"

namespace rivulet::streaming {

namespace {

using base::Duration;
using base::Instant;
using base::Result;
using opcua::Variable;
using opcua::VariableKind;
using templates::JobProtocol;
using templates::WindowProtocol;

constexpr Duration kDeadline = kSetupDeadline;
constexpr Duration kRunPoll = std::chrono::milliseconds{100};
constexpr std::size_t kLabelFieldMax = 60;

Variable cell(int baseCell, WindowProtocol::Header place) {
  return opcua::rParameter(baseCell + place);
}

/// Whole numbers only: another program may have left anything in the cells.
std::size_t countOf(double number) {
  constexpr double kCountMax = 1e9;
  return number >= 0.0 && number <= kCountMax ? static_cast<std::size_t>(number) : 0;
}

/// Letters that cannot end a comment or a block of an NC program.
std::string labelField(std::string_view text) {
  std::string field(text.substr(0, kLabelFieldMax));
  std::replace_if(
      field.begin(), field.end(), [](char c) { return c < ' ' || c > '~' || c == '@'; }, '_');
  return field.empty() ? "-" : field;
}

/// The rest of the line that begins with `begin`.
std::optional<std::string> lineAfter(std::string_view text, std::string_view begin) {
  const std::size_t at = text.find(begin);
  if (at == std::string_view::npos) {
    return std::nullopt;
  }
  const std::string_view rest = text.substr(at + begin.size());
  return std::string(base::trim(rest.substr(0, rest.find('\n'))));
}

}  // namespace

std::string runLabelName(int baseCell) {
  return fmt::format("RIVULET_RUN_{}.SPF", baseCell);
}

std::string runLabelText(int number, const RunOrigin& origin) {
  return fmt::format(
      "; RIVULET RUN {}\n; user: {}\n; computer: {}\n; started: {}\n; Says who started the run. "
      "It is never called.\nM17\n",
      number, labelField(origin.user), labelField(origin.computer),
      labelField(origin.startedAtUtc));
}

std::optional<RunOrigin> runLabelOf(std::string_view text, int number) {
  const auto run = lineAfter(text, "; RIVULET RUN ");
  const auto user = lineAfter(text, "; user: ");
  const auto computer = lineAfter(text, "; computer: ");
  const auto started = lineAfter(text, "; started: ");
  if (!run || *run != std::to_string(number) || !user || !computer || !started) {
    return std::nullopt;
  }
  return RunOrigin{*user, *computer, *started};
}

std::string describeOrigin(int number, const std::optional<RunOrigin>& origin) {
  return origin ? fmt::format("{}, {}, {} (run {})", origin->user, origin->computer,
                              origin->startedAtUtc, number)
                : fmt::format("(run {})", number);
}

int runNumberOf(double cell) {
  return static_cast<int>(countOf(cell));
}

Result<void> storeRunLabel(opcua::Control& control, int baseCell, int number,
                           const RunOrigin& origin) {
  return control.uploadProgram(runLabelName(baseCell), runLabelText(number, origin), true);
}

Result<std::optional<RunOnControl>> RunWatch::look(opcua::Link& link, opcua::Control& control,
                                                   int baseCell) {
  const std::array<Variable, 2> channel{
      {{VariableKind::ChannelStatus, 0}, {VariableKind::ProgramName, 0}}};
  const auto shown = opcua::readNow(link, channel, kDeadline);
  if (!shown) {
    return base::fail(shown.error());
  }
  const auto job = (*shown)[1].status ? std::nullopt : job::jobNameOf((*shown)[1].text);
  const std::optional<int> first = (*shown)[1].status ? std::optional(baseCell)
                                   : job              ? std::optional(job->baseCell)
                                         : templates::baseCellOf((*shown)[1].text, baseCell);
  if ((*shown)[0].status || (*shown)[0].number == opcua::kChannelReset || !first) {
    *this = {};
    return std::nullopt;
  }
  RunOnControl run;
  run.programName = (*shown)[1].text;
  run.baseCell = *first;
  const std::array<Variable, 7> header{
      cell(*first, WindowProtocol::Delivered), cell(*first, WindowProtocol::Latched),
      cell(*first, WindowProtocol::Executed),  cell(*first, WindowProtocol::State),
      cell(*first, WindowProtocol::Owner),     cell(*first, WindowProtocol::Heartbeat),
      cell(*first, WindowProtocol::Asked)};
  const auto numbers = opcua::readNumbers(link, header, kDeadline);
  if (!numbers) {
    return base::fail(numbers.error());
  }
  run.delivered = countOf((*numbers)[0]);
  run.latched = countOf((*numbers)[1]);
  run.executed = countOf((*numbers)[2]);
  run.state = static_cast<templates::WindowState>(countOf((*numbers)[3]));
  run.number = runNumberOf((*numbers)[4]);
  run.heartbeat = (*numbers)[5];
  if (job && JobProtocol::jobOf((*numbers)[6]) == job->number) {
    run.job = job->number;
    run.stretch = JobProtocol::stretchOf((*numbers)[6]);
    run.isNative = (*numbers)[6] < 0.0;
  } else if (job) {
    return std::nullopt;  // it has just begun: its cells are still those of another program
  }
  if (m_last && m_last->isSameAs(run)) {
    run.origin = m_last->origin;
  } else if (run.number != 0) {
    const Result<std::string> label = control.downloadProgram(runLabelName(*first));
    run.origin = label ? runLabelOf(*label, run.number - run.stretch) : std::nullopt;
  }
  takeHeartbeat(run, link.now());
  m_last = run;
  return run;
}

void RunWatch::takeHeartbeat(RunOnControl& run, Instant now) {
  const bool isSame = m_last && m_last->isSameAs(run);
  if (!isSame || m_last->heartbeat != run.heartbeat) {
    m_hasBeaten = isSame;
    m_since = now;
  }
  const bool isSilent = now - m_since >= kHeartbeatWatch;
  run.hasClient = m_hasBeaten && !isSilent;
  m_isClientKnown = m_hasBeaten || isSilent;
}

Result<std::optional<RunOnControl>> findRun(opcua::Link& link, opcua::Control& control,
                                            int baseCell, Duration watchFor) {
  RunWatch watch;
  const Instant until = link.now() + watchFor;
  for (;;) {
    Result<std::optional<RunOnControl>> found = watch.look(link, control, baseCell);
    if (!found || !*found || (*found)->hasClient || link.now() >= until) {
      return found;
    }
    if (Result<void> slept = opcua::sleepUntil(link, std::min(until, link.now() + kRunPoll));
        !slept) {
      return base::fail(slept.error());
    }
  }
}

Result<void> endProgram(opcua::Link& link, const EndCommand& command, const RunSettings& settings) {
  std::vector<Variable> watched{{VariableKind::ChannelStatus, 0}, command.end.variable};
  watched.insert(watched.end(), command.identity.begin(), command.identity.end());
  const std::size_t feedCell = watched.size();
  const bool mayHold = command.feed && command.beat;
  if (mayHold) {
    watched.insert(watched.end(), {*command.feed, *command.beat});
  }
  std::optional<double> beatSeen;
  Instant beatenAt{};  // by somebody else
  double beats = 0.0;
  const Instant until = link.now() + settings.stopDeadline;
  for (;;) {
    const auto numbers = opcua::readNumbers(link, watched, settings.setupDeadline);
    if (!numbers) {
      return base::fail(numbers.error());
    }
    if ((*numbers)[0] == opcua::kChannelReset) {
      return {};
    }
    if (!command.isMeant(std::span(*numbers).subspan(2, command.identity.size()))) {
      return base::fail(StreamError::ChannelBusy, std::string(command.isAnother));
    }
    if (!command.goesOn && link.now() >= until) {
      return base::fail(StreamError::StopNotConfirmed, std::string(command.doesNotEnd));
    }
    if (command.goesOn && !command.goesOn()) {
      return base::fail(StreamError::Cancelled, "The end of the program was not awaited.");
    }
    std::vector<opcua::Assignment> due;
    if ((*numbers)[1] != command.end.value) {
      due.push_back(command.end);
    }
    bool isAnothers = false;
    if (mayHold && (*numbers)[feedCell] == templates::FeedCell::kHold) {
      const double beat = (*numbers)[feedCell + 1];
      beatenAt = beatSeen == beat ? beatenAt : link.now();
      beatSeen = beat;
      isAnothers = link.now() - beatenAt < kHeartbeatWatch;
      if (!isAnothers) {
        due.push_back({*command.feed, templates::FeedCell::kProgrammed});
      }
    }
    if (command.beat && !isAnothers) {
      due.push_back({*command.beat, beats += 1.0});
      beatSeen = beats;
    }
    if (!due.empty()) {
      if (Result<void> done = opcua::writeNow(link, due, settings.setupDeadline); !done) {
        return done;
      }
    }
    if (Result<void> slept = opcua::sleepUntil(link, link.now() + kRunPoll); !slept) {
      return slept;
    }
  }
}

namespace {

bool isStill(const RunOnControl& run, double identity) {
  return run.job != 0 ? JobProtocol::jobOf(identity) == run.job
                      : identity == static_cast<double>(run.number);
}

Variable identityOf(const RunOnControl& run) {
  return cell(run.baseCell, run.job != 0 ? WindowProtocol::Asked : WindowProtocol::Owner);
}

constexpr std::string_view kAnotherRun =
    "Another run has begun on the control. Nothing was changed.";

}  // namespace

Result<StoppedRun> stopRun(opcua::Link& link, const RunOnControl& run, const RunSettings& settings,
                           const std::function<bool()>& goesOn) {
  constexpr Duration kPoll = std::chrono::milliseconds{16};
  templates::CellMap cells;
  cells.overrideWanted = run.baseCell + WindowProtocol::Override;
  cells.overrideActs = run.baseCell + WindowProtocol::OverrideActs;
  const std::array<Variable, 2> watched{{{VariableKind::ChannelStatus, 0}, identityOf(run)}};
  const opcua::Assignment end{cell(run.baseCell, WindowProtocol::Run),
                              static_cast<double>(WindowProtocol::kEnd)};
  FeedControl feed(cells);
  const Instant from = link.now();
  feed.want({true}, from);
  for (;;) {
    const auto numbers = opcua::readNumbers(link, watched, settings.setupDeadline);
    if (!numbers) {
      return base::fail(numbers.error());
    }
    if ((*numbers)[0] == opcua::kChannelReset) {
      return StoppedRun{true, {}};
    }
    if (!isStill(run, (*numbers)[1])) {
      return base::fail(StreamError::ChannelBusy, std::string(kAnotherRun));
    }
    if (feed.mustWrite(link.now())) {
      if (Result<void> done = opcua::writeNow(link, feed.write(link.now()), settings.setupDeadline);
          !done) {
        return base::fail(done.error());
      }
      feed.written(link.now());
      if (Result<void> done = opcua::writeNow(link, {&end, 1}, settings.setupDeadline); !done) {
        return base::fail(done.error());
      }
    }
    if (feed.mustRead(link.now())) {
      const auto readings = opcua::readNow(link, feed.read(link.now()), settings.setupDeadline);
      if (!readings) {
        return base::fail(readings.error());
      }
      feed.seen(*readings, link.now());
    }
    const auto stood = feed.state().stoodAfter;
    // A program that waits for a window ends at once.
    if (stood && link.now() - from >= *stood + kEndsAtOnce) {
      return StoppedRun{false, stood};
    }
    if (!stood && link.now() - from >= kStandsMax && !goesOn()) {
      return base::fail(StreamError::StopNotConfirmed, "The stop was not awaited.");
    }
    if (Result<void> slept = opcua::sleepUntil(link, link.now() + kPoll); !slept) {
      return base::fail(slept.error());
    }
  }
}

Result<void> endRun(opcua::Link& link, const RunOnControl& run, const RunSettings& settings,
                    std::function<bool()> goesOn) {
  return endProgram(
      link,
      {{cell(run.baseCell, WindowProtocol::Run), static_cast<double>(WindowProtocol::kEnd)},
       {identityOf(run)},
       cell(run.baseCell, WindowProtocol::Heartbeat),
       [&run](std::span<const double> identity) { return isStill(run, identity[0]); },
       kAnotherRun,
       "The program on the control did not end. Reset the control.",
       std::move(goesOn),
       cell(run.baseCell, WindowProtocol::Override)},
      settings);
}

Result<void> stopByReset(opcua::Link& link, opcua::Control& control,
                         const std::function<bool()>& goesOn) {
  if (!control.abilities().startsOnRequest) {
    return base::fail(opcua::LinkError::MethodMissing,
                      "Rivulet cannot stop what the control executes now. Press NC STOP at the "
                      "machine.");
  }
  if (Result<void> done = control.reset(); !done) {
    return base::fail(
        done.error().code,
        "The control was not reset by this client, as where somebody else has started "
        "the program and is still connected. Press NC STOP at the machine.");
  }
  const Instant from = link.now();
  const Variable status{VariableKind::ChannelStatus, 0};
  for (;;) {
    const auto numbers = opcua::readNumbers(link, {&status, 1}, kDeadline);
    if (!numbers) {
      return base::fail(numbers.error());
    }
    if (numbers->front() == opcua::kChannelReset) {
      return {};
    }
    if (link.now() - from >= kStandsMax && !goesOn()) {
      return base::fail(StreamError::StopNotConfirmed,
                        "The reset was not confirmed. Press NC STOP at the machine.");
    }
    if (Result<void> slept = opcua::sleepUntil(link, link.now() + kRunPoll); !slept) {
      return slept;
    }
  }
}

}  // namespace rivulet::streaming
