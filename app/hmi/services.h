// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The services on the board of machines: which ones, what each of them tells, and what is asked of
/// it. Each has a connection and a thread of its own (`service::ServiceWatch`).
/// @threadsafety GUI thread; it never waits, except for connections that are being made at its end.
#pragma once

#include <QObject>
#include <QStringList>
#include <map>
#include <memory>
#include <vector>

#include "base/error.h"
#include "opcua/security.h"
#include "report/machine_store.h"
#include "widgets/connection/service_view.h"

namespace rivulet::hmi {

class Services final : public QObject {
  Q_OBJECT

 public:
  /// @param endpoints  of the services that are on the board
  Services(const QStringList& endpoints, report::MachineStore store);
  ~Services() override;

  [[nodiscard]] const QStringList& endpoints() const { return m_endpoints; }
  /// In the order of the board.
  [[nodiscard]] std::vector<widgets::ServiceView> views() const;
  /// Puts a service on the board. @return false: it is there already
  bool add(const QString& endpoint);
  void remove(const QString& endpoint);
  /// Asks a discovery server for services that are not on the board.
  /// @param address  without a port or a scheme, the usual ones; empty: this computer
  void search(const QString& address);

  /// Calls a method of docs/service.md; the answer comes as `answered`. A preflight that is not
  /// ready yet is repeated.
  void call(const QString& endpoint, const QString& method, const QStringList& inputs);
  /// @param user  empty: anonymous
  void logIn(const QString& endpoint, const QString& user, const QString& pin);
  /// The certificate that is asked about.
  void accept(const QString& endpoint);
  void allow(const QString& endpoint, const opcua::SecurityChoice& choice);
  /// Nothing is accepted; who was to log in does not.
  void decline(const QString& endpoint);

 Q_SIGNALS:
  void changed();
  /// Services were added or removed.
  void listChanged();
  void answered(const QString& endpoint, const QString& method, bool accepted,
                const QString& message, const QString& confirmation);
  /// @param problem  why nothing could be found; code clear: it could
  void searched(const QStringList& endpoints, const rivulet::base::Error& problem);

 private:
  class Watched;

  void watch(const QString& endpoint);
  [[nodiscard]] Watched* find(const QString& endpoint) const;
  void take(Watched& watched);

  QStringList m_endpoints;
  report::MachineStore m_store;
  std::map<QString, QString> m_names;  ///< of machines, by their endpoints
  std::map<QString, std::unique_ptr<Watched>> m_watched;
};

}  // namespace rivulet::hmi
