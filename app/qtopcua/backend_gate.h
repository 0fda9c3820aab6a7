// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Holds the thread in which the plugin of Qt OPC UA serves the network while something is handed
/// over to it.
///
/// Why: before Qt 6.6.3 the plugin frees its connection as soon as that is lost, tells so by a
/// queued signal, and does not look whether the connection is there when it takes a request from
/// its queue. A request that was queued before the signal was heard ends the program (segmentation
/// fault in `__UA_Client_AsyncServiceEx`). While the thread waits here, the connection stays; what
/// the plugin has said of it before is in the client's queue, ahead of what is handed over; and
/// what was handed over is done before the timer runs that frees the connection.
/// @threadsafety that of the client.
#pragma once

#include <QOpcUaClient>
#include <functional>
#include <memory>

namespace rivulet::qtopcua {

class BackendGate {
 public:
  /// @param client  object of the client's thread; `pass` comes to its event loop
  explicit BackendGate(QObject* client);
  /// Before the client of Qt OPC UA ends. Nothing comes any more.
  ~BackendGate();
  BackendGate(const BackendGate&) = delete;
  BackendGate& operator=(const BackendGate&) = delete;

  /// Finds the thread. Blocks until it answers, a second at most; without an answer, `pass` and
  /// `hold` do not hold it. @param client  connected
  void find(QOpcUaClient& client);

  /// Runs `action` in the client's thread while the other one waits, later than all that the
  /// plugin has said until then.
  void pass(std::function<void()> action);

  /// Blocks until the thread waits, a second at most. @return it waits for as long as this lives
  [[nodiscard]] std::shared_ptr<void> hold();

 private:
  class Door;
  std::shared_ptr<Door> m_door;
  QObject* m_gate = nullptr;  ///< of the other thread, and ends with it
};

}  // namespace rivulet::qtopcua
