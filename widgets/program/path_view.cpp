// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/program/path_view.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QPushButton>

#include "widgets/common/icons.h"
#include "widgets/common/theme.h"
#include "widgets/program/path_canvas.h"

namespace rivulet::widgets {

PathView::PathView(QWidget* parent)
    : Page(parent),
      m_canvas(new PathCanvas(this)),
      m_top(makeTouchButton(this)),
      m_isometric(makeTouchButton(this)),
      m_fit(makeTouchButton(this)) {
  auto* group = new QButtonGroup(this);
  for (QPushButton* button : {m_top, m_isometric}) {
    button->setCheckable(true);
    group->addButton(button);
  }
  m_top->setChecked(true);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(m_top);
  buttons->addWidget(m_isometric);
  buttons->addStretch();
  buttons->addWidget(m_fit);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(buttons);
  layout->addWidget(m_canvas, 1);
  connect(m_top, &QPushButton::clicked, this, [this] { setIsometric(false); });
  connect(m_isometric, &QPushButton::clicked, this, [this] { setIsometric(true); });
  connect(m_fit, &QPushButton::clicked, this, &PathView::fit);
  retranslate();
  restyle();
}

void PathView::setProgram(std::shared_ptr<const gcode::Program> program) {
  m_canvas->setProgram(std::move(program));
}

void PathView::setPoints(const std::vector<gcode::StreamPoint>& points) {
  m_canvas->setPoints(points);
}

void PathView::setExecuted(std::size_t count) {
  m_canvas->setExecuted(count);
}

void PathView::setToolPosition(const std::optional<base::Vec3>& positionMm) {
  m_canvas->setToolPosition(positionMm);
}

void PathView::setIsometric(bool isometric) {
  (isometric ? m_isometric : m_top)->setChecked(true);
  m_canvas->setView(isometric ? PathCanvas::View::Isometric : PathCanvas::View::Top);
}

void PathView::fit() {
  m_canvas->fit();
}

void PathView::retranslate() {
  m_top->setText(tr("Top (XY)"));
  m_isometric->setText(tr("Isometric"));
  m_fit->setText(tr("Fit"));
  m_fit->setToolTip(tr("Show the whole path (double click does the same)"));
  m_canvas->setTexts({tr("No program is loaded"), tr("To cut"), tr("Rapid"), tr("Executed"),
                      tr("Start"), tr("Tool")});
}

void PathView::restyle() {
  const QColor color = themeColors(palette()).text;
  m_top->setIcon(themedIcon(QStringLiteral("view-top"), color));
  m_isometric->setIcon(themedIcon(QStringLiteral("view-isometric"), color));
  m_fit->setIcon(themedIcon(QStringLiteral("fit"), color));
}

}  // namespace rivulet::widgets
