// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The main job on the real window, with its threads, on a virtual machine in virtual time; see
/// tst_window_over_opcua for the real connection. Pictures of every page stay in the build folder.

#include <QAbstractSpinBox>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QProcess>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QUdpSocket>
#include <QWheelEvent>
#include <QtTest>
#include <algorithm>
#include <cmath>

#include "base/file.h"
#include "base/random.h"
#include "base/units.h"
#include "gui/end_by_hand.h"
#include "hmi/main_window.h"
#include "opcua/error.h"
#include "report/run_history.h"
#include "streaming/methods/pause_placement.h"
#include "support/patience.h"
#include "support/simulated_control.h"
#include "support/test_program.h"
#include "trace/analysis/integrity.h"
#include "trace/recording.h"
#include "widgets/alarms/alarm_line.h"
#include "widgets/calibration/calibration_page.h"
#include "widgets/common/folding_columns.h"
#include "widgets/common/hold_button.h"
#include "widgets/common/place_tabs.h"
#include "widgets/connection/connection_panel.h"
#include "widgets/connection/position_line.h"
#include "widgets/feasibility/feasibility_page.h"
#include "widgets/program/file_bars.h"
#include "widgets/program/path_view.h"
#include "widgets/program/program_page.h"
#include "widgets/streaming/correction_panel.h"
#include "widgets/streaming/found_run_bar.h"
#include "widgets/streaming/preflight_sheet.h"
#include "widgets/streaming/resume_bar.h"
#include "widgets/streaming/run_panel.h"
#include "widgets/trace/trace_page.h"

using namespace rivulet;
using hmi::MainWindow;
using streaming::Outcome;
using streaming::RunReport;

namespace {

using rivulet::tests::kSoonMs;
/// Bound of a run of the scorpion at the slowest feed used here, about 130 s of motion.
using rivulet::tests::kRunMs;
constexpr std::size_t kScorpionPoints = 270;
constexpr std::size_t kScorpionLines = 276;

const QString kScorpion = QStringLiteral(RIVULET_SOURCE_DIR "/resources/programs/scorpion.tap");

/// Seconds of the machine in one second, where a test does something in the middle of a run.
constexpr double kInteractivePace = 8.0;

hmi::Settings settings() {
  hmi::Settings settings;
  settings.language = QStringLiteral("en");
  settings.theme = widgets::Theme::Light;
  return settings;
}

streaming::StreamSettings streamSettings(base::MethodKind method, int points, double deltaMm,
                                         double feedMmPerMin) {
  streaming::StreamSettings stream;
  stream.parameters.method = method;
  stream.parameters.pointsPerLoop = points;
  stream.deltaMm = deltaMm;
  stream.feedMmPerS = base::mmPerSFromMmPerMin(feedMmPerMin);
  return stream;
}

/// A label of the widget that is visible has the text in it.
bool shows(const QWidget* widget, const QString& text) {
  const auto labels = widget->findChildren<QLabel*>();
  return std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) {
    return label->isVisible() && label->text().contains(text);
  });
}

/// A picture of the whole window on every page; blank ones fail.
void picturePages(MainWindow& window, const QString& prefix) {
  QDir().mkpath(QStringLiteral(RIVULET_SCREENSHOTS));
  const QStringList names{
      QStringLiteral("program"), QStringLiteral("feasibility"), QStringLiteral("traces"),
      QStringLiteral("runs"),    QStringLiteral("alarms"),      QStringLiteral("messages"),
      QStringLiteral("audit"),   QStringLiteral("users"),       QStringLiteral("set-up")};
  const int present = window.pages()->currentIndex();
  for (int page = 0; page < window.pages()->count(); ++page) {
    window.pages()->setCurrentIndex(page);
    window.tracePage()->redrawNow();
    QCoreApplication::processEvents();
    const QImage image = window.grab().toImage();
    QSet<QRgb> colours;
    for (int y = 0; y < image.height() && colours.size() < 20; y += 3) {
      for (int x = 0; x < image.width(); x += 3) {
        colours.insert(image.pixel(x, y));
      }
    }
    const QString name = names.value(page, QStringLiteral("page-%1").arg(page));
    QVERIFY2(colours.size() >= 20, qPrintable(name));
    QVERIFY(image.save(QStringLiteral(RIVULET_SCREENSHOTS "/%1-%2.png").arg(prefix, name)));
  }
  window.pages()->setCurrentIndex(present);
}

}  // namespace

class TestMainWindow : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<tests::SimulatedControl> m_machine;
  std::unique_ptr<MainWindow> m_window;
  QTemporaryDir m_folder;

  void open(const streaming::StreamSettings& stream, const QString& path = kScorpion) {
    m_window->setStreamSettings(stream);
    m_window->openProgram(path);
    connectToMachine();
    QTRY_COMPARE_WITH_TIMEOUT(m_window->startBlockedReason(), QString(), kSoonMs);
  }

  void connectToMachine() {
    m_window->connectTo(QString::fromStdString(tests::SimulatedControl::endpoint()));
  }

  /// A new machine; what was connected to another one loses it.
  void startMachine(const char* preset = "dmu75") {
    m_machine.reset();
    m_machine = std::make_unique<tests::SimulatedControl>(preset, kInteractivePace);
  }

  void openWindow() {
    m_window = std::make_unique<MainWindow>(settings(), false, [this](const auto& asked) {
      return m_machine->connect(asked.endpoint);
    });
    m_window->resize(1440, 900);
    m_window->show();
    auto* columns = m_window->findChild<widgets::FoldingColumns*>();
    QVERIFY(!columns->isOpen(widgets::FoldingColumns::First));
    QVERIFY(!columns->isOpen(widgets::FoldingColumns::Second));
    columns->setOpen(widgets::FoldingColumns::Second, true);
  }

  std::shared_ptr<const RunReport> runToEnd() {
    m_machine->setPace(tests::SimulatedControl::kUnlimited);
    QSignalSpy finished(m_window.get(), &MainWindow::runFinished);
    if (!m_window->start() || (finished.isEmpty() && !finished.wait(kRunMs))) {
      return nullptr;
    }
    return m_window->lastReport();
  }

  /// The page in front, a machine that has arrays, nothing known about it yet.
  void openCalibration() {
    QDir(m_folder.filePath(QStringLiteral("rivulet/machines"))).removeRecursively();
    startMachine("dmu75-arrays");
    hmi::showPageOf(m_window->calibrationPage());
    streaming::CalibrationPlan plan;
    plan.firstCell = 80;
    plan.lastCell = 99;
    plan.shots = 40;
    plan.budget = std::chrono::minutes{1};
    m_window->calibrationPage()->setPlan(plan);
  }

  void confirmCells() {
    for (QCheckBox* box : m_window->calibrationPage()->findChildren<QCheckBox*>()) {
      if (box->text().contains(QStringLiteral("R80 to R99"))) {
        box->setChecked(true);
      }
    }
  }

  void beginCalibration() {
    confirmCells();
    open(streamSettings(base::MethodKind::Window, 13, 0.3, 3000.0));
    QTest::mouseClick(button(QStringLiteral("Calibrate")), Qt::LeftButton);
  }

  void calibrate() {
    m_machine->setPace(tests::SimulatedControl::kUnlimited);
    beginCalibration();
    QTRY_VERIFY_WITH_TIMEOUT(m_window->accessSource().isUsed(), kRunMs);
  }

  /// Start as an operator does it: look at the preflight, then hold.
  void startByHand() {
    auto* start = m_window->findChild<widgets::HoldButton*>(QStringLiteral("start"));
    QTest::mouseClick(start, Qt::LeftButton);
    QTest::mousePress(start, Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(m_window->isRunning(), kSoonMs);
    QTest::mouseRelease(start, Qt::LeftButton);
  }

  /// First that of the run: a service on the board of machines has some with the same text.
  [[nodiscard]] QPushButton* button(const QString& text) const {
    for (const QWidget* place : std::initializer_list<const QWidget*>{
             m_window->findChild<widgets::RunPanel*>(), m_window.get()}) {
      for (QPushButton* candidate : place->findChildren<QPushButton*>()) {
        if (candidate->text() == text) {
          return candidate;
        }
      }
    }
    return nullptr;
  }

 private Q_SLOTS:
  void initTestCase() {
    qputenv("XDG_DATA_HOME", m_folder.path().toUtf8());    // where the machine store is
    qputenv("XDG_CONFIG_HOME", m_folder.path().toUtf8());  // where earlier versions kept profiles
    QCoreApplication::setOrganizationName(QStringLiteral("RivuletTest"));
  }

  void init() {
    // A run that an earlier test left would be offered.
    QDir(qEnvironmentVariable("XDG_STATE_HOME")).removeRecursively();
    startMachine();
    openWindow();
  }

  void cleanup() {
    m_window.reset();
    m_machine.reset();
  }

  void startIsGuarded() {
    QVERIFY(!m_window->startBlockedReason().isEmpty());  // no connection
    QVERIFY(!m_window->start());
    open(streamSettings(base::MethodKind::Signal, 7, 0.3, 3000.0));
    QVERIFY(m_window->verdict()->feasible);
    // Outside the region, and with a number of points that does not fit: no start.
    m_window->setStreamSettings(streamSettings(base::MethodKind::Position, 7, 0.3, 20000.0));
    QVERIFY(!m_window->verdict()->feasible);
    QVERIFY(!m_window->start());
    m_window->setStreamSettings(streamSettings(base::MethodKind::Signal, 40, 0.3, 500.0));
    QVERIFY(!m_window->startBlockedReason().isEmpty());
    QVERIFY(!m_window->start());
  }

  /// The button of the page, the worker's threads, the points beside the borders.
  void simulatesAroundTheOperatingPoint() {
    QFile whole(kScorpion);
    QVERIFY(whole.open(QIODevice::ReadOnly));
    QFile part(m_folder.filePath(QStringLiteral("part.tap")));
    QVERIFY(part.open(QIODevice::WriteOnly));
    constexpr int kLines = 90;  // each point of the chart simulates all of them several times
    for (int line = 0; line < kLines; ++line) {
      part.write(whole.readLine());
    }
    part.close();
    open(streamSettings(base::MethodKind::Position, 9, 0.75, 1400.0), part.fileName());
    m_window->pages()->setCurrentIndex(1);
    auto* page = m_window->findChild<widgets::FeasibilityPage*>();
    page->showChart(feasibility::SweepAxis::PointsPerLoop);
    auto* chart = page->chart(feasibility::SweepAxis::PointsPerLoop);
    auto* button = page->findChild<QPushButton*>();
    QTest::mouseClick(button, Qt::LeftButton);
    QVERIFY(!button->isVisible());
    QTRY_VERIFY_WITH_TIMEOUT(chart->region().has_value(), kRunMs);
    QVERIFY(button->isVisible());
    std::size_t ran = 0;
    std::size_t failed = 0;
    for (const widgets::SimulatedPoint& point : chart->region()->points) {
      QVERIFY(point.runs > 0);
      QVERIFY(point.abscissa <= 9.0);  // more slots do not fit 100 R-parameters
      ran += point.failures == 0 ? 1 : 0;
      failed += point.failures > 0 ? 1 : 0;
    }
    QDir().mkpath(QStringLiteral(RIVULET_SCREENSHOTS));
    QVERIFY(
        m_window->grab().save(QStringLiteral(RIVULET_SCREENSHOTS "/simulated_feasibility.png")));
    QVERIFY(ran > 0 && failed > 0);
    // Another program: what was simulated is gone. A start ends what is being simulated.
    m_window->openProgram(kScorpion);
    QTRY_VERIFY_WITH_TIMEOUT(!chart->region().has_value(), kSoonMs);
    QTRY_COMPARE_WITH_TIMEOUT(m_window->startBlockedReason(), QString(), kSoonMs);
    QTest::mouseClick(button, Qt::LeftButton);
    QVERIFY(!button->isVisible());
    QVERIFY(m_window->start());
    QVERIFY(button->isVisible() && !button->isEnabled());
    QVERIFY(!chart->region());
    QSignalSpy finished(m_window.get(), &MainWindow::runFinished);
    QTRY_VERIFY_WITH_TIMEOUT(m_window->lastUpdate().counters.executed >= 3, kRunMs);
    m_window->stop();
    QVERIFY(!finished.isEmpty() || finished.wait(kRunMs));
    QVERIFY(button->isEnabled());
  }

  void aLargeViewLeavesTheStrip() {
    m_window->resize(1280, 800);
    m_window->openProgram(kScorpion);
    auto* path = m_window->findChild<widgets::PathView*>();
    QTRY_VERIFY_WITH_TIMEOUT(path->isVisible(), kSoonMs);
    QCoreApplication::processEvents();
    const QSize before = path->size();
    auto* rail = m_window->findChild<widgets::PlaceRail*>();
    QTest::keyClick(m_window.get(), Qt::Key_F11);
    QTRY_VERIFY_WITH_TIMEOUT(path->width() > 1200 && path->height() > before.height(), kSoonMs);
    QVERIFY(!rail->isVisible());
    QVERIFY(m_window->findChild<QWidget*>(QStringLiteral("stop"))->isVisible());
    QTest::keyClick(m_window.get(), Qt::Key_F11);
    QTRY_COMPARE_WITH_TIMEOUT(path->size(), before, kSoonMs);
    QVERIFY(rail->isVisible());
  }

  /// From half of FullHD (200 %) up, and at the quarter of 1024x768: the window takes the size, and
  /// the whole of Stop, Start and the state can be seen, whatever is being said.
  void stopIsNeverCut_data() {
    QTest::addColumn<QSize>("size");
    for (const QSize size : {QSize(1024, 768), QSize(1280, 800), QSize(1920, 1080),
                             QSize(1280, 720), QSize(960, 540), QSize(683, 512), QSize(512, 384)}) {
      QTest::addRow("%dx%d", size.width(), size.height()) << size;
    }
  }

  void stopIsNeverCut() {
    QFETCH(QSize, size);
    const auto isWhole = [this, size](const QWidget* widget) {
      const QRect place(widget->mapTo(m_window.get(), QPoint()), widget->size());
      return widget->isVisible() && m_window->size() == size && m_window->rect().contains(place) &&
             widget->visibleRegion().boundingRect() == widget->rect();
    };
    for (const QString& language : {QStringLiteral("en"), QStringLiteral("de")}) {
      m_window->setLanguage(language);
      m_window->setStreamSettings(streamSettings(base::MethodKind::Window, 7, 0.3, 3000.0));
      m_window->openProgram(kScorpion);
      connectToMachine();
      QTRY_COMPARE_WITH_TIMEOUT(m_window->startBlockedReason(), QString(), kSoonMs);
      for (const bool isLost : {false, true}) {
        if (isLost) {
          m_machine->kill();
          QTRY_VERIFY_WITH_TIMEOUT(!m_window->startBlockedReason().isEmpty(), kSoonMs);
        }
        m_window->resize(size);
        for (int page = 0; page < m_window->pages()->count(); ++page) {
          m_window->pages()->setCurrentIndex(page);
          // A notice is above the strip on every second page.
          widgets::FoundRunView run;
          run.kind = widgets::FoundRunView::Kind::Waiting;
          run.number = 123456;
          run.program = QStringLiteral("a program with a rather long name.nc");
          run.user = QStringLiteral("anna");
          run.computer = QStringLiteral("cell-computer-of-the-shop");
          run.startedAtUtc = QStringLiteral("2026-01-01T00:00:00Z");
          m_window->findChild<widgets::FoundRunBar*>()->setRun(page % 2 == 1 ? std::optional(run)
                                                                             : std::nullopt);
          QCoreApplication::processEvents();
          for (const char* name : {"stop", "start", "state"}) {
            const auto* widget = m_window->findChild<QWidget*>(QLatin1String(name));
            QTRY_VERIFY2_WITH_TIMEOUT(widget != nullptr && isWhole(widget), name, kSoonMs);
          }
          QVERIFY(m_window->findChild<QWidget*>(QStringLiteral("stop"))->height() >= 56);
          QVERIFY(m_window->findChild<QWidget*>(QStringLiteral("start"))->height() >= 56);
        }
        QDir().mkpath(QStringLiteral(RIVULET_SCREENSHOTS));
        m_window->findChild<widgets::FoundRunBar*>()->setRun(std::nullopt);
        m_window->pages()->setCurrentIndex(0);
        m_window->grab().save(QStringLiteral(RIVULET_SCREENSHOTS "/frame-%1-%2%3.png")
                                  .arg(QString::number(size.width()), language,
                                       isLost ? QStringLiteral("-lost") : QString()));
      }
      startMachine();
    }
    m_window->setLanguage(QStringLiteral("en"));
  }

  /// A click, a key that is tapped, or a hold without the preflight moves nothing.
  void startNeedsPreflightAndHold() {
    open(streamSettings(base::MethodKind::Window, 7, 0.3, 3000.0));
    auto* start = m_window->findChild<widgets::HoldButton*>(QStringLiteral("start"));
    auto* sheet = m_window->findChild<widgets::PreflightSheet*>();
    QSignalSpy held(start, &widgets::HoldButton::held);
    QVERIFY(!sheet->isVisible());
    start->setFocus();
    QTest::keyClick(start, Qt::Key_Space);
    QVERIFY(sheet->isVisible() && !m_window->isRunning());
    QVERIFY(shows(sheet, QStringLiteral("Nothing has moved yet")));
    QTRY_VERIFY(shows(sheet, QStringLiteral("scorpion.tap, version ") +
                                 QString::fromStdString(m_window->program()->hash)));
    QVERIFY(shows(sheet, QStringLiteral("in a straight line over")));
    QTest::keyClick(start, Qt::Key_Space);
    QTest::mouseClick(start, Qt::LeftButton);
    QVERIFY(held.isEmpty() && !m_window->isRunning());
    // A finger that slides off the button lets go.
    QTest::mousePress(start, Qt::LeftButton);
    QTest::mouseMove(start, QPoint(-50, -50));
    QVERIFY(!start->isDown());
    QTest::mouseRelease(start, Qt::LeftButton);
    QVERIFY(m_window->grab().save(QStringLiteral(RIVULET_SCREENSHOTS "/preflight.png")));
    // "Not now" takes the meaning back.
    QTest::mouseClick(button(QStringLiteral("Not now")), Qt::LeftButton);
    QVERIFY(!sheet->isVisible());
    QSignalSpy finished(m_window.get(), &MainWindow::runFinished);
    QTest::keyClick(start, Qt::Key_Space);
    QTest::keyPress(start, Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(m_window->isRunning(), kSoonMs);
    QTest::keyRelease(start, Qt::Key_Space);
    QVERIFY(!sheet->isVisible());
    m_window->stop();
    QVERIFY(finished.wait(kRunMs));
  }

  /// Escape, wherever the focus is.
  void escapeStopsFromAnywhere_data() {
    QTest::addColumn<QString>("where");
    QTest::newRow("a field") << QStringLiteral("QLineEdit");
    QTest::newRow("a table") << QStringLiteral("QTableView");
    QTest::newRow("a menu") << QStringLiteral("QMenu");
    QTest::newRow("the window") << QString();
  }

  void escapeStopsFromAnywhere() {
    QFETCH(QString, where);
    open(streamSettings(base::MethodKind::Window, 7, 0.3, 3000.0));
    QSignalSpy finished(m_window.get(), &MainWindow::runFinished);
    QVERIFY(m_window->start());
    QTRY_VERIFY_WITH_TIMEOUT(m_window->lastUpdate().counters.executed >= 7, kRunMs);
    QWidget* target = m_window.get();
    for (QWidget* widget : m_window->findChildren<QWidget*>()) {
      if (widget->inherits(where.toLatin1()) &&
          (where == QStringLiteral("QMenu") || widget->isVisible())) {
        target = widget;
        break;
      }
    }
    if (auto* menu = qobject_cast<QMenu*>(target)) {
      menu->popup(m_window->mapToGlobal(QPoint(10, 10)));
    }
    QTest::keyClick(target, Qt::Key_Escape);
    tests::endByHand(*m_window);
    QVERIFY(!finished.isEmpty() || finished.wait(kRunMs));
    QVERIFY(m_window->lastReport()->outcome == Outcome::Stopped);
    QVERIFY(m_window->lastReport()->integrity.isFaultless());
  }

  /// A question in the window, whichever it is, leaves Stop to the mouse.
  void noQuestionCoversStop_data() {
    QTest::addColumn<QString>("item");
    QTest::addColumn<QString>("sheet");
    QTest::newRow("about") << QStringLiteral("&About Rivulet") << QStringLiteral("QMessageBox");
    QTest::newRow("a file") << QStringLiteral("&Open program …") << QStringLiteral("QFileDialog");
    QTest::newRow("a source") << QStringLiteral("Li&ve points …")
                              << QStringLiteral("rivulet::widgets::LiveDialog");
  }

  void noQuestionCoversStop() {
    QFETCH(QString, item);
    QFETCH(QString, sheet);
    open(streamSettings(base::MethodKind::Window, 7, 0.3, 3000.0));
    // Before the start, as an operator who opens it and then presses cycle start at the control.
    for (QAction* action : m_window->findChildren<QAction*>()) {
      if (action->text() == item) {
        action->trigger();
      }
    }
    const auto asked = [this, &sheet] {
      const auto all = m_window->findChildren<QDialog*>();
      const auto found = std::find_if(all.begin(), all.end(), [&sheet](const QDialog* dialog) {
        return dialog->inherits(sheet.toLatin1()) && dialog->isVisible();
      });
      return found == all.end() ? nullptr : *found;
    };
    QVERIFY(asked() != nullptr);
    QVERIFY(QApplication::activeModalWidget() == nullptr);
    QSignalSpy finished(m_window.get(), &MainWindow::runFinished);
    QVERIFY(m_window->start());
    QTRY_VERIFY_WITH_TIMEOUT(m_window->lastUpdate().counters.executed >= 7, kRunMs);
    QVERIFY(asked() != nullptr);
    QPushButton* stop = button(QStringLiteral("Stop"));
    QVERIFY(m_window->childAt(stop->mapTo(m_window.get(), stop->rect().center())) == stop);
    QTest::mouseClick(stop, Qt::LeftButton);
    tests::endByHand(*m_window);
    QVERIFY(!finished.isEmpty() || finished.wait(kRunMs));
    QVERIFY(m_window->lastReport()->outcome == Outcome::Stopped);
    // Another page withdraws the question; nothing of it is left.
    QTest::keyClick(m_window.get(), Qt::Key_2, Qt::AltModifier);
    QVERIFY(asked() == nullptr);
    QVERIFY(m_window->pages()->isVisible());
  }

  /// No setting anywhere in the window changes because a pointer hovers over it.
  void wheelChangesNoSetting() {
    open(streamSettings(base::MethodKind::Window, 7, 0.3, 3000.0));
    m_window->resize(1920, 1080);
    int tried = 0;
    for (int page = 0; page < m_window->pages()->count(); ++page) {
      m_window->pages()->setCurrentIndex(page);
      QCoreApplication::processEvents();
      for (QWidget* widget : m_window->findChildren<QWidget*>()) {
        const bool isSetting = qobject_cast<QAbstractSpinBox*>(widget) != nullptr ||
                               qobject_cast<QComboBox*>(widget) != nullptr ||
                               qobject_cast<QSlider*>(widget) != nullptr;
        if (!isSetting || !widget->isVisible() || !widget->isEnabled()) {
          continue;
        }
        const auto value = [widget] {
          const auto* combo = qobject_cast<QComboBox*>(widget);
          const auto* slider = qobject_cast<QSlider*>(widget);
          return combo != nullptr    ? combo->currentText()
                 : slider != nullptr ? QString::number(slider->value())
                                     : widget->property("text").toString();
        };
        const QString before = value();
        for (const int step : {120, -120, -120}) {
          const QPoint middle = widget->rect().center();
          QWheelEvent wheel(middle, widget->mapToGlobal(middle), QPoint(), QPoint(0, step),
                            Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
          QApplication::sendEvent(widget, &wheel);
        }
        QCOMPARE(value(), before);
        QVERIFY(widget->focusPolicy() != Qt::WheelFocus);
        ++tried;
      }
    }
    QVERIFY2(tried > 8, qPrintable(QString::number(tried)));
  }

  /// The control no longer answers, with the connection still up: after half a second nothing is
  /// shown as live. When the connection is lost, what the control does is not known.
  void nothingOldIsShownAsLive() {
    open(streamSettings(base::MethodKind::Window, 7, 0.3, 3000.0));
    auto* line = m_window->findChild<widgets::PositionLine*>();
    QTRY_VERIFY_WITH_TIMEOUT(shows(line, QStringLiteral("Live")), kSoonMs);
    QSignalSpy finished(m_window.get(), &MainWindow::runFinished);
    QVERIFY(m_window->start());
    QTRY_VERIFY_WITH_TIMEOUT(m_window->lastUpdate().counters.executed >= 7, kRunMs);
    m_machine->setPace(1e-6);
    QTRY_VERIFY_WITH_TIMEOUT(shows(line, QStringLiteral("Old: read")), kSoonMs);
    const auto struck = [line] {
      const auto labels = line->findChildren<QLabel*>();
      return std::count_if(labels.begin(), labels.end(), [](const QLabel* label) {
        return label->isVisible() && label->font().strikeOut();
      });
    };
    QVERIFY(struck() >= 3);
    QVERIFY(m_window->grab().save(QStringLiteral(RIVULET_SCREENSHOTS "/old-values.png")));
    m_machine->kill();
    QVERIFY(finished.wait(kRunMs));
    for (const auto* panel : m_window->findChildren<widgets::ConnectionPanel*>()) {
      for (const auto* label : panel->findChildren<QLabel*>()) {
        QVERIFY2(!label->text().contains(QStringLiteral("Active")) &&
                     !label->text().contains(QStringLiteral("Running")),
                 qPrintable(label->text()));
      }
    }
    QVERIFY(struck() >= 3);
  }

  /// Points closer than δ: the equations hold, but this machine would repeat points of this
  /// program. Nothing starts.
  void theMachineOverrulesTheEquation() {
    QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("circle.nc")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    for (int i = 0; i < 200; ++i) {
      const double angle = 0.015 * i;
      file.write(QStringLiteral("G1 X%1 Y%2 Z0 F150\n")
                     .arg(10.0 * std::cos(angle), 0, 'f', 4)
                     .arg(10.0 * std::sin(angle), 0, 'f', 4)
                     .toLatin1());
    }
    file.close();
    m_window->setStreamSettings(streamSettings(base::MethodKind::Position, 7, 0.3, 150.0));
    m_window->openProgram(file.fileName());
    connectToMachine();
    QTRY_VERIFY_WITH_TIMEOUT(m_window->verdict() && m_window->verdict()->feasible, kSoonMs);
    QTRY_VERIFY_WITH_TIMEOUT(
        m_window->startBlockedReason().contains(QStringLiteral("the control would repeat points")),
        kSoonMs);
    QVERIFY(!m_window->start());
    QVERIFY(!m_window->verdict()->feasible);
    QVERIFY(shows(m_window.get(), QStringLiteral("Not feasible")));
    QVERIFY(m_window->grab().save(QStringLiteral(RIVULET_SCREENSHOTS "/overruled.png")));
    m_window->setStreamSettings(streamSettings(base::MethodKind::Window, 7, 0.3, 150.0));
    QTRY_COMPARE_WITH_TIMEOUT(m_window->startBlockedReason(), QString(), kSoonMs);
  }

  /// Random bytes have no path: there is no verdict on them.
  void randomBytesAreNotFeasible() {
    connectToMachine();
    QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("random.bin")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    base::Random random(7);
    QByteArray bytes;
    for (int i = 0; i < 4000; ++i) {
      bytes.append(static_cast<char>(random.bits() & 0xff));
    }
    file.write("X1 Y1\nX2 Y5\nG1 X7 Y3 F100\n" + bytes);
    file.close();
    m_window->openProgram(file.fileName());
    QTRY_VERIFY_WITH_TIMEOUT(m_window->program() != nullptr, kSoonMs);
    QVERIFY(!m_window->program()->isStreamable());
    QVERIFY(!m_window->verdict());
    QVERIFY(!shows(m_window.get(), QStringLiteral("Feasible")));
    QVERIFY(!m_window->startBlockedReason().isEmpty());
  }

  void badFileKeepsTheProgram() {
    open(streamSettings(base::MethodKind::Signal, 7, 0.3, 3000.0));
    QTemporaryDir folder;
    QFile empty(folder.filePath(QStringLiteral("empty.nc")));
    QVERIFY(empty.open(QIODevice::WriteOnly));
    empty.close();
    auto* messages = m_window->findChild<widgets::AlarmLine*>();
    for (const QString& path : {folder.filePath(QStringLiteral("missing.nc")), empty.fileName()}) {
      messages->clearNote();
      m_window->openProgram(path);
      QTRY_VERIFY_WITH_TIMEOUT(!messages->text().isEmpty(), kSoonMs);
      QCOMPARE(m_window->startBlockedReason(), QString());
    }
  }

  /// Every point once, a pause for every STOPRE with motion behind it: two in each of the 39
  /// loops, but for the last of all.
  void streamsBySignal() {
    open(streamSettings(base::MethodKind::Signal, 7, 0.3, 6000.0));
    QVERIFY(m_window->verdict()->feasible);
    const auto report = runToEnd();
    QVERIFY(report);
    QVERIFY2(report->outcome == Outcome::Completed, report->error.text().c_str());
    QCOMPARE(report->counters.total, kScorpionPoints);
    QVERIFY(report->integrity.isFaultless());
    QCOMPARE(report->integrity.executed, kScorpionPoints);
    const std::size_t loops = (kScorpionPoints + 6) / 7;
    QCOMPARE(report->pauses.size(), 2 * loops - 1);
    for (const trace::Pause& pause : report->pauses) {
      QVERIFY(pause.origin == trace::PauseOrigin::Measured);
    }
    picturePages(*m_window, QStringLiteral("light-en"));
    m_window->setLanguage(QStringLiteral("de"));
    m_window->setTheme(widgets::Theme::Dark);
    QTRY_COMPARE(m_window->pages()->tabText(0), QStringLiteral("Programm"));
    picturePages(*m_window, QStringLiteral("dark-de"));
    m_window->setLanguage(QStringLiteral("en"));
    QTRY_COMPARE(m_window->pages()->tabText(0), QStringLiteral("Program"));
    picturePages(*m_window, QStringLiteral("dark-en"));
    m_window->setTheme(widgets::Theme::Light);
  }

  /// Each move has the feed of its own block: verdict, preflight and run go by the override.
  void streamsWithTheFeedsOfTheProgram() {
    streaming::StreamSettings stream = streamSettings(base::MethodKind::Window, 7, 0.3, 3000.0);
    stream.programFeeds = true;
    stream.overrideFactor = 0.9;
    open(stream);
    // The block that limits is the one that the command line names.
    QTRY_VERIFY_WITH_TIMEOUT(shows(m_window.get(), QStringLiteral("line 246: F")), kSoonMs);
    QTest::mouseClick(m_window->findChild<widgets::HoldButton*>(QStringLiteral("start")),
                      Qt::LeftButton);
    QTRY_VERIFY(shows(m_window.get(), QStringLiteral("Those of the program")));
    QVERIFY(m_window->grab().save(QStringLiteral(RIVULET_SCREENSHOTS "/preflight-feeds.png")));
    const auto report = runToEnd();
    QVERIFY(report && report->isFaultless());
    QVERIFY(report->settings.programFeeds.has_value());
    QCOMPARE(report->settings.programFeeds->overrideFactor, 0.9);
    QCOMPARE(report->counters.executed, kScorpionPoints);
  }

  void streamsByPosition() {
    open(streamSettings(base::MethodKind::Position, 9, 0.75, 1400.0));
    QVERIFY(m_window->verdict()->feasible);
    const auto report = runToEnd();
    QVERIFY(report);
    QVERIFY2(report->outcome == Outcome::Completed, report->error.text().c_str());
    QVERIFY(report->integrity.isFaultless());
    const std::size_t total = report->counters.total;
    QCOMPARE(total, kScorpionPoints);
    QCOMPARE(report->integrity.executed, total);
    QCOMPARE(report->pauses.size(), (total + 8) / 9 - 1);
  }

  /// Stop in the middle by the button: confirmed, nothing repeated, the recording whole.
  void stopsInTheMiddle() {
    open(streamSettings(base::MethodKind::Signal, 7, 0.3, 3000.0));
    QSignalSpy finished(m_window.get(), &MainWindow::runFinished);
    startByHand();
    QTRY_VERIFY_WITH_TIMEOUT(m_window->lastUpdate().counters.executed >= 14, kRunMs);
    QVERIFY(m_window->lastUpdate().state == streaming::RunState::Running);
    QTest::mouseClick(button(QStringLiteral("Stop")), Qt::LeftButton);
    QVERIFY(finished.wait(kRunMs));
    const auto report = m_window->lastReport();
    QVERIFY2(report->outcome == Outcome::Stopped, report->error.text().c_str());
    QVERIFY(report->stopConfirmedAfter.has_value());
    QVERIFY(report->integrity.isFaultless());
    QVERIFY(report->integrity.executed >= 14);
    QVERIFY(report->integrity.executed < kScorpionPoints);
    picturePages(*m_window, QStringLiteral("stopped"));

    const auto kept = report::RunHistory().list().runs;
    QVERIFY(!kept.empty() && kept.front().ownsRecording);
    const auto text = base::readFile(kept.front().recording);
    QVERIFY(text);
    const auto recording = trace::parseRecording(*text);
    QVERIFY(recording);
    QVERIFY(recording->complete);
    QCOMPARE(recording->end->outcome, std::string("stopped"));
    // The next start finds the machine ready again.
    QTRY_COMPARE_WITH_TIMEOUT(m_window->startBlockedReason(), QString(), kSoonMs);
  }

  /// By the slider, then by a datagram: the control confirms it, the axes are displaced by it, and
  /// at the end it is gone.
  void correctsWhileItRuns() {
    streaming::StreamSettings stream = streamSettings(base::MethodKind::Window, 7, 0.3, 3000.0);
    stream.parameters.correctionLimitMm = 0.1;
    open(stream);
    auto* panel = m_window->findChild<widgets::CorrectionPanel*>();
    QVERIFY(panel->isVisible());
    const auto sliders = panel->findChildren<QSlider*>();
    QSignalSpy finished(m_window.get(), &MainWindow::runFinished);
    QVERIFY(m_window->start());
    QTRY_VERIFY_WITH_TIMEOUT(m_window->lastUpdate().counters.executed >= 14, kRunMs);
    sliders.at(2)->setValue(80);
    const auto confirmed = [this] {
      const auto& correction = m_window->lastUpdate().correction;
      return correction ? correction->confirmedMm : base::Vec3{};
    };
    QTRY_COMPARE_WITH_TIMEOUT(confirmed(), (base::Vec3{0.0, 0.0, 0.08}), kSoonMs);
    const auto source = panel->findChild<QComboBox*>();
    source->setCurrentIndex(1);
    QCOMPARE(confirmed().z, 0.08);  // held until the source says something
    QUdpSocket socket;
    QTRY_VERIFY_WITH_TIMEOUT(
        (socket.writeDatagram("Y -0.05 Z 0.02", QHostAddress(QHostAddress::LocalHost),
                              static_cast<quint16>(panel->input().port)),
         confirmed() == base::Vec3{0.0, -0.05, 0.02}),
        kSoonMs);
    m_window->stop();
    QVERIFY(finished.wait(kRunMs));
    const auto report = m_window->lastReport();
    QVERIFY2(report->outcome == Outcome::Stopped, report->error.text().c_str());
    QVERIFY(report->integrity.isFaultless());
    const trace::ControlTrace& seen = *report->controlTrace;
    const auto isBelow = [&seen](double mm) {
      return std::any_of(seen.samples.begin(), seen.samples.end(),
                         [mm](const trace::ControlSample& sample) {
                           return std::abs(std::remainder(sample.commandMm.z, 1.0) - mm) < 1e-9;
                         });
    };
    QVERIFY(isBelow(0.08) && isBelow(0.02));
    QVERIFY(!sliders.at(2)->isEnabled());
    QTRY_COMPARE_WITH_TIMEOUT(m_window->startBlockedReason(), QString(), kSoonMs);
  }

  /// The file changes while it runs: the run keeps its version, and says so; afterwards the new
  /// one can be read.
  void aRunKeepsItsVersion() {
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.tap"));
    QVERIFY(QFile::copy(kScorpion, path));
    open(streamSettings(base::MethodKind::Signal, 7, 0.3, 3000.0), path);
    const QString hash = QString::fromStdString(m_window->program()->hash);
    auto* banner = m_window->findChild<widgets::FileBanner*>();
    QSignalSpy finished(m_window.get(), &MainWindow::runFinished);
    QVERIFY(m_window->start());
    QTRY_VERIFY_WITH_TIMEOUT(m_window->lastUpdate().counters.executed >= 7, kRunMs);
    QFile file(path);
    QVERIFY(file.setPermissions(file.permissions() | QFile::WriteOwner));
    QVERIFY(file.open(QIODevice::Append));
    QVERIFY(file.write("G0 X1\n") > 0);
    file.close();
    QTRY_VERIFY_WITH_TIMEOUT(banner->isVisible(), kSoonMs);
    QVERIFY(shows(banner, QStringLiteral("keeps version ") + hash));
    QVERIFY(shows(m_window.get(), QStringLiteral("Running: a.tap, version ") + hash));
    QVERIFY(!banner->findChild<QPushButton*>()->isVisible());
    QVERIFY(
        m_window->grab().save(QStringLiteral(RIVULET_SCREENSHOTS "/changed-while-running.png")));
    m_window->stop();
    QVERIFY(finished.wait(kRunMs));
    QVERIFY(m_window->lastReport()->integrity.isFaultless());
    QCOMPARE(QString::fromStdString(m_window->program()->hash), hash);
    QVERIFY(banner->findChild<QPushButton*>()->isVisible());
    // What is on disk is not what would run.
    QVERIFY(m_window->startBlockedReason().contains(QStringLiteral("reload")));
    QVERIFY(!m_window->start());
    QTest::mouseClick(banner->findChild<QPushButton*>(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(QString::fromStdString(m_window->program()->hash) != hash, kSoonMs);
    QTRY_COMPARE_WITH_TIMEOUT(m_window->startBlockedReason(), QString(), kSoonMs);
  }

  /// Method window by the buttons: pauses are told before the start, hold and continue, stop, and
  /// resume behind a sentence. Every point once, by the machine's own traces of both runs.
  void holdsStopsAndResumes() {
    open(streamSettings(base::MethodKind::Window, 7, 0.3, 6000.0));
    auto* path = m_window->programPage()->path();
    QTRY_VERIFY_WITH_TIMEOUT(path->pauses() != nullptr, kSoonMs);
    const auto points = gcode::streamPoints(m_window->program()->trajectory, {}).points;
    const auto planned = streaming::plannedPauses(points, base::MethodKind::Window, 7);
    QCOMPARE(path->pauses()->count(), planned.size());
    QCOMPARE(path->pauses()->inCut.size(), streaming::pausesInCut(planned));
    const QString summary = QStringLiteral("%1, of them %2 in the cut")
                                .arg(planned.size())
                                .arg(streaming::pausesInCut(planned));
    QTRY_VERIFY_WITH_TIMEOUT(shows(m_window.get(), summary), kSoonMs);
    QTRY_VERIFY_WITH_TIMEOUT(m_window->programPage()->hasTimes(), kSoonMs);
    picturePages(*m_window, QStringLiteral("window-light-en"));

    auto* hold = button(QStringLiteral("Pause"));
    // The bar of a run that was found has a button of the same text.
    auto* strip = m_window->findChild<widgets::RunPanel*>();
    auto* resume = strip->findChild<QPushButton*>(QStringLiteral("resume"));
    QVERIFY(!hold->isEnabled() && !resume->isVisible());
    QSignalSpy finished(m_window.get(), &MainWindow::runFinished);
    startByHand();
    QTRY_VERIFY_WITH_TIMEOUT(m_window->lastUpdate().counters.executed >= 14, kRunMs);
    QTest::mouseClick(hold, Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(m_window->lastUpdate().state == streaming::RunState::Holding, kRunMs);
    QCOMPARE(hold->text(), QStringLiteral("Continue"));
    // The axes stand at once, wherever they are on the path.
    QTRY_VERIFY_WITH_TIMEOUT(m_window->lastUpdate().feed->stoodAfter, kRunMs);
    QVERIFY(shows(strip, QStringLiteral("The axes stand")));
    const std::size_t held = m_window->lastUpdate().counters.executed;
    QVERIFY(held < kScorpionPoints);
    // The time that is left is known.
    auto* line = m_window->findChild<widgets::PositionLine*>();
    QVERIFY(shows(line, QStringLiteral("set 6,000")));
    // The line is that of a move of the window that is held, not of the last one that is over.
    const std::size_t end = std::min(held + 14, points.size());
    QVERIFY(std::any_of(
        points.begin() + static_cast<std::ptrdiff_t>(held),
        points.begin() + static_cast<std::ptrdiff_t>(end), [&](const auto& point) {
          return shows(strip, QStringLiteral("%1 of %2").arg(point.line.value).arg(kScorpionLines));
        }));
    QVERIFY(shows(strip, QStringLiteral(", pauses ")));
    picturePages(*m_window, QStringLiteral("holding"));
    QTest::mouseClick(hold, Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(m_window->lastUpdate().counters.executed > held, kRunMs);
    QVERIFY(!resume->isVisible());
    // Stop is the same, and the rest of the window comes only when somebody wants it. The override
    // is set by the buttons, and is that of the control.
    const auto percent = [this] { return m_window->lastUpdate().feed->actsPercent.value_or(-1.0); };
    QTest::mouseClick(strip->findChild<QPushButton*>(QStringLiteral("override-less")),
                      Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(percent(), 95.0, kRunMs);
    QTest::mouseClick(button(QStringLiteral("Stop")), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(m_window->lastUpdate().feed->stoodAfter, kRunMs);
    QCOMPARE(percent(), 0.0);
    QVERIFY(finished.isEmpty());
    picturePages(*m_window, QStringLiteral("held-by-stop"));
    tests::endByHand(*m_window);
    QVERIFY(!finished.isEmpty() || finished.wait(kRunMs));
    const auto first = m_window->lastReport();
    QVERIFY2(first->outcome == Outcome::Stopped, first->error.text().c_str());
    QVERIFY(first->accessForms.has_value());  // proved, not assumed
    QVERIFY(first->integrity.isFaultless());
    QVERIFY(first->integrity.executed < kScorpionPoints);

    // The control is asked; nothing moves for it, nor until the operator says so.
    QTRY_VERIFY_WITH_TIMEOUT(resume->isVisible() && resume->isEnabled(), kSoonMs);
    QTest::mouseClick(resume, Qt::LeftButton);
    auto* bar = m_window->findChild<widgets::ResumeBar*>();
    QTRY_VERIFY_WITH_TIMEOUT(bar->place().has_value(), kSoonMs);
    QCOMPARE(bar->place()->point, first->integrity.executed);
    QVERIFY(
        shows(bar, QStringLiteral("Nothing has moved yet. The run will resume at point %1 of 270")
                       .arg(first->integrity.executed + 1)));
    QVERIFY(!m_window->isRunning());
    picturePages(*m_window, QStringLiteral("resume-light-en"));
    m_window->setLanguage(QStringLiteral("de"));
    m_window->setTheme(widgets::Theme::Dark);
    QTRY_COMPARE(m_window->pages()->tabText(0), QStringLiteral("Programm"));
    picturePages(*m_window, QStringLiteral("resume-dark-de"));
    m_window->setLanguage(QStringLiteral("en"));
    m_window->setTheme(widgets::Theme::Light);
    QTRY_COMPARE(m_window->pages()->tabText(0), QStringLiteral("Program"));
    finished.clear();
    auto* goOn =
        button(QStringLiteral("Press and hold: resume at point %1").arg(bar->place()->point + 1));
    QTest::mousePress(goOn, Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(m_window->isRunning(), kSoonMs);
    QTest::mouseRelease(goOn, Qt::LeftButton);
    QVERIFY(!bar->isVisible());
    m_machine->setPace(tests::SimulatedControl::kUnlimited);
    QVERIFY(finished.wait(kRunMs));
    const auto second = m_window->lastReport();
    QVERIFY2(second->outcome == Outcome::Completed, second->error.text().c_str());
    QCOMPARE(m_window->lastUpdate().counters.executed, kScorpionPoints);
    std::vector<trace::ExecutedBlock> blocks = first->controlTrace->blocks;
    blocks.insert(blocks.end(), second->controlTrace->blocks.begin(),
                  second->controlTrace->blocks.end());
    const auto whole =
        gcode::streamPoints(m_window->program()->trajectory, first->checkpoint->startMm);
    const trace::Integrity integrity = trace::judgeIntegrity(whole.points, blocks, 1e-6);
    QVERIFY(integrity.isFaultless());
    QCOMPARE(integrity.executed, kScorpionPoints);
    // It has come to its end: there is nothing to resume.
    QTRY_COMPARE_WITH_TIMEOUT(m_window->startBlockedReason(), QString(), kSoonMs);
    QVERIFY(!resume->isVisible());
    picturePages(*m_window, QStringLiteral("resumed"));
  }

  /// The connection is lost in the middle; another program forgets the run that was left.
  void whatIsLeftBelongsToItsProgram() {
    open(streamSettings(base::MethodKind::Window, 7, 0.3, 3000.0));
    QSignalSpy finished(m_window.get(), &MainWindow::runFinished);
    QVERIFY(m_window->start());
    QTRY_VERIFY_WITH_TIMEOUT(m_window->lastUpdate().counters.executed >= 7, kRunMs);
    m_machine->kill();
    QVERIFY(!finished.isEmpty() || finished.wait(kRunMs));
    QVERIFY(m_window->lastReport()->outcome == Outcome::Failed);
    QVERIFY(!m_window->resumeBlockedReason().isEmpty());  // no connection
    // A machine that has never run it cannot say where it was left, and says so.
    startMachine();
    connectToMachine();
    QTRY_COMPARE_WITH_TIMEOUT(m_window->resumeBlockedReason(), QString(), kSoonMs);
    m_window->askResume();
    auto* bar = m_window->findChild<widgets::ResumeBar*>();
    QTRY_VERIFY_WITH_TIMEOUT(shows(bar, QStringLiteral("cannot be resumed")), kSoonMs);
    QVERIFY(!m_window->resume());
    QVERIFY(!m_window->isRunning());
    m_window->openProgram(kScorpion);
    QTRY_VERIFY_WITH_TIMEOUT(!bar->isVisible(), kSoonMs);
    QVERIFY(!m_window->resumeBlockedReason().isEmpty());
  }

  void calibrationNeedsAControlAndFreeCells() {
    openCalibration();
    auto* calibrate = button(QStringLiteral("Calibrate"));
    QVERIFY(!calibrate->isEnabled());
    confirmCells();
    QVERIFY(!calibrate->isEnabled());
    QVERIFY(shows(m_window->calibrationPage(), QStringLiteral("Connect to a control first.")));
    open(streamSettings(base::MethodKind::Window, 13, 0.3, 3000.0));
    QVERIFY(!m_window->accessSource().record);
    QVERIFY(!m_window->verdict()->accessMeasured);
    QVERIFY(calibrate->isEnabled());
  }

  /// The cells are free again, nothing is kept.
  void cancelledCalibrationLeavesNothing() {
    openCalibration();
    beginCalibration();
    QVERIFY(!m_window->start());
    auto* page = m_window->calibrationPage();
    auto* bar = page->findChild<QProgressBar*>();
    QTRY_VERIFY_WITH_TIMEOUT(bar->isVisible() && bar->value() > 30, kSoonMs);
    QTRY_VERIFY_WITH_TIMEOUT(shows(page, QStringLiteral("shots,")), kSoonMs);
    QDir().mkpath(QStringLiteral(RIVULET_SCREENSHOTS));
    QVERIFY(m_window->grab().save(QStringLiteral(RIVULET_SCREENSHOTS "/calibrating.png")));
    page->cancelRequested();
    auto* messages = m_window->findChild<widgets::AlarmLine*>();
    QTRY_VERIFY_WITH_TIMEOUT(messages->text().contains(QStringLiteral("cancelled")), kSoonMs);
    QVERIFY(!m_window->accessSource().record && !bar->isVisible());
  }

  void calibrationIsRecorded() {
    openCalibration();
    calibrate();
    QVERIFY(m_window->accessSource().isUsed());
    const streaming::CalibrationRecord& record = *m_window->accessSource().record;
    QCOMPARE(record.endpoint, tests::SimulatedControl::endpoint());
    QCOMPARE(record.server.buildNumber, std::string("dmu75-arrays"));
    QVERIFY(record.calibration.best() == opcua::Grouping::ArrayCount);
    for (const streaming::AccessSeries& series : record.calibration.series) {
      QVERIFY(series.shotsMade >= 5 && series.shotsMade <= 40);
    }
  }

  /// A window costs as much as a cell now: the machine is kept up with at many times the feed.
  void verdictUsesTheCalibration() {
    openCalibration();
    open(streamSettings(base::MethodKind::Window, 13, 0.3, 3000.0));
    const double assumedMmPerS = m_window->verdict()->feedMmPerSMax;
    calibrate();
    QVERIFY(m_window->verdict()->accessMeasured);
    QVERIFY(m_window->verdict()->feedMmPerSMax > 3.0 * assumedMmPerS);
    picturePages(*m_window, QStringLiteral("calibrated-light-en"));
    m_window->setLanguage(QStringLiteral("de"));
    m_window->setTheme(widgets::Theme::Dark);
    picturePages(*m_window, QStringLiteral("calibrated-dark-de"));
  }

  void nextWindowFindsTheCalibration() {
    openCalibration();
    calibrate();
    QVERIFY(m_window->accessSource().isUsed());
    const std::string measuredAt = m_window->accessSource().record->measuredAtUtc;
    openWindow();
    open(streamSettings(base::MethodKind::Window, 13, 0.3, 3000.0));
    QVERIFY(m_window->accessSource().isUsed());
    QCOMPARE(m_window->accessSource().record->measuredAtUtc, measuredAt);
    QVERIFY(m_window->verdict()->accessMeasured);
  }

  /// Another version at the same address: shown, not used.
  void anotherServerDoesNotUseTheCalibration() {
    openCalibration();
    open(streamSettings(base::MethodKind::Window, 13, 0.3, 3000.0));
    const double assumedMmPerS = m_window->verdict()->feedMmPerSMax;
    calibrate();
    m_window.reset();
    startMachine("dmu75");
    openWindow();
    open(streamSettings(base::MethodKind::Window, 13, 0.3, 3000.0));
    QVERIFY(m_window->accessSource().record && !m_window->accessSource().isUsed());
    QVERIFY(!m_window->verdict()->accessMeasured);
    QVERIFY(std::abs(m_window->verdict()->feedMmPerSMax / assumedMmPerS - 1.0) < 1e-9);
    picturePages(*m_window, QStringLiteral("outdated"));
  }

  /// The machine goes away in the middle: one sentence, and the page is ready again.
  void calibrationLosesItsMachine() {
    openCalibration();
    beginCalibration();
    auto* bar = m_window->calibrationPage()->findChild<QProgressBar*>();
    QTRY_VERIFY_WITH_TIMEOUT(bar->isVisible() && bar->value() > 30, kSoonMs);
    m_machine->kill();
    auto* messages = m_window->findChild<widgets::AlarmLine*>();
    QTRY_VERIFY_WITH_TIMEOUT(!messages->text().isEmpty(), kSoonMs);
    QTRY_VERIFY_WITH_TIMEOUT(!bar->isVisible(), kSoonMs);
    QVERIFY(!m_window->accessSource().record);
    QVERIFY(!m_window->startBlockedReason().isEmpty());
  }

  /// The network cable is pulled: one clear sentence, nothing goes on by itself.
  void lostMachineIsSaid() {
    open(streamSettings(base::MethodKind::Signal, 7, 0.3, 3000.0));
    QSignalSpy finished(m_window.get(), &MainWindow::runFinished);
    QVERIFY(m_window->start());
    QTRY_VERIFY_WITH_TIMEOUT(m_window->lastUpdate().counters.executed >= 3, kRunMs);
    m_machine->kill();
    QVERIFY(!finished.isEmpty() || finished.wait(kRunMs));
    const auto report = m_window->lastReport();
    QVERIFY(report->outcome == Outcome::Failed);
    QVERIFY(report->error.code == opcua::LinkError::ConnectionLost);
    QVERIFY(!report->isFaultless());
    QVERIFY(!m_window->findChild<widgets::AlarmLine*>()->text().isEmpty());
    QVERIFY(!m_window->isRunning());
    QVERIFY(!m_window->startBlockedReason().isEmpty());
  }
};

RIVULET_TEST(TestMainWindow)
#include "tst_main_window.moc"
