// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/trace/path_panel.h"

#include <QComboBox>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QSplitter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "widgets/common/number_format.h"
#include "widgets/common/theme.h"
#include "widgets/plots/time_window.h"
#include "widgets/program/program_text_view.h"
#include "widgets/scope/path_pane.h"
#include "widgets/scope/scope_view.h"

namespace rivulet::widgets {

namespace {

QString lineSignal() {
  return QStringLiteral("program_line");
}

}  // namespace

PathPanel::PathPanel(ScopeCurves* curves, TimeWindow* window, ScopeCursors* cursors,
                     ScopeView* view, QWidget* parent)
    : Page(parent),
      m_curves(curves),
      m_window(window),
      m_cursors(cursors),
      m_view(view),
      m_path(new PathPane(curves, window, cursors, this)),
      m_text(say(new ProgramTextView(this),
                 {.tip = QT_TR_NOOP("The line under cursor A is marked. A click on a line puts "
                                    "cursor A where it was executed."),
                  .name = QT_TR_NOOP("Text of the program"),
                  .id = "traceProgram"})) {
  for (QPushButton* button : {m_top, m_spatial}) {
    button->setCheckable(true);
    button->setAutoExclusive(true);
  }
  m_top->setChecked(true);
  for (QComboBox* list : {m_error, m_colour}) {
    list->setMinimumHeight(kTouchHeightPx);
    list->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    list->setMinimumContentsLength(6);
  }
  for (const double factor : PathPane::kEnlargements) {
    m_error->addItem(QString(), factor);
  }
  auto* look = inRow({m_top, m_spatial, {m_error, 1}});
  look->setSpacing(4);
  auto* body = new QSplitter(Qt::Vertical, this);
  body->setObjectName(QStringLiteral("tracePathBody"));
  body->setChildrenCollapsible(false);
  body->setHandleWidth(6);
  body->addWidget(m_path);
  body->addWidget(m_text);
  body->setStretchFactor(0, 3);
  body->setStretchFactor(1, 2);
  body->setSizes({3000, 2000});
  inColumn({look, m_colour, {body, 1}, m_note}, this, QMargins(4, 6, 4, 4));
  connect(m_error, &QComboBox::activated, this, &PathPanel::showView);
  connect(m_colour, &QComboBox::activated, this, &PathPanel::showView);
  connect(m_curves, &ScopeCurves::tracesChanged, this, &PathPanel::listSignals);
  connect(m_view, &ScopeView::changed, this, &PathPanel::listSignals);
  connect(m_cursors, &ScopeCursors::changed, this, &PathPanel::follow);
  connect(m_curves, &ScopeCurves::changed, this, &PathPanel::follow);
  connect(m_text, &ProgramTextView::lineChosen, this, &PathPanel::choose);
  onLanguage(&PathPanel::setEnlargements, &PathPanel::listSignals, &PathPanel::showNote);
  onTheme(&PathPanel::showNote);
}

void PathPanel::setProgram(std::shared_ptr<const overview::ProgramView> view) {
  // Points for another position of the tool come with the same text.
  const bool isSameText = m_program && view && m_program->program == view->program;
  m_program = std::move(view);
  if (!isSameText) {
    m_text->setProgram(m_program);
  }
  follow();
}

void PathPanel::listSignals() {
  const QString chosen = m_path->colouring();
  m_formulas = {QString()};
  m_colour->clear();
  m_colour->addItem(tr("Colour: the trace"));
  for (const trace::SignalOffer& offer : m_curves->offers()) {
    m_formulas.push_back(QString::fromStdString(offer.formula));
    m_colour->addItem(tr("Colour: %1").arg(signalTitle(offer)));
  }
  // The operator's own formulas.
  for (const QStringList& pane : m_view->arrangement()) {
    for (const QString& formula : pane) {
      if (std::find(m_formulas.begin(), m_formulas.end(), formula) == m_formulas.end()) {
        m_formulas.push_back(formula);
        m_colour->addItem(tr("Colour: %1").arg(formula));
      }
    }
  }
  const auto found = std::find(m_formulas.begin(), m_formulas.end(), chosen);
  m_colour->setCurrentIndex(
      found == m_formulas.end() ? 0 : static_cast<int>(found - m_formulas.begin()));
  showView();
}

void PathPanel::setEnlargements() {
  for (int i = 0; i < m_error->count(); ++i) {
    m_error->setItemText(
        i,
        tr("Error × %1").arg(numberText(PathPane::kEnlargements[static_cast<std::size_t>(i)], 0)));
  }
}

void PathPanel::showView() {
  m_error->setEnabled(m_path->canEnlarge());
  m_error->setToolTip(m_path->canEnlarge()
                          ? tr("How many times larger the distance to the programmed path is drawn")
                          : tr("Errors can be drawn larger after the trace has been compared with "
                               "its NC program"));
  m_path->setSpatial(m_spatial->isChecked());
  m_path->setEnlargement(m_error->currentData().toDouble());
  m_path->setColouring(m_formulas[static_cast<std::size_t>(std::max(0, m_colour->currentIndex()))]);
}

void PathPanel::redrawNow() {
  m_path->redrawNow();
}

PathPanel::Obstacle PathPanel::obstacle() const {
  if (!m_program) {
    return Obstacle::NoProgram;
  }
  if (m_curves->isLive() || m_curves->traces().empty()) {
    return Obstacle::Live;
  }
  const trace::ShownTrace& trace = *m_curves->traces().front();
  if (!trace.programHash.empty() && trace.programHash != m_program->program->hash) {
    return Obstacle::OtherProgram;
  }
  if (!trace.isAnalysed) {
    return Obstacle::NotYet;
  }
  const bool hasLines = trace.signalSet.find(lineSignal().toStdString()) != nullptr;
  return hasLines ? Obstacle::None : Obstacle::NoLines;
}

/// Marks the line of cursor A.
void PathPanel::follow() {
  if (m_isGoing) {
    return;  // where it goes is a beginning of the line chosen, and of others at the same place
  }
  m_chosen = 0;
  const auto& at = m_cursors->atS(ScopeCursors::A);
  const auto lines = obstacle() == Obstacle::None ? m_curves->samples(0, lineSignal()) : nullptr;
  const double line = lines && at ? trace::heldValueAt(*lines, instantOf(*at)) : std::nan("");
  m_marked = std::isfinite(line) ? static_cast<std::size_t>(line) : 0;
  m_text->setRunLine(m_marked, true);
  showNote();
}

void PathPanel::choose(std::size_t line) {
  const auto lines = obstacle() == Obstacle::None ? m_curves->samples(0, lineSignal()) : nullptr;
  if (!lines) {
    return;
  }
  m_curves->run([self = QPointer(this), request = ++m_request, lines,
                 line]() -> std::function<void()> {
    const std::vector<trace::ValueSpan> spans = trace::spansOf(*lines, static_cast<double>(line));
    return [self, request, line, spans] {
      if (self && self->m_request == request) {
        self->goTo(line, spans);
      }
    };
  });
}

void PathPanel::goTo(std::size_t line, const std::vector<trace::ValueSpan>& spans) {
  m_time = line == m_chosen && m_times > 0 ? m_time % m_times + 1 : 1;
  m_times = spans.size();
  m_chosen = line;
  if (!spans.empty()) {
    const double atS = base::toSeconds(spans[m_time - 1].from);
    m_isGoing = true;
    m_window->reveal(atS);
    m_cursors->set(ScopeCursors::A, atS);
    m_isGoing = false;
    m_marked = line;
    m_text->setRunLine(line, false);
  }
  showNote();
}

void PathPanel::showNote() {
  QString text;
  const Obstacle why = obstacle();
  switch (why) {
    case Obstacle::NoProgram:
      text = tr("Open the NC program of the trace to see its lines with the cursor.");
      break;
    case Obstacle::Live:
      text = tr("Lines and trace are linked when a trace is shown.");
      break;
    case Obstacle::OtherProgram:
      text =
          tr("The run was made with another program or another version of it. Open that one to "
             "see its lines with the cursor.");
      break;
    case Obstacle::NotYet:
      text = tr("Comparing the trace with the program …");
      break;
    case Obstacle::NoLines:
      text = tr("The trace does not show where it is in the program.");
      break;
    case Obstacle::None:
      if (m_chosen > 0 && m_times == 0) {
        text = tr("Nothing moved in line %1.").arg(m_chosen);
      } else if (m_chosen > 0 && m_times > 1) {
        text =
            tr("Line %1 was executed %2 times. Cursor A is at number %3; click again for the next.")
                .arg(m_chosen)
                .arg(m_times)
                .arg(m_time);
      } else {
        text = tr("A click on a line puts cursor A where it was executed.");
      }
      break;
  }
  m_note->setText(text);
  setMuted(m_note, palette());
  if (why == Obstacle::OtherProgram) {
    QPalette attention = m_note->palette();
    attention.setColor(QPalette::WindowText, themeColors(palette()).attention);
    m_note->setPalette(attention);
  }
}

}  // namespace rivulet::widgets
