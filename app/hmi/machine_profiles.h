// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The limits of the connected machine: found again at each connection, entered by an engineer,
/// and used for feeds, times and simulations. @threadsafety GUI thread.
#pragma once

#include <QObject>
#include <optional>

#include "hmi/document.h"
#include "hmi/machine_model.h"
#include "hmi/messages.h"
#include "hmi/run_controller.h"
#include "job/functions.h"
#include "report/machine_store.h"
#include "streaming/control/machine_profile.h"

namespace rivulet::hmi {

class MachineProfiles final : public QObject {
  Q_OBJECT

 public:
  MachineProfiles(Document& document, MachineModel& machine, RunController& runs,
                  Messages& messages, report::MachineStore store);

  /// As entered; nothing: nobody has, or no machine is connected.
  [[nodiscard]] const std::optional<streaming::MachineProfile>& profile() const {
    return m_profile;
  }
  /// As entered, or those that are assumed.
  [[nodiscard]] streaming::MachineProfile shown() const;
  [[nodiscard]] bool canSave() const {
    return m_machine.isConnected() && m_runs.canChangeSettings();
  }
  /// What the connected machine does for M functions of other machines.
  [[nodiscard]] job::Functions functions() const;
  void saveFunctions(const job::Functions& functions);
  /// Keeps the limits for the connected machine. @param profile  without machine, time and user
  void save(streaming::MachineProfile profile);

 Q_SIGNALS:
  void changed();
  void permissionsChanged();

 private:
  void load();
  void followFunctions();
  void apply();

  Document& m_document;
  MachineModel& m_machine;
  RunController& m_runs;
  Messages& m_messages;
  report::MachineStore m_store;
  std::optional<streaming::MachineProfile> m_profile;
};

}  // namespace rivulet::hmi
