// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A client of a service on this computer, without encryption: for scripts, probes and tests. Other
/// clients need nothing of Rivulet. @threadsafety one object, one thread; its calls wait.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "service/service_session.h"

namespace rivulet::service {

/// In place of a variable that is shown only after a login.
inline constexpr std::string_view kHidden = "(shown after login)";

class ServiceClient {
 public:
  /// @param endpoint  on this computer @return NotReachable, and if it is on another computer
  [[nodiscard]] static base::Result<std::unique_ptr<ServiceClient>> connect(
      const std::string& endpoint);
  ~ServiceClient();
  ServiceClient(const ServiceClient&) = delete;
  ServiceClient& operator=(const ServiceClient&) = delete;

  /// All variables as text, by their identifiers. @return NotReachable
  [[nodiscard]] base::Result<std::map<std::string, std::string>> read();
  /// @return NotReachable; MethodMissing: the service has no such method, or not these inputs
  [[nodiscard]] base::Result<Answer> call(const std::string& method,
                                          const std::vector<std::string>& inputs);

 private:
  class Impl;
  explicit ServiceClient(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> m_impl;
};

}  // namespace rivulet::service
