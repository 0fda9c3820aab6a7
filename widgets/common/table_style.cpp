// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/common/table_style.h"

#include <QApplication>
#include <QHeaderView>
#include <QHelpEvent>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QToolTip>

#include "widgets/common/diagnostic_text.h"
#include "widgets/common/icons.h"
#include "widgets/common/theme.h"

namespace rivulet::widgets {

namespace {

/// Space between a cell's text and its neighbours.
class PaddedDelegate final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override {
    QStyleOptionViewItem padded = option;
    initStyleOption(&padded, index);
    const QStyle* style = padded.widget->style();
    style->drawPrimitive(QStyle::PE_PanelItemViewItem, &padded, painter, padded.widget);
    padded.rect.adjust(kPaddingPx, 0, -kPaddingPx, 0);
    style->drawControl(QStyle::CE_ItemViewItem, &padded, painter, padded.widget);
  }

  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option,
                               const QModelIndex& index) const override {
    QStyleOptionViewItem padded = option;
    padded.rect.adjust(kPaddingPx, 0, -kPaddingPx, 0);
    return QStyledItemDelegate::sizeHint(padded, index) + QSize(2 * kPaddingPx, 6);
  }

  /// What does not fit its cell is told when one points at it.
  bool helpEvent(QHelpEvent* event, QAbstractItemView* view, const QStyleOptionViewItem& option,
                 const QModelIndex& index) override {
    const QString text = index.data(Qt::DisplayRole).toString();
    if (event->type() == QEvent::ToolTip && index.data(Qt::ToolTipRole).toString().isEmpty() &&
        sizeHint(option, index).width() > option.rect.width()) {
      QToolTip::showText(event->globalPos(), text, view);
      return true;
    }
    return QStyledItemDelegate::helpEvent(event, view, option, index);
  }

 private:
  static constexpr int kPaddingPx = 5;
};

}  // namespace

void styleTable(QTableView* table) {
  table->setItemDelegate(new PaddedDelegate(table));
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
  QIcon icon = themedIcon(severityIconName(severity), color);
  for (const int size : {16, 20, 24, 32}) {
    // In a selected row the icon is on the background of the selection, as its text is.
    icon.addPixmap(
        iconPixmap(severityIconName(severity), palette.color(QPalette::HighlightedText), size),
        QIcon::Selected);
  }
  return icon;
}

}  // namespace rivulet::widgets
