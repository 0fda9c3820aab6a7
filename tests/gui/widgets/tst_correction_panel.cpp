// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QSpinBox>
#include <QTest>
#include <QWheelEvent>

#include "gui/widgets/page_test.h"
#include "support/test_program.h"
#include "widgets/common/status_label.h"
#include "widgets/common/theme.h"
#include "widgets/streaming/correction_panel.h"

using namespace rivulet;
using namespace rivulet::widgets;

Q_DECLARE_METATYPE(rivulet::base::Vec3)
Q_DECLARE_METATYPE(rivulet::widgets::CorrectionInput)

namespace {

struct PanelParts {
  explicit PanelParts(const CorrectionPanel& panel)
      : sliders(panel.findChildren<QSlider*>()),
        zero(panel.findChild<QPushButton*>()),
        source(panel.findChild<QComboBox*>()),
        port(panel.findChild<QSpinBox*>()),
        status(panel.findChild<StatusLabel*>()) {
    for (QDoubleSpinBox* field : panel.findChildren<QDoubleSpinBox*>()) {
      (field->decimals() == 3 ? fields : others).append(field);
    }
  }
  QList<QSlider*> sliders;
  QList<QDoubleSpinBox*> fields;
  QList<QDoubleSpinBox*> others;
  QPushButton* zero;
  QComboBox* source;
  QSpinBox* port;
  StatusLabel* status;
};

}  // namespace

class TestCorrectionPanel : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    test::failOnWarnings();
    applyTheme(Theme::Light);
  }

  void isShownOnlyWhereTheProgramHasIt() {
    QWidget window;
    CorrectionPanel panel(&window);
    window.show();
    QVERIFY(!panel.isVisible());
    panel.setLimit(0.1, {true, false, true});
    QVERIFY(panel.isVisible());
    const PanelParts parts(panel);
    QVERIFY(parts.sliders.at(0)->isVisible());
    QVERIFY(!parts.sliders.at(1)->isVisible() && !parts.fields.at(1)->isVisible());
    panel.setLimit(0.0, {true, true, true});
    QVERIFY(!panel.isVisible());
  }

  void nothingCanBeOrderedWithoutARun() {
    CorrectionPanel panel;
    panel.setLimit(0.1, {true, true, true});
    const PanelParts parts(panel);
    for (QSlider* slider : parts.sliders) {
      QVERIFY(!slider->isEnabled());
    }
    QVERIFY(!parts.zero->isEnabled());
    panel.setRunning(true);
    for (QSlider* slider : parts.sliders) {
      QVERIFY(slider->isEnabled());
    }
    QVERIFY(parts.zero->isEnabled());
  }

  void sliderAndNumberAreOneWithinTheLimit() {
    CorrectionPanel panel;
    panel.setLimit(0.05, {true, true, true});
    panel.setRunning(true);
    const PanelParts parts(panel);
    QSignalSpy asked(&panel, &CorrectionPanel::correctionRequested);
    parts.sliders.at(0)->setValue(20);
    QCOMPARE(asked.count(), 1);
    QCOMPARE(asked.last().at(0).value<base::Vec3>(), (base::Vec3{0.02, 0.0, 0.0}));
    QCOMPARE(parts.fields.at(0)->value(), 0.02);
    parts.fields.at(2)->setValue(-0.031);
    QCOMPARE(asked.count(), 2);
    QCOMPARE(asked.last().at(0).value<base::Vec3>(), (base::Vec3{0.02, 0.0, -0.031}));
    QCOMPARE(parts.sliders.at(2)->value(), -31);
    parts.sliders.at(1)->setValue(1000);
    parts.fields.at(1)->setValue(7.0);
    QCOMPARE(asked.last().at(0).value<base::Vec3>().y, 0.05);
    QCOMPARE(asked.count(), 3);  // the number did not change any more
    parts.zero->click();
    QCOMPARE(asked.last().at(0).value<base::Vec3>(), base::Vec3{});
    QCOMPARE(parts.sliders.at(1)->value(), 0);
    // A run begins with nothing, whatever the one before ended with.
    parts.sliders.at(0)->setValue(20);
    panel.setRunning(false);
    panel.setRunning(true);
    QCOMPARE(parts.sliders.at(0)->value(), 0);
    QCOMPARE(parts.fields.at(0)->value(), 0.0);
  }

  /// Half a number is no order, and a wheel that scrolls the column is none either.
  void onlyWhatIsMeantIsOrdered() {
    CorrectionPanel panel;
    panel.setLimit(0.5, {true, true, true});
    panel.setRunning(true);
    panel.show();
    const PanelParts parts(panel);
    QSignalSpy asked(&panel, &CorrectionPanel::correctionRequested);
    QWheelEvent wheel(QPointF(5, 5), QPointF(5, 5), QPoint(), QPoint(0, 120), Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    for (QWidget* widget :
         {static_cast<QWidget*>(parts.sliders.at(0)), static_cast<QWidget*>(parts.fields.at(0))}) {
      QCoreApplication::sendEvent(widget, &wheel);
    }
    QCOMPARE(asked.count(), 0);
    parts.fields.at(0)->setFocus();
    parts.fields.at(0)->selectAll();
    QTest::keyClicks(parts.fields.at(0), QLocale().toString(0.4, 'f', 1));
    QCOMPARE(asked.count(), 0);
    QTest::keyClick(parts.fields.at(0), Qt::Key_Return);
    QCOMPARE(asked.count(), 1);
    QCOMPARE(asked.last().at(0).value<base::Vec3>().x, 0.4);
  }

  void confirmedIsWhatTheControlHas() {
    test::Language language;
    CorrectionPanel panel;
    panel.setLimit(0.1, {true, true, true});
    panel.setRunning(true);
    panel.show();
    QVERIFY(!test::visibleText(panel).contains(QStringLiteral("0.025")));
    panel.setCorrection(streaming::Correction{{0.05, 0.0, 0.0}, {0.025, 0.0, 0.0}});
    QVERIFY(test::visibleText(panel).contains(QStringLiteral("0.025")));
    const PanelParts parts(panel);
    QCOMPARE(parts.sliders.at(0)->value(), 0);  // the hand has asked for nothing
  }

  void aSourceTakesTheHandsPlaceAndGivesItBackWithoutAJump() {
    test::Language language;
    CorrectionPanel panel;
    panel.setLimit(0.1, {true, true, true});
    panel.setRunning(true);
    panel.show();
    const PanelParts parts(panel);
    QSignalSpy asked(&panel, &CorrectionPanel::correctionRequested);
    QSignalSpy input(&panel, &CorrectionPanel::inputChanged);
    parts.source->setCurrentIndex(1);
    QCOMPARE(input.count(), 1);
    QVERIFY(panel.input().isLive && input.last().at(0).value<CorrectionInput>().isLive);
    QVERIFY(parts.port->isVisible() && !parts.sliders.at(0)->isEnabled());
    panel.setLiveSource({true, false, false, 0});
    QCOMPARE(parts.status->status(), Status::Busy);
    panel.setLiveSource({true, true, false, 0});
    QCOMPARE(parts.status->status(), Status::Good);
    panel.setCorrection(streaming::Correction{{0.06, -0.02, 0.0}, {0.06, -0.02, 0.0}});
    QCOMPARE(parts.sliders.at(0)->value(), 60);
    // It falls silent: nothing is asked, and it is said.
    panel.setLiveSource({true, true, true, 0});
    QCOMPARE(parts.status->status(), Status::Attention);
    QVERIFY(parts.status->text().contains(QStringLiteral("held")));
    QCOMPARE(parts.sliders.at(0)->value(), 60);
    panel.setLiveSource({true, true, false, 3});
    QCOMPARE(parts.status->status(), Status::Attention);
    panel.setLiveSource({false, false, false, 0});
    QCOMPARE(parts.status->status(), Status::Fault);
    QCOMPARE(asked.count(), 0);
    // Back to the hand: it is where the source was.
    parts.source->setCurrentIndex(0);
    QCOMPARE(asked.count(), 0);
    QCOMPARE(parts.sliders.at(0)->value(), 60);
    QVERIFY(parts.sliders.at(0)->isEnabled() && !parts.port->isVisible());
    parts.sliders.at(2)->setValue(10);
    QCOMPARE(asked.last().at(0).value<base::Vec3>(), (base::Vec3{0.06, -0.02, 0.01}));
  }

  void zeroTakesTheSourceAway() {
    CorrectionPanel panel;
    panel.setLimit(0.1, {true, true, true});
    panel.setRunning(true);
    const PanelParts parts(panel);
    parts.source->setCurrentIndex(1);
    parts.port->setValue(50000);
    parts.others.at(0)->setValue(5.0);
    QCOMPARE(panel.input(), (CorrectionInput{true, 50000, 5.0}));
    panel.setCorrection(streaming::Correction{{0.06, 0.0, 0.0}, {0.06, 0.0, 0.0}});
    QSignalSpy asked(&panel, &CorrectionPanel::correctionRequested);
    parts.zero->click();
    QVERIFY(!panel.input().isLive);
    QCOMPARE(asked.count(), 1);
    QCOMPARE(asked.last().at(0).value<base::Vec3>(), base::Vec3{});
  }
};

RIVULET_TEST(TestCorrectionPanel)
#include "tst_correction_panel.moc"
