// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A client of Qt OPC UA in a thread of its own, whose event loop it needs. What is asked and
/// what is answered is passed between this thread and that of the caller.
/// @threadsafety one object, one thread at a time, which need not have an event loop.
#pragma once

#include <QByteArray>
#include <QList>
#include <QOpcUaClient>
#include <QString>
#include <cstdint>
#include <memory>
#include <optional>

#include "base/instant.h"
#include "opcua/open62541/monotonic_clock.h"

namespace rivulet::qtopcua {

/// BadNotSupported, which no server answers here.
inline constexpr std::uint32_t kNoBackend = 0x803D0000;

/// To one service call.
struct Answer {
  std::uint64_t serial = 0;
  base::Instant at{};        ///< when it arrived
  std::uint32_t status = 0;  ///< of the service call, as OPC UA counts them
  QList<QOpcUaReadResult> readings;
  QList<QOpcUaWriteResult> writes;
  QVariant outputs;  ///< of a method: a list if there are several
};

/// Qt OPC UA does not say to which of several calls an answer belongs: the next call may be made
/// only when the one before it has been answered.
class ClientThread {
 public:
  /// Starts the thread. @param clock  for the times of answers; outlives this object
  explicit ClientThread(const opcua::MonotonicClock& clock);
  /// Closes the connection; blocks a second at most, whatever the other side does.
  ~ClientThread();
  ClientThread(const ClientThread&) = delete;
  ClientThread& operator=(const ClientThread&) = delete;

  /// Without encryption and without a user. @return status code; 0: it is connected, and
  /// `kNoBackend`: Qt OPC UA is installed without its plugin
  [[nodiscard]] std::uint32_t connect(const QString& endpoint, const QString& sessionName,
                                      base::Instant deadline);

  void read(std::uint64_t serial, QList<QOpcUaReadItem> items);
  void write(std::uint64_t serial, QList<QOpcUaWriteItem> items);
  /// @param object, method  node ids
  void call(std::uint64_t serial, const QString& object, const QString& method,
            QList<QOpcUa::TypedVariant> inputs);

  /// The next answer. @return nothing if the time has come, or the connection is lost
  [[nodiscard]] std::optional<Answer> take(base::Instant until);
  /// It was there and is gone.
  [[nodiscard]] bool isLost() const;

 private:
  class Worker;
  std::shared_ptr<Worker> m_worker;
};

}  // namespace rivulet::qtopcua
