// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The pauses of a run as a table: start, duration, origin.
/// @threadsafety GUI thread.
#pragma once

#include "trace/pause.h"
#include "widgets/common/table_model.h"

namespace rivulet::widgets {

class PauseModel final : public TableModel<trace::Pause> {
  Q_OBJECT

 public:
  enum Column { Start, Duration, Origin };

  explicit PauseModel(QObject* parent = nullptr);
};

}  // namespace rivulet::widgets
