// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What all reachable markings have in common, on nets small enough to count by hand and on [P3]'s.

#include <QXmlStreamReader>
#include <QtTest>

#include "petri/export.h"
#include "petri/net_file.h"
#include "petri/simulator.h"
#include "petri/state_space.h"
#include "support/test_program.h"

using namespace rivulet;

namespace {

petri::Net parsed(const std::string& text, const petri::ParameterValues& parameters = {}) {
  auto net = petri::parseNet("name = \"n\"\ntime_unit = \"ms\"\ntop = \"Top\"\n" + text, "test",
                             parameters);
  if (!net) {
    qFatal("%s", net.error().text().c_str());
  }
  return std::move(*net);
}

petri::Net p3(petri::Word policy, petri::Word processors, petri::Word lines = -1) {
  auto net = petri::loadNet(
      "p3", {{"policy", policy}, {"processors", processors}, {"capacity", 1}, {"lines", lines}});
  if (!net) {
    qFatal("%s", net.error().text().c_str());
  }
  return std::move(*net);
}

}  // namespace

class TestStateSpace : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aBufferHasOneMarkingPerLevel() {
    const petri::Net net = parsed(R"net(
[parameters]
capacity = 5
[pages.Top.places]
B = { colour = "INT", initial = "0" }
[pages.Top.transitions.put]
in = { B = "b" }
guard = "b < capacity"
out = { B = "b + 1 @+ 3" }
[pages.Top.transitions.take]
in = { B = "b" }
guard = "b > 0"
out = { B = "b - 1 @+ 4" }
[pages.Top.transitions.never]
in = { B = "b" }
guard = "b > capacity"
)net");
    const auto space = petri::exploreStates(net);
    QVERIFY(space.has_value());
    QCOMPARE(space->states, std::size_t(6));
    QCOMPARE(space->firings, std::size_t(10));
    QCOMPARE(space->bounds[0].valueMax, petri::Word(5));
    QCOMPARE(space->deadlocks, std::size_t(0));
    QCOMPARE(space->fired[net.transitionOf("Top.never")], std::uint64_t(0));
    QVERIFY(space->fired[net.transitionOf("Top.put")] > 0);
  }

  void deadlocksAndViolationsAreFound() {
    // Two tasks that take two forks in opposite order.
    const petri::Net net = parsed(R"net(
[invariants]
one_fork = 'tokens(Top.fork1) + tokens(Top.fork2) > 0'
[pages.Top.places]
fork1 = { colour = "UNIT", initial = "()" }
fork2 = { colour = "UNIT", initial = "()" }
left = { colour = "UNIT" }
right = { colour = "UNIT" }
[pages.Top.transitions.left1]
in = { fork1 = "()" }
out = { left = "()" }
[pages.Top.transitions.left2]
in = { fork2 = "()", left = "()" }
out = { fork1 = "()", fork2 = "()" }
[pages.Top.transitions.right1]
in = { fork2 = "()" }
out = { right = "()" }
[pages.Top.transitions.right2]
in = { fork1 = "()", right = "()" }
out = { fork1 = "()", fork2 = "()" }
)net");
    const auto space = petri::exploreStates(net);
    QCOMPARE(space->states, std::size_t(4));
    QCOMPARE(space->deadlocks, std::size_t(1));
    QCOMPARE(space->deadlock, std::string("Top.left: (); Top.right: ()"));
    QCOMPARE(space->violated, std::vector<std::string>{"one_fork"});
  }

  void aNetWithoutBoundIsRefused() {
    const petri::Net net = parsed(R"net(
[pages.Top.places]
n = { colour = "INT", initial = "0" }
[pages.Top.transitions.count]
in = { n = "i" }
out = { n = "i + 1" }
)net");
    const auto space = petri::exploreStates(net, {.statesMax = 1000});
    QVERIFY(!space.has_value());
    QVERIFY(space.error().message.find("More than 1000 markings are reachable") == 0);
  }

  void p3IsBoundedAndNeverStops_data() {
    QTest::addColumn<int>("policy");
    QTest::addColumn<int>("processors");
    QTest::newRow("task dependency, 1 processor") << 0 << 1;
    QTest::newRow("data flow, 1 processor") << 1 << 1;
    QTest::newRow("data flow, 2 processors") << 1 << 2;
  }

  void p3IsBoundedAndNeverStops() {
    QFETCH(const int, policy);
    QFETCH(const int, processors);
    const petri::Net net = p3(policy, processors);
    const auto space = petri::exploreStates(net, {.statesMax = 300'000});
    QVERIFY2(space.has_value(), space ? "" : space.error().message.c_str());
    qInfo("%zu markings, %zu firings", space->states, space->firings);
    for (const char* buffer : {"B1", "B2", "B3", "B4", "B5"}) {
      const petri::PlaceBounds& bounds = space->bounds[net.placeOf(buffer)];
      QCOMPARE(bounds.valueMin, petri::Word(0));
      QCOMPARE(bounds.valueMax, petri::Word(1));
      QCOMPARE(bounds.tokensMax, std::size_t(1));
    }
    QCOMPARE(space->bounds[net.placeOf("Top.SCHED.Running")].tokensMax, std::size_t(processors));
    QCOMPARE(space->deadlocks, std::size_t(0));
    for (std::size_t i = 0; i < net.transitions.size(); ++i) {
      QVERIFY2(space->fired[i] > 0, net.transitions[i].name.c_str());
    }
    QVERIFY2(space->violated.empty(), space->violated.empty() ? "" : space->violated[0].c_str());
  }

  void everyTimedMarkingIsInTheStateSpace() {
    // The bounds of a timed run lie within those of the state space, with more lines than capacity.
    const petri::Net net = p3(1, 2, 3);
    const auto space = petri::exploreStates(net);
    QVERIFY(space.has_value());
    QCOMPARE(space->deadlocks, std::size_t(1));  // the end of the program
    petri::Simulator simulator(net);
    while (simulator.step()) {
      for (std::size_t place = 0; place < net.places.size(); ++place) {
        const std::size_t tokens = simulator.marking()[place].size();
        QVERIFY(tokens >= space->bounds[place].tokensMin);
        QVERIFY(tokens <= space->bounds[place].tokensMax);
      }
    }
    for (std::size_t i = 0; i < net.transitions.size(); ++i) {
      QVERIFY2(simulator.counts()[i] == 0 || space->fired[i] > 0, net.transitions[i].name.c_str());
    }
  }

  void exportsAreComplete() {
    const petri::Net net = p3(0, 2);
    QXmlStreamReader xml(QString::fromStdString(petri::pnmlOf(net)));
    std::size_t places = 0;
    std::size_t transitions = 0;
    while (!xml.atEnd()) {
      if (xml.readNext() == QXmlStreamReader::StartElement) {
        places += xml.name() == QStringLiteral("place") ? 1 : 0;
        transitions += xml.name() == QStringLiteral("transition") ? 1 : 0;
      }
    }
    QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
    QCOMPARE(places, net.places.size());
    QCOMPARE(transitions, net.transitions.size());
    const QString dot = QString::fromStdString(petri::graphvizOf(net));
    QVERIFY(dot.contains(QStringLiteral("label=\"Top.SCHED\"")));
    QCOMPARE(dot.count(QStringLiteral("shape=box")), static_cast<int>(net.transitions.size()));
  }
};

RIVULET_TEST(TestStateSpace)
#include "tst_state_space.moc"
