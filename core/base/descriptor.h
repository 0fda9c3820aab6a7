// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Open files by their descriptors, where a stream is too much: files that are appended to under a
/// lock, recordings, pipes. What a system calls them stays behind this header.
/// @threadsafety the functions share nothing.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

namespace rivulet::base {

/// How a file is opened for writing. It is made if it is missing.
struct Opening {
  bool mustBeNew = false;   ///< a file that is there is refused: EEXIST
  bool isEmptied = false;   ///< what a file holds is dropped
  bool neverWaits = false;  ///< a pipe that nobody reads is refused: ENXIO, or has no room: EAGAIN
  bool isForOwner = false;  ///< of a file that is made: nobody else may read it
};

/// @return a descriptor; -1: `errno` says why
[[nodiscard]] int openToWrite(const std::filesystem::path& path, const Opening& how = {});
/// A pipe without a writer is opened at once, and reading from it never waits. @return as above
[[nodiscard]] int openToRead(const std::filesystem::path& path);
/// For reading bytes as they are. @return null: `errno` says why
[[nodiscard]] std::FILE* openStream(const std::filesystem::path& path);
/// For writing bytes as they are, in place of what the file holds. @return as above
[[nodiscard]] std::FILE* openStreamToWrite(const std::filesystem::path& path);
/// @return whether the stream reads on there
[[nodiscard]] bool readFrom(std::FILE* stream, std::uint64_t at);

/// From now on writing waits for room, however the file was opened.
void letWait(int descriptor);

/// @return 0 or the system's error number
int closeFile(int descriptor);

/// Writes all of the text, also if the system takes it in pieces or a signal interrupts.
/// @return 0 or the system's error number
[[nodiscard]] int writeWhole(int descriptor, std::string_view text);
/// The same at a place of the file.
[[nodiscard]] int writeAt(int descriptor, std::string_view text, std::uint64_t at);
/// Writes what there is room for. @return bytes; < 0: nothing
std::ptrdiff_t writeSome(int descriptor, std::string_view text);
/// @return less than `bytes` at the end of the file, or if it cannot be read
[[nodiscard]] std::string readAt(int descriptor, std::uint64_t at, std::size_t bytes);
/// Of the file now; < 0: it has none, `errno` says why.
[[nodiscard]] std::int64_t sizeOf(int descriptor);
/// @return whether the file has this size now
[[nodiscard]] bool cutTo(int descriptor, std::uint64_t bytes);

/// Returns when what was written is on the disk. Pipes and devices refuse this, which is not an
/// error. @return 0 or the system's error number
[[nodiscard]] int syncToDisk(int descriptor);

/// Whether this open file is still the one of that name.
[[nodiscard]] bool hasName(int descriptor, const std::filesystem::path& path);

}  // namespace rivulet::base
