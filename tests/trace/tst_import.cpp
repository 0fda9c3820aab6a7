// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "imported_text.h"
#include "support/test_program.h"
#include "trace/import/clock_text.h"
#include "trace/import/compression.h"
#include "trace/import/import.h"
#include "trace/import/import_error.h"
#include "trace/import/text_blocks.h"
#include "trace/motion.h"
#include "trace/trace.h"

using namespace rivulet;
using namespace rivulet::trace;
using tests::imported;
using tests::remarks;
using tests::roles;

class TestImport : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void readsAnyLayout_data();
  void readsAnyLayout();
  void guessesRoles_data();
  void guessesRoles();
  void obeysTheMapping();
  void refusesAWrongMapping();
  void printsAndParsesMappings();
  void previewsTables();
  void keepsWhatCanBeRead();
  void keepsALastColumnThatIsMostlyEmpty();
  void readsClocks_data();
  void readsClocks();
  void readsTimesOfAllKinds_data();
  void readsTimesOfAllKinds();
  void knowsTheOrderOfDates();
  void passesOverRowsOfText_data();
  void passesOverRowsOfText();
  void combinesSparseRows();
  void sortsRowsInDisorder();
  void beginsASectionWhereTimeStartsAgain();
  void leavesOutTimeThatRunsBackwards();
  void namesDuplicateColumns();
  void readsTwoTimeBases();
  void readsHalsampler();
  void readsTwinCatScope();
  void readsSinumerikXml();
  void readsCompressedFiles();
  void readsLargeTablesBlockByBlock_data();
  void readsLargeTablesBlockByBlock();
  void leavesToOthersWhatIsNoLargeTable();
  void refusesRubbish();
};

void TestImport::readsAnyLayout_data() {
  QTest::addColumn<QByteArray>("text");
  const auto row = [](const char* name, QByteArray text) { QTest::newRow(name) << text; };
  row("csv", "t_s,x_cmd,y_cmd\n0,1.5,-2\n0.004,1.75,-2.5\n0.008,2,-3\n");
  row("crlf", "t_s,x_cmd,y_cmd\r\n0,1.5,-2\r\n0.004,1.75,-2.5\r\n0.008,2,-3\r\n");
  row("tsv", "t_s\tx_cmd\ty_cmd\n0\t1.5\t-2\n0.004\t1.75\t-2.5\n0.008\t2\t-3\n");
  row("comma decimals", "t_s;x_cmd;y_cmd\n0;1,5;-2\n0,004;1,75;-2,5\n0,008;2;-3\n");
  row("comma decimals, tabs", "t_s\tx_cmd\ty_cmd\n0\t1,5\t-2\n0,004\t1,75\t-2,5\n0,008\t2\t-3\n");
  row("quotes", "\"t_s\",\"x_cmd\",\"y_cmd\"\n0,\"1.5\",-2\n0.004,1.75,-2.5\n0.008,2,-3\n");
  row("units in brackets", "t [ms];X cmd [um];Y cmd (mm)\n0;1500;-2\n4;1750;-2.5\n8;2000;-3\n");
  row("row of units", "t;x_cmd;y_cmd\nms;um;mm\n0;1500;-2\n4;1750;-2.5\n8;2000;-3\n");
  row("preamble",
      "exported by somebody\n\nt_s,x_cmd,y_cmd\n0,1.5,-2\n0.004,1.75,-2.5\n0.008,2,-3\n");
  row("separator at the end", "t_s;x_cmd;y_cmd;\n0;1.5;-2;\n0.004;1.75;-2.5;\n0.008;2;-3;\n");
  row("time of day",
      "time,x_cmd,y_cmd\n00:00:00.000,1.5,-2\n00:00:00.004,1.75,-2.5\n00:00:00.008,2,-3\n");
  row("across an hour",
      "time,x_cmd,y_cmd\n13:59:59.996,1.5,-2\n14:00:00.000,1.75,-2.5\n14:00:00.004,2,-3\n");
  row("separators in quotes",
      "\"t_s\",\"x_cmd, first\",\"y_cmd, second\"\n0,1.5,-2\n0.004,1.75,-2.5\n0.008,2,-3\n");
  row("last column nearly empty",
      "t_s,x_cmd,y_cmd,note\n0,1.5,-2,\n0.004,1.75,-2.5,\n0.008,2,-3,\n");
  row("byte order mark", "\xEF\xBB\xBFt_s,x_cmd,y_cmd\n0,1.5,-2\n0.004,1.75,-2.5\n0.008,2,-3\n");
}

void TestImport::readsAnyLayout() {
  QFETCH(QByteArray, text);
  const ImportedTrace trace = imported(text.toStdString());
  QCOMPARE(remarks(trace), std::string());
  QVERIFY(trace.trace.timeBases[0].name.find('t') == 0);  // nothing before it
  const Motion motion = motionOf(trace);
  QCOMPARE(motion.samples.size(), std::size_t{3});
  QVERIFY(motion.hasSet && !motion.hasActual && !motion.hasSpeed);
  QCOMPARE(motion.step, base::Duration{std::chrono::milliseconds{4}});
  QVERIFY(base::distance(motion.samples[1].setMm, {1.75, -2.5, 0.0}) < 1e-9);
  QVERIFY(base::distance(motion.samples[2].setMm, {2.0, -3.0, 0.0}) < 1e-9);
}

void TestImport::guessesRoles_data() {
  QTest::addColumn<QString>("head");
  QTest::addColumn<QString>("expected");
  const auto row = [](const char* head, const char* expected) {
    QTest::newRow(head) << QString(head) << QString(expected);
  };
  row("t_s,x_cmd,x_fb,vx,v_path,v_req,line",
      "time=t_s:s,x_set=x_cmd,x_act=x_fb,x_speed=vx,path_speed=v_path,programmed_feed=v_req,line="
      "line");
  row("Zeit [s],X Soll [mm],X Ist [mm],Schleppabstand X [mm],Satz",
      "time=Zeit [s]:s,x_set=X Soll [mm]:mm,x_act=X Ist [mm]:mm,line=Satz");
  row("__time,/axis1/setpoint,/axis2/setpoint,/axis1/actual",
      "time=__time:s,x_set=/axis1/setpoint,y_set=/axis2/setpoint,x_act=/axis1/actual");
  row("time,joint.0.pos-cmd,joint.1.pos-cmd,joint.0.f-error,feed override",
      "time=time:s,x_set=joint.0.pos-cmd,y_set=joint.1.pos-cmd,override=feed override");
  row("t_s,Xact,Yact", "time=t_s:s,x_act=Xact,y_act=Yact");
  row("timestamp,ActPosX,SetPosX,x acceleration", "time=timestamp:s,x_set=SetPosX,x_act=ActPosX");
  // What panes and recordings save: formulas are no positions, and names of ours are exact.
  row("t [s],program_line,d(x_act) [mm/s],x_set - x_act [mm],line,x_act [mm]",
      "time=t [s]:s,x_act=x_act [mm]:mm,line=line");
  row("t [s],x [mm/s],y [mm],y cmd [A]", "time=t [s]:s,y_act=y [mm]:mm");
  row("t [s],motion.program-line,x [mm]", "time=t [s]:s,x_act=x [mm]:mm,line=motion.program-line");
}

void TestImport::guessesRoles() {
  QFETCH(QString, head);
  QFETCH(QString, expected);
  std::string text = head.toStdString() + "\n";
  const auto columns = std::count(text.begin(), text.end(), ',');
  for (int i = 0; i < 5; ++i) {
    text += fmt::format("{}", 0.01 * i);
    for (int column = 0; column < columns; ++column) {
      text += fmt::format(",{}", 0.5 * i);
    }
    text += '\n';
  }
  QCOMPARE(QString::fromStdString(roles(imported(text))), expected);
}

void TestImport::obeysTheMapping() {
  const TableMapping options = *parseTableMapping("time=clock:ms,x_set=a:um,y_act=#3");
  const ImportedTrace trace = imported("clock,a,b\n0,1500,-2\n4,1750,-2.5\n", options);
  const Motion motion = motionOf(trace);
  QCOMPARE(motion.step, base::Duration{std::chrono::milliseconds{4}});
  QCOMPARE(motion.samples[1].setMm.x, 1.75);
  QCOMPARE(motion.samples[1].actualMm.y, -2.5);
  QCOMPARE(roles(trace), std::string("time=clock:ms,x_set=a:um,y_act=b"));
}

void TestImport::refusesAWrongMapping() {
  QVERIFY(parseTableMapping("x=a").error().message.find("x_set") != std::string::npos);
  const TableMapping options = *parseTableMapping("x_set=c");
  const auto result = importTrace("t,a,b\n0,1,2\n1,2,3\n", options);
  QCOMPARE(result.error().message,
           std::string("The trace has no column \"c\". Its columns are t, a, b."));
}

/// What the command line takes and what a dialog writes are one text.
void TestImport::printsAndParsesMappings() {
  TableMapping mapping;
  mapping.columns = {{SignalRole::Time, "t", "ms"},
                     {SignalRole::XActual, columnReference("Pos, X", 2), "um"},
                     {SignalRole::Line, columnReference("N", 3), ""}};
  mapping.rateHz = 250.0;
  mapping.offsetS = -1.5;
  mapping.isComplete = true;
  const std::string text = printTableMapping(mapping);
  QCOMPARE(text, std::string("time=t:ms,x_act=#3:um,line=N,rate=250,offset=-1.5,guess=no"));
  QVERIFY(*parseTableMapping(text) == mapping);
  QVERIFY(*parseTableMapping("") == TableMapping{});
  for (const char* wrong : {"rate=0", "rate=x", "offset=", "guess=yes", "x_set="}) {
    QVERIFY2(!parseTableMapping(wrong), wrong);
  }
  const auto twice = parseTableMapping("x_set=a,x_set=b");
  QVERIFY(!twice && twice.error().code == ImportError::RoleTwice);
  QVERIFY(parseTableMapping("time=a,x_set=b,time=c"));  // two time bases
  QCOMPARE(unitsOf(SignalRole::Time).front(), std::string_view("s"));
  QVERIFY(unitsOf(SignalRole::Line).empty());
}

void TestImport::previewsTables() {
  const std::string text = "a;b;c\n0;1;2\n10;3;4\n20;5;6\n";
  const ImportedTrace guessed = imported(text);
  QCOMPARE(guessed.table.columns.size(), std::size_t{3});
  QVERIFY(!guessed.table.isCertain);  // no position
  QCOMPARE(guessed.table.columns[1].name, std::string("b"));
  QVERIFY(!guessed.table.columns[1].role);
  QCOMPARE(guessed.table.columns[1].first, (std::vector<double>{1.0, 3.0, 5.0}));
  const ImportedTrace mapped = imported(text, *parseTableMapping("time=a:ms,x_act=b:um,guess=no"));
  QVERIFY(mapped.table.isCertain);
  QVERIFY(mapped.table.columns[1].role == SignalRole::XActual);
  QCOMPARE(mapped.table.columns[1].unit, std::string("um"));
  // Nothing else is guessed: without a time, the rate counts.
  const ImportedTrace bare = imported("t_s;x_cmd\n0;1\n0.01;2\n0.02;3\n",
                                      *parseTableMapping("x_act=x_cmd,rate=100,guess=no"));
  QCOMPARE(roles(bare), std::string("x_act=x_cmd"));
  QVERIFY(imported("t_s;x_cmd\n0;1\n0.01;2\n0.02;3\n").table.isCertain);
  QVERIFY(!imported("t;x_cmd\n0;1\n4;2\n8;3\n").table.isCertain);  // ms is assumed
}

void TestImport::keepsWhatCanBeRead() {
  const ImportedTrace trace = imported(
      "t_s,x_cmd,y_cmd\n0,1,2\n0.001,1,2\n*** overrun ***\n0.002,1,error\n0.003,,2\n0.004,1");
  QCOMPARE(trace.trace.timeBases[0].at.size(), std::size_t{4});
  QVERIFY(std::isnan(trace.trace.signalList[1].values[2]));
  QVERIFY(std::isnan(trace.trace.signalList[0].values[3]));
  QCOMPARE(remarks(trace),
           std::string("Rows that do not have 3 columns and were left out: 1, the first in line "
                       "4.\nCells that are no numbers and were left empty: 1, the first in line "
                       "5.\n"
                       "The file ends within a row: it was cut off there."));
  QCOMPARE(motionOf(trace).samples.size(), std::size_t{2});
}

void TestImport::keepsALastColumnThatIsMostlyEmpty() {
  std::string text = "t_s,x_cmd,alarm\n";
  for (int i = 0; i < 50; ++i) {
    text += fmt::format("{},{},{}\n", 0.01 * i, 0.5 * i, i == 30 ? "7" : "");
  }
  const ImportedTrace trace = imported(text);
  QCOMPARE(remarks(trace), std::string());
  QCOMPARE(trace.trace.signalList.size(), std::size_t{2});
  const Signal& alarm = trace.trace.signalList[1];
  QCOMPARE(alarm.name, std::string("alarm"));
  QCOMPARE(alarm.values.size(), std::size_t{50});
  QVERIFY(std::isnan(alarm.values[29]) && alarm.values[30] == 7.0);
  // Without a heading, a value tells.
  const ImportedTrace bare = imported(text.substr(text.find('\n') + 1));
  QCOMPARE(bare.trace.signalList.size(), std::size_t{2});
}

void TestImport::readsClocks_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<double>("seconds");  // < 0: it is no clock
  const auto row = [](const char* text, double seconds) {
    QTest::newRow(text) << QByteArray(text) << seconds;
  };
  constexpr double kNewYear = 1767225600.0;  // 2026-01-01, UTC, as `date -u +%s` says
  constexpr double kAfternoon = 15 * 3600.0 + 4 * 60.0 + 5.25;
  row("2026-01-01T15:04:05.25Z", kNewYear + kAfternoon);
  row("2026-01-01 15:04:05,25", kNewYear + kAfternoon);
  row("2026/01/01 15:04:05.25", kNewYear + kAfternoon);
  row("2026-01-01T17:04:05.25+02:00", kNewYear + kAfternoon);
  row("2026-01-01T09:34:05.25-0530", kNewYear + kAfternoon);
  row("2026-01-01T16:04:05.25+01", kNewYear + kAfternoon);
  row("1.1.2026 15:04:05.250", kNewYear + kAfternoon);
  row("01/01/2026 3:04:05.25 PM", kNewYear + kAfternoon);
  row("01/01/2026 12:04:05.25 a.m.", kNewYear + kAfternoon - 15 * 3600.0);
  row("01/01/2026 12:04:05.25 PM", kNewYear + kAfternoon - 3 * 3600.0);
  row("2026-01-01", kNewYear);
  row("01.01.2026", kNewYear);
  row("15:04:05:250", kAfternoon);
  row("3:04:05.25 pm", kAfternoon);
  row("00:00:00", 0.0);
  for (const char* wrong :
       {"13:04:05 PM", "25:00:00", "10:60:00", "2026-13-01", "1.2.3", "12:30", "10:00:00+x",
        "2026-01-01X10:00:00", "01-02-03 10:00:00", "10:00:00.", "PM"}) {
    row(wrong, -1.0);
  }
}

void TestImport::readsClocks() {
  QFETCH(QByteArray, text);
  QFETCH(double, seconds);
  const auto clock = parseClock(text.toStdString(), DateOrder::DayFirst);
  QCOMPARE(clock.has_value(), seconds >= 0.0);
  QVERIFY(!clock || std::abs(clock->seconds - seconds) < 1e-6);
}

/// Four samples, 10 ms apart, over what each kind of clock has: midnight, noon.
void TestImport::readsTimesOfAllKinds_data() {
  QTest::addColumn<QByteArray>("text");
  const auto row = [](const char* name, QByteArray text) { QTest::newRow(name) << text; };
  row("date and time in two columns",
      "Date,Time,x_act\n31.12.2025,23:59:59.980,0\n31.12.2025,23:59:59.990,1\n01.01.2026,00:00:00."
      "000,2\n"
      "01.01.2026,00:00:00.010,3\n");
  row("the date once",
      "Uhrzeit;Datum;x_act\n23:59:59.970;31.12.2025;0\n23:59:59.980;;1\n23:59:59.990;;2\n00:00:00."
      "000;01.01.2026;3\n");
  row("no date", "clock;x_act\n23:59:59.980;0\n23:59:59.990;1\n00:00:00.000;2\n00:00:00.010;3\n");
  row("offset",
      "timestamp,x_act\n2025-04-24T10:00:00.000+02:00,0\n2025-04-24T10:00:00.010+02:00,1\n"
      "2025-04-24T08:00:00.020Z,2\n2025-04-24T10:00:00.030+02:00,3\n");
  row("am and pm",
      "Time,x_act\n12/31/2025 11:59:59.980 PM,0\n12/31/2025 11:59:59.990 PM,1\n"
      "01/01/2026 12:00:00.000 AM,2\n01/01/2026 12:00:00.010 AM,3\n");
  row("month first",
      "Time,x_act\n01/31/2026 23:59:59.980,0\n01/31/2026 23:59:59.990,1\n"
      "02/01/2026 00:00:00.000,2\n02/01/2026 00:00:00.010,3\n");
  row("FILETIME",
      "Timestamp;x_act\n133869456000000000;0\n133869456000100000;1\n133869456000200000;2\n"
      "133869456000300000;3\n");
  row("ms since 1970",
      "Timestamp;x_act\n1745488800000;0\n1745488800010;1\n1745488800020;2\n1745488800030;3\n");
  row("ns since 1970",
      "Timestamp;x_act\n1745488800000000000;0\n1745488800010000000;1\n1745488800020000000;2\n"
      "1745488800030000000;3\n");
  row("TwinCAT Scope, full times",
      "Name\tProject\n\nName\tAxis.ActPosX\nSampleTime[ms]\t10\nUnit\tmm\n\n133869456000000000\t0\n"
      "133869456000100000\t1\n133869456000200000\t2\n133869456000300000\t3\n");
  row("line break in a heading", "\"t, s\",\"X, actual\n(mm)\"\n0,0\n0.01,1\n0.02,2\n0.03,3\n");
}

void TestImport::readsTimesOfAllKinds() {
  QFETCH(QByteArray, text);
  const ImportedTrace trace = imported(text.toStdString());
  QCOMPARE(remarks(trace), std::string());
  const Motion motion = motionOf(trace);
  QCOMPARE(motion.samples.size(), std::size_t{4});
  for (std::size_t i = 0; i < 4; ++i) {
    const double seconds = base::toSeconds(motion.samples[i].at - motion.samples[0].at);
    QVERIFY2(std::abs(seconds - 0.01 * static_cast<double>(i)) < 1e-5,
             qPrintable(QString::number(seconds)));
    QCOMPARE(motion.samples[i].actualMm.x, static_cast<double>(i));
  }
}

/// What no date says is assumed, and said.
void TestImport::knowsTheOrderOfDates() {
  QVERIFY(dateOrderOf("13/01/2026") == DateOrder::DayFirst);
  QVERIFY(dateOrderOf("01/13/2026 10:00:00") == DateOrder::MonthFirst);
  QVERIFY(dateOrderOf("01/02/2026 10:00:00 pm") == DateOrder::MonthFirst);
  QVERIFY(!dateOrderOf("01/02/2026 10:00:00") && !dateOrderOf("2026/01/13"));
  const ImportedTrace trace =
      imported("Time,x_act\n01/02/2026 10:00:00,1\n01/02/2026 10:00:01,2\n01/02/2026 10:00:02,3\n");
  QVERIFY(trace.trace.remarks.back().code == RemarkCode::DayFirstAssumed);
}

void TestImport::passesOverRowsOfText_data() {
  QTest::addColumn<QByteArray>("rows");
  QTest::addColumn<QByteArray>("expected");
  const QByteArray first =
      "Rows of text that hold no values and were left out: 1, the first in line 2.";
  QTest::newRow("no values yet") << QByteArray(
                                        "n/a,UNAVAILABLE,UNAVAILABLE\n0,1,2\n0.1,1,2\n0.2,1,2\n")
                                 << first;
  QTest::newRow("only a time") << QByteArray(
                                      "-0.1,UNAVAILABLE,UNAVAILABLE\n0,1,2\n0.1,1,2\n0.2,1,2\n")
                               << first;
  QTest::newRow("the heading again") << QByteArray("0,1,2\nt_s,x_act,y_act\n0.1,1,2\n0.2,1,2\n")
                                     << QByteArray(first).replace("line 2", "line 3");
}

void TestImport::passesOverRowsOfText() {
  QFETCH(QByteArray, rows);
  QFETCH(QByteArray, expected);
  const ImportedTrace trace = imported("t_s,x_act,y_act\n" + rows.toStdString());
  QCOMPARE(roles(trace), std::string("time=t_s:s,x_act=x_act,y_act=y_act"));
  QCOMPARE(QByteArray::fromStdString(remarks(trace)), expected);
  QCOMPARE(motionOf(trace).samples.size(), std::size_t{3});
}

/// Each signal in rows of its own; Z only once.
void TestImport::combinesSparseRows() {
  const ImportedTrace trace = imported(
      "t_s,x_act,y_act,z_act\n0,0,,\n0.01,,10,\n0.02,,,5\n0.1,1,,\n0.11,,11,\n0.2,2,,\n0.21,,12,"
      "\n0.3,3,,\n0.31,,13,\n");
  const Motion motion = motionOf(trace);
  QCOMPARE(motion.samples.size(), std::size_t{4});
  QVERIFY(base::distance(motion.samples[0].actualMm, {0.0, 10.0, 5.0}) < 1e-9);
  QVERIFY(base::distance(motion.samples[1].actualMm, {1.0, 10.9, 5.0}) < 1e-9);
  QVERIFY(base::distance(motion.samples[3].actualMm, {3.0, 12.9, 5.0}) < 1e-9);
  QVERIFY(trace.trace.remarks.back().code == RemarkCode::SparseRows);
}

void TestImport::sortsRowsInDisorder() {
  std::string text = "t_s,x_act\n";
  for (int i = 0; i < 100; ++i) {
    const int row =
        i >= 40 && i < 60 ? 99 - i : i;  // 40 to 59 the other way round, as two threads write
    text += fmt::format("{:.2f},{}\n",
                        0.01 * (i >= 20 && i < 40   ? i + 20
                                : i >= 40 && i < 60 ? i - 20
                                                    : i),
                        row);
  }
  const ImportedTrace trace = imported(text);
  QCOMPARE(remarks(trace), std::string("The rows are not in the order of their time \"t_s\", the "
                                       "first at row 41: they were sorted."));
  QCOMPARE(trace.trace.timeBases[0].at.size(), std::size_t{100});
  QVERIFY(trace.trace.sections.empty());
}

/// A recorder that was started again: nothing is left out, and no motion invented between both.
void TestImport::beginsASectionWhereTimeStartsAgain() {
  std::string text = "t_s,x_act\n";
  for (const auto& [count, from] :
       {std::pair{30, 0.0}, std::pair{50, 100.0}, std::pair{20, -70.0}}) {
    for (int i = 0; i < count; ++i) {
      text += fmt::format("{:.2f},{}\n", 0.01 * i, from + 0.1 * i);
    }
  }
  const ImportedTrace trace = imported(text);
  QCOMPARE(trace.trace.sections.size(), std::size_t{2});
  QCOMPARE(trace.trace.timeBases[0].at.size(), std::size_t{100});
  QCOMPARE(remarks(trace), std::string("The time \"t_s\" starts again, the first time at row 31. 3 "
                                       "sections are shown 1 s apart, "
                                       "and the longest one is analysed."));
  const Motion motion = motionOf(trace);
  QCOMPARE(motion.samples.size(), std::size_t{50});
  QCOMPARE(motion.samples[0].actualMm.x, 100.0);
  QVERIFY(std::abs(base::toSeconds(motion.samples[0].at - trace.trace.timeBases[0].at[0]) - 1.29) <
          1e-9);
}

/// A clock that runs unevenly is no recorder that was started again.
void TestImport::leavesOutTimeThatRunsBackwards() {
  std::string text = "t_s,x_act\n";
  for (int i = 0; i < 1000; ++i) {
    text += fmt::format("{:.3f},{}\n", 0.01 * i - (i % 40 == 39 ? 0.012 : 0.0), i);
  }
  const ImportedTrace trace = imported(text);
  QCOMPARE(remarks(trace), std::string("The time \"t_s\" runs backwards at row 40. Rows that were "
                                       "left out until it goes on: 25."));
  QCOMPARE(trace.trace.timeBases[0].at.size(), std::size_t{975});
}

void TestImport::namesDuplicateColumns() {
  const ImportedTrace trace = imported("t_s,x_cmd,x_cmd\n0,1,5\n0.1,2,6\n0.2,3,7\n");
  QCOMPARE(trace.trace.signalList[1].name, std::string("x_cmd (2)"));
  QCOMPARE(remarks(trace), std::string("The column \"x_cmd\" occurs more than once: this one is "
                                       "called \"x_cmd (2)\"."));
  QCOMPARE(motionOf(trace).samples[2].setMm.x, 3.0);
}

void TestImport::readsTwoTimeBases() {
  const ImportedTrace trace =
      imported("t1_ms,x_cmd,t2_ms,y_cmd\n0,0,0,0\n10,1,20,4\n20,2,40,8\n30,3,60,12\n40,4,80,16\n");
  QCOMPARE(trace.trace.timeBases.size(), std::size_t{2});
  const Motion motion = motionOf(trace);
  QCOMPARE(motion.samples.size(), std::size_t{5});
  QVERIFY(base::distance(motion.samples[1].setMm, {1.0, 2.0, 0.0}) < 1e-9);
  QVERIFY(base::distance(motion.samples[4].setMm, {4.0, 8.0, 0.0}) < 1e-9);
}

void TestImport::readsHalsampler() {
  const TableMapping options = *parseTableMapping("x_set=#2,y_set=#3,rate=500");
  const ImportedTrace trace =
      imported("100 1.5 2\n101 1.6 2\n102 1.7 2\noverrun\n110 1.8 2\n111 1.9 2\n", options);
  const PackedTimes& at = trace.trace.timeBases[0].at;
  QCOMPARE(at.size(), std::size_t{5});
  QCOMPARE(at[3] - at[2], base::Duration{std::chrono::milliseconds{16}});
  QCOMPARE(motionOf(trace).samples[4].setMm.x, 1.9);
}

void TestImport::readsTwinCatScope() {
  const ImportedTrace trace = imported(
      "Name\tScope Project\nFile\tC:\\a.svdx\nStarttime of export\t133238090039920000\tMonday\n"
      "Endtime of export\t133238090049920000\tMonday\n\n"
      "Name\tAxis1.SetPos\tName\tAxis1.ActPos\nData-Type\tREAL64\tData-Type\tREAL64\n"
      "SampleTime[ms]\t2\tSampleTime[ms]\t4\nUnit\tmm\tUnit\tmm\n\n"
      "0\t1,5\t0\t1\n2\t1,6\t4\t2\n4\t1,7\t8\t3\n6\t1,8\t12\t4\n8\t1,9\t16\t5\n");
  QCOMPARE(trace.trace.format, std::string("TwinCAT Scope"));
  QCOMPARE(trace.trace.timeBases.size(), std::size_t{2});
  const Motion motion = motionOf(trace);
  QCOMPARE(motion.step, base::Duration{std::chrono::milliseconds{2}});
  QCOMPARE(motion.samples[1].setMm.x, 1.6);
  QCOMPARE(motion.samples[1].actualMm.x, 1.5);
  // Other versions count the samples.
  const Motion counted = motionOf(
      imported("Name\tScope Project\nFile\tC:\\a.svdx\n\nName\tAxis1.SetPos\nData-Type\tREAL64\n"
               "SampleTime[ms]\t2\nUnit\tmm\n\n0\t1,5\n1\t1,6\n2\t1,7\n3\t1,8\n4\t1,9\n"));
  QCOMPARE(counted.step, base::Duration{std::chrono::milliseconds{2}});
}

void TestImport::readsSinumerikXml() {
  const std::string text =
      "<?xml version=\"1.0\" encoding=\"utf-8\" ?>\n<traceSession version=\"01.00.03.02\">\n"
      "<traceData><dataFrame>\n<frameHeader startTime=\"x\"/>\n"
      "<dataSignal id=\"f1\" key=\"s1\" name=\"/Nck/!SD/a [u1, 1]\" description=\"Position "
      "setpoint "
      "(64 bit)\" interval=\"0.002\" unitsType=\"posn\"/>\n"
      "<dataSignal id=\"f2\" key=\"s2\" name=\"/Nck/!SD/b [u1, 2]\" description=\"Position "
      "setpoint "
      "(64 bit)\" interval=\"0.004\" unitsType=\"posn\"/>\n"
      "<dataSignal id=\"f3\" key=\"s3\" name=\"/Nck/!SD/c [u1, 1]\" description=\"Following "
      "Error\" "
      "unitsType=\"posn\"/>\n"
      "<rec time=\"0\" f1=\"1.5\" f2=\"-3\" f3=\"0.1\"/>\n<rec time=\"0.002\" f1=\"1.6\"/>\n"
      "<rec time=\"0.004\" f1=\"1.7\" f2=\"-4\" f3=\"9221120237041090560\"/>\n"
      "<rec time=\"0.003\" f1=\"9\"/>\n<rec time=\"0.006\" f1=\"1.8\" f2=";
  const ImportedTrace trace = imported(text);
  QCOMPARE(trace.trace.format, std::string("SINUMERIK trace"));
  const PackedValues& values = trace.trace.signalList[0].values;
  QCOMPARE(std::vector<double>(values.begin(), values.end()), (std::vector<double>{1.5, 1.6, 1.7}));
  QVERIFY(remarks(trace).find("runs backwards and that were left out: 1.") != std::string::npos);
  QCOMPARE(trace.trace.signalList[2].values.size(), std::size_t{1});
  const Motion motion = motionOf(trace);
  QCOMPARE(motion.samples.size(), std::size_t{3});
  QVERIFY(base::distance(motion.samples[1].setMm, {1.6, -3.5, 0.0}) < 1e-9);
  QVERIFY(remarks(trace).find("cut off") != std::string::npos);
}

void TestImport::readsCompressedFiles() {
  std::string text = "t_s,x_cmd\n";
  for (int i = 0; i < 50000; ++i) {
    text += fmt::format("{},{}\n", 0.001 * i, 0.5 * i * i);
  }
  const std::string packed = pack(text, 3);
  QCOMPARE(imported(packed).trace.signalList[0].values.size(), std::size_t{50000});
  const ImportedTrace cut = imported(packed.substr(0, packed.size() / 2));
  QVERIFY(cut.trace.signalList[0].values.size() > 1000);
  QVERIFY(remarks(cut).find("cut or damaged") != std::string::npos);
}

namespace {

/// A text as a file that is read where it is asked for.
class BytesOfText final : public base::ByteSource {
 public:
  explicit BytesOfText(std::string_view text) : m_text(text) {}
  [[nodiscard]] std::uint64_t size() const override { return m_text.size(); }
  [[nodiscard]] base::Result<std::string> read(std::uint64_t at, std::uint64_t bytes) override {
    return std::string(m_text.substr(std::min<std::size_t>(at, m_text.size()), bytes));
  }

 private:
  std::string_view m_text;
};

/// The last job first: no order is promised.
class BackwardsExecutor final : public base::Executor {
 public:
  void forEach(std::size_t count, const std::function<void(std::size_t)>& job) override {
    while (count-- > 0) {
      job(count);
    }
  }
};

bool isSameTrace(const SignalTrace& a, const SignalTrace& b) {
  const auto isSame = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
  return std::ranges::equal(a.signalList, b.signalList,
                            [&](const Signal& one, const Signal& other) {
                              return one.name == other.name && one.timeBase == other.timeBase &&
                                     std::ranges::equal(one.values, other.values, isSame);
                            }) &&
         std::ranges::equal(a.timeBases, b.timeBases,
                            [](const TimeBase& one, const TimeBase& other) {
                              return std::ranges::equal(one.at, other.at);
                            });
}

/// Numbers with a few rows that are none, from the first block to the last.
std::string largeTable(const char* separator, const char* sign) {
  std::string text = "\"t\n[s]\"" + std::string(separator) + "x_act" + separator + "y\n";
  for (int i = 0; text.size() < 2 * TextBlocks::kBlockBytes + 100'000; ++i) {
    std::string row = fmt::format("{:.3f}{}{:.5f}{}{}\n", 0.001 * i, separator, std::sin(0.001 * i),
                                  separator, i % 17);
    if (i % 200'000 == 199'999) {
      row = fmt::format("{:.3f}{}UNAVAILABLE{}1\n", 0.001 * i, separator, separator);
    } else if (i % 300'000 == 299'999) {
      row = "UNAVAILABLE" + std::string(separator) + "UNAVAILABLE" + separator + "UNAVAILABLE\n";
    } else if (i % 350'000 == 349'999) {
      row = "1" + std::string(separator) + "2\n";
    }
    std::ranges::replace(row, '.', *sign);
    text += row;
  }
  return text + "1" + separator;  // cut off
}

}  // namespace

void TestImport::readsLargeTablesBlockByBlock_data() {
  QTest::addColumn<QByteArray>("separator");
  QTest::addColumn<QByteArray>("sign");
  QTest::newRow("comma") << QByteArray(",") << QByteArray(".");
  QTest::newRow("tab") << QByteArray("\t") << QByteArray(".");
  QTest::newRow("semicolon, decimal comma") << QByteArray(";") << QByteArray(",");
}

void TestImport::readsLargeTablesBlockByBlock() {
  QFETCH(QByteArray, separator);
  QFETCH(QByteArray, sign);
  const std::string text = "\xEF\xBB\xBF" + largeTable(separator.constData(), sign.constData());
  const ImportedTrace whole = imported(text);
  QVERIFY(whole.trace.signalList.size() == 2 && whole.trace.signalList[0].values.size() > 600'000);
  BytesOfText bytes(text);
  BackwardsExecutor executor;
  const auto blocks = importLargeTable(bytes, {}, {}, &executor);
  QVERIFY(blocks && *blocks);
  QCOMPARE(remarks(**blocks), remarks(whole));
  QCOMPARE(roles(**blocks), roles(whole));
  QVERIFY(isSameTrace((*blocks)->trace, whole.trace));
  for (const char* said : {"350000", "200000", "300000"}) {
    const std::string line = std::to_string(std::stoi(said) + 2);  // the heading has two
    QVERIFY2(remarks(whole).find(line) != std::string::npos, remarks(whole).c_str());
  }
  const auto refused = importLargeTable(bytes, {}, base::Budget(10'000'000), &executor);
  QVERIFY(!refused && refused.error().code == base::BudgetError::Exceeded);
}

void TestImport::leavesToOthersWhatIsNoLargeTable() {
  const std::string table = largeTable(",", ".");
  const auto isLeft = [](std::string text) {
    BytesOfText bytes(text);
    const auto imported = importLargeTable(bytes);
    return imported && !*imported;
  };
  QVERIFY(!isLeft(table));
  QVERIFY(isLeft(table.substr(0, TextBlocks::kBlockBytes)));
  QVERIFY(isLeft(pack(table, 1) + table));
  QVERIFY(isLeft("t,x_act,Spann\xFCng\n" + table));  // Latin-1
  QVERIFY(isLeft(std::string(table.size(), ',')));
  BytesOfText recording("rivulet-recording 1\n");
  QVERIFY(!*readLargeTrace(recording));
  // A line that is longer than a block is read as a whole.
  std::string odd = table;
  odd.insert(table.rfind('\n') + 1, std::string(2 * TextBlocks::kBlockBytes, '7') + "\n");
  BytesOfText bytes(odd);
  const auto read = importLargeTable(bytes);
  QVERIFY(read && *read);
  QVERIFY(isSameTrace((*read)->trace, imported(odd).trace));
}

void TestImport::refusesRubbish() {
  for (const std::string& rubbish :
       {std::string(), std::string("Dear Sir or Madam,\nplease find enclosed\n"),
        std::string("\x7F\x45\x4C\x46\0\1\2\3 1 2 3\n4 5 6\n", 20),
        std::string("<traceSession></traceSession>")}) {
    const auto result = importTrace(rubbish);
    QVERIFY(!result);
    QVERIFY(!result.error().message.empty());
  }
}

RIVULET_TEST(TestImport)
#include "tst_import.moc"
