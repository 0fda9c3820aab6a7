// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cnc/segment.h"

#include <fmt/format.h>

#include <boost/interprocess/exceptions.hpp>
#include <new>
#include <utility>

#include "pipeline/error.h"

namespace rivulet::cnc {

namespace ipc = boost::interprocess;

SharedSegment::SharedSegment(std::string name, bool isOwner, ipc::mapped_region region)
    : m_name(std::move(name)),
      m_isOwner(isOwner),
      m_region(std::move(region)),
      m_segment(isOwner ? new (m_region.get_address()) Segment
                        : static_cast<Segment*>(m_region.get_address())) {
}

SharedSegment::SharedSegment(SharedSegment&& other) noexcept
    : m_name(std::move(other.m_name)),
      m_isOwner(std::exchange(other.m_isOwner, false)),
      m_region(std::move(other.m_region)),
      m_segment(std::exchange(other.m_segment, nullptr)) {
}

SharedSegment::~SharedSegment() {
  if (m_isOwner) {
    m_segment->~Segment();
    ipc::shared_memory_object::remove(m_name.c_str());
  }
}

base::Result<SharedSegment> SharedSegment::make(const std::string& name) {
  try {
    ipc::shared_memory_object memory(ipc::create_only, name.c_str(), ipc::read_write,
                                     ipc::permissions(0600));
    memory.truncate(sizeof(Segment));
    return SharedSegment(name, true, ipc::mapped_region(memory, ipc::read_write));
  } catch (const ipc::interprocess_exception& error) {
    return base::fail(pipeline::PipelineError::RingLayout,
                      fmt::format("Shared memory cannot be made ({}). Free memory in /dev/shm, or "
                                  "run all tasks in one process, without --processes.",
                                  error.what()),
                      name);
  }
}

base::Result<SharedSegment> SharedSegment::open(const std::string& name) {
  const auto refuse = [&](const std::string& what) {
    return base::fail(pipeline::PipelineError::RingLayout,
                      fmt::format("The memory of the pipeline is refused: {}. Tasks are started by "
                                  "rivulet-cnc run --processes.",
                                  what),
                      name);
  };
  try {
    ipc::shared_memory_object memory(ipc::open_only, name.c_str(), ipc::read_write);
    ipc::mapped_region region(memory, ipc::read_write);
    if (region.get_size() < sizeof(Segment)) {
      return refuse("it is too small");
    }
    if (static_cast<const Segment*>(region.get_address())->layout != Segment::kLayout) {
      return refuse("it was made by another version");
    }
    return SharedSegment(name, false, std::move(region));
  } catch (const ipc::interprocess_exception& error) {
    return refuse(error.what());
  }
}

}  // namespace rivulet::cnc
