// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Signals that end a program (SIGHUP, SIGINT, SIGTERM) as a signal of Qt, so that a run in
/// progress can be stopped first. One object in a program. @threadsafety GUI thread.
#pragma once

#include <QObject>

namespace rivulet::hmi {

class EndSignals final : public QObject {
  Q_OBJECT

 public:
  explicit EndSignals(QObject* parent = nullptr);
  ~EndSignals() override;

 Q_SIGNALS:
  void received();
};

}  // namespace rivulet::hmi
