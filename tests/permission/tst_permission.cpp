// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "permission/permission.h"

#include <QTest>

#include "support/test_program.h"

using namespace rivulet::permission;

namespace {

constexpr std::array kActs{Act::Stop,           Act::Hold,        Act::Continue,   Act::Start,
                           Act::Resume,         Act::Watch,       Act::Correct,    Act::OpenProgram,
                           Act::ChangeSettings, Act::Connect,     Act::Disconnect, Act::Calibrate,
                           Act::Release,        Act::Acknowledge, Act::Shelve,     Act::SetUpUsers,
                           Act::Trust,          Act::Override};

}  // namespace

class TestPermission : public QObject {
  Q_OBJECT

 private slots:
  void anEngineerMayDoEverything() {
    for (const Act act : kActs) {
      QVERIFY(!refusal({Role::Engineer, false}, act, false));
    }
  }

  void stopAlwaysWorks() {
    for (const Role role : {Role::Operator, Role::Engineer}) {
      for (const bool isLocked : {false, true}) {
        QVERIFY(!refusal({role, isLocked}, Act::Stop, false));
      }
    }
  }

  void aLockedWindowOnlyStops() {
    for (const Act act : kActs) {
      QCOMPARE(refusal({Role::Engineer, true}, act) == Refusal::Locked, act != Act::Stop);
    }
    QVERIFY(!refusal({Role::Engineer, true}, Act::LogIn));
  }

  void anOperatorStartsWhatIsReleased() {
    const Standing standing{Role::Operator, false};
    for (const Act act : {Act::Start, Act::Resume}) {
      QVERIFY(!refusal(standing, act, true));
      QVERIFY(refusal(standing, act, false) == Refusal::NotReleased);
      // What may execute old points again is an engineer's, even if one has released it.
      QVERIFY(refusal(standing, act, true, true) == Refusal::NeedsEngineer);
      QVERIFY(!refusal({Role::Engineer, false}, act, true, true));
    }
    for (const Act act :
         {Act::ChangeSettings, Act::Calibrate, Act::Release, Act::SetUpUsers, Act::Trust}) {
      QVERIFY(refusal(standing, act) == Refusal::NeedsEngineer);
    }
    for (const Act act :
         {Act::Hold, Act::Continue, Act::Override, Act::OpenProgram, Act::Acknowledge}) {
      QVERIFY(!refusal(standing, act, false));
    }
    QVERIFY(overridePercentMax(Role::Operator) < overridePercentMax(Role::Engineer));
  }

  void theLastWordOnAJobCounts() {
    const Job job{"abc", "F=100", "2026"};
    const Job other{"abc", "F=200", "2026"};
    std::vector<Release> releases{{job, "a.nc", "anna", 1, false}};
    QVERIFY(releaseOf(releases, job) != nullptr);
    QVERIFY(releaseOf(releases, other) == nullptr);
    QVERIFY(releaseOf(releases, {"abd", "F=100", "2026"}) == nullptr);
    QVERIFY(releaseOf(releases, {"abc", "F=100", ""}) == nullptr);
    releases.push_back({other, "a.nc", "anna", 2, false});
    QCOMPARE(lastReleaseOf(releases, "abc")->job.settings, std::string("F=200"));
    releases.push_back({other, "a.nc", "anna", 3, true});
    QVERIFY(releaseOf(releases, other) == nullptr);
    QCOMPARE(lastReleaseOf(releases, "abc")->job.settings, std::string("F=100"));
    releases.push_back({job, "a.nc", "anna", 4, true});
    QVERIFY(lastReleaseOf(releases, "abc") == nullptr);
    releases.push_back({job, "a.nc", "otto", 5, false});
    QCOMPARE(releaseOf(releases, job)->by, std::string("otto"));
  }

  void names() {
    for (const Act act : kActs) {
      QVERIFY(actOfName(actName(act)) == act);
    }
    QVERIFY(roleOfName("operator") == Role::Operator && !roleOfName("king"));
  }
};

RIVULET_TEST(TestPermission)
#include "tst_permission.moc"
