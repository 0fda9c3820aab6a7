// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/machine_profiles.h"

#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/utc.h"
#include "platform/utc_now.h"
#include "report/known_machine.h"
#include "report/run_store.h"
#include "widgets/common/error_text.h"

namespace rivulet::hmi {

using gcode::Severity;
using Source = Messages::Source;

MachineProfiles::MachineProfiles(Document& document, MachineModel& machine, RunController& runs,
                                 Messages& messages, report::MachineStore store)
    : m_document(document),
      m_machine(machine),
      m_runs(runs),
      m_messages(messages),
      m_store(std::move(store)) {
  followFunctions();
  connect(&m_machine, &MachineModel::linkChanged, this, [this] {
    if (m_machine.isConnected()) {
      load();
    }
    followFunctions();
    Q_EMIT permissionsChanged();
  });
  connect(&m_runs, &RunController::permissionsChanged, this, &MachineProfiles::permissionsChanged);
}

streaming::MachineProfile MachineProfiles::shown() const {
  return m_profile ? *m_profile : *report::profileOfPreset(report::kAssumedPreset);
}

void MachineProfiles::load() {
  auto found =
      m_store.profile(m_machine.endpoint().trimmed().toStdString(), m_machine.link().server);
  if (!found) {
    m_messages.log(Severity::Warning, Source::Control,
                   [error = found.error()] { return widgets::errorText(error); });
  }
  m_profile = found ? std::move(*found) : std::nullopt;
  apply();
}

void MachineProfiles::apply() {
  m_document.setMachine(
      m_profile ? std::make_shared<const machine::MachineConfig>(report::configOf(&*m_profile))
                : nullptr);
  m_document.setSilenceLimit(streaming::silenceLimitS(m_profile ? &*m_profile : nullptr));
  m_document.setStopLimit(streaming::stopLimitS(m_profile ? &*m_profile : nullptr));
  const auto known =
      report::knownMachine(m_machine.link().server, m_profile ? &*m_profile : nullptr);
  m_document.setJobMachine(known ? std::make_shared<const machine::MachineConfig>(*known)
                                 : nullptr);
  followFunctions();
  Q_EMIT changed();
}

void MachineProfiles::followFunctions() {
  const bool isConnected = m_machine.isConnected();
  m_document.setLoadMachine(report::loadMachineOf(
      m_store, isConnected ? m_machine.endpoint().trimmed().toStdString() : std::string(),
      isConnected ? m_machine.link().server : opcua::ServerIdentity{},
      !isConnected || m_machine.view().isVirtualMachine,
      isConnected && m_profile ? &*m_profile : nullptr));
}

job::Functions MachineProfiles::functions() const {
  return m_store.functions(m_machine.endpoint().trimmed().toStdString());
}

void MachineProfiles::saveFunctions(const job::Functions& functions) {
  if (!canSave()) {
    return;
  }
  const std::string endpoint = m_machine.endpoint().trimmed().toStdString();
  if (const auto saved = m_store.save(endpoint, m_machine.link().server, functions); !saved) {
    m_messages.show(Severity::Error, [error = saved.error()] { return widgets::errorText(error); });
    return;
  }
  m_messages.didAct(permission::Act::ChangeSettings,
                    {{"machine", endpoint}, {"m_functions", job::textOf(functions)}});
  followFunctions();
  Q_EMIT changed();
}

void MachineProfiles::save(streaming::MachineProfile profile) {
  if (!canSave() || streaming::problemOf(profile)) {
    return;
  }
  profile.endpoint = m_machine.endpoint().trimmed().toStdString();
  profile.server = m_machine.link().server;
  profile.enteredAtUtc = base::utcText(utc::now());
  profile.enteredBy = report::thisUser().user;
  if (const auto saved = m_store.save(profile); !saved) {
    m_messages.show(Severity::Error, [error = saved.error()] { return widgets::errorText(error); });
    return;
  }
  m_messages.didAct(
      permission::Act::ChangeSettings,
      {{"machine", profile.endpoint},
       {"limits", report::profileJson(profile, {})
                      .dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace)}});
  m_messages.log(Severity::Note, Source::Computer, [endpoint = m_machine.endpoint()] {
    return tr("The limits of %1 have been saved.").arg(endpoint);
  });
  m_profile = std::move(profile);
  apply();
}

}  // namespace rivulet::hmi
