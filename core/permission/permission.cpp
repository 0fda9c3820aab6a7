// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "permission/permission.h"

#include <algorithm>
#include <array>

#include "base/contract.h"

namespace rivulet::permission {

namespace {

struct Facts {
  Act act;
  std::string_view name;
  bool needsEngineer;
  bool worksLocked;
};

constexpr std::array<Facts, 24> kFacts{{
    {Act::Stop, "stop", false, true},
    {Act::Hold, "hold", false, false},
    {Act::Continue, "continue", false, false},
    {Act::Override, "override", false, false},
    {Act::Start, "start", false, false},
    {Act::Resume, "resume", false, false},
    {Act::Watch, "watch", false, false},
    {Act::Correct, "correct", false, false},
    {Act::OpenProgram, "open-program", false, false},
    {Act::ChangeSettings, "change-settings", true, false},
    {Act::Connect, "connect", false, false},
    {Act::Disconnect, "disconnect", false, false},
    {Act::Trust, "trust", true, false},
    {Act::Calibrate, "calibrate", true, false},
    {Act::Release, "release", true, false},
    {Act::TakeBackRelease, "take-back-release", true, false},
    {Act::Acknowledge, "acknowledge", false, false},
    {Act::Shelve, "shelve", false, false},
    {Act::SetUpUsers, "set-up-users", true, false},
    {Act::LogIn, "log-in", false, true},
    {Act::LogInFailed, "log-in-failed", false, true},
    {Act::Lock, "lock", false, true},
    {Act::ProgramStart, "program-start", false, true},
    {Act::ProgramEnd, "program-end", false, true},
}};

constexpr bool isInOrder() {
  for (std::size_t i = 0; i < kFacts.size(); ++i) {
    if (kFacts[i].act != static_cast<Act>(i)) {
      return false;
    }
  }
  return true;
}
static_assert(isInOrder(), "the act is the index");

const Facts& factsOf(Act act) {
  const auto index = static_cast<std::size_t>(act);
  RIVULET_ASSERT(index < kFacts.size());
  return kFacts[index];
}

/// The last release that fits, unless it is taken back.
template <class Fits>
const Release* lastThat(std::span<const Release> releases, Fits fits) {
  const auto found = std::find_if(releases.rbegin(), releases.rend(), fits);
  return found == releases.rend() || found->isTakenBack ? nullptr : &*found;
}

}  // namespace

std::string_view actName(Act act) {
  return factsOf(act).name;
}

std::optional<Act> actOfName(std::string_view name) {
  const auto* found = std::find_if(kFacts.begin(), kFacts.end(),
                                   [name](const Facts& facts) { return facts.name == name; });
  return found == kFacts.end() ? std::nullopt : std::optional(found->act);
}

std::string_view roleName(Role role) {
  return role == Role::Operator ? "operator" : "engineer";
}

std::optional<Role> roleOfName(std::string_view name) {
  for (const Role role : {Role::Operator, Role::Engineer}) {
    if (roleName(role) == name) {
      return role;
    }
  }
  return std::nullopt;
}

std::optional<Refusal> refusal(const Standing& standing, Act act, bool isReleased, bool mayRepeat) {
  if (standing.isLocked && !factsOf(act).worksLocked) {
    return Refusal::Locked;
  }
  if (standing.role == Role::Engineer) {
    return std::nullopt;
  }
  const bool moves = act == Act::Start || act == Act::Resume;
  if (factsOf(act).needsEngineer || (moves && mayRepeat)) {
    return Refusal::NeedsEngineer;
  }
  return moves && !isReleased ? std::optional(Refusal::NotReleased) : std::nullopt;
}

const Release* releaseOf(std::span<const Release> releases, const Job& job) {
  return lastThat(releases, [&job](const Release& release) { return release.job == job; });
}

const Release* lastReleaseOf(std::span<const Release> releases, std::string_view programHash) {
  for (auto release = releases.rbegin(); release != releases.rend(); ++release) {
    if (release->job.programHash == programHash && releaseOf(releases, release->job) != nullptr) {
      return releaseOf(releases, release->job);
    }
  }
  return nullptr;
}

}  // namespace rivulet::permission
