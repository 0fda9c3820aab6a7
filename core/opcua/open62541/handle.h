// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Ownership and borrowing of open62541 values, for the link and the machine's front. This
/// header names open62541 types; no header of another module may include it.
/// @threadsafety plain values.
#pragma once

#include <open62541/types.h>
#include <open62541/types_generated_handling.h>

#include <algorithm>
#include <string>
#include <string_view>

namespace rivulet::opcua {

/// Owns one value of an open62541 type, e.g. `Handle<UA_CallResponse, UA_TYPES_CALLRESPONSE>`.
template <class T, std::size_t TypeIndex>
class Handle {
 public:
  Handle() { UA_init(&m_value, type()); }
  ~Handle() { UA_clear(&m_value, type()); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  Handle(Handle&& other) noexcept : m_value(other.m_value) { UA_init(&other.m_value, type()); }
  Handle& operator=(Handle&& other) noexcept {
    if (this != &other) {
      UA_clear(&m_value, type());
      m_value = other.m_value;
      UA_init(&other.m_value, type());
    }
    return *this;
  }

  [[nodiscard]] static const UA_DataType* type() { return &UA_TYPES[TypeIndex]; }
  [[nodiscard]] T* get() { return &m_value; }
  [[nodiscard]] const T* get() const { return &m_value; }
  T* operator->() { return &m_value; }
  const T* operator->() const { return &m_value; }

 private:
  T m_value;
};

/// A library string that points into `text`: valid as long as it, and never to be cleared.
[[nodiscard]] inline UA_String borrow(std::string_view text) {
  UA_String string{};
  string.length = text.size();
  // The library declares what it only reads as mutable.
  string.data = reinterpret_cast<UA_Byte*>(const_cast<char*>(text.data()));
  return string;
}

/// The bytes of a library string; valid as long as it.
[[nodiscard]] inline std::string_view view(const UA_String& string) {
  return {reinterpret_cast<const char*>(string.data), string.length};
}

/// A node id with a string identifier that points into `identifier`; never to be cleared.
[[nodiscard]] inline UA_NodeId borrowNodeId(UA_UInt16 namespaceIndex, std::string_view identifier) {
  UA_NodeId id{};
  id.namespaceIndex = namespaceIndex;
  id.identifierType = UA_NODEIDTYPE_STRING;
  id.identifier.string = borrow(identifier);
  return id;
}

/// A node id of the standard's own namespace.
[[nodiscard]] inline UA_NodeId standardNodeId(UA_UInt32 identifier) {
  UA_NodeId id{};
  id.identifierType = UA_NODEIDTYPE_NUMERIC;
  id.identifier.numeric = identifier;
  return id;
}

/// A variant that points at `value`; never to be cleared.
template <class T>
[[nodiscard]] UA_Variant borrowScalar(T& value, std::size_t typeIndex) {
  UA_Variant variant;
  UA_Variant_init(&variant);
  UA_Variant_setScalar(&variant, &value, &UA_TYPES[typeIndex]);
  return variant;
}

/// The scalar of a variant if it has just this type, else null.
template <class T>
[[nodiscard]] const T* scalarOf(const UA_Variant& variant, std::size_t typeIndex) {
  return UA_Variant_hasScalarType(&variant, &UA_TYPES[typeIndex])
             ? static_cast<const T*>(variant.data)
             : nullptr;
}

/// Whether each input of a method is one value. The library has compared their number and types,
/// but takes an array without elements for a scalar, and its data point at nothing.
[[nodiscard]] inline bool areScalars(const UA_Variant* inputs, std::size_t count) {
  return std::all_of(inputs, inputs + count,
                     [](const UA_Variant& input) { return UA_Variant_isScalar(&input); });
}

}  // namespace rivulet::opcua
