// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "job/dry_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "base/text.h"
#include "job/main_program.h"
#include "nc/nc_number.h"
#include "nc/syntax/language.h"
#include "nc/syntax/lexer.h"

namespace rivulet::job {

namespace {

using nc::Token;
using nc::TokenKind;

constexpr std::size_t kZ = 2;

/// Turn the frame, or scale it: what is along Z then is not known.
constexpr std::array<std::string_view, 14> kTurnFrames{
    "ROT",    "AROT",    "ROTS", "AROTS",   "CROTS", "SCALE",  "ASCALE",
    "MIRROR", "AMIRROR", "RPL",  "TOFRAME", "TOROT", "CTRANS", "CFRAME"};
/// Turn the spindle themselves.
constexpr std::array<std::string_view, 5> kTurnSpindle{"CYCLE84", "CYCLE840", "CYCLE86", "CYCLE87",
                                                       "CYCLE88"};

template <std::size_t Size>
bool isOneOf(std::string_view name, const std::array<std::string_view, Size>& names) {
  return std::find(names.begin(), names.end(), base::toUpper(name)) != names.end();
}

bool isWord(const Token& token) {
  return token.kind == TokenKind::Word || token.kind == TokenKind::IndexedWord ||
         token.kind == TokenKind::Expression;
}

/// Threads and the feed per revolution wait for the spindle.
bool needsSpindle(const Token& token) {
  static constexpr std::array<int, 12> kG{33, 34, 35, 63, 95, 96, 97, 331, 332, 961, 962, 971};
  return token.kind == TokenKind::Word && token.address == 'G' &&
         std::any_of(kG.begin(), kG.end(), [&token](int key) { return token.value == key; });
}

/// What is left out: it turns the spindle, stops it, or switches coolant.
bool isWet(const Token& token) {
  if (token.kind == TokenKind::NamedValue || token.kind == TokenKind::Assignment ||
      token.kind == TokenKind::Call) {
    return base::toUpper(nc::tokenName(token)).starts_with("SPOS");
  }
  if (!isWord(token)) {
    return false;
  }
  static constexpr std::array<int, 15> kM{3, 4, 5, 7, 8, 9, 13, 14, 19, 40, 41, 42, 43, 44, 45};
  const char address =
      token.address != 0 || token.text.empty() ? token.address : base::toUpper(token.text)[0];
  return address == 'S' ||
         (address == 'M' && token.kind != TokenKind::Expression &&
          std::any_of(kM.begin(), kM.end(), [&token](int key) { return token.value == key; }));
}

/// An M function whose number is calculated.
bool isUnclear(const Token& token) {
  return token.kind == TokenKind::Expression && token.address == 'M';
}

class DryPlanner {
 public:
  DryPlanner(Plan plan, double raiseMm) : m_plan(std::move(plan)), m_raiseMm(raiseMm) {}

  base::Result<Plan> make() {
    for (gcode::TrajectoryPoint& point : m_plan.program.trajectory.points) {
      point.positionMm.z += m_raiseMm;  // not a number where the axis is not named
    }
    m_plan.minMm.z += m_raiseMm;
    m_plan.maxMm.z += m_raiseMm;
    for (Part& part : m_plan.parts) {
      if (auto* const native = std::get_if<NativeBlock>(&part)) {
        if (base::Result<void> dried = dry(*native); !dried) {
          return base::fail(dried.error());
        }
      } else if (auto& stretch = std::get<Stretch>(part); stretch.number > 0) {
        stretch.startMm.z += m_raiseMm;
        m_isFirst = true;
        m_isPlaced = false;
      }
    }
    return std::move(m_plan);
  }

 private:
  [[nodiscard]] tl::unexpected<base::Error> refuse(const NativeBlock& native,
                                                   std::string_view why) const {
    return base::fail(
        JobError::NotDry,
        fmt::format("A dry run is not possible: {} {}.", why, base::trim(native.source)),
        fmt::format("{}:{}", native.file.empty() ? m_plan.program.name : native.file,
                    native.place.line.value));
  }

  base::Result<void> dry(NativeBlock& native) {
    if (native.text.empty()) {
      return {};
    }
    switch (native.reason) {
      case NativeReason::Transformation:
        return refuse(native,
                      "the control turns the coordinates here, and what is above the "
                      "workpiece is not known:");
      case NativeReason::Subprogram:
        return refuse(native, "what this program on the control does is not known:");
      case NativeReason::Probing:
        return refuse(native, "the probe would not touch the workpiece:");
      default:
        break;
    }
    if (base::Result<void> stripped = strip(native); !stripped || native.text.empty()) {
      return stripped;
    }
    return raise(native);
  }

  /// Takes the words of spindle and coolant out of a block.
  base::Result<void> strip(NativeBlock& native) const {
    const nc::Language& language = nc::languageOf(nc::Dialect::Sinumerik);
    std::string left;
    std::string_view rest = native.text;
    while (!rest.empty()) {
      const std::size_t end = rest.find('\n');
      std::string line(rest.substr(0, end));
      rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
      const nc::Words words = nc::readWords(line, language, native.place);
      bool isMore = false;
      std::vector<const Token*> wet;
      for (const Token& token : words.tokens) {
        const std::string_view name = nc::tokenName(token);
        if (isOneOf(name, kTurnFrames)) {
          return refuse(native, "the coordinates are turned or scaled here:");
        }
        if (isOneOf(name, kTurnSpindle) || needsSpindle(token) || isUnclear(token)) {
          return refuse(native, "this block needs the spindle:");
        }
        const bool isNumber = token.kind == TokenKind::Word && token.address == 'N';
        if (isWet(token)) {
          wet.push_back(&token);
        } else {
          isMore = isMore || !isNumber;
        }
      }
      const bool isDwell =
          std::any_of(words.tokens.begin(), words.tokens.end(), [](const Token& t) {
            return t.kind == TokenKind::Word && t.address == 'G' && t.value == 4.0;
          });
      if (isDwell && !wet.empty()) {
        continue;  // it counts turns of the spindle
      }
      for (auto token = wet.rbegin(); token != wet.rend(); ++token) {
        line.erase(static_cast<std::size_t>((*token)->column - 1), (*token)->text.size());
      }
      if (isMore) {
        left += (left.empty() ? "" : "\n") + std::string(base::trim(line));
      }
    }
    native.text = std::move(left);
    return {};
  }

  /// The frame in which the block moves is that of the program, higher.
  base::Result<void> raise(NativeBlock& native) {
    if (native.before.planeFirstAxis != 0) {
      return refuse(native, "the tool does not stand along Z (G18, G19):");
    }
    if (native.before.feedMode == nc::FeedMode::PerRevolution && native.moves) {
      return refuse(native, "the feed waits for the spindle (G95):");
    }
    // After a frame has shifted the axis, an increment would pass the shift.
    if (native.increments[kZ] && !m_isPlaced) {
      return refuse(native, "an increment of Z cannot be raised, write it with G90:");
    }
    const auto isShift = [](const std::string& line) {
      return line.starts_with("TRANS") || line.starts_with("ATRANS");
    };
    if (!std::all_of(native.frame.begin(), native.frame.end(), isShift)) {
      return refuse(native, "the coordinates are turned or scaled here:");
    }
    const std::string height = nc::ncNumber(m_raiseMm);
    const bool isForeign = m_plan.program.dialect != nc::Dialect::Sinumerik;
    if (isForeign) {
      if (m_isFirst) {
        native.text = fmt::format("TRANS Z{}\n{}", height, native.text);
        native.setsFrame = true;
      }
    } else {
      native.frame.push_back(
          fmt::format("{} Z{}", native.frame.empty() ? "TRANS" : "ATRANS", height));
      // It replaces the frame, or may do so.
      if (native.setsFrame) {
        native.text += fmt::format("\nATRANS Z{}", height);
      } else if (native.reason == NativeReason::WorkOffset) {
        for (const std::string& line : native.frame) {
          native.text += '\n' + line;
        }
      }
    }
    m_isFirst = false;
    m_isPlaced = m_isPlaced || native.places[kZ];
    return {};
  }

  Plan m_plan;
  double m_raiseMm;
  bool m_isFirst = true;    ///< no block for the control since the last stretch
  bool m_isPlaced = false;  ///< one of them has placed Z
};

}  // namespace

base::Result<Plan> dryPlan(Plan plan, double raiseMm) {
  if (!(raiseMm > 0.0) || raiseMm > kRaiseMmMax) {
    return base::fail(JobError::NotDry,
                      fmt::format("A dry run is made above the workpiece: choose a height of more "
                                  "than 0 and at most {:g} mm.",
                                  kRaiseMmMax));
  }
  return DryPlanner(std::move(plan), raiseMm).make();
}

}  // namespace rivulet::job
