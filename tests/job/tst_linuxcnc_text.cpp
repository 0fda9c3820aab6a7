// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Native blocks in the language of LinuxCNC. What its interpreter makes of them is judged by itself
// (test_linuxcnc_jobs).

#include <QtTest>

#include "job/linuxcnc_text.h"
#include "job/main_program.h"
#include "job/plan.h"
#include "support/test_program.h"

using namespace rivulet;

namespace {

QString lines(const tl::expected<std::string, std::string>& text) {
  return text ? QString::fromStdString(*text) : "no: " + QString::fromStdString(text.error());
}

base::Result<job::JobPrograms> programsOf(const std::string& text, gcode::Dialect dialect) {
  gcode::LoadOptions options;
  options.dialect = dialect;
  const auto plan = job::makePlan("part.ngc", text, options, {});
  templates::TemplateParameters parameters;
  parameters.target = templates::TargetControl::LinuxCnc;
  return plan ? job::makePrograms(*plan, parameters) : base::fail(plan.error());
}

}  // namespace

class TestLinuxCncText final : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void words_data() {
    QTest::addColumn<QString>("sinumerik");
    QTest::addColumn<QString>("linuxCnc");
    const auto row = [](const char* from, const char* to) { QTest::newRow(from) << from << to; };
    row("N10 T5 M6 ; mill", "T5 M6");
    row("D1", "G43");
    row("D0", "G49");
    row("S3000 M3", "S3000 M3");
    row("M8", "M8");
    row("G505", "G58");
    row("G57", "G57");
    row("G4 F1.5", "G4 P1.5");
    row("SUPA G0 Z0 D0", "G49 G53 G0 Z0");
    row("SUPA G0 A90", "G53 G0 A90");
    row("G0 X=IC(5) Y2", "G0 X[#<_x>+5] Y2");
    row("G1 X=IC(-5) F100", "F100 G1 X[#<_x>-5]");
    row("G2 X1 Y2 I=AC(3) J=AC(-4) F100", "G90.1\nF100 G2 X1 Y2 I3 J-4\nG91.1");
    row("G3 X1 Y2 CR=5", "G3 X1 Y2 R5");
    row("G3 X1 Y2 I3 J4 TURN=2", "G3 X1 Y2 I3 J4 P3");
    row("G18 G1 X1", "G18 G1 X1");
    row("G17 G90 G94 G710 DIAMOF", "");  // as the loop has left it
    row("G700 X1", "no: G700 X1");       // where the move goes from is not said
    row("G1 G700 G95 F0.1 X1", "G20 G95 F0.1 G1 X1");
    row("G60", "G61");
    row("G64 SOFT FFWON", "G64 P0.01 Q0");
    row("MSG(\"roughing\")", "");
    row("$P_UIFR[2,X,TR]=5 $P_UIFR[2,Z,TR]=-1", "G10 L2 P2 X5 Z-1");
    row("G54\nG0 X1\nY2", "G54\nG0 X1\nG0 Y2");
    row("SPOS=90", "M19 R90");
    row("TOFFL=0\nD1\nTOFFL=-$P_TOOLL[1]", "G43\nG49");
    // What LinuxCNC has not, or has in another meaning.
    for (const char* const word : {"TRANS X5",     "CYCLE81(10,0,2,-5)",
                                   "T=\"MILL\"",   "D2",
                                   "G25 X10",      "G33 Z5 K1",
                                   "SUPA",         "X=DC(5)",
                                   "M41",          "M101",
                                   "G500",         "G96 S100",
                                   "TRAORI",       "OVR=50",
                                   "RND=2",        "G93",
                                   "H5",           "$P_UIFR[1,X,RT]=5",
                                   "G4 S3",        "G41 X1",
                                   "SETAL(65000)", "LIMS=100",
                                   "G70",          "R5=3"}) {
      const std::string text = std::string("G1 ") + word;
      QTest::newRow(word) << QString::fromStdString(text) << "no";
    }
  }
  void words() {
    QFETCH(const QString, sinumerik);
    QFETCH(const QString, linuxCnc);
    job::LinuxCncText text(nc::Dialect::Sinumerik);
    text.loopCalled();
    const QString found = lines(text.convert(sinumerik.toStdString()));
    if (linuxCnc == QLatin1String("no")) {
      QVERIFY2(found.startsWith(QLatin1String("no: ")), qPrintable(found));
    } else {
      QCOMPARE(found, linuxCnc);
    }
  }

  /// The tool goes beside the contour as LinuxCNC says, which is that of a program for it alone.
  void compensation() {
    job::LinuxCncText own(nc::Dialect::LinuxCnc);
    own.loopCalled();
    QCOMPARE(lines(own.convert("G41\nG1 X1 F100")), QStringLiteral("G41\nF100 G1 X1"));
    QVERIFY(own.compensates());
    QCOMPARE(lines(own.convert("G17 G90 G94 G710 DIAMOF\nG40\nG40")), QStringLiteral("G40"));
    QVERIFY(!own.compensates());
    QCOMPARE(lines(own.convert("G42 OFFN=3-$P_TOOLR")), QStringLiteral("G42.1 D6"));
    job::LinuxCncText other(nc::Dialect::Fanuc);
    QVERIFY(!other.convert("G41\nG1 X1 F100"));
    QCOMPARE(lines(other.convert("M150")), QStringLiteral("M150"));  // said by the user
  }

  /// The loop comes first, so that both count the same lines; each O-word begins once.
  void oneFile() {
    const auto programs = programsOf(
        "G21 G90 G17\nT1 M6\nG43\nG0 X0 Y0 Z5\nM8\nG1 Z-1 F300\nX10\nG98 G81 X20 Z-5 R2\nG80\n"
        "G0 X0\nM30\n",
        gcode::Dialect::LinuxCnc);
    QVERIFY(programs.has_value());
    QVERIFY(!programs->loop.isOwnFile);
    const QStringList main = QString::fromStdString(programs->mainText).split(QLatin1Char('\n'));
    QVERIFY(QString::fromStdString(programs->mainText)
                .startsWith(QString::fromStdString(programs->loop.text)));
    QVERIFY(!programs->loop.motionLines.empty());
    for (const std::uint32_t line : programs->loop.motionLines) {
      QVERIFY(main[static_cast<int>(line) - 1].startsWith(QLatin1String("G1 X#")));
    }
    QVERIFY(main[static_cast<int>(programs->loop.handoverLine) - 1].startsWith("G4 "));
    QStringList begun;
    for (const QString& line : main) {
      QVERIFY(line.size() < 255);
      const QString word = line.section(QLatin1Char(' '), 0, 0);
      if (line.endsWith(QLatin1String(" sub")) || line.contains(QLatin1String(" while [")) ||
          line.contains(QLatin1String(" if ["))) {
        QVERIFY2(!begun.contains(word), qPrintable(line));
        begun << word;
      }
    }
    QCOMPARE(main.count(QStringLiteral("T1 M6")), 1);
    QCOMPARE(main.count(QStringLiteral("M8")), 1);
  }

  /// By name and line, before anything is on the control.
  void refused() {
    const auto programs =
        programsOf("G0 X0 Y0 Z5\nS500 M3\nG84 X5 Y5 R2 Z-5 F500\nG80\nM30\n", gcode::Dialect::Haas);
    QVERIFY(!programs);
    QVERIFY(programs.error().code == job::JobError::NotTranslated);
    QCOMPARE(QString::fromStdString(programs.error().context), QStringLiteral("part.ngc:3"));
    QVERIFY(programs.error().message.find("G84 X5 Y5 R2 Z-5 F500") != std::string::npos);
  }

  /// A move in machine coordinates is given to the control as a rapid one.
  void noFeedBecomesRapid() {
    const auto refusals = [](const std::string& block, gcode::Dialect dialect) {
      gcode::LoadOptions options;
      options.dialect = dialect;
      const std::string text = "G21 G90 G17\nG0 X0 Y0 Z5\nG1 X5 F100\n" + block + "\nM30\n";
      const auto plan = job::makePlan("part.ngc", text, options, {});
      return plan && !plan->refusals.empty() ? plan->refusals.front().argument : std::string();
    };
    QCOMPARE(refusals("G53 G1 Z0", gcode::Dialect::LinuxCnc), std::string("G53 G1"));
    QCOMPARE(refusals("G53 Z0", gcode::Dialect::LinuxCnc), std::string("G53 G1"));
    QCOMPARE(refusals("G53 G0 Z0", gcode::Dialect::LinuxCnc), std::string());
    QCOMPARE(refusals("G28 Z9", gcode::Dialect::LinuxCnc), std::string());
    QCOMPARE(refusals("G53 Z0", gcode::Dialect::Fanuc), std::string());  // rapid there in any case
  }

  /// LinuxCNC keeps G98 and G99 from program to program.
  void whereACycleEndsHasToBeSaid() {
    const std::string drilled = "G21 G90 G17\nG0 X0 Y0 Z5\nG81 X5 Y5 Z-3 R2 F100\nX9\nG80\nM30\n";
    const auto planOf = [](const std::string& text, gcode::Dialect dialect) {
      gcode::LoadOptions options;
      options.dialect = dialect;
      return *job::makePlan("part.ngc", text, options, {});
    };
    const job::Plan unsaid = planOf(drilled, gcode::Dialect::LinuxCnc);
    QVERIFY(!unsaid.refusals.empty());
    QCOMPARE(QString::fromStdString(unsaid.refusals.front().argument),
             QStringLiteral("G81 (G98, G99)"));
    QVERIFY(planOf("G99\n" + drilled, gcode::Dialect::LinuxCnc).isWhole());
    QVERIFY(planOf(drilled, gcode::Dialect::Haas).isWhole());  // begins with G98
  }
};

RIVULET_TEST(TestLinuxCncText)
#include "tst_linuxcnc_text.moc"
