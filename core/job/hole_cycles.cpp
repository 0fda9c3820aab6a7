// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "job/hole_cycles.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text.h"
#include "job/motion_text.h"
#include "nc/nc_number.h"

namespace rivulet::job {

namespace {

using base::Vec3;

// Keys of the G functions.
constexpr int kChipBreaking = 730;
constexpr int kLeftTapping = 740;
constexpr int kFineBoring = 760;
constexpr int kDrilling = 810;
constexpr int kCounterboring = 820;
constexpr int kPecking = 830;
constexpr int kTapping = 840;
/// The same without a chuck that gives way, of some controls: so is each of them here.
constexpr int kRigidTapping = 842;
constexpr int kRigidLeftTapping = 843;
constexpr int kBoring = 850;
constexpr int kBoringStop = 860;
constexpr int kBoringManual = 880;
constexpr int kBoringDwell = 890;
constexpr std::array kKnown{kChipBreaking,  kLeftTapping,  kFineBoring, kDrilling,
                            kCounterboring, kPecking,      kTapping,    kBoring,
                            kBoringStop,    kBoringManual, kBoringDwell};

/// How far G73 draws back, and above which depth the feed of G83 begins again: a setting of the
/// control. That of LinuxCNC is 0.254 mm.
constexpr double kClearanceMm = 0.25;
constexpr int kStrokesMax = 10000;
constexpr double kRepeatsMax = 10000.0;

bool isTapping(int key) {
  return key == kTapping || key == kLeftTapping;
}

}  // namespace

/// Collects lines, and keeps the executor's position with them.
class HoleCycles::Writer {
 public:
  Writer(nc::Executor& executor, std::size_t toolAxis)
      : m_executor(executor), m_toolAxis(toolAxis) {}

  void rapid(Vec3 toMm) { go(toMm, std::nullopt); }
  void rapid(double heightMm) { go(at(heightMm), std::nullopt); }
  void feed(double heightMm, double mmPerS) { go(at(heightMm), mmPerS); }
  void dwell(double seconds) {
    if (seconds > 0.0) {
      add("G4 F" + nc::ncNumber(seconds));
    }
  }
  void add(std::string line) { m_lines.push_back(std::move(line)); }

  [[nodiscard]] std::size_t toolAxis() const { return m_toolAxis; }
  [[nodiscard]] Vec3 position() const { return m_executor.start().programmedMm; }
  [[nodiscard]] double height() const { return position()[m_toolAxis]; }
  /// In the workpiece frame.
  [[nodiscard]] double workpieceHeight(double heightMm) const {
    return m_executor.start().frame.toWorkpiece(at(heightMm))[m_toolAxis];
  }
  [[nodiscard]] std::vector<std::string> take() { return std::move(m_lines); }

 private:
  [[nodiscard]] Vec3 at(double heightMm) const {
    Vec3 place = position();
    place.set(m_toolAxis, heightMm);
    return place;
  }
  void go(Vec3 toMm, std::optional<double> mmPerS) {
    nc::Position& position = m_executor.start();
    std::string line = lineText(position.frame.toWorkpiece(position.programmedMm),
                                position.frame.toWorkpiece(toMm), mmPerS);
    if (!line.empty()) {
      add(std::move(line));
    }
    position.programmedMm = toMm;
    position.direction = {};
  }

  nc::Executor& m_executor;
  std::size_t m_toolAxis;
  std::vector<std::string> m_lines;
};

bool HoleCycles::begin(int key) {
  key = key == kRigidTapping ? kTapping : key == kRigidLeftTapping ? kLeftTapping : key;
  if (std::find(kKnown.begin(), kKnown.end(), key) == kKnown.end()) {
    end();
    return false;
  }
  if (!m_key) {  // a series of cycles has one height before it, and its own words
    m_isFirst = true;
    m_retract.reset();
    m_depth.reset();
    m_strokeMm = 0.0;
    m_dwellS = 0.0;
  }
  m_key = key;
  return true;
}

void HoleCycles::takeWords(const nc::BlockWords& words, std::optional<double> dwellS,
                           const nc::ModalState& state) {
  const std::size_t axis = state.planeThirdAxis();
  if (words.hasRadius) {
    m_retract = {words.radius * state.lengthFactor, state.relative};
  }
  if (words.axes.has(axis)) {
    m_depth = {words.axes.value[axis] * state.lengthFactor, words.axes.isIncrement(axis)};
  }
  m_strokeMm = words.q ? std::abs(*words.q) * state.lengthFactor : m_strokeMm;
  m_dwellS = dwellS.value_or(m_dwellS);
  // Of the cycles of plain text.
  const auto named = [&words](std::string_view name) {
    const nc::NamedWord* const word = words.named(name);
    return word == nullptr ? std::nullopt : std::optional(word->value);
  };
  m_breakBackMm = named("VRT");
  m_orientation.reset();
  if (const auto degrees = named("POSS")) {
    m_orientation =
        Orientation{{}, *degrees, named("RFF").value_or(0.0) * state.lengthFactor / 60.0};
    m_orientation->asideMm.set(state.planeFirstAxis,
                               named("RPA").value_or(0.0) * state.lengthFactor);
    m_orientation->asideMm.set(state.planeSecondAxis(),
                               named("RPO").value_or(0.0) * state.lengthFactor);
  }
  if (m_breakBackMm) {
    *m_breakBackMm *= state.lengthFactor;
  }
}

/// The word that the program leaves to a setting of the control; empty: none.
std::string HoleCycles::lacks(double feedMmPerS, double spindlePerMin) const {
  const bool needsStroke = m_key == kChipBreaking || m_key == kPecking;
  return !m_retract                                    ? "R"
         : !m_depth                                    ? "Z"
         : needsStroke && !(m_strokeMm > 0.0)          ? "Q"
         : !(feedMmPerS > 0.0)                         ? "F"
         : isTapping(*m_key) && !(spindlePerMin > 0.0) ? "S"
         : m_key == kFineBoring && !m_orientation      ? "Q"  // on which side, a setting says
                                                       : "";
}

tl::expected<std::vector<std::string>, std::string> HoleCycles::drill(const nc::BlockWords& words,
                                                                      std::optional<double> dwellS,
                                                                      nc::Executor& executor) {
  const nc::ModalState& state = executor.state();
  const std::size_t axis = state.planeThirdAxis();
  Writer to(executor, axis);
  if (m_isFirst) {
    m_startMm = to.height();
    m_isFirst = false;
  }
  takeWords(words, dwellS, state);
  const bool namesPlace =
      words.movesLinear() || words.named("AP") != nullptr || words.named("RP") != nullptr;
  if (!namesPlace) {
    return std::vector<std::string>();
  }
  if (std::string lacking = lacks(executor.feedMmPerS(), state.spindlePerMin); !lacking.empty()) {
    return tl::unexpected(std::move(lacking));
  }
  if (needsStart() && std::isnan(m_startMm)) {
    return tl::unexpected(std::string());
  }
  const double retractMm = m_retract->valueMm + (m_retract->isIncrement ? m_startMm : 0.0);
  const double depthMm = m_depth->valueMm + (m_depth->isIncrement ? retractMm : 0.0);
  const double afterMm = m_toStart ? std::max(retractMm, m_startMm) : retractMm;
  if (state.diameter || !(depthMm < retractMm) ||
      (m_strokeMm > 0.0 && (retractMm - depthMm) / m_strokeMm > kStrokesMax)) {
    return tl::unexpected(std::string("Z below R"));  // upwards: a control refuses it as well
  }
  const double repeats = words.l                  ? *words.l
                         : words.centre.has(axis) ? words.centre.value[axis]
                                                  : 1.0;
  for (double hole = 0.0; hole < std::clamp(repeats, 0.0, kRepeatsMax); ++hole) {
    if (to.height() < retractMm) {
      to.rapid(retractMm);
    }
    Vec3 place = executor.placeInPlane(words);  // an axis that is not known stays where it is
    place.set(axis, to.height());
    to.rapid(place);
    to.rapid(retractMm);
    writeHole(to, retractMm, depthMm, executor.feedMmPerS(), state.spindlePerMin);
    to.rapid(afterMm);
  }
  return to.take();
}

/// From the retraction plane to the depth and back.
void HoleCycles::writeHole(Writer& to, double retractMm, double depthMm, double feedMmPerS,
                           double spindlePerMin) const {
  const int key = *m_key;
  if (key == kChipBreaking || key == kPecking) {
    double reachedMm = retractMm;
    while (reachedMm - m_strokeMm > depthMm) {
      reachedMm -= m_strokeMm;
      to.feed(reachedMm, feedMmPerS);
      to.dwell(key == kChipBreaking ? m_dwellS : 0.0);
      const double backMm = reachedMm + std::min(kClearanceMm, m_strokeMm);
      if (key == kPecking) {
        to.rapid(retractMm);
      }
      to.rapid(backMm);
    }
    to.feed(depthMm, feedMmPerS);
    to.dwell(m_dwellS);
    to.rapid(retractMm);
    return;
  }
  if (isTapping(key)) {
    const double pitchMm = feedMmPerS * 60.0 / spindlePerMin;
    const std::string speed = nc::ncNumber(spindlePerMin);
    const std::string plane = nc::ncNumber(to.workpieceHeight(retractMm));
    std::string strokes;
    if (m_breakBackMm && m_strokeMm > 0.0) {
      strokes = fmt::format(",,,,{},{},{}", *m_breakBackMm > 0.0 ? 1 : 2, nc::ncNumber(m_strokeMm),
                            nc::ncNumber(*m_breakBackMm));
    }
    to.add(fmt::format("CYCLE84({0},{0},0,{1},,{2},{3},,{4},,{5},{5}{6})", plane,
                       nc::ncNumber(to.workpieceHeight(depthMm)), nc::ncNumber(m_dwellS),
                       key == kTapping ? 3 : 4, nc::ncNumber(key == kTapping ? pitchMm : -pitchMm),
                       speed, strokes));
    return;
  }
  if (key == kFineBoring) {
    to.feed(depthMm, feedMmPerS);
    to.dwell(m_dwellS);
    to.add("SPOS=" + nc::ncNumber(m_orientation->degrees));
    const Vec3 middle = to.position();
    to.rapid(middle + m_orientation->asideMm);
    if (m_orientation->backMmPerS > 0.0) {
      to.feed(retractMm, m_orientation->backMmPerS);
    } else {
      to.rapid(retractMm);
    }
    Vec3 above = middle;
    above.set(to.toolAxis(), retractMm);
    to.rapid(above);
    to.add(fmt::format("M{}", m_spindle));
    return;
  }
  to.feed(depthMm, feedMmPerS);
  to.dwell(key == kCounterboring || key == kBoringDwell || key == kBoringStop ||
                   key == kBoringManual
               ? m_dwellS
               : 0.0);
  if (key == kBoring || key == kBoringDwell) {
    to.feed(retractMm, feedMmPerS);
  } else if (key == kBoringStop || key == kBoringManual) {
    to.add("M5");
    if (key == kBoringManual) {
      to.add("M0");  // the operator takes the tool out of the bore
    }
    to.rapid(retractMm);
    to.add(fmt::format("M{}", m_spindle));
  } else {
    to.rapid(retractMm);
  }
}

}  // namespace rivulet::job
