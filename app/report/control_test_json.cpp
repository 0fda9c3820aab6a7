// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/control_test_json.h"

#include <nlohmann/json.hpp>

#include "report/run_fields.h"

namespace rivulet::report {

namespace {

using nlohmann::ordered_json;

constexpr double kMoveMost = 1e9;

template <class Io>
void resultFields(Io& io, auto& result, const streaming::Commissioning& /*kind*/) {
  io.ifThere().count("asked", result.asked);
  io.ifThere().count("answered", result.answered);
  io.ifThere().milliseconds("slowest_answer_ms", result.slowestAnswer);
}

constexpr auto kMoveFields = [](auto& io, auto& move) {
  io.number("axis", move.axis, 0, static_cast<int>(base::kAxisCount) - 1);
  io.number("mm", move.mm, -kMoveMost, kMoveMost);
  io.number("feed_mm_per_min", move.feedMmPerMin, 0.0, kMoveMost);
  io.ifThere().number("lift_mm", move.liftMm, 0.0, templates::kLiftMmMax);
};

template <class Io>
void resultFields(Io& io, auto& result, const streaming::FeedCommissioning& /*kind*/) {
  maybe(io, "air_move", result.move, kMoveFields);
  io.ifThere().milliseconds("braking_ms", result.braking);
  io.ifThere().number("overlay_limit_mm", result.limitMm, -kMoveMost, kMoveMost);
}

constexpr auto kTriedFields = [](auto& io, auto& block) {
  io.text("block", block.text);
  std::vector<std::string> kinds;
  for (const job::NativeReason kind : block.kinds) {
    kinds.emplace_back(job::nativeReasonName(kind));
  }
  io.words("kinds", kinds);
  if constexpr (std::remove_cvref_t<decltype(io)>::kReads) {
    for (const std::string& name : kinds) {
      if (const auto kind = job::nativeReasonFromName(name)) {
        block.kinds.push_back(*kind);
      } else {
        io.refuse("kinds");
      }
    }
  }
  io.named("seen_by", block.witness, streaming::witnessName, streaming::witnessFromName);
  io.text("message", block.message);
};

template <class Io>
void resultFields(Io& io, auto& result, const streaming::JobCommissioning& /*kind*/) {
  io.ifThere().object("air_move", result.move, kMoveFields);
  io.ifThere().list("tried", result.tried, kTriedFields);
}

/// What a file does not say is empty.
template <class Io, class Test>
void testFields(Io& io, Test& test) {
  io.ifThere().text("endpoint", test.endpoint);
  io.ifThere().object("server", test.server, serverFields);
  io.ifThere().text("tested_at_utc", test.testedAtUtc);
  io.ifThere().text("tool_version", test.toolVersion);
  resultFields(io, test.result, test.result);
  io.ifThere().list("checks", test.result.checks, [](auto& inner, auto& check) {
    inner.text("name", check.name);
    inner.flag("passed", check.passed);
    inner.text("message", check.message);
  });
}

template <class Test>
ordered_json jsonOf(const Test& test) {
  ordered_json json{{"passed", test.result.passed()}};
  FieldWriter io(json);
  testFields(io, test);
  return json;
}

template <class Test>
Test testOf(const ordered_json& from) {
  const nlohmann::json json(from);
  Members members(json);
  FieldReader io(members);
  Test test;
  testFields(io, test);
  if (!members.bad().empty()) {
    test.result.checks.clear();  // what cannot be read has not passed
  }
  return test;
}

}  // namespace

ordered_json testJson(const streaming::CreditTest& test) {
  return jsonOf(test);
}

ordered_json testJson(const streaming::FeedTest& test) {
  return jsonOf(test);
}

ordered_json testJson(const streaming::JobTest& test) {
  return jsonOf(test);
}

streaming::CreditTest creditTestOf(const ordered_json& json) {
  return testOf<streaming::CreditTest>(json);
}

streaming::FeedTest feedTestOf(const ordered_json& json) {
  return testOf<streaming::FeedTest>(json);
}

streaming::JobTest jobTestOf(const ordered_json& json) {
  return testOf<streaming::JobTest>(json);
}

}  // namespace rivulet::report
