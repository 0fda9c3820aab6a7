// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/common/file_field.h"

#include <QLineEdit>
#include <QPushButton>

#include "widgets/common/page.h"
#include "widgets/common/sheet_area.h"
#include "widgets/common/theme.h"

namespace rivulet::widgets {

FileField::FileField(const QString& name, QWidget* parent)
    : QWidget(parent), m_edit(new QLineEdit(this)), m_choose(makeTouchButton(this)) {
  m_edit->setObjectName(name);
  m_choose->setObjectName(name + QStringLiteral("-choose"));
  m_edit->setMinimumHeight(kTouchHeightPx);
  inRow({{m_edit, 1}, m_choose}, this, QMargins(0, 0, 0, 0));
  setFocusProxy(m_edit);
  connect(m_edit, &QLineEdit::returnPressed, this, &FileField::submitted);
  connect(m_choose, &QPushButton::clicked, this, &FileField::choose);
}

void FileField::setTexts(const QString& what, const QString& toolTip, const QString& filter) {
  m_what = what;
  m_filter = filter;
  m_edit->setAccessibleName(what);
  m_edit->setPlaceholderText(what);
  m_edit->setToolTip(toolTip);
  m_choose->setText(tr("Choose…"));
  m_choose->setToolTip(tr("Choose the file: %1").arg(what));
}

void FileField::setFile(const QString& file) {
  m_edit->setText(file);
}

QString FileField::file() const {
  return m_edit->text().trimmed();
}

void FileField::choose() {
  askForFile(this, {m_what, m_edit->text(), m_filter},
             [this](const QString& file) { m_edit->setText(file); });
}

}  // namespace rivulet::widgets
