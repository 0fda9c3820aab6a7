// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QApplication>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QToolButton>
#include <QWheelEvent>
#include <cmath>

#include "gui/widgets/page_test.h"
#include "gui/widgets/samples.h"
#include "support/test_program.h"
#include "widgets/program/file_bars.h"
#include "widgets/program/path_canvas.h"
#include "widgets/program/path_view.h"
#include "widgets/program/program_page.h"
#include "widgets/program/program_panel.h"
#include "widgets/program/program_text_view.h"
#include "widgets/program/text_pane.h"

using namespace rivulet;
using namespace rivulet::widgets;

namespace {

std::shared_ptr<const overview::ProgramView> textOnly(std::string text) {
  auto program = std::make_shared<gcode::Program>();
  program->text = std::move(text);
  return test::viewOf(program);
}

}  // namespace

class TestProgramPage : public QObject {
  Q_OBJECT

 private slots:
  void init() { test::failOnWarnings(); }

  void textIsReadAsWhatItIs() {
    ProgramTextView view;
    view.setProgram(
        textOnly("(gr\xC3\xB6\xC3\x9F"
                 "er)\r\nX1\tY2\r\n"));
    QCOMPARE(view.lineText(1), QString::fromUtf8("(gr\xC3\xB6\xC3\x9F"
                                                 "er)"));
    QCOMPARE(view.lineText(2), QString("X1      Y2"));
    view.setProgram(
        textOnly("(gr\xF6\xDF"
                 "er)\nX1\n"));
    QCOMPARE(view.lineText(1), QString::fromUtf8("(gr\xC3\xB6\xC3\x9F"
                                                 "er)"));
    // One endless line is shown as far as it goes.
    view.setProgram(textOnly(std::string(100'000, 'X')));
    QVERIFY(view.lineText(1).size() < 5000);
    QVERIFY(view.lineText(1).endsWith(QChar(0x2026)));
    QVERIFY(test::colourCount(test::picture(view, {300, 200})) > 2);
  }

  /// Three fifths, unless the text would be too narrow for its buttons.
  void thePathHasMostOfTheRoom() {
    ProgramPage page;
    page.setProgram(textOnly("X1\n"));
    for (const int width : {1000, 1700}) {
      QVERIFY(test::picture(page, {width, 800}).width() > 0);
      const double share = static_cast<double>(page.path()->width()) / width;
      QVERIFY2(std::abs(share - 0.6) < 0.02, qPrintable(QString::number(share)));
    }
  }

  /// A million lines: no more of them are painted than there is room for.
  void onlyLinesInSightArePainted() {
    std::string text;
    for (int line = 0; line < 1'000'000; ++line) {
      text += "N" + std::to_string(line + 1) + " X1 Y2\n";
    }
    const auto program = textOnly(std::move(text));
    ProgramTextView view;
    view.setProgram(program);
    static_cast<void>(test::picture(view, {400, 300}));
    const std::size_t room = view.paintedLines();
    QVERIFY(room > 5 && room < 60);
    QElapsedTimer clock;
    double slowestMs = 0.0;
    for (const std::size_t line : {1U, 500'000U, 1'000'000U, 123'456U}) {
      view.setCurrentLine(line);
      QCOMPARE(view.currentLine(), line);
      QVERIFY(view.firstVisibleLine() <= line && line < view.firstVisibleLine() + room);
      clock.start();
      static_cast<void>(view.grab());
      slowestMs = std::max(slowestMs, static_cast<double>(clock.nsecsElapsed()) * 1e-6);
      QVERIFY(view.paintedLines() <= room);
    }
    qInfo("1,000,000 lines: the slowest frame took %.1f ms", slowestMs);
    // A line in sight stays in sight when the view changes its height.
    for (const int height : {120, 60, 400}) {
      static_cast<void>(test::picture(view, {400, height}));
      QVERIFY(view.firstVisibleLine() <= 123'456U);
      QVERIFY(123'456U < view.firstVisibleLine() + view.paintedLines());
    }
    view.setCurrentLine(1'000'001);
    QCOMPARE(view.currentLine(), std::size_t{123'456});
  }

  /// Who executes a line is seen at its edge, and said when one points at it.
  void aJobIsSeenInTheText() {
    ProgramPage page;
    page.setProgram(test::jobView());
    static_cast<void>(test::picture(page, {900, 640}));
    const ProgramTextView* text = page.text();
    QVERIFY(text->hintOf(3).contains(QStringLiteral("tool or tool length")));
    QVERIFY(text->hintOf(3).contains(QStringLiteral("read from the control")));
    QVERIFY(text->hintOf(10).contains(QStringLiteral("coolant")));
    QVERIFY(text->hintOf(11).contains(QStringLiteral("Part 2 of 3")));
    QVERIFY(text->hintOf(12).isEmpty());
    auto* pane = page.findChild<TextPane*>();
    QVERIFY(pane->nextPart()->isVisibleTo(pane));
    page.showLine(1);
    QTest::mouseClick(pane->nextPart(), Qt::LeftButton);
    QCOMPARE(text->currentLine(), std::size_t{3});
    QTest::keyClick(pane, Qt::Key_PageDown, Qt::ControlModifier);
    QTest::mouseClick(pane->nextPart(), Qt::LeftButton);
    QTest::mouseClick(pane->previousPart(), Qt::LeftButton);
    QVERIFY(text->currentLine() < 10);
    // A program that was not split has no parts to jump to.
    page.setProgram(test::viewOf(test::pocket()));
    QVERIFY(!pane->nextPart()->isVisibleTo(pane));
    QVERIFY(text->hintOf(10).isEmpty());
  }

  /// A line chosen before the view has its size is in sight when it has.
  void aLineChosenEarlyIsInSight() {
    ProgramPage page;
    page.setProgram(test::viewOf(test::pocket()));
    page.showLine(700);
    static_cast<void>(test::picture(page, {760, 640}));
    const std::size_t first = page.text()->firstVisibleLine();
    QVERIFY2(first <= 700 && 700 < first + page.text()->paintedLines(),
             qPrintable(QString::number(first)));
  }

  void keysAndClicksChooseLines() {
    ProgramTextView view;
    view.setProgram(textOnly("a\nb\nc\nd\n"));
    static_cast<void>(test::picture(view, {300, 200}));
    QSignalSpy chosen(&view, &ProgramTextView::lineChosen);
    const auto last = [&] { return chosen.last().first().value<std::size_t>(); };
    QTest::keyClick(&view, Qt::Key_Down);
    QCOMPARE(last(), std::size_t{1});
    QTest::keyClick(&view, Qt::Key_Down);
    QCOMPARE(last(), std::size_t{2});
    QTest::keyClick(&view, Qt::Key_End);
    QCOMPARE(last(), std::size_t{4});
    QTest::keyClick(&view, Qt::Key_Down);
    QCOMPARE(last(), std::size_t{4});
    QTest::keyClick(&view, Qt::Key_PageUp);
    QCOMPARE(last(), std::size_t{1});
    QTest::mouseClick(view.viewport(), Qt::LeftButton, {}, {150, 30});
    QCOMPARE(last(), std::size_t{2});
    // Below the text there is nothing to choose.
    const auto count = chosen.count();
    QTest::mouseClick(view.viewport(), Qt::LeftButton, {}, {150, 180});
    QCOMPARE(chosen.count(), count);
    view.setProgram(nullptr);
    QTest::keyClick(&view, Qt::Key_Down);
    QCOMPARE(chosen.count(), count);
  }

  /// A million lines are searched in slices; the first line found is shown at once.
  void searchFindsLinesWithoutHoldingUpTheWindow() {
    std::string text;
    for (int line = 0; line < 1'000'000; ++line) {
      text += line % 250'000 == 249'999 ? "G1 Z-5 ; Here\n" : "G1 X1 Y2\n";
    }
    ProgramPage page;
    page.setProgram(textOnly(std::move(text)));
    page.resize(900, 700);
    page.show();
    TextPane* pane = page.textPane();
    page.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&page));
    QTest::keyClick(&page, Qt::Key_F, Qt::ControlModifier);
    QTRY_COMPARE(QApplication::focusWidget(), pane->search());
    QElapsedTimer clock;
    clock.start();
    pane->search()->setText(QStringLiteral("here"));
    const double typedMs = static_cast<double>(clock.nsecsElapsed()) * 1e-6;
    QTRY_COMPARE(page.text()->currentLine(), std::size_t{250'000});
    QTRY_VERIFY(test::visibleText(*pane).split(QLatin1Char('\n')).contains(QStringLiteral("4")));
    qInfo("typing took %.2f ms", typedMs);
    QTest::keyClick(pane->search(), Qt::Key_Return);
    QCOMPARE(page.text()->currentLine(), std::size_t{500'000});
    for (int i = 0; i < 3; ++i) {
      QTest::keyClick(pane->search(), Qt::Key_Return);
    }
    QCOMPARE(page.text()->currentLine(), std::size_t{250'000});  // around the end
    pane->search()->setText(QStringLiteral("nowhere"));
    QTRY_VERIFY(test::visibleText(*pane).split(QLatin1Char('\n')).contains(QStringLiteral("0")));
    QCOMPARE(page.text()->currentLine(), std::size_t{250'000});
    QTest::keyClick(&page, Qt::Key_G, Qt::ControlModifier);
    QTRY_COMPARE(QApplication::focusWidget(), pane->lineField());
    QTest::keyClicks(pane->lineField(), QStringLiteral("777777"));
    QTest::keyClick(pane->lineField(), Qt::Key_Return);
    QCOMPARE(page.text()->currentLine(), std::size_t{777'777});
  }

  void textFollowsTheRunUntilTheOperatorLooksElsewhere() {
    const auto view = test::viewOf(test::pocket());
    ProgramPage page;
    page.setProgram(view);
    static_cast<void>(test::picture(page, {900, 700}));
    const auto inSight = [&page](std::size_t line) {
      const std::size_t first = page.text()->firstVisibleLine();
      return first <= line && line < first + page.text()->paintedLines();
    };
    const auto lineOf = [&view](std::size_t executed) {
      return std::size_t{view->points.points[executed - 1].line.value};
    };
    page.followRun();
    page.setExecuted(600);
    static_cast<void>(test::picture(page, {900, 700}));
    QVERIFY(inSight(lineOf(600)));
    QVERIFY(page.textPane()->follow()->isChecked());
    // The wheel looks elsewhere: the run does not pull the text back.
    QWheelEvent wheel(QPointF(20, 20), page.text()->viewport()->mapToGlobal(QPointF(20, 20)), {},
                      {0, 12000}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(page.text()->viewport(), &wheel);
    QVERIFY(!page.textPane()->follow()->isChecked());
    page.setExecuted(1200);
    static_cast<void>(test::picture(page, {900, 700}));
    QVERIFY(!inSight(lineOf(1200)));
    page.textPane()->follow()->setChecked(true);
    static_cast<void>(test::picture(page, {900, 700}));
    QVERIFY(inSight(lineOf(1200)));
  }

  void halvesStackWhereItIsNarrow() {
    ProgramPage page;
    page.setProgram(test::viewOf(test::pocket()));
    // A splitter shares its width only when it is shown.
    page.resize(1000, 700);
    page.show();
    const auto place = [&page](QWidget* widget) {
      return QRect(widget->mapTo(&page, QPoint()), widget->size());
    };
    QTRY_VERIFY(place(page.panel()).left() >= place(page.path()).right());
    page.resize(500, 900);
    QTRY_VERIFY(place(page.panel()).top() >= place(page.path()).bottom());
  }

  void findingsAreMarked() {
    const auto broken = test::viewOf(test::brokenProgram());
    auto clean = std::make_shared<gcode::Program>(*test::brokenProgram());
    clean->diagnostics.clear();
    ProgramTextView marked;
    marked.setProgram(broken);
    ProgramTextView plain;
    plain.setProgram(test::viewOf(clean));
    QVERIFY(test::picture(marked, {300, 200}) != test::picture(plain, {300, 200}));
  }

  /// Path, text and findings show the same place, whichever was touched.
  void placesAreLinkedBothWays() {
    const auto view = test::viewOf(test::pocket());
    ProgramPage page;
    page.setProgram(view);
    static_cast<void>(test::picture(page, {900, 700}));
    // Text to path.
    const std::size_t point = 400;
    const std::size_t line = view->points.points[point].line.value;
    page.text()->setCurrentLine(1);
    Q_EMIT page.text()->lineChosen(line);
    QCOMPARE(page.text()->currentLine(), line);
    QCOMPARE(page.path()->slider()->value(), static_cast<int>(point));
    // Slider to text.
    page.path()->slider()->setValue(500);
    QCOMPARE(page.text()->currentLine(), std::size_t{view->points.points[500].line.value});
    // Path to text.
    PathCanvas* canvas = page.path()->canvas();
    QTest::mouseClick(canvas, Qt::LeftButton, {}, canvas->placeOf(point).toPoint());
    const auto clicked = static_cast<std::size_t>(page.path()->slider()->value());
    QVERIFY(QLineF(canvas->placeOf(clicked), canvas->placeOf(point)).length() < 14.0);
    QCOMPARE(page.text()->currentLine(), std::size_t{view->points.points[clicked].line.value});
    // A line without a move is shown in the text; the path stays where it is.
    Q_EMIT page.panel()->lineChosen(2);
    QCOMPARE(page.text()->currentLine(), std::size_t{2});
    QCOMPARE(page.path()->slider()->value(), static_cast<int>(clicked));
    page.setProgram(nullptr);
    Q_EMIT page.panel()->lineChosen(2);
    QCOMPARE(page.text()->currentLine(), std::size_t{0});
  }

  void theBannerSaysWhatARunKeeps() {
    test::Language language;
    FileBanner banner;
    banner.setProgram("A.MPF", "0123456789abcdef");
    QVERIFY(!banner.isVisibleTo(nullptr));
    banner.setState(FileBanner::State::Changed);
    QVERIFY(test::visibleText(banner).contains("Reload it?"));
    QSignalSpy reload(&banner, &FileBanner::reloadRequested);
    auto* button = banner.findChild<QPushButton*>();
    QTest::mouseClick(button, Qt::LeftButton);
    QCOMPARE(reload.count(), 1);
    banner.setRunning(true);
    QVERIFY(test::visibleText(banner).contains("The run keeps version 0123456789abcdef."));
    QVERIFY(!button->isVisibleTo(&banner));
    banner.setRunning(false);
    banner.setState(FileBanner::State::Gone);
    QVERIFY(test::visibleText(banner).contains("no longer there"));
    QVERIFY(!button->isVisibleTo(&banner));
    banner.setState(FileBanner::State::Same);
    QVERIFY(banner.isHidden());
  }

  void readingCanBeCancelled() {
    LoadBar bar;
    QVERIFY(bar.isHidden());
    bar.setProgress(0.25, "A.MPF");
    QVERIFY(bar.isHidden());  // it may be there in a moment
    QTRY_VERIFY(!bar.isHidden());
    QVERIFY(test::visibleText(bar).contains("A.MPF"));
    QSignalSpy cancel(&bar, &LoadBar::cancelRequested);
    QTest::mouseClick(bar.findChild<QPushButton*>(), Qt::LeftButton);
    QCOMPARE(cancel.count(), 1);
    bar.setProgress(std::nullopt);
    QVERIFY(bar.isHidden());
    // What was read within a moment never showed.
    bar.setProgress(0.5, "B.MPF");
    bar.setProgress(std::nullopt);
    QVERIFY(test::settle(bar));
    QVERIFY(bar.isHidden());
  }
};

RIVULET_TEST(TestProgramPage)
#include "tst_program_page.moc"
