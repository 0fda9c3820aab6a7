// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Failures of a connection to a control. OPC UA status codes end here.
#pragma once

#include <string_view>
#include <system_error>

namespace rivulet::opcua {

enum class LinkError {
  NotReachable = 1,   ///< no server answers at the endpoint
  ConnectionLost,     ///< it was there and is gone
  DeadlineExceeded,   ///< no answer in time; the request may still have been carried out
  VariableMissing,    ///< the control has no such variable
  NotWritable,        ///< write access is missing
  BadValue,           ///< NaN or infinity offered, or an unusable type received
  Rejected,           ///< the server refused the request
  NamespaceMissing,   ///< the server is not a SINUMERIK (no SinumerikVarProvider)
  MethodMissing,      ///< the server does not offer the method
  ProgramMissing,     ///< no such program on the control
  ChannelNotInReset,  ///< a program can be selected and started only in reset
  FileExists,
  TooManyItems,  ///< request larger than the link accepts
};

[[nodiscard]] std::error_code make_error_code(LinkError code);

/// Whether the server has answered no: made again, a request that was falsified on its way is
/// right.
[[nodiscard]] bool mayBeFalsified(const std::error_code& code);

/// What to do about a variable that was refused repeatedly.
[[nodiscard]] std::string_view remedyForItem(const std::error_code& status);

}  // namespace rivulet::opcua

template <>
struct std::is_error_code_enum<rivulet::opcua::LinkError> : std::true_type {};
