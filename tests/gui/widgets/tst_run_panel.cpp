// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>

#include "gui/widgets/page_test.h"
#include "gui/widgets/samples.h"
#include "support/test_program.h"
#include "widgets/common/number_format.h"
#include "widgets/common/theme.h"
#include "widgets/streaming/preflight_sheet.h"
#include "widgets/streaming/report_panel.h"
#include "widgets/streaming/run_panel.h"

using namespace rivulet;
using namespace rivulet::widgets;
using streaming::RunState;

namespace {

streaming::LiveUpdate updateOf(RunState state) {
  streaming::LiveUpdate update;
  update.state = state;
  update.counters = {412, 409, 405, 1353};
  update.margin = std::chrono::microseconds{12'400};
  return update;
}

struct Buttons {
  explicit Buttons(const RunPanel& panel) {
    start = panel.findChild<QPushButton*>("start");
    stop = panel.findChild<QPushButton*>("stop");
    hold = panel.findChild<QPushButton*>("hold");
  }
  QPushButton* start;
  QPushButton* stop;
  QPushButton* hold;
};

}  // namespace

class TestRunPanel : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    test::failOnWarnings();
    applyTheme(Theme::Light);
  }

  void startIsGuarded() {
    test::Language language;
    RunPanel panel;
    const Buttons buttons(panel);
    QSignalSpy preflights(&panel, &RunPanel::preflightRequested);
    QSignalSpy starts(&panel, &RunPanel::startRequested);
    panel.setStartBlocked("the verdict is not feasible");
    QVERIFY(!buttons.start->isEnabled());
    buttons.start->click();
    QCOMPARE(preflights.count(), 0);
    QVERIFY(test::visibleText(panel).contains("Start is not possible: the verdict"));
    panel.setStartBlocked({});
    QVERIFY(buttons.start->isEnabled());
    buttons.start->click();
    QCOMPARE(preflights.count(), 1);
    // Behind the preflight a click is not enough.
    panel.setPreflightPassed(true);
    buttons.start->click();
    QCOMPARE(preflights.count(), 1);
    QCOMPARE(starts.count(), 0);
    panel.show();
    QTest::mousePress(buttons.start, Qt::LeftButton);
    QVERIFY(starts.wait());
    QTest::mouseRelease(buttons.start, Qt::LeftButton);
    QCOMPARE(starts.count(), 1);
  }

  /// A run that was left is not "done", and the next start is not simply "ready".
  /// Who has started with the keyboard can stop with it: the focus goes to no other button.
  void theFocusGoesFromStartToStop() {
    RunPanel panel;
    const Buttons buttons(panel);
    panel.show();
    panel.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&panel));
    buttons.start->setFocus();
    panel.setStartBlocked("the program is being simulated");
    panel.setStartBlocked({});
    QVERIFY(buttons.start->hasFocus());
    panel.setStartBlocked("a run is in progress");
    QVERIFY(!buttons.stop->hasFocus());
    panel.setUpdate(updateOf(streaming::RunState::Armed));
    QVERIFY(buttons.stop->hasFocus());
  }

  /// Who works, and when Stop and Hold are obeyed.
  void aWholeJobSaysWhereItIs() {
    test::Language language;
    RunPanel panel;
    JobProgress job{3, 12, false, 0, {}, false};
    panel.setUpdate(updateOf(streaming::RunState::Running));
    panel.setJob(job);
    QVERIFY(test::visibleText(panel).contains("Running: part 3 of 12"));
    job = {4, 12, true, 214, "N2130 T5 M6", false};
    panel.setJob(job);
    QVERIFY(test::visibleText(panel).contains("Running: the control, line 214"));
    QVERIFY(test::visibleText(panel).contains("Before part 4 of 12: N2130 T5 M6"));
    QVERIFY(test::visibleText(panel).contains("at the end of the block"));
    job.waitsForCycleStart = true;
    panel.setJob(job);
    QVERIFY(test::visibleText(panel).contains("waits for cycle start at the control"));
    job = {13, 12, true, 0, {}, false};
    panel.setJob(job);
    QVERIFY(test::visibleText(panel).contains("After the last part"));
    panel.setProgress({5, 300, TimeLeft{100.0, 5.0, 20.0, 10.0}});
    QVERIFY(test::visibleText(panel).contains("control 30"));
  }

  void aStoppedRunSaysWhereItStopped() {
    test::Language language;
    RunPanel panel;
    panel.setResume(true, {});
    panel.setUpdate(updateOf(RunState::Stopped));
    const QString text = test::visibleText(panel);
    QVERIFY(text.contains("Stopped at 405 of 1,353"));
    QVERIFY(!text.contains("Done") && !text.contains("Ready"));
    QVERIFY(text.contains("Resume …") && text.contains("Start over …"));
    panel.show();
    const auto left = [&panel](const QString& name) {
      const auto all = panel.findChildren<QPushButton*>();
      const auto it = std::find_if(all.begin(), all.end(), [&](const QPushButton* button) {
        return button->text().startsWith(name);
      });
      return (*it)->mapTo(&panel, QPoint()).x();
    };
    panel.resize(1200, panel.height());
    QCoreApplication::processEvents();
    QVERIFY(left("Resume") > left("Start"));
    // Another program has nothing to do with it.
    panel.setResume(false, {});
    panel.setProgram(43);
    const QString next = test::visibleText(panel);
    QVERIFY(next.contains("0 of 43") && next.contains("Ready") && !next.contains("405"));
  }

  /// Points were executed twice: no check mark, no "Ready to start" beside it.
  void aRunWithWrongMotionIsNotReady() {
    test::Language language;
    RunPanel panel;
    panel.setUpdate(updateOf(RunState::Running));
    panel.setWrongMotion(true);
    QVERIFY(test::visibleText(panel).contains("Wrong motion. Running"));
    for (const RunState state : {RunState::Done, RunState::Stopped, RunState::Aborted}) {
      panel.setUpdate(updateOf(state));
      for (const bool isBlocked : {false, true}) {
        panel.setStartBlocked(isBlocked ? "the channel is busy" : "");
        const QString text = test::visibleText(panel);
        QVERIFY(text.contains("Wrong motion"));
        QVERIFY(!text.contains("Ready") && !text.contains("Done"));
      }
    }
    panel.setWrongMotion(false);
    QVERIFY(!test::visibleText(panel).contains("Wrong motion"));
  }

  void stopIsThereWheneverSomethingMayMove_data() {
    QTest::addColumn<int>("state");
    QTest::addColumn<bool>("canStop");
    QTest::newRow("idle") << static_cast<int>(RunState::Idle) << false;
    QTest::newRow("armed") << static_cast<int>(RunState::Armed) << true;
    QTest::newRow("running") << static_cast<int>(RunState::Running) << true;
    QTest::newRow("stopping") << static_cast<int>(RunState::Stopping) << true;
    QTest::newRow("done") << static_cast<int>(RunState::Done) << false;
    QTest::newRow("aborted") << static_cast<int>(RunState::Aborted) << false;
  }
  void stopIsThereWheneverSomethingMayMove() {
    QFETCH(int, state);
    QFETCH(bool, canStop);
    RunPanel panel;
    const Buttons buttons(panel);
    panel.setUpdate(updateOf(static_cast<RunState>(state)));
    QCOMPARE(buttons.stop->isEnabled(), canStop);
    QCOMPARE(buttons.start->isEnabled(), !canStop);
  }

  /// Whoever has started what the control executes, and after a stop that was not confirmed.
  void stopIsThereWhileTheControlMayMove() {
    RunPanel panel;
    const Buttons buttons(panel);
    QSignalSpy stops(&panel, &RunPanel::stopRequested);
    panel.setUpdate(updateOf(RunState::Aborted));
    panel.setMayMove(true);
    QVERIFY(buttons.stop->isEnabled());
    buttons.stop->click();
    QCOMPARE(stops.count(), 1);
    panel.setMayMove(false);
    QVERIFY(!buttons.stop->isEnabled());
  }

  /// With a feed cell the axes stand at once; then the run goes on, or ends when somebody wants it.
  void theFeedCellActsAtOnce() {
    RunPanel panel;
    const Buttons buttons(panel);
    static_cast<void>(test::picture(panel, {1280, 110}));
    auto* end = panel.findChild<QPushButton*>("end-here");
    auto* less = panel.findChild<QPushButton*>("override-less");
    auto* more = panel.findChild<QPushButton*>("override-more");
    QSignalSpy percents(&panel, &RunPanel::overrideRequested);
    streaming::LiveUpdate update = updateOf(RunState::Running);
    panel.setUpdate(update);
    QVERIFY(buttons.start->isVisible() && !less->isVisible() && !end->isVisible());
    update.feed.emplace();
    panel.setUpdate(update);
    QVERIFY(!buttons.start->isVisible() && less->isVisible() && !end->isVisible());
    QVERIFY(!more->isEnabled());  // an operator may not set more than 100 %
    less->click();
    QCOMPARE(percents.takeFirst().at(0).toDouble(), 95.0);
    panel.setOverrideAllowed(true, 120.0);
    for (const double percent : {100.0, 105.0}) {
      more->click();
      QCOMPARE(percents.takeFirst().at(0).toDouble(), percent);
    }
    buttons.stop->click();
    QVERIFY(!test::visibleText(panel).contains("not yet confirmed"));
    update.state = RunState::Holding;
    update.feed->holds = true;
    update.feed->wantedPercent = 0.0;
    panel.setUpdate(update);
    QVERIFY(test::visibleText(panel).contains("The axes are braking"));
    QVERIFY(test::visibleText(panel).contains("Override 105 %"));  // with which it goes on
    QVERIFY(end->isVisible() && buttons.stop->isEnabled());
    update.feed->stoodAfter = std::chrono::milliseconds{210};
    panel.setUpdate(update);
    QVERIFY(test::visibleText(panel).contains("The axes stand"));
    update.feed->isIgnored = true;
    panel.setUpdate(update);
    QVERIFY(test::visibleText(panel).contains("Press NC STOP"));
    static_cast<void>(test::picture(panel, {480, 180}));
    for (const QPushButton* part : {buttons.stop, end, less, more}) {
      QVERIFY(part->isVisible() &&
              panel.rect().contains(QRect(part->mapTo(&panel, QPoint()), part->size())));
    }
  }

  void stopSaysWhenItIsConfirmed() {
    test::Language language;
    RunPanel panel;
    const Buttons buttons(panel);
    QSignalSpy stops(&panel, &RunPanel::stopRequested);
    panel.setUpdate(updateOf(RunState::Running));
    buttons.stop->click();
    QCOMPARE(stops.count(), 1);
    QVERIFY(test::visibleText(panel).contains("not yet confirmed"));
    widgets::RunProgress progress;
    progress.delivered = widgets::MotionLeft{212.4, 33.7};
    panel.setProgress(progress);
    QVERIFY(test::visibleText(panel).contains("still moving, at most 212"));
    QVERIFY(test::visibleText(panel).contains("about 34"));
    streaming::RunReport report = test::report();
    report.error = base::makeError(make_error_code(streaming::StreamError::StopNotConfirmed), "");
    panel.setReport(report);
    QVERIFY(test::visibleText(panel).contains("Stop NOT confirmed"));
    auto update = updateOf(RunState::Stopping);
    update.stopConfirmedAfter = std::chrono::milliseconds{1230};
    panel.setUpdate(update);
    QVERIFY(test::visibleText(panel).contains(QString("Stop confirmed after 1.23") + QChar(0x00A0) +
                                              "s"));
    // The next run begins without the traces of this one.
    panel.setUpdate(updateOf(RunState::Done));
    panel.setUpdate(updateOf(RunState::Armed));
    QVERIFY(!test::visibleText(panel).contains("confirmed"));
  }

  /// Before a start: what is wrong is in sight, what has passed is one line that unfolds.
  void whatHasPassedIsOneLine() {
    test::Language language;
    PreflightSheet sheet;
    const PreflightItem wrong{Status::Fault, "Release", "not released", {}, 0};
    const PreflightItem kept{Status::Plain, "First move", "straight down", {}, 0, true};
    const PreflightItem good{Status::Good, "Verdict", "margin 2", {}, 0};
    const PreflightItem other{Status::Good, "Cells", "all free", {}, 0};
    sheet.setItems({good, kept, other, wrong}, false);
    sheet.resize(900, 500);
    sheet.show();
    QTest::qWait(0);
    const auto text = [&sheet] { return test::visibleText(sheet); };
    QVERIFY(text().contains("not released") && text().contains("straight down"));
    QVERIFY(text().contains("2 checks: Verdict, Cells") && !text().contains("margin 2"));
    // A changed list is laid out before it is seen: no button over the title.
    sheet.setItems({good, kept, other}, true);
    for (auto* button : sheet.findChildren<QPushButton*>()) {
      QVERIFY(!button->isVisible() || button->y() > 0);
    }
    sheet.setItems({good, kept, other, wrong}, false);
    const auto press = [&sheet](const QString& name) {
      for (auto* button : sheet.findChildren<QPushButton*>()) {
        if (button->isVisible() && button->text() == name) {
          QTest::mouseClick(button, Qt::LeftButton);
          return true;
        }
      }
      return false;
    };
    QVERIFY(press("Show"));
    QTRY_VERIFY(text().contains("margin 2"));
    QVERIFY(press("Fold"));
    QTRY_VERIFY(!text().contains("margin 2"));
    // What is pressed may be gone by the time it acts.
    QVERIFY(press("Show"));
    sheet.setItems({kept, wrong}, false);
    QTest::qWait(0);
    QVERIFY(!text().contains("Verdict"));
  }

  void onlyStopIsRedAndOnlyStartIsGreen() {
    for (const Theme theme : {Theme::Light, Theme::Dark, Theme::Contrast}) {
      applyTheme(theme);
      RunPanel panel;
      const Buttons buttons(panel);
      panel.setUpdate(updateOf(RunState::Running));
      const auto fill = [](QPushButton* button) {
        return test::picture(*button, {200, 60}).pixelColor(10, 30);
      };
      const QColor stop = fill(buttons.stop);
      QVERIFY(stop.hsvSaturation() > 100 && (stop.hsvHue() < 15 || stop.hsvHue() > 345));
      const QColor start = fill(buttons.start);
      QVERIFY(start.hsvSaturation() > 40 && start.hsvHue() > 120 && start.hsvHue() < 180);
      const QColor pause = fill(buttons.hold);
      QVERIFY(std::max({pause.red(), pause.green(), pause.blue()}) -
                  std::min({pause.red(), pause.green(), pause.blue()}) <
              40);
      QVERIFY(buttons.start->minimumHeight() >= kTouchHeightPx);
      QVERIFY(buttons.stop->minimumHeight() >= kTouchHeightPx);
      for (const QString& text : {buttons.stop->text(), buttons.stop->toolTip()}) {
        QVERIFY(!text.startsWith("Emergency", Qt::CaseInsensitive));
      }
    }
  }

  void countersAndReasonsAreShown() {
    test::Language language;
    RunPanel panel;
    panel.resize(1200, 100);
    panel.setTotal(1353);
    QVERIFY(test::visibleText(panel).contains("0 of 1,353"));
    auto update = updateOf(RunState::Armed);
    update.waitingFor = "cycle-start";
    panel.setUpdate(update);
    QString text = test::visibleText(panel);
    QVERIFY(text.contains("405 of 1,353"));
    QVERIFY(test::hintOf(panel, "405 of 1,353")
                .contains("Sent to the control: 412, confirmed by it: 409"));
    QVERIFY(text.contains("4 moves in hand"));
    QVERIFY(text.contains("cycle start at the control"));
    update.waitingFor = "something-new";
    update.margin = std::chrono::milliseconds{-3};
    panel.setUpdate(update);
    text = test::visibleText(panel);
    QVERIFY(text.contains("something-new"));
    QVERIFY(text.contains("late, 4 moves in hand"));
    language.german();
    text = test::visibleText(panel);
    QVERIFY(text.contains("405 von 1.353"));
    QVERIFY(text.contains("zu spät, 4 Sätze"));
  }

  /// Line, time left and moves in hand; what is not known is a dash with a reason.
  void progressIsShown() {
    test::Language language;
    RunPanel panel;
    panel.resize(1400, 130);
    const auto hint = [&panel](const QString& shown) { return test::hintOf(panel, shown); };
    QVERIFY(hint(noValue()).contains("No program is loaded"));
    panel.setProgram(1353);
    panel.setProgress({0, 1500, TimeLeft{754.0, 130.0}});
    QVERIFY(hint(QString("12:34") + QChar(0x00A0) + "min, pauses 2:10" + QChar(0x00A0) + "min")
                .contains("planned pauses"));
    QVERIFY(hint(noValue()).contains("No point has been executed"));
    panel.setUpdate(updateOf(RunState::Running));
    panel.setProgress({406, 1500, TimeLeft{90.0, 0.0}});
    QVERIFY(hint("406 of 1,500").contains("move that the tool is on"));
    QVERIFY(!hint(QString("1:30") + QChar(0x00A0) + "min").isEmpty());
    const QString stream = hint("on time, 4 moves in hand");
    QVERIFY(stream.contains("has not executed yet") && stream.contains("99th percentile"));
    QVERIFY(test::visibleText(panel).contains(QString("Running ") + QChar(0x00B7) + " 30"));
    RunProgress live;
    live.isLive = true;
    panel.setProgress(live);
    QVERIFY(test::visibleText(panel).split(QLatin1Char('\n')).contains(QString("Running")));
    panel.setProgress({406, 1500, std::nullopt});
    QVERIFY(hint(noValue()).contains("not estimated yet"));
    panel.setProgress({406, 1500, TimeLeft{90.0, 0.0}});
    panel.setUpdate(updateOf(RunState::Done));
    QVERIFY(hint(noValue()).contains("The run has ended"));
    // Of a run that another computer streams, only what the control says is known.
    panel.setProgram(1353);
    FoundRunView found;
    found.kind = FoundRunView::Kind::Served;
    found.isWatched = true;
    found.executed = 21;
    found.total = 40;
    panel.setFound(found);
    QVERIFY(!hint("21 of 40").isEmpty());
    QVERIFY(hint(noValue()).contains("Only the computer that streams"));
  }

  void reportTellsWhatHappened() {
    test::Language language;
    ReportPanel panel;
    QVERIFY(test::visibleText(panel).contains("No run yet"));
    streaming::RunReport report = test::report();
    panel.setReport(report);
    QString text = test::visibleText(panel);
    QVERIFY(text.contains("Completed"));
    QVERIFY(text.contains("1,353 of 1,353"));
    QVERIFY(text.contains(QString("4.31") + QChar(0x00A0) + "ms"));
    report.integrity.repeated = 3;
    panel.setReport(report);
    QVERIFY(test::visibleText(panel).contains("Completed with wrong motion"));
    report.integrity = {};
    report.outcome = streaming::Outcome::Stopped;
    panel.setReport(report);
    text = test::visibleText(panel);
    QVERIFY(text.contains("Stopped, not judged"));
    QVERIFY(text.contains("NOT confirmed: check the machine"));
    report.outcome = streaming::Outcome::Failed;
    report.error = base::makeError(make_error_code(streaming::StreamError::ControlAlarm),
                                   "The control stopped with alarm 10870.");
    panel.setReport(report);
    QVERIFY(test::visibleText(panel).contains("alarm 10870"));
    language.german();
    QVERIFY(test::visibleText(panel).contains("Fehlgeschlagen"));
  }
};

RIVULET_TEST(TestRunPanel)
#include "tst_run_panel.moc"
