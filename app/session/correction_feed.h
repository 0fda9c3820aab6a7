// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A live source of corrections: datagrams to a UDP port of this computer, 127.0.0.1, which no
/// other computer can send to. Each holds lines as `streaming::CorrectionLines` takes them.
/// @threadsafety GUI thread.
#pragma once

#include <QObject>
#include <QTimer>

#include "base/vec3.h"
#include "streaming/correction_lines.h"

class QUdpSocket;

namespace rivulet::session {

/// What the source is doing.
struct FeedState {
  bool isOpen = false;
  bool hasValue = false;  ///< since `forget`
  bool isSilent = false;  ///< nothing has come for longer than the silence
  std::size_t unknown = 0;
  base::Vec3 valueMm;
};

class CorrectionFeed final : public QObject {
  Q_OBJECT

 public:
  explicit CorrectionFeed(QObject* parent = nullptr);

  /// Listens from now on; what was heard before is forgotten. @param port  0: any that is free
  /// @return false if the port cannot be had
  bool open(quint16 port, int silenceMs);
  void close();
  /// A new run: its correction begins with nothing.
  void forget();
  [[nodiscard]] const FeedState& state() const { return m_state; }
  /// 0: closed.
  [[nodiscard]] quint16 port() const;

 Q_SIGNALS:
  /// A line said something.
  void valueArrived(const rivulet::base::Vec3& valueMm);
  /// Anything else than that.
  void stateChanged(const rivulet::session::FeedState& state);

 private:
  void receive();

  QUdpSocket* m_socket;
  QTimer m_silence;
  streaming::CorrectionLines m_lines;
  FeedState m_state;
};

}  // namespace rivulet::session
