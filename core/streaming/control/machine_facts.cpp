// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/control/machine_facts.h"

#include <fmt/format.h>

#include <utility>

#include "base/error.h"
#include "streaming/run/run.h"
#include "templates/target.h"

namespace rivulet::streaming {

std::error_code make_error_code(MachineFileError code) {
  static const base::NamedCategory category("machine file");
  return {static_cast<int>(code), category};
}

std::string versionText(const opcua::ServerIdentity& server) {
  const std::string text =
      fmt::format("{} {} {}", server.productName, server.softwareVersion, server.buildNumber);
  const std::size_t last = text.find_last_not_of(' ');
  return last == std::string::npos ? "a server without a name" : text.substr(0, last + 1);
}

base::Result<void> requireCreditTest(const std::optional<CreditTest>& test,
                                     const std::string& endpoint,
                                     const opcua::ServerIdentity& now) {
  const auto refuse = [&endpoint](const std::string& why) {
    return base::fail(
        StreamError::NotCommissioned,
        fmt::format("Method credit is experimental and starts only on a control that has passed "
                    "its test. {} Run rivulet-cli commission --endpoint {}, or choose method "
                    "window.",
                    why, endpoint));
  };
  if (!test) {
    return refuse("This control has not been tested.");
  }
  if (!(test->server == now)) {
    return refuse(fmt::format("The test was made with {}; now it is {}.", versionText(test->server),
                              versionText(now)));
  }
  if (!test->result.passed()) {
    return refuse(fmt::format("This control failed the test on {}.", test->testedAtUtc));
  }
  return {};
}

FeedProof feedProof(const std::optional<FeedTest>& test, const opcua::ServerIdentity& now,
                    bool isVirtualMachine) {
  const bool isOfNow = test && test->server == now;
  if (isOfNow && !test->result.passed()) {
    return FeedProof::Failed;
  }
  if (isVirtualMachine) {
    return FeedProof::Proved;
  }
  return !test                   ? FeedProof::NotTested
         : !isOfNow              ? FeedProof::OtherServer
         : test->result.proves() ? FeedProof::Proved
                                 : FeedProof::WithoutMotion;
}

double provedLiftMm(const std::optional<FeedTest>& test, const opcua::ServerIdentity& now,
                    bool isVirtualMachine) {
  if (feedProof(test, now, isVirtualMachine) != FeedProof::Proved) {
    return 0.0;
  }
  return isVirtualMachine ? templates::kLiftMmMax : test->result.provedLiftMm();
}

std::string_view describe(FeedProof proof) {
  switch (proof) {
    case FeedProof::Proved:
      break;
    case FeedProof::NotTested:
      return "The feed cell has not been tested on this control (rivulet-cli commission "
             "--feed-cell).";
    case FeedProof::OtherServer:
      return "The feed cell was tested with another version of the server: test it again.";
    case FeedProof::Failed:
      return "This control has failed the test of the feed cell.";
    case FeedProof::WithoutMotion:
      return "The feed cell was tested without motion only: whether the axes obey has not been "
             "seen (rivulet-cli commission --feed-cell --air-move).";
  }
  return {};
}

JobRelease::JobRelease(const std::optional<JobTest>& test, std::string endpoint,
                       const opcua::ServerIdentity& now, bool isVirtualMachine)
    : m_isUnlimited(templates::runsWholeJobs(now.applicationUri, isVirtualMachine)),
      m_endpoint(std::move(endpoint)) {
  if (m_isUnlimited) {
    return;
  }
  m_whyNone =
      !test                    ? "Whole jobs have not been tested on this control."
      : !(test->server == now) ? fmt::format("Whole jobs were tested with {}; now it is {}.",
                                             versionText(test->server), versionText(now))
      : !test->result.passed()
          ? fmt::format("This control failed the test of whole jobs on {}.", test->testedAtUtc)
          : std::string();
  if (m_whyNone.empty()) {
    m_tested = test->result;
  }
}

const job::NativeBlock* JobRelease::firstUntried(const job::Plan& plan) const {
  for (const job::Part& part : plan.parts) {
    const auto* const block = std::get_if<job::NativeBlock>(&part);
    if (!m_isUnlimited && block != nullptr && !block->text.empty() && !m_tested.releases(*block)) {
      return block;
    }
  }
  return nullptr;
}

base::Result<void> JobRelease::require(const job::Plan& plan) const {
  if (!runsJobs()) {
    return base::fail(StreamError::NotCommissioned,
                      fmt::format("{} Test it with rivulet-cli commission --jobs --endpoint {}, or "
                                  "stream the motion alone.",
                                  m_whyNone, m_endpoint));
  }
  const job::NativeBlock* const block = firstUntried(plan);
  if (block == nullptr) {
    return {};
  }
  return base::fail(
      StreamError::NotCommissioned,
      fmt::format("Line {}{}: \"{}\" ({}) has not been tried on this control. Test it with "
                  "rivulet-cli commission --jobs --block, or stream the motion alone.",
                  block->place.line.value,
                  block->file.empty() ? std::string() : " of " + block->file, block->text,
                  job::nativeReasonName(block->reason)));
}

}  // namespace rivulet::streaming
