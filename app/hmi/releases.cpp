// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/releases.h"

#include <utility>

#include "platform/utc_now.h"
#include "preparation/release_file.h"
#include "preparation/settings_facts.h"
#include "widgets/common/error_text.h"

namespace rivulet::hmi {

using permission::Act;
using permission::Release;

Releases::Releases(const std::filesystem::path& folder, Users& users, Document& document,
                   MachineModel& machine, Messages& messages)
    : m_path(folder.empty() ? folder : preparation::releaseFileIn(folder)),
      m_users(users),
      m_document(document),
      m_machine(machine),
      m_messages(messages) {
  if (!m_path.empty()) {
    load(m_path);
  }
  connect(&m_document, &Document::programLoaded, this, &Releases::takeSettings);
  connect(&m_users, &Users::changed, this, &Releases::takeSettings);
  connect(&m_document, &Document::judged, this, &Releases::changed);
}

void Releases::load(const std::filesystem::path& path) {
  auto releases = preparation::readReleases(path);
  if (!releases) {
    m_messages.log(gcode::Severity::Warning, Messages::Source::Computer,
                   [error = releases.error()] { return widgets::errorText(error); });
    return;
  }
  m_releases = *std::move(releases);
}

std::optional<permission::Job> Releases::job() const {
  const auto program = m_document.program();
  if (!program) {
    return std::nullopt;
  }
  const widgets::AccessSource& source = m_document.findings().source;
  return permission::Job{
      program->hash,
      preparation::textOf(preparation::releasedFacts(m_document.settings(), m_document.reading())),
      source.isUsed() ? source.record->endpoint + " " + source.record->measuredAtUtc : ""};
}

const Release* Releases::release() const {
  const auto present = job();
  return present ? permission::releaseOf(m_releases, *present) : nullptr;
}

void Releases::give() {
  const auto present = job();
  if (!present || m_users.refusal(Act::Release)) {
    return;
  }
  append({*present, m_document.program()->name, m_users.name().toStdString(), utc::now(), false});
  m_messages.didAct(Act::Release, {{"program", m_document.program()->name},
                                   {"hash", present->programHash},
                                   {"settings", present->settings},
                                   {"calibration", present->calibration}});
}

void Releases::takeBack() {
  const Release* present = release();
  if (present == nullptr || m_users.refusal(Act::TakeBackRelease)) {
    return;
  }
  Release back = *present;
  back.by = m_users.name().toStdString();
  back.at = utc::now();
  back.isTakenBack = true;
  m_messages.didAct(Act::TakeBackRelease,
                    {{"program", back.programName}, {"hash", back.job.programHash}});
  append(std::move(back));
}

void Releases::append(Release release) {
  if (!m_path.empty()) {
    if (const auto written = preparation::appendRelease(m_path, release); !written) {
      m_messages.show(gcode::Severity::Error,
                      [error = written.error()] { return widgets::errorText(error); });
      return;
    }
  }
  m_releases.push_back(std::move(release));
  Q_EMIT changed();
}

void Releases::takeSettings() {
  const auto present = job();
  if (present && m_users.standing().role == permission::Role::Operator && !isReleased()) {
    if (const Release* last = permission::lastReleaseOf(m_releases, present->programHash)) {
      streaming::StreamSettings settings = m_document.settings();
      const preparation::SettingsFacts facts = preparation::factsOfText(last->job.settings);
      preparation::applySettings(settings, facts);
      m_document.setSettings(settings);
      session::Reading reading = m_document.reading();
      static_cast<gcode::TextReading&>(reading) = {};
      preparation::applyReading(reading, facts);
      if (!(static_cast<const gcode::TextReading&>(reading) == m_document.reading())) {
        m_document.readAgain(reading);
      }
    }
  }
  Q_EMIT changed();
}

}  // namespace rivulet::hmi
