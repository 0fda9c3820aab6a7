// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/templates/cell_model.h"

#include <QStringList>
#include <utility>
#include <vector>

namespace rivulet::widgets {

namespace {

const QLatin1Char kBlank(' ');

QString cellName(int number) {
  return QStringLiteral("R%1").arg(number);
}

using Writer = CellRow::Writer;

QString writerText(const CellRow& row) {
  switch (row.writer) {
    case Writer::Client:
      return CellModel::tr("Client");
    case Writer::Nc:
      return CellModel::tr("NC");
    case Writer::Both:
      break;
  }
  return CellModel::tr("Client, NC");
}

/// "X Y Z A".
QString axisNames(const templates::CellMap& cells) {
  QStringList names;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (cells.axes[axis]) {
      names.append(QString(QLatin1Char(base::kAxisNames[axis])));
    }
  }
  for (const char name : base::rotaryNames(cells.rotaryAxes)) {
    names.append(QString(QLatin1Char(name)));
  }
  return names.join(kBlank);
}

/// @param role  gets the names of the axes
CellRow pointRow(const templates::CellMap& cells, int slot,
                 std::function<QString(const QString& axes)> role) {
  QStringList numbers;
  for (const int number : cells.slotCells(slot)) {
    numbers.append(cellName(number));
  }
  return {[role = std::move(role), axes = axisNames(cells)] { return role(axes); },
          numbers.join(kBlank), Writer::Client};
}

CellRow correctionRow(const templates::CellMap& cells) {
  QStringList axes;
  QStringList numbers;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (cells.correction[axis] >= 0) {
      axes.append(QString(QLatin1Char(base::kAxisNames[axis])));
      numbers.append(cellName(cells.correction[axis]));
    }
  }
  return {[names = axes.join(kBlank)] { return CellModel::tr("Online correction: %1").arg(names); },
          numbers.join(kBlank), Writer::Client};
}

/// The methods of [P1]: five cells and the slots.
std::vector<CellRow> slotRows(const templates::CellMap& cells) {
  std::vector<CellRow> rows{
      {[] { return CellModel::tr("Signal"); }, cellName(cells.signal), Writer::Both},
      {[] { return CellModel::tr("Run"); }, cellName(cells.run), Writer::Client},
      {[] { return CellModel::tr("Stop"); }, cellName(cells.stop), Writer::Client},
      {[] { return CellModel::tr("Feed (mm/min)"); }, cellName(cells.feed), Writer::Client},
      {[] { return CellModel::tr("Layout number"); }, cellName(cells.layout), Writer::Nc},
  };
  for (int slot = 0; slot < cells.pointsPerLoop; ++slot) {
    rows.push_back(pointRow(cells, slot, [slot](const QString& axes) {
      return CellModel::tr("Point %1: %2").arg(QString::number(slot + 1), axes);
    }));
  }
  return rows;
}

std::vector<CellRow> windowRows(const templates::CellMap& cells) {
  std::vector<CellRow> rows{
      {[] { return CellModel::tr("Run"); }, cellName(cells.run), Writer::Client},
      {[] { return CellModel::tr("Windows delivered"); }, cellName(cells.delivered),
       Writer::Client},
      {[] { return CellModel::tr("Windows taken"); }, cellName(cells.latched), Writer::Nc},
      {[] { return CellModel::tr("Windows executed"); }, cellName(cells.executed), Writer::Nc},
      {[] { return CellModel::tr("Layout number"); }, cellName(cells.layout), Writer::Nc},
      {[] { return CellModel::tr("State"); }, cellName(cells.state), Writer::Nc},
      {[] { return CellModel::tr("Number of the run"); }, cellName(cells.client), Writer::Client},
      {[] { return CellModel::tr("Run obeyed"); }, cellName(cells.owner), Writer::Nc},
      {[] { return CellModel::tr("Heartbeat"); }, cellName(cells.heartbeat), Writer::Client},
  };
  for (int window = 0; window < cells.windows; ++window) {
    const QString number = QString::number(window + 1);
    rows.push_back({[number] { return CellModel::tr("Window %1: points").arg(number); },
                    cellName(cells.windowCount(window)), Writer::Client});
    rows.push_back({[number] { return CellModel::tr("Window %1: feed (mm/min)").arg(number); },
                    cellName(cells.windowFeed(window)), Writer::Client});
    rows.push_back({[number] { return CellModel::tr("Window %1: check number").arg(number); },
                    cellName(cells.windowCheck(window)), Writer::Client});
    for (int place = 0; place < cells.pointsPerLoop; ++place) {
      rows.push_back(pointRow(cells, window * cells.pointsPerLoop + place,
                              [number, place](const QString& axes) {
                                return CellModel::tr("Window %1 point %2: %3")
                                    .arg(number, QString::number(place + 1), axes);
                              }));
    }
  }
  if (cells.corrects()) {
    rows.push_back(correctionRow(cells));
  }
  return rows;
}

}  // namespace

CellModel::CellModel(QObject* parent)
    : TableModel(
          {{[] { return tr("Role"); }, [](const CellRow& row) { return row.role(); }},
           {[] { return tr("R-parameters"); }, [](const CellRow& row) { return row.parameters; }},
           {[] { return tr("Writer"); }, writerText}},
          parent) {
}

void CellModel::setCells(const std::optional<templates::CellMap>& cells) {
  if (!cells) {
    clear();
  } else {
    setRows(cells->windows > 0 ? windowRows(*cells) : slotRows(*cells));
  }
}

}  // namespace rivulet::widgets
