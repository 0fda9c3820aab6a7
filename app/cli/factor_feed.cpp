// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/factor_feed.h"

#include <fmt/format.h>

#include <cstdio>
#include <utility>

#include "base/units.h"
#include "sources/open_source.h"

namespace rivulet::cli {

base::Result<std::unique_ptr<FactorFeed>> FactorFeed::open(
    const FactorOptions& options, const templates::WindowSettings& bounds) {
  if (options.source.empty()) {
    return std::unique_ptr<FactorFeed>();
  }
  const live::FactorAgreement agreement{bounds.factorLeast, bounds.factorMost,
                                        base::fromSeconds(options.silenceS),
                                        options.inSilence == "hold"};
  if (base::Result<void> sound = live::requireSound(agreement); !sound) {
    return base::fail(sound.error());
  }
  auto source = sources::openSource(options.source);
  if (!source) {
    return base::fail(source.error());
  }
  if (base::Result<void> ready = (*source)->prepare(); !ready) {
    return base::fail(ready.error());
  }
  fmt::print(stderr, "The feed follows {}: {}.\n", (*source)->name(), live::textOf(agreement));
  return std::unique_ptr<FactorFeed>(new FactorFeed(std::move(*source), agreement));
}

FactorFeed::FactorFeed(std::unique_ptr<live::Source> source, const live::FactorAgreement& agreement)
    : m_source(std::move(source)),
      m_factor(m_source->name(), agreement),
      m_reader(*m_source, m_factor) {
}

const live::FactorSeen& FactorFeed::seen(base::Instant now) {
  m_reader.turn(now);
  return m_factor.seen(now);
}

void FactorFeed::tell(const streaming::LiveUpdate& update) {
  if (!update.sample || !update.sample->positionMm || !m_source->takesReplies()) {
    return;
  }
  m_told.accepted = m_factor.count().values;
  m_told.executed = update.counters.executed;
  m_told.positionMm = *update.sample->positionMm;
  m_told.feed = live::Progress::Feed{};
  m_told.feed->percent = update.feed ? update.feed->actsPercent.value_or(0.0) : 0.0;
  if (update.sample->feedMmPerS) {
    m_told.feed->feedMmPerMin = base::mmPerMinFromMmPerS(*update.sample->feedMmPerS);
  }
  m_source->tell(m_told);
}

void FactorFeed::finish(std::string_view outcome, std::optional<streaming::FactorReport>& report) {
  if (report) {
    report->count = m_factor.count();
  }
  if (m_source->takesReplies()) {
    m_told.accepted = m_factor.count().values;
    m_told.end = live::Progress::End{std::string(outcome), {}};
    m_source->tell(m_told);
  }
}

void printFactor(const std::optional<streaming::FactorReport>& report) {
  if (!report || report->count.source.empty()) {
    return;
  }
  fmt::print(
      "factors of the override from {}: {} as agreed, {} refused, {} silences; {} written, "
      "{:g} to {:g}\n",
      report->count.source, report->count.values, report->count.refused, report->count.silences,
      report->written, report->least, report->most);
  if (report->delay.count > 0) {
    fmt::print(
        "delay from reading a factor to its cell: median {:.1f} ms, 99 % {:.1f} ms, max "
        "{:.1f} ms\n",
        base::toMilliseconds(report->delay.p50), base::toMilliseconds(report->delay.p99),
        base::toMilliseconds(report->delay.max));
  }
}

}  // namespace rivulet::cli
