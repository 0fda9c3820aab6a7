// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/trace/layout_menu.h"
#include "widgets/common/sheet_area.h"

#include <QActionGroup>
#include <QInputDialog>

namespace rivulet::widgets {

namespace {

constexpr int kNameMax = 60;

/// A name is no shortcut.
QString asItem(QString name) {
  return name.replace(QLatin1Char('&'), QStringLiteral("&&"));
}

}  // namespace

LayoutMenu::LayoutMenu(QWidget* parent) : QMenu(parent) {
  connect(this, &QMenu::aboutToShow, this, &LayoutMenu::fill);
}

void LayoutMenu::setLayouts(ScopeLayouts layouts) {
  m_layouts = std::move(layouts);
}

void LayoutMenu::fill() {
  clear();
  for (const ScopeLayout& layout : m_layouts.list) {
    addAction(asItem(layout.name), this,
              [this, name = layout.name] { Q_EMIT showRequested(name); });
  }
  if (m_layouts.list.empty()) {
    addAction(tr("No layout is kept yet"))->setEnabled(false);
  }
  addSeparator();
  addAction(tr("Keep the present panes as…"), this, &LayoutMenu::askName);
  if (m_layouts.list.empty()) {
    return;
  }
  QMenu* ofNew = addMenu(tr("New traces are shown in"));
  auto* choice = new QActionGroup(ofNew);
  const auto offer = [&](const QString& text, const QString& name) {
    QAction* action =
        ofNew->addAction(text, this, [this, name] { Q_EMIT standardRequested(name); });
    action->setCheckable(true);
    action->setActionGroup(choice);
    action->setChecked(name == m_layouts.standard);
  };
  offer(tr("the usual panes"), QString());
  QMenu* remove = addMenu(tr("Delete"));
  for (const ScopeLayout& layout : m_layouts.list) {
    offer(asItem(layout.name), layout.name);
    remove->addAction(asItem(layout.name), this,
                      [this, name = layout.name] { Q_EMIT deleteRequested(name); });
  }
}

void LayoutMenu::askName() {
  auto* dialog = new QInputDialog;
  dialog->setWindowTitle(tr("Keep the panes"));
  dialog->setLabelText(tr("Name of the layout; one of the same name is replaced"));
  connect(dialog, &QInputDialog::textValueSelected, this, [this](const QString& text) {
    const QString name = text.simplified().left(kNameMax);
    if (!name.isEmpty()) {
      Q_EMIT keepRequested(name);
    }
  });
  openSheet(dialog, parentWidget());
}

}  // namespace rivulet::widgets
