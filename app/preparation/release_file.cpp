// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "preparation/release_file.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "journal/line_file.h"

namespace rivulet::preparation {

using nlohmann::ordered_json;
using permission::Release;

namespace {

std::string member(const ordered_json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::optional<Release> releaseOfLine(const std::string& line) {
  const ordered_json json = ordered_json::parse(line, nullptr, false);
  if (!json.is_object()) {
    return std::nullopt;
  }
  const auto at = base::utcOfText(member(json, "at"));
  Release release{{member(json, "hash"), member(json, "settings"), member(json, "calibration")},
                  member(json, "program"),
                  member(json, "by"),
                  at.value_or(0),
                  json.contains("taken_back")};
  return at && !release.job.programHash.empty() ? std::optional(release) : std::nullopt;
}

std::string lineOf(const Release& release) {
  ordered_json json{{"at", base::utcText(release.at)},  {"by", release.by},
                    {"program", release.programName},   {"hash", release.job.programHash},
                    {"settings", release.job.settings}, {"calibration", release.job.calibration}};
  if (release.isTakenBack) {
    json["taken_back"] = true;
  }
  return json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

}  // namespace

std::filesystem::path releaseFileIn(const std::filesystem::path& folder) {
  return folder / "releases.jsonl";
}

base::Result<std::vector<Release>> readReleases(const std::filesystem::path& path) {
  const auto lines = journal::readLines(path);
  if (!lines) {
    return base::fail(lines.error());
  }
  std::vector<Release> releases;
  for (const std::string& line : lines->lines) {
    if (auto release = releaseOfLine(line)) {
      releases.push_back(std::move(*release));
    }
  }
  return releases;
}

base::Result<void> appendRelease(const std::filesystem::path& path, const Release& release) {
  return journal::appendLine(path, [&release](std::string_view) { return lineOf(release); });
}

}  // namespace rivulet::preparation
