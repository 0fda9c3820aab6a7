// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Small nets whose runs are known by hand, and properties of the net of [P3].

#include <QtTest>

#include "petri/net_file.h"
#include "petri/simulator.h"
#include "support/test_program.h"

using namespace rivulet;

namespace {

constexpr const char* kHead = "name = \"n\"\ntime_unit = \"ms\"\ntop = \"Top\"\n";

petri::Net netOf(const std::string& rest) {
  auto net = petri::parseNet(kHead + rest, "test");
  if (!net) {
    qFatal("%s", net.error().text().c_str());
  }
  return std::move(*net);
}

/// "time:transition" of each firing.
QStringList runOf(const petri::Net& net, petri::Word until, std::uint64_t seed = 0) {
  petri::Simulator simulator(net, seed);
  QStringList run;
  simulator.setWatcher([&](std::size_t transition, petri::Word time) {
    run.append(QStringLiteral("%1:%2").arg(time).arg(
        QString::fromStdString(net.transitions[transition].name).section(u'.', -1)));
  });
  simulator.run(until);
  return run;
}

}  // namespace

class TestPetriSimulator : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void tokensAreReadyAtTheirTime() {
    const petri::Net net = netOf(R"net(
[pages.Top.places]
clock = { colour = "INT", initial = "0" }
ticks = { colour = "INT" }
[pages.Top.transitions.tick]
in = { clock = "n" }
out = { clock = "n + 1 @+ 5", ticks = "n" }
)net");
    QCOMPARE(runOf(net, 12), QStringList({"0:tick", "5:tick", "10:tick"}));
  }

  void priorityDecidesAmongTheEnabled() {
    const petri::Net net = netOf(R"net(
[pages.Top.places]
a = { colour = "UNIT", initial = "2`()" }
b = { colour = "UNIT" }
[pages.Top.transitions.first]
priority = 2
in = { a = "()" }
[pages.Top.transitions.second]
priority = 1
in = { a = "()" }
out = { b = "()" }
[pages.Top.transitions.third]
priority = 0
in = { b = "()" }
)net");
    QCOMPARE(runOf(net, 0), QStringList({"0:second", "0:third", "0:second", "0:third"}));
  }

  void guardsChooseTheBinding() {
    const petri::Net net = netOf(R"net(
[pages.Top.places]
numbers = { colour = "INT", initial = ["3", "8", "4 @ 7"] }
wanted = { colour = "INT", initial = ["4", "8"] }
found = { colour = "INT" }
[pages.Top.transitions.match]
in = { numbers = "n", wanted = "m" }
guard = "n = m"
out = { found = "n" }
)net");
    QCOMPARE(runOf(net, 20), QStringList({"0:match", "7:match"}));
    petri::Simulator simulator(net);
    QVERIFY(!simulator.run(20));
    const auto& found = simulator.marking()[net.placeOf("Top.found")];
    QCOMPARE(found.size(), std::size_t(2));
    QCOMPARE(found[0].value[0], petri::Word(8));
    QCOMPARE(simulator.marking()[net.placeOf("Top.numbers")][0].value[0], petri::Word(3));
  }

  void listsAreSortedAndTokensTakenEarly() {
    const petri::Net net = netOf(R"net(
functions = ["fun before(a:INT, b:INT) = a < b"]
[colours]
INTS = "list INT"
[pages.Top.places]
in = { colour = "INT", initial = ["5", "2", "9", "2"] }
queue = { colour = "INTS", initial = "[]" }
later = { colour = "INT", initial = "1 @ 1000" }
smallest = { colour = "INT" }
[pages.Top.transitions.insert]
in = { in = "n", queue = "la" }
out = { queue = "sort(before, ins(la, n))" }
[pages.Top.transitions.take]
priority = 1
in = { queue = "la", later = "n @any" }
out = { queue = "tail(la)", smallest = "head(la) * 10 + length(la)" }
)net");
    QCOMPARE(runOf(net, 0).last(), QStringLiteral("0:take"));
    petri::Simulator simulator(net);
    simulator.run(0);
    QCOMPARE(simulator.marking()[net.placeOf("Top.smallest")][0].value[0], petri::Word(24));
    QCOMPARE(simulator.marking()[net.placeOf("Top.queue")][0].value, (petri::Words{3, 2, 5, 9}));
  }

  void expressionsAsStandardMl_data() {
    QTest::addColumn<QString>("expression");
    QTest::addColumn<int>("value");
    const auto add = [](const char* text, int value) {
      QTest::newRow(text) << QString::fromUtf8(text) << value;
    };
    add("2 + 3 * 4", 14);
    add("(2 + 3) * 4", 20);
    add("-7 div 2", -4);
    add("-7 mod 2", 1);
    add("7 div 0", 0);
    add("if 1 < 2 andalso not (3 <> 3) then 5 else 6", 5);
    add("if 2 >= 3 orelse 1 > 1 then 5 else 6", 6);
    add("max(3, 9) - min(3, 9)", 6);
    add("P{a = 1, b = 2} {b = 7}.b", 7);
  }

  void expressionsAsStandardMl() {
    QFETCH(const QString, expression);
    QFETCH(const int, value);
    const petri::Net net = netOf(
        "[colours]\nP = \"record a:INT b:INT\"\n[pages.Top.places]\n"
        "a = { colour = \"INT\", initial = \"" +
        expression.toStdString() + "\" }\n[pages.Top.transitions.t]\nin = { a = \"n\" }\n");
    QCOMPARE(net.places[0].initial[0].value[0], petri::Word(value));
  }

  void chanceFollowsTheSeed() {
    const petri::Net net = netOf(R"net(
[pages.Top.places]
a = { colour = "INT", initial = "0" }
[pages.Top.transitions.left]
in = { a = "n" }
out = { a = "n + 1 @+ uniform(1, 9)" }
[pages.Top.transitions.right]
in = { a = "n" }
out = { a = "n + 1 @+ uniform(1, 9)" }
)net");
    QCOMPARE(runOf(net, 500, 7), runOf(net, 500, 7));
    QVERIFY(runOf(net, 500, 7) != runOf(net, 500, 8));
    QVERIFY(runOf(net, 500, 7).join(u' ').contains(QStringLiteral("right")));
  }

  void theNetOfP3KeepsItsInvariants_data() {
    QTest::addColumn<int>("policy");
    QTest::addColumn<int>("processors");
    QTest::addColumn<int>("cycle");
    for (const int policy : {0, 1, 2}) {
      for (const int processors : {1, 3, 6}) {
        QTest::addRow("policy %d, %d processors", policy, processors)
            << policy << processors << (processors == 3 ? 2000 : 15000);
      }
    }
  }

  void theNetOfP3KeepsItsInvariants() {
    QFETCH(const int, policy);
    QFETCH(const int, processors);
    QFETCH(const int, cycle);
    const auto net = petri::loadNet("p3", {{"policy", policy},
                                           {"processors", processors},
                                           {"position_cycle", cycle},
                                           {"capacity", 4},
                                           {"lines", 30}});
    QVERIFY2(net.has_value(), net ? "" : net.error().text().c_str());
    petri::Simulator simulator(*net);
    while (simulator.step()) {
      const std::vector<std::string> violations = simulator.violations();
      QVERIFY2(violations.empty(), violations.empty() ? "" : violations.front().c_str());
    }
    // Each line of the program has passed all tasks, and the buffers are empty.
    QCOMPARE(simulator.counts()[net->transitionOf("Top.CNC.Receive.complete")], std::uint64_t(30));
    QCOMPARE(simulator.counts()[net->transitionOf("Top.CNC.Position.complete")], std::uint64_t(30));
    for (const char* buffer : {"B1", "B2", "B3", "B4", "B5"}) {
      QCOMPARE(simulator.marking()[net->placeOf(buffer)][0].value[0], petri::Word(0));
    }
  }

  /// Who asks what fires next gets the run of who does not, also where it is drawn.
  void whatFiresNextIsKnown() {
    const auto net = petri::loadNet("p3", {{"processors", 2}});
    for (const std::uint64_t seed : {0U, 3U}) {
      petri::Simulator asked(*net, seed);
      std::optional<std::size_t> fired;
      asked.setWatcher([&](std::size_t transition, petri::Word /*time*/) { fired = transition; });
      petri::Simulator other(*net, seed);
      for (int i = 0; i < 500; ++i) {
        const auto next = asked.next();
        QVERIFY(next.has_value());
        QCOMPARE(asked.next(), next);
        const petri::Word at = asked.now();
        QVERIFY(asked.isEnabled(*next, at));
        QVERIFY(asked.step());
        QCOMPARE(fired, next);
        QVERIFY(other.step());
        QCOMPARE(other.now(), at);
      }
      QCOMPARE(asked.counts(), other.counts());
      QVERIFY(!asked.next(asked.now() - 1).has_value());
    }
  }

  void aNetCanBeDriven() {
    const auto net = petri::loadNet("p3", {{"processors", 1}});
    petri::Simulator simulator(*net);
    const auto any = [](const petri::Evaluator::Frame&) { return true; };
    QVERIFY(simulator.fire(net->transitionOf("Top.CNC.Receive.init"), 0, any));
    QVERIFY(!simulator.fire(net->transitionOf("Top.SCHED.select"), 0, any));
    QVERIFY(simulator.fire(net->transitionOf("Top.CNC.Receive.start"), 0, any));
    QVERIFY(simulator.fire(net->transitionOf("Top.SCHED.insert"), 0, any));
    QVERIFY(simulator.fire(net->transitionOf("Top.SCHED.select"), 40, any));
    QVERIFY(!simulator.fire(net->transitionOf("Top.SCHED.isDone"), 10039, any));
    QVERIFY(simulator.fire(net->transitionOf("Top.SCHED.isDone"), 10040, any));
  }
};

RIVULET_TEST(TestPetriSimulator)
#include "tst_petri_simulator.moc"
