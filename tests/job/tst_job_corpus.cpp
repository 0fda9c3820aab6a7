// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Programs from many CAM systems, split into what is streamed and what the control executes. The
// collection lies beside the checkout where it exists; its licences do not let it live here.

#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include "gcode/block_observer.h"
#include "job/plan.h"
#include "nc/syntax/lexer.h"
#include "support/patience.h"
#include "support/test_program.h"

using namespace rivulet;

namespace {

const QString kCorpus = QStringLiteral(RIVULET_SOURCE_DIR "/../shared/corpus/");

/// Share of the valid milling programs that must split without a refusal. Refused by name, although
/// they ran before: G41 without a length (D0 has no radius either), $AA_IM, an O word behind whose
/// number a comment stands.
constexpr double kShare = 0.91;

/// Files that are no valid milling program of a dialect Rivulet reads, and why.
const QMap<QString, QString>& noMillingPrograms() {
  static const QMap<QString, QString> files = [] {
    QMap<QString, QString> made;
    QFile file(QStringLiteral(RIVULET_SOURCE_DIR "/tests/data/not_valid_milling_programs.tsv"));
    if (!file.open(QIODevice::ReadOnly)) {
      qFatal("%s is missing", qPrintable(file.fileName()));
    }
    for (const QString& line : QString::fromUtf8(file.readAll()).split(QLatin1Char('\n'))) {
      if (!line.startsWith(QLatin1Char('#')) && line.contains(QLatin1Char('\t'))) {
        made[line.section(QLatin1Char('\t'), 0, 0)] = line.section(QLatin1Char('\t'), 1);
      }
    }
    return made;
  }();
  return files;
}

/// With what is known of their flow: "linear", "executed", "static".
QMap<QString, QString> readIndex() {
  QFile file(kCorpus + QStringLiteral("INDEX.tsv"));
  QMap<QString, QString> paths;
  if (file.open(QIODevice::ReadOnly)) {
    for (const QString& line : QString::fromUtf8(file.readAll()).split(QLatin1Char('\n')).mid(1)) {
      if (line.contains(QLatin1Char('\t'))) {
        constexpr int kFlow = 11;
        paths[line.section(QLatin1Char('\t'), 0, 0)] =
            line.section(QLatin1Char('\t'), kFlow, kFlow);
      }
    }
  }
  return paths;
}

const QMap<QString, QString>& corpusFiles() {
  static const QMap<QString, QString> files = readIndex();
  return files;
}

/// The text itself, or what gzip holds.
std::string textOf(const QString& path) {
  if (path.endsWith(QStringLiteral(".gz"))) {
    QProcess gzip;
    gzip.start(QStringLiteral("gzip"), {QStringLiteral("-dc"), kCorpus + path});
    return gzip.waitForFinished(tests::kSoonMs) ? gzip.readAllStandardOutput().toStdString()
                                                : std::string();
  }
  QFile file(kCorpus + path);
  return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
}

gcode::LoadOptions loadOptions(const QString& path) {
  gcode::LoadOptions options;
  options.subprogram = gcode::subprogramsBeside((kCorpus + path).toStdString());
  // Its arcs fit this way of writing only, and the program is loaded so.
  if (path.endsWith(QStringLiteral("Minimill_560_Siemens_810__sample_part.ptp"))) {
    options.centres = gcode::CentreReading::StartMinusCentre;
  }
  return options;
}

base::Result<job::Plan> planOf(const QString& path) {
  QString name = QFileInfo(path).fileName();
  name.remove(QStringLiteral(".gz"));
  return job::makePlan(name.toStdString(), textOf(path), loadOptions(path));
}

/// Nothing but which blocks are executed.
class Recorder final : public gcode::BlockObserver {
 public:
  nc::Sinks observe(const nc::Language&, nc::Sinks own) override { return own; }
  void begin(const gcode::SourceBlock& block, nc::Executor&) override {
    blocks.push_back(block.place);
  }
  void executed(const nc::BlockWords&, nc::Executor&) override {}
  void modalCall(std::string_view) override {}
  void end(nc::Executor&, std::size_t) override {}
  void finish(std::size_t) override {}

  std::vector<nc::Place> blocks;
};

bool isSame(const nc::Place& a, const nc::Place& b) {
  return a.line == b.line && a.file == b.file;
}

/// "1 2 3", files beside the program as "2/1".
QString print(const std::vector<nc::Place>& blocks) {
  QString text;
  for (const nc::Place& block : blocks) {
    text += (text.isEmpty() ? QString() : QStringLiteral(" ")) +
            (block.file == 0 ? QString() : QString::number(block.file) + QLatin1Char('/')) +
            QString::number(block.line.value);
  }
  return text;
}

QString whyNot(const job::Plan& plan) {
  QStringList reasons;
  for (const job::Refusal& refusal : plan.refusals) {
    reasons << QString::fromStdString(std::string(job::refusalName(refusal.code)) + " " +
                                      refusal.argument);
  }
  for (const gcode::Diagnostic& found : plan.program.diagnostics) {
    if (found.severity == gcode::Severity::Error) {
      reasons << QStringLiteral("%1 %2 %3")
                     .arg(found.line.value)
                     .arg(QString::fromStdString(std::string(gcode::diagnosticName(found.code))),
                          QString::fromStdString(gcode::parameterOf(found)));
    }
  }
  reasons.removeDuplicates();
  return reasons.mid(0, 6).join(QStringLiteral("; "));
}

}  // namespace

class TestJobCorpus : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    if (corpusFiles().isEmpty()) {
      QSKIP("the collection of foreign NC programs is not beside this checkout");
    }
  }

  /// The share that can be a job, and why the others cannot.
  void share() {
    int valid = 0;
    int before = 0;
    int whole = 0;
    int natives = 0;
    int own = 0;
    int ownWhole = 0;
    for (const QString& path : corpusFiles().keys()) {
      if (noMillingPrograms().contains(path)) {
        continue;
      }
      const auto plan = planOf(path);
      QVERIFY2(plan.has_value(), qPrintable(path));
      gcode::LoadOptions options;
      options.subprogram = gcode::subprogramsBeside((kCorpus + path).toStdString());
      const auto program = gcode::interpretProgram(plan->program.name, plan->program.text, options);
      ++valid;
      before += program && program->isUnderstood() ? 1 : 0;
      whole += plan->isWhole() ? 1 : 0;
      const bool isOwn = plan->program.dialect == gcode::Dialect::Sinumerik;
      own += isOwn ? 1 : 0;
      ownWhole += isOwn && plan->isWhole() ? 1 : 0;
      natives += static_cast<int>(plan->nativeCount());
      if (!plan->isWhole()) {
        qInfo("%s: %s", qPrintable(path), qPrintable(whyNot(*plan)));
      }
    }
    qInfo(
        "%d valid milling programs: %d load without an error, %d split without a refusal "
        "(%.1f %%), %d of %d for a SINUMERIK; %d native blocks",
        valid, before, whole, 100.0 * whole / valid, ownWhole, own, natives);
    QVERIFY(static_cast<double>(whole) >= kShare * valid);
  }

  void everyBlockOnce_data() {
    QTest::addColumn<QString>("path");
    for (const QString& path : corpusFiles().keys()) {
      QTest::newRow(qPrintable(path)) << path;
    }
    if (corpusFiles().isEmpty()) {
      QTest::newRow("none") << QString();
    }
  }

  /// The blocks of all parts, one after another, are those that are executed: each once and in
  /// order. Where nothing repeats, jumps or calls, they are also the lines of the text.
  void everyBlockOnce() {
    QFETCH(const QString, path);
    const auto plan = planOf(path);
    QVERIFY(plan.has_value());
    std::vector<nc::Place> blocks;
    const auto add = [&blocks](const nc::Place& place, bool mayRepeat) {
      if (!mayRepeat || blocks.empty() || !isSame(blocks.back(), place)) {
        blocks.push_back(place);
      }
    };
    bool wasHalf = false;  // a block that is translated and streamed stands in up to three parts
    for (const job::Part& part : plan->parts) {
      if (const auto* const native = std::get_if<job::NativeBlock>(&part)) {
        add(native->place, native->isHalf);
        wasHalf = native->isHalf;
        continue;
      }
      for (const nc::Place& place : std::get<job::Stretch>(part).blocks.all()) {
        add(place, wasHalf);
        wasHalf = false;
      }
    }
    Recorder recorder;
    QVERIFY(gcode::interpretProgram(plan->program.name, plan->program.text, loadOptions(path),
                                    &recorder));
    QCOMPARE(print(blocks), print(recorder.blocks));
    const bool calls = std::any_of(blocks.begin(), blocks.end(),
                                   [](const nc::Place& block) { return block.file != 0; });
    if (corpusFiles().value(path) == QStringLiteral("linear") && !calls &&
        !noMillingPrograms().contains(path)) {
      std::vector<nc::Place> lines;
      nc::Lexer lexer(plan->program.text, plan->program.dialect);
      nc::Block block;
      while (lexer.next(block)) {
        if (!block.tokens.empty()) {
          lines.push_back({block.line, 0, 1});
        }
      }
      // What follows the end of the program is not executed, and is said to be so.
      QVERIFY(blocks.size() <= lines.size());
      lines.resize(blocks.size());
      QCOMPARE(print(blocks), print(lines));
    }
  }
};

RIVULET_TEST(TestJobCorpus)
#include "tst_job_corpus.moc"
