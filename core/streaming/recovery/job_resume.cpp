// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/recovery/job_resume.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "job/main_program.h"
#include "opcua/await.h"
#include "opcua/forwarding_link.h"
#include "streaming/recovery/resume.h"
#include "streaming/recovery/run_on_control.h"
#include "streaming/run/whole_job.h"

namespace rivulet::streaming {

namespace {

using base::Result;
using opcua::Variable;
using opcua::VariableKind;
using templates::JobProtocol;

/// Tells the positions of the axes in a workpiece frame, as an active program does.
class FrameLink final : public opcua::ForwardingLink {
 public:
  FrameLink(opcua::Link& link, base::Vec3 zeroMm) : ForwardingLink(link), m_zeroMm(zeroMm) {}

  base::RequestId read(std::span<const Variable> variables, base::Duration deadline,
                       opcua::Grouping grouping) override {
    const base::RequestId id = m_link.read(variables, deadline, grouping);
    m_reads.emplace_back(id, std::vector<Variable>(variables.begin(), variables.end()));
    return id;
  }
  std::optional<opcua::Event> wait(base::Instant until) override {
    std::optional<opcua::Event> event = m_link.wait(until);
    const auto read = std::find_if(m_reads.begin(), m_reads.end(), [&event](const auto& each) {
      return event && each.first == event->request;
    });
    if (read == m_reads.end()) {
      return event;
    }
    const auto isActive = [&] {  // as far as it has been asked for
      for (std::size_t i = 0; i < read->second.size(); ++i) {
        if (read->second[i].kind == VariableKind::ChannelStatus) {
          return event->readings[i].number != opcua::kChannelReset;
        }
      }
      return false;
    };
    const bool isMachine = event->kind == opcua::EventKind::ReadDone && !isActive();
    for (std::size_t i = 0; isMachine && i < read->second.size(); ++i) {
      const Variable& variable = read->second[i];
      if (variable.kind == VariableKind::ActualPosition &&
          variable.index < static_cast<int>(base::kAxisCount)) {
        event->readings[i].number -= m_zeroMm[static_cast<std::size_t>(variable.index)];
      }
    }
    m_reads.erase(read);
    return event;
  }

 private:
  base::Vec3 m_zeroMm;
  std::vector<std::pair<base::RequestId, std::vector<Variable>>> m_reads;
};

/// A block that may be executed again from anywhere within it: it says what holds, not what to do.
/// An arc or an increment would lead elsewhere.
bool isRepeatable(const job::NativeBlock& native) {
  using job::NativeReason;
  const bool steps = native.increments != decltype(native.increments){};
  const bool moves = native.moves && !native.isHalf;
  return native.isInserted || (native.reason == NativeReason::Retract && !steps) ||
         (native.reason >= NativeReason::Tool && native.reason <= NativeReason::Mode && !moves);
}

/// What the control tells of the job.
struct Told {
  bool isReset = false;
  double call = 0.0;
  int owner = 0;          ///< number of the run that it obeys
  double block = 0.0;     ///< see `job::blockCell`
  bool hasMoved = false;  ///< of the windows of a stretch
};

class Search {
 public:
  Search(opcua::Link& link, const job::Plan& plan, const RunSettings& settings,
         const Checkpoint& last, const std::function<Result<base::Vec3>(std::size_t part)>& zeroAt,
         ActiveProgram active)
      : m_link(link),
        m_plan(plan),
        m_settings(settings),
        m_last(last),
        m_zeroAt(zeroAt),
        m_active(active) {}

  Result<JobRest> run() {
    Result<job::JobPrograms> programs = job::makePrograms(m_plan, m_settings.parameters);
    if (!programs) {
      return base::fail(programs.error());
    }
    const int job = programs->number;
    const Result<Told> first = ask(programs->loop);
    if (!first) {
      return base::fail(first.error());
    }
    Told told = *first;
    if (JobProtocol::jobOf(told.call) != job) {
      return ofAnother(told,
                       "The control does not know this job: it was switched off since then, or has "
                       "run another program. ");
    }
    const bool waits = !told.isReset && told.call >= 0.0;
    const bool isBegun =
        begunIn(told) == JobProtocol::stretchOf(told.call) && JobProtocol::stretchOf(told.call) > 0;
    // In a stretch that has begun, what it executes meanwhile counts.
    if (waits && !isBegun && m_active == ActiveProgram::IsEnded) {
      RunOnControl onControl;
      onControl.baseCell = m_settings.parameters.baseCell;
      onControl.job = job;
      if (Result<void> ended = endRun(m_link, onControl, m_settings); !ended) {
        return base::fail(ended.error());
      }
      const Result<Told> then = ask(programs->loop);
      if (!then) {
        return base::fail(then.error());
      }
      told = *then;
    }
    return place(told, job);
  }

 private:
  [[nodiscard]] std::size_t partOfStretch(int number) const {
    const auto is = [number](const job::Part& part) {
      const auto* const stretch = std::get_if<job::Stretch>(&part);
      return stretch != nullptr && stretch->number == number;
    };
    return static_cast<std::size_t>(std::find_if(m_plan.parts.begin(), m_plan.parts.end(), is) -
                                    m_plan.parts.begin());
  }

  [[nodiscard]] Result<Told> ask(const templates::JobLoop& loop) {
    const std::array<Variable, 6> watched{{{VariableKind::ChannelStatus, 0},
                                           opcua::rParameter(loop.callCell),
                                           opcua::rParameter(loop.cells.owner),
                                           opcua::rParameter(job::blockCell(loop)),
                                           opcua::rParameter(loop.cells.latched),
                                           opcua::rParameter(loop.cells.executed)}};
    const auto numbers = opcua::readNumbers(m_link, watched, m_settings.setupDeadline);
    if (!numbers) {
      return base::fail(numbers.error());
    }
    return Told{(*numbers)[0] == opcua::kChannelReset, (*numbers)[1], runNumberOf((*numbers)[2]),
                (*numbers)[3], (*numbers)[4] != 0.0 || (*numbers)[5] != 0.0};
  }

  /// The stretch that `m_last` is of; 0: none.
  [[nodiscard]] int begunIn(const Told& told) const {
    return m_last.runNumber - (told.owner - JobProtocol::stretchOf(told.call));
  }

  /// The control tells of something else than what was kept. @param why  it does
  Result<JobRest> ofAnother(const Told& told, std::string why) {
    if (!isBeforeFirstBlock(m_last)) {
      return base::fail(StreamError::CannotResume, std::move(why) + kChooseStretch,
                        m_plan.program.name);
    }
    return told.isReset ? rest(0, {}) : base::fail(channelBusy());
  }

  Result<JobRest> place(const Told& told, int job) {
    const int stretch = JobProtocol::stretchOf(told.call);
    const int begun = begunIn(told);
    const bool isOurs = stretch == 0 ? told.owner == 0 || begun == 0
                                     : begun >= 0 && begun <= stretch &&
                                           partOfStretch(stretch) < m_plan.parts.size();
    if (!isOurs || std::abs(told.call) != JobProtocol::callNumber(job, stretch)) {
      return ofAnother(told,
                       "The control has run this job once more since then: what it has done is not "
                       "known here. ");
    }
    const std::size_t part = stretch > 0 ? partOfStretch(stretch) : 0;
    if (told.call < 0.0) {
      const std::size_t from = stretch > 0 ? part + 1 : 0;
      return told.isReset ? afterStretch(from, told)
                          : base::fail(StreamError::ChannelBusy, stillExecutes(stretch));
    }
    if (stretch == 0) {
      Result<JobRest> beginning = rest(0, {});
      if (beginning && !told.isReset) {
        beginning->restMm = 0.0;
      }
      return beginning;
    }
    return begun == stretch ? inStretch(part) : beforeStretch(part, told);
  }

  [[nodiscard]] std::string stillExecutes(int stretch) const {
    return fmt::format(
        "The control still is in blocks of the job, {}, where its axes stand without a client. End "
        "it (rivulet-cli runs --end, or EndRun of a service): it executes the block that it is in. "
        "Then resume.",
        stretch > 0 ? fmt::format("after stretch {}", stretch) : "before its first stretch");
  }

  /// The control was executing the windows of a stretch, or waiting for them.
  Result<JobRest> inStretch(std::size_t part) {
    const Result<base::Vec3> zero = m_zeroAt(part);
    if (!zero) {
      return base::fail(zero.error());
    }
    FrameLink link(m_link, *zero);
    const auto& stretch = std::get<job::Stretch>(m_plan.parts[part]);
    const Result<LeftAt> left =
        leftAt(link, programOf(m_plan, stretch), m_settings, m_last, {}, m_active);
    if (!left) {
      return base::fail(left.error());
    }
    Result<JobRest> found = left->resume ? rest(part, left->resume) : rest(part + 1, {});
    if (found && left->restMm) {
      const Result<base::Vec3> zeroThen = m_zeroAt(found->part);
      if (!zeroThen) {
        return base::fail(zeroThen.error());
      }
      found->toolMm = left->toolMm + *zero - *zeroThen;
      found->restMm = left->restMm;
    }
    return found;
  }

  /// The control has executed all native blocks before a stretch of which no window was sent.
  Result<JobRest> beforeStretch(std::size_t part, const Told& told) {
    if (told.hasMoved) {
      return base::fail(StreamError::CannotResume,
                        std::string("The control has executed points of which nothing was kept "
                                    "here. ") +
                            kChooseStretch,
                        m_plan.program.name);
    }
    Result<JobRest> found = rest(part, {});
    if (found && !told.isReset) {
      found->restMm = 0.0;
    }
    return found;
  }

  /// The control was executing native blocks. @param from  the first part that may be one of them
  Result<JobRest> afterStretch(std::size_t from, const Told& told) {
    const double block = told.block;
    // Until the loop has returned, the same cell has the number of the run. It could be that of a
    // block or of the end: nothing is taken for known then.
    const bool isRun = block == told.owner;
    const double done = job::doneNumber(m_plan);
    if (block == 0.0 || (isRun && block > done)) {
      return rest(from, {});
    }
    if (block == done && !isRun) {
      return rest(m_plan.parts.size(), {});
    }
    const double sought = isRun ? 0.0 : std::abs(block);
    double number = 0.0;
    for (std::size_t at = 0; at < m_plan.parts.size(); ++at) {
      const auto* const native = std::get_if<job::NativeBlock>(&m_plan.parts[at]);
      number += native != nullptr ? 1.0 : 0.0;
      if (native == nullptr || number != sought) {
        continue;
      }
      if (block < 0.0) {
        return rest(std::max(at + 1, from), {});  // none has begun since, or since the stretch
      }
      if (at < from || !isRepeatable(*native)) {
        return base::fail(
            StreamError::CannotResume,
            fmt::format(
                "The job ended within line {} ({}): what that block has done is not known. ",
                native->place.line.value, native->source) +
                kChooseStretch,
            m_plan.program.name);
      }
      return rest(at, {});
    }
    return base::fail(
        StreamError::CannotResume,
        std::string("It is not known which block the control executed last. ") + kChooseStretch,
        m_plan.program.name);
  }

  Result<JobRest> rest(std::size_t part, std::optional<Resume> resume) {
    if (part >= m_plan.parts.size()) {
      return base::fail(StreamError::CannotResume, "Every block has been executed already.",
                        m_plan.program.name);
    }
    if (part == 0 && !resume) {
      return JobRest{};  // the job begins at its beginning, wherever the tool stands
    }
    const Result<base::Vec3> zero = m_zeroAt(part);
    if (!zero) {
      return base::fail(zero.error());
    }
    const std::array<Variable, 4> position{{{VariableKind::ChannelStatus, 0},
                                            {VariableKind::ActualPosition, 0},
                                            {VariableKind::ActualPosition, 1},
                                            {VariableKind::ActualPosition, 2}}};
    FrameLink link(m_link, *zero);
    const auto numbers = opcua::readNumbers(link, position, m_settings.setupDeadline);
    if (!numbers) {
      return base::fail(numbers.error());
    }
    return JobRest{part, resume, base::Vec3{(*numbers)[1], (*numbers)[2], (*numbers)[3]}};
  }

  opcua::Link& m_link;
  const job::Plan& m_plan;
  const RunSettings& m_settings;
  const Checkpoint& m_last;
  const std::function<Result<base::Vec3>(std::size_t part)>& m_zeroAt;
  ActiveProgram m_active;
};

}  // namespace

bool isBeforeFirstBlock(const Checkpoint& last) {
  return !last.granted && last.pointCount == 0;
}

Result<JobRest> whereJobWasLeft(opcua::Link& link, const job::Plan& plan,
                                const RunSettings& settings, const Checkpoint& last,
                                const std::function<Result<base::Vec3>(std::size_t part)>& zeroAt,
                                ActiveProgram active) {
  return Search(link, plan, settings, last, zeroAt, active).run();
}

}  // namespace rivulet::streaming
