// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <cmath>
#include <limits>

#include "base/random.h"
#include "support/test_program.h"
#include "trace/control_trace.h"

using namespace rivulet::trace;
using rivulet::base::Duration;
using rivulet::base::Instant;
using rivulet::base::Random;
using rivulet::base::Vec3;

namespace {

ControlTrace smallTrace() {
  ControlTrace trace;
  trace.cycle = Duration{4'000'000};
  trace.samples = {{Instant{Duration{0}}, {0.1, -0.2, 1e-9}, {0.05, 0.0, -0.0}, 8.25, {3}},
                   {Instant{Duration{4'000'000}}, {1.0 / 3.0, 2e17, 3}, {4, 5, 6}, 0.0, {4}}};
  trace.blocks = {{Instant{Duration{-5}}, Instant{Duration{7}}, {12}, {1, 2, 3}, 0.5}};
  return trace;
}

std::error_code errorOf(const std::string& text) {
  const auto trace = parseControlTrace(text);
  return trace ? std::error_code{} : trace.error().code;
}

}  // namespace

class TestControlTrace : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void printsTheDocumentedLines() {
    QCOMPARE(printControlTrace(smallTrace()),
             std::string("rivulet-control-trace 1 cycle_ns=4000000\n"
                         "s 0 0.1 -0.2 1e-09 0.05 0 -0 8.25 3\n"
                         "s 4000000 0.3333333333333333 2e+17 3 4 5 6 0 4\n"
                         "b -5 7 12 1 2 3 0.5\n"
                         "end samples=2 blocks=1 truncated=0\n"));
  }

  void readsBackToTheBit() {
    Random random(1);
    ControlTrace trace = smallTrace();
    trace.truncated = true;
    for (int i = 0; i < 1000; ++i) {
      const Vec3 odd{random.normal() * 1e3, std::ldexp(random.uniform(), -900), -random.uniform()};
      trace.samples.push_back({Instant{Duration{i}}, odd, {0, 0, 0}, 1e-300, {4294967295U}});
    }
    const auto back = parseControlTrace(printControlTrace(trace));
    QVERIFY(back);
    QCOMPARE(back->cycle, trace.cycle);
    QVERIFY(back->truncated);
    QCOMPARE(back->samples.size(), trace.samples.size());
    QCOMPARE(back->blocks.size(), trace.blocks.size());
    for (std::size_t i = 0; i < trace.samples.size(); ++i) {
      QVERIFY(back->samples[i].commandMm == trace.samples[i].commandMm);
      QVERIFY(back->samples[i].actualMm == trace.samples[i].actualMm);
      QVERIFY(back->samples[i].at == trace.samples[i].at);
      QVERIFY(back->samples[i].line == trace.samples[i].line);
    }
    QVERIFY(std::signbit(back->samples[0].actualMm.z));
    QVERIFY(back->blocks[0].from == trace.blocks[0].from);
    QVERIFY(back->blocks[0].to == trace.blocks[0].to);
    QVERIFY(back->blocks[0].targetMm == trace.blocks[0].targetMm);
    QVERIFY(back->blocks[0].line == trace.blocks[0].line);
    QVERIFY(back->blocks[0].lengthMm == 0.5);
  }

  /// Format 3: what the machine did besides moving.
  void eventsAreKept() {
    ControlTrace trace = smallTrace();
    using Kind = ControlEvent::Kind;
    for (const Kind kind : {Kind::ToolChange, Kind::Edge, Kind::WorkOffset, Kind::Spindle,
                            Kind::Coolant, Kind::Dwell, Kind::Stop}) {
      trace.events.push_back(
          {Instant{Duration{1}}, Instant{Duration{2}}, {7}, kind, -0.1, "MILL \"10\""});
    }
    const std::string text = printControlTrace(trace);
    QVERIFY(text.starts_with("rivulet-control-trace 3 "));
    QVERIFY(text.find("e 1 2 7 tool -0.1 \"MILL \\\"10\\\"\"\n") != std::string::npos);
    const auto back = parseControlTrace(text);
    QVERIFY(back);
    QCOMPARE(back->events.size(), std::size_t{7});
    for (std::size_t i = 0; i < back->events.size(); ++i) {
      const ControlEvent& event = back->events[i];
      QVERIFY(event.kind == trace.events[i].kind && event.value == -0.1 &&
              event.from == trace.events[i].from && event.to == trace.events[i].to &&
              event.line == trace.events[i].line && event.name == trace.events[i].name);
    }
    std::string damaged = text;
    damaged.replace(damaged.find(" tool "), 6, " tools ");
    QVERIFY(errorOf(damaged) == TraceError::Damaged);
    damaged = text;
    damaged.replace(damaged.find("events=7"), 8, "events=6");
    QVERIFY(errorOf(damaged) == TraceError::Damaged);
  }

  void keepsWhatIsNoNumber() {
    ControlTrace trace = smallTrace();
    trace.samples[0].feedMmPerS = -std::numeric_limits<double>::quiet_NaN();
    trace.samples[1].feedMmPerS = std::numeric_limits<double>::infinity();
    const auto back = parseControlTrace(printControlTrace(trace));
    QVERIFY(back);
    QVERIFY(std::isnan(back->samples[0].feedMmPerS));
    QVERIFY(std::isinf(back->samples[1].feedMmPerS));
  }

  void readsWhatAnEditorMadeOfIt() {
    std::string text = printControlTrace(smallTrace());
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) {
      text.insert(at, 1, '\r');
    }
    QVERIFY(parseControlTrace(text + "\r\n"));
  }

  void refusesOtherAndNewerFiles() {
    QVERIFY(errorOf("") == TraceError::NotATrace);
    QVERIFY(errorOf("G1 X0\n") == TraceError::NotATrace);
    QVERIFY(errorOf("rivulet-control-trace\n") == TraceError::NotATrace);
    QVERIFY(errorOf("rivulet-control-trace one\n") == TraceError::NotATrace);
    QVERIFY(errorOf("rivulet-control-trace 0\n") == TraceError::NotATrace);
    QVERIFY(errorOf("rivulet-control-trace 4 anything\n") == TraceError::NewerVersion);
  }

  void namesTheDamagedLine_data() {
    QTest::addColumn<std::string>("from");
    QTest::addColumn<std::string>("to");
    QTest::addColumn<int>("line");
    using S = std::string;
    QTest::newRow("number") << S("1e-09") << S("1e-0x") << 2;
    QTest::newRow("field missing") << S(" 8.25 3") << S(" 8.25") << 2;
    QTest::newRow("field too many") << S(" 8.25 3") << S(" 8.25 3 9") << 2;
    QTest::newRow("negative line") << S("8.25 3") << S("8.25 -3") << 2;
    QTest::newRow("time with a fraction") << S("s 4000000") << S("s 4000000.5") << 3;
    QTest::newRow("block") << S("b -5 7") << S("b -5") << 4;
    QTest::newRow("keyword") << S("b -5") << S("q -5") << 4;
    QTest::newRow("count of samples") << S("samples=2") << S("samples=3") << 5;
    QTest::newRow("count of blocks") << S("blocks=1") << S("blocks=0") << 5;
    QTest::newRow("end line") << S("blocks=1") << S("blocks") << 5;
    QTest::newRow("after the end") << S("truncated=0\n") << S("truncated=0\ns\n") << 6;
    QTest::newRow("cycle") << S("cycle_ns=4000000") << S("cycle_ns=-1") << 1;
    QTest::newRow("header field") << S("cycle_ns=4000000") << S("cycle_ns= 4") << 1;
    QTest::newRow("no end line") << S("end samples=2 blocks=1 truncated=0\n") << S("") << 4;
  }

  void namesTheDamagedLine() {
    QFETCH(std::string, from);
    QFETCH(std::string, to);
    QFETCH(int, line);
    std::string text = printControlTrace(smallTrace());
    const std::size_t at = text.find(from);
    QVERIFY(at != std::string::npos);
    text.replace(at, from.size(), to);
    const auto trace = parseControlTrace(text);
    QVERIFY(!trace);
    QVERIFY(trace.error().code == TraceError::Damaged);
    const std::string wanted = "line " + std::to_string(line) + ":";
    QVERIFY2(trace.error().message.find(wanted) != std::string::npos,
             trace.error().message.c_str());
  }

  void noticesEveryCut() {
    const std::string text = printControlTrace(smallTrace());
    for (std::size_t length = 0; length < text.size(); ++length) {
      QVERIFY2(!parseControlTrace(text.substr(0, length)), std::to_string(length).c_str());
    }
    QVERIFY(parseControlTrace(text));
  }
};

RIVULET_TEST(TestControlTrace)
#include "tst_control_trace.moc"
