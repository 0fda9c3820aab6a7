// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The OPC UA server of the service: shows a session's snapshot as variables, and passes methods to
/// it. Who calls is whom the client has logged in as; without users everybody is an engineer, as in
/// the window. @threadsafety the thread of the session.
#pragma once

#include <memory>
#include <string>

#include "base/instant.h"
#include "base/result.h"
#include "machine/front/server.h"
#include "preparation/user_file.h"
#include "service/service_session.h"

namespace rivulet::service {

class ServiceServer {
 public:
  /// Listens from now on; requests are answered only in `iterate`.
  /// @param session  outlives the server  @param users  none: nobody is set up
  /// @return as `machine::Server::start`
  [[nodiscard]] static base::Result<std::unique_ptr<ServiceServer>> start(
      ServiceSession& session, const preparation::UserFile& users,
      const machine::ServerOptions& options);
  /// Closes all connections.
  ~ServiceServer();
  ServiceServer(const ServiceServer&) = delete;
  ServiceServer& operator=(const ServiceServer&) = delete;

  [[nodiscard]] const std::string& endpoint() const;
  /// Serves what has arrived; waits for it no longer than `timeout`. Then the variables show the
  /// session as it is.
  void iterate(base::Duration timeout);

 private:
  class Impl;
  explicit ServiceServer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> m_impl;
};

}  // namespace rivulet::service
