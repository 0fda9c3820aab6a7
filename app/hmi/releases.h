// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Which jobs an operator may start: program, settings and calibration that an engineer has
/// released. Kept in a file that is only appended to. @threadsafety GUI thread.
#pragma once

#include <QObject>
#include <filesystem>
#include <optional>
#include <vector>

#include "hmi/document.h"
#include "hmi/machine_model.h"
#include "hmi/messages.h"
#include "hmi/users.h"
#include "permission/permission.h"

namespace rivulet::hmi {

class Releases final : public QObject {
  Q_OBJECT

 public:
  /// @param folder  of the file; empty: releases last as long as the window
  Releases(const std::filesystem::path& folder, Users& users, Document& document,
           MachineModel& machine, Messages& messages);

  /// What Start would run now; nothing: no program is loaded.
  [[nodiscard]] std::optional<permission::Job> job() const;
  /// Of that job; null: it is not released.
  [[nodiscard]] const permission::Release* release() const;
  [[nodiscard]] bool isReleased() const { return release() != nullptr; }

  /// An engineer releases the present job, or takes its release back.
  void give();
  void takeBack();

 Q_SIGNALS:
  void changed();

 private:
  void load(const std::filesystem::path& path);
  void append(permission::Release release);
  /// An operator gets the settings of the program's last release.
  void takeSettings();

  std::filesystem::path m_path;
  Users& m_users;
  Document& m_document;
  MachineModel& m_machine;
  Messages& m_messages;
  std::vector<permission::Release> m_releases;
};

}  // namespace rivulet::hmi
