// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The pauses of a run as a table: start, duration, origin.
/// @threadsafety GUI thread.
#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "trace/pause.h"

namespace rivulet::widgets {

class PauseModel final : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { Start, Duration, Origin, ColumnCount };

  explicit PauseModel(QObject* parent = nullptr);

  void setPauses(std::vector<trace::Pause> pauses);
  void append(const trace::Pause& pause);
  void retranslate();
  [[nodiscard]] const std::vector<trace::Pause>& pauses() const { return m_pauses; }

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role) const override;

 private:
  std::vector<trace::Pause> m_pauses;
};

}  // namespace rivulet::widgets
