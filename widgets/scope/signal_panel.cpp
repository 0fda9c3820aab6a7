// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/scope/signal_panel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QPushButton>
#include <QStyledItemDelegate>
#include <QTreeWidget>
#include <algorithm>
#include <optional>

#include "widgets/common/error_text.h"
#include "widgets/common/theme.h"
#include "widgets/scope/scope_curves.h"
#include "widgets/scope/scope_pane.h"

namespace rivulet::widgets {

namespace {

constexpr int kFormulaRole = Qt::UserRole;

/// Signals are dragged as their formula.
class SignalTree final : public QTreeWidget {
 public:
  using QTreeWidget::QTreeWidget;

 protected:
  QMimeData* mimeData(const QList<QTreeWidgetItem*>& items) const override {
    auto* dragged = new QMimeData;
    for (const QTreeWidgetItem* item : items) {
      dragged->setData(ScopePane::mimeType(), item->data(0, kFormulaRole).toString().toUtf8());
    }
    return dragged;
  }
};

/// A row is high enough for a finger.
class TouchRow final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option,
                               const QModelIndex& index) const override {
    return QStyledItemDelegate::sizeHint(option, index).expandedTo({0, kTouchHeightPx});
  }
};

}  // namespace

SignalPanel::SignalPanel(std::function<bool(const QString&)> isShown, QWidget* parent)
    : Page(parent),
      m_isShown(std::move(isShown)),
      m_tree(say(new SignalTree(this), {.name = QT_TR_NOOP("Signals"), .id = "signalTree"})),
      m_tables(new QMenu(this)) {
  m_search->setClearButtonEnabled(true);
  m_tree->setColumnCount(2);
  m_tree->setHeaderHidden(true);
  m_tree->setDragEnabled(true);
  m_tree->setItemDelegate(new TouchRow(m_tree));
  m_tree->setUniformRowHeights(true);
  m_tree->header()->setStretchLastSection(false);
  m_tree->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  m_tree->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  m_tree->setMinimumHeight(100);
  m_tree->installEventFilter(this);
  m_formulaNote->setTextFormat(Qt::PlainText);
  m_formulaNote->hide();
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(4);
  for (QPushButton* button : {m_newPane, m_add, m_remove}) {
    button->setAutoDefault(false);
    buttons->addWidget(button, 1);
  }
  inColumn({m_search, {m_tree, 1}, buttons, m_formula, m_formulaNote, m_columns}, this,
           QMargins(4, 6, 4, 4));
  m_columns->hide();
  connect(m_columns, &QPushButton::clicked, this, [this] {
    if (m_tables->isEmpty()) {
      Q_EMIT columnsRequested(0);
    }
  });

  connect(m_search, &QLineEdit::textChanged, this, &SignalPanel::filter);
  connect(m_tree, &QTreeWidget::itemDoubleClicked, this, [this] { activate(true); });
  connect(m_tree, &QTreeWidget::currentItemChanged, this, &SignalPanel::showButtons);
  connect(m_newPane, &QPushButton::clicked, this, [this] { activate(true); });
  connect(m_add, &QPushButton::clicked, this, [this] { activate(false); });
  connect(m_remove, &QPushButton::clicked, this, [this] {
    if (!currentFormula().isEmpty()) {
      Q_EMIT removeRequested(currentFormula());
    }
  });
  connect(m_formula, &QLineEdit::returnPressed, this, &SignalPanel::addFormula);
  connect(m_formula, &QLineEdit::textEdited, m_formulaNote, &QWidget::hide);
  retranslate();
  restyle();
}

void SignalPanel::setOffers(std::vector<trace::SignalOffer> offers) {
  m_offers = std::move(offers);
  fill();
}

void SignalPanel::fill() {
  const QString current = currentFormula();
  m_tree->clear();
  QTreeWidgetItem* group = nullptr;
  std::optional<trace::SignalGroup> of;
  for (const trace::SignalOffer& offer : m_offers) {
    if (!of || *of != offer.group) {
      of = offer.group;
      group = new QTreeWidgetItem(m_tree, {signalGroupTitle(offer.group)});
      group->setFlags(Qt::ItemIsEnabled);
      group->setFirstColumnSpanned(true);
    }
    auto* item =
        new QTreeWidgetItem(group, {signalTitle(offer), QString::fromStdString(offer.unit)});
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsDragEnabled);
    const QString formula = QString::fromStdString(offer.formula);
    item->setData(0, kFormulaRole, formula);
    item->setToolTip(0, formula);
    if (formula == current) {
      m_tree->setCurrentItem(item);
    }
  }
  m_tree->expandAll();
  refresh();
  filter();
}

void SignalPanel::setTables(const QStringList& names) {
  m_columns->setVisible(!names.isEmpty());
  m_tables->clear();
  for (qsizetype i = 0; i < names.size() && names.size() > 1; ++i) {
    connect(m_tables->addAction(names[i]), &QAction::triggered, this,
            [this, i] { Q_EMIT columnsRequested(static_cast<int>(i)); });
  }
  m_columns->setMenu(m_tables->isEmpty() ? nullptr : m_tables);
}

void SignalPanel::refresh() {
  for (int i = 0; i < m_tree->topLevelItemCount(); ++i) {
    QTreeWidgetItem* group = m_tree->topLevelItem(i);
    for (int j = 0; j < group->childCount(); ++j) {
      QTreeWidgetItem* item = group->child(j);
      const bool isShown = m_isShown(item->data(0, kFormulaRole).toString());
      QFont font = m_tree->font();
      font.setBold(isShown);
      item->setFont(0, font);
      item->setData(0, Qt::AccessibleDescriptionRole, isShown ? tr("shown") : QString());
    }
  }
  showButtons();
}

void SignalPanel::filter() {
  const QString wanted = m_search->text().trimmed();
  for (int i = 0; i < m_tree->topLevelItemCount(); ++i) {
    QTreeWidgetItem* group = m_tree->topLevelItem(i);
    const bool isGroup = group->text(0).contains(wanted, Qt::CaseInsensitive);
    bool any = false;
    for (int j = 0; j < group->childCount(); ++j) {
      QTreeWidgetItem* item = group->child(j);
      const bool fits = isGroup || item->text(0).contains(wanted, Qt::CaseInsensitive) ||
                        item->toolTip(0).contains(wanted, Qt::CaseInsensitive);
      item->setHidden(!fits);
      any = any || fits;
    }
    group->setHidden(!any);
  }
}

QString SignalPanel::currentFormula() const {
  const QTreeWidgetItem* item = m_tree->currentItem();
  return item == nullptr || item->isHidden() ? QString() : item->data(0, kFormulaRole).toString();
}

void SignalPanel::activate(bool inOwnPane) {
  const QString formula = currentFormula();
  if (formula.isEmpty()) {
    return;
  }
  if (inOwnPane) {
    Q_EMIT paneRequested(formula);
  } else {
    Q_EMIT addRequested(formula);
  }
}

void SignalPanel::addFormula() {
  const QString text = m_formula->text().trimmed();
  if (text.isEmpty()) {
    return;
  }
  if (const auto formula = trace::Formula::parse(text.toStdString()); !formula) {
    showFormulaError(formula.error());
    return;
  }
  m_formulaNote->hide();
  Q_EMIT paneRequested(text);
}

void SignalPanel::showFormulaError(const base::Error& error) {
  m_formulaError = error;
  m_formulaNote->setText(errorText(m_formulaError));
  m_formulaNote->show();
}

void SignalPanel::showButtons() {
  const QString formula = currentFormula();
  m_newPane->setEnabled(!formula.isEmpty());
  m_add->setEnabled(!formula.isEmpty());
  m_remove->setEnabled(!formula.isEmpty() && m_isShown(formula));
}

bool SignalPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == m_tree && event->type() == QEvent::KeyPress) {
    const auto* key = static_cast<QKeyEvent*>(event);
    switch (key->key()) {
      case Qt::Key_Return:
      case Qt::Key_Enter:
        activate(!key->modifiers().testFlag(Qt::ShiftModifier));
        return true;
      case Qt::Key_Delete:
        if (m_remove->isEnabled()) {
          Q_EMIT removeRequested(currentFormula());
        }
        return true;
      default:
        break;
    }
  }
  return Page::eventFilter(watched, event);
}

void SignalPanel::retranslate() {
  m_formula->setPlaceholderText(QStringLiteral("hypot(x_act-x_set, y_act-y_set)"));
  m_formulaNote->setText(errorText(m_formulaError));
  fill();
}

void SignalPanel::restyle() {
  QPalette fault = m_formulaNote->palette();
  fault.setColor(QPalette::WindowText, themeColors(palette()).fault);
  m_formulaNote->setPalette(fault);
}

}  // namespace rivulet::widgets
