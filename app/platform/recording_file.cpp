// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "platform/recording_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <condition_variable>
#include <mutex>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include "base/descriptor.h"
#include "base/file.h"
#include "platform/interrupt.h"
#include "trace/frames.h"

namespace rivulet::recorder {

namespace {

/// Pieces of at least this size are lists: see `append`.
constexpr std::size_t kListBytes = std::size_t{32} << 10U;
/// Text of one frame, at most.
constexpr std::size_t kFrameBytes = std::size_t{256} << 10U;
/// So long lines wait for others before they are written: less is lost if this program is killed.
constexpr std::chrono::milliseconds kFrameTime{500};

int syncAndClose(int descriptor) {
  const int error = base::syncToDisk(descriptor);
  const int closing = base::closeFile(descriptor);
  return error != 0 ? error : closing;
}

}  // namespace

struct RecordingFile::State {
  RecordingLimits limits;
  int descriptor = -1;
  std::mutex mutex;
  std::condition_variable changed;
  std::string waiting;                                 ///< to be written
  std::chrono::steady_clock::time_point waitingSince;  ///< its first line
  std::size_t inFlight = 0;                            ///< bytes that are being written
  std::size_t written = 0;                             ///< bytes
  base::Duration recorded{};                           ///< from the first record to the last one
  bool isClosing = false;                              ///< nothing more will come
  bool isDone = false;                                 ///< the file is closed
  bool isBehind = false;     ///< there was no room: the recording ends there
  bool isAbandoned = false;  ///< the file hung at the end
  int error = 0;             ///< of the system

  void work();
  int write(trace::FrameWriter& frames, std::string_view text);
};

/// The thread of the file. Signals are for the thread of the run; a pipe without its reader and a
/// file beyond its limit become errors of `write`.
void RecordingFile::State::work() {
  interrupt::leaveToOtherThreads();
  trace::FrameWriter frames;
  std::unique_lock lock(mutex);
  for (;;) {
    changed.wait(lock, [this] { return !waiting.empty() || isClosing; });
    if (waiting.empty()) {
      break;
    }
    // A frame of many lines is smaller than many frames of one.
    const std::size_t enough = std::min(kFrameBytes, limits.queueBytesMax / 4);
    // The time of a slow disk counts: what came meanwhile has waited already.
    changed.wait_until(lock, waitingSince + kFrameTime,
                       [this, enough] { return waiting.size() >= enough || isClosing; });
    const std::string text = std::exchange(waiting, {});
    inFlight = text.size();
    lock.unlock();
    const int failure = write(frames, text);
    lock.lock();
    if (failure != 0) {
      error = failure;
      waiting.clear();
      inFlight = 0;
      isClosing = true;
    }
  }
  const bool isWhole = error == 0 && written > 0;
  lock.unlock();
  // A recording that has its table was written to its end.
  int failure = isWhole ? base::writeWhole(descriptor, frames.table()) : 0;
  const int closing = syncAndClose(descriptor);
  failure = failure != 0 ? failure : closing;
  lock.lock();
  error = error != 0 ? error : failure;
  isDone = true;
  changed.notify_all();
}

/// The text as frames. After each, what has been written survives the end of this program, and a
/// loss of power as soon as the disk says so. @return error of the system, 0: none
int RecordingFile::State::write(trace::FrameWriter& frames, std::string_view text) {
  while (!text.empty()) {
    // Whole lines, unless one line is larger than a frame.
    const std::size_t end =
        text.size() <= kFrameBytes ? std::string_view::npos : text.rfind('\n', kFrameBytes);
    const std::string_view lines = text.substr(
        0, end == std::string_view::npos ? std::min(text.size(), kFrameBytes) : end + 1);
    const int failure = base::writeWhole(descriptor, frames.frame(lines));
    if (failure != 0) {
      return failure;
    }
    text.remove_prefix(lines.size());
    const std::lock_guard counted(mutex);
    inFlight -= lines.size();
    written += lines.size();
    recorded = frames.span();
    changed.notify_all();
  }
  // A pipe cannot be synchronised; a disk that fails tells so again when it is closed.
  static_cast<void>(base::syncToDisk(descriptor));
  return 0;
}

base::Result<std::unique_ptr<RecordingFile>> RecordingFile::open(const std::filesystem::path& path,
                                                                 const RecordingLimits& limits) {
  // A pipe that nobody reads is not waited for here; one that is slow is, by the thread.
  const int descriptor =
      base::openToWrite(path, {.isEmptied = true, .neverWaits = true, .isForOwner = true});
  if (descriptor < 0) {
    const bool isPipe = errno == ENXIO;
    return base::fail(base::FileError::NotWritable,
                      isPipe
                          ? std::string("The recording cannot be written: nobody reads the pipe.")
                          : fmt::format("The recording cannot be written: {}. Check the folder "
                                        "and the permissions.",
                                        std::generic_category().message(errno)),
                      path.string());
  }
  base::letWait(descriptor);
  auto state = std::make_shared<State>();
  state->limits = limits;
  state->descriptor = descriptor;
  std::thread([state] { state->work(); }).detach();
  return std::unique_ptr<RecordingFile>(new RecordingFile(std::move(state), path));
}

RecordingFile::~RecordingFile() {
  static_cast<void>(finish());
}

bool RecordingFile::append(std::string_view lines) {
  State& state = *m_state;
  std::unique_lock lock(state.mutex);
  const bool isList = lines.size() >= kListBytes;
  // Lists leave half of the room to the records of the stream.
  const std::size_t room = state.limits.queueBytesMax / (isList ? 2 : 1);
  const auto fits = [&] { return state.waiting.size() + state.inFlight + lines.size() <= room; };
  while (isList && !fits() && !state.isClosing) {
    const std::size_t before = state.written;
    if (!state.changed.wait_for(lock, state.limits.patience,
                                [&] { return state.written != before || state.isClosing; })) {
      break;
    }
  }
  if (state.isClosing || state.isBehind || !fits()) {
    state.isBehind = state.isBehind || !state.isClosing;
    return false;
  }
  if (state.waiting.empty()) {
    state.waitingSince = std::chrono::steady_clock::now();
  }
  state.waiting += lines;
  state.changed.notify_all();
  return true;
}

trace::RecordingSink RecordingFile::sink() {
  return [this](std::string_view lines) { return append(lines); };
}

base::Duration RecordingFile::recorded() const {
  const std::lock_guard lock(m_state->mutex);
  return m_state->recorded;
}

base::Result<void> RecordingFile::soFar() const {
  const std::lock_guard lock(m_state->mutex);
  return result();
}

base::Result<void> RecordingFile::finish() {
  State& state = *m_state;
  std::unique_lock lock(state.mutex);
  state.isClosing = true;
  state.changed.notify_all();
  while (!state.isDone && !state.isAbandoned) {
    const std::size_t before = state.written;
    state.isAbandoned = !state.changed.wait_for(
        lock, state.limits.patience, [&] { return state.isDone || state.written != before; });
  }
  return result();
}

base::Result<void> RecordingFile::result() const {
  const State& state = *m_state;
  const auto incomplete = [this](std::string why) {
    return base::fail(base::FileError::NotWritable,
                      fmt::format("The recording is incomplete: {}. {:.1f} s of the run are in it.",
                                  why, base::toSeconds(m_state->recorded)),
                      m_path.string());
  };
  if (state.error != 0) {
    return incomplete(std::generic_category().message(state.error));
  }
  if (state.isBehind) {
    return incomplete("its disk or pipe could not keep up, so it was cut off");
  }
  if (state.isAbandoned) {
    return incomplete("its disk or pipe accepts nothing more");
  }
  return {};
}

}  // namespace rivulet::recorder
