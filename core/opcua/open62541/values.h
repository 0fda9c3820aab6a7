// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What the values of a server mean to Rivulet, whatever types it gives them. @threadsafety pure
/// functions.
#pragma once

#include <open62541/types.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "opcua/control_map.h"
#include "opcua/link.h"
#include "opcua/node_watch.h"
#include "opcua/variable.h"

namespace rivulet::opcua {

/// The number of a scalar of any numeric type.
[[nodiscard]] std::optional<double> numberOf(const UA_Variant& variant);
/// Of a String or a LocalizedText.
[[nodiscard]] std::optional<std::string> textOf(const UA_Variant& variant);
/// A mask of bits, of whatever numeric type this server uses; no bit for what is none.
[[nodiscard]] unsigned bitsOf(const UA_DataValue& value);
[[nodiscard]] NodeValue nodeValueOf(const UA_Variant& variant);

[[nodiscard]] Reading readingOf(const UA_DataValue& value, VariableKind kind);
/// A reading of a variable that a map names.
[[nodiscard]] Reading mappedReading(const UA_DataValue& value, const ControlMap& map,
                                    const Variable& variable);
/// One reading per element of an array.
void appendReadings(const UA_DataValue& value, std::size_t length, std::vector<Reading>& readings);

/// What a server has told of its subscription.
/// @return false: the subscription has ended
[[nodiscard]] bool takeNotification(const UA_NotificationMessage& message,
                                    std::vector<NodeChange>& changes);

}  // namespace rivulet::opcua
