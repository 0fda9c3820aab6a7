// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <cmath>

#include "base/text.h"
#include "gcode/calculator.h"
#include "support/test_program.h"

using namespace rivulet;
using gcode::Dialect;

namespace {

/// The value as text, or "! why not".
std::string valueOf(gcode::Calculator& calculator, std::string_view text) {
  const std::optional<double> value = calculator.evaluate(text);
  return value ? base::formatFixed(*value, 9) : "! " + calculator.problem();
}

}  // namespace

class TestCalculator : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void sinumerik_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("expected");
    const auto add = [](const char* text, const char* expected) {
      QTest::newRow(text) << QByteArray(text) << QByteArray(expected);
    };
    add("2+3*4", "14");
    add("10-2*3", "4");
    add("100-10*2+5", "85");
    add("(2+3)*4", "20");
    add("2*-3", "-6");
    add("1+1-1+-1", "0");
    add("7 DIV 3", "2");
    add("7 DIV 4.1", "1");
    add("7 DIV 0.4", "17");
    add("7 MOD 4.1", "2.9");
    add("6 B_AND 3", "2");
    add("1 OR 0 AND 0", "1");
    add("R1+R[1+1]", "12");
    add("5>=5", "1");
    add("0.1+0.2==0.3", "1");
    add("0.1+0.2>0.3", "0");
    add("NOT 0", "1");
    add("8.2EX-3", "0.0082");
    add("'H1F'+'B101'", "36");
    add("SQRT(POT(3)+POT(4))", "5");
    add("ATAN2(30.5,80.1)", "20.845533927");
    add("BOUND(-1,5,7)", "5");
    add("F[1,2]", "7");
    add("TRUE+depth", "3.5");
    add("1/0", "! a division by zero");
    add("R9", "! R9 is read before the program sets it: only the control knows it");
    add("F[2,0]", "! the index lies outside the array");
    add("1+", "! a value is missing");
    add("(1", "! a bracket is not closed");
    add("1 2", "! \"2\" is not understood");
    add("SIN", "! SIN needs its argument in brackets");
    add("NAME", "! a text is calculated with");
    add("$P_TOOL", "! the value of $P_TOOL is known on the control only");
    add("$AA_IW[X]", "42");
  }

  void sinumerik() {
    gcode::Calculator calculator(Dialect::Sinumerik, [](std::string_view name) {
      return name == "$AA_IW[X]" ? std::optional(42.0) : std::nullopt;
    });
    QVERIFY(calculator.define("REAL F[2,3], DEPTH=2.5"));
    QVERIFY(calculator.define("STRING[8] NAME=\"A, B\""));
    QVERIFY(calculator.assign("R1=5"));
    QVERIFY(calculator.assign("R[2]=R1+2"));
    QVERIFY(calculator.assign("F[1,2]=7"));
    QFETCH(const QByteArray, text);
    QFETCH(const QByteArray, expected);
    QCOMPARE(QByteArray::fromStdString(valueOf(calculator, text.toStdString())), expected);
  }

  void iso_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("expected");
    const auto add = [](const char* text, const char* expected) {
      QTest::newRow(text) << QByteArray(text) << QByteArray(expected);
    };
    add("[#1+#<depth>*2]", "11");
    add("#[1+1]", "7");
    add("##3", "5");
    add("-#1", "-5");
    add("[2**3**2]", "64");
    add("[7 MOD 4]", "3");
    add("[-7 MOD 4]", "1");
    add("[#1EQ5]", "1");
    add("[#1 GT 5 OR #2 LE 7]", "1");
    add("[1 + 2 EQ 3]", "1");
    add("ATAN[1]/[-1]", "135");
    add("FIX[-2.5]+FUP[2.1]", "0");
    add("EXISTS[#<depth>]", "1");
    add("EXISTS[#<width>]", "0");
    add("#4", "0");
    add("#5220", "! the value of #5220 is known on the control only");
    add("#<width>", "! the value of #<WIDTH> is known on the control only");
    add("[1+2", "! a bracket is not closed");
    add("#ABC", "! #ABC is no variable");
  }

  void iso() {
    gcode::Calculator calculator(Dialect::LinuxCnc, {});
    QVERIFY(calculator.assign("#1=5"));
    QVERIFY(calculator.assign("#2 = [#1 + 2]"));
    QVERIFY(calculator.assign("#3=1"));
    QVERIFY(calculator.assign("#<depth>=3"));
    QFETCH(const QByteArray, text);
    QFETCH(const QByteArray, expected);
    QCOMPARE(QByteArray::fromStdString(valueOf(calculator, text.toStdString())), expected);
  }

  void arraysAreFilled() {
    gcode::Calculator calculator(Dialect::Sinumerik, {});
    QVERIFY(calculator.define("REAL A[2,2]=SET(1,,3), B[3]=REP(7)"));
    QCOMPARE(calculator.find("A")->values, (std::vector<double>{1, 0, 3, 0}));
    QCOMPARE(calculator.find("B")->values, (std::vector<double>{7, 7, 7}));
    QVERIFY(calculator.assign("A[0,1]=SET(8,9)"));
    QCOMPARE(calculator.find("A")->values, (std::vector<double>{1, 8, 9, 0}));
    QVERIFY(calculator.define("INT N=2.6"));
    QCOMPARE(calculator.find("N")->values.front(), 3.0);
    QVERIFY(!calculator.define("REAL HUGE[100000,100000]"));
  }

  /// What is computed from a value that failed fails as well, instead of using an older one.
  void faultsSpread() {
    gcode::Calculator calculator(Dialect::Sinumerik, {});
    QVERIFY(calculator.define("REAL A=1"));
    QVERIFY(calculator.assign("R1=1"));
    QVERIFY(!calculator.assign("A=1/0"));
    QVERIFY(!calculator.assign("R1=$P_TOOL"));
    QVERIFY(!calculator.evaluate("A+1"));
    QVERIFY(!calculator.evaluate("R1"));
  }

  void subprogramsHaveTheirOwn() {
    gcode::Calculator calculator(Dialect::LinuxCnc, {});
    QVERIFY(calculator.assign("#1=5"));
    QVERIFY(calculator.assign("#<_all>=6"));
    gcode::Scope scope;
    scope.numbers[1] = 9.0;
    calculator.enter(std::move(scope));
    QCOMPARE(calculator.evaluate("#1").value(), 9.0);
    QCOMPARE(calculator.evaluate("#<_all>").value(), 6.0);
    calculator.leave();
    QCOMPARE(calculator.evaluate("#1").value(), 5.0);
  }

  void deepNestingIsAnError() {
    gcode::Calculator calculator(Dialect::Sinumerik, {});
    const std::string text = std::string(100'000, '(') + "1" + std::string(100'000, ')');
    QVERIFY(!calculator.evaluate(text));
    QVERIFY(!calculator.evaluate(std::string(100'000, '-') + "1"));
  }
};

RIVULET_TEST(TestCalculator)
#include "tst_calculator.moc"
