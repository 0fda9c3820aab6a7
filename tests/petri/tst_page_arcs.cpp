// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What stands on the pages of a net, where, and the lines between.

#include <QtTest>
#include <set>

#include "petri/net_file.h"
#include "petri/page_arcs.h"
#include "support/test_program.h"

using namespace rivulet;

namespace {

using Kind = petri::PageNode::Kind;

std::size_t pageOf(const petri::Net& net, const std::string& path) {
  std::size_t page = 0;
  while (page < net.pages.size() && net.pages[page].path != path) {
    ++page;
  }
  return page;
}

/// "IN<CNC", "OUT>CNC", "down=start": puts, takes, both.
QStringList linesOf(const petri::Net& net, const std::string& path) {
  const std::size_t page = pageOf(net, path);
  const auto& nodes = net.pages[page].nodes;
  QStringList lines;
  for (const petri::PageArc& arc : petri::arcsOfPage(net, page)) {
    lines.append(QString::fromStdString(nodes[arc.place].name) +
                 QLatin1Char(arc.takes && arc.puts ? '=' : (arc.takes ? '>' : '<')) +
                 QString::fromStdString(nodes[arc.node].name));
  }
  lines.sort();
  return lines;
}

}  // namespace

class TestPageArcs : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// The window draws these nets where their files say.
  void allNodesHaveAPlaceOfTheirOwn() {
    for (const std::string& name : petri::netNames()) {
      const auto net = petri::loadNet(name);
      QVERIFY(net.has_value());
      for (const petri::NetPage& page : net->pages) {
        std::set<std::pair<double, double>> taken;
        for (const petri::PageNode& node : page.nodes) {
          const std::string where = page.path + '.' + node.name;
          QVERIFY2(node.hasPosition, where.c_str());
          QVERIFY2(node.column >= 0.0 && node.row >= 0.0, where.c_str());
          QVERIFY2(taken.emplace(node.column, node.row).second, where.c_str());
        }
      }
    }
  }

  void pagesStandInTheirOrder() {
    const auto net = petri::loadNet("p3");
    QVERIFY(net.has_value());
    QCOMPARE(net->pages.size(), std::size_t(3 + 6));
    QCOMPARE(net->pages.front().path, std::string("Top"));
    for (std::size_t i = 1; i < net->pages.size(); ++i) {
      const petri::NetPage& parent = net->pages[net->pages[i].parent];
      QVERIFY(net->pages[i].parent < i);
      const auto isHere = [i](const petri::PageNode& node) {
        return node.kind == Kind::Substitution && node.index == i;
      };
      QCOMPARE(std::count_if(parent.nodes.begin(), parent.nodes.end(), isHere), 1);
    }
    // One page of the file stands in four places, with a transition of its own each time.
    const std::size_t one = net->transitionOf("Top.CNC.Interpreter.start");
    QVERIFY(petri::isOnPage(*net, one, pageOf(*net, "Top.CNC.Interpreter")));
    QVERIFY(petri::isOnPage(*net, one, pageOf(*net, "Top.CNC")));
    QVERIFY(petri::isOnPage(*net, one, 0));
    QVERIFY(!petri::isOnPage(*net, one, pageOf(*net, "Top.CNC.AccDec")));
    QVERIFY(!petri::isOnPage(*net, one, pageOf(*net, "Top.SCHED")));
  }

  void linesAreTheArcs() {
    const auto net = petri::loadNet("p3");
    QCOMPARE(linesOf(*net, "Top"), QStringList({"IN<CNC", "IN>SCHED", "OUT<SCHED", "OUT>CNC"}));
    QCOMPARE(linesOf(*net, "Top.CNC.Position"),
             QStringList({"IN<datacheck", "OUT>complete", "datarec<datacheck", "off>init",
                          "record=complete", "record=datacheck", "sent<complete", "sent>timecheck",
                          "timeout<timecheck", "up=datacheck", "waitdata<complete", "waitdata<init",
                          "waitdata>datacheck"}));
    // The scheduler reads the buffers through fusion places: no line goes to it from them.
    QVERIFY(linesOf(*net, "Top.CNC").contains(QStringLiteral("B3=AccDec")));
    QVERIFY(!linesOf(*net, "Top.CNC").contains(QStringLiteral("B3=Position")));
  }

  void inscriptionsAreThoseOfTheFile() {
    const auto net = petri::loadNet("p3");
    const std::size_t page = pageOf(*net, "Top.SCHED");
    const auto& nodes = net->pages[page].nodes;
    for (const petri::PageArc& arc : petri::arcsOfPage(*net, page)) {
      if (nodes[arc.place].name == "TimeList" && nodes[arc.node].name == "preempt") {
        QCOMPARE(arc.taken, std::vector<std::string>{"r.ID @any"});
        QCOMPARE(arc.put, std::vector<std::string>{"head(la).ID @+ head(la).ts"});
        return;
      }
    }
    QFAIL("preempt has no line to TimeList");
  }

  void positionsThatAreNone() {
    for (const char* at : {"3", "[1]", "[1, 2, 3]", "[\"a\", 2]"}) {
      const std::string text =
          std::string(
              "name = \"n\"\ntime_unit = \"ms\"\ntop = \"Top\"\n[pages.Top.places]\n"
              "a = { colour = \"INT\", at = ") +
          at + " }\n[pages.Top.transitions.t]\nin = { a = \"n\" }\n";
      const auto net = petri::parseNet(text, "test");
      QVERIFY2(!net.has_value(), at);
      QVERIFY(net.error().message.find("a: \"at\" must be a column and a row") == 0);
    }
  }
};

RIVULET_TEST(TestPageArcs)
#include "tst_page_arcs.moc"
