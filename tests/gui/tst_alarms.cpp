// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What the window says: alarms with their history, and messages in the language of the window.

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "hmi/alarms.h"
#include "hmi/messages.h"
#include "journal/line_file.h"
#include "opcua/error.h"
#include "support/patience.h"
#include "support/test_program.h"
#include "widgets/alarms/alarm_text.h"

using namespace rivulet;
using hmi::Alarms;
using hmi::Messages;

namespace {

using rivulet::tests::kSoonMs;
constexpr base::UtcMs kNoon = 1'795'348'800'000;

/// Alarms in a folder of their own, at a time that the test sets.
struct Cell {
  std::filesystem::path folder;
  base::UtcMs now = kNoon;
  Messages messages{};
  Alarms alarms{messages, folder, [this] { return now; }};
};

std::string only(const Alarms& alarms) {
  std::string text;
  for (const alarm::Alarm& alarm : alarms.list().alarms()) {
    text += (text.empty() ? "" : ", ") + std::string(alarm::factsOf(alarm.code).name) + " " +
            std::string(alarm::stateName(alarm.state()));
  }
  return text;
}

}  // namespace

class TestAlarms : public QObject {
  Q_OBJECT

 private slots:
  void whatIsRaisedIsLogged() {
    Cell cell;
    QList<widgets::LogLine> lines;
    connect(&cell.messages, &Messages::logged, this,
            [&lines](const widgets::LogLine& line) { lines << line; });
    cell.messages.raise(alarm::Code::ConnectionLost, {"cell"},
                        base::makeError(opcua::LinkError::ConnectionLost, "It is gone."));
    QCOMPARE(only(cell.alarms), std::string("connection-lost unacknowledged"));
    QCOMPARE(lines.size(), 1);
    QVERIFY(lines.first().severity == gcode::Severity::Error);
    QVERIFY(lines.first().source == alarm::Source::Connection);
    QVERIFY(lines.first().text().startsWith("The connection to cell is lost. "));
    cell.messages.settle(alarm::Code::ConnectionLost);
    QCOMPARE(only(cell.alarms), std::string("connection-lost returned-unacknowledged"));
    cell.alarms.acknowledgeAll();
    QCOMPARE(only(cell.alarms), std::string());
    QCOMPARE(lines.size(), 1);
  }

  void anotherNumberTakesThePlaceOfAControlAlarm() {
    Cell cell;
    for (const char* number : {"10631", "10631", "27000"}) {
      cell.messages.raise(alarm::Code::ControlAlarm, {number});
    }
    QCOMPARE(only(cell.alarms), std::string("control-alarm unacknowledged, "
                                            "control-alarm returned-unacknowledged"));
    QCOMPARE(cell.alarms.history().size(), std::size_t{3});
  }

  void aShelvedAlarmComesBack() {
    Cell cell;
    QSignalSpy changed(&cell.alarms, &Alarms::changed);
    cell.messages.raise(alarm::Code::FileChanged, {"a.nc"});
    cell.alarms.shelve(cell.alarms.list().alarms().front().number, 10);
    QCOMPARE(only(cell.alarms), std::string("file-changed shelved"));
    changed.clear();
    cell.now += 10 * 60'000;
    QTRY_VERIFY_WITH_TIMEOUT(changed.count() == 1, kSoonMs);
    QCOMPARE(only(cell.alarms), std::string("file-changed unacknowledged"));
  }

  void theHistorySurvivesARestart() {
    const QTemporaryDir folder;
    {
      Cell cell{folder.path().toStdString()};
      cell.alarms.setUser("anna");
      cell.messages.raise(alarm::Code::WrongMotion, {"a.nc", "3", "1"});
      cell.messages.raise(alarm::Code::ConnectionLost, {"cell"},
                          base::makeError(opcua::LinkError::ConnectionLost, "It is gone."));
      cell.alarms.acknowledge(cell.alarms.list().mostImportant()->number);
    }
    Cell cell{folder.path().toStdString()};
    QCOMPARE(cell.alarms.history().size(), std::size_t{3});
    const alarm::Transition& newest = cell.alarms.history().front();
    QVERIFY(newest.event == alarm::Event::Acknowledged && newest.by == "anna");
    QVERIFY(newest.alarm.error.code == opcua::LinkError::ConnectionLost);
    // What nobody has acknowledged is there again; its cause is not known to hold.
    QCOMPARE(only(cell.alarms), std::string("wrong-motion returned-unacknowledged"));
  }

  void aHistoryThatCannotBeWrittenIsAnAlarm() {
    Cell cell{"/proc/rivulet"};
    cell.messages.raise(alarm::Code::FileGone, {"a.nc"});
    QTRY_VERIFY_WITH_TIMEOUT(cell.alarms.list().alarms().size() == 2, kSoonMs);
    QVERIFY(only(cell.alarms).find("alarm-history-unwritten") != std::string::npos);
  }
};

RIVULET_TEST(TestAlarms)
#include "tst_alarms.moc"
