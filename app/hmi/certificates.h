// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The certificates of this user: the one by which servers know this computer, and those of servers
/// that are trusted or were refused. @threadsafety GUI thread.
#pragma once

#include <QObject>
#include <QString>
#include <filesystem>

#include "hmi/messages.h"
#include "trust/own_certificate.h"
#include "trust/trust_store.h"
#include "widgets/connection/certificates_page.h"

namespace rivulet::hmi {

class Certificates final : public QObject {
  Q_OBJECT

 public:
  explicit Certificates(Messages& messages, std::filesystem::path folder = trust::trustFolder());

  /// As the files were when they were read last.
  [[nodiscard]] const widgets::CertificatesView& view() const { return m_view; }
  /// Reads the files again; creates nothing.
  void refresh();

  /// Writes the own certificate, without its key, for the control's list of trusted clients (DER).
  /// One is made if there is none; that takes up to some seconds, in the background.
  void exportOwn(const QString& path);
  /// Makes a new one, in the background. Every server has to trust it anew.
  void renewOwn();
  /// A server is unknown from now on.
  void forget(const QString& endpoint);
  /// What was allowed by name is taken back: the strongest protection again.
  void strengthen(const QString& endpoint);
  void acceptRejected(const QString& fingerprint);
  void dropRejected(const QString& fingerprint);

 Q_SIGNALS:
  void changed();

 private:
  template <class Make>
  void makeOwn(Make make, const QString& exportPath);
  void take(const base::Result<opcua::OwnCertificate>& own, const QString& exportPath);
  void say(const base::Error& error);

  Messages& m_messages;
  std::filesystem::path m_folder;
  trust::TrustStore m_store;
  widgets::CertificatesView m_view;
};

}  // namespace rivulet::hmi
