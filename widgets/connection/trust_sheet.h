// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What has to be decided before a machine is connected: whether the certificate of its server is
/// trusted, or whether a connection with little or no protection is allowed. It stands where the
/// pages are, so it covers neither Stop nor the state. What is safe has the focus; the other button
/// has to be held. @threadsafety GUI thread.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "opcua/connection.h"
#include "widgets/common/page.h"
#include "widgets/common/status_label.h"

class QButtonGroup;
class QGridLayout;
class QLabel;
class QPushButton;

namespace rivulet::widgets {

class HoldButton;

/// Whether a question is asked on this sheet; else it is answered where users and passwords are
/// typed.
[[nodiscard]] bool isOnSheet(const opcua::TrustQuestion& question);

class TrustSheet final : public Page {
  Q_OBJECT

 public:
  explicit TrustSheet(QWidget* parent = nullptr);

  /// @param question  null: none
  void setQuestion(std::shared_ptr<const opcua::TrustQuestion> question);
  [[nodiscard]] const std::shared_ptr<const opcua::TrustQuestion>& question() const {
    return m_question;
  }
  /// The certificate by which the server knows this computer; nothing: there is none yet.
  void setOwnCertificate(const std::optional<opcua::CertificateFacts>& own);
  /// @param reason  why nothing can be accepted; empty: it can
  void setBlocked(const QString& reason);

 Q_SIGNALS:
  void certificateAccepted();
  void choiceAllowed(const rivulet::opcua::SecurityChoice& choice);
  void declined();
  /// This computer's certificate is to be written to a file.
  void exportRequested();

 protected:
  void retranslate() override;

 private:
  void clearRows();
  void addRow(const QString& name, Status status, const QString& text,
              const QString& other = QString(), bool isCode = false);
  void showCertificate();
  void showChoices();
  void showMachineSide();
  void accept();
  [[nodiscard]] QString title() const;
  [[nodiscard]] QString meaning() const;
  [[nodiscard]] QString obstacle() const;

  std::shared_ptr<const opcua::TrustQuestion> m_question;
  std::optional<opcua::CertificateFacts> m_own;
  QString m_blocked;
  QLabel* m_title = heading({.wraps = true});
  StatusLabel* m_meaning = status({.wraps = true});
  QPushButton* m_decline =
      button({.text = QT_TR_NOOP("Do not connect"), .icon = "dismiss", .id = "trust-decline"},
             &TrustSheet::declined);
  HoldButton* m_accept;
  QLabel* m_obstacle = label({.wraps = true});
  QGridLayout* m_rows;
  int m_nextRow = 0;
  std::vector<QWidget*> m_shown;
  QButtonGroup* m_choices;
  int m_chosen = 0;  ///< index in the question's choices
  QLabel* m_machineSide = value({.wraps = true});
  QPushButton* m_export = button({.text = QT_TR_NOOP("Save this computer's certificate …"),
                                  .icon = "save",
                                  .id = "trust-export"},
                                 &TrustSheet::exportRequested);
};

}  // namespace rivulet::widgets
