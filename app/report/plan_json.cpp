// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/plan_json.h"

#include <nlohmann/json.hpp>

#include "job/main_program.h"

namespace rivulet::report {

using nlohmann::ordered_json;

namespace {

ordered_json stretchJson(const job::Stretch& stretch) {
  return {{"kind", "streamed"},
          {"stretch", stretch.number},
          {"first_line", stretch.blocks.front().line.value},
          {"last_line", stretch.blocks.back().line.value},
          {"blocks", stretch.blocks.size()},
          {"points", stretch.pointCount},
          {"start_known", stretch.startIsKnown()}};
}

ordered_json nativeJson(const job::NativeBlock& native) {
  ordered_json block{{"kind", "native"},
                     {"line", native.place.line.value},
                     {"reason", job::nativeReasonName(native.reason)},
                     {"source", native.source},
                     {"text", native.text},
                     {"moves", native.moves}};
  if (!native.file.empty()) {
    block["file"] = native.file;
  }
  return block;
}

}  // namespace

ordered_json partJson(const job::Part& part) {
  if (const auto* const native = std::get_if<job::NativeBlock>(&part)) {
    return nativeJson(*native);
  }
  const auto& stretch = std::get<job::Stretch>(part);
  return stretch.number > 0 ? stretchJson(stretch) : ordered_json(nullptr);
}

ordered_json refusalsJson(const std::vector<job::Refusal>& list) {
  ordered_json refusals = ordered_json::array();
  for (const job::Refusal& refusal : list) {
    refusals.push_back({{"line", refusal.line.value},
                        {"code", job::refusalName(refusal.code)},
                        {"message", job::describe(refusal)}});
  }
  return refusals;
}

ordered_json planJson(const job::Plan& plan) {
  ordered_json parts = ordered_json::array();
  for (const job::Part& part : plan.parts) {
    if (ordered_json made = partJson(part); !made.is_null()) {
      parts.push_back(std::move(made));
    }
  }
  ordered_json json{
      {"whole", plan.isWhole()}, {"parts", parts}, {"refusals", refusalsJson(plan.refusals)}};
  if (const base::Result<void> whole = job::requireWhole(plan); !whole) {
    json["refused"] = whole.error().text();  // what a job of it would say
  }
  return json;
}

}  // namespace rivulet::report
