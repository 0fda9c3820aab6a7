// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// What an operator sees of a live source, and the dialog that agrees on what may move.

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>

#include "gui/widgets/page_test.h"
#include "live/error.h"
#include "support/test_program.h"
#include "widgets/common/status_label.h"
#include "widgets/common/theme.h"
#include "widgets/live/live_dialog.h"
#include "widgets/live/live_panel.h"

using namespace rivulet;
using namespace rivulet::widgets;
using namespace std::chrono_literals;

Q_DECLARE_METATYPE(rivulet::live::Setup)

namespace {

constexpr QSize kPanel{420, 560};

streaming::LiveUpdate update(live::SourceState state) {
  streaming::LiveUpdate update;
  update.state = streaming::RunState::Running;
  update.counters = {100, 96, 90, 120};
  update.source.emplace();
  update.source->state = state;
  update.source->silence = 2s;
  update.source->accepted = 120;
  update.source->waiting = 30;
  update.source->capacity = 98;
  update.source->acceptedPerS = 200.4;
  update.source->executedPerS = 198.0;
  update.source->delays = 90;
  update.source->delayMedian = 471ms;
  update.source->delayP99 = 544ms;
  update.source->leastDelay = 73ms;
  update.source->mostDelay = 585ms;
  return update;
}

QString stateOf(const LivePanel& panel) {
  return panel.findChild<StatusLabel*>(QStringLiteral("live-state"))
      ->text()
      .replace(QChar::Nbsp, QLatin1Char(' '));
}

live::Setup someSetup() {
  live::Setup setup;
  setup.address = "udp:4100";
  setup.agreement.lowestMm = {-1.5, -2.0, 3.25};
  setup.agreement.highestMm = {10.0, 20.0, 30.0};
  setup.agreement.stepMmMax = 0.75;
  setup.agreement.turnDegMax = 2.0;
  setup.agreement.feedMmPerMinMax = 2500.0;
  setup.agreement.distanceMmMin = 0.01;
  setup.agreement.startMmMax = 3.0;
  setup.limits.fullWithin = 20ms;
  setup.limits.holdAfter = 2s;
  setup.limits.endAfter = 9s;
  setup.rotaryAxes = {true, false, true};
  return setup;
}

}  // namespace

class TestLivePanel : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    test::failOnWarnings();
    QLocale::setDefault(QLocale(QLocale::English));
    applyTheme(Theme::Light);
  }

  void showsWhatTheSourceDoes() {
    LivePanel panel;
    panel.setSource({}, QStringLiteral("tcp:4001"), {});
    QVERIFY(stateOf(panel).startsWith(QStringLiteral("Listening")));
    panel.show();
    QVERIFY(test::visibleText(panel).contains("127.0.0.1, port 4001"));
    panel.setSource({}, QStringLiteral("tcp:4001"), QStringLiteral("The port is taken."));
    QCOMPARE(stateOf(panel), QStringLiteral("The port is taken."));
    panel.setSource({}, QStringLiteral("tcp:4001"), {});
    // What is left of a run that has ended is no news of the next.
    panel.setUpdate(update(live::SourceState::Receiving));
    QVERIFY(stateOf(panel).startsWith(QStringLiteral("Listening")));
    panel.begin();
    panel.setUpdate(update(live::SourceState::Waiting));
    QCOMPARE(stateOf(panel), QStringLiteral("Waiting for the first line, for 2.0 s"));
    panel.setUpdate(update(live::SourceState::Silent));
    QCOMPARE(stateOf(panel),
             QStringLiteral("Silent for 2.0 s; hold after 5.0 s, end after 1:00 min"));
    panel.setUpdate(update(live::SourceState::Ended));
    QCOMPARE(stateOf(panel), QStringLiteral("Ended by the source"));
    auto refused = update(live::SourceState::Refused);
    refused.source->refusal =
        base::makeError(live::LiveError::OutsideBox, "X12 is outside the box.", "tcp:4001, line 7");
    panel.setUpdate(refused);
    QCOMPARE(stateOf(panel), QStringLiteral("tcp:4001, line 7: X12 is outside the box."));
    panel.setUpdate(update(live::SourceState::Receiving));
    QCOMPARE(stateOf(panel), QStringLiteral("Receiving"));
    const auto* buffer = panel.findChild<QProgressBar*>(QStringLiteral("live-buffer"));
    QCOMPARE(buffer->maximum(), 98);
    QCOMPARE(buffer->value(), 30);
    const QString text = test::visibleText(panel);
    for (const char* shown :
         {"200.4 /s", "198.0 /s", "471\u00A0ms", "544\u00A0ms", "585\u00A0ms"}) {
      QVERIFY2(text.contains(QString::fromUtf8(shown)) ||
                   text.contains(QString::fromUtf8(shown).replace(QChar(0xA0), QChar(' '))),
               shown);
    }
  }

  void theEndStaysShown() {
    LivePanel panel;
    panel.setSource({}, QStringLiteral("tcp:4001"), {});
    panel.begin();
    panel.setUpdate(update(live::SourceState::Receiving));
    streaming::RunReport report;
    report.counters.executed = 480;  // parts of their moves
    report.live.emplace();
    report.live->accepted = report.live->executed = 120;
    report.live->delay.count = 120;
    report.live->delay.p50 = 300ms;
    panel.setReport(report);
    QVERIFY(stateOf(panel).startsWith(QStringLiteral("The run has ended")));
    QCOMPARE(panel.findChild<QLabel*>(QStringLiteral("live-executed"))->text(),
             QStringLiteral("120"));
    QVERIFY(panel.findChild<QLabel*>(QStringLiteral("live-median"))
                ->text()
                .startsWith(QStringLiteral("300")));
    QCOMPARE(panel.findChild<QProgressBar*>(QStringLiteral("live-buffer"))->value(), 0);
    // The source that is opened again for the next run changes nothing.
    panel.setSource({}, QStringLiteral("tcp:4001"), {});
    QVERIFY(stateOf(panel).startsWith(QStringLiteral("The run has ended")));
    report.live->refusal = base::makeError(live::LiveError::SourceClosed, "It was closed.", "x");
    panel.setReport(report);
    QCOMPARE(stateOf(panel), QStringLiteral("x: It was closed."));
  }

  void nothingIsCutInAnyLook() {
    for (const Theme theme : {Theme::Light, Theme::Dark, Theme::Contrast}) {
      applyTheme(theme);
      test::Language language;
      for (const bool isGerman : {false, true}) {
        isGerman ? language.german() : language.english();
        LivePanel panel;
        panel.setSource(someSetup(), QStringLiteral("tcp:4001"), {});
        panel.begin();
        panel.setUpdate(update(live::SourceState::Silent));
        const QImage picture = test::picture(panel, kPanel);
        const QString name = QStringLiteral("live-%1-%2")
                                 .arg(widgets::themeName(theme),
                                      isGerman ? QStringLiteral("de") : QStringLiteral("en"));
        test::keep(picture, name);
        QCOMPARE(test::cutTexts(panel), QStringList());
        LiveDialog dialog(someSetup(), true, base::Vec3{120.5, 0.0, 250.0}, nullptr);
        test::keep(test::picture(dialog, dialog.sizeHint()), name + QStringLiteral("-dialog"));
        QCOMPARE(test::cutTexts(dialog), QStringList());
        QVERIFY2(dialog.height() <= 700, qPrintable(QString::number(dialog.height())));
        QVERIFY2(dialog.width() <= 1000, qPrintable(QString::number(dialog.width())));
      }
    }
  }

  void theDialogReturnsWhatItWasGiven() {
    for (const char* address :
         {"udp:4100", "tcp:0", "unix:/tmp/points", "opcua:/tmp/robot.toml", "-"}) {
      live::Setup setup = someSetup();
      setup.address = address;
      const LiveDialog dialog(setup, true, {}, nullptr);
      QCOMPARE(live::textOf(dialog.setup()), live::textOf(setup));
    }
    // Without points in it, standard input is not offered.
    live::Setup input;
    input.address = "-";
    QCOMPARE(LiveDialog(input, false, {}, nullptr).setup().address, std::string("tcp:4001"));
  }

  /// A box in which no first point can be is said before anything is agreed.
  void theBoxIsPutAroundTheTool() {
    LiveDialog dialog({}, false, base::Vec3{120.5, 0.0, 250.0}, nullptr);
    dialog.show();
    const auto* tool = dialog.findChild<widgets::StatusLabel*>(QStringLiteral("live-tool"));
    QCOMPARE(tool->status(), widgets::Status::Attention);
    QVERIFY2(tool->text().contains(QStringLiteral("so far outside")), qPrintable(tool->text()));
    QTest::mouseClick(dialog.findChild<QPushButton*>(QStringLiteral("live-around")),
                      Qt::LeftButton);
    QCOMPARE(tool->status(), widgets::Status::Plain);
    const live::Agreement agreed = dialog.setup().agreement;
    QCOMPARE(agreed.lowestMm, base::Vec3(110.0, -10.0, 240.0));
    QCOMPARE(agreed.highestMm, base::Vec3(131.0, 10.0, 260.0));
    // 1 mm beside the box the first point can still be reached, no more.
    auto* lowest = dialog.findChild<QDoubleSpinBox*>(QStringLiteral("live-x-from"));
    lowest->setValue(121.5);
    QCOMPARE(tool->status(), widgets::Status::Plain);
    lowest->setValue(121.501);
    QCOMPARE(tool->status(), widgets::Status::Attention);
    const LiveDialog other({}, false, {}, nullptr);
    QVERIFY(other.findChild<QPushButton*>(QStringLiteral("live-around"))->isHidden());
  }

  void whatCannotBeKeptIsNotOpened() {
    LiveDialog dialog({}, false, {}, nullptr);
    QSignalSpy opened(&dialog, &LiveDialog::openRequested);
    dialog.show();
    auto* lowest = dialog.findChild<QDoubleSpinBox*>(QStringLiteral("live-x-from"));
    auto* open = dialog.findChild<QPushButton*>(QStringLiteral("live-open"));
    lowest->setValue(10.5);
    QTest::mouseClick(open, Qt::LeftButton);
    QVERIFY(dialog.isVisible());
    QCOMPARE(opened.count(), 0);
    QVERIFY(test::visibleText(dialog).contains("no room in X"));
    lowest->setValue(-5.0);
    QTest::mouseClick(open, Qt::LeftButton);
    QVERIFY(!dialog.isVisible());
    QCOMPARE(opened.count(), 1);
    QCOMPARE(opened.front().front().value<live::Setup>().agreement.lowestMm.x, -5.0);
  }

  void everyFieldIsNamedForItsUser() {
    LiveDialog dialog(someSetup(), true, {}, nullptr);
    int fields = 0;
    for (const QWidget* field : dialog.findChildren<QWidget*>()) {
      if (qobject_cast<const QAbstractSpinBox*>(field) != nullptr ||
          qobject_cast<const QComboBox*>(field) != nullptr ||
          qobject_cast<const QCheckBox*>(field) != nullptr ||
          (qobject_cast<const QLineEdit*>(field) != nullptr &&
           qobject_cast<const QAbstractSpinBox*>(field->parentWidget()) == nullptr)) {
        ++fields;
        QVERIFY2(field->objectName().startsWith(QStringLiteral("live-")),
                 qPrintable(field->accessibleName()));
        QVERIFY2(!field->accessibleName().isEmpty() && !field->toolTip().isEmpty(),
                 qPrintable(field->objectName()));
        QVERIFY2(field->minimumHeight() >= 44, qPrintable(field->objectName()));
      }
    }
    QCOMPARE(fields, 21);
  }
};

RIVULET_TEST(TestLivePanel)
#include "tst_live_panel.moc"
