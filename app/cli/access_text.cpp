// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/access_text.h"

#include <fmt/format.h>

namespace rivulet::cli {

std::string accessText(opcua::Grouping used, const std::optional<streaming::AccessForms>& forms) {
  std::string text(opcua::groupingName(used));
  if (!forms) {
    return text + " (not tried)";
  }
  std::string others;
  std::string failed;
  for (const streaming::FormProof& proof : forms->proofs) {
    if (proof.form == used) {
      continue;
    }
    const std::string_view name = opcua::groupingName(proof.form);
    if (proof.works()) {
      others += fmt::format("{}{}", others.empty() ? "; also " : ", ", name);
    } else {
      failed += fmt::format("; {} does not work: {}", name, proof.why);
    }
  }
  return fmt::format("{} (proved{}{})", text, others, failed);
}

}  // namespace rivulet::cli
