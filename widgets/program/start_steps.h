// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// In place of a program while none is open: the three steps to a moving machine, side by side, or
/// one below the other in a narrow window. The step that comes next has the coloured button.
/// @threadsafety GUI thread.
#pragma once

#include <array>

#include "widgets/common/page.h"
#include "widgets/connection/machine_view.h"

class QBoxLayout;

namespace rivulet::widgets {

class StatusLabel;

class StartSteps final : public Page {
  Q_OBJECT

 public:
  explicit StartSteps(QWidget* parent = nullptr);

  void setConnection(ConnectionState state);
  void setOpenEnabled(bool enabled);
  /// @param name  empty: there is none
  void setSample(const QString& name);

 Q_SIGNALS:
  void virtualMachineRequested();
  /// The operator names an address.
  void connectRequested();
  void openRequested();
  void sampleRequested();
  void liveRequested();

 protected:
  void restyle() override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* card(int number, QLabel* title, QLabel* text, std::initializer_list<InBox> below);
  void showSteps();

  ConnectionState m_connection = ConnectionState::Disconnected;
  QString m_sample;

  std::array<QLabel*, 3> m_numbers{};
  StatusLabel* m_state;
  QPushButton* m_virtual;
  QPushButton* m_connect;
  QPushButton* m_open;
  QPushButton* m_openSample;
  QPushButton* m_live;
  QBoxLayout* m_cards;
};

}  // namespace rivulet::widgets
