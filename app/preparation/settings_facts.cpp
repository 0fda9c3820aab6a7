// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "preparation/settings_facts.h"

#include <algorithm>
#include <sstream>

#include "base/ranges.h"
#include "base/text.h"
#include "base/units.h"
#include "gcode/feeds.h"
#include "sources/open_source.h"

namespace rivulet::preparation {

namespace {

/// Before the height of a dry run.
const std::string kDry = "dry ";
constexpr std::string_view kAuto = "auto";
/// Between accepted words, none of which has one.
constexpr char kBar = '|';
constexpr std::string_view kNoSource = "none";
constexpr std::string_view kHold = "hold";
constexpr std::string_view kOverride = "override";
constexpr double kSilenceSMax = 3600.0;

/// Adaptive feed.
SettingsFacts factorFacts(const streaming::StreamSettings& settings) {
  constexpr int kDecimals = 4;
  const live::FactorSource& source = settings.factor;
  return {
      {"feed_factor_least", base::formatFixed(settings.parameters.factorLeast, kDecimals)},
      {"feed_factor_most", base::formatFixed(settings.parameters.factorMost, kDecimals)},
      {"feed_from", source.address.empty() ? std::string(kNoSource) : source.address},
      {"feed_silence", base::formatFixed(base::toSeconds(source.silence), kDecimals)},
      {"feed_silent", source.holdsInSilence ? std::string(kHold) : std::string(kOverride)},
  };
}

/// How the points travel. What is usual is not in a release: earlier ones do not name it.
SettingsFacts pointFacts(const streaming::StreamSettings& settings) {
  return {{"packed", settings.parameters.packed ? "yes" : "no"},
          {"tolerance", base::formatFixed(settings.tolerance, 6)}};
}

void applyFactor(streaming::StreamSettings& settings, const std::string& name,
                 const std::string& value) {
  const auto number = base::parseNumber(value);
  const bool isFactor = number && *number >= 0.0 && *number <= templates::kFactorMax;
  if (name == "feed_factor_least" && isFactor) {
    settings.parameters.factorLeast = *number;
  } else if (name == "feed_factor_most" && isFactor) {
    settings.parameters.factorMost = *number;
  } else if (name == "feed_from" && (value == kNoSource || sources::isPort(value))) {
    settings.factor.address = value == kNoSource ? std::string() : value;
  } else if (name == "feed_silence" && number && *number > 0.0 && *number <= kSilenceSMax) {
    settings.factor.silence = base::fromSeconds(*number);
  } else if (name == "feed_silent" && (value == kHold || value == kOverride)) {
    settings.factor.holdsInSilence = value == kHold;
  }
}

}  // namespace

SettingsFacts settingsFacts(const streaming::StreamSettings& settings) {
  const templates::TemplateParameters& parameters = settings.parameters;
  constexpr int kDecimals = 4;
  SettingsFacts facts{
      {"method", std::string(base::methodName(parameters.method))},
      {"points", std::to_string(parameters.pointsPerLoop)},
      {"feed", base::formatFixed(base::mmPerMinFromMmPerS(settings.feedMmPerS), kDecimals)},
      {"feeds", settings.usesProgramFeeds() ? "program" : "one"},
      {"override", base::formatFixed(settings.overrideFactor, kDecimals)},
      {"delta", base::formatFixed(settings.deltaMm, kDecimals)},
      {"layout", std::string(templates::layoutName(parameters.layout))},
      {"windows", std::to_string(parameters.windows)},
      {"feed_per_point", parameters.feedPerPoint ? "yes" : "no"},
      {"base_cell", std::to_string(parameters.baseCell)},
      {"correction_limit", base::formatFixed(parameters.correctionLimitMm, kDecimals)},
      {"access", std::to_string(static_cast<int>(settings.access))},
      {"job", !settings.wholeJob        ? "motion only"
              : settings.dryRunMm > 0.0 ? kDry + base::formatFixed(settings.dryRunMm, kDecimals)
                                        : "whole"},
      {"transfer_by_hand", settings.transferByHand ? "yes" : "no"},
  };
  for (const SettingsFacts& group : {pointFacts(settings), factorFacts(settings)}) {
    facts.insert(facts.end(), group.begin(), group.end());
  }
  return facts;
}

void applySettings(streaming::StreamSettings& settings, const SettingsFacts& facts) {
  templates::TemplateParameters& parameters = settings.parameters;
  for (const auto& [name, value] : facts) {
    const auto number = base::parseNumber(value);
    const auto whole = base::parseInteger(value);
    if (name == "method") {
      parameters.method = base::methodFromName(value).value_or(parameters.method);
    } else if (name == "layout") {
      parameters.layout = templates::layoutFromName(value).value_or(parameters.layout);
    } else if (name == "points" && whole) {
      parameters.pointsPerLoop = *whole;
    } else if (name == "windows" && whole) {
      parameters.windows = *whole;
    } else if (name == "base_cell" && whole) {
      parameters.baseCell = *whole;
    } else if (name == "feed" && number && base::isFeedMmPerMin(*number)) {
      settings.feedMmPerS = base::mmPerSFromMmPerMin(*number);
    } else if (name == "feeds") {
      settings.programFeeds = value == "program";
    } else if (name == "override" && number && *number >= gcode::kOverrideMin &&
               *number <= gcode::kOverrideMax) {
      settings.overrideFactor = *number;
    } else if (name == "delta" && number && *number > 0.0) {
      settings.deltaMm = *number;
    } else if (name == "correction_limit" && number && *number >= 0.0) {
      parameters.correctionLimitMm = *number;
    } else if (name == "access" && whole && *whole >= 0 &&
               *whole <= static_cast<int>(streaming::AccessPreference::Single)) {
      settings.access = static_cast<streaming::AccessPreference>(*whole);
    } else if (name == "job") {
      const bool isDry = value.starts_with(kDry);
      settings.wholeJob = isDry || value == "whole";
      settings.dryRunMm = isDry ? base::parseNumber(value.substr(kDry.size())).value_or(0.0) : 0.0;
    } else if (name == "feed_per_point") {
      parameters.feedPerPoint = value == "yes";
    } else if (name == "packed") {
      parameters.packed = value == "yes";
    } else if (name == "tolerance" && number && *number >= 0.0 &&
               *number <= gcode::kStreamToleranceMax) {
      settings.tolerance = *number;
    } else if (name == "transfer_by_hand") {
      settings.transferByHand = value == "yes";
    } else {
      applyFactor(settings, name, value);
    }
  }
}

SettingsFacts readingFacts(const gcode::TextReading& reading) {
  const auto name = [](const auto& value, auto nameOf) {
    return value ? std::string(nameOf(*value)) : std::string(kAuto);
  };
  std::string accepted;
  for (const std::string& word : reading.accepted) {
    accepted += (accepted.empty() ? "" : std::string(1, kBar)) + word;
  }
  return {
      {"dialect", name(reading.dialect, gcode::dialectName)},
      {"units", name(reading.units, gcode::fileUnitsName)},
      {"no_point", name(reading.noPoint, gcode::noPointName)},
      {"centres", std::string(gcode::centreReadingName(reading.centres))},
      {"settings", gcode::textOf(reading.settings)},
      {"chord_tolerance", base::formatFixed(reading.chordToleranceMm, 6)},
      {"accept", accepted},
  };
}

void applyReading(gcode::TextReading& reading, const SettingsFacts& facts) {
  for (const auto& [name, value] : facts) {
    if (name == "dialect" && (value == kAuto || gcode::dialectOfName(value))) {
      reading.dialect = gcode::dialectOfName(value);
    } else if (name == "units" && (value == kAuto || gcode::saidUnitsOfName(value))) {
      reading.units = gcode::saidUnitsOfName(value);
    } else if (name == "no_point" && (value == kAuto || gcode::noPointOfName(value))) {
      reading.noPoint = gcode::noPointOfName(value);
    } else if (name == "settings") {
      reading.settings = gcode::controlSettingsOf(value).value_or(reading.settings);
    } else if (name == "centres") {
      reading.centres = gcode::centreReadingOfName(value).value_or(reading.centres);
    } else if (name == "chord_tolerance") {
      const auto number = base::parseNumber(value);
      const bool isTolerance =
          number && *number > 0.0 && *number <= gcode::TextReading::kChordToleranceMmMax;
      reading.chordToleranceMm = isTolerance ? *number : reading.chordToleranceMm;
    } else if (name == "accept") {
      reading.accepted.clear();
      std::stringstream words(value);
      for (std::string word; std::getline(words, word, kBar);) {
        reading.accepted.push_back(word);
      }
    }
  }
}

SettingsFacts releasedFacts(const streaming::StreamSettings& settings,
                            const gcode::TextReading& reading) {
  SettingsFacts facts = settingsFacts(settings);
  const SettingsFacts ofReading = readingFacts(reading);
  facts.insert(facts.end(), ofReading.begin(), ofReading.end());
  SettingsFacts usual = readingFacts({});
  for (const SettingsFacts& group : {pointFacts({}), factorFacts({})}) {
    usual.insert(usual.end(), group.begin(), group.end());
  }
  std::erase_if(facts, [&usual](const auto& fact) {
    return std::find(usual.begin(), usual.end(), fact) != usual.end();
  });
  return facts;
}

std::string textOf(const SettingsFacts& facts) {
  std::string text;
  for (const auto& [name, value] : facts) {
    text += (text.empty() ? "" : ";") + name + "=" + value;
  }
  return text;
}

SettingsFacts factsOfText(const std::string& text) {
  SettingsFacts facts;
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find(';', begin), text.size());
    const std::string item = text.substr(begin, end - begin);
    const std::size_t sign = item.find('=');
    if (sign != std::string::npos) {
      facts.emplace_back(item.substr(0, sign), item.substr(sign + 1));
    }
    begin = end + 1;
  }
  return facts;
}

}  // namespace rivulet::preparation
