// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Files and pipes that are slow, full, or hang.

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include <QDir>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QtTest>
#include <filesystem>
#include <string>
#include <system_error>
#include <thread>

#include "base/file.h"
#include "base/random.h"
#include "platform/recording_file.h"
#include "support/patience.h"
#include "support/test_program.h"
#include "trace/frames.h"
#include "trace/recording.h"

using namespace rivulet;
using recorder::RecordingFile;
using recorder::RecordingLimits;

class TestRecordingFile : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;
  [[nodiscard]] std::filesystem::path path(const char* name) const {
    return std::filesystem::path(m_folder.path().toStdString()) / name;
  }

  /// Whether the error gives the system's reason, in the language of the locale.
  static bool says(const base::Error& error, std::errc reason) {
    return error.message.find(std::make_error_code(reason).message()) != std::string::npos;
  }

  /// Text that cannot be compressed much; each seed has another.
  static std::string noise(std::size_t size, std::uint64_t seed = 1) {
    base::Random random(seed);
    std::string text(size, ' ');
    for (char& c : text) {
      c = static_cast<char>('!' + random.below(90));
    }
    return text;
  }

  /// A pipe with a reader that never reads.
  int hangingPipe(const char* name) {
    if (mkfifo(path(name).c_str(), 0600) != 0) {
      qFatal("no pipe can be made");
    }
    return open(path(name).c_str(), O_RDONLY | O_NONBLOCK);
  }

 private Q_SLOTS:
  void everythingArrives() {
    std::string expected;
    {
      auto file = RecordingFile::open(path("whole"));
      QVERIFY(file.has_value());
      const trace::RecordingSink sink = (*file)->sink();
      for (int i = 0; i < 20000; ++i) {
        const std::string line = "line " + std::to_string(i) + "\n";
        QVERIFY(sink(line));
        expected += line;
      }
      QVERIFY((*file)->finish().has_value());
      QVERIFY((*file)->finish().has_value());
      QVERIFY(!sink("too late\n"));
    }
    const std::string bytes = base::readFile(path("whole")).value();
    const trace::Frames frames = trace::readFrames(bytes).value();
    QCOMPARE(frames.text, expected);
    QVERIFY(frames.hasTable && !frames.isCut && frames.damaged == 0);
    QVERIFY(bytes.size() < expected.size() / 2);
  }

  /// Whatever ends the program: what has been written can be read.
  void aKilledProgramKeepsItsRecording() {
    const std::filesystem::path file = path("killed");
    std::string expected;
    for (int i = 0; i < 1000; ++i) {
      expected += "line " + std::to_string(i) + "\n";
    }
    const pid_t child = fork();
    QVERIFY(child >= 0);
    if (child == 0) {
      auto opened = RecordingFile::open(file);
      for (std::size_t at = 0; opened && at < expected.size();) {
        const std::size_t end = expected.find('\n', at) + 1;
        static_cast<void>((*opened)->append(expected.substr(at, end - at)));
        at = end;
      }
      pause();  // as in the middle of a run
      _exit(1);
    }
    const auto isThere = [&] {
      const auto bytes = base::readFile(file);
      return bytes && trace::readFrames(*bytes)->text == expected;
    };
    const bool arrived = QTest::qWaitFor(isThere, tests::kSoonMs);
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    QVERIFY(arrived);
    const trace::Frames frames = trace::readFrames(*base::readFile(file)).value();
    QCOMPARE(frames.text, expected);
    QVERIFY(!frames.hasTable && frames.damaged == 0);
  }

  /// A run whose program is killed: less than a second of the machine's time is lost. The machine
  /// stands while its program does not get the processor, so that a busy computer does not lose
  /// more; the file is in memory, because a busy disk would.
  void aKilledRunLosesLessThanASecond() {
    using namespace std::chrono_literals;
    const bool hasMemory = QFileInfo(QStringLiteral("/dev/shm")).isWritable();
    const QTemporaryDir folder((hasMemory ? QStringLiteral("/dev/shm") : QDir::tempPath()) +
                               QStringLiteral("/recording-XXXXXX"));
    const std::filesystem::path file = folder.filePath(QStringLiteral("run")).toStdString();
    constexpr base::Duration kCycle = 2ms;
    int acknowledged[2];
    QCOMPARE(pipe(acknowledged), 0);
    const pid_t child = fork();
    QVERIFY(child >= 0);
    if (child == 0) {
      auto opened = RecordingFile::open(file);
      trace::RecordingWriter writer((*opened)->sink());
      writer.start({});
      writer.points({});
      for (base::Instant now{};; now += kCycle) {
        writer.sample({now, base::Vec3{1.0, 2.0, 3.0}, 10.0});
        const base::Duration::rep at = now.time_since_epoch().count();
        static_cast<void>(write(acknowledged[1], &at, sizeof at));
        std::this_thread::sleep_for(kCycle);
      }
    }
    close(acknowledged[1]);
    base::Instant last{};
    const auto next = [&] {
      base::Duration::rep at = 0;
      const bool isThere = read(acknowledged[0], &at, sizeof at) == sizeof at;
      last = isThere ? base::Instant{base::Duration{at}} : last;
      return isThere;
    };
    while (last < base::Instant{1730ms} && next()) {
    }
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    while (next()) {
    }
    close(acknowledged[0]);
    QVERIFY(last >= base::Instant{1730ms});
    const auto recording = trace::parseRecording(*base::readFile(file));
    QVERIFY(recording.has_value());
    QVERIFY(!recording->complete && !recording->samples.empty());
    QVERIFY2(last - recording->samples.back().at < 1s,
             qPrintable(QString::number(base::toSeconds(last - recording->samples.back().at))));
    for (std::size_t i = 0; i < recording->samples.size(); ++i) {
      QCOMPARE(recording->samples[i].at, base::Instant{kCycle * static_cast<int>(i)});
    }
  }

  /// Lists larger than the queue wait for the disk; nothing of them is lost.
  void listsWaitForRoom() {
    auto file = RecordingFile::open(path("list"), {std::size_t{1} << 18U});
    QVERIFY(file.has_value());
    const std::string piece(std::size_t{1} << 16U, 'p');
    for (int i = 0; i < 200; ++i) {
      QVERIFY((*file)->append(piece));
    }
    QVERIFY((*file)->finish().has_value());
    QCOMPARE(trace::readFrames(*base::readFile(path("list")))->text.size(),
             std::size_t{200} << 16U);
  }

  /// The records of a stream never wait: this test would not end.
  void aPipeThatHangsIsLeftAlone() {
    const int reader = hangingPipe("hangs");
    QVERIFY(reader >= 0);
    auto file =
        RecordingFile::open(path("hangs"), {std::size_t{1} << 20U, std::chrono::milliseconds{50}});
    QVERIFY(file.has_value());
    constexpr std::size_t kLineBytes = 100;
    std::size_t taken = 0;
    while ((*file)->append(noise(kLineBytes, taken))) {
      ++taken;
      QVERIFY(taken * kLineBytes <= (std::size_t{2} << 20U));
    }
    QVERIFY(taken * kLineBytes > (std::size_t{1} << 19U));
    QVERIFY(!(*file)->append(noise(std::size_t{1} << 19U)));
    const auto finished = (*file)->finish();
    QVERIFY(!finished.has_value());
    QVERIFY(finished.error().message.find("incomplete") != std::string::npos);
    close(reader);
  }

  void aPipeWithoutAReaderIsRefused() {
    QCOMPARE(mkfifo(path("alone").c_str(), 0600), 0);
    const auto file = RecordingFile::open(path("alone"));
    QVERIFY(!file.has_value());
    QVERIFY(file.error().code == base::FileError::NotWritable);
    QVERIFY(file.error().message.find("nobody reads") != std::string::npos);
    QVERIFY(!RecordingFile::open("/nowhere/recording").has_value());
  }

  /// Its reader goes away: no signal ends the program.
  void aBrokenPipeIsSaid() {
    const int reader = hangingPipe("broken");
    auto file = RecordingFile::open(path("broken"));
    QVERIFY(file.has_value());
    close(reader);
    QVERIFY((*file)->append("line\n"));
    QVERIFY(!(*file)->finish().has_value());
  }

  void aFullDiskIsSaid() {
    auto file = RecordingFile::open("/dev/full");
    QVERIFY(file.has_value());
    QVERIFY((*file)->append("line\n"));
    const auto finished = (*file)->finish();
    QVERIFY(!finished.has_value());
    QVERIFY(says(finished.error(), std::errc::no_space_on_device));
    QVERIFY(!(*file)->append("line\n"));
  }

  /// A disk that fills up in mid-run: whoever records hears of it at the next line, not at the end,
  /// and how much is there.
  void aCutIsKnownBeforeTheEnd() {
    using namespace std::chrono_literals;
    rlimit before{};
    QCOMPARE(getrlimit(RLIMIT_FSIZE, &before), 0);
    auto file = RecordingFile::open(path("cut"));
    QVERIFY(file.has_value());
    trace::RecordingWriter writer((*file)->sink());
    QVERIFY(writer.start({}) && writer.points({}));
    for (const base::Duration at : {1s, 3s}) {
      QVERIFY(writer.sample({base::Instant(at), base::Vec3{1.0, 2.0, 3.0}, 10.0}));
    }
    QTRY_COMPARE_WITH_TIMEOUT((*file)->recorded(), base::Duration(2s), tests::kSoonMs);
    QVERIFY((*file)->soFar().has_value());
    rlimit full = before;
    full.rlim_cur = std::filesystem::file_size(path("cut"));
    QCOMPARE(setrlimit(RLIMIT_FSIZE, &full), 0);
    base::Instant now{4s};
    const bool isRefused = QTest::qWaitFor(
        [&] {
          return !writer.sample({now += 1s, base::Vec3{1.0, 2.0, 3.0}, 10.0});
        },
        tests::kSoonMs);
    const auto seen = (*file)->soFar();
    QCOMPARE(setrlimit(RLIMIT_FSIZE, &before), 0);
    QVERIFY(isRefused && !seen.has_value());
    QVERIFY(says(seen.error(), std::errc::file_too_large));
    QVERIFY2(seen.error().message.ends_with("2.0 s of the run are in it."),
             seen.error().message.c_str());
    QCOMPARE((*file)->recorded(), base::Duration(2s));
    QVERIFY(!(*file)->finish().has_value());
    const auto kept = trace::parseRecording(*base::readFile(path("cut")));
    QVERIFY(kept.has_value() && !kept->complete);
    QCOMPARE(kept->samples.size(), std::size_t{2});
  }

  /// A limit of the shell on the size of files does not end the program either.
  void aLimitOfTheShellIsSaid() {
    rlimit before{};
    QCOMPARE(getrlimit(RLIMIT_FSIZE, &before), 0);
    auto file = RecordingFile::open(path("limited"));
    QVERIFY(file.has_value());
    rlimit small = before;
    small.rlim_cur = 1000;
    QCOMPARE(setrlimit(RLIMIT_FSIZE, &small), 0);
    QVERIFY((*file)->append(noise(5000)));
    const auto finished = (*file)->finish();
    QCOMPARE(setrlimit(RLIMIT_FSIZE, &before), 0);
    QVERIFY(!finished.has_value());
    QVERIFY(says(finished.error(), std::errc::file_too_large));
  }
};

RIVULET_TEST(TestRecordingFile)
#include "tst_recording_file.moc"
