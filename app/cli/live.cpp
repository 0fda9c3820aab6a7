// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/units.h"
#include "cli/access_text.h"
#include "cli/calibration_choice.h"
#include "cli/commands.h"
#include "cli/connection.h"
#include "cli/console_orders.h"
#include "cli/feed_source.h"
#include "cli/paced_link.h"
#include "cli/run_files.h"
#include "cli/run_settings.h"
#include "cli/status_line.h"
#include "live/point_stream.h"
#include "platform/interrupt.h"
#include "platform/log.h"
#include "report/report_json.h"
#include "report/run_store.h"
#include "sources/open_source.h"
#include "streaming/run/job.h"
#include "streaming/simulation/template_proof.h"
#include "streaming/start/stop_bound.h"
#include "templates/flexible_program.h"

namespace rivulet::cli {

namespace {

using base::Result;

/// A line on a terminal says how far the run is.
class LiveConsole final : public streaming::RunSink, public ConsoleOrders {
 public:
  LiveConsole(double stopAfterS, FeedSource& feed) : ConsoleOrders(stopAfterS, feed) {}
  void update(const streaming::LiveUpdate& update) override {
    tell(update);
    if (update.wrong && !m_saysWrong) {
      m_saysWrong = true;
      log::logger().error("Wrong motion: {}. Stop the run, then check workpiece and tool.",
                          streaming::describe(*update.wrong));
    }
    if (!update.source || update.source->executed == m_shown) {
      return;
    }
    m_shown = update.source->executed;
    m_line.show(fmt::format("{:<8} {} points executed, {} of at most {} waiting",
                            streaming::runStateName(update.state), m_shown, update.source->waiting,
                            update.source->capacity));
  }
  void access(const trace::Access&) override {}
  void note(const trace::Note&) override {}

 private:
  StatusLine m_line;
  bool m_saysWrong = false;
  std::size_t m_shown = 0;
};

live::Setup setupOf(const LiveOptions& live) {
  live::Setup setup;
  setup.address = live.source;
  setup.agreement = live.agreed;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    setup.agreement.lowestMm.set(axis, live.boxMm[2 * axis]);
    setup.agreement.highestMm.set(axis, live.boxMm[2 * axis + 1]);
  }
  setup.limits.fullWithin = base::fromSeconds(live.fullWithinMs / 1000.0);
  setup.limits.holdAfter = base::fromSeconds(live.holdAfterS);
  setup.limits.endAfter = base::fromSeconds(live.endAfterS);
  return setup;
}

class LiveCommand {
 public:
  explicit LiveCommand(const StreamOptions& options) : m_options(options) {}
  Result<void> prepare();
  [[nodiscard]] Exit run();

 private:
  Result<void> plan();
  Result<void> connect();
  Result<void> checkTravel();
  [[nodiscard]] run::RunFacts facts() const;
  [[nodiscard]] Exit show(const streaming::RunReport& done, const run::RunRecord& record) const;

  const StreamOptions& m_options;
  live::Setup m_setup;
  streaming::RunSettings m_settings;
  templates::FlexibleProgram m_flexible;
  std::unique_ptr<live::Source> m_source;
  std::unique_ptr<run::FactorFeed> m_factor;
  Connection m_connection;
};

Result<void> LiveCommand::prepare() {
  for (const auto step : {&LiveCommand::plan, &LiveCommand::connect, &LiveCommand::checkTravel}) {
    if (Result<void> done = (this->*step)(); !done) {
      return done;
    }
  }
  auto source = sources::openSource(m_setup.address);
  if (!source) {
    return base::fail(source.error());
  }
  m_source = std::move(*source);
  if (Result<void> ready = m_source->prepare(); !ready) {
    return ready;
  }
  auto factor = openFactor(m_settings);
  if (!factor) {
    return base::fail(factor.error());
  }
  m_factor = std::move(*factor);
  fmt::print(stderr, "Points are taken from {}.\n", m_source->name());
  return {};
}

Result<void> LiveCommand::plan() {
  m_setup = setupOf(m_options.live);
  if (Result<void> sound = live::requireSound(m_setup); !sound) {
    return sound;
  }
  m_settings = settingsOf(m_options, {});
  if (m_options.point.feedMmPerMin <= 0.0) {
    m_settings.feedMmPerS = base::mmPerSFromMmPerMin(m_setup.agreement.feedMmPerMinMax);
  }
  return templates::requireProgram(m_settings.parameters);
}

Result<void> LiveCommand::connect() {
  auto connection = m_options.simulate ? simulate(m_options.preset, m_options.seed)
                                       : connectTo(m_options.endpoint);
  if (!connection) {
    return base::fail(connection.error());
  }
  m_connection = std::move(*connection);
  if (Result<void> taken = takeSilenceLimit(m_settings.parameters, m_options.point, m_connection);
      !taken) {
    return taken;
  }
  const auto proof = takeStopLimit(m_settings, m_options.point, m_connection);
  if (!proof) {
    return base::fail(proof.error());
  }
  if (m_settings.windowSMax > 0.0) {
    log::logger().warn(
        "Stop: the control still executes the window that is in motion, of at most {} moves within "
        "the agreed box, and of at most {:.1f} s: longer moves are divided. {}",
        m_settings.parameters.pointsPerLoop * streaming::windowsAfterStop(m_settings.parameters),
        m_settings.windowSMax, streaming::describe(*proof));
  }
  auto flexible = templates::makeProgram(m_settings.parameters);
  if (!flexible) {
    return base::fail(flexible.error());
  }
  m_flexible = std::move(*flexible);
  if (base::needsCommissioning(m_settings.parameters.method)) {
    if (Result<void> tested = requireTest(m_options, m_connection); !tested) {
      return tested;
    }
    m_settings.isCommissioned = true;
  }
  if (m_options.simulate) {
    return {};
  }
  m_settings.origin = report::thisUser();
  return streaming::requireProven(m_flexible);
}

run::RunFacts LiveCommand::facts() const {
  run::RunFacts facts;
  facts.kind = run::RunKind::Live;
  facts.programName = m_source->name();
  facts.endpoint = m_connection.name;
  facts.startedAtUtc = utcNow();
  facts.recording = m_options.record;
  facts.onCut = &tellCut;
  facts.isSimulated = m_options.simulate;
  return facts;
}

/// Of the box in which all points lie.
Result<void> LiveCommand::checkTravel() {
  gcode::StreamPoint least;
  gcode::StreamPoint most;
  least.positionMm = m_setup.agreement.lowestMm;
  most.positionMm = m_setup.agreement.highestMm;
  return requireTravel(m_connection, m_options.simulate ? m_options.preset : std::string(),
                       std::array{least, most});
}

Exit LiveCommand::run() {
  run::RunRecord record(facts());
  if (const Result<void> opened = record.open(); !opened) {
    return reportError(opened.error(), m_options.json);
  }
  // The points may come from standard input.
  base::Result<FeedSource> feed = FeedSource::open(m_options.orders, true);
  if (!feed) {
    return reportError(feed.error(), m_options.json);
  }
  if (m_factor) {
    feed->follow(*m_factor);
  }
  live::PointStream points(*m_source, m_setup.agreement, m_setup.limits);
  PacedLink paced(*m_connection.link);
  opcua::Link& link = m_options.simulate ? static_cast<opcua::Link&>(paced) : *m_connection.link;
  streaming::RunReport done;
  {
    LiveConsole console(m_options.stopAfterS, *feed);
    done = streaming::runLive(link, *m_connection.control, m_source->name(), points, m_flexible,
                              m_settings, console, console,
                              {record.writer(), record.start(), nullptr});
  }
  if (m_factor) {
    m_factor->finish(streaming::outcomeName(done.outcome), done.factor);
    m_factor.reset();
  }
  m_source.reset();  // the sender hears the end
  record.finish(done, {points.points()});
  return show(done, record);
}

void printLive(const live::Summary& live) {
  if (live.merged > 0) {
    fmt::print(
        "{} points were merged with the one before, which was too close; the first in line "
        "{}\n",
        live.merged, live.firstMerged);
  }
  fmt::print(
      "{} lines of {}, executed to line {}; {} windows of {:.0f} ms, {} of them sent before they "
      "were full\n",
      live.lines, live.source, live.lastLine, live.windows, base::toMilliseconds(live.windowTime),
      live.shortWindows);
  if (live.delay.count > 0) {
    fmt::print(
        "delay from arrival to motion: median {:.0f} ms, 90 % {:.0f} ms, 99 % {:.0f} ms, "
        "max {:.0f} ms; in theory {:.0f} ms at least, {:.0f} ms with all buffers full\n",
        base::toMilliseconds(live.delay.p50), base::toMilliseconds(live.delay.p90),
        base::toMilliseconds(live.delay.p99), base::toMilliseconds(live.delay.max),
        base::toMilliseconds(live.leastDelay), base::toMilliseconds(live.mostDelay));
  }
}

Exit LiveCommand::show(const streaming::RunReport& done, const run::RunRecord& record) const {
  if (m_options.json) {
    nlohmann::ordered_json json = report::runJson(done);
    json["endpoint"] = m_connection.name;
    json.update(filesJson(record, "saved_run"));
    printJson(json);
  } else {
    const live::Summary live = done.live.value_or(live::Summary{});
    fmt::print("{}: {} of {} points executed, {}\n", streaming::outcomeName(done.outcome),
               live.executed, live.accepted,
               done.integrity.judged
                   ? fmt::format("{} repeated, {} skipped, {} foreign", done.integrity.repeated,
                                 done.integrity.skipped, done.integrity.foreign)
                   : std::string("not judged"));
    fmt::print("{:.1f} s, access form: {}\n", base::toSeconds(done.duration),
               accessText(done.settings.grouping, done.accessForms));
    if (done.live) {
      printLive(*done.live);
    }
    printFactor(done.factor);
    if (done.error.code) {
      log::logger().error(done.error.text());
    }
  }
  return exitAfter(done, record);
}

}  // namespace

Exit streamLive(const StreamOptions& options) {
  interrupt::watch();
  LiveCommand command(options);
  if (const Result<void> prepared = command.prepare(); !prepared) {
    return reportError(prepared.error(), options.json);
  }
  return command.run();
}

}  // namespace rivulet::cli
