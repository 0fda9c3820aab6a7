// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include "gcode/gcode_text.h"
#include "job/plan.h"
#include "plan_text.h"
#include "support/test_program.h"

using namespace rivulet;

namespace {

job::Plan planOf(const char* text, gcode::Dialect dialect = gcode::Dialect::Sinumerik,
                 const job::Profile& profile = {}) {
  gcode::LoadOptions options;
  options.dialect = dialect;
  const auto plan = job::makePlan("PART.MPF", text, options, profile);
  if (!plan) {
    qFatal("%s", plan.error().text().c_str());
  }
  return *plan;
}

/// What the control gets, one after the other.
QString nativeLines(const job::Plan& plan) {
  QStringList found;
  for (const job::Part& part : plan.parts) {
    const auto* const native = std::get_if<job::NativeBlock>(&part);
    if (native != nullptr && !native->text.empty()) {
      found << QString::fromStdString(native->text).split(QLatin1Char('\n'));
    }
  }
  return found.join(QLatin1Char(';'));
}

/// The first native block for that reason.
const job::NativeBlock& native(const job::Plan& plan, job::NativeReason reason) {
  for (const job::Part& part : plan.parts) {
    const auto* const block = std::get_if<job::NativeBlock>(&part);
    if (block != nullptr && block->reason == reason) {
      return *block;
    }
  }
  qFatal("there is no such block");
}

QString text(const std::string& printed) {
  return QString::fromStdString(printed);
}

QString refusals(const job::Plan& plan) {
  QStringList all;
  for (const job::Refusal& refusal : plan.refusals) {
    all << QStringLiteral("%1 %2 %3")
               .arg(refusal.line.value)
               .arg(QString::fromStdString(std::string(job::refusalName(refusal.code))),
                    QString::fromStdString(refusal.argument));
  }
  return all.join(QStringLiteral(" | "));
}

}  // namespace

class TestSplitter : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// A part as a CAM system writes it: tools, spindle and coolant stay with the control.
  void partWithTools() {
    const job::Plan plan = planOf(
        "N10 G17 G90 G71\n"
        "T1 D1 M6\n"
        "S3000 M3\n"
        "M8\n"
        "G0 X0 Y0\n"
        "G0 Z5\n"
        "G1 Z-1 F200\n"
        "G1 X10\n"
        "SUPA G0 Z0 D0\n"
        "T=\"DRILL_6\"\n"
        "M6\n"
        "D1\n"
        "G0 X5 Y5\n"
        "M30\n");
    QVERIFY(plan.isWhole());
    QCOMPARE(
        text(test::printParts(plan)),
        QStringLiteral(
            "settings 1 | native 2 tool T1 D1 M6 | native 3 spindle S3000 M3 | native 4 coolant "
            "M8 | stretch 1 5-8: 4 points from ? | native 9 retract SUPA G0 Z0 D0 | native 10 "
            "tool T=\"DRILL_6\" | native 11 tool M6 | native 12 tool D1 | stretch 2 13: 1 point "
            "from ? | native 14 end M30"));
    QCOMPARE(text(test::printPoints(plan.program.trajectory)),
             QStringLiteral("5 R X0 Y0 Z? | 6 R X0 Y0 Z5 | 7 L X0 "
                            "Y0 Z-1 F200 | 8 L X10 Y0 Z-1 F200 "
                            "| 13 R X5 Y5 Z?"));
    QCOMPARE(plan.stretchCount(), std::size_t{2});
    QCOMPARE(plan.nativeCount(), std::size_t{8});
  }

  /// Where the tool stands after a retract only the control knows. The old height must not return
  /// with the next move across.
  void retractForgetsTheHeight() {
    const job::Plan plan = planOf("G0 X0 Y0 Z5\nSUPA G0 Z0\nG0 X100 Y50\n");
    QCOMPARE(text(test::printPoints(plan.program.trajectory)),
             QStringLiteral("1 R X0 Y0 Z5 | 3 R X100 Y50 Z?"));
    const auto& last = std::get<job::Stretch>(plan.parts.back());
    QVERIFY(!last.startIsKnown());
  }

  /// What only switches something leaves the tool where it is.
  void coolantKeepsThePosition() {
    const job::Plan plan = planOf("G0 X0 Y0 Z5\nM9\nMSG(\"turn the part\")\nG4 F1\nG91 G0 Z5\n");
    QVERIFY(plan.isWhole());
    QCOMPARE(
        text(test::printParts(plan)),
        QStringLiteral(
            "stretch 1 1: 1 point from ? | native 2 coolant M9 | native 3 message MSG(\"turn the "
            "part\") | native 4 dwell G4 F1 | stretch 2 5: 1 point"));
    QCOMPARE(text(test::printPoints(plan.program.trajectory)),
             QStringLiteral("1 R X0 Y0 Z5 | 5 R X0 Y0 Z10"));
  }

  /// An increment from a place that only the control knows is the control's.
  void incrementFromUnknownPosition() {
    const job::Plan plan = planOf("G0 X0 Y0 Z5\nT2 M6\nG91 G0 Z5\nG90 X10 Y10 Z20\n");
    QVERIFY(plan.isWhole());
    QCOMPARE(
        text(test::printParts(plan)),
        QStringLiteral(
            "stretch 1 1: 1 point from ? | native 2 tool T2 M6 | native 3 unknown-position G91 G0 "
            "Z5 | stretch 2 4: 1 point from ?"));
  }

  /// A block that moves and switches belongs to the control as a whole; its end is known.
  void motionWithSpindle() {
    const job::Plan plan = planOf("G0 X0 Y0 Z5\nG0 X10 S500 M3\nG1 Z0 F100\n");
    QCOMPARE(text(test::printParts(plan)),
             QStringLiteral(
                 "stretch 1 1: 1 point from ? | native 2 spindle G0 X10 S500 M3 | stretch 2 3: 1 "
                 "point"));
    QVERIFY(native(plan, job::NativeReason::Spindle).moves);
    QCOMPARE(text(test::printPoints(plan.program.trajectory)),
             QStringLiteral("1 R X0 Y0 Z5 | 3 L X10 Y0 Z0 F100"));
  }

  /// LinuxCNC, G codes, "G10 L2 Set Coordinate System": X, Y and Z are set on the control, which
  /// takes them over with the next G54; the turn about Z is Rivulet's. P0 is the one in force.
  void setsWorkOffset() {
    const job::Plan plan =
        planOf("G20 G90\nG10 L2 P0 X-2 Y1 R90\nF1000\nG0 X0 Y0 Z0\nG1 X1 Y0\nG10 L2 P2 Z1\nM2\n",
               gcode::Dialect::LinuxCnc);
    QCOMPARE(refusals(plan), QString());
    QVERIFY(plan.isWhole());
    QCOMPARE(text(test::printParts(plan)),
             QStringLiteral("settings 1 | native 2 work-offset $P_UIFR[1,X,TR]=-50.8 "
                            "$P_UIFR[1,Y,TR]=25.4 $P_UIFR[1,Z,RT]=0\nG54 | stretch 1 3-5: 2 points "
                            "from ? | native 6 work-offset $P_UIFR[2,Z,TR]=25.4 | native 7 end "
                            "M30"));
    QCOMPARE(text(test::printPoints(plan.program.trajectory)),
             QStringLiteral("4 R X0 Y0 Z0 | 5 L X0 Y25.4 Z0 F25400"));
    QVERIFY(!planOf("G10 L20 P1 X0\nG0 X1\n", gcode::Dialect::LinuxCnc).isWhole());
    QVERIFY(planOf("G90 G10 L2 P1 X0\nG0 X1\n", gcode::Dialect::Fanuc).isWhole());
    // P0 is an offset of its own there, and G91 adds.
    QVERIFY(!planOf("G90 G10 L2 P0 X0\nG0 X1\n", gcode::Dialect::Fanuc).isWhole());
    QVERIFY(!planOf("G91 G10 L2 P1 X5\nG90 G0 X1\n", gcode::Dialect::Fanuc).isWhole());
  }

  /// After a tool change only the control knows where the tool stands, and so what G92 shifts.
  void setsPositionAtUnknownPlace() {
    const auto planOfIso = [](const char* lines) { return planOf(lines, gcode::Dialect::Fanuc); };
    const job::Plan plan = planOfIso("G0 X0 Y0 Z5\nT1 M6\nG92 X0\nG1 Y1 F100\nX5\nM30\n");
    QCOMPARE(refusals(plan), QStringLiteral("5 not-translated G92"));
    QVERIFY(planOfIso("G0 X0 Y0 Z5\nT1 M6\nG92 X0\nG92.1\nG1 X5 F100\nM30\n").isWhole());
    QVERIFY(planOfIso("G0 X0 Y0 Z5\nG92 X7\nT1 M6\nG1 X5 F100\nM30\n").isWhole());
    QVERIFY(planOfIso("T1 M6\nG92 X0 Y0 Z0\nG1 X5 F100\nM30\n").isWhole());
  }

  /// LinuxCNC, "Switchable kinematics": M428 makes X, Y and Z those of the tool's tip, M429 ends
  /// it. Without it the same points would be another path.
  void tipOfTheTool() {
    const job::Plan plan = planOf("G0 X0 Y0 Z50 A0\nM428\nG1 X1 A5 F100\nM429\nG0 Z60\nM2\n",
                                  gcode::Dialect::LinuxCnc);
    QVERIFY(plan.isWhole());
    QCOMPARE(
        text(test::printParts(plan)),
        QStringLiteral("stretch 1 1: 1 point from ? | native 2 transformation TRAORI | stretch "
                       "2 3: 1 point from ? | native 4 transformation TRAFOOF | stretch 3 5: "
                       "1 point from ? | native 6 end M30"));
    const job::Plan iso =
        planOf("G0 X0 Y0 Z50\nG43.4 H1\nG1 X1 B5 F100\nM30\n", gcode::Dialect::Fanuc);
    QVERIFY(!iso.isWhole());
    QVERIFY(refusals(iso).contains(QStringLiteral("G43.4")));
    QVERIFY(!planOf("M428\nG0 X1\nM30\n", gcode::Dialect::Fanuc).isWhole());
  }
  /// M128 and M129 of a TNC; where another block moves, and in machine coordinates, not.
  void tipOfTheToolOfTnc() {
    const auto plain = [](const std::string& body) {
      const std::string whole =
          "BEGIN PGM A MM\nL X+0 Y+0 Z+50 A+0 FMAX\n" + body + "END PGM A MM\n";
      return planOf(whole.c_str(), gcode::Dialect::Heidenhain);
    };
    const job::Plan plan =
        plain("M129\nL M128 F2000\nL X+1 Y+0 Z+50 A+5 F100\nM129\nL X+0 Y+0 Z+60 FMAX\n");
    QCOMPARE(refusals(plan), QString());
    QVERIFY(plan.isWhole());
    QCOMPARE(text(test::printParts(plan)),
             QStringLiteral("stretch 1 1-3: 1 point from ? | native 4 transformation "
                            "TRAORI | stretch 2 5: 1 point from ? | native 6 transformation "
                            "TRAFOOF | stretch 3 7: 1 point from ? | native 8 end M30"));
    QCOMPARE(plan.program.trajectory.points[1].feedMmPerS * 60.0, 100.0);
    QVERIFY(!plain("L X+5 A+5 F100 M128\nM129\n").isWhole());
    QVERIFY(!plain("M128\nL Z+0 FMAX M91\nM129\n").isWhole());
    QVERIFY(plain("M128\nM129\nL Z+0 FMAX M91\n").isWhole());
    // Where the tool stands in the new coordinates is not known.
    QVERIFY(!plain("M128\nL IX+5 F100\nM129\n").isWhole());
  }

  void compensationRegion() {
    const job::Plan plan = planOf(
        "G0 X0 Y0 Z5\n"
        "G1 Z0 F100\n"
        "G41 G1 X10 Y0\n"
        "G1 X20\n"
        "M8\n"
        "G40\n"
        "G0 Z5\n"
        "G0 X30 Y0\n"
        "G0 X0\n");
    QVERIFY(plan.isWhole());
    QCOMPARE(
        text(test::printParts(plan)),
        QStringLiteral(
            "stretch 1 1-2: 2 points from ? | native 3 radius-compensation G41 G1 X10 Y0 | native "
            "4 radius-compensation G1 X20 | native 5 radius-compensation M8 | native 6 "
            "radius-compensation "
            "G40 | native 7 radius-compensation G0 Z5 | native 8 radius-compensation G0 X30 Y0 | "
            "stretch 2 9: 1 point"));
  }

  void cyclesAndModalCalls() {
    const job::Plan plan = planOf(
        "G0 X0 Y0 Z5\n"
        "CYCLE81(5,0,2,-10)\n"
        "G0 X1 Y1 Z5\n"
        "MCALL CYCLE81(5,0,2,-10)\n"
        "X10 Y10\n"
        "X20\n"
        "MCALL\n"
        "G0 X0 Y0\n");
    QVERIFY(plan.isWhole());
    QCOMPARE(
        text(test::printParts(plan)),
        QStringLiteral(
            "stretch 1 1: 1 point from ? | native 2 cycle CYCLE81(5,0,2,-10) | stretch 2 3: 1 "
            "point from ? | native 4 cycle MCALL CYCLE81(5,0,2,-10) | native 5 cycle X10 Y10 | "
            "native 6 cycle X20 | native 7 cycle MCALL | stretch 3 8: 1 point from ?"));
  }

  void transformationRegion() {
    const job::Plan plan = planOf(
        "G0 X0 Y0 Z5\nCYCLE800(0,\"TC1\",0,57,0,0,0,0,45,0,0,0,0,1)\nG0 X1\nCYCLE800()\nG0 X2\n"
        "TRAORI\nG1 X3 A3=0 B3=0.1 C3=1 F100\nTRAFOOF\nG0 X4\n");
    QVERIFY(plan.isWhole());
    QCOMPARE(
        text(test::printParts(plan)),
        QStringLiteral(
            "stretch 1 1: 1 point from ? | native 2 transformation "
            "CYCLE800(0,\"TC1\",0,57,0,0,0,0,45,0,0,0,0,1) | native 3 transformation G0 X1 | "
            "native 4 transformation CYCLE800() | stretch 2 5: 1 point from ? | native 6 "
            "transformation TRAORI | native 7 transformation G1 X3 A3=0 B3=0.1 C3=1 F100 | native "
            "8 transformation TRAFOOF | stretch 3 9: 1 point from ?"));
    QVERIFY(plan.program.isStreamable());
  }

  /// Each native block knows what the source program has in force there.
  void modalStateBefore() {
    const job::Plan plan = planOf(
        "G18\n"
        "G70 G91\n"
        "G95 DIAMON\n"
        "TRANS X10\n"
        "AROT RPL=30\n"
        "M8\n"
        "TRANS\n"
        "G17 G90 DIAMOF\n"
        "M9\n");
    const job::NativeBlock& on = std::get<job::NativeBlock>(plan.parts.at(2));
    QCOMPARE(on.text, std::string("M8"));
    QCOMPARE(on.before.planeFirstAxis, std::size_t{2});
    QCOMPARE(on.before.lengthFactor, 25.4);
    QVERIFY(on.before.relative);
    QVERIFY(on.before.diameter);
    QCOMPARE(on.before.feedMode, nc::FeedMode::PerRevolution);
    QCOMPARE(on.frame, (std::vector<std::string>{"TRANS X254", "G18", "AROT RPL=30"}));
    const job::NativeBlock& off = std::get<job::NativeBlock>(plan.parts.back());
    QCOMPARE(off.before.planeFirstAxis, std::size_t{0});
    QVERIFY(!off.before.relative);
    QVERIFY(off.frame.empty());
  }

  /// A loop is followed by Rivulet: its native blocks come as often as it runs them.
  void blocksOfALoop() {
    const job::Plan plan = planOf(
        "DEF INT I\n"
        "FOR I=1 TO 2\n"
        "M8\n"
        "G0 X=I\n"
        "ENDFOR\n"
        "PART\n"
        "M30\n");
    QCOMPARE(text(test::printParts(plan)),
             QStringLiteral(
                 "settings 1-2 | native 3 coolant M8 | stretch 1 4: 1 point from ? | native 3 "
                 "coolant M8 "
                 "| stretch 2 4: 1 point from ? | native 6 subprogram PART | native 7 end M30"));
  }

  /// A call that Rivulet follows is not made by the control as well, nor its return.
  void followedCalls() {
    gcode::LoadOptions options;
    options.dialect = gcode::Dialect::Sinumerik;
    options.subprogram = [](std::string_view name) {
      return name == "PART" ? std::optional(nc::LoadedText{"M8\nG0 X5\nM9 M17\n", "PART.SPF"})
                            : std::nullopt;
    };
    const auto plan = job::makePlan("MAIN.MPF", "S500 M3\nPART\nM5\nM30\n", options);
    QVERIFY(plan.has_value());
    QCOMPARE(
        text(test::printParts(*plan)),
        QStringLiteral(
            "native 1 spindle S500 M3 | settings 2 | native 1 coolant M8 | stretch 1 2: 1 point "
            "from ? | native 3 coolant M9 | native 3 spindle M5 | native 4 end M30"));
    QCOMPARE(native(*plan, job::NativeReason::Coolant).file, std::string("PART.SPF"));
  }

  void skipMarksAndLabels() {
    const job::Plan plan = planOf("/ N10 M8 ; mist\nAGAIN: M9\nG0 X1\n");
    QCOMPARE(
        text(test::printParts(plan)),
        QStringLiteral(
            "native 1 coolant N10 M8 ; mist | native 2 coolant M9 | stretch 1 3: 1 point from ?"));
  }

  /// A cycle of the control gets the values of its arguments.
  void argumentsOfCycles() {
    const job::Plan plan = planOf(
        "DEF REAL TOL=0.03\nR1=20 R2=-4.5\nCYCLE832(TOL,3,1)\nG0 X1 Y1 Z20\n"
        "CYCLE81(R1,,R1/10,R2)\nMSG(\"depth \"<<R2<<\" of \"<<R1)\nMSG(\"T\"<<$P_TOOLNO)\n"
        "OWN(R1)\n");
    QStringList found;
    for (const job::Part& part : plan.parts) {
      if (const auto* const native = std::get_if<job::NativeBlock>(&part)) {
        found << QString::fromStdString(native->text);
        // What the control alone knows stays; a program of the user may write to its argument.
        QCOMPARE(native->calculates, native->text == "OWN(R1)");
      }
    }
    QCOMPARE(found, (QStringList{
                        QStringLiteral("CYCLE832(0.03,3,1)"), QStringLiteral("CYCLE81(20,,2,-4.5)"),
                        QStringLiteral("MSG(\"depth -4.5 of 20\")"),
                        QStringLiteral("MSG(\"T\"<<$P_TOOLNO)"), QStringLiteral("OWN(R1)")}));
  }

  /// Of other controls along Z in each plane.
  void lengthActsAlongZ() {
    const job::Plan plan = planOf(
        "T1 M6\nG18 G0 X0. Y50.\nG43 H1 Z50.\nG19 G2 Y0. Z0. J-50. F100.\n", gcode::Dialect::Fanuc);
    QCOMPARE(refusals(plan), QString());
  }

  /// A tool length acts along Z: an arc after it begins where the program says.
  void lengthForgetsItsAxisAlone() {
    const job::Plan plan =
        planOf("T1 M6\nG0 X0. Y0.\nG43 H1 Z5.\nT2\nG2 X10. Y0. I5. J0. F100.\nG91 G1 X5.\n",
               gcode::Dialect::Fanuc);
    QCOMPARE(refusals(plan), QString());
    const auto& last = std::get<job::Stretch>(plan.parts.back());
    QVERIFY(last.startIsKnown());
    QCOMPARE(last.startMm, (base::Vec3{0.0, 0.0, 5.0}));
    // In another plane the length of a SINUMERIK acts along another axis: Y and Z are not known.
    const job::Plan turned = planOf("G17 G0 X1 Y2 Z3\nG18\nG0 X5\n");
    QCOMPARE(text(test::printPoints(turned.program.trajectory)),
             QStringLiteral("1 R X1 Y2 Z3 | 3 R X5 Y? Z?"));
  }

  /// Where an arc begins after a tool change only the control knows, and so the control makes it.
  void startIsUnknown() {
    const auto arcOf = [](const std::string& arc) {
      return planOf(("G0 X0. Y0. Z5.\nT1 M6\n" + arc + "\n").c_str(), gcode::Dialect::Fanuc);
    };
    const job::Plan plan = arcOf("G2 X10. Y0. I5. J0. F100.");
    QCOMPARE(refusals(plan), QString());
    QCOMPARE(native(plan, job::NativeReason::UnknownPosition).text,
             std::string("G2 X10 Y0 I5 J0 F100"));
    QCOMPARE(native(arcOf("G91 G3 X10. Y2. R8. F100."), job::NativeReason::UnknownPosition).text,
             std::string("G3 X=IC(10) Y=IC(2) CR=8 F100"));
    // Across another plane it is refused. The advice must not be to leave X out.
    QCOMPARE(refusals(arcOf("G18 G2 X10. Z0. I5. K0. F100.")),
             QStringLiteral("3 start-unknown G18 G2 X10. Z0. I5. K0. F100."));
  }

  /// M functions of another machine: as the user has said, else they are refused.
  void functionsOfAnotherMachine() {
    const char* const program = "G0 X0. Y0. Z5.\nM163\nG0 X1.\nM11\nM163\nG91 G0 X1.\n";
    QCOMPARE(refusals(planOf(program, gcode::Dialect::Fanuc)),
             QStringLiteral("2 function-unknown M163 | 4 function-unknown M11 | 5 function-unknown "
                            "M163"));
    job::Profile profile;
    profile.functions = {{{163}, ""}, {{11}, "M21"}};
    const job::Plan plan = planOf(program, gcode::Dialect::Fanuc, profile);
    QCOMPARE(refusals(plan), QString());
    // What is left out does not part the motion; what the control does may move the axes.
    QCOMPARE(text(test::printParts(plan)),
             QStringLiteral("stretch 1 1-3: 2 points from ? | native 4 other M21 | settings 5 | "
                            "native 6 unknown-position G0 X=IC(1)"));
    QCOMPARE(plan.functions.size(), std::size_t{2});
    QCOMPARE(plan.functions.back().name.number, 163);
    QCOMPARE(plan.functions.back().count, std::size_t{2});
    QVERIFY(!plan.functions.back().isAssumed);
    job::Profile pictured;
    pictured.leavesOutFunctions = true;
    // What the language itself defines is no machine's.
    QCOMPARE(refusals(planOf("G0 X0 Y0 Z5\nM61 Q3\nG0 X1\n", gcode::Dialect::LinuxCnc, pictured)),
             QStringLiteral("2 not-translated M61"));
    QVERIFY(planOf(program, gcode::Dialect::Fanuc, pictured).functions.front().isAssumed);
  }

  /// The control does not know the variables that Rivulet has computed.
  void valuesTakeThePlaceOfCalculations() {
    const job::Plan plan = planOf(
        "DEF REAL HOME=20\nR1=500\nS=R1*2 M3\nMSG(\"S is \"<<R1)\nMSG(\"READY\")\nG0 X1 Y1 Z1\n"
        "SUPA G0 Z=HOME D0\nG1 X=IC(R1/100) M8 F100\n");
    QCOMPARE(
        text(test::printParts(plan)),
        QStringLiteral("settings 1-2 | native 3 spindle S=1000 M3 | native 4 message MSG(\"S is "
                       "500\") | native 5 message MSG(\"READY\") | stretch 1 6: 1 point from "
                       "? | native 7 retract SUPA G0 Z=20 D0 | native 8 coolant G1 X=IC(5) M8 "
                       "F100"));
    QVERIFY(!std::get<job::NativeBlock>(plan.parts.at(1)).calculates);
    QVERIFY(!std::get<job::NativeBlock>(plan.parts.at(2)).calculates);
    QVERIFY(!std::get<job::NativeBlock>(plan.parts.at(3)).calculates);
  }

  /// What neither Rivulet nor a table knows stays an error, and what the user leaves out stays out.
  void unknownWordsAreErrors() {
    QVERIFY(!planOf("G0 X0\nG999\nG0 X1\n").isWhole());
    gcode::LoadOptions options;
    options.dialect = gcode::Dialect::Sinumerik;
    options.accepted = {"G41"};
    const auto plan = job::makePlan("PART.MPF", "G0 X0 Y0\nG41 G0 X1\nG0 X2\n", options);
    QVERIFY(plan.has_value());
    QCOMPARE(text(test::printParts(*plan)), QStringLiteral("stretch 1 1-3: 3 points from ?"));
  }

  /// Other dialects: the words for the machine are translated, and the motion of the same block is
  /// streamed.
  void isoBlocks() {
    const job::Plan plan = planOf(
        "T5 M6\n"
        "G0 G90 G54 X10. Y20. S3000 M3\n"
        "G43 Z50. H5 M8\n"
        "G1 Z-1. F200.\n"
        "G0 Z50. M9\n"
        "G91 G28 Z0.\n"
        "G90 G0 X0. Y0.\n"
        "G4 P500\n"
        "M30\n",
        gcode::Dialect::Fanuc);
    QCOMPARE(refusals(plan), QString());
    QVERIFY(plan.isWhole());
    QCOMPARE(
        text(test::printParts(plan)),
        QStringLiteral(
            "native 1 tool T5 M6\nD0 | native 2 work-offset G54 S3000 M3 | stretch 1 2: 1 point "
            "from ? "
            "| "
            "native 3 tool D1 M8 | stretch 2 3-5: 3 points from ? | native 5 coolant M9 | native "
            "6 retract SUPA G0 Z0 D0\nD1 | stretch 3 7: 1 point from ? | native 8 dwell G4 F0.5 | "
            "native 9 end M30"));
    QCOMPARE(text(test::printPoints(plan.program.trajectory)),
             QStringLiteral("2 R X10 Y20 Z? | 3 R X10 Y20 Z50 | 4 L X10 Y20 "
                            "Z-1 F200 | 5 R X10 Y20 Z50 | 7 R X0 Y0 Z?"));
  }

  /// Catches a length that nobody has asked for, and one of another tool.
  void toolLength_data() {
    QTest::addColumn<QString>("program");
    QTest::addColumn<QString>("parts");
    QTest::addColumn<QString>("refused");
    QTest::newRow("none without G43") << "T1 M6\nG0 X0 Y0 Z10\nM30\n"
                                      << "native 1 tool T1 M6\nD0"
                                      << "";
    QTest::newRow("that of the tool") << "T2 M6\nG43 H2\nG0 X0 Y0 Z10\nM30\n"
                                      << "native 1 tool T2 M6\nD0 | native 2 tool D1"
                                      << "";
    QTest::newRow("one of another tool") << "T2 M6\nG43 H12\nG0 X0 Y0 Z10\nM30\n"
                                         << ""
                                         << "H12";
    QTest::newRow("a tool that waits")
        << "T2 M6\nT3\nG43 H2\nG0 X0 Y0 Z10\nM30\n"
        << "native 1 tool T2 M6\nD0 | native 2 tool T3 | native 3 tool D1"
        << "";
    QTest::newRow("none after G49")
        << "T2 M6\nG43 H2\nG49\nG0 X0 Y0 Z10\nM30\n"
        << "native 1 tool T2 M6\nD0 | native 2 tool D1 | native 3 tool D0"
        << "";
    // Fanuc: H stays in force until another one, H0 or G49.
    QTest::newRow("the length before, kept over a tool change")
        << "T1 M6\nG43 H1 Z50\nG91 G28 Z0\nT2 M6\nG90 G0 X1 Y1\nZ10\nM30\n"
        << ""
        << "6 length-kept H1 (T2)";
    QTest::newRow("kept, and moved in the plane alone")
        << "T1 M6\nG43 H1 Z50\nG91 G28 Z0\nT2 M6\nG90 G0 X1 Y1\nG43 H2 Z10\nM30\n"
        << "native 1 tool T1 M6\nD0 | native 2 tool D1 | stretch 1 2: 1 point from ? | native 3 "
           "retract SUPA G0 Z0 D0\nD1 | native 4 tool T2 M6\nD0 | stretch 2 5: 1 point from ? | "
           "native 6 tool D1"
        << "";
    QTest::newRow("kept, and cancelled")
        << "T1 M6\nG43 H1 Z50\nT2 M6\nG49\nG0 X1 Y1 Z10\nM30\n"
        << "native 1 tool T1 M6\nD0 | native 2 tool D1 | stretch 1 2: 1 point from ? | native 3 "
           "tool T2 M6\nD0 | native 4 tool  | stretch 2 5"
        << "";
    QTest::newRow("the same tool again")
        << "T1 M6\nG43 H1 Z50\nT1 M6\nG0 X1 Y1 Z10\nM30\n"
        << "native 1 tool T1 M6\nD0 | native 2 tool D1 | stretch 1 2: 1 point from ? | native 3 "
           "tool T1 M6\nD1"
        << "";
    QTest::newRow("G43 alone: H stays") << "T2 M6\nG43 H2 Z5\nG49\nG43 Z6\nM30\n"
                                        << "native 1 tool T2 M6\nD0 | native 2 tool D1 | stretch "
                                           "1 2: 1 point from ? | native 3 tool D0 | native 4 "
                                           "tool D1"
                                        << "";
    QTest::newRow("no tool has been called") << "G43 H5 Z50\nM30\n"
                                             << ""
                                             << "1 tool-not-called H5";
    QTest::newRow("T alone names it") << "T5\nG43 H5 Z50\nM30\n"
                                      << "native 1 tool T5 | native 2 tool D1"
                                      << "";
    QTest::newRow("H0") << "T2 M6\nG43 H0\nG0 X0 Y0 Z10\nM30\n"
                        << "native 1 tool T2 M6\nD0 | native 2 tool D0"
                        << "";
  }
  void toolLength() {
    QFETCH(const QString, program);
    QFETCH(const QString, parts);
    QFETCH(const QString, refused);
    const job::Plan plan = planOf(qPrintable(program), gcode::Dialect::Fanuc);
    QVERIFY2(refused.isEmpty() ? refusals(plan).isEmpty() : refusals(plan).contains(refused),
             qPrintable(refusals(plan)));
    const QString made = text(test::printParts(plan));
    QVERIFY2(made.contains(parts), qPrintable(made));
  }

  void translationComesFromTheProfile() {
    job::Profile profile;
    profile.retract = "G75 Z1=0";
    profile.toolChange = "TC(%1)";
    const job::Plan plan = planOf("T7 M6\nG28 Z0.\n", gcode::Dialect::Fanuc, profile);
    QCOMPARE(text(test::printParts(plan)),
             QStringLiteral("native 1 tool TC(7)\nD0 | native 2 retract G75 Z1=0\nD0"));
  }

  /// A rotary axis goes home as well.
  void rotaryAxesGoHome() {
    const job::Plan plan =
        planOf("G0 X0. Y0. Z5. B90.\nG91 G28 X0 B0\nG90 G53 Z-10. C30.\n", gcode::Dialect::Fanuc);
    QCOMPARE(text(test::printParts(plan)),
             QStringLiteral("stretch 1 1: 1 point from ? | native 2 retract SUPA G0 X0 Y0\nSUPA G0 "
                            "B0 | native 3 retract SUPA G0 Z-10 D0\nSUPA G0 C30\nD1"));
  }

  void plainTextOfHeidenhain() {
    const job::Plan plan = planOf(
        "0 BEGIN PGM A MM\n"
        "1 TOOL CALL 5 Z S3000\n"
        "2 L X+10 Y+0 R0 FMAX M3\n"
        "3 L Z-5 F200 M8\n"
        "4 L Z+100 R0 FMAX M9\n"
        "5 L Z+0 R0 FMAX M91\n"
        "6 END PGM A MM\n",
        gcode::Dialect::Heidenhain);
    QCOMPARE(refusals(plan), QString());
    QCOMPARE(
        text(test::printParts(plan)),
        QStringLiteral(
            "settings 1 | native 2 tool T5 M6 S3000 | native 3 spindle M3 | stretch 1 3: 1 point "
            "from ? | native 4 coolant M8 | stretch 2 4-5: 2 points from ? | native 5 coolant M9 "
            "| native 6 retract SUPA G0 Z0 D0\nD1 | native 7 end M30"));
  }

  /// What the table lacks is named.
  void notTranslated() {
    const job::Plan plan = planOf("G0 X0. Y0. Z5.\nM60\nG81 X1. F100.\n", gcode::Dialect::Fanuc);
    QVERIFY(!plan.isWhole());
    QCOMPARE(refusals(plan),  // a cycle without Z
             QStringLiteral("2 function-unknown M60 | 3 cycle-incomplete G81 (Z)"));
    QCOMPARE(QString::fromStdString(job::describe(plan.refusals.back())),
             QStringLiteral("The canned cycle G81 (Z) lacks a value, or has one that does not "
                            "fit: write it into the block."));
  }

  void settingsOfTheControl_data() {
    QTest::addColumn<QString>("program");
    QTest::addColumn<QString>("given");  ///< settings that the user has said
    QTest::addColumn<QString>("lines");
    QTest::addColumn<QString>("open");
    const auto row = [](const char* name, const char* program, const char* given, const char* lines,
                        const char* open) {
      QTest::newRow(name) << program << given << lines << open;
    };
    row("no R: from the height before it", "G98 G81 X1. Z-5. F100.\n", "",
        "G0 X1;G1 Z-5 F100;G0 Z9", "G81: plane=0");
    row("R as said", "G98 G81 X1. Z-5. F100.\n", "plane=8", "G0 X1;G0 Z1;G1 Z-5 F100;G0 Z1;G0 Z9",
        "");
    row("no Q: at once", "G99 G83 X1. R1. Z-5. F100.\n", "", "G0 X1;G0 Z1;G1 Z-5 F100;G0 Z1",
        "G83: stroke=0");
    row("Q0: the same", "G99 G73 X1. R1. Z-5. Q0 F100.\n", "", "G0 X1;G0 Z1;G1 Z-5 F100;G0 Z1",
        "G73: stroke=0");
    row("Q and the clearance as said", "G99 G83 X1. R1. Z-5. F100.\n", "stroke=4 clearance=0.5",
        "G0 X1;G0 Z1;G1 Z-3 F100;G0 Z1;G0 Z-2.5;G1 Z-5 F100;G0 Z1", "");
    row("Q is that of the hole before, until G80",
        "G99 G83 X1. R1. Z-2. Q2. F100.\nX2.\nG80\nG83 X3. R1. Z-2. F100.\n", "",
        "G0 X1;G0 Z1;G1 Z-1 F100;G0 Z1;G0 Z-0.75;G1 Z-2 F100;G0 Z1;G0 X2;G1 Z-1 F100;G0 Z1;"
        "G0 Z-0.75;G1 Z-2 F100;G0 Z1;G0 X3;G1 Z-2 F100;G0 Z1",
        "G83: stroke=0");
    row("no S", "G99 G84 X1. R1. Z-5. F625.\n", "",
        "G0 X1;G0 Z1;CYCLE84(1,1,0,-5,,0,3,,1.25,,500,500)", "G84: tap-speed=500");
    row("fine boring", "G99 M3 G76 X1. R1. Z-5. Q.5 F100.\n", "",
        "M3;G0 X1;G0 Z1;G1 Z-5 F100;SPOS=0;G0 X1.5;G0 Z1;G0 X1;M3", "G76: lift=X lift-angle=0");
    row("fine boring as said", "G99 M3 G76 X1. R1. Z-5. Q.5 F100.\n", "lift=-Y lift-angle=90",
        "M3;G0 X1;G0 Z1;G1 Z-5 F100;SPOS=90;G0 Y-0.5;G0 Z1;G0 Y0;M3", "");
    row("fine boring by I and J", "G99 M3 G76 X1. R1. Z-5. I-.5 J.25 F100.\n", "lift-angle=0",
        "M3;G0 X1;G0 Z1;G1 Z-5 F100;SPOS=0;G0 X0.5 Y0.25;G0 Z1;G0 X1 Y0;M3", "");
    row("a line that says no centre", "G1 Z1. F100.\nG2 X1.\nM8\n", "arc=line", "M8", "");
    row("a listed offset", "G54.1 P3\nG0 X1.\n", "", "G509", "G54.1 P: offset=507");
    row("a listed offset as said", "G54.1 P3\nG0 X1.\n", "offset=510", "G512", "");
    row("from behind", "G99 M3 G87 X1. R-5. Z-2. Q.5 F100.\n", "lift=X lift-angle=0",
        "M3;G0 X1;SPOS=0;G0 X1.5;G0 Z-5;G0 X1;M3;G1 Z-2 F100;SPOS=0;G0 X1.5;G0 Z9;G0 X1;M3", "");
  }
  /// What a program leaves out, a control takes from its settings: Fanuc 30i, canned cycles;
  /// parameters 5101 (RD1, RD2), 5148; Haas, settings 22, 27 and 52. It is said, or a virtual
  /// machine has one of its own.
  void settingsOfTheControl() {
    QFETCH(const QString, program);
    QFETCH(const QString, given);
    QFETCH(const QString, lines);
    QFETCH(const QString, open);
    gcode::LoadOptions options;
    options.dialect = gcode::Dialect::Fanuc;
    options.settings = gcode::controlSettingsOf(given.toStdString()).value();
    const std::string whole = "G21 G0 X0. Y0. Z9.\n" + program.toStdString();
    const auto plan = job::makePlan("A.NC", whole, options);
    QVERIFY(plan.has_value());
    QCOMPARE(refusals(*plan), QString());
    QCOMPARE(nativeLines(*plan), lines);
    const gcode::Diagnostic* const found = gcode::openSetting(plan->program);
    QCOMPARE(found == nullptr ? QString() : QString::fromStdString(found->argument), open);
    QCOMPARE(gcode::openSettings(plan->program).empty(), open.isEmpty());
    // Taken as the finding says, nothing is open, and the job is the same.
    options.settings.merge(gcode::openSettings(plan->program));
    const auto said = job::makePlan("A.NC", whole, options);
    QVERIFY(said.has_value());
    QVERIFY(gcode::openSetting(said->program) == nullptr);
    QCOMPARE(nativeLines(*said), lines);
  }

  /// G76 of LinuxCNC cuts threads, and a lift along the tool is none.
  void noSettingForAnotherCycle() {
    QCOMPARE(refusals(planOf("G21 G0 X0 Y0 Z9\nG76 P1 Z-5 I-1 J1 K2 R1 Q29\n",
                             gcode::Dialect::LinuxCnc)),
             QStringLiteral("2 not-translated G76"));
    gcode::LoadOptions options;
    options.dialect = gcode::Dialect::Haas;
    options.settings = gcode::controlSettingsOf("lift=Z").value();
    const auto plan = job::makePlan("A.NC", "G0 X0 Y0 Z9.\nG76 X1. R1. Z-5. Q1. F9.\n", options);
    QVERIFY(plan.has_value());
    QCOMPARE(refusals(*plan), QStringLiteral("2 cycle-incomplete G76 (lift)"));
    for (const char* wrong : {"lift=W", "lift", "=1", "plane=-1", "depth=1", "plane=1,5"}) {
      QVERIFY2(!gcode::controlSettingsOf(wrong), wrong);
    }
  }

  void cannedCycles_data() {
    QTest::addColumn<QString>("program");
    QTest::addColumn<QString>("lines");  ///< for the control, of all cycles
    QTest::newRow("to the height before it")
        << "G98 G81 X1. Y1. Z-5. R1. F100.\nX2.\nG80\n"
        << "G0 X1 Y1;G0 Z1;G1 Z-5 F100;G0 Z1;G0 Z9;G0 X2;G0 Z1;G1 Z-5 F100;G0 Z1;G0 Z9";
    QTest::newRow("to the retraction plane")
        << "G99 G82 X1. Z-5. R1. P500 F100.\nX2. Z-6.\n"
        << "G0 X1;G0 Z1;G1 Z-5 F100;G4 F0.5;G0 Z1;G0 X2;G1 Z-6 F100;G4 F0.5;G0 Z1";
    QTest::newRow("increments, repeated") << "G91 G99 G81 X1. Z-3. R-5. K2 F100.\n"
                                          << "G0 X1;G0 Z4;G1 Z1 F100;G0 Z4;G0 X2;G1 Z1 F100;G0 Z4";
    QTest::newRow("pecking") << "G99 G83 X1. Z-5. R1. Q4. F100.\n"
                             << "G0 X1;G0 Z1;G1 Z-3 F100;G0 Z1;G0 Z-2.75;G1 Z-5 F100;G0 Z1";
    QTest::newRow("chip breaking") << "G99 G73 X1. Z-5. R1. Q4. F100.\n"
                                   << "G0 X1;G0 Z1;G1 Z-3 F100;G0 Z-2.75;G1 Z-5 F100;G0 Z1";
    QTest::newRow("with another angle")
        << "B0.\nG99 G81 X1. Z-5. R1. F100. B90.\nX2.\nX3. B90.\n"
        << "G0 B90;G0 X1;G0 Z1;G1 Z-5 F100;G0 Z1;G0 X2;G1 Z-5 F100;G0 Z1;G0 X3;G1 Z-5 F100;G0 Z1";
    QTest::newRow("from a height of the machine")
        << "G53 G0 Z0.\nG98 G81 X1. Z-5. R1. F100.\nX2.\nG80\n"
        << "SUPA G0 Z0 D0;D1;G0 X1;G0 Z1;G1 Z-5 F100;G0 Z1;SUPA G0 Z0 D0;D1;G0 X2;G0 Z1;"
           "G1 Z-5 F100;G0 Z1;SUPA G0 Z0 D0;D1";
    QTest::newRow("tapping") << "G99 S500 M3 G84 X1. Z-5. R1. F625.\n"
                             << "S500 M3;G0 X1;G0 Z1;CYCLE84(1,1,0,-5,,0,3,,1.25,,500,500)";
    QTest::newRow("boring") << "G99 G85 X1. Z-5. R1. F100.\nG86 X2.\n"
                            << "G0 X1;G0 Z1;G1 Z-5 F100;G1 Z1 F100;G0 X2;G1 Z-5 F100;M5;G0 Z1;M3";
    QTest::newRow("inch") << "G20 G99 G81 X1. Z-1. R0. F10.\n"
                          << "G0 X25.4;G0 Z0;G1 Z-25.4 F254;G0 Z0";
    QTest::newRow("with an offset") << "G52 X100. Z1.\nG99 G81 X1. Z-5. R1. F100.\n"
                                    << "G0 X101;G0 Z2;G1 Z-4 F100;G0 Z2";
  }
  void cannedCycles() {
    QFETCH(const QString, program);
    QFETCH(const QString, lines);
    const job::Plan plan = planOf(
        ("G0 X0. Y0. Z9.\n" + program + "G0 X50.\n").toStdString().c_str(), gcode::Dialect::Fanuc);
    QCOMPARE(refusals(plan), QString());
    QCOMPARE(nativeLines(plan), lines);
    // What follows begins above the last hole.
    const auto& last = std::get<job::Stretch>(plan.parts.back());
    QCOMPARE(last.startIsKnown(), !program.startsWith(QStringLiteral("G53")));
  }

  /// The user has said which length it is.
  void acceptedLength() {
    gcode::LoadOptions options;
    options.dialect = gcode::Dialect::Fanuc;
    options.accepted = {"H5", "H12"};
    const auto plan = job::makePlan("A.NC", "G43 H5 Z50\nT2 M6\nG43 H12 Z5\n", options);
    QVERIFY(plan.has_value());
    QCOMPARE(refusals(*plan), QString());
    QCOMPARE(text(test::printParts(*plan)),
             QStringLiteral("native 1 tool D1 | stretch 1 1: 1 point from ? | native 2 tool T2 "
                            "M6\nD0 | native 3 tool D1 | stretch 2 3: 1 point from ?"));
    job::Profile virtualMachine;
    virtualMachine.assumesTool = true;
    const job::Plan assumed = planOf("G43 H5 Z50\n", gcode::Dialect::Fanuc, virtualMachine);
    QCOMPARE(refusals(assumed), QString());
    QCOMPARE(assumed.assumedTool.word, std::string("H5"));
    // Of another tool, and of the one before the change.
    const char* const others = "T2 M6\nG43 H3 Z5.\nT4 M6\nZ6.\nG43 H4 Z5.\n";
    QCOMPARE(refusals(planOf(others, gcode::Dialect::Fanuc)),
             QStringLiteral("2 length-of-other-tool H3 (T2)"));
    const job::Plan other = planOf(others, gcode::Dialect::Fanuc, virtualMachine);
    QCOMPARE(refusals(other), QString());
    QCOMPARE(other.assumedLengths.size(), std::size_t{2});
    QCOMPARE(other.assumedLengths.front().word, std::string("H3 (T2)"));
    QCOMPARE(other.assumedLengths.back().word, std::string("H3 (T4)"));
  }

  /// D0 has no radius: the tool gets its own, and a length of 0, until there is one.
  void compensationWithoutLength() {
    const job::Plan plan = planOf("T3 M6\nG0 X0 Y0 Z2\nG41 D3 X10 F100\nG40 X0\nG43 H3 Z5\n",
                                  gcode::Dialect::LinuxCnc);
    QCOMPARE(refusals(plan), QString());
    QCOMPARE(text(test::printParts(plan)),
             QStringLiteral(
                 "native 1 tool T3 M6\nD0 | stretch 1 2: 1 point from ? | native 3 "
                 "radius-compensation TOFFL=0\nD1\nTOFFL=-$P_TOOLL[1]\nG41\nG0 X10 | native 4 "
                 "radius-compensation G40\nG0 X0 | native 5 tool TOFFL=0\nD1 | stretch 2 5: "
                 "1 point from ?"));
  }

  /// Between G41 and G40 the control moves, with arcs to their centres.
  void compensationOfIso() {
    const job::Plan plan = planOf(
        "T3 M6\nG43 H3\nG0 G90 X0. Y0. Z2.\nG1 Z-1. F100.\nG41 D13 X10. Y0.\nX20. M8\n"
        "G3 X30. Y10. R10.\nG40 G1 X40.\nG0 Z2.\n",
        gcode::Dialect::Fanuc);
    QCOMPARE(refusals(plan), QString());
    QCOMPARE(text(test::printParts(plan)),
             QStringLiteral("native 1 tool T3 M6\nD0 | native 2 tool D1 | stretch 1 3-4: 2 points "
                            "from ? | native 5 "
                            "radius-compensation G41\nG1 X10 F100 | native 6 radius-compensation "
                            "M8\nG1 X20 F100 | native 7 radius-compensation G3 X30 Y10 I=AC(20) "
                            "J=AC(10) F100 | native 8 radius-compensation G40\nG1 X40 F100 | "
                            "stretch 2 9: 1 point"));
  }

  void incrementsFromUnknownPosition() {
    const job::Plan plan = planOf("G20 G91 G0 X1. Z.5\nG90 Y2.\nG91 G1 X1. Y1. F10.\nG90 X0.\n",
                                  gcode::Dialect::Fanuc);
    QCOMPARE(refusals(plan), QString());
    QCOMPARE(text(test::printParts(plan)),
             QStringLiteral("native 1 unknown-position G0 X=IC(25.4) Z=IC(12.7) | stretch 1 2: 1 "
                            "point from ? | native 3 unknown-position G1 X=IC(25.4) Y76.2 F254 | "
                            "stretch 2 4: 1 point from ?"));
  }

  /// The shortest way, from where only the control knows the axis: a SINUMERIK finds it, and no
  /// program of another make has a word for it there.
  void turnFromUnknownAngle() {
    const job::Plan own = planOf("G0 X0 Y0 Z9\nG0 X1 C=DC(350)\nX2 C=DC(10)\n");
    QCOMPARE(refusals(own), QString());
    QCOMPARE(text(test::printParts(own)),
             QStringLiteral("stretch 1 1: 1 point from ? | native 2 unknown-position G0 X1 "
                            "C=DC(350) | native 3 unknown-position X2 C=DC(10)"));
    const char* const shortest =
        "0 BEGIN PGM A MM\n1 L X+0 Y+0 Z+9 R0 FMAX\n2 M126\n3 L C+350 FMAX\n4 END PGM A MM\n";
    QCOMPARE(refusals(planOf(shortest, gcode::Dialect::Heidenhain)),
             QStringLiteral("4 start-unknown 3 L C+350 FMAX"));
    job::Profile virtualMachine;  // it begins at a known angle
    virtualMachine.assumesTool = true;
    QCOMPARE(refusals(planOf(shortest, gcode::Dialect::Heidenhain, virtualMachine)), QString());
  }

  void leftOutByTheUser() {
    gcode::LoadOptions options;
    options.dialect = gcode::Dialect::Fanuc;
    options.accepted = {"M60"};
    const auto plan = job::makePlan("A.NC", "M60 M8\nG0 X1.\n", options);
    QVERIFY(plan.has_value());
    QVERIFY(plan->isWhole());
    QCOMPARE(text(test::printParts(*plan)),
             QStringLiteral("native 1 coolant M8 | stretch 1 2: 1 point from ?"));
  }

  void splineIsNotInterrupted() {
    const job::Plan plan =
        planOf("G1 X0 Y0 Z0 F100\nBSPLINE X1 Y1\nX2 Y0\nM8\nX3 Y1\nX4 Y0\nG1 X5\n");
    QCOMPARE(refusals(plan), QStringLiteral("4 curve-interrupted M8"));
  }

  /// ASPLINE ends a B-spline, as G1 does, and is the control's until another motion.
  void splineThroughPointsIsTheControls() {
    const job::Plan plan = planOf(
        "G1 X0 Y0 F100\nBSPLINE SD=2\nX1 Y1 PW=2\nX2 Y0\nASPLINE BNAT ETAN\nX3 Y1\nX4 Y0\nG1 X5 "
        "Y0\nX6\nM30\n");
    QCOMPARE(refusals(plan), QString());
    QVERIFY(plan.isWhole());
    QCOMPARE(nativeLines(plan), QStringLiteral("ASPLINE BNAT ETAN;X3 Y1;X4 Y0;G1 X5 Y0;M30"));
    const auto& points = plan.program.trajectory.points;
    double xMmMax = 0.0;
    for (const gcode::TrajectoryPoint& point : points) {
      xMmMax = point.line.value < 6 ? std::max(xMmMax, point.positionMm.x) : xMmMax;
    }
    QCOMPARE(xMmMax, 2.0);
    QCOMPARE(points.back().positionMm.x, 6.0);
  }

  /// Where a rotary axis stands after a move to a fixed point, the control knows: it turns by the
  /// increment itself.
  void turnsFromUnknown() {
    const auto linesOf = [](const char* program) {
      const job::Plan plan = planOf(program, gcode::Dialect::Fanuc);
      return refusals(plan) + nativeLines(plan);
    };
    QCOMPARE(linesOf("G0 X0. Y0. Z5.\nG91 G28 Z0. B0.\nG0 B-37.5 C45.\n").section(';', -1),
             QStringLiteral("G0 B=IC(-37.5) C=IC(45)"));
    QCOMPARE(linesOf("G0 X0. Y0. Z5.\nG91 G28 B0.\nG94 G1 B-37.5 F100.\n").section(';', -1),
             QStringLiteral("G1 B=IC(-37.5) F100"));
    // Beside X the feed is no feed of the angle.
    QVERIFY(linesOf("G0 X0. Y0. Z5.\nG91 G28 B0.\nG1 X5. B-37.5 F100.\n").contains("B-37.5"));
  }

  /// An axis that the source's machine has beside X Y Z A B C: as an M function of its builder.
  void axesOfAnotherMachine() {
    const char* const program = "G0 X0. Y0. Z5.\nW5.\nG91 W-1.\nG90 X1.\n";
    QCOMPARE(refusals(planOf(program, gcode::Dialect::Fanuc)),
             QStringLiteral("2 function-unknown W | 3 function-unknown W"));
    job::Profile profile;
    profile.functions = {{{0, 'W'}, "W"}};
    const job::Plan passed = planOf(program, gcode::Dialect::Fanuc, profile);
    QCOMPARE(refusals(passed), QString());
    QCOMPARE(nativeLines(passed), QStringLiteral("G0 W=5;G0 W=IC(-1)"));
    QCOMPARE(refusals(planOf("G0 X0. Y0. Z5.\nX1. W5.\n", gcode::Dialect::Fanuc, profile)),
             QStringLiteral("2 not-translated W5"));
    QCOMPARE(refusals(planOf("G0 X0. Y0. Z5.\nG1 W5. F100.\n", gcode::Dialect::Fanuc, profile)),
             QStringLiteral("2 not-translated W5"));
    // Home with the others, it is no move of its own.
    QCOMPARE(refusals(planOf("G0 X0. Y0. Z5.\nG91 G28 Z0. W0.\n", gcode::Dialect::Fanuc, profile)),
             QStringLiteral("2 not-translated W0"));
    profile.functions = {{{0, 'W'}, ""}};
    QVERIFY(planOf("G0 X0. Y0. Z5.\nG91 G28 Z0. W0.\n", gcode::Dialect::Fanuc, profile).isWhole());
    QCOMPARE(nativeLines(planOf(program, gcode::Dialect::Fanuc, profile)), QString());
    job::Profile pictured;
    pictured.leavesOutFunctions = true;
    const job::Plan left = planOf(program, gcode::Dialect::Fanuc, pictured);
    QVERIFY(left.isWhole());
    QCOMPARE(left.functions.front().name.axis, 'W');
    QVERIFY(left.functions.front().isAssumed);
    // The control of the program has the axis.
    QVERIFY(nativeLines(planOf("G0 X0 Y0 Z5\nG0 W5\nX1\n")).startsWith("G0 W5"));
  }
};

RIVULET_TEST(TestSplitter)
#include "tst_splitter.moc"
