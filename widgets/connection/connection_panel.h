// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Where the operator connects to a machine and sees what it does, and whether that is up to date.
/// @threadsafety GUI thread.
#pragma once

#include <optional>

#include "opcua/security.h"
#include "widgets/common/page.h"
#include "widgets/connection/control_fields.h"
#include "widgets/connection/login_fields.h"
#include "widgets/connection/machine_view.h"

class QGroupBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace rivulet::widgets {

class DescribedMachineBox;
class StatusLabel;

class ConnectionPanel final : public Page {
  Q_OBJECT

 public:
  explicit ConnectionPanel(QWidget* parent = nullptr);

  void setEndpoint(const QString& endpoint);
  [[nodiscard]] QString endpoint() const;
  /// @param detail  one sentence on why, for Lost; may be empty
  void setConnectionState(ConnectionState state, const QString& detail = {});
  void setLogin(const LoginView& login) { m_login->setLogin(login); }
  /// What was chosen for the machine of the endpoint.
  void setControl(const ControlChoice& choice) { m_control->setChoice(choice); }
  void setHasQtOpcUa(bool hasQtOpcUa) { m_control->setHasQtOpcUa(hasQtOpcUa); }
  /// @param protection  nothing: not connected, or there is no network between
  void setProtection(std::optional<opcua::Protection> protection,
                     const std::optional<opcua::ChannelSecurity>& security);
  void setMachineState(const MachineView& machine);
  /// During a run, disconnecting is not possible.
  void setDisconnectEnabled(bool enabled);

 Q_SIGNALS:
  void connectRequested(const QString& endpoint, const rivulet::widgets::Login& login,
                        const rivulet::widgets::ControlChoice& control);
  void disconnectRequested();

 protected:
  void restyle() override;

 private:
  void requestConnection();
  void buildConnection();
  void buildMachine();
  void showConnection();
  void showProtection();
  void showMachine();
  void showChannel();

  ConnectionState m_state = ConnectionState::Disconnected;
  QString m_detail;
  std::optional<opcua::Protection> m_protectionKind;
  std::optional<opcua::ChannelSecurity> m_security;
  MachineView m_machine;
  bool m_disconnectEnabled = true;

  QGroupBox* m_connectionGroup = group({.text = QT_TR_NOOP("Connection")});
  QLineEdit* m_endpoint = lineEdit();
  QPushButton* m_connect = button({.id = "connect"});
  StatusLabel* m_connectionStatus = status({.wraps = true});
  StatusLabel* m_virtualBadge = status({.wraps = true});
  StatusLabel* m_protection = status({.id = "protection", .wraps = true});
  ControlFields* m_control;
  LoginFields* m_login;
  DescribedMachineBox* m_described;

  QGroupBox* m_machineGroup = group({.text = QT_TR_NOOP("Machine")});
  StatusLabel* m_channel = status();
  StatusLabel* m_programStatus = status();
  QLabel* m_programName = value({.wraps = true});
  StatusLabel* m_alarm = status({.wraps = true});
  QLabel* m_message = value({.wraps = true});
};

}  // namespace rivulet::widgets
