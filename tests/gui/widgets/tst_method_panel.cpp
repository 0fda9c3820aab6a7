// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>
#include <algorithm>
#include <vector>

#include "base/units.h"
#include "gui/widgets/page_test.h"
#include "gui/widgets/samples.h"
#include "support/test_program.h"
#include "widgets/common/number_field.h"
#include "widgets/streaming/method_panel.h"

using namespace rivulet;
using namespace rivulet::widgets;

namespace {

feasibility::Verdict verdictOf(const streaming::StreamSettings& settings) {
  const auto points = test::streamed(*test::pocket());
  const auto distances = feasibility::programDistances(points, settings.parameters.pointsPerLoop);
  return feasibility::judge({settings.parameters.method, settings.parameters.pointsPerLoop,
                             settings.deltaMm, settings.feedMmPerS},
                            distances)
      .value();
}

QPushButton* buttonWith(const QWidget& widget, const QString& text) {
  for (QPushButton* button : widget.findChildren<QPushButton*>()) {
    if (button->text().contains(text) && button->isVisibleTo(&widget)) {
      return button;
    }
  }
  return nullptr;
}

/// Numbers as in a language; its texts have tests of their own.
void inLanguage(QWidget& widget, const QString& code) {
  QLocale::setDefault(QLocale(code));
  QEvent change(QEvent::LanguageChange);
  QCoreApplication::sendEvent(&widget, &change);
}

QRect placeIn(const QWidget& panel, const QWidget* field) {
  return {field->mapTo(&panel, QPoint()), field->size()};
}

}  // namespace

class TestMethodPanel : public QObject {
  Q_OBJECT

 private slots:
  void init() { test::failOnWarnings(); }

  void changesAreSignalledOnce() {
    test::Language language;
    MethodPanel panel;
    QSignalSpy changes(&panel, &MethodPanel::settingsChanged);
    streaming::StreamSettings settings;
    settings.parameters.pointsPerLoop = 9;
    panel.setSettings(settings);
    QCOMPARE(changes.count(), 0);
    panel.findChild<QSpinBox*>()->setValue(11);
    QCOMPARE(changes.count(), 1);
    auto changed = changes.takeFirst().first().value<streaming::StreamSettings>();
    QCOMPARE(changed.parameters.pointsPerLoop, 11);
    panel.findChild<QComboBox*>("method")->setCurrentIndex(1);
    QCOMPARE(changes.count(), 1);
    changed = changes.takeFirst().first().value<streaming::StreamSettings>();
    QCOMPARE(changed.parameters.method, base::MethodKind::Position);
    // Switching the language shows everything anew and changes nothing.
    language.german();
    QCOMPARE(changes.count(), 0);
  }

  /// One of two fields is shown: it has a row of its own, whatever was shown before.
  void eachFieldShownHasItsRow() {
    test::Language language;
    MethodPanel panel;
    panel.resize(600, 800);
    streaming::StreamSettings settings;
    settings.programFeeds = true;
    panel.setSettings(settings);
    panel.show();
    for (const bool isFixed : {true, false, true}) {
      settings.programFeeds = !isFixed;
      panel.setSettings(settings);
      QTest::qWait(0);
      std::vector<QWidget*> fields;
      for (QWidget* each : panel.findChildren<QWidget*>()) {
        const bool isField = qobject_cast<QComboBox*>(each) != nullptr ||
                             qobject_cast<QAbstractSpinBox*>(each) != nullptr;
        if (isField && each->isVisible()) {
          fields.push_back(each);
        }
      }
      QVERIFY(fields.size() > 5);
      for (std::size_t i = 0; i < fields.size(); ++i) {
        const QRect place = placeIn(panel, fields[i]);
        QVERIFY(place.height() >= fields[i]->minimumSizeHint().height());
        for (std::size_t j = 0; j < i; ++j) {
          QVERIFY(!place.intersects(placeIn(panel, fields[j])));
        }
      }
      const auto labels = panel.findChildren<QLabel*>();
      const QString name = isFixed ? QStringLiteral("F (path feed)") : QStringLiteral("Override");
      QVERIFY(std::any_of(labels.begin(), labels.end(), [&](const QLabel* each) {
        return each->isVisible() && each->text() == name && each->buddy() != nullptr &&
               each->buddy()->isVisible();
      }));
    }
  }

  void valuesKeepTheDigitsTheFieldsDoNotShow() {
    MethodPanel panel;
    streaming::StreamSettings settings;
    settings.feedMmPerS = 1.23456;
    settings.deltaMm = 0.1234567;
    panel.setSettings(settings);
    panel.findChild<QSpinBox*>()->setValue(12);
    QCOMPARE(panel.settings().feedMmPerS, 1.23456);
    QCOMPARE(panel.settings().deltaMm, 0.1234567);
  }

  /// Method window is never infeasible: it says whether the machine will wait, and up to which feed
  /// it does not.
  void windowIsSafeAndSaysWhenItWaits() {
    test::Language language;
    MethodPanel panel;
    streaming::StreamSettings settings;
    QCOMPARE(settings.parameters.method, base::MethodKind::Window);
    settings.feedMmPerS = base::mmPerSFromMmPerMin(50000.0);
    panel.setSettings(settings);
    panel.setVerdict(verdictOf(settings), std::nullopt);
    QVERIFY(test::visibleText(panel).contains("Safe, with waiting"));
    QVERIFY(test::visibleText(panel).contains("Reach:"));
    QVERIFY(test::visibleText(panel).contains("N (points per window)"));
    QPushButton* offer = buttonWith(panel, "Use F = ");
    QVERIFY(offer != nullptr);
    offer->click();
    panel.setVerdict(verdictOf(panel.settings()), std::nullopt);
    QVERIFY(test::visibleText(panel).contains("Feasible"));
    QVERIFY(buttonWith(panel, "Use F = ") == nullptr);
    for (const QComboBox* box : panel.findChildren<QComboBox*>()) {
      // The layout is that of the method.
      QCOMPARE(box->isEnabled(), !box->itemText(0).startsWith(QStringLiteral("With gaps")));
    }
  }

  void theTemplateMayComeByHand() {
    widgets::MethodPanel panel;
    auto* const byHand = panel.findChild<QCheckBox*>("by-hand");
    QVERIFY(byHand != nullptr && !byHand->isChecked());
    QSignalSpy changed(&panel, &widgets::MethodPanel::settingsChanged);
    byHand->click();
    QCOMPARE(changed.count(), 1);
    QVERIFY(panel.settings().transferByHand);
    panel.setEditable(false);
    QVERIFY(!byHand->isEnabled());
  }

  void deltaBelongsToMethodPosition() {
    test::Language language;
    MethodPanel panel;
    streaming::StreamSettings settings;
    settings.parameters.method = base::MethodKind::Signal;
    panel.setSettings(settings);
    auto* delta = panel.findChild<QDoubleSpinBox*>("delta");
    QVERIFY(!delta->isEnabled());
    QVERIFY(delta->toolTip().contains("does not use δ"));
    settings.parameters.method = base::MethodKind::Position;
    panel.setSettings(settings);
    QVERIFY(delta->isEnabled());
  }

  void infeasibleOffersAFeedThatIsFeasible_data() {
    QTest::addColumn<bool>("position");
    QTest::newRow("position") << true;
    QTest::newRow("signal") << false;
  }
  void infeasibleOffersAFeedThatIsFeasible() {
    QFETCH(bool, position);
    test::Language language;
    MethodPanel panel;
    streaming::StreamSettings settings;
    settings.parameters.method = position ? base::MethodKind::Position : base::MethodKind::Signal;
    settings.feedMmPerS = base::mmPerSFromMmPerMin(5000.0);
    panel.setSettings(settings);
    panel.setVerdict(verdictOf(settings), std::nullopt);
    QVERIFY(test::visibleText(panel).contains("Not feasible"));
    QVERIFY(test::visibleText(panel).contains("Violated: Equation ("));
    QVERIFY(test::visibleText(panel).contains("line"));
    QPushButton* offer = buttonWith(panel, "Use F = ");
    QVERIFY(offer != nullptr);
    QSignalSpy changes(&panel, &MethodPanel::settingsChanged);
    offer->click();
    QCOMPARE(changes.count(), 1);
    const auto changed = changes.first().first().value<streaming::StreamSettings>();
    QVERIFY(changed.feedMmPerS < settings.feedMmPerS);
    QVERIFY(verdictOf(changed).feasible);
    panel.setVerdict(verdictOf(changed), std::nullopt);
    QVERIFY(!test::visibleText(panel).contains("Not feasible"));
    QVERIFY(buttonWith(panel, "Use F = ") == nullptr);
  }

  void offersALargerDeltaWhereItAloneHelps() {
    test::Language language;
    MethodPanel panel;
    streaming::StreamSettings settings;
    settings.parameters.method = base::MethodKind::Position;
    settings.feedMmPerS = base::mmPerSFromMmPerMin(60.0);
    settings.deltaMm = 0.005;
    panel.setSettings(settings);
    const auto verdict = verdictOf(settings);
    QVERIFY(!verdict.feasible);
    panel.setVerdict(verdict, std::nullopt);
    QPushButton* offer = buttonWith(panel, "Use δ = ");
    QVERIFY(offer != nullptr);
    offer->click();
    QVERIFY(panel.settings().deltaMm > settings.deltaMm);
    QVERIFY(verdictOf(panel.settings()).feasible);
  }

  void offeredFeedsAreBelowTheLimit() {
    for (const double limitMmPerMin : {0.15, 1.0, 12.34, 999.0, 1000.0, 12'345.6}) {
      const auto offer = offeredFeedMmPerS(base::mmPerSFromMmPerMin(limitMmPerMin));
      QVERIFY(offer.has_value());
      QVERIFY(*offer < base::mmPerSFromMmPerMin(limitMmPerMin));
      QVERIFY(*offer > 0.5 * base::mmPerSFromMmPerMin(limitMmPerMin));
    }
    QVERIFY(!offeredFeedMmPerS(0.0).has_value());
    QVERIFY(!offeredFeedMmPerS(std::numeric_limits<double>::infinity()).has_value());
  }

  void problemsAreSaid() {
    test::Language language;
    MethodPanel panel;
    QVERIFY(test::visibleText(panel).contains("Load a program"));
    panel.setVerdict(std::nullopt, QString("N does not fit."));
    QVERIFY(test::visibleText(panel).contains("N does not fit."));
    QVERIFY(test::visibleText(panel).contains("Not judged"));
  }

  void nothingCanBeChangedWhileARunLasts() {
    MethodPanel panel;
    streaming::StreamSettings settings;
    settings.parameters.method = base::MethodKind::Position;
    settings.feedMmPerS = 100.0;
    panel.setSettings(settings);
    panel.setVerdict(verdictOf(settings), std::nullopt);
    panel.setEditable(false);
    for (const QAbstractSpinBox* field : panel.findChildren<QAbstractSpinBox*>()) {
      QVERIFY(!field->isEnabled());
    }
    for (const QPushButton* button : panel.findChildren<QPushButton*>()) {
      QVERIFY(!button->isEnabled() || !button->isVisibleTo(&panel));
    }
  }

  void numbersAreReadAsTyped_data() {
    QTest::addColumn<QString>("language");
    QTest::addColumn<QString>("typed");
    QTest::addColumn<double>("feedMmPerMin");  // 0: refused
    const auto row = [](const char* language, const char* typed, double feedMmPerMin) {
      QTest::addRow("%s %s", language, typed)
          << QString::fromLatin1(language) << QString::fromLatin1(typed) << feedMmPerMin;
    };
    for (const char* language : {"en", "de", "fr", "it", "es"}) {
      for (const char* typed : {"1200.5", "1200,5"}) {
        row(language, typed, 1200.5);
      }
      row(language, "1200", 1200.0);
      for (const char* typed : {"1,200.5", "1.200,5", "120000000", ""}) {
        row(language, typed, 0.0);
      }
    }
    row("en", "1,200", 0.0);
    for (const char* language : {"de", "fr", "it", "es"}) {
      row(language, "1.200", 0.0);
      row(language, "1,200", 1.2);
    }
  }

  /// Point and comma are decimal separators in every language; what could be read in two ways keeps
  /// the former value and says so.
  void numbersAreReadAsTyped() {
    QFETCH(QString, language);
    QFETCH(QString, typed);
    QFETCH(double, feedMmPerMin);
    const test::Language english;
    MethodPanel panel;
    streaming::StreamSettings settings;
    settings.feedMmPerS = 10.0;
    panel.setSettings(settings);
    panel.show();
    inLanguage(panel, language);
    auto* feed = panel.findChild<NumberField*>("feed");
    QVERIFY(feed->text().startsWith("600"));
    QSignalSpy refused(feed, &NumberField::refused);
    feed->selectAll();
    QTest::keyClick(feed, Qt::Key_Delete);
    QTest::keyClicks(feed, typed);
    QTest::keyClick(feed, Qt::Key_Return);
    const bool isRefused = feedMmPerMin == 0.0;
    QCOMPARE(refused.count(), isRefused ? 1 : 0);
    QCOMPARE(base::mmPerMinFromMmPerS(panel.settings().feedMmPerS),
             isRefused ? 600.0 : feedMmPerMin);
    QCOMPARE(feed->value(), isRefused ? 600.0 : feedMmPerMin);
  }

  /// The limit of a typed feed is that of the machine.
  void noFeedAboveTheMachineIsTaken() {
    test::Language language;
    MethodPanel panel;
    panel.setFeedMax(base::mmPerSFromMmPerMin(8000.0));
    streaming::StreamSettings settings;
    settings.feedMmPerS = 10.0;
    panel.setSettings(settings);
    panel.show();
    auto* feed = panel.findChild<NumberField*>("feed");
    QSignalSpy refused(feed, &NumberField::refused);
    feed->selectAll();
    QTest::keyClicks(feed, QStringLiteral("8001"));
    QTest::keyClick(feed, Qt::Key_Return);
    QCOMPARE(refused.count(), 1);
    QVERIFY(refused.first().first().toString().contains("8000"));
    QCOMPARE(base::mmPerMinFromMmPerS(panel.settings().feedMmPerS), 600.0);
  }

  void wholeNumbersAreReadAsTyped_data() {
    QTest::addColumn<QString>("language");
    QTest::addColumn<QString>("typed");
    QTest::addColumn<int>("points");  // 0: refused
    for (const char* language : {"en", "de", "fr", "it", "es"}) {
      const QString code = QString::fromLatin1(language);
      QTest::addRow("%s 1200", language) << code << QStringLiteral("1200") << 1200;
      for (const char* wrong : {"1,200", "1.200", "9.5", "9,0", "12000", "0", "-3", ""}) {
        QTest::addRow("%s %s", language, wrong) << code << QString::fromLatin1(wrong) << 0;
      }
    }
  }
  void wholeNumbersAreReadAsTyped() {
    QFETCH(QString, language);
    QFETCH(QString, typed);
    QFETCH(int, points);
    const test::Language english;
    MethodPanel panel;
    panel.setSettings({});
    panel.show();
    inLanguage(panel, language);
    auto* field = panel.findChild<WholeNumberField*>();
    QSignalSpy refused(field, &WholeNumberField::refused);
    field->selectAll();
    QTest::keyClick(field, Qt::Key_Delete);
    QTest::keyClicks(field, typed);
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(refused.count(), points == 0 ? 1 : 0);
    QCOMPARE(field->value(), points == 0 ? 7 : points);
    QCOMPARE(field->text(), QString::number(field->value()));
    QCOMPARE(panel.settings().parameters.pointsPerLoop, field->value());
  }

  void feedsOfTheProgramHaveAnOverride() {
    test::Language language;
    MethodPanel panel;
    QSignalSpy changes(&panel, &MethodPanel::settingsChanged);
    streaming::StreamSettings settings;
    settings.programFeeds = true;
    panel.setSettings(settings);
    panel.show();
    auto* feed = panel.findChild<NumberField*>("feed");
    auto* factor = panel.findChild<NumberField*>("program-override");
    QVERIFY(!feed->isVisible());
    QVERIFY(factor->isVisible());
    factor->setValue(80.0);
    QCOMPARE(changes.count(), 1);
    QCOMPARE(panel.settings().overrideFactor, 0.8);

    // The block that limits is named, and what it leaves is offered.
    feasibility::Verdict verdict = verdictOf(settings);
    verdict.waits = true;
    verdict.limiting.margin = 0.5;
    panel.setOverrideLimit(
        streaming::OverrideLimit{0.624, {214}, base::mmPerSFromMmPerMin(2000.0), 0.3, false}, 50.0);
    panel.setVerdict(verdict, std::nullopt);
    const QString text = test::visibleText(panel);
    QVERIFY2(text.contains("62") && text.contains("line 214") && text.contains("2,000") &&
                 text.contains("0.300"),
             qPrintable(text));
    QPushButton* offer = buttonWith(panel, QStringLiteral("override = 62"));
    QVERIFY(offer != nullptr);
    offer->click();
    QCOMPARE(panel.settings().overrideFactor, 0.62);
    QVERIFY(panel.settings().programFeeds);
  }

  /// The methods of the paper have one feed; the choice comes back with the other methods.
  void publishedMethodsHaveOneFeed() {
    test::Language language;
    MethodPanel panel;
    streaming::StreamSettings settings;
    settings.programFeeds = true;
    settings.parameters.method = base::MethodKind::Signal;
    panel.setSettings(settings);
    panel.show();
    auto* feed = panel.findChild<NumberField*>("feed");
    auto* factor = panel.findChild<NumberField*>("program-override");
    QVERIFY(feed->isVisible());
    QVERIFY(!factor->isVisible());
    QVERIFY(!panel.settings().usesProgramFeeds());
    feed->setValue(700.0);
    auto* method = panel.findChild<QComboBox*>("method");
    method->setCurrentIndex(0);
    QVERIFY(panel.settings().usesProgramFeeds());
    QVERIFY(factor->isVisible());
  }

  void numbersFollowTheLanguage() {
    test::Language language;
    MethodPanel panel;
    streaming::StreamSettings settings;
    settings.parameters.method = base::MethodKind::Position;
    panel.setSettings(settings);
    language.german();
    QCOMPARE(panel.findChild<QDoubleSpinBox*>("delta")->text(),
             QString("0,300") + QChar(0x00A0) + "mm");
    QVERIFY(test::visibleText(panel).contains("Verfahren"));
  }
};

Q_DECLARE_METATYPE(rivulet::streaming::StreamSettings)
RIVULET_TEST(TestMethodPanel)
#include "tst_method_panel.moc"
