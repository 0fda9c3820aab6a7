// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// OPC UA status codes are translated here into Rivulet's errors. @threadsafety pure.
#pragma once

#include <open62541/types.h>

#include <string>

#include "base/error.h"
#include "opcua/error.h"

namespace rivulet::opcua {

enum class Operation { Read, Write, Call };

/// Meaning of a bad status of one item or of a whole service call.
[[nodiscard]] LinkError linkErrorOf(UA_StatusCode status, Operation operation);

/// True if this status means that the connection (channel or session) is gone.
[[nodiscard]] bool meansConnectionLost(UA_StatusCode status);

/// True if the severity bits say "bad"; an uncertain value is still a value.
[[nodiscard]] constexpr bool isBad(UA_StatusCode status) {
  return (status >> 30U) >= 2U;
}

/// One sentence for people, and what to do.
[[nodiscard]] std::string sentenceOf(LinkError error);

/// The error of a failed request: sentence, name of the status code, place.
[[nodiscard]] base::Error requestError(UA_StatusCode status, Operation operation,
                                       const std::string& context);

}  // namespace rivulet::opcua
