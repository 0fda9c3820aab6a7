// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The machine at the top of the window: the state of the connection in shape, word and colour, and
/// how long nothing has been heard from it; below it, how the connection is protected. Pressing it
/// opens what there is to know.
/// @threadsafety GUI thread.
#pragma once

#include <QToolButton>
#include <optional>

#include "widgets/connection/connection_state.h"
#include "widgets/connection/machine_view.h"

namespace rivulet::widgets {

class MachineButton final : public QToolButton {
  Q_OBJECT

 public:
  explicit MachineButton(QWidget* parent = nullptr);

  /// @param protection  nothing: there is no network between
  /// @param security    as it is named, "Aes256_Sha256_RsaPss, SignAndEncrypt"
  void setConnectionState(ConnectionState state,
                          std::optional<opcua::Protection> protection = std::nullopt,
                          const QString& security = {});
  void setMachineState(const MachineView& machine);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void show();

  [[nodiscard]] QIcon icon(Status status, const ProtectionText* protection) const;

  ConnectionState m_state = ConnectionState::Disconnected;
  std::optional<opcua::Protection> m_protection;
  QString m_security;
  bool m_isVirtual = false;
  int m_silentS = 0;  ///< whole seconds since anything was heard
};

}  // namespace rivulet::widgets
