// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "session/file_watch.h"

#include <QDateTime>
#include <QFileInfo>

namespace rivulet::session {

namespace {

constexpr int kSettleMs = 250;

}  // namespace

FileStamp fileStamp(const QString& path) {
  const QFileInfo file(path);
  if (!file.exists()) {
    return {};
  }
  return {true, file.size(), file.lastModified().toMSecsSinceEpoch()};
}

FileWatch::FileWatch(QObject* parent) : QObject(parent) {
  m_settle.setSingleShot(true);
  m_settle.setInterval(kSettleMs);
  connect(&m_settle, &QTimer::timeout, this, &FileWatch::look);
  const auto look = [this] { m_settle.start(); };
  connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, look);
  connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, look);
}

void FileWatch::watch(const QString& path, const FileStamp& stamp) {
  clear();
  m_path = QFileInfo(path).absoluteFilePath();
  m_read = stamp;
  // The folder reports what the file itself cannot: that another file has its name.
  m_watcher.addPath(QFileInfo(m_path).absolutePath());
  look();
}

void FileWatch::clear() {
  m_settle.stop();
  m_path.clear();
  m_state = State::Same;
  const QStringList watched = m_watcher.files() + m_watcher.directories();
  if (!watched.isEmpty()) {
    m_watcher.removePaths(watched);
  }
}

void FileWatch::look() {
  if (m_path.isEmpty()) {
    return;
  }
  const FileStamp now = fileStamp(m_path);
  if (now.exists) {
    // After a replacement the watch is still on the old file: watch the new one.
    if (m_watcher.files().contains(m_path)) {
      m_watcher.removePath(m_path);
    }
    m_watcher.addPath(m_path);
  }
  const State state = !now.exists ? State::Gone : (now == m_read ? State::Same : State::Changed);
  if (state != m_state) {
    m_state = state;
    Q_EMIT stateChanged(state);
  }
}

}  // namespace rivulet::session
