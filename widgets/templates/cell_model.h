// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Which R-parameter means what, as a table: role, R-parameters, who writes them.
/// @threadsafety GUI thread.
#pragma once

#include <functional>
#include <optional>

#include "templates/cells.h"
#include "widgets/common/table_model.h"

namespace rivulet::widgets {

struct CellRow {
  std::function<QString()> role;  ///< in the present language
  QString parameters;
  enum class Writer { Client, Nc, Both } writer = Writer::Client;
};

class CellModel final : public TableModel<CellRow> {
  Q_OBJECT

 public:
  enum Column { Role, Parameters, Writer };

  explicit CellModel(QObject* parent = nullptr);

  void setCells(const std::optional<templates::CellMap>& cells);
};

}  // namespace rivulet::widgets
