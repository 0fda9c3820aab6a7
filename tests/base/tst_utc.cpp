// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/utc.h"

#include <QTest>

#include "support/test_program.h"

using namespace rivulet;

class TestUtc : public QObject {
  Q_OBJECT

 private slots:
  void textAndBack() {
    QCOMPARE(base::utcText(0), std::string("1970-01-01T00:00:00.000Z"));
    QCOMPARE(base::utcText(1'709'164'799'999), std::string("2024-02-28T23:59:59.999Z"));
    QCOMPARE(base::utcText(1'709'164'800'000), std::string("2024-02-29T00:00:00.000Z"));
    for (const base::UtcMs at : {base::UtcMs{0}, base::UtcMs{1'795'336'205'123}}) {
      QCOMPARE(base::utcOfText(base::utcText(at)), std::optional(at));
    }
    QCOMPARE(base::utcOfText("1970-01-02T12:00:05Z"), std::optional(base::UtcMs{129'605'000}));
  }

  void otherTextsAreRefused() {
    for (const char* text : {"", "2026-11-22", "2026-11-22T08:30:05.1Z", "2026-13-22T08:30:05.000Z",
                             "2026-02-30T08:30:05.000Z", "2026-11-22T24:30:05.000Z",
                             "2026-11-22t08:30:05.000Z", "2026-11-2aT08:30:05.000Z"}) {
      QVERIFY2(!base::utcOfText(text), text);
    }
  }
};

RIVULET_TEST(TestUtc)
#include "tst_utc.moc"
