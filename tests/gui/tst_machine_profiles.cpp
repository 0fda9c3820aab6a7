// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The limits of a machine, typed in the window: they count at once, and again at the next
/// connection to this machine. And the machines that the window knows.

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QtTest>

#include "base/file.h"
#include "hmi/main_window.h"
#include "report/known_machine.h"
#include "report/machine_store.h"
#include "support/patience.h"
#include "support/simulated_control.h"
#include "support/test_program.h"
#include "widgets/common/number_field.h"
#include "widgets/connection/machines_page.h"
#include "widgets/setup/profile_page.h"
#include "widgets/streaming/preflight_sheet.h"

using namespace rivulet;
using hmi::MainWindow;

namespace {

using rivulet::tests::kSoonMs;
const QString kScorpion = QStringLiteral(RIVULET_SOURCE_DIR "/resources/programs/scorpion.tap");

}  // namespace

class TestMachineProfiles : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;
  std::unique_ptr<tests::SimulatedControl> m_machine;
  std::unique_ptr<MainWindow> m_window;

  void openWindow(const QString& program = kScorpion) {
    m_window.reset();
    hmi::Settings settings;
    settings.stream.wholeJob = program != kScorpion;
    settings.language = QStringLiteral("en");
    settings.stream.parameters.method = base::MethodKind::Window;
    settings.stream.programFeeds = true;
    m_window = std::make_unique<MainWindow>(
        settings, false, [this](const auto& asked) { return m_machine->connect(asked.endpoint); });
    m_window->resize(1440, 900);
    m_window->show();
    m_window->openProgram(program);
    m_window->connectTo(QString::fromStdString(tests::SimulatedControl::endpoint()));
    QTRY_COMPARE_WITH_TIMEOUT(m_window->startBlockedReason(), QString(), kSoonMs);
  }
  [[nodiscard]] widgets::NumberField* field(const QString& name) const {
    for (auto* field : page()->findChildren<widgets::NumberField*>()) {
      if (field->accessibleName() == name) {
        return field;
      }
    }
    return nullptr;
  }
  [[nodiscard]] widgets::ProfilePage* page() const {
    return m_window->findChild<widgets::ProfilePage*>();
  }
  [[nodiscard]] QPushButton* button(const QString& text) const {
    for (auto* button : page()->findChildren<QPushButton*>()) {
      if (button->text() == text) {
        return button;
      }
    }
    return nullptr;
  }
  [[nodiscard]] QString preflightText() const {
    m_window->showPreflight();
    QCoreApplication::processEvents();
    QString text;
    for (const auto* label :
         m_window->findChild<widgets::PreflightSheet*>()->findChildren<QLabel*>()) {
      text += label->text() + QLatin1Char('\n');
    }
    m_window->closePreflight();
    return text;
  }

 private Q_SLOTS:
  void initTestCase() {
    qputenv("XDG_DATA_HOME", m_folder.path().toUtf8());
    qputenv("XDG_CONFIG_HOME", m_folder.path().toUtf8());
    m_machine = std::make_unique<tests::SimulatedControl>("dmu75");
  }
  void cleanupTestCase() {
    m_window.reset();
    m_machine.reset();
  }

  void limitsCountAndAreFoundAgain() {
    openWindow();
    QVERIFY2(preflightText().contains(QStringLiteral("nobody has entered the limits")),
             qPrintable(preflightText()));
    const double fastest = m_window->feedMmPerSMax();
    widgets::NumberField* rapid = field(QStringLiteral("Rapid, mm/min"));
    QVERIFY(rapid != nullptr);
    QVERIFY(std::abs(rapid->value() - 60.0 * fastest) < 1e-6);
    // No axis without travel.
    widgets::NumberField* end = field(QStringLiteral("X Travel to"));
    const double endMm = end->value();
    end->setValue(-1e6);
    QVERIFY(!button(QStringLiteral("Save the limits"))->isEnabled());
    end->setValue(endMm);
    for (const char* axis : {"X", "Y", "Z"}) {
      field(QString::fromLatin1(axis) + QStringLiteral(" Speed"))->setValue(12000.0);
    }
    rapid->setValue(12000.0);
    field(QStringLiteral("Y Travel from"))->setValue(0.0);
    field(QStringLiteral("Y Travel to"))->setValue(2.0);
    QVERIFY(button(QStringLiteral("Save the limits"))->isEnabled());
    button(QStringLiteral("Save the limits"))->click();
    QTRY_COMPARE_WITH_TIMEOUT(m_window->feedMmPerSMax(), 200.0, kSoonMs);
    QVERIFY(!button(QStringLiteral("Save the limits"))->isEnabled());
    QTRY_VERIFY2_WITH_TIMEOUT(preflightText().contains(QStringLiteral("Y needs")),
                              qPrintable(preflightText()), kSoonMs);
    openWindow();
    QCOMPARE(m_window->feedMmPerSMax(), 200.0);
    QCOMPARE(field(QStringLiteral("Y Travel to"))->value(), 2.0);
  }

  /// What the names of the steps show is what has been done.
  void limitsOfAPresetAreTakenOver() {
    openWindow();
    auto* preset = page()->findChild<QComboBox*>();
    preset->setCurrentText(QStringLiteral("dmu75-5axis"));
    button(QStringLiteral("Take over its limits"))->click();
    QVERIFY(field(QStringLiteral("Rapid, mm/min"))->value() > 12000.0);
    QVERIFY(button(QStringLiteral("Discard changes"))->isEnabled());
    button(QStringLiteral("Discard changes"))->click();
    QCOMPARE(field(QStringLiteral("Rapid, mm/min"))->value(), 12000.0);
    hmi::showPageOf(page());
    QCoreApplication::processEvents();
    QDir().mkpath(QStringLiteral(RIVULET_SCREENSHOTS));
    QVERIFY(m_window->grab().save(QStringLiteral(RIVULET_SCREENSHOTS "/limits-light.png")));
    m_window->setTheme(widgets::Theme::Dark);
    m_window->resize(1024, 768);
    QCoreApplication::processEvents();
    QVERIFY(m_window->grab().save(QStringLiteral(RIVULET_SCREENSHOTS "/limits-dark.png")));
    m_window->setTheme(widgets::Theme::Light);
  }

  /// What a machine does for M functions of other machines is said once, and shown before a start.
  void functionsOfAnotherMachine() {
    const QString file = m_folder.filePath(QStringLiteral("O7.nc"));
    QVERIFY(base::writeFile(file.toStdString(),
                            "O7\nG21 G90 G94 G17\nG54\nT1 M6\nG43 H1\nG0 X0. Y0. Z10.\nM163\n"
                            "G1 X5. F500.\nM30\n"));
    openWindow();
    m_window->openProgram(file);
    QTRY_VERIFY2_WITH_TIMEOUT(
        preflightText().contains(QStringLiteral("M163 (line 7, once): left out, because nobody")),
        qPrintable(preflightText()), kSoonMs);
    QLineEdit* functions = nullptr;
    for (auto* each : page()->findChildren<QLineEdit*>()) {
      if (each->accessibleName() == QStringLiteral("M functions of other machines")) {
        functions = each;
      }
    }
    QVERIFY(functions != nullptr);
    QTest::keyClicks(functions, QStringLiteral("163"));
    QVERIFY(!button(QStringLiteral("Save the limits"))->isEnabled());
    QTest::keyClicks(functions, QStringLiteral("=M8"));
    button(QStringLiteral("Save the limits"))->click();
    QTRY_VERIFY2_WITH_TIMEOUT(
        preflightText().contains(QStringLiteral("M163 (line 7, once): the control executes M8")),
        qPrintable(preflightText()), kSoonMs);
    openWindow();
    m_window->openProgram(file);
    QTRY_VERIFY_WITH_TIMEOUT(preflightText().contains(QStringLiteral("executes M8")), kSoonMs);
  }

  /// With several machines, the window begins with them; a click goes to one.
  void severalMachinesAreTheFirstPage() {
    auto other = report::profileOfPreset("dmu75").value();
    other.endpoint = "opc.tcp://192.168.7.20:4840";
    other.server.applicationUri = "urn:maker:control";
    other.name = "Mill in the back";
    QVERIFY(report::MachineStore().save(other).has_value());
    m_window.reset();
    hmi::Settings settings;
    settings.language = QStringLiteral("en");
    m_window = std::make_unique<MainWindow>(
        settings, false, [this](const auto& asked) { return m_machine->connect(asked.endpoint); });
    m_window->resize(1440, 900);
    m_window->show();
    auto* machines = m_window->findChild<widgets::MachinesPage*>();
    QTRY_VERIFY_WITH_TIMEOUT(machines->isVisible(), kSoonMs);
    const auto connects = [machines] {
      QStringList names;
      for (const auto* button : machines->findChildren<QPushButton*>(QStringLiteral("open"))) {
        names.append(button->accessibleName());
      }
      return names;
    };
    QCOMPARE(connects().size(), 2);
    QCOMPARE(connects().front(), QStringLiteral("Connect Mill in the back"));
    QDir().mkpath(QStringLiteral(RIVULET_SCREENSHOTS));
    QCoreApplication::processEvents();
    QVERIFY(m_window->grab().save(QStringLiteral(RIVULET_SCREENSHOTS "/machines-light.png")));
    machines->findChildren<QPushButton*>(QStringLiteral("open")).back()->click();
    QVERIFY(!machines->isVisible());
    QTRY_VERIFY_WITH_TIMEOUT(connects().back().startsWith(QStringLiteral("Open ")), kSoonMs);
    m_window->setTheme(widgets::Theme::Dark);
    m_window->resize(1024, 768);
    for (int page = 0; !machines->isVisible() && page < m_window->pages()->count(); ++page) {
      m_window->pages()->setCurrentIndex(page);
    }
    QVERIFY(machines->isVisible());
    QCoreApplication::processEvents();
    QVERIFY(m_window->grab().save(QStringLiteral(RIVULET_SCREENSHOTS "/machines-dark.png")));
    m_window->setTheme(widgets::Theme::Light);
    // A removed machine goes from the list; what is known of it is put aside.
    machines->findChildren<QPushButton*>(QStringLiteral("remove")).front()->click();
    machines->findChildren<QPushButton*>(QStringLiteral("confirm-remove")).front()->click();
    QTRY_COMPARE(connects().size(), 1);
    QVERIFY(connects().front().startsWith(QStringLiteral("Open ")));
    QVERIFY(!report::MachineStore().profile(other.endpoint, other.server).value());
  }

  /// The tools of a virtual machine are known: a pocket of plain text gets their radius.
  void radiusOfATool() {
    m_window.reset();
    // What earlier tests have kept of this machine has no tools.
    QDir(m_folder.filePath(QStringLiteral("rivulet/machines"))).removeRecursively();
    QFile pocket(m_folder.filePath(QStringLiteral("pocket.h")));
    QVERIFY(pocket.open(QIODevice::WriteOnly));
    pocket.write(
        "BEGIN PGM POCKET MM\nTOOL CALL 3 Z S1000 F500\nL X+0 Y+0 Z+50 R0 FMAX M3\n"
        "CYCL DEF 252 CIRCULAR POCKET Q215=+0 Q223=+60 Q368=+0 Q207=+500 Q351=+1 Q201=-2 Q202=+2 "
        "Q369=+0 Q206=+150 Q338=+0 Q200=+2 Q203=+0 Q204=+50 Q370=+1 Q366=+0 Q385=+500\n"
        "CYCL CALL POS X+0 Y+0 Z+0 FMAX\nEND PGM POCKET MM\n");
    pocket.close();
    m_machine = std::make_unique<tests::SimulatedControl>("dmu75-mill");
    openWindow(pocket.fileName());
    m_window.reset();
    m_machine = std::make_unique<tests::SimulatedControl>("dmu75");
  }
};

RIVULET_TEST(TestMachineProfiles)
#include "tst_machine_profiles.moc"
