// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gcode/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <system_error>
#include <utility>

#include "gcode/interpreter.h"

namespace rivulet::gcode {

namespace {

/// FNV-1a, 64 bit: tells versions of a program apart; it is no protection against intent.
std::string hashOf(std::string_view text) {
  std::uint64_t hash = 0xCBF29CE484222325ULL;
  for (const char c : text) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3ULL;
  }
  return fmt::format("{:016x}", hash);
}

bool isError(const Diagnostic& diagnostic) {
  return diagnostic.severity == Severity::Error;
}

}  // namespace

bool Program::isStreamable() const {
  return std::none_of(diagnostics.begin(), diagnostics.end(), isError);
}

base::Result<Program> interpretProgram(std::string name, std::string text,
                                       const LoadOptions& options) {
  Interpretation interpretation = interpret(text, options);
  if (interpretation.trajectory.points.empty()) {
    // The finding that stands in the way of a motion is worth more than the bare fact.
    const auto first =
        std::find_if(interpretation.diagnostics.begin(), interpretation.diagnostics.end(), isError);
    const std::string reason =
        first == interpretation.diagnostics.end()
            ? std::string()
            : fmt::format(" Line {}: {}", first->line.value, describe(*first));
    if (interpretation.blocks == 0) {
      return base::fail(GcodeError::EmptyProgram,
                        "The program has no block: choose a file with NC text.", std::move(name));
    }
    return base::fail(GcodeError::NoMotion,
                      "The program moves no axis: choose a program with G0, G1, G2 or G3 and X, Y "
                      "or Z." +
                          reason,
                      std::move(name));
  }
  std::string hash = hashOf(text);
  Program program;
  program.name = std::move(name);
  program.text = std::move(text);
  program.hash = std::move(hash);
  program.trajectory = std::move(interpretation.trajectory);
  program.diagnostics = std::move(interpretation.diagnostics);
  program.statistics = std::move(interpretation.statistics);
  return program;
}

base::Result<Program> loadProgram(const std::filesystem::path& path, const LoadOptions& options) {
  const auto unreadable = [&](std::string message) {
    return base::fail(GcodeError::FileUnreadable, std::move(message), path.string());
  };
  std::error_code status;
  const std::filesystem::file_status file = std::filesystem::status(path, status);
  if (file.type() == std::filesystem::file_type::not_found) {
    return unreadable("The file does not exist: check its name and folder.");
  }
  if (file.type() == std::filesystem::file_type::directory) {
    return unreadable("This is a folder: choose an NC program file in it.");
  }
  if (file.type() != std::filesystem::file_type::regular) {
    return unreadable("This is not a regular file: choose an NC program file.");
  }
  const std::uintmax_t bytes = std::filesystem::file_size(path, status);
  if (status) {
    return unreadable("The size of the file cannot be read: check its permissions.");
  }
  if (bytes > kProgramBytesMax) {
    return base::fail(
        GcodeError::FileTooLarge,
        fmt::format("The file has {} MiB, more than the {} MiB accepted: split the program.",
                    bytes / (1024 * 1024), kProgramBytesMax / (1024 * 1024)),
        path.string());
  }
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    return unreadable("The file cannot be opened: check its permissions.");
  }
  std::string text(static_cast<std::size_t>(bytes), '\0');
  stream.read(text.data(), static_cast<std::streamsize>(bytes));
  if (static_cast<std::uintmax_t>(stream.gcount()) != bytes) {
    return unreadable("The file could not be read to its end: check the drive and try again.");
  }
  base::Result<Program> program =
      interpretProgram(path.filename().string(), std::move(text), options);
  if (!program) {
    base::Error error = program.error();
    error.context = path.string();
    return base::fail(std::move(error));
  }
  return program;
}

}  // namespace rivulet::gcode
