// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A record lists its fields once, and is written and read by the same list:
///
///     template <class Io, class Place>
///     void fieldsOf(Io& io, Place& place) {
///       io.count("point", place.point);
///       io.ifThere().flag("granted", place.granted);
///     }
///
/// `Io` is `FieldWriter`, with a constant record, or `FieldReader`. @threadsafety plain values.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/instant.h"
#include "base/units.h"
#include "base/vec3.h"
#include "report/json_members.h"

namespace rivulet::report {

inline constexpr double kJsonSecondsMax = 1e9;
inline constexpr double kJsonMillisecondsMax = 1e12;
/// The smallest of what has to be more than nothing.
inline constexpr double kJsonAbove0 = std::numeric_limits<double>::min();

template <class Record, class Fields>
[[nodiscard]] nlohmann::ordered_json jsonOf(const Record& record, Fields fields);
template <class Record, class Fields>
[[nodiscard]] nlohmann::ordered_json listOf(const std::vector<Record>& records, Fields fields);

class FieldWriter {
 public:
  static constexpr bool kReads = false;
  explicit FieldWriter(nlohmann::ordered_json& json) : m_json(json) {}

  /// The next field may be missing: earlier versions did not write it.
  FieldWriter& ifThere() { return *this; }
  /// The next field is written only if it is not empty, zero or false.
  FieldWriter& ifSet() {
    m_onlyIfSet = true;
    return *this;
  }
  template <class Value>
  void number(const char* key, const Value& value, double /*min*/, double /*max*/) {
    put(key, value);
  }
  template <class Value>
  void count(const char* key, const Value& value) {
    put(key, value);
  }
  void flag(const char* key, bool value) { put(key, value); }
  void text(const char* key, const std::string& value) { put(key, value); }
  void seconds(const char* key, base::Duration value) { put(key, base::toSeconds(value)); }
  void seconds(const char* key, base::Instant value) { put(key, base::toSeconds(value)); }
  void milliseconds(const char* key, base::Duration value, double /*max*/ = 0.0) {
    put(key, base::toMilliseconds(value));
  }
  void feed(const char* key, double mmPerS, double /*min*/ = 0.0) {
    put(key, base::mmPerMinFromMmPerS(mmPerS));
  }
  void place(const char* key, const base::Vec3& mm) { m_json[key] = {mm.x, mm.y, mm.z}; }
  template <std::size_t size>
  void numbers(const char* key, const std::array<double, size>& values, double /*min*/,
               double /*max*/) {
    m_json[key] = values;
  }
  void counts(const char* key, const std::vector<std::size_t>& values) { m_json[key] = values; }
  /// Null: nothing.
  void nullable(const char* key, std::optional<int> value) {
    m_json[key] = value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
  }
  void words(const char* key, const std::vector<std::string>& values) { m_json[key] = values; }
  /// As text: JSON numbers are doubles in many programs.
  void hexadecimal(const char* key, std::uint64_t value);
  /// Only if there is one.
  void error(const char* key, const base::Error& error);
  template <class Value, class NameOf, class OfName>
  void named(const char* key, Value value, NameOf nameOf, OfName /*ofName*/) {
    put(key, std::string(nameOf(value)));
  }
  template <class Record, class Fields>
  void object(const char* key, Record& record, Fields fields) {
    m_json[key] = jsonOf(record, fields);
  }
  template <class Record, class Fields>
  void list(const char* key, const std::vector<Record>& records, Fields fields) {
    if (std::exchange(m_onlyIfSet, false) && records.empty()) {
      return;
    }
    m_json[key] = listOf(records, fields);
  }
  /// @return the field is to be listed
  template <class Value>
  [[nodiscard]] bool has(const char* /*key*/, const std::optional<Value>& value) {
    return value.has_value();
  }

 private:
  template <class Value>
  void put(const char* key, const Value& value) {
    if (!std::exchange(m_onlyIfSet, false) || value != Value{}) {
      m_json[key] = value;
    }
  }

  nlohmann::ordered_json& m_json;
  bool m_onlyIfSet = false;
};

class FieldReader {
 public:
  static constexpr bool kReads = true;
  /// @param members  of the whole text. @param at  pointer to the object of the record
  explicit FieldReader(Members& members, std::string at = {})
      : m_members(members), m_at(std::move(at)) {}

  FieldReader& ifThere() {
    m_mayBeMissing = true;
    return *this;
  }
  FieldReader& ifSet() { return ifThere(); }
  template <class Value>
  void number(const char* key, Value& value, double min, double max) {
    if (const std::string at = toRead(key); !at.empty()) {
      value = std::is_integral_v<Value>
                  ? m_members.integer<Value>(at.c_str(), min, max)
                  : static_cast<Value>(m_members.number(at.c_str(), min, max));
    }
  }
  template <class Value>
  void count(const char* key, Value& value) {
    number(key, value, 0.0, kJsonCountMax);
  }
  void flag(const char* key, bool& value) {
    if (const std::string at = toRead(key); !at.empty()) {
      value = m_members.flag(at.c_str());
    }
  }
  void text(const char* key, std::string& value) {
    if (const std::string at = toRead(key); !at.empty()) {
      value = m_members.text(at.c_str());
    }
  }
  void seconds(const char* key, base::Duration& value) {
    duration(key, value, kJsonSecondsMax, 1.0);
  }
  void seconds(const char* key, base::Instant& value) {
    base::Duration since{};
    seconds(key, since);
    value = base::Instant{since};
  }
  void milliseconds(const char* key, base::Duration& value, double max = kJsonMillisecondsMax) {
    duration(key, value, max, 1000.0);
  }
  /// @param min  mm/min
  void feed(const char* key, double& mmPerS, double min = 0.0) {
    double mmPerMin = base::mmPerMinFromMmPerS(mmPerS);
    number(key, mmPerMin, min, kJsonCountMax);
    mmPerS = base::mmPerSFromMmPerMin(mmPerMin);
  }
  void place(const char* key, base::Vec3& mm) {
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      const std::string at = pointer(key) + '/' + std::to_string(axis);
      mm.set(axis, m_members.number(at.c_str(), -kJsonPlaceMax, kJsonPlaceMax));
    }
  }
  /// @param min, max  of each of them
  template <std::size_t size>
  void numbers(const char* key, std::array<double, size>& values, double min, double max) {
    const bool mayBeMissing = std::exchange(m_mayBeMissing, false);
    for (std::size_t i = 0; i < size; ++i) {
      const std::string at = pointer(key) + '/' + std::to_string(i);
      if (!mayBeMissing || m_members.has(at.c_str())) {
        values[i] = m_members.number(at.c_str(), min, max);
      }
    }
  }
  void counts(const char* key, std::vector<std::size_t>& values) {
    const nlohmann::json* items = m_members.find(pointer(key).c_str());
    if (items == nullptr || !items->is_array()) {
      refuse(key);
      return;
    }
    for (const nlohmann::json& item : *items) {
      values.push_back(item.is_number_unsigned() ? item.get<std::size_t>() : 0);
    }
  }
  void nullable(const char* key, std::optional<int>& value) {
    const nlohmann::json* found = m_members.find(pointer(key).c_str());
    if (found != nullptr && found->is_number()) {
      number(key, value.emplace(), 0.0, kJsonCountMax);
    }
  }
  void words(const char* key, std::vector<std::string>& values) {
    values = m_members.words(pointer(key).c_str());
  }
  /// The whole record.
  void refuse() { m_members.refuse(m_at.c_str()); }
  /// For a value that a field cannot have.
  void refuse(const char* key) { m_members.refuse(pointer(key).c_str()); }
  void hexadecimal(const char* key, std::uint64_t& value);
  void error(const char* key, base::Error& error);
  /// @param ofName  of each name its value, as an optional
  template <class Value, class NameOf, class OfName>
  void named(const char* key, Value& value, NameOf /*nameOf*/, OfName ofName) {
    if (const std::string at = toRead(key); !at.empty()) {
      const std::optional<Value> known = ofName(m_members.text(at.c_str()));
      value = known.value_or(value);
      if (!known) {
        m_members.refuse(at.c_str());
      }
    }
  }
  template <class Record, class Fields>
  void object(const char* key, Record& record, Fields fields) {
    if (const std::string at = toRead(key); !at.empty()) {
      FieldReader inner(m_members, at);
      fields(inner, record);
    }
  }
  template <class Record, class Fields>
  void list(const char* key, std::vector<Record>& records, Fields fields) {
    const std::string at = toRead(key);
    if (at.empty()) {
      return;
    }
    const nlohmann::json* items = m_members.find(at.c_str());
    if (items == nullptr || !items->is_array()) {
      m_members.refuse(at.c_str());
      return;
    }
    for (const nlohmann::json& item : *items) {
      Members own(item);
      FieldReader inner(own);
      fields(inner, records.emplace_back());
      if (!own.bad().empty()) {
        m_members.refuse(at.c_str());
        return;
      }
    }
  }
  /// Makes what is there. @return the field is to be listed
  template <class Value>
  [[nodiscard]] bool has(const char* key, std::optional<Value>& value) {
    if (m_members.has(pointer(key).c_str())) {
      value.emplace();
    }
    return value.has_value();
  }

 private:
  [[nodiscard]] std::string pointer(const char* key) const { return m_at + '/' + key; }
  /// Where it stands; empty: it may be missing, and is.
  [[nodiscard]] std::string toRead(const char* key) {
    std::string at = pointer(key);
    return std::exchange(m_mayBeMissing, false) && !m_members.has(at.c_str()) ? std::string() : at;
  }
  void duration(const char* key, base::Duration& value, double max, double perSecond) {
    double count = base::toSeconds(value) * perSecond;
    number(key, count, 0.0, max);
    value = base::fromSeconds(count / perSecond);
  }

  Members& m_members;
  std::string m_at;
  bool m_mayBeMissing = false;
};

/// For `named`: looks a name up among those of the values.
template <class Value, std::size_t size, class NameOf>
[[nodiscard]] auto nameAmong(const std::array<Value, size>& values, NameOf nameOf) {
  return [values, nameOf](const std::string& name) {
    const auto found =
        std::find_if(values.begin(), values.end(), [&](Value one) { return nameOf(one) == name; });
    return found == values.end() ? std::nullopt : std::optional<Value>(*found);
  };
}

/// An optional record, as an object of its own.
template <class Io, class Optional, class Fields>
void maybe(Io& io, const char* key, Optional& record, Fields fields) {
  if (io.has(key, record)) {
    io.object(key, *record, fields);
  }
}

template <class Record, class Fields>
[[nodiscard]] nlohmann::ordered_json jsonOf(const Record& record, Fields fields) {
  auto json = nlohmann::ordered_json::object();
  FieldWriter io(json);
  fields(io, record);
  return json;
}

template <class Record, class Fields>
[[nodiscard]] nlohmann::ordered_json listOf(const std::vector<Record>& records, Fields fields) {
  auto json = nlohmann::ordered_json::array();
  for (const Record& record : records) {
    json.push_back(jsonOf(record, fields));
  }
  return json;
}

/// As `jsonOf`, with what the text that it replaces has besides: a later version wrote it.
template <class Record, class Fields>
[[nodiscard]] nlohmann::ordered_json jsonInPlaceOf(const nlohmann::json& replaced,
                                                   const Record& record, Fields fields) {
  std::set<std::string> asked;
  Members members(replaced, &asked);
  FieldReader io(members);
  Record unused;
  fields(io, unused);
  nlohmann::ordered_json json = jsonOf(record, fields);
  keepUnknown(json, replaced, asked);
  return json;
}

}  // namespace rivulet::report
