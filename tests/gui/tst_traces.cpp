// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Files on the page Traces of the real window: what is shown is what the command line says of
/// them.

#include <QMimeData>
#include <QStandardPaths>
#include <QTableView>
#include <QTemporaryDir>
#include <QtTest>

#include "base/file.h"
#include "hmi/main_window.h"
#include "hmi/trace_layouts.h"
#include "report/trace_source.h"
#include "session/background.h"
#include "support/patience.h"
#include "support/test_program.h"
#include "trace/analysis/trace_analysis.h"
#include "widgets/common/status_label.h"
#include "widgets/plots/time_window.h"
#include "widgets/program/program_text_view.h"
#include "widgets/scope/scope_view.h"
#include "widgets/trace/stop_model.h"
#include "widgets/trace/trace_page.h"

using namespace rivulet;
using hmi::MainWindow;

namespace {

using rivulet::tests::kSoonMs;

/// A square with a stop at each corner; the actual position is 0.02 mm beside the path.
trace::ControlTrace square() {
  trace::ControlTrace trace;
  trace.cycle = std::chrono::milliseconds{4};
  const std::array<base::Vec3, 5> corners{
      {{0.0, 0.0, 0.0}, {10.0, 0.0, 0.0}, {10.0, 10.0, 0.0}, {0.0, 10.0, 0.0}, {0.0, 0.0, 0.0}}};
  base::Instant at{std::chrono::seconds{7}};
  for (std::size_t side = 0; side + 1 < corners.size(); ++side) {
    for (int i = 0; i < 110; ++i) {
      const double share = std::min(i, 100) / 100.0;
      trace::ControlSample sample;
      sample.at = at;
      at += trace.cycle;
      sample.commandMm = corners[side] + share * (corners[side + 1] - corners[side]);
      sample.actualMm = sample.commandMm + base::Vec3{0.02, 0.02, 0.0};
      sample.feedMmPerS = i == 0 || i > 100 ? 0.0 : 25.0;
      sample.line = base::LineNumber{static_cast<std::uint32_t>(side + 2)};
      trace.samples.push_back(sample);
    }
  }
  return trace;
}

std::string csv() {
  std::string text = "t [s];x_set [mm];x_act [mm];Spindle load [%]\n";
  for (int i = 0; i < 500; ++i) {
    text += std::to_string(0.01 * i) + ";" + std::to_string(0.1 * i) + ";" +
            std::to_string(0.1 * i - 0.3) + ";" + std::to_string(20 + i % 7) + "\n";
  }
  return text;
}

}  // namespace

class TestTraces : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;
  std::unique_ptr<MainWindow> m_window;

  QString write(const char* name, const std::string& text) {
    const QString path = m_folder.filePath(QLatin1String(name));
    return base::writeFile(path.toStdString(), text) ? path : QString();
  }

  [[nodiscard]] QString note() const {
    return m_window->tracePage()->findChild<widgets::StatusLabel*>("traceNote")->text();
  }
  [[nodiscard]] const std::vector<widgets::StopRow>& stops() const {
    return static_cast<widgets::StopModel*>(
               m_window->tracePage()->findChild<QTableView*>("stopTable")->model())
        ->rows();
  }
  /// Waits until what was opened has been analysed.
  void open(const QStringList& paths) {
    m_window->openTraces(paths);
    QVERIFY(note().contains("Reading"));
    QTRY_VERIFY_WITH_TIMEOUT(!note().contains("Reading") && !note().contains("Looking for stops"),
                             kSoonMs);
  }

 private Q_SLOTS:
  void initTestCase() {
    QStandardPaths::setTestModeEnabled(true);
    qputenv("XDG_STATE_HOME", m_folder.filePath(QStringLiteral("state")).toUtf8());
    qputenv("XDG_CONFIG_HOME", m_folder.filePath(QStringLiteral("config")).toUtf8());
    hmi::Settings settings;
    settings.language = QStringLiteral("en");
    m_window = std::make_unique<MainWindow>(settings, false);
    m_window->resize(1280, 800);
    m_window->show();
  }

  void showsTheTraceOfAControl() {
    const QString path = write("square.trace", trace::printControlTrace(square()));
    open({path});
    QVERIFY(m_window->tracePage()->isVisible());
    QVERIFY2(note().contains("square.trace"), qPrintable(note()));
    const auto source = report::openTrace(path.toStdString(), {}, 0.0);
    QVERIFY(source);
    const trace::TraceAnalysis analysis = trace::analyseTrace(*source);
    QCOMPARE(stops().size(), analysis.stops.size());
    QVERIFY(stops().size() >= 3);
    for (std::size_t i = 0; i < stops().size(); ++i) {
      QVERIFY(stops()[i].start ==
              base::Instant{analysis.stops[i].start - base::Instant{std::chrono::seconds{7}}});
      QVERIFY(stops()[i].duration == analysis.stops[i].duration);
      QVERIFY(stops()[i].cause == analysis.stops[i].cause);
    }
    QCOMPARE(m_window->tracePage()->view()->panes().size(), std::size_t{4});
  }

  /// The comparison by point was asked for before there was a program.
  void aProgramOpenedLaterIsCompared() {
    QVERIFY(!m_window->program());
    open({m_folder.filePath("square.trace"),
          write("again.trace", trace::printControlTrace(square()))});
    auto* page = m_window->tracePage();
    auto* curves = page->findChild<widgets::ScopeCurves*>();
    QVERIFY(!curves->samples(0, "contour_error"));
    QSignalSpy refused(curves, &widgets::ScopeCurves::axisFailed);
    curves->setAxis(trace::RunAxis::Point);
    QTRY_COMPARE_WITH_TIMEOUT(refused.count(), 1, kSoonMs);
    page->timeWindow()->showRange(0.5, 1.0);
    const QString program = write("square.mpf", "G1 X10 Y0 Z0 F1500\nY10\nX0\nY0\nM30\n");
    m_window->openProgram(program);
    QTRY_VERIFY_WITH_TIMEOUT(curves->axis() == trace::RunAxis::Point, kSoonMs);
    QVERIFY(curves->traces().front()->programPath);
    QVERIFY(page->findChild<widgets::ProgramTextView*>("traceProgram")->lineCount() >= 5);
    // A file that is gone by now is not taken away.
    QVERIFY(QFile::remove(m_folder.filePath("again.trace")));
    const auto shown = curves->traces();
    m_window->openProgram(write("other.mpf", "G1 X10 Y0 Z0 F1500\nY20\nM30\n"));
    QTRY_VERIFY_WITH_TIMEOUT(m_window->program()->name == "other.mpf", kSoonMs);
    session::awaitPool();
    QCoreApplication::processEvents();
    QVERIFY(curves->traces() == shown);
    m_window->openProgram(program);
    QTRY_VERIFY_WITH_TIMEOUT(m_window->program()->name == "square.mpf", kSoonMs);
  }

  void comparesWithTheProgram() {
    open({m_folder.filePath("square.trace")});
    auto* page = m_window->tracePage();
    page->view()->addPane("contour_error");
    page->redrawNow();
    // On a straight side, half of the offset is off the path.
    auto* curves = page->findChild<widgets::ScopeCurves*>();
    const auto error = curves->samples(0, "contour_error");
    QVERIFY(error);
    QVERIFY(std::abs(trace::valueAt(*error, base::Instant{std::chrono::milliseconds{200}}) - 0.02) <
            1e-6);
    QVERIFY(curves->samples(0, "program_point"));
  }

  void showsTablesOfOtherTools() {
    open({write("scope.csv", csv())});
    QTRY_VERIFY(m_window->tracePage()->view()->shows("x_act"));
    auto* curves = m_window->tracePage()->findChild<widgets::ScopeCurves*>();
    QVERIFY(curves->samples(0, "Spindle load [%]"));
    m_window->tracePage()->view()->addPane("x_set - x_act");
    QTRY_VERIFY(curves->samples(0, "x_set - x_act"));
    const auto lag = curves->samples(0, "x_set - x_act");
    QVERIFY(std::abs(lag->range(base::Instant{}, base::Instant::max())->max - 0.3) < 1e-6);
  }

  void comparesFiles() {
    open({m_folder.filePath("square.trace"), m_folder.filePath("scope.csv")});
    QVERIFY(note().contains("square.trace, scope.csv"));
    auto* curves = m_window->tracePage()->findChild<widgets::ScopeCurves*>();
    QCOMPARE(curves->traces().size(), std::size_t{2});
    QVERIFY(std::abs(m_window->tracePage()->timeWindow()->toS() - 4.99) < 1e-6);
  }

  void saysWhatCannotBeReadAndShowsTheRest() {
    const QString rubbish = write("rubbish.csv", "nothing here\n\x01\x02\n");
    open({rubbish, m_folder.filePath("scope.csv")});
    QVERIFY2(note().contains("rubbish.csv"), qPrintable(note()));
    QVERIFY(note().contains("scope.csv"));
    auto* curves = m_window->tracePage()->findChild<widgets::ScopeCurves*>();
    QCOMPARE(curves->traces().size(), std::size_t{1});
    open({m_folder.filePath("missing.rivulet")});
    QVERIFY2(note().contains("missing.rivulet"), qPrintable(note()));
    QCOMPARE(curves->traces().size(), std::size_t{1});
    // Cut in the middle of a line: what came before is shown.
    const std::string whole = trace::printControlTrace(square());
    open({write("cut.trace", whole.substr(0, whole.size() / 2))});
    QVERIFY2(note().contains("cut.trace"), qPrintable(note()));
  }

  /// In the next window they are there again.
  void keepsLayouts() {
    open({m_folder.filePath("square.trace")});
    auto* page = m_window->tracePage();
    page->view()->setArrangement({{"x_act"}, {"hypot(x_act, y_act)", "y_act"}});
    page->keepLayout(QString::fromUtf8("Ablage ä"));
    const auto kept = hmi::loadTraceLayouts(hmi::traceLayoutsFile());
    QVERIFY(kept && kept->layouts == page->layouts() && kept->keptAs.empty());
    QCOMPARE(kept->layouts.list.size(), std::size_t{1});
    const MainWindow another(hmi::Settings{}, false);
    QVERIFY(another.tracePage()->layouts() == kept->layouts);
  }

  /// What can be read is used; the damaged file itself is kept, whatever is saved later.
  void keepsADamagedFileOfLayouts() {
    const auto file = m_folder.filePath("panes.json").toStdString();
    QVERIFY(hmi::loadTraceLayouts(file)->keptAs.empty());  // there is none
    const std::string partly = R"({"standard": "no", "layouts": [3, {"name": "a"},
        {"name": "c", "panes": [["x_act", 4]]},
        {"name": "b", "panes": [["x_act", "y_act"], [], ["x"]]}]})";
    QVERIFY(base::writeFile(file, partly));
    const auto damaged = hmi::loadTraceLayouts(file);
    QVERIFY(damaged);
    QCOMPARE(damaged->layouts.list.size(), std::size_t{1});
    QCOMPARE(damaged->layouts.list[0].panes, (std::vector<QStringList>{{"x_act", "y_act"}, {"x"}}));
    QVERIFY(damaged->layouts.standard.isEmpty());
    QCOMPARE(damaged->keptAs, std::filesystem::path(file + ".damaged"));
    QCOMPARE(base::readFile(damaged->keptAs).value_or(""), partly);
    QVERIFY(hmi::loadTraceLayouts(file)->keptAs.empty());
    QVERIFY(hmi::loadTraceLayouts(file)->layouts == damaged->layouts);
    QVERIFY(base::writeFile(file, "{"));
    const auto rubbish = hmi::loadTraceLayouts(file);
    QVERIFY(rubbish && rubbish->layouts.list.empty());
    QCOMPARE(rubbish->keptAs, std::filesystem::path(file + ".damaged-2"));
    QCOMPARE(base::readFile(damaged->keptAs).value_or(""), partly);
    // The window says so.
    const std::string before = base::readFile(hmi::traceLayoutsFile()).value_or("");
    QVERIFY(base::writeFile(hmi::traceLayoutsFile(), "rubbish"));
    const MainWindow another(hmi::Settings{}, false);
    const QString said = another.tracePage()->findChild<widgets::StatusLabel*>("traceNote")->text();
    QVERIFY2(said.contains("trace_panes.json.damaged"), qPrintable(said));
    QVERIFY(base::writeFile(hmi::traceLayoutsFile(), before));
  }

  void takesDroppedFilesButNoPrograms() {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(m_folder.filePath("scope.csv"))});
    auto* page = m_window->tracePage();
    QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(page, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(page, &drop);
    QTRY_VERIFY_WITH_TIMEOUT(note().startsWith("scope.csv:"), kSoonMs);
    data.setUrls({QUrl::fromLocalFile(m_folder.filePath("square.mpf"))});
    // The window takes it as its program.
    QSignalSpy opened(page, &widgets::TracePage::openRequested);
    QDragEnterEvent program(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(page, &program);
    QDropEvent programDrop(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(page, &programDrop);
    QCOMPARE(opened.count(), 0);
  }
};

RIVULET_TEST(TestTraces)
#include "tst_traces.moc"
