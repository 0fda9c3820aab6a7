// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/live/live_text.h"

#include <QCoreApplication>

#include "base/units.h"
#include "widgets/common/number_format.h"

namespace rivulet::widgets {

namespace {

struct LiveTexts {
  Q_DECLARE_TR_FUNCTIONS(LiveTexts)

 public:
  static QString box(const QString& from, const QString& to) {
    return tr("%1 to %2").arg(from, to);
  }
  static QString silence(const QString& hold, const QString& end) {
    return tr("hold after %1, end after %2").arg(hold, end);
  }
  static QString delay(const QString& median, const QString& most) {
    return tr("median %1, 99 % %2").arg(median, most);
  }
  static QString inTheory(const QString& range) { return tr("in theory %1").arg(range); }
  static QString lines(const live::Summary& summary) {
    return tr("%1 from %2, executed to line %3")
        .arg(countText(summary.lines), QString::fromStdString(summary.source),
             countText(summary.lastLine));
  }
  static QString merged(std::size_t count) {
    return tr("%Ln points merged", nullptr, static_cast<int>(count));
  }
};

}  // namespace

QString boxText(const live::Agreement& agreed, std::size_t axis) {
  return LiveTexts::box(numberText(agreed.lowestMm[axis], 3),
                        lengthText(agreed.highestMm[axis], 3));
}

QString silenceText(const live::Limits& limits) {
  return LiveTexts::silence(durationText(base::toSeconds(limits.holdAfter)),
                            durationText(base::toSeconds(limits.endAfter)));
}

QString theoryText(base::Duration least, base::Duration most) {
  return most.count() == 0 ? QString()
                           : LiveTexts::box(numberText(base::toMilliseconds(least), 0),
                                            millisecondsText(most, 0));
}

QString delayText(const live::Summary& summary) {
  if (summary.delay.count == 0) {
    return noValue();
  }
  const QString delay = LiveTexts::delay(millisecondsText(summary.delay.p50, 0),
                                         millisecondsText(summary.delay.p99, 0));
  const QString theory = theoryText(summary.leastDelay, summary.mostDelay);
  return theory.isEmpty() ? delay : delay + QStringLiteral("; ") + LiveTexts::inTheory(theory);
}

QString linesText(const live::Summary& summary) {
  const QString lines = LiveTexts::lines(summary);
  return summary.merged == 0 ? lines
                             : lines + QStringLiteral("; ") + LiveTexts::merged(summary.merged);
}

}  // namespace rivulet::widgets
