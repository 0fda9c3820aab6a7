// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QComboBox>
#include <QElapsedTimer>
#include <QLineF>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QWheelEvent>
#include <algorithm>

#include "feasibility/equations.h"
#include "gui/widgets/page_test.h"
#include "gui/widgets/samples.h"
#include "support/test_program.h"
#include "widgets/common/theme.h"
#include "widgets/program/path_canvas.h"
#include "widgets/program/path_view.h"
#include "widgets/program/thin_line.h"

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

void show(PathCanvas& canvas, const std::shared_ptr<const overview::ProgramView>& view) {
  canvas.setProgram(view);
  const ThemeColors& colors = themeColors(canvas.palette());
  canvas.setStyle({view->kinds,
                   {QPen(colors.rapid), QPen(colors.path), QPen(colors.path), QPen(colors.path)}});
}

void turnWheel(PathCanvas& canvas, QPointF place, int angle) {
  QWheelEvent wheel(place, place, {}, {0, angle}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                    false);
  QCoreApplication::sendEvent(&canvas, &wheel);
}

void drag(PathCanvas& canvas, QPoint from, QPoint to) {
  QTest::mousePress(&canvas, Qt::LeftButton, {}, from);
  QMouseEvent move(QEvent::MouseMove, to, canvas.mapToGlobal(to), Qt::NoButton, Qt::LeftButton,
                   Qt::NoModifier);
  QCoreApplication::sendEvent(&canvas, &move);
  QTest::mouseRelease(&canvas, Qt::LeftButton, {}, to);
}

std::size_t nearest(const overview::ProgramView& view, base::Vec3 place) {
  const auto& points = view.points.points;
  const auto found =
      std::min_element(points.begin(), points.end(), [&](const auto& a, const auto& b) {
        return base::distance(a.positionMm, place) < base::distance(b.positionMm, place);
      });
  return static_cast<std::size_t>(found - points.begin());
}

}  // namespace

class TestPathView : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    test::failOnWarnings();
    applyTheme(Theme::Light);
  }

  /// What the control moves between two stretches is drawn apart from the path, and never as
  /// executed; the first point with another tool is marked.
  void aJobIsSeenOnThePath() {
    PathView view;
    const auto job = test::jobView();
    view.setProgram(job);
    const QColor native = themeColors(view.palette()).native;
    const int without = pixelsOf(test::picture(view, {700, 600}), native);
    QVERIFY(without > 40);
    view.setExecuted(job->points.points.size());
    QVERIFY(pixelsOf(test::picture(view, {700, 600}), native) > without / 2);
    view.setColouring(overview::PathColouring::Feed);
    QVERIFY(pixelsOf(test::picture(view, {700, 600}), native) > without / 2);
    view.setProgram(test::viewOf(test::pocket()));
    QCOMPARE(pixelsOf(test::picture(view, {700, 600}), native), 0);
  }

  void executedPartGrowsAndShrinks() {
    PathCanvas canvas;
    const auto program = test::pocket();
    const auto view = test::viewOf(program);
    show(canvas, view);
    const auto& points = view->points.points;
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
    PathCanvas once;
    show(once, test::viewOf(program));
    once.setExecuted(600);
    PathCanvas grown;
    show(grown, test::viewOf(program));
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

  /// Two kinds of marks that differ without colour; gone with the switch, and with the program.
  void pausesAreMarked() {
    test::Language language;
    PathView view;
    const auto program = test::viewOf(test::pocket());
    view.setProgram(program);
    const QImage without = test::picture(view, {560, 620});
    auto pauses = std::make_shared<overview::PauseMap>();
    const auto corner = [&](double xMm, double yMm) {
      return static_cast<std::uint32_t>(nearest(*program, {xMm, yMm, -2.0}));
    };
    std::uint32_t offCut = corner(-30.0, 20.0);
    std::uint32_t other = corner(30.0, 20.0);
    const std::uint32_t inCut = corner(-30.0, -20.0);
    if (other < offCut) {
      std::swap(offCut, other);
    }
    pauses->offCut = {offCut, other};
    pauses->inCut = {inCut};
    view.setPauses(pauses);
    const QImage with = test::picture(view, {560, 620});
    QVERIFY(with != without);
    QCOMPARE(view.canvas()->drawnPauses(), std::size_t{3});
    QVERIFY(test::cutTexts(view).isEmpty());
    const auto around = [&](std::size_t point) {
      const QImage picture =
          view.canvas()->grab().toImage().convertToFormat(QImage::Format_Grayscale8);
      const QPoint place = view.canvas()->placeOf(point).toPoint();
      return picture.copy(place.x() - 3, place.y() - 7, 7, 4);
    };
    // Above its middle the square is empty, the triangle's tip is full.
    QVERIFY(around(offCut) != around(inCut));
    const QPointF place = view.canvas()->placeOf(inCut);
    const auto near = view.canvas()->pauseNear(place + QPointF(3.0, 2.0));
    QVERIFY(near && near->point == inCut && near->inCut);
    QVERIFY(!view.canvas()->pauseNear({2.0, 2.0}));
    view.markPoint(inCut);
    QVERIFY(test::visibleText(view).contains("then a pause in the cut"));
    view.markPoint(offCut);
    QVERIFY(test::visibleText(view).contains("then a pause off the cut"));
    view.markPoint(offCut + 1);
    QVERIFY(!test::visibleText(view).contains("then a pause"));
    view.setPausesShown(false);
    QVERIFY(!view.canvas()->pauseNear(place));
    view.setPausesShown(true);
    QVERIFY(view.canvas()->pauseNear(place));
    view.setProgram(test::viewOf(test::pocket()));
    QVERIFY(!view.canvas()->pauseNear(place));
    // Points that are not there: the pauses of another program.
    auto beyond = std::make_shared<overview::PauseMap>();
    beyond->inCut = {1'000'000};
    view.setPauses(beyond);
    static_cast<void>(test::picture(view, {560, 620}));
    QVERIFY(!view.canvas()->pauseNear(place));
  }

  /// A million pauses: what is examined and drawn is bounded, and close up each is there.
  void manyPausesAreThinnedToTheScreen() {
    PathCanvas canvas;
    const auto view = test::viewOf(test::programOf(test::manyPoints(1'000'000)));
    show(canvas, view);
    auto pauses = std::make_shared<overview::PauseMap>();
    for (std::uint32_t i = 0; i < 999'999; ++i) {
      (i % 10 == 0 ? pauses->inCut : pauses->offCut).push_back(i);
    }
    canvas.setPauses(pauses);
    static_cast<void>(test::picture(canvas, {800, 600}));
    QVERIFY(canvas.drawnPauses() > 50);
    QVERIFY2(canvas.drawnPauses() < 2000, qPrintable(QString::number(canvas.drawnPauses())));
    QVERIFY(canvas.pausesSeen() <= 2 * (PathCanvas::kPausesSeen + 1));
    // Magnified until single moves can be seen.
    for (int step = 0; step < 12; ++step) {
      turnWheel(canvas, canvas.placeOf(500'000), 480);
    }
    static_cast<void>(test::picture(canvas, {800, 600}));
    QVERIFY(canvas.drawnPauses() > 0);
    const auto near = canvas.pauseNear(canvas.placeOf(500'000));
    QVERIFY(near && near->point == 500'000 && near->inCut);
    // Made anew, they take a moment of the GUI thread.
    QElapsedTimer clock;
    clock.start();
    canvas.setPauses(pauses);
    static_cast<void>(canvas.grab());
    qInfo("1,000,000 pauses: their picture took %lld ms", clock.elapsed());
  }

  void toolIsShown() {
    PathCanvas canvas;
    show(canvas, test::viewOf(test::pocket()));
    const QImage without = test::picture(canvas, {500, 400});
    canvas.setToolPosition(base::Vec3{5.0, 5.0, 0.0});
    const QImage with = test::picture(canvas, {500, 400});
    QVERIFY(with != without);
    canvas.setToolPosition(std::nullopt);
    QCOMPARE(test::picture(canvas, {500, 400}), without);
  }

  void manyPointsAreThinnedToTheScreen() {
    PathCanvas canvas;
    show(canvas, test::viewOf(test::programOf(test::manyPoints(300'000))));
    static_cast<void>(test::picture(canvas, {800, 600}));
    QVERIFY(canvas.drawnMoves() > 1000);
    QTRY_VERIFY(canvas.isFine());
    QVERIFY2(canvas.drawnMoves() < 300'000, qPrintable(QString::number(canvas.drawnMoves())));
    // Magnified, only what is in sight is drawn.
    for (int step = 0; step < 12; ++step) {
      turnWheel(canvas, {400, 300}, 480);
    }
    static_cast<void>(test::picture(canvas, {800, 600}));
    QVERIFY(canvas.drawnMoves() < 3000);
  }

  /// Whatever is done with a path of a million points that no level can make small: no frame and
  /// no slice of the fine picture draws more than its share.
  void noFrameDrawsMoreThanItsShare() {
    auto points = test::manyPoints(1'000'000);
    for (std::size_t i = 0; i < points.size(); ++i) {
      // Noise of a tenth of a millimetre: nothing lies on a line.
      points[i].positionMm.z = 0.1 * static_cast<double>((i * 2'654'435'761U) % 1000U) / 1000.0;
    }
    const auto view = test::viewOf(test::programOf(points));
    PathCanvas canvas;
    canvas.resize(1000, 700);
    show(canvas, view);
    canvas.show();
    QElapsedTimer clock;
    double slowestMs = 0.0;
    int frames = 0;
    const auto frame = [&] {
      clock.start();
      static_cast<void>(canvas.grab());
      slowestMs = std::max(slowestMs, static_cast<double>(clock.nsecsElapsed()) * 1e-6);
      ++frames;
      const std::size_t most = canvas.takeMostAtOnce();
      QVERIFY2(most <= PathCanvas::kFrameMoves, qPrintable(QString::number(most)));
    };
    for (const auto projection : {PathCanvas::View::Top, PathCanvas::View::Space}) {
      canvas.setView(projection);
      frame();
      for (int step = 0; step < 10; ++step) {
        turnWheel(canvas, {420, 260}, 120);
        frame();
        drag(canvas, {500, 300}, {520, 310});
        frame();
      }
      canvas.fit();
      canvas.setExecuted(700'000);
      frame();
    }
    qInfo("1,000,000 points: the slowest of %d frames took %.1f ms", frames, slowestMs);
    // At rest the fine picture is made, in slices that keep to their share as well.
    QTRY_VERIFY_WITH_TIMEOUT(canvas.isFine(), 20'000);
    const std::size_t most = canvas.takeMostAtOnce();
    QVERIFY2(most <= PathCanvas::kFrameMoves, qPrintable(QString::number(most)));
    QVERIFY(canvas.drawnMoves() > PathCanvas::kPathMoves);
  }

  void clicksChooseTheNearestPoint() {
    const auto view = test::viewOf(test::pocket());
    PathView page;
    page.setProgram(view);
    static_cast<void>(test::picture(page, {600, 600}));
    PathCanvas* canvas = page.canvas();
    QSignalSpy chosen(&page, &PathView::pointChosen);
    // A corner of the contour, where no other move is near.
    const std::size_t corner = nearest(*view, {-30.0, 20.0, -2.0});
    const QPoint place = canvas->placeOf(corner).toPoint();
    QTest::mouseClick(canvas, Qt::LeftButton, {}, place);
    QCOMPARE(chosen.count(), 1);
    QCOMPARE(chosen.first().first().value<std::size_t>(), corner);
    QCOMPARE(page.slider()->value(), static_cast<int>(corner));
    // Beside the path nothing is chosen; dragging chooses nothing either.
    QTest::mouseClick(canvas, Qt::LeftButton, {}, {3, 3});
    drag(*canvas, place, place + QPoint(40, 0));
    QCOMPARE(chosen.count(), 1);
    // Every point is found where it is drawn, or one drawn at the same place.
    for (std::size_t i = 0; i < view->points.points.size(); i += 53) {
      const auto found = canvas->pointNear(canvas->placeOf(i));
      QVERIFY(found.has_value());
      QVERIFY(QLineF(canvas->placeOf(*found), canvas->placeOf(i)).length() < 1.5);
    }
  }

  void theSliderWalksByPointAndByTime() {
    const auto view = test::viewOf(test::pocket());
    PathView page;
    page.setProgram(view);
    static_cast<void>(test::picture(page, {600, 600}));
    QSignalSpy chosen(&page, &PathView::pointChosen);
    const int last = static_cast<int>(view->points.points.size()) - 1;
    QCOMPARE(page.slider()->maximum(), last);
    page.slider()->setValue(17);
    QCOMPARE(chosen.last().first().value<std::size_t>(), std::size_t{17});
    QVERIFY(test::visibleText(page).contains("Point 18 of "));
    auto* scale = page.findChildren<QComboBox*>().last();
    page.setTimes(test::timesOf(*view));
    scale->setCurrentIndex(1);
    QCOMPARE(page.slider()->maximum(), last * 100);
    QCOMPARE(page.slider()->value(), 1700);
    page.slider()->setValue(2950);
    QCOMPARE(chosen.last().first().value<std::size_t>(), std::size_t{30});
    // Times of another program are none.
    page.setProgram(test::viewOf(test::brokenProgram()));
    page.setTimes(test::timesOf(*view));
    QVERIFY(page.slider()->maximum() < 10);
  }

  void aMarkedPointComesIntoSight() {
    const auto view = test::viewOf(test::pocket());
    PathView page;
    page.setProgram(view);
    static_cast<void>(test::picture(page, {600, 600}));
    PathCanvas* canvas = page.canvas();
    for (int step = 0; step < 12; ++step) {
      turnWheel(*canvas, {10, 10}, 240);
    }
    const std::size_t corner = nearest(*view, {20.0, 20.0, -2.0});
    QVERIFY(!canvas->rect().contains(canvas->placeOf(corner).toPoint()));
    page.selectPoints({static_cast<std::uint32_t>(corner)});
    QVERIFY(canvas->rect().contains(canvas->placeOf(corner).toPoint()));
  }

  void coloursFollowWhatTheyMean() {
    test::Language language;
    const auto view = test::viewOf(test::pocket());
    // By kind as the trajectory says.
    const overview::PathClasses kinds = overview::classesByKind(*view);
    const overview::PathClasses feeds = overview::classesByFeed(*view);
    QVERIFY(feeds.eachFeedItsOwn);
    QCOMPARE(feeds.borders.size(), std::size_t{3});  // F250 F500 F800
    for (std::size_t i = 0; i < view->points.points.size(); ++i) {
      const bool isRapid = view->points.points[i].kind == gcode::MoveKind::Rapid;
      QCOMPARE(kinds.ofPoint[i] == 0, isRapid);
      QCOMPARE(feeds.ofPoint[i] == 0, isRapid);
      if (!isRapid) {
        QCOMPARE(static_cast<float>(feeds.borders[feeds.ofPoint[i] - 1U]),
                 view->programmedMmPerS(i));
      }
    }
    // The smallest margin of the moves is the margin of the verdict.
    for (const auto method : {base::MethodKind::Position, base::MethodKind::Signal}) {
      feasibility::OperatingPoint point;
      point.method = method;
      point.feedMmPerS = 60.0;
      const auto margins = overview::localMargins(*view, point);
      const auto distances =
          feasibility::programDistances(view->points.points, point.pointsPerLoop);
      const auto verdict = feasibility::judge(point, distances).value();
      const double least = *std::min_element(margins.begin(), margins.end());
      const double expected = verdict.conditions.front().margin;
      QVERIFY2(std::abs(least - expected) < 1e-5 * expected,
               qPrintable(QString("%1 %2").arg(least).arg(expected)));
      QCOMPARE(margins.size(), view->points.points.size());
      const overview::PathClasses classes = overview::classesByMargin(*view, point);
      const auto worst = *std::max_element(classes.ofPoint.begin(), classes.ofPoint.end());
      QCOMPARE(worst == 3, expected <= 1.0);
    }
    // With window it is the reach of the shortest window of M steps.
    feasibility::OperatingPoint window;
    window.method = base::MethodKind::Window;
    window.pointsPerLoop = 3;
    window.feedMmPerS = 60.0;
    const auto reaches = overview::localMargins(*view, window);
    const double shortestMm =
        feasibility::programDistances(view->points.points, 6).windowLengthMmMin;
    const double reach =
        feasibility::reachMargin(60.0, feasibility::AccessModel{}.accessTime, 3, shortestMm, 1.0);
    QVERIFY(std::abs(*std::min_element(reaches.begin(), reaches.end()) - reach) < 1e-5 * reach);
    const overview::PathClasses times = overview::classesByTime({0.0F, 1.0F, 2.0F, 3.0F, 5.0F});
    QCOMPARE(times.ofPoint, (std::vector<std::uint8_t>{0, 1, 2, 3, 4}));
    PathView page;
    page.setProgram(view);
    QList<QImage> pictures;
    for (const auto colouring : {overview::PathColouring::Kind, overview::PathColouring::Feed,
                                 overview::PathColouring::Margin, overview::PathColouring::Time}) {
      page.setColouring(colouring);
      page.setTimes(test::timesOf(*view));
      pictures.append(test::picture(page, {600, 600}));
      for (int before = 0; before + 1 < pictures.size(); ++before) {
        QVERIFY(pictures[before] != pictures.last());
      }
    }
  }

  /// Where pauses are close to each other, the class is higher; after the last one there is none.
  void pausesAreShownByTheirDensity() {
    const auto view = test::viewOf(test::programOf(test::manyPoints(1000)));
    overview::PauseMap pauses;
    for (std::uint32_t point = 10; point < 200; point += 10) {
      pauses.inCut.push_back(point);
    }
    for (std::uint32_t point = 300; point < 900; point += 100) {
      pauses.offCut.push_back(point);
    }
    const overview::PathClasses classes = overview::classesByPauses(*view, &pauses);
    QCOMPARE(classes.ofPoint.size(), view->points.points.size());
    QCOMPARE(classes.borders.size(), overview::kPauseClasses + 1);
    QVERIFY(std::is_sorted(classes.borders.rbegin(), classes.borders.rend()));
    QVERIFY(classes.ofPoint[100] > classes.ofPoint[500]);
    QVERIFY(classes.ofPoint[500] >= 1);
    QCOMPARE(classes.ofPoint[950], std::uint8_t{0});
    QCOMPARE(overview::classesByPauses(*view, nullptr).count, overview::kPauseClasses + 1);
    const auto shown = std::make_shared<overview::PauseMap>(pauses);
    PathView page;
    page.setProgram(view);
    page.setColouring(overview::PathColouring::Pauses);
    const QImage without = test::picture(page, {600, 600});
    page.setPauses(shown);
    QVERIFY(test::picture(page, {600, 600}) != without);
  }

  /// What has been executed is blue; no class of the feed may be.
  void feedAndExecutedShareNoColour() {
    auto program = std::make_shared<gcode::Program>(*test::programOf(test::manyPoints(100)));
    for (std::size_t i = 0; i < 100; ++i) {
      program->trajectory.points[i].feedMmPerS = static_cast<double>(1 + i % 5);
    }
    for (const Theme theme : {Theme::Light, Theme::Dark}) {
      applyTheme(theme);
      PathView page;
      page.setProgram(test::viewOf(program));
      page.setColouring(overview::PathColouring::Feed);
      const int executed = themeColors(page.palette()).accent.hue();
      for (const QPen& pen : page.pens()) {
        const int apart = std::abs(pen.color().hue() - executed);
        QVERIFY2(std::min(apart, 360 - apart) > 50, qPrintable(pen.color().name()));
      }
    }
    applyTheme(Theme::Light);
  }

  /// Many feeds fall in classes that cover them all.
  void manyFeedsBecomeClasses() {
    auto program = std::make_shared<gcode::Program>(*test::programOf(test::manyPoints(100)));
    for (std::size_t i = 0; i < 100; ++i) {
      program->trajectory.points[i].feedMmPerS = i == 0 ? 0.0 : static_cast<double>(i);
    }
    const overview::PathClasses feeds = overview::classesByFeed(*test::viewOf(program));
    QVERIFY(!feeds.eachFeedItsOwn);
    QCOMPARE(feeds.borders.size(), overview::kFeedClassesMax + 1);
    QCOMPARE(feeds.borders.front(), 1.0);
    QCOMPARE(feeds.borders.back(), 99.0);
    for (std::size_t i = 2; i < 99; ++i) {
      const std::size_t one = feeds.ofPoint[i];
      QVERIFY(one >= 1 && one < feeds.count);
      QVERIFY(static_cast<double>(i) >= feeds.borders[one - 1] - 1e-9);
      QVERIFY(static_cast<double>(i) <= feeds.borders[one] + 1e-9);
    }
  }

  void thinLinesAreWhereTheyBelong_data() {
    QTest::addColumn<QLineF>("line");
    QTest::newRow("flat") << QLineF(2.5, 10.5, 30.5, 14.5);
    QTest::newRow("steep") << QLineF(20.5, 38.5, 12.5, 3.5);
    QTest::newRow("point") << QLineF(7.5, 7.5, 7.5, 7.5);
    QTest::newRow("across") << QLineF(-300.0, -180.0, 420.0, 260.0);
    QTest::newRow("leaves right") << QLineF(30.0, 5.0, 900.0, 300.0);
    QTest::newRow("enters from above") << QLineF(10.0, -1e6, 12.0, 20.0);
    QTest::newRow("outside") << QLineF(-10.0, 50.0, 60.0, 45.0);
    QTest::newRow("far outside") << QLineF(-1e9, -1e9, -1e9, 1e9);
    QTest::newRow("right border") << QLineF(50.0, 0.0, 50.0, 40.0);
  }
  void thinLinesAreWhereTheyBelong() {
    QFETCH(QLineF, line);
    QImage picture(50, 40, QImage::Format_RGB32);
    picture.fill(Qt::white);
    drawThinLine(picture, line.p1(), line.p2(), qRgb(0, 0, 0));
    int drawn = 0;
    for (int y = 0; y < 40; ++y) {
      for (int x = 0; x < 50; ++x) {
        if (picture.pixel(x, y) == qRgb(0, 0, 0)) {
          ++drawn;
          // The line passes through the pixel or its neighbour.
          const QRectF around(x - 1.0, y - 1.0, 3.0, 3.0);
          bool passes = around.contains(line.p1()) || around.contains(line.p2());
          for (const QLineF& side : {QLineF(around.topLeft(), around.topRight()),
                                     QLineF(around.topRight(), around.bottomRight()),
                                     QLineF(around.bottomRight(), around.bottomLeft()),
                                     QLineF(around.bottomLeft(), around.topLeft())}) {
            passes = passes || side.intersects(line, nullptr) == QLineF::BoundedIntersection;
          }
          QVERIFY2(passes, qPrintable(QString("%1 %2").arg(x).arg(y)));
        }
      }
    }
    // And it is whole: as many pixels as columns or rows it crosses within the picture.
    int crossed = 0;
    const bool isFlat = std::abs(line.dx()) >= std::abs(line.dy());
    for (int at = 0; at < (isFlat ? 50 : 40); ++at) {
      const double centre = at + 0.5;
      const double from = isFlat ? line.x1() : line.y1();
      const double way = isFlat ? line.dx() : line.dy();
      const double share = way == 0.0 ? -1.0 : (centre - from) / way;
      if (share >= 0.0 && share <= 1.0) {
        const double other = isFlat ? line.y1() + share * line.dy() : line.x1() + share * line.dx();
        crossed += other >= 0.0 && other < (isFlat ? 40.0 : 50.0) ? 1 : 0;
      }
    }
    QVERIFY2(std::abs(drawn - crossed) <= 2, qPrintable(QString("%1 %2").arg(drawn).arg(crossed)));
  }

  void viewsDiffer() {
    PathView view;
    view.setProgram(test::viewOf(test::pocket()));
    view.setView(PathCanvas::View::Top);
    const QImage top = test::picture(view, {500, 400});
    QImage before = top;
    for (const PathCanvas::View other :
         {PathCanvas::View::Space, PathCanvas::View::Front, PathCanvas::View::Side}) {
      view.setView(other);
      const QImage seen = test::picture(view, {500, 400});
      QVERIFY(seen != top && seen != before);
      before = seen;
    }
    view.setView(PathCanvas::View::Top);
    QCOMPARE(test::picture(view, {500, 400}), top);
  }

  /// Dragging and arrows turn the space and move a plane; the middle of the path stays in sight.
  void theSpaceTurnsAndPlanesMove() {
    PathCanvas canvas;
    canvas.resize(600, 500);
    canvas.setProgram(test::viewOf(test::pocket()));
    static_cast<void>(test::picture(canvas, {600, 500}));
    const auto angles = canvas.angles();
    const QPointF before = canvas.placeOf(100);
    drag(canvas, {300, 250}, {340, 230});
    QVERIFY(canvas.angles() == angles);
    QCOMPARE((canvas.placeOf(100) - before).toPoint(), QPoint(40, -20));
    canvas.setView(PathCanvas::View::Space);
    const auto seen = canvas.angles();
    drag(canvas, {300, 250}, {340, 230});
    QVERIFY(std::abs(canvas.angles().turnDeg - (seen.turnDeg - 20.0)) < 1e-9);
    QVERIFY(std::abs(canvas.angles().tiltDeg - (seen.tiltDeg - 10.0)) < 1e-9);
    QTest::keyClick(&canvas, Qt::Key_Left);
    QVERIFY(std::abs(canvas.angles().turnDeg - (seen.turnDeg - 15.0)) < 1e-9);
    for (int step = 0; step < 100; ++step) {
      QTest::keyClick(&canvas, Qt::Key_Down);
      QTest::keyClick(&canvas, Qt::Key_Right);
    }
    QCOMPARE(canvas.angles().tiltDeg, 90.0);
    int inSight = 0;
    for (std::size_t point = 0; point < 700; ++point) {
      inSight += QRectF(canvas.rect()).contains(canvas.placeOf(point)) ? 1 : 0;
    }
    QVERIFY2(inSight > 650, qPrintable(QString::number(inSight)));
    QTest::keyClick(&canvas, Qt::Key_Home);
    QVERIFY(canvas.angles() == seen);
  }

  void emptyAndSinglePointsAreHarmless() {
    PathView view;
    view.setProgram(nullptr);
    QVERIFY(test::colourCount(test::picture(view, {500, 400})) > 5);
    view.setProgram(test::viewOf(test::programOf({{{1.0, 2.0, 3.0}, base::LineNumber{1}}})));
    view.setExecuted(7);
    QVERIFY(test::colourCount(test::picture(view, {500, 400})) > 5);
  }
};

RIVULET_TEST(TestPathView)
#include "tst_path_view.moc"
