// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Runs that have ended, from the stream to the page and back to a program with its settings.

#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>

#include "base/file.h"
#include "base/units.h"
#include "hmi/past_runs.h"
#include "machine/machine.h"
#include "streaming/simulation/simulated_link.h"
#include "support/patience.h"
#include "support/test_program.h"

using namespace rivulet;
using hmi::PastRuns;
using FinishedRunPtr = std::shared_ptr<const report::FinishedRun>;
using RecordingPtr = std::shared_ptr<const trace::Recording>;

namespace {

using rivulet::tests::kSoonMs;
const QString kScorpion = QStringLiteral(RIVULET_SOURCE_DIR "/resources/programs/scorpion.tap");

struct Cell {
  machine::Machine machine{*machine::loadPreset("dmu75"), 1};
  streaming::SimulatedLink link{machine};
};

base::Result<opcua::Connection> connectToCell(const opcua::ConnectRequest& asked) {
  auto cell = std::make_shared<Cell>();
  return opcua::Connection{cell, &cell->link, &cell->link, asked.endpoint};
}

streaming::StreamSettings settings(base::MethodKind method, int points, double feedMmPerMin) {
  streaming::StreamSettings stream;
  stream.parameters.method = method;
  stream.parameters.pointsPerLoop = points;
  stream.feedMmPerS = base::mmPerSFromMmPerMin(feedMmPerMin);
  return stream;
}

struct Models {
  explicit Models(const QTemporaryDir& folder)
      : store(report::MachineFolders::below(
            folder.filePath(QStringLiteral("data")).toStdString(),
            folder.filePath(QStringLiteral("config")).toStdString())) {}

  report::MachineStore store;
  hmi::Messages messages;
  session::StreamSession session{connectToCell, store};
  hmi::Document document{settings(base::MethodKind::Window, 9, 1500.0)};
  hmi::MachineModel machine{session, store, messages};
  hmi::RunController runs{session, document, machine, messages};
  PastRuns past{document, runs, messages};
};

}  // namespace

class TestPastRuns : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;
  QString m_program;
  QString m_other;
  std::unique_ptr<Models> m_models;
  FinishedRunPtr m_run;

  void load(const QString& path) {
    QSignalSpy loaded(&m_models->document, &hmi::Document::programLoaded);
    m_models->document.open(path);
    QVERIFY(loaded.wait(kSoonMs));
  }

 private Q_SLOTS:
  /// One run; the other functions look at what is left of it.
  void initTestCase() {
    QStandardPaths::setTestModeEnabled(true);
    qputenv("XDG_STATE_HOME", m_folder.filePath(QStringLiteral("state")).toUtf8());
    m_program = m_folder.filePath(QStringLiteral("scorpion.tap"));
    QVERIFY(QFile::copy(kScorpion, m_program));
    m_other = m_folder.filePath(QStringLiteral("other.mpf"));
    QVERIFY(base::writeFile(m_other.toStdString(), "G1 X1 Y1 F500\nX2\nX3 Y0\n"));
    m_models = std::make_unique<Models>(m_folder);
    load(m_program);
    m_models->machine.connectTo(QStringLiteral("opc.tcp://cell"));
    QTRY_VERIFY_WITH_TIMEOUT(!m_models->runs.startBlocked(), kSoonMs);
    QSignalSpy listed(&m_models->past, &PastRuns::listed);
    QVERIFY(m_models->runs.start());
    QTRY_VERIFY_WITH_TIMEOUT(m_models->runs.report(), kSoonMs);
    QTRY_VERIFY_WITH_TIMEOUT(!listed.isEmpty(), kSoonMs);
    const auto list = listed.last()[0].value<std::shared_ptr<const report::HistoryList>>();
    QCOMPARE(list->runs.size(), std::size_t{1});
    const streaming::RunSummary& run = list->runs.front();
    QCOMPARE(run.programFile, m_program.toStdString());
    QCOMPARE(run.programHash, m_models->document.program()->hash);
    QCOMPARE(run.pointsPerLoop, 9);
    QVERIFY(run.finding == streaming::RunFinding::Faultless);
    QVERIFY(run.executed > 200);
    QVERIFY(!run.origin.user.empty());
    QSignalSpy read(&m_models->past, &PastRuns::read);
    m_models->past.readRun(QString::fromStdString(run.id));
    QVERIFY(read.wait(kSoonMs));
    m_run = read[0][1].value<FinishedRunPtr>();
    QVERIFY(m_run->sketch.size() > 50);
  }

  void cleanupTestCase() { m_models.reset(); }

  /// After the run the tool stands elsewhere, and the axes tremble: d_min is that of the program.
  void theShortestDistanceStaysThatOfTheProgram() {
    load(m_program);
    const auto& distances = m_models->document.findings().distances;
    const double programMm = distances->pointDistanceMmMin;
    QVERIFY(programMm > 0.01);
    m_models->document.setToolPosition({2e-7, -3e-7, 40.0});
    QSignalSpy placed(&m_models->document, &hmi::Document::programPlaced);
    QVERIFY(placed.wait(kSoonMs));
    QCOMPARE(m_models->document.findings().distances->pointDistanceMmMin, programMm);
  }

  void opensTheRecording() {
    QSignalSpy opened(&m_models->past, &PastRuns::recordingRead);
    m_models->past.openRecording(*m_run);
    QVERIFY(opened.wait(kSoonMs));
    const auto recording = opened[0][0].value<RecordingPtr>();
    QVERIFY(recording->complete);
    QVERIFY(recording->controlTrace && !recording->controlTrace->samples.empty());
  }

  void saysThatARecordingIsGone() {
    report::FinishedRun gone = *m_run;
    gone.summary.recording = m_folder.filePath(QStringLiteral("gone.rivulet")).toStdString();
    QSignalSpy shown(&m_models->messages, &hmi::Messages::shown);
    m_models->past.openRecording(gone);
    QVERIFY(shown.wait(kSoonMs));
  }

  void repeatsWithTheSettingsOfTheRun() {
    load(m_other);
    m_models->document.setSettings(settings(base::MethodKind::Position, 5, 200.0));
    QSignalSpy shown(&m_models->messages, &hmi::Messages::shown);
    m_models->past.repeat(*m_run);
    QTRY_VERIFY_WITH_TIMEOUT(!shown.isEmpty(), kSoonMs);
    const streaming::StreamSettings& now = m_models->document.settings();
    QVERIFY(now.parameters.method == base::MethodKind::Window);
    QCOMPARE(now.parameters.pointsPerLoop, 9);
    QCOMPARE(now.feedMmPerS, base::mmPerSFromMmPerMin(1500.0));
    QVERIFY(shown.last()[0].value<gcode::Severity>() == gcode::Severity::Note);
    QVERIFY(!m_models->runs.isRunning());
  }

  void repeatsNothingForAnOperator() {
    load(m_other);
    m_models->document.setSettings(settings(base::MethodKind::Position, 5, 200.0));
    m_models->runs.setGate([](permission::Act act) {
      return permission::refusal({permission::Role::Operator, false}, act);
    });
    m_models->past.repeat(*m_run);
    m_models->runs.setGate({});  // the models are those of all tests
    QCOMPARE(m_models->document.requestedPath(), m_other);
    QVERIFY(m_models->document.settings().parameters.method == base::MethodKind::Position);
  }

  /// The file has another content now: said, with both versions.
  void warnsIfTheProgramIsAnotherOne() {
    const auto text = base::readFile(m_program.toStdString());
    QVERIFY(text && base::writeFile(m_program.toStdString(), *text + "G1 X1\n"));
    load(m_other);
    QSignalSpy shown(&m_models->messages, &hmi::Messages::shown);
    m_models->past.repeat(*m_run);
    QTRY_VERIFY_WITH_TIMEOUT(!shown.isEmpty(), kSoonMs);
    QVERIFY(shown.last()[0].value<gcode::Severity>() == gcode::Severity::Warning);
    const QString sentence = shown.last()[1].value<std::function<QString()>>()();
    QVERIFY2(sentence.contains(QString::fromStdString(m_run->summary.programHash)),
             qPrintable(sentence));
    QVERIFY(sentence.contains(QString::fromStdString(m_models->document.program()->hash)));
    QCOMPARE(m_models->document.path(), m_program);
  }

  /// Made by another program, such as the command line: seen without asking.
  void noticesRunsOfOtherPrograms() {
    QSignalSpy listed(&m_models->past, &PastRuns::listed);
    QVERIFY(report::RunHistory().add(m_run->report, m_run->summary, {}));
    QTRY_VERIFY_WITH_TIMEOUT(!listed.isEmpty(), kSoonMs);
    QCOMPARE(listed.last()[0].value<std::shared_ptr<const report::HistoryList>>()->runs.size(),
             std::size_t{2});
  }

  void saysWhyAFileIsNotAReport() {
    QSignalSpy unreadable(&m_models->past, &PastRuns::unreadable);
    m_models->past.readFile(m_program);
    QVERIFY(unreadable.wait(kSoonMs));
    QVERIFY(unreadable[0][1].value<base::Error>().code == report::ReportError::NotAReport);
  }
};

RIVULET_TEST(TestPastRuns)
#include "tst_past_runs.moc"
