// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/rs274/program_drawer.h"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

#include "base/random.h"

namespace rivulet::tests {

namespace {

using Words = std::vector<std::string>;

/// Letters of a plane: its axes, and the words of a centre in it.
struct Plane {
  int g = 17;
  char first = 'X';
  char second = 'Y';
  char third = 'Z';
  char firstCentre = 'I';
  char secondCentre = 'J';
};
constexpr std::array kPlanes{Plane{17, 'X', 'Y', 'Z', 'I', 'J'}, Plane{18, 'Z', 'X', 'Y', 'K', 'I'},
                             Plane{19, 'Y', 'Z', 'X', 'J', 'K'}};

class Drawer {
 public:
  explicit Drawer(base::Random random)
      : m_random(random),
        m_lowerCase(chance(0.15)),
        m_blanksInside(chance(0.12)),
        m_noBlanks(chance(0.3)),
        m_numbered(chance(0.2)),
        m_calculates(chance(0.4)) {}

  std::string draw() {
    const bool percent = chance(0.1);
    head();
    const int statements = 2 + below(9);
    for (int i = 0; i < statements; ++i) {
      statement(2);
    }
    // Behind the second % nothing is read.
    m_lines.push_back(percent && m_behindEnd.empty() ? "%" : cased(chance(0.5) ? "M2" : "M30"));
    for (const std::string& line : m_behindEnd) {
      m_lines.push_back(line);
    }
    // Where the axes stand at the beginning, Rivulet does not know.
    std::string text = percent ? "%\n" : "";
    text += "G0 X0 Y0 Z0 A0 B0 C0\n";
    for (const std::string& line : m_lines) {
      text += line + "\n";
    }
    return text;
  }

 private:
  // --- chance -----------------------------------------------------------------------------------

  bool chance(double share) { return m_random.uniform() < share; }
  int below(int bound) {
    return static_cast<int>(m_random.below(static_cast<std::uint64_t>(bound)));
  }
  double between(double low, double high) { return low + (high - low) * m_random.uniform(); }
  template <class T>
  T oneOf(std::initializer_list<T> values) {
    return *(values.begin() + below(static_cast<int>(values.size())));
  }

  // --- spelling ---------------------------------------------------------------------------------

  [[nodiscard]] std::string cased(std::string text) const {
    if (m_lowerCase) {
      for (char& c : text) {
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      }
    }
    return text;
  }

  /// The same value, as people and CAM systems write it.
  std::string spelled(double value, int decimals) {
    std::string text = fmt::format("{:.{}f}", value, decimals);
    if (text.find('.') != std::string::npos) {
      const int style = below(4);
      while (style != 0 && text.back() == '0') {
        text.pop_back();
      }
      if (text.back() == '.' && style != 1) {
        text.pop_back();
      }
    }
    const bool negative = text.front() == '-';
    std::string digits = negative ? text.substr(1) : text;
    if (digits.size() > 2 && digits[0] == '0' && digits[1] == '.' && chance(0.4)) {
      digits.erase(0, 1);
    } else if (chance(0.05)) {
      digits.insert(0, "0");
    }
    const bool isZero = digits.find_first_not_of("0.") == std::string::npos;
    return (negative && !isZero ? "-" : chance(0.05) ? "+" : "") + digits;
  }

  /// A coordinate: a number, or what comes to one.
  std::string value(double low = -40.0, double high = 40.0) {
    if (m_calculates && chance(0.25)) {
      switch (below(4)) {
        case 0:
          return variable();
        case 1:
          return fmt::format("[{}]", expression(1));
        default:
          return fmt::format("[[{}] MOD {}]", expression(2), spelled(between(5.0, high), 1));
      }
    }
    return spelled(between(low, high), oneOf({0, 1, 2, 3}));
  }

  std::string word(char letter, const std::string& text) {
    std::string made = fmt::format("{}{}", letter, text);
    const bool isNumber = text.find_first_of("[#") == std::string::npos;
    if (m_blanksInside && isNumber && chance(0.5)) {
      made.insert(1 + static_cast<std::size_t>(below(static_cast<int>(text.size()))), " ");
    }
    return made;
  }
  std::string g(double number) {
    std::string text = fmt::format("{}", number);
    if (text.size() == 1 && chance(0.2)) {
      text.insert(0, "0");
    }
    return "G" + text;
  }

  /// One line of words in any order.
  void block(Words words) {
    for (std::size_t i = words.size(); i > 1; --i) {
      std::swap(words[i - 1], words[static_cast<std::size_t>(below(static_cast<int>(i)))]);
    }
    if (chance(0.03)) {
      words.insert(words.begin() + below(static_cast<int>(words.size()) + 1),
                   oneOf<std::string>({"(a comment)", "(MSG, hello)", "(X5 Y7)", "()"}));
    }
    std::string line;
    for (const std::string& each : words) {
      line += (line.empty() || m_noBlanks ? "" : chance(0.05) ? "\t" : " ") + each;
    }
    if (m_numbered && chance(0.8)) {
      m_number += 10;
      line = fmt::format("N{}{}{}", m_number, m_noBlanks ? "" : " ", line);
    }
    if (chance(0.02)) {
      line.insert(0, "/");
    }
    if (chance(0.03)) {
      line += oneOf<std::string>({" ; at the end", ";X3", " (first) (second)", "   "});
    }
    m_lines.push_back(line.find_first_of("(;") == std::string::npos ? cased(line) : line);
  }
  void plain(std::string line) { m_lines.push_back(cased(std::move(line))); }

  // --- variables and expressions ----------------------------------------------------------------

  std::string variable() {
    if (!m_calculates) {
      return spelled(between(-9.0, 9.0), 1);
    }
    if (m_inSub) {
      return oneOf<std::string>({"#1", "#2", "#3", "#30", "#<_size>", "#100"});
    }
    return oneOf<std::string>({"#1", "#2", "#3", "#[1+1]", "#<size>", "#<_size>", "#100",
                               "#< Some Name >", "##4", chance(0.05) ? "#31" : "#3",
                               chance(0.1) ? "#5220" : "#1"});
  }

  std::string operand(int depth) {
    if (chance(0.3)) {
      return variable();
    }
    if (depth == 0 || chance(0.35)) {
      return spelled(between(-9.0, 9.0), oneOf({0, 1, 2}));
    }
    switch (below(14)) {
      case 0:
        return fmt::format("ABS[{}]", expression(depth - 1));
      case 1:
        return fmt::format("SQRT[ABS[{}]]", expression(depth - 1));
      case 2:
        return fmt::format("SIN[{}]", expression(depth - 1));
      case 3:
        return fmt::format("COS[{}]", expression(depth - 1));
      case 4:
        return fmt::format("TAN[{}]", spelled(between(-60.0, 60.0), 1));
      case 5:
        return fmt::format("ATAN[{}]/[{}]", expression(depth - 1), expression(depth - 1));
      case 6:
        return fmt::format("{}[{}]", oneOf({"ASIN", "ACOS"}), spelled(between(-1.0, 1.0), 2));
      case 7:
        return fmt::format("EXP[{}]", spelled(between(-2.0, 2.0), 1));
      case 8:
        return fmt::format("LN[{}]", spelled(between(0.1, 20.0), 1));
      case 9:
        return fmt::format("ROUND[{}]", expression(depth - 1));
      case 10:
        return fmt::format("{}[{}]", oneOf({"FIX", "FUP"}), expression(depth - 1));
      case 11:
        return fmt::format("EXISTS[{}]", oneOf({"#<size>", "#<nobody>", "#<_size>"}));
      default:
        return fmt::format("[{}]", expression(depth - 1));
    }
  }

  std::string expression(int depth) {
    std::string text = operand(depth);
    for (int more = below(3); more > 0; --more) {
      const std::string blank = chance(0.5) ? " " : "";
      switch (below(18)) {
        case 0:
        case 1:
        case 2:
          text += blank + "+" + blank + operand(depth);
          break;
        case 3:
        case 4:
        case 5:
          text += blank + "-" + blank + operand(depth);
          break;
        case 6:
        case 7:
          text += blank + "*" + blank + operand(depth);
          break;
        case 8:
          text += blank + "/" + blank + spelled(between(1.0, 9.0), 1);
          break;
        case 9:
          text += " MOD " + spelled(between(1.0, 9.0), 1);
          break;
        case 10:
          text = fmt::format("[{}]{}**{}{}", text, blank, blank, oneOf({"2", "3", "0", "1"}));
          break;
        case 11:
        case 12:
          text +=
              fmt::format(" {} {}", oneOf({"EQ", "NE", "GT", "GE", "LT", "LE"}), operand(depth));
          break;
        case 13:
          text += fmt::format(" {} {}", oneOf({"AND", "OR", "XOR"}), operand(depth));
          break;
        default:
          break;
      }
    }
    return text;
  }

  std::string condition() {
    return fmt::format("[{} {} {}]", operand(1), oneOf({"EQ", "NE", "GT", "GE", "LT", "LE"}),
                       operand(1));
  }

  std::string assignment() {
    const std::string target =
        !m_calculates ? oneOf<std::string>({"#1", "#100", "#<_size>"})
        : m_inSub
            ? oneOf<std::string>({"#1", "#2", "#30", "#<_size>", "#100", "#<inner>"})
            : oneOf<std::string>({"#1", "#2", "#3", "#<size>", "#<_size>", "#100", "#<SomeName>"});
    const std::string blank = chance(0.3) ? " " : "";
    return target + blank + "=" + blank +
           (chance(0.5) ? spelled(between(-20.0, 20.0), 1) : fmt::format("[{}]", expression(2)));
  }

  // --- the beginning ----------------------------------------------------------------------------

  void head() {
    if (chance(0.3)) {
      plain("(drawn)");
    }
    if (chance(0.6)) {
      block({g(21), g(90), g(17)});
    }
    if (m_calculates) {
      plain("#1=" + spelled(between(-9.0, 9.0), 2));
      plain("#2=" + spelled(between(1.0, 9.0), 1));
      plain("#3=3 #4=2");
      plain("#<size>=" + spelled(between(2.0, 20.0), 1));
      plain("#<_size>=" + spelled(between(2.0, 20.0), 1));
      plain("#<somename>=4 #100=" + spelled(between(-20.0, 20.0), 1));
    }
    if (chance(0.25)) {
      subprogram();
    }
    Words start{g(0), word('X', spelled(between(-20.0, 20.0), 1)),
                word('Y', spelled(between(-20.0, 20.0), 1)),
                word('Z', spelled(between(5.0, 20.0), 1))};
    if (chance(0.05)) {
      start.pop_back();
    }
    block(start);
    if (chance(0.97)) {
      block({word('F', spelled(between(50.0, 900.0), 0))});
      m_hasFeed = true;
    }
  }

  // --- statements -------------------------------------------------------------------------------

  /// @param depth  of structures still allowed
  void statement(int depth) {
    using Draw = void (Drawer::*)();
    struct Kind {
      int weight;
      Draw draw;
    };
    static constexpr std::array kKinds{
        Kind{26, &Drawer::line},      Kind{16, &Drawer::arc},        Kind{5, &Drawer::distance},
        Kind{3, &Drawer::units},      Kind{4, &Drawer::plane},       Kind{3, &Drawer::spline},
        Kind{3, &Drawer::diameter},   Kind{5, &Drawer::setPosition}, Kind{2, &Drawer::localOffset},
        Kind{1, &Drawer::workOffset}, Kind{1, &Drawer::machineMove}, Kind{2, &Drawer::toolLength},
        Kind{3, &Drawer::blending},   Kind{4, &Drawer::cycle},       Kind{5, &Drawer::feedMode},
        Kind{4, &Drawer::savedState}, Kind{7, &Drawer::assign},      Kind{4, &Drawer::comment},
        Kind{4, &Drawer::polar},      Kind{1, &Drawer::junk},        Kind{4, &Drawer::machineWords},
        Kind{4, &Drawer::rotary},
    };
    if (depth > 0 && chance(0.12)) {
      structure(depth - 1);
      return;
    }
    if (m_subs > 0 && !m_inSub && chance(0.15)) {
      call();
      return;
    }
    int sum = 0;
    for (const Kind& kind : kKinds) {
      sum += kind.weight;
    }
    int drawn = below(sum);
    for (const Kind& kind : kKinds) {
      drawn -= kind.weight;
      if (drawn < 0) {
        (this->*kind.draw)();
        return;
      }
    }
  }

  [[nodiscard]] const Plane& inPlane() const { return kPlanes[m_plane]; }

  /// F where the feed mode needs one, and sometimes where not.
  void addFeed(Words& words) {
    if (m_inverse || chance(m_hasFeed ? 0.15 : 0.9)) {
      words.push_back(word('F', m_perTurn     ? spelled(between(0.05, 0.9), 2)
                                : m_inverse   ? spelled(between(1.0, 30.0), 1)
                                : chance(0.1) ? value(50.0, 900.0)
                                              : spelled(between(50.0, 900.0), oneOf({0, 1, 2}))));
      m_hasFeed = true;
    }
  }

  void line() {
    Words words;
    if (m_cycle || m_motion < 0 || chance(0.6)) {
      m_motion = chance(0.3) ? 0 : 1;
      m_cycle = false;
      words.push_back(g(m_motion));
    }
    if (m_motion > 1) {
      m_motion = 1;
      words.push_back(g(1));
    }
    for (const char axis : {'X', 'Y', 'Z'}) {
      if (chance(0.55)) {
        words.push_back(word(axis, value()));
      }
    }
    if (m_motion == 1) {
      addFeed(words);
    }
    if (chance(0.05)) {
      words.push_back(oneOf<std::string>({"M3", "M5", "M8", "S500", "G61", "G40"}));
    }
    if (chance(0.05)) {
      words.push_back(assignment());
    }
    if (words.empty()) {
      words.push_back(word('X', value()));
    }
    block(words);
  }

  void rotary() {
    m_motion = chance(0.4) ? 0 : 1;
    m_cycle = false;
    Words words{g(m_motion), word(oneOf({'A', 'B', 'C'}), value(-200.0, 200.0))};
    if (chance(0.5)) {
      words.push_back(word(oneOf({'X', 'Y', 'Z'}), value()));
    }
    if (m_motion == 1) {
      addFeed(words);
    }
    block(words);
  }

  void distance() {
    if (chance(0.25)) {
      m_absoluteCentre = chance(0.5);
      block({g(m_absoluteCentre ? 90.1 : 91.1)});
      return;
    }
    m_relative = !m_relative;
    Words words{g(m_relative ? 91 : 90)};
    if (!m_cycle && m_motion == 0 && chance(0.4)) {
      words.push_back(word('X', value()));
    }
    block(words);
  }

  void units() {
    m_inches = !m_inches;
    Words words{g(m_inches ? 20 : 21)};
    if (chance(0.3) && m_motion == 0 && !m_cycle) {
      words.push_back(word('Y', value(-3.0, 3.0)));
    }
    block(words);
  }

  void plane() {
    m_plane = static_cast<std::size_t>(below(3));
    block({g(inPlane().g)});
  }

  void diameter() {
    m_diameter = !m_diameter;
    block({g(m_diameter ? 7 : 8)});
  }

  // --- arcs -------------------------------------------------------------------------------------

  /// X counts as a diameter under G7.
  std::string coordinate(char axis, double value) {
    return word(axis, spelled(axis == 'X' && m_diameter ? 2.0 * value : value, 6));
  }

  void arc() {
    if (chance(0.2)) {
      plane();
    }
    const Plane& in = inPlane();
    const double startFirst = std::round(between(-20.0, 20.0));
    const double startSecond = std::round(between(-20.0, 20.0));
    const double centreFirst = std::round(between(-100.0, 100.0)) / 10.0;
    const double centreSecond = 0.5 + std::round(between(0.0, 100.0)) / 10.0;
    const double turn = between(0.2, 2.0 * std::numbers::pi - 0.2);
    const double endFirst =
        centreFirst - centreFirst * std::cos(turn) + centreSecond * std::sin(turn);
    const double endSecond =
        centreSecond - centreFirst * std::sin(turn) - centreSecond * std::cos(turn);
    const bool relative = m_relative;
    const bool atKnownPlace = !relative;
    if (atKnownPlace) {
      Words to{g(90), g(1), coordinate(in.first, startFirst), coordinate(in.second, startSecond)};
      addFeed(to);
      block(to);
    }
    m_motion = 2 + below(2);
    m_cycle = false;
    Words words{g(m_motion)};
    // What holds after branches and saved states is not followed.
    if (chance(0.7)) {
      words.push_back(g(in.g));
      words.push_back(g(relative ? 91 : 90));
    }
    if (chance(0.25)) {
      words.push_back(word(in.third, value(-10.0, 10.0)));
    }
    if (chance(0.06)) {
      words.push_back(word('P', fmt::format("{}", 1 + below(3))));
    }
    addFeed(words);
    const bool absoluteCentre = m_absoluteCentre && atKnownPlace;
    if (m_absoluteCentre && !atKnownPlace) {
      words.push_back(g(91.1));
      m_absoluteCentre = false;
    }
    const auto centre = [&] {
      words.push_back(
          word(in.firstCentre, spelled(centreFirst + (absoluteCentre ? startFirst : 0.0), 6)));
      words.push_back(
          word(in.secondCentre, spelled(centreSecond + (absoluteCentre ? startSecond : 0.0), 6)));
    };
    const auto end = [&] {
      words.push_back(coordinate(in.first, endFirst + (atKnownPlace ? startFirst : 0.0)));
      words.push_back(coordinate(in.second, endSecond + (atKnownPlace ? startSecond : 0.0)));
    };
    switch (below(5)) {
      case 0:  // a full turn
        centre();
        break;
      case 1: {  // by its radius
        const double chord = std::hypot(endFirst, endSecond);
        end();
        words.push_back(
            word('R', spelled((chance(0.3) ? -1.0 : 1.0) * chord * between(0.52, 2.0), 4)));
        break;
      }
      case 2:  // one of the centre's words, a half turn
        words.push_back(
            word(in.secondCentre, spelled(centreSecond + (absoluteCentre ? startSecond : 0.0), 4)));
        if (absoluteCentre) {
          words.push_back(word(in.firstCentre, spelled(startFirst, 1)));
        }
        words.push_back(
            coordinate(in.second, 2.0 * centreSecond + (atKnownPlace ? startSecond : 0.0)));
        break;
      default:
        centre();
        end();
        break;
    }
    block(words);
  }

  void polar() {
    if (m_plane != 0 && chance(0.9)) {
      m_plane = 0;
      block({g(17)});
    }
    m_motion = chance(0.5) ? 0 : 1;
    m_cycle = false;
    Words words{g(m_motion)};
    if (chance(0.8)) {
      words.push_back(word('@', spelled(between(1.0, 30.0), 1)));
    }
    if (chance(0.8)) {
      words.push_back(word('^', spelled(between(-180.0, 360.0), 1)));
    }
    if (chance(0.3)) {
      words.push_back(word(inPlane().third, value()));
    }
    if (m_motion == 1) {
      addFeed(words);
    }
    block(words);
  }

  void spline() {
    if (m_plane != 0) {
      m_plane = 0;
      block({g(17)});
    }
    if (m_inverse && chance(0.8)) {
      feedMode();
    }
    const auto offset = [this](char letter) {
      return word(letter, spelled(between(-9.0, 9.0), 1));
    };
    switch (below(4)) {
      case 0:
        block({g(5.1), word('X', value()), word('Y', value()), offset('I'), offset('J')});
        break;
      case 1: {
        block({"G5.2", word('X', value()), word('Y', value()), "P1", "L3"});
        for (int more = 1 + below(4); more >= 0; --more) {
          block({word('X', value()), word('Y', value()), word('P', spelled(between(0.5, 2.0), 1))});
        }
        block({g(5.3)});
        break;
      }
      default:
        block({g(5), word('X', value()), word('Y', value()), offset('I'), offset('J'), offset('P'),
               offset('Q')});
        if (chance(0.4)) {
          block({g(5), word('X', value()), word('Y', value()), offset('P'), offset('Q')});
        }
        break;
    }
    m_motion = -1;
    line();
  }

  // --- offsets ----------------------------------------------------------------------------------

  void setPosition() {
    switch (below(5)) {
      case 0:
        block({oneOf<std::string>({"G92.1", "G92.2", "G92.3"})});
        break;
      default: {
        Words words{g(92), word(oneOf({'X', 'Y', 'Z'}), value())};
        if (chance(0.3)) {
          words.push_back(word(oneOf({'A', 'B', 'C'}), value()));
        }
        block(words);
      }
    }
  }

  void localOffset() { block({g(52), word(oneOf({'X', 'Y', 'Z'}), chance(0.3) ? "0" : value())}); }

  void workOffset() {
    switch (below(4)) {
      case 0:
        block({g(10), "L2", word('P', fmt::format("{}", below(3))), word('X', value()),
               word('R', chance(0.5) ? "0" : "30")});
        break;
      case 1:
        block({g(10), "L20", word('P', fmt::format("{}", below(3))), word('Y', value())});
        break;
      default:
        block({oneOf<std::string>(
            {"G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"})});
        break;
    }
  }

  void machineMove() {
    if (chance(0.3)) {
      block({oneOf<std::string>({"G28", "G30", "G28.1", "G30.1"})});
      return;
    }
    m_motion = chance(0.8) ? 0 : 1;
    m_cycle = false;
    block({g(53), g(m_motion), word(oneOf({'X', 'Y', 'Z'}), value())});
  }

  /// The length is the control's: where a block behind does not name Z, Rivulet does not know it.
  void toolLength() {
    block({word('T', fmt::format("{}", 1 + below(3))), "M6"});
    Words words = chance(0.2)   ? Words{g(43.1), word('Z', value(0.0, 30.0))}
                  : chance(0.3) ? Words{g(49)}
                                : Words{g(43), word('H', fmt::format("{}", 1 + below(3)))};
    if (words.front() == "G43.1") {
      block(words);
      words.clear();
    }
    words.push_back(g(90));
    words.push_back(g(0));
    words.push_back(word('Z', value()));
    m_relative = false;
    m_motion = 0;
    m_cycle = false;
    block(words);
  }

  void savedState() {
    switch (below(16)) {
      case 0:
        block({"M72"});
        break;
      case 1:
        block({"M71"});
        break;
      case 2:
        block({"M73"});
        break;
      default:
        block({"M70"});
        if (chance(0.6)) {
          const bool relative = m_relative;
          const bool inches = m_inches;
          const std::size_t inPlane = m_plane;
          const bool isDiameter = m_diameter;
          const bool absoluteCentre = m_absoluteCentre;
          distance();
          if (chance(0.5)) {
            units();
          }
          line();
          block({"M72"});
          m_relative = relative;
          m_inches = inches;
          m_plane = inPlane;
          m_diameter = isDiameter;
          m_absoluteCentre = absoluteCentre;
        }
        break;
    }
  }

  // --- how it moves -----------------------------------------------------------------------------

  void blending() {
    block(chance(0.4) ? Words{oneOf<std::string>({"G61", "G61.1", "G64"})}
          : chance(0.5)
              ? Words{g(64), word('P', spelled(between(0.01, 0.5), 2))}
              : Words{g(64), word('P', "0.1"), word('Q', spelled(between(0.01, 0.5), 2))});
  }

  void feedMode() {
    m_perTurn = false;
    m_inverse = false;
    switch (below(5)) {
      case 0:
      case 1:
        m_inverse = true;
        m_hasFeed = false;
        block({g(93)});
        break;
      case 2:
        m_perTurn = true;
        m_hasFeed = true;
        block({"M3", word('S', spelled(between(100.0, 2000.0), 0))});
        block({g(95), word('F', spelled(between(0.05, 0.9), 2))});
        break;
      case 3:
        if (chance(0.4)) {
          block(chance(0.5) ? Words{g(96), "D2000", word('S', "150")}
                            : Words{g(97), word('S', "800")});
          break;
        }
        [[fallthrough]];
      default:
        block({g(94), word('F', spelled(between(50.0, 900.0), 0))});
        m_hasFeed = true;
        break;
    }
  }

  void machineWords() {
    switch (below(8)) {
      case 0:
        block({g(4), word('P', spelled(between(0.1, 3.0), 1))});
        break;
      case 1:
        block({"M3", word('S', spelled(between(100.0, 2000.0), 0))});
        break;
      case 2:
        block({oneOf<std::string>({"M4 S100", "M5", "M7", "M8", "M9"})});
        break;
      case 3:
        block({oneOf<std::string>({"M48", "M49", "M50", "M51", "M52 P1", "M53 P1"})});
        break;
      case 4:
        block({oneOf<std::string>(
            {"M62 P1", "M63 P1", "M64 P0", "M65 P0", "M67 E0 Q1", "M68 E0 Q1"})});
        break;
      case 5:
        block({oneOf<std::string>({"M0", "M1", "M60"})});
        break;
      default:
        block({word('S', spelled(between(100.0, 2000.0), 0))});
        break;
    }
  }

  void cycle() {
    const char third = inPlane().third;
    const int number = oneOf({81, 82, 83, 73, 85, 86, 89, 81, 83, 82, 81, 81,
                              82, 83, 73, 85, 89, 81, 81, 82, 83, 73, 87});
    if (m_inverse) {
      feedMode();
    }
    if (number == 86) {
      block({"M3 S500"});
    }
    Words words{g(number),
                g(inPlane().g),
                word(inPlane().first, value(-9.0, 9.0)),
                word(inPlane().second, value(-9.0, 9.0)),
                word(third, spelled(between(-9.0, -1.0), 1)),
                word('R', spelled(between(1.0, 5.0), 1))};
    if (number == 82 || number == 86 || number == 89) {
      words.push_back(word('P', "0.5"));
    }
    if (number == 83 || number == 73) {
      words.push_back(word('Q', spelled(between(1.0, 4.0), 1)));
    }
    if (chance(0.9)) {  // without, LinuxCNC takes G99
      words.push_back(g(chance(0.5) ? 98 : 99));
    }
    if (chance(0.15)) {
      words.push_back(word('L', fmt::format("{}", 1 + below(3))));
    }
    addFeed(words);
    block(words);
    m_cycle = true;
    m_motion = number;
    for (int more = below(3); more > 0; --more) {
      Words further{word(inPlane().first, value(-9.0, 9.0))};
      if (chance(0.3)) {
        further.push_back(word(third, spelled(between(-9.0, -1.0), 1)));
      }
      if (m_inverse) {
        addFeed(further);
      }
      block(further);
    }
    if (chance(0.8)) {
      block({g(80)});
      m_motion = -1;
    }
  }

  // --- calculations and order -------------------------------------------------------------------

  void assign() {
    if (chance(0.3) && !m_cycle) {
      m_motion = 0;
      block({assignment(), g(0), word('X', variable())});
      return;
    }
    block({assignment()});
  }

  void comment() {
    plain(oneOf<std::string>({"(a comment)", "; a comment", "(MSG, text with X5 Y3)", "", "  ",
                              "(DEBUG, value is #1)", "(LOG, #1)", "(an ; inside)"}));
  }

  void structure(int depth) {
    const std::string name =
        chance(0.3) ? fmt::format("O<part{}>", ++m_names) : fmt::format("O{}", 100 + ++m_names);
    const auto statements = [&](int most) {
      for (int count = 1 + below(most); count > 0; --count) {
        statement(depth);
      }
    };
    switch (below(5)) {
      case 0:
        plain(fmt::format("{} repeat [{}]", name, below(4)));
        statements(2);
        plain(fmt::format("{} endrepeat", name));
        break;
      case 1: {
        const std::string counter = m_inSub ? "#20" : fmt::format("#<n{}>", m_names);
        plain(fmt::format("{}=0", counter));
        plain(fmt::format("{} while [{} LT {}]", name, counter, 1 + below(3)));
        plain(fmt::format("{0}=[{0}+1]", counter));
        statements(2);
        if (chance(0.2)) {
          const int inner = 100 + ++m_names;
          plain(fmt::format("O{} if [{} GT 1]", inner, counter));
          plain(fmt::format("{} {}", name, oneOf({"break", "continue"})));
          plain(fmt::format("O{} endif", inner));
          line();
        }
        plain(fmt::format("{} endwhile", name));
        break;
      }
      case 2: {
        const std::string counter = m_inSub ? "#21" : fmt::format("#<n{}>", m_names);
        plain(fmt::format("{}=0", counter));
        plain(fmt::format("{} do", name));
        plain(fmt::format("{0}=[{0}+1]", counter));
        statements(2);
        plain(fmt::format("{} while [{} LT {}]", name, counter, 1 + below(3)));
        break;
      }
      default:
        plain(fmt::format("{} if {}", name, condition()));
        statements(2);
        if (chance(0.3)) {
          plain(fmt::format("{} elseif {}", name, condition()));
          statements(1);
        }
        if (chance(0.5)) {
          plain(fmt::format("{} else", name));
          statements(1);
        }
        plain(fmt::format("{} endif", name));
        break;
    }
  }

  void subprogram() {
    m_inSub = true;
    const bool isFanuc = chance(0.15);
    m_subName = isFanuc || chance(0.5) ? fmt::format("O{}", 1000 + below(100)) : "O<work>";
    m_isFanuc = isFanuc;
    std::vector<std::string> before;
    before.swap(m_lines);
    if (isFanuc) {
      plain(m_subName);
    } else {
      plain(fmt::format("{} sub", m_subName));
    }
    if (m_calculates && !isFanuc) {
      plain("#30=[#1+#2]");
    }
    m_motion = -1;
    line();
    for (int count = below(3); count > 0; --count) {
      statement(1);
    }
    if (isFanuc) {
      plain("M99");
    } else {
      if (chance(0.2)) {
        const int inner = 100 + ++m_names;
        plain(fmt::format("O{} if {}", inner, condition()));
        plain(fmt::format("{} return [{}]", m_subName, below(9)));
        plain(fmt::format("O{} endif", inner));
      }
      plain(chance(0.2) ? fmt::format("{} endsub [#1]", m_subName)
                        : fmt::format("{} endsub", m_subName));
    }
    if (isFanuc || chance(0.15)) {
      m_behindEnd.swap(m_lines);
      m_lines.swap(before);
    } else {
      before.insert(before.end(), m_lines.begin(), m_lines.end());
      m_lines.swap(before);
    }
    m_inSub = false;
    m_subs = 1;
    m_motion = -1;
  }

  void call() {
    m_motion = -1;
    if (m_isFanuc) {
      // Any other order of these words is refused.
      plain(fmt::format("M98 P{} L{}", m_subName.substr(1), 1 + below(2)));
      return;
    }
    std::string text = m_subName + " call";
    for (int count = m_calculates ? 3 : below(4); count > 0; --count) {
      text += fmt::format(
          " [{}]", m_calculates && chance(0.4) ? expression(1) : spelled(between(-9.0, 9.0), 1));
    }
    plain(text);
  }

  /// What LinuxCNC refuses, or takes in a way that is easily missed.
  void junk() {
    switch (below(10)) {
      case 0:
        block({g(0), "X1", "X2"});
        break;
      case 1:
        block({g(oneOf({41, 42})), "D1"});
        break;
      case 2:
        block({g(oneOf({65, 66, 77, 11, 16, 68, 70})), "X1"});
        break;
      case 3:
        block({g(0), g(1), "X3"});
        break;
      case 4:
        plain("G0 X1.2.3");
        break;
      case 5:
        plain("G0 X[1+2");
        break;
      case 6:
        block({g(1), "X5", "F0"});
        break;
      case 7:
        block({g(4), "P1", "X5"});
        break;
      case 8:
        plain("G1 X#<nobody>");
        break;
      default:
        block({g(2), "X5", "Y5"});
        break;
    }
  }

  base::Random m_random;
  bool m_lowerCase;
  bool m_blanksInside;
  bool m_noBlanks;
  bool m_numbered;
  bool m_calculates;
  int m_number = 0;
  std::vector<std::string> m_lines;
  std::vector<std::string> m_behindEnd;
  int m_names = 0;
  int m_subs = 0;
  std::string m_subName;
  bool m_isFanuc = false;
  bool m_inSub = false;
  // As far as it is known without following the program.
  int m_motion = -1;  ///< G0 to G3; -1: none
  bool m_cycle = false;
  bool m_relative = false;
  bool m_inches = false;
  bool m_diameter = false;
  bool m_absoluteCentre = false;
  std::size_t m_plane = 0;
  bool m_inverse = false;
  bool m_perTurn = false;
  bool m_hasFeed = false;
};

}  // namespace

std::string drawProgram(std::uint64_t seed, std::uint64_t number) {
  return Drawer(base::Random(seed).fork(number)).draw();
}

}  // namespace rivulet::tests
