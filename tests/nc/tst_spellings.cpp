// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// One path, many spellings: each program must give the path that was drawn before it was written.
// RIVULET_SPELLINGS_COUNT paths from RIVULET_SPELLINGS_SEED on, each for all controls or for
// RIVULET_SPELLINGS_CONTROL; scripts/meaning runs more of them than ctest does.
//
// Readers that were made wrong to see that this finds it: AC() read as an increment under G91 (111
// of 500 paths of SINUMERIK differ), a frame that stays after the return of PROC SAVE (14).

#include <QtTest>
#include <cmath>
#include <cstdio>

#include "gcode/program.h"
#include "spellings.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace rivulet::tests;

namespace {

/// Programs are written with twelve decimals. A centre that follows from a radius, a tangent or a
/// third point is less exact than its numbers.
constexpr double kEndMm = 1e-9;
constexpr double kCentreMm = 1e-8;
constexpr double kFeedShare = 1e-9;
/// Differences that are made small; the others are counted.
constexpr std::size_t kShrunkMax = 100;

gcode::Dialect dialectOf(Control control) {
  const std::optional<gcode::Dialect> own = gcode::dialectOfName(controlName(control));
  return own ? *own : *gcode::dialectOfName("iso");
}

struct Reading {
  std::string difference;              ///< "": none
  std::map<std::string, int> refused;  ///< word → how often
};

std::string textOf(base::Vec3 v) {
  return QString::asprintf("%.10f %.10f %.10f", v.x, v.y, v.z).toStdString();
}

std::string differenceOf(const std::vector<PathMove>& path, gcode::Trajectory trajectory) {
  // Where a place is named again, nothing moves.
  for (std::size_t i = trajectory.points.size(); i-- > 1;) {
    const bool isArc = trajectory.points[i].kind == gcode::MoveKind::Arc;
    if (!isArc && base::distance(trajectory.points[i].positionMm,
                                 trajectory.points[i - 1].positionMm) <= kEndMm) {
      trajectory.points.erase(trajectory.points.begin() + static_cast<std::ptrdiff_t>(i));
      for (gcode::KeptArc& arc : trajectory.arcs) {
        arc.point -= arc.point > i ? 1 : 0;
      }
    }
  }
  if (trajectory.points.size() != path.size()) {
    return "moves: " + std::to_string(path.size()) + ", read " +
           std::to_string(trajectory.points.size());
  }
  std::map<std::size_t, const gcode::KeptArc*> arcs;
  for (const gcode::KeptArc& arc : trajectory.arcs) {
    arcs[arc.point] = &arc;
  }
  for (std::size_t i = 0; i < path.size(); ++i) {
    const PathMove& move = path[i];
    const gcode::TrajectoryPoint& point = trajectory.points[i];
    const std::string where =
        "move " + std::to_string(i + 1) + ", line " + std::to_string(point.line.value) + ": ";
    if (!(base::distance(move.end, point.positionMm) <= kEndMm)) {
      return where + "ends at " + textOf(move.end) + ", read " + textOf(point.positionMm);
    }
    const bool isArc = move.kind == PathMove::Kind::Arc;
    if ((point.kind == gcode::MoveKind::Rapid) != (move.kind == PathMove::Kind::Rapid) ||
        (point.kind == gcode::MoveKind::Arc) != isArc) {
      return where + "another kind of move";
    }
    if (isArc) {
      const gcode::KeptArc& arc = *arcs.at(i);
      const base::Vec3 apart = arc.centreMm - move.centre;
      const double off = base::norm(apart - base::dot(apart, move.axis) * move.axis);
      const double sweep = arc.sweepRad * 180.0 / std::acos(-1.0);
      if (!(off <= kCentreMm) || base::norm(arc.axis - move.axis) > 1e-9 ||
          std::abs(sweep - move.sweepDeg) > 1e-7) {
        return where + "turns about " + textOf(move.centre) + " axis " + textOf(move.axis) +
               " by " + std::to_string(move.sweepDeg) + ", read " + textOf(arc.centreMm) +
               " axis " + textOf(arc.axis) + " by " + std::to_string(sweep);
      }
    }
    const double feed = point.feedMmPerS * 60.0;
    if (move.kind != PathMove::Kind::Rapid &&
        !(std::abs(feed - move.feed) <= kFeedShare * move.feed)) {
      return where + "feed " + std::to_string(move.feed) + ", read " + std::to_string(feed);
    }
  }
  return {};
}

Reading readingOf(const std::vector<DrawnMove>& moves, const Spelling& spelling) {
  const Written written = writePath(moves, spelling);
  gcode::LoadOptions options;
  options.dialect = dialectOf(spelling.control);
  options.keepArcs = true;
  options.subprogram = [&written](std::string_view name) -> std::optional<nc::LoadedText> {
    const auto found = written.beside.find(name);
    return found == written.beside.end()
               ? std::nullopt
               : std::optional(nc::LoadedText{found->second, std::string(name) + ".SPF"});
  };
  const auto program = gcode::interpretProgram("DRAWN", written.text, options);
  Reading reading;
  if (!program) {
    reading.difference = "nothing read: " + program.error().text();
    return reading;
  }
  for (const gcode::Diagnostic& each : program->diagnostics) {
    if (each.severity != gcode::Severity::Error) {
      continue;
    }
    const std::string_view code = gcode::diagnosticName(each.code);
    // A word that is not made is refused by its name; anything else has been misread.
    if (code == "unsupported-g-code" || code == "cycle-not-run") {
      ++reading.refused[each.argument];
    } else if (reading.difference.empty()) {
      reading.difference = "line " + std::to_string(each.line.value) + ": " + std::string(code) +
                           " " + each.argument;
    }
  }
  if (!reading.refused.empty()) {
    reading.difference.clear();  // what follows from it
  } else if (reading.difference.empty()) {
    reading.difference = differenceOf(pathOf(moves), program->trajectory);
  }
  return reading;
}

std::size_t variableOf(const char* name, std::size_t otherwise) {
  bool isNumber = false;
  const qulonglong value = qEnvironmentVariable(name).toULongLong(&isNumber);
  return isNumber ? static_cast<std::size_t>(value) : otherwise;
}

/// The smallest program that still differs: moves are dropped, then ways of writing.
void shrink(std::vector<DrawnMove>& moves, Spelling& spelling) {
  const auto differs = [](const std::vector<DrawnMove>& some, const Spelling& how) {
    return !pathOf(some).empty() && !readingOf(some, how).difference.empty();
  };
  bool smaller = true;
  while (smaller) {
    smaller = false;
    // The first move names the place.
    for (std::size_t i = moves.size(); i-- > 1;) {
      std::vector<DrawnMove> fewer = moves;
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
      if (differs(fewer, spelling)) {
        moves = fewer;
        smaller = true;
      }
    }
    for (int each = 0; each < static_cast<int>(Feature::Count); ++each) {
      Spelling plainer = spelling;
      if (plainer.without.insert(static_cast<Feature>(each)).second && differs(moves, plainer)) {
        spelling = plainer;
        smaller = true;
      }
    }
  }
}

std::string usedBy(const Written& written) {
  std::string used;
  for (const Feature feature : written.used) {
    used += (used.empty() ? "" : " ") + std::string(featureName(feature));
  }
  return used;
}

void print(const std::vector<DrawnMove>& moves, const Spelling& spelling, std::uint64_t seed,
           const std::string& difference) {
  const Written written = writePath(moves, spelling);
  std::string text = written.text;
  std::replace(text.begin(), text.end(), '\r', '\n');
  for (const auto& [name, more] : written.beside) {
    text += "--- " + name + "\n" + more;
  }
  const std::string control(controlName(spelling.control));
  std::fprintf(stderr,
               "%s\n%s (%s)\nRIVULET_SPELLINGS_SEED=%llu RIVULET_SPELLINGS_COUNT=1 "
               "RIVULET_SPELLINGS_CONTROL=%s tests_nc tst_spellings\n%s\n",
               difference.c_str(), control.c_str(), usedBy(written).c_str(),
               static_cast<unsigned long long>(seed), control.c_str(), text.c_str());
}

}  // namespace

class TestSpellings : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void samePath_data() {
    QTest::addColumn<int>("control");
    for (const Control control : kControls) {
      QTest::newRow(std::string(controlName(control)).c_str()) << static_cast<int>(control);
    }
  }
  void samePath() {
    QFETCH(const int, control);
    const QString only = qEnvironmentVariable("RIVULET_SPELLINGS_CONTROL");
    Spelling spelling;
    spelling.control = static_cast<Control>(control);
    if (!only.isEmpty() && only.toStdString() != controlName(spelling.control)) {
      QSKIP("another control was asked for");
    }
    const std::size_t first = variableOf("RIVULET_SPELLINGS_SEED", 1);
    const std::size_t count = variableOf("RIVULET_SPELLINGS_COUNT", 500);
    std::size_t same = 0;
    std::size_t refused = 0;
    std::size_t different = 0;
    std::map<std::string, int> words;
    std::map<std::string, int> kinds;  // of differences, by the ways of writing that they need
    std::map<Feature, int> used;
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint64_t seed = first + i;
      const std::vector<DrawnMove> moves = drawMoves(seed);
      spelling.seed = seed;
      if (pathOf(moves).empty()) {
        continue;
      }
      const Reading reading = readingOf(moves, spelling);
      if (!reading.refused.empty()) {
        ++refused;
        for (const auto& [word, times] : reading.refused) {
          ++words[word];
        }
      } else if (!reading.difference.empty()) {
        ++different;
        if (different <= kShrunkMax) {
          std::vector<DrawnMove> fewer = moves;
          Spelling plainer = spelling;
          shrink(fewer, plainer);
          // One of each kind is shown.
          if (++kinds[usedBy(writePath(fewer, plainer))] == 1) {
            print(fewer, plainer, seed, readingOf(fewer, plainer).difference);
          }
        }
      } else {
        ++same;
        for (const Feature feature : writePath(moves, spelling).used) {
          ++used[feature];
        }
      }
      if (qEnvironmentVariableIsSet("RIVULET_SPELLINGS_PRINT")) {
        print(moves, spelling, seed, {});
      }
    }
    QString text = QStringLiteral("%1: %2 the same, %3 different, %4 refused")
                       .arg(QString::fromStdString(std::string(controlName(spelling.control))))
                       .arg(same)
                       .arg(different)
                       .arg(refused);
    for (const auto& [word, times] : words) {
      text += QStringLiteral("\n  refused %1: %2").arg(times).arg(QString::fromStdString(word));
    }
    for (const auto& [kind, times] : kinds) {
      text += QStringLiteral("\n  different %1: %2").arg(times).arg(QString::fromStdString(kind));
    }
    text += QStringLiteral("\n  written:");
    for (const auto& [feature, times] : used) {
      text += QStringLiteral(" %1 %2")
                  .arg(QString::fromStdString(std::string(featureName(feature))))
                  .arg(times);
    }
    qInfo().noquote() << text;
    QCOMPARE(different, std::size_t{0});
  }
};

RIVULET_TEST(TestSpellings)
#include "tst_spellings.moc"
