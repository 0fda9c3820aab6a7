// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "journal/audit.h"

#include <QTemporaryDir>
#include <QTest>

#include "base/file.h"
#include "journal/line_file.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace rivulet::journal;

namespace {

namespace fs = std::filesystem;

AuditEntry entry(int number) {
  return {1'795'336'205'123 + number,
          "anna",
          "engineer",
          "change-settings",
          {{"feed", "829 -> " + std::to_string(900 + number)}}};
}

/// Findings as "2 changed, 3 chain-broken".
QString print(const AuditContent& content) {
  QStringList texts;
  for (const AuditFinding& finding : content.findings) {
    const std::string_view name = faultName(finding.fault);
    texts << QStringLiteral("%1 %2")
                 .arg(finding.line)
                 .arg(QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size())));
  }
  return texts.join(QStringLiteral(", "));
}

class Trail {
 public:
  explicit Trail(int entries) {
    for (int i = 0; i < entries; ++i) {
      QVERIFY(appendAudit(path, entry(i)).has_value());
    }
  }
  [[nodiscard]] std::vector<std::string> lines() const { return readLines(path)->lines; }
  void write(const std::vector<std::string>& lines) const {
    std::string text;
    for (const std::string& line : lines) {
      text += line + '\n';
    }
    QVERIFY(base::writeFile(path, text).has_value());
  }
  [[nodiscard]] QString findings() const { return print(*readAudit(path)); }

  QTemporaryDir folder;
  fs::path path = auditFileIn(folder.path().toStdString());
};

}  // namespace

class TestAudit : public QObject {
  Q_OBJECT

 private slots:
  void whatWasWrittenIsRead() {
    const Trail trail(3);
    const auto content = readAudit(trail.path);
    QVERIFY(content && content->findings.empty() && content->firstChange() == 0);
    QCOMPARE(content->lines.size(), std::size_t{3});
    QVERIFY(content->lines[1].entry == entry(1) && content->lines[1].number == 2);
    QCOMPARE(content->lastHash.size(), std::size_t{64});
    QVERIFY(readAudit(trail.path.string() + "-none")->lines.empty());
  }

  void aChangedLineIsFound() {
    const Trail trail(4);
    auto lines = trail.lines();
    lines[1].replace(lines[1].find("anna"), 4, "otto");
    trail.write(lines);
    QCOMPARE(trail.findings(), QString("2 changed, 3 chain-broken"));
    QCOMPARE(readAudit(trail.path)->firstChange(), std::size_t{2});
  }

  void theLastLineIsProtectedToo() {
    const Trail trail(2);
    auto lines = trail.lines();
    lines[1].replace(lines[1].find("anna"), 4, "otto");
    trail.write(lines);
    QCOMPARE(trail.findings(), QString("2 changed"));
  }

  void removedAndInsertedLinesAreFound() {
    const Trail trail(5);
    const auto whole = trail.lines();
    auto lines = whole;
    lines.erase(lines.begin() + 2);
    trail.write(lines);
    QCOMPARE(trail.findings(), QString("3 chain-broken, 5 tail-missing"));
    lines = whole;
    lines.insert(lines.begin() + 2, whole[0]);
    trail.write(lines);
    QCOMPARE(trail.findings(), QString("3 chain-broken, 4 chain-broken"));
    // The first line cannot go either.
    lines = whole;
    lines.erase(lines.begin());
    trail.write(lines);
    QCOMPARE(trail.findings(), QString("1 chain-broken, 5 tail-missing"));
  }

  /// The end of the trail, or all of it.
  void whatIsMissingAtTheEndIsSaid() {
    const Trail trail(5);
    QVERIFY(readAudit(trail.path)->hasHead);
    const auto whole = trail.lines();
    trail.write({whole.begin(), whole.begin() + 3});
    QCOMPARE(trail.findings(), QString("4 tail-missing"));
    QCOMPARE(readAudit(trail.path)->findings.front().missing, std::size_t{2});
    QCOMPARE(QString::fromStdString(describe(readAudit(trail.path)->findings.front())),
             QString("2 lines are missing from line 4 on: the end of the trail was cut off."));
    QCOMPARE(readAudit(trail.path)->firstChange(), std::size_t{4});
    // Who writes on does not hide it.
    QVERIFY(appendAudit(trail.path, entry(9)).has_value());
    QVERIFY(appendAudit(trail.path, entry(10)).has_value());
    QCOMPARE(trail.findings(), QString("4 tail-missing"));
    trail.write({});
    QCOMPARE(trail.findings(), QString("4 tail-missing, 1 tail-missing"));
    std::filesystem::remove(trail.path);
    QCOMPARE(readAudit(trail.path)->findings.back().missing, std::size_t{5});
  }

  /// A new trail that is sound by itself.
  void aReplacedTrailIsFound() {
    const Trail trail(3);
    const auto whole = trail.lines();
    std::filesystem::remove(trail.path);
    for (int i = 5; i < 9; ++i) {
      QVERIFY(appendAudit(trail.path, entry(i)).has_value());
    }
    const auto other = trail.lines();
    QCOMPARE(trail.findings(), QString("1 tail-missing"));
    const Trail second(4);
    second.write(other);
    QCOMPARE(second.findings(), QString("4 replaced"));
  }

  /// Killed between the line and its head: nobody is suspected.
  void aHeadThatIsBehindIsNoChange() {
    const Trail trail(2);
    const auto head = base::readFile(auditHeadOf(trail.path));
    QVERIFY(head && appendAudit(trail.path, entry(2)).has_value());
    QVERIFY(base::writeFile(auditHeadOf(trail.path), *head).has_value());
    QCOMPARE(trail.findings(), QString());
    QVERIFY(appendAudit(trail.path, entry(3)).has_value());
    QCOMPARE(trail.findings(), QString());
    trail.write({});
    QCOMPARE(readAudit(trail.path)->findings.back().missing, std::size_t{4});
  }

  /// Where there is no head, that is said, and nobody else may read it where there is one.
  void theHeadIsKeptApart() {
    const Trail trail(1);
    const fs::path head = auditHeadOf(trail.path);
    const auto mine = fs::perms::owner_read | fs::perms::owner_write;
    QVERIFY(fs::status(head).permissions() == mine);
    QVERIFY(fs::status(head.parent_path()).permissions() == fs::perms::owner_all);
    fs::remove(head);
    QVERIFY(!readAudit(trail.path)->hasHead);
    QCOMPARE(trail.findings(), QString());
  }

  /// Power was lost while a line was written: the trail goes on, and nobody is suspected.
  void aCutLineIsNoChange() {
    const Trail trail(2);
    auto lines = trail.lines();
    const std::string third = lines[1].substr(0, 40);
    QVERIFY(base::writeFile(trail.path, lines[0] + '\n' + lines[1] + '\n' + third).has_value());
    QCOMPARE(trail.findings(), QString("3 not-a-line"));
    QVERIFY(appendAudit(trail.path, entry(9)).has_value());
    QVERIFY(appendAudit(trail.path, entry(10)).has_value());
    QCOMPARE(trail.findings(), QString("3 not-a-line"));
    QCOMPARE(readAudit(trail.path)->firstChange(), std::size_t{0});
    QCOMPARE(readAudit(trail.path)->lines.size(), std::size_t{4});
  }

  void exports() {
    const Trail trail(1);
    AuditEntry odd = entry(1);
    odd.who = "=cmd \"x\"";
    QVERIFY(appendAudit(trail.path, odd).has_value());
    const auto content = readAudit(trail.path);
    const QString csv = QString::fromStdString(auditCsv(*content));
    QCOMPARE(csv.split("\r\n").at(1),
             QString("1,2026-11-22T08:30:05.123Z,\"anna\",\"engineer\",\"change-settings\","
                     "\"feed=829 -> 900\""));
    QVERIFY(csv.contains("\"'=cmd \"\"x\"\"\""));
    QVERIFY(auditJson(*content).find("\"feed\": \"829 -> 900\"") != std::string::npos);
  }
};

RIVULET_TEST(TestAudit)
#include "tst_audit.moc"
