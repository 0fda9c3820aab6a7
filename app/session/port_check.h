// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Whether something answers at the port of a machine: a connection that is closed again at once,
/// without a word of OPC UA. It costs a control no access.
/// @threadsafety GUI thread; it never waits.
#pragma once

#include <QObject>
#include <QSet>
#include <QString>

namespace rivulet::session {

class PortCheck final : public QObject {
  Q_OBJECT

 public:
  /// Tries to connect; without an effect while it does so already. @param endpoint  of OPC UA
  void look(const QString& endpoint);

 Q_SIGNALS:
  void looked(const QString& endpoint, bool isThere);

 private:
  QSet<QString> m_inProgress;
};

}  // namespace rivulet::session
