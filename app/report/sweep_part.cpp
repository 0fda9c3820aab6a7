// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/sweep_part.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/text.h"
#include "report/json_members.h"

namespace rivulet::report {

namespace {

constexpr const char* kKind = "rivulet part of an experiment";
constexpr double kSharesMax = 1e6;
constexpr double kWidthMax = 1e3;

}  // namespace

std::error_code make_error_code(SweepPartError code) {
  static const base::NamedCategory category("sweep part");
  return {static_cast<int>(code), category};
}

std::string sweepPartText(const SweepPart& part) {
  nlohmann::ordered_json numbers = nlohmann::ordered_json::array();
  for (const double number : part.numbers.numbers) {
    // JSON has no such numbers; text has.
    numbers.push_back(std::isfinite(number) ? nlohmann::ordered_json(number)
                                            : nlohmann::ordered_json(fmt::format("{}", number)));
  }
  return nlohmann::ordered_json{{"kind", kKind},
                                {"version", part.origin.version},
                                {"experiment", part.origin.experiment},
                                {"seeds", part.origin.seeds},
                                {"preset", part.origin.preset},
                                {"preset_sha256", part.origin.presetHash},
                                {"part", part.numbers.share.number},
                                {"of", part.numbers.share.of},
                                {"jobs", part.numbers.jobs},
                                {"numbers_each", part.numbers.width},
                                {"numbers", std::move(numbers)}}
             .dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) +
         "\n";
}

base::Result<SweepPart> sweepPartOf(std::string_view text, const std::string& name,
                                    const base::Budget& budget) {
  const auto json = parseJson(text, budget);
  if (!json) {
    return base::fail(json.error().code, json.error().message, name);
  }
  Members members(*json);
  SweepPart part;
  if (members.text("/kind") != kKind) {
    return base::fail(SweepPartError::Unreadable,
                      "This is no part of an experiment. Name the files that `experiment --shard` "
                      "has written.",
                      name);
  }
  part.origin = {members.text("/version"), members.text("/experiment"),
                 members.integer<std::size_t>("/seeds", 0.0, kJsonCountMax),
                 members.text("/preset"), members.text("/preset_sha256")};
  part.numbers.share = {members.integer<std::size_t>("/part", 1.0, kSharesMax),
                        members.integer<std::size_t>("/of", 1.0, kSharesMax)};
  part.numbers.jobs = members.integer<std::size_t>("/jobs", 0.0, kJsonCountMax);
  part.numbers.width = members.integer<std::size_t>("/numbers_each", 0.0, kWidthMax);
  const nlohmann::json* numbers = members.find("/numbers");
  if (numbers == nullptr || !numbers->is_array()) {
    members.refuse("/numbers");
  } else {
    for (const nlohmann::json& number : *numbers) {
      const auto value = number.is_number()   ? std::optional(number.get<double>())
                         : number.is_string() ? base::parseNumber(number.get<std::string>())
                                              : std::nullopt;
      if (!value) {
        members.refuse("/numbers");
        break;
      }
      part.numbers.numbers.push_back(*value);
    }
  }
  if (!members.bad().empty()) {
    return base::fail(
        SweepPartError::Unreadable,
        fmt::format("\"{}\" is missing or damaged. Compute this part again.", members.bad()), name);
  }
  return part;
}

base::Result<SweepPart> mergedParts(const std::vector<SweepPart>& parts) {
  std::vector<base::ShareNumbers> numbers;
  for (const SweepPart& part : parts) {
    if (part.origin != parts.front().origin) {
      const SweepOrigin& one = parts.front().origin;
      const SweepOrigin& other = part.origin;
      return base::fail(
          SweepPartError::Unlike,
          fmt::format("Parts of \"{}\" were computed with different options (version {} and {}, {} "
                      "and {} seeds, preset {} and {}). Compute them again with the same ones.",
                      one.experiment, one.version, other.version, one.seeds, other.seeds,
                      one.preset, other.preset));
    }
    numbers.push_back(part.numbers);
  }
  auto whole = base::merged(numbers);
  if (!whole) {
    return base::fail(whole.error());
  }
  return SweepPart{parts.empty() ? SweepOrigin{} : parts.front().origin, std::move(*whole)};
}

}  // namespace rivulet::report
