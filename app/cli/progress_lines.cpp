// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/progress_lines.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "base/descriptor.h"
#include "base/file.h"

namespace rivulet::cli {

namespace {

constexpr base::Duration kInterval = std::chrono::milliseconds{50};

std::string textOf(const nlohmann::ordered_json& json) {
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

/// State and orders: what is said at once.
nlohmann::ordered_json stateJson(const streaming::LiveUpdate& update) {
  nlohmann::ordered_json json{{"state", streaming::runStateName(update.state)},
                              {"waiting_for", update.waitingFor}};
  if (update.feed) {
    json["override_percent"] = update.feed->wantedPercent;
    json["holds"] = update.feed->holds;
    json["stands"] = update.feed->holds && update.feed->stoodAfter.has_value();
  }
  if (update.wrong) {
    json["wrong_motion"] = streaming::describe(*update.wrong);
  }
  return json;
}

}  // namespace

base::Result<ProgressLines> ProgressLines::open(const std::string& path) {
  const int descriptor =
      base::openToWrite(path, {.isEmptied = true, .neverWaits = true, .isForOwner = true});
  if (descriptor < 0) {
    return base::fail(base::FileError::NotWritable,
                      "The progress cannot be written there. Name a file in a folder that you may "
                      "write, or a pipe that is read already.",
                      path);
  }
  ProgressLines lines(descriptor);
  lines.write(textOf({{"rivulet_progress", kProgressVersion}, {"version", RIVULET_VERSION}}));
  return lines;
}

ProgressLines::ProgressLines(ProgressLines&& other) noexcept
    : m_descriptor(std::exchange(other.m_descriptor, -1)),
      m_toldAt(other.m_toldAt),
      m_toldOrder(std::move(other.m_toldOrder)),
      m_positionMm(other.m_positionMm),
      m_margins(other.m_margins) {
}

ProgressLines::~ProgressLines() {
  if (m_descriptor >= 0) {
    base::closeFile(m_descriptor);
  }
}

/// A line is shorter than what a pipe takes at once or not at all.
void ProgressLines::write(const std::string& line) const {
  base::writeSome(m_descriptor, line + '\n');
}

void ProgressLines::tell(const streaming::LiveUpdate& update) {
  if (update.margin) {
    m_margins.add(*update.margin);
  }
  if (update.sample && update.sample->positionMm) {
    m_positionMm = update.sample->positionMm;
  }
  nlohmann::ordered_json json = stateJson(update);
  const std::string order = textOf(json);
  if (m_toldAt && order == m_toldOrder && update.at - *m_toldAt < kInterval) {
    return;
  }
  m_toldAt = update.at;
  m_toldOrder = order;
  json["points"] = update.counters.total;
  json["sent"] = update.counters.sent;
  json["accepted"] = update.counters.accepted;
  json["executed"] = update.counters.executed;
  json["late_windows"] = m_margins.lateWindows();
  if (const std::optional<base::Duration> margin = m_margins.last()) {
    json["margin_ms"] = base::toMilliseconds(*margin);
  }
  if (m_positionMm) {
    json["position_mm"] = {m_positionMm->x, m_positionMm->y, m_positionMm->z};
  }
  if (update.source) {
    json["waiting"] = update.source->waiting;
    json["capacity"] = update.source->capacity;
  }
  write(textOf(json));
}

}  // namespace rivulet::cli
