// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <clocale>

#include "base/text.h"
#include "support/test_program.h"

using namespace rivulet::base;

class TestText : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void parsesNumbersWhateverTheLocale() {
    std::setlocale(LC_ALL, "de_DE.UTF-8");  // where it is installed; harmless elsewhere
    QCOMPARE(parseNumber("1.5"), std::optional<double>(1.5));
    QCOMPARE(parseNumber("+.5"), std::optional<double>(0.5));
    QCOMPARE(parseNumber("-60."), std::optional<double>(-60.0));
    QVERIFY(!parseNumber("1,5"));
    QVERIFY(!parseNumber(""));
    QVERIFY(!parseNumber("+-1"));
    QVERIFY(!parseNumber("12x"));
    std::setlocale(LC_ALL, "C");
  }

  void formatsShortestAndFixed() {
    QCOMPARE(formatNumber(0.1), std::string("0.1"));
    QCOMPARE(formatFixed(12.50, 3), std::string("12.5"));
    QCOMPARE(formatFixed(3.0, 3), std::string("3"));
    QCOMPARE(formatFixed(-0.0001, 3), std::string("0"));
    QCOMPARE(formatFixed(100.0, 0), std::string("100"));
  }

  void trimsAndRaises() {
    QCOMPARE(trim(" \tG1 X0\r\n"), std::string_view("G1 X0"));
    QCOMPARE(trim(" \t"), std::string_view(""));
    QCOMPARE(toUpper("g1 x\xC3\xA4"), std::string("G1 X\xC3\xA4"));
  }
};

RIVULET_TEST(TestText)
#include "tst_text.moc"
