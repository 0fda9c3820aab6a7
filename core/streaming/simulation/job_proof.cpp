// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/simulation/job_proof.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "job/main_program.h"
#include "job/plan_writer.h"
#include "machine/machine.h"
#include "streaming/run/whole_job.h"
#include "streaming/simulation/simulated_link.h"
#include "trace/control_trace.h"

namespace rivulet::streaming {

namespace {

using trace::ControlEvent;
using trace::ControlTrace;
using trace::ExecutedBlock;

/// Shorter motions are those of axes that begin where the control has read them.
constexpr double kShortMm = 0.01;

class QuietConsole final : public WholeJobSink, public RunOrders {
 public:
  bool stopRequested(base::Instant) override { return false; }
  void update(const LiveUpdate&) override {}
  void access(const trace::Access&) override {}
  void note(const trace::Note&) override {}
  void nativeBlocks(int) override {}
  void stretchBegins(const job::Stretch&, base::Vec3) override {}
  bool waitsForCycleStart() override { return true; }
};

/// @return nothing: it ends with an alarm, or takes longer than the trace
std::optional<ControlTrace> traceOf(const machine::MachineConfig& config, const std::string& text,
                                    std::uint64_t seed) {
  machine::Machine machine(config, seed);
  SimulatedLink link(machine);
  if (!link.uploadProgram("PLAIN.MPF", text, true) || !link.selectProgram("PLAIN.MPF") ||
      !link.cycleStart()) {
    return std::nullopt;
  }
  const base::Instant until = link.now() + config.traceLimit;
  while (machine.state().channel != machine::ChannelStatus::Reset) {
    if (link.now() > until || machine.state().alarm != 0) {
      return std::nullopt;
    }
    if (machine.state().channel == machine::ChannelStatus::Interrupted) {
      (void)link.cycleStart();  // M0
    }
    (void)link.wait(link.now() + std::chrono::milliseconds{100});
  }
  auto trace = link.fetchTrace();
  return trace && !trace->truncated ? std::optional(std::move(*trace)) : std::nullopt;
}

base::Duration timeOf(const ControlTrace& trace) {
  return trace.blocks.empty() ? base::Duration{}
                              : trace.blocks.back().to - trace.blocks.front().from;
}

double distance(const ExecutedBlock& a, const ExecutedBlock& b) {
  double turnDeg = 0.0;
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    turnDeg = std::max(turnDeg, std::abs(a.targetDeg[axis] - b.targetDeg[axis]));
  }
  return std::max(base::distance(a.targetMm, b.targetMm), turnDeg);
}

/// Of each motion of the source, the block of the job that ends in the same place; in order.
struct Matches {
  std::vector<const ExecutedBlock*> plain;
  std::vector<const ExecutedBlock*> asJob;
};

Matches match(const ControlTrace& plain, const ControlTrace& asJob, JobProof& proof) {
  Matches matches;
  std::size_t at = 0;
  for (const ExecutedBlock& block : plain.blocks) {
    if (block.lengthMm <= kShortMm && block.turnDeg <= kShortMm) {
      continue;
    }
    while (at < asJob.blocks.size() && distance(block, asJob.blocks[at]) > kSameEndMm) {
      ++at;
    }
    if (at == asJob.blocks.size()) {
      proof.difference = fmt::format(
          "The job does not reach the end of line {} of its comparison, X {:.3f} Y {:.3f} Z "
          "{:.3f}.",
          block.line.value, block.targetMm.x, block.targetMm.y, block.targetMm.z);
      return matches;
    }
    // Points may be closer than what counts as the same.
    while (at + 1 < asJob.blocks.size() &&
           distance(block, asJob.blocks[at + 1]) < distance(block, asJob.blocks[at])) {
      ++at;
    }
    proof.farthestMm = std::max(proof.farthestMm, distance(block, asJob.blocks[at]));
    matches.plain.push_back(&block);
    matches.asJob.push_back(&asJob.blocks[at]);
    ++at;
  }
  proof.ends = matches.plain.size();
  return matches;
}

/// What the machine does besides moving, and how many of the motions come before it. Dwells are
/// left out: the loop waits with them.
struct Deed {
  const ControlEvent* event;
  std::size_t ends;
};

std::vector<Deed> deedsOf(const ControlTrace& trace,
                          const std::vector<const ExecutedBlock*>& ends) {
  std::vector<Deed> deeds;
  for (const ControlEvent& event : trace.events) {
    if (event.kind != ControlEvent::Kind::Dwell) {
      const auto after =
          std::find_if(ends.begin(), ends.end(), [&event](const ExecutedBlock* block) {
            return block->from >= event.from || block->to > event.from;
          });
      deeds.push_back({&event, static_cast<std::size_t>(after - ends.begin())});
    }
  }
  return deeds;
}

void compareDeeds(const ControlTrace& plain, const ControlTrace& asJob, const Matches& matches,
                  JobProof& proof) {
  const std::vector<Deed> expected = deedsOf(plain, matches.plain);
  const std::vector<Deed> found = deedsOf(asJob, matches.asJob);
  for (std::size_t i = 0; i < std::max(expected.size(), found.size()); ++i) {
    const bool isSame = i < expected.size() && i < found.size() &&
                        expected[i].event->kind == found[i].event->kind &&
                        expected[i].event->value == found[i].event->value &&
                        expected[i].event->name == found[i].event->name &&
                        expected[i].ends == found[i].ends;
    if (!isSame) {
      const auto words = [i](const std::vector<Deed>& of) {
        return i < of.size() ? fmt::format("action {} with {} after motion {}",
                                           static_cast<int>(of[i].event->kind), of[i].event->value,
                                           of[i].ends)
                             : std::string("nothing");
      };
      proof.difference = fmt::format("The machine does {} in the job, and {} in its comparison.",
                                     words(found), words(expected));
      return;
    }
  }
}

}  // namespace

std::string modalDifference(const job::Plan& plan) {
  if (plan.program.dialect != nc::Dialect::Sinumerik) {
    return {};
  }
  gcode::LoadOptions options;
  options.dialect = nc::Dialect::Sinumerik;
  const auto again = job::makePlan("JOB.MPF", job::outlineOf(plan).text, options);
  if (!again) {
    return again.error().text();
  }
  std::vector<const job::NativeBlock*> made;
  for (const job::Part& part : again->parts) {
    if (const auto* const native = std::get_if<job::NativeBlock>(&part)) {
      made.push_back(native);
    }
  }
  std::size_t at = 0;
  for (const job::Part& part : plan.parts) {
    const auto* const native = std::get_if<job::NativeBlock>(&part);
    if (native == nullptr || native->text.empty()) {
      continue;
    }
    while (at < made.size() && made[at]->text != native->text) {
      ++at;  // what the job sets before a native block is none of the source
    }
    if (at == made.size()) {
      return fmt::format("Line {} is not in the job: {}", native->place.line.value, native->source);
    }
    const std::string expected = job::modalWords(native->before);
    nc::ModalState state = made[at]->before;
    if (native->before.motion >= nc::Motion::None) {
      state.motion =
          nc::Motion::None;  // G1 by default, which the loop leaves; or a curve, which has ended
    }
    const std::string found = job::modalWords(state);
    if (expected != found || native->frame != made[at]->frame) {
      return fmt::format("Line {} runs with {} in the job, and with {} in the source: {}",
                         native->place.line.value, found, expected, native->source);
    }
    ++at;
  }
  return {};
}

base::Result<JobProof> proveJob(const job::Plan& plan, const machine::MachineConfig& config,
                                const RunSettings& settings, std::uint64_t seed) {
  JobProof proof;
  std::optional<ControlTrace> plain;
  if (plan.program.dialect == nc::Dialect::Sinumerik) {
    plain = traceOf(config, plan.program.text + "\nM30\n", seed);
    proof.isSource = plain.has_value();
  }
  if (!plain) {
    plain = traceOf(config, job::plainProgramOf(plan, settings.programFeeds, settings.feedMmPerS),
                    seed);
  }
  if (!plain) {
    return base::fail(StreamError::NotStarted,
                      "The virtual machine does not run the program to its end within its trace: "
                      "there is nothing to compare the job with.",
                      plan.program.name);
  }
  machine::Machine machine(config, seed);
  SimulatedLink link(machine);
  QuietConsole console;
  const WholeJobReport done = runWholeJob(link, link, plan, settings, console, console);
  if (done.outcome != Outcome::Completed) {
    return base::fail(done.error);
  }
  if (done.controlTrace == nullptr || done.controlTrace->truncated) {
    return base::fail(StreamError::NotStarted, "The job is longer than the trace of the machine.",
                      plan.program.name);
  }
  proof.plain = timeOf(*plain);
  proof.asJob = timeOf(*done.controlTrace);
  const Matches matches = match(*plain, *done.controlTrace, proof);
  if (proof.difference.empty()) {
    compareDeeds(*plain, *done.controlTrace, matches, proof);
  }
  if (proof.difference.empty()) {
    proof.difference = modalDifference(plan);
  }
  return proof;
}

}  // namespace rivulet::streaming
