// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The milling cycles of Heidenhain cut the shape that the manual defines: the workpiece is looked
/// at point by point, whether the tool has been there or not, and compared with the shape as its
/// parameters describe it. Nothing of the reader is used for the comparison. TNC 640 User's Manual
/// Cycle Programming, chapters "Pocket Milling / Stud Milling / Slot Milling", "Drilling",
/// "Tapping / Thread Milling" and "Multipass Milling"; cycles 4 and 5: TNC 426 User's Manual.

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "gcode/program.h"
#include "support/test_program.h"

using namespace rivulet;

namespace {

constexpr double kToolRadius = 4.0;
constexpr double kSurface = 0.0;

struct Place {
  double x = 0.0;
  double y = 0.0;
};
/// How far outside the shape a place is; negative: within.
using Shape = std::function<double(Place)>;

Place turnedBack(Place place, Place about, double degrees) {
  const double angle = -degrees * std::numbers::pi / 180.0;
  const double x = place.x - about.x;
  const double y = place.y - about.y;
  return {x * std::cos(angle) - y * std::sin(angle), x * std::sin(angle) + y * std::cos(angle)};
}

/// A rectangle with round corners.
Shape rectangle(Place middle, double length, double width, double corner, double degrees = 0.0) {
  return [=](Place place) {
    const Place own = turnedBack(place, middle, degrees);
    const double x = std::abs(own.x) - (length / 2.0 - corner);
    const double y = std::abs(own.y) - (width / 2.0 - corner);
    return std::hypot(std::max(x, 0.0), std::max(y, 0.0)) + std::min(std::max(x, y), 0.0) - corner;
  };
}
Shape circle(Place middle, double diameter) {
  return [=](Place place) {
    return std::hypot(place.x - middle.x, place.y - middle.y) - diameter / 2.0;
  };
}
/// Along a circle, from one angle on, with round ends.
Shape arcSlot(Place centre, double diameter, double from, double sweep, double width) {
  return [=](Place place) {
    const Place own = turnedBack(place, centre, from + sweep / 2.0);
    const double half = sweep / 2.0 * std::numbers::pi / 180.0;
    const double angle = std::clamp(std::atan2(own.y, own.x), -half, half);
    const Place nearest{diameter / 2.0 * std::cos(angle), diameter / 2.0 * std::sin(angle)};
    return std::hypot(own.x - nearest.x, own.y - nearest.y) - width / 2.0;
  };
}
Shape both(Shape a, Shape b) {
  return [=](Place place) { return std::min(a(place), b(place)); };
}
/// Where the hole was before, nothing is said of the tool.
Shape besideHole(Shape shape, Shape hole) {
  return [=](Place place) { return hole(place) < 0.0 ? 0.0 : shape(place); };
}

struct Stroke {
  Place from;
  Place to;
};
double distanceTo(Place place, const Stroke& stroke) {
  const double x = stroke.to.x - stroke.from.x;
  const double y = stroke.to.y - stroke.from.y;
  const double square = x * x + y * y;
  const double along =
      square > 0.0
          ? std::clamp(((place.x - stroke.from.x) * x + (place.y - stroke.from.y) * y) / square,
                       0.0, 1.0)
          : 0.0;
  return std::hypot(place.x - stroke.from.x - along * x, place.y - stroke.from.y - along * y);
}

struct Cut {
  std::vector<base::Vec3> points;  ///< the first is where the tool comes from
  std::vector<bool> isRapid;
  std::set<double> feeds;  ///< mm/min, rounded
  double lowest = 0.0;
  std::string fault;

  [[nodiscard]] std::vector<Stroke> strokesAt(double height) const {
    std::vector<Stroke> strokes;
    for (std::size_t i = 1; i < points.size(); ++i) {
      if (points[i - 1].z < height + 1e-6 && points[i].z < height + 1e-6) {
        strokes.push_back({{points[i - 1].x, points[i - 1].y}, {points[i].x, points[i].y}});
      }
    }
    return strokes;
  }
};

Cut cutOf(const std::string& body, const std::string& tool = "R+4") {
  const std::string text = "BEGIN PGM T MM\nTOOL DEF 5 L+0 " + tool +
                           "\nTOOL CALL 5 Z S2000\nL X+10 Y+20 Z+80 R0 FMAX M3\n" + body +
                           "\nL Z+90 R0 FMAX\nEND PGM T MM\n";
  gcode::LoadOptions options;
  options.dialect = gcode::Dialect::Heidenhain;
  Cut cut;
  const auto program = gcode::interpretProgram("T.H", text, options);
  if (!program) {
    cut.fault = program.error().text();
    return cut;
  }
  for (const gcode::Diagnostic& finding : program->diagnostics) {
    if (finding.severity == gcode::Severity::Error) {
      cut.fault += gcode::describe(finding) + "\n";
    }
  }
  for (const gcode::TrajectoryPoint& point : program->trajectory.points) {
    cut.points.push_back(point.positionMm);
    cut.isRapid.push_back(point.kind == gcode::MoveKind::Rapid);
    if (!cut.isRapid.back()) {
      cut.feeds.insert(std::round(point.feedMmPerS * 60.0 * 1000.0) / 1000.0);
    }
    cut.lowest = std::min(cut.lowest, point.positionMm.z);
  }
  return cut;
}

/// Where the ground differs from the shape, by the first place; empty: nowhere.
std::string differenceAt(const Cut& cut, double height, const Shape& shape,
                         double radius = kToolRadius) {
  constexpr double kGrid = 0.5;
  constexpr double kTolerance = 0.02;
  const std::vector<Stroke> strokes = cut.strokesAt(height);
  for (double x = -60.0; x <= 80.0; x += kGrid) {
    for (double y = -60.0; y <= 80.0; y += kGrid) {
      const double outside = shape({x, y});
      const bool isCut = std::any_of(strokes.begin(), strokes.end(), [&](const Stroke& stroke) {
        return distanceTo({x, y}, stroke) < radius;
      });
      if ((outside < -kTolerance && !isCut) || (outside > kTolerance && isCut)) {
        return "X" + std::to_string(x) + " Y" + std::to_string(y) +
               (isCut ? " is cut" : " is left") + " at Z" + std::to_string(height);
      }
    }
  }
  return {};
}

/// No rapid goes into the material or across it, and the tool ends above the place of the call.
std::string faultOfPlanes(const Cut& cut, double retract) {
  for (std::size_t i = 1; i < cut.points.size(); ++i) {
    const base::Vec3 from = cut.points[i - 1];
    const base::Vec3 to = cut.points[i];
    const bool isAcross = std::hypot(to.x - from.x, to.y - from.y) > 1e-9;
    if (cut.isRapid[i] && isAcross && std::min(from.z, to.z) < kSurface - 1e-9) {
      return "a rapid across at Z" + std::to_string(std::min(from.z, to.z));
    }
    if (cut.isRapid[i] && !isAcross && to.z < from.z - 1e-9 && to.z < kSurface) {
      return "a rapid down to Z" + std::to_string(to.z);
    }
  }
  const base::Vec3 last = cut.points[cut.points.size() - 2];
  const bool isBack = std::abs(last.x - 10.0) < 1e-9 && std::abs(last.y - 20.0) < 1e-9 &&
                      std::abs(last.z - retract) < 1e-9;
  return isBack ? std::string()
                : "the tool ends at X" + std::to_string(last.x) + " Y" + std::to_string(last.y) +
                      " Z" + std::to_string(last.z);
}

std::string cycle(const std::string& number, const std::string& parameters) {
  return "CYCL DEF " + number + " " + parameters +
         " Q201=-6 Q206=150 Q200=2 Q203=+0 Q204=50\nCYCL CALL";
}
const std::string kPocket = " Q215=0 Q368=0 Q207=500 Q351=+1 Q202=2.5 Q369=0 Q338=0 Q385=300 ";

}  // namespace

class TestKlartextShapes : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void shape_data() {
    QTest::addColumn<QString>("program");
    QTest::addColumn<int>("shape");
    const auto row = [this](const char* name, const std::string& program, Shape shape) {
      m_shapes.push_back(std::move(shape));
      QTest::newRow(name) << QString::fromStdString(program)
                          << static_cast<int>(m_shapes.size()) - 1;
    };
    const Place here{10.0, 20.0};
    row("251 about its middle",
        cycle("251", "Q218=40 Q219=30 Q220=6 Q224=0 Q367=0 Q370=1 Q366=0" + kPocket),
        rectangle(here, 40, 30, 6));
    row("251 turned, with the radius of the tool, by a helix",
        cycle("251", "Q218=40 Q219=30 Q220=0 Q224=30 Q367=0 Q370=1.4 Q366=1" + kPocket),
        rectangle(here, 40, 30, 4, 30));
    row("251 from its lower left corner",
        cycle("251", "Q218=40 Q219=30 Q220=5 Q224=0 Q367=1 Q370=1 Q366=2" + kPocket),
        rectangle({30, 35}, 40, 30, 5));
    row("251 from its upper left corner, turned",
        cycle("251", "Q218=40 Q219=30 Q220=5 Q224=90 Q367=4 Q370=1 Q366=1" + kPocket),
        rectangle({25, 40}, 30, 40, 5));
    row("251 roughs and finishes",
        cycle("251",
              "Q218=40 Q219=30 Q220=6 Q224=0 Q367=0 Q370=1 Q366=1 Q215=0 Q368=0.5 Q207=500"
              " Q351=-1 Q202=2.5 Q369=0.3 Q338=0 Q385=300 "),
        rectangle(here, 40, 30, 6));
    row("251 only roughs",
        cycle("251",
              "Q218=40 Q219=30 Q220=6 Q224=0 Q367=0 Q370=1 Q366=0 Q215=1"
              " Q368=0.5 Q207=500 Q351=1 Q202=2.5 Q369=0 Q338=0 "),
        rectangle(here, 39, 29, 5.5));
    row("252", cycle("252", "Q223=35 Q370=1 Q366=1" + kPocket), circle(here, 35));
    row("253 about its middle", cycle("253", "Q218=40 Q219=12 Q374=20 Q367=0 Q366=1" + kPocket),
        rectangle(here, 40, 12, 6, 20));
    row("253 from the middle of its left circle, as wide as the tool",
        cycle("253", "Q218=40 Q219=8 Q374=0 Q367=2 Q366=2" + kPocket),
        rectangle({26, 20}, 40, 8, 4));
    row("254",
        cycle("254",
              "Q219=12 Q375=60 Q367=0 Q216=0 Q217=0 Q376=30 Q248=80 Q378=0 Q377=1"
              " Q366=2" +
                  kPocket),
        arcSlot({0, 0}, 60, 30, 80, 12));
    row("254 twice, against the feed",
        cycle("254",
              "Q219=10 Q375=60 Q367=0 Q216=5 Q217=0 Q376=0 Q248=45 Q378=180 Q377=2 Q366=0"
              " Q215=0 Q368=0 Q207=500 Q351=-1 Q202=2.5 Q369=0 Q338=0 Q385=300 "),
        both(arcSlot({5, 0}, 60, 0, 45, 10), arcSlot({5, 0}, 60, 180, 45, 10)));
    row("208", cycle("208", "Q334=1.5 Q335=15 Q342=0 Q351=1"), circle(here, 15));
    row("208 of a bore before it", cycle("208", "Q334=1.5 Q335=20 Q342=8 Q351=-1"),
        besideHole(circle(here, 20), circle(here, 8)));
    row("4",
        "L Z+2 FMAX\nCYCL DEF 4.0 POCKET MILLING\nCYCL DEF 4.1 SET UP 2\nCYCL DEF 4.2 DEPTH -6"
        "\nCYCL DEF 4.3 PECKG 2.5 F150\nCYCL DEF 4.4 X+40\nCYCL DEF 4.5 Y+30\n"
        "CYCL DEF 4.6 F500 DR- RADIUS 7\nCYCL CALL",
        rectangle(here, 40, 30, 7));
    row("5",
        "L Z+2 FMAX\nCYCL DEF 5.0 KREISTASCHE\nCYCL DEF 5.1 ABST 2\nCYCL DEF 5.2 TIEFE -6\n"
        "CYCL DEF 5.3 ZUSTLG 2,5 F150\nCYCL DEF 5.4 RADIUS 17.5\nCYCL DEF 5.5 F500 DR+\n"
        "CYCL CALL",
        circle(here, 35));
  }
  void shape() {
    QFETCH(const QString, program);
    QFETCH(const int, shape);
    const Cut cut = cutOf(program.toStdString());
    QVERIFY2(cut.fault.empty(), cut.fault.c_str());
    QCOMPARE(cut.lowest, -6.0);
    const std::string difference = differenceAt(cut, -6.0, m_shapes[static_cast<size_t>(shape)]);
    QVERIFY2(difference.empty(), difference.c_str());
    const bool isOld = program.contains("CYCL DEF 4.0") || program.contains("CYCL DEF 5.0");
    const std::string planes = faultOfPlanes(cut, isOld ? 2.0 : 50.0);
    QVERIFY2(planes.empty(), planes.c_str());
    for (const double feed : cut.feeds) {
      QVERIFY2(feed == 150.0 || feed == 500.0 || feed == 300.0, std::to_string(feed).c_str());
    }
    // Nothing is cut deeper at a time than Q202 says.
    const double infeed = program.contains("208") ? 6.0 : 2.5;
    std::set<double> levels{0.0};
    for (std::size_t i = 1; i < cut.points.size(); ++i) {
      const bool isFlat = std::abs(cut.points[i].z - cut.points[i - 1].z) < 1e-9;
      if (!cut.isRapid[i] && isFlat && cut.points[i].z < 0.0) {
        levels.insert(cut.points[i].z);
      }
    }
    for (auto level = std::next(levels.begin()); level != levels.end(); ++level) {
      QVERIFY(*level - *std::prev(level) <= infeed + 1e-6);
    }
  }
  /// What the judge would say of other shapes than the programmed one.
  void wrongShapes() {
    const std::string good = "Q218=40 Q219=30 Q220=6 Q224=0 Q367=0 Q370=1 Q366=0" + kPocket;
    const Shape shape = rectangle({10, 20}, 40, 30, 6);
    QVERIFY(differenceAt(cutOf(cycle("251", good)), -6.0, shape).empty());
    for (const auto& [from, to] :
         std::vector<std::pair<std::string, std::string>>{{"Q218=40", "Q218=40.2"},
                                                          {"Q219=30", "Q219=29.5"},
                                                          {"Q220=6", "Q220=4"},
                                                          {"Q224=0", "Q224=3"},
                                                          {"Q367=0", "Q367=1"},
                                                          {"Q215=0 Q368=0", "Q215=1 Q368=0.3"}}) {
      std::string bad = good;
      bad.replace(bad.find(from), from.size(), to);
      QVERIFY2(!differenceAt(cutOf(cycle("251", bad)), -6.0, shape).empty(), to.c_str());
    }
    // A tool that is smaller than the control takes it to be.
    QVERIFY(!differenceAt(cutOf(cycle("251", good)), -6.0, shape, 3.4).empty());
  }
  void studs() {
    const std::string common =
        " Q368=0 Q207=500 Q351=1 Q202=2.5 Q370=1 Q201=-6 Q206=150 Q200=2 Q203=+0 Q204=50\n"
        "CYCL CALL";
    const auto leaves = [](const Cut& cut, const Shape& stud, const Shape& blank) {
      const std::vector<Stroke> strokes = cut.strokesAt(-6.0);
      for (double x = -40.0; x <= 60.0; x += 0.5) {
        for (double y = -30.0; y <= 70.0; y += 0.5) {
          const bool isCut = std::any_of(strokes.begin(), strokes.end(), [&](const Stroke& s) {
            return distanceTo({x, y}, s) < kToolRadius;
          });
          const bool isStud = stud({x, y}) < -0.02;
          const bool isWaste = stud({x, y}) > 0.02 && blank({x, y}) < 0.0;
          if ((isStud && isCut) || (isWaste && !isCut)) {
            return false;
          }
        }
      }
      return true;
    };
    const Cut square =
        cutOf("CYCL DEF 256 Q218=30 Q424=42 Q219=20 Q425=24 Q220=3 Q224=15 Q367=0" + common);
    QVERIFY2(square.fault.empty(), square.fault.c_str());
    QVERIFY(leaves(square, rectangle({10, 20}, 30, 20, 3, 15), rectangle({10, 20}, 42, 24, 0, 15)));
    QVERIFY(
        !leaves(square, rectangle({10, 20}, 30.3, 20, 3, 15), rectangle({10, 20}, 42, 24, 0, 15)));
    const Cut round = cutOf("CYCL DEF 257 Q223=30 Q222=50 Q376=-1" + common);
    QVERIFY2(round.fault.empty(), round.fault.c_str());
    QVERIFY(leaves(round, circle({10, 20}, 30), circle({10, 20}, 50)));
    QCOMPARE(faultOfPlanes(round, 50.0), std::string());
  }
  void threads() {
    // M16, climb: a right-handed thread within rises and turns to the left.
    const std::string common = " Q335=16 Q239=+2 Q201=-10 Q253=700 Q200=2 Q203=+0 Q204=50 Q207=400";
    const Cut cut = cutOf("CYCL DEF 262" + common + " Q355=1 Q351=+1\nCYCL CALL");
    QVERIFY2(cut.fault.empty(), cut.fault.c_str());
    QCOMPARE(faultOfPlanes(cut, 50.0), std::string());
    double turned = 0.0;
    double from = 0.0;
    double to = 0.0;
    for (std::size_t i = 1; i < cut.points.size(); ++i) {
      const base::Vec3 a = cut.points[i - 1] - base::Vec3{10, 20, 0};
      const base::Vec3 b = cut.points[i] - base::Vec3{10, 20, 0};
      const bool isOnThread = std::abs(std::hypot(a.x, a.y) - 4.0) < 1e-6 &&
                              std::abs(std::hypot(b.x, b.y) - 4.0) < 1e-6;
      if (isOnThread) {
        from = turned == 0.0 ? a.z : from;
        to = b.z;
        turned += std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
      }
    }
    const double turns = turned / (2.0 * std::numbers::pi);
    QVERIFY(std::abs(turns - 5.0) < 1e-6);                // counterclockwise, 10 mm of pitch 2
    QVERIFY(std::abs((to - from) / turns - 2.0) < 1e-6);  // upwards
    QCOMPARE(from, -10.0);
    // Not the other hand, and not against the feed.
    for (const std::string other : {" Q355=1 Q351=-1", " Q355=0 Q351=+1"}) {
      const Cut wrong = cutOf("CYCL DEF 262" + common + other + "\nCYCL CALL");
      QVERIFY(wrong.fault.empty());
      QVERIFY(wrong.points != cut.points);
    }
  }
  void face() {
    const Cut cut = cutOf(
        "CYCL DEF 232 Q389=0 Q225=-10 Q226=-5 Q227=+2 Q386=-1 Q218=50 Q219=30 Q202=2 Q369=0.5"
        " Q370=1 Q207=500 Q385=300 Q253=2000 Q200=2 Q357=2 Q204=50\nCYCL CALL");
    QVERIFY2(cut.fault.empty(), cut.fault.c_str());
    QCOMPARE(cut.lowest, -1.0);
    const std::vector<Stroke> strokes = cut.strokesAt(-1.0);
    for (double x = -10.0; x <= 40.0; x += 0.5) {
      for (double y = -5.0; y <= 25.0; y += 0.5) {
        QVERIFY(std::any_of(strokes.begin(), strokes.end(), [&](const Stroke& stroke) {
          return distanceTo({x, y}, stroke) <= kToolRadius;
        }));
      }
    }
    QVERIFY(cut.feeds.contains(300.0) && cut.feeds.contains(500.0));
  }
  /// What is not made is refused by the name of the parameter.
  void refused_data() {
    QTest::addColumn<QString>("program");
    QTest::addColumn<QString>("names");
    const auto row = [](const char* name, const std::string& program, const char* names) {
      QTest::newRow(name) << QString::fromStdString(program) << QString(names);
    };
    const std::string rest = " Q224=0 Q367=0 Q370=1 Q366=0" + kPocket;
    row("too narrow", cycle("251", "Q218=40 Q219=7 Q220=0" + rest), "tool radius");
    row("a corner smaller than the tool", cycle("251", "Q218=40 Q219=30 Q220=2" + rest), "Q220");
    row("rings too far apart", cycle("252", "Q223=35 Q370=2.5 Q366=0" + kPocket), "Q370");
    row("no room for a helix", cycle("252", "Q223=8.2 Q370=1 Q366=1" + kPocket), "tool radius");
    row("a core is left", cycle("208", "Q334=1.5 Q335=20 Q342=0 Q351=1"), "Q342");
    row("thousands of infeeds",
        cycle("252", "Q223=35 Q370=1 Q366=0 Q215=0 Q368=0 Q207=500 Q351=1 Q202=0.001"), "Q202");
    row("millions of moves",
        cycle("252", "Q223=900 Q370=0.5 Q366=0 Q215=0 Q368=0 Q207=500 Q351=1 Q202=0.01"),
        "number of moves");
    row("from where is not known",
        "L X+5 R0 FMAX M91\n" + cycle("252", "Q223=35 Q370=1 Q366=0" + kPocket), "increment of X");
    row("how it cuts is left to GLOBAL DEF",
        cycle("252", "Q223=35 Q370=1 Q366=0 Q215=0 Q368=0 Q207=500 Q351=0 Q202=2.5"), "Q351");
    row("254 by the end of the slot",
        cycle("254", "Q219=12 Q375=60 Q367=3 Q216=0 Q217=0 Q376=30 Q248=80 Q378=0 Q377=1 Q366=2" +
                         kPocket),
        "Q367");
  }
  void refused() {
    QFETCH(const QString, program);
    QFETCH(const QString, names);
    const Cut cut = cutOf(program.toStdString());
    QVERIFY2(QString::fromStdString(cut.fault).contains(names), cut.fault.c_str());
  }
  void radiusNotKnown() {
    const Cut cut = cutOf(cycle("252", "Q223=35 Q370=1 Q366=1" + kPocket), "");
    QVERIFY2(QString::fromStdString(cut.fault).contains("Q108"), cut.fault.c_str());
  }
  void radiusOfTheMachine() {
    gcode::LoadOptions options;
    options.dialect = gcode::Dialect::Heidenhain;
    options.toolRadiusMm = [](int number, std::string_view name) -> std::optional<double> {
      return number == 7 || name == "MILL_8" ? std::optional(4.0) : std::nullopt;
    };
    for (const std::string tool : {"7", "\"MILL_8\"", "8"}) {
      const auto program = gcode::interpretProgram(
          "T.H",
          "BEGIN PGM T MM\nTOOL CALL " + tool + " Z S2000 DR+0.5\nQ1=Q108\nL X+Q1 Z+50 FMAX\n" +
              "END PGM T MM\n",
          options);
      QVERIFY(program.has_value());
      QCOMPARE(program->isUnderstood(), tool != "8");
      if (program->isUnderstood()) {
        QCOMPARE(program->trajectory.points.front().positionMm.x, 4.5);
      }
    }
  }

 private:
  std::vector<Shape> m_shapes;
};

RIVULET_TEST(TestKlartextShapes)
#include "tst_klartext_shapes.moc"
