// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/scope/spectrum_panel.h"

#include <QChart>
#include <QChartView>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineSeries>
#include <QLocale>
#include <QPointer>
#include <QScatterSeries>
#include <QTableWidget>
#include <QValueAxis>
#include <algorithm>
#include <iterator>

#include "widgets/common/error_text.h"
#include "widgets/common/number_format.h"
#include "widgets/common/table_style.h"
#include "widgets/common/theme.h"
#include "widgets/plots/chart_style.h"
#include "widgets/plots/time_window.h"
#include "widgets/scope/scope_view.h"

namespace rivulet::widgets {

namespace {

constexpr int kSpectrumDelayMs = 120;
constexpr std::size_t kLinePoints = 1000;
constexpr double kRoomAbovePeak = 1.08;
constexpr int kPeakDigits = 4;
/// Lengths below are shown in micrometres.
constexpr double kSmallMm = 0.05;
constexpr int kTicksAcross = 4;
constexpr double kHzAroundPeaks = 3.0;
constexpr int kTicksUp = 5;

}  // namespace

SpectrumPanel::SpectrumPanel(ScopeCurves* curves, TimeWindow* window, ScopeCursors* cursors,
                             ScopeView* view, QWidget* parent)
    : Page(parent),
      m_curves(curves),
      m_window(window),
      m_cursors(cursors),
      m_view(view),
      m_chart(say(new QChartView(new QChart, this),
                  {.name = QT_TR_NOOP("Spectrum"), .id = "spectrumChart"})),
      m_line(new QLineSeries),
      m_marks(new QScatterSeries),
      m_hz(new QValueAxis(this)),
      m_amplitude(new QValueAxis(this)),
      m_table(say(new QTableWidget(0, 2, this),
                  {.name = QT_TR_NOOP("Peaks of the spectrum"), .id = "spectrumTable"})) {
  m_signal->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  m_note->setTextFormat(Qt::PlainText);
  m_chart->setFrameShape(QFrame::NoFrame);
  m_chart->setRenderHint(QPainter::Antialiasing);
  m_chart->setMinimumHeight(160);
  QChart* chart = m_chart->chart();
  chart->setAnimationOptions(QChart::NoAnimation);
  // Its own least size would make the page higher than a small screen.
  chart->setMinimumSize(120.0, 120.0);
  chart->addAxis(m_hz, Qt::AlignBottom);
  chart->addAxis(m_amplitude, Qt::AlignLeft);
  for (QXYSeries* series : {static_cast<QXYSeries*>(m_line), static_cast<QXYSeries*>(m_marks)}) {
    chart->addSeries(series);
    series->attachAxis(m_hz);
    series->attachAxis(m_amplitude);
  }
  m_marks->setMarkerSize(8.0);
  styleTable(m_table);
  m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  m_table->setMinimumHeight(80);
  m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  inColumn({m_signal, m_note, {m_chart, 3}, {m_table, 2}}, this, QMargins(4, 6, 4, 4));

  m_delay.setParent(this);  // whoever waits for the page finds it
  m_delay.setSingleShot(true);
  m_delay.setInterval(kSpectrumDelayMs);
  connect(&m_delay, &QTimer::timeout, this, &SpectrumPanel::refresh);
  connect(m_signal, &QComboBox::activated, this, &SpectrumPanel::schedule);
  connect(m_cursors, &ScopeCursors::changed, this, &SpectrumPanel::schedule);
  connect(m_window, &TimeWindow::changed, this, [this] {
    if (!isBetweenCursors()) {
      schedule();
    }
  });
  connect(m_curves, &ScopeCurves::changed, this, &SpectrumPanel::schedule);
  connect(m_view, &ScopeView::changed, this, &SpectrumPanel::schedule);
  retranslate();
  restyle();
}

bool SpectrumPanel::isBetweenCursors() const {
  return m_cursors->atS(ScopeCursors::A) && m_cursors->atS(ScopeCursors::B);
}

void SpectrumPanel::showEvent(QShowEvent* event) {
  Page::showEvent(event);
  schedule();
}

void SpectrumPanel::schedule() {
  if (isVisible() && !m_delay.isActive()) {
    m_delay.start();
  }
}

void SpectrumPanel::refreshNow() {
  m_delay.stop();
  refresh();
}

/// The curves of all panes; the chosen one stays.
void SpectrumPanel::listSignals() {
  m_shown.clear();
  for (const QStringList& pane : m_view->arrangement()) {
    for (const QString& formula : pane) {
      std::vector<ScopeCurves::Curve> of = m_curves->curves(formula);
      std::move(of.begin(), of.end(), std::back_inserter(m_shown));
    }
  }
  QStringList titles;
  for (const ScopeCurves::Curve& curve : m_shown) {
    titles.append(curve.title);
  }
  QStringList present;
  for (int i = 0; i < m_signal->count(); ++i) {
    present.append(m_signal->itemText(i));
  }
  if (titles != present) {
    const QString chosen = m_signal->currentText();
    m_signal->clear();
    m_signal->addItems(titles);
    m_signal->setCurrentIndex(std::max(0, static_cast<int>(titles.indexOf(chosen))));
  }
}

void SpectrumPanel::refresh() {
  listSignals();
  ++m_request;
  const auto chosen = static_cast<std::size_t>(std::max(m_signal->currentIndex(), 0));
  const bool isThere = chosen < m_shown.size() && m_shown[chosen].samples;
  m_unit = isThere ? m_curves->unit(m_shown[chosen].formula) : QString();
  if (!isThere || m_curves->axis() != trace::RunAxis::Time) {
    m_problem = m_curves->axis() != trace::RunAxis::Time
                    ? tr("Frequencies need the time axis: choose it under Compare.")
                    : tr("No curve is shown.");
    m_spectrum = {};
    draw();
    return;
  }
  double from = m_window->fromS();
  double to = m_window->toS();
  if (isBetweenCursors()) {
    from = std::min(*m_cursors->atS(ScopeCursors::A), *m_cursors->atS(ScopeCursors::B));
    to = std::max(*m_cursors->atS(ScopeCursors::A), *m_cursors->atS(ScopeCursors::B));
  }
  ScopeCurves::Samples samples = m_shown[chosen].samples;
  if (m_curves->isLive()) {
    // More is appended meanwhile; what is seen live is little.
    showSpectrum(trace::spectrumOf(*samples, instantOf(from), instantOf(to)));
    return;
  }
  m_curves->run([self = QPointer(this), request = m_request, samples = std::move(samples), from,
                 to]() -> std::function<void()> {
    auto spectrum = trace::spectrumOf(*samples, instantOf(from), instantOf(to));
    return [self, request, spectrum = std::move(spectrum)] {
      if (self && self->m_request == request) {
        self->showSpectrum(spectrum);
      }
    };
  });
}

void SpectrumPanel::showSpectrum(const base::Result<trace::Spectrum>& spectrum) {
  m_problem = spectrum ? QString() : errorText(spectrum.error());
  m_spectrum = spectrum ? *spectrum : trace::Spectrum{};
  draw();
}

double SpectrumPanel::scale() const {
  const auto most = std::max_element(m_spectrum.amplitudes.begin(), m_spectrum.amplitudes.end());
  const bool isSmall = most != m_spectrum.amplitudes.end() && *most < kSmallMm;
  return m_unit == QLatin1String("mm") && isSmall ? 1000.0 : 1.0;
}

QString SpectrumPanel::amplitudeTitle() const {
  const QString unit = scale() > 1.0 ? QStringLiteral("µm") : m_unit;
  return unit.isEmpty() ? tr("Amplitude") : tr("Amplitude, %1").arg(unit);
}

/// The peaks and what is around them: above, there is mostly nothing to be seen.
double SpectrumPanel::shownHz() const {
  double highest = 0.0;
  for (const trace::FrequencyPeak& peak : m_spectrum.peaks) {
    highest = std::max(highest, peak.hz);
  }
  const double all = m_spectrum.rateHz / 2.0;
  return all <= 0.0 ? 1.0 : (highest > 0.0 ? std::min(all, kHzAroundPeaks * highest) : all);
}

void SpectrumPanel::draw() {
  const std::vector<double>& amplitudes = m_spectrum.amplitudes;
  const double factor = scale();
  // The highest of neighbours: no peak is lost.
  const std::size_t end =
      std::min(amplitudes.size(), m_spectrum.stepHz > 0.0
                                      ? static_cast<std::size_t>(shownHz() / m_spectrum.stepHz) + 2
                                      : std::size_t{0});
  const std::size_t group = end / kLinePoints + 1;
  QList<QPointF> points;
  double most = 0.0;
  for (std::size_t begin = 0; begin < end; begin += group) {
    const auto first = amplitudes.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto last =
        amplitudes.begin() + static_cast<std::ptrdiff_t>(std::min(end, begin + group));
    const auto highest = std::max_element(first, last);
    points.append(
        {m_spectrum.stepHz * static_cast<double>(highest - amplitudes.begin()), factor * *highest});
    most = std::max(most, factor * *highest);
  }
  QList<QPointF> marks;
  for (const trace::FrequencyPeak& peak : m_spectrum.peaks) {
    marks.append({peak.hz, factor * peak.amplitude});
    most = std::max(most, factor * peak.amplitude);
  }
  m_line->replace(points);
  m_marks->replace(marks);
  divideAxis(m_hz, 0.0, shownHz(), kTicksAcross);
  divideAxis(m_amplitude, 0.0, most > 0.0 ? most * kRoomAbovePeak : 1.0, kTicksUp);
  m_hz->setTitleText(tr("Frequency, Hz"));
  m_amplitude->setTitleText(amplitudeTitle());
  m_table->setHorizontalHeaderLabels({tr("Peak, Hz"), amplitudeTitle()});
  m_table->setRowCount(static_cast<int>(m_spectrum.peaks.size()));
  for (std::size_t i = 0; i < m_spectrum.peaks.size(); ++i) {
    const trace::FrequencyPeak& peak = m_spectrum.peaks[i];
    int column = 0;
    for (const QString& text :
         {numberText(peak.hz, 2), QLocale().toString(factor * peak.amplitude, 'g', kPeakDigits)}) {
      auto* item = new QTableWidgetItem(text);
      item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      m_table->setItem(static_cast<int>(i), column++, item);
    }
  }
  showNote();
}

void SpectrumPanel::showNote() {
  QString text = m_problem;
  if (text.isEmpty()) {
    const QString count = countText(m_spectrum.count);
    const QString rate = numberText(m_spectrum.rateHz, m_spectrum.rateHz < 100.0 ? 1 : 0);
    text = isBetweenCursors() ? tr("Between the cursors: %1 samples, %2 Hz").arg(count, rate)
                              : tr("In the time shown: %1 samples, %2 Hz").arg(count, rate);
    if (m_spectrum.isResampled) {
      text += QStringLiteral(". ") +
              tr("The samples are not evenly spaced: values between them were interpolated.");
    }
  }
  m_note->setText(text);
  QPalette note = m_note->palette();
  const ThemeColors& colors = themeColors(palette());
  const bool isWarning = !m_problem.isEmpty() || m_spectrum.isResampled;
  note.setColor(QPalette::WindowText, isWarning ? colors.attention : colors.mutedText);
  m_note->setPalette(note);
}

void SpectrumPanel::retranslate() {
  m_chart->chart()->setLocale(QLocale());
  draw();
  schedule();
}

void SpectrumPanel::restyle() {
  const ThemeColors& colors = themeColors(palette());
  m_chart->setBackgroundBrush(colors.surface);
  styleChart(m_chart->chart(), palette());
  m_line->setPen(QPen(colors.trace, 1.2));
  m_marks->setColor(colors.accent);
  m_marks->setBorderColor(colors.surface);
  showNote();
}

}  // namespace rivulet::widgets
