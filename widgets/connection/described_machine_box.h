// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What a server says of its machine by OPC 40001-1 and OPC 40501-1: who made it, its state, its
/// program and job. Hidden if the server says nothing. Read-only.
/// @threadsafety GUI thread.
#pragma once

#include <array>

#include "widgets/common/page.h"
#include "widgets/connection/machine_view.h"

class QFormLayout;
class QGroupBox;

namespace rivulet::opcua {
struct DescribedMachine;
}

namespace rivulet::widgets {

class StatusLabel;

class DescribedMachineBox final : public Page {
  Q_OBJECT

 public:
  explicit DescribedMachineBox(QWidget* parent = nullptr);

  /// @param isConnected  else nothing is shown
  void setMachineState(const MachineView& machine, bool isConnected);

 protected:
  void retranslate() override;

 private:
  enum Row { Name, Maker, Model, Serial, State, Program, Job, Rows };
  void showDescription();
  /// @param isLive  it changes while the machine works
  void showRow(Row row, const QString& text, bool isLive);

  MachineView m_machine;
  bool m_isConnected = false;
  QGroupBox* m_group =
      group({.text = QT_TR_NOOP("Described by the server"),
             .tip = QT_TR_NOOP(
                 "What the server says of its machine by OPC 40001-1 (Machinery) and OPC 40501-1 "
                 "(Machine Tools). It is read every 10 s, and not while a run is in progress.")});
  QFormLayout* m_form;
  std::array<StatusLabel*, Rows> m_values{};
};

}  // namespace rivulet::widgets
