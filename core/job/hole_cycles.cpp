// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "job/hole_cycles.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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
constexpr int kBackBoring = 870;
constexpr int kBoringManual = 880;
constexpr int kBoringDwell = 890;
constexpr std::array kKnown{kChipBreaking,  kLeftTapping, kFineBoring,   kDrilling,
                            kCounterboring, kPecking,     kTapping,      kBoring,
                            kBoringStop,    kBackBoring,  kBoringManual, kBoringDwell};
/// Of a Haas, whose G87 is as G88.
constexpr int kBackBoringOfHaas = 770;

constexpr int kStrokesMax = 10000;
constexpr double kRepeatsMax = 10000.0;

bool isTapping(int key) {
  return key == kTapping || key == kLeftTapping;
}

bool isPecking(int key) {
  return key == kChipBreaking || key == kPecking;
}

bool liftsOff(int key) {
  return key == kFineBoring || key == kBackBoring;
}

/// One name for what cycles of several makes do.
int commonKey(nc::Dialect dialect, int key) {
  if (dialect == nc::Dialect::Haas) {
    key = key == kBackBoring ? kBoringManual : key == kBackBoringOfHaas ? kBackBoring : key;
  }
  return key == kRigidTapping ? kTapping : key == kRigidLeftTapping ? kLeftTapping : key;
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
  /// On the way to the hole.
  void turn(const base::RotaryDeg& toDeg) {
    base::RotaryDeg& nowDeg = m_executor.start().rotaryDeg;
    std::string line;
    for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
      if (!std::isnan(toDeg[axis]) && toDeg[axis] != nowDeg[axis]) {
        line += fmt::format(" {}{}", base::kRotaryAxisNames[axis], nc::ncNumber(toDeg[axis]));
        nowDeg[axis] = toDeg[axis];
      }
    }
    if (!line.empty()) {
      add("G0" + line);
    }
  }
  /// To where only the control knows the tool to be.
  void rise(const std::vector<std::string>& lines) {
    m_lines.insert(m_lines.end(), lines.begin(), lines.end());
    m_executor.start().programmedMm.set(m_toolAxis, std::numeric_limits<double>::quiet_NaN());
  }
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

bool HoleCycles::begin(nc::Dialect dialect, int key) {
  m_dialect = dialect;
  m_hasSettings = dialect == nc::Dialect::Fanuc || dialect == nc::Dialect::Haas;
  key = commonKey(dialect, key);
  const bool isThread = dialect == nc::Dialect::LinuxCnc && liftsOff(key);  // G76; no G87
  if (std::find(kKnown.begin(), kKnown.end(), key) == kKnown.end() || isThread) {
    end();
    return false;
  }
  if (!m_key) {  // a series of cycles has one height before it, and its own words
    m_isFirst = true;
    m_retract.reset();
    m_depth.reset();
    m_strokeMm.reset();
    m_strokesMm.reset();
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
  if (words.q) {
    m_strokeMm = std::abs(*words.q) * state.lengthFactor;
  }
  if (m_dialect == nc::Dialect::Haas && isPecking(*m_key) && words.centre.has(0)) {
    m_strokesMm.emplace();
    for (std::size_t word = 0; word < base::kAxisCount; ++word) {
      (*m_strokesMm)[word] =
          words.centre.has(word) ? std::abs(words.centre.value[word]) * state.lengthFactor : 0.0;
    }
  }
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

/// A word that the program lacks; empty: none.
std::string HoleCycles::lacks(double feedMmPerS, double spindlePerMin) const {
  const bool needsStroke =
      isPecking(*m_key) && !m_strokesMm && !(m_strokeMm && (m_hasSettings || *m_strokeMm > 0.0));
  return !m_retract                                         ? "R"
         : !m_depth                                         ? "Z"
         : needsStroke                                      ? "Q"
         : !(feedMmPerS > 0.0)                              ? "F"
         : isTapping(*m_key) && !(spindlePerMin > 0.0)      ? "S"
         : liftsOff(*m_key) && !m_orientation               ? "lift"
         : m_dialect == nc::Dialect::LinuxCnc && !m_toStart ? "G98, G99"
                                                            : "";
}

double HoleCycles::setting(gcode::ControlSetting which) {
  const auto given = m_given.find(which);
  if (given != m_given.end()) {
    return given->second;
  }
  return m_taken.emplace(which, gcode::machineDefault(which)).first->second;
}

/// The tool lifts off by I and J, else by Q in the direction of a setting: Fanuc 15i, G76, bit SIJ
/// of parameter 6200; Haas, G76 and G77, setting 27. @return nothing: that is no axis across the
/// tool
std::optional<Vec3> HoleCycles::liftMm(const nc::BlockWords& words, const nc::ModalState& state) {
  const std::array across{state.planeFirstAxis, state.planeSecondAxis()};
  Vec3 aside;
  bool isGiven = false;
  for (const std::size_t axis : across) {
    if (!words.q && words.centre.has(axis)) {
      aside.set(axis, words.centre.value[axis] * state.lengthFactor);
      isGiven = true;
    }
  }
  if (isGiven) {
    return aside;
  }
  const double lift = setting(gcode::ControlSetting::Lift);
  auto axis = static_cast<std::size_t>(std::abs(lift)) - 1;
  if (axis == state.planeThirdAxis()) {
    if (m_given.contains(gcode::ControlSetting::Lift)) {
      return std::nullopt;
    }
    axis = state.planeFirstAxis;
    m_taken[gcode::ControlSetting::Lift] = static_cast<double>(axis + 1);
  }
  const double byMm =
      m_strokeMm.value_or(0.0) > 0.0 ? *m_strokeMm : setting(gcode::ControlSetting::LiftBy);
  aside.set(axis, std::copysign(byMm, lift));
  return aside;
}

/// In place of what the program lacks.
void HoleCycles::takeSettings(const nc::BlockWords& words, const nc::ModalState& state) {
  m_taken.clear();
  if (!m_hasSettings) {
    return;
  }
  if (!m_retract) {
    m_retract = {-setting(gcode::ControlSetting::RetractPlane), true};
  }
  if (isPecking(*m_key) && !m_strokesMm && !(m_strokeMm.value_or(0.0) > 0.0)) {
    m_strokeMm = setting(gcode::ControlSetting::Stroke);
  }
  if (!liftsOff(*m_key)) {
    return;
  }
  if (const std::optional<Vec3> aside = liftMm(words, state)) {
    m_orientation = Orientation{*aside, setting(gcode::ControlSetting::LiftAngle), 0.0};
  }
}

tl::expected<std::vector<std::string>, std::string> HoleCycles::drill(
    const nc::BlockWords& words, std::optional<double> dwellS, nc::Executor& executor,
    const std::vector<std::string>& wayUp) {
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
  takeSettings(words, state);
  Hole hole;
  hole.startMm = m_startMm;
  hole.feedMmPerS = executor.feedMmPerS();
  const bool takesSpeed = m_hasSettings && isTapping(*m_key) && !(state.spindlePerMin > 0.0);
  hole.spindlePerMin = takesSpeed ? setting(gcode::ControlSetting::TapSpeed) : state.spindlePerMin;
  if (std::string lacking = lacks(hole.feedMmPerS, hole.spindlePerMin); !lacking.empty()) {
    return tl::unexpected(std::move(lacking));
  }
  const bool isBehind = m_key == kBackBoring;  // Fanuc, G87: G99 has no meaning there
  const bool needsHeight =
      isBehind || m_retract->isIncrement || (retractsToStart() && wayUp.empty());
  if (needsHeight && std::isnan(m_startMm)) {
    return tl::unexpected(std::string());
  }
  const bool goesWayUp = retractsToStart() && std::isnan(m_startMm);
  hole.retractMm = m_retract->valueMm + (m_retract->isIncrement ? m_startMm : 0.0);
  hole.depthMm = m_depth->valueMm + (m_depth->isIncrement ? hole.retractMm : 0.0);
  hole.afterMm = isBehind            ? m_startMm
                 : retractsToStart() ? std::max(hole.retractMm, m_startMm)
                                     : hole.retractMm;
  const double lengthMm = hole.retractMm - hole.depthMm;  // of back boring either way round
  if (state.diameter || !(isBehind || lengthMm > 0.0) ||
      (isPecking(*m_key) && lengthMm / strokeMm(hole, kStrokesMax) > kStrokesMax)) {
    return tl::unexpected(std::string("Z below R"));  // upwards: a control refuses it as well
  }
  const bool mayRepeat = m_dialect != nc::Dialect::Haas && !liftsOff(*m_key);
  const double repeats = words.l                               ? *words.l
                         : mayRepeat && words.centre.has(axis) ? words.centre.value[axis]
                                                               : 1.0;
  to.turn(executor.rotaryOf(words));
  for (double count = 0.0; count < std::clamp(repeats, 0.0, kRepeatsMax); ++count) {
    if (!isBehind && to.height() < hole.retractMm) {
      to.rapid(hole.retractMm);
    }
    Vec3 place = executor.placeInPlane(words);  // an axis that is not known stays where it is
    place.set(axis, to.height());
    to.rapid(place);
    if (isBehind) {
      writeBackBore(to, hole);
    } else {
      to.rapid(hole.retractMm);
      writeHole(to, hole);
    }
    if (goesWayUp) {
      to.rise(wayUp);
    } else {
      to.rapid(hole.afterMm);
    }
  }
  return to.take();
}

/// @param number  from 0 @return > 0
double HoleCycles::strokeMm(const Hole& hole, int number) const {
  double stroke = m_strokeMm.value_or(0.0);
  if (m_strokesMm) {
    const auto& [first, less, shortest] = *m_strokesMm;
    stroke = std::max(first - less * number, shortest);
  }
  return stroke > 0.0 ? stroke : hole.retractMm - hole.depthMm;
}

void HoleCycles::writePecks(Writer& to, const Hole& hole) {
  const auto given = m_given.find(gcode::ControlSetting::Clearance);
  const double clearanceMm = given != m_given.end()
                                 ? given->second
                                 : gcode::machineDefault(gcode::ControlSetting::Clearance);
  double reachedMm = hole.retractMm;
  for (int number = 0;; ++number) {
    const double stroke = strokeMm(hole, number);
    if (reachedMm - stroke <= hole.depthMm) {
      break;
    }
    reachedMm -= stroke;
    to.feed(reachedMm, hole.feedMmPerS);
    to.dwell(m_key == kChipBreaking ? m_dwellS : 0.0);
    if (m_key == kPecking) {
      to.rapid(hole.retractMm);
    }
    to.rapid(reachedMm + std::min(clearanceMm, stroke));
  }
  to.feed(hole.depthMm, hole.feedMmPerS);
  to.dwell(m_dwellS);
  to.rapid(hole.retractMm);
}

void HoleCycles::writeTap(Writer& to, const Hole& hole) const {
  const double pitchMm = hole.feedMmPerS * 60.0 / hole.spindlePerMin;
  const std::string speed = nc::ncNumber(hole.spindlePerMin);
  const std::string plane = nc::ncNumber(to.workpieceHeight(hole.retractMm));
  const bool isRight = m_key == kTapping;
  std::string strokes;
  if (m_breakBackMm && m_strokeMm.value_or(0.0) > 0.0) {
    strokes = fmt::format(",,,,{},{},{}", *m_breakBackMm > 0.0 ? 1 : 2, nc::ncNumber(*m_strokeMm),
                          nc::ncNumber(*m_breakBackMm));
  }
  to.add(fmt::format("CYCLE84({0},{0},0,{1},,{2},{3},,{4},,{5},{5}{6})", plane,
                     nc::ncNumber(to.workpieceHeight(hole.depthMm)), nc::ncNumber(m_dwellS),
                     isRight ? 3 : 4, nc::ncNumber(isRight ? pitchMm : -pitchMm), speed, strokes));
}

void HoleCycles::writeFineBore(Writer& to, const Hole& hole) const {
  to.feed(hole.depthMm, hole.feedMmPerS);
  to.dwell(m_dwellS);
  to.add("SPOS=" + nc::ncNumber(m_orientation->degrees));
  const Vec3 middle = to.position();
  to.rapid(middle + m_orientation->asideMm);
  if (m_orientation->backMmPerS > 0.0) {
    to.feed(hole.retractMm, m_orientation->backMmPerS);
  } else {
    to.rapid(hole.retractMm);
  }
  Vec3 above = middle;
  above.set(to.toolAxis(), hole.retractMm);
  to.rapid(above);
  to.add(fmt::format("M{}", m_spindle));
}

/// Through the hole beside its middle, to R below it; then up to Z, and back the same way. Fanuc
/// 30i, G87; Haas, G77.
void HoleCycles::writeBackBore(Writer& to, const Hole& hole) const {
  const std::string turn = "SPOS=" + nc::ncNumber(m_orientation->degrees);
  const std::string spindle = fmt::format("M{}", m_spindle);
  const Vec3 asideMm = m_orientation->asideMm;
  to.add(turn);
  to.rapid(to.position() + asideMm);
  to.rapid(hole.retractMm);
  to.rapid(to.position() - asideMm);
  to.add(spindle);
  to.feed(hole.depthMm, hole.feedMmPerS);
  to.dwell(m_dwellS);
  to.add(turn);
  to.rapid(to.position() + asideMm);
  to.rapid(hole.afterMm);
  to.rapid(to.position() - asideMm);
  to.add(spindle);
}

/// From the retraction plane to the depth and back.
void HoleCycles::writeHole(Writer& to, const Hole& hole) {
  const int key = *m_key;
  if (isPecking(key)) {
    writePecks(to, hole);
    return;
  }
  if (isTapping(key)) {
    writeTap(to, hole);
    return;
  }
  if (key == kFineBoring) {
    writeFineBore(to, hole);
    return;
  }
  to.feed(hole.depthMm, hole.feedMmPerS);
  to.dwell(key == kCounterboring || key == kBoringDwell || key == kBoringStop ||
                   key == kBoringManual
               ? m_dwellS
               : 0.0);
  if (key == kBoring || key == kBoringDwell) {
    to.feed(hole.retractMm, hole.feedMmPerS);
  } else if (key == kBoringStop || key == kBoringManual) {
    to.add("M5");
    if (key == kBoringManual) {
      to.add("M0");  // the operator takes the tool out of the bore
    }
    to.rapid(hole.retractMm);
    to.add(fmt::format("M{}", m_spindle));
  } else {
    to.rapid(hole.retractMm);
  }
}

}  // namespace rivulet::job
