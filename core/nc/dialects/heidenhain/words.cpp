// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The words of positioning blocks.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "nc/dialects/heidenhain/control.h"

namespace rivulet::nc::heidenhain {

namespace {

/// @return true: it has been taken
Expected<bool> takeValue(Scanner& in, std::optional<double>& target) {
  const Expected<double> value = in.value();
  if (!value) {
    return fail(value.error());
  }
  if (target) {
    return in.fault<bool>(FaultCode::RepeatedWord);
  }
  target = *value;
  return true;
}

}  // namespace

bool Control::MotionWords::has(int function) const {
  return std::any_of(functions.begin(), functions.end(),
                     [function](const MFunction& each) { return each.number == function; });
}

bool Control::MotionWords::moves() const {
  return std::any_of(axes.begin(), axes.end(),
                     [](const std::optional<double>& axis) { return axis.has_value(); });
}

Expected<Control::MotionWords> Control::motionWords(Scanner& in) {
  MotionWords words;
  words.column = in.column();
  bool isFirst = true;
  while (!in.isAtEnd()) {
    if (isFirst) {
      words.column = in.column();
      isFirst = false;
    }
    const Expected<bool> read = wordOf(in, words);
    if (!read) {
      return fail(read.error());
    }
    if (!*read) {
      return in.fault<MotionWords>(FaultCode::UnknownWord, in.nextText());
    }
  }
  // With a distance and alone, M140 is a move; whether the axes of its block move before it or
  // afterwards is not clear.
  constexpr int kRetract = 140;
  if (words.retractBy && (words.moves() || *words.retractBy < 0.0)) {
    words.retractBy.reset();
  } else if (words.retractBy) {
    std::erase_if(words.functions, [](const MFunction& each) { return each.number == kRetract; });
  }
  return words;
}

/// @return false: it is none
Expected<bool> Control::coordinate(Scanner& in, MotionWords& words) {
  const std::size_t from = in.at();
  const bool isIncrement = in.takePrefix("I");
  if (in.takePrefix("PR")) {
    words.radiusIsIncrement = isIncrement;
    return takeValue(in, words.polarRadius);
  }
  if (in.takePrefix("PA")) {
    words.angleIsIncrement = isIncrement;
    return takeValue(in, words.polarAngle);
  }
  for (std::size_t axis = 0; axis < kProgrammedAxisCount; ++axis) {
    if (in.takePrefix(std::string(1, kProgrammedAxes[axis]))) {
      words.isIncrement[axis] = isIncrement;
      return takeValue(in, words.axes[axis]);
    }
  }
  in.goTo(from);
  return false;
}

/// @return false: it is no word of a positioning block
Expected<bool> Control::wordOf(Scanner& in, MotionWords& words) {
  const int column = in.column();
  // R0, and not R0,5.
  const std::size_t before = in.at();
  const bool isOff =
      in.takePrefix("R0") && !base::isDigit(in.peek()) && in.peek() != ',' && in.peek() != '.';
  if (!isOff) {
    in.goTo(before);
  }
  if (isOff || in.takePrefix("RL") || in.takePrefix("RR")) {
    const char which = in.previous();
    words.compensation = which == '0' ? 0 : which == 'L' ? 1 : -1;
    words.compensationColumn = column;
    return true;
  }
  if (in.takePrefix("DR")) {
    const bool clockwise = in.take('-');
    if (!clockwise && !in.take('+')) {
      return in.fault<bool>(FaultCode::ValueMissing);
    }
    words.clockwise = clockwise;
    return true;
  }
  if (in.takePrefix("CCA")) {
    return takeValue(in, words.centreAngle);
  }
  if (in.takePrefix("LEN")) {
    return takeValue(in, words.length);
  }
  static constexpr std::string_view kLinear = "XYZ";
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (in.takePrefix(std::string("N") + kLinear[axis])) {
      return takeValue(in, words.normal[axis]);
    }
    if (in.takePrefix(std::string("T") + kLinear[axis])) {
      return takeValue(in, words.tool[axis]);
    }
  }
  if (const Expected<bool> read = coordinate(in, words); !read || *read) {
    return read;
  }
  if (in.peek() == 'F') {
    const Expected<Feed> feed = feedWord(in);
    if (!feed) {
      return fail(feed.error());
    }
    words.feed = *feed;
    return true;
  }
  if (in.takePrefix("R")) {
    return takeValue(in, words.radius);
  }
  if (in.takePrefix("S")) {
    return takeValue(in, words.spindlePerMin);
  }
  if (in.takePrefix("M")) {
    const Expected<void> done = functionWord(in, words);
    return done ? Expected<bool>(true) : fail(done.error());
  }
  return false;
}

/// M functions, with what some of them have behind them (chapter "Miscellaneous functions").
Expected<void> Control::functionWord(Scanner& in, MotionWords& words) {
  const int column = in.column() - 1;
  const std::optional<int> number = in.takeInteger();
  if (!number) {
    return in.fault<void>(FaultCode::NumberMissing, "M");
  }
  words.functions.push_back({*number, column});
  constexpr int kRetract = 140;
  constexpr int kLookAhead = 120;
  constexpr int kTipOn = 128;
  // They change the feed or the path by what follows them.
  static constexpr std::array kWithWords{103, 118, 124};
  if (*number == kRetract) {
    if (in.takePrefix("MB") && !in.takeWord("MAX")) {
      const Expected<double> distance = in.value();
      if (!distance) {
        return fail(distance.error());
      }
      words.retractBy = *distance;
    }
    if (in.isAtEnd() || in.peek() != 'F') {
      return {};
    }
    const Expected<Feed> feed = feedWord(in);
    if (!feed) {
      return fail(feed.error());
    }
    words.retractFeed = *feed;
  } else if (*number == kTipOn) {
    // M128 F1000: how fast the control may follow the rotary axes, no feed of the path.
    if (!in.isAtEnd() && in.peek() == 'F') {
      const Expected<Feed> feed = feedWord(in);
      if (!feed) {
        return fail(feed.error());
      }
    }
  } else if (*number == kLookAhead) {
    if (in.takePrefix("LA")) {
      (void)in.takeInteger();
    }
  } else if (std::find(kWithWords.begin(), kWithWords.end(), *number) != kWithWords.end()) {
    return in.fault<void>(FaultCode::UnsupportedGCode, fmt::format("M{}", *number));
  }
  return {};
}

/// F500, FQ1, FMAX, FAUTO, FU0.2. Chapter "Tools", "Feed rate F".
Expected<Control::Feed> Control::feedWord(Scanner& in) {
  (void)in.takePrefix("F");
  if (in.takeWord("MAX")) {
    return Feed{FeedKind::Rapid, 0.0};
  }
  if (in.takeWord("AUTO")) {
    return m_tool.feed.kind == FeedKind::None ? in.fault<Feed>(FaultCode::ValueMissing, "FAUTO")
                                              : Expected<Feed>(m_tool.feed);
  }
  const bool isPerRevolution = in.takePrefix("U");
  if (!in.isAtValue()) {
    return in.fault<Feed>(FaultCode::UnsupportedGCode, "F" + in.nextText());
  }
  const Expected<double> value = in.value();
  if (!value) {
    return fail(value.error());
  }
  return Feed{isPerRevolution || m_perRevolution ? FeedKind::PerRevolution : FeedKind::PerMinute,
              *value};
}

/// A word that its block has no use for is refused. @param used  of "radius angle length polar
/// direction"
Expected<void> Control::refuseUnused(const MotionWords& words, std::string_view used) {
  const auto uses = [used](std::string_view what) {
    return used.find(what) != std::string_view::npos;
  };
  const auto refused = [this, &words](std::string_view word) -> Expected<void> {
    return fail(FaultCode::UnknownWord, std::string(word),
                {m_block.place.line, m_block.place.file, words.column});
  };
  if (words.radius && !uses("radius")) {
    return refused("R");
  }
  if (words.centreAngle && !uses("angle")) {
    return refused("CCA");
  }
  if (words.length && !uses("length")) {
    return refused("LEN");
  }
  if ((words.polarRadius || words.polarAngle) && !uses("polar")) {
    return refused("PR");
  }
  if (words.clockwise && !uses("direction")) {
    return refused("DR");
  }
  return {};
}

}  // namespace rivulet::nc::heidenhain
