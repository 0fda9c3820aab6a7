// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/connection/connection_state.h"

#include <QCoreApplication>

#include "widgets/common/number_format.h"

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

  static ProgramStatusText programStatus(std::optional<int> status) {
    if (!status) {
      return {Status::Unknown, noValue()};
    }
    switch (*status) {
      case 1:
        return {Status::Attention, tr("Interrupted")};
      case 2:
        return {Status::Good, tr("Stopped")};
      case 3:
        return {Status::Busy, tr("Running")};
      case 4:
        return {Status::Busy, tr("Waiting")};
      case 5:
        return {Status::Good, tr("Ended")};
      default:
        return {Status::Unknown, tr("Unknown (%1)").arg(*status)};
    }
  }
};

}  // namespace

QString connectionText(ConnectionState state) {
  return ConnectionTexts::text(state);
}

ProgramStatusText programStatusText(std::optional<int> programStatus) {
  return ConnectionTexts::programStatus(programStatus);
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
