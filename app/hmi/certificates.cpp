// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/certificates.h"

#include <utility>

#include "base/file.h"
#include "opcua/open62541/encryption.h"
#include "platform/utc_now.h"
#include "session/background.h"
#include "widgets/common/error_text.h"

namespace rivulet::hmi {

using gcode::Severity;
using permission::Act;

Certificates::Certificates(Messages& messages, std::filesystem::path folder)
    : m_messages(messages), m_folder(std::move(folder)), m_store(m_folder) {
  m_view.library = QString::fromStdString(opcua::encryptionLibrary());
  refresh();
}

void Certificates::refresh() {
  const std::filesystem::path path = trust::certificatePath(m_folder, trust::kClient);
  const auto der = base::readFile(path, trust::kCertificateBytesMax);
  const auto own = der ? opcua::readCertificate(*der) : base::fail(der.error());
  m_view.own = own ? std::optional(*own) : std::nullopt;
  m_view.ownDaysLeft = own ? opcua::daysLeft(*own, utc::now()) : 0;
  m_view.servers.clear();
  m_view.rejected.clear();
  const auto servers = m_store.servers();
  m_view.problem = servers ? base::Error{} : servers.error();
  if (servers) {
    for (const trust::KnownServer& server : *servers) {
      widgets::CertificatesView::Server row;
      row.endpoint = server.endpoint;
      row.fingerprint = server.fingerprint;
      row.facts = m_store.keptFacts(server.fingerprint);
      row.daysLeft = row.facts ? opcua::daysLeft(*row.facts, utc::now()) : 0;
      row.allowed = server.security;
      m_view.servers.push_back(std::move(row));
    }
  }
  for (const trust::RejectedServer& server : m_store.rejected()) {
    m_view.rejected.push_back({server.endpoint, server.facts});
  }
  Q_EMIT changed();
}

void Certificates::say(const base::Error& error) {
  m_messages.show(Severity::Error, [error] { return widgets::errorText(error); });
}

template <class Make>
void Certificates::makeOwn(Make make, const QString& exportPath) {
  m_view.isMaking = true;
  Q_EMIT changed();
  session::inBackground(
      this, std::move(make),
      [exportPath](Certificates& self, const base::Result<opcua::OwnCertificate>& own) {
        self.take(own, exportPath);
      });
}

void Certificates::take(const base::Result<opcua::OwnCertificate>& own, const QString& exportPath) {
  m_view.isMaking = false;
  if (!own) {
    say(own.error());
  } else if (!exportPath.isEmpty()) {
    if (const auto written = base::writeFile(exportPath.toStdString(), own->certificate);
        !written) {
      say(written.error());
    } else {
      m_messages.log(Severity::Note, Messages::Source::Computer,
                     [exportPath] { return tr("Saved %1.").arg(exportPath); });
    }
  }
  refresh();
}

void Certificates::exportOwn(const QString& path) {
  makeOwn([folder = m_folder] { return trust::ownCertificate(folder, trust::kClient); }, path);
}

void Certificates::renewOwn() {
  m_messages.didAct(Act::Trust, {{"certificate", "renewed"}});
  makeOwn([folder = m_folder] { return trust::renewCertificate(folder, trust::kClient); },
          QString());
}

void Certificates::forget(const QString& endpoint) {
  m_messages.didAct(Act::Trust, {{"machine", endpoint.toStdString()}, {"forgotten", "true"}});
  if (const auto done = m_store.forget(endpoint.toStdString()); !done) {
    say(done.error());
  }
  refresh();
}

void Certificates::strengthen(const QString& endpoint) {
  m_messages.didAct(Act::Trust, {{"machine", endpoint.toStdString()}, {"allowed", "strongest"}});
  if (const auto done = m_store.allow(endpoint.toStdString(), ""); !done) {
    say(done.error());
  }
  refresh();
}

void Certificates::acceptRejected(const QString& fingerprint) {
  m_messages.didAct(Act::Trust, {{"certificate", fingerprint.toStdString()}});
  if (const auto done = m_store.acceptRejected(fingerprint.toStdString()); !done) {
    say(done.error());
  }
  refresh();
}

void Certificates::dropRejected(const QString& fingerprint) {
  m_store.dropRejected(fingerprint.toStdString());
  refresh();
}

}  // namespace rivulet::hmi
