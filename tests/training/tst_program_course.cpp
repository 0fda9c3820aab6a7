// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QFileInfo>
#include <QtTest>

#include "support/test_program.h"
#include "training/program_course.h"
#include "training/recorded_run.h"

using namespace rivulet::training;
using rivulet::base::Vec3;

namespace {

std::vector<Vec3> courseOf(std::string_view program) {
  const auto blocks = parseRecordedProgram(program, {});
  return blocks ? trapezoidCourse(*blocks, {}) : std::vector<Vec3>{};
}

}  // namespace

class TestProgramCourse : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void stopsAtEveryCornerAndKeepsItsLimits() {
    const std::vector<Vec3> mm = courseOf("G61\nF3000\nG1 X12 Y0\nG1 X12 Y12\n");
    QVERIFY(!mm.empty());
    QCOMPARE(mm.front(), (Vec3{}));
    QVERIFY(rivulet::base::distance(mm.back(), {12.0, 12.0, 0.0}) < 1e-9);
    // Trapezoids: 12/50 + 50/540 and 12/50 + 50/450, and a few cycles.
    const double seconds = 0.001 * static_cast<double>(mm.size());
    QVERIFY2(std::abs(seconds - 0.6837) < 0.01, qPrintable(QString::number(seconds)));
    for (std::size_t i = 1; i + 1 < mm.size(); ++i) {
      QVERIFY(std::abs(mm[i + 1].x - 2.0 * mm[i].x + mm[i - 1].x) < 541e-6);
      QVERIFY(std::abs(mm[i + 1].y - 2.0 * mm[i].y + mm[i - 1].y) < 451e-6);
    }
  }

  void roundsACornerWithinItsTolerance() {
    const std::vector<Vec3> mm = courseOf("G64 P0.01\nF360\nG1 X12 Y0\nG1 X12 Y12\n");
    QVERIFY(!mm.empty());
    double nearest = 1.0;
    for (const Vec3& at : mm) {
      nearest = std::min(nearest, rivulet::base::distance(at, {12.0, 0.0, 0.0}));
    }
    QVERIFY2(nearest > 0.008 && nearest < 0.0115, qPrintable(QString::number(nearest)));
    QVERIFY(rivulet::base::distance(mm.back(), {12.0, 12.0, 0.0}) < 1e-9);
  }

  void isTheCourseOfARecording_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<double>("mmMax");
    QTest::newRow("exact stops") << QStringLiteral("G1_g61") << 0.001;
    QTest::newRow("rounded corners") << QStringLiteral("G1_g64p001") << 0.02;
  }
  void isTheCourseOfARecording() {
    QFETCH(QString, name);
    QFETCH(double, mmMax);
    const QString folder = QStringLiteral(RIVULET_SOURCE_DIR "/../shared/groundtruth");
    if (!QFileInfo::exists(folder)) {
      QSKIP("the recordings are not here");
    }
    const auto run = loadRecordedRun(folder.toStdString(), name.toStdString());
    QVERIFY(run);
    const std::vector<Vec3> mm = trapezoidCourse(run->blocks, {});
    const auto moves = [&](const RecordedSample& sample) {
      return rivulet::base::norm(sample.commandMm) > 0.0;
    };
    const auto first = std::ranges::find_if(run->samples, moves);
    const auto ours =
        std::ranges::find_if(mm, [](const Vec3& at) { return rivulet::base::norm(at) > 0.0; });
    QVERIFY(first != run->samples.end() && ours != mm.end());
    // A recording every fourth cycle may begin up to three cycles later.
    double best = 1e9;
    for (int late = 0; late < 4; ++late) {
      double largest = 0.0;
      for (auto sample = first; sample != run->samples.end(); ++sample) {
        const auto cycle = static_cast<std::ptrdiff_t>(
            std::llround((sample->timeS - first->timeS) / 0.001) + late + (ours - mm.begin()));
        const Vec3& at =
            mm[static_cast<std::size_t>(std::min<std::ptrdiff_t>(cycle, std::ssize(mm) - 1))];
        largest = std::max(largest, rivulet::base::distance(at, sample->commandMm));
      }
      best = std::min(best, largest);
    }
    QVERIFY2(best < mmMax, qPrintable(QString::number(best)));
  }
};

RIVULET_TEST(TestProgramCourse)
#include "tst_program_course.moc"
