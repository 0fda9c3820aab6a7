// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The state of the connection in the operator's words, the same wherever it is shown.
/// @threadsafety GUI thread.
#pragma once

#include "widgets/common/status_label.h"
#include "widgets/connection/machine_view.h"

namespace rivulet::widgets {

/// "Connected", "Connection lost", …
[[nodiscard]] QString connectionText(ConnectionState state);
[[nodiscard]] Status connectionStatus(ConnectionState state);

struct ProgramStatusText {
  Status status = Status::Unknown;
  QString text;
};
/// @param programStatus  opcua::VariableKind::ProgramStatus; nothing: not known
[[nodiscard]] ProgramStatusText programStatusText(std::optional<int> programStatus);

}  // namespace rivulet::widgets
