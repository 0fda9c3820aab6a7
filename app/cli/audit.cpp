// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>

#include "base/file.h"
#include "cli/commands.h"
#include "journal/audit.h"
#include "journal/line_file.h"

namespace rivulet::cli {

Exit audit(const AuditOptions& options) {
  const std::filesystem::path path = options.file.empty()
                                         ? journal::auditFileIn(journal::stateFolderOfUser())
                                         : std::filesystem::path(options.file);
  std::error_code ignored;
  if (!options.file.empty() && !std::filesystem::exists(path, ignored) &&
      !std::filesystem::exists(journal::auditHeadOf(path), ignored)) {
    return reportError(
        base::makeError(base::FileError::Unreadable, "There is no such file.", path.string()),
        options.json);
  }
  const auto content = journal::readAudit(path);
  if (!content) {
    return reportError(content.error(), options.json);
  }
  if (options.json) {
    fmt::print("{}", journal::auditJson(*content));
  } else if (!options.verify) {
    fmt::print("{}", journal::auditCsv(*content));
  } else {
    for (const journal::AuditFinding& finding : content->findings) {
      fmt::print("{}\n", journal::describe(finding));
    }
    fmt::print("{}: {} lines, {}\nlast hash {}\n", path.string(), content->lines.size(),
               content->firstChange() == 0 ? "no line was changed, inserted or removed"
                                           : "lines were changed, inserted or removed",
               content->lastHash.empty() ? "-" : content->lastHash);
    if (!content->hasHead) {
      fmt::print(
          "Nothing is kept on this file elsewhere: lines missing at its end would not show.\n");
    }
  }
  return content->firstChange() == 0 ? Exit::Done : Exit::Wrong;
}

}  // namespace rivulet::cli
