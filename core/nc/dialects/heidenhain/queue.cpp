// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What is told, in order: an element waits until it is known that the next block leaves its end
// alone.

#include <cmath>
#include <utility>

#include "nc/dialects/heidenhain/control.h"

namespace rivulet::nc::heidenhain {

Token Control::word(char address, double value) const {
  // Texts of all letters.
  static constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";
  Token token;
  token.kind = TokenKind::Word;
  token.address = address;
  token.column = m_block.place.column;
  token.value = value;
  token.hasPoint = true;
  token.reference = Reference::Absolute;
  token.text = kLetters.substr(static_cast<std::size_t>(address - 'A'), 1);
  // M126 and M127 say how rotary axes turn there.
  const bool isLinear = address >= 'X' && address <= 'Z';
  if (!isLinear) {
    token.reference = Reference::Modal;
  }
  return token;
}

Token Control::named(std::string_view name, double value) const {
  Token token;
  token.kind = TokenKind::NamedValue;
  token.column = m_block.place.column;
  token.value = value;
  token.text = name;
  return token;
}

std::string_view Control::kept(std::string text) {
  return *m_texts.insert(std::move(text)).first;
}

void Control::tell(std::vector<Token> tokens) {
  Item item;
  item.place = m_block.place;
  item.isSkipped = m_block.isSkipped;
  item.tokens = std::move(tokens);
  push(std::move(item));
}

void Control::ignore(std::string word) {
  Item item;
  item.place = m_block.place;
  item.ignored = std::move(word);
  push(std::move(item));
}

/// What a block would have moved is missing: nobody knows where the tool is.
void Control::report(Fault fault) {
  Item item;
  item.place = m_block.place;
  if (fault.place.line.value != 0) {
    item.place = fault.place;
  }
  fault.place = item.place;
  m_corner.reset();
  const bool isNew = m_faults
                         .insert({item.place.file, item.place.line.value,
                                  static_cast<std::uint32_t>(item.place.column)})
                         .second;
  if (!isNew) {
    flush();
    forgetPosition();
    return;
  }
  item.fault = std::move(fault);
  push(std::move(item));
  forgetPosition();
}

void Control::refuse(FaultCode code, std::string argument) {
  report({code, std::move(argument), m_block.place});
}

void Control::forgetPosition() {
  m_at = {std::nan(""), std::nan(""), std::nan("")};
  m_direction.reset();
}

void Control::push(Item item) {
  item.line = m_block.line;
  if (m_approach) {
    if (Expected<void> done = joinApproach(item); !done) {
      report(std::move(done.error()));
    }
  }
  if (m_corner) {
    if (Expected<void> done = joinCorner(item); !done) {
      m_corner.reset();
      const Place place = std::exchange(m_block.place, done.error().place);
      report(std::move(done.error()));
      m_block.place = place;
    }
  }
  flush();
  if (item.moves && item.element && item.plane == firstAxis() && item.turns == 0) {
    m_pending = std::move(item);
  } else {
    write(std::move(item));
  }
}

void Control::flush() {
  if (m_pending) {
    write(std::move(*std::exchange(m_pending, std::nullopt)));
  }
}

void Control::finish() {
  if (m_approach) {
    const Place place = m_approach->place;
    m_approach.reset();
    report({FaultCode::UnsupportedGCode, "APPR", place});
  }
  if (m_corner) {
    const Place place = m_corner->place;
    m_corner.reset();
    m_block.place = place;
    report({FaultCode::CornerMalformed, {}, place});
  }
  flush();
}

bool Control::take(Made& made) {
  if (m_made.empty()) {
    return false;
  }
  made = std::move(m_made.front());
  m_made.pop_front();
  return true;
}

void Control::write(Item item) {
  Made made;
  made.place = item.place;
  made.line = item.line;
  made.isMade = item.isMade;
  made.fault = std::move(item.fault);
  made.ignored = std::move(item.ignored);
  std::vector<Token>& tokens = made.words.tokens;
  const auto add = [&tokens, &item](Token token) {
    token.column = item.place.column;
    tokens.push_back(token);
  };
  if (item.isSkipped) {
    Token skip;
    skip.kind = TokenKind::BlockSkip;
    skip.text = "/";
    add(skip);
  }
  // An arc may lie in another plane than that of the tool.
  const std::size_t plane =
      item.moves && item.element && item.element->isArc ? item.plane : firstAxis();
  if (plane != m_toldPlane && !made.fault && made.ignored.empty()) {
    static constexpr std::array<double, base::kAxisCount> kPlanes{17.0, 19.0, 18.0};
    add(word('G', kPlanes[plane]));
    m_toldPlane = plane;
  }
  if (item.moves) {
    const bool isRapid = item.feed.kind == FeedKind::Rapid;
    const bool isArc = item.element && item.element->isArc;
    add(word('G', isArc ? (item.element->clockwise ? 2.0 : 3.0) : isRapid ? 0.0 : 1.0));
    base::Vec3 target = item.target;
    if (item.element) {
      target.set(item.plane, item.element->end.x);
      target.set((item.plane + 1) % base::kAxisCount, item.element->end.y);
    }
    if (!item.isInMachine) {
      target.set(thirdAxis(), target[thirdAxis()] + m_tool.lengthDelta);
    }
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      if (item.given[axis]) {
        add(word(base::kAxisNames[axis], target[axis]));
      }
    }
    if (isArc && item.radius) {
      add(word('R', *item.radius));
    } else if (isArc) {
      const Flat centre = item.element->centre - item.element->start;
      add(word(static_cast<char>('I' + item.plane), centre.x));
      add(word(static_cast<char>('I' + (item.plane + 1) % base::kAxisCount), centre.y));
    }
    if (item.turns > 0) {
      add(named("TURN", item.turns));
    }
    for (std::size_t axis = kFirstRotary; axis < kProgrammedAxisCount; ++axis) {
      if (item.rotary[axis]) {
        add(word(kProgrammedAxes[axis], *item.rotary[axis]));
      }
    }
    if (!isRapid && item.feed.kind != FeedKind::None && item.feed != m_told) {
      if (item.feed.kind != m_told.kind &&
          (m_told.kind == FeedKind::PerRevolution || item.feed.kind == FeedKind::PerRevolution)) {
        add(word('G', item.feed.kind == FeedKind::PerRevolution ? 95.0 : 94.0));
      }
      m_told = item.feed;
      // In an inch program a feed per minute counts in tenths of an inch.
      constexpr double kInchesPerMin = 0.1;
      const bool isTenth = m_isInch && item.feed.kind == FeedKind::PerMinute;
      add(word('F', isTenth ? item.feed.value * kInchesPerMin : item.feed.value));
    }
  }
  for (const Token& token : item.tokens) {
    tokens.push_back(token);
  }
  m_made.push_back(std::move(made));
}

// --- corners ------------------------------------------------------------------------------------

/// RND and CHF: chapter "Programming contours", "Rounded corners RND" and "Inserting a chamfer
/// between two straight lines".
Expected<void> Control::joinCorner(Item& next) {
  const CornerWords words = *std::exchange(m_corner, std::nullopt);
  const auto malformed = [&words] { return fail(FaultCode::CornerMalformed, {}, words.place); };
  const bool isFlat = next.moves && next.element && next.plane == firstAxis() && next.turns == 0 &&
                      m_pending && m_pending->element && !next.given[thirdAxis()] &&
                      !m_pending->given[thirdAxis()];
  if (!isFlat) {
    return malformed();
  }
  const std::optional<Corner> made =
      words.isChamfer ? chamferedCorner(*m_pending->element, *next.element, words.size)
                      : roundedCorner(*m_pending->element, *next.element, words.size);
  if (!made) {
    return malformed();
  }
  Item between;
  between.place = words.place;
  between.line = words.line;
  between.moves = true;
  between.isMade = true;
  between.given[firstAxis()] = true;
  between.given[secondAxis()] = true;
  between.element = made->between;
  between.plane = firstAxis();
  between.feed = words.feed.value_or(m_pending->feed);
  if (between.feed.kind == FeedKind::Rapid && made->between.isArc) {
    return malformed();
  }
  m_pending->element = made->before;
  m_pending->radius.reset();
  m_pending->given[firstAxis()] = true;
  m_pending->given[secondAxis()] = true;
  next.element = made->after;
  next.radius.reset();
  next.given[firstAxis()] = true;
  next.given[secondAxis()] = true;
  flush();
  write(std::move(between));
  return {};
}

}  // namespace rivulet::nc::heidenhain
