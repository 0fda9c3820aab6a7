// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The page of the credit test: what stands in the way, how far it is, and its result.

#include <QCheckBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>

#include "gui/widgets/page_test.h"
#include "gui/widgets/samples.h"
#include "support/test_program.h"
#include "widgets/commissioning/commissioning_page.h"
#include "widgets/common/theme.h"

using namespace rivulet;
using namespace rivulet::widgets;
using streaming::CommissioningStep;

class TestCommissioningPage : public QObject {
  Q_OBJECT

  static QPushButton* start(const CommissioningPage& page) {
    for (QPushButton* button : page.findChildren<QPushButton*>()) {
      if (button->text() == QStringLiteral("Start the test")) {
        return button;
      }
    }
    return nullptr;
  }

 private slots:
  void init() {
    test::failOnWarnings();
    applyTheme(Theme::Light);
  }

  /// Cells are written: nothing starts before they are confirmed, and others not by the old answer.
  void startsOnlyOnConfirmedCells() {
    CommissioningPage page;
    page.show();
    QSignalSpy wanted(&page, &CommissioningPage::testRequested);
    QVERIFY(!start(page)->isEnabled());
    QVERIFY(test::visibleText(page).contains("Confirm the R-parameters first."));
    auto* confirmed = page.findChildren<QCheckBox*>().first();
    QVERIFY(confirmed->text().contains("R0 to R9"));
    confirmed->setChecked(true);
    QVERIFY(start(page)->isEnabled());
    page.findChild<QSpinBox*>()->setValue(40);
    QVERIFY(!start(page)->isEnabled());
    QVERIFY(confirmed->text().contains("R40 to R49"));
    QCOMPARE(page.findChild<QPlainTextEdit*>()->toPlainText(),
             QString::fromStdString(streaming::commissioningProgram(40)));
    confirmed->setChecked(true);
    page.setBlocked("Connect to a control first.");
    QVERIFY(!start(page)->isEnabled());
    QVERIFY(test::visibleText(page).contains("Connect to a control first."));
    page.setBlocked({});
    QTest::mouseClick(start(page), Qt::LeftButton);
    QCOMPARE(wanted.count(), 1);
    QCOMPARE(wanted[0][0].toInt(), 40);
    QCOMPARE(wanted[0][1].toBool(), false);
  }

  void showsHowFarItIs() {
    CommissioningPage page;
    page.show();
    page.setProgress(CommissioningStep::CycleStart);
    QVERIFY(test::visibleText(page).contains("Waiting for cycle start"));
    QVERIFY(!start(page)->isEnabled());
    QSignalSpy cancelled(&page, &CommissioningPage::cancelRequested);
    for (QPushButton* button : page.findChildren<QPushButton*>()) {
      if (button->text() == "Cancel") {
        QTest::mouseClick(button, Qt::LeftButton);
      }
    }
    QCOMPARE(cancelled.count(), 1);
    page.setProgress(CommissioningStep::Running);
    QVERIFY(test::visibleText(page).contains("The test is in progress"));
    page.setProgress(std::nullopt);
    page.setProblem("The channel is busy.");
    QVERIFY(test::visibleText(page).contains("The channel is busy."));
  }

  void saysWhatTheTestShowed() {
    test::Language language;
    CommissioningPage page;
    page.show();
    QVERIFY(test::visibleText(page).contains("Not tested"));
    streaming::CreditTest passed = test::creditTest(true);
    page.setTest(passed, false);
    QVERIFY(test::visibleText(page).contains("Passed: method credit may run"));
    QVERIFY(test::visibleText(page).contains("The control answers the client while"));
    page.setTest(passed, true);
    QVERIFY(test::visibleText(page).contains("another version of the server"));
    page.setTest(test::creditTest(false), false);
    QVERIFY(test::visibleText(page).contains("Not passed"));
    language.german();
    QVERIFY(test::visibleText(page).contains("Nicht bestanden"));
    QVERIFY(test::visibleText(page).contains("Die Steuerung antwortet dem Client"));
    page.setTest(std::nullopt, false);
    QVERIFY(test::visibleText(page).contains("Nicht getestet"));
  }
};

RIVULET_TEST(TestCommissioningPage)
#include "tst_commissioning_page.moc"
