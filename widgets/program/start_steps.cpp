// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/program/start_steps.h"

#include <QFrame>
#include <QLabel>
#include <QPushButton>

#include "widgets/common/status_label.h"
#include "widgets/common/theme.h"
#include "widgets/connection/connection_state.h"

namespace rivulet::widgets {

namespace {

constexpr int kNarrowPx = 860;
constexpr int kWidthPxMax = 1040;
constexpr int kGapPx = 12;
constexpr int kCardMarginPx = 20;
constexpr int kNumberPx = 34;
constexpr double kTitlePt = 20.0;
constexpr double kCardTitlePt = 14.0;

void setSize(QLabel* label, double points) {
  QFont font = label->font();
  font.setPointSizeF(points);
  font.setBold(true);
  label->setFont(font);
}

}  // namespace

StartSteps::StartSteps(QWidget* parent)
    : Page(parent),
      m_state(status({.wraps = true})),
      m_virtual(button({.text = QT_TR_NOOP("Start a virtual machine"), .id = "virtual-machine"},
                       [this] { Q_EMIT virtualMachineRequested(); })),
      m_connect(button({.text = QT_TR_NOOP("Connect to a control …"), .id = "connect-control"},
                       [this] { Q_EMIT connectRequested(); })),
      m_open(button({.text = QT_TR_NOOP("Open …"), .id = "open-first"},
                    [this] { Q_EMIT openRequested(); })),
      m_openSample(button({.id = "open-sample"}, [this] { Q_EMIT sampleRequested(); })),
      m_live(button({.text = QT_TR_NOOP("Live …"),
                     .tip = QT_TR_NOOP("Points from a program or a sensor, while they are made")},
                    [this] { Q_EMIT liveRequested(); })),
      m_cards(new QBoxLayout(QBoxLayout::LeftToRight)) {
  auto* title = heading({.text = QT_TR_NOOP("Three steps to a moving machine"), .wraps = true});
  setSize(title, kTitlePt);
  m_cards->setSpacing(kGapPx);
  m_cards->addWidget(
      card(0, label({.text = QT_TR_NOOP("Connect")}),
           label({.text = QT_TR_NOOP("Your control by its address, or a virtual machine on this "
                                     "computer: the same program, and nothing real moves."),
                  .wraps = true}),
           {m_state, m_virtual, m_connect}),
      1);
  m_cards->addWidget(
      card(1, label({.text = QT_TR_NOOP("Open a program")}),
           label({.text = QT_TR_NOOP("Any CAM program: SINUMERIK, ISO, LinuxCNC, Grbl, Heidenhain. "
                                     "Or the sample."),
                  .wraps = true}),
           {m_open, m_openSample, m_live}),
      1);
  m_cards->addWidget(
      card(2, label({.text = QT_TR_NOOP("Start")}),
           label({.text = QT_TR_NOOP("Start, below at the right, checks travel, tools and data "
                                     "rate, shows the first move, and waits for you."),
                  .wraps = true}),
           {}),
      1);
  auto* middle = new QWidget(this);
  middle->setMaximumWidth(kWidthPxMax);
  inColumn({spring(), title,
            label({.text = QT_TR_NOOP("Nothing moves before you hold Start."), .isMuted = true}),
            m_cards, spring(2)},
           middle)
      ->setSpacing(kGapPx);
  inRow({spring(), {middle, 100}, spring()}, this);
  onLanguage(&StartSteps::showSteps);
  restyle();
}

QWidget* StartSteps::card(int number, QLabel* title, QLabel* text,
                          std::initializer_list<InBox> below) {
  auto* frame = new QFrame(this);
  frame->setFrameShape(QFrame::StyledPanel);
  frame->setAutoFillBackground(true);
  frame->setBackgroundRole(QPalette::Base);
  auto* mark = new QLabel(QString::number(number + 1), frame);
  mark->setAlignment(Qt::AlignCenter);
  mark->setFixedSize(kNumberPx, kNumberPx);
  mark->setAutoFillBackground(true);
  mark->setBackgroundRole(QPalette::Window);  // that of the card else
  m_numbers[static_cast<std::size_t>(number)] = mark;
  setSize(mark, kCardTitlePt);
  setSize(title, kCardTitlePt);
  text->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  auto* rows = inColumn({inRow({mark, {title, 1}}), {text, 1}}, frame,
                        QMargins(kCardMarginPx, kCardMarginPx, kCardMarginPx, kCardMarginPx));
  rows->setSpacing(kGapPx);
  for (const InBox& part : below) {
    rows->addWidget(part.widget);
  }
  return frame;
}

void StartSteps::setConnection(ConnectionState state) {
  m_connection = state;
  showSteps();
}

void StartSteps::setOpenEnabled(bool enabled) {
  for (QPushButton* const each : {m_open, m_openSample, m_live}) {
    each->setEnabled(enabled);
  }
}

void StartSteps::setSample(const QString& name) {
  m_sample = name;
  showSteps();
}

void StartSteps::showSteps() {
  const ThemeColors& colors = themeColors(palette());
  const bool isAlone = m_connection == ConnectionState::Disconnected;
  m_state->setVisible(!isAlone);
  m_state->setStatus(connectionStatus(m_connection), connectionText(m_connection));
  m_virtual->setEnabled(isAlone);
  m_connect->setEnabled(isAlone);
  m_openSample->setVisible(!m_sample.isEmpty());
  m_openSample->setText(tr("Sample: %1").arg(m_sample));
  const std::size_t next = m_connection == ConnectionState::Connected ? 1 : 0;
  for (std::size_t i = 0; i < m_numbers.size(); ++i) {
    QPalette own = palette();
    own.setColor(QPalette::Window, i == next ? colors.railChosen : colors.window);
    own.setColor(QPalette::WindowText, i == next ? colors.onFill : colors.mutedText);
    m_numbers[i]->setPalette(own);
  }
  for (const auto& [each, isNext] :
       {std::pair(m_virtual, next == 0), std::pair(m_open, next == 1)}) {
    if (isNext) {
      fillButton(*each, colors.railChosen);
    } else {
      each->setPalette(palette());
    }
  }
}

void StartSteps::restyle() {
  showSteps();
}

void StartSteps::resizeEvent(QResizeEvent* event) {
  Page::resizeEvent(event);
  m_cards->setDirection(width() < kNarrowPx ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

}  // namespace rivulet::widgets
