// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The state of the connection in the operator's words, the same wherever it is shown.
/// @threadsafety GUI thread.
#pragma once

#include "opcua/security.h"
#include "widgets/common/status_label.h"
#include "widgets/connection/machine_view.h"

namespace rivulet::widgets {

/// "Connected", "Connection lost", …
[[nodiscard]] QString connectionText(ConnectionState state);
[[nodiscard]] Status connectionStatus(ConnectionState state);

/// How a connection is protected.
struct ProtectionText {
  Status status = Status::Good;
  QString icon;      ///< name of an icon
  QString word;      ///< "encrypted", "not protected"
  QString sentence;  ///< what it means
};
[[nodiscard]] ProtectionText protectionText(opcua::Protection protection);

struct ProgramStatusText {
  Status status = Status::Unknown;
  QString text;
};
/// @param programStatus  opcua::VariableKind::ProgramStatus; nothing: not known
[[nodiscard]] ProgramStatusText programStatusText(std::optional<int> programStatus);

}  // namespace rivulet::widgets
