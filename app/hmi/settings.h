// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What the HMI remembers between starts. The only user of QSettings. @threadsafety GUI thread.
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <filesystem>

#include "live/setup.h"
#include "opcua/node_map.h"
#include "streaming/start/stream_settings.h"
#include "widgets/common/theme.h"

namespace rivulet::hmi {

struct Settings {
  QString endpoint = QString::fromUtf8(opcua::kLocalEndpoint);
  QStringList recentFiles;
  QStringList services;  ///< addresses of those on the board of machines
  QString language;      ///< one of `language::languages()`; empty: the system's
  widgets::Theme theme = widgets::Theme::System;
  streaming::StreamSettings stream;
  live::Setup live;  ///< agreed last
  QByteArray geometry;
  /// Where alarms, audit trail and releases are kept; empty: nowhere.
  std::filesystem::path stateFolder;
  std::filesystem::path usersFile;  ///< empty: no users
  /// Of mode 0600, with the password of a user of the machine; given at the start, not remembered.
  std::filesystem::path passwordFile;

  static constexpr int kRecentFilesMax = 8;
  void addRecentFile(const QString& path);
};

[[nodiscard]] Settings loadSettings();
void saveSettings(const Settings& settings);

}  // namespace rivulet::hmi
