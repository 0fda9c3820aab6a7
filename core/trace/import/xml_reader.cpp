// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/import/xml_reader.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "base/text.h"

namespace rivulet::trace {

namespace {

constexpr std::string_view kBlanks = " \t\r\n";

/// Before the first element a file may have comments.
constexpr std::size_t kRootBytes = 65536;

std::string_view localName(std::string_view name) {
  const std::size_t colon = name.rfind(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

/// Where the tag ends: signs in quotes do not end it.
std::size_t endOfTag(std::string_view text, std::size_t at) {
  while ((at = text.find_first_of("\"'>", at)) != std::string_view::npos && text[at] != '>') {
    at = text.find(text[at], at + 1);
    if (at == std::string_view::npos) {
      break;
    }
    ++at;
  }
  return at;
}

void appendCode(std::string& out, std::uint32_t code) {
  const auto more = [&out, code](unsigned shift) {
    out += static_cast<char>(0x80U | (code >> shift & 0x3FU));
  };
  if (code < 0x80) {
    out += static_cast<char>(code);
  } else if (code < 0x800) {
    out += static_cast<char>(0xC0U | code >> 6U);
    more(0);
  } else if (code < 0x10000) {
    out += static_cast<char>(0xE0U | code >> 12U);
    more(6);
    more(0);
  } else {
    out += static_cast<char>(0xF0U | code >> 18U);
    more(12);
    more(6);
    more(0);
  }
}

/// "#181", "#xB5". @return nothing: no number of a character
std::optional<std::uint32_t> characterCode(std::string_view reference) {
  if (reference.size() < 2 || reference[0] != '#') {
    return std::nullopt;
  }
  const bool isHex = reference[1] == 'x';
  const std::string_view digits = reference.substr(isHex ? 2 : 1);
  std::uint32_t code = 0;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), code, isHex ? 16 : 10);
  const bool isWhole = error == std::errc() && end == digits.data() + digits.size();
  const bool isCharacter =
      isWhole && code > 0 && code < 0x110000 && (code < 0xD800 || code > 0xDFFF);
  return isCharacter ? std::optional(code) : std::nullopt;
}

}  // namespace

void XmlReader::cut() {
  m_wasCut = true;
  m_at = m_text.size();
}

std::optional<std::string_view> XmlReader::takeUntil(std::string_view end) {
  const std::size_t found = m_text.find(end, m_at);
  if (found == std::string_view::npos) {
    cut();
    return std::nullopt;
  }
  const std::string_view before = m_text.substr(m_at, found - m_at);
  m_at = found + end.size();
  return before;
}

/// "<!DOCTYPE name [ … ]>": what stands in its brackets declares entities, which stay unknown.
bool XmlReader::passDocumentType() {
  const std::size_t end = m_text.find_first_of("[>", m_at);
  if (end != std::string_view::npos && m_text[end] == '[') {
    m_at = end;
    if (!takeUntil("]")) {
      return false;
    }
  }
  return takeUntil(">").has_value();
}

std::optional<XmlToken> XmlReader::takeTag() {
  const std::size_t end = endOfTag(m_text, m_at);
  if (end == std::string_view::npos) {
    cut();
    return std::nullopt;
  }
  std::string_view tag = m_text.substr(m_at, end - m_at);
  m_at = end + 1;
  XmlToken token;
  if (tag.starts_with('/')) {
    token.kind = XmlKind::End;
    token.name = localName(base::trim(tag.substr(1)));
    return token;
  }
  if (tag.ends_with('/')) {
    token.isEmpty = true;
    tag.remove_suffix(1);
  }
  const std::size_t name = std::min(tag.find_first_of(kBlanks), tag.size());
  token.name = localName(tag.substr(0, name));
  token.raw = tag.substr(name);
  return token;
}

std::optional<XmlToken> XmlReader::next() {
  while (m_at < m_text.size()) {
    if (m_text[m_at] != '<') {
      const std::size_t end = std::min(m_text.find('<', m_at), m_text.size());
      XmlToken token;
      token.kind = XmlKind::Text;
      token.raw = m_text.substr(m_at, end - m_at);
      m_at = end;
      return token;
    }
    const std::string_view rest = m_text.substr(m_at);
    ++m_at;
    if (rest.starts_with("<!--")) {
      m_at += 3;
      takeUntil("-->");
    } else if (rest.starts_with("<![CDATA[")) {
      m_at += 8;
      if (const auto text = takeUntil("]]>")) {
        XmlToken token;
        token.kind = XmlKind::Text;
        token.raw = *text;
        token.isLiteral = true;
        return token;
      }
    } else if (rest.starts_with("<?")) {
      takeUntil("?>");
    } else if (rest.starts_with("<!")) {
      passDocumentType();
    } else if (const auto tag = takeTag(); tag && !tag->name.empty()) {
      return tag;
    }
  }
  return std::nullopt;
}

std::optional<XmlAttribute> takeXmlAttribute(std::string_view& raw) {
  const std::size_t begin = raw.find_first_not_of(kBlanks);
  const std::size_t equal = raw.find('=', std::min(begin, raw.size()));
  const std::size_t open =
      equal == std::string_view::npos ? equal : raw.find_first_not_of(kBlanks, equal + 1);
  const bool isQuoted = open != std::string_view::npos && (raw[open] == '"' || raw[open] == '\'');
  const std::size_t end = isQuoted ? raw.find(raw[open], open + 1) : std::string_view::npos;
  if (end == std::string_view::npos) {
    raw = {};
    return std::nullopt;
  }
  const XmlAttribute attribute{base::trim(raw.substr(begin, equal - begin)),
                               raw.substr(open + 1, end - open - 1)};
  raw.remove_prefix(end + 1);
  return attribute;
}

std::string xmlAttribute(const XmlToken& tag, std::string_view name) {
  std::string_view raw = tag.raw;
  while (const auto attribute = takeXmlAttribute(raw)) {
    if (attribute->name == name) {
      return xmlText(attribute->value);
    }
  }
  return {};
}

std::string xmlText(std::string_view raw) {
  static constexpr std::array<std::pair<std::string_view, char>, 5> kNamed{
      {{"amp", '&'}, {"lt", '<'}, {"gt", '>'}, {"quot", '"'}, {"apos", '\''}}};
  constexpr std::size_t kReferenceMax = 10;
  std::string text;
  while (!raw.empty()) {
    const std::size_t sign = std::min(raw.find('&'), raw.size());
    text += raw.substr(0, sign);
    raw.remove_prefix(sign);
    if (raw.empty()) {
      break;
    }
    const std::size_t end = raw.substr(0, kReferenceMax).find(';');
    const std::string_view reference =
        end == std::string_view::npos ? std::string_view() : raw.substr(1, end - 1);
    const std::size_t before = text.size();
    if (const auto code = characterCode(reference)) {
      appendCode(text, *code);
    }
    for (const auto& [name, character] : kNamed) {
      if (reference == name) {
        text += character;
      }
    }
    const bool isReplaced = text.size() > before;
    text += isReplaced ? "" : "&";
    raw.remove_prefix(isReplaced ? end + 1 : 1);
  }
  return text;
}

std::string_view xmlRoot(std::string_view text) {
  XmlReader reader(text.substr(0, kRootBytes));
  while (const auto token = reader.next()) {
    if (token->kind == XmlKind::Start) {
      return token->name;
    }
  }
  return {};
}

}  // namespace rivulet::trace
