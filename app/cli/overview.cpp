// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "base/byte_source.h"
#include "cli/commands.h"
#include "trace/recording_reader.h"

namespace rivulet::cli {

namespace {

using nlohmann::ordered_json;

base::Result<trace::RecordingReader> openRecording(const std::string& path) {
  auto file = base::FileBytes::open(path);
  if (!file) {
    return base::fail(file.error());
  }
  auto reader = trace::RecordingReader::open(std::make_unique<base::FileBytes>(std::move(*file)),
                                             memoryBudget());
  if (!reader) {
    base::Error error = reader.error();
    error.context = path;
    return base::fail(std::move(error));
  }
  return reader;
}

ordered_json rangeJson(const trace::ValueRange& range) {
  return range.isEmpty() ? ordered_json(nullptr) : ordered_json{range.min, range.max};
}

ordered_json overviewJson(const std::string& file, const trace::RecordingReader& reader) {
  const trace::IndexGroup all = reader.index().total();
  const bool hasTime = all.first <= all.last;
  ordered_json places;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    places[std::string(1, static_cast<char>('x' + axis))] = rangeJson(all.positionMm[axis]);
  }
  return {{"file", file},
          {"program", reader.start().programName},
          {"method", reader.start().method},
          {"endpoint", reader.start().endpoint},
          {"started_utc", reader.start().startedAtUtc},
          {"outcome", reader.end() ? ordered_json(reader.end()->outcome) : ordered_json(nullptr)},
          {"had_index", reader.hadIndex()},
          {"span_s",
           hasTime ? ordered_json(base::toSeconds(all.last - all.first)) : ordered_json(nullptr)},
          {"samples", all.samples},
          {"requests", all.accesses},
          {"notes", all.notes},
          {"control_samples", all.controlSamples},
          {"position_mm", std::move(places)},
          {"request_ms", rangeJson(all.accessMs)}};
}

void printOverview(const ordered_json& json) {
  fmt::print(
      "{}: {}, method {}, {}{}\n", json["file"].get<std::string>(),
      json["program"].get<std::string>(), json["method"].get<std::string>(),
      json["outcome"].is_null() ? "cut off before its end" : json["outcome"].get<std::string>(),
      json["had_index"].get<bool>() ? "" : " (without an index: read as a whole)");
  fmt::print("  {:.1f} s, {} observations, {} requests, {} notes, {} samples of the control\n",
             json["span_s"].is_null() ? 0.0 : json["span_s"].get<double>(),
             json["samples"].get<std::uint64_t>(), json["requests"].get<std::uint64_t>(),
             json["notes"].get<std::uint64_t>(), json["control_samples"].get<std::uint64_t>());
}

}  // namespace

Exit overview(const AnalyseOptions& options) {
  ordered_json results = ordered_json::array();
  Exit exit = Exit::Done;
  for (const std::string& file : options.files) {
    const auto reader = openRecording(file);
    if (!reader) {
      exit = reportError(reader.error(), options.json && options.files.size() == 1);
      continue;
    }
    results.push_back(overviewJson(file, *reader));
    if (!options.json) {
      printOverview(results.back());
    }
  }
  if (options.json && !results.empty()) {
    printJson(options.files.size() > 1 ? results : results.front());
  }
  return exit;
}

}  // namespace rivulet::cli
