// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The models of the window without a window: what is open, what may be done and why not, and a
/// run on a virtual machine in virtual time.

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

#include "base/units.h"
#include "hmi/document.h"
#include "hmi/machine_model.h"
#include "hmi/run_controller.h"
#include "machine/machine.h"
#include "streaming/simulation/simulated_link.h"
#include "support/test_program.h"

using namespace rivulet;
using hmi::Document;
using hmi::RunController;
using streaming::BlockReason;

namespace {

constexpr int kSoonMs = 60000;
const QString kScorpion = QStringLiteral(RIVULET_SOURCE_DIR "/resources/programs/scorpion.tap");

struct Cell {
  machine::Machine machine{*machine::loadPreset("dmu75"), 1};
  streaming::SimulatedLink link{machine};
};

base::Result<opcua::Connection> connectToCell(const std::string& endpoint) {
  auto cell = std::make_shared<Cell>();
  return opcua::Connection{cell, &cell->link, &cell->link, endpoint};
}

widgets::StreamSettings settings(base::MethodKind method, double feedMmPerMin) {
  widgets::StreamSettings stream;
  stream.parameters.method = method;
  stream.feedMmPerS = base::mmPerSFromMmPerMin(feedMmPerMin);
  return stream;
}

/// All models, with machine files in a folder of their own.
struct Models {
  QTemporaryDir folder;
  report::MachineStore store{
      report::MachineFolders::below(folder.filePath(QStringLiteral("data")).toStdString(),
                                    folder.filePath(QStringLiteral("config")).toStdString())};
  hmi::Messages messages;
  session::StreamSession session{connectToCell, store};
  Document document{settings(base::MethodKind::Window, 1500.0)};
  hmi::MachineModel machine{session, store, messages};
  RunController runs{session, document, machine, messages};

  [[nodiscard]] std::optional<BlockReason> reason() const {
    const auto blocked = runs.startBlocked();
    return blocked ? std::optional(blocked->reason) : std::nullopt;
  }
};

}  // namespace

class TestRunController : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aDocumentNeedsNoMachine() {
    Document document(settings(base::MethodKind::Window, 1500.0));
    QVERIFY(!document.view() && !document.findings().verdict);
    QVERIFY(!document.findings().templateText.empty());
    QSignalSpy judged(&document, &Document::judged);
    QSignalSpy loaded(&document, &Document::programLoaded);
    document.open(kScorpion);
    QVERIFY(loaded.wait(kSoonMs));
    QVERIFY(judged.count() >= 1);
    QVERIFY(document.findings().verdict.has_value());
    // Settings of which no program can be made: one reason, no verdict.
    widgets::StreamSettings tooMany = document.settings();
    tooMany.parameters.pointsPerLoop = 40;
    document.setSettings(tooMany);
    QVERIFY(document.findings().settingsError && !document.findings().verdict);
    QVERIFY(!document.findings().cells && document.findings().distances);
  }

  void theNextReasonIsNamed() {
    Models models;
    QVERIFY(models.reason() == BlockReason::NotConnected);
    QSignalSpy shown(&models.messages, &hmi::Messages::shown);
    QVERIFY(!models.runs.start());
    QCOMPARE(shown.count(), 1);
    models.machine.connectTo(QStringLiteral("opc.tcp://cell"));
    QTRY_VERIFY_WITH_TIMEOUT(models.reason() == BlockReason::NoProgram, kSoonMs);
    QVERIFY(!models.runs.calibrationBlocked());
    models.document.open(kScorpion);
    QTRY_VERIFY_WITH_TIMEOUT(!models.reason(), kSoonMs);
    models.document.setSettings(settings(base::MethodKind::Position, 20000.0));
    QVERIFY(models.reason() == BlockReason::Infeasible);
    QVERIFY(models.runs.resumeBlocked()->reason == BlockReason::NothingToResume);
  }

  /// A stream without slack reads the axes every 0.9 s: that is said once, not with each read.
  void readsThatComeRarelyAreSaidToBeRare() {
    using widgets::Freshness;
    Models models;
    double nowS = 100.0;
    hmi::MachineModel machine{models.session, models.store, models.messages,
                              [&nowS] { return nowS; }};
    const auto readAfter = [&](double passedS) {
      nowS += passedS;
      machine.showSample({base::Instant{}, base::Vec3{1.0, 2.0, 3.0}, 5.0, {}}, std::nullopt);
    };
    const auto lookAfter = [&](double passedS) {
      nowS += passedS;
      machine.showExecuted(5, {}, 8.0, std::nullopt);
      return machine.view().positionFreshness();
    };
    readAfter(0.0);
    QVERIFY(lookAfter(0.4) == Freshness::Live);
    QVERIFY(lookAfter(0.2) == Freshness::Old);
    for (int i = 0; i < 5; ++i) {
      readAfter(0.1);
      for (int look = 0; look < 4; ++look) {
        QVERIFY(lookAfter(0.2) == Freshness::Planned);
        QVERIFY(machine.view().feedFreshness() == Freshness::Planned);
      }
    }
    QVERIFY(lookAfter(0.5) == Freshness::Old);  // a read is missing
    QVERIFY(!machine.positionNowMm());          // that is not where the tool stands now
    readAfter(0.0);
    QVERIFY(lookAfter(0.1) == Freshness::Planned);
    for (int i = 0; i < 40; ++i) {
      readAfter(0.1);
    }
    QVERIFY(lookAfter(0.1) == Freshness::Live);
  }

  void aRunEndsWithItsReport() {
    Models models;
    models.machine.connectTo(QStringLiteral("opc.tcp://cell"));
    models.document.open(kScorpion);
    QTRY_VERIFY_WITH_TIMEOUT(!models.reason() && models.document.view(), kSoonMs);
    QSignalSpy finished(&models.runs, &RunController::finished);
    QSignalSpy started(&models.runs, &RunController::started);
    QVERIFY(models.runs.start());
    QCOMPARE(started.count(), 1);
    QVERIFY(models.reason() == BlockReason::RunInProgress);
    QVERIFY(models.runs.calibrationBlocked()->reason == BlockReason::RunInProgress);
    // While it is in progress no other program takes the place of its own.
    const auto program = models.document.program();
    QVERIFY(finished.wait(kSoonMs));
    QVERIFY(models.document.program() == program);
    const auto report = models.runs.report();
    QVERIFY2(report && report->isFaultless(), report ? report->error.text().c_str() : "");
    const streaming::LiveUpdate& update = models.runs.update();
    QVERIFY(update.state == streaming::RunState::Done);
    QCOMPARE(update.counters.executed, models.document.points().size());
    QTRY_VERIFY_WITH_TIMEOUT(!models.reason(), kSoonMs);
  }
};

RIVULET_TEST(TestRunController)
#include "tst_run_controller.moc"
