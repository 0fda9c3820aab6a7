// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Reads NC programs away from the GUI thread. Only the result of the request made last is
/// reported. @threadsafety GUI thread; the reading itself runs in the global pool.
#pragma once

#include <QObject>
#include <QString>
#include <memory>

#include "base/result.h"
#include "gcode/program.h"

namespace rivulet::session {

class ProgramLoader final : public QObject {
  Q_OBJECT

 public:
  explicit ProgramLoader(QObject* parent = nullptr) : QObject(parent) {}

  void load(const QString& path);

 Q_SIGNALS:
  void loaded(const std::shared_ptr<const rivulet::gcode::Program>& program, const QString& path);
  void failed(const rivulet::base::Error& error, const QString& path);

 private:
  int m_latest = 0;
};

}  // namespace rivulet::session
