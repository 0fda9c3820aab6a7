// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A live source of corrections: datagrams to a UDP port on 127.0.0.1, to which no other computer
/// can send. Each holds lines for `streaming::CorrectionLines`.
/// @threadsafety GUI thread.
#pragma once

#include <QObject>
#include <QTimer>

#include "base/vec3.h"
#include "streaming/run/correction_lines.h"

class QUdpSocket;

namespace rivulet::session {

/// State of the source.
struct FeedState {
  bool isOpen = false;
  bool hasValue = false;  ///< since `forget`
  bool isSilent = false;  ///< nothing has been received for longer than the silence
  std::size_t unknown = 0;
  base::Vec3 valueMm;
};

class CorrectionFeed final : public QObject {
  Q_OBJECT

 public:
  explicit CorrectionFeed(QObject* parent = nullptr);

  /// Listens from now on; earlier values are forgotten. @param port  0: any free port
  /// @return false if the port cannot be opened
  bool open(quint16 port, int silenceMs);
  void close();
  /// A new run: its correction begins at zero.
  void forget();
  [[nodiscard]] const FeedState& state() const { return m_state; }
  /// 0: closed.
  [[nodiscard]] quint16 port() const;

 Q_SIGNALS:
  /// A line with a correction was received.
  void valueArrived(const rivulet::base::Vec3& valueMm);
  /// Any other change of the state.
  void stateChanged(const rivulet::session::FeedState& state);

 private:
  void receive();

  QUdpSocket* m_socket;
  QTimer m_silence;
  streaming::CorrectionLines m_lines;
  FeedState m_state;
};

}  // namespace rivulet::session
