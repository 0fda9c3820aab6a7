// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The GUI thread is never busy for long: a tour of the window with a watchdog on its event loop.
/// It counts what the thread works, not what the clock says, so other programs on the computer do
/// not matter; how fast the computer is does, and is measured as well.

#include <QAbstractEventDispatcher>
#include <QSemaphore>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>
#include <atomic>
#include <ctime>
#include <optional>
#include <thread>
#include <vector>

#include "base/median.h"
#include "base/random.h"
#include "hmi/main_window.h"
#include "session/background.h"
#include "support/patience.h"
#include "support/simulated_control.h"
#include "support/surface_program.h"
#include "support/test_program.h"
#include "widgets/program/path_canvas.h"
#include "widgets/program/path_view.h"
#include "widgets/program/program_page.h"
#include "widgets/program/program_text_view.h"

using namespace rivulet;
using hmi::MainWindow;

namespace {

using rivulet::tests::kRunMs;
using rivulet::tests::kSoonMs;
constexpr double kPace = 8.0;

/// A user notices a window that does not answer for longer.
constexpr double kBusyMsMax = 50.0;
/// What `referenceWork` takes on the computer that the limit was set on. A slower one gets more
/// time.
constexpr double kReferenceMs = 14.0;

constexpr int kPasses = 3;
constexpr int kMoves = 1'000'000;  ///< of a long program
/// How much longer something may take when it is done for the first time.
constexpr double kFirstTimes = 2.0;
/// Between what was done and the number of the pass.
constexpr const char* kPass = ", pass ";

const QString kScorpion = QStringLiteral(RIVULET_SOURCE_DIR "/resources/programs/scorpion.tap");

/// Time that the calling thread has worked, in ms.
double workedMs() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

/// Sorting: branches and memory, as in a program.
double referenceWork() {
  base::Random random(1);
  std::vector<std::uint64_t> values(200'000);
  for (std::uint64_t& value : values) {
    value = random.bits();
  }
  const double before = workedMs();
  std::sort(values.begin(), values.end());
  return workedMs() - before;
}

/// Listens to the event loop: how long the thread works between two moments in which it could take
/// an event of the user.
class Watchdog {
 public:
  Watchdog() {
    auto* loop = QAbstractEventDispatcher::instance();
    m_woken = QObject::connect(loop, &QAbstractEventDispatcher::awake, loop, [this] { mark(); });
    m_slept = QObject::connect(loop, &QAbstractEventDispatcher::aboutToBlock, loop, [this] {
      if (m_since) {
        end();
      }
    });
  }
  ~Watchdog() {
    QObject::disconnect(m_woken);
    QObject::disconnect(m_slept);
  }
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

  /// Everything is done again, by another window.
  void beginPass(int number) { m_pass = QLatin1String(kPass) + QString::number(number); }
  /// What the test itself does is not counted; what the window does from now on belongs to `what`.
  void name(const QString& what) {
    m_what = what + m_pass;
    m_listens = true;
    m_since.reset();
  }
  /// What comes now is not counted.
  void forget() {
    m_listens = false;
    m_since.reset();
  }
  /// Does something that a user does, as one event.
  template <typename Action>
  void measure(const QString& what, Action action) {
    name(what);
    m_since = workedMs();
    action();
    end();
  }
  /// Works the same every time, between what the window does.
  void measureReference() {
    forget();
    m_referencesMs.push_back(referenceWork());
  }
  /// The median: what disturbs the window disturbs this work, too.
  [[nodiscard]] double referenceMs() const { return base::median(m_referencesMs); }
  struct Longest {
    double ms = 0.0;
    QString what;
  };
  /// The longest of one pass.
  [[nodiscard]] Longest longestOf(int pass) const {
    Longest longest;
    for (const Longest& one : m_longest) {
      const bool isOfPass = one.what.section(QLatin1String(kPass), 1, 1).toInt() == pass;
      longest = isOfPass && one.ms > longest.ms ? one : longest;
    }
    return longest;
  }
  /// Descending, one of each kind, each from the pass in which it took least: other work of the
  /// computer makes a pass slower, never faster.
  [[nodiscard]] std::vector<Longest> longest() const {
    std::vector<Longest> sorted;
    for (const Longest& one : m_longest) {
      const QString kind = one.what.section(QLatin1String(kPass), 0, 0);
      const auto found = std::find_if(sorted.begin(), sorted.end(),
                                      [&kind](const Longest& other) { return other.what == kind; });
      if (found == sorted.end()) {
        sorted.push_back({one.ms, kind});
      } else {
        found->ms = std::min(found->ms, one.ms);
      }
    }
    std::sort(sorted.begin(), sorted.end(),
              [](const Longest& a, const Longest& b) { return a.ms > b.ms; });
    return sorted;
  }

 private:
  void mark() {
    if (!m_listens) {
      return;
    }
    if (m_since) {
      end();  // a nested loop, or one that does not sleep
    }
    m_since = workedMs();
  }
  void end() {
    const double ms = workedMs() - *m_since;
    m_since.reset();
    auto found = std::find_if(m_longest.begin(), m_longest.end(),
                              [this](const Longest& one) { return one.what == m_what; });
    if (found == m_longest.end()) {
      m_longest.push_back({ms, m_what});
    } else {
      found->ms = std::max(found->ms, ms);
    }
  }

  QMetaObject::Connection m_woken;
  QMetaObject::Connection m_slept;
  std::optional<double> m_since;
  QString m_pass;
  bool m_listens = false;
  QString m_what;
  std::vector<Longest> m_longest;
  std::vector<double> m_referencesMs;
};

}  // namespace

class TestResponsiveness : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;

 private Q_SLOTS:
  void initTestCase() {
    QStandardPaths::setTestModeEnabled(true);
    qputenv("XDG_DATA_HOME", m_folder.path().toUtf8());
    qputenv("XDG_CONFIG_HOME", m_folder.path().toUtf8());
    QCoreApplication::setOrganizationName(QStringLiteral("RivuletTest"));
  }

  void guiThreadIsNeverBusyForLong() {
    Watchdog dog;
    double startMs = 0.0;
    for (int pass = 0; pass < kPasses; ++pass) {
      dog.beginPass(pass);
      startMs = useAWindow(dog);
      QVERIFY(startMs > 0.0);
    }

    qInfo("start %.0f ms of work", startMs);
    judge(dog);
  }

  /// Whatever an operator does with a program of a million lines.
  void aLongProgramNeverHoldsTheWindow() {
    const QString file = m_folder.filePath(QStringLiteral("long.mpf"));
    QVERIFY(tests::writeSurfaceProgram(file, kMoves));
    Watchdog dog;
    for (int pass = 0; pass < kPasses; ++pass) {
      dog.beginPass(pass);
      useALongProgram(file, dog);
      if (QTest::currentTestFailed()) {
        return;
      }
    }
    judge(dog);
  }

  /// Work that takes minutes, such as the time of a program of millions of lines: the window is
  /// drawn all the same. The watchdog does not see it, because a thread that waits does no work.
  void theWindowIsDrawnWhileThePoolIsBusy() {
    hmi::Settings settings;
    settings.language = QStringLiteral("en");
    MainWindow window(settings, false);
    window.resize(1440, 900);
    QSemaphore begun;
    QSemaphore end;
    const int threads = session::poolThreads();
    for (int i = 0; i < threads; ++i) {
      session::startInPool([&begun, &end] {
        begun.release();
        end.acquire();
      });
    }
    begun.acquire(threads);
    // So that a window that waits for the work fails here, and does not hang.
    std::atomic<bool> isAwaited{false};
    QSemaphore isDrawn;
    std::thread rescue([&] {
      isAwaited = !isDrawn.tryAcquire(1, kSoonMs);
      end.release(threads);
    });
    window.show();
    for (const widgets::Theme theme : {widgets::Theme::Dark, widgets::Theme::Light}) {
      window.setTheme(theme);
      for (int page = 0; page < window.pages()->count(); ++page) {
        window.pages()->setCurrentIndex(page);
        window.grab();
      }
    }
    isDrawn.release();
    rescue.join();
    session::awaitPool();
    QVERIFY(!isAwaited);
  }

 private:
  static void judge(const Watchdog& dog) {
    const double referenceMs = dog.referenceMs();
    const double allowedMs = kBusyMsMax * std::max(1.0, referenceMs / kReferenceMs);
    const auto longest = dog.longest();
    QVERIFY(longest.size() > 10);
    qInfo("reference %.1f ms of work, allowed %.0f ms", referenceMs, allowedMs);
    for (std::size_t i = 0; i < 8; ++i) {
      qInfo("%6.1f ms %s", longest[i].ms, qPrintable(longest[i].what));
    }
    if (tests::kIsSanitized) {
      return;  // a sanitizer slows memory down more than sorting
    }
    const auto text = [](const Watchdog::Longest& one) {
      return QStringLiteral("%1 ms of work: %2").arg(one.ms).arg(one.what);
    };
    QVERIFY2(longest.front().ms <= allowedMs, qPrintable(text(longest.front())));
    // Fonts, icons and texts are loaded once.
    const Watchdog::Longest first = dog.longestOf(0);
    qInfo("%6.1f ms %s", first.ms, qPrintable(first.what));
    QVERIFY2(first.ms <= kFirstTimes * allowedMs, qPrintable(text(first)));
  }

  static void useALongProgram(const QString& file, Watchdog& dog) {
    tests::SimulatedControl machine("dmu75", kPace);
    hmi::Settings settings;
    settings.language = QStringLiteral("en");
    settings.theme = widgets::Theme::Light;
    MainWindow window(settings, false,
                      [&machine](const auto& asked) { return machine.connect(asked.endpoint); });
    window.resize(1440, 900);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    streaming::StreamSettings stream;
    stream.parameters.method = base::MethodKind::Window;
    stream.parameters.pointsPerLoop = 7;
    stream.programFeeds = true;
    stream.overrideFactor = 0.5;
    window.setStreamSettings(stream);
    widgets::ProgramPage* page = window.programPage();
    widgets::PathCanvas* canvas = page->path()->canvas();
    const auto isShown = [&] { return canvas->hasClasses() && canvas->isFine(); };

    dog.measureReference();
    dog.name(QStringLiteral("open"));
    window.openProgram(file);
    QTRY_VERIFY_WITH_TIMEOUT(window.program() != nullptr && isShown(), kRunMs);
    QCOMPARE(window.program()->statistics.lines, std::size_t{kMoves + 5});
    QVERIFY(canvas->takeMostAtOnce() <= widgets::PathCanvas::kFrameMoves);
    dog.name(QStringLiteral("times"));
    QTRY_VERIFY_WITH_TIMEOUT(page->hasTimes(), kRunMs);
    using Colouring = overview::PathColouring;
    for (const auto colouring : {Colouring::Feed, Colouring::Margin, Colouring::Time,
                                 Colouring::Pauses, Colouring::Margin}) {
      const QString what = QStringLiteral("colours %1").arg(static_cast<int>(colouring));
      dog.measure(what, [&] { page->path()->setColouring(colouring); });
      measureTurns(dog, what);
      dog.name(what);
      QTRY_VERIFY_WITH_TIMEOUT(page->path()->shownColouring() == colouring && isShown(), kSoonMs);
    }
    dog.measureReference();
    dog.measure(QStringLiteral("line"), [&] { page->showLine(777'777); });
    QCOMPARE(page->text()->currentLine(), std::size_t{777'777});
    measureTurns(dog, QStringLiteral("line"));
    dog.name(QStringLiteral("connect"));
    window.connectTo(QString::fromStdString(tests::SimulatedControl::endpoint()));
    QTRY_COMPARE_WITH_TIMEOUT(window.startBlockedReason(), QString(), kRunMs);
    stream.parameters.pointsPerLoop = 9;
    dog.measure(QStringLiteral("N"), [&] { window.setStreamSettings(stream); });
    // Nothing starts before the path has been judged for this N.
    QVERIFY(window.startBlockedReason() != QString());
    measureTurns(dog, QStringLiteral("N"));
    dog.name(QStringLiteral("N"));
    QTRY_COMPARE_WITH_TIMEOUT(window.startBlockedReason(), QString(), kRunMs);
    visitPages(window, dog, QStringLiteral("ready"));
    dog.measure(QStringLiteral("preflight"), [&] { window.showPreflight(); });
    measureTurns(dog, QStringLiteral("preflight"));
    QSignalSpy finished(&window, &MainWindow::runFinished);
    dog.measure(QStringLiteral("start"), [&] { window.start(); });
    dog.name(QStringLiteral("running"));
    QTRY_VERIFY_WITH_TIMEOUT(window.lastUpdate().counters.executed >= 50, kRunMs);
    visitPages(window, dog, QStringLiteral("running"));
    dog.name(QStringLiteral("stop"));
    window.stop();
    QTRY_VERIFY_WITH_TIMEOUT(!finished.isEmpty(), kRunMs);
    visitPages(window, dog, QStringLiteral("stopped"));
    dog.forget();
  }

  /// Does what an operator does with it. @return the work of the start, ms; 0: it went wrong
  static double useAWindow(Watchdog& dog) {
    tests::SimulatedControl machine("dmu75", kPace);
    hmi::Settings settings;
    settings.language = QStringLiteral("en");
    settings.theme = widgets::Theme::Light;
    const double beforeMs = workedMs();
    MainWindow window(settings, false,
                      [&machine](const auto& asked) { return machine.connect(asked.endpoint); });
    window.resize(1440, 900);
    window.show();
    const bool isExposed = QTest::qWaitForWindowExposed(&window);
    const double startMs = workedMs() - beforeMs;
    dog.forget();

    visitPages(window, dog, QStringLiteral("empty"));
    streaming::StreamSettings stream;
    stream.parameters.method = base::MethodKind::Window;
    stream.parameters.pointsPerLoop = 7;
    stream.programFeeds = true;
    dog.name(QStringLiteral("open and connect"));
    window.setStreamSettings(stream);
    window.openProgram(kScorpion);
    window.connectTo(QString::fromStdString(tests::SimulatedControl::endpoint()));
    const bool isReady =
        QTest::qWaitFor([&] { return window.startBlockedReason().isEmpty(); }, kSoonMs);
    visitPages(window, dog, QStringLiteral("ready"));
    dog.measure(QStringLiteral("preflight"), [&window] {
      window.showPreflight();
      QCoreApplication::processEvents();
    });

    QSignalSpy finished(&window, &MainWindow::runFinished);
    dog.measure(QStringLiteral("start of a run"), [&window] { window.start(); });
    dog.name(QStringLiteral("running"));
    const bool isRunning =
        QTest::qWaitFor([&] { return window.lastUpdate().counters.executed >= 14; }, kRunMs);
    visitPages(window, dog, QStringLiteral("running"));
    dog.name(QStringLiteral("stop"));
    window.stop();
    const bool isStopped = QTest::qWaitFor([&] { return !finished.isEmpty(); }, kRunMs);
    visitPages(window, dog, QStringLiteral("stopped"));
    const auto change = [&dog](const QString& what, const auto& action) {
      dog.measureReference();
      dog.measure(what, action);
      measureTurns(dog, what);
    };
    change(QStringLiteral("dark"), [&] { window.setTheme(widgets::Theme::Dark); });
    change(QStringLiteral("light"), [&] { window.setTheme(widgets::Theme::Light); });
    change(QStringLiteral("German"), [&] { window.setLanguage(QStringLiteral("de")); });
    change(QStringLiteral("English"), [&] { window.setLanguage(QStringLiteral("en")); });
    dog.forget();
    return isExposed && isReady && isRunning && isStopped ? startMs : 0.0;
  }
  /// It lays out, draws, and takes what has arrived; each turn of the loop could take an event of
  /// the user.
  static void measureTurns(Watchdog& dog, const QString& what) {
    for (int turn = 0; turn < 5; ++turn) {
      dog.measure(what + QStringLiteral(", turn %1").arg(turn),
                  [] { QCoreApplication::processEvents(); });
    }
  }
  static void visitPages(MainWindow& window, Watchdog& dog, const QString& scene) {
    dog.measureReference();
    for (int page = 0; page < window.pages()->count(); ++page) {
      const QString what = scene + QLatin1String(", page ") + QString::number(page);
      dog.measure(what, [&window, page] { window.pages()->setCurrentIndex(page); });
      measureTurns(dog, what);
    }
    window.pages()->setCurrentIndex(0);
  }
};

RIVULET_TEST(TestResponsiveness)
#include "tst_responsiveness.moc"
