// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// One service in the place of the board: what its machine does, what a start would do, and a few
/// large buttons. The service decides what is permitted; its answer is shown. Start is held, and
/// only after the preflight is shown. @threadsafety GUI thread.
#pragma once

#include <optional>

#include "widgets/common/page.h"
#include "widgets/connection/service_view.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;

namespace rivulet::widgets {

class ElidedLabel;
class HoldButton;
class TrustSheet;

class ServicePanel final : public Page {
  Q_OBJECT

 public:
  explicit ServicePanel(QWidget* parent = nullptr);

  void setService(const ServiceView& view);
  [[nodiscard]] const QString& endpoint() const { return m_view.endpoint; }
  /// How a method was answered. @param confirmation  of a preflight; empty: none
  void setAnswer(const QString& method, bool accepted, const QString& message,
                 const QString& confirmation);
  /// See `TrustSheet`: for what is asked before a service is connected.
  void setOwnCertificate(const std::optional<opcua::CertificateFacts>& own);
  void setTrustBlocked(const QString& reason);

 Q_SIGNALS:
  void closeRequested();
  /// One of the methods of docs/service.md.
  void callRequested(const QString& method, const QStringList& inputs);
  void loginRequested(const QString& user, const QString& pin);
  void certificateAccepted();
  void choiceAllowed(const rivulet::opcua::SecurityChoice& choice);
  void declined();
  void exportRequested();

 private:
  enum class Offer { None, Start, Resume };

  void buildFacts();
  void buildLogin();
  void call(const QString& method, const QStringList& inputs = {});
  void begin();
  void logIn();
  void drop();
  void showPrograms(const QStringList& programs);
  void showQuestion();
  void showAll();
  void showFacts();
  void showButtons();

  ServiceView m_view;
  std::optional<opcua::CertificateFacts> m_own;
  QString m_trustBlocked;
  /// The preflight that is shown.
  struct Preflight {
    Offer offer = Offer::None;  ///< what it is of
    QString confirmation;
    QString text;
  };
  Preflight m_offered;
  struct Reply {
    QString asked;   ///< method that is not answered yet; empty: none
    QString answer;  ///< the last one that was no preflight
    bool isRefused = false;
  };
  Reply m_replied;

  QPushButton* m_back = button({.text = QT_TR_NOOP("All machines"),
                                .tip = QT_TR_NOOP("Back to the board. The run goes on."),
                                .id = "panel-back"},
                               &ServicePanel::closeRequested);
  ElidedLabel* m_title;
  ElidedLabel* m_where;
  StatusLabel* m_state = status({.id = "panel-state", .wraps = true});
  StatusLabel* m_alarm = status({.id = "panel-alarm"});
  TrustSheet* m_trust = nullptr;  ///< only while something is asked
  QWidget* m_work;
  QLabel* m_program = value();
  QProgressBar* m_progress;
  QLabel* m_points = value({.id = "panel-points"});
  StatusLabel* m_waiting = status();
  QLabel* m_position = value();
  QLabel* m_message = value({.isMuted = true, .wraps = true});
  QLineEdit* m_file =
      lineEdit({.tip = QT_TR_NOOP("The service reads it in its folder of programs."),
                .name = QT_TR_NOOP("Program"),
                .placeholder = QT_TR_NOOP("choose or type a file in the folder of the service"),
                .id = "panel-file",
                .isTouch = true});
  QComboBox* m_files = list({.name = QT_TR_NOOP("Program"), .id = "panel-files", .isTouch = true});
  QPushButton* m_load =
      button({.text = QT_TR_NOOP("Load"),
              .tip = QT_TR_NOOP("The service reads the program and judges it. Nothing moves."),
              .id = "panel-load"});
  QLabel* m_preflightTitle = heading();
  QLabel* m_preflight = value({.id = "panel-preflight", .wraps = true});
  StatusLabel* m_reply = status({.id = "panel-reply"});
  QLabel* m_whose = label({.isMuted = true, .wraps = true});  ///< the buttons
  QPushButton* m_stop =
      button({.text = QT_TR_NOOP("Stop"),
              .tip = QT_TR_NOOP("Ends the run of this machine after the window in motion. It "
                                "does not replace the machine's emergency stop."),
              .icon = "stop",
              .id = "panel-stop"});
  QPushButton* m_hold = button(
      {.tip = QT_TR_NOOP("The machine waits before the next window until you press Continue."),
       .id = "panel-hold"});
  QPushButton* m_resume =
      button({.text = QT_TR_NOOP("Resume …"),
              .tip = QT_TR_NOOP("Asks the control where the run was left. Nothing moves yet."),
              .icon = "resume",
              .id = "panel-resume"});
  HoldButton* m_start;
  struct Login {
    StatusLabel* who = nullptr;
    QPushButton* open = nullptr;
    QWidget* fields = nullptr;
    QLabel* userLabel = nullptr;
    QLineEdit* user = nullptr;
    QLabel* pinLabel = nullptr;
    QLineEdit* pin = nullptr;
    QPushButton* enter = nullptr;
  };
  Login m_login{
      .who = status({.id = "panel-user"}),
      .open =
          button({.tip = QT_TR_NOOP("This service has users: log in before you give it commands."),
                  .id = "panel-login"}),
      .fields = new QWidget(m_work),
      .userLabel = label({.text = QT_TR_NOOP("&Name")}),
      .user = lineEdit(
          {.tip = QT_TR_NOOP("A user of the service; empty: nobody."), .id = "panel-name"}),
      .pinLabel = label({.text = QT_TR_NOOP("P&IN")}),
      .pin = lineEdit({.tip = QT_TR_NOOP("It is not kept."), .id = "panel-pin"}),
      .enter = button({.text = QT_TR_NOOP("Log in"),
                       .tip = QT_TR_NOOP("Connects again as this user."),
                       .id = "panel-enter"},
                      &ServicePanel::logIn)};
};

}  // namespace rivulet::widgets
