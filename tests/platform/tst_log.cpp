// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QTemporaryDir>
#include <QtTest>
#include <fstream>
#include <sstream>

#include "platform/log.h"
#include "support/test_program.h"

using namespace rivulet;
namespace fs = std::filesystem;

namespace {

std::string textOf(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

}  // namespace

class TestLog : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void listenersHearFromInfoOnWhileTheyLive() {
    std::vector<log::Line> heard;
    {
      const log::Listener listener([&](const log::Line& line) { heard.push_back(line); });
      log::logger().debug("not this");
      log::logger().info("point {}", 7);
      log::logger().error("no answer");
    }
    log::logger().error("too late");
    QCOMPARE(heard.size(), std::size_t{2});
    QCOMPARE(heard[0].text, std::string("point 7"));
    QVERIFY(heard[0].level == spdlog::level::info);
    QVERIFY(heard[1].level == spdlog::level::err);
  }

  void aFileThatCannotBeWrittenIsSaid() {
    const QTemporaryDir folder;
    const fs::path blocked = fs::path(folder.path().toStdString()) / "file";
    std::ofstream(blocked) << "no folder";
    const auto done = log::setUp({"blocked", "", blocked, false});
    QVERIFY(!done);
    QVERIFY(done.error().message.find("Check the folder") != std::string::npos);
  }

  /// Levels, format and rotation. The sinks stay, so this is one test.
  void theFileHasItsLevelAndRotates() {
    const QTemporaryDir temporary;
    const fs::path folder = fs::path(temporary.path().toStdString()) / "runs";
    QVERIFY(log::setUp({"warner", "warning", folder, false}));
    QVERIFY(log::setUp({"rivulet", "", folder, false}));
    log::logger().info("started");
    log::logger().warn("late");
    log::logger().flush();
    const std::string all = textOf(folder / "rivulet.log");
    QVERIFY(all.find(" info started\n") != std::string::npos);
    QVERIFY(all.find(" warning late\n") != std::string::npos);
    QCOMPARE(textOf(folder / "warner.log").find("started"), std::string::npos);
    for (int i = 0; i < 5000; ++i) {
      log::logger().info(std::string(1000, 'x'));
    }
    log::logger().flush();
    QVERIFY(fs::file_size(folder / "rivulet.log") <= log::kFileBytesMax);
    QVERIFY(fs::exists(folder / "rivulet.2.log"));
    QVERIFY(!fs::exists(folder / "rivulet.3.log"));
  }

  void levels() {
    const std::vector<std::string> names = log::levelNames();
    QVERIFY(std::find(names.begin(), names.end(), "debug") != names.end());
    QVERIFY(std::find(names.begin(), names.end(), "off") != names.end());
  }
};

RIVULET_TEST(TestLog)
#include "tst_log.moc"
