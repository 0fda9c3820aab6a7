// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "session/port_check.h"

#include <QNetworkProxy>
#include <QTcpSocket>
#include <QTimer>
#include <QUrl>
#include <chrono>

#include "opcua/node_map.h"

namespace rivulet::session {

namespace {

constexpr std::chrono::seconds kAnswerMax{2};

}  // namespace

void PortCheck::look(const QString& endpoint) {
  if (m_inProgress.contains(endpoint)) {
    return;
  }
  m_inProgress.insert(endpoint);
  auto* socket = new QTcpSocket(this);
  socket->setProxy(QNetworkProxy::NoProxy);
  const auto end = [this, socket, endpoint](bool isThere) {
    if (m_inProgress.remove(endpoint)) {
      socket->disconnect(this);
      socket->abort();
      socket->deleteLater();
      Q_EMIT looked(endpoint, isThere);
    }
  };
  connect(socket, &QTcpSocket::connected, this, [end] { end(true); });
  connect(socket, &QTcpSocket::errorOccurred, this, [end] { end(false); });
  QTimer::singleShot(kAnswerMax, socket, [end] { end(false); });
  const QUrl url(endpoint);
  socket->connectToHost(url.host(), static_cast<quint16>(url.port(opcua::kPort)));
}

}  // namespace rivulet::session
