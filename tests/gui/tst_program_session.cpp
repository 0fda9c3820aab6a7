// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Programs of any size on the real window, without a control: read in the background, cancelled,
/// timed, watched on the disk.

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>
#include <functional>

#include "hmi/main_window.h"
#include "session/file_watch.h"
#include "session/program_loader.h"
#include "session/program_timer.h"
#include "support/patience.h"
#include "support/surface_program.h"
#include "support/test_program.h"
#include "widgets/alarms/alarm_line.h"
#include "widgets/program/file_bars.h"
#include "widgets/program/path_view.h"
#include "widgets/program/program_page.h"
#include "widgets/program/program_panel.h"
#include "widgets/program/program_text_view.h"

using namespace rivulet;
using session::FileWatch;
using session::LoadedProgram;
using session::ProgramLoader;
using session::ProgramTimer;

namespace {

using rivulet::tests::kRunMs;
using rivulet::tests::kSoonMs;
using rivulet::tests::surfaceProgram;

void write(const QString& path, const QByteArray& text) {
  QFile file(path);
  QVERIFY(file.open(QIODevice::WriteOnly));
  QCOMPARE(file.write(text), text.size());
}

hmi::Settings settings() {
  hmi::Settings settings;
  settings.language = QStringLiteral("en");
  settings.theme = widgets::Theme::Light;
  return settings;
}

}  // namespace

class TestProgramSession : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    QCoreApplication::setOrganizationName(QStringLiteral("RivuletTest"));
    QVERIFY(QDir().mkpath(QStringLiteral(RIVULET_SCREENSHOTS)));
  }

  void changesOfTheFileAreTold() {
    QTemporaryDir folder;
    const QString path = folder.filePath("a.mpf");
    const QString other = folder.filePath("b.mpf");
    write(path, "G0 X1\n");
    FileWatch watch;
    QSignalSpy states(&watch, &FileWatch::stateChanged);
    const auto last = [&] { return states.last().first().value<FileWatch::State>(); };
    watch.watch(path, session::fileStamp(path));
    QCOMPARE(watch.state(), FileWatch::State::Same);
    // Written to.
    write(path, "G0 X1\nG1 X2 F100\n");
    QTRY_COMPARE_WITH_TIMEOUT(watch.state(), FileWatch::State::Changed, kSoonMs);
    QCOMPARE(states.count(), 1);
    QCOMPARE(last(), FileWatch::State::Changed);
    // Replaced by another that takes its name, as editors and CAM systems do; twice, for the
    // watch must have taken the new file.
    for (const QByteArray& text : {QByteArray("G0 X3\n"), QByteArray("G0 X3\nG0 X4\n")}) {
      watch.watch(path, session::fileStamp(path));
      QCOMPARE(watch.state(), FileWatch::State::Same);
      write(other, text + "G0 Y7\n");
      QVERIFY(QFile::remove(path));
      QVERIFY(QFile::rename(other, path));
      QTRY_COMPARE_WITH_TIMEOUT(watch.state(), FileWatch::State::Changed, kSoonMs);
      watch.watch(path, session::fileStamp(path));
      write(path, text);
      QTRY_COMPARE_WITH_TIMEOUT(watch.state(), FileWatch::State::Changed, kSoonMs);
    }
    // Away, and back as it was.
    watch.watch(path, session::fileStamp(path));
    QVERIFY(QFile::rename(path, other));
    QTRY_COMPARE_WITH_TIMEOUT(watch.state(), FileWatch::State::Gone, kSoonMs);
    QVERIFY(QFile::rename(other, path));
    QTRY_COMPARE_WITH_TIMEOUT(watch.state(), FileWatch::State::Same, kSoonMs);
    // What happened between the reading and the watching is told at once.
    session::FileStamp old = session::fileStamp(path);
    old.bytes += 1;
    watch.watch(path, old);
    QCOMPARE(watch.state(), FileWatch::State::Changed);
    watch.clear();
    QCOMPARE(watch.state(), FileWatch::State::Same);
  }

  void theLastRequestIsReported() {
    QTemporaryDir folder;
    write(folder.filePath("long.mpf"), surfaceProgram(200'000));
    write(folder.filePath("short.mpf"), surfaceProgram(50));
    ProgramLoader loader;
    QSignalSpy failed(&loader, &ProgramLoader::failed);
    QSignalSpy cancelled(&loader, &ProgramLoader::cancelled);
    std::vector<LoadedProgram> loaded;
    connect(&loader, &ProgramLoader::loaded, this,
            [&](const LoadedProgram& program) { loaded.push_back(program); });
    std::vector<double> shares;
    connect(&loader, &ProgramLoader::progressed, this,
            [&](double share) { shares.push_back(share); });
    loader.load({folder.filePath("long.mpf"), {}, {}, 7});
    loader.load({folder.filePath("short.mpf"), {}, {}, 7});
    QVERIFY(loader.isBusy());
    QTRY_COMPARE_WITH_TIMEOUT(loaded.size(), std::size_t{1}, kSoonMs);
    QVERIFY(!loader.isBusy());
    QCOMPARE(loaded.front().view->program->name, std::string("short.mpf"));
    QCOMPARE(loaded.front().view->distancesFor, 7);
    QVERIFY(loaded.front().stamp == session::fileStamp(folder.filePath("short.mpf")));
    // Cancelled: nothing comes, and it is no failure.
    shares.clear();
    loader.load({folder.filePath("long.mpf"), {}, {}, 7});
    QTRY_VERIFY_WITH_TIMEOUT(!shares.empty(), kSoonMs);
    loader.cancel();
    QCOMPARE(cancelled.count(), 1);
    QVERIFY(!loader.isBusy());
    // To its end: the shares grow.
    shares.clear();
    loader.load({folder.filePath("long.mpf"), {}, {}, 7});
    QTRY_COMPARE_WITH_TIMEOUT(loaded.size(), std::size_t{2}, kRunMs);
    QVERIFY(std::is_sorted(shares.begin(), shares.end()));
    QVERIFY(shares.back() <= 1.0);
    QCOMPARE(loaded.back().view->program->trajectory.points.size(), std::size_t{200'003});
    QCOMPARE(failed.count(), 0);
    loader.load({folder.filePath("missing.mpf"), {}, {}, 7});
    QTRY_COMPARE_WITH_TIMEOUT(failed.count(), 1, kSoonMs);
    QVERIFY(!loader.isBusy());
  }

  void timesBelongToTheStreamedPoints() {
    const auto program = std::make_shared<const gcode::Program>(
        gcode::interpretProgram("a", "G0 X0 Y0 Z0\nG1 X10 F600\nX10\nX20\nX30 Y5\n").value());
    const auto view = overview::makeProgramView(program, {0.0, 0.0, 0.0}, 2);
    QCOMPARE(view->points.points.size(), std::size_t{4});
    ProgramTimer timer;
    std::vector<std::shared_ptr<const overview::ProgramTimes>> times;
    connect(&timer, &ProgramTimer::estimated, this, [&](const auto& estimated, const auto& of) {
      QVERIFY(of == view);
      times.push_back(estimated);
    });
    timer.start(view, {base::MethodKind::Position, 2, 5.0});
    // First what the program itself takes, then what a run takes.
    QTRY_COMPARE_WITH_TIMEOUT(times.size(), std::size_t{2}, kSoonMs);
    QVERIFY(!times.front()->run);
    const overview::ProgramTimes& first = *times.back();
    QCOMPARE(first.atS, times.front()->atS);
    QCOMPARE(first.atS.size(), std::size_t{4});
    QVERIFY(std::is_sorted(first.atS.begin(), first.atS.end()));
    QVERIFY(first.programmedS > 3.0 && first.programmedS < 4.0);  // 31.18 mm at 10 mm/s
    QVERIFY(first.run->totalS > 6.2);                             // and at 5 mm/s
    QCOMPARE(first.run->pauses, std::size_t{1});
    QVERIFY(first.run->standingS > 0.0);
    // Other settings: what the program itself takes stays.
    timer.start(view, {base::MethodKind::Signal, 2, 10.0});
    QTRY_COMPARE_WITH_TIMEOUT(times.size(), std::size_t{3}, kSoonMs);
    QCOMPARE(times.back()->programmedS, first.programmedS);
    QVERIFY(times.back()->run->totalS < first.run->totalS);
    QCOMPARE(times.back()->run->pauses, std::size_t{3});
    QVERIFY(times.back()->run->pausesCostS() > 0.0);
    // Another place of the tool is another way to the first point, with pauses and without.
    const auto moved = overview::makeProgramView(program, {50.0, 0.0, 0.0}, 2);
    std::shared_ptr<const overview::PauseMap> pauses;
    disconnect(&timer, nullptr, this, nullptr);
    connect(&timer, &ProgramTimer::planned, this,
            [&](const auto& planned, const auto&) { pauses = planned; });
    connect(&timer, &ProgramTimer::estimated, this,
            [&](const auto& estimated, const auto&) { times.push_back(estimated); });
    timer.start(moved, {base::MethodKind::Signal, 2, 10.0});
    QTRY_VERIFY_WITH_TIMEOUT(times.back()->run && !timer.isBusy(), kSoonMs);
    QVERIFY(pauses != nullptr);
    QCOMPARE(pauses->count(), times.back()->run->pauses);
    QVERIFY(times.back()->run->pausesCostS() > 0.0);
    timer.start(view, {base::MethodKind::Signal, 2, 10.0});
    timer.cancel();
    QVERIFY(!timer.isBusy());
  }

  /// Coordinates a program leaves open are where the tool stands.
  void pointsFollowTheTool() {
    const auto program = std::make_shared<const gcode::Program>(
        gcode::interpretProgram("a", "G0 Z5\nG1 X10 Y0 F600\nX20\n").value());
    const auto view = overview::makeProgramView(program, {1.0, 2.0, 3.0}, 2);
    QVERIFY(view->dependsOnStart);
    QVERIFY((view->points.points.front().positionMm == base::Vec3{1.0, 2.0, 5.0}));
    ProgramLoader loader;
    std::shared_ptr<const overview::ProgramView> placed;
    connect(&loader, &ProgramLoader::placed, this, [&](const auto& made, const auto& request) {
      QVERIFY(request.view == view);
      placed = made;
    });
    loader.place({view, program, {}, {7.0, 8.0, 9.0}, 2});
    loader.place({view, program, {}, {0.0, 0.0, 0.0}, 2});  // one at a time: not begun
    QVERIFY(loader.isPlacing());
    QTRY_VERIFY_WITH_TIMEOUT(placed != nullptr, kSoonMs);
    QVERIFY(!loader.isPlacing());
    QVERIFY(placed->program == program);
    QVERIFY((placed->points.points.front().positionMm == base::Vec3{7.0, 8.0, 5.0}));
    QVERIFY(placed->points.points.back().positionMm == view->points.points.back().positionMm);
  }

  /// Where a stop waits for its moves, they are divided; the program as it was read stays.
  void longMovesAreDividedForTheRun() {
    const auto program = std::make_shared<const gcode::Program>(
        gcode::interpretProgram("a", "G0 X0 Y0 Z5\nG1 X100 F600\nX200 F6000\n").value());
    const auto view = overview::makeProgramView(program, {}, 2);
    ProgramLoader loader;
    std::shared_ptr<const overview::ProgramView> placed;
    connect(&loader, &ProgramLoader::placed, this,
            [&](const auto& made, const auto&) { placed = made; });
    gcode::MoveRules limit;
    limit.secondsMax = 2.0;
    limit.feedMmPerS = 10.0;
    loader.place({view, program, limit, {}, 2});
    QTRY_VERIFY_WITH_TIMEOUT(placed != nullptr, kSoonMs);
    QCOMPARE(placed->points.points.size(), std::size_t{1 + 5 + 5});
    QCOMPARE(placed->program->trajectory.points.size(), std::size_t{11});
    QCOMPARE(program->trajectory.points.size(), std::size_t{3});
    QCOMPARE(placed->program->hash, program->hash);
    QCOMPARE(placed->pointsOfLine({2}).size(), std::size_t{5});
  }

  /// The points within the tolerance of the settings, and all of them again without it. A whole job
  /// keeps all.
  void movesAreMergedForTheRun() {
    QTemporaryDir folder;
    QByteArray text("G1 X0 Y0 Z5 F600\n");
    for (int i = 1; i <= 400; ++i) {
      text += "X" + QByteArray::number(0.1 * i, 'f', 3) + " Y" +
              QByteArray::number(0.002 * i * i * 0.1, 'f', 3) + '\n';
    }
    write(folder.filePath("dense.mpf"), text);
    write(folder.filePath("job.mpf"), "M3 S1000\n" + text + "M5\nM30\n");
    hmi::MainWindow window(settings(), false);
    window.openProgram(folder.filePath("dense.mpf"));
    QTRY_VERIFY_WITH_TIMEOUT(window.program() != nullptr, kSoonMs);
    QCOMPARE(window.program()->trajectory.points.size(), std::size_t{401});
    streaming::StreamSettings stream;
    stream.tolerance = 0.01;
    window.setStreamSettings(stream);
    QTRY_VERIFY_WITH_TIMEOUT(window.program()->merged.has_value(), kSoonMs);
    const gcode::MergedMoves merged = *window.program()->merged;
    QCOMPARE(merged.of, std::size_t{401});
    QVERIFY(merged.to < 100 && merged.deviationMm <= 0.01);
    QCOMPARE(window.program()->trajectory.points.size(), merged.to);
    QCOMPARE(window.program()->trajectory.points.back().line.value, 401U);
    stream.tolerance = 0.0;
    window.setStreamSettings(stream);
    QTRY_COMPARE_WITH_TIMEOUT(window.program()->trajectory.points.size(), std::size_t{401},
                              kSoonMs);
    stream.tolerance = 0.01;
    stream.wholeJob = true;
    window.setStreamSettings(stream);
    window.openProgram(folder.filePath("job.mpf"));
    QTRY_VERIFY_WITH_TIMEOUT(window.program()->name == "job.mpf", kSoonMs);
    QTRY_COMPARE_WITH_TIMEOUT(window.program()->trajectory.points.size(), std::size_t{401},
                              kSoonMs);
    QVERIFY(!window.program()->merged);
  }

  void cancelLeavesTheProgramThatWasThere() {
    QTemporaryDir folder;
    write(folder.filePath("small.mpf"), surfaceProgram(300));
    write(folder.filePath("huge.mpf"), surfaceProgram(3'000'000));  // read long enough to cancel
    hmi::MainWindow window(settings(), false);
    window.show();
    window.openProgram(folder.filePath("small.mpf"));
    QTRY_VERIFY_WITH_TIMEOUT(window.program() != nullptr, kSoonMs);
    const auto small = window.program();

    auto* bar = window.findChild<widgets::LoadBar*>();
    auto* progress = bar->findChild<QProgressBar*>();
    window.openProgram(folder.filePath("huge.mpf"));
    QTRY_VERIFY_WITH_TIMEOUT(bar->isVisible() && progress->value() > 0, kRunMs);
    QTest::mouseClick(bar->findChild<QPushButton*>(), Qt::LeftButton);
    QVERIFY(!bar->isVisible());
    QVERIFY(window.findChild<widgets::AlarmLine*>()->text().isEmpty());
    QVERIFY(window.program() == small);
  }

  /// What is not understood is accepted and taken back, a dialect is ordered: the program is read
  /// again each time, with all that was ordered before.
  void theWayOfReadingIsOrdered() {
    QTemporaryDir folder;
    const QString path = folder.filePath("a.mpf");
    write(path, "G0 X0 Y0 Z0\nG1 X10 F500\nG87 X20\nG1 X30\nCYCLE83(1)\nG1 X40\n");
    hmi::MainWindow window(settings(), false);
    window.openProgram(path);
    QTRY_VERIFY_WITH_TIMEOUT(window.program() != nullptr, kSoonMs);
    QVERIFY(!window.program()->isStreamable());
    auto* panel = window.programPage()->panel();
    const auto readAgain = [&](const std::function<void()>& order) {
      const auto before = window.program();
      order();
      return QTest::qWaitFor([&] { return window.program() != before; }, kSoonMs);
    };
    QStringList names;
    for (const gcode::Diagnostic& finding : window.program()->diagnostics) {
      const QString name = QString::fromStdString(gcode::acceptableName(finding));
      if (!name.isEmpty() && !names.contains(name)) {
        names.append(name);
      }
    }
    QVERIFY(names.size() >= 2);
    for (const QString& name : names) {
      QVERIFY(!window.program()->isStreamable());
      QVERIFY(readAgain([&] { Q_EMIT panel->acceptRequested(name); }));
    }
    QVERIFY(window.program()->isStreamable());
    // Another dialect keeps what was accepted.
    QVERIFY(readAgain([&] { Q_EMIT panel->dialectRequested(gcode::Dialect::Sinumerik); }));
    QVERIFY(window.program()->dialect == gcode::Dialect::Sinumerik);
    QVERIFY(window.program()->isStreamable());
    QVERIFY(readAgain([&] { Q_EMIT panel->takeBackRequested(names.front()); }));
    QVERIFY(!window.program()->isStreamable());
    QVERIFY(window.program()->dialect == gcode::Dialect::Sinumerik);
    // Opened anew, it is read as any other.
    QVERIFY(readAgain([&] { window.openProgram(path); }));
    QVERIFY(!window.program()->isStreamable());
  }

  /// The file changes under the window; Reload takes the new text, the old one stays until then.
  void aChangedFileIsReloadedOnDemand() {
    QTemporaryDir folder;
    const QString path = folder.filePath("a.mpf");
    write(path, surfaceProgram(100));
    hmi::MainWindow window(settings(), false);
    window.resize(1440, 900);
    window.show();
    window.openProgram(path);
    QTRY_VERIFY_WITH_TIMEOUT(window.program() != nullptr, kSoonMs);
    const std::string hash = window.program()->hash;
    auto* banner = window.findChild<widgets::FileBanner*>();
    QVERIFY(!banner->isVisible());
    write(path, surfaceProgram(120));
    QTRY_VERIFY_WITH_TIMEOUT(banner->isVisible(), kSoonMs);
    QCOMPARE(window.program()->hash, hash);
    QVERIFY(window.grab().save(QStringLiteral(RIVULET_SCREENSHOTS "/file-changed.png")));
    // At this width nothing is cut, and nothing scrolls sideways.
    for (const QScrollArea* area : window.findChildren<QScrollArea*>()) {
      if (area->isVisible()) {
        QVERIFY2(area->widget()->width() <= area->viewport()->width(),
                 area->widget()->metaObject()->className());
      }
    }
    QTest::mouseClick(banner->findChild<QPushButton*>(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(window.program()->hash != hash, kSoonMs);
    QVERIFY(!banner->isVisible());
    QVERIFY(QFile::remove(path));
    QTRY_VERIFY_WITH_TIMEOUT(banner->isVisible(), kSoonMs);
    QCOMPARE(banner->state(), widgets::FileBanner::State::Gone);
  }
};

RIVULET_TEST(TestProgramSession)
#include "tst_program_session.moc"
