// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The stops of a run as a table: start, duration, line, why or how it is known.
/// @threadsafety GUI thread.
#pragma once

#include "widgets/common/table_model.h"
#include "widgets/scope/stop_row.h"

namespace rivulet::widgets {

class StopModel final : public TableModel<StopRow> {
  Q_OBJECT

 public:
  enum Column { Start, Duration, Line, Cause };

  explicit StopModel(QObject* parent = nullptr);
};

}  // namespace rivulet::widgets
