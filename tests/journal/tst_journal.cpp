// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QTemporaryDir>
#include <QTest>
#include <fstream>
#include <thread>

#include "base/file.h"
#include "journal/alarm_history.h"
#include "journal/line_file.h"
#include "journal/writer.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace rivulet::journal;

namespace {

namespace fs = std::filesystem;

void appendRaw(const fs::path& path, const std::string& text) {
  std::ofstream(path, std::ios::app) << text;
}

alarm::Transition transition(alarm::Code code, const std::string& subject, alarm::Event event) {
  alarm::Transition made;
  made.at = 1'795'336'205'123;
  made.event = event;
  made.alarm.code = code;
  made.alarm.arguments = {subject};
  made.alarm.raisedAt = made.at;
  made.alarm.isAcknowledged = event == alarm::Event::Acknowledged;
  return made;
}

}  // namespace

class TestJournal : public QObject {
  Q_OBJECT

 private slots:
  void linesFollowEachOther() {
    const QTemporaryDir folder;
    const fs::path path = fs::path(folder.path().toStdString()) / "new" / "a.jsonl";
    QVERIFY(readLines(path)->lines.empty());
    const auto count = [](std::string_view last) { return std::string(last) + "x"; };
    for (int i = 0; i < 3; ++i) {
      QVERIFY(appendLine(path, count).has_value());
    }
    QCOMPARE(readLines(path)->lines, (std::vector<std::string>{"x", "xx", "xxx"}));
    QVERIFY(fs::status(path).permissions() == (fs::perms::owner_read | fs::perms::owner_write));
    // Power was lost in the middle of a line.
    appendRaw(path, "xx");
    QVERIFY(readLines(path)->isCut);
    QCOMPARE(readLines(path)->lines.size(), std::size_t{3});
    QVERIFY(appendLine(path, count).has_value());
    QVERIFY(!readLines(path)->isCut);
    QCOMPARE(readLines(path)->lines, (std::vector<std::string>{"x", "xx", "xxx", "xx", "xxxx"}));
  }

  /// Each line is made from the one before it, whoever wrote that.
  void writersTakeTurns() {
    const QTemporaryDir folder;
    const fs::path path = fs::path(folder.path().toStdString()) / "a";
    constexpr int kLines = 40;
    const auto write = [&path] {
      for (int i = 0; i < kLines; ++i) {
        QVERIFY(appendLine(path, [](std::string_view last) {
                  return std::to_string(last.empty() ? 1 : std::stoi(std::string(last)) + 1);
                }).has_value());
      }
    };
    std::thread other(write);
    write();
    other.join();
    QCOMPARE(readLines(path)->lines.back(), std::to_string(2 * kLines));
  }

  void aFullFileGivesWay() {
    const QTemporaryDir folder;
    const fs::path path = fs::path(folder.path().toStdString()) / "a";
    for (int i = 0; i < 5; ++i) {
      QVERIFY(appendLine(
                  path, [i](std::string_view) { return std::to_string(i); }, 4)
                  .has_value());
    }
    QCOMPARE(readLines(path)->lines, std::vector<std::string>{"4"});
    QCOMPARE(readLines(path.string() + ".1")->lines, (std::vector<std::string>{"2", "3"}));
  }

  void whatCannotBeWrittenIsSaid() {
    const auto failed =
        appendLine("/proc/rivulet/a", [](std::string_view) { return std::string("x"); });
    QVERIFY(!failed && failed.error().code == base::FileError::NotWritable);
  }

  void theHistoryReadsWhatItWrote() {
    const QTemporaryDir folder;
    const AlarmHistory history(folder.path().toStdString());
    auto lost = transition(alarm::Code::ConnectionLost, "opc.tcp://cell", alarm::Event::Raised);
    lost.alarm.error = base::makeError(base::FileError::Unreadable, "No answer.", "cell");
    QVERIFY(history.append(lost).has_value());
    auto changed = transition(alarm::Code::FileChanged, "a.nc", alarm::Event::Acknowledged);
    changed.by = "anna";
    QVERIFY(history.append(changed).has_value());
    appendRaw(history.path(), "not a line of it\n{\"at\":\"2026");
    const auto content = history.read([](std::string_view kind, int value) {
      return kind == "file" ? make_error_code(static_cast<base::FileError>(value))
                            : std::error_code();
    });
    QVERIFY(content.has_value());
    QCOMPARE(content->dropped, std::size_t{2});
    QCOMPARE(content->transitions.size(), std::size_t{2});
    const alarm::Transition& first = content->transitions.front();
    QVERIFY(first.alarm.code == alarm::Code::ConnectionLost && first.at == lost.at);
    QCOMPARE(first.alarm.arguments, lost.alarm.arguments);
    QVERIFY(first.alarm.error.code == base::FileError::Unreadable);
    QCOMPARE(first.alarm.error.text(), std::string("cell: No answer."));
    QVERIFY(first.alarm.state() == alarm::State::Unacknowledged);
    QCOMPARE(content->transitions.back().by, std::string("anna"));
    const auto open = unacknowledged(content->transitions);
    QCOMPARE(open.size(), std::size_t{1});
    QVERIFY(open.front().code == alarm::Code::ConnectionLost);
  }

  void theWriterFinishesWhatItWasGiven() {
    int done = 0;
    {
      Writer writer;
      for (int i = 0; i < 100; ++i) {
        writer.add([] { return base::Result<void>{}; },
                   [&done](const base::Result<void>& result) { done += result ? 1 : 0; });
      }
    }
    QCOMPARE(done, 100);
  }
};

RIVULET_TEST(TestJournal)
#include "tst_journal.moc"
