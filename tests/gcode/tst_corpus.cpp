// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Programs from many CAM systems and senders, against facts found by an independent script, and
// against what two other interpreters made of them. The collection lies beside the checkout where
// it exists; its licences do not let it live here.

#include <QFile>
#include <QFileInfo>
#include <QHash>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QtTest>
#include <cmath>

#include "gcode/program.h"
#include "gcode_text.h"
#include "support/patience.h"
#include "support/test_program.h"

using namespace rivulet;

namespace {

const QString kCorpus = QStringLiteral(RIVULET_SOURCE_DIR "/../shared/corpus/");

using Row = QHash<QString, QString>;

/// INDEX.tsv: path → (column name → text).
QMap<QString, Row> readIndex() {
  QMap<QString, Row> index;
  QFile file(kCorpus + QStringLiteral("INDEX.tsv"));
  if (!file.open(QIODevice::ReadOnly)) {
    return index;
  }
  const QStringList lines = QString::fromUtf8(file.readAll()).split(QLatin1Char('\n'));
  const QStringList names = lines.first().split(QLatin1Char('\t'));
  for (const QString& line : lines.mid(1)) {
    const QStringList fields = line.split(QLatin1Char('\t'));
    for (qsizetype i = 0; fields.size() > 1 && i < std::min(fields.size(), names.size()); ++i) {
      index[fields.first()][names[i]] = fields[i];
    }
  }
  return index;
}

const QMap<QString, Row>& corpusIndex() {
  static const QMap<QString, Row> index = readIndex();
  return index;
}

/// Facts are rounded to three decimals in the unit of the file; 1e-3 is what they may differ by.
constexpr double kTolerance = 1e-3 + 5e-4;

/// Where the index and we differ, and who is right. Each was checked by hand.
struct Difference {
  const char* path;
  const char* fact;
  const char* proof;
};
constexpr Difference kDifferences[] = {
    {"fluidnc/probe.nc", "n_G0",
     "line 25, G43.1 Z#..., gives a tool length; the index counts its Z as a G0 move"},
    {"linuxcnc/good-arc.big.imperial.center-format.ngc", "arc_length",
     "I is calculated, [300 + ...]; the index does not calculate. The radii differ by 0.28 in, so "
     "the length is not known to 1e-3"},
    {"linuxcnc/good-arc.medium.metric.center-format.ngc", "arc_length",
     "I is calculated, [0.9995 * 1000]; the radii differ by 1 mm"},
};

/// Programs that are executed as far as Rivulet can, and refused: no count is claimed.
/// @return why; nullptr: the program is none of them
const char* refusalOf(const QString& path) {
  if (path == QLatin1String("heidenhain-plan/Plan-Beispiel.h")) {
    return "it calls Plan.h, which reads Q108, the tool radius of the control";
  }
  if (path == QLatin1String("nx-postprocessor/training_deckel.h")) {
    return "CYCL DEF 19 tilts the working plane";
  }
  return nullptr;
}

const Difference* differenceOf(const QString& path, const QString& fact) {
  for (const Difference& difference : kDifferences) {
    if (path == QLatin1String(difference.path) && fact == QLatin1String(difference.fact)) {
      return &difference;
    }
  }
  return nullptr;
}

/// "unknown" is what the script could not say; "~" marks a count it does not vouch for.
bool isKnown(const QString& fact) {
  return fact != QStringLiteral("unknown") && !fact.startsWith(QLatin1Char('~'));
}

QString number(double value) {
  return QString::number(value, 'f', 6);
}

/// The file itself, or what gzip holds.
QString plainFile(const QString& path, const QTemporaryDir& folder) {
  if (!path.endsWith(QStringLiteral(".gz"))) {
    return kCorpus + path;
  }
  const QString plain = folder.filePath(QFileInfo(path).completeBaseName());
  QProcess gzip;
  gzip.setStandardOutputFile(plain);
  gzip.start(QStringLiteral("gzip"), {QStringLiteral("-dc"), kCorpus + path});
  return gzip.waitForFinished(tests::kSoonMs) && gzip.exitCode() == 0 ? plain : QString();
}

class Comparison {
 public:
  Comparison(const QString& path, const Row& row, const gcode::Program& program)
      : m_path(path), m_row(row), m_facts(program.facts) {
    check(QStringLiteral("lines"), QString::number(program.statistics.lines));
    for (std::size_t g = 0; g < m_facts.motions.size(); ++g) {
      checkCount(QStringLiteral("n_G%1").arg(g), m_facts.motions[g]);
    }
    checkCount(QStringLiteral("n_Gdefault"), m_facts.defaultMotions);
    checkCount(QStringLiteral("n_mcs_moves"), m_facts.machineMotions);
    // Programs that are not run may name their units where the script has not looked.
    if (row[QStringLiteral("facts_kind")] != QStringLiteral("static")) {
      check(QStringLiteral("units"),
            QString::fromStdString(std::string(gcode::fileUnitsName(m_facts.units))));
    }
    const bool measured = m_facts.complete && m_facts.lengthsKnown;
    checkLength(QStringLiteral("g1_length"), m_facts.g1Length, measured);
    checkLength(QStringLiteral("arc_length"), m_facts.arcLength,
                measured && m_facts.arcRadiusMismatch <= nc::kArcRadiusToleranceMm);
    checkBounds();
    checkFeeds();
  }

  [[nodiscard]] const QStringList& differences() const { return m_differences; }
  [[nodiscard]] int compared() const { return m_compared; }

 private:
  void differ(const QString& fact, const QString& expected, const QString& actual) {
    if (differenceOf(m_path, fact) == nullptr) {
      m_differences << QStringLiteral("%1: %2 instead of %3").arg(fact, actual, expected);
    }
  }

  void check(const QString& fact, const QString& actual) {
    ++m_compared;
    if (isKnown(m_row[fact]) && m_row[fact] != actual) {
      differ(fact, m_row[fact], actual);
    }
  }

  void checkCount(const QString& fact, std::size_t actual) {
    // "static" facts were counted without running the program.
    if (m_facts.complete) {
      check(fact, QString::number(actual));
    } else if (m_row[QStringLiteral("facts_kind")] != QStringLiteral("static") &&
               isKnown(m_row[fact])) {
      differ(fact, m_row[fact], QStringLiteral("nothing"));
    }
  }

  void checkLength(const QString& fact, double actual, bool known) {
    if (!isKnown(m_row[fact])) {
      return;
    }
    ++m_compared;
    const double expected = m_row[fact].toDouble();
    if (!known) {
      differ(fact, m_row[fact], QStringLiteral("nothing"));
    } else if (!(std::abs(actual - expected) <= kTolerance)) {
      differ(fact, m_row[fact], number(actual));
    }
  }

  void checkBounds() {
    const QString text = m_row[QStringLiteral("bbox_programmed")];
    if (!isKnown(text) || m_row[QStringLiteral("facts_kind")] == QStringLiteral("static")) {
      return;
    }
    static const QRegularExpression box(QStringLiteral("([A-Z])\\[([^,]+),([^\\]]+)\\]"));
    auto match = box.globalMatch(text);
    QSet<QChar> seen;
    while (match.hasNext()) {
      const auto found = match.next();
      const QChar letter = found.captured(1).at(0);
      const auto axis =
          static_cast<std::size_t>(std::find(gcode::kProgrammedAxes.begin(),
                                             gcode::kProgrammedAxes.end(), letter.toLatin1()) -
                                   gcode::kProgrammedAxes.begin());
      seen.insert(letter);
      ++m_compared;
      const auto& range = m_facts.bounds.at(axis);
      if (!range || std::abs(range->smallest - found.captured(2).toDouble()) > kTolerance ||
          std::abs(range->largest - found.captured(3).toDouble()) > kTolerance) {
        differ(QStringLiteral("bbox ") + letter, found.captured(0),
               range ? number(range->smallest) + QLatin1Char(',') + number(range->largest)
                     : QStringLiteral("nothing"));
      }
    }
    for (std::size_t axis = 0; axis < gcode::kProgrammedAxisCount; ++axis) {
      const QChar letter = QLatin1Char(gcode::kProgrammedAxes[axis]);
      if (m_facts.bounds[axis] && !seen.contains(letter) && !m_facts.boundsUnknown[axis] &&
          !text.contains(letter)) {
        differ(QStringLiteral("bbox ") + letter, QStringLiteral("nothing"),
               number(m_facts.bounds[axis]->smallest));
      }
    }
  }

  void checkFeeds() {
    const QString text = m_row[QStringLiteral("feeds")];
    if (!isKnown(text) || text.contains(QStringLiteral("..")) ||
        text.contains(QStringLiteral("expr")) ||
        m_row[QStringLiteral("facts_kind")] == QStringLiteral("static")) {
      return;
    }
    QStringList feeds;
    for (const double feed : m_facts.feeds) {
      feeds << QString::number(feed, 'g', 10);
    }
    const QString actual = feeds.isEmpty() ? QStringLiteral("none") : feeds.join(QLatin1Char(','));
    ++m_compared;
    if (actual != text) {
      differ(QStringLiteral("feeds"), text, actual);
    }
  }

  QString m_path;
  Row m_row;
  const gcode::ProgramFacts& m_facts;
  QStringList m_differences;
  int m_compared = 0;
};

}  // namespace

class TestCorpus : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    if (corpusIndex().isEmpty()) {
      QSKIP("the collection of foreign NC programs is not beside this checkout");
    }
  }

  void agreesWithTheIndex_data() {
    QTest::addColumn<QString>("path");
    for (const QString& path : corpusIndex().keys()) {
      QTest::newRow(qPrintable(path)) << path;
    }
    if (corpusIndex().isEmpty()) {
      QTest::newRow("none") << QString();
    }
  }

  /// Every program loads, and every fact the index vouches for is the same.
  void agreesWithTheIndex() {
    QFETCH(const QString, path);
    const QTemporaryDir folder;
    const QString file = plainFile(path, folder);
    QVERIFY2(!file.isEmpty(), "gzip can unpack the file");
    const auto program = gcode::loadProgram(file.toStdString());
    QVERIFY2(program.has_value(), program ? "" : program.error().text().c_str());
    if (const char* const reason = refusalOf(path)) {
      QVERIFY2(!program->isUnderstood() && !program->facts.complete, reason);
      return;
    }
    const Comparison comparison(path, corpusIndex()[path], *program);
    QVERIFY(comparison.compared() > 0);
    QVERIFY2(comparison.differences().isEmpty(),
             qPrintable(comparison.differences().join(QStringLiteral("; "))));
  }

  /// The differences listed above are real ones: a list that has gone stale fails.
  void differencesAreReal() {
    for (const Difference& difference : kDifferences) {
      const QString path = QString::fromLatin1(difference.path);
      const auto program = gcode::loadProgram((kCorpus + path).toStdString());
      QVERIFY(program.has_value());
      const QString fact = QString::fromLatin1(difference.fact);
      const QString expected = corpusIndex()[path][fact];
      if (fact.startsWith(QStringLiteral("n_G"))) {
        const auto g = static_cast<std::size_t>(fact.back().digitValue());
        QVERIFY(QString::number(program->facts.motions[g]) != expected);
      } else {
        QVERIFY(program->facts.arcRadiusMismatch > nc::kArcRadiusToleranceMm);
      }
      qInfo("%s, %s: %s", difference.path, difference.fact, difference.proof);
    }
  }

  /// Programs whose path is not all known never pass for ones that are, and those that the index
  /// says must be rejected are rejected for that reason.
  void refusedForTheRightReason_data() {
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("code");
    const auto add = [](const char* path, const char* code) {
      QTest::newRow(path) << QString::fromLatin1(path) << QString::fromLatin1(code);
    };
    add("linuxcnc/bad-arc.medium.metric.center-format.ngc", "arc-radius-mismatch");
    add("linuxcnc/bad-arc.small.imperial.center-format.ngc", "arc-radius-mismatch");
    add("linuxcnc/no-ijr.ngc", "arc-without-centre");
    add("linuxcnc/nested.ngc", "flow-fault");
    add("linuxcnc/a-in-canned-cycle.ngc", "cycle-not-run");
    add("nx-postprocessor/Minimill_560_Siemens_810__sample_part.ptp", "arc-radius-mismatch");
    add("nx-postprocessor/Cincinnati_Lamb_FTV5_840D_sample.mpf", "subprogram-missing");
    add("fluidnc/flow_control_basic.nc", "unexpected-character");
    add("nx-postprocessor/Haas_5T.ptp", "number-missing");
    add("sinumerik-cas/CAM_TEST.MPF", "machine-coordinates");
    add("nx-postprocessor/DMU_70_eVo_840D_in_Sample_part.ptp", "cycle-not-run");
    add("heidenhain-plan/Plan-Beispiel.h", "expression-fault");  // the radius of the tool
  }

  void refusedForTheRightReason() {
    QFETCH(const QString, path);
    QFETCH(const QString, code);
    const auto program = gcode::loadProgram((kCorpus + path).toStdString());
    QVERIFY(program.has_value());
    QVERIFY(!program->isUnderstood());
    QStringList codes;
    for (const gcode::Diagnostic& diagnostic : program->diagnostics) {
      if (diagnostic.severity == gcode::Severity::Error) {
        codes << QString::fromStdString(std::string(gcode::diagnosticName(diagnostic.code)));
      }
    }
    QVERIFY2(codes.contains(code), qPrintable(codes.join(QLatin1Char(' '))));
  }

  /// no-feed-rate.ngc is refused by LinuxCNC; here a feed comes with the run, so it is a warning.
  void missingFeedIsSaid() {
    const auto program =
        gcode::loadProgram((kCorpus + QStringLiteral("linuxcnc/no-feed-rate.ngc")).toStdString());
    QVERIFY(program.has_value());
    QVERIFY(test::printProblems(program->diagnostics).find("feed-missing") != std::string::npos);
  }

  void arcReadingIsFound_data() {
    QTest::addColumn<QString>("path");
    QTest::addColumn<int>("reading");
    const auto add = [](const char* path, gcode::CentreReading reading) {
      QTest::newRow(path) << QString::fromLatin1(path) << static_cast<int>(reading);
    };
    add("nx-postprocessor/Minimill_560_Siemens_810__sample_part.ptp",
        gcode::CentreReading::StartMinusCentre);
    add("nx-postprocessor/makino_u32k_sample.ptp", gcode::CentreReading::StartMinusCentre);
    add("nx-postprocessor/testpart-esab_waterjet.ptp", gcode::CentreReading::Absolute);
  }

  /// A program whose arcs fit only another reading is refused, says so, and loads with it.
  void arcReadingIsFound() {
    QFETCH(const QString, path);
    QFETCH(const int, reading);
    gcode::LoadOptions options;
    const auto refused = gcode::loadProgram((kCorpus + path).toStdString(), options);
    QVERIFY(refused.has_value());
    QCOMPARE(static_cast<int>(refused->facts.centreReading), reading);
    QVERIFY(test::printFindings(refused->diagnostics).find("centre-reading") != std::string::npos);
    options.centres = static_cast<gcode::CentreReading>(reading);
    const auto read = gcode::loadProgram((kCorpus + path).toStdString(), options);
    QVERIFY(read.has_value());
    const std::string problems = test::printProblems(read->diagnostics);
    QVERIFY2(problems.find("arc-radius") == std::string::npos, problems.c_str());
  }

  void executedAsElsewhere_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"arc",
                             "basic_math",
                             "case",
                             "case_insensitive_variables",
                             "def_string",
                             "goto",
                             "if_statement",
                             "increment",
                             "loop",
                             "multiple_m_codes",
                             "precedence",
                             "r_param",
                             "trans",
                             "trans2",
                             "trans_ic",
                             "trans_reset",
                             "trig",
                             "variables",
                             "logic_operators",
                             "function_calls"}) {
      QTest::newRow(name) << QString::fromLatin1(name);
    }
  }

  /// Executed rows of another SINUMERIK interpreter, with TRANS applied, arcs not flattened. Its
  /// $AA_IM (actual_position.mpf) leaves the work offset and the tool out; here it is refused.
  void executedAsElsewhere() {
    QFETCH(const QString, name);
    const QString cead = kCorpus + QStringLiteral("cead-nc-interpreter/");
    QFile oracle(cead + QStringLiteral("oracle/%1.csv").arg(name));
    if (!oracle.open(QIODevice::ReadOnly)) {
      QSKIP("there are no published rows for this program");
    }
    const QStringList lines = QString::fromUtf8(oracle.readAll()).split(QLatin1Char('\n'));
    const QStringList columns = lines.first().trimmed().split(QLatin1Char(','));
    std::vector<base::Vec3> expected;
    base::Vec3 last{std::nan(""), std::nan(""), std::nan("")};
    for (const QString& line : lines.mid(1)) {
      const QStringList cells = line.split(QLatin1Char(','));
      base::Vec3 here = last;
      bool any = false;
      for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
        const qsizetype column = columns.indexOf(QString(QLatin1Char(base::kAxisNames[axis])));
        bool ok = false;
        const double value =
            column < 0 || column >= cells.size() ? 0.0 : cells[column].toDouble(&ok);
        if (ok) {
          here.set(axis, value);
          any = true;
        }
      }
      const auto same = [&here, &last](std::size_t axis) {
        return here[axis] == last[axis] || std::isnan(here[axis]);
      };
      if (any && !(same(0) && same(1) && same(2))) {
        expected.push_back(here);
      }
      last = here;
    }
    gcode::LoadOptions options;
    options.keepArcs = true;
    options.dialect = gcode::Dialect::Sinumerik;
    const auto program =
        gcode::loadProgram((cead + name + QStringLiteral(".mpf")).toStdString(), options);
    QVERIFY(program.has_value());
    std::vector<base::Vec3> actual;
    for (const gcode::TrajectoryPoint& point : program->trajectory.points) {
      const auto same = [&](std::size_t axis) {
        return std::isnan(point.positionMm[axis]) ||
               (!actual.empty() && std::abs(point.positionMm[axis] - actual.back()[axis]) < 5e-4);
      };
      if (!(same(0) && same(1) && same(2))) {
        actual.push_back(point.positionMm);
      }
    }
    QVERIFY(!expected.empty());
    QCOMPARE(actual.size(), expected.size());
    for (std::size_t i = 0; i < actual.size(); ++i) {
      for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
        const bool unknown = std::isnan(actual[i][axis]) || std::isnan(expected[i][axis]);
        QVERIFY2(unknown || std::abs(actual[i][axis] - expected[i][axis]) < 1e-3,
                 qPrintable(QStringLiteral("row %1, axis %2: %3 instead of %4")
                                .arg(i)
                                .arg(axis)
                                .arg(actual[i][axis])
                                .arg(expected[i][axis])));
      }
    }
  }

  /// The points of a B-spline published there lie on our curve, to their three decimals.
  void splineAsElsewhere() {
    const QString cead = kCorpus + QStringLiteral("cead-nc-interpreter/");
    QFile oracle(cead + QStringLiteral("oracle/flatten_demo_flattened.csv"));
    QVERIFY(oracle.open(QIODevice::ReadOnly));
    gcode::LoadOptions options;
    options.chordToleranceMm = 1e-5;
    const auto program =
        gcode::loadProgram((cead + QStringLiteral("flatten_demo.mpf")).toStdString(), options);
    QVERIFY(program.has_value());
    const auto& points = program->trajectory.points;
    int compared = 0;
    while (!oracle.atEnd()) {
      const QList<QByteArray> cells = oracle.readLine().split(',');
      if (cells.size() < 7 || cells[6] != "1.000" || cells[2].toDouble() <= 100.0) {
        continue;  // programmed points, and those of the arc
      }
      const base::Vec3 sample{cells[2].toDouble(), cells[3].toDouble(), cells[4].toDouble()};
      double nearestMm = 1e9;
      for (std::size_t i = 1; i < points.size(); ++i) {
        const base::Vec3 from = points[i - 1].positionMm;
        const base::Vec3 along = points[i].positionMm - from;
        const double squares = base::dot(along, along);
        const double share =
            squares == 0.0 ? 0.0 : std::clamp(base::dot(sample - from, along) / squares, 0.0, 1.0);
        nearestMm = std::min(nearestMm, base::distance(sample, from + share * along));
      }
      QVERIFY2(nearestMm < 1e-3, qPrintable(QString::number(nearestMm)));
      ++compared;
    }
    QCOMPARE(compared, 18);
  }
};

RIVULET_TEST(TestCorpus)
#include "tst_corpus.moc"
