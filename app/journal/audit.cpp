// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "journal/audit.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "base/sha256.h"
#include "journal/line_file.h"

namespace rivulet::journal {

using nlohmann::ordered_json;

namespace {

constexpr std::string_view kHashKey = ",\"hash\":\"";
constexpr std::size_t kHashDigits = 64;
constexpr std::string_view kLineEnd = "\"}";

ordered_json jsonOf(const AuditEntry& entry) {
  ordered_json json{{"at", base::utcText(entry.at)}, {"who", entry.who}};
  if (!entry.role.empty()) {
    json["role"] = entry.role;
  }
  json["act"] = entry.act;
  if (!entry.details.empty()) {
    ordered_json details = ordered_json::object();
    for (const auto& [name, value] : entry.details) {
      details[name] = value;
    }
    json["details"] = std::move(details);
  }
  return json;
}

std::string dump(const ordered_json& json) {
  // Names of files may hold bytes that are not UTF-8.
  return json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

std::string hashOfLine(std::string_view line) {
  return line.empty() ? std::string(kHashDigits, '0') : base::sha256Hex(line);
}

/// The text without its own hash, and that hash; nothing: there is none at its end.
std::optional<std::pair<std::string_view, std::string_view>> splitHash(std::string_view line) {
  const std::size_t tail = kHashKey.size() + kHashDigits + kLineEnd.size();
  if (line.size() <= tail || !line.ends_with(kLineEnd) ||
      line.substr(line.size() - tail, kHashKey.size()) != kHashKey) {
    return std::nullopt;
  }
  return std::pair(line.substr(0, line.size() - tail),
                   line.substr(line.size() - tail + kHashKey.size(), kHashDigits));
}

struct Parsed {
  AuditEntry entry;
  std::string previous;
};

std::optional<Parsed> parsed(const std::string& line) {
  const ordered_json json = ordered_json::parse(line, nullptr, false);
  if (!json.is_object()) {
    return std::nullopt;
  }
  const auto at = base::utcOfText(textOf(json, "at"));
  if (!at || textOf(json, "act").empty()) {
    return std::nullopt;
  }
  Parsed result{{*at, textOf(json, "who"), textOf(json, "role"), textOf(json, "act"), {}},
                textOf(json, "prev")};
  if (const auto details = json.find("details"); details != json.end() && details->is_object()) {
    for (const auto& [name, value] : details->items()) {
      result.entry.details.emplace_back(
          name, value.is_string()
                    ? value.get<std::string>()
                    : value.dump(-1, ' ', false, ordered_json::error_handler_t::replace));
    }
  }
  return result;
}

/// A field of CSV (RFC 4180). A text that a spreadsheet would take for a formula is quoted as text.
std::string csvField(std::string text) {
  if (!text.empty() && std::string_view("=+-@").find(text.front()) != std::string_view::npos) {
    text.insert(0, 1, '\'');
  }
  std::string quoted = "\"";
  for (const char c : text) {
    quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  }
  return quoted + '"';
}

}  // namespace

std::size_t AuditContent::firstChange() const {
  for (const AuditFinding& finding : findings) {
    if (finding.fault != AuditFault::NotALine) {
      return finding.line;
    }
  }
  return 0;
}

std::filesystem::path auditFileIn(const std::filesystem::path& folder) {
  return folder / "audit.jsonl";
}

base::Result<void> appendAudit(const std::filesystem::path& path, const AuditEntry& entry) {
  return appendLine(path, [&entry](std::string_view last) {
    ordered_json json = jsonOf(entry);
    json["prev"] = hashOfLine(last);
    std::string body = dump(json);
    body.pop_back();  // the closing bracket
    return body + std::string(kHashKey) + base::sha256Hex(body) + std::string(kLineEnd);
  });
}

base::Result<AuditContent> readAudit(const std::filesystem::path& path) {
  const base::Result<Lines> lines = readLines(path);
  if (!lines) {
    return base::fail(lines.error());
  }
  AuditContent content;
  std::string_view previous;    // the line before
  std::string_view beforeThat;  // the last line that could be read, if `previous` could not
  for (std::size_t i = 0; i < lines->lines.size(); ++i) {
    const std::string& line = lines->lines[i];
    const std::size_t number = i + 1;
    const auto split = splitHash(line);
    const std::optional<Parsed> entry = parsed(line);
    if (!entry || !split) {
      content.findings.push_back({number, AuditFault::NotALine});
    } else {
      if (base::sha256Hex(split->first) != split->second) {
        content.findings.push_back({number, AuditFault::Changed});
      }
      // After a line that was cut, the next one refers to the last whole line.
      if (entry->previous != hashOfLine(previous) && entry->previous != hashOfLine(beforeThat)) {
        content.findings.push_back({number, AuditFault::ChainBroken});
      }
      content.lines.push_back({number, entry->entry});
    }
    if (entry && split) {
      beforeThat = line;
    }
    previous = line;
  }
  if (lines->isCut) {
    content.findings.push_back({lines->lines.size() + 1, AuditFault::NotALine});
  }
  content.lastHash = previous.empty() ? std::string() : base::sha256Hex(previous);
  return content;
}

std::string auditCsv(const AuditContent& content) {
  std::string text = "line,at,who,role,act,details\r\n";
  for (const AuditContent::Line& line : content.lines) {
    std::string details;
    for (const auto& [name, value] : line.entry.details) {
      details += fmt::format("{}{}={}", details.empty() ? "" : "; ", name, value);
    }
    text += fmt::format("{},{},{},{},{},{}\r\n", line.number, base::utcText(line.entry.at),
                        csvField(line.entry.who), csvField(line.entry.role),
                        csvField(line.entry.act), csvField(details));
  }
  return text;
}

std::string auditJson(const AuditContent& content) {
  ordered_json json{{"lines", ordered_json::array()}, {"findings", ordered_json::array()}};
  for (const AuditContent::Line& line : content.lines) {
    ordered_json entry{{"line", line.number}};
    entry.update(jsonOf(line.entry));
    json["lines"].push_back(std::move(entry));
  }
  for (const AuditFinding& finding : content.findings) {
    json["findings"].push_back(
        {{"line", finding.line}, {"fault", faultName(finding.fault)}, {"text", describe(finding)}});
  }
  json["last_hash"] = content.lastHash;
  return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + '\n';
}

std::string_view faultName(AuditFault fault) {
  switch (fault) {
    case AuditFault::NotALine:
      return "not-a-line";
    case AuditFault::Changed:
      return "changed";
    case AuditFault::ChainBroken:
      break;
  }
  return "chain-broken";
}

std::string describe(const AuditFinding& finding) {
  switch (finding.fault) {
    case AuditFault::NotALine:
      return fmt::format("Line {} is cut or damaged, as after a loss of power.", finding.line);
    case AuditFault::Changed:
      return fmt::format("Line {} was changed after it was written.", finding.line);
    case AuditFault::ChainBroken:
      break;
  }
  return fmt::format(
      "Line {} does not follow from the line before it: lines were changed, inserted or removed.",
      finding.line);
}

}  // namespace rivulet::journal
