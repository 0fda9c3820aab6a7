// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <cmath>

#include "support/test_program.h"
#include "trace/export.h"
#include "trace/import/import.h"

using namespace rivulet;
using namespace rivulet::trace;

namespace {

std::shared_ptr<const Envelope> samples(int count, double stepS, double factor) {
  auto envelope = std::make_shared<Envelope>();
  for (int i = 0; i < count; ++i) {
    envelope->append(base::Instant{base::fromSeconds(stepS * i)},
                     i == 3 ? std::nan("") : factor * i);
  }
  return envelope;
}

const base::Instant kStart{};
const base::Instant kEnd = base::Instant::max() - base::Duration{1};

}  // namespace

class TestExport : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void printsATable() {
    const std::vector<ExportedSignal> exported{{"x_act", "mm", samples(5, 0.5, 0.1)},
                                               {"hypot(a, b)", "", samples(5, 0.5, 1.0)}};
    QCOMPARE(printSignals(exported, base::Instant{std::chrono::milliseconds{500}},
                          base::Instant{std::chrono::milliseconds{1500}}, "t", "s"),
             std::string("t [s];x_act [mm];hypot(a, b)\n0.5;0.1;1\n1;0.2;2\n1.5;nan;nan\n"));
  }

  /// What is written is read back without loss, also with two time bases.
  void isReadBack() {
    const std::vector<ExportedSignal> exported{{"x_act", "mm", samples(50, 0.004, 1.0 / 3.0)},
                                               {"load", "%", samples(9, 0.02, 1e-7)},
                                               {"a;b", "", samples(50, 0.004, 7.0)},
                                               {"y_act", "mm", samples(50, 0.004, 2.0)}};
    const std::string text = printSignals(exported, kStart, kEnd, "t", "s");
    // The last columns are full: other tools tell by them how many there are.
    QCOMPARE(text.substr(0, text.find('\n')),
             std::string("t [s];load [%];t 2 [s];x_act [mm];\"a;b\";y_act [mm]"));
    const auto imported = importTrace(text);
    QVERIFY(imported);
    QCOMPARE(imported->trace.timeBases.size(), std::size_t{2});
    QCOMPARE(imported->trace.signalList.size(), std::size_t{4});
    for (const ExportedSignal& one : exported) {
      const auto found =
          std::find_if(imported->trace.signalList.begin(), imported->trace.signalList.end(),
                       [&](const Signal& signal) { return signal.name.find(one.name) == 0; });
      QVERIFY2(found != imported->trace.signalList.end(), one.name.c_str());
      QCOMPARE(found->values.size(), one.samples->size());
      for (std::size_t i = 0; i < found->values.size(); ++i) {
        const double expected = one.samples->valueAt(i);
        QVERIFY(std::isnan(expected) ? std::isnan(found->values[i]) : found->values[i] == expected);
      }
    }
  }
};

RIVULET_TEST(TestExport)
#include "tst_export.moc"
