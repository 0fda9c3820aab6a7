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

  static ProtectionText protection(opcua::Protection protection) {
    using opcua::Protection;
    switch (protection) {
      case Protection::Encrypted:
        return {Status::Good, QStringLiteral("locked"), tr("encrypted"),
                tr("Nobody on the network can read or change what is sent.")};
      case Protection::Signed:
        return {Status::Good, QStringLiteral("signed"), tr("signed"),
                tr("Nobody can change what is sent, but everybody on the network can read it.")};
      case Protection::Weak:
        return {Status::Attention, QStringLiteral("unlocked"), tr("weakly encrypted"),
                tr("This encryption was withdrawn: it can be broken with the means of today.")};
      case Protection::LocalOnly:
        return {Status::Plain, QStringLiteral("unlocked"), tr("not protected"),
                tr("Not encrypted. What is sent does not leave this computer.")};
      case Protection::None:
        break;
    }
    return {Status::Attention, QStringLiteral("unlocked"), tr("not protected"),
            tr("Everybody on the network can read what is sent, and move the machine.")};
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

ProtectionText protectionText(opcua::Protection protection) {
  return ConnectionTexts::protection(protection);
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
