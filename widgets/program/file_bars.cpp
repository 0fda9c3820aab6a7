// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/program/file_bars.h"

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <cmath>

#include "widgets/common/icons.h"
#include "widgets/common/theme.h"

namespace rivulet::widgets {

namespace {

constexpr int kSteps = 1000;
constexpr int kMomentMs = 200;

}  // namespace

LoadBar::LoadBar(QWidget* parent) : Page(parent), m_bar(new QProgressBar(this)) {
  m_bar->setRange(0, kSteps);
  inRow({m_name, {m_bar, 1}, m_cancel}, this, QMargins(12, 2, 12, 2));
  m_showTimer.setSingleShot(true);
  m_showTimer.setInterval(kMomentMs);
  connect(&m_showTimer, &QTimer::timeout, this, &LoadBar::show);
  hide();
  retranslate();
}

void LoadBar::setProgress(const std::optional<double>& share, const QString& name) {
  if (share) {
    m_fileName = name;
    m_bar->setValue(static_cast<int>(std::lround(*share * kSteps)));
    retranslate();
    if (isHidden() && !m_showTimer.isActive()) {
      m_showTimer.start();
    }
  } else {
    m_showTimer.stop();
    hide();
  }
}

void LoadBar::retranslate() {
  m_name->setText(tr("Reading %1").arg(m_fileName));
}

FileBanner::FileBanner(QWidget* parent) : Page(parent) {
  inRow({m_icon, {m_text, 1}, m_reload}, this, QMargins(12, 2, 12, 2));
  hide();
  retranslate();
  restyle();
}

void FileBanner::setState(State state) {
  m_state = state;
  setVisible(state != State::Same);
  retranslate();
}

void FileBanner::setProgram(const QString& name, const QString& hash) {
  m_fileName = name;
  m_hash = hash;
  retranslate();
}

void FileBanner::setRunning(bool running) {
  m_running = running;
  retranslate();
}

void FileBanner::retranslate() {
  const bool changed = m_state == State::Changed;
  QString text = changed ? tr("The file %1 has changed.").arg(m_fileName)
                         : tr("The file %1 is no longer there.").arg(m_fileName);
  if (m_running) {
    text += QLatin1Char(' ') + tr("The run keeps version %1.").arg(m_hash);
  } else {
    text += QLatin1Char(' ') +
            (changed ? tr("Reload it?") : tr("Version %1 stays loaded.").arg(m_hash));
  }
  m_text->setText(text);
  m_reload->setVisible(changed && !m_running);
}

void FileBanner::restyle() {
  m_icon->setPixmap(iconPixmap(QStringLiteral("status-attention"), themeColors(palette()).attention,
                               24, devicePixelRatioF()));
}

void FileBanner::paintEvent(QPaintEvent* /*event*/) {
  paintAttentionBar(*this);
}

}  // namespace rivulet::widgets
