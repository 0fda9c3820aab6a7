// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <cmath>

#include "base/text.h"
#include "nc/cycles/drilling.h"
#include "support/test_program.h"

using namespace rivulet;
using nc::CycleStart;
using nc::CycleStep;

namespace {

constexpr CycleStart kStart{{10.0, 20.0, 50.0}, 0, 1.0, 600.0};

/// "10,,2": numbers, empty where a parameter is left out.
std::vector<std::optional<double>> argumentsOf(const QString& text) {
  std::vector<std::optional<double>> arguments;
  for (const QString& part : text.split(QLatin1Char(','))) {
    arguments.push_back(part.trimmed().isEmpty() ? std::nullopt : std::optional(part.toDouble()));
  }
  return arguments;
}

std::string rounded(double value) {
  return base::formatNumber(std::round(value * 1e6) / 1e6 + 0.0);  // no -0
}

/// Heights where the tool goes: R rapid, F with the feed, D dwell, M spindle. An axis besides Z is
/// named only if it is not at the start.
std::string textOf(const std::vector<CycleStep>& steps) {
  std::string text;
  for (const CycleStep& step : steps) {
    text += text.empty() ? "" : " ";
    switch (step.kind) {
      case CycleStep::Kind::Rapid:
      case CycleStep::Kind::Feed:
        text += (step.kind == CycleStep::Kind::Rapid ? "R" : "F") + rounded(step.toMm.z);
        if (step.toMm.x != kStart.positionMm.x || step.toMm.y != kStart.positionMm.y) {
          text += "(" + rounded(step.toMm.x) + "," + rounded(step.toMm.y) + ")";
        }
        text += step.feedFactor != 1.0 ? "*" + rounded(step.feedFactor) : "";
        text += step.feedMmPerS != 0.0 ? "@" + rounded(step.feedMmPerS) : "";
        break;
      case CycleStep::Kind::Dwell:
        text += "D" + rounded(step.seconds);
        break;
      case CycleStep::Kind::Spindle:
        text += "M" + rounded(step.function);
        text += step.spindlePerMin != 0.0 ? "S" + rounded(step.spindlePerMin) : "";
        break;
    }
  }
  return text;
}

}  // namespace

class TestDrilling : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void cycles_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("arguments");
    QTest::addColumn<QString>("steps");
    const auto row = [](const char* what, const char* name, const char* arguments,
                        const char* steps) { QTest::newRow(what) << name << arguments << steps; };
    row("absolute", "CYCLE81", "10,0,2,-5", "R2 F-5 R10");
    row("relative", "CYCLE81", "10,3,2,,5", "R5 F-2 R10");
    row("relative wins", "CYCLE81", "10,3,2,-50,5", "R5 F-2 R10");
    row("no retraction", "CYCLE81", "3,3,,-1,", "R3 F-1 R3");
    row("upwards", "CYCLE81", "-10,0,2,5", "R-2 F5 R-10");
    row("upwards, relative", "CYCLE81", "-10,0,2,,5", "R-2 F5 R-10");
    row("dwell", "CYCLE82", "10,0,2,-5,,0.5", "R2 F-5 D0.5 R10");
    row("dwell in turns", "CYCLE82", "10,0,2,-5,,-3", "R2 F-5 D0.3 R10");
    row("retraction in the hole", "CYCLE81", "-2,0,2,-5", "alarm 61101");
    row("no direction", "CYCLE81", "3,3,1,,5", "alarm 61101");

    row("whole depth", "CYCLE83", "10,0,2,-5,,-9,,0", "R2 F-5 R10");
    row("equal strokes", "CYCLE83", "10,0,2,-9,,-4,,0,,,1,1",
        "R2 F-4 R2 R-3.4 F-8 R2 R-7.4 F-9 R10");
    row("first depth relative", "CYCLE83", "10,1,2,-8,,,4,0,,,1,1",
        "R3 F-3 R3 R-2.4 F-7 R3 R-6.4 F-8 R10");
    // Strokes 20, 15, 10, 5, then 5 as long as more than 10 is left, and two halves.
    row("degression", "CYCLE83", "10,0,2,-63,,-20,,5,,,1,0",
        "R2 F-20 F-19 F-35 F-34 F-45 F-44 F-50 F-49 F-55 F-54 F-59 F-58 F-63 R10");
    row("degression by a factor", "CYCLE83", "10,0,2,-18,,-8,,-0.5,,,1,0,,3",
        "R2 F-8 F-7 F-12 F-11 F-15 F-14 F-18 R10");
    row("dwells", "CYCLE83", "10,0,2,-8,,-4,,0,0.2,0.3,1,1,,,,0.5",
        "R2 F-4 D0.2 R2 D0.3 R-3.4 F-8 D0.5 R10");
    row("first feed", "CYCLE83", "10,0,2,-8,,-4,,0,,,0.5,1", "R2 F-4*0.5 R2 R-3.4 F-8 R10");
    row("chip breaking", "CYCLE83", "10,0,2,-8,,-4,,0,,,1,0,,,1.5", "R2 F-4 F-2.5 F-8 R10");
    row("limit of a deep hole", "CYCLE83", "10,0,2,-100,,-50,,0,,,1,1",
        "R2 F-50 R2 R-48 F-100 R10");
    row("limit given", "CYCLE83", "10,0,2,-8,,-4,,0,,,1,1,,,,,1", "R2 F-4 R2 R-3 F-8 R10");
    row("no first depth", "CYCLE83", "10,0,2,-8", "alarm 61107");

    row("tapping by pitch", "CYCLE84", "10,0,2,-8,,0.5,3,,1.5,0,400,800",
        "R2 M19 M3S400 F-8@10 D0.5 M4S800 F2@20 R10 M3");
    row("tapping by size", "CYCLE84", "10,0,2,-8,,,5,10,,0,400",
        "R2 M19 M3S400 F-8@10 M4S400 F2@10 R10 M5");
    row("left-hand thread, speed of the program", "CYCLE84", "10,0,2,-8,,,4,,-1",
        "R2 M19 M4S600 F-8@10 M3S600 F2@10 R10 M4");
    row("no pitch", "CYCLE84", "10,0,2,-8,,,3", "alarm 61001");
    row("no such thread", "CYCLE84", "10,0,2,-8,,,3,11", "alarm 61001");
    row("two pitches", "CYCLE84", "10,0,2,-8,,,3,10,1", "alarm 61001");
    row("no direction after tapping", "CYCLE84", "10,0,2,-8,,,,10", "alarm 61102");

    row("boring", "CYCLE86", "10,0,2,-8,,0.5,3,-0.2,0.1,0.3,0",
        "R2 M3 F-8 D0.5 M19 R-7.7(9.8,20.1) R2(9.8,20.1) R10");
    row("boring without direction", "CYCLE86", "10,0,2,-8", "alarm 61102");
  }
  void cycles() {
    QFETCH(QString, name);
    QFETCH(QString, arguments);
    QFETCH(QString, steps);
    const auto made = nc::expandCycle(name.toStdString(), argumentsOf(arguments), kStart);
    const std::string text = made ? textOf(*made) : "alarm " + std::to_string(made.error().alarm);
    QCOMPARE(QString::fromStdString(text), steps);
  }

  /// The axis is that of the plane, or the one the cycle names.
  void axisIsThatOfThePlane() {
    CycleStart start = kStart;
    start.planeFirstAxis = 2;  // G18
    const auto drilled = nc::expandCycle("CYCLE81", argumentsOf("10,0,2,-5"), start);
    QCOMPARE(drilled->at(1).toMm, (base::Vec3{10.0, -5.0, 50.0}));
    const auto deep = nc::expandCycle("CYCLE83", argumentsOf("10,0,2,-5,,-9,,,,,,,1"), start);
    QCOMPARE(deep->at(1).toMm, (base::Vec3{-5.0, 20.0, 50.0}));
  }

  void inchesAreConverted() {
    CycleStart start = kStart;
    start.lengthFactor = 25.4;
    const auto drilled = nc::expandCycle("CYCLE81", argumentsOf("1,0,0.1,-1"), start);
    QCOMPARE(drilled->at(0).toMm.z, 2.54);
    QCOMPARE(drilled->at(1).toMm.z, -25.4);
    QCOMPARE(nc::holesOf("HOLES2", argumentsOf("1,2,1,0,0,4"), start).at(0).x, 50.8);
  }

  void patterns_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("arguments");
    QTest::addColumn<QString>("places");
    QTest::newRow("row") << "HOLES1"
                         << "0,20,0,10,5,3"
                         << "10,20 15,20 20,20";
    QTest::newRow("row from its nearer end") << "HOLES1"
                                             << "0,0,90,0,10,3"
                                             << "0,20 0,10 0,0";
    QTest::newRow("row at an angle") << "HOLES1"
                                     << "10,20,30,0,10,2"
                                     << "10,20 18.660254,25";
    QTest::newRow("circle") << "HOLES2"
                            << "0,0,10,0,0,4"
                            << "10,0 0,10 -10,0 0,-10";
    QTest::newRow("part of a circle") << "HOLES2"
                                      << "0,0,10,90,-45,2"
                                      << "0,10 7.071068,7.071068";
    QTest::newRow("none") << "HOLES2"
                          << "0,0,10,0,0,0"
                          << "";
  }
  void patterns() {
    QFETCH(QString, name);
    QFETCH(QString, arguments);
    QFETCH(QString, places);
    QStringList text;
    for (const base::Vec3 place : nc::holesOf(name.toStdString(), argumentsOf(arguments), kStart)) {
      QCOMPARE(place.z, kStart.positionMm.z);
      text.append(QString::fromStdString(rounded(place.x) + "," + rounded(place.y)));
    }
    QCOMPARE(text.join(QLatin1Char(' ')), places);
  }
};

RIVULET_TEST(TestDrilling)
#include "tst_drilling.moc"
