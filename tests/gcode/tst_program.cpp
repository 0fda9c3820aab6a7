// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QTemporaryDir>
#include <QtTest>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <set>

#include "gcode/program.h"
#include "gcode_text.h"
#include "support/test_program.h"

using namespace rivulet;
using gcode::GcodeError;

namespace {

std::filesystem::path write(const QTemporaryDir& folder, const std::string& text) {
  const std::filesystem::path path =
      std::filesystem::path(folder.path().toStdString()) / "program.nc";
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

}  // namespace

class TestProgram : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void loadsTheSampleProgram() {
    const auto program = gcode::loadProgram(RIVULET_SOURCE_DIR "/resources/programs/scorpion.tap");
    QVERIFY(program.has_value());
    QCOMPARE(program->name, std::string("scorpion.tap"));
    QCOMPARE(program->text.size(), std::size_t{4685});
    QVERIFY(program->isStreamable());
    QCOMPARE(QByteArray::fromStdString(test::printFindings(program->diagnostics)),
             QByteArray("2:1 note ignored-code T | 2:3 note ignored-code M6 | "
                        "4:15 note ignored-code S | 4:21 note ignored-code M3"));
    const gcode::Statistics& statistics = program->statistics;
    QCOMPARE(statistics.lines, std::size_t{276});
    QCOMPARE(statistics.motions, (std::array<std::size_t, 4>{7, 266, 0, 0}));
    QCOMPARE(statistics.points, std::size_t{273});
    QCOMPARE(statistics.minMm, (base::Vec3{0.0, 0.0, -3.0}));
    QCOMPARE(statistics.maxMm, (base::Vec3{206.12, 235.389, 10.0}));
    QVERIFY(std::abs(statistics.cutLengthMm - 2450.806) < 1e-3);
    QCOMPARE(statistics.feedsMmPerMin, (std::vector<double>{600.0, 1800.0}));
    const gcode::TrajectoryPoint& first = program->trajectory.points.front();
    QVERIFY(std::isnan(first.positionMm.x));
    QCOMPARE(first.positionMm.z, 10.0);
    QCOMPARE(first.kind, gcode::MoveKind::Rapid);
    QCOMPARE(first.line.value, 3U);
    const gcode::PointList list = gcode::streamPoints(program->trajectory, {0, 0, 50});
    QCOMPARE(list.points.size() + list.merged, std::size_t{273});
    QCOMPARE(list.points.front().positionMm, (base::Vec3{0, 0, 10}));
  }

  /// What the text editor, the office program or the transfer made of a text is read, or named.
  void readsHowTextsAreStored() {
    using namespace std::string_literals;
    const auto load = [](const std::string& text, gcode::Dialect dialect) {
      gcode::LoadOptions options;
      options.dialect = dialect;
      const auto program = gcode::interpretProgram("a", text, options);
      return program ? test::printPoints(program->trajectory) + " / " +
                           test::printProblems(program->diagnostics)
                     : "not read"s;
    };
    const std::string wide = "\xFF\xFEG\0000\0X\0001\0\r\0\n\0X\0002\0"s;
    QCOMPARE(load(wide, gcode::Dialect::Grbl), "1 R X1 Y? Z? | 2 R X2 Y? Z? / "s);
    QCOMPARE(load("G0\xC2\xA0X1", gcode::Dialect::Grbl),
             "1 R X1 Y? Z? / 1:3 error invisible-character U+00A0"s);
    QCOMPARE(load("G0 X1\xE2\x80\x8BY2", gcode::Dialect::Sinumerik),
             "1 R X1 Y2 Z? / 1:6 error invisible-character U+200B"s);
    QCOMPARE(load("G0 X1 0\nY1", gcode::Dialect::Sinumerik),
             "2 R X? Y1 Z? / 1:5 error blank-in-number 1 0"s);
    QCOMPARE(load("G0 X1 (A (B) Y9) Z5", gcode::Dialect::LinuxCnc),
             "1 R X1 Y? Z5 / 1:7 error comment-nested (A (B) Y9)"s);
    QCOMPARE(load("G0 X1 (END MILL (5MM)) Z5", gcode::Dialect::LinuxCnc),
             "1 R X1 Y? Z5 / 1:7 warning comment-nested (END MILL (5MM))"s);
    // One value in a thousand as "e-05": its word is never accepted in part.
    gcode::LoadOptions options;
    options.dialect = gcode::Dialect::Grbl;
    options.accepted = {"E"};
    const auto program = gcode::interpretProgram("a", "G0 X1 Y1\nG1 X8.775e-05 F100", options);
    QVERIFY(program.has_value());
    QVERIFY(!program->isStreamable());
    QCOMPARE(test::printProblems(program->diagnostics), "2:5 error number-malformed 8.775e-05"s);
    // A line of a million bytes.
    std::string longLine = "G0";
    for (int i = 0; i < 90000; ++i) {
      longLine += " (a comment)";
    }
    QCOMPARE(load(longLine + " X1", gcode::Dialect::Grbl), "1 R X1 Y? Z? / "s);
  }

  void hashTellsVersionsApart() {
    const auto one = gcode::interpretProgram("a", "G0 X1");
    const auto two = gcode::interpretProgram("a", "G0 X2");
    const auto same = gcode::interpretProgram("b", "G0 X1");
    QVERIFY(one && two && same);
    QCOMPARE(one->hash.size(), std::size_t{16});
    QVERIFY(one->hash != two->hash);
    QCOMPARE(one->hash, same->hash);
    // A change of any byte, at any place, is another program.
    std::string text = "G0 X1\nG1 X2 F100\nG1 X3\nM30\n";
    std::set<std::string> hashes{gcode::interpretProgram("a", text)->hash};
    for (std::size_t at = 0; at < text.size(); ++at) {
      std::string other = text;
      other[at] = other[at] == ' ' ? '\t' : ' ';
      QVERIFY(hashes.insert(gcode::interpretProgram("a", other)->hash).second);
    }
    QVERIFY(hashes.insert(gcode::interpretProgram("a", text + "\n")->hash).second);
  }

  void empty_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("code");
    const auto add = [](const char* text, GcodeError code) {
      QTest::newRow(QByteArray(text).simplified().constData())
          << QByteArray(text) << static_cast<int>(code);
    };
    add("", GcodeError::EmptyProgram);
    add("\n\r\n  \n", GcodeError::EmptyProgram);
    add("%\n(only a comment)\n; another\nO12\nN5\n%", GcodeError::EmptyProgram);
  }

  void empty() {
    QFETCH(const QByteArray, text);
    QFETCH(const int, code);
    const auto program = gcode::interpretProgram("a.nc", text.toStdString());
    QVERIFY(!program);
    QVERIFY(program.error().code == static_cast<GcodeError>(code));
    QCOMPARE(program.error().context, std::string("a.nc"));
    QVERIFY(program.error().message.find(": choose a") != std::string::npos);
  }

  void motionlessProgramsLoadAndAreNotStreamed() {
    for (const char* text : {"G90 G21\nM30", "G4 X5", "M30\nG0 X1"}) {
      const auto program = gcode::interpretProgram("a.nc", text);
      QVERIFY(program.has_value());
      QVERIFY(program->isUnderstood());
      QVERIFY(!program->isStreamable());
      QVERIFY(test::printProblems(program->diagnostics).find("no-motion") != std::string::npos);
    }
  }

  void rotaryAxesMayBeTurnedButNotDirectionsGiven() {
    const auto set = gcode::interpretProgram("a.nc", "G0 X1 B90\nG1 X2 F60");
    QVERIFY(set && set->isStreamable());
    const auto turned = gcode::interpretProgram("a.nc", "G0 X1 B90\nG1 X2 B91 F60");
    QVERIFY(turned && turned->isStreamable());
    QVERIFY(gcode::turnedAxes(set->trajectory) == base::RotarySet{});
    QVERIFY(gcode::turnedAxes(turned->trajectory) == (base::RotarySet{false, true, false}));
    const auto tip = gcode::interpretProgram("a.nc", "TRAORI\nG0 X1 B90\nG1 X2 B91 F60");
    QVERIFY(tip && tip->isUnderstood() && !tip->isStreamable());
    const auto tipOff =
        gcode::interpretProgram("a.nc", "TRAORI\nG0 X1 B90\nTRAFOOF\nG1 X2 B91 F60");
    QVERIFY(tipOff && tipOff->isStreamable());
    const auto directions = gcode::interpretProgram("a.nc", "G0 X1\nG1 X2 A3=0 B3=1 C3=1 F60");
    QVERIFY(directions && directions->isUnderstood() && !directions->isStreamable());
  }

  /// What a program leaves open is where the axis stands; a point differs in its angles alone too.
  void pointsCarryAngles() {
    const auto program = gcode::interpretProgram("a.nc", "G0 X1\nG1 B5 F60\nB6\nB6\nX2 C90");
    QVERIFY(program.has_value());
    const gcode::PointList list =
        gcode::streamPoints(program->trajectory, {9.0, 8.0, 7.0}, {1.0, 2.0, 3.0});
    QCOMPARE(list.points.size(), std::size_t{4});
    QCOMPARE(list.merged, std::size_t{1});
    QVERIFY(list.points[0].rotaryDeg == (base::RotaryDeg{1.0, 2.0, 3.0}));
    QVERIFY(list.points[1].rotaryDeg == (base::RotaryDeg{1.0, 5.0, 3.0}));
    QVERIFY(list.points[2].positionMm == (base::Vec3{1.0, 8.0, 7.0}));
    QVERIFY(list.points[3].rotaryDeg == (base::RotaryDeg{1.0, 6.0, 90.0}));
  }

  /// What is not understood stops the load, unless the user has accepted it by name.
  void acceptedByName() {
    const std::string text = "G0 X1\nG28 Z0\nCYCLE83(1,2)\nSUPA X5\nG1 X2 F60\n";
    gcode::LoadOptions options;
    std::vector<std::string> names;
    const auto refused = gcode::interpretProgram("a.nc", text, options);
    QVERIFY(refused && !refused->isUnderstood());
    for (const gcode::Diagnostic& diagnostic : refused->diagnostics) {
      if (diagnostic.severity == gcode::Severity::Error) {
        names.push_back(gcode::acceptableName(diagnostic));
      }
    }
    QCOMPARE(names, (std::vector<std::string>{"G28", "CYCLE83", "SUPA"}));
    options.accepted = {"G28", "CYCLE83"};
    const auto partly = gcode::interpretProgram("a.nc", text, options);
    QVERIFY(partly && !partly->isUnderstood());
    options.accepted = names;
    const auto accepted = gcode::interpretProgram("a.nc", text, options);
    QVERIFY(accepted && accepted->isStreamable());
    QCOMPARE(QByteArray::fromStdString(test::printProblems(accepted->diagnostics)),
             QByteArray("2:1 warning accepted G28 | 3:1 warning accepted CYCLE83 | "
                        "4:1 warning accepted SUPA"));
    QCOMPARE(accepted->trajectory.points.size(), std::size_t{2});
    // A word that is no word at all cannot be accepted.
    const auto malformed = gcode::interpretProgram("a.nc", "G0 X1,5");
    QVERIFY(malformed && gcode::acceptableName(malformed->diagnostics.front()).empty());
  }

  void subprogramsBesideTheFile() {
    const QTemporaryDir folder;
    const auto path = write(folder, "MSG(\"a\")\nG0 X0 Y0 Z0\nHOLE(5)\nHOLE(7)\nM30\n");
    std::ofstream(path.parent_path() / "hole.spf")
        << "PROC HOLE(REAL DEPTH)\nG1 Z=-DEPTH F100\nG0 Z1\nRET\n";
    const auto program = gcode::loadProgram(path);
    QVERIFY(program.has_value());
    QCOMPARE(QByteArray::fromStdString(test::printPoints(program->trajectory)),
             QByteArray("2 R X0 Y0 Z0 | 3 L X0 Y0 Z-5 F100 | 3 R X0 Y0 Z1 | 4 L X0 Y0 Z-7 F100 | "
                        "4 R X0 Y0 Z1"));
    std::filesystem::remove(path.parent_path() / "hole.spf");
    const auto missing = gcode::loadProgram(path);
    QVERIFY(missing && !missing->isUnderstood());
  }

  void progressAndCancel() {
    std::string text = "G0 X0 Y0 Z0\n";
    for (int i = 0; i < 200'000; ++i) {
      text += "G1 X1 F60\n";
    }
    gcode::LoadOptions options;
    double last = 0.0;
    int calls = 0;
    options.progress = [&](double share) {
      ++calls;
      const bool grows = share >= last && share <= 1.0;
      last = share;
      return grows && calls < 6;
    };
    const auto cancelled = gcode::interpretProgram("a.nc", text, options);
    QVERIFY(!cancelled);
    QVERIFY(cancelled.error().code == GcodeError::Cancelled);
    QCOMPARE(calls, 6);
    QVERIFY(last > 0.3 && last < 0.7);
  }

  void notStreamableWithAnError() {
    const auto program = gcode::interpretProgram("a.nc", "G0 X1\nG28 X0\nG0 X2");
    QVERIFY(program.has_value());
    QVERIFY(!program->isStreamable());
    const auto warned = gcode::interpretProgram("a.nc", "G21 G1 X1");
    QVERIFY(warned.has_value());
    QVERIFY(warned->isStreamable());
    QCOMPARE(warned->diagnostics.size(), std::size_t{1});
  }

  void unreadableFiles() {
    const QTemporaryDir folder;
    const std::string path = folder.path().toStdString();
    const auto missing = gcode::loadProgram(path + "/missing.nc");
    QVERIFY(!missing);
    QVERIFY(missing.error().code == GcodeError::FileUnreadable);
    QCOMPARE(missing.error().text(),
             path + "/missing.nc: The file does not exist: check its name and folder.");
    const auto isFolder = gcode::loadProgram(path);
    QVERIFY(!isFolder);
    QVERIFY(isFolder.error().code == GcodeError::FileUnreadable);
    QVERIFY(isFolder.error().message.find("folder") != std::string::npos);
    const auto device = gcode::loadProgram("/dev/null");
    QVERIFY(!device);
    QVERIFY(device.error().code == GcodeError::FileUnreadable);
  }

  void tooLargeFileIsNotRead() {
    const QTemporaryDir folder;
    const std::filesystem::path path = write(folder, "G0 X1\n");
    std::error_code status;
    std::filesystem::resize_file(path, base::Budget::kUsualBytes, status);  // sparse
    if (status) {
      QSKIP("the file system has no room for a sparse file");
    }
    const auto program = gcode::loadProgram(path);
    QVERIFY(!program);
    QVERIFY(program.error().code == base::BudgetError::Exceeded);
  }

  void fileErrorsCarryThePath() {
    const QTemporaryDir folder;
    const std::filesystem::path path = write(folder, "(nothing)\n");
    const auto program = gcode::loadProgram(path);
    QVERIFY(!program);
    QVERIFY(program.error().code == GcodeError::EmptyProgram);
    QCOMPARE(program.error().context, path.string());
  }

  void chordToleranceDecidesTheNumberOfPoints() {
    const std::string text = "G0 X0 Y0\nG2 X20 Y0 I10 F60";
    gcode::LoadOptions coarse;
    coarse.chordToleranceMm = 0.1;
    const auto a = gcode::interpretProgram("a", text, coarse);
    const auto b = gcode::interpretProgram("a", text);
    QVERIFY(a && b);
    QVERIFY(b->statistics.points > 3 * a->statistics.points);
    QCOMPARE(a->statistics.cutLengthMm, b->statistics.cutLengthMm);
  }

  void streamPointsFillAndMerge() {
    const auto program = gcode::interpretProgram("a", "G0 X1\nX1\nG1 Z2 F60\nZ2\nY5\nX1 Y5 Z2");
    QVERIFY(program.has_value());
    const gcode::PointList list = gcode::streamPoints(program->trajectory, {9, 8, 7});
    QCOMPARE(list.merged, std::size_t{3});
    QCOMPARE(list.points.size(), std::size_t{3});
    QCOMPARE(list.points[0].positionMm, (base::Vec3{1, 8, 7}));
    QCOMPARE(list.points[1].positionMm, (base::Vec3{1, 8, 2}));
    QCOMPARE(list.points[2].positionMm, (base::Vec3{1, 5, 2}));
    QCOMPARE(list.points[1].line.value, 3U);
    QVERIFY(gcode::streamPoints({}, {0, 0, 0}).points.empty());
  }

  /// Axes at rest tremble. A tool that has been brought to X0 stands at 3e-7: no move of 3e-7 mm
  /// may come of it, which no method could stream.
  void axesThatStandWhereTheyAreSentDoNotMove() {
    const auto program = gcode::interpretProgram("a", "G0 Z10\nX0 Y0\nG1 X5 F60\nZ9");
    QVERIFY(program.has_value());
    const auto exact = gcode::streamPoints(program->trajectory, {0, 0, 10});
    const auto trembling = gcode::streamPoints(program->trajectory, {3e-7, -0.004, 10});
    QCOMPARE(exact.points.size(), std::size_t{3});
    QCOMPARE(trembling.points.size(), exact.points.size());
    QCOMPARE(trembling.merged, exact.merged);
    for (std::size_t i = 0; i < exact.points.size(); ++i) {
      QCOMPARE(trembling.points[i].positionMm, exact.points[i].positionMm);
    }
    // Farther away it is a move, and an axis that is never named stays where it stands.
    QCOMPARE(gcode::streamPoints(program->trajectory, {0.02, 0, 10}).points.size(), std::size_t{4});
    const auto open = gcode::interpretProgram("a", "G0 X1\nG1 X2 F60");
    QCOMPARE(gcode::streamPoints(open->trajectory, {0, 3e-7, -0.1234}).points[0].positionMm,
             (base::Vec3{1, 3e-7, -0.1234}));
  }

  void errorCodesHaveACategory() {
    const std::error_code code = GcodeError::NoMotion;
    QCOMPARE(std::string(code.category().name()), std::string("gcode"));
    QVERIFY(code != std::error_code(GcodeError::EmptyProgram));
  }
};

RIVULET_TEST(TestProgram)
#include "tst_program.moc"
