// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "service/announcer.h"

#include <fmt/format.h>

#include <chrono>
#include <utility>

#include "platform/log.h"
#include "service/node_table.h"

namespace rivulet::service {

namespace {

/// A discovery server forgets who is silent for some minutes.
constexpr std::chrono::seconds kAnnounceInterval{60};
constexpr std::chrono::seconds kTellMax{2};

}  // namespace

Announcer::Announcer(std::string discoveryServer, const std::string& endpoint)
    : m_discoveryServer(std::move(discoveryServer)),
      m_own{
          std::string(kProductName),
          // All services of a user have one certificate; a discovery server needs different names.
          fmt::format("{}:{}", kNamespaceUri, endpoint),
          std::string(kNamespaceUri),
          {endpoint}} {
  if (!m_discoveryServer.empty()) {
    m_thread = std::thread([this] { work(); });
  }
}

Announcer::~Announcer() {
  if (m_thread.joinable()) {
    {
      const std::lock_guard lock(m_mutex);
      m_ends = true;
    }
    m_wake.notify_all();
    m_thread.join();
  }
}

void Announcer::work() {
  bool wasTold = true;  // a failure is logged once
  std::unique_lock lock(m_mutex);
  for (;;) {
    const bool isOnline = !m_ends;
    lock.unlock();
    const auto told = opcua::registerServer(m_discoveryServer, m_own, isOnline, kTellMax);
    if (!told && wasTold) {
      log::logger().warn("The discovery server is not told of this service: {}",
                         told.error().text());
    }
    wasTold = told.has_value();
    lock.lock();
    if (!isOnline) {
      return;
    }
    m_wake.wait_for(lock, kAnnounceInterval, [this] { return m_ends; });
  }
}

}  // namespace rivulet::service
