// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The board: all machines that this computer knows, and all services, a card each. One machine can
/// be connected at a time; of the others it is said whether their port answers. Services tell what
/// their machines do; one of them is opened in the place of the board. @threadsafety GUI thread.
#pragma once

#include <optional>
#include <vector>

#include "streaming/run/run_summary.h"
#include "widgets/common/page.h"
#include "widgets/connection/machine_view.h"
#include "widgets/connection/service_view.h"

class QGridLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QVBoxLayout;

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
  bool hasFeedTest = false;
  bool hasJobTest = false;
  bool canRemove = false;   ///< from the list, now
  bool isLeftOver = false;  ///< a virtual machine that is gone, and of which nothing is kept

  [[nodiscard]] bool hasFacts() const {
    return hasLimits || hasCalibration || hasCreditTest || hasFeedTest || hasJobTest;
  }
};

class MachineCard;
class ServiceCard;
class ServicePanel;

class MachinesPage final : public Page {
  Q_OBJECT

 public:
  explicit MachinesPage(QWidget* parent = nullptr);

  void setMachines(const std::vector<MachineCardView>& machines);
  /// During a run the window stays with its machine. @param why  empty: any may be opened
  void setBlocked(const QString& why);
  /// The services of the board, in their order.
  void setServices(const std::vector<ServiceView>& services);
  /// Of the service that has been added: the next one is typed from the beginning.
  void clearAddress();
  /// What a search has found and the board does not have; with a sentence about it.
  void setFound(const QStringList& endpoints, const QString& note);
  /// @param why  services can neither be added nor removed; empty: they can
  void setServicesBlocked(const QString& why);
  [[nodiscard]] ServicePanel* servicePanel() const { return m_panel; }
  /// Opens the service in the place of the board; empty: back to the board.
  void openService(const QString& endpoint);

 Q_SIGNALS:
  /// The operator wants to work at this machine: connect if it is not connected.
  void openRequested(const QString& endpoint);
  /// The operator has confirmed that the machine goes from the list.
  void removeRequested(const QString& endpoint);
  void addServiceRequested(const QString& endpoint);
  void removeServiceRequested(const QString& endpoint);
  /// Services are to be looked for. @param address  of a discovery server, or part of it; may be
  /// empty
  void searchRequested(const QString& address);

 protected:
  void retranslate() override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void place();
  void showCards();
  void showLeftOver();
  void showServices();
  void buildServices(QVBoxLayout& layout);

  QWidget* m_board;
  ServicePanel* m_panel;
  QLabel* m_note = label(
      {.text = QT_TR_NOOP("One machine at a time is connected with a window. Of the others "
                          "only the port is looked at, every 30 s while this page is shown: a "
                          "question would cost them time that another stream may need."),
       .wraps = true});
  QGridLayout* m_grid;
  QGridLayout* m_serviceGrid;
  QLabel* m_addLabel = label({.text = QT_TR_NOOP("&Address of a service")});
  QLineEdit* m_address =
      lineEdit({.tip = QT_TR_NOOP("As rivulet-service prints it when it is ready."),
                .name = QT_TR_NOOP("Address of a service"),
                .id = "service-address",
                .isTouch = true});
  QPushButton* m_add = button({.text = QT_TR_NOOP("Add"), .id = "service-add"});
  QPushButton* m_search = button({.text = QT_TR_NOOP("Search"), .id = "service-search"});
  QLabel* m_foundNote = label({.id = "service-found", .wraps = true});
  QVBoxLayout* m_foundList;
  QLabel* m_leftOverNote = label({.wraps = true});
  QPushButton* m_showLeftOver = button({.id = "show-left-over"});
  std::vector<MachineCardView> m_machines;
  std::vector<MachineCard*> m_cards;
  std::vector<ServiceView> m_services;
  std::vector<ServiceCard*> m_serviceCards;
  std::vector<QPushButton*> m_foundButtons;
  QStringList m_found;
  QString m_foundText;
  QString m_servicesBlocked;
  QString m_blocked;
  int m_columns = 0;
  std::size_t m_placed = 0;  ///< cards of services
};

}  // namespace rivulet::widgets
