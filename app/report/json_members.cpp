// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/json_members.h"

namespace rivulet::report {

namespace {

/// What a tree takes, without making it, bytes: about, and not less.
class TreeSize final : public nlohmann::json_sax<nlohmann::json> {
 public:
  explicit TreeSize(std::uint64_t left) : m_left(left) {}
  [[nodiscard]] bool isExceeded() const { return m_isExceeded; }

  bool null() override { return add(0); }
  bool boolean(bool) override { return add(0); }
  bool number_integer(number_integer_t) override { return add(0); }
  bool number_unsigned(number_unsigned_t) override { return add(0); }
  bool number_float(number_float_t, const string_t&) override { return add(0); }
  bool string(string_t& text) override { return add(kTextBytes + text.size()); }
  bool binary(binary_t& bytes) override { return add(kTextBytes + bytes.size()); }
  bool start_object(std::size_t) override { return ++m_depth <= kDepthMax && add(kListBytes); }
  bool key(string_t& text) override { return add(kMemberBytes + text.size()); }
  bool end_object() override { return --m_depth >= 0; }
  bool start_array(std::size_t) override { return ++m_depth <= kDepthMax && add(kListBytes); }
  bool end_array() override { return --m_depth >= 0; }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override {
    return false;
  }

 private:
  static constexpr int kDepthMax = 100;
  /// In a list that grows.
  static constexpr std::size_t kValueBytes = 2 * sizeof(nlohmann::json);
  static constexpr std::size_t kTextBytes = sizeof(std::string) + 16;
  static constexpr std::size_t kListBytes = 64;
  /// A node of a map.
  static constexpr std::size_t kMemberBytes = sizeof(std::string) + 48;

  bool add(std::size_t bytes) {
    bytes += kValueBytes;
    m_isExceeded = bytes > m_left;
    m_left -= m_isExceeded ? 0 : bytes;
    return !m_isExceeded;
  }

  std::uint64_t m_left;
  int m_depth = 0;
  bool m_isExceeded = false;
};

/// @param at  of both objects
void keepUnknown(nlohmann::ordered_json& record, const nlohmann::json& replaced,
                 const std::set<std::string>& asked, const nlohmann::json::json_pointer& at) {
  for (const auto& [key, value] : replaced.items()) {
    const nlohmann::json::json_pointer here = at / key;
    const std::string name = here.to_string();
    const auto below = asked.lower_bound(name + '/');
    const bool isKnown =
        asked.contains(name) || (below != asked.end() && below->starts_with(name + '/'));
    const auto own = record.find(key);
    if (own == record.end() && !isKnown) {
      record[key] = value;
    } else if (own != record.end() && own->is_object() && value.is_object()) {
      keepUnknown(*own, value, asked, here);
    }
  }
}

}  // namespace

base::Result<bool> isSoundJson(std::string_view text, const base::Budget& budget) {
  TreeSize size(budget.left());
  const bool isSound = nlohmann::json::sax_parse(text, &size);
  return size.isExceeded() ? base::Result<bool>(base::fail(budget.exceeded("The JSON text")))
                           : base::Result<bool>(isSound);
}

void keepUnknown(nlohmann::ordered_json& record, const nlohmann::json& replaced,
                 const std::set<std::string>& asked) {
  if (replaced.is_object()) {
    keepUnknown(record, replaced, asked, nlohmann::json::json_pointer());
  }
}

}  // namespace rivulet::report
