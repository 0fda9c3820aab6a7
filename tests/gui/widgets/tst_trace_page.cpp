// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QDropEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMimeData>
#include <QPointingDevice>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTableView>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>
#include <QUrl>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "base/file.h"
#include "gui/widgets/page_test.h"
#include "gui/widgets/samples.h"
#include "support/test_program.h"
#include "trace/hdf5.h"
#include "trace/import/import.h"
#include "widgets/common/number_field.h"
#include "widgets/common/number_format.h"
#include "widgets/common/status_label.h"
#include "widgets/common/theme.h"
#include "widgets/plots/time_window.h"
#include "widgets/program/program_text_view.h"
#include "widgets/scope/path_pane.h"
#include "widgets/scope/scope_view.h"
#include "widgets/trace/columns_dialog.h"
#include "widgets/trace/layout_menu.h"
#include "widgets/trace/path_panel.h"
#include "widgets/trace/stop_model.h"
#include "widgets/trace/trace_page.h"

using namespace rivulet;
using namespace rivulet::widgets;

namespace {

QString note(const TracePage& page) {
  return page.findChild<StatusLabel*>("traceNote")->text();
}

/// At 10 mm/s along all points of a program, from the origin, without stopping.
trace::ControlTrace alongProgram(const gcode::Program& program) {
  trace::ControlTrace trace;
  trace.cycle = std::chrono::milliseconds{10};
  base::Vec3 from;
  base::Instant at{};
  for (const gcode::StreamPoint& point : test::streamed(program)) {
    const double lengthMm = base::distance(from, point.positionMm);
    const int steps = static_cast<int>(std::lround(lengthMm / 0.1));
    for (int i = 1; i <= steps; ++i) {
      trace::ControlSample sample;
      at += trace.cycle;
      sample.at = at;
      sample.commandMm = from + static_cast<double>(i) / steps * (point.positionMm - from);
      sample.actualMm = sample.commandMm;
      sample.feedMmPerS = 10.0;
      trace.samples.push_back(sample);
    }
    from = point.positionMm;
  }
  return trace;
}

void drop(QWidget* on, const QMimeData& data) {
  const QPoint place(100, 20);
  QDragEnterEvent enter(place, Qt::CopyAction, &data, Qt::LeftButton, {});
  QCoreApplication::sendEvent(on, &enter);
  QDropEvent event(place, Qt::CopyAction, &data, Qt::LeftButton, {});
  QCoreApplication::sendEvent(on, &event);
}

}  // namespace

class TestTracePage : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    test::failOnWarnings();
    applyTheme(Theme::Light);
  }

  void windowFollowsUntilTheOperatorLooksBack() {
    TimeWindow window;
    QSignalSpy changes(&window, &TimeWindow::changed);
    window.setEnd(100.0);
    QVERIFY(window.isLive());
    QCOMPARE(window.toS(), 100.0);
    window.pan(-20.0);
    QVERIFY(!window.isLive());
    const double to = window.toS();
    window.setEnd(110.0);
    QCOMPARE(window.toS(), to);
    window.goLive();
    QCOMPARE(window.toS(), 110.0);
    const double from = window.fromS();
    const double middle = (window.fromS() + window.toS()) / 2.0;
    window.zoom(0.5, middle);
    QVERIFY(window.fromS() > from);
    QCOMPARE((window.fromS() + window.toS()) / 2.0, middle);
    for (int step = 0; step < 100; ++step) {
      window.zoom(0.5, middle);
    }
    QVERIFY(window.toS() - window.fromS() >= 0.00199);
    window.showAll();
    QCOMPARE(window.fromS(), 0.0);
    QCOMPARE(window.toS(), 110.0);
    QVERIFY(changes.count() > 4);
  }

  void manySamplesMakeFewRedraws() {
    TracePage page;
    static_cast<void>(test::picture(page, {800, 500}));
    ScopePane* pane = page.view()->panes().front();
    QSignalSpy redraws(pane, &ScopePane::redrawn);
    for (int index = 0; index < 10'000; ++index) {
      page.append({index * 0.004, base::Vec3{1.0 * index, 0.0, 0.0}, 8.0});
    }
    QCOMPARE(redraws.count(), 0);  // a redraw never happens inside an append
    QTRY_COMPARE(redraws.count(), 1);
    QVERIFY(test::settle(page));
    QCOMPARE(redraws.count(), 1);
  }

  void stopsAreListed() {
    test::Language language;
    StopModel model;
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    StopRow stop =
        stopRow(trace::Pause{base::Instant{std::chrono::milliseconds{1500}},
                             std::chrono::milliseconds{41}, trace::PauseOrigin::Inferred});
    model.append(stop);
    QCOMPARE(model.index(0, StopModel::Start).data().toString(),
             QString("1.500") + QChar(0x00A0) + "s");
    QCOMPARE(model.index(0, StopModel::Duration).data().toString(),
             QString("41") + QChar(0x00A0) + "ms");
    QCOMPARE(model.index(0, StopModel::Cause).data().toString(), QString("I (inferred)"));
    QCOMPARE(model.index(0, StopModel::Line).data().toString(), QString());
    language.german();
    QCOMPARE(model.index(0, StopModel::Cause).data().toString(), QString("A (abgeleitet)"));
    language.english();
    stop.cause = trace::StopCause::ExactStop;
    stop.line = 20;
    stop.evidence = "the path turns by 90 degrees";
    model.setRows(std::vector<StopRow>{stop});
    QCOMPARE(model.index(0, StopModel::Cause).data().toString(), QString("Exact stop"));
    QCOMPARE(model.index(0, StopModel::Cause).data(Qt::ToolTipRole).toString(),
             QString("the path turns by 90 degrees"));
    QCOMPARE(model.index(0, StopModel::Line).data().toString(), QString("20"));
    model.clear();
    QCOMPARE(model.rowCount(), 0);
  }

  void showsLiveSamplesThenTheControlsTrace() {
    test::Language language;
    TracePage page;
    QVERIFY(note(page).contains("No samples yet"));
    page.append({0.0, base::Vec3{1.0, 2.0, 3.0}, 8.0});
    page.append({0.1, std::nullopt, 8.0});
    QVERIFY(note(page).contains("Live samples"));
    page.addPause({base::Instant{std::chrono::milliseconds{50}}, std::chrono::milliseconds{40},
                   trace::PauseOrigin::Inferred});
    auto* table = page.findChild<QTableView*>("stopTable");
    QCOMPARE(table->model()->rowCount(), 1);
    const auto trace = test::controlTrace(0.9);
    const auto shown = test::shownTrace(*trace);
    page.showTraces({shown}, TracePage::Source::Control);
    QVERIFY(note(page).contains("The control's own trace"));
    QVERIFY(note(page).contains(QString("every 4") + QChar(0x00A0) + "ms"));
    // The same stops as those that the command line tells.
    const auto pauses = test::pausesOf(*trace);
    QCOMPARE(table->model()->rowCount(), static_cast<int>(shown->stops.size()));
    QVERIFY(shown->stops.size() >= pauses.size() - 1);
    QVERIFY(!page.findChild<QPushButton*>("traceLive")->isEnabled());
    page.clear();
    QCOMPARE(table->model()->rowCount(), 0);
    QVERIFY(note(page).contains("No samples yet"));
    QVERIFY(page.findChild<QPushButton*>("traceLive")->isEnabled());
  }

  void saysWhatCannotBeRead() {
    test::Language language;
    TracePage page;
    page.showReading({"a.csv"});
    QVERIFY(note(page).contains("Reading a.csv"));
    page.showProblem("a.csv: no numbers.");
    QVERIFY(note(page).startsWith("a.csv: no numbers."));
    // What can be read is shown, beside what is wrong.
    page.showTraces({test::shownTrace(*test::controlTrace(0.9), "b.csv")},
                    TracePage::Source::Files);
    QVERIFY(note(page).startsWith("a.csv: no numbers."));
    QVERIFY(note(page).contains("b.csv"));
    page.showReading({"b.csv"});
    page.showTraces({test::shownTrace(*test::controlTrace(0.9), "b.csv")},
                    TracePage::Source::Files);
    QVERIFY(!note(page).contains("no numbers"));
  }

  void wheelKeysAndRubberBandZoom() {
    TracePage page;
    page.showTraces({test::shownTrace(*test::controlTrace(0.9))}, TracePage::Source::Files);
    static_cast<void>(test::picture(page, {1000, 640}));
    TimeWindow& window = *page.timeWindow();
    const double length = window.toS();
    QVERIFY(std::abs(length - 19.996) < 1e-9);
    auto* pane = page.findChild<ScopePane*>("scopePane0");
    const QPoint middle = pane->rect().center();
    QWheelEvent turn(middle, pane->mapToGlobal(middle), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                     Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(pane, &turn);
    QVERIFY(window.toS() - window.fromS() < 0.9 * length);
    QTest::keyClick(pane, Qt::Key_Home);
    QCOMPARE(window.toS() - window.fromS(), length);
    QTest::keyClick(pane, Qt::Key_Plus);
    const double span = window.toS() - window.fromS();
    QVERIFY(span < length);
    const double from = window.fromS();
    QTest::keyClick(pane, Qt::Key_Right);
    QVERIFY(window.fromS() > from);
    QTest::keyClick(pane, Qt::Key_Left);
    QVERIFY(std::abs(window.fromS() - from) < 1e-9);
    QTest::keyClick(pane, Qt::Key_Minus);
    QVERIFY(window.toS() - window.fromS() > span);
    QTest::keyClick(pane, Qt::Key_Home);
    // Half of what is seen.
    const int left = static_cast<int>(kScopeLeftPx);
    const int wide = pane->width() - left - static_cast<int>(kScopeRightPx);
    QTest::mousePress(pane, Qt::LeftButton, Qt::ControlModifier, {left + wide / 4, middle.y()});
    QTest::mouseMove(pane, {left + wide / 2, middle.y()});
    QTest::mouseRelease(pane, Qt::LeftButton, Qt::ControlModifier,
                        {left + 3 * wide / 4, middle.y()});
    QVERIFY(std::abs(window.fromS() - length / 4.0) < 0.1);
    QVERIFY(std::abs(window.toS() - 3.0 * length / 4.0) < 0.1);
    QTest::mousePress(pane, Qt::LeftButton, {}, {left + wide / 2, middle.y()});
    QTest::mouseMove(pane, {left + wide / 2 + 100, middle.y()});
    QTest::mouseRelease(pane, Qt::LeftButton, {}, {left + wide / 2 + 100, middle.y()});
    QVERIFY(window.fromS() < length / 4.0 - 0.5);
    QVERIFY(!page.findChild<QTableWidget*>("cursorTable")->item(0, 0)->text().contains("1"));
  }

  void cursorsMeasure() {
    test::Language language;
    TracePage page;
    trace::ControlTrace straight;
    for (int i = 0; i <= 1000; ++i) {
      trace::ControlSample sample;
      sample.at = base::Instant{std::chrono::milliseconds{4 * i}};
      sample.actualMm.x = 0.02 * i;
      sample.feedMmPerS = 5.0;
      straight.samples.push_back(sample);
    }
    page.showTraces({test::shownTrace(straight)}, TracePage::Source::Files);
    static_cast<void>(test::picture(page, {1000, 640}));
    auto* pane = page.findChild<ScopePane*>("scopePane0");
    const int left = static_cast<int>(kScopeLeftPx);
    const int wide = pane->width() - left - static_cast<int>(kScopeRightPx);
    const int y = pane->height() / 2;
    QTest::mouseClick(pane, Qt::LeftButton, {}, {left + wide / 4, y});
    QTest::mouseClick(pane, Qt::LeftButton, Qt::ShiftModifier, {left + wide / 2, y});
    QVERIFY(test::settle(page));
    auto* table = page.findChild<QTableWidget*>("cursorTable");
    const auto figure = [table](const char* name) {
      for (int row = 0; row < table->rowCount(); ++row) {
        if (table->verticalHeaderItem(row)->text() == name) {
          return QLocale().toDouble(table->item(row, 0)->text());
        }
      }
      return std::nan("");
    };
    QVERIFY(std::abs(figure("B − A") - 5.0) < 0.1);
    QVERIFY(std::abs(figure("Slope, 1/s") - 5.0) < 1e-6);
    QVERIFY(std::abs(figure("Mean") - 7.5) < 0.1);
    QVERIFY(std::abs(figure("Minimum") - figure("At A")) < 0.03);
    QVERIFY(std::abs(figure("Maximum") - figure("At B")) < 0.03);
    QVERIFY(std::abs(figure("Samples") - 250.0) <= 5.0);
    // A cursor is dragged, and moved by keys.
    const double before = figure("At A");
    QTest::mousePress(pane, Qt::LeftButton, {}, {left + wide / 4, y});
    QTest::mouseMove(pane, {left + wide / 8, y});
    QTest::mouseRelease(pane, Qt::LeftButton, {}, {left + wide / 8, y});
    QVERIFY(test::settle(page));
    QVERIFY(figure("At A") < before - 2.0);
    const double moved = figure("At A");
    QTest::keyClick(pane, Qt::Key_Right, Qt::ShiftModifier);
    QVERIFY(test::settle(page));
    QVERIFY(figure("At A") > moved);
    QTest::keyClick(pane, Qt::Key_C);
    QVERIFY(test::settle(page));
    QVERIFY(std::isnan(figure("At A")) || table->item(0, 0)->text() == noValue());
  }

  void pathAndCursorsLeadToEachOther() {
    test::Language language;
    TracePage page;
    page.showTraces({test::shownTrace(*test::controlTrace(0.9))}, TracePage::Source::Files);
    page.findChild<QTabWidget*>("tracePanel")->setCurrentIndex(3);
    static_cast<void>(test::picture(page, {1000, 700}));
    auto* path = page.findChild<PathPane*>("scopePath");
    page.timeWindow()->showRange(0.0, 6.0);  // less than one turn: each place is passed once
    page.redrawNow();
    auto* cursors = page.findChild<ScopeCursors*>();
    const auto place = path->placeOf(3.0);
    QVERIFY(place);
    QTest::mouseClick(path, Qt::LeftButton, {}, place->toPoint());
    QVERIFY(cursors->atS(ScopeCursors::A));
    QVERIFY(std::abs(*cursors->atS(ScopeCursors::A) - 3.0) < 0.2);
    QTest::mouseClick(path, Qt::LeftButton, Qt::ShiftModifier, path->placeOf(5.0)->toPoint());
    QVERIFY(std::abs(*cursors->atS(ScopeCursors::B) - 5.0) < 0.2);
    QVERIFY(path->placeText().startsWith("X -"));
    cursors->set(ScopeCursors::A, 0.0);
    QVERIFY2(path->placeText().startsWith("X 10.000  Y 0.0"), qPrintable(path->placeText()));
    // Beside the path, nothing happens.
    QTest::mouseClick(path, Qt::LeftButton, {}, {2, path->height() - 2});
    QCOMPARE(*cursors->atS(ScopeCursors::A), 0.0);
  }

  void linesAndCursorLeadToEachOther() {
    test::Language language;
    // Lines 2 to 5 twice: a square, and again.
    const auto program = test::programFrom(
        "SQUARE.MPF", "G17 G90\nAA: G1 X10 Y0 Z0 F1500\nY10\nX0\nY0\nREPEAT AA P=1\nG4 F1\nM30\n");
    const trace::ControlTrace motion = alongProgram(*program);
    TracePage page;
    page.showTraces({test::shownTrace(motion, "a", program.get())}, TracePage::Source::Files);
    page.findChild<QTabWidget*>("tracePanel")->setCurrentIndex(3);
    static_cast<void>(test::picture(page, {1000, 700}));
    auto* panel = page.findChild<PathPanel*>();
    auto* text = panel->text();
    auto* said = page.findChild<QLabel*>("traceProgramNote");
    auto* cursors = page.findChild<ScopeCursors*>();
    QVERIFY2(said->text().startsWith("Open the NC program"), qPrintable(said->text()));
    const auto view = test::viewOf(program);
    page.setProgram(view);
    const auto mark = [&](double atS) {
      cursors->set(ScopeCursors::A, atS);
      return panel->markedLine();
    };
    QCOMPARE(mark(0.5), std::size_t{2});
    QCOMPARE(mark(1.5), std::size_t{3});
    QCOMPARE(mark(3.5), std::size_t{5});
    QCOMPARE(mark(5.5), std::size_t{3});
    // A click on the line goes to its first time, then to the next, then around.
    page.timeWindow()->showRange(0.0, 0.8);
    const auto click = [&](std::size_t line) {
      Q_EMIT text->lineChosen(line);
      return cursors->atS(ScopeCursors::A).value_or(-1.0);
    };
    QVERIFY(std::abs(click(4) - 2.0) < 0.03);
    QVERIFY(page.timeWindow()->fromS() < 2.0 && page.timeWindow()->toS() > 2.0);
    QCOMPARE(panel->markedLine(), std::size_t{4});
    QVERIFY2(said->text().contains("2 times"), qPrintable(said->text()));
    QVERIFY(std::abs(click(4) - 6.0) < 0.03);
    QVERIFY(std::abs(click(4) - 2.0) < 0.03);
    QVERIFY(std::abs(click(3) - 1.0) < 0.03);
    // A line without motion says so and leaves the cursor.
    const double before = *cursors->atS(ScopeCursors::A);
    QCOMPARE(click(7), before);
    QVERIFY2(said->text().contains("line 7"), qPrintable(said->text()));
    // A click on the path marks the line there.
    page.timeWindow()->showRange(0.0, 3.9);
    page.redrawNow();
    auto* path = page.findChild<PathPane*>("scopePath");
    QTest::mouseClick(path, Qt::LeftButton, {}, path->placeOf(2.5)->toPoint());
    QCOMPARE(panel->markedLine(), std::size_t{4});
    // A recording of another program is not linked.
    trace::ShownTrace other = *test::shownTrace(motion, "b", program.get());
    other.programHash = "0123";
    page.showTraces({std::make_shared<const trace::ShownTrace>(other)}, TracePage::Source::Files);
    QCOMPARE(mark(1.5), std::size_t{0});
    QVERIFY2(said->text().contains("another program"), qPrintable(said->text()));
  }

  void thePathIsTurnedColouredAndItsErrorEnlarged() {
    test::Language language;
    const auto program =
        test::programFrom("SQUARE.MPF", "G17 G90\nG1 X10 Y0 Z0 F1500\nY10 Z2\nX0\nY0 Z0\nM30\n");
    trace::ControlTrace motion = alongProgram(*program);
    for (trace::ControlSample& sample : motion.samples) {
      sample.actualMm = sample.commandMm + base::Vec3{0.0, 0.0, 0.01};
    }
    TracePage page;
    page.showTraces({test::shownTrace(*test::controlTrace(0.9))}, TracePage::Source::Files);
    page.findChild<QTabWidget*>("tracePanel")->setCurrentIndex(3);
    static_cast<void>(test::picture(page, {1000, 760}));
    auto* path = page.findChild<PathPane*>("scopePath");
    auto* error = page.findChild<QComboBox*>("tracePathError");
    auto* colour = page.findChild<QComboBox*>("tracePathColour");
    QVERIFY(!error->isEnabled());  // there is no program to measure from
    page.showTraces({test::shownTrace(motion, "a", program.get())}, TracePage::Source::Files);
    page.redrawNow();
    QVERIFY(error->isEnabled());
    const auto choose = [](QComboBox* list, const QString& text) {
      const int index = list->findText(text, Qt::MatchContains);
      QVERIFY2(index >= 0, qPrintable(text));
      list->setCurrentIndex(index);
      Q_EMIT list->activated(index);
    };
    choose(colour, "X actual");
    page.redrawNow();
    QVERIFY(std::abs(path->colourRange().min - 0.0) < 1e-6);
    QVERIFY(std::abs(path->colourRange().max - 10.0) < 1e-6);
    const int coloured = test::colourCount(path->grab().toImage());
    choose(colour, "the trace");
    page.redrawNow();
    QVERIFY(path->colourRange().isEmpty());
    QVERIFY(coloured > test::colourCount(path->grab().toImage()));
    // From the side, the error in Z is seen; × 100 it is 1 mm.
    QTest::mouseClick(page.findChild<QPushButton*>("tracePath3D"), Qt::LeftButton);
    page.redrawNow();
    path->setFocus();
    const overview::Projection::Angles first = path->angles();
    QTest::keyClick(path, Qt::Key_Left);
    QCOMPARE(path->angles().turnDeg, first.turnDeg + 5.0);
    QTest::keyClick(path, Qt::Key_Home);
    QVERIFY(path->angles() == first);
    const QPoint middle = path->rect().center();
    QTest::mousePress(path, Qt::LeftButton, {}, middle);
    QMouseEvent drag(QEvent::MouseMove, middle + QPoint(40, 20), path->mapToGlobal(middle),
                     Qt::NoButton, Qt::LeftButton, {});
    QCoreApplication::sendEvent(path, &drag);
    QTest::mouseRelease(path, Qt::LeftButton, {}, middle + QPoint(40, 20));
    QVERIFY(std::abs(path->angles().turnDeg - (first.turnDeg - 20.0)) < 1e-9);
    QVERIFY(std::abs(path->angles().tiltDeg - (first.tiltDeg + 10.0)) < 1e-9);
    QVERIFY(!page.findChild<ScopeCursors*>()->atS(ScopeCursors::A));  // a drag is no click
    for (int i = 0; i < 40; ++i) {
      QTest::keyClick(path, Qt::Key_Up);
    }
    QCOMPARE(path->angles().tiltDeg, -90.0);
    QTest::keyClick(path, Qt::Key_Home);
    page.redrawNow();
    QVERIFY(base::distance(*path->shownMm(0.49), {5.0, 0.0, 0.01}) < 1e-6);
    choose(error, QStringLiteral("100"));
    page.redrawNow();
    QCOMPARE(path->enlargement(), 100.0);
    choose(colour, "Z actual");
    page.setProgram(test::viewOf(program));
    page.findChild<ScopeCursors*>()->set(ScopeCursors::A, 1.5);
    language.german();
    applyTheme(Theme::Dark);
    test::keep(test::picture(page, {1280, 800}), "trace-path-3d");
    QCOMPARE(test::cutTexts(page), QStringList());
    language.english();
    applyTheme(Theme::Light);
    page.redrawNow();
    QVERIFY(base::distance(*path->shownMm(0.49), {5.0, 0.0, 1.0}) < 1e-3);
    QTest::mouseClick(page.findChild<QPushButton*>("tracePathTop"), Qt::LeftButton);
    QVERIFY(path->angles() == overview::Projection::Angles{});
  }

  void asksWhatColumnsMean() {
    test::Language language;
    const std::string text = "a;b, mm;c\n0;1;2\n10;3;4\n20;5;6\n";
    const auto shownTable = [&text](const std::string& mapping) {
      const auto imported = trace::importTrace(text, *trace::parseTableMapping(mapping));
      trace::ShownTrace shown = trace::makeShownTrace(trace::Trace(*imported));
      shown.name = "scope.csv";
      return std::make_shared<const trace::ShownTrace>(std::move(shown));
    };
    TracePage page;
    std::string layout;
    trace::TableMapping mapping;
    connect(&page, &TracePage::mappingChosen, this,
            [&](const std::string& of, const trace::TableMapping& chosen) {
              layout = of;
              mapping = chosen;
            });
    page.resize(1000, 700);
    page.show();
    page.showTraces({shownTable("")}, TracePage::Source::Files);
    auto* dialog = page.findChild<ColumnsDialog*>();
    QVERIFY(dialog != nullptr);  // no position is known
    auto* note = dialog->findChild<StatusLabel*>("columnsNote");
    auto* accept = dialog->findChild<QPushButton*>("columnsAccept");
    const auto list = [&dialog](const char* name) { return dialog->findChild<QComboBox*>(name); };
    QVERIFY2(note->text().startsWith("Without a position"), qPrintable(note->text()));
    QCOMPARE(list("columnRole0")->currentText(), QString("Time"));
    list("columnRole1")->setCurrentIndex(list("columnRole1")->findText("X actual"));
    QCOMPARE(note->text(), QString("The trace can be analysed."));
    list("columnUnit1")->setCurrentText("um");
    list("columnRole2")->setCurrentIndex(list("columnRole2")->findText("X actual"));
    QVERIFY2(note->text().startsWith("Two columns"), qPrintable(note->text()));
    QVERIFY(!accept->isEnabled());
    list("columnRole2")->setCurrentIndex(list("columnRole2")->findText("Y set point"));
    QVERIFY(!dialog->findChild<NumberField*>("columnsRate")->isEnabled());
    dialog->findChild<NumberField*>("columnsOffset")->setValue(1.5);
    test::keep(test::picture(*dialog, {820, 560}), "trace-columns");
    QCOMPARE(test::cutTexts(*dialog), QStringList());
    QTest::mouseClick(accept, Qt::LeftButton);
    QCOMPARE(trace::printTableMapping(mapping),
             std::string("time=a:ms,x_act=#2:um,y_set=c:mm,offset=1.5,guess=no"));
    QCOMPARE(layout, std::string("a|b, mm|c"));
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QVERIFY(page.findChild<ColumnsDialog*>() == nullptr);
    // As chosen: the first sample is at 1.5 s, in mm. It is not asked again but on request.
    page.showTraces({shownTable(trace::printTableMapping(mapping))}, TracePage::Source::Files);
    QVERIFY(page.findChild<ColumnsDialog*>() == nullptr);
    auto* curves = page.findChild<ScopeCurves*>();
    QVERIFY(curves->samples(0, "x_act")->timeAt(0) ==
            base::Instant{std::chrono::milliseconds{1500}});
    QVERIFY(std::abs(curves->samples(0, "x_act")->valueAt(1) - 0.003) < 1e-12);
    page.findChild<QTabWidget*>("tracePanel")->setCurrentIndex(1);
    QTest::mouseClick(page.findChild<QPushButton*>("signalColumns"), Qt::LeftButton);
    dialog = page.findChild<ColumnsDialog*>();
    QVERIFY(dialog != nullptr);
    QCOMPARE(list("columnUnit1")->currentText(), QString("um"));
    QTest::keyClick(dialog, Qt::Key_Escape);
    // Who has said no is not asked again.
    page.showTraces({shownTable("")}, TracePage::Source::Files);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QVERIFY(page.findChild<ColumnsDialog*>() == nullptr);
  }

  void goesToPlaces() {
    test::Language language;
    TracePage page;
    trace::ControlTrace steps;
    for (int i = 0; i <= 1000; ++i) {
      trace::ControlSample sample;
      sample.at = base::Instant{std::chrono::milliseconds{10 * i}};
      sample.line = base::LineNumber{static_cast<std::uint32_t>(1 + i / 100)};
      steps.samples.push_back(sample);
    }
    page.showTraces({test::shownTrace(steps)}, TracePage::Source::Files);
    static_cast<void>(test::picture(page, {1000, 640}));
    TimeWindow& window = *page.timeWindow();
    window.showRange(0.0, 1.0);
    page.findChild<QTabWidget*>("tracePanel")->setCurrentIndex(2);
    auto* where = page.findChild<QLineEdit*>("goToWhere");
    auto* what = page.findChild<QComboBox*>("goToWhat");
    auto* problem = page.findChild<QLabel*>("goToNote");
    QTest::keyClicks(where, "7.5");
    QTest::keyClick(where, Qt::Key_Return);
    QVERIFY(window.fromS() < 7.5 && window.toS() > 7.5 && window.toS() < 9.0);
    what->setCurrentIndex(1);
    where->clear();
    QTest::keyClicks(where, "4");
    QTest::mouseClick(page.findChild<QPushButton*>("goTo"), Qt::LeftButton);
    QVERIFY(window.fromS() < 3.0 && window.toS() > 3.0 && window.toS() < 4.5);
    QVERIFY(problem->isHidden());
    for (const char* text : {"99", "x", ""}) {
      where->setText(text);
      QTest::keyClick(where, Qt::Key_Return);
      QVERIFY(!problem->isHidden());
    }
    QVERIFY(window.fromS() < 3.0 && window.toS() > 3.0);
  }

  void aRowLeadsToItsStop() {
    TracePage page;
    page.showTraces({test::shownTrace(*test::controlTrace(0.9))}, TracePage::Source::Files);
    static_cast<void>(test::picture(page, {1000, 640}));
    page.timeWindow()->showRange(0.0, 0.5);
    auto* table = page.findChild<QTableView*>("stopTable");
    const QRect cell = table->visualRect(table->model()->index(3, 0));
    QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, cell.center());
    const double at = base::toSeconds(static_cast<StopModel*>(table->model())->rows()[3].start);
    QVERIFY(page.timeWindow()->fromS() < at && page.timeWindow()->toS() > at);
    QVERIFY(std::abs(page.timeWindow()->toS() - page.timeWindow()->fromS() - 0.5) < 1e-9);
    QTest::keyClick(table, Qt::Key_Down);
    QTest::keyClick(table, Qt::Key_Return);
  }

  /// The time in the middle of two fingers stays there.
  void aPinchZooms() {
    TracePage page;
    page.showTraces({test::shownTrace(*test::controlTrace(0.9))}, TracePage::Source::Files);
    page.resize(1000, 640);
    page.show();
    QVERIFY(QTest::qWaitForWindowExposed(&page));
    ScopePane* pane = page.view()->panes()[0];
    const std::unique_ptr<QPointingDevice> touch(QTest::createTouchDevice());
    const TimeWindow& time = *page.timeWindow();
    const double fromS = time.fromS();
    const double spanS = time.toS() - fromS;
    const QPoint middle = pane->rect().center();
    const auto apart = [&middle](int px) {
      return std::pair(middle - QPoint(px, 0), middle + QPoint(px, 0));
    };
    const auto [left, right] = apart(40);
    QTest::touchEvent(pane, touch.get()).press(0, left, pane).press(1, right, pane);
    for (int px = 50; px <= 100; px += 10) {
      const auto [a, b] = apart(px);
      QTest::touchEvent(pane, touch.get()).move(0, a, pane).move(1, b, pane);
    }
    const auto [a, b] = apart(100);
    QTest::touchEvent(pane, touch.get()).release(0, a, pane).release(1, b, pane);
    const double share = (time.toS() - time.fromS()) / spanS;
    QVERIFY2(share > 0.35 && share < 0.6, qPrintable(QString::number(share)));
    QVERIFY(time.fromS() > fromS && time.toS() < fromS + spanS);
    // Two fingers are neither a click nor a drag.
    QVERIFY(!page.findChild<ScopeCursors*>()->atS(ScopeCursors::A));
  }

  /// Four panes beside the list do not make the window scroll at 1024 x 768.
  void fitsALowWindow() {
    test::Language language;
    TracePage page;
    page.showTraces({test::shownTrace(*test::controlTrace(0.9))}, TracePage::Source::Files);
    static_cast<void>(test::picture(page, {780, 560}));
    QCOMPARE(page.view()->panes().size(), std::size_t{4});
    const int height = page.layout()->hasHeightForWidth() ? page.layout()->heightForWidth(780)
                                                          : page.minimumSizeHint().height();
    QVERIFY2(height <= 560, qPrintable(QString::number(height)));
  }

  void signalsAreFoundAndShown() {
    test::Language language;
    TracePage page;
    page.showTraces({test::shownTrace(*test::controlTrace(0.9))}, TracePage::Source::Files);
    static_cast<void>(test::picture(page, {1000, 640}));
    page.findChild<QTabWidget*>("tracePanel")->setCurrentIndex(1);
    auto* search = page.findChild<QLineEdit*>("signalSearch");
    auto* tree = page.findChild<QTreeWidget*>("signalTree");
    QTest::keyClicks(search, "jerk");
    QTreeWidgetItem* jerk = nullptr;
    for (QTreeWidgetItemIterator it(tree); *it != nullptr; ++it) {
      const bool isVisible = !(*it)->isHidden() && (*it)->parent() != nullptr;
      if (isVisible && jerk == nullptr) {
        jerk = *it;
      }
      QVERIFY(!isVisible || (*it)->text(0).contains("jerk"));
    }
    QVERIFY(jerk != nullptr);
    const std::size_t panes = page.view()->panes().size();
    tree->setCurrentItem(jerk);
    QTest::keyClick(tree, Qt::Key_Return);
    QCOMPARE(page.view()->panes().size(), panes + 1);
    QVERIFY(page.view()->shows("d(d(d(x_act)))"));
    QVERIFY(jerk->font(0).bold());
    search->clear();
    // Into the same pane, and out again.
    tree->setCurrentItem(jerk->parent()->child(1));
    QTest::keyClick(tree, Qt::Key_Return, Qt::ShiftModifier);
    QCOMPARE(page.view()->panes().size(), panes + 1);
    QVERIFY(page.view()->shows("d(d(d(y_act)))"));
    QTest::mouseClick(page.findChild<QPushButton*>("signalRemove"), Qt::LeftButton);
    QVERIFY(!page.view()->shows("d(d(d(y_act)))"));
    tree->setCurrentItem(jerk);
    QTest::keyClick(tree, Qt::Key_Delete);
    QCOMPARE(page.view()->panes().size(), panes);
    const QRect place = tree->visualItemRect(jerk);
    QVERIFY(place.height() >= kTouchHeightPx);
    QTest::mouseClick(tree->viewport(), Qt::LeftButton, {}, place.center());
    QTest::mouseDClick(tree->viewport(), Qt::LeftButton, {}, place.center());
    QCOMPARE(page.view()->panes().size(), panes + 1);
    QTest::keyClick(page.view()->panes().back(), Qt::Key_Delete);
    QCOMPARE(page.view()->panes().size(), panes);
  }

  void signalsAreDropped() {
    TracePage page;
    page.showTraces({test::shownTrace(*test::controlTrace(0.9))}, TracePage::Source::Files);
    static_cast<void>(test::picture(page, {1000, 640}));
    ScopePane* pane = page.view()->panes()[1];
    QMimeData dragged;
    dragged.setData(ScopePane::mimeType(), "x_set - x_act");
    drop(pane, dragged);
    QCOMPARE(pane->formulas(), QStringList({"y_act", "x_set - x_act"}));
  }

  void filesAreDropped() {
    TracePage page;
    QSignalSpy opened(&page, &TracePage::openRequested);
    QMimeData dragged;
    dragged.setUrls({QUrl::fromLocalFile("/data/a.rivulet"), QUrl::fromLocalFile("/data/b.CSV"),
                     QUrl::fromLocalFile("/data/c.h5"), QUrl::fromLocalFile("/data/part.mpf")});
    drop(&page, dragged);
    QCOMPARE(opened.size(), 1);
    QCOMPARE(opened[0][0].toStringList(),
             QStringList({"/data/a.rivulet", "/data/b.CSV", "/data/c.h5"}));
  }

  void formulasAreShownOrRefused() {
    test::Language language;
    TracePage page;
    page.showTraces({test::shownTrace(*test::controlTrace(0.9))}, TracePage::Source::Files);
    static_cast<void>(test::picture(page, {1000, 640}));
    page.findChild<QTabWidget*>("tracePanel")->setCurrentIndex(1);
    auto* formula = page.findChild<QLineEdit*>("signalFormula");
    auto* problem = page.findChild<QLabel*>("signalFormulaNote");
    QTest::keyClicks(formula, "hypot(x_act, y_act)");
    QTest::keyClick(formula, Qt::Key_Return);
    QVERIFY(page.view()->shows("hypot(x_act, y_act)"));
    QVERIFY(problem->isHidden());
    formula->setText("hypot(x_act");
    QTest::keyClick(formula, Qt::Key_Return);
    QVERIFY(problem->text().contains("not complete"));
    formula->setText("w_act * 2");
    QTest::keyClick(formula, Qt::Key_Return);
    page.redrawNow();
    QVERIFY2(problem->text().contains("w_act"), qPrintable(problem->text()));
    language.german();
    QCoreApplication::processEvents();
    QVERIFY2(problem->text().contains("kein solches Signal"), qPrintable(problem->text()));
  }

  /// Nobody has asked for the length along a program that is not there.
  void aTraceWithoutItsProgramIsNoMistake() {
    TracePage page;
    page.showTraces({test::shownTrace(*test::controlTrace(0.9))}, TracePage::Source::Files);
    auto* panel = page.findChild<QTabWidget*>("tracePanel");
    for (int tab = 0; tab < panel->count(); ++tab) {
      panel->setCurrentIndex(tab);
      static_cast<void>(test::picture(page, {1000, 640}));
      page.redrawNow();
    }
    QVERIFY(page.findChild<QLabel*>("signalFormulaNote")->isHidden());
  }

  /// While the set point stands, the axes still close up. What is enlarged is how far they are off
  /// the path, not where on it they are.
  void anEnlargedErrorHasNoSpurs() {
    const auto program = test::programFrom("LINE.MPF", "G17 G90\nG1 X10 Y0 Z0 F600\nM30\n");
    trace::ControlTrace motion;
    motion.cycle = std::chrono::milliseconds{4};
    double setMm = 0.0;
    double actualMm = 0.0;
    for (int i = 0; i < 320; ++i) {
      const bool stands = i >= 120 && i < 190;
      setMm = std::min(10.0, setMm + (stands ? 0.0 : 0.04));
      actualMm += 0.08 * (setMm - actualMm);
      trace::ControlSample sample;
      sample.at = base::Instant{std::chrono::milliseconds{4 * i}};
      sample.commandMm = {setMm, 0.0, 0.0};
      sample.actualMm = {actualMm, 0.01, 0.0};
      sample.feedMmPerS = stands ? 0.0 : 10.0;
      motion.samples.push_back(sample);
    }
    TracePage page;
    page.showTraces({test::shownTrace(motion, "a", program.get())}, TracePage::Source::Files);
    page.findChild<QTabWidget*>("tracePanel")->setCurrentIndex(3);
    auto* path = page.findChild<PathPane*>("scopePath");
    path->setEnlargement(100.0);
    static_cast<void>(test::picture(page, {1000, 760}));
    int seen = 0;
    for (int i = 40; i < 240; ++i) {  // at first the axes are before the path
      const auto shown = path->shownMm(0.004 * i);
      QVERIFY(shown);
      const base::Vec3 expected{motion.samples[static_cast<std::size_t>(i)].actualMm.x, 1.0, 0.0};
      QVERIFY2(base::distance(*shown, expected) < 1e-4,
               qPrintable(QStringLiteral("sample %1: %2 %3")
                              .arg(i)
                              .arg(shown->x - expected.x)
                              .arg(shown->y - expected.y)));
      ++seen;
    }
    QCOMPARE(seen, 200);
  }

  void aTriggerFreezesTheLiveView() {
    test::Language language;
    TracePage page;
    page.findChild<QTabWidget*>("tracePanel")->setCurrentIndex(6);
    static_cast<void>(test::picture(page, {1000, 700}));
    auto* arm = page.findChild<QPushButton*>("triggerArm");
    auto* state = page.findChild<StatusLabel*>("triggerState");
    auto* cursors = page.findChild<ScopeCursors*>();
    auto* condition = page.findChild<QComboBox*>("triggerCondition");
    page.findChild<NumberField*>("triggerLevel")->setValue(5.0);
    page.findChild<NumberField*>("triggerBefore")->setValue(1.0);
    page.findChild<NumberField*>("triggerAfter")->setValue(2.0);
    // x rises by 1 mm/s from 0.
    double atS = 0.0;
    const auto runUntil = [&](double endS) {
      for (; atS < endS - 1e-9; atS += 0.1) {
        page.append({atS, base::Vec3{atS, 0.0, 0.0}, 8.0});
      }
    };
    QTest::mouseClick(arm, Qt::LeftButton);
    QVERIFY(arm->isChecked());
    runUntil(6.0);
    QVERIFY(page.timeWindow()->isLive());  // the time after the trigger is still to come
    QVERIFY2(state->text().startsWith("Triggered: waiting"), qPrintable(state->text()));
    runUntil(9.0);
    QVERIFY(!page.timeWindow()->isLive());
    QVERIFY(std::abs(page.timeWindow()->fromS() - 4.0) < 1e-6);
    QVERIFY(std::abs(page.timeWindow()->toS() - 7.0) < 1e-6);
    QVERIFY(std::abs(*cursors->atS(ScopeCursors::A) - 5.0) < 1e-6);
    QVERIFY2(state->text().contains("5.000"), qPrintable(state->text()));
    QVERIFY(!arm->isChecked());
    language.german();
    applyTheme(Theme::Contrast);
    test::keep(test::picture(page, {1024, 700}), "trace-trigger");
    QCOMPARE(test::cutTexts(page), QStringList());
    language.english();
    applyTheme(Theme::Light);
    // An event, noticed late; every time.
    page.findChild<QPushButton*>("traceLive")->click();
    condition->setCurrentIndex(6);
    QVERIFY(!page.findChild<NumberField*>("triggerLevel")->isVisible());
    page.findChild<QComboBox*>("triggerMode")->setCurrentIndex(1);
    QTest::mouseClick(arm, Qt::LeftButton);
    page.addPause({base::Instant{std::chrono::milliseconds{6000}}, std::chrono::milliseconds{200}});
    QVERIFY(std::abs(page.timeWindow()->fromS() - 5.0) < 1e-6);
    QVERIFY(arm->isChecked());
    runUntil(14.0);
    page.addPause(
        {base::Instant{std::chrono::milliseconds{13000}}, std::chrono::milliseconds{200}});
    QVERIFY(std::abs(page.timeWindow()->fromS() - 5.0) < 1e-6);  // not complete
    page.finishLive();
    QVERIFY(std::abs(page.timeWindow()->fromS() - 12.0) < 1e-6);
    // The next run begins at 0 again, and the trigger is still armed.
    page.clear();
    QVERIFY(arm->isChecked());
    atS = 0.0;
    runUntil(1.0);
    page.noticeAlarm();  // another event
    QVERIFY2(state->text().startsWith("Waiting"), qPrintable(state->text()));
    QTest::mouseClick(arm, Qt::LeftButton);
    QCOMPARE(state->text(), QString("Not armed"));
    condition->setCurrentIndex(7);
    QTest::mouseClick(arm, Qt::LeftButton);
    page.noticeAlarm();
    runUntil(4.0);
    QVERIFY(std::abs(*cursors->atS(ScopeCursors::A) - 0.9) < 1e-6);
  }

  void severalTracesShareTheirTime() {
    TracePage page;
    page.showTraces({test::shownTrace(*test::controlTrace(0.9), "first.csv"),
                     test::shownTrace(*test::controlTrace(1.3), "second.csv")},
                    TracePage::Source::Files);
    static_cast<void>(test::picture(page, {1000, 640}));
    QVERIFY(note(page).contains("first.csv, second.csv"));
    auto* table = page.findChild<QTableWidget*>("cursorTable");
    QVERIFY(test::settle(page));
    QCOMPARE(table->columnCount(), 8);
    QVERIFY(table->horizontalHeaderItem(1)->text().contains("second.csv"));
  }

  /// By path, the slower of two equal runs differs in its speed alone; a row leads to its place.
  void runsAreCompared() {
    test::Language language;
    TracePage page;
    page.showTraces({test::shownTrace(*test::controlTrace(0.9), "first.csv"),
                     test::shownTrace(*test::controlTrace(1.3), "second.csv")},
                    TracePage::Source::Files);
    page.findChild<QTabWidget*>("tracePanel")->setCurrentIndex(4);
    static_cast<void>(test::picture(page, {1000, 640}));
    auto* axis = page.findChild<QComboBox*>("compareAxis");
    auto* table = page.findChild<QTableWidget*>("compareTable");
    auto* curves = page.findChild<ScopeCurves*>();
    axis->setCurrentIndex(2);
    Q_EMIT axis->activated(2);
    QVERIFY(page.findChild<QLabel*>("compareNote")->text().contains("NC program"));
    QCOMPARE(axis->currentIndex(), 0);
    Q_EMIT axis->activated(1);
    page.redrawNow();
    QVERIFY(curves->axis() == trace::RunAxis::Path);
    QCOMPARE(page.timeWindow()->toS(), curves->axisEnd());
    QVERIFY(table->rowCount() > 4);
    int speed = 0;
    while (speed < table->rowCount() && !table->item(speed, 0)->text().startsWith("Path speed")) {
      ++speed;
    }
    QVERIFY(speed < table->rowCount());
    Q_EMIT table->cellClicked(speed, 0);
    page.redrawNow();
    auto* cursors = page.findChild<ScopeCursors*>();
    QVERIFY(cursors->atS(ScopeCursors::A));
    page.findChild<QAbstractButton*>("compareDifferences")->setChecked(true);
    const auto shown = curves->curves("per_min(path_speed)");
    QCOMPARE(shown.size(), std::size_t{1});
    QVERIFY(shown.front().title.contains(QString::fromUtf8("second.csv − first.csv")));
    QVERIFY(shown.front().samples);
    // What the table says is what the curve shows; where a run stands, it has several values.
    const double place = *cursors->atS(ScopeCursors::A);
    const auto range =
        shown.front().samples->range(instantOf(place - 1e-6), instantOf(place + 1e-6));
    QVERIFY(range);
    const double largest = QLocale().toDouble(table->item(speed, 1)->text());
    const double there = largest > 0.0 ? range->max : range->min;
    QVERIFY(std::abs(there - largest) < 1e-3 * std::abs(largest));
    // Other files begin with time.
    page.showTraces({test::shownTrace(*test::controlTrace(0.9), "third.csv")},
                    TracePage::Source::Files);
    QVERIFY(curves->axis() == trace::RunAxis::Time);
    QVERIFY(!axis->isEnabled());
  }

  /// A vibration of 12.5 Hz is named, and only between the cursors.
  void showsASpectrum() {
    test::Language language;
    trace::ControlTrace trace;
    trace.cycle = std::chrono::milliseconds{4};
    for (int i = 0; i < 5000; ++i) {
      trace::ControlSample sample;
      const double seconds = 0.004 * i;
      sample.at = instantOf(seconds);
      sample.commandMm.x = seconds;
      sample.actualMm.x =
          seconds + (i > 2500 ? 0.01 * std::sin(2.0 * std::acos(-1.0) * 12.5 * seconds) : 0.0);
      trace.samples.push_back(sample);
    }
    TracePage page;
    page.showTraces({test::shownTrace(trace, "a.csv")}, TracePage::Source::Files);
    page.findChild<QTabWidget*>("tracePanel")->setCurrentIndex(5);
    static_cast<void>(test::picture(page, {1280, 800}));
    page.view()->setArrangement({{"x_act"}});
    auto* cursors = page.findChild<ScopeCursors*>();
    cursors->set(ScopeCursors::A, 12.0);
    cursors->set(ScopeCursors::B, 18.0);
    page.redrawNow();
    auto* table = page.findChild<QTableWidget*>("spectrumTable");
    QCOMPARE(table->rowCount(), 1);
    QVERIFY(std::abs(QLocale().toDouble(table->item(0, 0)->text()) - 12.5) < 0.02);
    QVERIFY(std::abs(QLocale().toDouble(table->item(0, 1)->text()) - 10.0) < 0.2);
    QVERIFY(table->horizontalHeaderItem(1)->text().contains(QString::fromUtf8("µm")));
    auto* said = page.findChild<QLabel*>("spectrumNote");
    QVERIFY2(said->text().startsWith("Between the cursors"), qPrintable(said->text()));
    cursors->set(ScopeCursors::B, 12.01);
    page.redrawNow();
    QVERIFY2(said->text().contains("16 samples"), qPrintable(said->text()));
    QCOMPARE(table->rowCount(), 0);
  }

  void layoutsAreKeptAndShown() {
    test::Language language;
    TracePage page;
    const auto trace = test::shownTrace(*test::controlTrace(0.9), "a.csv");
    page.showTraces({trace}, TracePage::Source::Files);
    static_cast<void>(test::picture(page, {1280, 800}));
    QSignalSpy changes(&page, &TracePage::layoutsChanged);
    page.view()->setArrangement({{"x_act", "x_set"}, {"x_set - x_act"}});
    page.view()->setHeights({300, 100});
    page.keepLayout("lag");
    page.view()->setArrangement({{"y_act"}});
    page.keepLayout("Y only");
    QCOMPARE(changes.count(), 2);
    QCOMPARE(page.layouts().list.size(), std::size_t{2});
    page.showLayout("lag");
    QCOMPARE(page.view()->arrangement(),
             (std::vector<QStringList>{{"x_act", "x_set"}, {"x_set - x_act"}}));
    QVERIFY(page.view()->heights()[0] > 2 * page.view()->heights()[1]);
    // One of the same name is replaced; the menu offers what there is.
    page.view()->setArrangement({{"y_act"}});
    page.keepLayout("Y only");
    QCOMPARE(page.layouts().list.size(), std::size_t{2});
    auto* menu = page.findChild<LayoutMenu*>();
    Q_EMIT menu->aboutToShow();
    QCOMPARE(menu->actions().first()->text(), QString("lag"));
    Q_EMIT menu->standardRequested("Y only");
    page.showTraces({test::shownTrace(*test::controlTrace(1.3), "b.csv")},
                    TracePage::Source::Files);
    QCOMPARE(page.view()->arrangement(), (std::vector<QStringList>{{"y_act"}}));
    Q_EMIT menu->deleteRequested("Y only");
    QVERIFY(page.layouts().standard.isEmpty());
    QCOMPARE(page.layouts().list.size(), std::size_t{1});
    // A layout of signals that the next file does not have is not taken.
    ScopeLayouts layouts = page.layouts();
    layouts.keep({"other", {{"spindle"}}, {}});
    layouts.standard = "other";
    page.setLayouts(layouts);
    QCOMPARE(page.view()->arrangement(), (std::vector<QStringList>{{"y_act"}}));
  }

  void whatIsShownIsSaved() {
    test::Language language;
    QTemporaryDir folder;
    TracePage page;
    page.showTraces({test::shownTrace(*test::controlTrace(0.9), "a.csv")},
                    TracePage::Source::Files);
    static_cast<void>(test::picture(page, {1280, 800}));
    page.view()->setArrangement({{"x_act", "x_set - x_act"}, {"write_ms"}});
    page.timeWindow()->showRange(1.0, 2.0);
    page.save(folder.filePath("part.csv"));
    QVERIFY2(note(page).startsWith("Saved: part.csv"), qPrintable(note(page)));
    const auto text = base::readFile(folder.filePath("part.csv").toStdString());
    QVERIFY(text);
    const auto imported = trace::importTrace(*text);
    QVERIFY(imported);
    QCOMPARE(imported->trace.signalList.size(), std::size_t{2});
    QCOMPARE(imported->trace.timeBases.front().at.front(), base::Instant{std::chrono::seconds{1}});
    page.save(folder.filePath("part.h5"));
    if (trace::hasHdf5()) {
      QVERIFY2(note(page).startsWith("Saved: part.h5"), qPrintable(note(page)));
      const auto bytes = base::readFile(folder.filePath("part.h5").toStdString());
      const auto read = trace::importTrace(*bytes);
      QVERIFY(read);
      QCOMPARE(read->trace.format, std::string("HDF5"));
      QCOMPARE(read->trace.signalList.size(), std::size_t{2});
      QVERIFY(std::ranges::equal(read->trace.signalList[0].values,
                                 imported->trace.signalList[0].values));
      // The stop that is seen, and no other.
      QCOMPARE(read->trace.events.size(), std::size_t{1});
      QCOMPARE(read->trace.events[0].kind, std::string("stop"));
    } else {
      QVERIFY2(note(page).contains("built without HDF5"), qPrintable(note(page)));
    }
    for (const char* name : {"panes.png", "panes.svg", "panes.pdf"}) {
      page.save(folder.filePath(name));
      QVERIFY2(note(page).contains(name), qPrintable(note(page)));
      QVERIFY(QFileInfo(folder.filePath(name)).size() > 2000);
    }
    const auto svg = base::readFile(folder.filePath("panes.svg").toStdString());
    QVERIFY(svg && svg->find("<polyline") != std::string::npos);
    page.save(folder.filePath("missing/part.csv"));
    QVERIFY2(note(page).contains("cannot be written"), qPrintable(note(page)));
    page.save(folder.filePath("missing/part.pdf"));
    QVERIFY2(note(page).contains("cannot be written"), qPrintable(note(page)));
  }

  void analysisFollowsWithoutMovingTheView() {
    TracePage page;
    const auto trace = test::controlTrace(0.9);
    auto early = trace::makeShownTrace(trace::Trace(trace));
    early.name = "a";
    page.showTraces({std::make_shared<const trace::ShownTrace>(std::move(early))},
                    TracePage::Source::Files);
    static_cast<void>(test::picture(page, {1000, 640}));
    QVERIFY(note(page).contains("Looking for stops"));
    page.timeWindow()->showRange(3.0, 5.0);
    page.view()->addPane("d(x_act)");
    page.showTraces({test::shownTrace(*trace, "a")}, TracePage::Source::Files);
    QCOMPARE(page.timeWindow()->fromS(), 3.0);
    QVERIFY(page.view()->shows("d(x_act)"));
    QVERIFY(!note(page).contains("Looking for stops"));
  }

  void liveButtonTellsWhetherItIsLive() {
    TracePage page;
    for (int index = 0; index < 1000; ++index) {
      page.append({index * 0.1, base::Vec3{}, 8.0});
    }
    auto* live = page.findChild<QPushButton*>("traceLive");
    QVERIFY(live->isChecked());
    auto* all = page.findChild<QPushButton*>("traceAll");
    all->click();
    QVERIFY(!live->isChecked());
    live->click();
    QVERIFY(live->isChecked());
    live->click();
    QVERIFY(live->isChecked());
  }
};

RIVULET_TEST(TestTracePage)
#include "tst_trace_page.moc"
