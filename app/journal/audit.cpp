// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "journal/audit.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "base/file.h"
#include "base/private_file.h"
#include "base/sha256.h"
#include "journal/line_file.h"
#include "platform/user_folders.h"

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

/// What is kept apart of a trail.
struct Head {
  std::size_t lines = 0;
  std::string hash;                 ///< of the last line
  std::uintmax_t bytes = 0;         ///< of the file
  std::vector<AuditFinding> found;  ///< of ends that were missing when somebody wrote on
};

std::optional<Head> readHead(const std::filesystem::path& trail) {
  const auto text = base::readFile(auditHeadOf(trail));
  const ordered_json json =
      text ? ordered_json::parse(*text, nullptr, false) : ordered_json(nullptr);
  const auto numberOf = [](const ordered_json& object, const char* key) -> std::uint64_t {
    const auto found = object.find(key);
    return found != object.end() && found->is_number_unsigned() ? found->get<std::uint64_t>() : 0;
  };
  if (!json.is_object() || textOf(json, "hash").size() != kHashDigits) {
    return std::nullopt;
  }
  Head head{numberOf(json, "lines"), textOf(json, "hash"), numberOf(json, "bytes"), {}};
  if (const auto found = json.find("found"); found != json.end() && found->is_array()) {
    for (const ordered_json& one : *found) {
      if (one.is_object()) {
        const std::size_t missing = numberOf(one, "missing");
        head.found.push_back({numberOf(one, "line"),
                              missing > 0 ? AuditFault::TailMissing : AuditFault::Replaced,
                              missing});
      }
    }
  }
  return head;
}

base::Result<void> writeHead(const std::filesystem::path& trail, const Head& head) {
  ordered_json json{{"trail", trail.string()},
                    {"lines", head.lines},
                    {"hash", head.hash},
                    {"bytes", head.bytes},
                    {"found", ordered_json::array()}};
  for (const AuditFinding& finding : head.found) {
    json["found"].push_back({{"line", finding.line}, {"missing", finding.missing}});
  }
  const std::filesystem::path path = auditHeadOf(trail);
  if (auto made = base::makePrivateFolder(path.parent_path()); !made) {
    return made;
  }
  return base::writePrivateFile(path, dump(json) + '\n');
}

/// How the lines that are there differ from those that the head has counted. More lines are none: a
/// program may have ended between the line and its head.
std::optional<AuditFinding> judgedByHead(const Head& head, const std::vector<std::string>& lines) {
  if (lines.size() < head.lines) {
    return AuditFinding{lines.size() + 1, AuditFault::TailMissing, head.lines - lines.size()};
  }
  if (head.lines > 0 && hashOfLine(lines[head.lines - 1]) != head.hash) {
    return AuditFinding{head.lines, AuditFault::Replaced, 0};
  }
  return std::nullopt;
}

/// After a line was appended.
base::Result<void> advanceHead(const std::filesystem::path& trail, const Appended& appended) {
  std::optional<Head> before = readHead(trail);
  Head head = before.value_or(Head{});
  if (before && head.bytes == appended.bytesBefore && head.hash == hashOfLine(appended.last)) {
    ++head.lines;
  } else {
    base::Result<Lines> lines = readLines(trail);
    if (!lines) {
      return base::fail(lines.error());
    }
    const std::size_t count = lines->lines.size();
    lines->lines.pop_back();
    const auto finding = before ? judgedByHead(head, lines->lines) : std::nullopt;
    if (finding) {
      head.found.push_back(*finding);
    }
    head.lines = count;
  }
  head.hash = hashOfLine(appended.line);
  head.bytes = appended.bytesAfter;
  return writeHead(trail, head);
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

std::filesystem::path auditHeadOf(const std::filesystem::path& trail) {
  constexpr std::size_t kDigits = 16;
  std::error_code status;
  auto whole = std::filesystem::weakly_canonical(trail, status);
  if (status) {
    whole = trail;
  }
  return folders::dataHome() / "rivulet" / "audit-heads" /
         (base::sha256Hex(whole.string()).substr(0, kDigits) + ".json");
}

base::Result<void> appendAudit(const std::filesystem::path& path, const AuditEntry& entry) {
  return appendLine(
      path,
      [&entry](std::string_view last) {
        ordered_json json = jsonOf(entry);
        json["prev"] = hashOfLine(last);
        std::string body = dump(json);
        body.pop_back();  // the closing bracket
        return body + std::string(kHashKey) + base::sha256Hex(body) + std::string(kLineEnd);
      },
      0, [&path](const Appended& appended) { return advanceHead(path, appended); });
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
  if (const auto head = readHead(path)) {
    content.hasHead = true;
    content.findings.insert(content.findings.end(), head->found.begin(), head->found.end());
    const auto finding = judgedByHead(*head, lines->lines);
    // Where the chain is broken, the last line does not tell more.
    if (finding && (finding->fault == AuditFault::TailMissing || content.firstChange() == 0)) {
      content.findings.push_back(*finding);
    }
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
  json["head"] = content.hasHead;
  json["last_hash"] = content.lastHash;
  return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + '\n';
}

std::string_view faultName(AuditFault fault) {
  switch (fault) {
    case AuditFault::NotALine:
      return "not-a-line";
    case AuditFault::Changed:
      return "changed";
    case AuditFault::TailMissing:
      return "tail-missing";
    case AuditFault::Replaced:
      return "replaced";
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
    case AuditFault::TailMissing:
      return fmt::format("{} line{} missing from line {} on: the end of the trail was cut off.",
                         finding.missing, finding.missing == 1 ? " is" : "s are", finding.line);
    case AuditFault::Replaced:
      return fmt::format("Line {} is not the one that was written there: the trail was replaced.",
                         finding.line);
    case AuditFault::ChainBroken:
      break;
  }
  return fmt::format(
      "Line {} does not follow from the line before it: lines were changed, inserted or removed.",
      finding.line);
}

}  // namespace rivulet::journal
