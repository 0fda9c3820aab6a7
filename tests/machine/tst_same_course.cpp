// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The preview of a program and the virtual machine go the same way: one program, both readers.

#include <QtTest>
#include <cmath>

#include "base/text.h"
#include "gcode/interpreter.h"
#include "machine/interpreter.h"
#include "nc/syntax/parser.h"
#include "support/test_program.h"

using namespace rivulet;

namespace {

/// X of every motion.
std::string previewed(const std::string& text, const std::map<std::string, std::string>& library) {
  gcode::LoadOptions options;
  options.dialect = nc::Dialect::Sinumerik;
  options.subprogram = [&library](std::string_view name) -> std::optional<nc::LoadedText> {
    const auto found = library.find(std::string(name));
    return found == library.end() ? std::nullopt
                                  : std::optional(nc::LoadedText{found->second, found->first});
  };
  std::string out;
  for (const gcode::TrajectoryPoint& point : gcode::interpret(text, options).trajectory.points) {
    out += base::formatFixed(point.positionMm.x, 6) + " ";
  }
  return out;
}

std::string executed(const std::string& text, const std::map<std::string, std::string>& library) {
  machine::RParameters parameters{100};
  machine::InterpreterOptions options;
  options.rapidMmPerS = 100.0;
  options.feedMmPerS = 10.0;
  options.library = [&library](const std::string& name) -> std::shared_ptr<const nc::Tree> {
    const auto found = library.find(name);
    return found == library.end()
               ? nullptr
               : std::make_shared<const nc::Tree>(nc::parseSinumerik(found->second));
  };
  machine::Interpreter interpreter(std::make_shared<const nc::Tree>(nc::parseSinumerik(text)),
                                   parameters, options);
  std::string out;
  constexpr int kBlocksMax = 20000;
  for (int block = 0; block < kBlocksMax; ++block) {
    const machine::Prepared prepared = interpreter.next();
    if (const auto* const motion = std::get_if<machine::PreparedMotion>(&prepared)) {
      out += base::formatFixed(motion->targetMm.x, 6) + " ";
    } else if (std::holds_alternative<machine::PreparedStopre>(prepared)) {
      interpreter.refresh();
    } else if (const auto* const alarm = std::get_if<machine::Alarm>(&prepared)) {
      return out + "! " + alarm->text;
    } else if (std::holds_alternative<machine::PreparedEnd>(prepared)) {
      break;
    }
  }
  return out;
}

}  // namespace

class TestSameCourse : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void previewAndMachineAgree_data() {
    QTest::addColumn<QByteArray>("text");
    const auto add = [](const char* name, const char* text) {
      QTest::newRow(name) << QByteArray("G0 X0 Y0 Z0\n") + text + "\nM30\n";
    };
    // A step of 0.1 ends beside the limit: what counts as equal decides on the last round.
    add("steps that do not sum up", "R1=0\nWHILE R1<1\nR1=R1+0.1\nX=R1\nENDWHILE");
    add("limit included", "R1=0\nREPEAT\nR1=R1+0.1\nX=R1\nUNTIL R1>=1");
    add("above", "R1=1\nWHILE R1>0\nR1=R1-0.1\nX=R1\nENDWHILE");
    add("FOR counts its limit once", "DEF INT I\nR1=3\nFOR I=1 TO R1\nR1=R1+1\nX=I\nENDFOR\nX=I");
    add("nested",
        "DEF INT I,K\nFOR I=1 TO 3\nFOR K=I TO 3\nIF K==2\nX=I*10+K\nELSE\nX=K\nENDIF\n"
        "ENDFOR\nENDFOR");
    add("jumps", "R1=0\nAGAIN:\nR1=R1+1\nX=R1\nIF R1<3 GOTOB AGAIN\nGOTOF OUT\nX99\nOUT: X7");
    add("CASE", "R1=2\nCASE(R1) OF 1 GOTOF AA 2 GOTOF BB DEFAULT GOTOF CC\nAA: X1\nBB: X2\nCC: X3");
    add("REPEAT label", "R1=0\nAA: R1=R1+1\nX=R1\nREPEAT AA P=2\nX9");
    add("REPEAT from to", "R1=0\nAA: R1=R1+1\nBB: X=R1\nX8\nREPEAT AA BB P=2\nX9");
    add("bounds", "R1=BOUND(0,10,15)\nX=R1\nX=MINVAL(3,R1)\nX=ROUNDUP(2.1)+TRUNC(-1.5)");
    add("rounded to INT", "DEF INT I\nI=2.5\nX=I\nI=-2.5\nX=I");
    add("arrays", "DEF REAL F[2,3]=SET(1,2,3,4,5,6)\nX=F[1,0]\nF[0,2]=F[1,1]+F[0,1]\nX=F[0,2]");
    add("by reference", "DEF REAL V=1,F[2]=SET(3,4)\nSUBB(V,F,F[0])\nX=V\nX=F[0]\nX=F[1]");
    add("modulo and division", "X=7 MOD 3+7 DIV 2\nX=-7 MOD 3\nX=ATAN2(1,-1)");
    add("subprogram several times", "R1=0\nCOUNT P3\nX=R1");
  }

  void previewAndMachineAgree() {
    QFETCH(const QByteArray, text);
    const std::map<std::string, std::string> library{
        {"SUBB",
         "PROC SUBB(VAR REAL AA, VAR REAL BB[], REAL CC)\nAA=BB[1]+CC\nBB[0]=9\nCC=7\nM17\n"},
        {"COUNT", "PROC COUNT\nR1=R1+1\nX=R1\nRET\n"}};
    const std::string expected = executed(text.toStdString(), library);
    QVERIFY2(expected.find('!') == std::string::npos, expected.c_str());
    QCOMPARE(QByteArray::fromStdString(previewed(text.toStdString(), library)),
             QByteArray::fromStdString(expected));
  }
};

RIVULET_TEST(TestSameCourse)
#include "tst_same_course.moc"
