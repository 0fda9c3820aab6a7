// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/calibration_choice.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <nlohmann/json.hpp>

#include "report/machine_store.h"

namespace rivulet::cli {

namespace {

using streaming::versionText;

}  // namespace

const streaming::CalibrationRecord* CalibrationChoice::usable() const {
  return record && !outdated ? &*record : nullptr;
}

base::Result<CalibrationChoice> calibrationOf(const Connection& connection) {
  const auto identity = connection.control->identity();
  if (!identity) {
    return base::fail(identity.error());
  }
  CalibrationChoice choice;
  auto found = report::MachineStore().calibration(connection.name, *identity);
  if (!found) {
    choice.unreadable = found.error().text();
  } else if (*found) {
    choice.record = std::move(**found);
    choice.outdated = choice.record->isOutdated(*identity);
    choice.otherServer = versionText(*identity);
  }
  return choice;
}

std::string accessSourceText(const CalibrationChoice& choice, opcua::Grouping form,
                             const feasibility::Verdict& verdict) {
  const double t = base::toMilliseconds(verdict.accessTime);
  const streaming::CalibrationRecord* record = choice.usable();
  if (record == nullptr) {
    const bool published = verdict.accessTime == feasibility::AccessModel{}.accessTime;
    std::string text = fmt::format("access: {}, t = {:.2f} ms per cell",
                                   published ? "assumed ([P1])" : "as given", t);
    if (choice.outdated) {
      text += fmt::format(
          "\n  OUTDATED, not used: the calibration of {} was made with {}; now it is {}. Calibrate "
          "again.",
          choice.record->measuredAtUtc, versionText(choice.record->server), choice.otherServer);
    } else if (!choice.unreadable.empty()) {
      text += "\n  The calibration of this machine is not used: " + choice.unreadable;
    }
    return text;
  }
  const streaming::Calibration& calibration = record->calibration;
  std::string text = fmt::format("access: calibrated on {}, form {}, t = {:.2f} ms per cell",
                                 record->measuredAtUtc, opcua::groupingName(form), t);
  for (const bool write : {false, true}) {
    const streaming::AccessFit* fit = calibration.fit(write, form);
    if (fit == nullptr) {
      fit = calibration.fit(write, opcua::Grouping::List);
    }
    const auto tail = calibration.tail(write, fit->grouping, 1);
    text += fmt::format("\n  {:<5} {:.2f} ms + n * {:.3f} ms, p99 of one cell {:.2f} ms",
                        write ? "write" : "read", fit->overheadMs, fit->nodeMs,
                        base::toMilliseconds(tail.value_or(base::Duration{})));
  }
  return text;
}

nlohmann::ordered_json accessSourceJson(const CalibrationChoice& choice, opcua::Grouping form,
                                        const feasibility::Verdict& verdict) {
  const streaming::CalibrationRecord* record = choice.usable();
  nlohmann::ordered_json json{{"source", record == nullptr ? "assumed" : "calibrated"},
                              {"time_per_cell_ms", base::toMilliseconds(verdict.accessTime)}};
  if (record != nullptr) {
    json["measured_at_utc"] = record->measuredAtUtc;
    json["form"] = opcua::groupingName(form);
    for (const bool write : {false, true}) {
      if (const auto tail = record->calibration.tail(write, form, 1)) {
        json[write ? "write_p99_ms" : "read_p99_ms"] = base::toMilliseconds(*tail);
      }
    }
  } else if (choice.outdated) {
    json["outdated_calibration"] = choice.record->measuredAtUtc;
  }
  return json;
}

std::string utcNow() {
  return fmt::format("{:%FT%TZ}", fmt::gmtime(std::time(nullptr)));
}

}  // namespace rivulet::cli
