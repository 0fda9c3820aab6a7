// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include "gui/widgets/page_test.h"
#include "gui/widgets/samples.h"
#include "widgets/common/theme.h"
#include "widgets/program/path_canvas.h"
#include "widgets/program/path_view.h"

using namespace rivulet;
using namespace rivulet::widgets;

namespace {

int pixelsOf(const QImage& image, const QColor& color) {
  int count = 0;
  for (int y = 40; y < image.height() - 40; ++y) {  // between legend and scale bar
    for (int x = 0; x < image.width(); ++x) {
      count += image.pixelColor(x, y) == color ? 1 : 0;
    }
  }
  return count;
}

}  // namespace

class TestPathView : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    test::failOnWarnings();
    applyTheme(Theme::Light);
  }

  void executedPartGrowsAndShrinks() {
    PathCanvas canvas;
    const auto program = test::pocket();
    canvas.setProgram(program);
    const auto points = test::streamed(*program);
    canvas.setPoints(points);
    const QColor accent = themeColors(canvas.palette()).accent;
    QCOMPARE(pixelsOf(test::picture(canvas, {500, 400}), accent), 0);
    canvas.setExecuted(points.size() / 3);
    const int third = pixelsOf(test::picture(canvas, {500, 400}), accent);
    QVERIFY(third > 0);
    canvas.setExecuted(points.size());
    const int all = pixelsOf(test::picture(canvas, {500, 400}), accent);
    QVERIFY2(all > third, qPrintable(QString("%1 %2").arg(all).arg(third)));
    canvas.setExecuted(points.size() / 3);
    QCOMPARE(pixelsOf(test::picture(canvas, {500, 400}), accent), third);
  }

  void growingIsTheSameAsDrawingAtOnce() {
    const auto program = test::pocket();
    const auto points = test::streamed(*program);
    PathCanvas once;
    once.setProgram(program);
    once.setPoints(points);
    once.setExecuted(600);
    PathCanvas grown;
    grown.setProgram(program);
    grown.setPoints(points);
    for (std::size_t count = 0; count <= 600; count += 100) {
      grown.setExecuted(count);
      static_cast<void>(test::picture(grown, {500, 400}));
    }
    const QColor accent = themeColors(once.palette()).accent;
    const int expected = pixelsOf(test::picture(once, {500, 400}), accent);
    const int found = pixelsOf(test::picture(grown, {500, 400}), accent);
    // Seams between the pieces may differ by a few pixels of their round ends.
    QVERIFY2(std::abs(expected - found) < expected / 20,
             qPrintable(QString("%1 %2").arg(expected).arg(found)));
  }

  void toolIsShown() {
    PathCanvas canvas;
    canvas.setProgram(test::pocket());
    const QImage without = test::picture(canvas, {500, 400});
    canvas.setToolPosition(base::Vec3{5.0, 5.0, 0.0});
    const QImage with = test::picture(canvas, {500, 400});
    QVERIFY(with != without);
    canvas.setToolPosition(std::nullopt);
    QCOMPARE(test::picture(canvas, {500, 400}), without);
  }

  void manyPointsAreThinnedToTheScreen() {
    PathCanvas canvas;
    canvas.setPoints(test::manyPoints(300'000));
    static_cast<void>(test::picture(canvas, {800, 600}));
    QVERIFY(canvas.drawnVertices() > 1000);
    QVERIFY2(canvas.drawnVertices() < 300'000, qPrintable(QString::number(canvas.drawnVertices())));
    // Magnified, only what is in sight is drawn.
    for (int step = 0; step < 12; ++step) {
      QWheelEvent wheel({400, 300}, {400, 300}, {}, {0, 480}, Qt::NoButton, Qt::NoModifier,
                        Qt::NoScrollPhase, false);
      QCoreApplication::sendEvent(&canvas, &wheel);
    }
    static_cast<void>(test::picture(canvas, {800, 600}));
    QVERIFY(canvas.drawnVertices() < 3000);
  }

  void viewsDiffer() {
    PathView view;
    view.setProgram(test::pocket());
    const QImage top = test::picture(view, {500, 400});
    view.setIsometric(true);
    QVERIFY(test::picture(view, {500, 400}) != top);
    view.setIsometric(false);
    QCOMPARE(test::picture(view, {500, 400}), top);
  }

  void emptyAndSinglePointsAreHarmless() {
    PathView view;
    view.setProgram(nullptr);
    QVERIFY(test::colourCount(test::picture(view, {500, 400})) > 5);
    view.setPoints({{{1.0, 2.0, 3.0}, base::LineNumber{1}}});
    view.setExecuted(7);
    QVERIFY(test::colourCount(test::picture(view, {500, 400})) > 5);
  }
};

QTEST_MAIN(TestPathView)
#include "tst_path_view.moc"
