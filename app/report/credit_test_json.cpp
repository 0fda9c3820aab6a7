// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/credit_test_json.h"

#include <string>
#include <type_traits>
#include <utility>

namespace rivulet::report {

namespace {

using nlohmann::ordered_json;

template <class T>
T valueOf(const ordered_json& json, const char* key) {
  if (!json.is_object() || !json.contains(key)) {
    return {};
  }
  const ordered_json& value = json[key];
  if constexpr (std::is_same_v<T, std::string>) {
    return value.is_string() ? value.get<T>() : T{};
  } else if constexpr (std::is_same_v<T, bool>) {
    return value.is_boolean() && value.get<bool>();
  } else {
    return value.is_number() ? value.get<T>() : T{};
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

streaming::CreditTest creditTestOf(const ordered_json& json) {
  streaming::CreditTest test;
  test.endpoint = valueOf<std::string>(json, "endpoint");
  test.testedAtUtc = valueOf<std::string>(json, "tested_at_utc");
  test.toolVersion = valueOf<std::string>(json, "tool_version");
  test.result.asked = valueOf<int>(json, "asked");
  test.result.answered = valueOf<int>(json, "answered");
  test.result.slowestAnswer = base::fromMilliseconds(valueOf<double>(json, "slowest_answer_ms"));
  const ordered_json server = json.value("server", ordered_json::object());
  test.server = {valueOf<std::string>(server, "application_uri"),
                 valueOf<std::string>(server, "product"), valueOf<std::string>(server, "version"),
                 valueOf<std::string>(server, "build")};
  if (const auto checks = json.find("checks"); checks != json.end() && checks->is_array()) {
    for (const ordered_json& check : *checks) {
      test.result.checks.push_back({valueOf<std::string>(check, "name"),
                                    valueOf<bool>(check, "passed"),
                                    valueOf<std::string>(check, "message")});
    }
  }
  return test;
}

}  // namespace rivulet::report
