// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "session/correction_feed.h"

#include <QHostAddress>
#include <QNetworkDatagram>
#include <QUdpSocket>

namespace rivulet::session {

namespace {

/// At most this much is read at a time, so that the window stays responsive.
constexpr int kDatagramsMax = 256;

}  // namespace

CorrectionFeed::CorrectionFeed(QObject* parent) : QObject(parent), m_socket(new QUdpSocket(this)) {
  m_silence.setSingleShot(true);
  connect(&m_silence, &QTimer::timeout, this, [this] {
    m_state.isSilent = true;
    Q_EMIT stateChanged(m_state);
  });
  connect(m_socket, &QUdpSocket::readyRead, this, &CorrectionFeed::receive);
}

bool CorrectionFeed::open(quint16 port, int silenceMs) {
  m_socket->close();
  m_silence.setInterval(silenceMs);
  m_state = {};
  m_state.isOpen = m_socket->bind(QHostAddress(QHostAddress::LocalHost), port,
                                  QAbstractSocket::DontShareAddress);
  forget();
  return m_state.isOpen;
}

void CorrectionFeed::close() {
  m_socket->close();
  m_silence.stop();
  m_state = {};
  Q_EMIT stateChanged(m_state);
}

void CorrectionFeed::forget() {
  m_lines = {};
  const bool isOpen = m_state.isOpen;
  m_state = {};
  m_state.isOpen = isOpen;
  m_silence.stop();
  if (isOpen) {
    m_silence.start();
  }
  Q_EMIT stateChanged(m_state);
}

quint16 CorrectionFeed::port() const {
  return m_state.isOpen ? m_socket->localPort() : quint16{0};
}

void CorrectionFeed::receive() {
  bool says = false;
  for (int i = 0; i < kDatagramsMax && m_socket->hasPendingDatagrams(); ++i) {
    const QByteArray bytes = m_socket->receiveDatagram().data();
    says = m_lines.add({bytes.constData(), static_cast<std::size_t>(bytes.size())}) || says;
    if (!bytes.endsWith('\n')) {
      says = m_lines.finishLine() || says;  // no line continues in the next datagram
    }
  }
  if (m_socket->hasPendingDatagrams()) {
    QMetaObject::invokeMethod(this, &CorrectionFeed::receive, Qt::QueuedConnection);
  }
  m_state.unknown = m_lines.unknownCount();
  if (says) {
    m_state.hasValue = true;
    m_state.isSilent = false;
    m_state.valueMm = m_lines.valueMm();
    m_silence.start();
    Q_EMIT valueArrived(m_state.valueMm);
  }
  Q_EMIT stateChanged(m_state);
}

}  // namespace rivulet::session
