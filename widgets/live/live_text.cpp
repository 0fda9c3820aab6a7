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
  static QString factor(const live::FactorSeen& seen) {
    const QString source = QString::fromStdString(seen.source);
    if (seen.state == live::FactorState::Follows) {
      return tr("Adaptive feed: %1 % of your override, from %2")
          .arg(numberText(100.0 * seen.factor, 0), source);
    }
    if (seen.state == live::FactorState::Released) {
      return tr("Adaptive feed: without %1, until its next factor").arg(source);
    }
    const QString why = withoutFactor(seen);
    return seen.holds() ? tr("Adaptive feed: the axes are held. %1: %2").arg(source, why)
                        : tr("Adaptive feed: your override acts alone. %1: %2").arg(source, why);
  }
  static QString withoutFactor(const live::FactorSeen& seen) {
    switch (seen.state) {
      case live::FactorState::Waiting:
        return tr("no factor has come yet");
      case live::FactorState::Silent:
        return tr("no factor has come in time");
      case live::FactorState::Refused:
        return seen.refused ? tr("%1 % was not agreed").arg(numberText(100.0 * *seen.refused, 0))
                            : tr("its last line is no factor");
      case live::FactorState::Closed:
        return tr("it has closed");
      case live::FactorState::Follows:
      case live::FactorState::Released:
        break;
    }
    return {};
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

QString feedSourceText(const live::FactorSeen& seen) {
  return LiveTexts::factor(seen);
}

}  // namespace rivulet::widgets
