// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <rapidcheck.h>

#include <QtTest>
#include <algorithm>
#include <limits>
#include <span>
#include <string>

#include "base/random.h"
#include "support/test_program.h"
#include "trace/analysis/integrity.h"

using namespace rivulet::trace;
using rivulet::base::Duration;
using rivulet::base::Instant;
using rivulet::base::PointIndex;
using rivulet::base::Random;
using rivulet::base::Vec3;
using rivulet::gcode::StreamPoint;

namespace {

constexpr double kToleranceMm = 1e-6;

/// A place per letter, not on one line, so that neighbours differ in every axis.
Vec3 place(char letter) {
  const double n = letter;
  return {n, 0.1 * n * n - 700.0, -n / 3.0};
}

/// "ABCA": a path that ends where it began.
std::vector<StreamPoint> program(std::string_view letters) {
  std::vector<StreamPoint> points;
  for (const char letter : letters) {
    points.push_back({place(letter), {}});
  }
  return points;
}

/// What the machine did, one block every millisecond: a letter is a motion to its place, '.' a
/// block that moves nothing (it starts at A), '?' a motion to a place of no point, blanks only
/// group.
std::vector<ExecutedBlock> executed(std::string_view letters) {
  std::vector<ExecutedBlock> blocks;
  Vec3 at = place('A');
  std::int64_t milliseconds = 0;
  for (const char letter : letters) {
    if (letter == ' ') {
      continue;
    }
    const Vec3 target = letter == '.' ? at : (letter == '?' ? Vec3{-1e4, 0, 0} : place(letter));
    ExecutedBlock block;
    block.from = Instant{Duration{milliseconds * 1'000'000}};
    block.to = block.from + Duration{1'000'000};
    block.targetMm = target;
    block.lengthMm = letter == '.' ? 0.0 : std::max(1e-3, rivulet::base::distance(at, target));
    blocks.push_back(block);
    at = target;
    ++milliseconds;
  }
  return blocks;
}

/// "executed/repeated/skipped/foreign/out of order"
std::string judge(std::string_view points, std::string_view blocks) {
  const Integrity result = judgeIntegrity(program(points), executed(blocks), kToleranceMm);
  return std::to_string(result.executed) + "/" + std::to_string(result.repeated) + "/" +
         std::to_string(result.skipped) + "/" + std::to_string(result.foreign) + "/" +
         std::to_string(result.outOfOrder);
}

std::string faults(std::string_view points, std::string_view blocks) {
  std::string text;
  for (const IntegrityFault& fault :
       judgeIntegrity(program(points), executed(blocks), kToleranceMm).faults) {
    const char kind = std::string_view("RSFO")[static_cast<std::size_t>(fault.kind)];
    text += (text.empty() ? "" : " ") + std::string(1, kind) + std::to_string(fault.point.value) +
            "@" + std::to_string(fault.at.time_since_epoch().count() / 1'000'000);
  }
  return text;
}

std::vector<ExecutedBlock> blocksOf(const std::vector<StreamPoint>& points,
                                    const std::vector<std::size_t>& order) {
  std::vector<ExecutedBlock> blocks;
  for (const std::size_t index : order) {
    ExecutedBlock block;
    block.from = Instant{Duration{static_cast<std::int64_t>(blocks.size())}};
    block.targetMm = points[index].positionMm;
    block.lengthMm = 1.0;
    blocks.push_back(block);
  }
  return blocks;
}

/// Points that are all at places of their own.
std::vector<StreamPoint> distinctPoints(Random& random, std::size_t count) {
  std::vector<StreamPoint> points;
  for (std::size_t i = 0; i < count; ++i) {
    points.push_back(
        {{static_cast<double>(i) + 0.4 * random.uniform(), random.normal(), random.normal()}, {}});
  }
  // In random order, so that neighbours of the program are not neighbours in space.
  for (std::size_t i = count; i > 1; --i) {
    std::swap(points[i - 1], points[random.below(i)]);
  }
  return points;
}

/// A walk over a small grid: most places are visited many times.
std::vector<StreamPoint> crowdedPoints(Random& random, std::size_t count) {
  std::vector<StreamPoint> points;
  Vec3 at;
  for (std::size_t i = 0; i < count; ++i) {
    Vec3 next = at;
    while (next == at) {
      next.set(random.below(3), static_cast<double>(random.below(3)));
    }
    at = next;
    points.push_back({at, {}});
  }
  return points;
}

/// The points with stretches lost, executed twice or exchanged, and motions to foreign places.
std::vector<ExecutedBlock> disturbed(Random& random, const std::vector<StreamPoint>& points) {
  const std::size_t rarity = 2 + random.below(200);
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t fault = random.below(rarity);
    if (fault == 0) {
      i += random.below(9);
    }
    if (fault == 1 && !order.empty()) {
      const std::size_t from =
          order.size() - 1 - random.below(std::min<std::size_t>(9, order.size()));
      order.push_back(order[from]);
    }
    order.push_back(std::min(i, points.size() - 1));
    if (fault == 2 && order.size() > 1) {
      std::swap(order.back(), order[order.size() - 2]);
    }
  }
  std::vector<ExecutedBlock> blocks = blocksOf(points, order);
  for (ExecutedBlock& block : blocks) {
    if (random.below(3 * rarity) == 0) {
      block.targetMm.x += 0.5;
    } else if (random.below(3 * rarity) == 0) {
      block.lengthMm = 0.0;
    }
  }
  return blocks;
}

/// Everything that a judgement says.
std::string text(const Integrity& result) {
  std::string all = result.judged ? "judged" : "not judged";
  for (const std::size_t number :
       {result.executed, result.repeated, result.skipped, result.foreign, result.outOfOrder}) {
    all += "/" + std::to_string(number);
  }
  for (const IntegrityFault& fault : result.faults) {
    all += " " + std::to_string(static_cast<int>(fault.kind)) + ":" +
           std::to_string(fault.point.value) + "@" +
           std::to_string(fault.at.time_since_epoch().count());
  }
  return all;
}

std::vector<std::size_t> faithful(std::size_t count) {
  std::vector<std::size_t> order(count);
  for (std::size_t i = 0; i < count; ++i) {
    order[i] = i;
  }
  return order;
}

}  // namespace

class TestIntegrity : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void judges_data() {
    QTest::addColumn<std::string>("points");
    QTest::addColumn<std::string>("blocks");
    QTest::addColumn<std::string>("counts");
    const auto row = [](const char* name, const char* points, const char* blocks,
                        const char* counts) {
      QTest::newRow(name) << std::string(points) << std::string(blocks) << std::string(counts);
    };
    row("nothing", "", "", "0/0/0/0/0");
    row("nothing executed", "ABC", "", "0/0/0/0/0");
    row("no points", "", "AB", "0/0/0/2/0");
    row("faithful", "ABCDEFGH", "ABCD EFGH", "8/0/0/0/0");
    row("stopped early", "ABCDEFGH", "ABCD", "4/0/0/0/0");
    row("loop repeated", "ABCDEFGH", "ABCD ABCD EFGH", "8/4/0/0/0");
    row("loop repeated twice", "ABCDEFGH", "ABCD ABCD ABCD EFGH", "8/8/0/0/0");
    row("loop repeated, then lost one", "ABCDEFGH", "ABCD ABCD FGH", "7/4/1/0/0");
    row("slot late, its point lost", "ABCDEFGH", "ABCD EBGH", "7/1/1/0/0");
    row("slot late, executed a loop later", "ABCDEFGHIJKL", "ABCD EBGH IFKL", "11/1/1/0/1");
    row("slots late twice", "ABCDEFGHIJKL", "ABCD EBGH IBKL", "10/2/2/0/0");
    row("one skipped", "ABCDE", "ABDE", "4/0/1/0/0");
    row("first skipped", "ABCDE", "BCDE", "4/0/1/0/0");
    row("last missing is no skip", "ABCDE", "ABCD", "4/0/0/0/0");
    row("back and on", "ABCD", "ABCBCD", "4/2/0/0/0");
    row("same again", "ABCD", "ABBCD", "4/1/0/0/0");
    row("swapped", "ABCDE", "ABDCE", "5/0/0/0/1");
    row("overwritten too early", "ABCDEFGHIJKLMN", "ABCD EFKH IJKL MN", "13/1/1/0/1");
    row("torn between two writes", "ABCDE", "AB?DE", "4/0/1/1/0");
    row("extra motion", "ABCDE", "AB?CDE", "5/0/0/1/0");
    row("extra motion first", "ABCDE", "?ABCDE", "5/0/0/1/0");
    // Blocks that move nothing.
    row("padded end", "ABC", "ABC.....", "3/0/0/0/0");
    row("holds everywhere", "ABC", "A..B...C.", "3/0/0/0/0");
    row("starts where it stands", "ABC", ".BC", "3/0/0/0/0");
    row("stands elsewhere at first", "BCA", "..BCA", "3/0/0/0/0");
    row("point repeats its predecessor", "ABBC", "AB.C", "4/0/0/0/0");
    row("such a point without a block", "ABBC", "ABC", "4/0/0/0/0");
    row("two of them", "ABBBC", "AB.C", "5/0/0/0/0");
    // Places visited more than once.
    row("closed contour", "ABCDA", "ABCDA", "5/0/0/0/0");
    row("two laps", "ABCDABCDA", "ABCDABCDA", "9/0/0/0/0");
    row("there and back", "ABCDCBA", "ABCDCBA", "7/0/0/0/0");
    row("there and back, loop repeated", "ABCDCBA", "ABCD BCD CBA", "7/3/0/0/0");
    row("there and back, reversal lost", "ABCDCBA", "ABCDBA", "6/0/1/0/0");
    row("closed contour, loop repeated", "ABCDA", "AB AB CD A", "5/2/0/0/0");
    row("closed contour, start again", "ABCDA", "ABC A", "4/0/1/0/0");
    row("pocket: many laps, loop repeated", "ABCDEFABCDEFABCDEF", "ABC DEF DEF ABC DEF ABC DEF",
        "18/3/0/0/0");
    row("pocket: one lost", "ABCDEFABCDEFABCDEF", "ABCDEF ABCEF ABCDEF", "17/0/1/0/0");
    row("to and fro", "ABABABAB", "ABABABAB", "8/0/0/0/0");
  }

  void judges() {
    QFETCH(std::string, points);
    QFETCH(std::string, blocks);
    QFETCH(std::string, counts);
    QCOMPARE(judge(points, blocks), counts);
  }

  /// Between two stretches the control has moved itself: to the first point of the next one.
  void standsAtThePointDue() {
    const std::vector<StreamPoint> points = program("ABCD");
    std::vector<ExecutedBlock> blocks = blocksOf(points, {0, 1, 2, 3});
    blocks[2].lengthMm = 0.0;
    QVERIFY(judgeIntegrity(points, blocks, kToleranceMm).isFaultless());
    blocks[2].targetMm.x += 1.0;  // somewhere else
    QCOMPARE(judgeIntegrity(points, blocks, kToleranceMm).skipped, std::size_t{1});
  }

  void listsFaultsInTimeOrder() {
    QCOMPARE(faults("ABCDEFGH", "ABCD EFGH"), std::string());
    QCOMPARE(faults("ABCDEFGH", "ABCD EBGH"), std::string("R1@5 S5@6"));
    QCOMPARE(faults("ABCDE", "AB?DE"), std::string("F2@2 S2@3"));
    QCOMPARE(faults("ABCDE", "ABDCE"), std::string("O3@2"));
    QCOMPARE(faults("ABCDE", "BA"), std::string("O1@0"));
  }

  void listsAHundredFaultsAtMost() {
    std::string blocks = "A";
    for (int i = 0; i < 150; ++i) {
      blocks += "?";
    }
    const Integrity result = judgeIntegrity(program("AB"), executed(blocks), kToleranceMm);
    QCOMPARE(result.foreign, std::size_t{150});
    QCOMPARE(result.faults.size(), std::size_t{100});
  }

  void tellsWhetherItIsFaultless() {
    QVERIFY(!Integrity{}.isFaultless());
    QVERIFY(judgeIntegrity(program("ABC"), executed("AB"), kToleranceMm).isFaultless());
    for (const char* blocks : {"AAB", "AC", "A?B", "ACB"}) {
      QVERIFY(!judgeIntegrity(program("ABC"), executed(blocks), kToleranceMm).isFaultless());
    }
  }

  void holdsToTheTolerance() {
    const std::vector<StreamPoint> points{{{0, 0, 0}, {}}, {{1, 0, 0}, {}}};
    auto blocks = blocksOf(points, {0, 1});
    blocks[1].targetMm.x += 0.9e-6;
    QVERIFY(judgeIntegrity(points, blocks, kToleranceMm).isFaultless());
    blocks[1].targetMm.x += 0.2e-6;
    QCOMPARE(judgeIntegrity(points, blocks, kToleranceMm).foreign, std::size_t{1});
    // The search after a fault holds to it too, also across the borders of its grid.
    for (const double x : {0.0, 4e-6, 8e-6 - 0.5e-6, -4e-6, 1e3 / 3.0, 1e9}) {
      const std::vector<StreamPoint> far{{{-7, 0, 0}, {}}, {{-8, 0, 0}, {}}, {{x, x, x}, {}}};
      auto skipping = blocksOf(far, {0, 2});
      skipping[1].targetMm = skipping[1].targetMm + Vec3{-0.5e-6, 0.5e-6, -0.5e-6};
      QCOMPARE(judgeIntegrity(far, skipping, kToleranceMm).skipped, std::size_t{1});
      skipping[1].targetMm.x -= 0.5e-6;
      QCOMPARE(judgeIntegrity(far, skipping, kToleranceMm).foreign, std::size_t{1});
    }
    QVERIFY(judgeIntegrity(points, blocksOf(points, {0, 1}), 0.0).isFaultless());
  }

  void takesTargetsThatAreNoPlace() {
    const std::vector<StreamPoint> points = program("ABC");
    auto blocks = executed("ABC");
    blocks[1].targetMm.x = std::numeric_limits<double>::quiet_NaN();
    blocks[2].targetMm.y = 1e300;
    const Integrity result = judgeIntegrity(points, blocks, kToleranceMm);
    QCOMPARE(result.foreign, std::size_t{2});
    QCOMPARE(result.executed, std::size_t{1});
  }

  void faithfulRunsAreFaultless() {
    QVERIFY(rc::check("a list executed as it is has no fault", [] {
      Random random(*rc::gen::arbitrary<std::uint64_t>());
      const std::size_t count = 1 + random.below(300);
      const auto points =
          random.below(2) == 0 ? crowdedPoints(random, count) : distinctPoints(random, count);
      const std::size_t done = random.below(count + 1);
      const Integrity result =
          judgeIntegrity(points, blocksOf(points, faithful(done)), kToleranceMm);
      RC_ASSERT(result.isFaultless());
      RC_ASSERT(result.executed == done);
      RC_ASSERT(result.faults.empty());
    }));
  }

  void anyOtherRunIsNot() {
    QVERIFY(rc::check("a motion that differs from the program is a fault", [] {
      Random random(*rc::gen::arbitrary<std::uint64_t>());
      const std::size_t count = 4 + random.below(100);
      const auto points = crowdedPoints(random, count);
      auto blocks = blocksOf(points, faithful(count));
      // One block goes elsewhere: where it should go is the only place that is no fault.
      const std::size_t changed = random.below(count);
      blocks[changed].targetMm = points[random.below(count)].positionMm;
      const bool differs = blocks[changed].targetMm != points[changed].positionMm;
      const Integrity result = judgeIntegrity(points, blocks, kToleranceMm);
      RC_ASSERT(result.isFaultless() == !differs);
      RC_ASSERT(result.executed + result.repeated + result.foreign == count);
    }));
  }

  void countsRepetitionsAndSkipsExactly() {
    QVERIFY(rc::check("repetitions and skips of distinct points are counted exactly", [] {
      Random random(*rc::gen::arbitrary<std::uint64_t>());
      const std::size_t count = 2 + random.below(200);
      const auto points = distinctPoints(random, count);
      std::vector<std::size_t> order;
      std::vector<std::size_t> lost;
      std::size_t repeated = 0;
      for (std::size_t i = 0; i < count; ++i) {
        if (random.below(10) == 0 && i + 1 < count) {
          lost.push_back(i);
        } else {
          order.push_back(i);
        }
        if (random.below(10) == 0 && !order.empty()) {
          // A stretch executed before, once more.
          const std::size_t from = random.below(order.size());
          const std::size_t length =
              1 + random.below(std::min<std::size_t>(7, order.size() - from));
          for (std::size_t k = 0; k < length; ++k) {
            order.push_back(order[from + k]);
          }
          repeated += length;
        }
      }
      const Integrity result = judgeIntegrity(points, blocksOf(points, order), kToleranceMm);
      RC_ASSERT(result.executed == count - lost.size());
      RC_ASSERT(result.repeated == repeated);
      RC_ASSERT(result.skipped == lost.size());
      RC_ASSERT(result.foreign == 0U);
      RC_ASSERT(result.outOfOrder == 0U);
    }));
  }

  void countsWhatIsOutOfOrder() {
    QVERIFY(rc::check("one point moved elsewhere is one point out of order", [] {
      Random random(*rc::gen::arbitrary<std::uint64_t>());
      const std::size_t count = 3 + random.below(100);
      const auto points = distinctPoints(random, count);
      std::vector<std::size_t> order = faithful(count);
      const std::size_t from = random.below(count);
      const std::size_t to = random.below(count);
      order.erase(order.begin() + static_cast<std::ptrdiff_t>(from));
      order.insert(order.begin() + static_cast<std::ptrdiff_t>(to), from);
      const Integrity result = judgeIntegrity(points, blocksOf(points, order), kToleranceMm);
      RC_ASSERT(result.executed == count);
      RC_ASSERT(result.repeated + result.skipped + result.foreign == 0U);
      RC_ASSERT(result.outOfOrder == (from == to ? 0U : 1U));
    }));
  }

  /// A control that records no blocks: its set points say which points were executed.
  void withoutBlocksTheSetPointsAreJudged() {
    const std::vector<Vec3> corners{{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}};
    std::vector<StreamPoint> points;
    for (std::size_t i = 1; i < corners.size(); ++i) {
      // As the pieces of an arc: each is a point of its own.
      points.push_back({corners[i], {}, rivulet::gcode::MoveKind::ArcPiece});
    }
    const auto traceOf = [&corners](const std::vector<std::size_t>& course) {
      ControlTrace trace;
      trace.cycle = Duration{1'000'000};
      for (std::size_t leg = 1; leg < course.size(); ++leg) {
        const Vec3 from = corners[course[leg - 1]];
        const Vec3 to = corners[course[leg]];
        for (int step = leg == 1 ? 0 : 1; step <= 100; ++step) {
          ControlSample sample;
          sample.at = Instant{trace.cycle * static_cast<int>(trace.samples.size())};
          sample.commandMm = from + (0.01 * step) * (to - from);
          sample.actualMm = sample.commandMm;
          trace.samples.push_back(sample);
        }
      }
      return trace;
    };
    Integrity result = judgeRun(points, traceOf({0, 1, 2, 3}), {});
    QVERIFY(result.judged && result.isFaultless());
    QCOMPARE(result.executed, std::size_t{3});
    result = judgeRun(points, traceOf({0, 1, 2, 1, 2, 3}), {});
    QVERIFY(result.judged && !result.isFaultless());
    QVERIFY(result.repeated > 0);
    result = judgeRun(points, traceOf({0, 1, 3}), {});
    QVERIFY(result.judged && !result.isFaultless());
    ControlTrace cut = traceOf({0, 1, 2, 3});
    cut.truncated = true;
    QVERIFY(!judgeRun(points, cut, {}).judged);
    QVERIFY(!judgeRun(points, traceOf({0, 1, 2, 3}), {true, false, false}).judged);
  }

  /// While the run lasts, its blocks come in pieces, and the points of a live run with them.
  void piecesGiveTheSameJudgementAsTheWhole() {
    QVERIFY(rc::check("judged in pieces as in one", [] {
      Random random(*rc::gen::arbitrary<std::uint64_t>());
      const std::size_t count = 1 + random.below(700);
      const bool isCrowded = random.below(2) == 0;
      const std::vector<StreamPoint> points =
          isCrowded ? crowdedPoints(random, count) : distinctPoints(random, count);
      const std::vector<ExecutedBlock> blocks = disturbed(random, points);
      const Integrity whole = judgeIntegrity(points, blocks, kToleranceMm);

      std::vector<StreamPoint> growing;
      IntegrityJudge judge(points, kToleranceMm, {}, PointsOfRun::Known);
      IntegrityJudge live(growing, kToleranceMm, {}, PointsOfRun::Growing);
      for (std::size_t from = 0; from < blocks.size();) {
        const std::size_t size = std::min(1 + random.below(400), blocks.size() - from);
        const std::size_t known = std::min(points.size(), from + size + random.below(30));
        growing.insert(
            growing.end(), points.begin() + static_cast<std::ptrdiff_t>(growing.size()),
            points.begin() + static_cast<std::ptrdiff_t>(std::max(known, growing.size())));
        judge.add(std::span(blocks).subspan(from, size));
        live.add(std::span(blocks).subspan(from, size));
        from += size;
      }
      growing = points;
      RC_ASSERT(text(judge.finish()) == text(whole));
      RC_ASSERT(text(live.finish()) == text(whole));
    }));
  }

  void aTraceInPiecesIsJudgedAsTheWhole() {
    const std::vector<StreamPoint> points = program("ABCDEFG");
    ControlTrace whole;
    whole.blocks = executed("ABCDEFG");
    ControlTrace first = whole;
    first.blocks.resize(3);
    ControlTrace second = whole;
    second.blocks.erase(second.blocks.begin(), second.blocks.begin() + 3);
    RunJudge judge(points, {}, PointsOfRun::Known);
    judge.add(first);
    judge.add(second);
    QVERIFY(judge.finish().isFaultless());
    RunJudge incomplete(points, {}, PointsOfRun::Known);
    first.truncated = true;
    incomplete.add(first);
    incomplete.add(second);
    QVERIFY(!incomplete.finish().judged);
  }

  void staysFastOnLongFaultyRuns() {
    // 20 000 laps over the same five places, every third block lost: a search through all points
    // of one place would not end within the time ctest allows.
    std::vector<StreamPoint> points;
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < 100'000; ++i) {
      points.push_back({place(static_cast<char>('A' + i % 5)), {}});
      if (i % 3 != 2) {
        order.push_back(i);
      }
    }
    const Integrity result = judgeIntegrity(points, blocksOf(points, order), kToleranceMm);
    QVERIFY(!result.isFaultless());
    QCOMPARE(result.executed + result.repeated + result.foreign, order.size());
  }
};

RIVULET_TEST(TestIntegrity)
#include "tst_integrity.moc"
