// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/machine_profile.h"

#include <fmt/format.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <system_error>

#include "report/machine_file.h"
#include "streaming/run.h"
#include "trace/control_trace.h"
#include "trace/file.h"

namespace rivulet::report {

namespace {

using nlohmann::ordered_json;

constexpr int kFormatVersion = 1;
constexpr const char* kFormatKey = "rivulet_machine_profile";
constexpr const char* kCreditKey = "credit_test";

ordered_json jsonOf(const CreditTest& test) {
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

/// The whole profile. An empty text is an empty profile.
base::Result<ordered_json> profileOf(std::string_view text, const std::string& origin) {
  if (text.empty()) {
    return ordered_json{{kFormatKey, kFormatVersion}};
  }
  ordered_json json = ordered_json::parse(text, nullptr, false);
  if (!json.is_object() || !json.contains(kFormatKey) || !json[kFormatKey].is_number_integer()) {
    return base::fail(trace::TraceError::NotATrace,
                      "This is not a machine profile of Rivulet. Move the file away.", origin);
  }
  if (json[kFormatKey].get<int>() > kFormatVersion) {
    return base::fail(trace::TraceError::NewerVersion,
                      "The machine profile was written by a newer Rivulet. Use that version.",
                      origin);
  }
  return json;
}

template <class T>
T valueOf(const ordered_json& json, const char* key) {
  // Another type is as good as nothing: a test that says so little has not been passed.
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

std::string versionText(const opcua::ServerIdentity& server) {
  const std::string text =
      fmt::format("{} {} {}", server.productName, server.softwareVersion, server.buildNumber);
  const std::size_t last = text.find_last_not_of(' ');
  return last == std::string::npos ? "a server without a name" : text.substr(0, last + 1);
}

}  // namespace

base::Result<std::string> withCreditTest(std::string_view text, const CreditTest& test,
                                         const std::string& origin) {
  base::Result<ordered_json> profile = profileOf(text, origin);
  if (!profile) {
    return base::fail(profile.error());
  }
  (*profile)[kCreditKey] = jsonOf(test);
  return profile->dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
}

base::Result<std::optional<CreditTest>> creditTestOf(std::string_view text,
                                                     const std::string& origin) {
  const base::Result<ordered_json> profile = profileOf(text, origin);
  if (!profile) {
    return base::fail(profile.error());
  }
  if (!profile->contains(kCreditKey) || !(*profile)[kCreditKey].is_object()) {
    return std::optional<CreditTest>();
  }
  const ordered_json& json = (*profile)[kCreditKey];
  CreditTest test;
  test.endpoint = valueOf<std::string>(json, "endpoint");
  test.testedAtUtc = valueOf<std::string>(json, "tested_at_utc");
  test.toolVersion = valueOf<std::string>(json, "tool_version");
  test.result.asked = valueOf<int>(json, "asked");
  test.result.answered = valueOf<int>(json, "answered");
  test.result.slowestAnswer = base::fromMilliseconds(valueOf<double>(json, "slowest_answer_ms"));
  if (json.contains("server")) {
    const ordered_json& server = json["server"];
    test.server = {valueOf<std::string>(server, "application_uri"),
                   valueOf<std::string>(server, "product"), valueOf<std::string>(server, "version"),
                   valueOf<std::string>(server, "build")};
  }
  if (json.contains("checks") && json["checks"].is_array()) {
    for (const ordered_json& check : json["checks"]) {
      test.result.checks.push_back({valueOf<std::string>(check, "name"),
                                    valueOf<bool>(check, "passed"),
                                    valueOf<std::string>(check, "message")});
    }
  }
  return std::optional(std::move(test));
}

std::filesystem::path profileFolder() {
  const char* config = std::getenv("XDG_CONFIG_HOME");
  if (config != nullptr && *config == '/') {
    return std::filesystem::path(config) / "rivulet" / "machines";
  }
  const char* home = std::getenv("HOME");
  return std::filesystem::path(home != nullptr ? home : ".") / ".config" / "rivulet" / "machines";
}

std::filesystem::path profilePath(const std::filesystem::path& folder, const std::string& endpoint,
                                  const opcua::ServerIdentity& server) {
  return folder / machineFileName(endpoint, server);
}

base::Result<void> saveCreditTest(const std::filesystem::path& folder, const CreditTest& test) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  const std::filesystem::path path = profilePath(folder, test.endpoint, test.server);
  if (error) {
    return base::fail(
        trace::TraceError::FileNotWritable,
        "The folder for the machine profiles cannot be created. Check the permissions.",
        folder.string());
  }
  std::string before;
  if (std::filesystem::exists(path, error)) {
    base::Result<std::string> text = trace::readFile(path);
    if (!text) {
      return base::fail(text.error());
    }
    before = std::move(*text);
  }
  const base::Result<std::string> after = withCreditTest(before, test, path.string());
  if (!after) {
    return base::fail(after.error());
  }
  return trace::writeFile(path, *after);
}

base::Result<void> requireCreditTest(const std::filesystem::path& folder,
                                     const std::string& endpoint,
                                     const opcua::ServerIdentity& server) {
  const std::string command = fmt::format("Run rivulet-cli commission --endpoint {}", endpoint);
  const auto refuse = [&](const std::string& why) {
    return base::fail(streaming::StreamError::NotCommissioned,
                      fmt::format("Method credit is experimental and starts only on a control that "
                                  "has passed its test. {} {}, or choose method window.",
                                  why, command));
  };
  const std::filesystem::path path = profilePath(folder, endpoint, server);
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    return refuse("This control has not been tested.");
  }
  const base::Result<std::string> text = trace::readFile(path);
  if (!text) {
    return base::fail(text.error());
  }
  const auto test = creditTestOf(*text, path.string());
  if (!test) {
    return base::fail(test.error());
  }
  if (!*test) {
    return refuse("This control has not been tested.");
  }
  if (!((*test)->server == server)) {
    return refuse(fmt::format("The test was made with {}; now it is {}.",
                              versionText((*test)->server), versionText(server)));
  }
  if (!(*test)->result.passed()) {
    return refuse(fmt::format("This control failed the test on {}.", (*test)->testedAtUtc));
  }
  return {};
}

std::string creditTestJson(const CreditTest& test) {
  return jsonOf(test).dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace rivulet::report
