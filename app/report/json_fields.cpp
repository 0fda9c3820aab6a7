// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/json_fields.h"

#include <fmt/format.h>

#include <charconv>

#include "base/file.h"
#include "live/error.h"
#include "opcua/error.h"
#include "report/report_json.h"
#include "templates/cells.h"

namespace rivulet::report {

namespace {

/// "streaming:5" as the code it was printed from. A code of another folder keeps its number only.
std::error_code codeOf(const std::string& text) {
  static const base::NamedCategory unknown("report of an earlier run");
  const std::size_t colon = text.rfind(':');
  int value = 0;
  if (colon != std::string::npos) {
    std::from_chars(text.data() + colon + 1, text.data() + text.size(), value);
  }
  const std::string name = text.substr(0, colon);
  for (const std::error_code& known :
       {make_error_code(streaming::StreamError{}), make_error_code(opcua::LinkError{}),
        make_error_code(base::FileError{}), make_error_code(templates::TemplateError{}),
        make_error_code(live::LiveError{})}) {
    if (known.category().name() == name && value > 0) {
      return {value, known.category()};
    }
  }
  return {std::max(value, 1), unknown};
}

}  // namespace

void FieldWriter::hexadecimal(const char* key, std::uint64_t value) {
  m_json[key] = fmt::format("{:016x}", value);
}

void FieldWriter::error(const char* key, const base::Error& error) {
  if (error.code) {
    m_json[key] = errorJson(error);
  }
}

void FieldReader::hexadecimal(const char* key, std::uint64_t& value) {
  std::string digits;
  text(key, digits);
  if (digits.empty()) {
    return;
  }
  constexpr int kHexadecimal = 16;
  const char* const past = digits.data() + digits.size();
  const auto [end, status] = std::from_chars(digits.data(), past, value, kHexadecimal);
  if (status != std::errc{} || end != past || value == 0) {
    refuse(key);
  }
}

void FieldReader::error(const char* key, base::Error& error) {
  const std::string at = pointer(key);
  if (m_members.has(at.c_str())) {
    error = base::makeError(codeOf(m_members.text((at + "/code").c_str())),
                            m_members.text((at + "/message").c_str()));
  }
}

}  // namespace rivulet::report
