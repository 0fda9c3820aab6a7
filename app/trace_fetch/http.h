// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Reads what an HTTP server answers. @threadsafety one thread at a time.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <system_error>

#include "base/instant.h"
#include "base/result.h"

namespace rivulet::trace_fetch {

enum class FetchError {
  NotReachable = 1,  ///< no such host, or nothing answers there
  TimedOut,          ///< an answer began too late, or came too slowly
  TooLarge,          ///< an answer with more bytes than may be held
  WrongAnswer,       ///< from something that is no MTConnect agent, or not as the standard says
  BadAddress,        ///< nothing can be read from it
  NoHttp,            ///< this program was built without the library
};

[[nodiscard]] std::error_code make_error_code(FetchError code);

/// Whether the server is there, not what it answers.
[[nodiscard]] bool isOfConnection(const base::Error& error);

class HttpReader {
 public:
  virtual ~HttpReader() = default;

  /// The body of the answer, whatever its status is if it is XML.
  /// @param url  "http://host:5000/current"
  /// @return the errors above; their context is the url
  [[nodiscard]] virtual base::Result<std::string> get(const std::string& url) = 0;
};

struct HttpLimits {
  base::Duration connectMax = std::chrono::seconds{5};
  base::Duration answerMax = std::chrono::seconds{60};   ///< from the request to its last byte
  base::Duration silenceMax = std::chrono::seconds{10};  ///< with less than 100 bytes per second
  std::uint64_t bytesMax = 100'000'000;                  ///< of one answer
};

/// Over the network: http, and https with the certificates that this system trusts. Redirections
/// are not followed. @return error NoHttp
[[nodiscard]] base::Result<std::unique_ptr<HttpReader>> makeHttpReader(const HttpLimits& limits);

}  // namespace rivulet::trace_fetch

template <>
struct std::is_error_code_enum<rivulet::trace_fetch::FetchError> : std::true_type {};
