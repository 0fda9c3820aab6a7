// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Programs from many CAM systems and senders, against facts counted by an independent script.
// The collection lies beside the checkout where it exists; its licences do not let it live here.

#include <QFile>
#include <QHash>
#include <QRegularExpression>
#include <QtTest>

#include "base/units.h"
#include "gcode/program.h"
#include "gcode_text.h"

using namespace rivulet;

namespace {

const QString kCorpus = QStringLiteral(RIVULET_SOURCE_DIR "/../shared/corpus/");

/// INDEX.tsv: path → (column name → text).
QHash<QString, QHash<QString, QString>> readIndex() {
  QHash<QString, QHash<QString, QString>> index;
  QFile file(kCorpus + QStringLiteral("INDEX.tsv"));
  if (!file.open(QIODevice::ReadOnly)) {
    return index;
  }
  const QStringList lines = QString::fromUtf8(file.readAll()).split(QLatin1Char('\n'));
  const QStringList names = lines.first().split(QLatin1Char('\t'));
  for (const QString& line : lines.mid(1)) {
    const QStringList fields = line.split(QLatin1Char('\t'));
    for (qsizetype i = 0; i < std::min(fields.size(), names.size()); ++i) {
      index[fields.first()][names[i]] = fields[i];
    }
  }
  return index;
}

/// Facts are rounded to three decimals (coordinates to four) in the unit of the file.
constexpr double kTolerance = 1e-3;

}  // namespace

class TestCorpus : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void agreesWithTheIndex_data() {
    QTest::addColumn<QString>("path");
    QTest::addColumn<bool>("streamable");
    const auto add = [](const char* path, bool streamable = true) {
      QTest::newRow(path) << QString::fromLatin1(path) << streamable;
    };
    add("pygcode/Scorpion.tap");
    add("pygcode/Disc3.tap");
    add("pygcode/vertical-slot.ngc");
    add("pygcode/Clamp.nc");
    add("pygcode/Heart.tap");
    add("pygcode/Letter_A_V-Carve_.tap");
    add("pygcode/Tweakie_s_CNC_Cube.nc");
    add("pygcode/plug6a.tap", false);  // M10 P1 asks a sender's macro for something
    add("blendercam/Cross.gcode");
    add("blendercam/HelixEnter.gcode");
    add("blendercam/Op_Parallel_OCL.gcode");
    add("blendercam/Text_MedialPocket.gcode");
    add("blendercam/Waterline_Internal.gcode");
    add("gcode-toolpath/arc-no-plane.nc");
    add("gcode-toolpath/arc-xy-plane.nc");
    add("gcode-toolpath/arc-yz-plane.nc");
    add("gcode-toolpath/arc-zx-plane.nc");
    add("gcode-toolpath/circle.nc");
    add("gcode-toolpath/one-inch-circle.nc");
    add("gcode-toolpath/arc-r.nc", false);    // two arcs have no centre
    add("gcode-toolpath/t2laser.nc", false);  // G92 moves the frame
    add("fluidnc/arcs_arrows.nc");
    add("fluidnc/raster_tree.nc");
    add("fluidnc/spindle_testing.nc");
    add("grbl-plotter/gcode_absolute_and_relative.nc");
    add("linuxcnc/arcspiral.ngc");
    add("linuxcnc/lathe_pawn.ngc", false);  // G8 is LinuxCNC's radius programming
    add("linuxcnc/test_12mmflat.ngc");
    add("nx-postprocessor/finish_profile_0918.ptp");
  }

  void agreesWithTheIndex() {
    QFETCH(const QString, path);
    QFETCH(const bool, streamable);
    static const QHash<QString, QHash<QString, QString>> index = readIndex();
    if (index.isEmpty()) {
      QSKIP("the collection of foreign NC programs is not beside this checkout");
    }
    const QHash<QString, QString> facts = index.value(path);
    QVERIFY2(!facts.isEmpty(), "the index knows the program");

    const auto program = gcode::loadProgram((kCorpus + path).toStdString());
    QVERIFY2(program.has_value(), program ? "" : program.error().text().c_str());
    const std::string problems = test::printProblems(program->diagnostics);
    QVERIFY2(program->isStreamable() == streamable, problems.c_str());

    const gcode::Statistics& statistics = program->statistics;
    QCOMPARE(statistics.lines, facts[QStringLiteral("lines")].toULongLong());
    QCOMPARE(statistics.points, program->trajectory.points.size());
    for (std::size_t motion = 0; motion < statistics.motions.size(); ++motion) {
      std::size_t expected = facts[QStringLiteral("n_G%1").arg(motion)].toULongLong();
      expected += motion == 1 ? facts[QStringLiteral("n_Gdefault")].toULongLong() : 0;
      QCOMPARE(statistics.motions[motion], expected);
    }
    const double factor =
        facts[QStringLiteral("units")] == QStringLiteral("in") ? base::kMmPerInch : 1.0;

    static const QRegularExpression box(QStringLiteral("([XYZ])\\[([^,]+),([^\\]]+)\\]"));
    auto match = box.globalMatch(facts[QStringLiteral("bbox_programmed")]);
    std::array<bool, base::kAxisCount> seen{};
    while (match.hasNext()) {
      const auto axis = match.next();
      const auto i = static_cast<std::size_t>(axis.captured(1).at(0).unicode() - u'X');
      seen[i] = true;
      QVERIFY(std::abs(statistics.minMm[i] / factor - axis.captured(2).toDouble()) < kTolerance);
      QVERIFY(std::abs(statistics.maxMm[i] / factor - axis.captured(3).toDouble()) < kTolerance);
    }
    for (std::size_t i = 0; i < base::kAxisCount; ++i) {
      QCOMPARE(std::isfinite(statistics.minMm[i]), seen[i]);
    }

    const double expectedLength = facts[QStringLiteral("g1_length")].toDouble() +
                                  facts[QStringLiteral("arc_length")].toDouble();
    if (facts[QStringLiteral("arc_length")] == QStringLiteral("unknown") ||
        facts[QStringLiteral("g1_length")] == QStringLiteral("unknown")) {
      return;  // the script itself could not say
    }
    const double length = statistics.cutLengthMm / factor;
    // Where rounding makes the radii of an arc differ, the index takes the start's, we the mean.
    const double rounding = facts[QStringLiteral("arc_radius_mismatch")].toDouble() * M_PI *
                            static_cast<double>(statistics.motions[2] + statistics.motions[3]);
    QVERIFY2(std::abs(length - expectedLength) < 2.0 * kTolerance + rounding,
             qPrintable(QStringLiteral("%1 instead of %2")
                            .arg(length, 0, 'f', 4)
                            .arg(expectedLength, 0, 'f', 4)));

    QStringList feeds;
    for (const double feed : statistics.feedsMmPerMin) {
      feeds << QString::number(feed / factor, 'g', 10);
    }
    const QString expectedFeeds = facts[QStringLiteral("feeds")];
    if (!expectedFeeds.contains(QStringLiteral(".."))) {
      QCOMPARE(feeds.isEmpty() ? QStringLiteral("none") : feeds.join(QLatin1Char(',')),
               expectedFeeds);
    }
  }

  /// Programs with variables, loops and jumps must never pass for plain ones.
  void refusesWhatItCannotRun() {
    const QHash<QString, QHash<QString, QString>> index = readIndex();
    if (index.isEmpty()) {
      QSKIP("the collection of foreign NC programs is not beside this checkout");
    }
    static const QRegularExpression calculated(
        QStringLiteral("params|DEF|expr|loops|goto|if|cycles|frame|spline|cutter|inverse|rotary|"
                       "subprog|mcs|probe|abs-ijk|polar"));
    int refused = 0;
    for (auto row = index.begin(); row != index.end(); ++row) {
      if (row.key().endsWith(QStringLiteral(".gz")) ||
          !calculated.match(row.value()[QStringLiteral("features")]).hasMatch()) {
        continue;
      }
      const auto program = gcode::loadProgram((kCorpus + row.key()).toStdString());
      if (program) {
        QVERIFY2(!program->isStreamable(), qPrintable(row.key()));
      }
      ++refused;
    }
    QVERIFY(refused > 50);
  }
};

QTEST_APPLESS_MAIN(TestCorpus)
#include "tst_corpus.moc"
