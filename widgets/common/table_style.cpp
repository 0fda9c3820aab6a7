// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/common/table_style.h"

#include <QHeaderView>
#include <QTableView>

#include "widgets/common/diagnostic_text.h"
#include "widgets/common/icons.h"
#include "widgets/common/theme.h"

namespace rivulet::widgets {

void styleTable(QTableView* table) {
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  table->setSelectionMode(QAbstractItemView::SingleSelection);
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setAlternatingRowColors(true);
  table->setShowGrid(false);
  table->setWordWrap(false);
  table->verticalHeader()->hide();
  table->verticalHeader()->setDefaultSectionSize(28);
  table->horizontalHeader()->setHighlightSections(false);
  table->horizontalHeader()->setMinimumSectionSize(40);
}

QIcon severityIcon(gcode::Severity severity, const QPalette& palette) {
  const ThemeColors& colors = themeColors(palette);
  const QColor color =
      severity == gcode::Severity::Error
          ? colors.fault
          : (severity == gcode::Severity::Warning ? colors.attention : colors.mutedText);
  return themedIcon(severityIconName(severity), color);
}

}  // namespace rivulet::widgets
