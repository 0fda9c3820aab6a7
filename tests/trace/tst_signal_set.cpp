// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "support/test_program.h"
#include "trace/formula.h"
#include "trace/import/import.h"
#include "trace/signal_set.h"

using namespace rivulet;
using namespace rivulet::trace;
using base::Instant;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Instant at(double seconds) {
  return Instant{base::fromSeconds(seconds)};
}

std::vector<double> valuesOf(const char* text, const std::vector<std::vector<double>>& columns,
                             double stepS = 0.5) {
  const auto formula = Formula::parse(text);
  if (!formula) {
    return {};
  }
  std::vector<Instant> times;
  for (std::size_t i = 0; i < columns.front().size(); ++i) {
    times.push_back(at(stepS * static_cast<double>(i)));
  }
  return formula->evaluate(times, columns);
}

Channel channel(const char* name, const std::vector<double>& values, double stepS = 1.0) {
  auto samples = std::make_shared<Envelope>();
  for (std::size_t i = 0; i < values.size(); ++i) {
    samples->append(at(stepS * static_cast<double>(i)), values[i]);
  }
  return {name, "mm", std::move(samples)};
}

/// X goes 10 mm in 10 samples, 0.1 mm ahead of the actual position.
ControlTrace straight() {
  ControlTrace trace;
  trace.cycle = std::chrono::milliseconds{4};
  for (int i = 0; i < 11; ++i) {
    ControlSample sample;
    sample.at = at(5.0 + 0.004 * i);
    sample.commandMm.x = i;
    sample.actualMm.x = i - 0.1;
    sample.feedMmPerS = 250.0;
    sample.line = base::LineNumber{i < 5 ? 10U : 20U};
    trace.samples.push_back(sample);
  }
  return trace;
}

}  // namespace

class TestSignalSet : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void calculates_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<double>("expected");  // with a = 3, b = 4
    const auto row = [](const char* text, double expected) {
      QTest::newRow(text) << QString(text) << expected;
    };
    row("a", 3.0);
    row("a + b * 2", 11.0);
    row("(a + b) * 2", 14.0);
    row("b - a - 1", 0.0);
    row("2 / b / 2", 0.25);
    row("-a^2", -9.0);
    row("2^3^2", 512.0);
    row("2^-1", 0.5);
    row("hypot(a, b)", 5.0);
    row("hypot(a, b, 12)", 13.0);
    row("min(a, b, 1) + max(a, 7)", 8.0);
    row("abs(a - b)", 1.0);
    row("atan2(1, 1)", 45.0);
    row("sin(30)+cos(60)+tan(45)", 2.0);
    row("sqrt(b) + ln(exp(1.5e0)) + .5", 4.0);
    row("per_min(a)", 180.0);
    row("'a' * a", 9.0);
  }
  void calculates() {
    QFETCH(QString, text);
    QFETCH(double, expected);
    const auto formula = Formula::parse(text.toStdString());
    QVERIFY2(formula, qPrintable(text));
    std::vector<std::vector<double>> columns;
    for (const std::string& name : formula->names()) {
      columns.push_back({name == "a" ? 3.0 : 4.0});
    }
    QVERIFY(std::abs(formula->evaluate({at(0.0)}, columns).front() - expected) < 1e-12);
  }

  void derivesInTime() {
    const auto values = valuesOf("d(a)", {{1.0, 2.0, 4.0}});
    QVERIFY(std::isnan(values[0]));
    QCOMPARE(values[1], 2.0);
    QCOMPARE(values[2], 4.0);
    QVERIFY(std::isnan(valuesOf("d(d(a))", {{1.0, 2.0, 4.0}})[1]));
    QCOMPARE(valuesOf("d(d(a))", {{1.0, 2.0, 4.0}})[2], 4.0);
    QVERIFY(std::isnan(valuesOf("d(a)", {{1.0, 2.0}}, 0.0)[1]));
    QVERIFY(std::isnan(valuesOf("max(a, 1)", {{kNaN}})[0]));
    QVERIFY(std::isnan(valuesOf("min(1, a)", {{kNaN}})[0]));
  }

  void refusesRubbish_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("context");
    for (const auto& [text, context] :
         std::initializer_list<std::pair<const char*, const char*>>{{"", ""},
                                                                    {"a +", ""},
                                                                    {"a b", "b"},
                                                                    {"(a", ""},
                                                                    {"a)", ")"},
                                                                    {"hypot(a)", ")"},
                                                                    {"abs(a, b)", ", b)"},
                                                                    {"sine(a)", "sine"},
                                                                    {"'a", "a"},
                                                                    {"#", "#"},
                                                                    {"1..2", ".2"},
                                                                    {"atan2(1)", ")"},
                                                                    {"inf(1)", "inf"},
                                                                    {"min(a,b", ""},
                                                                    {"''", "'"}}) {
      QTest::newRow(text) << QString(text) << QString(context);
    }
  }
  void refusesRubbish() {
    QFETCH(QString, text);
    QFETCH(QString, context);
    const auto formula = Formula::parse(text.toStdString());
    QVERIFY(!formula);
    QCOMPARE(QString::fromStdString(formula.error().context), context);
    QVERIFY(!Formula::parse(std::string(100'000, '(')));
    QVERIFY(!Formula::parse(std::string(100'000, '-')));
  }

  /// A file that was changed, or put together: what runs backwards is left out, and that is said.
  void timesThatRunBackwards() {
    ControlTrace trace = straight();
    std::swap(trace.samples[4].at, trace.samples[7].at);
    const TraceAnalysis analysis = analyseTrace(Trace(trace));
    const ShownTrace shown = makeShownTrace(Trace(trace), analysis);
    QCOMPARE(analysis.motion.samples.size(), trace.samples.size() - 3);
    QCOMPARE(shown.remarks.size(), std::size_t{1});
    QVERIFY(shown.remarks.front().code == RemarkCode::ValuesBackwards);
  }

  void offersWhatIsThere() {
    const ControlTrace trace = straight();
    const TraceAnalysis analysis = analyseTrace(Trace(trace));
    const ShownTrace shown = makeShownTrace(Trace(trace), analysis);
    QCOMPARE(base::toSeconds(shown.length), 0.04);
    QVERIFY(shown.isAnalysed);
    std::size_t axes = 0;
    for (const SignalOffer& offer : shown.signalSet.offers()) {
      const auto samples = shown.signalSet.calculate(offer.formula);
      QVERIFY2(samples, offer.formula.c_str());
      QCOMPARE((*samples)->size(), std::size_t{11});
      QVERIFY(offer.group != SignalGroup::ContourError);  // there is no program
      axes += offer.group == SignalGroup::Lag ? 1U : 0U;
    }
    QCOMPARE(axes, std::size_t{3});
    QVERIFY(std::abs(valueAt(**shown.signalSet.calculate("x_set - x_act"), at(0.01)) - 0.1) <
            1e-12);
    QCOMPARE(valueAt(**shown.signalSet.calculate("per_min(path_speed)"), at(0.02)), 15000.0);
    QCOMPARE(valueAt(**shown.signalSet.calculate("line"), at(0.0)), 10.0);
    QVERIFY(!shown.signalSet.calculate("x_actual"));
    QCOMPARE(shown.signalSet.calculate("x_actual").error().context, std::string("x_actual"));
    QVERIFY(!shown.signalSet.calculate("1 + 1"));
  }

  void showsColumnsOfAnyName() {
    const auto imported = importTrace("t [s];Spindle load [%];x_act\n0;10;1\n1;20;2\n2;x;4\n");
    QVERIFY(imported);
    const ShownTrace shown = makeShownTrace(Trace(*imported));
    QVERIFY(!shown.isAnalysed);
    bool found = false;
    for (const SignalOffer& offer : shown.signalSet.offers()) {
      QVERIFY2(shown.signalSet.calculate(offer.formula), offer.formula.c_str());
      found = found || (offer.group == SignalGroup::Column && offer.unit == "%");
    }
    QVERIFY(found);
    QVERIFY(!shown.remarks.empty() || imported->trace.remarks.empty());
  }

  void mixesTimeBases() {
    SignalSet signalSet;
    signalSet.add(channel("a", {0.0, 1.0, 2.0, 3.0}));
    signalSet.add(channel("b", {0.0, 10.0, 20.0}, 1.2));
    const auto sum = signalSet.calculate("a + b");
    QVERIFY(sum);
    QCOMPARE((*sum)->size(), std::size_t{4});
    QVERIFY(std::abs((*sum)->valueAt(2) - (2.0 + 10.0 + 10.0 * 0.8 / 1.2)) < 1e-9);
    QVERIFY(std::isnan((*sum)->valueAt(3)));  // b has ended
  }

  /// A line is that of the last block that began: nothing is between two of them.
  void holdsValuesThatChangeInSteps() {
    const Channel lines = channel("line", {10.0, 10.0, 20.0, kNaN, 10.0});
    QVERIFY(std::isnan(heldValueAt(*lines.samples, at(-0.1))));
    QVERIFY(std::isnan(valueAt(*lines.samples, at(-0.1))));
    QCOMPARE(heldValueAt(*lines.samples, at(0.0)), 10.0);
    QCOMPARE(heldValueAt(*lines.samples, at(1.9)), 10.0);
    QCOMPARE(heldValueAt(*lines.samples, at(2.0)), 20.0);
    QVERIFY(std::isnan(heldValueAt(*lines.samples, at(3.5))));
    QCOMPARE(heldValueAt(*lines.samples, at(99.0)), 10.0);
    const std::vector<ValueSpan> spans = spansOf(*lines.samples, 10.0);
    QCOMPARE(spans.size(), std::size_t{2});
    QCOMPARE(spans[0].from, at(0.0));
    QCOMPARE(spans[0].to, at(2.0));
    QCOMPARE(spans[1].from, at(4.0));
  }

  /// Files that are seen together begin where the user says.
  void beginsAtTheOffset() {
    const std::string text = "t_s,x_act\n100,1\n100.5,2\n101,3\n";
    for (const double offsetS : {0.0, 1.5, -0.25}) {
      TableMapping mapping;
      mapping.offsetS = offsetS;
      const auto imported = importTrace(text, mapping);
      QVERIFY(imported);
      const ShownTrace shown = makeShownTrace(Trace(*imported));
      QCOMPARE(shown.signalSet.find("x_act")->samples->timeAt(1), at(offsetS + 0.5));
    }
  }

  void countsBetweenTwoInstants() {
    const Channel one = channel("a", {9.0, 3.0, kNaN, -4.0, 1.0, 9.0});
    const SampleStatistics figures = sampleStatistics(*one.samples, at(1.0), at(4.0));
    QCOMPARE(figures.count, std::size_t{3});
    QCOMPARE(figures.min, -4.0);
    QCOMPARE(figures.max, 3.0);
    QCOMPARE(figures.mean, 0.0);
    QVERIFY(std::abs(figures.rms - std::sqrt(26.0 / 3.0)) < 1e-12);
    QCOMPARE(figures.p50, 1.0);
    QCOMPARE(figures.p95, 3.0);
    QCOMPARE(sampleStatistics(*one.samples, at(2.0), at(2.0)).count, std::size_t{0});
    QCOMPARE(sampleStatistics(*one.samples, at(8.0), at(9.0)).count, std::size_t{0});
  }
};

RIVULET_TEST(TestSignalSet)
#include "tst_signal_set.moc"
