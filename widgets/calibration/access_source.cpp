// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/calibration/access_source.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>
#include <algorithm>

#include "widgets/common/number_format.h"

namespace rivulet::widgets {

namespace {

struct AccessTexts {
  Q_DECLARE_TR_FUNCTIONS(AccessTexts)
};

/// a + b · n.
QString lineText(const streaming::Calibration& calibration, bool write, opcua::Grouping form) {
  const streaming::AccessFit* fit = calibration.fit(write, form);
  if (fit == nullptr) {
    fit = calibration.fit(write, opcua::Grouping::List);
  }
  return fit == nullptr
             ? noValue()
             : QStringLiteral("%1 + %2 · n")
                   .arg(millisecondsText(fit->overheadMs, 2), millisecondsText(fit->nodeMs, 2));
}

}  // namespace

AccessSourceText accessSourceText(const AccessSource& source, base::Duration accessTime) {
  const QString time = millisecondsText(accessTime, 2);
  if (!source.record) {
    return {
        Status::Plain,
        AccessTexts::tr("Access is assumed: %1 for each R-parameter. See Calibration.").arg(time)};
  }
  const QString date = dateText(source.record->measuredAtUtc);
  if (source.isOutdated) {
    return {Status::Attention,
            AccessTexts::tr("Access is assumed: %1 for each R-parameter. The calibration of %2 "
                            "belongs to another version of the server and is not used.")
                .arg(time, date)};
  }
  const streaming::Calibration& calibration = source.record->calibration;
  QString text =
      AccessTexts::tr("Access calibrated on %1 (%2): t = %3; read %4, write %5.")
          .arg(date, formText(source.form), time, lineText(calibration, false, source.form),
               lineText(calibration, true, source.form));
  const auto tail = calibration.tail(true, source.form, source.cellsMax);
  if (tail) {
    text +=
        QLatin1Char(' ') + AccessTexts::tr("99 % of the writes of %n R-parameters end within %1.",
                                           nullptr, source.cellsMax)
                               .arg(millisecondsText(*tail));
  }
  int measured = 0;
  for (const streaming::AccessSeries& series : calibration.series) {
    measured = std::max(measured, series.nodes);
  }
  if (source.cellsMax > measured) {
    text += QLatin1Char(' ') +
            AccessTexts::tr("Up to %n R-parameters were measured.", nullptr, measured);
  }
  return {Status::Plain, text};
}

QString formText(opcua::Grouping form) {
  switch (form) {
    case opcua::Grouping::List:
      return AccessTexts::tr("list");
    case opcua::Grouping::Single:
      return AccessTexts::tr("one by one");
    case opcua::Grouping::ArrayCount:
      return AccessTexts::tr("array, by count");
    case opcua::Grouping::ArrayRange:
      return AccessTexts::tr("array, by range");
  }
  return {};
}

QString serverText(const opcua::ServerIdentity& server) {
  QStringList parts;
  for (const std::string& part : {server.productName, server.softwareVersion, server.buildNumber}) {
    if (!part.empty()) {
      parts << QString::fromStdString(part);
    }
  }
  return parts.isEmpty() ? AccessTexts::tr("a server without a name")
                         : parts.join(QLatin1Char(' '));
}

QString dateText(const std::string& utc) {
  const QDateTime at = QDateTime::fromString(QString::fromStdString(utc), Qt::ISODate);
  return at.isValid() ? at.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm"))
                      : QString::fromStdString(utc);
}

}  // namespace rivulet::widgets
