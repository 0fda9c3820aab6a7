// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// What an operator does in a shift, in the real window on a virtual machine over OPC UA: open a
/// program, judge it, start, hold, continue, stop, resume, recover after a loss of power, find out
/// why a run was slow. By mouse, by keyboard alone and by finger. The actions of each task are
/// counted, and compared with what the same task takes in two other senders (see docs/hmi.md).

#include <QAbstractButton>
#include <QDir>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabBar>
#include <QTabWidget>
#include <QTableView>
#include <QTest>
#include <QToolButton>
#include <map>

#include "base/units.h"
#include "gui/file_sheet.h"
#include "hmi/main_window.h"
#include "support/fault_proxy.h"
#include "support/kill_scene.h"
#include "support/patience.h"
#include "support/test_program.h"
#include "widgets/common/log_view.h"
#include "widgets/common/theme.h"
#include "widgets/connection/machine_button.h"
#include "widgets/program/program_panel.h"
#include "widgets/streaming/preflight_sheet.h"

using namespace rivulet;
using hmi::MainWindow;
using streaming::Outcome;

namespace {

using rivulet::tests::kRunMs;
using rivulet::tests::kSoonMs;
constexpr int kTabsMax = 300;

/// Begins the message.
const QString kWhySlow = QStringLiteral("The control answered slowly");

enum class Hand { Mouse, Keyboard, Finger };

/// Actions of the same task in gSender and in Universal G-code Sender, by their sources; 0: they do
/// not offer it. Two are estimates (see docs/hmi.md): judge, and to connect again in gSender. What
/// they may need beside these (homing, unlocking) is not counted.
struct Peers {
  int gSender = 0;
  int ugs = 0;
};
const std::map<std::string, Peers> kPeers{
    {"open", {2, 2}},     {"judge", {1, 1}},    {"start", {1, 1}},
    {"hold", {1, 1}},     {"continue", {1, 1}}, {"stop", {1, 1}},
    {"end here", {}},     {"resume", {3, 5}},   {"recover after power loss", {4, 6}},
    {"find why slow", {}}};

bool shows(const QWidget* widget, const QString& text) {
  const auto labels = widget->findChildren<QLabel*>();
  return std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) {
    return label->isVisible() && label->text().contains(text);
  });
}

bool holds(const QAbstractItemModel* model, const QString& text) {
  for (int row = 0; row < model->rowCount(); ++row) {
    for (int column = 0; column < model->columnCount(); ++column) {
      if (model->index(row, column).data().toString().contains(text)) {
        return true;
      }
    }
  }
  return false;
}

/// Does what a person does, and counts it: a click, a touch or a key that acts is one action,
/// however it was reached; a press that is held is one, too.
class Person {
 public:
  Person(MainWindow& window, Hand hand) : m_window(window), m_hand(hand) {}

  void begins(const std::string& task) { m_task = task; }
  [[nodiscard]] const std::map<std::string, int>& actions() const { return m_actions; }
  /// Presses of Tab to get to what was pressed by key.
  [[nodiscard]] int tabs() const { return m_tabs; }

  void press(QWidget* widget) { press(widget, widget->rect().center()); }
  void press(QWidget* widget, QPoint place) {
    down(widget, place);
    up(widget, place);
  }
  /// Holds it until the condition is true.
  template <class Condition>
  bool hold(QWidget* widget, const Condition& condition) {
    const QPoint middle = widget->rect().center();
    down(widget, middle);
    const bool isTrue = QTest::qWaitFor(condition, kSoonMs);
    up(widget, middle);
    return isTrue;
  }
  /// A key that works from anywhere in the window.
  void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    ++m_actions[m_task];
    QTest::keyClick(target(), key, modifiers);
  }
  /// The file in the sheet that `open` brings up.
  template <class Open>
  void chooseFile(const QString& path, const Open& open) {
    open();
    ++m_actions[m_task];
    tests::typeFileName(m_window, path);
  }

 private:
  [[nodiscard]] QWidget* target() const {
    QWidget* focus = m_window.focusWidget();
    return focus != nullptr ? focus : &m_window;
  }
  /// To the window itself: what is larger than the screen of the test is reached, too.
  [[nodiscard]] QTest::QTouchEventSequence touch() const {
    return QTest::touchEvent(m_window.windowHandle(), m_screen);
  }
  [[nodiscard]] QPoint inWindow(const QWidget* widget, QPoint place) const {
    return widget->mapTo(&m_window, place);
  }
  void down(QWidget* widget, QPoint place) {
    ++m_actions[m_task];
    QVERIFY2(widget->isVisible() && widget->isEnabled(), qPrintable(widget->objectName()));
    switch (m_hand) {
      case Hand::Mouse:
        QTest::mousePress(widget, Qt::LeftButton, {}, place);
        break;
      case Hand::Finger:
        QVERIFY2(widget->height() >= widgets::kTouchHeightPx, qPrintable(widget->objectName()));
        touch().press(++m_touches, inWindow(widget, place));
        break;
      case Hand::Keyboard:
        for (int i = 0; i < kTabsMax && m_window.focusWidget() != widget; ++i) {
          ++m_tabs;
          QTest::keyClick(target(), Qt::Key_Tab);
        }
        QCOMPARE(m_window.focusWidget(), widget);
        QTest::keyPress(widget, Qt::Key_Space);
        break;
    }
  }
  void up(QWidget* widget, QPoint place) {
    switch (m_hand) {
      case Hand::Mouse:
        QTest::mouseRelease(widget, Qt::LeftButton, {}, place);
        break;
      case Hand::Finger:
        touch().release(m_touches, inWindow(widget, place));
        QCoreApplication::processEvents();  // a click is made of it
        break;
      case Hand::Keyboard:
        QTest::keyRelease(widget, Qt::Key_Space);
        break;
    }
  }

  MainWindow& m_window;
  Hand m_hand;
  QPointingDevice* m_screen = QTest::createTouchDevice();
  std::string m_task;
  std::map<std::string, int> m_actions;
  int m_tabs = 0;
  int m_touches = 0;  ///< each is a point of its own
};

}  // namespace

class TestUsability : public QObject {
  Q_OBJECT

  tests::KillScene m_scene{QStringLiteral(RIVULET_MACHINE)};
  std::unique_ptr<MainWindow> m_window;

  [[nodiscard]] QPushButton* button(const char* name) const {
    return m_window->findChild<QPushButton*>(QLatin1String(name));
  }
  /// That of the first steps, as long as there is no program.
  [[nodiscard]] QPushButton* openButton() const { return button("open-first"); }
  [[nodiscard]] QString state() const {
    return m_window->findChild<QWidget*>(QStringLiteral("state"))->accessibleName();
  }
  [[nodiscard]] bool canPress(const char* name) const {
    return button(name)->isVisible() && button(name)->isEnabled();
  }
  /// Asks where the run was left, looks, and goes on.
  void resume(Person& person) {
    QTRY_VERIFY2_WITH_TIMEOUT(canPress("resume"), qPrintable(m_window->resumeBlockedReason()),
                              kSoonMs);
    person.press(button("resume"));
    QTRY_VERIFY_WITH_TIMEOUT(canPress("go-on"), kSoonMs);
    QVERIFY(person.hold(button("go-on"), [this] { return m_window->isRunning(); }));
  }
  void switchOffAndOn() {
    // While it holds: the tool stands on the path.
    QTRY_VERIFY_WITH_TIMEOUT(canPress("hold"), kSoonMs);
    QTest::mouseClick(button("hold"), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(state(), QStringLiteral("Holding"), kSoonMs);
    m_scene.awaitRest();
    m_scene.switchOff();
    QTRY_VERIFY_WITH_TIMEOUT(state().startsWith(QStringLiteral("Failed at")), kRunMs);
    m_scene.switchOn();
  }

 private Q_SLOTS:
  void initTestCase() {
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    qputenv("XDG_DATA_HOME", m_scene.path("data").toUtf8());
    qputenv("XDG_STATE_HOME", m_scene.path("state").toUtf8());
    QCoreApplication::setOrganizationName(QStringLiteral("RivuletTest"));
    m_scene.switchOn();
  }
  void cleanup() { m_window.reset(); }
  void cleanupTestCase() { m_scene.switchOff(); }

  /// The tool tip of a page names its key, if it has one.
  void keysOpenPages() {
    m_window = std::make_unique<MainWindow>(hmi::Settings(), false);
    m_window->show();
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    const QTabWidget* pages = m_window->pages();
    for (int page = 0; page < pages->count(); ++page) {
      const QString shown = pages->tabToolTip(page);
      if (shown.isEmpty()) {
        continue;
      }
      const QKeySequence key(shown);
      QCOMPARE(key.count(), 1);
      QTest::keyClick(m_window.get(), key[0].key(), key[0].keyboardModifiers());
      QVERIFY2(pages->currentIndex() == page, qPrintable(shown));
    }
  }

  void tasks_data() {
    QTest::addColumn<int>("hand");
    QTest::addColumn<QSize>("size");
    QTest::newRow("mouse") << static_cast<int>(Hand::Mouse) << QSize(1440, 900);
    QTest::newRow("keyboard") << static_cast<int>(Hand::Keyboard) << QSize(1280, 800);
    QTest::newRow("finger") << static_cast<int>(Hand::Finger) << QSize(1024, 768);
  }
  void tasks() {
    QFETCH(int, hand);
    QFETCH(QSize, size);
    const std::size_t before = m_scene.executed().size();
    tests::FaultProxy proxy(m_scene.endpoint().toStdString());
    hmi::Settings settings;
    settings.language = QStringLiteral("en");
    settings.theme = widgets::Theme::Light;
    settings.stream.parameters.pointsPerLoop = 4;
    settings.stream.feedMmPerS = base::mmPerSFromMmPerMin(1500.0);
    m_window = std::make_unique<MainWindow>(settings, false);
    m_window->resize(size);
    // Before the window is up, as with --connect: otherwise the page Machines comes first as soon
    // as there are runs on several machines.
    m_window->connectTo(QString::fromStdString(proxy.endpoint()));
    m_window->show();
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    QSignalSpy finished(m_window.get(), &MainWindow::runFinished);
    Person person(*m_window, static_cast<Hand>(hand));

    person.begins("open");
    person.chooseFile(m_scene.programFile(), [&] { person.press(openButton()); });
    QTRY_COMPARE_WITH_TIMEOUT(m_window->startBlockedReason(), QString(), kSoonMs);

    person.begins("judge");
    person.press(button("start"));
    auto* sheet = m_window->findChild<widgets::PreflightSheet*>();
    QTRY_VERIFY_WITH_TIMEOUT(sheet->isVisible(), kSoonMs);
    QTRY_VERIFY_WITH_TIMEOUT(shows(sheet, QStringLiteral("rows.nc, version")), kSoonMs);
    QVERIFY(shows(sheet, QStringLiteral("Simulation")));

    person.begins("start");
    QVERIFY(person.hold(button("start"), [this] { return m_window->isRunning(); }));
    QTRY_VERIFY_WITH_TIMEOUT(m_window->lastUpdate().counters.executed >= 4, kRunMs);

    person.begins("hold");
    person.press(button("hold"));
    QTRY_COMPARE_WITH_TIMEOUT(state(), QStringLiteral("Holding"), kSoonMs);
    person.begins("continue");
    person.press(button("hold"));
    QTRY_COMPARE_WITH_TIMEOUT(state(), QStringLiteral("Running"), kSoonMs);

    person.begins("stop");
    if (static_cast<Hand>(hand) == Hand::Keyboard) {
      person.key(Qt::Key_Escape);
    } else {
      person.press(button("stop"));
    }
    QTRY_VERIFY_WITH_TIMEOUT(m_window->lastUpdate().feed->stoodAfter, kRunMs);
    person.begins("end here");
    QVERIFY(person.hold(button("end-here"), [this] { return !canPress("end-here"); }));
    QVERIFY(finished.count() > 0 || finished.wait(kRunMs));
    QVERIFY(m_window->lastReport()->outcome == Outcome::Stopped);

    person.begins("resume");
    resume(person);
    person.begins("recover after power loss");
    switchOffAndOn();
    if (!canPress("connect")) {
      person.press(m_window->findChild<widgets::MachineButton*>());
    }
    QTRY_VERIFY_WITH_TIMEOUT(canPress("connect"), kSoonMs);
    person.press(button("connect"));
    resume(person);

    // The network becomes slow: 40 ms in each direction.
    tests::NetworkFault slow;
    slow.kind = tests::FaultKind::Delay;
    slow.duration = std::chrono::hours(1);
    slow.delay = std::chrono::milliseconds(40);
    proxy.begin(slow);
    auto* log = m_window->findChild<widgets::LogView*>();
    const auto* table = log->findChild<QTableView*>();
    QTRY_VERIFY_WITH_TIMEOUT(holds(table->model(), kWhySlow), kRunMs);
    proxy.begin({});
    QTRY_COMPARE_WITH_TIMEOUT(state(), QStringLiteral("Done"), kRunMs);
    person.begins("find why slow");
    QTabWidget* pages = m_window->pages();
    for (int page = 0; page < pages->count(); ++page) {
      if (!pages->widget(page)->isAncestorOf(log)) {
        continue;
      }
      if (static_cast<Hand>(hand) == Hand::Keyboard) {
        const QKeySequence shown(pages->tabToolTip(page));
        QCOMPARE(shown.count(), 1);
        person.key(shown[0].key(), shown[0].keyboardModifiers());
      } else {
        person.press(m_window->findChild<QAbstractButton*>(QStringLiteral("place-set-up")));
        person.press(pages->tabBar(), pages->tabBar()->tabRect(page).center());
      }
    }
    QTRY_VERIFY_WITH_TIMEOUT(table->isVisible(), kSoonMs);
    QVERIFY(holds(table->model(), kWhySlow));
    QDir().mkpath(QStringLiteral(RIVULET_SCREENSHOTS));
    m_window->grab().save(QStringLiteral(RIVULET_SCREENSHOTS "/why-slow-%1.png")
                              .arg(QLatin1String(QTest::currentDataTag())));

    QVERIFY(m_scene.isWhole(before));
    QString line;
    for (const auto& [task, count] : person.actions()) {
      line += QStringLiteral(" %1 %2,").arg(QString::fromStdString(task)).arg(count);
      const Peers& peers = kPeers.at(task);
      if (peers.gSender > 0) {
        QVERIFY2(count <= std::min(peers.gSender, peers.ugs), task.c_str());
      }
    }
    QCOMPARE(person.actions().size(), kPeers.size());
    qInfo("%s:%s %d presses of Tab", QTest::currentDataTag(), qPrintable(line), person.tabs());
  }
};

RIVULET_TEST(TestUsability)
#include "tst_usability.moc"
