// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/hazard_text.h"

#include <QCoreApplication>
#include <QStringList>
#include <cmath>

#include "widgets/common/number_format.h"

namespace rivulet::hmi {

using forecast::Hazard;
using forecast::HazardKind;

namespace {

struct HazardTexts {
  Q_DECLARE_TR_FUNCTIONS(HazardTexts)

 public:
  static QString place(const Hazard& hazard) {
    const QString line = widgets::countText(hazard.line.value);
    if (!hazard.file.empty()) {
      return tr("%1, line %2").arg(QString::fromStdString(hazard.file), line);
    }
    return hazard.stretch > 0
               ? tr("Line %1 (part %2)")
                     .arg(line, widgets::countText(static_cast<std::size_t>(hazard.stretch)))
               : tr("Line %1").arg(line);
  }

  static QString what(const Hazard& hazard) {
    switch (hazard.kind) {
      case HazardKind::Travel:
        return travel(*hazard.travel);
      case HazardKind::SpindleSpeed:
        return tr("S%1 is %2 1/min more than the spindle can turn; the control reduces it to "
                  "%3 1/min.")
            .arg(widgets::numberText(hazard.value, 0),
                 widgets::numberText(hazard.value - hazard.limit, 0),
                 widgets::numberText(hazard.limit, 0));
      case HazardKind::ToolMissing:
        return hazard.near.empty()
                   ? tr("Tool %1 is not in the tool table of the machine. Enter it there, or "
                        "choose another tool.")
                         .arg(QString::fromStdString(hazard.text))
                   : tr("Tool %1 is not in the tool table of the machine, but %2 is. Enter %1 "
                        "there, or write %2 into the program.")
                         .arg(QString::fromStdString(hazard.text),
                              QString::fromStdString(hazard.near));
      case HazardKind::Refused:
        return tr("The machine would stop with alarm %1: %2")
            .arg(hazard.alarm)
            .arg(QString::fromStdString(hazard.text));
      case HazardKind::NotChecked:
        return tr("From here on the job cannot be checked, because only the control knows what "
                  "this block does: %1")
            .arg(QString::fromStdString(hazard.text));
    }
    return {};
  }

  static QString more(std::size_t count) {
    return tr("and %1 more").arg(widgets::countText(count));
  }

 private:
  static QString travel(const machine::BeyondTravel& travel) {
    const double limit = travel.target > travel.max ? travel.max : travel.min;
    const auto text = [&travel](double value) {
      return travel.isRotary() ? widgets::numberText(value, 3) + QStringLiteral("\u00A0°")
                               : widgets::lengthText(value);
    };
    return tr("%1 would go to %2 in machine coordinates, %3 beyond its limit of %4. Move the "
              "workpiece or change the work offset.")
        .arg(QLatin1Char(travel.axis))
        .arg(text(travel.target), text(std::abs(travel.target - limit)), text(limit));
  }
};

}  // namespace

QString hazardText(const Hazard& hazard) {
  return QStringLiteral("%1: %2").arg(HazardTexts::place(hazard), HazardTexts::what(hazard));
}

QString hazardsText(const session::Hazards& hazards, bool stop) {
  constexpr qsizetype kShown = 5;
  QStringList lines;
  std::size_t left = 0;
  for (const Hazard& hazard : hazards) {
    if (hazard.stops() != stop) {
      continue;
    }
    if (lines.size() < kShown) {
      lines.append(hazardText(hazard));
    } else {
      ++left;
    }
  }
  if (left > 0) {
    lines.append(HazardTexts::more(left));
  }
  return lines.join(QLatin1Char('\n'));
}

}  // namespace rivulet::hmi
