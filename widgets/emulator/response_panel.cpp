// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/emulator/response_panel.h"

#include <QLabel>
#include <utility>

#include "emulator/axis_response.h"
#include "widgets/emulator/emulator_text.h"
#include "widgets/plots/curve_chart.h"

namespace rivulet::widgets {

namespace {

constexpr double kFromHz = 0.1;
constexpr double kToHz = 100.0;
constexpr int kFrequencies = 200;
constexpr double kStepMm = 1.0;
constexpr double kStepPeriodS = 0.0005;
constexpr int kStepCount = 1000;
constexpr int kChartHeightPx = 170;

}  // namespace

ResponsePanel::ResponsePanel(QWidget* parent)
    : Page(parent),
      m_gain(say(new CurveChart(AxisScale::Logarithmic, AxisScale::Even, this),
                 {.id = "emulatorGain"})),
      m_phase(say(new CurveChart(AxisScale::Logarithmic, AxisScale::Even, this),
                  {.id = "emulatorPhase"})),
      m_step(say(new CurveChart(AxisScale::Even, AxisScale::Even, this), {.id = "emulatorStep"})) {
  for (CurveChart* chart : {m_gain, m_phase, m_step}) {
    chart->setMinimumHeight(kChartHeightPx);
  }
  inColumn({m_bandwidths, {inRow({{inColumn({m_gain, m_phase}), 1}, {m_step, 1}}), 1}, m_formulas},
           this, QMargins(0, 0, 0, 0));
  retranslate();
  restyle();
}

void ResponsePanel::setAxes(std::vector<emulator::LearnedAxis> axes) {
  m_axes = std::move(axes);
  std::vector<ChartCurve> gains;
  std::vector<ChartCurve> phases;
  std::vector<ChartCurve> steps;
  for (std::size_t i = 0; i < m_axes.size(); ++i) {
    const QString name = QString(QLatin1Char(m_axes[i].axis));
    ChartCurve gain{name, i, false, {}};
    ChartCurve phase{name, i, false, {}};
    for (const emulator::ResponsePoint& point :
         emulator::frequencyResponse(m_axes[i].parameters, kFromHz, kToHz, kFrequencies)) {
      gain.points.emplace_back(point.hz, point.decibel);
      phase.points.emplace_back(point.hz, point.phaseDeg);
    }
    ChartCurve step{name, i, false, {}};
    const std::vector<double> mm =
        emulator::stepResponse(m_axes[i].parameters, kStepMm, kStepPeriodS, kStepCount);
    for (std::size_t k = 0; k < mm.size(); ++k) {
      step.points.emplace_back(static_cast<double>(k + 1) * kStepPeriodS, mm[k]);
    }
    gains.push_back(std::move(gain));
    phases.push_back(std::move(phase));
    steps.push_back(std::move(step));
  }
  m_gain->setCurves(std::move(gains));
  m_phase->setCurves(std::move(phases));
  m_step->setCurves(std::move(steps));
  retranslate();
}

void ResponsePanel::retranslate() {
  m_gain->setTitles(tr("Bode plot: gain"), tr("Frequency, Hz"), tr("Gain, dB"));
  m_phase->setTitles(tr("Bode plot: phase"), tr("Frequency, Hz"), tr("Phase, °"));
  m_step->setTitles(tr("Answer to a step of 1 mm"), tr("Time, s"), tr("Position, mm"));
  QStringList bandwidths;
  QStringList formulas;
  for (const emulator::LearnedAxis& axis : m_axes) {
    formulas.append(QStringLiteral("%1:  %2").arg(QString(QLatin1Char(axis.axis)),
                                                  transferFunctionText(axis.parameters)));
    const double hz = emulator::bandwidthHz(axis.parameters);
    if (hz > 0.0) {
      bandwidths.append(tr("%1 follows up to %2 Hz (−3 dB).")
                            .arg(QString(QLatin1Char(axis.axis)), significantText(hz, 3)));
    }
  }
  m_bandwidths->setText(
      tr("From set point to actual position; the Bode plot is without friction.") +
      QLatin1Char(' ') + bandwidths.join(QLatin1Char(' ')));
  m_formulas->setText(formulas.join(QLatin1Char('\n')));
}

}  // namespace rivulet::widgets
