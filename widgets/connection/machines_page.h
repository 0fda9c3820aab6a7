// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// All machines that this computer knows, a card each. One of them can be connected at a time; of
/// the others it is said whether their port answers. @threadsafety GUI thread.
#pragma once

#include <optional>
#include <vector>

#include "streaming/run_summary.h"
#include "widgets/common/page.h"
#include "widgets/connection/machine_view.h"

class QGridLayout;
class QLabel;
class QPushButton;

namespace rivulet::widgets {

/// What is known of a machine.
struct MachineCardView {
  QString name;  ///< may be empty: the endpoint stands for it
  QString endpoint;
  bool isPresent = false;  ///< the one of this window, connected or not
  ConnectionState connection = ConnectionState::Disconnected;
  MachineView machine;                           ///< if it is connected
  QString program;                               ///< the run in progress; empty: none
  double progress = 0.0;                         ///< 0 to 1, of that run
  std::optional<streaming::RunSummary> lastRun;  ///< nothing: none is known
  std::size_t alarms = 0;                        ///< that are active, of the present machine

  std::optional<bool> answers;  ///< something does at its port; nothing: nobody has looked
  double lookedS = 0.0;         ///< age of that, s
  // What this computer keeps of it.
  bool hasLimits = false;
  bool hasCalibration = false;
  bool hasCreditTest = false;
  bool canRemove = false;   ///< from the list, now
  bool isLeftOver = false;  ///< a virtual machine that is gone, and of which nothing is kept

  [[nodiscard]] bool hasFacts() const { return hasLimits || hasCalibration || hasCreditTest; }
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
  /// The operator has confirmed that the machine goes from the list.
  void removeRequested(const QString& endpoint);

 protected:
  void retranslate() override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void place();
  void showCards();
  void showLeftOver();

  QLabel* m_note;
  QGridLayout* m_grid;
  QLabel* m_leftOverNote;
  QPushButton* m_showLeftOver;
  std::vector<MachineCardView> m_machines;
  std::vector<MachineCard*> m_cards;
  QString m_blocked;
  int m_columns = 0;
};

}  // namespace rivulet::widgets
