// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Users, lock, releases and the audit trail, in their models and in the real window.

#include <QFileInfo>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "base/file.h"
#include "base/units.h"
#include "gui/end_by_hand.h"
#include "hmi/audit.h"
#include "hmi/main_window.h"
#include "hmi/users.h"
#include "journal/audit.h"
#include "journal/line_file.h"
#include "preparation/settings_facts.h"
#include "support/patience.h"
#include "support/simulated_control.h"
#include "support/test_program.h"
#include "widgets/users/users_page.h"

using namespace rivulet;
using hmi::Users;
using permission::Act;
using permission::Refusal;
using permission::Role;

namespace {

using rivulet::tests::kSoonMs;
const QString kScorpion = QStringLiteral(RIVULET_SOURCE_DIR "/resources/programs/scorpion.tap");

std::filesystem::path in(const QTemporaryDir& folder, const char* name) {
  return std::filesystem::path(folder.path().toStdString()) / name;
}

/// Tries to log in. @return whether it was the right PIN
bool logIn(Users& users, const char* name, const char* pin) {
  QSignalSpy right(&users, &Users::loggedIn);
  QSignalSpy wrong(&users, &Users::logInFailed);
  users.logIn(QString::fromUtf8(name), QString::fromUtf8(pin));
  return QTest::qWaitFor([&] { return right.count() + wrong.count() > 0; }, kSoonMs) &&
         right.count() == 1;
}

streaming::StreamSettings stream(double feedMmPerMin) {
  streaming::StreamSettings settings;
  settings.parameters.method = base::MethodKind::Window;
  settings.parameters.pointsPerLoop = 7;
  settings.feedMmPerS = base::mmPerSFromMmPerMin(feedMmPerMin);
  return settings;
}

/// A window with files of its own on a machine in virtual time.
struct Cell {
  QTemporaryDir folder;
  tests::SimulatedControl machine{"dmu75", 8.0};
  std::unique_ptr<hmi::MainWindow> window;

  void open() {
    hmi::Settings settings;
    settings.language = QStringLiteral("en");
    settings.theme = widgets::Theme::Light;
    settings.stream = stream(900.0);
    settings.stateFolder = in(folder, "state");
    settings.usersFile = in(folder, "users.json");
    window = std::make_unique<hmi::MainWindow>(
        settings, false, [this](const auto& asked) { return machine.connect(asked.endpoint); });
    window->resize(1280, 800);
    window->show();
    window->connectTo(QString::fromStdString(tests::SimulatedControl::endpoint()));
    window->openProgram(kScorpion);
    QTRY_VERIFY_WITH_TIMEOUT(window->program() != nullptr, kSoonMs);
  }
  /// The lines of the audit trail, as "act", after the window is closed.
  QStringList closeAndReadActs() {
    window.reset();
    const auto content = journal::readAudit(journal::auditFileIn(in(folder, "state")));
    QStringList acts;
    for (const auto& line : content->lines) {
      acts << QString::fromStdString(line.entry.act);
    }
    return content->findings.empty() ? acts : QStringList();
  }
};

/// Waits until a user is kept or refused.
bool put(Users& users, const QString& name, Role role, const QString& pin) {
  std::optional<bool> isKept;
  users.put(name, role, pin, [&isKept](const auto& done) { isKept = done.has_value(); });
  return QTest::qWaitFor([&isKept] { return isKept.has_value(); }, kSoonMs) && *isKept;
}

}  // namespace

class TestOperator : public QObject {
  Q_OBJECT

 private slots:
  void withoutUsersNobodyIsBothered() {
    Users users({}, QStringLiteral("anna"));
    QVERIFY(!users.isSetUp() && !users.isLocked());
    QCOMPARE(users.name(), QString("anna"));
    for (const Act act : {Act::Start, Act::ChangeSettings, Act::Calibrate, Act::SetUpUsers}) {
      QVERIFY(!users.refusal(act, false));
    }
    users.lock();
    QVERIFY(!users.isLocked());
  }

  void usersLogInByPin() {
    const QTemporaryDir folder;
    const auto file = in(folder, "users.json");
    {
      Users users(file, QStringLiteral("cell"));
      // The first one must be an engineer, and a PIN has four characters.
      QVERIFY(!put(users, QStringLiteral("otto"), Role::Operator, QStringLiteral("1234")));
      QVERIFY(!put(users, QStringLiteral("anna"), Role::Engineer, QStringLiteral("123")));
      QVERIFY(put(users, QStringLiteral("anna"), Role::Engineer, QStringLiteral("47110815")));
      QVERIFY(put(users, QStringLiteral("otto"), Role::Operator, QStringLiteral("1234")));
      QCOMPARE(users.name(), QString("anna"));
      QVERIFY(!put(users, QStringLiteral("anna"), Role::Operator, QStringLiteral("47110815")));
      QVERIFY(!users.remove(QStringLiteral("anna")));
    }
    QCOMPARE(QFileInfo(QString::fromStdString(file.string())).permissions() &
                 (QFileDevice::ReadGroup | QFileDevice::ReadOther | QFileDevice::WriteGroup |
                  QFileDevice::WriteOther),
             QFileDevice::Permissions());
    const auto text = base::readFile(file);
    QVERIFY(text && text->find("47110815") == std::string::npos);

    Users users(file, QStringLiteral("cell"));
    QVERIFY(users.isLocked());
    QVERIFY(users.refusal(Act::Start) == Refusal::Locked && !users.refusal(Act::Stop));
    QVERIFY(!logIn(users, "otto", "47110815"));
    QVERIFY(!logIn(users, "nobody", "1234"));
    QVERIFY(logIn(users, "otto", "1234"));
    QVERIFY(users.refusal(Act::ChangeSettings) == Refusal::NeedsEngineer);
    QVERIFY(users.refusal(Act::Start, false) == Refusal::NotReleased);
    QVERIFY(!users.refusal(Act::Start, true));
    users.lock();
    QVERIFY(users.isLocked());
    QVERIFY(logIn(users, "anna", "47110815"));
    QVERIFY(!users.refusal(Act::ChangeSettings));
  }

  void aPinIsHashedBesideTheWindow() {
    Users users({}, QStringLiteral("cell"));
    bool isKept = false;
    users.put(QStringLiteral("anna"), Role::Engineer, QStringLiteral("4711"),
              [&isKept](const auto& done) { isKept = done.has_value(); });
    QVERIFY(!isKept && !users.isSetUp());
    QTRY_VERIFY(isKept && users.isSetUp());
  }

  void wrongPinsHaveToWait() {
    const QTemporaryDir folder;
    Users users(in(folder, "users.json"), QStringLiteral("cell"));
    QVERIFY(put(users, QStringLiteral("anna"), Role::Engineer, QStringLiteral("4711")));
    users.lock();
    for (int i = 0; i < Users::kTriesMax; ++i) {
      QVERIFY(!logIn(users, "anna", "0000"));
    }
    QVERIFY(!logIn(users, "anna", "4711"));
    QVERIFY(users.isLocked());
  }

  void theUserOfTheComputerNeedsNoPin() {
    const QTemporaryDir folder;
    const auto file = in(folder, "users.json");
    {
      Users users(file, QStringLiteral("anna"));
      QVERIFY(put(users, QStringLiteral("anna"), Role::Engineer, {}));
      QVERIFY(!put(users, QStringLiteral("otto"), Role::Operator, {}));
    }
    QVERIFY(!Users(file, QStringLiteral("anna")).isLocked());
    Users other(file, QStringLiteral("otto"));
    QVERIFY(other.isLocked() && !logIn(other, "anna", ""));
  }

  /// A damaged file must not open the window to everybody.
  void aDamagedFileLocks() {
    const QTemporaryDir folder;
    QVERIFY(base::writeFile(in(folder, "users.json"), "{\"users\": [{").has_value());
    const Users users(in(folder, "users.json"), QStringLiteral("anna"));
    QVERIFY(users.isLocked() && users.fileError().code);
  }

  void aLockedWindowOnlyStops() {
    Cell cell;
    {
      Users users(in(cell.folder, "users.json"), QStringLiteral("x"));
      QVERIFY(put(users, QStringLiteral("anna"), Role::Engineer, QStringLiteral("4711")));
    }
    cell.open();
    hmi::MainWindow& window = *cell.window;
    QTRY_COMPARE_WITH_TIMEOUT(window.startBlockedReason(), QString("The window is locked: log in."),
                              kSoonMs);
    const auto* menu = window.findChild<QToolButton*>(QStringLiteral("menu"));
    QVERIFY(!window.start() && !menu->isEnabled());
    Users& users = window.users();
    QVERIFY(logIn(users, "anna", "4711"));
    QTRY_COMPARE_WITH_TIMEOUT(window.startBlockedReason(), QString(), kSoonMs);
    QVERIFY(menu->isEnabled());
    QSignalSpy finished(&window, &hmi::MainWindow::runFinished);
    QVERIFY(window.start());
    QTRY_VERIFY_WITH_TIMEOUT(window.lastUpdate().counters.executed >= 7, kSoonMs);
    users.lock();
    QVERIFY(window.isRunning());
    auto* stop = window.findChild<QPushButton*>(QStringLiteral("stop"));
    QVERIFY(stop != nullptr && stop->isEnabled());
    QDir().mkpath(QStringLiteral(RIVULET_SCREENSHOTS));
    QVERIFY(window.grab().save(QStringLiteral(RIVULET_SCREENSHOTS "/locked-running.png")));
    QTest::mouseClick(stop, Qt::LeftButton);
    tests::endByHand(window);
    QVERIFY(finished.count() == 1 || finished.wait(kSoonMs));
    QVERIFY(window.lastReport()->outcome == streaming::Outcome::Stopped);
    QCOMPARE(cell.closeAndReadActs(),
             QStringList({"program-start", "connect", "open-program", "log-in", "start", "lock",
                          "stop", "stop", "program-end"}));
  }

  /// An operator starts what is released, with the settings it was released with.
  void anOperatorStartsWhatIsReleased() {
    Cell cell;
    {
      Users users(in(cell.folder, "users.json"), QStringLiteral("x"));
      QVERIFY(put(users, QStringLiteral("anna"), Role::Engineer, QStringLiteral("4711")));
      QVERIFY(put(users, QStringLiteral("otto"), Role::Operator, QStringLiteral("1234")));
    }
    cell.open();
    hmi::MainWindow* window = cell.window.get();
    QVERIFY(logIn(window->users(), "otto", "1234"));
    QTRY_COMPARE_WITH_TIMEOUT(
        window->startBlockedReason(),
        QString("Not released: an engineer has to release this program with these settings."),
        kSoonMs);
    QVERIFY(!window->start());
    QVERIFY(logIn(window->users(), "anna", "4711"));
    window->setStreamSettings(stream(800.0));
    QTRY_COMPARE_WITH_TIMEOUT(window->startBlockedReason(), QString(), kSoonMs);
    window->releases().give();
    window->showPreflight();
    QVERIFY(window->grab().save(QStringLiteral(RIVULET_SCREENSHOTS "/released.png")));
    window->setStreamSettings(stream(900.0));
    QVERIFY(!window->releases().isReleased());
    // In another window, with other settings at hand.
    cell.window.reset();
    cell.open();
    window = cell.window.get();
    QVERIFY(logIn(window->users(), "otto", "1234"));
    QTRY_COMPARE_WITH_TIMEOUT(window->startBlockedReason(), QString(), kSoonMs);
    QVERIFY(window->releases().isReleased());
    QCOMPARE(window->releases().release()->by, std::string("anna"));
    // The operator cannot take it back; the engineer can.
    window->releases().takeBack();
    QVERIFY(window->releases().isReleased());
    QVERIFY(logIn(window->users(), "anna", "4711"));
    window->releases().takeBack();
    QVERIFY(!window->releases().isReleased());
    const QStringList acts = cell.closeAndReadActs();
    QVERIFY(acts.contains("release") && acts.contains("take-back-release"));
  }

  void changedSettingsAreRecorded() {
    const QTemporaryDir folder;
    hmi::Messages messages;
    {
      hmi::Audit audit(messages, folder.path().toStdString(), [] { return base::UtcMs{0}; });
      audit.setWho("anna", "engineer");
      audit.follow(stream(800.0));
      audit.follow(stream(850.0));
      audit.follow(stream(900.0));
      messages.didAct(Act::Start);
    }
    const auto content = journal::readAudit(journal::auditFileIn(folder.path().toStdString()));
    QVERIFY(content->findings.empty());
    QCOMPARE(content->lines.size(), std::size_t{3});
    const journal::AuditEntry& entry = content->lines.front().entry;
    QCOMPARE(entry.act, std::string("change-settings"));
    QCOMPARE(entry.details, (hmi::ActDetails{{"feed", "800 -> 900"}}));
    QVERIFY(entry.who == "anna" && entry.role == "engineer");
    QCOMPARE(content->lines[1].entry.act, std::string("start"));
  }

  void settingsGoThroughTheirFacts() {
    streaming::StreamSettings settings = stream(1234.5);
    settings.parameters.pointsPerLoop = 9;
    settings.deltaMm = 0.25;
    settings.access = streaming::AccessPreference::List;
    streaming::StreamSettings other;
    preparation::applySettings(other, preparation::settingsFacts(settings));
    QCOMPARE(preparation::settingsFacts(other), preparation::settingsFacts(settings));
    preparation::applySettings(other, {{"feed", "-3"}, {"access", "99"}, {"unknown", "1"}});
    QCOMPARE(preparation::settingsFacts(other), preparation::settingsFacts(settings));
  }

  void aTrailThatWasChangedIsAnAlarm() {
    const QTemporaryDir folder;
    const auto path = journal::auditFileIn(folder.path().toStdString());
    for (int i = 0; i < 3; ++i) {
      QVERIFY(journal::appendAudit(path, {i, "anna", "", "start", {}}).has_value());
    }
    std::string text = *base::readFile(path);
    text.replace(text.find("anna"), 4, "otto");
    QVERIFY(base::writeFile(path, text).has_value());
    hmi::Messages messages;
    hmi::Audit audit(messages, folder.path().toStdString(), [] { return base::UtcMs{0}; });
    QSignalSpy raised(&messages, &hmi::Messages::raised);
    audit.refresh();
    QVERIFY(raised.wait(kSoonMs));
    QCOMPARE(audit.content().firstChange(), std::size_t{1});
  }

  void aTrailThatCannotBeWrittenIsAnAlarm() {
    hmi::Messages messages;
    hmi::Audit audit(messages, "/proc/rivulet", [] { return base::UtcMs{0}; });
    QSignalSpy raised(&messages, &hmi::Messages::raised);
    messages.didAct(Act::Start);
    QVERIFY(raised.wait(kSoonMs));
  }
};

RIVULET_TEST(TestOperator)
#include "tst_operator.moc"
