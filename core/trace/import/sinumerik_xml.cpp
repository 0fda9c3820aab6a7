// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/import/sinumerik_xml.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <optional>
#include <string>

#include "base/text.h"
#include "trace/control_trace.h"
#include "trace/import/import_error.h"
#include "trace/import/xml_reader.h"

namespace rivulet::trace {

namespace {

/// A NaN that was written as an unsigned whole number is at least this.
constexpr double kNanAsInteger = 9.2e18;

// What is held of a trace, with what is made of it, bytes.
constexpr std::size_t kSignalBytes = 1000;  // beside its values: names, role, remarks
/// With its time, in lists that grow.
constexpr std::size_t kValueBytes = 2 * (sizeof(double) + sizeof(base::Instant));

std::string unitOf(std::string_view unitsType) {
  if (unitsType == "posn") {
    return "mm";
  }
  if (unitsType == "velo") {
    return "mm/min";
  }
  return std::string(unitsType == "none" ? "" : unitsType);
}

}  // namespace

bool isSinumerikTrace(std::string_view text) {
  return text.substr(0, 4096).find("<traceSession") != std::string_view::npos;
}

base::Result<SignalTrace> readSinumerikTrace(std::string_view text, const base::Budget& budget) {
  SignalTrace trace;
  trace.format = "SINUMERIK trace";
  std::map<std::string, std::size_t, std::less<>> signalOfId;
  const std::size_t frame = text.find("<dataFrame");
  XmlReader reader(text, std::min(frame, text.size()));
  std::size_t backwards = 0;
  std::size_t held = 0;
  while (const auto tag = reader.next()) {
    if (tag->kind != XmlKind::Start) {
      continue;
    }
    if (held > budget.left()) {
      return base::fail(budget.exceeded("The trace with its analysis"));
    }
    if (tag->name == "dataSignal") {
      held += kSignalBytes + 2 * tag->raw.size();
      const std::string id = xmlAttribute(*tag, "id");
      Signal signal;
      const std::string path = xmlAttribute(*tag, "name");
      // The axis is in the path: "... [u1, 2]".
      const std::size_t index = path.find('[');
      signal.name = xmlAttribute(*tag, "description") +
                    (index == std::string::npos ? "" : " " + path.substr(index));
      signal.unit = unitOf(xmlAttribute(*tag, "unitsType"));
      signal.timeBase = trace.timeBases.size();
      signalOfId[id.empty() ? fmt::format("f{}", trace.signalList.size() + 1) : id] =
          trace.signalList.size();
      trace.timeBases.push_back({"time", {}});
      trace.signalList.push_back(std::move(signal));
      continue;
    }
    if (tag->name != "rec") {
      continue;
    }
    const auto seconds = base::parseNumber(xmlAttribute(*tag, "time"));
    if (!seconds || !std::isfinite(*seconds) || std::abs(*seconds) > 4e9) {
      continue;
    }
    const base::Instant at{base::fromSeconds(*seconds)};
    held += kAnalysedSampleBytes;
    std::string_view values = tag->raw;
    while (const auto attribute = takeXmlAttribute(values)) {
      const auto found = signalOfId.find(attribute->name);
      const auto number =
          found == signalOfId.end() ? std::nullopt : base::parseNumber(attribute->value);
      if (!number || *number > kNanAsInteger) {
        continue;
      }
      Signal& signal = trace.signalList[found->second];
      PackedTimes& times = trace.timeBases[signal.timeBase].at;
      if (!times.empty() && at <= times.back()) {
        ++backwards;
        continue;
      }
      held += kValueBytes;
      times.push_back(at);
      signal.values.push_back(*number);
    }
  }
  const bool hasValues = std::any_of(trace.signalList.begin(), trace.signalList.end(),
                                     [](const Signal& signal) { return !signal.values.empty(); });
  if (!hasValues) {
    return base::fail(
        ImportError::NotATable,
        "The SINUMERIK trace holds no values that can be read. Save it with its data, "
        "as XML, at the control.");
  }
  if (backwards > 0) {
    trace.remarks.push_back({RemarkCode::ValuesBackwards, {std::to_string(backwards)}});
  }
  if (reader.wasCut() || text.find("</traceSession>") == std::string_view::npos) {
    trace.remarks.push_back({RemarkCode::CutFile});
  }
  trace.remarks.push_back({RemarkCode::SpeedUnitsAssumed});
  return trace;
}

}  // namespace rivulet::trace
