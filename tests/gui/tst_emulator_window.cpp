// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The page Emulator of the real window, with mouse and keys: from recordings of a machine whose
/// parameters are known to a preset of the virtual machine; and what it says of files that are no
/// good.

#include <fmt/format.h>

#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>
#include <QTabWidget>
#include <QTableView>
#include <QTemporaryDir>
#include <QtTest>

#include "base/file.h"
#include "emulator/axis_model.h"
#include "gui/file_sheet.h"
#include "gui/look_check.h"
#include "hmi/main_window.h"
#include "machine/config.h"
#include "session/background.h"
#include "support/patience.h"
#include "support/test_program.h"
#include "widgets/common/sheet_area.h"
#include "widgets/common/status_label.h"
#include "widgets/emulator/emulator_page.h"
#include "widgets/emulator/emulator_text.h"
#include "widgets/emulator/overlay_panel.h"
#include "widgets/plots/box_plot.h"
#include "widgets/plots/curve_chart.h"
#include "widgets/plots/heat_map.h"
#include "widgets/scope/path_pane.h"
#include "widgets/scope/scope_view.h"

using namespace rivulet;
using hmi::MainWindow;
using widgets::CurveChart;
using widgets::EmulatorPage;

namespace {

using rivulet::tests::kRunMs;
using rivulet::tests::kSoonMs;
constexpr double kStepS = 0.004;
constexpr double kXGain = 40.0;
constexpr double kYGain = 30.0;

enum Tab { kRecordings, kParameters, kTests, kMatrix, kOverlay };

/// Two axes that follow with known lags; each design moves in its own way.
struct Trace {
  std::vector<double> atS;
  std::array<std::vector<double>, 2> askedMm;
  std::array<std::vector<double>, 2> seenMm;

  explicit Trace(int design, double seconds = 10.0, double reachMm = 20.0) {
    for (int i = 0; kStepS * i < seconds; ++i) {
      const double at = kStepS * i;
      atS.push_back(at);
      const double slow = 1.1 + 0.3 * design;
      askedMm[0].push_back(reachMm * (std::sin(slow * at) + 0.2 * std::sin(7.0 * at)));
      askedMm[1].push_back(reachMm * (std::cos(slow * at) - 1.0 + 0.15 * std::sin(9.0 * at)));
    }
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const auto law = emulator::firstOrderLag(1.0 / (axis == 0 ? kXGain : kYGain));
      for (const emulator::AxisState& state : emulator::simulateAxis(law, kStepS, askedMm[axis])) {
        seenMm[axis].push_back(state.mm);
      }
    }
  }

  [[nodiscard]] std::string text(bool withSetPoints = true) const {
    std::string text = withSetPoints ? "t_s,x_cmd,x_fb,y_cmd,y_fb\n" : "t_s,x_fb,y_fb\n";
    for (std::size_t i = 0; i < atS.size(); ++i) {
      text += withSetPoints
                  ? fmt::format("{:.4f},{:.7f},{:.7f},{:.7f},{:.7f}\n", atS[i], askedMm[0][i],
                                seenMm[0][i], askedMm[1][i], seenMm[1][i])
                  : fmt::format("{:.4f},{:.7f},{:.7f}\n", atS[i], seenMm[0][i], seenMm[1][i]);
    }
    return text;
  }
};

}  // namespace

class TestEmulatorWindow : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;
  std::unique_ptr<MainWindow> m_window;

  QString write(const QString& name, const std::string& text) {
    const QString path = m_folder.filePath(name);
    return base::writeFile(path.toStdString(), text) ? path : QString();
  }
  [[nodiscard]] EmulatorPage* page() const { return m_window->findChild<EmulatorPage*>(); }
  template <class Widget>
  [[nodiscard]] Widget* part(const char* name) const {
    return page()->findChild<Widget*>(QLatin1String(name));
  }
  [[nodiscard]] QString note() const { return part<widgets::StatusLabel>("emulatorNote")->text(); }
  [[nodiscard]] QString cell(const char* table, int row, int column) const {
    const QAbstractItemModel* model = part<QTableView>(table)->model();
    return model->index(row, column).data().toString();
  }
  [[nodiscard]] int rows(const char* table) const {
    return part<QTableView>(table)->model()->rowCount();
  }
  void click(const char* name) const {
    auto* button = part<QPushButton>(name);
    QVERIFY2(button->isVisible() && button->isEnabled(), name);
    QVERIFY2(button->height() >= 44, name);
    QTest::mouseClick(button, Qt::LeftButton);
  }
  void showTab(int tab) const { part<QTabWidget>("emulatorTabs")->setCurrentIndex(tab); }

  /// Types names into the sheet that a click opens.
  void choose(const char* button, const QStringList& paths) const {
    click(button);
    tests::typeFileName(
        *m_window, paths.size() == 1
                       ? paths.front()
                       : QLatin1Char('"') + paths.join(QStringLiteral("\" \"")) + QLatin1Char('"'));
  }
  void waitUntilRead() const {
    QTRY_VERIFY_WITH_TIMEOUT(!note().contains(QStringLiteral("Reading")), kSoonMs);
  }
  void learn() const {
    click("emulatorLearn");
    QTRY_VERIFY_WITH_TIMEOUT(part<QPushButton>("emulatorLearn")->isVisible(), kRunMs);
  }

 private Q_SLOTS:
  void initTestCase() {
    QStandardPaths::setTestModeEnabled(true);
    qputenv("XDG_STATE_HOME", m_folder.filePath(QStringLiteral("state")).toUtf8());
    qputenv("XDG_CONFIG_HOME", m_folder.filePath(QStringLiteral("config")).toUtf8());
    hmi::Settings settings;
    settings.language = QStringLiteral("en");
    settings.theme = widgets::Theme::Light;
    m_window = std::make_unique<MainWindow>(settings, false);
    m_window->resize(1280, 800);
    m_window->show();
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
  }

  void saysWhatToDoFirst() {
    for (int i = 0; !page()->isVisible() && i < m_window->pages()->count(); ++i) {
      m_window->pages()->setCurrentIndex(i);
    }
    QVERIFY(page()->isVisible());
    QVERIFY2(note().contains(QStringLiteral("Record a few programs")), qPrintable(note()));
    for (const char* button : {"emulatorLearn", "emulatorSave", "emulatorUse", "emulatorRemove"}) {
      QVERIFY2(!part<QPushButton>(button)->isEnabled(), button);
    }
  }

  void aRecordingWithoutSetPointsWantsItsProgram() {
    choose("emulatorAdd", {write(QStringLiteral("positions.csv"), Trace(0).text(false))});
    waitUntilRead();
    QCOMPARE(rows("emulatorRecordings"), 1);
    QVERIFY2(note().contains(QStringLiteral("positions.csv has no set points")),
             qPrintable(note()));
    QVERIFY(!part<QPushButton>("emulatorLearn")->isEnabled());
    // What is no program is refused, and asked for again.
    choose("emulatorProgram", {write(QStringLiteral("empty.ngc"), "G61\nF100\n")});
    QTRY_VERIFY_WITH_TIMEOUT(note().contains(QStringLiteral("program moves nothing")), kSoonMs);
    QCOMPARE(cell("emulatorRecordings", 0, 2), QStringLiteral("missing"));
    choose("emulatorProgram",
           {write(QStringLiteral("line.ngc"), "G61\nF1000\nG1 X10 Y10\nG1 X0 Y0\n")});
    QTRY_COMPARE_WITH_TIMEOUT(cell("emulatorRecordings", 0, 2), QStringLiteral("line.ngc"),
                              kSoonMs);
    QVERIFY(part<QPushButton>("emulatorLearn")->isEnabled());
    // It is not this one.
    learn();
    QCOMPARE(rows("emulatorParameters"), 0);
    QVERIFY(!part<QPushButton>("emulatorSave")->isEnabled());
    QVERIFY2(part<widgets::StatusLabel>("emulatorNote")->status() == widgets::Status::Fault,
             qPrintable(note()));
    click("emulatorRemove");
    QCOMPARE(rows("emulatorRecordings"), 0);
  }

  void learnsFromRecordings() {
    QStringList files;
    for (int design = 0; design < 3; ++design) {
      files.append(write(QStringLiteral("design%1.csv").arg(design), Trace(design).text()));
    }
    choose("emulatorAdd", files);
    waitUntilRead();
    QCOMPARE(rows("emulatorRecordings"), 3);
    QCOMPARE(cell("emulatorRecordings", 0, 1), QStringLiteral("Learn"));
    QCOMPARE(cell("emulatorRecordings", 2, 1), QStringLiteral("Test"));
    QCOMPARE(cell("emulatorRecordings", 2, 3), QStringLiteral("XY"));
    QCOMPARE(cell("emulatorRecordings", 2, 5), QStringLiteral("250"));
    // A run is learned from or tested on as the operator wants, by keys as well.
    auto* table = part<QTableView>("emulatorRecordings");
    table->setFocus();
    QTest::keyClick(table, Qt::Key_Down);
    QCOMPARE(table->currentIndex().row(), 1);
    QTest::keyClick(table, Qt::Key_Return);
    QCOMPARE(cell("emulatorRecordings", 1, 1), QStringLiteral("Test"));
    click("emulatorUse");
    QCOMPARE(cell("emulatorRecordings", 1, 1), QStringLiteral("Learn"));

    learn();
    QCOMPARE(part<QTabWidget>("emulatorTabs")->currentIndex(), static_cast<int>(kParameters));
    QVERIFY2(note().contains(QStringLiteral("Learned and tested")), qPrintable(note()));
    QCOMPARE(cell("emulatorParameters", 0, 1), QStringLiteral("Position gain"));
    QVERIFY(!cell("emulatorParameters", 0, 4).isEmpty());
    const QString remark = part<widgets::StatusLabel>("emulatorRemark")->text();
    QVERIFY2(remark.contains(QStringLiteral("On design2, which it was not learned from")),
             qPrintable(remark));
    QVERIFY2(remark.contains(QStringLiteral("feeds up to")), qPrintable(remark));
    // The curve of the error has a point for each model that was tried, for both axes.
    const auto& curves = part<CurveChart>("emulatorCurve")->curves();
    QCOMPARE(curves.size(), std::size_t{4});
    QVERIFY(curves[0].points.size() >= 8);
    QVERIFY(curves[0].points.back().y() <= curves[0].points.front().y());
  }

  void showsWhatItWasTestedOn() {
    showTab(kTests);
    QCOMPARE(rows("emulatorTests"), 3);
    QCOMPARE(cell("emulatorTests", 0, 0), QStringLiteral("design2"));
    QCOMPARE(cell("emulatorTests", 0, 1), QStringLiteral("Test"));
    QVERIFY2(cell("emulatorTests", 0, 2).toDouble() < 0.5,
             qPrintable(cell("emulatorTests", 0, 2)));  // µm
  }

  /// Which recordings teach most, and what each parameter is worth.
  void comparesRecordings() {
    showTab(kMatrix);
    auto* matrix = part<widgets::HeatMap>("emulatorMatrix");
    QVERIFY(!matrix->isVisible());
    click("emulatorCompare");
    QVERIFY(part<QPushButton>("emulatorCancel")->isVisible());
    QTRY_VERIFY_WITH_TIMEOUT(matrix->isVisible(), kRunMs);
    QCOMPARE(matrix->values().size(), std::size_t{3});
    for (const std::vector<double>& row : matrix->values()) {
      QCOMPARE(row.size(), std::size_t{3});
      for (const double micrometre : row) {
        QVERIFY2(micrometre < 1.0, qPrintable(QString::number(micrometre)));
      }
    }
    // One parameter for each axis, on three recordings; the slower axis lags more.
    const auto& boxes = part<widgets::BoxPlot>("emulatorWorth")->boxes();
    QCOMPARE(boxes.size(), std::size_t{2});
    QCOMPARE(boxes[1].name, QStringLiteral("Y Position gain"));
    QCOMPARE(boxes[1].values.size(), std::size_t{3});
    QVERIFY(boxes[0].values[1] > 10.0);  // µm: a lag of 1/40 s is a tenth shorter
    QVERIFY(part<QPushButton>("emulatorLearn")->isVisible());
    // It ends when it is told to; what was there stays.
    click("emulatorCompare");
    click("emulatorCancel");
    QTRY_VERIFY_WITH_TIMEOUT(part<QPushButton>("emulatorLearn")->isVisible(), kSoonMs);
    QVERIFY2(note().contains(QStringLiteral("cancelled")), qPrintable(note()));
    QVERIFY(matrix->isVisible());
  }

  void drawsMachineAndEmulator() {
    showTab(kOverlay);
    widgets::OverlayPanel* overlay = page()->overlay();
    QTRY_COMPARE_WITH_TIMEOUT(overlay->view()->panes().size(), std::size_t{4}, kSoonMs);
    QVERIFY(overlay->path()->canEnlarge());
    auto* enlargement = part<QComboBox>("emulatorEnlargement");
    enlargement->setFocus();
    QTest::keyClick(enlargement, Qt::Key_End);
    QTest::keyClick(enlargement, Qt::Key_Return);
    QTRY_COMPARE(overlay->path()->enlargement(), 1000.0);
    // Of another recording.
    auto* run = part<QComboBox>("emulatorOverlayRun");
    QCOMPARE(run->count(), 3);
    auto* curves = overlay->findChild<widgets::ScopeCurves*>();
    const auto before = curves->traces();
    run->setFocus();
    QTest::keyClick(run, Qt::Key_Down);
    QTRY_VERIFY_WITH_TIMEOUT(curves->traces() != before && curves->traces().size() == 2, kSoonMs);
    QCOMPARE(curves->traces()[0]->name, std::string("Machine"));
    QCOMPARE(curves->traces()[1]->name, std::string("Emulator"));
  }

  void showsBodeAndStepPlotsToThoseWhoWantThem() {
    showTab(kParameters);
    QVERIFY(!part<CurveChart>("emulatorGain")->isVisible());
    auto* more = part<QPushButton>("emulatorMore");
    more->setFocus();
    QTest::keyClick(more, Qt::Key_Space);
    QVERIFY(part<CurveChart>("emulatorGain")->isVisible());
    QCOMPARE(part<CurveChart>("emulatorGain")->curves().size(), std::size_t{2});
    // The bandwidth of the lag of X: 40/2π Hz.
    const QString text = part<QLabel>("emulatorBandwidths")->text();
    QVERIFY(part<QLabel>("emulatorFormulas")->text().startsWith(QStringLiteral("X:  G(s) = ")));
    QVERIFY2(text.contains(QStringLiteral("X follows up to 6.")), qPrintable(text));
    QTest::keyClick(more, Qt::Key_Space);
    QVERIFY(!part<CurveChart>("emulatorGain")->isVisible());
  }

  void formulasNameThePartsThatAnAxisHas() {
    using P = emulator::AxisParameter;
    emulator::AxisParameters axis;
    axis[P::PositionGain] = 40.0;
    QCOMPARE(widgets::transferFunctionText(axis), QStringLiteral("G(s) = 40.00 / (s + 40.00)"));
    axis[P::FeedForward] = 0.7;
    axis[P::SpeedGain] = 100.0;
    axis[P::ResetTime] = 0.02;
    QCOMPARE(widgets::transferFunctionText(axis),
             QStringLiteral("G(s) = (40.00 + 0.7000 s) W(s) / (s + 40.00 W(s))\n"
                            "W(s) = L(s) / (1 + L(s)),  L(s) = 100.0 · (1 + 1 / (0.02000 s)) / s"));
    axis[P::FeedForwardLag] = 0.004;
    axis[P::EffortLag] = 0.002;
    axis[P::Viscous] = 5.0;
    axis[P::Delay] = 0.003;
    axis[P::ResonanceHz] = 50.0;
    axis[P::ResonanceDamping] = 0.1;
    QCOMPARE(widgets::transferFunctionText(axis),
             QStringLiteral("G(s) = e^(−0.003000 s) · (40.00 + 0.7000 s / (1 + 0.004000 s)) W(s) / "
                            "(s + 40.00 W(s)) · (62.83 s + 98,696) / (s² + 62.83 s + 98,696)\n"
                            "W(s) = L(s) / (1 + L(s)),  L(s) = 100.0 · (1 + 1 / (0.02000 s)) / "
                            "((1 + 0.002000 s) (s + 5.000))"));
  }

  void savesAPreset() {
    const QString path = m_folder.filePath(QStringLiteral("mine"));  // .toml is added
    choose("emulatorSave", {path});
    QTRY_VERIFY_WITH_TIMEOUT(note().contains(QStringLiteral("mine.toml")), kSoonMs);
    const auto machine = machine::loadPreset(path.toStdString() + ".toml");
    QVERIFY2(machine, machine ? "" : machine.error().text().c_str());
    using P = emulator::AxisParameter;
    QVERIFY(std::abs((*machine->axisLaw(0))[P::PositionGain] - kXGain) < 0.1);
    QVERIFY(std::abs((*machine->axisLaw(1))[P::PositionGain] - kYGain) < 0.1);
    const auto text = base::readFile(path.toStdString() + ".toml");
    QVERIFY(text->find("# Tested on design2: position ") != std::string::npos);
    // Nothing is replaced without a question, by the name that the file will have.
    choose("emulatorSave", {path});
    auto* question = m_window->findChild<QMessageBox*>();
    QVERIFY(question != nullptr && question->isVisible());
    QTest::mouseClick(question->button(QMessageBox::Cancel), Qt::LeftButton);
    auto* sheet =
        m_window->findChild<widgets::SheetArea*>()->currentWidget()->findChild<QFileDialog*>();
    QVERIFY(sheet != nullptr && sheet->isVisible());
    sheet->reject();
    // Where nobody may write.
    choose("emulatorSave", {m_folder.filePath(QStringLiteral("state/none/mine.toml"))});
    QTRY_VERIFY_WITH_TIMEOUT(
        part<widgets::StatusLabel>("emulatorNote")->status() == widgets::Status::Fault, kSoonMs);
  }

  /// Learning is ended by a key in the middle; what was learned stays.
  void canBeCancelled() {
    const int before = rows("emulatorParameters");
    QVERIFY(before > 0);
    click("emulatorLearn");
    auto* cancel = part<QPushButton>("emulatorCancel");
    QVERIFY(cancel->isVisible());
    QVERIFY(!part<QPushButton>("emulatorLearn")->isVisible());
    QTRY_VERIFY_WITH_TIMEOUT(part<CurveChart>("emulatorCurve")->curves().size() >= 2, kRunMs);
    cancel->setFocus();
    QTest::keyClick(cancel, Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(part<QPushButton>("emulatorLearn")->isVisible(), kSoonMs);
    QVERIFY2(note().contains(QStringLiteral("cancelled")), qPrintable(note()));
    QCOMPARE(rows("emulatorParameters"), before);
    QVERIFY(part<QPushButton>("emulatorSave")->isEnabled());
  }

  void saysWhatIsWrong_data() {
    QTest::addColumn<std::string>("text");
    QTest::addColumn<QString>("named");
    QTest::addColumn<bool>("isRefusedAtOnce");
    QTest::newRow("no table") << std::string("one line\n") << QString() << true;
    Trace spoilt(0);
    spoilt.seenMm[0][200] = std::numeric_limits<double>::quiet_NaN();
    QTest::newRow("not a number") << spoilt.text() << QString() << false;
    Trace backwards(0);
    std::swap(backwards.atS[100], backwards.atS[140]);
    QTest::newRow("time runs backwards") << backwards.text() << QString() << false;
    QTest::newRow("no motion") << Trace(0, 10.0, 0.0).text() << QStringLiteral("moves") << false;
    QTest::newRow("too short") << Trace(0, 0.1).text() << QStringLiteral("observed") << false;
    Trace inches(0);
    for (double& mm : inches.seenMm[0]) {
      mm /= 25.4;
    }
    QTest::newRow("units mixed") << inches.text() << QStringLiteral("units") << false;
    Trace reversed(0);
    for (std::vector<double>& mm : reversed.seenMm) {
      std::reverse(mm.begin(), mm.end());
    }
    QTest::newRow("another program") << reversed.text() << QStringLiteral("departs") << false;
  }
  void saysWhatIsWrong() {
    QFETCH(std::string, text);
    QFETCH(QString, named);
    QFETCH(bool, isRefusedAtOnce);
    const int before = rows("emulatorParameters");
    while (rows("emulatorRecordings") > 0) {
      showTab(kRecordings);
      click("emulatorRemove");
    }
    choose("emulatorAdd", {write(QStringLiteral("bad.csv"), text)});
    waitUntilRead();
    if (isRefusedAtOnce) {
      QCOMPARE(rows("emulatorRecordings"), 0);
    } else if (rows("emulatorRecordings") == 1) {  // else the reader has refused it
      learn();
    }
    QVERIFY2(part<widgets::StatusLabel>("emulatorNote")->status() == widgets::Status::Fault,
             qPrintable(note()));
    QVERIFY2(note().contains(named), qPrintable(note()));
    QVERIFY2(!note().contains(QLatin1Char('\n')), qPrintable(note()));
    // Nothing is lost.
    QCOMPARE(rows("emulatorParameters"), before);
    QVERIFY(part<QPushButton>("emulatorSave")->isEnabled());
  }

  /// Every part of the page, learned, at the sizes, themes and languages it is used in.
  void looksRight() {
    QStringList files;
    for (int design = 0; design < 3; ++design) {
      files.append(m_folder.filePath(QStringLiteral("design%1.csv").arg(design)));
    }
    while (rows("emulatorRecordings") > 0) {
      showTab(kRecordings);
      click("emulatorRemove");
    }
    choose("emulatorAdd", files);
    waitUntilRead();
    QDir().mkpath(QStringLiteral(RIVULET_SCREENSHOTS));
    QStringList faults;
    for (const QSize size : {QSize(1024, 768), QSize(1280, 800), QSize(1920, 1080)}) {
      for (const char* language : {"en", "de"}) {
        for (const widgets::Theme theme :
             {widgets::Theme::Light, widgets::Theme::Dark, widgets::Theme::Contrast}) {
          m_window->resize(size);
          m_window->setLanguage(QLatin1String(language));
          m_window->setTheme(theme);
          for (const bool isOpen : {false, true}) {
            part<QPushButton>("emulatorMore")->setChecked(isOpen);
            for (int tab = isOpen ? kParameters : kRecordings;
                 tab <= (isOpen ? kParameters : kOverlay); ++tab) {
              showTab(tab);
              session::awaitPool();
              // What is laid out lays out what is in it in the next turn.
              for (int turn = 0; turn < 4; ++turn) {
                QCoreApplication::sendPostedEvents();
                QCoreApplication::processEvents();
              }
              page()->overlay()->redrawNow();
              const QString name = QStringLiteral("emulator-%1-%2-%3-%4%5")
                                       .arg(size.width())
                                       .arg(widgets::themeName(theme), QLatin1String(language))
                                       .arg(tab)
                                       .arg(isOpen ? QStringLiteral("-more") : QString());
              const QPixmap picture = m_window->grab();
              QVERIFY(picture.save(QStringLiteral(RIVULET_SCREENSHOTS "/%1.png").arg(name)));
              for (const QString& fault : tests::lookFaults(*m_window, picture.toImage())) {
                faults.append(name + QStringLiteral(": ") + fault);
              }
            }
          }
        }
      }
    }
    for (const QString& fault : faults) {
      qInfo("%s", qPrintable(fault));
    }
    QVERIFY(faults.isEmpty());
  }
};

RIVULET_TEST(TestEmulatorWindow)
#include "tst_emulator_window.moc"
