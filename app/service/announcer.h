// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Tells a discovery server of OPC UA where the service is, each minute and when it ends. On a
/// thread of its own: nobody waits for a discovery server. @threadsafety construct and destroy.
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "opcua/open62541/discovery.h"

namespace rivulet::service {

class Announcer {
 public:
  /// @param discoveryServer  "opc.tcp://host:4840"; empty: none is told
  /// @param endpoint  of the service
  Announcer(std::string discoveryServer, const std::string& endpoint);
  /// Says that the service is gone; waits for that some seconds at most.
  ~Announcer();
  Announcer(const Announcer&) = delete;
  Announcer& operator=(const Announcer&) = delete;

 private:
  void work();

  std::string m_discoveryServer;
  opcua::FoundServer m_own;
  std::mutex m_mutex;
  std::condition_variable m_wake;
  bool m_ends = false;  ///< with `m_mutex`
  std::thread m_thread;
};

}  // namespace rivulet::service
