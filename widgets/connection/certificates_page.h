// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// By which certificate servers know this computer, and which servers it trusts.
/// @threadsafety GUI thread.
#pragma once

#include <QCoreApplication>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "opcua/certificate.h"
#include "widgets/common/page.h"
#include "widgets/common/table_model.h"

class QGroupBox;
class QLabel;
class QPushButton;
class QTableView;

namespace rivulet::widgets {

class HoldButton;
class StatusLabel;

struct CertificatesView {
  struct Server {
    std::string endpoint;
    std::string fingerprint;                       ///< empty: no certificate was accepted
    std::optional<opcua::CertificateFacts> facts;  ///< nothing: not kept
    int daysLeft = 0;                              ///< with `facts`
    std::string allowed;                           ///< by name; empty: the strongest only
  };
  struct Rejected {
    std::string endpoint;
    opcua::CertificateFacts facts;
  };
  std::optional<opcua::CertificateFacts> own;  ///< nothing: made when it is first needed
  int ownDaysLeft = 0;
  bool isMaking = false;  ///< a new one is being made
  QString library;        ///< that encrypts
  std::vector<Server> servers;
  std::vector<Rejected> rejected;
  base::Error problem;  ///< why the list of servers cannot be read; code clear: it can
};

class ServerModel final : public TableModel<CertificatesView::Server> {
  Q_DECLARE_TR_FUNCTIONS(ServerModel)

 public:
  explicit ServerModel(QObject* parent);
};

class RejectedModel final : public TableModel<CertificatesView::Rejected> {
  Q_DECLARE_TR_FUNCTIONS(RejectedModel)

 public:
  explicit RejectedModel(QObject* parent);
};

class CertificatesPage final : public Page {
  Q_OBJECT

 public:
  explicit CertificatesPage(QWidget* parent = nullptr);

  void setCertificates(const CertificatesView& view);
  /// @param reason  why nothing can be changed; empty: it can
  void setBlocked(const QString& reason);

 Q_SIGNALS:
  void exportRequested(const QString& path);
  void renewRequested();
  void forgetRequested(const QString& endpoint);
  void strengthenRequested(const QString& endpoint);
  void acceptRequested(const QString& fingerprint);
  void dropRequested(const QString& fingerprint);

 private:
  QWidget* makeOwn();
  QWidget* makeServers();
  QWidget* makeRejected();
  void showOwn();
  void showButtons();
  void fitColumns();
  void chooseFile();
  [[nodiscard]] const CertificatesView::Server* chosenServer() const;
  [[nodiscard]] const CertificatesView::Rejected* chosenRejected() const;

  CertificatesView m_view;
  QString m_blocked;
  StatusLabel* m_blockedText = status({.wraps = true});
  QGroupBox* m_ownGroup;
  StatusLabel* m_days;
  QLabel* m_fingerprintTitle;
  QLabel* m_fingerprint;
  QLabel* m_library;
  QPushButton* m_export;
  HoldButton* m_renew;
  QGroupBox* m_serverGroup;
  ServerModel* m_servers;
  QTableView* m_serverTable;
  QPushButton* m_forget;
  QPushButton* m_strengthen;
  QGroupBox* m_rejectedGroup;
  RejectedModel* m_rejected;
  QTableView* m_rejectedTable;
  HoldButton* m_accept;
  QPushButton* m_drop;
};

/// Asks where this computer's certificate is to be saved.
void askForCertificateFile(QWidget* asker, const std::function<void(const QString&)>& chosen);

}  // namespace rivulet::widgets
