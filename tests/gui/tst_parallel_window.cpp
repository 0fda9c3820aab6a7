// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The page CNC tasks of the real window, with mouse and keys: its Petri net is played, and what
/// it shows is compared with the net played without a window.

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QStandardPaths>
#include <QTabWidget>
#include <QTableView>
#include <QTemporaryDir>
#include <QtTest>

#include "base/file.h"
#include "cnc/event_file.h"
#include "gui/file_sheet.h"
#include "gui/look_check.h"
#include "hmi/main_window.h"
#include "papers/parallel_cnc.h"
#include "petri/net_file.h"
#include "petri/simulator.h"
#include "support/patience.h"
#include "support/test_program.h"
#include "widgets/common/number_format.h"
#include "widgets/common/status_label.h"
#include "widgets/pipeline/net_canvas.h"
#include "widgets/pipeline/parallel_page.h"
#include "widgets/plots/curve_chart.h"

using namespace rivulet;
using hmi::MainWindow;
using widgets::CurveChart;
using widgets::NetCanvas;
using widgets::ParallelPage;

namespace {

using rivulet::tests::kRunMs;
using rivulet::tests::kSoonMs;

}  // namespace

class TestParallelWindow : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;
  std::unique_ptr<MainWindow> m_window;

  [[nodiscard]] ParallelPage* page() const { return m_window->findChild<ParallelPage*>(); }
  template <class Widget>
  [[nodiscard]] Widget* part(const char* name) const {
    return page()->findChild<Widget*>(QLatin1String(name));
  }
  [[nodiscard]] NetCanvas* canvas() const { return part<NetCanvas>("netCanvas"); }
  [[nodiscard]] QString note() const { return part<widgets::StatusLabel>("netNote")->text(); }
  [[nodiscard]] QString taskNote() const { return part<widgets::StatusLabel>("taskNote")->text(); }
  /// Of the table of the tasks.
  [[nodiscard]] QString taskCell(int row, int column) const {
    const QAbstractItemModel* model = part<QTableView>("taskTable")->model();
    return model->index(row, column).data().toString();
  }
  /// Types a name into the sheet that a click opens.
  void typeName(const char* button, const QString& path) const {
    click(button);
    tests::typeFileName(*m_window, path);
  }
  void click(const char* name) const {
    auto* button = part<QPushButton>(name);
    QVERIFY2(button->isVisible() && button->isEnabled(), name);
    QVERIFY2(button->height() >= 44, name);
    QTest::mouseClick(button, Qt::LeftButton);
  }
  /// Chooses an entry of a list by keys.
  void choose(const char* name, int index) const {
    auto* list = part<QComboBox>(name);
    list->setFocus();
    QTest::keyClick(list, Qt::Key_Home);
    for (int i = 0; i < index; ++i) {
      QTest::keyClick(list, Qt::Key_Down);
    }
    QCOMPARE(list->currentIndex(), index);
  }
  /// Of the page that is shown.
  [[nodiscard]] std::size_t nodeNamed(const petri::Net& net, const std::string& name) const {
    const auto& nodes = net.pages[canvas()->page()].nodes;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (nodes[i].name == name) {
        return i;
      }
    }
    return nodes.size();
  }
  [[nodiscard]] QString cellOf(const QString& place, int column) const {
    const QAbstractItemModel* model = part<QTableView>("netPlaces")->model();
    for (int row = 0; row < model->rowCount(); ++row) {
      if (model->index(row, 0).data().toString() == place) {
        return model->index(row, column).data().toString();
      }
    }
    return QStringLiteral("no such place");
  }
  void clickNode(std::size_t node) const {
    QTest::mouseClick(canvas(), Qt::LeftButton, {}, canvas()->nodeRect(node).center().toPoint());
  }
  /// Level of each buffer at the end of its line.
  [[nodiscard]] std::vector<double> lastLevels() const {
    std::vector<double> levels;
    for (const widgets::ChartCurve& curve : part<CurveChart>("netLevels")->curves()) {
      levels.push_back(curve.points.back().y());
    }
    return levels;
  }

 private Q_SLOTS:
  void initTestCase() {
    QStandardPaths::setTestModeEnabled(true);
    qputenv("XDG_STATE_HOME", m_folder.filePath(QStringLiteral("state")).toUtf8());
    qputenv("XDG_CONFIG_HOME", m_folder.filePath(QStringLiteral("config")).toUtf8());
    // Where the window finds rivulet-cnc.
    qputenv("PATH", QFileInfo(QStringLiteral(RIVULET_CNC)).path().toUtf8() + ':' + qgetenv("PATH"));
    hmi::Settings settings;
    settings.language = QStringLiteral("en");
    settings.theme = widgets::Theme::Light;
    m_window = std::make_unique<MainWindow>(settings, false);
    m_window->resize(1280, 800);
    m_window->show();
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    for (int i = 0; !page()->isVisible() && i < m_window->pages()->count(); ++i) {
      m_window->pages()->setCurrentIndex(i);
    }
    QVERIFY(page()->isVisible());
  }

  /// Each step fires what the net fires when nobody looks, and shows the same tokens.
  void stepsAsTheNetDoes() {
    const auto net = petri::loadNet("p3", pipeline::figure13Parameters(10, 0));
    QVERIFY(net.has_value());
    petri::Simulator simulator(*net);
    QCOMPARE(part<QComboBox>("netPage")->count(), static_cast<int>(net->pages.size()));
    for (int i = 0; i < 40; ++i) {
      const auto next = simulator.next();
      QVERIFY(next.has_value());
      const QString name = QString::fromStdString(net->transitions[*next].name);
      QVERIFY2(note().endsWith(name), qPrintable(note() + QStringLiteral(" / ") + name));
      QVERIFY2(note().contains(QStringLiteral("fired %1;").arg(i)), qPrintable(note()));
      click("netStep");
      QVERIFY(simulator.step());
    }
    // The scheduler's page.
    choose("netPage", static_cast<int>(net->pages.size()) - 1);
    for (const char* place : {"TaskQueue", "Running", "Idle", "TimeList"}) {
      const auto& tokens = simulator.marking()[net->placeOf(std::string("Top.SCHED.") + place)];
      QCOMPARE(cellOf(QLatin1String(place), 1), QString::number(tokens.size()));
    }
    choose("netPage", 0);
  }

  /// What can fire is marked, on its page and on those above it.
  void marksWhatCanFire() {
    click("netRestart");
    const auto net = petri::loadNet("p3");
    // At the beginning each task can only be set up, and the scheduler has nothing to do.
    QVERIFY(canvas()->isMarked(nodeNamed(*net, "CNC")));
    QVERIFY(!canvas()->isMarked(nodeNamed(*net, "SCHED")));
    clickNode(nodeNamed(*net, "CNC"));
    canvas()->setFocus();
    QTest::keyClick(canvas(), Qt::Key_Return);
    QCOMPARE(part<QComboBox>("netPage")->currentText(), QStringLiteral("Top › CNC"));
    QTest::mouseDClick(canvas(), Qt::LeftButton, {},
                       canvas()->nodeRect(nodeNamed(*net, "Receive")).center().toPoint());
    QCOMPARE(part<QComboBox>("netPage")->currentText(), QStringLiteral("Top › CNC › Receive"));
    QVERIFY(canvas()->isMarked(nodeNamed(*net, "init")));
    QVERIFY(!canvas()->isMarked(nodeNamed(*net, "start")));
    QVERIFY(!canvas()->isMarked(nodeNamed(*net, "complete")));
    // With arrow keys from node to node; the guard is shown.
    clickNode(nodeNamed(*net, "program"));
    QTest::keyClick(canvas(), Qt::Key_Right);
    QCOMPARE(canvas()->selected(), std::optional(nodeNamed(*net, "start")));
    const QString detail = part<QLabel>("netDetail")->text();
    QVERIFY2(detail.contains(QStringLiteral("d < capacity andalso n <> 0")), qPrintable(detail));
    QTest::keyClick(canvas(), Qt::Key_Backspace);
    QCOMPARE(part<QComboBox>("netPage")->currentText(), QStringLiteral("Top › CNC"));
  }

  /// Played to its end, the levels are those of the figure.
  void playsFigure13_data() {
    QTest::addColumn<int>("cycle");
    QTest::addColumn<int>("cycleMs");
    QTest::addColumn<int>("policy");
    QTest::newRow("15 ms, data flow") << 2 << 15 << 1;
    QTest::newRow("2 ms, task dependency") << 0 << 2 << 0;
  }
  void playsFigure13() {
    QFETCH(const int, cycle);
    QFETCH(const int, cycleMs);
    QFETCH(const int, policy);
    choose("netCycle", cycle);
    choose("netPolicy", policy);
    QVERIFY2(note().contains(QStringLiteral("fired 0;")), qPrintable(note()));
    choose("netSpeed", 4);
    click("netPlay");
    QCOMPARE(part<QPushButton>("netPlay")->text(), QStringLiteral("Pause"));
    QVERIFY(!part<QPushButton>("netStep")->isEnabled());
    QTRY_VERIFY_WITH_TIMEOUT(part<QPushButton>("netPlay")->text() == QStringLiteral("Play"),
                             kRunMs);
    QVERIFY2(note().contains(QStringLiteral("nothing more is played")), qPrintable(note()));
    const auto run =
        papers::runParallelCnc(pipeline::figure13Parameters(cycleMs, policy), pipeline::kFigure13S);
    QVERIFY(run.has_value());
    const std::vector<double> levels = lastLevels();
    QCOMPARE(levels.size(), run->levels.size());
    for (std::size_t i = 0; i < levels.size(); ++i) {
      QCOMPARE(levels[i], run->levels[i].back().level);
      const auto& points = part<CurveChart>("netLevels")->curves()[i].points;
      QCOMPARE(points.size(), 2 * (run->levels[i].size() - 1));
      QCOMPARE(points.back().x(), pipeline::kFigure13S);
    }
  }

  void canBePaused() {
    click("netRestart");
    choose("netSpeed", 2);
    auto* play = part<QPushButton>("netPlay");
    play->setFocus();
    QTest::keyClick(play, Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(!note().contains(QStringLiteral("fired 0;")), kSoonMs);
    QTest::keyClick(play, Qt::Key_Space);
    QCOMPARE(play->text(), QStringLiteral("Play"));
    const QString paused = note();
    click("netStep");
    QVERIFY(note() != paused);
    // The page follows what fires next.
    part<QCheckBox>("netFollow")->setFocus();
    QTest::keyClick(part<QCheckBox>("netFollow"), Qt::Key_Space);
    for (int i = 0; i < 10; ++i) {
      click("netStep");
      const QString shown = part<QComboBox>("netPage")->currentText().replace(QStringLiteral(" › "),
                                                                              QStringLiteral("."));
      const QString next = note().section(QLatin1Char(' '), -1);
      QCOMPARE(next.section(QLatin1Char('.'), 0, -2), shown);
    }
    QTest::keyClick(part<QCheckBox>("netFollow"), Qt::Key_Space);
    click("netRestart");
  }

  /// The six tasks execute the example; their table and what was recorded are the same.
  void executesAProgram() {
    part<QTabWidget>("parallelTabs")->setCurrentIndex(1);
    QVERIFY2(taskNote().contains(QStringLiteral("No machine moves")), qPrintable(taskNote()));
    QVERIFY(!part<QPushButton>("taskStop")->isEnabled());
    QVERIFY(!part<QPushButton>("taskSave")->isEnabled());
    choose("taskPolicy", 1);
    choose("taskCycle", 4);
    click("taskStart");
    // It is shown while it runs.
    QTRY_VERIFY_WITH_TIMEOUT(taskCell(5, 1) != QStringLiteral("0"), kSoonMs);
    QVERIFY(part<QPushButton>("taskStop")->isEnabled());
    QVERIFY(!part<QPushButton>("taskStart")->isEnabled());
    QTRY_VERIFY2_WITH_TIMEOUT(taskNote().contains(QStringLiteral("has ended")),
                              qPrintable(taskNote()), kRunMs);
    QCOMPARE(taskCell(5, 8), QStringLiteral("–"));
    QCOMPARE(taskCell(4, 8), QStringLiteral("B5: 0/50"));
    // What was saved says the same.
    const QString path = m_folder.filePath(QStringLiteral("run.events"));
    typeName("taskSave", path);
    const auto text = base::readFile(path.toStdString());
    QVERIFY(text.has_value());
    const auto recording = cnc::parseEvents(*text);
    QVERIFY2(recording.has_value(), recording ? "" : recording.error().text().c_str());
    QCOMPARE(recording->policy, pipeline::PolicyKind::DataFlow);
    std::array<std::size_t, pipeline::kTaskCount> steps{};
    for (const pipeline::Event& event : recording->events) {
      steps[indexOf(event.task)] += event.kind == pipeline::Event::Kind::Complete ? 1 : 0;
    }
    for (std::size_t i = 0; i < steps.size(); ++i) {
      QCOMPARE(taskCell(static_cast<int>(i), 1), widgets::countText(steps[i]));
    }
    QStringList before;
    for (int row = 0; row < 6; ++row) {
      for (int column = 0; column < 9; ++column) {
        before.append(taskCell(row, column));
      }
    }
    typeName("taskOpen", path);
    QTRY_VERIFY2_WITH_TIMEOUT(taskNote().contains(QStringLiteral("Recording run.events")),
                              qPrintable(taskNote()), kSoonMs);
    QStringList after;
    for (int row = 0; row < 6; ++row) {
      for (int column = 0; column < 9; ++column) {
        after.append(taskCell(row, column));
      }
    }
    QCOMPARE(after, before);
    QVERIFY(part<CurveChart>("taskLevels")->curves()[0].points.size() > 10);
  }

  void saysWhatIsWrongWithARecording() {
    const QString path = m_folder.filePath(QStringLiteral("bad.events"));
    QVERIFY(
        base::writeFile(path.toStdString(), "rivulet-cnc events 1\nsteady 2 50 4000000 0\nx\n"));
    typeName("taskOpen", path);
    QTRY_VERIFY2_WITH_TIMEOUT(taskNote().contains(QStringLiteral("Line 3 is no event")),
                              qPrintable(taskNote()), kSoonMs);
    QCOMPARE(taskCell(5, 1), QStringLiteral("0"));
  }

  void canBeEnded() {
    click("taskStart");
    QTRY_VERIFY_WITH_TIMEOUT(taskCell(5, 1) != QStringLiteral("0"), kSoonMs);
    auto* stop = part<QPushButton>("taskStop");
    stop->setFocus();
    QTest::keyClick(stop, Qt::Key_Space);
    QTRY_VERIFY2_WITH_TIMEOUT(taskNote().contains(QStringLiteral("was stopped")),
                              qPrintable(taskNote()), kSoonMs);
    QVERIFY(part<QPushButton>("taskStart")->isEnabled());
  }

  /// At the sizes it is used at, in all themes, in German and in a language with longer texts.
  void looksGood_data() {
    QTest::addColumn<QSize>("size");
    QTest::addColumn<int>("theme");
    QTest::addColumn<bool>("isGerman");
    const auto add = [](const char* name, QSize size, widgets::Theme theme, bool isGerman) {
      QTest::newRow(name) << size << static_cast<int>(theme) << isGerman;
    };
    add("light", {1280, 800}, widgets::Theme::Light, false);
    add("dark", {1024, 768}, widgets::Theme::Dark, false);
    add("contrast", {1024, 768}, widgets::Theme::Contrast, true);
    add("small", {960, 540}, widgets::Theme::Light, true);
  }
  void looksGood() {
    QFETCH(const QSize, size);
    QFETCH(const int, theme);
    QFETCH(const bool, isGerman);
    m_window->setTheme(static_cast<widgets::Theme>(theme));
    m_window->setLanguage(isGerman ? QStringLiteral("de") : QStringLiteral("en"));
    m_window->resize(size);
    const QString folder = qEnvironmentVariable("RIVULET_PICTURE_FOLDER");
    const auto inspect = [&](const QString& what) {
      for (int turn = 0; turn < 4; ++turn) {
        QCoreApplication::sendPostedEvents();
        QCoreApplication::processEvents();
      }
      const QImage picture = m_window->grab().toImage();
      if (!folder.isEmpty()) {
        const QString name =
            QStringLiteral("%1-%2.png").arg(QLatin1String(QTest::currentDataTag()), what);
        QVERIFY(picture.save(QDir(folder).filePath(name)));
      }
      const QStringList faults = tests::lookFaults(*m_window, picture);
      QVERIFY2(faults.isEmpty(), qPrintable(faults.join(QLatin1Char('\n'))));
    };
    part<QTabWidget>("parallelTabs")->setCurrentIndex(1);
    inspect(QStringLiteral("tasks"));
    part<QTabWidget>("parallelTabs")->setCurrentIndex(0);
    auto* pages = part<QComboBox>("netPage");
    for (int i = 0; i < pages->count(); ++i) {
      if (i > 3 && i + 2 < pages->count()) {
        continue;  // the four tasks in the middle have the same page
      }
      choose("netPage", i);
      for (int step = 0; step < 9; ++step) {
        part<QPushButton>("netStep")->click();
      }
      inspect(QStringLiteral("net-%1").arg(i));
      // No node covers another, and all are on the canvas.
      const auto net = petri::loadNet("p3");
      const std::size_t count = net->pages[static_cast<std::size_t>(i)].nodes.size();
      for (std::size_t a = 0; a < count; ++a) {
        QVERIFY(QRectF(canvas()->rect()).contains(canvas()->nodeRect(a)));
        for (std::size_t b = 0; b < a; ++b) {
          QVERIFY(!canvas()->nodeRect(a).intersects(canvas()->nodeRect(b)));
        }
      }
    }
  }

  void cleanupTestCase() { m_window.reset(); }
};

RIVULET_TEST(TestParallelWindow)
#include "tst_parallel_window.moc"
