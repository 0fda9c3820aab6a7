// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Which forms of access are found, on controls that offer them, refuse them, or claim to have done
/// what they have not.

#include <QtTest>

#include "machine/machine.h"
#include "opcua/forwarding_link.h"
#include "streaming/control/access_probe.h"
#include "streaming/run/run.h"
#include "streaming/simulation/simulated_link.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace std::chrono_literals;
using machine::ArrayAccess;
using machine::ArrayCharge;
using machine::ArrayWrite;
using opcua::Grouping;
using opcua::LinkError;
using streaming::AccessForms;

namespace {

constexpr streaming::ScratchCells kCells{20, 49};

/// A control that gets arrays wrong in its own way.
class WrongLink final : public opcua::ForwardingLink {
 public:
  enum class Way { OneFurther, OneTooMany, LosesConnection, DoesNotAnswer };
  WrongLink(opcua::Link& link, Way way) : ForwardingLink(link), m_way(way) {}

  base::RequestId read(std::span<const opcua::Variable> variables, base::Duration deadline,
                       Grouping grouping) override {
    if (opcua::isArray(grouping) && m_way == Way::DoesNotAnswer) {
      return neverAnswered(deadline);
    }
    return m_link.read(variables, deadline, grouping);
  }
  base::RequestId write(std::span<const opcua::Assignment> assignments, base::Duration deadline,
                        Grouping grouping) override {
    std::vector<opcua::Assignment> items(assignments.begin(), assignments.end());
    if (opcua::isArray(grouping) && m_way == Way::DoesNotAnswer) {
      return neverAnswered(deadline);
    }
    if (opcua::isArray(grouping)) {
      if (m_way == Way::OneFurther) {
        for (opcua::Assignment& item : items) {
          ++item.variable.index;
        }
      } else if (m_way == Way::OneTooMany) {
        items.push_back({opcua::rParameter(items.back().variable.index + 1), 0.25});
      } else {
        m_lost = true;
      }
    }
    return m_link.write(items, deadline, grouping);
  }
  std::optional<opcua::Event> wait(base::Instant until) override {
    if (m_lost) {
      opcua::Event event;
      event.kind = opcua::EventKind::ConnectionLost;
      event.error = base::makeError(LinkError::ConnectionLost, "gone");
      return event;
    }
    std::optional<opcua::Event> event = m_link.wait(until);
    if (event && m_unanswered && event->request == *m_unanswered) {
      event->kind = opcua::EventKind::RequestFailed;
      event->error = base::makeError(LinkError::DeadlineExceeded, "no answer");
    }
    return event;
  }

 private:
  base::RequestId neverAnswered(base::Duration deadline) {
    const std::vector<opcua::Variable> any{opcua::rParameter(0)};
    m_unanswered = m_link.read(any, deadline, Grouping::List);
    return *m_unanswered;
  }

  Way m_way;
  std::optional<base::RequestId> m_unanswered;
  bool m_lost = false;
};

struct Bench {
  explicit Bench(const ArrayAccess& arrays, const std::string& preset = "ideal")
      : machine(configured(arrays, preset), 1), link(machine) {
    for (int cell = 0; cell < 100; ++cell) {
      machine.writeRParameter(cell, 0.125 * cell);
    }
  }
  static machine::MachineConfig configured(const ArrayAccess& arrays, const std::string& preset) {
    machine::MachineConfig config = *machine::loadPreset(preset);
    config.access.arrays = arrays;
    return config;
  }
  /// Every cell has the value it had.
  bool isUntouched() {
    machine.advance(machine.now() + 1s);
    for (int cell = 0; cell < 100; ++cell) {
      if (machine.ncRParameter(cell) != 0.125 * cell) {
        return false;
      }
    }
    return true;
  }

  machine::Machine machine;
  streaming::SimulatedLink link;
};

const streaming::FormProof& proofOf(const AccessForms& forms, Grouping form) {
  for (const streaming::FormProof& proof : forms.proofs) {
    if (proof.form == form) {
      return proof;
    }
  }
  qFatal("a form is missing");
}

}  // namespace

class TestAccessProbe : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void findsWhatTheControlOffers() {
    for (const ArrayCharge charge : {ArrayCharge::Node, ArrayCharge::Element}) {
      for (int offered = 0; offered < 4; ++offered) {
        const bool count = (offered & 1) != 0;
        const bool range = (offered & 2) != 0;
        Bench bench({count, range, ArrayWrite::All, charge}, "dmu75");
        const auto forms = streaming::probeAccess(bench.link, kCells, 2s);
        QVERIFY2(forms.has_value(), forms ? "" : forms.error().text().c_str());
        QCOMPARE(proofOf(*forms, Grouping::ArrayCount).works(), count);
        QCOMPARE(proofOf(*forms, Grouping::ArrayRange).works(), range);
        QVERIFY(proofOf(*forms, Grouping::List).works());
        QVERIFY(proofOf(*forms, Grouping::Single).works());
        QVERIFY(forms->best() == (count   ? Grouping::ArrayCount
                                  : range ? Grouping::ArrayRange
                                          : Grouping::List));
        QCOMPARE(forms->array().has_value(), count || range);
        QVERIFY(bench.isUntouched());
      }
    }
  }

  /// Arrays that can only be read are no use for a stream.
  void believesNoClaim_data() {
    QTest::addColumn<int>("write");
    QTest::newRow("refused") << static_cast<int>(ArrayWrite::Refused);
    QTest::newRow("first only") << static_cast<int>(ArrayWrite::FirstOnly);
  }
  void believesNoClaim() {
    QFETCH(int, write);
    Bench bench({true, true, static_cast<ArrayWrite>(write), ArrayCharge::Node});
    const auto forms = streaming::probeAccess(bench.link, kCells, 2s);
    QVERIFY2(forms.has_value(), forms ? "" : forms.error().text().c_str());
    for (const Grouping form : {Grouping::ArrayCount, Grouping::ArrayRange}) {
      QVERIFY(!proofOf(*forms, form).writes);
      QVERIFY(proofOf(*forms, form).reads);
      QVERIFY(!proofOf(*forms, form).why.empty());
    }
    QVERIFY(forms->best() == Grouping::List);
    QVERIFY(!forms->array());
    QVERIFY(bench.isUntouched());
  }

  void noticesWhatGoesElsewhere() {
    for (const WrongLink::Way way : {WrongLink::Way::OneFurther, WrongLink::Way::OneTooMany}) {
      Bench bench({true, true, ArrayWrite::All, ArrayCharge::Node});
      WrongLink wrong(bench.link, way);
      const auto forms = streaming::probeAccess(wrong, kCells, 2s);
      QVERIFY2(forms.has_value(), forms ? "" : forms.error().text().c_str());
      QVERIFY(!proofOf(*forms, Grouping::ArrayCount).writes);
      QVERIFY(!proofOf(*forms, Grouping::ArrayRange).writes);
      QVERIFY(forms->best() == Grouping::List);
      QVERIFY(bench.isUntouched());
    }
  }

  void fallsBackToListsWhereArraysAreNotAnswered() {
    Bench bench({true, true, ArrayWrite::All, ArrayCharge::Node});
    WrongLink wrong(bench.link, WrongLink::Way::DoesNotAnswer);
    const auto forms = streaming::probeAccess(wrong, kCells, 2s);
    QVERIFY2(forms.has_value(), forms ? "" : forms.error().text().c_str());
    QVERIFY(forms->best() == Grouping::List);
    QVERIFY(bench.isUntouched());
  }

  /// Single access costs a round trip per cell.
  void longRoundTripsAreNoReasonToFail() {
    machine::MachineConfig config = *machine::loadPreset("ideal");
    config.access.arrays = {true, true, ArrayWrite::All, ArrayCharge::Node};
    config.access.readOverhead = config.access.writeOverhead = 1s;
    machine::Machine machine(config, 1);
    streaming::SimulatedLink link(machine);
    const auto forms = streaming::probeAccess(link, kCells, 2s);
    QVERIFY2(forms.has_value(), forms ? "" : forms.error().text().c_str());
    QVERIFY(forms->best() == Grouping::ArrayCount);
    QVERIFY(machine.now().time_since_epoch() < 120s);
  }

  void saysWhenTheCellsAreNotAsTheyWere() {
    Bench bench({true, true, ArrayWrite::All, ArrayCharge::Node});
    WrongLink wrong(bench.link, WrongLink::Way::LosesConnection);
    const auto forms = streaming::probeAccess(wrong, kCells, 2s);
    QVERIFY(!forms && forms.error().code == LinkError::ConnectionLost);
    QVERIFY(forms.error().message.find("test values") != std::string::npos);
  }

  void refusesWhatWouldDoHarm() {
    Bench bench({true, true, ArrayWrite::All, ArrayCharge::Node});
    QVERIFY(streaming::probeAccess(bench.link, {20, 22}, 2s).error().code ==
            LinkError::VariableMissing);
    QVERIFY(streaming::probeAccess(bench.link, {-1, 22}, 2s).error().code ==
            LinkError::VariableMissing);
    QVERIFY(streaming::probeAccess(bench.link, {90, 100}, 2s).error().code ==
            LinkError::VariableMissing);
    QVERIFY(bench.isUntouched());
    QVERIFY(bench.machine.storeProgram("A.MPF", "G4 F1000\nM30\n", true));
    QVERIFY(bench.machine.selectProgram("A.MPF"));
    QVERIFY(bench.machine.cycleStart());
    QVERIFY(streaming::probeAccess(bench.link, kCells, 2s).error().code ==
            streaming::StreamError::ChannelBusy);
    QVERIFY(bench.isUntouched());
  }
};

RIVULET_TEST(TestAccessProbe)
#include "tst_access_probe.moc"
