// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// For scripts/meaning: see there.

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

#include "base/text.h"
#include "nc/rs274/judge.h"
#include "nc/rs274/program_drawer.h"
#include "nc/rs274/rs274.h"

using namespace rivulet;

namespace {

constexpr int kDifferent = 1;
constexpr int kUsage = 2;
constexpr int kSkipped = 77;

std::uint64_t sum(const std::map<std::string, std::uint64_t>& counts) {
  std::uint64_t total = 0;
  for (const auto& [kind, count] : counts) {
    total += count;
  }
  return total;
}

void print(const char* title, const std::map<std::string, std::uint64_t>& counts) {
  fmt::print("{:6} {}\n", sum(counts), title);
  std::multimap<std::uint64_t, std::string, std::greater<>> sorted;
  for (const auto& [kind, count] : counts) {
    sorted.emplace(count, kind);
  }
  for (const auto& [count, kind] : sorted) {
    fmt::print("         {:6} {}\n", count, kind);
  }
}

int judgeFile(const std::string& path, const std::filesystem::path& folder) {
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const tests::Difference made = tests::judgeProgram(text, folder);
  fmt::print("{}{}\n", describe(made), made.kind.empty() ? "equal" : made.kind);
  return made.kind.empty() ? EXIT_SUCCESS : kDifferent;
}

}  // namespace

/// rs274_judge FOLDER count|seed|first|show NUMBER... | file PATH
int main(int argc, char** argv) {
  if (tests::Rs274::program().empty()) {
    fmt::print("skipped: rs274 of LinuxCNC is not installed\n");
    return kSkipped;
  }
  if (argc < 2) {
    return kUsage;
  }
  tests::JudgeOptions options;
  options.folder = argv[1];
  for (int i = 2; i + 1 < argc; i += 2) {
    const std::string_view name = argv[i];
    const std::string value = argv[i + 1];
    if (name == "file") {
      return judgeFile(value, options.folder / "file");
    }
    const std::uint64_t number = std::strtoull(value.c_str(), nullptr, 10);
    if (name == "count") {
      options.count = number;
    } else if (name == "seed") {
      options.seed = number;
    } else if (name == "first") {
      options.first = number;
    } else if (name == "examples") {
      options.shrunkPerKind = static_cast<int>(number);
    } else if (name == "refused") {
      options.refusedPerWord = static_cast<int>(number);
    } else if (name == "show") {
      fmt::print("{}", tests::drawProgram(options.seed, number));
      return EXIT_SUCCESS;
    } else {
      return kUsage;
    }
  }
  const tests::Judgement judgement = tests::judge(options);
  for (const tests::Difference& each : judgement.examples) {
    fmt::print("--- {} (program {})\n{}\n", each.kind, each.number, describe(each));
  }
  fmt::print("{:6} equal\n", judgement.equal);
  print("refused by both", judgement.bothRefuse);
  print("not supported by Rivulet, by word", judgement.notSupported);
  print("different", judgement.different);
  return judgement.different.empty() ? EXIT_SUCCESS : kDifferent;
}
