// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Pauses of method window on the NC programs of many CAM systems. The collection lies beside the
// checkout where it exists. For every program: 90 % of the pauses are off the cut, or no way to cut
// windows of M points has fewer in the cut, by a count that knows nothing of the optimiser. And:
// where a pause is called off the cut because of a corner, the look-ahead of the virtual machine
// has braked to next to nothing without it.

#include <QDir>
#include <QDirIterator>
#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/units.h"
#include "gcode/program.h"
#include "machine/path_planner.h"
#include "streaming/methods/pause_placement.h"
#include "support/patience.h"
#include "support/test_program.h"
#include "templates/cells.h"

using namespace rivulet;

namespace {

using Points = std::vector<gcode::StreamPoint>;

const QString kCorpus = QStringLiteral(RIVULET_SOURCE_DIR "/../shared/corpus/");
constexpr std::size_t kDefaultPoints = 7;  // of the HMI
constexpr double kShareOffCut = 0.9;
constexpr double kFeedMmPerMin = 2000.0;  // of the HMI
/// What is left of the feed at a corner that is called off the cut.
constexpr double kNextToNothing = 0.12;

std::size_t largestWindow(int rParameters) {
  templates::TemplateParameters parameters;
  parameters.rParameterCount = rParameters;
  return static_cast<std::size_t>(templates::pointsPerLoopMax(parameters));
}

/// The file itself, or what gzip holds.
QString plainFile(const QString& path, const QTemporaryDir& folder) {
  if (!path.endsWith(QStringLiteral(".gz"))) {
    return path;
  }
  const QString plain = folder.filePath(QFileInfo(path).completeBaseName());
  QProcess gzip;
  gzip.setStandardOutputFile(plain);
  gzip.start(QStringLiteral("gzip"), {QStringLiteral("-dc"), path});
  return gzip.waitForFinished(tests::kSoonMs) && gzip.exitCode() == 0 ? plain : QString();
}

/// Every pause must lie somewhere, and between two places off the cut at most M points may lie in
/// one window: a run of L points needs ceil(L / M) windows, so that many less one pauses inside.
std::size_t fewestInCut(const std::vector<bool>& harmless, std::size_t perWindow) {
  std::size_t fewest = 0;
  std::size_t run = 0;
  for (const bool isPlace : harmless) {
    ++run;
    if (isPlace) {
      fewest += (run + perWindow - 1) / perWindow - 1;
      run = 0;
    }
  }
  return fewest;
}

double turnDegrees(const Points& points, std::size_t i) {
  const base::Vec3 in = points[i].positionMm - points[i - 1].positionMm;
  const base::Vec3 out = points[i + 1].positionMm - points[i].positionMm;
  const base::Vec3 across{in.y * out.z - in.z * out.y, in.z * out.x - in.x * out.z,
                          in.x * out.y - in.y * out.x};
  return std::atan2(base::norm(across), base::dot(in, out)) * 180.0 / std::numbers::pi;
}

bool isCorner(const Points& points, std::size_t i) {
  return i > 0 && i + 1 < points.size() && turnDegrees(points, i) >= streaming::kCornerDegrees;
}

/// The lowest speed from the middle of the block that ends at a point to that of the next one.
std::vector<double> lowestSpeeds(const Points& points, const machine::MachineConfig& config,
                                 double feedMmPerS) {
  machine::PathPlanner planner(config, points.front().positionMm - base::Vec3{1.0, 0.0, 0.0});
  std::vector<double> lowest(points.size(), feedMmPerS);
  std::vector<trace::ExecutedBlock> executed;
  base::Instant now{};
  std::size_t appended = 0;
  std::size_t done = 0;
  const auto see = [&](std::size_t point) {
    lowest[point] = std::min(lowest[point], planner.speedMmPerS());
  };
  while (done < points.size()) {
    for (; appended < points.size() && planner.blockCount() < 200; ++appended) {
      machine::PreparedMotion block;
      block.line = points[appended].line;
      block.targetMm = points[appended].positionMm;
      block.feedMmPerS = feedMmPerS;
      block.roundingMm = config.roundingMm;
      block.dynamics = config.resetDynamics;
      block.end = machine::BlockEnd::Rounded;
      planner.append(block);
    }
    executed.clear();
    planner.step(now += config.interpolationCycle, executed);
    for (std::size_t ended = 0; ended < executed.size(); ++ended) {
      see(done++);
    }
    if (done < points.size()) {
      if (planner.pathShare() >= 0.5) {
        see(done);
      } else if (done > 0) {
        see(done - 1);
      }
    }
  }
  return lowest;
}

double quantile(std::vector<double>& values, double share) {
  if (values.empty()) {
    return 0.0;
  }
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

struct Loaded {
  QString name;
  Points points;
};

}  // namespace

class TestPauseCorpus : public QObject {
  Q_OBJECT

 private:
  std::vector<Loaded> m_programs;  ///< what loads and can be streamed, of two windows or more

 private Q_SLOTS:
  void initTestCase() {
    if (!QFileInfo::exists(kCorpus)) {
      QSKIP("there is no collection of programs beside the checkout");
    }
    QStringList paths;
    for (QDirIterator files(kCorpus, QDir::Files, QDirIterator::Subdirectories); files.hasNext();) {
      const QString path = files.next();
      // derived-large: programs of the collection joined end to end.
      if (!path.contains(QStringLiteral("/oracle/")) &&
          !path.contains(QStringLiteral("/derived-large/")) &&
          QFileInfo(path).path() != QDir(kCorpus).path()) {
        paths << path;
      }
    }
    paths.sort();
    for (const QString& path : paths) {
      const QTemporaryDir folder;
      const auto program = gcode::loadProgram(plainFile(path, folder).toStdString());
      if (program && program->isStreamable()) {
        Points points = gcode::streamPoints(program->trajectory, {}).points;
        if (points.size() > kDefaultPoints) {
          m_programs.push_back({QDir(kCorpus).relativeFilePath(path), std::move(points)});
        }
      }
    }
    qInfo("%zu programs", m_programs.size());
    QVERIFY(m_programs.size() >= 30);
  }

  void mostPausesAreOffTheCut_data() {
    QTest::addColumn<std::size_t>("perWindow");
    for (const std::size_t perWindow :
         {kDefaultPoints, largestWindow(100), largestWindow(320), largestWindow(1000)}) {
      QTest::addRow("M %zu", perWindow) << perWindow;
    }
  }

  /// Every program, with the windows of the HMI, the largest that fit the usual 100 R-parameters,
  /// and larger ones.
  void mostPausesAreOffTheCut() {
    QFETCH(const std::size_t, perWindow);
    std::size_t programs = 0;
    std::size_t reached = 0;
    std::size_t pauses = 0;
    std::size_t inCut = 0;
    std::size_t evenPauses = 0;
    std::size_t evenInCut = 0;
    for (const Loaded& program : m_programs) {
      if (program.points.size() <= perWindow) {
        continue;
      }
      const auto placed = streaming::placePauses(program.points, perWindow);
      const auto even = streaming::evenPauses(program.points, perWindow);
      const std::size_t bound = fewestInCut(streaming::harmlessPauses(program.points), perWindow);
      const double share =
          1.0 - static_cast<double>(placed.inCut) / static_cast<double>(placed.pauses());
      qInfo("%s: %zu points, %zu pauses, %zu in the cut, bound %zu; evenly %zu, %zu",
            qPrintable(program.name), program.points.size(), placed.pauses(), placed.inCut, bound,
            even.pauses(), even.inCut);
      QVERIFY2(placed.inCut >= bound, qPrintable(program.name));  // or the bound is none
      QVERIFY2(share >= kShareOffCut || placed.inCut == bound, qPrintable(program.name));
      QVERIFY2(placed.inCut <= even.inCut, qPrintable(program.name));
      ++programs;
      reached += share >= kShareOffCut ? 1 : 0;
      pauses += placed.pauses();
      inCut += placed.inCut;
      evenPauses += even.pauses();
      evenInCut += even.inCut;
    }
    QVERIFY(programs > 0);
    qInfo(
        "ALL, M %zu: %zu programs, %zu with 90 %% off the cut, the others at the bound; "
        "%zu pauses, %zu in the cut; evenly %zu, %zu in the cut",
        perWindow, programs, reached, pauses, inCut, evenPauses, evenInCut);
  }

  /// The look-ahead without any STOPRE: what is left of the feed where a pause would be.
  void theMachineBrakesThereAnyway() {
    const auto config = machine::loadPreset("dmu75");
    QVERIFY(config.has_value());
    const double feedMmPerS = base::mmPerSFromMmPerMin(kFeedMmPerMin);
    std::vector<double> corners;
    std::vector<double> rapids;
    std::vector<double> cut;
    for (const Loaded& program : m_programs) {
      if (program.points.size() > 20'000) {
        continue;  // hours of motion; there are enough others
      }
      const std::vector<bool> harmless = streaming::harmlessPauses(program.points);
      const std::vector<double> lowest = lowestSpeeds(program.points, *config, feedMmPerS);
      for (std::size_t i = 1; i + 1 < program.points.size(); ++i) {
        const double left = lowest[i] / feedMmPerS;
        (!harmless[i] ? cut : isCorner(program.points, i) ? corners : rapids).push_back(left);
        // Just above the border a rounded corner is opened a little more.
        QVERIFY2(!isCorner(program.points, i) || left <= kNextToNothing,
                 qPrintable(QStringLiteral("%1, point %2: %3").arg(program.name).arg(i).arg(left)));
      }
    }
    const auto tell = [](const char* where, std::vector<double>& values) {
      qInfo(
          "%s: %zu places, of the feed are left: median %.3f, 90 %% of them below %.3f, all below "
          "%.3f",
          where, values.size(), quantile(values, 0.5), quantile(values, 0.9),
          quantile(values, 1.0));
    };
    tell("corners", corners);
    tell("rapids and retracts that go straight on", rapids);
    tell("in the cut", cut);
    QVERIFY(corners.size() > 1000);
    QVERIFY(quantile(corners, 0.5) < 0.2 * quantile(cut, 0.5));
  }
};

RIVULET_TEST(TestPauseCorpus)
#include "tst_pause_corpus.moc"
