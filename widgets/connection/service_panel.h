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

 protected:
  void retranslate() override;
  void restyle() override;

 private:
  enum class Offer { None, Start, Resume };

  void buildFacts();
  void buildLogin();
  void call(const QString& method, const QStringList& inputs = {});
  void begin();
  void logIn();
  void drop();
  void showQuestion();
  void showAll();
  void showFacts();
  void showButtons();

  ServiceView m_view;
  std::optional<opcua::CertificateFacts> m_own;
  QString m_trustBlocked;
  Offer m_offer = Offer::None;  ///< what the preflight that is shown is of
  QString m_confirmation;
  QString m_shown;   ///< the text of the preflight
  QString m_asked;   ///< method that is not answered yet; empty: none
  QString m_answer;  ///< the last one that was no preflight
  bool m_isRefused = false;

  QPushButton* m_back;
  ElidedLabel* m_title;
  ElidedLabel* m_where;
  StatusLabel* m_state;
  StatusLabel* m_alarm;
  TrustSheet* m_trust = nullptr;  ///< only while something is asked
  QWidget* m_work;
  QLabel* m_program;
  QProgressBar* m_progress;
  QLabel* m_points;
  StatusLabel* m_waiting;
  QLabel* m_position;
  QLabel* m_message;
  QLabel* m_fileLabel;
  QLineEdit* m_file;
  QPushButton* m_load;
  QLabel* m_preflightTitle;
  QLabel* m_preflight;
  StatusLabel* m_reply;
  QLabel* m_whose;  ///< the buttons
  QPushButton* m_stop;
  QPushButton* m_hold;
  QPushButton* m_resume;
  HoldButton* m_start;
  StatusLabel* m_whoIs;
  QPushButton* m_login;
  QWidget* m_fields;
  QLabel* m_userLabel;
  QLineEdit* m_user;
  QLabel* m_pinLabel;
  QLineEdit* m_pin;
  QPushButton* m_enter;
};

}  // namespace rivulet::widgets
