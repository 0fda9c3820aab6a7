// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/motion_words.h"

#include <fmt/format.h>

#include <algorithm>

#include "nc/modal/vocabulary.h"

namespace rivulet::machine {

namespace {

constexpr int kSyntaxError = 12080;
constexpr int kAddressTwice = 12010;
constexpr int kGroupTwice = 12060;
constexpr int kUnknownG = 12470;
constexpr int kUnknownName = 12550;

/// G functions without effect on what the virtual machine models.
constexpr std::array kIgnoredG{40, 54, 55, 56, 57, 94, 450, 451, 500, 601, 602, 603, 505, 506};

/// What a G function sets: a function per code, a contradiction within a group is an alarm.
struct GFunction {
  int number;
  bool (*set)(MotionWords&);  ///< false: the group has been set in this block
};

template <class Value>
bool once(std::optional<Value>& target, Value value) {
  const bool isFirst = !target;
  target = value;
  return isFirst;
}

bool rounds(MotionWords& words, RoundingKind kind) {
  words.rounding = kind;
  return once(words.end, BlockEnd::Rounded);
}

constexpr std::array kGFunctions{
    GFunction{0, [](MotionWords& w) { return once(w.mode, PathMode::Rapid); }},
    GFunction{1, [](MotionWords& w) { return once(w.mode, PathMode::Line); }},
    GFunction{2, [](MotionWords& w) { return once(w.mode, PathMode::Clockwise); }},
    GFunction{3, [](MotionWords& w) { return once(w.mode, PathMode::CounterClockwise); }},
    GFunction{9, [](MotionWords& w) { return w.exactStopOnce = true; }},
    GFunction{53, [](MotionWords& w) { return w.suppressesFrame = true; }},
    GFunction{153, [](MotionWords& w) { return w.suppressesFrame = true; }},
    GFunction{17, [](MotionWords& w) { return once(w.plane, std::size_t{0}); }},
    GFunction{18, [](MotionWords& w) { return once(w.plane, std::size_t{2}); }},
    GFunction{19, [](MotionWords& w) { return once(w.plane, std::size_t{1}); }},
    GFunction{60, [](MotionWords& w) { return once(w.end, BlockEnd::ExactStop); }},
    GFunction{64, [](MotionWords& w) { return rounds(w, RoundingKind::Deviation); }},
    GFunction{641, [](MotionWords& w) { return rounds(w, RoundingKind::Distance); }},
    GFunction{642, [](MotionWords& w) { return rounds(w, RoundingKind::Deviation); }},
    GFunction{643, [](MotionWords& w) { return rounds(w, RoundingKind::Deviation); }},
    GFunction{644, [](MotionWords& w) { return rounds(w, RoundingKind::Deviation); }},
    GFunction{645, [](MotionWords& w) { return rounds(w, RoundingKind::Deviation); }},
    GFunction{70, [](MotionWords& w) { return once(w.inches, true); }},
    GFunction{71, [](MotionWords& w) { return once(w.inches, false); }},
    GFunction{90, [](MotionWords& w) { return once(w.absolute, true); }},
    GFunction{91, [](MotionWords& w) { return once(w.absolute, false); }},
    GFunction{700, [](MotionWords& w) { return once(w.inches, true); }},
    GFunction{710, [](MotionWords& w) { return once(w.inches, false); }},
};

std::optional<Alarm> setG(MotionWords& words, double number) {
  const auto found =
      std::find_if(kGFunctions.begin(), kGFunctions.end(),
                   [number](const GFunction& function) { return function.number == number; });
  if (found != kGFunctions.end()) {
    return found->set(words) ? std::nullopt
                             : std::optional<Alarm>{{kGroupTwice,
                                                     "Two G functions of one group are in the "
                                                     "block."}};
  }
  if (std::any_of(kIgnoredG.begin(), kIgnoredG.end(), [number](int g) { return g == number; })) {
    return std::nullopt;
  }
  return Alarm{kUnknownG, fmt::format("G{} is not known to this machine.", number)};
}

/// Where the value of an address goes; null: no address of this machine.
std::optional<Coordinate>* targetOf(MotionWords& words, std::string_view address) {
  using Target = std::optional<Coordinate>* (*)(MotionWords&);
  static constexpr std::array<std::pair<std::string_view, Target>, 17> kTargets{{
      {"X", [](MotionWords& w) { return &w.axes[0]; }},
      {"Y", [](MotionWords& w) { return &w.axes[1]; }},
      {"Z", [](MotionWords& w) { return &w.axes[2]; }},
      {"A", [](MotionWords& w) { return &w.rotary[0]; }},
      {"B", [](MotionWords& w) { return &w.rotary[1]; }},
      {"C", [](MotionWords& w) { return &w.rotary[2]; }},
      {"I", [](MotionWords& w) { return &w.centre[0]; }},
      {"J", [](MotionWords& w) { return &w.centre[1]; }},
      {"K", [](MotionWords& w) { return &w.centre[2]; }},
      {"I1", [](MotionWords& w) { return &w.through[0]; }},
      {"J1", [](MotionWords& w) { return &w.through[1]; }},
      {"K1", [](MotionWords& w) { return &w.through[2]; }},
      {"F", [](MotionWords& w) { return &w.feedMmPerMin; }},
      {"CR", [](MotionWords& w) { return &w.radius; }},
      {"AR", [](MotionWords& w) { return &w.openingAngle; }},
      {"TURN", [](MotionWords& w) { return &w.fullTurns; }},
      {"ADIS", [](MotionWords& w) { return &w.roundingMm; }},
  }};
  const auto found = std::find_if(kTargets.begin(), kTargets.end(),
                                  [address](const auto& entry) { return entry.first == address; });
  return found == kTargets.end() ? nullptr : found->second(words);
}

/// M S T D H, axes beyond A B C, and names without effect on the path: their values are not asked
/// for.
bool isIgnored(std::string_view address) {
  static constexpr std::array<std::string_view, 5> kModelled{"SOFT", "BRISK", "DRIVE", "ADIS",
                                                             "ADISPOS"};
  if (address.size() == 1) {
    return std::string_view("MSTDHUVW").find(address) != std::string_view::npos;
  }
  return nc::nameEffect(nc::Dialect::Sinumerik, address) == nc::NameEffect::None &&
         std::find(kModelled.begin(), kModelled.end(), address) == kModelled.end();
}

}  // namespace

bool isWithoutEffect(const nc::Words& words) {
  return std::all_of(words.words.begin(), words.words.end(),
                     [](const nc::Word& word) { return isIgnored(word.address); });
}

std::variant<MotionWords, Alarm> gather(
    const nc::Words& words,
    const std::function<nc::Expected<double>(const nc::Expression&)>& valueOf) {
  MotionWords made;
  for (const nc::Word& word : words.words) {
    const std::string& address = word.address;
    if (isIgnored(address)) {
      continue;
    }
    if (address == "SOFT" || address == "BRISK" || address == "DRIVE") {
      if (!once(made.dynamics, address == "SOFT" ? Dynamics::Soft : Dynamics::Brisk)) {
        return Alarm{kGroupTwice, "Two G functions of one group are in the block."};
      }
      continue;
    }
    if (address == "SUPA") {
      made.suppressesFrame = true;
      continue;
    }
    if (address == "CIP") {
      if (!once(made.mode, PathMode::Through)) {
        return Alarm{kGroupTwice, "Two G functions of one group are in the block."};
      }
      continue;
    }
    std::optional<Coordinate>* const target = targetOf(made, address);
    const bool isRounding = address == "ADISPOS";  // of G0: not modelled
    if ((target == nullptr && address != "G" && !isRounding) || word.extension) {
      return Alarm{kUnknownName, fmt::format("The name \"{}\" is not defined.", address)};
    }
    if (!word.value) {
      return Alarm{kSyntaxError, fmt::format("The address {} needs a value.", address)};
    }
    const nc::Expected<double> value = valueOf(*word.value);
    if (!value) {
      return alarmOf(value.error());
    }
    if (address == "G") {
      if (std::optional<Alarm> alarm = setG(made, *value)) {
        return *std::move(alarm);
      }
    } else if (target != nullptr) {
      if (*target) {
        return Alarm{kAddressTwice, "An address is programmed more than once in the block."};
      }
      *target = Coordinate{*value, word.reference};
    }
  }
  return made;
}

}  // namespace rivulet::machine
