// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "live/progress.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace rivulet::live {

namespace {

std::string feedText(const Progress& progress) {
  if (!progress.feed) {
    return {};
  }
  return fmt::format(",\"percent\":{:g}", progress.feed->percent) +
         (progress.feed->feedMmPerMin
              ? fmt::format(",\"feed_mm_per_min\":{:.3f}", *progress.feed->feedMmPerMin)
              : std::string());
}

}  // namespace

std::string progressLine(const Progress& progress) {
  if (!progress.end) {
    const base::Vec3& at = progress.positionMm;
    return fmt::format(
        "{{\"accepted\":{},\"executed\":{},\"line\":{},\"merged\":{},"
        "\"x\":{:.6f},\"y\":{:.6f},\"z\":{:.6f}{}}}\n",
        progress.accepted, progress.executed, progress.line, progress.merged, at.x, at.y, at.z,
        feedText(progress));
  }
  nlohmann::ordered_json json{{"end", progress.end->outcome},
                              {"accepted", progress.accepted},
                              {"executed", progress.executed},
                              {"line", progress.line}};
  if (!progress.end->error.empty()) {
    json["error"] = progress.end->error;
  }
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace rivulet::live
