// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// One scenario through the simulated link and through OPC UA on loopback: the same writes in the
/// same order, the same points executed; only the times differ.

#include <QtTest>
#include <cmath>

#include "base/units.h"
#include "opcua/forwarding_link.h"
#include "streaming/control/access_probe.h"
#include "streaming/run/job.h"
#include "streaming/simulation/scenario.h"
#include "streaming/simulation/simulated_link.h"
#include "support/chosen_link.h"
#include "support/loopback_machine.h"
#include "support/silent_run.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace std::chrono_literals;
using base::MethodKind;
using streaming::RunReport;

namespace {

/// Notes what is written, and passes everything on.
class NotingLink final : public opcua::ForwardingLink {
 public:
  using ForwardingLink::ForwardingLink;

  base::RequestId write(std::span<const opcua::Assignment> assignments, base::Duration deadline,
                        opcua::Grouping grouping) override {
    for (const opcua::Assignment& assignment : assignments) {
      writes.emplace_back(assignment.variable.index, assignment.value);
    }
    writes.emplace_back(-1, 0.0);  // end of the request
    return m_link.write(assignments, deadline, grouping);
  }

  std::vector<std::pair<int, double>> writes;
};

struct Seen {
  std::vector<std::pair<int, double>> writes;
  std::vector<base::Vec3> executed;
  RunReport report;
};

Seen run(opcua::Link& link, opcua::Control& control, const gcode::Program& program,
         const streaming::RunSettings& settings) {
  NotingLink noting(link);
  tests::SilentRun silent;
  Seen seen;
  seen.report = streaming::runJob(noting, control, program, settings, silent, silent);
  seen.writes = std::move(noting.writes);
  if (seen.report.controlTrace) {
    for (const trace::ExecutedBlock& block : seen.report.controlTrace->blocks) {
      seen.executed.push_back(block.targetMm);
    }
  }
  return seen;
}

}  // namespace

class TestEquivalence : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { RIVULET_SKIP_WITHOUT_LINK(); }

  /// Whatever a control offers, the same forms are found over OPC UA and in virtual time.
  void bothLinksFindTheSameForms() {
    using machine::ArrayAccess;
    using machine::ArrayCharge;
    using machine::ArrayWrite;
    for (const ArrayAccess& arrays :
         {ArrayAccess{true, true, ArrayWrite::All, ArrayCharge::Node},
          ArrayAccess{false, true, ArrayWrite::All, ArrayCharge::Element},
          ArrayAccess{true, true, ArrayWrite::Refused, ArrayCharge::Node},
          ArrayAccess{true, true, ArrayWrite::FirstOnly, ArrayCharge::Node},
          ArrayAccess{false, false, ArrayWrite::All, ArrayCharge::Node}}) {
      machine::MachineConfig config = *machine::loadPreset("ideal");
      config.access.arrays = arrays;
      machine::Machine simulated(config, 1);
      streaming::SimulatedLink simulatedLink(simulated);
      tests::LoopbackMachine::Options options;
      options.arrays = arrays;
      tests::LoopbackMachine cell(options);
      const auto link = tests::connectChosen(cell);
      const auto expected = streaming::probeAccess(simulatedLink, {10, 40}, 20s);
      const auto found = streaming::probeAccess(*link, {10, 40}, 20s);
      QVERIFY2(expected.has_value(), expected ? "" : expected.error().text().c_str());
      QVERIFY2(found.has_value(), found ? "" : found.error().text().c_str());
      QCOMPARE(found->proofs.size(), expected->proofs.size());
      for (std::size_t i = 0; i < found->proofs.size(); ++i) {
        QVERIFY(found->proofs[i].form == expected->proofs[i].form);
        QCOMPARE(found->proofs[i].writes, expected->proofs[i].writes);
        QCOMPARE(found->proofs[i].reads, expected->proofs[i].reads);
        QCOMPARE(found->proofs[i].why, expected->proofs[i].why);
      }
    }
  }

  void bothLinksDoTheSame_data() {
    QTest::addColumn<int>("method");
    QTest::addColumn<QString>("preset");
    const QString preset = QStringLiteral("dmu75");
    QTest::newRow("window") << static_cast<int>(MethodKind::Window) << preset;
    QTest::newRow("window, arrays")
        << static_cast<int>(MethodKind::Window) << QStringLiteral("dmu75-arrays");
    QTest::newRow("signal") << static_cast<int>(MethodKind::Signal) << preset;
    QTest::newRow("position") << static_cast<int>(MethodKind::Position) << preset;
  }
  void bothLinksDoTheSame() {
    QFETCH(int, method);
    QFETCH(QString, preset);
    const std::string name = preset.toStdString();
    // Far inside the region: what is written does not depend on chance.
    std::vector<base::Vec3> points;
    for (int i = 0; i < 32; ++i) {
      points.push_back({2.5 * i, 3.0 * std::sin(0.3 * i), 40.0});
    }
    const auto program = streaming::programOf(points);
    streaming::RunSettings settings;
    settings.parameters.method = static_cast<MethodKind>(method);
    settings.deltaMm = 1.0;
    settings.feedMmPerS = base::mmPerSFromMmPerMin(1500.0);
    settings.monitor = true;
    settings.runNumber = 4711;
    if (name == "dmu75-arrays") {
      settings.access = streaming::AccessChoice::Array;
    }

    machine::Machine simulated(*machine::loadPreset(name), 1);
    streaming::SimulatedLink simulatedLink(simulated);
    const Seen virtualRun = run(simulatedLink, simulatedLink, *program, settings);

    tests::LoopbackMachine cell({name, 1, 0});
    const auto link = tests::connectChosen(cell);
    const Seen realRun = run(*link, *link, *program, settings);

    for (const Seen* seen : {&virtualRun, &realRun}) {
      QVERIFY2(seen->report.outcome == streaming::Outcome::Completed,
               seen->report.error.text().c_str());
      QVERIFY(seen->report.isFaultless());
      QCOMPARE(seen->report.integrity.executed, points.size());
    }
    QVERIFY(!virtualRun.writes.empty());
    // How often the heart beats is a matter of time, what is streamed is not.
    const templates::CellMap cells = templates::makeProgram(settings.parameters)->cells;
    const auto streamed = [&](const Seen& seen) {
      std::vector<std::pair<int, double>> writes;
      for (std::size_t i = 0; i < seen.writes.size(); ++i) {
        if (cells.windows > 0 && seen.writes[i].first == cells.heartbeat) {
          ++i;  // with the end of its request
        } else {
          writes.push_back(seen.writes[i]);
        }
      }
      return writes;
    };
    QVERIFY(streamed(virtualRun) == streamed(realRun));
    QVERIFY(virtualRun.executed == realRun.executed);
    QCOMPARE(virtualRun.report.pauses.size(), realRun.report.pauses.size());
  }
};

RIVULET_TEST(TestEquivalence)
#include "tst_equivalence.moc"
