// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/credit_test_json.h"

#include <nlohmann/json.hpp>

#include "report/run_fields.h"

namespace rivulet::report {

namespace {

using nlohmann::ordered_json;

/// What a file does not say is empty.
template <class Io, class Test>
void testFields(Io& io, Test& test) {
  io.ifThere().text("endpoint", test.endpoint);
  io.ifThere().object("server", test.server, serverFields);
  io.ifThere().text("tested_at_utc", test.testedAtUtc);
  io.ifThere().text("tool_version", test.toolVersion);
  io.ifThere().count("asked", test.result.asked);
  io.ifThere().count("answered", test.result.answered);
  io.ifThere().milliseconds("slowest_answer_ms", test.result.slowestAnswer);
  io.ifThere().list("checks", test.result.checks, [](auto& inner, auto& check) {
    inner.text("name", check.name);
    inner.flag("passed", check.passed);
    inner.text("message", check.message);
  });
}

}  // namespace

ordered_json creditTestJson(const streaming::CreditTest& test) {
  ordered_json json{{"passed", test.result.passed()}};
  FieldWriter io(json);
  testFields(io, test);
  return json;
}

streaming::CreditTest creditTestOf(const ordered_json& from) {
  const nlohmann::json json(from);
  Members members(json);
  FieldReader io(members);
  streaming::CreditTest test;
  testFields(io, test);
  if (!members.bad().empty()) {
    test.result.checks.clear();  // what cannot be read has not passed
  }
  return test;
}

}  // namespace rivulet::report
