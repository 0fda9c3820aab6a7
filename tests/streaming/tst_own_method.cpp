// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// A method of one's own is one file and one registration: its program on the control, its client,
/// what is known of it. Lint, proof, job and driver take it as any other.

#include <QtTest>

#include "streaming/methods/loop.h"
#include "streaming/simulation/scenario.h"
#include "streaming/simulation/template_proof.h"
#include "support/test_program.h"
#include "templates/methods/loop.h"

using namespace rivulet;
using templates::CellMap;
using templates::LoopProtocol;

namespace {

/// The client hands over one point at a time, and says its number in this cell; the control counts
/// those it has passed in the signal cell, from `kRefilled` on.
constexpr int kHandedOver = 10;

class StepTemplate final : public templates::LoopTemplate {
 public:
  CellMap cells(const templates::TemplateParameters& parameters) const override {
    CellMap cells = LoopTemplate::cells(parameters);
    cells.cleared.push_back(kHandedOver);
    return cells;
  }
  int longestWrite(const templates::TemplateParameters&) const override { return 4; }

 private:
  void writeNotes(templates::Listing&, const templates::LoopSettings&) const override {}
  void writeSignalCell(templates::Listing& out, const CellMap& cells) const override {
    out.line("; R{}  points passed, R{}  point handed over", cells.signal, kHandedOver);
  }
  void writeLoop(templates::Listing& out, const templates::LoopSettings&,
                 const CellMap& cells) const override {
    out.line("STOPRE");
    out.line("IF R{}>0 GOTOF RIV_END", cells.stop);
    out.line("IF R{}>=R{} GOTOF RIV_STEP", kHandedOver, cells.signal);
    out.line("G4 F0.02");
    out.line("GOTOB RIV_LOOP");
    out.line("RIV_STEP:");
    out.line("G1 {} F=R{}", slotText(cells, 0).words, cells.feed);
    out.line("STOPRE");
    out.line("R{}=R{}+1", cells.signal, cells.signal);
  }
};

class StepMethod final : public streaming::LoopMethod {
 public:
  explicit StepMethod(streaming::MethodSetup setup)
      : LoopMethod(std::move(setup), {opcua::rParameter(setup.cells.signal)}) {}

 private:
  void begun(base::Instant, base::Instant) override { m_refillDue = true; }
  void observe(const streaming::Answer& answer, base::Instant now) override {
    const double passed = answer.readings[0].number - LoopProtocol::kRefilled;
    if (passed == static_cast<double>(m_progress.executed + 1)) {
      ++m_progress.executed;
      m_progress.lastProgress = now;
      // From then on the driver may ask whether the program still runs.
      m_progress.expected.set(streaming::Expectation::Progress,
                              now + streaming::kLoopSlowerThanPlanned);
      m_refillDue = m_progress.executed < m_plan.pointCount();
    }
  }
  std::size_t addRefill() override {
    m_plan.addPoint(m_progress.executed);
    m_plan.addCell(kHandedOver, static_cast<double>(LoopProtocol::kRefilled + m_progress.executed));
    return m_progress.executed > 0 ? 1 : 0;  // the first was counted when the slots were filled
  }
  bool isInLastLoop() const override { return m_progress.executed == m_plan.pointCount(); }
  bool hasSentAll() const override { return m_progress.executed + 1 >= m_plan.pointCount(); }
};

class StepType final : public streaming::LoopMethodType {
  std::unique_ptr<streaming::Method> make(streaming::MethodSetup setup) const override {
    return std::make_unique<StepMethod>(std::move(setup));
  }
  std::size_t pauseWithinLoop(std::size_t) const override { return 0; }
};

base::MethodKind stepMethod() {
  static const StepTemplate program;
  static const StepType type;
  static const base::MethodKind kind =
      streaming::registerMethod({.name = "step", .portion = base::Portion::Point}, program, type);
  return kind;
}

streaming::RunSettings settings() {
  streaming::RunSettings settings;
  settings.parameters.method = stepMethod();
  settings.parameters.pointsPerLoop = 1;
  settings.feedMmPerS = 20.0;
  return settings;
}

}  // namespace

class TestOwnMethod : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void isKnownByItsName() {
    QVERIFY(base::methodFromName("step") == stepMethod());
    QCOMPARE(templates::makeProgram(settings().parameters)->name, "RIVULET_STEP_1.MPF");
  }

  void streamsEachPointOnce() {
    streaming::Scenario scenario;
    scenario.machine = *machine::loadPreset("dmu75");
    scenario.settings = settings();
    base::Random random(1);
    scenario.program = streaming::programOf(streaming::drawContour({40, 0.3, 0.3}, random));
    const streaming::RunReport report = streaming::simulate(scenario);
    QVERIFY2(report.isFaultless(), report.error.text().c_str());
    QCOMPARE(report.integrity.executed, std::size_t{40});
  }

  /// Also where the client is late, which no method of [P1] stands.
  void passesTheProof() {
    const auto program = templates::makeProgram(settings().parameters);
    const auto proof =
        streaming::proveTemplate(program->text, *program, *machine::loadPreset("dmu75"));
    QVERIFY(proof.has_value());
    QVERIFY2(proof->findings.empty(),
             proof->findings.empty() ? "" : proof->findings.front().message.c_str());
    for (const streaming::ProofCase& one : proof->cases) {
      QVERIFY2(one.holds(), (one.name + ": " + one.message).c_str());
    }
  }
};

RIVULET_TEST(TestOwnMethod)
#include "tst_own_method.moc"
