// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/connection/connection_state.h"

#include <QCoreApplication>

namespace rivulet::widgets {

namespace {

struct ConnectionTexts {
  Q_DECLARE_TR_FUNCTIONS(ConnectionTexts)

 public:
  static QString text(ConnectionState state) {
    switch (state) {
      case ConnectionState::Disconnected:
        return tr("Not connected");
      case ConnectionState::Connecting:
        return tr("Connecting …");
      case ConnectionState::Connected:
        return tr("Connected");
      case ConnectionState::Lost:
        return tr("Connection lost");
    }
    return {};
  }
};

}  // namespace

QString connectionText(ConnectionState state) {
  return ConnectionTexts::text(state);
}

Status connectionStatus(ConnectionState state) {
  switch (state) {
    case ConnectionState::Disconnected:
      break;
    case ConnectionState::Connecting:
      return Status::Busy;
    case ConnectionState::Connected:
      return Status::Good;
    case ConnectionState::Lost:
      return Status::Fault;
  }
  return Status::Unknown;
}

}  // namespace rivulet::widgets
