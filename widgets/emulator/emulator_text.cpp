// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/emulator/emulator_text.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "widgets/common/number_format.h"

namespace rivulet::widgets {

namespace {

using P = emulator::AxisParameter;

struct EmulatorTexts {
  Q_DECLARE_TR_FUNCTIONS(EmulatorTexts)

 public:
  struct Words {
    QString name;
    QString meaning;
  };

  static Words of(P parameter) {
    switch (parameter) {
      case P::PositionGain:
        return {tr("Position gain"), tr("The larger it is, the smaller the following error.")};
      case P::FeedForward:
        return {tr("Feed-forward"),
                tr("Share of the speed that needs no following error. With 1 there is none at "
                   "constant speed.")};
      case P::FeedForwardLag:
        return {tr("Filter of the feed-forward"), tr("How late the feed-forward takes effect.")};
      case P::SpeedGain:
        return {tr("Speed gain"), tr("How quickly the drive reaches the speed it is told.")};
      case P::ResetTime:
        return {tr("Reset time"), tr("How soon the drive removes the rest of an error in speed.")};
      case P::EffortLag:
        return {tr("Lag of the drive"), tr("How late the force follows its command.")};
      case P::Coulomb:
        return {tr("Friction"), tr("Force against every motion, as the acceleration it costs. It "
                                   "makes the bumps where an axis reverses.")};
      case P::CoulombSpeed:
        return {tr("Speed of friction"), tr("From this speed on, friction has its full force.")};
      case P::Viscous:
        return {tr("Viscous friction"), tr("Friction that grows with the speed.")};
      case P::Delay:
        return {tr("Delay"), tr("Time until a set point takes effect.")};
      case P::ResonanceHz:
        return {tr("Resonance"), tr("Frequency at which motor and table swing against each "
                                    "other.")};
      case P::ResonanceDamping:
        return {
            tr("Damping of the resonance"),
            tr("The smaller it is, the longer the axis oscillates. At 1 it does not oscillate.")};
    }
    return {};
  }

  static QString unseen(const emulator::RunFit& worst) {
    return tr("On %1, which it was not learned from, positions are right within %2 (RMS), %3 at "
              "most.")
        .arg(QString::fromStdString(worst.name), errorLengthText(worst.positionRmsMm),
             errorLengthText(worst.positionMaxMm));
  }
  static QString unseenContour(double offMm, double machineMm) {
    return tr("The contour error there is off by %1 of %2 (RMS).")
        .arg(errorLengthText(offMm), errorLengthText(machineMm));
  }
  static QString onlyStretches(double rmsMm) {
    return tr("It was tested only on parts of the same recordings: right within %1 (RMS). Add "
              "a recording of another program and use it to test.")
        .arg(errorLengthText(rmsMm));
  }
  static QString goodFor(const QString& axes, double feedMmPerSMax) {
    return tr("Good for simulating and timing programs that move %1 at feeds up to %2. What is "
              "faster was not tested.")
        .arg(axes, feedText(feedMmPerSMax));
  }
  static QString badContour() { return tr("Do not rely on the contour errors that it predicts."); }
  static QString fromPreset(const QString& preset) {
    return tr("Limits of speed, acceleration and jerk are those of preset %1: correct them in the "
              "file if the machine has others.")
        .arg(preset);
  }
  /// @param accelerations  "X 540 mm/s²", of each axis
  static QString fromSetPoints(const QString& accelerations, const QString& preset) {
    return tr("Acceleration and jerk are limited as the set points show (%1), all else as in "
              "preset %2.")
        .arg(accelerations, preset);
  }
};

/// A contour error that is off by more is no prediction.
constexpr double kContourShare = 0.2;
constexpr double kContourMmMin = 0.001;

}  // namespace

QString parameterName(P parameter) {
  return EmulatorTexts::of(parameter).name;
}

QString parameterMeaning(P parameter) {
  return EmulatorTexts::of(parameter).meaning;
}

QString parameterUnit(P parameter) {
  const auto unit = emulator::factsOf(parameter).unit;
  return unit == "mm/s2" ? QStringLiteral("mm/s²")
         : unit == "s"   ? QStringLiteral("ms")
                         : QString::fromUtf8(unit.data(), static_cast<qsizetype>(unit.size()));
}

QString parameterText(P parameter, double value) {
  constexpr int kDigits = 4;
  return significantText(emulator::factsOf(parameter).unit == "s" ? 1e3 * value : value, kDigits);
}

QString significantText(double value, int digits) {
  const double size = std::abs(value);
  const int whole = size > 0.0 ? static_cast<int>(std::floor(std::log10(size))) + 1 : 1;
  return numberText(value, std::clamp(digits - whole, 0, 9));
}

QString errorLengthText(double mm) {
  constexpr double kLongMm = 1.0;
  constexpr double kShortMm = 1e-6;
  if (std::abs(mm) >= kLongMm) {
    return QStringLiteral("%1\u00a0mm").arg(significantText(mm, 3));
  }
  return std::abs(mm) < kShortMm
             ? QStringLiteral("<\u00a0%1\u00a0µm").arg(numberText(1e3 * kShortMm, 3))
             : QStringLiteral("%1\u00a0µm").arg(significantText(1e3 * mm, 3));
}

QString transferFunctionText(const emulator::AxisParameters& p) {
  constexpr int kDigits = 4;
  const auto number = [&](P parameter) { return significantText(p[parameter], kDigits); };
  // "1 + 0.002 s", in parentheses.
  const auto lag = [&](P parameter) { return QStringLiteral("(1 + %1 s)").arg(number(parameter)); };
  const bool hasSpeedLoop = p[P::SpeedGain] > 0.0;
  const QString gain = number(P::PositionGain);
  QString command = gain;
  if (p[P::FeedForward] > 0.0) {
    command = QStringLiteral("(%1 + %2 s%3)")
                  .arg(gain, number(P::FeedForward),
                       p[P::FeedForwardLag] > 0.0 ? QStringLiteral(" / ") + lag(P::FeedForwardLag)
                                                  : QString());
  }
  QString all = hasSpeedLoop ? QStringLiteral("%1 W(s) / (s + %2 W(s))").arg(command, gain)
                             : QStringLiteral("%1 / (s + %2)").arg(command, gain);
  if (p[P::Delay] > 0.0) {
    all = QStringLiteral("e^(−%1 s) · %2").arg(number(P::Delay), all);
  }
  if (p[P::ResonanceHz] > 0.0) {
    const double own = 2.0 * std::numbers::pi * p[P::ResonanceHz];
    const QString spring = QStringLiteral("%1 s + %2")
                               .arg(significantText(2.0 * p[P::ResonanceDamping] * own, kDigits),
                                    significantText(own * own, kDigits));
    all += QStringLiteral(" · (%1) / (s² + %1)").arg(spring);
  }
  QString text = QStringLiteral("G(s) = ") + all;
  if (hasSpeedLoop) {
    const QString plant = p[P::Viscous] > 0.0 ? QStringLiteral("(s + %1)").arg(number(P::Viscous))
                                              : QStringLiteral("s");
    text += QStringLiteral("\nW(s) = L(s) / (1 + L(s)),  L(s) = %1 · (1 + 1 / (%2 s)) / %3")
                .arg(number(P::SpeedGain), number(P::ResetTime),
                     p[P::EffortLag] > 0.0 ? QStringLiteral("(%1 %2)").arg(lag(P::EffortLag), plant)
                                           : plant);
  }
  return text;
}

EmulatorRemark emulatorRemark(const EmulatorView& view) {
  EmulatorRemark remark;
  QStringList sentences;
  QStringList axes;
  double stretchRmsMm = 0.0;
  for (const emulator::LearnedAxis& axis : view.emulator.axes) {
    axes.append(QString(QLatin1Char(axis.axis)));
    stretchRmsMm = std::max(stretchRmsMm, axis.heldOutRmsMm);
  }
  if (view.unseen.empty()) {
    remark.status = Status::Attention;
    sentences.append(EmulatorTexts::onlyStretches(stretchRmsMm));
  } else {
    const auto worst = std::max_element(
        view.unseen.begin(), view.unseen.end(),
        [](const auto& one, const auto& two) { return one.positionRmsMm < two.positionRmsMm; });
    sentences.append(EmulatorTexts::unseen(*worst));
    const double offMm = std::abs(worst->emulatedContourRmsMm - worst->contourRmsMm);
    sentences.append(EmulatorTexts::unseenContour(offMm, worst->contourRmsMm));
    if (offMm > std::max(kContourMmMin, kContourShare * worst->contourRmsMm)) {
      remark.status = Status::Attention;
      sentences.append(EmulatorTexts::badContour());
    }
  }
  sentences.append(EmulatorTexts::goodFor(axes.join(QStringLiteral(", ")), view.feedMmPerSMax));
  QStringList limits;
  for (const emulator::AxisLimits& axis : view.limits) {
    if (emulator::isReached(axis.accelerationMmPerS2)) {
      limits.append(QStringLiteral("%1 %2\u00a0mm/s²")
                        .arg(QLatin1Char(axis.axis))
                        .arg(significantText(axis.accelerationMmPerS2.value, 4)));
    }
  }
  const QString preset = QString::fromStdString(view.emulator.preset);
  sentences.append(limits.isEmpty()
                       ? EmulatorTexts::fromPreset(preset)
                       : EmulatorTexts::fromSetPoints(limits.join(QStringLiteral(", ")), preset));
  remark.text = sentences.join(QLatin1Char(' '));
  return remark;
}

}  // namespace rivulet::widgets
