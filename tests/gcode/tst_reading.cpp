// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <algorithm>
#include <optional>
#include <string>

#include "gcode/program.h"
#include "gcode_text.h"
#include "support/test_program.h"

using namespace rivulet;
using gcode::DiagnosticCode;
using gcode::Dialect;

namespace {

gcode::Program load(const std::string& text, const gcode::LoadOptions& options = {},
                    const std::string& name = "part.nc") {
  auto program = gcode::interpretProgram(name, text, options);
  if (!program) {
    qFatal("%s", program.error().message.c_str());
  }
  return std::move(*program);
}

gcode::LoadOptions as(Dialect dialect) {
  gcode::LoadOptions options;
  options.dialect = dialect;
  return options;
}

const gcode::Diagnostic* find(const gcode::Program& program, DiagnosticCode code) {
  const auto found =
      std::find_if(program.diagnostics.begin(), program.diagnostics.end(),
                   [code](const gcode::Diagnostic& each) { return each.code == code; });
  return found == program.diagnostics.end() ? nullptr : &*found;
}

std::string points(const gcode::Program& program) {
  return test::printPoints(program.trajectory);
}

}  // namespace

/// What a text means where it does not say it itself: its unit, its decimal points, the end of its
/// blocks, its machine and its control.
class TestReading : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void unitsThatNobodySays() {
    const gcode::Program silent = load("O1 (A)\nG90\nG0 X0. Y0.\nG1 X100. Y50. F200\nM30\n");
    const gcode::Diagnostic* const found = find(silent, DiagnosticCode::UnitsNotSaid);
    QVERIFY(found != nullptr);
    QCOMPARE(found->severity, gcode::Severity::Warning);
    QCOMPARE(found->argument, std::string("X 100, Y 50 mm; X 2540, Y 1270 mm"));
    QVERIFY(silent.isStreamable());
    // Too late is not said either.
    QVERIFY(find(load("O1\nG0 X0. Y0.\nG20\nG1 X1. F9\n"), DiagnosticCode::UnitsNotSaid));
    QVERIFY(find(load("G0 X0. Y0.\nX5.\n", as(Dialect::Haas)), DiagnosticCode::UnitsNotSaid));
    QVERIFY(find(load("G0 X0. Y0.\nX5.\n", as(Dialect::LinuxCnc)), DiagnosticCode::UnitsNotSaid));
    for (const char* const said :
         {"G21\nG0 X1. Y0.\n", "N1 G20 G90\nG0 X1.\n", "G20 G0 X1.\n", "T1 M6\nG21 G0 X1.\n"}) {
      QVERIFY(!find(load(said), DiagnosticCode::UnitsNotSaid));
    }
    // These have a unit by their manuals: $13 concerns reports alone, MD10240, BEGIN PGM.
    QVERIFY(!find(load("G0 X1.\n", as(Dialect::Grbl)), DiagnosticCode::UnitsNotSaid));
    QVERIFY(!find(load("G0 X1.\n", as(Dialect::Sinumerik)), DiagnosticCode::UnitsNotSaid));
  }

  void unitsThatTheUserSays() {
    gcode::LoadOptions options;
    options.units = gcode::FileUnits::Inches;
    const gcode::Program inches = load("G90\nG0 X0. Y0.\nG1 X1. F10\nG21\nX50. F100\n", options);
    QCOMPARE(points(inches),
             std::string("2 R X0 Y0 Z? | 3 L X25.4 Y0 Z? F254 | 5 L X50 Y0 Z? F100"));
    QVERIFY(!find(inches, DiagnosticCode::UnitsNotSaid));
    options.units = gcode::FileUnits::Millimetres;
    const gcode::Program mm = load("G90\nG0 X0. Y0.\nG1 X1. F10\n", options);
    QCOMPARE(points(mm), std::string("2 R X0 Y0 Z? | 3 L X1 Y0 Z? F10"));
    QVERIFY(!find(mm, DiagnosticCode::UnitsNotSaid));
  }

  void numbersWithoutPoint() {
    const std::string text = "O56\nG21 G90 G94\nG0 X0 Y0 Z5\nG1 X10000 Y5000 F200\nM30\n";
    const gcode::Program program = load(text);
    const gcode::Diagnostic* const found = find(program, DiagnosticCode::NoDecimalPoint);
    QVERIFY(found != nullptr);
    QCOMPARE(found->argument, std::string("X 10000, Y 5000, Z 0 mm; X 10, Y 5, Z 0 mm"));
    gcode::LoadOptions options;
    options.noPoint = gcode::NoPoint::Increments;
    const gcode::Program counted = load(text, options);
    QCOMPARE(points(counted), std::string("3 R X0 Y0 Z0.005 | 4 L X10 Y5 Z0.005 F200"));
    QVERIFY(!find(counted, DiagnosticCode::NoDecimalPoint));
    options.noPoint = gcode::NoPoint::Units;
    QCOMPARE(points(load(text, options)), points(program));
    QVERIFY(!find(load(text, options), DiagnosticCode::NoDecimalPoint));
    // Counts of an inch, arcs, what has a point, and a dwell that is none of it.
    options.noPoint = gcode::NoPoint::Increments;
    QCOMPARE(points(load("O1\nG20 G90 G0 X10000 Y0. Z1.5\nG4 P1000\nG1 X20000 F10.\n", options)),
             std::string("2 R X25.4 Y0 Z38.1 | 4 L X50.8 Y0 Z38.1 F254"));
    const gcode::Program arc =
        load("O1\nG21 G90 G0 X0 Y0 Z0\nG2 X10000 Y0 I5000 J0 F100\n", options);
    QVERIFY(arc.isStreamable());
    QVERIFY(std::abs(arc.statistics.cutLengthMm - 15.70796) < 1e-4);
  }

  /// Small numbers on controls that have no such setting, and one number that stands out.
  void numbersWithoutPointThatAreNoMatter() {
    const auto has = [](const char* text, std::optional<Dialect> dialect = std::nullopt) {
      return find(load(text, dialect ? as(*dialect) : gcode::LoadOptions()),
                  DiagnosticCode::NoDecimalPoint) != nullptr;
    };
    QVERIFY(!has("G21 G90\nG0 X10 Y5\n"));
    QVERIFY(!has("G21 G0 X10000 Y5000\n", Dialect::LinuxCnc));
    QVERIFY(!has("G21 G0 X10000 Y5000\n", Dialect::Grbl));
    QVERIFY(!has("G71 G0 X10000 Y5000\n", Dialect::Sinumerik));
    QVERIFY(!has("O1\nG21 G0 X10. Y5\nG1 X12.5 Y7 F100\n"));
    QVERIFY(has("O1\nG21 G0 X10. Y5.\nG1 X12.5 Y7000 F100\n"));
    QVERIFY(has("G21 G90\nG0 X10000 Y5000\n"));
  }

  void sizesBeyondAMachine() {
    QVERIFY(
        find(load("G21 G0 X0. Y0.\nX20000.\n", as(Dialect::Grbl)), DiagnosticCode::SizeUnlikely));
    QVERIFY(
        !find(load("G21 G0 X0. Y0.\nX2000.\n", as(Dialect::Grbl)), DiagnosticCode::SizeUnlikely));
  }

  /// @source Fanuc, operator's manual, "Program configuration": ";" stands for the code that ends a
  /// block.
  void semicolonEndsBlocksOfFanuc() {
    const std::string text =
        "O0003;\nG21 G90;\nG0 X0. Y0. Z5.; G1 Z-1. F100;\nX10.; Y10.;\nG0 Z5.;\nM30;\n";
    const gcode::Program program = load(text);
    QCOMPARE(points(program),
             std::string("3 R X0 Y0 Z5 | 3 L X0 Y0 Z-1 F100 | 4 L X10 Y0 Z-1 F100 | "
                         "4 L X10 Y10 Z-1 F100 | 5 R X10 Y10 Z5"));
    QVERIFY(find(program, DiagnosticCode::SemicolonEndsBlock));
    QCOMPARE(points(load("O1\nG21 G0 X1.;;(a; b) Y2.;(end)\n")),
             std::string("2 R X1 Y? Z? | 2 R X1 Y2 Z?"));
    // Blanks and comments in brackets behind it are no blocks.
    QVERIFY(!find(load("O1;\nG21 G0 X1.; (a)\nY2.;\n"), DiagnosticCode::SemicolonEndsBlock));
    // A call in the middle of a line goes on behind it.
    QCOMPARE(points(load("O1;\nG21 G0 X0. Y0.; M98 P2; X7.;\nX9.;\nM30;\nO2;\nY6.; M99;\n")),
             std::string("2 R X0 Y0 Z? | 6 R X0 Y6 Z? | 2 R X7 Y6 Z? | 3 R X9 Y6 Z?"));
    // A jump counts blocks, not lines.
    QCOMPARE(points(load(
                 "O1;\nG21 G0 X0. Y0.; #1=0;\nN5 G91 X1.; #1=#1+1;\nIF [#1 LT 2] GOTO 5; Y3.;\n")),
             std::string("2 R X0 Y0 Z? | 3 R X1 Y0 Z? | 3 R X2 Y0 Z? | 4 R X2 Y3 Z?"));
  }

  /// Where one text behind ";" is none of the control's words, its author's control reads comments.
  void semicolonBeginsComments() {
    for (const char* const text : {"O1\nG21 G0 X1. ; to the start\nX2. ; X9.\n",
                                   "O1\nG21 G0 X1.\nX2. ; X9.\n; 10mm END MILL\n"}) {
      const gcode::Program program = load(text);
      QCOMPARE(program.trajectory.points.back().positionMm.x, 2.0);
      QVERIFY(program.isStreamable());
      QVERIFY(!find(program, DiagnosticCode::SemicolonEndsBlock));
    }
    for (const Dialect dialect : {Dialect::LinuxCnc, Dialect::Grbl, Dialect::Sinumerik}) {
      QCOMPARE(load("G0 X1. ; X9.\n", as(dialect)).trajectory.points.back().positionMm.x, 1.0);
    }
  }

  /// @source Fanuc, operator's manual for lathe systems, G code system A.
  void recognisesLathes() {
    const gcode::Program program =
        load("O0002\nG21 G99 G97 S500 M3\nG0 X50. Z2.\nG1 Z-20. F0.25\nX60.\nG0 X100. Z50.\nM30\n");
    const gcode::Diagnostic* const found = find(program, DiagnosticCode::LatheAssumed);
    QVERIFY(found != nullptr);
    QCOMPARE(found->argument, std::string("G97, G99"));
    // X is a diameter; 0.25 mm per revolution at 500/min.
    QCOMPARE(points(program),
             std::string("3 R X25 Y? Z2 | 4 L X25 Y? Z-20 F125 | 5 L X30 Y? Z-20 F125 | "
                         "6 R X50 Y? Z50"));
    // 180 m/min at 60 mm, 2000/min at the most; where X changes, one feed does not describe it.
    const std::string constant = "O3\nG21 G99\nG50 S2000\nG96 S180 M4\nG0 X60. Z2.\nG1 ";
    const double feedMmPerS = load(constant + "Z-20. F0.2\n").trajectory.points.back().feedMmPerS;
    QVERIFY(std::abs(feedMmPerS - 180'000.0 / (std::acos(-1.0) * 60.0) * 0.2 / 60.0) < 1e-9);
    QVERIFY(load(constant + "Z-20. F0.2\n").isStreamable());
    QVERIFY(!load(constant + "X80. Z-20. F0.2\n").isStreamable());
    QVERIFY(find(load("O3\nG21\nG50 S2000\nG96 S180 M4\nT0101\nG0 X60. Z2.\nG1 Z-20. F0.2\nM30\n"),
                 DiagnosticCode::LatheAssumed));
    QVERIFY(find(load("O3\nG21 T0202\nG97 S800 M3\nG0 X60. Z2.\nG1 W-20. F0.2\nU10.\nM30\n"),
                 DiagnosticCode::LatheAssumed));
    // Mills: another axis, a drilling cycle, a plane, a comment.
    for (const char* const mill :
         {"O1\nG21 G97 S500 M3\nG99 G81 X1. Z-5. R2. F100\nG80\n",
          "O1\nG21 G97 G99\nG0 X1. Y2. Z3.\n", "O1\nG17 G97 G99 G21\nG0 X1. Z3.\n",
          "O1 (G96 G97 G99)\nG21 G0 X1. Z3.\n"}) {
      QVERIFY(!find(load(mill), DiagnosticCode::LatheAssumed));
    }
  }

  void asksWhereControlsDiffer() {
    const gcode::Program program = load("G21 G90\nG0 X1. ; Y2.\nX3.\n");
    QVERIFY(program.ambiguity.has_value());
    QCOMPARE(program.ambiguity->line.value, 2U);
    QCOMPARE(program.ambiguity->readings[0].dialect, Dialect::Fanuc);
    QCOMPARE(gcode::describe(*program.ambiguity),
             std::string("as fanuc the tool goes to X1 Y2, as linuxcnc the tool goes to X3"));
    QVERIFY(!program.isStreamable());
    QVERIFY(find(program, DiagnosticCode::DialectUnclear));
    for (const Dialect dialect : {Dialect::Fanuc, Dialect::LinuxCnc, Dialect::Grbl}) {
      const gcode::Program chosen = load("G21 G90\nG0 X1. ; Y2.\nX3.\n", as(dialect));
      QVERIFY(chosen.isStreamable() && !chosen.ambiguity);
    }
    // The name of the file, and words of one control alone, are evidence.
    QVERIFY(!load("G21 G90\nG0 X1. ; Y2.\nX3.\n", {}, "part.ngc").ambiguity);
    QVERIFY(!load("O1234\nG21 G90\nG0 X1. ; Y2.\nX3.\n").ambiguity);
    // What all controls read alike is no question, nor is what only one of them can read.
    QVERIFY(!load("G21 G90\nG0 X1 0\nX3.\n").ambiguity);
    QVERIFY(!load("G21 G90\n#1=5\nG0 X#1\n").ambiguity);
    QVERIFY(!load("G21 G90 G17 G40\nG0 X1. Y1.\nG2 X3. Y1. I1. J0. F100\n").ambiguity);
  }

  void refusesWordsOfTwoControls() {
    const gcode::Program program =
        load("G0 X1\nCYCLE82(5,0,2,-10)\nO<part> call\n#<a>=1\nO100 ENDSUB\nTRAORI\n");
    QVERIFY(find(program, DiagnosticCode::TwoDialects));
    QVERIFY(!program.isStreamable());
    // Headings of plain text are free text, like comments.
    for (const char* heading : {"* - D10 CR=0", "12 *   - TRAORI", "N3 * - T5 CR=0.5"}) {
      const std::string plain =
          "0 BEGIN PGM A MM\n" + std::string(heading) + "\n2 L X+0 Y+0 Z+5 FMAX\n3 END PGM A MM\n";
      QVERIFY2(load(plain).isStreamable(), heading);
    }
    QVERIFY(find(load("0 BEGIN PGM A MM\n1 L X+0 FMAX\nG2 X1 Y1 CR=5\n2 END PGM A MM\n"),
                 DiagnosticCode::TwoDialects));
  }
};

RIVULET_TEST(TestReading)
#include "tst_reading.moc"
