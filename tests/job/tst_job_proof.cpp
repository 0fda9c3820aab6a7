// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A job does what its source does, on the virtual machine; and what a job does otherwise is found.

#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QtTest>

#include "forecast/large_machine.h"
#include "gcode/block_observer.h"
#include "gcode/feeds.h"
#include "job/main_program.h"
#include "streaming/control/control_axes.h"
#include "streaming/simulation/fitted_machine.h"
#include "streaming/simulation/job_proof.h"
#include "support/test_program.h"

using namespace rivulet;

namespace {

const QString kCorpus = QStringLiteral(RIVULET_SOURCE_DIR "/../shared/corpus/");

/// Programs as post-processors and people write them, for each control; `refused.tsv` has those
/// that are no job, with what has to be said.
const QString kPrograms = QStringLiteral(RIVULET_SOURCE_DIR "/tests/data/job-programs/");

const char* const kPart =
    "N10 G17 G90 G71 G54\nT3 M6\nD1\nS3000 M3\nG0 X0 Y0\nZ50\nZ5\nG1 Z-2 F2000\nG41 X20 Y0\nX60\n"
    "Y40\nG40 X90 Y60\nG0 Z50\nG2 X70 Y40 I-20 F1500\nM8\nTRANS X5\nG91 G1 X1\nG90\nM9\nG1 X3 Y3\n"
    "SUPA G0 Z200 D0\nT7 M6\nD1\nG0 X10 Y10\nZ10\nMCALL CYCLE81(10,0,2,-5)\nX10 Y10\nX30\nMCALL\n"
    "G0 Z50\nM5\nM30\n";

struct Proved {
  job::Plan plan;
  base::Result<streaming::JobProof> proof;
};

Proved prove(job::Plan plan, const machine::MachineConfig& machine) {
  streaming::RunSettings settings;
  settings.parameters.method = base::MethodKind::Window;
  settings.parameters.pointsPerLoop = 7;
  settings.parameters.feedPerPoint = true;
  settings.parameters = streaming::withTurnedAxes(settings.parameters, plan);
  settings.isCommissioned = true;
  settings.programFeeds = gcode::ProgramFeeds{};
  settings.programFeeds->rapidMmPerS = machine.rapidMmPerS;
  settings.programFeeds->feedMmPerSMax = machine.feedMmPerSMax();
  settings.feedMmPerS = machine.feedMmPerSMax();
  auto proof = streaming::proveJob(plan, machine, settings);
  return {std::move(plan), std::move(proof)};
}

job::Plan planOf(const std::string& name, const std::string& text,
                 const gcode::LoadOptions& options) {
  const auto plan = job::makePlan(name, text, options);
  if (!plan) {
    qFatal("%s", plan.error().text().c_str());
  }
  return *plan;
}

job::Plan partPlan() {
  gcode::LoadOptions options;
  options.dialect = gcode::Dialect::Sinumerik;
  return planOf("PART.MPF", kPart, options);
}

}  // namespace

class TestJobProof : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void part() {
    const Proved done = prove(partPlan(), *machine::loadPreset("dmu75-mill"));
    QVERIFY2(done.proof.has_value(), done.proof ? "" : done.proof.error().text().c_str());
    QVERIFY2(done.proof->difference.empty(), done.proof->difference.c_str());
    QVERIFY(done.proof->isSource);
    QVERIFY(done.proof->ends > 15);
    QVERIFY2(done.proof->farthestMm < 0.001, qPrintable(QString::number(done.proof->farthestMm)));
    QVERIFY(done.proof->asJob > done.proof->plain);
  }

  /// Each program runs as the job it is, or is refused with the reason.
  void programs_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("refusal");  ///< a part of the sentence; empty: it runs
    QFile list(kPrograms + "refused.tsv");
    QVERIFY(list.open(QIODevice::ReadOnly));
    QMap<QString, QString> refused;
    for (const QByteArray& line : list.readAll().split('\n')) {
      const QList<QByteArray> fields = line.split('\t');
      if (fields.size() == 2) {
        refused[QString::fromUtf8(fields[0])] = QString::fromUtf8(fields[1]);
      }
    }
    std::size_t found = 0;
    for (QDirIterator files(kPrograms, QDir::Files, QDirIterator::Subdirectories);
         files.hasNext();) {
      const QString file = files.next().mid(kPrograms.size());
      if (!file.contains('/')) {
        continue;  // the list
      }
      ++found;
      QTest::newRow(qPrintable(file)) << file << refused.value(file);
    }
    QVERIFY(found > 50);
  }
  void programs() {
    QFETCH(const QString, file);
    QFETCH(const QString, refusal);
    QFile program(kPrograms + file);
    QVERIFY(program.open(QIODevice::ReadOnly));
    gcode::LoadOptions options;
    options.subprogram = gcode::subprogramsBeside((kPrograms + file).toStdString());
    options.defaultFeedMmPerS = streaming::kFittedFeedMmPerS;
    job::Profile profile;
    profile.leavesOutFunctions = true;
    const std::string name = QFileInfo(file).fileName().toStdString();
    const std::string text = program.readAll().toStdString();
    auto plan = job::makePlan(name, text, options, profile);
    if (plan && plan->program.ambiguity) {
      // Asked for: it is that of its folder.
      options.dialect = gcode::dialectOfName(file.section('/', 0, 0).toStdString());
      plan = job::makePlan(name, text, options, profile);
    }
    QVERIFY(plan.has_value());
    const base::Result<void> whole = job::requireWhole(*plan);
    if (!refusal.isEmpty()) {
      QVERIFY(!whole);
      QVERIFY2(QString::fromStdString(whole.error().text()).contains(refusal),
               whole.error().text().c_str());
      return;
    }
    QVERIFY2(whole.has_value(), whole ? "" : whole.error().text().c_str());
    machine::MachineConfig machine =
        streaming::fitMachine(*machine::loadPreset("dmu75-mill"), *plan).config;
    (void)forecast::enlarge(machine, *plan);
    const Proved done = prove(*std::move(plan), machine);
    QVERIFY2(done.proof.has_value(), done.proof ? "" : done.proof.error().text().c_str());
    QVERIFY2(done.proof->difference.empty(), done.proof->difference.c_str());
  }

  /// A block that got lost is found, whether it moves or switches.
  void lostBlocks_data() {
    QTest::addColumn<int>("reason");
    QTest::newRow("coolant") << static_cast<int>(job::NativeReason::Coolant);
    QTest::newRow("compensation") << static_cast<int>(job::NativeReason::RadiusCompensation);
  }
  void lostBlocks() {
    QFETCH(const int, reason);
    job::Plan plan = partPlan();
    for (job::Part& part : plan.parts) {
      if (auto* const native = std::get_if<job::NativeBlock>(&part);
          native != nullptr && static_cast<int>(native->reason) == reason) {
        native->text.clear();
        break;
      }
    }
    const Proved done = prove(std::move(plan), *machine::loadPreset("dmu75-mill"));
    QVERIFY(!done.proof || !done.proof->difference.empty());
  }

  /// A block in another modal state is found, without a run.
  void modalState() {
    job::Plan plan = partPlan();
    QCOMPARE(streaming::modalDifference(plan), std::string());
    for (job::Part& part : plan.parts) {
      auto* const native = std::get_if<job::NativeBlock>(&part);
      if (native != nullptr && native->source == "M5") {
        native->before.relative = true;
      }
    }
    const std::string found = streaming::modalDifference(plan);
    QVERIFY2(found.find("Line 32") == 0 && found.find("G91") != std::string::npos, found.c_str());
  }

  void programsOfOthers_data() {
    QTest::addColumn<QString>("path");
    for (const char* const path :
         {"cead-nc-interpreter/trans.mpf", "cead-nc-interpreter/goto.mpf",
          "linuxcnc/05-M98-loops__test.ngc", "linuxcnc/comp-g1.ngc", "linuxcnc/butterfly-xy.ngc",
          "grbl-plotter/gcode_relative.nc", "linuxcnc/01-basics__test.ngc"}) {
      QTest::newRow(path) << QString::fromLatin1(path);
    }
  }
  void programsOfOthers() {
    QFETCH(const QString, path);
    QFile file(kCorpus + path);
    if (!file.open(QIODevice::ReadOnly)) {
      QSKIP("the collection of foreign NC programs is not beside this checkout");
    }
    gcode::LoadOptions options;
    options.subprogram = gcode::subprogramsBeside((kCorpus + path).toStdString());
    options.defaultFeedMmPerS = streaming::kFittedFeedMmPerS;
    job::Plan plan =
        planOf(QFileInfo(path).fileName().toStdString(), file.readAll().toStdString(), options);
    if (!plan.isWhole()) {
      QSKIP("it is no whole job");
    }
    const streaming::FittedMachine machine =
        streaming::fitMachine(*machine::loadPreset("dmu75-mill"), plan);
    const Proved done = prove(std::move(plan), machine.config);
    QVERIFY2(done.proof.has_value(), done.proof ? "" : done.proof.error().text().c_str());
    QVERIFY2(done.proof->difference.empty(), done.proof->difference.c_str());
  }
};

RIVULET_TEST(TestJobProof)
#include "tst_job_proof.moc"
