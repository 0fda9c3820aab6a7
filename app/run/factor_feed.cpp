// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "run/factor_feed.h"

#include <fmt/format.h>

#include <utility>

#include "base/units.h"
#include "sources/open_source.h"

namespace rivulet::run {

std::optional<live::FactorAgreement> agreedFactor(const streaming::RunSettings& settings) {
  const live::FactorSource& source = settings.factor;
  if (source.address.empty()) {
    return std::nullopt;
  }
  return live::FactorAgreement{settings.parameters.factorLeast, settings.parameters.factorMost,
                               source.silence, source.holdsInSilence};
}

base::Result<std::unique_ptr<FactorFeed>> FactorFeed::open(const streaming::RunSettings& settings) {
  const auto agreement = agreedFactor(settings);
  if (!agreement) {
    return std::unique_ptr<FactorFeed>();
  }
  if (base::Result<void> sound = live::requireSound(*agreement); !sound) {
    return base::fail(sound.error());
  }
  auto source = sources::openSource(settings.factor.address);
  if (!source) {
    return base::fail(source.error());
  }
  if (base::Result<void> ready = (*source)->prepare(); !ready) {
    return base::fail(ready.error());
  }
  return std::unique_ptr<FactorFeed>(new FactorFeed(std::move(*source), *agreement));
}

FactorFeed::FactorFeed(std::unique_ptr<live::Source> source, const live::FactorAgreement& agreement)
    : m_source(std::move(source)),
      m_agreement(agreement),
      m_factor(m_source->name(), agreement),
      m_reader(*m_source, m_factor) {
}

std::string followsText(const std::string& source, const live::FactorAgreement& agreement) {
  return fmt::format("The feed follows {}: {}.", source, live::textOf(agreement));
}

std::string FactorFeed::text() const {
  return followsText(m_source->name(), m_agreement);
}

void FactorFeed::follow(streaming::FeedOrder& order, bool goesOn, base::Instant now) {
  m_reader.turn(now);
  order.source = m_factor.seen(now);
  if (goesOn && order.source->holds()) {
    m_factor.release(now);
    order.source = m_factor.seen(now);
  }
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

}  // namespace rivulet::run
