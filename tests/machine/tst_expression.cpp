// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <cmath>

#include "machine/expression.h"
#include "support/test_program.h"

using namespace rivulet::machine;

namespace {

/// R[i] = 10·i for i below 20.
class Tens final : public ValueSource {
 public:
  std::optional<double> value(int index) const override {
    return index >= 0 && index < 20 ? std::optional<double>(10.0 * index) : std::nullopt;
  }
};

}  // namespace

class TestExpression : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void evaluates_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<double>("value");
    QTest::newRow("number") << "8.2EX-3" << 0.0082;
    QTest::newRow("products before sums") << "2+3*4-6/3" << 12.0;
    QTest::newRow("left to right") << "20-5-3" << 12.0;
    QTest::newRow("sign") << "-3*-2" << 6.0;
    QTest::newRow("parentheses") << "(2+3)*4" << 20.0;
    QTest::newRow("DIV truncates the real quotient") << "7 DIV 4.1" << 1.0;
    QTest::newRow("MOD") << "17 MOD 5" << 2.0;
    QTest::newRow("R") << "R3+1" << 31.0;
    QTest::newRow("R indexed") << "R[R0+2]" << 20.0;
    QTest::newRow("R of R") << "R[R1/10]" << 10.0;
    QTest::newRow("B_AND before B_OR") << "1 B_OR 6 B_AND 4" << 5.0;
    QTest::newRow("AND before OR") << "1 OR 0 AND 0" << 1.0;
    // With OR weakest but for comparisons: (1 OR 0) == 1.
    QTest::newRow("comparisons last") << "1 OR 0 == 1" << 1.0;
    QTest::newRow("sums before comparisons") << "1+1 < 1+2" << 1.0;
    QTest::newRow("NOT") << "NOT 0" << 1.0;
    QTest::newRow("unequal") << "3<>3" << 0.0;
    QTest::newRow("equal within 1e-12") << "0.1+0.2 == 0.3" << 1.0;
    QTest::newRow("degrees") << "SIN(30)" << 0.5;
    QTest::newRow("two arguments")
        << "ATAN2(30.5,-80.1)" << std::atan2(30.5, -80.1) * 57.29577951308232;
    QTest::newRow("nested") << "SQRT(POT(3)+POT(4))" << 5.0;
    QTest::newRow("bound") << "BOUND(2,9,11)" << 9.0;
  }
  void evaluates() {
    QFETCH(QString, text);
    QFETCH(double, value);
    std::string problem;
    const auto parsed = parseExpression(text.toStdString(), problem);
    QVERIFY2(parsed.has_value(), problem.c_str());
    QCOMPARE(parsed->length, static_cast<std::size_t>(text.size()));
    Alarm alarm;
    const auto result = parsed->expression.evaluate(Tens(), alarm);
    QVERIFY2(result.has_value(), alarm.text.c_str());
    // Trigonometry in degrees rounds: a part in 10^12 is what a double leaves of it.
    QVERIFY(std::abs(*result - value) <= 1e-12 * std::max(1.0, std::abs(value)));
  }

  void stopsWhereTheExpressionEnds() {
    std::string problem;
    const auto parsed = parseExpression("R11 Y=R12", problem);
    QVERIFY(parsed);
    QCOMPARE(parsed->length, std::size_t{3});
  }

  void refuses_data() {
    QTest::addColumn<QString>("text");
    for (const char* text : {"", "1+", "(1", "R", "R[1", "SIN 30", "BOUND(1,2)", "FOO", "1EX"}) {
      QTest::newRow(text) << text;
    }
  }
  void refuses() {
    QFETCH(QString, text);
    std::string problem;
    QVERIFY(!parseExpression(text.toStdString(), problem));
    QVERIFY(!problem.empty());
  }

  void alarms_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("number");
    QTest::newRow("missing R") << "R99" << 17020;
    QTest::newRow("negative index") << "R[-1]" << 17020;
    QTest::newRow("division by zero") << "1/(R1-10)" << 14051;
    QTest::newRow("root of a negative") << "SQRT(-1)" << 14051;
  }
  void alarms() {
    QFETCH(QString, text);
    QFETCH(int, number);
    std::string problem;
    const auto parsed = parseExpression(text.toStdString(), problem);
    QVERIFY(parsed);
    Alarm alarm;
    QVERIFY(!parsed->expression.evaluate(Tens(), alarm));
    QCOMPARE(alarm.number, number);
  }
};

RIVULET_TEST(TestExpression)
#include "tst_expression.moc"
