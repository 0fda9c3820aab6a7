// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <set>

#include "nc/modal/vocabulary.h"
#include "support/test_program.h"

using namespace rivulet;
using nc::Dialect;

class TestVocabulary : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Catches a function that somebody takes for harmless without a manual that says so.
  void everyFunctionHasASource() {
    for (const Dialect dialect : nc::kDialects) {
      std::set<int> keys;
      for (const nc::GRow& row : nc::gTable(dialect).rows().subspan(1)) {
        QVERIFY2(!row.source.empty(), qPrintable(QString::number(row.key)));
        QVERIFY2(row.function != nc::G::Unknown, qPrintable(QString::number(row.key)));
        QVERIFY2(keys.insert(row.key).second, qPrintable(QString::number(row.key)));
      }
      std::set<int> numbers;
      for (const nc::MRow& row : nc::mFunctions(dialect)) {
        QVERIFY2(!row.source.empty(), qPrintable(QString::number(row.number)));
        QVERIFY2(numbers.insert(row.number).second, qPrintable(QString::number(row.number)));
      }
    }
  }

  void whatIsNotListedIsUnknown() {
    QCOMPARE(nc::gTable(Dialect::Sinumerik)[430], nc::GEffect::Unknown);
    QCOMPARE(nc::gTable(Dialect::Fanuc)[1110], nc::GEffect::Unknown);
    QVERIFY(nc::mFunction(Dialect::Fanuc, 163) == nullptr);
    QVERIFY(nc::mFunction(Dialect::Fanuc, 3) != nullptr);
    for (const Dialect dialect : nc::kDialects) {
      QCOMPARE(nc::nameEffect(dialect, "SOFT") == nc::NameEffect::Unknown,
               dialect != Dialect::Sinumerik);
    }
  }

  /// G70 of a mill is a unit, of a lathe a cycle.
  void aLatheHasRowsOfItsOwn() {
    const nc::GTable& table = nc::gTable(Dialect::Fanuc);
    QCOMPARE(table.row(700).function, nc::G::Inches);
    QCOMPARE(table.latheRow(700).function, nc::G::TurningCycle);
    QCOMPARE(table.latheRow(700).effect, nc::GEffect::TurningCycle);
    QCOMPARE(table.latheRow(10).function, nc::G::Line);
  }
};

RIVULET_TEST(TestVocabulary)
#include "tst_vocabulary.moc"
