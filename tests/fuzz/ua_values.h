// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Values and messages of OPC UA for the fuzz targets. @threadsafety plain values.
#pragma once

#include <open62541/types.h>
#include <open62541/types_generated_handling.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/random.h"
#include "opcua/open62541/handle.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t sizeMax);

namespace rivulet::tests {

/// A value of the library's, read from its encoded form.
class Decoded {
 public:
  Decoded(std::string_view bytes, std::size_t type)
      : m_type(&UA_TYPES[type]), m_value(UA_new(m_type)) {
    const UA_ByteString source = opcua::borrow(bytes);
    m_isGood = UA_decodeBinary(&source, m_value, m_type, nullptr) == UA_STATUSCODE_GOOD;
  }
  ~Decoded() { UA_delete(m_value, m_type); }
  Decoded(const Decoded&) = delete;
  Decoded& operator=(const Decoded&) = delete;

  [[nodiscard]] bool isGood() const { return m_isGood; }
  [[nodiscard]] void* get() const { return m_value; }

 private:
  const UA_DataType* m_type;
  void* m_value;
  bool m_isGood = false;
};

/// The encoded form of a value.
template <class T>
[[nodiscard]] std::string encoded(const T& value, std::size_t type) {
  UA_ByteString bytes = UA_BYTESTRING_NULL;
  std::string text;
  if (UA_encodeBinary(&value, &UA_TYPES[type], &bytes) == UA_STATUSCODE_GOOD) {
    text = opcua::view(bytes);
  }
  UA_ByteString_clear(&bytes);
  return text;
}

/// Puts a message in place of an input; one that does not fit is changed by the library instead.
/// @param kind  the first byte  @return as of LLVMFuzzerCustomMutator
[[nodiscard]] inline std::size_t replacedBy(const std::string& message, std::uint8_t kind,
                                            std::uint8_t* data, std::size_t size,
                                            std::size_t sizeMax) {
  if (message.size() + 1 > sizeMax) {
    return LLVMFuzzerMutate(data, size, sizeMax);
  }
  data[0] = kind;
  std::copy(message.begin(), message.end(), data + 1);
  return message.size() + 1;
}

/// Draws values. They belong to this object and must not be cleared.
class Values {
 public:
  explicit Values(base::Random& random) : m_random(random) {}

  [[nodiscard]] double number() {
    static constexpr std::array<double, 10> kSpecial{0.0,
                                                     -0.0,
                                                     1.0,
                                                     -1.0,
                                                     1e300,
                                                     -1e18,
                                                     4294967296.0,
                                                     std::numeric_limits<double>::infinity(),
                                                     std::numeric_limits<double>::quiet_NaN(),
                                                     5e-324};
    return m_random.below(2) == 0 ? kSpecial[m_random.below(kSpecial.size())]
                                  : 100.0 * m_random.normal();
  }
  /// "3:7", "2,4", …
  [[nodiscard]] std::string range() {
    const auto part = [this] {
      return std::to_string(m_random.below(2) ? m_random.below(9) : 1U << 30U);
    };
    std::string text = part();
    for (std::size_t i = m_random.below(3); i > 0; --i) {
      text += (m_random.below(3) == 0 ? "," : ":") + part();
    }
    return text;
  }
  /// @param text  of strings
  [[nodiscard]] UA_Variant variant(std::string text = "A.MPF") {
    switch (m_random.below(9)) {
      case 0: {
        std::vector<double>& values = m_arrays.emplace_back();
        for (std::size_t i = m_random.below(40); i > 0; --i) {
          values.push_back(number());
        }
        UA_Variant array;
        UA_Variant_init(&array);
        UA_Variant_setArray(&array, values.data(), values.size(), &UA_TYPES[UA_TYPES_DOUBLE]);
        return array;
      }
      case 1:
        return integer(m_random.below(1U << 31U), UA_TYPES_UINT64);
      case 2:
        return integer(m_random.below(4), UA_TYPES_UINT32);
      case 3:
        return integer(m_random.below(2), UA_TYPES_BOOLEAN);
      case 4:
        return string(std::move(text), UA_TYPES_STRING);
      case 5:
        return string(std::move(text), UA_TYPES_BYTESTRING);
      case 6:
        return integer(m_random.below(300), UA_TYPES_INT32);
      case 7:
        return emptyArray();
      default:
        return opcua::borrowScalar(m_doubles.emplace_back(number()), UA_TYPES_DOUBLE);
    }
  }
  /// Of a type that methods take; the standard has two kinds.
  [[nodiscard]] UA_Variant emptyArray() {
    static constexpr std::array<std::size_t, 5> kTypes{
        UA_TYPES_STRING, UA_TYPES_BYTESTRING, UA_TYPES_BOOLEAN, UA_TYPES_UINT32, UA_TYPES_UINT64};
    UA_Variant array;
    UA_Variant_init(&array);
    array.type = &UA_TYPES[kTypes[m_random.below(kTypes.size())]];
    array.data = m_random.below(2) == 0 ? nullptr : UA_EMPTY_ARRAY_SENTINEL;
    return array;
  }
  /// @param type  an integer of 1 to 8 bytes
  [[nodiscard]] UA_Variant integer(std::uint64_t value, std::size_t type) {
    return opcua::borrowScalar(m_numbers.emplace_back(value), type);
  }
  [[nodiscard]] UA_Variant string(std::string text, std::size_t type) {
    const std::string& kept = m_texts.emplace_back(std::move(text));
    return opcua::borrowScalar(m_strings.emplace_back(opcua::borrow(kept)), type);
  }

 private:
  base::Random& m_random;
  std::deque<std::vector<double>> m_arrays;
  std::deque<std::uint64_t> m_numbers;
  std::deque<double> m_doubles;
  std::deque<std::string> m_texts;
  std::deque<UA_String> m_strings;
};

}  // namespace rivulet::tests
