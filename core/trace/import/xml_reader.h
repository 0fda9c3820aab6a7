// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The XML of traces, tag after tag. What it does not need of XML, it passes over: comments,
/// processing instructions and document types. Entities that a document declares itself are not
/// replaced, so that a short text stays short. Nothing calls itself: any depth of elements is read.
/// @threadsafety one object, one thread; the functions are pure.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace rivulet::trace {

enum class XmlKind : std::uint8_t {
  Start,  ///< of an element, also of one without content
  End,    ///< of an element; of one without content there is none
  Text,
};

/// Views of the text that is read.
struct XmlToken {
  XmlKind kind = XmlKind::Start;
  std::string_view name;   ///< of the element, without its prefix; empty: text
  std::string_view raw;    ///< the attributes of a start tag, or the text as it stands
  bool isEmpty = false;    ///< a start tag without content: its end has been passed
  bool isLiteral = false;  ///< text in which "&amp;" means itself (CDATA)
};

class XmlReader {
 public:
  /// @param from  where to begin, between two tags
  explicit XmlReader(std::string_view text, std::size_t from = 0) : m_text(text), m_at(from) {}

  /// Nothing at the end, or where the text was cut within a tag.
  [[nodiscard]] std::optional<XmlToken> next();
  [[nodiscard]] bool wasCut() const { return m_wasCut; }

 private:
  /// Passes over what ends with `end`. @return what is before it; nothing: it was cut
  std::optional<std::string_view> takeUntil(std::string_view end);
  std::optional<XmlToken> takeTag();
  bool passDocumentType();
  void cut();

  std::string_view m_text;
  std::size_t m_at;
  bool m_wasCut = false;
};

/// Takes the next attribute off `raw`, the attributes of a start tag.
struct XmlAttribute {
  std::string_view name;   ///< with its prefix
  std::string_view value;  ///< as it stands
};
[[nodiscard]] std::optional<XmlAttribute> takeXmlAttribute(std::string_view& raw);

/// The value of an attribute of a start tag; empty: it has none.
[[nodiscard]] std::string xmlAttribute(const XmlToken& tag, std::string_view name);
/// With "&lt;", "&#181;" and the like as characters. What is no such sequence stays as it is.
[[nodiscard]] std::string xmlText(std::string_view raw);

/// The name of the first element; empty: there is none in the first 64 kB.
[[nodiscard]] std::string_view xmlRoot(std::string_view text);

}  // namespace rivulet::trace
