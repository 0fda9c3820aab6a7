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

constexpr const char* kFromStretch = " Choose a stretch to begin with (--from-stretch).";

/// Tells the positions of the axes in a workpiece frame.
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
    for (std::size_t i = 0; event->kind == opcua::EventKind::ReadDone && i < read->second.size();
         ++i) {
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

/// A block that may be executed again: it says what holds, not what to do.
bool isRepeatable(const job::NativeBlock& native) {
  using job::NativeReason;
  const bool moves = native.increments != decltype(native.increments){};
  return (native.reason == NativeReason::Retract && !moves) ||
         (native.reason >= NativeReason::Tool && native.reason <= NativeReason::Mode);
}

class Search {
 public:
  Search(opcua::Link& link, const job::Plan& plan, const RunSettings& settings,
         const Checkpoint& last, const std::function<Result<base::Vec3>(std::size_t part)>& zeroAt)
      : m_link(link), m_plan(plan), m_settings(settings), m_last(last), m_zeroAt(zeroAt) {}

  Result<JobRest> run() {
    Result<job::JobPrograms> programs = job::makePrograms(m_plan, m_settings.parameters);
    if (!programs) {
      return base::fail(programs.error());
    }
    const templates::JobLoop& loop = programs->loop;
    const std::array<Variable, 4> watched{{opcua::rParameter(loop.callCell),
                                           opcua::rParameter(loop.cells.owner),
                                           opcua::rParameter(job::blockCell(loop)),
                                           {VariableKind::ChannelStatus, 0}}};
    const auto numbers = opcua::readNumbers(m_link, watched, m_settings.setupDeadline);
    if (!numbers) {
      return base::fail(numbers.error());
    }
    const double call = (*numbers)[0];
    const int stretch = JobProtocol::stretchOf(call);
    const int owner = runNumberOf((*numbers)[1]);
    const int begun = m_last.runNumber - (owner - stretch);
    if (std::abs(call) != JobProtocol::callNumber(programs->number, stretch) || begun < 1 ||
        begun > stretch || partOfStretch(stretch) == m_plan.parts.size()) {
      return base::fail(StreamError::CannotResume,
                        std::string("The control does not know this job: it was switched off since "
                                    "then, or has run another program.") +
                            kFromStretch,
                        m_plan.program.name);
    }
    const std::size_t part = partOfStretch(stretch);
    if (call < 0.0) {
      return (*numbers)[3] == opcua::kChannelReset ? afterStretch(part, (*numbers)[2], owner)
                                                   : base::fail(channelBusy());
    }
    return begun == stretch ? inStretch(part) : beforeStretch(part, owner);
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

  /// The control was executing the windows of a stretch, or waiting for them.
  Result<JobRest> inStretch(std::size_t part) {
    const Result<base::Vec3> zero = m_zeroAt(part);
    if (!zero) {
      return base::fail(zero.error());
    }
    FrameLink link(m_link, *zero);
    const auto& stretch = std::get<job::Stretch>(m_plan.parts[part]);
    const Result<std::optional<Resume>> left =
        leftAt(link, programOf(m_plan, stretch), m_settings, m_last);
    if (!left) {
      return base::fail(left.error());
    }
    return *left ? rest(part, **left) : rest(part + 1, {});
  }

  /// The control has executed all native blocks before a stretch of which no window was sent.
  Result<JobRest> beforeStretch(std::size_t part, int owner) {
    RunOnControl run;
    run.baseCell = m_settings.parameters.baseCell;
    run.number = owner;
    if (Result<void> ended = endRun(m_link, run, m_settings); !ended) {
      return base::fail(ended.error());
    }
    return rest(part, {});
  }

  /// The control was executing the native blocks after a stretch. @param block  see `blockCell`
  /// @param owner  number of the run; the client's, in the same cell, until the loop has returned
  Result<JobRest> afterStretch(std::size_t part, double block, int owner) {
    if (block == 0.0) {
      return rest(part + 1, {});
    }
    // The number of a run could be that of a block: no block is taken for known then.
    const double sought = block == owner ? 0.0 : std::abs(block);
    double number = 0.0;
    for (std::size_t at = 0; at < m_plan.parts.size(); ++at) {
      const auto* const native = std::get_if<job::NativeBlock>(&m_plan.parts[at]);
      number += native != nullptr ? 1.0 : 0.0;
      if (native == nullptr || number != sought) {
        continue;
      }
      if (block < 0.0) {
        return rest(std::max(at, part) + 1, {});  // none has begun since, or since the stretch
      }
      if (at < part || !isRepeatable(*native)) {
        return base::fail(
            StreamError::CannotResume,
            fmt::format("The job ended within line {} ({}): what that block has done is not known.",
                        native->place.line.value, native->source) +
                kFromStretch,
            m_plan.program.name);
      }
      return rest(at, {});
    }
    return base::fail(
        StreamError::CannotResume,
        std::string("It is not known which block the control executed last.") + kFromStretch,
        m_plan.program.name);
  }

  Result<JobRest> rest(std::size_t part, std::optional<Resume> resume) {
    if (part >= m_plan.parts.size()) {
      return base::fail(StreamError::CannotResume, "Every block has been executed already.",
                        m_plan.program.name);
    }
    const Result<base::Vec3> zero = m_zeroAt(part);
    if (!zero) {
      return base::fail(zero.error());
    }
    const std::array<Variable, 3> position{{{VariableKind::ActualPosition, 0},
                                            {VariableKind::ActualPosition, 1},
                                            {VariableKind::ActualPosition, 2}}};
    const auto numbers = opcua::readNumbers(m_link, position, m_settings.setupDeadline);
    if (!numbers) {
      return base::fail(numbers.error());
    }
    return JobRest{part, resume, base::Vec3{(*numbers)[0], (*numbers)[1], (*numbers)[2]} - *zero};
  }

  opcua::Link& m_link;
  const job::Plan& m_plan;
  const RunSettings& m_settings;
  const Checkpoint& m_last;
  const std::function<Result<base::Vec3>(std::size_t part)>& m_zeroAt;
};

}  // namespace

Result<JobRest> whereJobWasLeft(opcua::Link& link, const job::Plan& plan,
                                const RunSettings& settings, const Checkpoint& last,
                                const std::function<Result<base::Vec3>(std::size_t part)>& zeroAt) {
  return Search(link, plan, settings, last, zeroAt).run();
}

}  // namespace rivulet::streaming
