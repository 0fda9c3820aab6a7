// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The proof of flexible programs: what is generated holds, and what the lint cannot see in a
/// program that was broken on purpose shows in the motion.

#include <QtTest>
#include <algorithm>

#include "machine/config.h"
#include "streaming/simulation/template_proof.h"
#include "support/test_program.h"
#include "templates/flexible_program.h"

using namespace rivulet;
using base::MethodKind;
using streaming::ProofCase;
using streaming::TemplateProof;
using templates::TemplateParameters;

Q_DECLARE_METATYPE(rivulet::templates::TemplateParameters)

namespace {

TemplateParameters parametersOf(MethodKind method, int points) {
  TemplateParameters parameters;
  parameters.method = method;
  parameters.pointsPerLoop = points;
  return parameters;
}

TemplateProof prove(const std::string& text, const TemplateParameters& parameters) {
  const auto proof = streaming::proveTemplate(text, *templates::makeProgram(parameters),
                                              *machine::loadPreset("dmu75"));
  return proof ? *proof : TemplateProof{};
}

QByteArray listed(const TemplateProof& proof) {
  QByteArray text;
  for (const auto& finding : proof.findings) {
    text += QByteArray::fromStdString(finding.message) + "\n";
  }
  for (const ProofCase& one : proof.cases) {
    text += QByteArray::fromStdString(one.name) + " " + QByteArray::number(one.failures) + "/" +
            QByteArray::number(one.runs) + " " + QByteArray::fromStdString(one.message) + "\n";
  }
  return text;
}

}  // namespace

class TestTemplateProof : public QObject {
  Q_OBJECT

 private slots:
  void generatedTemplateHolds_data();
  void generatedTemplateHolds();
  void brokenProgramShows_data();
  void brokenProgramShows();
  void brokenCorrectionShows();
  void programWithErrorsIsNotRun();
};

void TestTemplateProof::generatedTemplateHolds_data() {
  QTest::addColumn<TemplateParameters>("parameters");
  for (const int points : {2, 7}) {
    QTest::addRow("position %d", points) << parametersOf(MethodKind::Position, points);
    QTest::addRow("signal %d", points) << parametersOf(MethodKind::Signal, points);
    QTest::addRow("window %d", points) << parametersOf(MethodKind::Window, points);
    QTest::addRow("credit %d", points) << parametersOf(MethodKind::Credit, points);
    QTest::addRow("file %d", points) << parametersOf(MethodKind::File, points);
  }
  TemplateParameters xz = parametersOf(MethodKind::Window, 3);
  xz.axes = {true, false, true};
  xz.windows = 3;
  xz.baseCell = 40;
  xz.slotStride = 5;
  xz.rParameterCount = 200;
  QTest::newRow("window, X and Z, elsewhere") << xz;
  TemplateParameters single = parametersOf(MethodKind::Window, 1);
  single.windows = 1;
  QTest::newRow("window, one of one point") << single;
  TemplateParameters large = parametersOf(MethodKind::Window, 40);
  large.windows = 8;
  large.rParameterCount = 1100;
  QTest::newRow("window, eight of 40 points") << large;
  TemplateParameters corrected = parametersOf(MethodKind::Window, 7);
  corrected.correctionLimitMm = 0.1;
  QTest::newRow("window, corrected") << corrected;
  corrected.method = MethodKind::Credit;
  corrected.axes = {true, false, true};
  QTest::newRow("credit, X and Z corrected") << corrected;
  TemplateParameters packed = parametersOf(MethodKind::Position, 1);
  packed.layout = templates::Layout::Contiguous;
  packed.axes = {false, true, false};
  QTest::newRow("position, one point in Y") << packed;
}

void TestTemplateProof::generatedTemplateHolds() {
  QFETCH(TemplateParameters, parameters);
  const TemplateProof proof = prove(templates::makeProgram(parameters)->text, parameters);
  QVERIFY2(proof.holds(), listed(proof));
  QVERIFY(proof.findings.empty());
  for (const ProofCase& one : proof.cases) {
    // The methods of [P1] are wrong where the client is late: the proof has to see that. Only a
    // loop of one point repeats it without a motion.
    const bool isLate = one.name == "late-client" && !base::hasWindows(parameters.method);
    QVERIFY2(one.holds() != (isLate && parameters.pointsPerLoop > 1), listed(proof));
    QCOMPARE(one.isRequired, !isLate);
  }
  const std::size_t corrections = parameters.correctionLimitMm > 0.0 ? 1 : 0;
  QCOMPARE(proof.cases.size(), base::hasWindows(parameters.method) ? 6U + corrections : 3U);
}

void TestTemplateProof::brokenProgramShows_data() {
  QTest::addColumn<int>("method");
  QTest::addColumn<std::string>("find");
  QTest::addColumn<std::string>("replace");
  QTest::addColumn<std::string>("failing");
  const auto row = [](const char* name, MethodKind method, const char* find, const char* replace,
                      const char* failing) {
    QTest::newRow(name) << static_cast<int>(method) << std::string(find) << std::string(replace)
                        << std::string(failing);
  };
  row("position: axes exchanged", MethodKind::Position, "X=R31 Y=R32", "X=R32 Y=R31", "on-time");
  row("position: slots exchanged", MethodKind::Position,
      "G1 X=R11 Y=R12 Z=R13 F=R3\nG1 X=R21 Y=R22 Z=R23 F=R3",
      "G1 X=R21 Y=R22 Z=R23 F=R3\nG1 X=R11 Y=R12 Z=R13 F=R3", "on-time");
  row("signal: signals exchanged", MethodKind::Signal, "\nR0=0", "\nR0=1", "on-time");
  row("window: no check of the window", MethodKind::Window, "IF ABS(RIV_S)>0.000001",
      "IF ABS(RIV_S)>100000000", "damaged-window");
  row("window: the copy is reported too early", MethodKind::Window, "R2=RIV_L R3=RIV_L",
      "R2=RIV_L+1 R3=RIV_L", "late-client");
  // A client that is gone in the middle leaves axes that stand, not a program that waits.
  row("window: never gives the client up", MethodKind::Window, "IF RIV_IDLE>1000",
      "IF RIV_IDLE>100000000", "bad-network");
}

void TestTemplateProof::brokenProgramShows() {
  QFETCH(int, method);
  QFETCH(std::string, find);
  QFETCH(std::string, replace);
  QFETCH(std::string, failing);
  const TemplateParameters parameters = parametersOf(static_cast<MethodKind>(method), 7);
  std::string text = templates::makeProgram(parameters)->text;
  const std::size_t at = text.find(find);
  QVERIFY(at != std::string::npos);
  text.replace(at, find.size(), replace);
  const TemplateProof proof = prove(text, parameters);
  QVERIFY2(templates::firstError(proof.findings) == nullptr, listed(proof));
  QVERIFY2(!proof.holds(), listed(proof));
  const auto found = std::find_if(proof.cases.begin(), proof.cases.end(),
                                  [&](const ProofCase& one) { return one.name == failing; });
  QVERIFY(found != proof.cases.end());
  QVERIFY2(!found->holds(), listed(proof));
  QVERIFY(!found->message.empty());
}

/// What the lint does not see: the overlay is not waited for, or stays.
void TestTemplateProof::brokenCorrectionShows() {
  TemplateParameters parameters = parametersOf(MethodKind::Window, 7);
  parameters.correctionLimitMm = 1.0;
  std::string text = templates::makeProgram(parameters)->text;
  const std::size_t at = text.find("ID=11 DO $AA_OFF[X]=0\n");
  QVERIFY(at != std::string::npos);
  text.erase(at, std::string("ID=11 DO $AA_OFF[X]=0\n").size());
  const TemplateProof proof = prove(text, parameters);
  QVERIFY2(templates::firstError(proof.findings) == nullptr, listed(proof));
  QVERIFY2(!proof.holds(), listed(proof));
}

void TestTemplateProof::programWithErrorsIsNotRun() {
  const TemplateParameters parameters = parametersOf(MethodKind::Position, 7);
  std::string text = templates::makeProgram(parameters)->text;
  const std::size_t at = text.rfind("STOPRE\n");
  text.erase(at, 7);
  const TemplateProof proof = prove(text, parameters);
  QVERIFY(!proof.holds());
  QVERIFY(proof.cases.empty());
  templates::FlexibleProgram program = *templates::makeProgram(parameters);
  QVERIFY(templates::requireSound(program));
  program.text = text;
  QVERIFY(!templates::requireSound(program));
}

RIVULET_TEST(TestTemplateProof)
#include "tst_template_proof.moc"
