// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The page of the credit test: what stands in the way, how far it is, and its result.

#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>

#include "gui/widgets/page_test.h"
#include "gui/widgets/samples.h"
#include "support/test_program.h"
#include "widgets/commissioning/commissioning_page.h"
#include "widgets/common/number_field.h"
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
    CommissioningPage page(creditTestTexts());
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

  /// An axis moves only after the word, and not by the word for another move.
  void anAxisMovesOnlyOnTheWord() {
    CommissioningPage page(feedTestTexts());
    page.show();
    QSignalSpy wanted(&page, &CommissioningPage::testRequested);
    auto* confirmed = page.findChildren<QCheckBox*>().first();
    QVERIFY(confirmed->text().contains("R0 to R17"));
    auto* program = page.findChild<QPlainTextEdit*>();
    QVERIFY(program->toPlainText().contains("MOVES NO AXIS"));
    QCheckBox* moves = nullptr;
    for (QCheckBox* box : page.findChildren<QCheckBox*>()) {
      moves = box->text() == QStringLiteral("An axis moves in the air") ? box : moves;
    }
    QVERIFY(moves != nullptr && !moves->isChecked());
    moves->setChecked(true);
    QVERIFY(program->toPlainText().contains("MOVES X BY 20 MM"));
    confirmed->setChecked(true);
    QVERIFY(!start(page)->isEnabled());
    QLineEdit* word = nullptr;
    for (QLineEdit* line : page.findChildren<QLineEdit*>()) {
      word = line->placeholderText().contains("MOVE") ? line : word;
    }
    QVERIFY(word != nullptr);
    word->setText("MOVE");
    QVERIFY(start(page)->isEnabled());
    page.findChild<QComboBox*>()->setCurrentIndex(2);
    QVERIFY(!start(page)->isEnabled());  // another axis
    QVERIFY(word->text().isEmpty());
    confirmed->setChecked(true);
    word->setText("MOVE");
    page.findChildren<NumberField*>().first()->setValue(0.5);  // too short to be held
    confirmed->setChecked(true);
    word->setText("MOVE");
    QVERIFY(!start(page)->isEnabled());
    page.findChildren<NumberField*>().first()->setValue(-20.0);
    confirmed->setChecked(true);
    word->setText("MOVE");
    QTest::mouseClick(start(page), Qt::LeftButton);
    QCOMPARE(wanted.count(), 1);
    const auto move = wanted[0][2].value<std::optional<streaming::AirMove>>();
    QVERIFY(move == (streaming::AirMove{2, -20.0, 400.0}));
    QVERIFY(!start(page)->isEnabled() && word->text().isEmpty());
  }

  /// An axis always moves; blocks are asked for, and others need the word again.
  void theTestOfJobsTriesBlocks() {
    CommissioningPage page(jobTestTexts());
    page.show();
    QSignalSpy wanted(&page, &CommissioningPage::testRequested);
    auto* confirmed = page.findChildren<QCheckBox*>().first();
    QVERIFY(confirmed->text().contains("R0 to R35"));
    QPlainTextEdit* blocks = nullptr;
    for (QPlainTextEdit* text : page.findChildren<QPlainTextEdit*>()) {
      blocks = text->isVisible() ? text : blocks;
    }
    QVERIFY(blocks != nullptr && !blocks->isReadOnly());
    QLineEdit* word = nullptr;
    for (QLineEdit* line : page.findChildren<QLineEdit*>()) {
      word = line->placeholderText().contains("MOVE") ? line : word;
    }
    const auto confirm = [&] {
      confirmed->setChecked(true);
      word->setText("MOVE");
    };
    confirm();
    QVERIFY(start(page)->isEnabled());
    blocks->setPlainText("S500 M3\n\n M5 \n");
    QVERIFY(!start(page)->isEnabled() && word->text().isEmpty());
    confirm();
    QVERIFY(start(page)->isEnabled());
    blocks->setPlainText("G1 X5");
    confirm();
    QVERIFY(!start(page)->isEnabled());
    QVERIFY(test::visibleText(page).contains("cannot be tried"));
    blocks->setPlainText("S500 M3\nM27");
    confirm();
    QTest::mouseClick(start(page), Qt::LeftButton);
    QCOMPARE(wanted.count(), 1);
    QVERIFY(wanted[0][2].value<std::optional<streaming::AirMove>>() ==
            (streaming::AirMove{0, 20.0, 400.0}));
    QVERIFY(wanted[0][3].value<std::vector<std::string>>() ==
            (std::vector<std::string>{"S500 M3", "M27"}));
  }

  /// What the control does not show, the operator may have seen; not after a test that failed.
  void theOperatorConfirmsABlock() {
    CommissioningPage page(jobTestTexts());
    page.show();
    QSignalSpy confirmed(&page, &CommissioningPage::blockConfirmed);
    streaming::JobTest test;
    test.result.checks = {{"hand-over", true, ""}};
    test.result.tried = {
        {"S500 M3", {job::NativeReason::Spindle}, streaming::Witness::Control, "spindle 0 → 500."},
        {"M27", {job::NativeReason::Other}, streaming::Witness::Nobody, ""}};
    const auto seen = [&page]() -> QPushButton* {
      for (QPushButton* button : page.findChildren<QPushButton*>()) {
        if (button->text() == QStringLiteral("I have seen it") && button->isVisible()) {
          return button;
        }
      }
      return nullptr;
    };
    page.setTest(shownTest(test), false);
    QVERIFY(test::visibleText(page).contains("spindle 0 → 500."));
    QVERIFY(seen() != nullptr);
    page.setBlocked("Only an engineer can do this.");
    QVERIFY(!seen()->isEnabled());
    page.setBlocked({});
    QTest::mouseClick(seen(), Qt::LeftButton);
    QCOMPARE(confirmed.count(), 1);
    QCOMPARE(confirmed[0][0].value<std::size_t>(), std::size_t{1});
    test.result.tried[1].witness = streaming::Witness::Operator;
    page.setTest(shownTest(test), false);
    QVERIFY(seen() == nullptr);
    test.result.tried[1].witness = streaming::Witness::Nobody;
    test.result.checks[0].passed = false;
    page.setTest(shownTest(test), false);
    QVERIFY(seen() == nullptr);
  }

  /// Without motion it has passed what was tested, which is not all.
  void passingWithoutMotionIsNotEnough() {
    CommissioningPage page(feedTestTexts());
    page.show();
    QVERIFY(test::visibleText(page).contains("a stop is sure to act only before"));
    streaming::FeedTest made;
    made.result.checks = {{"actions-follow", true, "yes"}};
    page.setTest(shownTest(made), false);
    QVERIFY(test::visibleText(page).contains("Passed without motion"));
    made.result.move = streaming::AirMove{0, 20.0, 400.0};
    page.setTest(shownTest(made), false);
    QVERIFY(test::visibleText(page).contains("act at once on this control"));
    made.result.checks.push_back({"stays-held", false, "It moved in 1 cycles."});
    page.setTest(shownTest(made), false);
    QVERIFY(test::visibleText(page).contains("Not passed"));
    QVERIFY(test::visibleText(page).contains("It moved in 1 cycles."));
  }

  void showsHowFarItIs() {
    CommissioningPage page(creditTestTexts());
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
    CommissioningPage page(creditTestTexts());
    page.show();
    QVERIFY(test::visibleText(page).contains("Not tested"));
    streaming::CreditTest passed = test::creditTest(true);
    page.setTest(shownTest(passed), false);
    QVERIFY(test::visibleText(page).contains("Passed: method credit may run"));
    QVERIFY(test::visibleText(page).contains("The control answers the client while"));
    page.setTest(shownTest(passed), true);
    QVERIFY(test::visibleText(page).contains("another version of the server"));
    page.setTest(shownTest(test::creditTest(false)), false);
    QVERIFY(test::visibleText(page).contains("Not passed"));
    language.german();
    QVERIFY(test::visibleText(page).contains("Nicht bestanden"));
    QVERIFY(test::visibleText(page).contains("Die Steuerung antwortet dem Client"));
    QVERIFY(test::visibleText(page).contains("Antworten unter Last"));
    page.setTest(std::nullopt, false);
    QVERIFY(test::visibleText(page).contains("Nicht getestet"));
  }
};

RIVULET_TEST(TestCommissioningPage)
#include "tst_commissioning_page.moc"
