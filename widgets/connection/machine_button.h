// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The machine at the top of the window: the state of the connection in shape, word and colour, and
/// how long nothing has been heard from it. Pressing it opens what there is to know.
/// @threadsafety GUI thread.
#pragma once

#include <QToolButton>

#include "widgets/connection/machine_view.h"

namespace rivulet::widgets {

class MachineButton final : public QToolButton {
  Q_OBJECT

 public:
  explicit MachineButton(QWidget* parent = nullptr);

  void setConnectionState(ConnectionState state);
  void setMachineState(const MachineView& machine);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void show();

  ConnectionState m_state = ConnectionState::Disconnected;
  bool m_isVirtual = false;
  int m_silentS = 0;  ///< whole seconds since anything was heard
};

}  // namespace rivulet::widgets
