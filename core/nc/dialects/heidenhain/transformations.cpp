// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Datum shift, mirror image, rotation and scaling. TNC 640 User's Manual Cycle Programming, chapter
// "Cycles: Coordinate Transformations".

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/text.h"
#include "nc/dialects/heidenhain/control.h"

namespace rivulet::nc::heidenhain {

namespace {

constexpr std::string_view kLinear = "XYZ";

/// The same transformation, but for rounding.
bool areSame(const Frame& a, const Frame& b) {
  constexpr double kSameFrame = 1e-9;
  for (const base::Vec3 probe : {base::Vec3{}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
    if (base::distance(a.toWorkpiece(probe), b.toWorkpiece(probe)) > kSameFrame) {
      return false;
    }
  }
  return true;
}

}  // namespace

Expected<void> Control::cycle(Scanner& in) {
  if (in.takeWord("CALL")) {
    return cycleCall(in);
  }
  return in.takeWord("DEF") ? cycleDefinition(in) : in.fault<void>(FaultCode::UnknownWord, "CYCL");
}

Expected<void> Control::cycleDefinition(Scanner& in) {
  const std::optional<int> number = in.takeInteger();
  if (!number) {
    return in.fault<void>(FaultCode::NumberMissing, "CYCL DEF");
  }
  if (in.take('.')) {
    const std::optional<int> line = in.takeInteger();
    if (!line) {
      return in.fault<void>(FaultCode::NumberMissing, "CYCL DEF");
    }
    return oldCycleLine(in, *number, *line);
  }
  std::set<std::string, std::less<>> named;
  // CYCL DEF 200 DRILLING Q200=2 Q201=-20 ...: the parameters are those that the program may also
  // set by itself.
  while (!in.isAtEnd()) {
    const std::size_t from = in.at();
    const std::string name = in.takeParameter();
    if (name.empty() || !in.take('=')) {
      in.goTo(from + 1);
      continue;
    }
    m_parameters.set(name, std::nan(""));
    named.insert(name);
    if (in.takePrefix("FMAX") || in.takeWord("MAX")) {
      m_parameters.set(name, 99999.999);
      continue;
    }
    if (in.takePrefix("FAUTO") || in.takeWord("AUTO")) {
      if (m_tool.feed.kind != FeedKind::PerMinute) {
        return in.fault<void>(FaultCode::ValueMissing);
      }
      m_parameters.set(name, m_tool.feed.value);
      continue;
    }
    if (!in.isAtValue()) {
      return in.fault<void>(FaultCode::UnsupportedGCode, name + "=" + in.nextText());
    }
    const Expected<double> value = in.value();
    if (!value) {
      return fail(value.error());
    }
    m_parameters.set(name, *value);
  }
  constexpr int kTolerance = 32;
  constexpr int kPreset = 247;
  if (*number == kPreset) {
    return selectPreset();
  }
  if (*number != kTolerance && !isPattern(*number) && !waitsForCall(*number)) {
    refuse(FaultCode::CycleNotRun, fmt::format("CYCL DEF {}", *number));
    return {};
  }
  ignore(fmt::format("CYCL DEF {}", *number));
  if (*number == kTolerance) {
    return {};
  }
  if (isPattern(*number)) {
    return runPattern(*number);
  }
  m_cycles.defined = {};
  m_cycles.defined.number = *number;
  m_cycles.defined.named = std::move(named);
  m_cycles.callsAlways = false;
  return {};
}

/// 247 PRESETTING: the preset that the program begins with is taken as the one that is active at
/// the control; where another one lies is not known.
Expected<void> Control::selectPreset() {
  const Expected<double> preset = m_parameters.number("Q339");
  if (!preset) {
    return fail(preset.error());
  }
  if (m_hasMoved && (!m_preset || *m_preset != *preset)) {
    refuse(FaultCode::UnsupportedGCode, "CYCL DEF 247");
    return {};
  }
  m_preset = *preset;
  ignore("CYCL DEF 247");
  return {};
}

/// FUNCTION MODE MILL and FUNCTION RESET TCPM are how a program begins anyway.
Expected<void> Control::function(Scanner& in) {
  if (in.takeWord("DWELL") && in.takePrefix("TIME")) {
    const Expected<double> seconds = in.value();
    if (!seconds) {
      return fail(seconds.error());
    }
    tell({word('G', 4.0), word('F', *seconds)});
    return {};
  }
  const bool isMill = in.takeWord("MODE") && in.takeWord("MILL");
  const bool isReset = !isMill && in.takeWord("RESET") && in.takeWord("TCPM");
  if ((isMill || isReset) && in.isAtEnd()) {
    ignore("FUNCTION");
    return {};
  }
  refuse(FaultCode::UnsupportedGCode, "FUNCTION " + in.nextText());
  in.skipRest();
  return {};
}

/// Cycles of old controls, line by line.
Expected<void> Control::oldCycleLine(Scanner& in, int number, int line) {
  using Read = Expected<void> (Control::*)(Scanner&);
  struct Row {
    int number;
    Read read;
  };
  static constexpr std::array kRows{Row{8, &Control::mirror}, Row{9, &Control::oldDwell},
                                    Row{10, &Control::rotation}, Row{11, &Control::scale},
                                    Row{19, &Control::swivel}};
  const auto* const row = std::find_if(kRows.begin(), kRows.end(),
                                       [number](const Row& each) { return each.number == number; });
  if (row == kRows.end() && number != 7) {
    return oldCallLine(in, number, line);
  }
  if (line == 0) {  // its name
    in.skipRest();
    return {};
  }
  return number == 7 ? datumShift(in, line) : (this->*row->read)(in);
}

Expected<void> Control::oldDwell(Scanner& in) {
  // The last word: "DWELL 0,5".
  const std::string_view rest = base::trim(in.rest());
  const std::size_t blank = rest.find_last_of(' ');
  in.goTo(in.at() + in.rest().find(rest) + (blank == std::string_view::npos ? 0 : blank + 1));
  while (!in.isAtEnd() && !in.isAtValue()) {
    in.goTo(in.at() + 1);
  }
  const Expected<double> seconds = in.value();
  if (!seconds) {
    return fail(seconds.error());
  }
  tell({word('G', 4.0), word('F', *seconds)});
  return {};
}

/// What changes no coordinates.
Expected<void> Control::oldCallLine(Scanner& in, int number, int line) {
  constexpr int kSpindleAngle = 13;
  constexpr int kScalePerAxis = 26;
  constexpr int kTolerance = 32;
  const std::string name = fmt::format("CYCL DEF {}", number);
  if (number == kSpindleAngle || number == kTolerance) {
    in.skipRest();
    ignore(name);
    return {};
  }
  if (number == kScalePerAxis) {
    in.skipRest();
    refuse(FaultCode::UnsupportedGCode, name);
    return {};
  }
  if (!waitsForCall(number)) {
    in.skipRest();
    if (line == 0) {
      refuse(FaultCode::CycleNotRun, name);
    }
    return {};
  }
  if (line == 0) {
    in.skipRest();
    ignore(name);
    m_cycles.defined = {};
    m_cycles.defined.number = number;
    m_cycles.callsAlways = false;
    return {};
  }
  if (m_cycles.defined.number != number) {
    return in.fault<void>(FaultCode::NoBeginning, fmt::format("{}.{}", name, line));
  }
  if (!isKnownCycle(number)) {
    in.skipRest();  // refused where it is called
    return {};
  }
  return oldCycleWords(in, line);
}

/// "SET UP 2", "PECKG 5 F100", "F200 DR- RADIUS 16", "X+145".
Expected<void> Control::oldCycleWords(Scanner& in, int line) {
  bool hasValue = false;
  while (!in.isAtEnd()) {
    const std::size_t at = in.at();
    if (in.takePrefix("DR") && (in.peek() == '+' || in.peek() == '-')) {
      m_cycles.defined.turns[line] = in.take('-') ? -1.0 : 1.0;
      in.take('+');
      continue;
    }
    in.goTo(at);
    const bool isFeed = in.takePrefix("F") && in.isAtValue();
    if (!isFeed) {
      in.goTo(at);
      const bool isAbbreviated = !in.takeName().empty() && in.take('.');  // V.ZEIT
      if (isAbbreviated || !in.isAtValue()) {
        in.goTo(std::max(in.at(), at + 1));
        continue;
      }
    }
    const Expected<double> value = in.value();
    if (!value) {
      return fail(value.error());
    }
    if (isFeed) {
      m_cycles.defined.feeds[line] = *value;
    }
    if (!isFeed || !hasValue) {
      m_cycles.defined.values[line] = *value;
    }
    hasValue = hasValue || !isFeed;
  }
  return {};
}

// --- transformations ----------------------------------------------------------------------------

Expected<void> Control::datumShift(Scanner& in, int /*line*/) {
  if (in.take('#') || in.take('*')) {
    // A line of the datum table of the control.
    in.skipRest();
    refuse(FaultCode::UnsupportedGCode, "CYCL DEF 7");
    return {};
  }
  base::Vec3 datum = m_coordinates.datum;
  while (!in.isAtEnd()) {
    const bool isIncrement = in.takePrefix("I");
    const std::size_t axis = kLinear.find(in.peek());
    if (axis == std::string_view::npos) {
      return in.fault<void>(FaultCode::UnsupportedGCode, "CYCL DEF 7 " + in.nextText());
    }
    in.goTo(in.at() + 1);
    const Expected<double> value = in.value();
    if (!value) {
      return fail(value.error());
    }
    datum.set(axis, *value + (isIncrement ? m_coordinates.datum[axis] : 0.0));
  }
  m_coordinates.datum = datum;
  return activate(Shift::Datum, "CYCL DEF 7");
}

/// TRANS DATUM AXIS X+10, TRANS DATUM RESET.
Expected<void> Control::translate(Scanner& in) {
  if (in.takeWord("DATUM") && in.takeWord("RESET")) {
    m_coordinates.datum = {};
    return activate(Shift::Datum, "TRANS DATUM");
  }
  if (in.takeWord("AXIS")) {
    return datumShift(in, 1);
  }
  refuse(FaultCode::UnsupportedGCode, "TRANS " + in.nextText());
  in.skipRest();
  return {};
}

/// The axes named are mirrored, and no others; none takes it back.
Expected<void> Control::mirror(Scanner& in) {
  m_coordinates.isMirrored.fill(false);
  while (!in.isAtEnd()) {
    const std::size_t axis = kLinear.find(in.peek());
    if (axis == std::string_view::npos) {
      return in.fault<void>(FaultCode::UnsupportedGCode, "CYCL DEF 8 " + in.nextText());
    }
    m_coordinates.isMirrored[axis] = true;
    in.goTo(in.at() + 1);
  }
  return activate(Shift::Mirror, "CYCL DEF 8");
}

Expected<void> Control::rotation(Scanner& in) {
  const bool isIncrement = in.takePrefix("I");
  if (!in.takePrefix("ROT")) {
    return in.fault<void>(FaultCode::UnsupportedGCode, "CYCL DEF 10 " + in.nextText());
  }
  const Expected<double> angle = in.value();
  if (!angle) {
    return fail(angle.error());
  }
  m_coordinates.turn = std::fmod(*angle + (isIncrement ? m_coordinates.turn : 0.0), 360.0);
  m_coordinates.turnAxis = thirdAxis();
  return activate(Shift::Rotation, "CYCL DEF 10");
}

/// All three axes, as a TNC 640 does it; on an iTNC 530 a machine parameter (MP7410) may leave the
/// tool axis alone.
Expected<void> Control::scale(Scanner& in) {
  if (!in.takePrefix("SCL")) {
    return in.fault<void>(FaultCode::UnsupportedGCode, "CYCL DEF 11 " + in.nextText());
  }
  const Expected<double> factor = in.value();
  if (!factor) {
    return fail(factor.error());
  }
  if (!(*factor > 0.0)) {
    return in.fault<void>(FaultCode::OutOfDomain, "SCL");
  }
  m_coordinates.scale = *factor;
  return activate(Shift::Scale, "CYCL DEF 11");
}

/// 19 WORKING PLANE: the control tilts its coordinates.
Expected<void> Control::swivel(Scanner& in) {
  bool isTilted = false;
  while (!in.isAtEnd()) {
    if (in.isAtValue()) {
      const Expected<double> angle = in.value();
      if (!angle) {
        return fail(angle.error());
      }
      isTilted = isTilted || *angle != 0.0;
    } else {
      in.goTo(in.at() + 1);
    }
  }
  if (isTilted || m_coordinates.isSwivelled) {
    m_coordinates.isSwivelled = true;
    tellPlaneAngles(false);
    refuse(FaultCode::UnsupportedGCode, "CYCL DEF 19");
  } else {
    tellPlaneAngles(true);
    ignore("CYCL DEF 19");
  }
  return {};
}

namespace {

/// A word of PLANE with its value: the plane is that of the machine with it.
bool isLevel(std::string_view kind, std::string_view word, double value) {
  if (kind == "VECTOR") {
    // The first axis of the plane, and the direction across it.
    const bool isAxis = word == "BX" || word == "NZ";
    const bool isOther = word == "BY" || word == "BZ" || word == "NX" || word == "NY";
    return isAxis ? value > 0.0 : !isOther || value == 0.0;
  }
  static constexpr std::array<std::string_view, 12> kAngles{
      "SPA", "SPB", "SPC", "A", "B", "C", "PROPR", "PROMIN", "ROT", "EULPR", "EULNU", "EULROT"};
  return value == 0.0 || std::find(kAngles.begin(), kAngles.end(), word) == kAngles.end();
}

bool isPlaneByAngles(std::string_view kind) {
  static constexpr std::array<std::string_view, 6> kKinds{"SPATIAL", "AXIAL",   "PROJECTED",
                                                          "EULER",   "RELATIV", "VECTOR"};
  return std::find(kKinds.begin(), kKinds.end(), kind) != kKinds.end();
}

}  // namespace

/// PLANE SPATIAL SPA+0 SPB+0 SPC+0 TURN MB MAX FMAX, PLANE RESET STAY. Chapter "The PLANE function:
/// tilting the working plane". Only a plane that is not tilted is followed: nothing turns, if the
/// rotary axes stand at zero.
Expected<void> Control::plane(Scanner& in) {
  const std::string kind = in.takeName();
  const bool isReset = kind == "RESET";
  bool isTilted = !isReset && !isPlaneByAngles(kind);
  bool stays = false;
  bool retracts = false;
  while (!isTilted && !in.isAtEnd()) {
    const std::string word = in.takeName();
    stays = stays || word == "STAY";
    retracts = retracts || word == "MB";
    if (word == "SEQ" || word == "SYM") {
      (void)(in.take('+') || in.take('-'));
      continue;
    }
    if (in.isAtValue()) {
      const Expected<double> value = in.value();
      if (!value) {
        return fail(value.error());
      }
      isTilted = !isReset && !isLevel(kind, word, *value);
    } else if (word.empty()) {
      return in.fault<void>(FaultCode::UnknownWord, in.nextText());
    }
  }
  in.skipRest();
  const bool turns = !stays && !rotaryAxesStandAtZero();
  if (isTilted || m_coordinates.isSwivelled || turns) {
    m_coordinates.isSwivelled = !isReset;
    tellPlaneAngles(false);
    refuse(FaultCode::UnsupportedGCode, "PLANE " + kind);
    return {};
  }
  tellPlaneAngles(true);
  if (!stays && retracts) {
    constexpr double kRetract = 140.0;
    tell({word('M', kRetract)});
    m_at.set(thirdAxis(), std::nan(""));
    m_direction.reset();
  } else {
    ignore("PLANE " + kind);
  }
  return {};
}

/// They are taken to stand there until the program names them.
bool Control::rotaryAxesStandAtZero() const {
  return std::none_of(m_rotary.begin() + kFirstRotary, m_rotary.begin() + kFirstFurther,
                      [](double degrees) { return std::abs(degrees) > 0.0; });
}

/// Q120 to Q122 are the angles of the rotary axes that a tilted plane needs.
void Control::tellPlaneAngles(bool isKnown) {
  for (const int angle : {120, 121, 122}) {
    m_parameters.setOfControl(angle, isKnown ? std::optional(0.0) : std::nullopt);
  }
}

bool Control::isActive(Shift shift) const {
  switch (shift) {
    case Shift::Datum:
      return !(m_coordinates.datum == base::Vec3{});
    case Shift::Mirror:
      return m_coordinates.isMirrored[0] || m_coordinates.isMirrored[1] ||
             m_coordinates.isMirrored[2];
    case Shift::Rotation:
      return m_coordinates.turn != 0.0;
    case Shift::Scale:
      return m_coordinates.scale != 1.0;
  }
  return false;
}

Frame Control::frameOf(const std::vector<Shift>& order) const {
  Frame frame;
  for (const Shift shift : order) {
    switch (shift) {
      case Shift::Datum:
        frame.translate(m_coordinates.datum);
        break;
      case Shift::Mirror:
        frame.scale({m_coordinates.isMirrored[0] ? -1.0 : 1.0,
                     m_coordinates.isMirrored[1] ? -1.0 : 1.0,
                     m_coordinates.isMirrored[2] ? -1.0 : 1.0});
        break;
      case Shift::Rotation:
        frame.rotate(m_coordinates.turnAxis, m_coordinates.turn);
        break;
      case Shift::Scale:
        frame.scale({m_coordinates.scale, m_coordinates.scale, m_coordinates.scale});
        break;
    }
  }
  return frame;
}

/// The manual does not say what a transformation means that is set or changed behind one of another
/// kind: it is taken only if it makes no difference whether it keeps its place in the order, comes
/// last, or the order is always datum, mirror image, rotation, scale.
Expected<void> Control::activate(Shift shift, std::string_view name) {
  const auto place = std::find(m_coordinates.order.begin(), m_coordinates.order.end(), shift);
  std::vector<Shift> kept = m_coordinates.order;
  std::vector<Shift> last = m_coordinates.order;
  std::erase(last, shift);
  if (isActive(shift)) {
    last.push_back(shift);
    if (place == m_coordinates.order.end()) {
      kept.push_back(shift);
    }
  } else {
    kept = last;
  }
  std::vector<Shift> fixed = kept;
  std::sort(fixed.begin(), fixed.end());
  const Frame frame = frameOf(kept);
  if (!areSame(frame, frameOf(last)) || !areSame(frame, frameOf(fixed))) {
    return fail(FaultCode::UnsupportedGCode, std::string(name), m_block.place);
  }
  m_coordinates.order = std::move(kept);
  m_coordinates.frame = m_coordinates.order.empty() ? Frame() : frame;
  m_pole.place.reset();
  return {};
}

}  // namespace rivulet::nc::heidenhain
