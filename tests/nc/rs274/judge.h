// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Draws programs, lets LinuxCNC and Rivulet read them, and counts in which they agree.
/// @threadsafety starts threads of its own.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "nc/rs274/comparison.h"

namespace rivulet::tests {

struct JudgeOptions {
  std::uint64_t seed = 1;
  std::uint64_t first = 0;  ///< number of the first program
  std::uint64_t count = 300;
  int threads = 2;
  int shrunkPerKind = 2;         ///< of the programs that differ in one way so many are made small
  int refusedPerWord = 0;        ///< and of those that Rivulet refuses for a word
  std::filesystem::path folder;  ///< for files, exists
};

struct Difference {
  std::uint64_t number = 0;  ///< of the drawn program
  std::string kind;
  std::string program;  ///< as small as it can be
  PathReading linuxCnc;
  PathReading rivulet;
};

struct Judgement {
  std::uint64_t equal = 0;
  std::map<std::string, std::uint64_t> bothRefuse;    ///< by what LinuxCNC says
  std::map<std::string, std::uint64_t> notSupported;  ///< by word
  std::map<std::string, std::uint64_t> different;     ///< by kind
  std::vector<Difference> examples;                   ///< by number
};

/// @pre Rs274::program() is not empty
[[nodiscard]] Judgement judge(const JudgeOptions& options);
/// Of one program. @param folder  for files
[[nodiscard]] Difference judgeProgram(const std::string& text, const std::filesystem::path& folder);
/// For people.
[[nodiscard]] std::string describe(const Difference& difference);

}  // namespace rivulet::tests
