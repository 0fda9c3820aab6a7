// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "alarm/alarm_list.h"

#include <QTest>

#include "support/test_program.h"

using namespace rivulet;
using namespace rivulet::alarm;

namespace {

/// "connection-lost unacknowledged, not-judged shelved": the list in its order.
QString print(const AlarmList& list) {
  QStringList texts;
  for (const Alarm& alarm : list.alarms()) {
    const std::string_view state = stateName(alarm.state());
    texts << QStringLiteral("%1 %2").arg(
        QString::fromUtf8(factsOf(alarm.code).name),
        QString::fromUtf8(state.data(), static_cast<qsizetype>(state.size())));
  }
  return texts.join(QStringLiteral(", "));
}

QString printEvents(AlarmList& list) {
  QStringList texts;
  for (const Transition& transition : list.takeTransitions()) {
    const std::string_view name = eventName(transition.event);
    texts << QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
  }
  return texts.join(QLatin1Char(' '));
}

constexpr UtcMs kMinute = 60'000;

}  // namespace

class TestAlarmList : public QObject {
  Q_OBJECT

 private slots:
  /// The four states of ISA-18.2 without shelving, on both ways to normal.
  void acknowledgedFirst() {
    AlarmList list;
    list.raise(Code::ConnectionLost, {"cell"}, 1);
    QCOMPARE(print(list), QString("connection-lost unacknowledged"));
    QVERIFY(list.acknowledge(list.alarms().front().number, "anna", 2));
    QCOMPARE(print(list), QString("connection-lost acknowledged"));
    QVERIFY(!list.acknowledge(list.alarms().front().number, "anna", 3));
    list.settle(Code::ConnectionLost, 4);
    QCOMPARE(print(list), QString());
    QCOMPARE(printEvents(list), QString("raised acknowledged returned"));
  }

  void returnedFirst() {
    AlarmList list;
    list.raise(Code::ConnectionLost, {"cell"}, 1);
    list.settle(Code::ConnectionLost, 2);
    QCOMPARE(print(list), QString("connection-lost returned-unacknowledged"));
    // It comes back before anybody has seen it: one alarm, counted, with its new time.
    list.raise(Code::ConnectionLost, {"cell"}, 3);
    QCOMPARE(print(list), QString("connection-lost unacknowledged"));
    QCOMPARE(list.alarms().front().count, 2);
    QCOMPARE(list.alarms().front().raisedAt, UtcMs{3});
    list.settle(Code::ConnectionLost, 4);
    list.acknowledgeAll("anna", 5);
    QVERIFY(list.alarms().empty() && list.mostImportant() == nullptr);
  }

  void aConditionThatHoldsIsOneAlarm() {
    AlarmList list;
    list.raise(Code::ControlAlarm, {"10631"}, 1);
    list.raise(Code::ControlAlarm, {"10631"}, 2);
    QCOMPARE(printEvents(list), QString("raised"));
    // Another number is another alarm.
    list.raise(Code::ControlAlarm, {"27000"}, 3);
    list.settleOthers(Code::ControlAlarm, "27000", 3);
    QCOMPARE(print(list), QString("control-alarm unacknowledged, "
                                  "control-alarm returned-unacknowledged"));
    QCOMPARE(list.mostImportant()->subject(), std::string("27000"));
  }

  void theMostImportantIsFirst() {
    AlarmList list;
    list.raise(Code::NotJudged, {"a.nc"}, 1);
    list.raise(Code::WrongMotion, {"a.nc", "3", "1"}, 2);
    list.raise(Code::FileChanged, {"a.nc"}, 3);
    QCOMPARE(print(list), QString("wrong-motion unacknowledged, file-changed unacknowledged, "
                                  "not-judged unacknowledged"));
    list.acknowledge(list.mostImportant()->number, "anna", 4);
    QCOMPARE(print(list), QString("file-changed unacknowledged, not-judged unacknowledged, "
                                  "wrong-motion acknowledged"));
    list.shelve(list.mostImportant()->number, 5 + kMinute, "anna", 5);
    QCOMPARE(list.mostImportant()->code, Code::NotJudged);
    QCOMPARE(list.shownCount(), std::size_t{2});
    QCOMPARE(print(list), QString("not-judged unacknowledged, wrong-motion acknowledged, "
                                  "file-changed shelved"));
  }

  void shelvingEnds() {
    AlarmList list;
    list.raise(Code::FileChanged, {"a.nc"}, 0);
    const int number = list.mostImportant()->number;
    QVERIFY(list.shelve(number, kMinute, "anna", 0));
    QVERIFY(list.mostImportant() == nullptr);
    list.advance(kMinute - 1);
    QCOMPARE(print(list), QString("file-changed shelved"));
    list.advance(kMinute);
    QCOMPARE(print(list), QString("file-changed unacknowledged"));
    // Nobody puts an alarm aside for ever.
    list.shelve(number, 1000 * AlarmList::kShelvingMsMax, "anna", kMinute);
    QCOMPARE(list.find(number)->shelving->until, kMinute + AlarmList::kShelvingMsMax);
    QVERIFY(list.unshelve(number, "anna", kMinute) && !list.unshelve(number, "anna", kMinute));
    QVERIFY(!list.shelve(number + 1, 2 * kMinute, "anna", kMinute));
    QCOMPARE(printEvents(list), QString("raised shelved shelving-expired shelved unshelved"));
  }

  void anAlarmOfYesterdayIsNotForgotten() {
    AlarmList list;
    Alarm alarm;
    alarm.code = Code::WrongMotion;
    alarm.arguments = {"a.nc", "3", "1"};
    list.restore(alarm);
    QCOMPARE(print(list), QString("wrong-motion returned-unacknowledged"));
    QVERIFY(list.takeTransitions().empty());
    list.acknowledgeAll("anna", 1);
    QVERIFY(list.alarms().empty());
  }

  void theListIsBounded() {
    AlarmList list;
    for (std::size_t i = 0; i < AlarmList::kAlarmsMax + 10; ++i) {
      list.raise(Code::ControlAlarm, {std::to_string(i)}, static_cast<UtcMs>(i));
    }
    QCOMPARE(list.alarms().size(), AlarmList::kAlarmsMax);
  }

  void namesAndSentences() {
    QSet<QString> names;
    for (const Facts& facts : allFacts()) {
      QCOMPARE(codeOfName(facts.name), std::optional(facts.code));
      // Where the remedy is left to the error, so is the cause.
      QVERIFY(*facts.text != '\0' && (*facts.remedy != '\0' || *facts.cause == '\0'));
      names.insert(QString::fromUtf8(facts.name));
    }
    QCOMPARE(names.size(), static_cast<qsizetype>(allFacts().size()));
    QVERIFY(!codeOfName("no-such-alarm"));
    Alarm alarm;
    alarm.code = Code::WrongMotion;
    alarm.arguments = {"a.nc", "3", "1"};
    QVERIFY(describe(alarm).starts_with("Wrong motion in a.nc (points repeated: 3, skipped: 1)."));
  }
};

RIVULET_TEST(TestAlarmList)
#include "tst_alarm_list.moc"
