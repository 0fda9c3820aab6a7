// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/calibration/calibration_models.h"

#include <QFont>

#include "widgets/calibration/access_source.h"
#include "widgets/common/number_format.h"

namespace rivulet::widgets {

namespace {

QVariant alignment(bool isText) {
  return QVariant((isText ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
}

QString timeText(base::Duration duration) {
  constexpr double kLongMs = 100.0;  // a second decimal would only take room
  const double ms = base::toMilliseconds(duration);
  return numberText(ms, ms >= kLongMs ? 1 : 2);
}

int perMilleOf(int column) {
  switch (column) {
    case SeriesModel::P50:
      return 500;
    case SeriesModel::P90:
      return 900;
    case SeriesModel::P95:
      return 950;
    case SeriesModel::P99:
      return 990;
    default:
      return 999;
  }
}

}  // namespace

void SeriesModel::setSeries(std::vector<streaming::AccessSeries> series, int shots) {
  beginResetModel();
  m_series = std::move(series);
  m_shots = shots;
  endResetModel();
}

void SeriesModel::retranslate() {
  if (!m_series.empty()) {
    Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
  }
  Q_EMIT headerDataChanged(Qt::Horizontal, 0, ColumnCount - 1);
}

int SeriesModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_series.size());
}

int SeriesModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : ColumnCount;
}

QVariant SeriesModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) {
    return {};
  }
  const streaming::AccessSeries& series = m_series[static_cast<std::size_t>(index.row())];
  const int column = index.column();
  if (role == Qt::TextAlignmentRole) {
    return alignment(column <= Access);
  }
  if (role == Qt::FontRole && column == Shots && series.shotsMade < m_shots) {
    QFont font;
    font.setBold(true);
    return font;
  }
  if (role == Qt::ToolTipRole && column == Shots && series.shotsMade < m_shots) {
    return series.refused
               ? tr("The control refused arrays of this size.")
               : tr("%1 were ordered; more did not fit the time.").arg(QString::number(m_shots));
  }
  if (role != Qt::DisplayRole) {
    return {};
  }
  switch (column) {
    case Form:
      return formText(series.grouping);
    case Access:
      return series.write ? tr("write") : tr("read");
    case Cells:
      return QString::number(series.nodes);
    case Shots:
      return series.refused ? tr("refused") : countText(static_cast<std::size_t>(series.shotsMade));
    default:
      break;
  }
  if (series.shotsMade == 0) {
    return noValue();
  }
  if (column == Mean) {
    return timeText(series.mean);
  }
  if (column == Max) {
    return timeText(series.max);
  }
  const auto value = series.percentile(perMilleOf(column));
  return value ? timeText(*value) : noValue();
}

QVariant SeriesModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) {
    return {};
  }
  if (role == Qt::TextAlignmentRole) {
    return alignment(section <= Access);
  }
  if (role != Qt::DisplayRole) {
    return {};
  }
  switch (section) {
    case Form:
      return tr("Form");
    case Access:
      return tr("Access");
    case Cells:
      return tr("Cells");
    case Shots:
      return tr("Shots");
    case Mean:
      return tr("Mean");
    case Max:
      return tr("Largest");
    default:
      return tr("%1 %").arg(numberText(0.1 * perMilleOf(section), section == P999 ? 1 : 0));
  }
}

void FitModel::setFits(std::vector<streaming::AccessFit> fits) {
  beginResetModel();
  m_fits = std::move(fits);
  endResetModel();
}

void FitModel::retranslate() {
  if (!m_fits.empty()) {
    Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
  }
  Q_EMIT headerDataChanged(Qt::Horizontal, 0, ColumnCount - 1);
}

int FitModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_fits.size());
}

int FitModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : ColumnCount;
}

QVariant FitModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) {
    return {};
  }
  const streaming::AccessFit& fit = m_fits[static_cast<std::size_t>(index.row())];
  if (role == Qt::TextAlignmentRole) {
    return alignment(index.column() <= Access);
  }
  if (role != Qt::DisplayRole) {
    return {};
  }
  switch (index.column()) {
    case Form:
      return formText(fit.grouping);
    case Access:
      return fit.write ? tr("write") : tr("read");
    case Overhead:
      return millisecondsText(fit.overheadMs, 2);
    case PerCell:
      return millisecondsText(fit.nodeMs, 3);
    case Deviation:
      return millisecondsText(fit.nodeDeviationMs, 2);
    case Apart:
      return tr("%1 %").arg(numberText(100.0 * fit.residualShare, 1));
    default:
      return {};
  }
}

QVariant FitModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) {
    return {};
  }
  if (role == Qt::TextAlignmentRole) {
    return alignment(section <= Access);
  }
  if (role != Qt::DisplayRole) {
    return {};
  }
  switch (section) {
    case Form:
      return tr("Form");
    case Access:
      return tr("Access");
    case Overhead:
      return tr("Per request (a)");
    case PerCell:
      return tr("Per cell (b)");
    case Deviation:
      return tr("± per cell");
    case Apart:
      return tr("Off the line");
    default:
      return {};
  }
}

}  // namespace rivulet::widgets
