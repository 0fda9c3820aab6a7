// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QTemporaryDir>
#include <QtTest>
#include <atomic>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "base/descriptor.h"
#include "base/file.h"
#include "base/file_lock.h"
#include "support/test_program.h"

using namespace rivulet::base;
namespace fs = std::filesystem;

class TestFile : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;
  [[nodiscard]] fs::path path(const char* name) const {
    return fs::path(m_folder.path().toStdString()) / name;
  }
  [[nodiscard]] std::ptrdiff_t filesInFolder() const {
    return std::distance(fs::directory_iterator(m_folder.path().toStdString()),
                         fs::directory_iterator());
  }

 private Q_SLOTS:
  void init() {
    QVERIFY(m_folder.isValid());
    for (const auto& entry : fs::directory_iterator(m_folder.path().toStdString())) {
      fs::remove_all(entry.path());
    }
  }

  void readsWhatWasWritten() {
    const std::string text("a\0b\r\n\xFF", 6);
    QVERIFY(writeFile(path("a"), text));
    QCOMPARE(readFile(path("a")).value(), text);
    QVERIFY(writeFile(path("a"), ""));
    QCOMPARE(readFile(path("a")).value(), std::string());
    const std::string large(300'000, 'x');
    QVERIFY(writeFile(path("a"), large));
    QCOMPARE(readFile(path("a")).value(), large);
    QCOMPARE(filesInFolder(), std::ptrdiff_t{1});
  }

  void keepsAnotherWritersTemporaryFile() {
    // The other one is in the middle of it: it holds the lock.
    const auto other = FileLock::take(path(".a.rivulet0"));
    QVERIFY(other);
    QCOMPARE(writeWhole(other->descriptor(), "other"), 0);
    QVERIFY(writeFile(path("a"), "mine"));
    QCOMPARE(readFile(path(".a.rivulet0")).value(), std::string("other"));
    QCOMPARE(readFile(path("a")).value(), std::string("mine"));
  }

  void makesRoomForWhatAKilledWriterLeft() {
    // As many as there are names.
    for (int i = 0; i < 100; ++i) {
      const std::string left = ".a.rivulet" + std::to_string(i);
      QVERIFY(writeFile(path(left.c_str()), "half of a longer text"));
    }
    QVERIFY(writeFile(path("a"), "mine"));
    QCOMPARE(readFile(path("a")).value(), std::string("mine"));
    QCOMPARE(filesInFolder(), std::ptrdiff_t{100});
  }

  void takesNoFileThatALinkNames() {
    QVERIFY(writeFile(path("precious"), "precious"));
    fs::create_symlink(path("precious"), path(".a.rivulet0"));
    QVERIFY(writeFile(path("a"), "mine"));
    QCOMPARE(readFile(path("precious")).value(), std::string("precious"));
    QCOMPARE(readFile(path("a")).value(), std::string("mine"));
    QVERIFY(!fs::is_symlink(path("a")));
  }

  void manyWritersLeaveAWholeFile() {
    constexpr int kWriters = 4;
    constexpr int kTexts = 50;
    const auto textOf = [](int writer) {
      return std::string(20'000, static_cast<char>('a' + writer));
    };
    std::vector<std::thread> writers;
    std::atomic<int> failures = 0;
    for (int writer = 0; writer < kWriters; ++writer) {
      writers.emplace_back([this, &failures, text = textOf(writer)] {
        for (int i = 0; i < kTexts; ++i) {
          failures += writeFile(path("a"), text) ? 0 : 1;
        }
      });
    }
    for (std::thread& writer : writers) {
      writer.join();
    }
    QCOMPARE(failures.load(), 0);
    const std::string left = readFile(path("a")).value();
    QVERIFY(left == textOf(left.at(0) - 'a'));
    QCOMPARE(filesInFolder(), std::ptrdiff_t{1});
  }

  void lockIsHeldByOne() {
    {
      const auto first = FileLock::tryToTake(path("lock"));
      QVERIFY(first && *first);
      const auto second = FileLock::tryToTake(path("lock"));
      QVERIFY(second && !*second);
    }
    const auto third = FileLock::tryToTake(path("lock"));
    QVERIFY(third && *third);
    const auto missing = FileLock::take(path("no/such/lock"));
    QVERIFY(!missing);
    QVERIFY(missing.error().code == FileError::NotWritable);
  }

  void changesUnderALockAreAllKept() {
    constexpr int kWriters = 4;
    constexpr int kChanges = 25;
    std::vector<std::thread> writers;
    QVERIFY(writeFile(path("count"), "0"));
    for (int writer = 0; writer < kWriters; ++writer) {
      writers.emplace_back([this] {
        for (int i = 0; i < kChanges; ++i) {
          const auto lock = FileLock::take(path("lock"));
          const int count = std::stoi(readFile(path("count")).value());
          static_cast<void>(writeFile(path("count"), std::to_string(count + 1)));
        }
      });
    }
    for (std::thread& writer : writers) {
      writer.join();
    }
    QCOMPARE(readFile(path("count")).value(), std::to_string(kWriters * kChanges));
  }

  void keepsLinksAndPermissions() {
    QVERIFY(writeFile(path("a"), "old"));
    fs::permissions(path("a"), fs::perms::owner_read | fs::perms::owner_write);
    fs::create_symlink(path("a"), path("link"));
    QVERIFY(writeFile(path("link"), "new"));
    QVERIFY(fs::is_symlink(path("link")));
    QCOMPARE(readFile(path("a")).value(), std::string("new"));
    QVERIFY(fs::status(path("a")).permissions() ==
            (fs::perms::owner_read | fs::perms::owner_write));
  }

  void writesToADeviceWithoutReplacingIt() {
    QVERIFY(writeFile("/dev/null", "text"));
    QVERIFY(fs::is_character_file("/dev/null"));
  }

  void saysWhatCannotBeRead() {
    const auto missing = readFile(path("missing"));
    QVERIFY(!missing);
    QVERIFY(missing.error().code == FileError::Unreadable);
    QVERIFY(missing.error().text().find("missing: The file cannot be read") != std::string::npos);
    const auto folder = readFile(m_folder.path().toStdString());
    QVERIFY(!folder);
    QVERIFY(folder.error().message.find("folder") != std::string::npos);
  }

  void saysWhatCannotBeWritten() {
    const auto missing = writeFile(path("no/such/folder"), "x");
    QVERIFY(!missing);
    QVERIFY(missing.error().code == FileError::NotWritable);
    const auto folder = writeFile(m_folder.path().toStdString(), "x");
    QVERIFY(!folder);
    QVERIFY(folder.error().code == FileError::NotWritable);
    // A full disk is noticed, not only a missing one.
    const auto full = writeFile("/dev/full", "x");
    QVERIFY(!full);
    QVERIFY(full.error().code == FileError::NotWritable);
    QCOMPARE(filesInFolder(), std::ptrdiff_t{0});
  }
};

RIVULET_TEST(TestFile)
#include "tst_file.moc"
