// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include "opcua/error.h"
#include "opcua/trace_parts.h"
#include "support/test_program.h"
#include "trace/control_trace.h"

using namespace rivulet;

class TestTraceParts : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void partsAreJoined() {
    trace::ControlTrace trace;
    trace.cycle = std::chrono::milliseconds{4};
    trace.samples.resize(9000);
    const std::string text = trace::printControlTrace(trace);
    constexpr std::size_t kPart = 70'000;
    QVERIFY(text.size() > kPart);
    const auto joined = opcua::joinTrace([&text](std::uint64_t from) {
      return opcua::TracePart{text.substr(from, kPart), text.size()};
    });
    QVERIFY(joined.has_value());
    QCOMPARE(joined->samples.size(), trace.samples.size());
  }

  /// A server that sends byte by byte would keep the client busy for days.
  void tinyPartsAreRefused() {
    int calls = 0;
    const auto joined = opcua::joinTrace([&calls](std::uint64_t) {
      ++calls;
      return opcua::TracePart{calls > 1000 ? std::string() : "x", 1'000'000'000};
    });
    QVERIFY(!joined && joined.error().code == opcua::LinkError::Rejected);
    QCOMPARE(calls, 1);
  }
};

RIVULET_TEST(TestTraceParts)
#include "tst_trace_parts.moc"
