// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Every generated template is without findings; a template that is broken on purpose is caught by
/// the finding that names what was broken, at the line where it matters.

#include <QtTest>
#include <algorithm>
#include <set>

#include "support/test_program.h"
#include "templates/flexible_program.h"
#include "templates/lint/lint.h"
#include "templates/method_template.h"

using namespace rivulet;
using base::MethodKind;
using templates::LintFinding;
using templates::LintRule;
using templates::LintSeverity;
using templates::SignalStop;
using templates::TemplateParameters;

Q_DECLARE_METATYPE(rivulet::templates::LintRule)
Q_DECLARE_METATYPE(rivulet::base::MethodKind)

namespace {

TemplateParameters parametersOf(MethodKind method, int points = 7) {
  TemplateParameters parameters;
  parameters.method = method;
  parameters.pointsPerLoop = points;
  return parameters;
}

std::string generated(const TemplateParameters& parameters) {
  return templates::makeProgram(parameters)->text;
}

std::vector<LintFinding> lint(const std::string& text, const TemplateParameters& parameters) {
  return templates::lintProgram(text, *templates::makeProgram(parameters));
}

QByteArray listed(const std::vector<LintFinding>& findings) {
  QByteArray text;
  for (const LintFinding& finding : findings) {
    text += QByteArray::number(finding.line.value) + " " +
            QByteArray::fromStdString(std::string(templates::lintRuleName(finding.rule))) + ": " +
            QByteArray::fromStdString(finding.message) + "\n";
  }
  return text;
}

/// Line of the first occurrence, from 1.
unsigned lineOf(const std::string& text, const std::string& part) {
  const std::size_t at = text.find(part);
  return at == std::string::npos
             ? 0
             : static_cast<unsigned>(
                   std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n')) +
                   1;
}

}  // namespace

class TestLint : public QObject {
  Q_OBJECT

 private slots:
  void generatedTemplatesAreClean();
  void brokenTemplateIsCaught_data();
  void brokenTemplateIsCaught();
  void brokenFactorIsCaught();
  void brokenCorrectionIsCaught_data();
  void brokenCorrectionIsCaught();
  void brokenLiftIsCaught();
  void studyTemplateIsWarnedOf();
  void handWrittenLoopsAreFollowed();
  void boundsOfCellsAreFollowed();
  void rulesHaveNames();
  void onlyTheGeneratedProgramForLinuxCnc();
};

void TestLint::generatedTemplatesAreClean() {
  int looked = 0;
  const auto isClean = [&looked](const TemplateParameters& parameters) {
    const auto program = templates::makeProgram(parameters);
    if (!program) {
      return;
    }
    ++looked;
    const auto findings = lint(program->text, parameters);
    QVERIFY2(findings.empty(), listed(findings) + (program->text + "\n").c_str());
  };
  using Axes = std::array<bool, base::kAxisCount>;
  for (const Axes axes :
       {Axes{true, true, true}, Axes{true, false, true}, Axes{false, true, false}}) {
    for (const int points : {1, 2, 3, 7, 12}) {
      for (const MethodKind method : base::kPaperMethods) {
        for (const auto layout : {templates::Layout::Paper, templates::Layout::Contiguous}) {
          TemplateParameters parameters = parametersOf(method, points);
          parameters.axes = axes;
          parameters.layout = layout;
          parameters.rParameterCount = 200;
          isClean(parameters);
        }
      }
      for (const int variant : {1, 2, 3, 8, 11, 12, 13, 18}) {
        const bool isCredit = variant > 10;
        const int windows = variant % 10;
        TemplateParameters parameters =
            parametersOf(isCredit ? MethodKind::Credit : MethodKind::Window, points);
        parameters.slowDown = windows != 3;
        parameters.windowsAhead = windows;
        parameters.axes = axes;
        parameters.windows = windows;
        parameters.baseCell = windows == 3 ? 40 : 0;
        parameters.slotStride = windows == 2 ? 5 : 0;
        parameters.rParameterCount = 400;
        isClean(parameters);
        parameters.correctionLimitMm = 0.01 * windows;
        isClean(parameters);
        parameters.packed = parameters.slotStride == 0;
        isClean(parameters);
      }
    }
  }
  QVERIFY(looked > 140);
}

void TestLint::brokenTemplateIsCaught_data() {
  QTest::addColumn<MethodKind>("method");
  QTest::addColumn<std::string>("find");     // what is replaced, first occurrence behind `behind`
  QTest::addColumn<std::string>("replace");  // with what
  QTest::addColumn<std::string>("behind");
  QTest::addColumn<LintRule>("rule");
  QTest::addColumn<std::string>("where");  // text in the line of the finding, after the change
  const auto row = [](const char* name, MethodKind method, const char* behind, const char* find,
                      const char* replace, LintRule rule, const char* where) {
    QTest::newRow(name) << method << std::string(find) << std::string(replace)
                        << std::string(behind) << rule << std::string(where);
  };
  const MethodKind position = MethodKind::Position;
  const MethodKind signal = MethodKind::Signal;
  const MethodKind window = MethodKind::Window;
  const MethodKind credit = MethodKind::Credit;
  row("position: no STOPRE at the end of the loop", position, "RIV_LOOP:", "STOPRE\n", "",
      LintRule::StopreMissing, "G1 X=R11");
  row("position: STOPRE jumped over on one path", position, "RIV_LOOP:", "STOPRE\n",
      "IF R90>0 GOTOF RIV_PAST\nSTOPRE\nRIV_PAST:\n", LintRule::StopreMissing, "G1 X=R11");
  row("position: no STOPRE in the waiting loop", position, "RIV_WAIT:", "STOPRE\n", "",
      LintRule::StopreMissing, "IF R2>0");
  row("position: no stop check in the waiting loop", position,
      "RIV_WAIT:", "IF R2>0 GOTOF RIV_END\n", "", LintRule::StopCheckMissing, "IF R1<1");
  row("position: no stop check in the loop", position, "RIV_LOOP:", "IF R2<1 GOTOB RIV_LOOP",
      "GOTOB RIV_LOOP", LintRule::StopCheckMissing, "GOTOB RIV_LOOP");
  row("position: the stop check leads back", position, "RIV_LOOP:", "IF R2<1 GOTOB RIV_LOOP\n",
      "IF R2<1 GOTOB RIV_LOOP\nGOTOB RIV_LOOP\n", LintRule::StopCheckMissing, "\nGOTOB RIV_LOOP");
  row("position: not waited for the client", position, "RIV_WAIT:", "IF R1<1 GOTOB RIV_WAIT\n", "",
      LintRule::HandshakeMissing, "G1 X=R11");
  row("position: R out of range", position, "RIV_LOOP:", "X=R71", "X=R171",
      LintRule::RParameterOutOfRange, "X=R171");
  row("position: wrong layout number", position, "STOPRE\n", "R4=", "R4=1",
      LintRule::WrongLayoutNumber, "R4=1");
  row("position: layout number on one path only", position, "STOPRE\n",
      "R4=", "IF R80>0 GOTOF RIV_WAIT\nR4=", LintRule::LayoutNumberMissing, "G1 X=R11");
  row("position: feed missing in the first block", position, "RIV_LOOP:", " F=R3", "",
      LintRule::FeedMissing, "G1 X=R11");
  row("position: label missing", position,
      "RIV_LOOP:", "RIV_END:", "RIV_ENDE:", LintRule::MissingLabel, "IF R2>0 GOTOF RIV_END");
  row("position: label in the other direction", position, "RIV_LOOP:", "GOTOB RIV_LOOP",
      "GOTOF RIV_LOOP", LintRule::MissingLabel, "GOTOF RIV_LOOP");
  row("position: unknown name", position, "RIV_LOOP:", "STOPRE\n", "STOPRE\nSTOPER\n",
      LintRule::UnknownName, "STOPER");
  row("position: syntax", position, "RIV_LOOP:", "Y=R12", "Y=R12+", LintRule::Syntax, "Y=R12+");
  row("position: slot forgotten", position, "RIV_LOOP:", "G1 X=R21 Y=R22 Z=R23 F=R3\n", "",
      LintRule::SlotNotRead, "M30");
  row("position: run reset too late", position, "STOPRE\n", "RIV_WAIT:\n", "R1=0\nRIV_WAIT:\n",
      LintRule::ClientCellOverwritten, "R1=0\nRIV_WAIT");
  row("position: increments", position, "", "G90 G94", "G91 G94", LintRule::RelativeMotion,
      "G1 X=R11");
  row("position: rapid", position, "RIV_LOOP:", "G1 X=R31", "G0 X=R31", LintRule::RapidMotion,
      "G0 X=R31");
  row("position: feed of its own", position, "RIV_LOOP:", "F=R3\n", "F=100\n",
      LintRule::FeedNotFromClient, "M30");
  row("position: no end", position, "RIV_END:", "M30\n", "G4 F0.1\n", LintRule::NoEnd, "G4 F0.1");
  row("signal: no STOPRE before the first signal", signal, "RIV_LOOP:", "STOPRE\nR0=0", "R0=0",
      LintRule::SignalAhead, "R0=0");
  row("signal: no STOPRE before the second signal", signal, "RIV_LOOP:", "STOPRE\nR0=1", "R0=1",
      LintRule::SignalAhead, "R0=1");
  row("window: no STOPRE between windows", window, "RIV_NEXT:", "STOPRE\n", "",
      LintRule::StopreMissing, "RIV_K=R[RIV_B]");
  row("window: STOPRE jumped over behind the last point", window, "RIV_MOVE:", "GOTOB RIV_NEXT",
      "IF (R0<2) AND (R1>RIV_L) GOTOB RIV_TAKE\nGOTOB RIV_NEXT", LintRule::StopreMissing,
      "RIV_K=R[RIV_B]");
  row("window: delivered not asked", window, "RIV_NEXT:", "(R1>RIV_L) AND (R1<=RIV_L+2)", "(R8>0)",
      LintRule::HandshakeMissing, "RIV_K=R[RIV_B]");
  row("window: no stop check", window, "RIV_NEXT:", "IF R0>1 GOTOF RIV_STOPPED\n", "",
      LintRule::StopCheckMissing, "");
  row("window: one window too many", window, "RIV_TAKE:", "RIV_B<=36", "RIV_B<=96",
      LintRule::RParameterOutOfRange, "");
  row("window: motion from the cells", window, "RIV_MOVE:", "X=RIV_C[0]", "X=R[RIV_B+3]",
      LintRule::MotionFromCells, "X=R[RIV_B+3]");
  row("window: feed missing", window, "RIV_MOVE:", " F=RIV_F", "", LintRule::FeedMissing,
      "G1 X=RIV_C[0]");
  row("window: wrong layout number", window, "STOPRE\n", "R4=", "R4=1", LintRule::WrongLayoutNumber,
      "R4=1");
  row("window: delivered reset too late", window, "STOPRE\n", "RIV_NEXT:\n", "R1=0\nRIV_NEXT:\n",
      LintRule::ClientCellOverwritten, "R1=0\nRIV_NEXT");
  row("window: name misspelt", window, "RIV_TAKE:", "RIV_IDLE=0", "RIV_IDEL=0",
      LintRule::UnknownName, "RIV_IDEL");
  row("window: point not copied", window, "RIV_TAKE:", " RIV_C[4]=R[RIV_B+7]", "",
      LintRule::SlotNotRead, "");
  row("credit: delivered not asked", credit, "RIV_ASK:", "(R1>RIV_L) AND (R1<=RIV_L+2)", "(R8>0)",
      LintRule::HandshakeMissing, "RIV_K=R[RIV_B]");
  row("credit: no stop check while the axes move", credit,
      "RIV_ASK:", "IF R0>1 GOTOF RIV_STOPPED\n", "", LintRule::StopCheckMissing, "");
  row("credit: asks for ever without a STOPRE", credit,
      "RIV_ASK:", "IF (RIV_TURN<100000) AND (RIV_DRY<25) GOTOB RIV_ASK", "GOTOB RIV_ASK",
      LintRule::StopreMissing, "");
  row("credit: state written ahead of the axes", credit, "RIV_STOPPED:", "STOPRE\n", "",
      LintRule::SignalAhead, "R3=RIV_L R5=2");
  row("credit: motion from the cells", credit, "RIV_MOVE:", "X=RIV_C[0]", "X=R[RIV_B+3]",
      LintRule::MotionFromCells, "X=R[RIV_B+3]");
  row("credit: slow is faster", credit, "ID=3", "DO $R11=10", "DO $R11=240", LintRule::FeedRaised,
      "$R11=240");
  row("credit: slow whatever is wanted", credit, "ID=3",
      " AND ($R11>10+90*ABS($AC_IPO_BUF-$AC_PATHN)/7)", "", LintRule::FeedRaised, "DO $R11=10");
  row("credit: a hold may be overtaken", credit, "ID=5", "$AC_OVR=$R11", "$AC_OVR=$R11+0.1",
      LintRule::FeedRaised, "");
  row("window: what is no override is obeyed", window, "ID=2", " AND ($R10<=200)", "",
      LintRule::FeedRaised, "ID=5");
  row("window: a negative override raises", window, "ID=2", "($R10>=0)", "(ABS($R10)>=0)",
      LintRule::FeedCellIgnored, "ID=5");
  row("window: not held in each cycle", window, "ID=1", "ID=1 DO $R11=0\n", "",
      LintRule::FeedRaised, "ID=5");
  row("window: written once", window, "ID=5", "ID=5 DO", "ID=5 WHEN TRUE DO", LintRule::FeedRaised,
      "ID=5");
  row("window: no override", window, "ID=5", "ID=5 DO $AC_OVR=$R11\n", "", LintRule::FeedRaised,
      "ID=4");
  row("window: half of it", window, "ID=2", "DO $R11=$R10", "DO $R11=0.5*$R10",
      LintRule::FeedCellIgnored, "ID=5");
  row("window: always held", window, "ID=2", "DO $R11=$R10", "DO $R11=0", LintRule::FeedCellIgnored,
      "ID=5");
  row("window: the client is not watched", window, "ID=2", " AND ($AC_TIMER[1]<=1)", "",
      LintRule::ClientNotWatched, "ID=5");
  row("window: watched for too long", window, "ID=2", "($AC_TIMER[1]<=1)", "($AC_TIMER[1]<=1.5)",
      LintRule::ClientNotWatched, "ID=5");
  row("window: moves before the first sign", window, "ID=2", " AND ($AC_TIMER[1]>=0)", "",
      LintRule::ClientNotWatched, "ID=5");
  row("credit: the time goes on", credit, "ID=4", "$AC_TIMER[1]=0", "$AC_TIMER[1]=$AC_TIMER[1]",
      LintRule::FeedCellIgnored, "");
  row("window: always a sign", window, "ID=4", "$AC_PARAM[1]=$R8 ", "", LintRule::ClientNotWatched,
      "ID=5");
  row("window: only a rising number is a sign", window, "ID=4", " OR ($R8<$AC_PARAM[1])", "",
      LintRule::ClientNotWatched, "ID=5");
  row("window: another cell is watched", window, "ID=4", "($R8>$AC_PARAM[1])", "($R6>$AC_PARAM[1])",
      LintRule::FeedCellIgnored, "ID=5");
  row("window: never a sign", window, "ID=4", "$AC_TIMER[1]=0", "$AC_TIMER[1]=-1",
      LintRule::FeedCellIgnored, "ID=5");
  row("credit: the main run writes a cell of the client", credit,
      "RIV_MOVE:", "DO $R3=", "DO $R1=", LintRule::ClientCellOverwritten, "DO $R1=");
  row("credit: wrong layout number", credit, "STOPRE\n", "R4=", "R4=1", LintRule::WrongLayoutNumber,
      "R4=1");
}

void TestLint::brokenTemplateIsCaught() {
  QFETCH(MethodKind, method);
  QFETCH(std::string, find);
  QFETCH(std::string, replace);
  QFETCH(std::string, behind);
  QFETCH(LintRule, rule);
  QFETCH(std::string, where);
  const TemplateParameters parameters = parametersOf(method);
  std::string text = generated(parameters);
  const std::size_t from = text.find(behind);
  QVERIFY(from != std::string::npos);
  std::size_t at = text.find(find, from);
  QVERIFY2(at != std::string::npos, text.c_str());
  if (rule == LintRule::FeedNotFromClient) {
    for (; at != std::string::npos; at = text.find(find, at)) {
      text.replace(at, find.size(), replace);
    }
  } else {
    text.replace(at, find.size(), replace);
  }
  const auto findings = lint(text, parameters);
  const auto found = std::find_if(findings.begin(), findings.end(),
                                  [&](const LintFinding& finding) { return finding.rule == rule; });
  QVERIFY2(found != findings.end(), text.c_str() + listed(findings));
  QVERIFY(!found->message.empty());
  if (!where.empty()) {
    const unsigned line = where.front() == '\n' ? lineOf(text, where) + 1 : lineOf(text, where);
    const bool isThere = std::any_of(findings.begin(), findings.end(), [&](const auto& finding) {
      return finding.rule == rule && finding.line.value == line;
    });
    QVERIFY2(isThere,
             text.c_str() + listed(findings) + "expected line " + QByteArray::number(line));
  }
  // Nothing else is blamed for it.
  for (const LintFinding& finding : findings) {
    QVERIFY2(finding.rule == rule, text.c_str() + listed(findings));
  }
  const bool isWarning = rule == LintRule::RapidMotion || rule == LintRule::FeedNotFromClient ||
                         rule == LintRule::NoEnd;
  QCOMPARE(templates::firstError(findings) == nullptr, isWarning);
}

/// A program with a factor of the override: as it is made, and as it may be changed.
void TestLint::brokenFactorIsCaught() {
  struct Row {
    std::string find;
    std::string replace;
    LintRule rule;
  };
  for (const MethodKind method : {MethodKind::Window, MethodKind::Credit}) {
    TemplateParameters parameters = parametersOf(method);
    parameters.factorLeast = 0.2;
    parameters.factorMost = 1.2;
    const std::string text = generated(parameters);
    QVERIFY2(lint(text, parameters).empty(), listed(lint(text, parameters)));
    const int cell = templates::planCells(parameters)->factor;
    const std::string factor = "$R" + std::to_string(cell);
    for (const Row& row :
         {Row{"ID=6 WHENEVER $R11>120 DO $R11=120\n", "", LintRule::FeedRaised},
          Row{"DO $R11=120", "DO $R11=130", LintRule::FeedRaised},
          Row{" AND (" + factor + "<=1.2)", "", LintRule::FeedRaised},
          Row{"(" + factor + ">=0.2)", "(" + factor + ">=0.1)", LintRule::FeedRaised},
          Row{"$R10*" + factor, "$R10", LintRule::FeedRaised},
          Row{"$R10*" + factor, factor, LintRule::FeedRaised},
          Row{"(" + factor + "<=1.2)", "(" + factor + "<=1.1)", LintRule::FeedCellIgnored},
          Row{"GOTOB RIV_NEXT", "R" + std::to_string(cell) + "=1\nGOTOB RIV_NEXT",
              LintRule::ClientCellOverwritten}}) {
      std::string broken = text;
      const std::size_t at = broken.find(row.find);
      QVERIFY2(at != std::string::npos, text.c_str());
      broken.replace(at, row.find.size(), row.replace);
      const auto findings = lint(broken, parameters);
      QVERIFY2(std::any_of(findings.begin(), findings.end(),
                           [&](const LintFinding& finding) { return finding.rule == row.rule; }),
               broken.c_str() + listed(findings));
    }
  }
}

void TestLint::brokenCorrectionIsCaught_data() {
  QTest::addColumn<std::string>("find");
  QTest::addColumn<std::string>("replace");
  QTest::addColumn<LintRule>("rule");
  QTest::addColumn<std::string>("where");
  const auto row = [](const char* name, const char* find, const char* replace, LintRule rule,
                      const char* where) {
    QTest::newRow(name) << std::string(find) << std::string(replace) << rule << std::string(where);
  };
  const LintRule unbounded = LintRule::CorrectionUnbounded;
  row("no limit", "ID=12 WHENEVER ($R61>=-0.100) AND ($R61<=0.100) DO", "ID=12 DO", unbounded,
      "ID=12 DO $AA_OFF[Y]=$R61\nID=13");
  row("no lower limit", "($R60>=-0.100) AND ", "", unbounded, "ID=11");
  row("limit too high", "($R60<=0.100)", "($R60<=0.101)", unbounded, "ID=11");
  row("either limit", "($R60>=-0.100) AND", "($R60>=-0.100) OR", unbounded, "ID=11");
  row("limit of another cell", "($R60<=0.100)", "($R61<=0.100)", unbounded, "ID=11");
  row("cell of another axis", "$AA_OFF[X]=$R60", "$AA_OFF[X]=$R61", unbounded, "ID=11");
  row("doubled", "$AA_OFF[X]=$R60", "$AA_OFF[X]=2*$R60", unbounded, "ID=11");
  row("halved", "$AA_OFF[X]=$R60", "$AA_OFF[X]=0.5*$R60", unbounded, "ID=11");
  row("the other way", "$AA_OFF[X]=$R60", "$AA_OFF[X]=-$R60", unbounded, "ID=11");
  row("beside the limit", "$AA_OFF[X]=$R60", "$AA_OFF[X]=$R60+1", unbounded, "ID=11");
  row("a fixed overlay", "ID=11 DO $AA_OFF[X]=0\n", "ID=11 DO $AA_OFF[X]=0.01\n", unbounded,
      "ID=11 DO $AA_OFF[X]=0.01");
  row("no action", "ID=13 WHENEVER ($R62>=-0.100) AND ($R62<=0.100) DO $AA_OFF[Z]=$R62\n", "",
      LintRule::CorrectionIgnored, "M30");
  row("once only", "ID=13 WHENEVER", "ID=13 WHEN", unbounded, "ID=13 WHEN");
  row("the end waits for ever", "IF RIV_IDLE>500 GOTOF RIV_END\n", "", LintRule::StopCheckMissing,
      "IF (ABS($AA_OFF_VAL[X])>0.0005) OR (ABS($AA_OFF_VAL[Y])>0.0005) OR "
      "(ABS($AA_OFF_VAL[Z])>0.0005) GOTOB");
  row("cells cleared too late", "RIV_NEXT:\n", "R60=0\nRIV_NEXT:\n",
      LintRule::ClientCellOverwritten, "R60=0\nRIV_NEXT");
  row("layout number without correction", "R4=", "R4=1", LintRule::WrongLayoutNumber, "");
}

/// The correction of method window is exactly what the client writes, within the limit.
void TestLint::brokenCorrectionIsCaught() {
  QFETCH(std::string, find);
  QFETCH(std::string, replace);
  QFETCH(LintRule, rule);
  QFETCH(std::string, where);
  TemplateParameters parameters = parametersOf(MethodKind::Window);
  parameters.correctionLimitMm = 0.1;
  std::string text = generated(parameters);
  const std::size_t at = text.find(find);
  QVERIFY(at != std::string::npos);
  text.replace(at, find.size(), replace);
  const std::vector<LintFinding> findings = lint(text, parameters);
  const auto found = std::find_if(findings.begin(), findings.end(), [rule](const LintFinding& one) {
    return one.rule == rule && one.severity == LintSeverity::Error;
  });
  QVERIFY2(found != findings.end(), text.c_str() + listed(findings));
  if (!where.empty()) {
    unsigned line = lineOf(text, where);
    line += where.front() == '\n' ? 1 : 0;
    if (rule == LintRule::CorrectionIgnored) {
      line = found->line.value;  // what is missing is told at the end
    }
    QCOMPARE(found->line.value, line);
  }
}

/// The lift is interlocked by the program itself, whatever a client writes.
void TestLint::brokenLiftIsCaught() {
  struct Row {
    std::string find;
    std::string replace;
    LintRule rule;
  };
  for (const MethodKind method : {MethodKind::Window, MethodKind::Credit}) {
    TemplateParameters parameters = parametersOf(method);
    parameters.liftMm = 2.0;
    const std::string text = generated(parameters);
    QVERIFY2(lint(text, parameters).empty(), listed(lint(text, parameters)));
    const std::string cell = "$R" + std::to_string(templates::planCells(parameters)->correction[2]);
    for (const Row& row : {
             Row{" AND ($AA_OFF_VAL[Z]<=0.0005)", "", LintRule::FeedRaised},
             Row{" AND ($AA_OFF_VAL[Z]<=0.0005)", " AND ($AA_OFF_VAL[Z]<=5)", LintRule::FeedRaised},
             Row{" AND ($AA_OFF_VAL[Z]<=0.0005)", " AND ($AA_OFF_VAL[X]<=0.0005)",
                 LintRule::FeedCellIgnored},
             Row{"ID=14 WHENEVER $R10>0 DO $AA_OFF[Z]=0\n", "", LintRule::FeedCellIgnored},
             Row{"ID=14 WHENEVER $R10>0", "ID=14 WHENEVER $R10<=0", LintRule::FeedCellIgnored},
             Row{"WHENEVER ($R10<=0) AND (" + cell, "WHENEVER (" + cell,
                 LintRule::CorrectionUnbounded},
             Row{"(" + cell + ">=0)", "(" + cell + ">=-1)", LintRule::CorrectionUnbounded},
             Row{"(" + cell + "<=2.000)", "(" + cell + "<=2.001)", LintRule::CorrectionUnbounded},
             Row{"DO $AA_OFF[Z]=" + cell, "DO $AA_OFF[Z]=-" + cell, LintRule::CorrectionUnbounded},
         }) {
      std::string broken = text;
      const std::size_t at = broken.find(row.find);
      QVERIFY2(at != std::string::npos, (row.find + "\n" + text).c_str());
      broken.replace(at, row.find.size(), row.replace);
      const auto findings = lint(broken, parameters);
      QVERIFY2(std::any_of(findings.begin(), findings.end(),
                           [&](const LintFinding& finding) { return finding.rule == row.rule; }),
               (row.find + " -> " + row.replace + ": ").c_str() + listed(findings));
    }
  }
}

void TestLint::studyTemplateIsWarnedOf() {
  TemplateParameters parameters = parametersOf(MethodKind::Signal);
  parameters.signalStop = SignalStop::OncePerLoop;
  const auto findings = lint(generated(parameters), parameters);
  QCOMPARE(findings.size(), std::size_t{1});
  QVERIFY(findings.front().rule == LintRule::SignalAhead);
  QVERIFY(findings.front().severity == LintSeverity::Warning);
}

void TestLint::handWrittenLoopsAreFollowed() {
  TemplateParameters parameters = parametersOf(MethodKind::Position, 3);
  const std::string number = std::to_string(templates::makeProgram(parameters)->layoutNumber);
  // The same contract in other words: WHILE and FOR instead of labels, slots by number.
  const std::string text =
      "DEF INT NR\nR1=0 R2=0\nG90 G94 G64\nSTOPRE\nR4=" + number +
      "\nWHILE R1<1\nSTOPRE\nG4 F0.02\nIF R2>0 GOTOF ENDE\nENDWHILE\n"
      "WHILE R2<1\nFOR NR=1 TO 3\nG1 X=R[10*NR+1] Y=R[10*NR+2] Z=R[10*NR+3] F=R3\n"
      "ENDFOR\nSTOPRE\nENDWHILE\nENDE:\nM30\n";
  const auto clean = lint(text, parameters);
  QVERIFY2(templates::firstError(clean) == nullptr, listed(clean));
  std::string broken = text;
  broken.replace(broken.find("TO 3"), 4, "TO 10");
  const auto findings = lint(broken, parameters);
  QVERIFY2(std::any_of(findings.begin(), findings.end(),
                       [](const LintFinding& finding) {
                         return finding.rule == LintRule::RParameterOutOfRange &&
                                finding.line.value == 13;
                       }),
           listed(findings));
}

void TestLint::boundsOfCellsAreFollowed() {
  TemplateParameters parameters = parametersOf(MethodKind::Position, 1);
  const std::string number = std::to_string(templates::makeProgram(parameters)->layoutNumber);
  const std::string head =
      "G90 G94\nSTOPRE\nR4=" + number + "\nWAIT:\nSTOPRE\nIF R2>0 GOTOF ENDE\nIF R1<1 GOTOB WAIT\n";
  const std::string tail = "G1 X=R11 Y=R12 Z=R13 F=R3\nGOTOB WAIT\nENDE:\nM30\n";
  QVERIFY2(lint(head + tail, parameters).empty(), listed(lint(head + tail, parameters)));
  const auto unbounded = lint(head + "R20=R[R21]\n" + tail, parameters);
  QCOMPARE(unbounded.size(), std::size_t{1});
  QVERIFY(unbounded.front().rule == LintRule::RParameterUnbounded);
  QCOMPARE(unbounded.front().line.value, 8U);
  const auto written = lint(head + "R[R21]=1\n" + tail, parameters);
  QCOMPARE(written.size(), std::size_t{1});
  QVERIFY(written.front().rule == LintRule::RParameterUnbounded);
}

void TestLint::rulesHaveNames() {
  std::set<std::string_view> names;
  for (int rule = 1; rule <= static_cast<int>(LintRule::ClientNotWatched); ++rule) {
    names.insert(templates::lintRuleName(static_cast<LintRule>(rule)));
  }
  QCOMPARE(names.size(), static_cast<std::size_t>(LintRule::ClientNotWatched));
  QVERIFY(!names.contains(""));
}

void TestLint::onlyTheGeneratedProgramForLinuxCnc() {
  templates::TemplateParameters parameters;
  parameters.target = templates::TargetControl::LinuxCnc;
  const auto program = templates::makeProgram(parameters);
  QVERIFY(program);
  const QString text = QString::fromStdString(program->text);
  const auto linesAt = [&](const QString& changed) {
    std::vector<unsigned> lines;
    for (const templates::LintFinding& finding :
         templates::lintProgram(changed.toStdString(), *program)) {
      lines.push_back(finding.line.value);
    }
    return lines;
  };
  QVERIFY(linesAt(text).empty());
  QVERIFY(linesAt(QStringLiteral("; another comment\n") + text).empty());
  const auto lineOf = [&](const char* block) {
    return static_cast<unsigned>(
        text.left(text.indexOf(QLatin1String(block))).count(QLatin1Char('\n')) + 1);
  };
  QString changed = text;
  changed.replace(QLatin1String("G64 P0.01"), QLatin1String("G64 P0.02"));
  QCOMPARE(linesAt(changed), std::vector<unsigned>{lineOf("G64 P0.01")});
  changed = text;
  changed.replace(QLatin1String("M66 E0 L0\no111"), QLatin1String("o111"));
  QCOMPARE(linesAt(changed), std::vector<unsigned>{lineOf("M66 E0 L0\no111")});
  QCOMPARE(linesAt(text.left(text.size() / 2)).size(), std::size_t{1});
  QVERIFY(templates::requireSound(*program));
}

RIVULET_TEST(TestLint)
#include "tst_lint.moc"
