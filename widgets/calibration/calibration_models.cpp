// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/calibration/calibration_models.h"

#include <QFont>
#include <optional>

#include "widgets/calibration/access_source.h"
#include "widgets/common/number_format.h"

namespace rivulet::widgets {

namespace {

using streaming::AccessFit;
using streaming::AccessSeries;
using SeriesColumn = TableColumn<AccessSeries>;

QString timeText(const std::optional<base::Duration>& duration) {
  constexpr double kLongMs = 100.0;  // a second decimal would only take room
  if (!duration) {
    return noValue();
  }
  const double ms = base::toMilliseconds(*duration);
  return numberText(ms, ms >= kLongMs ? 1 : 2);
}

/// A column of times; series without shots have none.
template <class Value>
SeriesColumn timeColumn(std::function<QString()> title, Value value) {
  return {std::move(title),
          [value](const AccessSeries& series) {
            return series.shotsMade == 0 ? noValue() : timeText(value(series));
          },
          true};
}

SeriesColumn percentileColumn(int perMille) {
  return timeColumn(
      [perMille] {
        return SeriesModel::tr("%1 %").arg(numberText(0.1 * perMille, perMille % 10 == 0 ? 0 : 1));
      },
      [perMille](const AccessSeries& series) { return series.percentile(perMille); });
}

QVariant bold() {
  QFont font;
  font.setBold(true);
  return font;
}

}  // namespace

SeriesModel::SeriesModel(QObject* parent)
    : TableModel(
          {{[] { return tr("Form"); },
            [](const AccessSeries& series) { return formText(series.grouping); }},
           {[] { return tr("Access"); },
            [](const AccessSeries& series) { return series.write ? tr("write") : tr("read"); }},
           {[] { return tr("R-parameters"); },
            [](const AccessSeries& series) { return QString::number(series.nodes); }, true},
           {[] { return tr("Shots"); },
            [](const AccessSeries& series) {
              return series.refused ? tr("refused")
                                    : countText(static_cast<std::size_t>(series.shotsMade));
            },
            true,
            [this](const AccessSeries& series, int role) -> QVariant {
              if (series.shotsMade >= m_shots ||
                  (role != Qt::FontRole && role != Qt::ToolTipRole)) {
                return {};
              }
              if (role == Qt::FontRole) {
                return bold();
              }
              return series.refused ? tr("The control refused arrays of this size.")
                                    : tr("%1 were requested; there was no time for more.")
                                          .arg(QString::number(m_shots));
            }},
           timeColumn([] { return tr("Mean"); },
                      [](const AccessSeries& series) { return series.mean; }),
           percentileColumn(500),
           percentileColumn(900),
           percentileColumn(950),
           percentileColumn(990),
           percentileColumn(999),
           timeColumn([] { return tr("Largest"); },
                      [](const AccessSeries& series) { return series.max; })},
          parent) {
}

void SeriesModel::setSeries(const std::vector<AccessSeries>& series, int shots) {
  m_shots = shots;
  setRows(series);
}

FitModel::FitModel(QObject* parent)
    : TableModel(
          {{[] { return tr("Form"); }, [](const AccessFit& fit) { return formText(fit.grouping); }},
           {[] { return tr("Access"); },
            [](const AccessFit& fit) { return fit.write ? tr("write") : tr("read"); }},
           {[] { return tr("Per request (a)"); },
            [](const AccessFit& fit) { return millisecondsText(fit.overheadMs, 2); }, true},
           {[] { return tr("Per R-parameter (b)"); },
            [](const AccessFit& fit) { return millisecondsText(fit.nodeMs, 3); }, true},
           {[] { return tr("± of b"); },
            [](const AccessFit& fit) { return millisecondsText(fit.nodeDeviationMs, 2); }, true},
           {[] { return tr("Residual"); },
            [](const AccessFit& fit) {
              return tr("%1 %").arg(numberText(100.0 * fit.residualShare, 1));
            },
            true}},
          parent) {
}

}  // namespace rivulet::widgets
