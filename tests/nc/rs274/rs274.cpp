// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/rs274/rs274.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <utility>

#include "base/contract.h"
#include "base/text.h"
#include "base/units.h"

namespace rivulet::tests {

namespace {

using base::Vec3;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
/// Canonical commands are printed with four decimals.
constexpr double kPrintedError = 0.5e-4;

/// Follows the canonical commands, as a machine does that knows no tool.
class CanonicalReader {
 public:
  PathReading read(std::string_view output) {
    bool ended = false;
    while (!output.empty()) {
      const std::size_t end = std::min(output.find('\n'), output.size());
      const std::string_view line = output.substr(0, end);
      output.remove_prefix(std::min(end + 1, output.size()));
      const std::size_t name = line.find_first_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ", kNumberWidth);
      if (isCommand(line) && name != std::string_view::npos) {
        const std::string_view command = line.substr(name);
        ended = ended || command.substr(0, 11) == "PROGRAM_END" || command.substr(0, 6) == "FINISH";
        if (!ended) {
          execute(command);
        }
      } else {
        // The sentence of a refusal stands before the block, at the end.
        m_reading.refusal = std::exchange(m_lastLine, std::string(line));
      }
    }
    return std::move(m_reading);
  }

 private:
  /// "   12 N..... STRAIGHT_FEED(1.0000, …)": a number, and the number of the block.
  static constexpr std::size_t kNumberWidth = 13;
  static bool isCommand(std::string_view line) {
    const std::size_t number = line.find_first_not_of(' ');
    return line.size() > kNumberWidth && number != std::string_view::npos &&
           base::isDigit(line[number]) && line.find(" N") != std::string_view::npos;
  }

  void execute(std::string_view command) {
    using Execute = void (CanonicalReader::*)();
    struct Command {
      std::string_view name;
      Execute execute;
    };
    static constexpr std::array kCommands{
        Command{"STRAIGHT_TRAVERSE", &CanonicalReader::traverse},
        Command{"STRAIGHT_FEED", &CanonicalReader::feed},
        Command{"ARC_FEED", &CanonicalReader::arc},
        Command{"NURBS_FEED", &CanonicalReader::spline},
        Command{"NURBS_G5_FEED", &CanonicalReader::spline},
        Command{"SET_FEED_RATE", &CanonicalReader::feedRate},
        Command{"SET_FEED_MODE", &CanonicalReader::feedMode},
        Command{"SET_SPINDLE_SPEED", &CanonicalReader::spindleSpeed},
        Command{"SET_SPINDLE_MODE", &CanonicalReader::spindleMode},
        Command{"SELECT_PLANE", &CanonicalReader::plane},
        Command{"USE_LENGTH_UNITS", &CanonicalReader::units},
        Command{"SET_G5X_OFFSET", &CanonicalReader::workOffset},
        Command{"SET_G92_OFFSET", &CanonicalReader::setOffset},
        Command{"SET_XY_ROTATION", &CanonicalReader::rotation},
    };
    const std::string_view name = command.substr(0, command.find('('));
    const auto* const found = std::find_if(kCommands.begin(), kCommands.end(),
                                           [name](const Command& c) { return c.name == name; });
    if (found != kCommands.end()) {
      m_command = command;
      takeNumbers(command.substr(name.size()));
      (this->*found->execute)();
    }
  }

  void takeNumbers(std::string_view text) {
    m_numbers.clear();
    while (!text.empty()) {
      const std::size_t begin = text.find_first_of("-0123456789");
      if (begin == std::string_view::npos) {
        return;
      }
      text.remove_prefix(begin);
      double value = 0.0;
      const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
      m_numbers.push_back(problem == std::errc() ? value : kNaN);
      text.remove_prefix(std::max<std::size_t>(1, static_cast<std::size_t>(end - text.data())));
    }
  }
  [[nodiscard]] double number(std::size_t index) const {
    return index < m_numbers.size() ? m_numbers[index] : kNaN;
  }
  [[nodiscard]] Vec3 lengths(std::size_t index) const {
    return m_unitMm * Vec3{number(index), number(index + 1), number(index + 2)};
  }

  /// Program coordinates are shifted, turned, and shifted again.
  [[nodiscard]] Vec3 inMachine(Vec3 program) const { return turned(program + m_setMm) + m_workMm; }
  [[nodiscard]] Vec3 turned(Vec3 way) const {
    const double radians = m_rotationDeg * std::numbers::pi / 180.0;
    const double cosine = std::cos(radians);
    const double sine = std::sin(radians);
    return {way.x * cosine - way.y * sine, way.x * sine + way.y * cosine, way.z};
  }

  ReadMove moveTo(MoveForm form, Vec3 program, std::size_t rotary) {
    ReadMove move;
    move.form = form;
    move.endMm = inMachine(program);
    for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
      move.rotaryDeg[axis] = number(rotary + axis) + m_setDeg[axis] + m_workDeg[axis];
    }
    // Of the place, and of each offset.
    move.errorMm = 3.0 * kPrintedError * m_unitMm;
    if (form != MoveForm::Rapid) {
      setFeed(move);
    }
    return move;
  }

  /// A number without a unit is multiplied where it is told, so a later G20 does not change it.
  void setFeed(ReadMove& move) const {
    const bool isAlong = base::distance(move.endMm, m_atMm) > 2.0 * move.errorMm ||
                         move.form != MoveForm::Feed || std::isnan(m_atMm.x);
    const double perTurn = m_perTurn ? m_spindlePerMin : 1.0;
    move.feedPerMin = m_feed * (isAlong ? m_feedUnitMm : 1.0) * perTurn;
  }

  void add(const ReadMove& move) {
    m_reading.moves.push_back(move);
    m_atMm = move.endMm;
  }

  void traverse() { add(moveTo(MoveForm::Rapid, lengths(0), 3)); }
  void feed() { add(moveTo(MoveForm::Feed, lengths(0), 3)); }

  void arc() {
    const std::size_t first = m_firstAxis;
    const std::size_t second = (first + 1) % 3;
    const std::size_t third = (first + 2) % 3;
    Vec3 end;
    end.set(first, number(0) * m_unitMm);
    end.set(second, number(1) * m_unitMm);
    end.set(third, number(5) * m_unitMm);
    Vec3 centre = end;
    centre.set(first, number(2) * m_unitMm);
    centre.set(second, number(3) * m_unitMm);
    ReadMove move = moveTo(MoveForm::Arc, end, 6);
    move.centreMm = inMachine(centre);
    const auto turns = static_cast<int>(number(4));
    move.axis.set(third, turns > 0 ? 1.0 : -1.0);
    move.axis = turned(move.axis);
    const Vec3 from = m_atMm - move.centreMm;
    const Vec3 to = move.endMm - move.centreMm;
    // Of a helix only what lies across its axis.
    const Vec3 fromAcross = from - base::dot(from, move.axis) * move.axis;
    const Vec3 toAcross = to - base::dot(to, move.axis) * move.axis;
    double sweep = std::atan2(base::dot(move.axis, base::cross(fromAcross, toAcross)),
                              base::dot(fromAcross, toAcross));
    constexpr double kTurn = 2.0 * std::numbers::pi;
    sweep += sweep < 0.0 ? kTurn : 0.0;
    constexpr double kFullCircleMm = 0.01;  // the start may have been printed in inches
    if (base::distance(fromAcross, toAcross) < kFullCircleMm) {
      sweep = kTurn;
    }
    move.sweepRad = sweep + (std::abs(turns) - 1) * kTurn;
    add(move);
  }

  /// Where it ends is not printed.
  void spline() {
    const Vec3 unknown{kNaN, kNaN, kNaN};
    ReadMove move = moveTo(MoveForm::Spline, unknown, 0);
    move.rotaryDeg = {kNaN, kNaN, kNaN};
    if (!m_reading.moves.empty() && m_reading.moves.back().form == MoveForm::Spline) {
      m_reading.moves.pop_back();
    }
    add(move);
  }

  void feedRate() {
    m_feed = number(0);
    m_feedUnitMm = m_unitMm;
  }
  void feedMode() { m_perTurn = number(1) != 0.0; }
  void spindleSpeed() { m_spindlePerMin = m_cutsAtSurfaceSpeed ? kNaN : std::abs(number(1)); }
  void spindleMode() { m_cutsAtSurfaceSpeed = number(1) != 0.0; }
  void plane() {
    m_firstAxis = m_command.find("XY") != std::string_view::npos   ? 0
                  : m_command.find("YZ") != std::string_view::npos ? 1
                                                                   : 2;
  }
  void units() {
    m_unitMm = m_command.find("INCHES") != std::string_view::npos ? base::kMmPerInch : 1.0;
  }
  void workOffset() {
    m_workMm = lengths(1);
    m_workDeg = {number(4), number(5), number(6)};
  }
  void setOffset() {
    m_setMm = lengths(0);
    m_setDeg = {number(3), number(4), number(5)};
  }
  void rotation() { m_rotationDeg = number(0); }

  PathReading m_reading;
  std::string m_lastLine;  ///< that is no command
  std::string_view m_command;
  std::vector<double> m_numbers;
  Vec3 m_atMm;
  double m_unitMm = 1.0;
  double m_feed = 0.0;
  double m_feedUnitMm = 1.0;
  bool m_perTurn = false;
  double m_spindlePerMin = 0.0;
  bool m_cutsAtSurfaceSpeed = false;
  std::size_t m_firstAxis = 0;
  Vec3 m_workMm;
  Vec3 m_setMm;
  base::RotaryDeg m_workDeg{};
  base::RotaryDeg m_setDeg{};
  double m_rotationDeg = 0.0;
};

/// What the new process needs, made before there is one.
struct Start {
  std::string program;
  std::string folder;
  std::string home;  ///< its table of tools lies there, mapped into memory
};

/// After fork: only calls that are safe between threads.
[[noreturn]] void startProgram(const Start& start, int output) {
  constexpr rlimit kSeconds{3, 3};
  setrlimit(RLIMIT_CPU, &kSeconds);
  if (chdir(start.folder.c_str()) != 0 || dup2(output, STDOUT_FILENO) < 0 ||
      dup2(output, STDERR_FILENO) < 0) {
    _exit(127);
  }
  static constexpr std::array kArguments{"rs274",     "-t", "tools",  "-v",
                                         "variables", "-g", "program"};
  std::array<char*, kArguments.size() + 1> words{};
  for (std::size_t i = 0; i < kArguments.size(); ++i) {
    words[i] = const_cast<char*>(kArguments[i]);
  }
  std::array environment{const_cast<char*>(start.home.c_str()), static_cast<char*>(nullptr)};
  execve(start.program.c_str(), words.data(), environment.data());
  _exit(127);
}

void write(const std::filesystem::path& path, std::string_view text) {
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file << text;
  file.close();
  RIVULET_ASSERT(file.good());
}

}  // namespace

std::string describe(const ReadMove& move) {
  static constexpr std::array<std::string_view, 4> kForms{"rapid", "feed", "arc", "spline"};
  std::string text =
      fmt::format("{:<6} X{:.4f} Y{:.4f} Z{:.4f}", kForms[static_cast<std::size_t>(move.form)],
                  move.endMm.x, move.endMm.y, move.endMm.z);
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    if (!std::isnan(move.rotaryDeg[axis]) && move.rotaryDeg[axis] != 0.0) {
      text += fmt::format(" {}{:.4f}", "ABC"[axis], move.rotaryDeg[axis]);
    }
  }
  if (move.form != MoveForm::Rapid) {
    text += fmt::format(" F{:.4f}", move.feedPerMin);
  }
  if (move.form == MoveForm::Arc) {
    text += fmt::format(", centre {:.4f} {:.4f} {:.4f}, {:.3f} deg about {:.0f} {:.0f} {:.0f}",
                        move.centreMm.x, move.centreMm.y, move.centreMm.z,
                        move.sweepRad * 180.0 / std::numbers::pi, move.axis.x, move.axis.y,
                        move.axis.z);
  }
  return text;
}

PathReading readCanonical(std::string_view output) {
  return CanonicalReader().read(output);
}

std::filesystem::path Rs274::program() {
  for (const char* const place : {"/usr/bin/rs274", "/usr/local/bin/rs274"}) {
    if (access(place, X_OK) == 0) {
      return place;
    }
  }
  return {};
}

Rs274::Rs274(std::filesystem::path folder) : m_folder(std::move(folder)) {
  std::filesystem::create_directories(m_folder);
  write(m_folder / "tools", "T1 P1 Z5.0 D6.0\nT2 P2 Z3.0 D10.0\nT3 P3 Z-0.4 D3.0\n");
}

PathReading Rs274::read(std::string_view text) {
  // It writes back its variables, G92 among them: each program begins with none.
  write(m_folder / "program", text);
  write(m_folder / "variables", "");
  const int status = run();
  PathReading reading = readCanonical(m_output);
  reading.accepted = status == 0;
  if (reading.accepted) {
    reading.refusal.clear();
  } else if (WIFSIGNALED(status)) {
    reading.refusal = "rs274 did not end";
  }
  return reading;
}

/// @return as waitpid has it
int Rs274::run() {
  constexpr std::size_t kOutputMax = 4U << 20U;
  const Start start{program().string(), m_folder.string(), "HOME=" + m_folder.string()};
  std::array<int, 2> ends{};
  RIVULET_ASSERT(pipe2(ends.data(), O_CLOEXEC) == 0);
  const pid_t child = fork();
  RIVULET_ASSERT(child >= 0);
  if (child == 0) {
    startProgram(start, ends[1]);
  }
  close(ends[1]);
  m_output.clear();
  std::array<char, 65536> buffer{};
  for (ssize_t count = 1; count > 0 && m_output.size() < kOutputMax;) {
    count = ::read(ends[0], buffer.data(), buffer.size());
    m_output.append(buffer.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  }
  close(ends[0]);
  int status = 0;
  RIVULET_ASSERT(waitpid(child, &status, 0) == child);
  return status;
}

}  // namespace rivulet::tests
