// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// All machines that this computer knows, a card each. One of them can be connected at a time; of
/// the others it is said what is known without asking them. @threadsafety GUI thread.
#pragma once

#include <vector>

#include "widgets/common/page.h"
#include "widgets/connection/machine_view.h"

class QGridLayout;
class QLabel;

namespace rivulet::widgets {

/// What is known of a machine.
struct MachineCardView {
  QString name;  ///< may be empty: the endpoint stands for it
  QString endpoint;
  bool isPresent = false;  ///< the one of this window, connected or not
  ConnectionState connection = ConnectionState::Disconnected;
  MachineView machine;     ///< if it is connected
  QString program;         ///< the run in progress; empty: none
  double progress = 0.0;   ///< 0 to 1, of that run
  QString lastRun;         ///< a sentence; empty: none is known
  std::size_t alarms = 0;  ///< that are active, of the present machine
};

class MachineCard;

class MachinesPage final : public Page {
  Q_OBJECT

 public:
  explicit MachinesPage(QWidget* parent = nullptr);

  void setMachines(const std::vector<MachineCardView>& machines);
  /// During a run the window stays with its machine. @param why  empty: any may be opened
  void setBlocked(const QString& why);

 Q_SIGNALS:
  /// The operator wants to work at this machine: connect if it is not connected.
  void openRequested(const QString& endpoint);

 protected:
  void retranslate() override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void place();

  QLabel* m_note;
  QGridLayout* m_grid;
  std::vector<MachineCard*> m_cards;
  QString m_blocked;
  int m_columns = 0;
};

}  // namespace rivulet::widgets
