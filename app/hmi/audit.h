// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The audit trail of the window: what the operator does becomes a line of a file. Writing happens
/// on a thread of its own; a failure is an alarm and stops nothing. @threadsafety GUI thread.
#pragma once

#include <QObject>
#include <QTimer>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "alarm/alarm_list.h"
#include "base/vec3.h"
#include "hmi/messages.h"
#include "journal/audit.h"
#include "journal/writer.h"
#include "permission/permission.h"
#include "streaming/start/stream_settings.h"

namespace rivulet::hmi {

class Audit final : public QObject {
  Q_OBJECT

 public:
  using Details = ActDetails;
  using Clock = std::function<base::UtcMs()>;

  /// @param folder  of the trail; empty: none is kept
  Audit(Messages& messages, const std::filesystem::path& folder, Clock clock);
  ~Audit() override;

  /// Who does what follows. @param role  empty: no roles are set up
  void setWho(std::string who, std::string role);

  void record(permission::Act act, Details details = {});
  /// The settings as they are now. A change is recorded once nobody has changed them for a moment,
  /// or before the next act.
  void follow(const streaming::StreamSettings& settings);
  /// The online correction, X Y Z, as the settings.
  void followCorrection(const base::Vec3& valueMm);
  void take(const alarm::Transition& transition);

  /// Empty: none is kept.
  [[nodiscard]] const std::filesystem::path& path() const { return m_path; }
  /// Reads and verifies the file on another thread, and raises an alarm if it was changed.
  /// `contentChanged` answers. Lines that are still being written may be missing.
  void refresh();
  /// As it was read last.
  [[nodiscard]] const journal::AuditContent& content() const { return m_content; }

 Q_SIGNALS:
  /// The file has a new line.
  void lineWritten();
  void contentChanged();

 private:
  void compare();
  void takeContent(base::Result<journal::AuditContent> content);
  void write(const journal::AuditEntry& entry);
  void recordSettings();

  Messages& m_messages;
  std::filesystem::path m_path;
  Clock m_clock;
  std::string m_who;
  std::string m_role;
  std::unique_ptr<journal::Writer> m_writer;  ///< null: nothing is kept
  journal::AuditContent m_content;
  Details m_recorded;  ///< settings as the trail has them; empty: it has none yet
  Details m_settings;  ///< settings as they are
  std::string m_correction = "0 0 0";
  QTimer m_rest;
};

}  // namespace rivulet::hmi
