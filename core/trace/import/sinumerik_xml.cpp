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

namespace rivulet::trace {

namespace {

/// A NaN that was written as an unsigned whole number is at least this.
constexpr double kNanAsInteger = 9.2e18;

// What is held of a trace, with what is made of it, bytes.
constexpr std::size_t kSignalBytes = 1000;  // beside its values: names, role, remarks
/// With its time, in lists that grow.
constexpr std::size_t kValueBytes = 2 * (sizeof(double) + sizeof(base::Instant));

/// Elements without content, one after another: all that this file needs of XML.
class ElementReader {
 public:
  ElementReader(std::string_view text, std::size_t from) : m_text(text), m_at(from) {}

  /// The next start tag; nothing at the end, or where the text was cut within a tag.
  [[nodiscard]] std::optional<std::string_view> next() {
    while (m_at < m_text.size()) {
      const std::size_t open = m_text.find('<', m_at);
      if (open == std::string_view::npos) {
        break;
      }
      const std::size_t close = m_text.find('>', open);
      if (close == std::string_view::npos) {
        m_wasCut = true;
        break;
      }
      m_at = close + 1;
      const std::string_view tag = m_text.substr(open + 1, close - open - 1);
      if (!tag.empty() && tag[0] != '/' && tag[0] != '?' && tag[0] != '!') {
        return tag;
      }
    }
    m_at = m_text.size();
    return std::nullopt;
  }
  [[nodiscard]] bool wasCut() const { return m_wasCut; }

 private:
  std::string_view m_text;
  std::size_t m_at;
  bool m_wasCut = false;
};

std::string_view nameOf(std::string_view tag) {
  return tag.substr(0, tag.find_first_of(" \t\r\n/"));
}

/// Calls `take(name, value)` for each attribute of a tag.
template <class Take>
void eachAttribute(std::string_view tag, const Take& take) {
  std::size_t at = nameOf(tag).size();
  for (;;) {
    const std::size_t begin = tag.find_first_not_of(" \t\r\n/", at);
    const std::size_t equal = tag.find('=', begin);
    if (begin == std::string_view::npos || equal == std::string_view::npos ||
        equal + 1 >= tag.size()) {
      return;
    }
    const char quote = tag[equal + 1];
    const std::size_t end = tag.find(quote, equal + 2);
    if (end == std::string_view::npos) {
      return;
    }
    take(base::trim(tag.substr(begin, equal - begin)), tag.substr(equal + 2, end - equal - 2));
    at = end + 1;
  }
}

std::string attribute(std::string_view tag, std::string_view wanted) {
  std::string found;
  eachAttribute(tag, [&](std::string_view name, std::string_view value) {
    if (name == wanted) {
      found = value;
    }
  });
  return found;
}

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
  ElementReader reader(text, std::min(frame, text.size()));
  std::size_t backwards = 0;
  std::size_t held = 0;
  while (const auto tag = reader.next()) {
    if (held > budget.left()) {
      return base::fail(budget.exceeded("The trace with its analysis"));
    }
    if (nameOf(*tag) == "dataSignal") {
      held += kSignalBytes + 2 * tag->size();
      const std::string id = attribute(*tag, "id");
      Signal signal;
      const std::string path = attribute(*tag, "name");
      // The axis is in the path: "... [u1, 2]".
      const std::size_t index = path.find('[');
      signal.name = attribute(*tag, "description") +
                    (index == std::string::npos ? "" : " " + path.substr(index));
      signal.unit = unitOf(attribute(*tag, "unitsType"));
      signal.timeBase = trace.timeBases.size();
      signalOfId[id.empty() ? fmt::format("f{}", trace.signalList.size() + 1) : id] =
          trace.signalList.size();
      trace.timeBases.push_back({"time", {}});
      trace.signalList.push_back(std::move(signal));
      continue;
    }
    if (nameOf(*tag) != "rec") {
      continue;
    }
    const auto seconds = base::parseNumber(attribute(*tag, "time"));
    if (!seconds || !std::isfinite(*seconds) || std::abs(*seconds) > 4e9) {
      continue;
    }
    const base::Instant at{base::fromSeconds(*seconds)};
    held += kAnalysedSampleBytes;
    eachAttribute(*tag, [&](std::string_view name, std::string_view value) {
      const auto found = signalOfId.find(name);
      const auto number = found == signalOfId.end() ? std::nullopt : base::parseNumber(value);
      if (!number || *number > kNanAsInteger) {
        return;
      }
      Signal& signal = trace.signalList[found->second];
      std::vector<base::Instant>& times = trace.timeBases[signal.timeBase].at;
      if (!times.empty() && at <= times.back()) {
        ++backwards;
        return;
      }
      held += kValueBytes;
      times.push_back(at);
      signal.values.push_back(*number);
    });
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
