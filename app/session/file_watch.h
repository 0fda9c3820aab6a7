// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Reports when the file of a program differs from what was read: written to, replaced by another
/// of the same name, deleted, or restored. @threadsafety GUI thread.
#pragma once

#include <QFileSystemWatcher>
#include <QObject>
#include <QString>
#include <QTimer>

namespace rivulet::session {

/// Identifies a version of a file without reading it.
struct FileStamp {
  bool exists = false;
  qint64 bytes = 0;
  qint64 modifiedMs = 0;
  friend bool operator==(const FileStamp&, const FileStamp&) = default;
};
[[nodiscard]] FileStamp fileStamp(const QString& path);

class FileWatch final : public QObject {
  Q_OBJECT

 public:
  enum class State { Same, Changed, Gone };

  explicit FileWatch(QObject* parent = nullptr);

  /// @param stamp  of the file as it was read; changes since then are reported as well
  void watch(const QString& path, const FileStamp& stamp);
  void clear();
  [[nodiscard]] State state() const { return m_state; }

 Q_SIGNALS:
  void stateChanged(rivulet::session::FileWatch::State state);

 private:
  void look();

  QFileSystemWatcher m_watcher;
  QTimer m_settle;  ///< programs write in many pieces: one check is enough for all of them
  QString m_path;
  FileStamp m_read;
  State m_state = State::Same;
};

}  // namespace rivulet::session
