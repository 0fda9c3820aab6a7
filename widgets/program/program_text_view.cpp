// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/program/program_text_view.h"

#include <QClipboard>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QScrollBar>
#include <QToolTip>
#include <algorithm>
#include <limits>

#include "widgets/common/diagnostic_text.h"
#include "widgets/common/icons.h"
#include "widgets/common/theme.h"
#include "widgets/program/job_text.h"

namespace rivulet::widgets {

namespace {

constexpr std::size_t kShownBytes = 4'000;  // of one line; no control takes more in a block
constexpr int kTabColumns = 8;
constexpr int kIconPx = 16;
constexpr int kGapPx = 6;
constexpr int kEdgePx = 6;  ///< of a line that the control executes itself

}  // namespace

ProgramTextView::ProgramTextView(QWidget* parent) : QAbstractScrollArea(parent) {
  QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
  fixed.setPointSizeF(std::max(fixed.pointSizeF(), 10.0));
  setFont(fixed);
  setFocusPolicy(Qt::StrongFocus);
  verticalScrollBar()->setSingleStep(3);
  connect(verticalScrollBar(), &QScrollBar::actionTriggered, this,
          &ProgramTextView::scrolledByHand);
  makeIcons();
}

void ProgramTextView::setProgram(std::shared_ptr<const overview::ProgramView> view) {
  m_program = std::move(view);
  m_current = 0;
  m_runLine = 0;
  m_marks.clear();
  if (m_program) {
    const auto& diagnostics = m_program->program->diagnostics;
    for (std::size_t i = 0; i < diagnostics.size(); ++i) {
      if (diagnostics[i].file.empty()) {
        m_marks.push_back({diagnostics[i].line.value, diagnostics[i].severity, i});
      }
    }
    // The worst of a line first; the others of the line are not marked.
    std::stable_sort(m_marks.begin(), m_marks.end(), [](const Mark& a, const Mark& b) {
      return a.line != b.line ? a.line < b.line : a.severity > b.severity;
    });
    m_marks.erase(std::unique(m_marks.begin(), m_marks.end(),
                              [](const Mark& a, const Mark& b) { return a.line == b.line; }),
                  m_marks.end());
  }
  setRanges();
  verticalScrollBar()->setValue(0);
  horizontalScrollBar()->setValue(0);
  viewport()->update();
}

void ProgramTextView::setCurrentLine(std::size_t line) {
  if (line < 1 || line > lines()) {
    return;
  }
  m_current = line;
  bringToSight(line);
  viewport()->update();
}

void ProgramTextView::setRunLine(std::size_t line, bool isFollowed) {
  m_runLine = line <= lines() ? line : 0;
  if (isFollowed && m_runLine > 0) {
    bringToSight(m_runLine);
  }
  viewport()->update();
}

void ProgramTextView::setHighlighted(const QString& text) {
  m_highlighted = text;
  viewport()->update();
}

void ProgramTextView::bringToSight(std::size_t line) {
  const std::size_t first = firstVisibleLine();
  if (line < first || line >= first + pageLines()) {
    // In the middle, so that what comes before and after is seen as well.
    const std::size_t half = pageLines() / 2;
    verticalScrollBar()->setValue(static_cast<int>(line - 1 > half ? line - 1 - half : 0));
  }
}

void ProgramTextView::wheelEvent(QWheelEvent* event) {
  QAbstractScrollArea::wheelEvent(event);
  Q_EMIT scrolledByHand();
}

void ProgramTextView::paintHighlights(QPainter& painter, const QString& text, int x, int y) const {
  QColor fill = themeColors(palette()).attention;
  fill.setAlpha(90);
  for (qsizetype at = text.indexOf(m_highlighted, 0, Qt::CaseInsensitive);
       at >= 0 && !m_highlighted.isEmpty();
       at = text.indexOf(m_highlighted, at + m_highlighted.size(), Qt::CaseInsensitive)) {
    const int from = fontMetrics().horizontalAdvance(text, static_cast<int>(at));
    const int to =
        fontMetrics().horizontalAdvance(text, static_cast<int>(at + m_highlighted.size()));
    painter.fillRect(x + from, y, to - from, lineHeightPx(), fill);
  }
}

QString ProgramTextView::lineText(std::size_t line) const {
  const std::string_view all = m_program->text.line(m_program->program->text, line - 1);
  const std::string_view bytes = all.substr(0, kShownBytes);
  const QString text =
      m_program->text.isUtf8()
          ? QString::fromUtf8(bytes.data(), static_cast<qsizetype>(bytes.size()))
          : QString::fromLatin1(bytes.data(), static_cast<qsizetype>(bytes.size()));
  if (!text.contains(QLatin1Char('\t')) && all.size() == bytes.size()) {
    return text;
  }
  QString shown;
  for (const QChar c : text) {
    if (c == QLatin1Char('\t')) {
      shown.append(QString(kTabColumns - shown.size() % kTabColumns, QLatin1Char(' ')));
    } else {
      shown.append(c);
    }
  }
  return all.size() == bytes.size() ? shown : shown + QChar(0x2026);
}

std::size_t ProgramTextView::firstVisibleLine() const {
  return static_cast<std::size_t>(verticalScrollBar()->value()) + 1;
}

void ProgramTextView::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(viewport());
  const ThemeColors& colors = themeColors(palette());
  const QRect area = viewport()->rect();
  painter.fillRect(area, colors.surface);
  m_painted = 0;
  if (lines() == 0) {
    painter.setPen(colors.mutedText);
    painter.drawText(area, Qt::AlignCenter | Qt::TextWordWrap, tr("No program is loaded"));
    return;
  }
  const int height = lineHeightPx();
  const int margin = marginPx();
  const int shift = horizontalScrollBar()->value();
  painter.fillRect(0, 0, margin, area.height(), colors.window);
  std::size_t line = firstVisibleLine();
  for (int y = 0; y < area.height() && line <= lines(); y += height, ++line) {
    const bool isCurrent = line == m_current;
    painter.setClipping(false);
    if (isCurrent) {
      QColor fill = colors.equations[1];  // as the chosen moves on the path
      fill.setAlpha(colors.isDark ? 90 : 56);
      painter.fillRect(0, y, area.width(), height, fill);
    }
    if (line == m_runLine) {
      QColor fill = colors.accent;  // as the executed path
      fill.setAlpha(colors.isDark ? 80 : 48);
      painter.fillRect(margin, y, area.width() - margin, height, fill);
      painter.fillRect(margin, y, 4, height, colors.accent);
    }
    if (const Mark* mark = markOf(line)) {
      painter.drawPixmap(3, y + (height - kIconPx) / 2,
                         m_icons[static_cast<std::size_t>(mark->severity)]);
    }
    painter.setPen(isCurrent ? colors.text : colors.mutedText);
    painter.drawText(QRect(0, y, numbersPx(), height), Qt::AlignRight | Qt::AlignVCenter,
                     QString::number(line));
    paintPart(painter, line, y);
    painter.setClipRect(margin, y, area.width() - margin, height);
    const QString text = lineText(line);
    paintHighlights(painter, text, margin + kGapPx - shift, y);
    const QString trimmed = text.trimmed();
    const bool isComment =
        trimmed.startsWith(QLatin1Char(';')) || trimmed.startsWith(QLatin1Char('('));
    painter.setPen(isComment ? colors.mutedText : colors.text);
    painter.drawText(QPoint(margin + kGapPx - shift,
                            y + (height - fontMetrics().height()) / 2 + fontMetrics().ascent()),
                     text);
    ++m_painted;
  }
  painter.setClipping(false);
  painter.setPen(colors.line);
  painter.drawLine(margin - 1, 0, margin - 1, area.height());
}

void ProgramTextView::paintPart(QPainter& painter, std::size_t line, int y) const {
  const ThemeColors& colors = themeColors(palette());
  const overview::JobOutline& outline = m_program->outline;
  const int margin = marginPx();
  const int height = lineHeightPx();
  if (outline.nativeAt(line) != nullptr) {
    painter.fillRect(margin - kEdgePx - 1, y, kEdgePx, height, colors.native);
  }
  const job::Stretch* stretch = outline.stretchAt(line);
  if (stretch == nullptr) {
    return;
  }
  const QRect place(numbersPx() + kGapPx / 2, y + 1,
                    margin - kEdgePx - 3 - numbersPx() - kGapPx / 2, height - 2);
  painter.setPen(colors.outline);
  painter.setBrush(colors.surface);
  painter.drawRoundedRect(place, 3.0, 3.0);
  painter.setPen(colors.text);
  painter.drawText(place, Qt::AlignCenter, QString::number(stretch->number));
}

QString ProgramTextView::hintOf(std::size_t line) const {
  QStringList hints;
  if (const Mark* mark = markOf(line)) {
    hints.append(diagnosticText(m_program->program->diagnostics[mark->diagnostic]));
  }
  if (!m_program || line == 0) {
    return {};
  }
  if (const job::NativeBlock* native = m_program->outline.nativeAt(line)) {
    hints.append(nativeBlockText(*native));
  }
  if (const job::Stretch* stretch = m_program->outline.stretchAt(line)) {
    hints.append(stretchText(*stretch, m_program->outline.stretches()));
  }
  return hints.join(QLatin1Char('\n'));
}

void ProgramTextView::resizeEvent(QResizeEvent* event) {
  QAbstractScrollArea::resizeEvent(event);
  // A line that was visible stays visible.
  const std::size_t first = firstVisibleLine();
  const bool wasInSight = m_current >= first && m_current < first + m_pageLines;
  setRanges();
  if (wasInSight) {
    setCurrentLine(m_current);
  }
}

void ProgramTextView::mousePressEvent(QMouseEvent* event) {
  const std::size_t line = lineAt(event->position().toPoint().y());
  if (event->button() == Qt::LeftButton && line > 0) {
    choose(line);
  }
}

void ProgramTextView::mouseReleaseEvent(QMouseEvent* event) {
  event->accept();
}

void ProgramTextView::keyPressEvent(QKeyEvent* event) {
  const std::size_t page = std::max<std::size_t>(pageLines(), 2) - 1;
  const std::size_t now = std::max<std::size_t>(m_current, 1);
  if (lines() > 0 && event->matches(QKeySequence::Copy) && m_current > 0) {
    QGuiApplication::clipboard()->setText(lineText(m_current));
    return;
  }
  std::size_t wanted = 0;
  switch (event->key()) {
    case Qt::Key_Up:
      wanted = now > 1 ? now - 1 : 1;
      break;
    case Qt::Key_Down:
      wanted = m_current == 0 ? 1 : now + 1;
      break;
    case Qt::Key_PageUp:
      wanted = now > page ? now - page : 1;
      break;
    case Qt::Key_PageDown:
      wanted = now + page;
      break;
    case Qt::Key_Home:
      wanted = 1;
      break;
    case Qt::Key_End:
      wanted = lines();
      break;
    default:
      QAbstractScrollArea::keyPressEvent(event);
      return;
  }
  if (lines() > 0) {
    choose(std::min(wanted, lines()));
  }
}

void ProgramTextView::changeEvent(QEvent* event) {
  QAbstractScrollArea::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) {
    makeIcons();
  }
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::LanguageChange) {
    viewport()->update();
  }
}

bool ProgramTextView::viewportEvent(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    const QString hint = hintOf(lineAt(help->pos().y()));
    if (!hint.isEmpty()) {
      QToolTip::showText(help->globalPos(), hint, this);
    } else {
      QToolTip::hideText();
    }
    return true;
  }
  return QAbstractScrollArea::viewportEvent(event);
}

int ProgramTextView::lineHeightPx() const {
  return std::max(fontMetrics().height() + 3, kIconPx + 2);
}

int ProgramTextView::numbersPx() const {
  const auto digits = static_cast<int>(QString::number(std::max<std::size_t>(lines(), 100)).size());
  return kIconPx + kGapPx + digits * fontMetrics().horizontalAdvance(QLatin1Char('0'));
}

int ProgramTextView::marginPx() const {
  if (!m_program || m_program->outline.partLines().empty()) {
    return numbersPx() + kGapPx;
  }
  const auto digits = static_cast<int>(QString::number(m_program->outline.stretches()).size());
  return numbersPx() + 2 * kGapPx + kEdgePx + 3 +
         digits * fontMetrics().horizontalAdvance(QLatin1Char('0'));
}

std::size_t ProgramTextView::pageLines() const {
  return static_cast<std::size_t>(std::max(1, viewport()->height() / lineHeightPx()));
}

std::size_t ProgramTextView::lineAt(int y) const {
  const std::size_t line =
      firstVisibleLine() + static_cast<std::size_t>(std::max(0, y / lineHeightPx()));
  return line <= lines() ? line : 0;
}

void ProgramTextView::setRanges() {
  const std::size_t page = pageLines();
  m_pageLines = page;
  verticalScrollBar()->setPageStep(static_cast<int>(page));
  verticalScrollBar()->setRange(0, static_cast<int>(lines() > page ? lines() - page : 0));
  const std::size_t longest = m_program ? std::min(m_program->text.longestBytes(), kShownBytes) : 0;
  const int wide =
      static_cast<int>(longest + 2) * fontMetrics().horizontalAdvance(QLatin1Char('0'));
  const int room = viewport()->width() - marginPx() - kGapPx;
  horizontalScrollBar()->setPageStep(std::max(1, room));
  horizontalScrollBar()->setSingleStep(20);
  horizontalScrollBar()->setRange(0, std::max(0, wide - room));
}

void ProgramTextView::makeIcons() {
  const ThemeColors& colors = themeColors(palette());
  const std::array<QColor, 3> shown{colors.mutedText, colors.attention, colors.fault};
  for (std::size_t i = 0; i < shown.size(); ++i) {
    m_icons[i] = iconPixmap(severityIconName(static_cast<gcode::Severity>(i)), shown[i], kIconPx,
                            devicePixelRatioF());
  }
}

void ProgramTextView::choose(std::size_t line) {
  setCurrentLine(line);
  Q_EMIT lineChosen(line);
}

const ProgramTextView::Mark* ProgramTextView::markOf(std::size_t line) const {
  const auto found =
      std::lower_bound(m_marks.begin(), m_marks.end(), line,
                       [](const Mark& mark, std::size_t wanted) { return mark.line < wanted; });
  return found != m_marks.end() && found->line == line && line > 0 ? &*found : nullptr;
}

}  // namespace rivulet::widgets
