// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QTemporaryDir>
#include <QtTest>
#include <filesystem>

#include "base/file.h"
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
    QVERIFY(writeFile(path("a.part0"), "other"));
    QVERIFY(writeFile(path("a"), "mine"));
    QCOMPARE(readFile(path("a.part0")).value(), std::string("other"));
    QCOMPARE(readFile(path("a")).value(), std::string("mine"));
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
