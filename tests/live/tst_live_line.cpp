// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The language of live sources, and what has been agreed with one.

#include <QtTest>

#include "live/agreement.h"
#include "live/error.h"
#include "live/line.h"
#include "live/line_reader.h"
#include "support/test_program.h"

using namespace rivulet;
using live::Line;
using live::LiveError;
using live::parseLine;

namespace {

live::Gate gateAt(base::Vec3 toolMm, const live::Agreement& agreement = {}) {
  return {agreement, {toolMm, {}}, 500.0, {true, true, true}, {}};
}

std::error_code refusal(live::Gate& gate, std::string_view text) {
  const auto point = gate.take(*parseLine(text), base::LineNumber{1});
  return point ? std::error_code{} : point.error().code;
}

}  // namespace

class TestLiveLine : public QObject {
  Q_OBJECT

 private slots:
  void words() {
    const auto line = parseLine("n3 X1.5 y-2 Z=.25A90 F 1200 ; to the left");
    QVERIFY(line && line->kind == Line::Kind::Point);
    QCOMPARE(line->mm[0].value(), 1.5);
    QCOMPARE(line->mm[1].value(), -2.0);
    QCOMPARE(line->mm[2].value(), 0.25);
    QCOMPARE(line->deg[0].value(), 90.0);
    QCOMPARE(line->feedMmPerMin.value(), 1200.0);
    QCOMPARE(line->number.value(), 3.0);
    QVERIFY(!line->deg[2]);
  }

  void json() {
    const auto line = parseLine(R"({"x": 1e-1, "Y": 2, "f": 300})");
    QVERIFY(line && line->kind == Line::Kind::Point);
    QCOMPARE(line->mm[0].value(), 0.1);
    QCOMPARE(line->mm[1].value(), 2.0);
    QVERIFY(!line->mm[2]);
    QVERIFY(parseLine(R"({"end": true})")->kind == Line::Kind::End);
    QVERIFY(parseLine(R"({"hold": true})")->kind == Line::Kind::Hold);
    QVERIFY(parseLine(R"({"comment": "X1"})")->kind == Line::Kind::Nothing);
  }

  void commands() {
    QVERIFY(parseLine(" End ")->kind == Line::Kind::End);
    QVERIFY(parseLine("hold")->kind == Line::Kind::Hold);
    for (const char* text : {"", "  ", "# X1", "; X1", "(X1)", "comment X1", "comment: X1"}) {
      QVERIFY2(parseLine(text) && parseLine(text)->kind == Line::Kind::Nothing, text);
    }
  }

  void whatIsNoLine() {
    for (const char* text : {"X", "Xnan", "X inf", "X1e999", "X--1", R"({"x": null})"}) {
      QVERIFY2(!parseLine(text) && parseLine(text).error().code == LiveError::NotFinite, text);
    }
    for (const char* text :
         {"F100", "N1", "X1 X2", "G1 X1", "endless", "hold X1", "\x01\x02", "{", "[1]", "{}",
          R"({"x": 1, "x": 2})", R"({"x": "1"})", R"({"end": false})", R"({"a": {"x": 1}})",
          R"({"x": 1} X2)"}) {
      QVERIFY2(!parseLine(text) && parseLine(text).error().code == LiveError::NotALine, text);
    }
  }

  void linesInPieces() {
    live::LineReader reader;
    reader.add("X1\r\nX");
    QCOMPARE(reader.next().value(), std::string_view("X1"));
    QVERIFY(!reader.next());
    reader.add("2");
    QVERIFY(!reader.next());
    reader.add("\n\nX3");
    QCOMPARE(reader.next().value(), std::string_view("X2"));
    QCOMPARE(reader.next().value(), std::string_view());
    QCOMPARE(reader.rest(), std::string_view("X3"));
    reader.add(std::string(live::kLineBytesMax, '3'));
    QVERIFY(reader.isTooLong());
  }

  void whatIsNotNamedStays() {
    live::Gate gate = gateAt({0.0, 0.0, 5.0});
    QVERIFY(gate.take(*parseLine("X0.5 F600"), base::LineNumber{1}));
    const auto point = gate.take(*parseLine("Y1"), base::LineNumber{2});
    QVERIFY(point && *point);
    QVERIFY(((*point)->positionMm == base::Vec3{0.5, 1.0, 5.0}));
    QCOMPARE((*point)->feedMmPerS, 10.0);
    QCOMPARE((*point)->line.value, 2U);
  }

  void onlyWhatWasAgreedPasses() {
    live::Gate gate = gateAt({});
    QVERIFY(refusal(gate, "X1.5") == LiveError::TooFarAway);
    QVERIFY(!refusal(gate, "X1"));
    QVERIFY(refusal(gate, "X6.5") == LiveError::StepTooLong);
    QVERIFY(!refusal(gate, "X6"));
    QVERIFY(!refusal(gate, "X10"));
    QVERIFY(refusal(gate, "X10.001") == LiveError::OutsideBox);
    QVERIFY(refusal(gate, "X9 F1001") == LiveError::FeedTooLarge);
    QVERIFY(refusal(gate, "X9 F0") == LiveError::FeedTooLarge);
    QVERIFY(refusal(gate, "X9 A1") == LiveError::AxisNotChosen);
    QVERIFY(refusal(gate, "X1e308") == LiveError::OutsideBox);
    QVERIFY(!refusal(gate, "X9 F1000"));
  }

  void rotaryAxesTurnALittle() {
    live::Gate gate({}, {}, 500.0, {true, true, true}, {true, false, false});
    QVERIFY(!refusal(gate, "X0.5 A5"));
    QVERIFY(refusal(gate, "A10.1") == LiveError::TurnTooLarge);
    const auto turned = gate.take(*parseLine("A5.1"), base::LineNumber{1});
    QVERIFY(turned && *turned);  // without a step of X, Y and Z
  }

  void pointsTooCloseAreMerged() {
    live::Agreement agreement;
    agreement.distanceMmMin = 0.1;
    live::Gate gate = gateAt({}, agreement);
    const auto isMerged = [&](std::string_view text) {
      const auto point = gate.take(*parseLine(text), base::LineNumber{1});
      return point && !*point;
    };
    QVERIFY(isMerged("X0"));  // the tool is there
    QVERIFY(!isMerged("X0.5"));
    QVERIFY(isMerged("X0.56"));
    QVERIFY(!isMerged("X0.62"));  // counted from the last point that was kept
    QVERIFY(isMerged("X0.62"));
  }
};

RIVULET_TEST(TestLiveLine)
#include "tst_live_line.moc"
