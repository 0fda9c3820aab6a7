// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include "streaming/method.h"
#include "support/test_program.h"

using namespace rivulet;
using base::MethodKind;
using namespace std::chrono_literals;

namespace {

streaming::MethodSetup setup(MethodKind method) {
  streaming::MethodSetup setup;
  for (int i = 0; i < 40; ++i) {
    setup.points.push_back({{50.0 * (i + 1), 0.0, 0.0}, base::LineNumber{}});
  }
  setup.settings.parameters.method = method;
  setup.settings.feedMmPerS = 10.0;
  setup.cells = *templates::planCells(setup.settings.parameters);
  return setup;
}

}  // namespace

class TestMethods : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// What is due has no slack: a read for the display before a refill makes it late.
  void refillIsNeededAtOnce() {
    for (const MethodKind kind : base::kPaperMethods) {
      const auto method = streaming::makeMethod(setup(kind));
      base::Instant now{};
      for (int begin = 0; begin < 2; ++begin) {  // fill, run
        QVERIFY(method->poll(now)->kind == streaming::Action::Kind::Write);
        method->handle({now, now, {}}, now);
      }
      QVERIFY(method->poll(now)->kind == streaming::Action::Kind::Read);
      std::vector<opcua::Reading> readings(kind == MethodKind::Position ? 3 : 1);
      // At the first point, or: the first window has been passed.
      readings[0].number = kind == MethodKind::Position ? 50.0 : 0.0;
      now += 5ms;
      method->handle({now - 5ms, now, readings}, now);
      QVERIFY(method->progress().executed > 0);
      QVERIFY(method->progress().nextEarliest <= now);
      QVERIFY(method->poll(now)->kind == streaming::Action::Kind::Write);
      now += 20ms;
      method->handle({now - 20ms, now, {}}, now);
      // The next point is 50 mm away at 10 mm/s.
      QVERIFY(method->progress().nextEarliest > now + 1s);
    }
  }
};

RIVULET_TEST(TestMethods)
#include "tst_methods.moc"
