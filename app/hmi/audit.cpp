// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/audit.h"

#include <QMetaObject>
#include <utility>

#include "base/text.h"
#include "preparation/settings_facts.h"
#include "session/background.h"
#include "widgets/common/error_text.h"

namespace rivulet::hmi {

using permission::Act;

namespace {

constexpr int kRestMs = 2000;
constexpr const char* kCorrection = "correction_mm";

}  // namespace

Audit::Audit(Messages& messages, const std::filesystem::path& folder, Clock clock)
    : m_messages(messages),
      m_path(folder.empty() ? folder : journal::auditFileIn(folder)),
      m_clock(std::move(clock)) {
  connect(&m_messages, &Messages::did, this, &Audit::record);
  m_rest.setSingleShot(true);
  m_rest.setInterval(kRestMs);
  connect(&m_rest, &QTimer::timeout, this, &Audit::recordSettings);
  if (!m_path.empty()) {
    m_writer = std::make_unique<journal::Writer>();
  }
}

Audit::~Audit() {
  record(Act::ProgramEnd);
}

void Audit::setWho(std::string who, std::string role) {
  recordSettings();  // they are another person's
  m_who = std::move(who);
  m_role = std::move(role);
}

void Audit::record(Act act, Details details) {
  recordSettings();
  write({m_clock(), m_who, m_role, std::string(permission::actName(act)), std::move(details)});
}

void Audit::follow(const streaming::StreamSettings& settings) {
  m_settings = preparation::settingsFacts(settings);
  m_settings.emplace_back(kCorrection, m_correction);
  compare();
}

void Audit::followCorrection(const base::Vec3& valueMm) {
  constexpr int kDecimals = 3;
  m_correction = base::formatFixed(valueMm.x, kDecimals) + " " +
                 base::formatFixed(valueMm.y, kDecimals) + " " +
                 base::formatFixed(valueMm.z, kDecimals);
  if (!m_settings.empty()) {
    m_settings.back().second = m_correction;
    compare();
  }
}

void Audit::compare() {
  if (m_recorded.empty()) {
    m_recorded = m_settings;
  } else if (m_settings != m_recorded) {
    m_rest.start();
  }
}

void Audit::recordSettings() {
  m_rest.stop();
  Details changes;
  for (std::size_t i = 0; i < m_settings.size(); ++i) {
    const auto& [name, value] = m_settings[i];
    if (value != m_recorded[i].second) {
      changes.emplace_back(name, m_recorded[i].second + " -> " + value);
    }
  }
  m_recorded = m_settings;
  if (!changes.empty()) {
    write({m_clock(), m_who, m_role, std::string(permission::actName(Act::ChangeSettings)),
           std::move(changes)});
  }
}

void Audit::take(const alarm::Transition& transition) {
  if (transition.by.empty()) {
    return;  // nobody has done it
  }
  const Act act = transition.event == alarm::Event::Acknowledged ? Act::Acknowledge : Act::Shelve;
  Details details{{"alarm", alarm::factsOf(transition.alarm.code).name}};
  if (!transition.alarm.subject().empty()) {
    details.emplace_back("of", transition.alarm.subject());
  }
  if (act == Act::Shelve) {
    details.emplace_back("until", transition.alarm.shelving
                                      ? base::utcText(transition.alarm.shelving->until)
                                      : "now");
  }
  record(act, std::move(details));
}

void Audit::write(const journal::AuditEntry& entry) {
  if (!m_writer) {
    return;
  }
  m_writer->add([path = m_path, entry] { return journal::appendAudit(path, entry); },
                [this](const base::Result<void>& written) {
                  // On another thread; the writer ends before this object does.
                  QMetaObject::invokeMethod(
                      this,
                      [this, written] {
                        if (written) {
                          m_messages.settle(alarm::Code::AuditUnwritten);
                          Q_EMIT lineWritten();
                        } else {
                          m_messages.raise(alarm::Code::AuditUnwritten, {m_path.string()},
                                           written.error());
                        }
                      },
                      Qt::QueuedConnection);
                });
}

void Audit::refresh() {
  if (m_path.empty()) {
    Q_EMIT contentChanged();
    return;
  }
  session::inBackground(
      this, [path = m_path] { return journal::readAudit(path); },
      [](Audit& self, const base::Result<journal::AuditContent>& content) {
        self.takeContent(content);
      });
}

void Audit::takeContent(base::Result<journal::AuditContent> content) {
  if (!content) {
    m_messages.show(gcode::Severity::Error,
                    [error = content.error()] { return widgets::errorText(error); });
    return;
  }
  m_content = *std::move(content);
  if (const std::size_t line = m_content.firstChange(); line > 0) {
    m_messages.raise(alarm::Code::AuditChanged, {m_path.string(), std::to_string(line)});
  } else {
    m_messages.settle(alarm::Code::AuditChanged);
  }
  Q_EMIT contentChanged();
}

}  // namespace rivulet::hmi
