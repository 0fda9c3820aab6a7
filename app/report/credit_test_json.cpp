// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/credit_test_json.h"

#include <nlohmann/json.hpp>
#include <string>
#include <type_traits>
#include <utility>

#include "report/json_members.h"

namespace rivulet::report {

namespace {

using nlohmann::ordered_json;

template <class T>
T valueOf(const ordered_json& from, const char* key) {
  if (!from.is_object() || !from.contains(key)) {
    return {};
  }
  const ordered_json& value = from[key];
  if constexpr (std::is_same_v<T, std::string>) {
    return value.is_string() ? value.get<T>() : T{};
  } else if constexpr (std::is_same_v<T, bool>) {
    return value.is_boolean() && value.get<bool>();
  } else {
    const double number = value.is_number() ? value.get<double>() : 0.0;
    return number >= 0.0 && number <= kJsonCountMax ? static_cast<T>(number) : T{};
  }
}

}  // namespace

ordered_json creditTestJson(const streaming::CreditTest& test) {
  ordered_json checks = ordered_json::array();
  for (const streaming::CommissioningCheck& check : test.result.checks) {
    checks.push_back({{"name", check.name}, {"passed", check.passed}, {"message", check.message}});
  }
  return {{"passed", test.result.passed()},
          {"endpoint", test.endpoint},
          {"server",
           {{"application_uri", test.server.applicationUri},
            {"product", test.server.productName},
            {"version", test.server.softwareVersion},
            {"build", test.server.buildNumber}}},
          {"tested_at_utc", test.testedAtUtc},
          {"tool_version", test.toolVersion},
          {"asked", test.result.asked},
          {"answered", test.result.answered},
          {"slowest_answer_ms", base::toMilliseconds(test.result.slowestAnswer)},
          {"checks", std::move(checks)}};
}

streaming::CreditTest creditTestOf(const ordered_json& from) {
  streaming::CreditTest test;
  test.endpoint = valueOf<std::string>(from, "endpoint");
  test.testedAtUtc = valueOf<std::string>(from, "tested_at_utc");
  test.toolVersion = valueOf<std::string>(from, "tool_version");
  test.result.asked = valueOf<int>(from, "asked");
  test.result.answered = valueOf<int>(from, "answered");
  test.result.slowestAnswer = base::fromMilliseconds(valueOf<double>(from, "slowest_answer_ms"));
  const ordered_json server = from.value("server", ordered_json::object());
  test.server = {valueOf<std::string>(server, "application_uri"),
                 valueOf<std::string>(server, "product"), valueOf<std::string>(server, "version"),
                 valueOf<std::string>(server, "build")};
  if (const auto checks = from.find("checks"); checks != from.end() && checks->is_array()) {
    for (const ordered_json& check : *checks) {
      test.result.checks.push_back({valueOf<std::string>(check, "name"),
                                    valueOf<bool>(check, "passed"),
                                    valueOf<std::string>(check, "message")});
    }
  }
  return test;
}

}  // namespace rivulet::report
