// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/common/number_format.h"

#include <QLocale>
#include <cmath>

#include "base/units.h"

namespace rivulet::widgets {

namespace {

// A no-break space keeps number and unit on one line.
QString withUnit(const QString& number, const QString& unit) {
  return number + QChar(0x00A0) + unit;
}

int decimalsForSize(double value) {
  const double size = std::abs(value);
  return size >= 100.0 ? 0 : (size >= 10.0 ? 1 : 2);
}

}  // namespace

QString noValue() {
  return QStringLiteral("\u2013");
}

QString numberText(double value, int decimals) {
  if (!std::isfinite(value)) {
    return noValue();
  }
  // "-0.000" would puzzle an operator.
  const double unit = std::pow(10.0, decimals);
  const double shown = std::abs(value) * unit < 0.5 ? 0.0 : value;
  return QLocale().toString(shown, 'f', decimals);
}

QString countText(std::size_t value) {
  return QLocale().toString(static_cast<qulonglong>(value));
}

QString lengthText(double lengthMm, int decimals) {
  return withUnit(numberText(lengthMm, decimals), QStringLiteral("mm"));
}

QString feedText(double feedMmPerS) {
  const double feedMmPerMin = base::mmPerMinFromMmPerS(feedMmPerS);
  return withUnit(numberText(feedMmPerMin, decimalsForSize(feedMmPerMin)),
                  QStringLiteral("mm/min"));
}

QString secondsText(double seconds, int decimals) {
  return withUnit(numberText(seconds, decimals), QStringLiteral("s"));
}

QString durationText(double seconds) {
  if (!(seconds >= 59.95)) {
    return secondsText(seconds);
  }
  const auto whole = static_cast<qlonglong>(std::llround(seconds));
  const auto twoDigits = [](qlonglong value) {
    return QStringLiteral("%1").arg(value, 2, 10, QLatin1Char('0'));
  };
  const QString minutes = QString::number(whole / 60);
  if (whole < 3600) {
    return withUnit(minutes + QLatin1Char(':') + twoDigits(whole % 60), QStringLiteral("min"));
  }
  return withUnit(
      QStringLiteral("%1:%2:%3")
          .arg(QString::number(whole / 3600), twoDigits(whole / 60 % 60), twoDigits(whole % 60)),
      QStringLiteral("h"));
}

QString ageText(double seconds) {
  return seconds < 10.0 || seconds >= 59.5 ? durationText(seconds) : secondsText(seconds, 0);
}

QString millisecondsText(double milliseconds, int decimals) {
  return withUnit(numberText(milliseconds, decimals), QStringLiteral("ms"));
}

QString millisecondsText(base::Duration duration, int decimals) {
  return millisecondsText(base::toMilliseconds(duration), decimals);
}

QString factorText(double factor) {
  if (std::isnan(factor)) {
    return noValue();
  }
  if (factor > 1000.0) {
    return QStringLiteral("> ") + countText(1000);
  }
  return numberText(factor, decimalsForSize(factor));
}

}  // namespace rivulet::widgets
