// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The audit trail: who did what when, one JSON object per line (docs/formats.md). Every line holds
/// the SHA-256 of the line before it and of itself, so that a later change shows. How many lines
/// there are, and the hash of the last one, is kept in a second place (`auditHeadOf`), so that
/// lines that are missing at the end show, too. That does not stop somebody who may write both:
/// keep a copy, or the last hash, elsewhere.
/// @threadsafety reads and writes files; shares nothing.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "base/utc.h"

namespace rivulet::journal {

struct AuditEntry {
  base::UtcMs at = 0;
  std::string who;
  std::string role;  ///< "operator", "engineer"; empty: nobody has set up roles
  std::string act;   ///< `permission::actName`
  std::vector<std::pair<std::string, std::string>> details;  ///< names and values, in order

  friend bool operator==(const AuditEntry&, const AuditEntry&) = default;
};

enum class AuditFault {
  NotALine,     ///< cut by a loss of power, or damaged
  Changed,      ///< the text does not have the hash that stands in it
  ChainBroken,  ///< the line does not follow from the one before it
  TailMissing,  ///< from this line on, lines are missing that had been written
  Replaced,     ///< the trail is not the one whose head is kept
};

struct AuditFinding {
  std::size_t line = 0;  ///< from 1
  AuditFault fault = AuditFault::NotALine;
  std::size_t missing = 0;  ///< lines, of TailMissing

  friend bool operator==(const AuditFinding&, const AuditFinding&) = default;
};

struct AuditContent {
  struct Line {
    std::size_t number = 0;  ///< from 1
    AuditEntry entry;
  };
  std::vector<Line> lines;  ///< that can be read, also those that were changed
  std::vector<AuditFinding> findings;
  std::string lastHash;  ///< SHA-256 of the last line; empty: there is none
  bool hasHead = false;  ///< else a missing end would not show

  /// The first line that somebody must have changed, inserted or removed; 0: none.
  [[nodiscard]] std::size_t firstChange() const;
};

/// "audit.jsonl" in the folder of what is kept.
[[nodiscard]] std::filesystem::path auditFileIn(const std::filesystem::path& folder);

/// Where count and hash of the lines of a trail are kept: below $XDG_DATA_HOME, mode 0600.
[[nodiscard]] std::filesystem::path auditHeadOf(const std::filesystem::path& trail);

/// Returns when the line, and then the head, is on the disk. Lines that were found to be missing
/// before stay noted in the head. @return NotWritable
[[nodiscard]] base::Result<void> appendAudit(const std::filesystem::path& path,
                                             const AuditEntry& entry);
/// Reads and verifies, also against the head. A file that does not exist is empty. @return
/// Unreadable
[[nodiscard]] base::Result<AuditContent> readAudit(const std::filesystem::path& path);

/// With a line of titles; details as "name=value; name=value".
[[nodiscard]] std::string auditCsv(const AuditContent& content);
[[nodiscard]] std::string auditJson(const AuditContent& content);

/// "changed", ...
[[nodiscard]] std::string_view faultName(AuditFault fault);
/// One English sentence.
[[nodiscard]] std::string describe(const AuditFinding& finding);

}  // namespace rivulet::journal
