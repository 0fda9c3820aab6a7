// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Failures of a connection to a control. OPC UA status codes end here.
#pragma once

#include <cstdint>
#include <span>
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
  TooManyItems,        ///< request larger than the link accepts
  EncryptionMissing,   ///< the server does not offer the protection that is asked for
  CertificateUnknown,  ///< the server's certificate has never been accepted
  CertificateChanged,  ///< another certificate has been accepted for this server
  CertificateInvalid,  ///< unreadable, not yet valid, or ended
  ClientNotTrusted,    ///< the server does not trust this computer's certificate
  LoginRefused,        ///< user name or password are wrong, missing, or not taken
  HostUnknown,         ///< the name of the server's computer cannot be looked up
  NoHandles,           ///< this computer, or this program, may open no further connection
  NoHistory,           ///< the server has not recorded this variable
};

[[nodiscard]] std::error_code make_error_code(LinkError code);

/// Whether the server has answered no: made again, a request that was falsified on its way is
/// right.
[[nodiscard]] bool mayBeFalsified(const std::error_code& code);

/// What to do about a variable that was refused repeatedly.
[[nodiscard]] std::string_view remedyForItem(const std::error_code& status);

/// Why a server refuses with a status code of OPC UA (Part 6, A.2), and what to do about it.
struct StatusAdvice {
  std::uint32_t code = 0;
  std::string_view name;  ///< "BadUserAccessDenied"
  std::string_view cause;
  std::string_view nextStep;
  LinkError whileConnecting = LinkError::NotReachable;
};

/// All status codes that are known to occur while connecting and in requests of their own. What a
/// code means for one variable or method depends on what was asked; see `linkErrorOf`.
[[nodiscard]] std::span<const StatusAdvice> statusAdvice();
/// The row of a code; null for one that is not in the table.
[[nodiscard]] const StatusAdvice* adviceOn(std::uint32_t code);

}  // namespace rivulet::opcua

template <>
struct std::is_error_code_enum<rivulet::opcua::LinkError> : std::true_type {};
