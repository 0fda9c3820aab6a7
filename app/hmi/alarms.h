// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The alarms of the window: takes what the models raise and settle, tells the time, keeps the
/// history on disk. @threadsafety GUI thread.
#pragma once

#include <QObject>
#include <QTimer>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "alarm/alarm_list.h"
#include "hmi/messages.h"
#include "journal/alarm_history.h"
#include "journal/writer.h"
#include "platform/utc_now.h"

namespace rivulet::hmi {

class Alarms final : public QObject {
  Q_OBJECT

 public:
  using Clock = std::function<base::UtcMs()>;
  /// Transitions that are shown; the files have more.
  static constexpr std::size_t kHistoryMax = 2000;

  /// @param folder  of the history; empty: it is not kept
  Alarms(Messages& messages, const std::filesystem::path& folder, Clock clock = utc::now);

  /// Who acknowledges and shelves.
  void setUser(std::string user) { m_user = std::move(user); }

  [[nodiscard]] const alarm::AlarmList& list() const { return m_list; }
  /// The newest first.
  [[nodiscard]] const std::vector<alarm::Transition>& history() const { return m_history; }

  void acknowledge(int number);
  void acknowledgeAll();
  void shelve(int number, int minutes);
  void unshelve(int number);

 Q_SIGNALS:
  void changed();
  /// Something happened to an alarm.
  void happened(const rivulet::alarm::Transition& transition);
  /// The operator wants to see the list.
  void listRequested();

 private:
  void restore();
  void raise(alarm::Code code, const std::vector<std::string>& arguments, const base::Error& error);
  void advance();
  /// Keeps what has happened in the list since the last call.
  void keep();
  void write(const alarm::Transition& transition);

  Messages& m_messages;
  Clock m_clock;
  std::string m_user;
  alarm::AlarmList m_list;
  std::vector<alarm::Transition> m_history;
  journal::AlarmHistory m_file;
  QTimer m_timer;                             ///< ends shelvings
  std::unique_ptr<journal::Writer> m_writer;  ///< null: nothing is kept
};

}  // namespace rivulet::hmi
