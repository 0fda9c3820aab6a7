// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How fast NC programs are read, beside what reading a file costs at least: finding its line ends.
// Each size is measured in turns, reading and scanning; medians are printed.

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "base/median.h"
#include "gcode/program.h"
#include "measuring.h"

namespace {

using namespace rivulet;

/// Lines as CAM systems write them, half of them packed.
void writeProgram(const std::filesystem::path& path, int lines) {
  std::ofstream out(path, std::ios::binary);
  out << "G90 G21 G17\nG0 X0 Y0 Z5\nG1 Z0 F1200\n";
  std::string text;
  for (int i = 0; i < lines; ++i) {
    const double x = 50.0 * std::sin(i * 0.001);
    const double y = 50.0 * std::cos(i * 0.0013);
    const double z = -1.0 + 0.5 * std::sin(i * 0.01);
    text += i % 2 != 0 ? fmt::format("N{} G1 X{:.4f} Y{:.4f} Z{:.4f}\n", i % 99999, x, y, z)
                       : fmt::format("G1X{:.3f}Y{:.3f}Z{:.3f}\n", x, y, z);
    if (text.size() > 1 << 20) {
      out << text;
      text.clear();
    }
  }
  out << text << "M30\n";
}

template <class Work>
double secondsOf(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::size_t scanLines(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text(std::filesystem::file_size(path), '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  std::size_t lines = 0;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (at != end) {
    const void* const found = std::memchr(at, '\n', static_cast<std::size_t>(end - at));
    if (found == nullptr) {
      break;
    }
    at = static_cast<const char*>(found) + 1;
    ++lines;
  }
  return lines;
}

}  // namespace

int main(int argc, char** argv) {
  const std::filesystem::path folder =
      argc > 1 ? argv[1] : std::filesystem::temp_directory_path() / "rivulet-bench";
  std::filesystem::create_directories(folder);
  fmt::print("{:>9} {:>8} {:>10} {:>10} {:>7} {:>9} {:>14}\n", "lines", "file MB", "read s",
             "scan s", "ratio", "us/line", "MB above file");
  for (const int lines : {10'000, 30'000, 100'000, 300'000, 1'000'000, 2'000'000, 5'000'000}) {
    const std::filesystem::path path = folder / fmt::format("lines-{}.nc", lines);
    writeProgram(path, lines);
    const double fileMb = static_cast<double>(std::filesystem::file_size(path)) / 1e6;
    std::vector<double> readS;
    std::vector<double> scanS;
    double aboveMb = 0.0;
    std::size_t counted = 0;
    const int rounds = lines > 1'000'000 ? 5 : 11;
    for (int round = 0; round < rounds; ++round) {
      scanS.push_back(secondsOf([&] { counted += scanLines(path); }));
      const double before = bench::residentMb();
      readS.push_back(secondsOf([&] {
        const auto program = gcode::loadProgram(path);
        if (!program || program->trajectory.points.size() != static_cast<std::size_t>(lines) + 2) {
          fmt::print(stderr, "the program was not read as it was written\n");
          std::exit(1);
        }
        aboveMb = std::max(aboveMb, bench::residentMb() - before - fileMb);
      }));
    }
    if (counted == 0) {
      return 1;
    }
    const double read = base::median(readS);
    const double scan = base::median(scanS);
    fmt::print("{:>9} {:>8.1f} {:>10.4f} {:>10.4f} {:>7.1f} {:>9.3f} {:>14.1f}\n", lines, fileMb,
               read, scan, read / scan, 1e6 * read / lines, aboveMb);
    std::filesystem::remove(path);
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  fmt::print("largest resident size {:.1f} MB\n", static_cast<double>(usage.ru_maxrss) / 1e3);
  return 0;
}
