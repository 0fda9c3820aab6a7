// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Stops by the feed cell over OPC UA, of a `rivulet-machine` in real time. RIVULET_STOPS=1000
/// draws as many in all. The judge has the machine's own trace; the client's times are printed.

#include <fmt/format.h>

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/units.h"
#include "machine/braking.h"
#include "opcua/open62541/ua_link.h"
#include "support/machine_process.h"
#include "support/patience.h"
#include "support/stop_bench.h"
#include "support/test_program.h"
#include "templates/flexible_program.h"
#include "trace/analysis/pauses.h"

using namespace rivulet;
using base::Duration;
using tests::Operator;

class TestStops : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyStopStands_data() {
    QTest::addColumn<double>("feedMmPerMin");
    QTest::newRow("60 mm moves at F 400") << 400.0;
    QTest::newRow("300 mm moves at F 4000") << 4000.0;
  }

  void everyStopStands() {
    QFETCH(double, feedMmPerMin);
    const tests::MachineProcess process(QStringLiteral(RIVULET_MACHINE_PROGRAM));
    opcua::ConnectOptions options;
    options.security = opcua::unencrypted();
    options.endpoint = process.endpoint().toStdString();
    options.connectDeadline = std::chrono::milliseconds(tests::kRunMs);
    const auto link = opcua::UaLink::connect(options);
    QVERIFY2(link.has_value(), link ? "" : link.error().text().c_str());
    const machine::MachineConfig config = *machine::loadPreset(machine::kDefaultPreset);

    Operator person(3);
    person.holdsMax = std::max<std::size_t>(5, tests::stopsWanted() / 2);
    person.meanS = 0.3;
    // The run is stopped after the last hold.
    person.stopWhen = [&person](base::Instant) {
      return person.holds.size() == person.holdsMax &&
             person.holds.back().released != base::Instant{};
    };
    streaming::RunSettings settings;
    settings.parameters.pointsPerLoop = 1;
    settings.feedMmPerS = base::mmPerSFromMmPerMin(feedMmPerMin);
    const auto flexible = templates::makeProgram(settings.parameters);
    QVERIFY(flexible.has_value());
    const auto program = tests::lines(200, feedMmPerMin > 1000.0 ? 300.0 : 60.0);
    const streaming::RunReport report =
        streaming::runJob(**link, **link, *program, *flexible, settings, person, person);
    QVERIFY2(report.outcome == streaming::Outcome::Stopped, report.error.text().c_str());
    QVERIFY(report.finding() == streaming::RunFinding::Faultless);
    QVERIFY(!person.wasIgnored);

    std::vector<double> seenS;
    for (const streaming::FeedEvent& event : report.feed) {
      if (event.isHold() && event.stoodAfter) {
        seenS.push_back(base::toSeconds(*event.stoodAfter));
      }
    }
    QCOMPARE(seenS.size(), person.holds.size());
    // By the machine's trace: where the feed is left, the axes brake and stand.
    QVERIFY(report.controlTrace != nullptr);
    const auto& samples = report.controlTrace->samples;
    std::vector<double> brakesS;
    double offMm = 0.0;  // behind the first move, the path is on X
    for (const trace::Pause& hold : report.holds) {
      const auto stands = std::find_if(samples.begin(), samples.end(), [&hold](const auto& sample) {
        return sample.at > hold.start && sample.feedMmPerS == 0.0;
      });
      if (stands == samples.end()) {
        continue;
      }
      // Between two windows the path stands as well: then it was not at its feed.
      auto from = stands;
      while (from != samples.begin() && std::prev(from)->feedMmPerS > 0.0 &&
             from->feedMmPerS < 0.999 * settings.feedMmPerS) {
        --from;
      }
      if (from->feedMmPerS < 0.999 * settings.feedMmPerS) {
        continue;
      }
      const Duration brakes = stands->at - from->at;
      brakesS.push_back(base::toSeconds(brakes));
      const Duration most =
          machine::brakingTime(config, settings.feedMmPerS) + 2 * config.interpolationCycle;
      // A hold may meet a path that is about to stop: then both are seen as one.
      QVERIFY2(brakes <= 3 * most, fmt::format("{:.1f} ms", base::toMilliseconds(brakes)).c_str());
      // The axes may still settle from the first move.
      const double beforeMm = std::hypot(from->actualMm.y, from->actualMm.z);
      for (auto held = stands; held != samples.end() && held->at <= hold.start + hold.duration;
           ++held) {
        QVERIFY(base::distance(held->commandMm, stands->commandMm) < 1e-6);
        const bool isOnX = std::hypot(held->commandMm.y, held->commandMm.z) < 1e-6;
        const double heldMm = std::hypot(held->actualMm.y, held->actualMm.z);
        offMm = isOnX ? std::max(offMm, heldMm - beforeMm) : offMm;
      }
    }
    QVERIFY(brakesS.size() + 2 >= person.holds.size() / 2);
    constexpr double kOffMmMax = 0.001;
    QVERIFY2(offMm <= kOffMmMax, std::to_string(offMm).c_str());
    qInfo(
        "%s: %zu stops; the client saw them stand after %.0f ms (worst %.0f); braking %.0f (%.0f); "
        "at most %.3f um off the path while held",
        QTest::currentDataTag(), seenS.size(), 1e3 * tests::median(seenS),
        1e3 * tests::worst(seenS), 1e3 * tests::median(brakesS), 1e3 * tests::worst(brakesS),
        1e3 * offMm);
  }
};

RIVULET_TEST(TestStops)
#include "tst_stops.moc"
