// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// OPC UA status codes are translated here into Rivulet's errors. @threadsafety pure.
#pragma once

#include <open62541/types.h>

#include <string>
#include <string_view>

#include "base/instant.h"
#include "base/result.h"
#include "opcua/error.h"
#include "opcua/request.h"

namespace rivulet::opcua {

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

/// The error of an attempt to connect.
[[nodiscard]] base::Error connectError(UA_StatusCode status, const std::string& endpoint);

/// The other side has been silent for so long that the connection counts as lost.
[[nodiscard]] base::Error silenceError(base::Duration silenceMax, const std::string& endpoint);

/// True if this status means that the server has ended the session; the network is not to blame.
[[nodiscard]] bool meansSessionEnded(UA_StatusCode status);

/// The server has ended the session of this client. Code: ConnectionLost.
[[nodiscard]] base::Error sessionEnded(const std::string& endpoint);

/// The type of an answer could not be read, and the connection was closed for it. Code:
/// ConnectionLost.
[[nodiscard]] base::Error unreadableAnswer(const std::string& endpoint);

/// A method has answered with other arguments than those of a SINUMERIK.
[[nodiscard]] base::Error unknownForm(std::string_view method);

/// A command was given that a real control does not take over OPC UA.
[[nodiscard]] base::Error onlyVirtual(const std::string& endpoint);

/// The answer of a method to `Select` or `CycleStart`.
/// @param status  as `SelectStatus` @param detail  empty: the sentence of the error
[[nodiscard]] base::Result<void> commandResult(int status, const std::string& subject,
                                               const std::string& detail = {});

}  // namespace rivulet::opcua
