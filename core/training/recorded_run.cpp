// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "training/recorded_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <optional>

#include "base/text.h"
#include "base/units.h"
#include "trace/import/compression.h"

namespace rivulet::training {

namespace {

using base::Result;
using base::Vec3;

Result<std::string> readFile(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  if (!file) {
    return base::fail(RecordedRunError::FileUnreadable,
                      "The file cannot be read. Check the path and its permissions.",
                      path.string());
  }
  return text;
}

/// Words of one line: letter and number.
class Words {
 public:
  static std::optional<Words> read(std::string_view line) {
    Words words;
    std::size_t at = 0;
    while (at < line.size()) {
      const char c = line[at];
      if (c == ' ' || c == '\r' || c == '\t') {
        ++at;
        continue;
      }
      if (c == '(') {
        const std::size_t close = line.find(')', at);
        at = close == std::string_view::npos ? line.size() : close + 1;
        continue;
      }
      std::size_t end = at + 1;
      while (end < line.size() &&
             std::string_view("+-.0123456789").find(line[end]) != std::string_view::npos) {
        ++end;
      }
      const std::optional<double> value = base::parseNumber(line.substr(at + 1, end - at - 1));
      if (!value) {
        return std::nullopt;
      }
      words.m_words.emplace_back(c, *value);
      at = end;
    }
    return words;
  }

  [[nodiscard]] bool hasG(double number) const {
    return std::find(m_words.begin(), m_words.end(), std::pair('G', number)) != m_words.end();
  }
  [[nodiscard]] std::optional<double> value(char letter) const {
    for (const auto& [name, value] : m_words) {
      if (name == letter) {
        return value;
      }
    }
    return std::nullopt;
  }

 private:
  std::vector<std::pair<char, double>> m_words;
};

machine::ArcPath arcPath(Vec3 from, Vec3 to, Vec3 centre, bool clockwise) {
  machine::ArcPath arc;
  arc.centreMm = centre;
  arc.axis = {0.0, 0.0, clockwise ? -1.0 : 1.0};
  const double begin = std::atan2(from.y - centre.y, from.x - centre.x);
  const double end = std::atan2(to.y - centre.y, to.x - centre.x);
  double sweep = clockwise ? begin - end : end - begin;
  while (sweep <= 1e-9) {
    sweep += 2.0 * std::numbers::pi;  // if it ends where it began, it is a full circle
  }
  arc.sweepRad = sweep;
  return arc;
}

/// Five columns of a table with a heading, row by row.
using RecordedRow = std::array<double, 5>;
Result<std::vector<RecordedRow>> parseColumns(std::string_view text,
                                              const std::array<std::string_view, 5>& columns) {
  const auto takeLine = [&text] {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    return line;
  };
  const auto split = [](std::string_view line) {
    std::vector<std::string_view> fields;
    for (;;) {
      const std::size_t comma = line.find(',');
      fields.push_back(base::trim(line.substr(0, comma)));
      if (comma == std::string_view::npos) {
        return fields;
      }
      line.remove_prefix(comma + 1);
    }
  };
  const std::vector<std::string_view> heading = split(takeLine());
  std::array<std::size_t, 5> places{};
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const auto found = std::find(heading.begin(), heading.end(), columns[i]);
    if (found == heading.end()) {
      return base::fail(RecordedRunError::Malformed,
                        fmt::format("The recording has no column {}.", columns[i]));
    }
    places[i] = static_cast<std::size_t>(found - heading.begin());
  }
  std::vector<RecordedRow> rows;
  while (!text.empty()) {
    const std::vector<std::string_view> fields = split(takeLine());
    RecordedRow values{};
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const std::optional<double> value =
          places[i] < fields.size() ? base::parseNumber(fields[places[i]]) : std::nullopt;
      if (!value) {
        return base::fail(RecordedRunError::Malformed,
                          fmt::format("Line {} of the recording cannot be read.", rows.size() + 2));
      }
      values[i] = *value;
    }
    rows.push_back(values);
  }
  return rows;
}

}  // namespace

std::error_code make_error_code(RecordedRunError code) {
  static const base::NamedCategory category("recorded run");
  return {static_cast<int>(code), category};
}

Result<std::vector<machine::PreparedMotion>> parseRecordedProgram(std::string_view text,
                                                                  Vec3 startMm) {
  std::vector<machine::PreparedMotion> blocks;
  machine::PreparedMotion modal;
  Vec3 at = startMm;
  int motion = 1;
  unsigned number = 0;
  while (!text.empty()) {
    ++number;
    const std::size_t end = text.find('\n');
    const std::optional<Words> words = Words::read(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (!words) {
      return base::fail(RecordedRunError::Malformed,
                        fmt::format("Line {} of the program cannot be read.", number));
    }
    if (words->hasG(61)) {
      modal.end = machine::BlockEnd::ExactStop;
    }
    if (words->hasG(64)) {
      modal.end = machine::BlockEnd::Rounded;
      modal.roundingMm = words->value('P').value_or(0.0);
    }
    for (const int code : {1, 2, 3}) {
      motion = words->hasG(code) ? code : motion;
    }
    if (const std::optional<double> feed = words->value('F')) {
      modal.feedMmPerS = base::mmPerSFromMmPerMin(*feed);
    }
    if (words->hasG(4) || !(words->value('X') || words->value('Y') || words->value('Z'))) {
      continue;
    }
    machine::PreparedMotion block = modal;
    block.line = {number};
    block.targetMm = {words->value('X').value_or(at.x), words->value('Y').value_or(at.y),
                      words->value('Z').value_or(at.z)};
    if (motion != 1) {
      const Vec3 centre =
          at + Vec3{words->value('I').value_or(0.0), words->value('J').value_or(0.0), 0.0};
      block.arc = arcPath(at, block.targetMm, centre, motion == 2);
    }
    at = block.targetMm;
    blocks.push_back(block);
  }
  return blocks;
}

Result<std::vector<RecordedSample>> parseRecordedSamples(std::string_view text) {
  const auto rows = parseColumns(text, {"t_s", "x_cmd", "y_cmd", "z_cmd", "v_path"});
  if (!rows) {
    return base::fail(rows.error());
  }
  std::vector<RecordedSample> samples;
  for (const RecordedRow& row : *rows) {
    samples.push_back({row[0], {row[1], row[2], row[3]}, row[4]});
  }
  return samples;
}

Result<std::vector<ObservedSample>> parseObservedSamples(std::string_view text) {
  const auto rows = parseColumns(text, {"t_s", "x", "y", "vx", "vy"});
  if (!rows) {
    return base::fail(rows.error());
  }
  std::vector<ObservedSample> samples;
  for (const RecordedRow& row : *rows) {
    samples.push_back({row[0], row[1], row[2], row[3], row[4]});
  }
  return samples;
}

Result<std::vector<ObservedSample>> loadObservedSamples(const std::filesystem::path& folder,
                                                        const std::string& name) {
  const Result<std::string> text = readFile(folder / "data" / "opcua" / (name + ".csv"));
  return text ? parseObservedSamples(*text) : base::fail(text.error());
}

Result<RecordedRun> loadRecordedRun(const std::filesystem::path& folder, const std::string& name) {
  RecordedRun run;
  run.name = name;
  const Result<std::string> program = readFile(folder / "programs" / (name + ".ngc"));
  if (!program) {
    return base::fail(program.error());
  }
  std::filesystem::path data = folder / "data" / (name + ".csv.zst");
  std::error_code missing;
  if (!std::filesystem::exists(data, missing)) {
    data = folder / "data" / (name + "_250hz.csv.zst");
  }
  const Result<std::string> packed = readFile(data);
  if (!packed) {
    return base::fail(packed.error());
  }
  const auto table = trace::unpack(*packed);
  if (!table) {
    return base::fail(table.error());
  }
  if (!table->whole) {
    return base::fail(RecordedRunError::Malformed, "The file is not a whole zstd archive.",
                      data.string());
  }
  auto samples = parseRecordedSamples(table->text);
  if (!samples) {
    return base::fail(samples.error());
  }
  run.samples = std::move(*samples);
  auto blocks =
      parseRecordedProgram(*program, run.samples.empty() ? Vec3{} : run.samples.front().commandMm);
  if (!blocks) {
    return base::fail(blocks.error());
  }
  run.blocks = std::move(*blocks);
  return run;
}

}  // namespace rivulet::training
