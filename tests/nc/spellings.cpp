// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "spellings.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/random.h"
#include "base/text.h"

namespace rivulet::tests {

using base::Vec3;

namespace {

constexpr double kDegree = 3.14159265358979323846 / 180.0;
constexpr double kInch = 25.4;

Vec3 unit(int axis) {
  Vec3 made;
  made.set(static_cast<std::size_t>(axis), 1.0);
  return made;
}

/// First and second axis of the plane across `axis`.
int firstOf(int axis) {
  return (axis + 1) % 3;
}
int secondOf(int axis) {
  return (axis + 2) % 3;
}
std::size_t at(int axis) {
  return static_cast<std::size_t>(axis);
}

Vec3 turned(Vec3 point, Vec3 centre, int axis, double degrees) {
  const double c = std::cos(degrees * kDegree);
  const double s = std::sin(degrees * kDegree);
  const double u = point[at(firstOf(axis))] - centre[at(firstOf(axis))];
  const double v = point[at(secondOf(axis))] - centre[at(secondOf(axis))];
  point.set(at(firstOf(axis)), centre[at(firstOf(axis))] + u * c - v * s);
  point.set(at(secondOf(axis)), centre[at(secondOf(axis))] + u * s + v * c);
  return point;
}

/// Programmed coordinates to those of the path: columns are the images of the axes.
struct Frame {
  std::array<Vec3, 3> axes{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  Vec3 origin;

  [[nodiscard]] Vec3 turn(Vec3 v) const { return v.x * axes[0] + v.y * axes[1] + v.z * axes[2]; }
  [[nodiscard]] Vec3 operator()(Vec3 p) const { return turn(p) + origin; }
  /// The axes stay perpendicular to each other.
  [[nodiscard]] Vec3 back(Vec3 v) const {
    return {base::dot(v, axes[0]) / base::dot(axes[0], axes[0]),
            base::dot(v, axes[1]) / base::dot(axes[1], axes[1]),
            base::dot(v, axes[2]) / base::dot(axes[2], axes[2])};
  }
  [[nodiscard]] Vec3 programmed(Vec3 p) const { return back(p - origin); }
  /// An operation in the coordinates that this frame makes.
  [[nodiscard]] Frame then(const Frame& next) const {
    Frame made;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      made.axes[axis] = turn(next.axes[axis]);
    }
    made.origin = (*this)(next.origin);
    return made;
  }
  /// All axes have one scale.
  [[nodiscard]] bool isEven() const {
    const double size = base::norm(axes[0]);
    return std::abs(base::norm(axes[1]) - size) < 1e-12 * size &&
           std::abs(base::norm(axes[2]) - size) < 1e-12 * size;
  }
  /// A circle across this axis of the path is one across an axis of the program: which, or -1. All
  /// axes are to have one scale: otherwise the reader makes chords.
  [[nodiscard]] int planeOf(int axis) const {
    for (int own = 0; own < 3; ++own) {
      const Vec3 image = axes[at(own)];
      const bool isAcross = base::norm(base::cross(image, unit(axis))) < 1e-12 * base::norm(image);
      if (isAcross && isEven()) {
        return own;
      }
    }
    return -1;
  }
};

struct PlacedMove {
  PathMove move;
  int plane = 2;
  double signedSweep = 0.0;
  Vec3 start;
};

std::vector<PlacedMove> place(const DrawnMove& drawn, Vec3 from, Vec3 direction) {
  std::vector<PlacedMove> placed;
  PlacedMove made;
  made.start = from;
  made.move.feed = drawn.kind == DrawnMove::Kind::Rapid ? 0.0 : drawn.feed;
  switch (drawn.kind) {
    case DrawnMove::Kind::Rapid:
    case DrawnMove::Kind::Line:
      made.move.kind =
          drawn.kind == DrawnMove::Kind::Rapid ? PathMove::Kind::Rapid : PathMove::Kind::Line;
      made.move.end = from;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        made.move.end.set(axis, drawn.given[axis] ? drawn.value[axis] : from[axis]);
      }
      if (base::distance(from, made.move.end) > 0.01) {
        placed.push_back(made);
      }
      break;
    case DrawnMove::Kind::Steps:
      for (int step = 0; step < drawn.count; ++step) {
        made.move.end = made.start + drawn.value;
        placed.push_back(made);
        made.start = made.move.end;
      }
      break;
    case DrawnMove::Kind::Arc: {
      made.move.kind = PathMove::Kind::Arc;
      made.plane = drawn.plane;
      made.signedSweep = drawn.sweepDeg;
      double first = drawn.centre[0];
      double second = drawn.centre[1];
      const double u = direction[at(firstOf(drawn.plane))];
      const double v = direction[at(secondOf(drawn.plane))];
      const double along = std::hypot(u, v);
      if (drawn.tangent && along > 0.999999) {
        // To the left of the direction for a counterclockwise turn.
        const double radius = std::copysign(std::hypot(first, second), drawn.sweepDeg);
        first = -v / along * radius;
        second = u / along * radius;
      }
      made.move.centre = from;
      made.move.centre.set(at(firstOf(drawn.plane)), from[at(firstOf(drawn.plane))] + first);
      made.move.centre.set(at(secondOf(drawn.plane)), from[at(secondOf(drawn.plane))] + second);
      made.move.axis = std::copysign(1.0, drawn.sweepDeg) * unit(drawn.plane);
      made.move.sweepDeg = std::abs(drawn.sweepDeg);
      made.move.end = made.move.sweepDeg == 360.0
                          ? from
                          : turned(from, made.move.centre, drawn.plane, drawn.sweepDeg);
      made.move.end.set(at(drawn.plane), from[at(drawn.plane)] + drawn.rise);
      placed.push_back(made);
      break;
    }
  }
  return placed;
}

/// Where the tool goes at the end of a move, if the move is one with a feed.
Vec3 directionAfter(const PlacedMove& placed) {
  const Vec3 along = placed.move.kind == PathMove::Kind::Arc
                         ? base::cross(placed.move.axis, placed.move.end - placed.move.centre)
                         : placed.move.end - placed.start;
  const bool isHelix = placed.move.kind == PathMove::Kind::Arc &&
                       placed.start[at(placed.plane)] != placed.move.end[at(placed.plane)];
  // That of a short line is not written with enough digits.
  const bool isKnown = placed.move.kind != PathMove::Kind::Rapid && !isHelix;
  return isKnown && base::norm(along) > 0.9 ? 1.0 / base::norm(along) * along : Vec3{};
}

std::string upperName(std::string_view name) {
  std::string made(name);
  for (char& c : made) {
    c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  }
  return made;
}

constexpr std::array<std::string_view, static_cast<std::size_t>(Feature::Count)> kFeatureNames{
    "increments", "per-value",   "inch",          "arc-radius",    "absolute-centre",
    "arc-angle",  "arc-through", "tangent",       "polar",         "plane-words",
    "shift",      "turn",        "scale",         "mirror",        "set-position",
    "loop",       "call",        "arguments",     "saved-state",   "variables",
    "deferred",   "repeated",    "block-numbers", "blanks",        "inner-blanks",
    "comments",   "exponent",    "number-forms",  "header",        "line-ends",
    "lower-case", "order",       "inverse-time",  "per-revolution"};

constexpr std::array<char, 3> kAxes{'X', 'Y', 'Z'};
constexpr std::array<char, 3> kCentres{'I', 'J', 'K'};
constexpr std::array<const char*, 3> kPlaneWords{"G19", "G18", "G17"};

std::string plain(double value, int decimals = 12) {
  return base::formatFixed(value, decimals);
}

}  // namespace

std::string_view controlName(Control control) {
  static constexpr std::array<std::string_view, kControls.size()> kNames{
      "sinumerik", "fanuc", "haas", "linuxcnc", "grbl", "heidenhain"};
  return kNames[static_cast<std::size_t>(control)];
}

std::string_view featureName(Feature feature) {
  return kFeatureNames[static_cast<std::size_t>(feature)];
}

std::vector<DrawnMove> drawMoves(std::uint64_t seed) {
  base::Random random(seed);
  const auto rounded = [&random](double span) {
    return std::round((random.uniform() * 2.0 - 1.0) * span * 1000.0) / 1000.0;
  };
  const bool inOnePlane = random.below(5) < 3;
  const std::size_t count = 2 + random.below(9);
  double feed = 100.0 * static_cast<double>(1 + random.below(30));
  std::vector<DrawnMove> moves;
  for (std::size_t i = 0; i < count; ++i) {
    DrawnMove move;
    move.id = i + 1;
    if (random.below(3) == 0) {
      feed = static_cast<double>(1 + random.below(400)) * 12.5;
    }
    move.feed = feed;
    const std::uint64_t kind = random.below(10);
    if (kind < 5 || i == 0) {
      move.kind = kind < 2 || i == 0 ? DrawnMove::Kind::Rapid : DrawnMove::Kind::Line;
      const std::uint64_t mask = i == 0 ? 7 : 1 + random.below(7);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        move.given[axis] = (mask >> axis & 1U) != 0;
        const double whole = random.below(2) == 0 ? 1.0 : 0.0;
        const double value = rounded(axis == 2 ? 30.0 : 100.0);
        move.value.set(axis, whole != 0.0 ? std::round(value) : value);
      }
    } else if (kind < 9) {
      move.kind = DrawnMove::Kind::Arc;
      move.plane = inOnePlane ? 2 : static_cast<int>(random.below(3));
      const double angle = random.uniform() * 360.0;
      const double radius = 1.0 + 40.0 * random.uniform();
      move.centre = {std::round(radius * std::cos(angle * kDegree) * 1000.0) / 1000.0,
                     std::round(radius * std::sin(angle * kDegree) * 1000.0) / 1000.0};
      const std::uint64_t size = random.below(8);
      const double sweep = size == 0   ? 360.0
                           : size == 1 ? 90.0
                           : size < 4  ? 200.0 + 140.0 * random.uniform()
                                       : 20.0 + 140.0 * random.uniform();
      move.sweepDeg = random.below(2) == 0 ? sweep : -sweep;
      move.tangent = random.below(3) == 0 && sweep != 360.0;
      move.rise = random.below(4) == 0 ? rounded(20.0) : 0.0;
    } else {
      move.kind = DrawnMove::Kind::Steps;
      move.count = 2 + static_cast<int>(random.below(3));
      move.value = {rounded(10.0), random.below(2) == 0 ? 0.0 : rounded(10.0),
                    random.below(2) == 0 ? 0.0 : rounded(3.0)};
      move.value.x = move.value.x == 0.0 ? 1.0 : move.value.x;
    }
    moves.push_back(move);
  }
  return moves;
}

namespace {

std::vector<std::vector<PlacedMove>> placeAll(const std::vector<DrawnMove>& moves) {
  std::vector<std::vector<PlacedMove>> all;
  Vec3 from;
  Vec3 direction;
  for (const DrawnMove& drawn : moves) {
    all.push_back(place(drawn, from, direction));
    if (!all.back().empty()) {
      direction = directionAfter(all.back().back());
      from = all.back().back().move.end;
    }
  }
  return all;
}

}  // namespace

std::vector<PathMove> pathOf(const std::vector<DrawnMove>& moves) {
  std::vector<PathMove> path;
  for (const std::vector<PlacedMove>& group : placeAll(moves)) {
    for (const PlacedMove& each : group) {
      path.push_back(each.move);
    }
  }
  return path;
}

namespace {

class Writer {
 public:
  Writer(const std::vector<DrawnMove>& moves, const Spelling& spelling)
      : m_moves(moves), m_spelling(spelling), m_control(spelling.control) {}

  Written write();

 private:
  /// State of the control that stays until another word changes it.
  struct Modal {
    bool inch = false;
    bool inchFeed = false;
    bool relative = false;
    bool centreAbsolute = false;
    int plane = 2;
    std::vector<Frame> frames{Frame{}};  ///< nested, the last one holds
    Frame set;                           ///< G92 on top
  };
  struct Word {
    std::string text;
    bool first = false;  ///< stays in front
  };
  /// A program or subprogram that is being written.
  struct Body {
    std::vector<std::string> lines;
    std::vector<double>* arguments = nullptr;
    std::string_view letters;  ///< of the arguments, in their order
    int id = 0;
    int number = 0;
  };

  // What is drawn depends on the seed, the move, the feature and how often it has been asked of
  // them: so it stays when other moves or features are dropped.
  double uniform(Feature feature) {
    const std::uint64_t asked = m_asked[{m_id, feature}]++;
    base::Random random(m_spelling.seed * 0x9e3779b97f4a7c15ULL ^ m_id * 0xbf58476d1ce4e5b9ULL ^
                        (static_cast<std::uint64_t>(feature) + 1) * 0x94d049bb133111ebULL ^
                        asked * 0xd6e8feb86659fd93ULL);
    return random.uniform();
  }
  std::size_t below(Feature feature, std::size_t bound) {
    return static_cast<std::size_t>(uniform(feature) * static_cast<double>(bound));
  }
  bool takes(Feature feature, double share) {
    const bool taken = uniform(feature) < share && !m_spelling.without.contains(feature);
    if (taken) {
      m_used.insert(feature);
    }
    return taken;
  }
  /// The same for the whole program.
  bool program(Feature feature, double share) {
    const std::uint64_t id = std::exchange(m_id, 0);
    const bool taken = takes(feature, share);
    m_id = id;
    return taken;
  }

  [[nodiscard]] bool is(Control control) const { return m_control == control; }
  [[nodiscard]] bool isIso() const { return is(Control::Fanuc) || is(Control::Haas); }
  [[nodiscard]] bool isPlain() const { return is(Control::Heidenhain); }
  [[nodiscard]] bool hasVariables() const { return !is(Control::Grbl); }
  [[nodiscard]] Frame frame() const { return m_modal.frames.back().then(m_modal.set); }
  [[nodiscard]] double length(double mm) const { return m_modal.inch ? mm / kInch : mm; }

  std::string literal(double value);
  std::string number(double value, bool inBrackets = false);
  std::string expression(double value);
  std::string variable(double value);
  std::string freshVariable();
  std::string word(const std::string& address, double value);
  std::string named(const std::string& name, const std::string& value) const;
  void block(std::vector<Word> words, bool mayReorder = true);
  void block(const std::string& text) { block({{text, true}}, false); }
  void raw(const std::string& line) { body().lines.push_back(line); }
  Body& body() { return *m_body; }
  std::string commented(std::string text);

  void beginProgram();
  void changeState(const PlacedMove& next);
  void useUnit(bool inch);
  void usePlane(int plane);
  void pushFrame();
  void writeAbout(const std::string& function, const std::vector<int>& axes,
                  const std::string& amount, Frame& frame);
  void popFrame();
  void setPosition();
  std::string frameWords(Feature kind, int axis, double value);
  void writeMove(const PlacedMove& placed, bool isLoopBody = false);
  void addEnd(std::vector<Word>& words, const PlacedMove& placed, bool isArc);
  bool writePolarLine(const PlacedMove& placed);
  bool writePolarArc(const PlacedMove& placed, int plane, const std::string& motion);
  void writeArc(const PlacedMove& placed);
  void addMotion(std::vector<Word>& words, const std::string& motion);
  void addFeed(std::vector<Word>& words, const PlacedMove& placed);
  void arrive(const PlacedMove& placed);
  void writeSteps(const std::vector<PlacedMove>& steps);
  void writeGroup(std::size_t index);
  std::size_t writeCall(std::size_t index);
  void finishCall(const std::string& name, int id, const std::vector<double>& arguments, bool saves,
                  Body&& sub);
  // Heidenhain.
  void plainLine(const PlacedMove& placed);
  void plainArc(const PlacedMove& placed);
  std::string plainEnd(const PlacedMove& placed, bool isArc);
  std::string plainFeed(const PlacedMove& placed);

  const std::vector<DrawnMove>& m_moves;
  const Spelling& m_spelling;
  Control m_control;
  std::vector<std::vector<PlacedMove>> m_placed;
  std::map<std::pair<std::uint64_t, Feature>, std::uint64_t> m_asked;
  std::uint64_t m_id = 0;
  std::set<Feature> m_used;
  Modal m_modal;
  std::string m_motion;  ///< "": to be written
  double m_feed = -1.0;  ///< F that holds, as written; -1: to be written
  Vec3 m_at;
  std::string m_deferred;  ///< an assignment that the next block takes along
  bool m_isPolar = false;  ///< the move before was
  bool m_fresh = true;     ///< all axes are to be written, absolute
  Vec3 m_direction;        ///< at the end of the move before, 0: a tangent has no meaning
  std::optional<std::pair<Vec3, double>> m_pole;  ///< programmed, and the polar angle reached
  Body m_main;
  Body* m_body = nullptr;
  std::vector<std::pair<std::string, Body>> m_subs;
  std::map<std::string, std::string, std::less<>> m_beside;
  int m_lastSub = 0;
  int m_depth = 0;
  int m_variable = 0;
  int m_label = 9000;
};

std::string Writer::literal(double value) {
  std::string text = plain(value);
  const bool hasPoint = text.find('.') != std::string::npos;
  if (!hasPoint && isIso()) {
    text += '.';  // without it an old control counts increments
  }
  if (is(Control::Sinumerik) && takes(Feature::Exponent, 0.05) && value != 0.0) {
    const bool grows = below(Feature::Exponent, 2) == 0;
    return plain(grows ? value * 100.0 : value / 100.0, 15) + (grows ? "EX-2" : "EX2");
  }
  if (takes(Feature::NumberForms, 0.1)) {
    const bool negative = text[0] == '-';
    std::string digits = negative ? text.substr(1) : text;
    switch (below(Feature::NumberForms, 3)) {
      case 0:
        digits = digits.starts_with("0.") && digits.size() > 2 ? digits.substr(1) : "0" + digits;
        break;
      case 1:
        digits += digits.find('.') == std::string::npos ? ".0" : "0";
        break;
      default:
        return negative || isIso() || isPlain() ? text : "+" + text;
    }
    return negative ? "-" + digits : digits;
  }
  return text;
}

std::string Writer::freshVariable() {
  ++m_variable;
  switch (m_control) {
    case Control::Sinumerik:
      return "R" + std::to_string(10 + m_variable % 60);
    case Control::LinuxCnc:
      return m_variable % 2 == 0 ? "#" + std::to_string(31 + m_variable % 60)
                                 : "#<_value" + std::to_string(m_variable % 7) + ">";
    case Control::Heidenhain:
      return "Q" + std::to_string(20 + m_variable % 60);
    default:
      return "#" + std::to_string(100 + m_variable % 50);
  }
}

/// Assigns it in a block of its own.
std::string Writer::variable(double value) {
  const std::string name = freshVariable();
  if (isPlain()) {
    raw((below(Feature::Variables, 2) == 0 ? "FN 0: " : "") + name + " = " + literal(value));
  } else {
    raw(name + "=" + literal(value));
  }
  return name;
}

/// Something that has this value; in Heidenhain's plain text a parameter.
std::string Writer::expression(double value) {
  if (isPlain()) {
    return variable(value);
  }
  if (is(Control::LinuxCnc) && m_deferred.empty() && takes(Feature::Deferred, 0.15)) {
    // An assignment takes effect behind its block: RS-274/NGC, "parameter setting".
    const std::string name = variable(value);
    m_deferred = name + "=" + literal(value + 7.0);
    return name;
  }
  const double other = std::round(uniform(Feature::Variables) * 2000.0) / 100.0 - 10.0;
  const bool isNgc = !is(Control::Sinumerik);
  const std::string open = isNgc ? "[" : "(";
  const std::string close = isNgc ? "]" : ")";
  switch (below(Feature::Variables, 7)) {
    case 0:
      return variable(value);
    case 1:
      return "-" + variable(-value);
    case 2: {
      const std::string name = variable(value - other);
      return name + (other < 0.0 ? "-" : "+") + literal(std::abs(other));
    }
    case 3:
      return "1" + std::string(isIso() ? "." : "") + "+2" + (isIso() ? "." : "") + "*" +
             variable((value - 1.0) / 2.0);
    case 4:
      return variable(value * 4.0) + "/4" + (isIso() ? "." : "");
    case 5: {
      const std::string name = variable(value * 2.0);
      return name + "*COS" + open + "60" + (isIso() ? "." : "") + close;
    }
    default: {
      const std::string name = variable(other - value);
      return open + literal(other) + "-" + name + close + "*1" + (isIso() ? "." : "");
    }
  }
}

/// What stands behind an address: a number, a variable, an argument, or an expression.
std::string Writer::number(double value, bool inBrackets) {
  if (body().arguments != nullptr && body().arguments->size() < 6 &&
      takes(Feature::Arguments, 0.4)) {
    std::vector<double>& arguments = *body().arguments;
    arguments.push_back(value);
    const std::size_t number = arguments.size();
    switch (m_control) {
      case Control::Sinumerik:
        return "ARG" + std::to_string(number);
      case Control::LinuxCnc:
        return "#" + std::to_string(number);
      case Control::Heidenhain:
        return "Q" + std::to_string(100 + 10 * body().id + static_cast<int>(number));
      default: {
        static const std::map<char, int> kLocals{{'A', 1},  {'B', 2},  {'C', 3},
                                                 {'H', 11}, {'Q', 17}, {'X', 24}};
        return "#" + std::to_string(kLocals.at(body().letters[number - 1]));
      }
    }
  }
  if (hasVariables() && takes(Feature::Variables, 0.12)) {
    const std::string text = expression(value);
    const bool isOne = text.find_first_of("+-*/", 1) == std::string::npos && text[0] != '[';
    return is(Control::Sinumerik) || isPlain() || isOne || inBrackets ? text : "[" + text + "]";
  }
  return literal(value);
}

std::string Writer::named(const std::string& name, const std::string& value) const {
  const bool isNumber = value.find_first_not_of("+-.0123456789") == std::string::npos;
  return name + (is(Control::Sinumerik) && (name.size() > 1 || !isNumber) ? "=" : "") + value;
}

std::string Writer::word(const std::string& address, double value) {
  return named(address, number(value));
}

std::string Writer::commented(std::string text) {
  if (!takes(Feature::Comments, 0.1)) {
    return text;
  }
  const bool brackets = !is(Control::Sinumerik) && !isPlain() && below(Feature::Comments, 2) == 0;
  if (brackets || isIso()) {
    return text + " (X999 G0 M30)";
  }
  return text + " ; X999 G0 M30 \"a";
}

void Writer::block(std::vector<Word> words, bool mayReorder) {
  if (!m_deferred.empty()) {
    // Rivulet refuses "^" behind it as an operator: there it stays the last word.
    const bool isPolar = std::any_of(words.begin(), words.end(),
                                     [](const Word& word) { return word.text[0] == '^'; });
    words.push_back({std::exchange(m_deferred, {}), isPolar});
  }
  if (mayReorder && takes(Feature::Order, 0.3)) {
    for (std::size_t i = words.size(); i > 1; --i) {
      const std::size_t j = below(Feature::Order, i);
      if (!words[i - 1].first && !words[j].first) {
        std::swap(words[i - 1], words[j]);
      }
    }
  }
  std::string text;
  if (takes(Feature::BlockNumbers, 0.3)) {
    ++body().number;
    text = isPlain() ? std::to_string(body().number) + " "
                     : "N" + std::to_string(10 * body().number) + " ";
  }
  const std::size_t blanks = takes(Feature::Blanks, 0.25) ? below(Feature::Blanks, 3) : 3;
  bool isFirst = true;
  for (const Word& each : words) {
    const bool needsBlank = isPlain() || each.first || is(Control::Sinumerik);
    if (!isFirst) {
      text += blanks == 3   ? " "
              : blanks == 0 ? (needsBlank ? " " : "")
              : blanks == 1 ? "   "
                            : "\t";
    }
    isFirst = false;
    text += each.text;
    const bool mayBreak = (is(Control::LinuxCnc) || is(Control::Grbl)) && mayReorder &&
                          each.text.find_first_of("#[(") == std::string::npos;
    if (mayBreak && each.text.size() > 2 && takes(Feature::InnerBlanks, 0.05)) {
      text.insert(text.size() - 1, " ");
    }
  }
  raw(commented(text));
}

void Writer::addMotion(std::vector<Word>& words, const std::string& motion) {
  if (m_motion != motion || takes(Feature::Repeated, 0.4)) {
    words.push_back({takes(Feature::NumberForms, 0.1) ? "G0" + motion.substr(1) : motion});
  }
  m_motion = motion;
}

void Writer::addFeed(std::vector<Word>& words, const PlacedMove& placed) {
  if (placed.move.kind == PathMove::Kind::Rapid) {
    return;
  }
  const double feed = m_modal.inchFeed ? placed.move.feed / kInch : placed.move.feed;
  if (feed != m_feed || takes(Feature::Repeated, 0.2)) {
    words.push_back({word("F", feed)});
    m_feed = feed;
  }
}

void Writer::arrive(const PlacedMove& placed) {
  m_at = placed.move.end;
  m_direction = directionAfter(placed);
  m_fresh = false;
  m_isPolar = false;
}

/// The axes of the end, each as the mode or the value itself says.
void Writer::addEnd(std::vector<Word>& words, const PlacedMove& placed, bool isArc) {
  const Vec3 from = frame().programmed(m_at);
  const Vec3 to = frame().programmed(placed.move.end);
  const bool perValue = is(Control::Sinumerik) && takes(Feature::PerValue, 0.25);
  if (m_fresh && m_modal.relative && !perValue) {
    words.push_back({"G90"});
    m_modal.relative = false;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double moved = to[axis] - from[axis];
    const bool again = takes(Feature::Repeated, 0.15) && !isArc;
    // Grbl wants an axis of the plane in each arc, in a full circle too.
    const bool isWanted = isArc && is(Control::Grbl) && axis == at(firstOf(m_modal.plane));
    if (std::abs(moved) < 1e-10 && !m_fresh && !again && !isWanted) {
      continue;
    }
    const std::string address(1, kAxes[axis]);
    bool increment = m_modal.relative;
    if (perValue) {
      increment = !m_fresh && below(Feature::PerValue, 2) == 0;
      const std::string value = number(length(increment ? moved : to[axis]), true);
      words.push_back({address + "=" + (increment ? "IC(" : "AC(") + value + ")"});
    } else {
      words.push_back({word(address, length(increment ? moved : to[axis]))});
    }
  }
}

/// Polar coordinates of a place about a pole, in the plane.
std::pair<double, double> polarOf(Vec3 point, Vec3 pole, int plane) {
  const double u = point[at(firstOf(plane))] - pole[at(firstOf(plane))];
  const double v = point[at(secondOf(plane))] - pole[at(secondOf(plane))];
  return {std::hypot(u, v), std::atan2(v, u) / kDegree};
}

bool Writer::writePolarLine(const PlacedMove& placed) {
  const Vec3 to = frame().programmed(placed.move.end);
  const Vec3 from = frame().programmed(m_at);
  const int plane = m_modal.plane;
  std::vector<Word> words;
  const std::string motion = placed.move.kind == PathMove::Kind::Rapid ? "G0" : "G1";
  const std::size_t across = at(plane);
  const bool rises = std::abs(to[across] - from[across]) > 1e-10 || m_fresh;
  if (is(Control::Sinumerik)) {
    Vec3 pole;
    if (!m_pole || below(Feature::Polar, 2) == 0) {
      // About zero, the present position, or the pole before: G111, G110, G112.
      const std::size_t kind =
          m_fresh || !m_pole ? below(Feature::Polar, m_fresh ? 1 : 2) : below(Feature::Polar, 3);
      pole.set(at(firstOf(plane)), std::round(uniform(Feature::Polar) * 1000.0) / 10.0);
      pole.set(at(secondOf(plane)), std::round(uniform(Feature::Polar) * 1000.0) / 10.0);
      const Vec3 origin = kind == 0 ? Vec3{} : kind == 1 ? from : m_pole->first;
      std::vector<Word> set{{kind == 0 ? "G111" : kind == 1 ? "G110" : "G112", true}};
      for (const int axis : {firstOf(plane), secondOf(plane)}) {
        set.push_back({word(std::string(1, kAxes[at(axis)]), length(pole[at(axis)]))});
        pole.set(at(axis), pole[at(axis)] + origin[at(axis)]);
      }
      block(set);
      m_pole = {pole, std::nan("")};
    }
    pole = m_pole->first;
    const auto [radius, angle] = polarOf(to, pole, plane);
    const bool chained = m_isPolar && !std::isnan(m_pole->second) && below(Feature::Polar, 2) == 0;
    addMotion(words, motion);
    const double turn = angle - (chained ? m_pole->second : 0.0);
    const std::string value = number(turn, true);
    words.push_back({chained                         ? "AP=IC(" + value + ")"
                     : m_modal.relative              ? "AP=AC(" + value + ")"
                     : below(Feature::Polar, 2) == 0 ? "AP=AC(" + value + ")"
                                                     : "AP=" + value});
    const std::string size = number(length(radius), true);
    words.push_back({m_modal.relative ? "RP=AC(" + size + ")" : "RP=" + size});
    m_pole->second = angle;
    if (rises) {
      const double height = to[across];
      words.push_back(
          {std::string(1, kAxes[across]) + "=AC(" + number(length(height), true) + ")"});
    }
  } else {
    if (m_modal.relative || (is(Control::LinuxCnc) && plane != 2)) {
      return false;
    }
    const auto [radius, angle] = polarOf(to, {}, plane);
    if (isIso()) {
      block("G16");
    }
    addMotion(words, motion);
    const char first = isIso() ? kAxes[at(firstOf(plane))] : '@';
    const char second = isIso() ? kAxes[at(secondOf(plane))] : '^';
    words.push_back({word(std::string(1, first), length(radius))});
    words.push_back({word(std::string(1, second), angle)});
    if (rises) {
      words.push_back({word(std::string(1, kAxes[across]), length(to[across]))});
    }
  }
  addFeed(words, placed);
  block(words);
  if (isIso()) {
    block("G15");
  }
  arrive(placed);
  m_isPolar = is(Control::Sinumerik);
  return true;
}

/// An arc about the pole: its centre.
bool Writer::writePolarArc(const PlacedMove& placed, int plane, const std::string& motion) {
  const Vec3 pole = frame().programmed(placed.move.centre);
  std::vector<Word> set{{"G111", true}};
  for (const int axis : {firstOf(plane), secondOf(plane)}) {
    set.push_back({word(std::string(1, kAxes[at(axis)]), length(pole[at(axis)]))});
  }
  block(set);
  const Vec3 to = frame().programmed(placed.move.end);
  const auto [radius, angle] = polarOf(to, pole, plane);
  std::vector<Word> words;
  addMotion(words, motion);
  words.push_back({"AP=AC(" + number(angle, true) + ")"});
  words.push_back({"RP=AC(" + number(length(radius), true) + ")"});
  if (std::abs(to[at(plane)] - frame().programmed(m_at)[at(plane)]) > 1e-10) {
    words.push_back(
        {std::string(1, kAxes[at(plane)]) + "=AC(" + number(length(to[at(plane)]), true) + ")"});
  }
  addFeed(words, placed);
  block(words);
  m_pole = {pole, angle};
  arrive(placed);
  m_isPolar = true;
  return true;
}

void Writer::writeArc(const PlacedMove& placed) {
  const Frame now = frame();
  const int plane = now.planeOf(placed.plane);
  usePlane(plane);
  const Vec3 from = now.programmed(m_at);
  const Vec3 centre = now.programmed(placed.move.centre);
  // The sense of the turn, as the program sees it.
  const Vec3 soon = now.programmed(
      turned(m_at, placed.move.centre, placed.plane, std::copysign(10.0, placed.signedSweep)));
  const bool counter = base::cross(from - centre, soon - centre)[at(plane)] > 0.0;
  const std::string motion = counter ? "G3" : "G2";
  const double sweep = placed.move.sweepDeg;
  const bool isFull = sweep == 360.0;
  const Vec3 to = now.programmed(placed.move.end);
  const bool rises = std::abs(to[at(plane)] - from[at(plane)]) > 1e-10;
  const double radius = base::norm(centre - from);
  const bool isSinumerik = is(Control::Sinumerik);
  std::vector<Word> words;
  if (isSinumerik && !isFull && !m_fresh && takes(Feature::Polar, 0.1)) {
    writePolarArc(placed, plane, motion);
    return;
  }
  if (isSinumerik && !isFull && !rises && takes(Feature::ArcThrough, 0.12)) {
    const Vec3 middle =
        now.programmed(turned(m_at, placed.move.centre, placed.plane, placed.signedSweep * 0.4));
    words.push_back({"CIP"});
    const bool perValue = takes(Feature::PerValue, 0.3);
    addEnd(words, placed, true);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool increment = perValue ? below(Feature::PerValue, 2) == 0 : m_modal.relative;
      const std::string value =
          number(length(increment ? middle[axis] - from[axis] : middle[axis]), true);
      const std::string name = std::string(1, kCentres[axis]) + "1=";
      words.push_back({name + (perValue ? (increment ? "IC(" : "AC(") + value + ")" : value)});
    }
    addFeed(words, placed);
    m_motion.clear();
    block(words);
    arrive(placed);
    return;
  }
  const Vec3 tangent = base::cross(placed.move.axis, m_at - placed.move.centre);
  const bool goesOn = base::norm(m_direction) > 0.5 && !rises && !isFull && !m_fresh &&
                      base::norm(base::cross(m_direction, tangent)) < 1e-12 * base::norm(tangent) &&
                      base::dot(m_direction, tangent) > 0.0;
  if (isSinumerik && goesOn && takes(Feature::Tangent, 0.5)) {
    words.push_back({"CT"});
    addEnd(words, placed, true);
    addFeed(words, placed);
    m_motion.clear();
    block(words);
    arrive(placed);
    return;
  }
  addMotion(words, motion);
  const bool byRadius = !isFull && takes(Feature::ArcRadius, 0.3);
  const bool byAngle = isSinumerik && !isFull && !byRadius && takes(Feature::ArcAngle, 0.2);
  const bool angleAndCentre = byAngle && !m_fresh && !rises && below(Feature::ArcAngle, 2) == 0;
  if (!isFull && !angleAndCentre) {
    addEnd(words, placed, true);
  } else if (rises || m_fresh || is(Control::Grbl)) {
    addEnd(words, placed, true);
  }
  if (byRadius) {
    const std::string name = isSinumerik ? "CR" : "R";
    words.push_back({word(name, length(sweep > 180.0 ? -radius : radius))});
  } else if (!byAngle || angleAndCentre) {
    const bool absolute =
        (isSinumerik || is(Control::LinuxCnc)) && takes(Feature::AbsoluteCentre, 0.25);
    if (is(Control::LinuxCnc) && absolute != m_modal.centreAbsolute) {
      m_modal.centreAbsolute = absolute;
      words.push_back({absolute ? "G90.1" : "G91.1"});
    }
    for (const int axis : {firstOf(plane), secondOf(plane)}) {
      const double offset = centre[at(axis)] - from[at(axis)];
      const std::string name(1, kCentres[at(axis)]);
      if (isSinumerik && absolute) {
        words.push_back({name + "=AC(" + number(length(centre[at(axis)]), true) + ")"});
      } else if (absolute) {
        words.push_back({word(name, length(centre[at(axis)]))});
      } else if (std::abs(offset) > 1e-10 || takes(Feature::Repeated, 0.5)) {
        words.push_back({word(name, length(offset))});
      }
    }
  }
  if (byAngle) {
    words.push_back({word("AR", sweep)});
  }
  addFeed(words, placed);
  block(words);
  arrive(placed);
}

void Writer::writeMove(const PlacedMove& placed, bool isLoopBody) {
  if (isPlain()) {
    placed.move.kind == PathMove::Kind::Arc ? plainArc(placed) : plainLine(placed);
    return;
  }
  const bool cuts = placed.move.kind != PathMove::Kind::Rapid;
  if (placed.move.kind == PathMove::Kind::Arc) {
    writeArc(placed);
    return;
  }
  if (!isLoopBody && (is(Control::Sinumerik) || isIso() || is(Control::LinuxCnc)) &&
      takes(Feature::Polar, 0.12) && writePolarLine(placed)) {
    return;
  }
  std::vector<Word> words;
  addMotion(words, cuts ? "G1" : "G0");
  const bool inverse = cuts && !isLoopBody && takes(Feature::InverseTime, 0.06);
  const bool perTurn =
      cuts && !isLoopBody && !inverse && !is(Control::Grbl) && takes(Feature::PerRevolution, 0.06);
  if (inverse) {
    block("G93");
  } else if (perTurn) {
    block("S1000 M3");
    block("G95");
  }
  addEnd(words, placed, false);
  if (inverse || perTurn) {
    const double feed = m_modal.inchFeed ? placed.move.feed / kInch : placed.move.feed;
    words.push_back({word(
        "F", inverse ? placed.move.feed / base::distance(m_at, placed.move.end) : feed / 1000.0)});
  } else {
    addFeed(words, placed);
  }
  block(words);
  if (inverse || perTurn) {
    block("G94");
    m_feed = -1.0;
  }
  arrive(placed);
}

void Writer::useUnit(bool inch) {
  if (isPlain() || inch == m_modal.inch) {
    return;
  }
  m_modal.inch = inch;
  m_modal.inchFeed = inch;
  std::string name = inch ? "G20" : "G21";
  if (is(Control::Sinumerik)) {
    const bool feedToo = below(Feature::Inch, 2) == 0;
    name = inch ? (feedToo ? "G700" : "G70") : (feedToo ? "G710" : "G71");
    m_modal.inchFeed = inch && feedToo;
  }
  block(name);
  m_feed = -1.0;
  m_pole.reset();
}

void Writer::usePlane(int plane) {
  if (plane == m_modal.plane) {
    return;
  }
  m_modal.plane = plane;
  m_pole.reset();
  if (isPlain()) {
    m_used.insert(Feature::PlaneWords);
    block("TOOL CALL 1 " + std::string(1, kAxes[at(plane)]) + " S1000");
    // Another tool is as long as only the control knows: the place is named again.
    const Vec3 here = frame().programmed(m_at);
    std::string text = "L";
    for (std::size_t axis = 0; axis < 3; ++axis) {
      text += std::string(" ") + kAxes[axis] + (here[axis] < 0 ? "" : "+") + plain(here[axis]);
    }
    block(text + " FMAX");
    m_direction = {};
    return;
  }
  block(kPlaneWords[at(plane)]);
}

/// A frame on top of the one that holds.
void Writer::pushFrame() {
  Frame next;
  const auto nice = [this](Feature feature, double span) {
    return std::round((uniform(feature) * 2.0 - 1.0) * span * 10.0) / 10.0;
  };
  const std::size_t depth = m_modal.frames.size();
  std::string line;
  const bool isSinumerik = is(Control::Sinumerik);
  const bool canNest = isSinumerik || depth == 1;
  if ((isSinumerik || ((isIso() || isPlain()) && depth == 1)) && takes(Feature::Shift, 0.06)) {
    next.origin = {nice(Feature::Shift, 50), nice(Feature::Shift, 50), nice(Feature::Shift, 10)};
    if (isPlain()) {
      raw("CYCL DEF 7.0 DATUM SHIFT");
      for (std::size_t axis = 0; axis < 3; ++axis) {
        raw("CYCL DEF 7." + std::to_string(axis + 1) + " " + kAxes[axis] +
            plain(next.origin[axis]));
      }
    } else {
      const bool additive = depth > 1 || below(Feature::Shift, 2) == 0;
      std::vector<Word> words{{isSinumerik ? (additive ? "ATRANS" : "TRANS") : "G52", true}};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        words.push_back({word(std::string(1, kAxes[axis]), length(next.origin[axis]))});
      }
      block(words);
    }
  } else if ((isSinumerik || ((isIso() || isPlain()) && canNest)) &&
             m_modal.frames.back().isEven() && takes(Feature::Turn, 0.05)) {
    const double angle = nice(Feature::Turn, 180);
    const int axis =
        is(Control::Sinumerik) ? static_cast<int>(below(Feature::Turn, 3)) : m_modal.plane;
    for (int own = 0; own < 3; ++own) {
      next.axes[at(own)] = turned(unit(own), {}, axis, angle);
    }
    if (is(Control::Sinumerik)) {
      const std::string name = depth > 1 || below(Feature::Turn, 2) == 0 ? "AROT" : "ROT";
      const bool inPlane = axis == m_modal.plane && below(Feature::Turn, 2) == 0;
      block({{name, true}, {word(inPlane ? "RPL" : std::string(1, kAxes[at(axis)]), angle)}});
    } else if (isIso()) {
      writeAbout("G68", {firstOf(axis), secondOf(axis)}, " R" + literal(angle), next);
    } else {
      raw("CYCL DEF 10.0 ROTATION");
      raw("CYCL DEF 10.1 ROT" + std::string(angle < 0 ? "" : "+") + plain(angle));
    }
  } else if ((isSinumerik || (isIso() && canNest)) && takes(Feature::Scale, 0.04)) {
    const double factor = 0.5 * static_cast<double>(1 + below(Feature::Scale, 5));
    if (is(Control::Sinumerik)) {
      const bool all = below(Feature::Scale, 3) != 0;
      const std::string name = depth > 1 || below(Feature::Scale, 2) == 0 ? "ASCALE" : "SCALE";
      std::vector<Word> words{{name, true}};
      for (int axis = 0; axis < (all ? 3 : 1); ++axis) {
        next.axes[at(axis)] = factor * next.axes[at(axis)];
        words.push_back({word(std::string(1, kAxes[at(axis)]), factor)});
      }
      block(words);
    } else {
      for (Vec3& axis : next.axes) {
        axis = factor * axis;
      }
      writeAbout("G51", {0, 1, 2}, " P" + literal(factor), next);
    }
  } else if ((isSinumerik || (!is(Control::LinuxCnc) && !is(Control::Grbl) && canNest)) &&
             takes(Feature::Mirror, 0.04)) {
    const int axis = static_cast<int>(below(Feature::Mirror, isPlain() ? 2 : 3));
    next.axes[at(axis)] = -1.0 * next.axes[at(axis)];
    if (isPlain()) {
      raw("CYCL DEF 8.0 MIRROR IMAGE");
      raw("CYCL DEF 8.1 " + std::string(1, kAxes[at(axis)]));
    } else if (isIso()) {
      writeAbout("G51.1", {axis}, "", next);
    } else {
      const std::string name = depth > 1 || below(Feature::Mirror, 2) == 0 ? "AMIRROR" : "MIRROR";
      block({{name, true}, {std::string(1, kAxes[at(axis)]) + "0"}});
    }
  } else {
    return;
  }
  m_modal.frames.push_back(m_modal.frames.back().then(next));
  m_fresh = true;
  m_pole.reset();
}

/// G68, G51 and G51.1: about a place, absolute. The frame so far is about zero.
void Writer::writeAbout(const std::string& function, const std::vector<int>& axes,
                        const std::string& amount, Frame& frame) {
  if (m_modal.relative) {
    m_modal.relative = false;
    block("G90");
  }
  Vec3 centre;
  std::vector<Word> words{{function, true}};
  for (const int axis : axes) {
    centre.set(at(axis), std::round(uniform(Feature::Shift) * 500.0) / 10.0);
    words.push_back({std::string(1, kAxes[at(axis)]) + literal(length(centre[at(axis)]))});
  }
  if (!amount.empty()) {
    words.push_back({amount.substr(1)});
  }
  frame.origin = centre - frame.turn(centre);
  block(words);
}

void Writer::popFrame() {
  m_modal.frames.resize(1);
  m_fresh = true;
  m_pole.reset();
  switch (m_control) {
    case Control::Sinumerik: {
      static constexpr std::array kNames{"TRANS", "ROT", "SCALE", "MIRROR"};
      block(kNames[below(Feature::Shift, kNames.size())]);
      break;
    }
    case Control::Heidenhain:
      raw("CYCL DEF 7.0 DATUM SHIFT");
      raw("CYCL DEF 7.1 X+0");
      raw("CYCL DEF 7.2 Y+0");
      raw("CYCL DEF 7.3 Z+0");
      raw("CYCL DEF 8.0 MIRROR IMAGE");
      raw("CYCL DEF 8.1");
      raw("CYCL DEF 10.0 ROTATION");
      raw("CYCL DEF 10.1 ROT+0");
      break;
    default:
      block("G69");
      block("G50");
      block("G50.1 X0. Y0. Z0.");
      block("G52 X0. Y0. Z0.");
      break;
  }
}

/// G92: the place where the tool stands gets other coordinates, or its own again.
void Writer::setPosition() {
  const bool takenBack = m_modal.set.origin != Vec3{} && below(Feature::SetPosition, 2) == 0;
  if (takenBack && (is(Control::LinuxCnc) || is(Control::Grbl))) {
    block("G92.1");
    m_modal.set = {};
  } else {
    Vec3 named = takenBack ? m_modal.frames.back().programmed(m_at) : Vec3{};
    std::vector<Word> words{{"G92", true}};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!takenBack) {
        named.set(axis, std::round(uniform(Feature::SetPosition) * 1000.0) / 10.0);
      }
      words.push_back({word(std::string(1, kAxes[axis]), length(named[axis]))});
    }
    block(words);
    m_modal.set.origin = m_modal.frames.back().programmed(m_at) - named;
  }
  m_fresh = true;
}

void Writer::changeState(const PlacedMove& next) {
  if (takes(Feature::Inch, 0.06)) {
    useUnit(!m_modal.inch);
  }
  if (m_modal.frames.size() > 1 && uniform(Feature::Count) < 0.2) {
    popFrame();
  }
  const bool canSet = is(Control::LinuxCnc) || is(Control::Grbl) || isIso();
  if (canSet && m_modal.frames.size() == 1 && !m_fresh && takes(Feature::SetPosition, 0.06)) {
    setPosition();
  }
  if (m_modal.set.origin == Vec3{}) {
    pushFrame();
  }
  if (next.move.kind == PathMove::Kind::Arc && frame().planeOf(next.plane) < 0) {
    popFrame();
  }
  if (!isPlain() && !m_fresh && takes(Feature::Increments, 0.2)) {
    m_modal.relative = !m_modal.relative;
    block(m_modal.relative ? "G91" : "G90");
  }
  if (!isPlain() && takes(Feature::PlaneWords, 0.06)) {
    usePlane(static_cast<int>(below(Feature::PlaneWords, 3)));
  }
}

/// Equal steps: a loop, or one after another.
void Writer::writeSteps(const std::vector<PlacedMove>& steps) {
  const int count = static_cast<int>(steps.size());
  const bool canLoop = !m_fresh && !is(Control::Grbl) && count > 1;
  if (!canLoop || !takes(Feature::Loop, 0.7)) {
    for (const PlacedMove& step : steps) {
      writeMove(step);
    }
    return;
  }
  const PlacedMove& first = steps.front();
  const Vec3 moved = frame().back(first.move.end - first.start);
  const std::string times = std::to_string(count);
  // What is written once holds for each turn: so the motion and the feed stand before it.
  const double feed = m_modal.inchFeed ? first.move.feed / kInch : first.move.feed;
  std::string line;
  if (isPlain()) {
    const int label = ++m_lastSub + 100;
    raw("LBL " + std::to_string(label));
    line = "L";
    for (std::size_t axis = 0; axis < 3; ++axis) {
      line += std::string(" I") + kAxes[axis] + (moved[axis] < 0 ? "" : "+") + plain(moved[axis]);
    }
    raw(line + " R0 F" + plain(feed));
    m_feed = feed;
    raw("CALL LBL " + std::to_string(label) + " REP" + (below(Feature::Loop, 2) == 0 ? " " : "") +
        std::to_string(count - 1));
    m_at = steps.back().move.end;
    m_direction = directionAfter(steps.back());
    return;
  }
  const bool cumulates = below(Feature::Loop, 3) == 0;
  const std::string counter = is(Control::Sinumerik)  ? "R90"
                              : is(Control::LinuxCnc) ? "#95"
                                                      : "#149";
  const Vec3 from = frame().programmed(first.start);
  std::array<std::string, 3> sums;
  for (std::size_t axis = 0; axis < 3 && cumulates; ++axis) {
    sums[axis] = is(Control::Sinumerik)  ? "R" + std::to_string(91 + axis)
                 : is(Control::LinuxCnc) ? "#" + std::to_string(96 + axis)
                                         : "#" + std::to_string(146 + axis);
    raw(sums[axis] + "=" + literal(length(from[axis])));
  }
  if (cumulates == m_modal.relative) {
    m_modal.relative = !cumulates;
    block(cumulates ? "G90" : "G91");
  }
  std::vector<std::string> inner;
  const bool isNgc = !is(Control::Sinumerik);
  line = "G1";
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string address(1, kAxes[axis]);
    if (cumulates) {
      const std::string step =
          (moved[axis] < 0 ? "-" : "+") + literal(length(std::abs(moved[axis])));
      inner.push_back(sums[axis] + "=" + (isNgc ? "[" : "") + sums[axis] + step +
                      (isNgc ? "]" : ""));
      line += " " + address + (isNgc ? "" : "=") + sums[axis];
    } else if (moved[axis] != 0.0) {
      line += " " + named(address, literal(length(moved[axis])));
    }
  }
  line += " " + named("F", literal(feed));
  inner.push_back(line);
  m_motion = "G1";
  m_feed = feed;
  const auto all = [this, &inner] {
    for (const std::string& each : inner) {
      raw(each);
    }
  };
  const std::string up = counter + "=" + (isNgc ? "[" : "") + counter + "+1" +
                         (isIso() ? "." : "") + (isNgc ? "]" : "");
  const std::string label = std::to_string(++m_label);
  if (is(Control::Sinumerik)) {
    switch (below(Feature::Loop, 5)) {
      case 0:
        raw("FOR " + counter + "=1 TO " + times);
        all();
        raw("ENDFOR");
        break;
      case 1:
        raw(counter + "=0");
        raw("WHILE " + counter + "<" + times);
        all();
        raw(up);
        raw("ENDWHILE");
        break;
      case 2:
        raw(counter + "=0");
        raw("REPEAT");
        all();
        raw(up);
        raw("UNTIL " + counter + ">=" + times);
        break;
      case 3:
        raw("LOOP" + label + ":");
        all();
        raw("REPEAT LOOP" + label + " P=" + std::to_string(count - 1));
        break;
      default:
        raw(counter + "=0");
        raw("BACK" + label + ":");
        all();
        raw(up);
        raw("IF " + counter + "<" + times + " GOTOB BACK" + label);
        break;
    }
  } else if (isIso()) {
    const std::string limit = times + ".";
    raw(counter + "=0");
    if (below(Feature::Loop, 2) == 0) {
      raw("WHILE[" + counter + "LT" + limit + "]DO1");
      all();
      raw(up);
      raw("END1");
    } else {
      raw("N" + label);
      all();
      raw(up);
      raw("IF [" + counter + " LT " + limit + "] GOTO " + label);
    }
  } else {
    raw(counter + "=0");
    const std::string o = "o" + label + " ";
    switch (below(Feature::Loop, 3)) {
      case 0:
        raw(o + "while [" + counter + " LT " + times + "]");
        all();
        raw(up);
        raw(o + "endwhile");
        break;
      case 1:
        raw(o + "repeat [" + times + "]");
        all();
        raw(o + "endrepeat");
        break;
      default:
        raw(o + "do");
        all();
        raw(up);
        raw(o + "while [" + counter + " lt " + times + "]");
        break;
    }
  }
  arrive(steps.back());
}

void Writer::writeGroup(std::size_t index) {
  m_id = m_moves[index].id;
  const std::vector<PlacedMove>& group = m_placed[index];
  if (group.empty()) {
    return;
  }
  changeState(group.front());
  if (m_moves[index].kind == DrawnMove::Kind::Steps) {
    writeSteps(group);
    return;
  }
  writeMove(group.front());
}

/// The next moves in a subprogram, or between words that save and restore the state.
/// @return the index behind them
std::size_t Writer::writeCall(std::size_t index) {
  m_id = m_moves[index].id;
  const std::size_t end = std::min(index + 1 + below(Feature::Call, 3), m_moves.size());
  const bool saves =
      (is(Control::Sinumerik) || is(Control::LinuxCnc)) && takes(Feature::SavedState, 0.4);
  const int id = ++m_lastSub;
  Body sub;
  std::vector<double> arguments;
  sub.letters = "XABCHQ";
  sub.id = id;
  // M98 leaves the variables to the program that calls, G65 has its own.
  const bool isMacro = !isIso() || below(Feature::Call, 2) == 0;
  sub.arguments = isMacro ? &arguments : nullptr;
  const Modal before = m_modal;
  Body* const caller = std::exchange(m_body, &sub);
  ++m_depth;
  std::size_t each = index;
  while (each < end) {
    m_id = m_moves[each].id;
    const bool nests = each > index && m_depth < 3 && takes(Feature::Call, 0.1);
    if (nests) {
      each = writeCall(each);  // perhaps beyond the end
    } else {
      writeGroup(each++);
    }
  }
  --m_depth;
  m_body = caller;
  m_id = m_moves[index].id;
  if (saves) {
    const Frame set = m_modal.set;  // G92 of LinuxCNC is no state that M70 saves
    m_modal = before;
    m_modal.set = set;
    m_motion.clear();
    m_feed = -1.0;
    m_fresh = true;
    m_pole.reset();
  }
  finishCall(is(Control::Sinumerik)
                 ? "PART" + std::string(1, static_cast<char>('A' + id % 26)) + std::to_string(id)
                 : std::to_string((isIso() ? 9000 : 100) + id),
             id, arguments, saves, std::move(sub));
  return each;
}

void Writer::finishCall(const std::string& name, int id, const std::vector<double>& arguments,
                        bool saves, Body&& sub) {
  std::vector<std::string>& lines = sub.lines;
  switch (m_control) {
    case Control::Sinumerik: {
      std::string head;
      std::string values;
      for (std::size_t i = 0; i < arguments.size(); ++i) {
        head += (i == 0 ? "REAL ARG" : ",REAL ARG") + std::to_string(i + 1);
        values += (i == 0 ? "" : ",") + literal(arguments[i]);
      }
      if (!arguments.empty() || saves) {
        lines.insert(lines.begin(), "PROC " + name + (arguments.empty() ? "" : "(" + head + ")") +
                                        (saves ? " SAVE" : ""));
      }
      lines.push_back(below(Feature::Call, 2) == 0 ? "M17" : "RET");
      block(name + (arguments.empty() ? "" : "(" + values + ")"));
      break;
    }
    case Control::LinuxCnc: {
      std::string call = "o" + name + " call";
      for (const double value : arguments) {
        call += " [" + literal(value) + "]";
      }
      lines.insert(lines.begin(), saves && below(Feature::SavedState, 2) == 0 ? "M73"
                                  : saves                                     ? "M70"
                                                                              : "");
      lines.insert(lines.begin(), "o" + name + " sub");
      if (lines[1] == "M70") {
        lines.push_back("M72");
      }
      lines.push_back("o" + name + " endsub");
      raw(call);
      break;
    }
    case Control::Heidenhain:
      for (std::size_t i = 0; i < arguments.size(); ++i) {
        raw("Q" + std::to_string(100 + 10 * id + static_cast<int>(i) + 1) + " = " +
            literal(arguments[i]));
      }
      lines.insert(lines.begin(), "LBL " + name);
      lines.push_back("LBL 0");
      raw("CALL LBL " + name);
      break;
    case Control::Grbl:
      for (std::string& line : lines) {
        raw(line);
      }
      return;
    default: {
      std::string call = sub.arguments != nullptr ? "G65 P" + name : "M98 P" + name;
      for (std::size_t i = 0; i < arguments.size(); ++i) {
        call += " " + std::string(1, sub.letters[i]) + literal(arguments[i]);
      }
      lines.insert(lines.begin(), "O" + name);
      lines.push_back("M99");
      block(call);
      break;
    }
  }
  sub.arguments = nullptr;
  m_subs.emplace_back(name, std::move(sub));
}

std::string Writer::plainFeed(const PlacedMove& placed) {
  if (placed.move.kind == PathMove::Kind::Rapid) {
    return " FMAX";
  }
  if (placed.move.feed == m_feed && !takes(Feature::Repeated, 0.2)) {
    return "";
  }
  m_feed = placed.move.feed;
  return " F" + number(m_feed);
}

std::string Writer::plainEnd(const PlacedMove& placed, bool isArc) {
  const Vec3 from = frame().programmed(m_at);
  const Vec3 to = frame().programmed(placed.move.end);
  std::string text;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double moved = to[axis] - from[axis];
    const bool inPlane = isArc && static_cast<int>(axis) != m_modal.plane;
    const bool again = takes(Feature::Repeated, 0.15) && !isArc;
    if (std::abs(moved) < 1e-10 && !m_fresh && !again && !inPlane) {
      continue;
    }
    const bool increment = !m_fresh && takes(Feature::Increments, 0.3);
    const std::string value = number(increment ? moved : to[axis]);
    const bool isSigned = value[0] == '-' || value[0] == '+';
    text += std::string(" ") + (increment ? "I" : "") + kAxes[axis] + (isSigned ? "" : "+") + value;
  }
  return text;
}

void Writer::plainLine(const PlacedMove& placed) {
  const Vec3 to = frame().programmed(placed.move.end);
  const Vec3 from = frame().programmed(m_at);
  std::string text;
  if (!m_fresh && takes(Feature::Polar, 0.12)) {
    const int plane = m_modal.plane;
    Vec3 pole;
    for (const int axis : {firstOf(plane), secondOf(plane)}) {
      pole.set(at(axis), std::round(uniform(Feature::Polar) * 1000.0) / 10.0);
      text += std::string(" ") + kAxes[at(axis)] + "+" + plain(pole[at(axis)]);
    }
    block("CC" + text);
    const auto [radius, angle] = polarOf(to, pole, plane);
    text = "LP PR+" + plain(radius) + " PA" + (angle < 0 ? "" : "+") + plain(angle);
    if (std::abs(to[at(plane)] - from[at(plane)]) > 1e-10) {
      text += std::string(" ") + kAxes[at(plane)] + (to[at(plane)] < 0 ? "" : "+") +
              plain(to[at(plane)]);
    }
  } else {
    text = "L" + plainEnd(placed, false);
  }
  text += takes(Feature::Repeated, 0.5) ? " R0" : "";
  text += plainFeed(placed);
  block(text);
  arrive(placed);
}

void Writer::plainArc(const PlacedMove& placed) {
  const Frame now = frame();
  const int plane = now.planeOf(placed.plane);
  usePlane(plane);
  const Vec3 from = now.programmed(m_at);
  const Vec3 to = now.programmed(placed.move.end);
  const Vec3 centre = now.programmed(placed.move.centre);
  const Vec3 soon = now.programmed(
      turned(m_at, placed.move.centre, placed.plane, std::copysign(10.0, placed.signedSweep)));
  const bool counter = base::cross(from - centre, soon - centre)[at(plane)] > 0.0;
  const double sweep = placed.move.sweepDeg;
  const bool isFull = sweep == 360.0;
  const bool rises = std::abs(to[at(plane)] - from[at(plane)]) > 1e-10;
  const std::string turn = counter ? " DR+" : " DR-";
  const Vec3 tangent = base::cross(placed.move.axis, m_at - placed.move.centre);
  const bool goesOn = base::norm(m_direction) > 0.5 && !rises && !isFull && !m_fresh &&
                      base::norm(base::cross(m_direction, tangent)) < 1e-12 * base::norm(tangent) &&
                      base::dot(m_direction, tangent) > 0.0;
  if (goesOn && takes(Feature::Tangent, 0.5)) {
    const std::string end = plainEnd(placed, true);
    block("CT" + end + plainFeed(placed));
    arrive(placed);
    return;
  }
  if (!rises && !isFull && takes(Feature::ArcRadius, 0.3)) {
    const double radius = base::norm(centre - from);
    const std::string end = plainEnd(placed, true);
    block("CR" + end + " R" + (sweep > 180.0 ? "-" : "+") + plain(radius) + turn +
          plainFeed(placed));
    arrive(placed);
    return;
  }
  std::string pole = "CC";
  for (const int axis : {firstOf(plane), secondOf(plane)}) {
    const double value = centre[at(axis)];
    pole += std::string(" ") + kAxes[at(axis)] + (value < 0 ? "" : "+") + plain(value);
  }
  block(pole);
  if (rises || isFull || takes(Feature::Polar, 0.2)) {
    std::string text = "CP";
    const double angle = polarOf(to, centre, plane).second;
    if (rises || isFull || below(Feature::Polar, 2) == 0) {
      text += " IPA" + std::string(counter ? "+" : "-") + plain(sweep);
    } else {
      text += " PA" + std::string(angle < 0 ? "" : "+") + plain(angle);
    }
    if (rises || m_fresh) {
      const double height = to[at(plane)];
      text += std::string(" ") + kAxes[at(plane)] + (height < 0 ? "" : "+") + plain(height);
    }
    block(text + turn + plainFeed(placed));
  } else {
    const std::string end = plainEnd(placed, true);
    block("C" + end + turn + plainFeed(placed));
  }
  arrive(placed);
}

void Writer::beginProgram() {
  switch (m_control) {
    case Control::Sinumerik:
      block("G17 G40 G54 G64 G71 G90 G94");
      break;
    case Control::Heidenhain:
      block("TOOL CALL 1 Z S1000");
      break;
    case Control::Grbl:
      block("G17 G21 G90 G94");
      break;
    case Control::LinuxCnc:
      block("G17 G21 G40 G49 G54 G80 G90 G91.1 G94");
      break;
    default:
      block("G17 G21 G40 G49 G80 G90 G94");
      break;
  }
}

Written Writer::write() {
  m_placed = placeAll(m_moves);
  m_body = &m_main;
  beginProgram();
  for (std::size_t index = 0; index < m_moves.size();) {
    m_id = m_moves[index].id;
    if (index > 0 && !is(Control::Grbl) && takes(Feature::Call, 0.08)) {
      index = writeCall(index);
    } else {
      writeGroup(index++);
    }
  }
  m_id = 0;
  const bool hasHeader = program(Feature::Header, 0.5);
  const bool archive = is(Control::Sinumerik) && below(Feature::Header, 2) == 0;
  std::vector<std::string> lines;
  std::map<std::string, std::string, std::less<>> beside;
  const auto add = [&lines](const std::vector<std::string>& more) {
    lines.insert(lines.end(), more.begin(), more.end());
  };
  std::string end = below(Feature::Header, 2) == 0 ? "M30" : "M2";
  switch (m_control) {
    case Control::Sinumerik:
      if (hasHeader || (archive && !m_subs.empty())) {
        add({"%_N_DRAWN_MPF", ";$PATH=/_N_MPF_DIR"});
        m_used.insert(Feature::Header);
      }
      add(m_main.lines);
      add({end});
      for (const auto& [name, sub] : m_subs) {
        if (archive) {
          add({"%_N_" + name + "_SPF", ";$PATH=/_N_SPF_DIR"});
          add(sub.lines);
        } else {
          std::string text;
          for (const std::string& line : sub.lines) {
            text += line + "\n";
          }
          m_beside[name] = text;
        }
      }
      break;
    case Control::Heidenhain:
      add({"BEGIN PGM DRAWN MM"});
      if (below(Feature::Header, 2) == 0) {
        add({"BLK FORM 0.1 Z X-100 Y-100 Z-50", "BLK FORM 0.2 X+100 Y+100 Z+0"});
      }
      add(m_main.lines);
      if (!m_subs.empty()) {
        add({"M30"});
      }
      for (const auto& [name, sub] : m_subs) {
        add(sub.lines);
      }
      add({"END PGM DRAWN MM"});
      break;
    case Control::LinuxCnc:
    case Control::Grbl:
      if (hasHeader) {
        add({"%"});
      }
      for (const auto& [name, sub] : m_subs) {
        add(sub.lines);
      }
      add(m_main.lines);
      add({hasHeader && below(Feature::Header, 2) == 0 ? "%" : end});
      break;
    default:
      if (hasHeader) {
        add({"%"});
      }
      if (hasHeader || !m_subs.empty()) {
        add({"O1234 (DRAWN)"});
      }
      add(m_main.lines);
      add({"M30"});
      for (const auto& [name, sub] : m_subs) {
        add(sub.lines);
      }
      if (hasHeader) {
        add({"%"});
      }
      break;
  }
  const std::size_t lineEnd = program(Feature::LineEnds, 0.3) ? 1 + below(Feature::LineEnds, 2) : 0;
  const bool lower = !isIso() && !isPlain() && program(Feature::LowerCase, 0.15);
  Written written;
  for (std::string line : lines) {
    const bool isHeader = line.starts_with("%_N_") || line.starts_with(";$");
    if (lower && !isHeader) {
      for (char& c : line) {
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
      }
    }
    written.text += line + (lineEnd == 0 ? "\n" : lineEnd == 1 ? "\r\n" : "\r");
  }
  for (const auto& [name, text] : m_beside) {
    written.beside[upperName(name)] = text;
  }
  written.used = m_used;
  return written;
}

}  // namespace

Written writePath(const std::vector<DrawnMove>& moves, const Spelling& spelling) {
  return Writer(moves, spelling).write();
}

}  // namespace rivulet::tests
