// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What a block is, and the blocks that do not move: parameters, jumps, calls, tools.

#include "nc/dialects/heidenhain/control.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text.h"

namespace rivulet::nc::heidenhain {

namespace {

/// The rounds that the flow counts; a TNC repeats up to 65 534 times.
constexpr int kRoundsMax = 9999;

/// "TNC:\NC\PART.H" is PART.
std::string programName(std::string path) {
  path = base::toUpper(base::trim(path));
  if (const std::size_t folder = path.find_last_of("\\/:"); folder != std::string::npos) {
    path.erase(0, folder + 1);
  }
  if (const std::size_t point = path.rfind('.'); point != std::string::npos && point > 0) {
    path.resize(point);
  }
  return path;
}

Expected<Steering> withoutSteering(const Expected<void>& done) {
  return done ? Expected<Steering>(Steering()) : fail(done.error());
}

}  // namespace

Control::Control(const ToolRadius* toolRadius)
    : m_radiusOfMachine(toolRadius), m_at{std::nan(""), std::nan(""), std::nan("")} {
  m_rotary.fill(std::nan(""));
  m_parameters.setOfControl(109, -1.0);
}

void Control::enterProgram() {
  ++m_depth;
  m_parameters.enterProgram();
}

void Control::leaveProgram() {
  --m_depth;
  m_parameters.leaveProgram();
}

Steering Control::execute(std::string_view block, Place place, base::LineNumber line,
                          bool isSkipped) {
  m_block = {place, line, isSkipped};
  const std::string text = withoutComments(block);
  Scanner in(text, m_parameters, place);
  Expected<Steering> done = statement(in);
  if (done && std::holds_alternative<std::monostate>(*done) && !in.isAtEnd()) {
    done = in.fault<Steering>(FaultCode::RestNotUnderstood, std::string(base::trim(in.rest())));
  }
  if (!done) {
    report(std::move(done.error()));
    return {};
  }
  return std::move(*done);
}

Expected<Steering> Control::statement(Scanner& in) {
  using Read = Expected<void> (Control::*)(Scanner&);
  struct Row {
    std::string_view word;
    Read read;
  };
  static constexpr std::array kRows{
      Row{"LN", &Control::line},
      Row{"LP", &Control::polarLine},
      Row{"L", &Control::line},
      Row{"CC", &Control::circleCentre},
      Row{"CR", &Control::arcWithRadius},
      Row{"CP", &Control::polarArc},
      Row{"C", &Control::arcAboutCentre},
      Row{"CYCL", &Control::cycle},
      Row{"CYCLE", &Control::cycle},  // as some post-processors write it
      Row{"PLANE", &Control::plane},
      Row{"STOP", &Control::stop},
      Row{"TRANS", &Control::translate},
      Row{"APPR", &Control::approach},
      Row{"DEP", &Control::departure},
      Row{"PATTERN", &Control::pattern},
      Row{"FUNCTION", &Control::function},
  };
  if (const std::string name = in.takeParameter(); !name.empty()) {
    return withoutSteering(assignment(in, name));
  }
  if (in.takePrefix("QS")) {
    return withoutSteering(assignText(in));
  }
  for (const Row& row : kRows) {
    if (in.takeWord(row.word)) {
      return withoutSteering((this->*row.read)(in));
    }
  }
  if (in.takeWord("CTP") || in.takeWord("CT")) {
    return withoutSteering(tangentialArc(in, in.previous() == 'P'));
  }
  // RNDR5 as well: a letter may follow.
  if (in.takePrefix("RND") || in.takePrefix("CHF")) {
    return withoutSteering(corner(in, in.previous() == 'F'));
  }
  return namedStatement(in);
}

Expected<Steering> Control::namedStatement(Scanner& in) {
  const std::string first = in.takeName();
  if (first == "FN") {
    return functionNumber(in);
  }
  if (first == "BEGIN" || first == "END") {
    return in.takeWord("PGM") ? program(in, first == "BEGIN")
                              : in.fault<Steering>(FaultCode::UnknownWord, first);
  }
  if (first == "LBL") {
    // Only LBL 0 is not a label.
    in.skipRest();
    return Steering(LabelEnd{});
  }
  if (first == "CALL") {
    return callSomething(in);
  }
  if (first == "TOOL") {
    if (in.takeWord("CALL")) {
      return withoutSteering(toolCall(in));
    }
    return in.takeWord("DEF") ? withoutSteering(toolDefinition(in))
                              : in.fault<Steering>(FaultCode::UnknownWord, "TOOL");
  }
  if (first == "BLK") {
    Token token;
    token.kind = TokenKind::Name;
    token.column = m_block.place.column;
    token.text = "BLK";
    tell({token});
    in.skipRest();
    return Steering();
  }
  if (first == "M" || first == "F" || first == "S" || first == "FMAX" || first == "FAUTO") {
    // Words alone.
    in.goTo(0);
    in.skipBlanks();
    return withoutSteering(line(in));
  }
  // A word that this reader does not know.
  refuse(FaultCode::UnsupportedGCode, first.empty() ? in.nextText() : first);
  in.skipRest();
  return Steering();
}

Expected<Steering> Control::program(Scanner& in, bool isBegin) {
  const std::string_view rest = base::trim(in.rest());
  const std::size_t blank = rest.find_last_of(' ');
  const std::string_view last = blank == std::string_view::npos ? rest : rest.substr(blank + 1);
  in.skipRest();
  if (!isBegin) {
    if (m_depth > 0) {
      return Steering(ProgramEnd{});
    }
    tell({word('M', 30.0)});
    return Steering();
  }
  const bool isInch = last == "INCH";
  if (!isInch && last != "MM") {
    return in.fault<Steering>(FaultCode::UnknownWord, std::string(last));
  }
  if (m_depth > 0) {
    return isInch == m_isInch
               ? Expected<Steering>(Steering())
               : in.fault<Steering>(FaultCode::UnsupportedExpression, std::string(last));
  }
  m_isInch = isInch;
  m_parameters.setOfControl(113, isInch ? 1.0 : 0.0);
  tell({word('G', isInch ? 20.0 : 21.0)});
  return Steering();
}

// --- parameters ---------------------------------------------------------------------------------

Expected<void> Control::assignment(Scanner& in, const std::string& name) {
  if (!in.take('=')) {
    return in.fault<void>(FaultCode::EqualsMissing);
  }
  const Expected<double> value = in.formula();
  if (!value) {
    m_parameters.set(name, std::nan(""));
    return fail(value.error());
  }
  m_parameters.set(name, *value);
  return {};
}

/// QS1 = "text", and parts of it with ||. What else is made of texts is not followed.
Expected<void> Control::assignText(Scanner& in) {
  const std::optional<int> number = in.takeInteger();
  if (!number || !in.take('=')) {
    return in.fault<void>(FaultCode::EqualsMissing);
  }
  std::string text;
  do {
    const std::optional<Expected<std::string>> part = in.takeText();
    if (!part) {
      return in.fault<void>(FaultCode::UnsupportedExpression, in.nextText());
    }
    if (!*part) {
      return fail(part->error());
    }
    text += **part;
  } while (in.takePrefix("||"));
  m_parameters.setText(fmt::format("QS{}", *number), std::move(text));
  return {};
}

Expected<Steering> Control::functionNumber(Scanner& in) {
  const std::optional<int> number = in.takeInteger();
  if (!number) {
    return in.fault<Steering>(FaultCode::ValueMissing);
  }
  in.take(':');
  constexpr int kError = 14;
  constexpr int kPrint = 15;
  constexpr int kFilePrint = 16;
  constexpr int kAngle = 13;
  if (*number <= 8 || *number == kAngle) {
    const std::string name = in.takeParameter();
    if (name.empty()) {
      return in.fault<Steering>(FaultCode::ValueMissing);
    }
    const Expected<void> done = assignment(in, name);
    return done ? Expected<Steering>(Steering()) : fail(done.error());
  }
  if (*number <= 12) {
    return conditionalJump(in, *number);
  }
  if (*number == kError) {
    // The control stops with an error.
    in.takeWord("ERROR");
    in.take('=');
    const Expected<double> error = in.value();
    return in.fault<Steering>(FaultCode::StopsWithError,
                              error ? fmt::format("FN 14 {:.0f}", *error) : "FN 14");
  }
  const std::string name = fmt::format("FN {}", *number);
  if (*number == kPrint || *number == kFilePrint) {
    ignore(name);
  } else {
    // Reads and writes what belongs to the control: a parameter it sets is not known.
    while (!in.isAtEnd()) {
      if (const std::string parameter = in.takeParameter(); !parameter.empty()) {
        m_parameters.set(parameter, std::nan(""));
        break;
      }
      in.goTo(in.at() + 1);
    }
    refuse(FaultCode::UnsupportedGCode, name);
  }
  in.skipRest();
  return Steering();
}

Expected<Steering> Control::conditionalJump(Scanner& in, int function) {
  m_isLost = true;  // until it is known where this leads
  in.takeWord("IF");
  const Expected<double> left = in.value();
  if (!left) {
    return fail(left.error());
  }
  static constexpr std::array<std::string_view, 4> kWords{"EQU", "NE", "GT", "LT"};
  if (!in.takeWord(kWords[static_cast<std::size_t>(function - 9)])) {
    return in.fault<Steering>(FaultCode::IfMalformed);
  }
  const Expected<double> right = in.value();
  if (!right) {
    return fail(right.error());
  }
  if (!in.takeWord("GOTO") || !in.takeWord("LBL")) {
    return in.fault<Steering>(FaultCode::NoTarget);
  }
  Expected<std::string> label = labelName(in);
  if (!label) {
    return fail(label.error());
  }
  // What differs by the rounding of a calculation is equal.
  constexpr double kEqual = 1e-9;
  const bool isEqual =
      std::abs(*left - *right) <= kEqual * std::max({1.0, std::abs(*left), std::abs(*right)});
  const bool holds = function == 9    ? isEqual
                     : function == 10 ? !isEqual
                     : function == 11 ? !isEqual && *left > *right
                                      : !isEqual && *left < *right;
  m_isLost = false;
  if (!holds) {
    return Steering();
  }
  Jump jump;
  jump.label = std::move(*label);
  return Steering(std::move(jump));
}

Expected<std::string> Control::labelName(Scanner& in) {
  if (const std::optional<Expected<std::string>> text = in.takeText()) {
    return *text;
  }
  const std::optional<int> number = in.takeInteger();
  return number ? Expected<std::string>(fmt::format("{}", *number))
                : in.fault<std::string>(FaultCode::NoTarget);
}

Expected<Steering> Control::callSomething(Scanner& in) {
  if (in.takeWord("PGM")) {
    Call call;
    std::string_view path = base::trim(in.rest());
    if (path.size() > 1 && path.front() == '"' && path.back() == '"') {
      path = path.substr(1, path.size() - 2);
    }
    call.name = programName(std::string(path));
    call.sharesVariables = true;
    in.skipRest();
    return Steering(std::move(call));
  }
  if (!in.takeWord("LBL")) {
    refuse(FaultCode::UnsupportedGCode, "CALL " + in.nextText());
    in.skipRest();
    return Steering();
  }
  Expected<std::string> label = labelName(in);
  if (!label) {
    return fail(label.error());
  }
  if (!in.takePrefix("REP")) {
    return Steering(LabelCall{std::move(*label)});
  }
  in.skipBlanks();
  const Expected<double> times = in.value();
  if (!times) {
    return fail(times.error());
  }
  if (!(*times >= 0.0 && *times <= kRoundsMax) || *times != std::floor(*times)) {
    return in.fault<Steering>(FaultCode::OutOfRange, "REP");
  }
  if (in.take('/')) {
    (void)in.takeInteger();  // what older controls show as left
  }
  RepeatLabel repeat;
  repeat.label = std::move(*label);
  repeat.times = Expression::constant(*times);
  return Steering(std::move(repeat));
}

// --- tools --------------------------------------------------------------------------------------

/// The working plane is that across the tool axis (chapter "Fundamentals", "Reference system").
void Control::setToolAxis(std::size_t axis) {
  m_parameters.setOfControl(109, static_cast<double>(axis));
  if (axis != m_tool.axis) {
    m_tool.axis = axis;
    m_pole.place.reset();
  }
}

/// The program's own data come first (chapter "Tools", "Tool data": those of TOOL DEF).
void Control::setTool(std::optional<int> number, std::string_view name) {
  m_tool.radius.reset();
  if (const auto own = number ? m_tools.find(*number) : m_tools.end();
      own != m_tools.end() && own->second.radius) {
    m_tool.radius = own->second.radius;
  } else if (m_radiusOfMachine != nullptr && *m_radiusOfMachine) {
    m_tool.radius = (*m_radiusOfMachine)(number.value_or(0), name);
    constexpr double kInch = 25.4;
    if (m_tool.radius && m_isInch) {
      *m_tool.radius /= kInch;
    }
  }
}

/// Q108 is the radius with its allowance (chapter "Programming Q parameters", "Preassigned Q
/// parameters").
void Control::tellToolRadius() {
  m_parameters.setOfControl(
      108, m_tool.radius ? std::optional(*m_tool.radius + m_tool.radiusDelta) : std::nullopt);
}

Expected<Control::ToolChoice> Control::toolChoice(Scanner& in) {
  ToolChoice choice;
  if (const std::optional<Expected<std::string>> text = in.takeText()) {
    if (!*text) {
      return fail(text->error());
    }
    choice.name = **text;
  } else if (in.isAtValue()) {
    const Expected<double> tool = in.value();
    if (!tool) {
      return fail(tool.error());
    }
    if (*tool != std::floor(*tool)) {
      // Another edge of a stepped tool: which one it is there, the control knows.
      return in.fault<ToolChoice>(FaultCode::UnsupportedGCode, fmt::format("TOOL CALL {}", *tool));
    }
    choice.number = *tool;
  }
  return choice;
}

Expected<void> Control::toolCall(Scanner& in) {
  Item item;
  item.place = m_block.place;
  const Expected<ToolChoice> choice = toolChoice(in);
  if (!choice) {
    return fail(choice.error());
  }
  if (choice->name) {
    Token token = word('T', 0.0);
    token.kind = TokenKind::TextWord;
    token.text = kept("T=\"" + *choice->name + "\"");
    item.tokens.push_back(token);
  } else if (choice->number) {
    item.tokens.push_back(word('T', *choice->number));
  }
  double radiusDelta = 0.0;
  double lengthDelta = 0.0;
  Feed feed;
  while (!in.isAtEnd()) {
    static constexpr std::string_view kAxes = "XYZ";
    const std::string text = in.nextText();
    if (text.size() == 1 && kAxes.find(text[0]) != std::string_view::npos) {
      setToolAxis(kAxes.find(text[0]));
      in.goTo(in.at() + 1);
    } else if (in.takePrefix("DR2") || in.takePrefix("DL") || in.takePrefix("DR")) {
      const char which = in.previous();
      const Expected<double> delta = in.value();
      if (!delta) {
        return fail(delta.error());
      }
      if (which == '2' && *delta != 0.0) {
        refuse(FaultCode::UnsupportedGCode, "DR2");
      }
      (which == 'L' ? lengthDelta : radiusDelta) = *delta;
    } else if (in.takePrefix("S")) {
      const Expected<double> speed = in.value();
      if (!speed) {
        return fail(speed.error());
      }
      m_spindlePerMin = *speed;
      item.tokens.push_back(word('S', *speed));
    } else if (text.front() == 'F') {
      const Expected<Feed> read = feedWord(in);
      if (!read) {
        return fail(read.error());
      }
      feed = *read;
    } else {
      return in.fault<void>(FaultCode::UnknownWord, text);
    }
  }
  if (choice->name || choice->number) {
    m_tool.radiusDelta = radiusDelta;
    m_tool.lengthDelta = lengthDelta;
    // Where the tip is along the tool, only the control knows.
    m_at.set(thirdAxis(), std::nan(""));
    m_direction.reset();
    setTool(choice->number ? std::optional(static_cast<int>(*choice->number)) : std::nullopt,
            choice->name.value_or(""));
  } else if (radiusDelta != 0.0 || lengthDelta != 0.0) {
    m_tool.radiusDelta = radiusDelta;
    m_tool.lengthDelta = lengthDelta;
  }
  tellToolRadius();
  if (feed.kind == FeedKind::PerMinute || feed.kind == FeedKind::PerRevolution) {
    m_feed = feed;
    m_tool.feed = feed;
  }
  if (!item.tokens.empty()) {
    push(std::move(item));
  }
  return {};
}

/// TOOL DEF 5 L+50 R+6: the length is the control's, which also has the tool.
Expected<void> Control::toolDefinition(Scanner& in) {
  Token token;
  token.kind = TokenKind::Name;
  token.column = m_block.place.column;
  token.text = "TOOL";
  tell({token});
  const std::optional<int> number = in.takeInteger();
  if (!number) {
    in.skipRest();
    return {};
  }
  while (!in.isAtEnd()) {
    const bool isRadius = in.takePrefix("R");
    if (!isRadius && !in.takePrefix("L")) {
      return in.fault<void>(FaultCode::UnknownWord, in.nextText());
    }
    const Expected<double> value = in.value();
    if (!value) {
      return fail(value.error());
    }
    if (isRadius) {
      m_tools[*number].radius = *value;
    }
  }
  return {};
}

Expected<void> Control::stop(Scanner& in) {
  Expected<MotionWords> words = motionWords(in);
  if (!words) {
    return fail(words.error());
  }
  words->functions.insert(words->functions.begin(), {0, m_block.place.column});
  Expected<Item> item = itemOf(*words);
  if (!item) {
    return fail(item.error());
  }
  return moveOn(*words, std::move(*item));
}

}  // namespace rivulet::nc::heidenhain
