// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/open62541/values.h"

#include <open62541/types_generated.h>

#include <cmath>
#include <limits>
#include <utility>

#include "opcua/open62541/handle.h"
#include "opcua/open62541/status.h"

namespace rivulet::opcua {

namespace {

template <class T>
[[nodiscard]] std::optional<double> numberAs(const UA_Variant& variant, std::size_t typeIndex) {
  const T* value = scalarOf<T>(variant, typeIndex);
  return value == nullptr ? std::nullopt : std::optional(static_cast<double>(*value));
}

/// The numbers of an array of doubles or floats; empty for anything else, or another length.
[[nodiscard]] std::vector<double> numbersOf(const UA_DataValue& value, std::size_t length) {
  const UA_Variant& array = value.value;
  if (!value.hasValue || array.arrayLength != length) {
    return {};
  }
  if (UA_Variant_hasArrayType(&array, &UA_TYPES[UA_TYPES_DOUBLE])) {
    const auto* const numbers = static_cast<const double*>(array.data);
    return {numbers, numbers + length};
  }
  if (UA_Variant_hasArrayType(&array, &UA_TYPES[UA_TYPES_FLOAT])) {
    const auto* const numbers = static_cast<const float*>(array.data);
    return {numbers, numbers + length};
  }
  return {};
}

}  // namespace

std::optional<double> numberOf(const UA_Variant& variant) {
  if (variant.type == nullptr || !UA_Variant_isScalar(&variant)) {
    return std::nullopt;
  }
  switch (variant.type->typeKind) {
    case UA_DATATYPEKIND_BOOLEAN:
      return numberAs<UA_Boolean>(variant, UA_TYPES_BOOLEAN);
    case UA_DATATYPEKIND_SBYTE:
      return numberAs<UA_SByte>(variant, UA_TYPES_SBYTE);
    case UA_DATATYPEKIND_BYTE:
      return numberAs<UA_Byte>(variant, UA_TYPES_BYTE);
    case UA_DATATYPEKIND_INT16:
      return numberAs<UA_Int16>(variant, UA_TYPES_INT16);
    case UA_DATATYPEKIND_UINT16:
      return numberAs<UA_UInt16>(variant, UA_TYPES_UINT16);
    case UA_DATATYPEKIND_INT32:
      return numberAs<UA_Int32>(variant, UA_TYPES_INT32);
    case UA_DATATYPEKIND_UINT32:
      return numberAs<UA_UInt32>(variant, UA_TYPES_UINT32);
    case UA_DATATYPEKIND_INT64:
      return numberAs<UA_Int64>(variant, UA_TYPES_INT64);
    case UA_DATATYPEKIND_UINT64:
      return numberAs<UA_UInt64>(variant, UA_TYPES_UINT64);
    case UA_DATATYPEKIND_FLOAT:
      return numberAs<UA_Float>(variant, UA_TYPES_FLOAT);
    case UA_DATATYPEKIND_DOUBLE:
      return numberAs<UA_Double>(variant, UA_TYPES_DOUBLE);
    default:
      return std::nullopt;
  }
}

unsigned bitsOf(const UA_DataValue& value) {
  const auto number = value.hasValue ? numberOf(value.value) : std::nullopt;
  const bool isMask = number && *number >= 0.0 && *number <= std::numeric_limits<unsigned>::max();
  return isMask ? static_cast<unsigned>(*number) : 0U;
}

std::optional<std::string> textOf(const UA_Variant& variant) {
  if (const auto* string = scalarOf<UA_String>(variant, UA_TYPES_STRING)) {
    return std::string(view(*string));
  }
  if (const auto* localized = scalarOf<UA_LocalizedText>(variant, UA_TYPES_LOCALIZEDTEXT)) {
    return std::string(view(localized->text));
  }
  return std::nullopt;
}

Reading readingOf(const UA_DataValue& value, VariableKind kind) {
  Reading reading;
  if (value.hasStatus && isBad(value.status)) {
    reading.status = linkErrorOf(value.status, Operation::Read);
    return reading;
  }
  if (isText(kind)) {
    if (auto text = value.hasValue ? textOf(value.value) : std::nullopt) {
      reading.text = std::move(*text);
      return reading;
    }
  } else if (const auto number = value.hasValue ? numberOf(value.value) : std::nullopt;
             number && std::isfinite(*number)) {
    reading.number = *number;
    return reading;
  }
  reading.status = LinkError::BadValue;
  return reading;
}

Reading mappedReading(const UA_DataValue& value, const ControlMap& map, const Variable& variable) {
  if (isText(variable.kind) || (value.hasStatus && isBad(value.status))) {
    return readingOf(value, variable.kind);
  }
  std::optional<StateValue> shown;
  if (const auto number = value.hasValue ? numberOf(value.value) : std::nullopt) {
    shown = *number;
  } else if (auto text = value.hasValue ? textOf(value.value) : std::nullopt) {
    shown = std::move(*text);
  }
  const auto meant = shown ? meaningOf(map, variable, *shown) : std::nullopt;
  Reading reading;
  if (meant && std::isfinite(*meant)) {
    reading.number = *meant;
  } else {
    reading.status = LinkError::BadValue;
  }
  return reading;
}

NodeValue nodeValueOf(const UA_Variant& variant) {
  if (const auto* flag = scalarOf<UA_Boolean>(variant, UA_TYPES_BOOLEAN)) {
    return *flag;
  }
  if (const auto number = numberOf(variant)) {
    return *number;
  }
  if (auto text = textOf(variant)) {
    return *std::move(text);
  }
  if (UA_Variant_hasArrayType(&variant, &UA_TYPES[UA_TYPES_DOUBLE])) {
    const auto* const numbers = static_cast<const double*>(variant.data);
    return std::vector<double>(numbers, numbers + variant.arrayLength);
  }
  return {};
}

void appendReadings(const UA_DataValue& value, std::size_t length, std::vector<Reading>& readings) {
  const bool bad = value.hasStatus && isBad(value.status);
  const std::vector<double> numbers = bad ? std::vector<double>() : numbersOf(value, length);
  for (std::size_t i = 0; i < length; ++i) {
    Reading reading;
    if (bad) {
      reading.status = linkErrorOf(value.status, Operation::Read);
    } else if (numbers.empty() || !std::isfinite(numbers[i])) {
      reading.status = LinkError::BadValue;
    } else {
      reading.number = numbers[i];
    }
    readings.push_back(std::move(reading));
  }
}

bool takeNotification(const UA_NotificationMessage& message, std::vector<NodeChange>& changes) {
  for (std::size_t i = 0; i < message.notificationDataSize; ++i) {
    const UA_ExtensionObject& data = message.notificationData[i];
    if (data.encoding < UA_EXTENSIONOBJECT_DECODED) {
      continue;  // of a kind that the library does not know
    }
    const void* const content = data.content.decoded.data;
    if (data.content.decoded.type == &UA_TYPES[UA_TYPES_STATUSCHANGENOTIFICATION]) {
      return !isBad(static_cast<const UA_StatusChangeNotification*>(content)->status);
    }
    if (data.content.decoded.type != &UA_TYPES[UA_TYPES_DATACHANGENOTIFICATION]) {
      continue;
    }
    const auto& told = *static_cast<const UA_DataChangeNotification*>(content);
    for (std::size_t k = 0; k < told.monitoredItemsSize; ++k) {
      const UA_DataValue& value = told.monitoredItems[k].value;
      const bool isGood = value.hasValue && !(value.hasStatus && isBad(value.status));
      changes.push_back(
          {told.monitoredItems[k].clientHandle, isGood ? nodeValueOf(value.value) : NodeValue()});
    }
  }
  return true;
}

}  // namespace rivulet::opcua
