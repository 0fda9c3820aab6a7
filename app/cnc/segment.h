// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The memory that the six tasks, the scheduler and the axes share: ring buffers and one mailbox
/// per task. In one process it is ordinary memory, between processes it is shared memory.
/// @threadsafety the rings as they say; a mailbox between its task and the scheduler.
#pragma once

#include <array>
#include <atomic>
#include <boost/interprocess/mapped_region.hpp>
#include <boost/interprocess/shared_memory_object.hpp>
#include <cstdint>
#include <memory>
#include <string>

#include "base/result.h"
#include "cnc/clock.h"
#include "pipeline/items.h"
#include "pipeline/pipeline.h"
#include "pipeline/ring.h"
#include "pipeline/task.h"

namespace rivulet::cnc {

/// A set point on its way from position control to the axes.
struct AxisPoint {
  static constexpr std::string_view kLayout = "B6 axis point 1";
  pipeline::SetPoint point{};
  std::int64_t sentNs = 0;  ///< monotonic
};

enum class Instruction : std::uint32_t { None, Run, Quit };

struct Mailbox {
  Semaphore wake;
  // To the task.
  std::atomic<Instruction> instruction{Instruction::None};
  std::atomic<std::int64_t> notBeforeNs{0};  ///< of the step
  // From the task.
  std::atomic<bool> isReady{false};      ///< it waits for instructions
  std::atomic<bool> hasAnswered{false};  ///< what follows is valid
  std::atomic<bool> inputHasArrived{false};
  std::uint8_t made = 0;
  std::uint8_t next = 0;  ///< pipeline::Need
  bool hasFailed = false;
  std::int64_t beganNs = 0;
  std::int64_t endedNs = 0;
  pipeline::BoundedText<500> error{};
};

/// What a task has to know before it begins.
struct Setup {
  pipeline::BoundedText<500> preset{};
  std::int64_t cycleNs = 0;
  pipeline::BoundedText<1000> program{};  ///< path; empty: the program comes over TCP
  std::int32_t priority = 0;              ///< of SCHED_FIFO; 0: not asked for
  std::int32_t core = -1;                 ///< for position control; -1: any
};

struct Segment {
  /// Of this version of the program.
  static constexpr std::uint64_t kLayout = base::hashOf("rivulet-cnc segment 1") ^
                                           pipeline::RingMemory<AxisPoint>::kLayout ^
                                           pipeline::RingMemory<pipeline::RoughBlock>::kLayout;

  std::uint64_t layout = kLayout;
  Semaphore bell;  ///< wakes the scheduler
  Setup setup;
  std::atomic<std::int32_t> port{0};  ///< where the program is expected, once it is
  pipeline::Rings rings;
  pipeline::RingMemory<AxisPoint> axes;
  std::array<Mailbox, pipeline::kTaskCount> mailboxes;

  [[nodiscard]] Mailbox& mailbox(pipeline::Task task) { return mailboxes[indexOf(task)]; }
};

/// A segment in shared memory. Its maker removes the name; who has opened it keeps the memory.
class SharedSegment {
 public:
  [[nodiscard]] static base::Result<SharedSegment> make(const std::string& name);
  /// @return an error if there is none, or if it was made by another version
  [[nodiscard]] static base::Result<SharedSegment> open(const std::string& name);
  SharedSegment(SharedSegment&& other) noexcept;
  SharedSegment& operator=(SharedSegment&&) = delete;
  ~SharedSegment();

  [[nodiscard]] Segment& segment() { return *m_segment; }

 private:
  SharedSegment(std::string name, bool isOwner, boost::interprocess::mapped_region region);

  std::string m_name;
  bool m_isOwner;
  boost::interprocess::mapped_region m_region;
  Segment* m_segment;
};

}  // namespace rivulet::cnc
