// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "live/feed_factor.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "live/error.h"
#include "live/line.h"

namespace rivulet::live {

namespace {

using base::Instant;

constexpr std::size_t kFactorBytesMax = 4096;
/// A source with more than this in a turn must not hold up the run: the rest is read in the next.
constexpr int kFactorReadsMax = 16;
/// What is larger, or no number, is not worth showing.
constexpr double kFactorShownMax = 1e4;
constexpr std::string_view kNoFactor = "The line is no factor of the feed, as feed 0.85 would be";

std::string without(const FactorAgreement& agreement) {
  return agreement.holdsInSilence ? "the axes are held" : "the override of the operator acts alone";
}

}  // namespace

base::Result<void> requireSound(const FactorAgreement& agreement) {
  if (agreement.silence <= base::Duration{0}) {
    return base::fail(LiveError::NotAgreed,
                      "A source of factors needs a time for its silence above 0 s.");
  }
  return {};
}

std::string textOf(const FactorAgreement& agreement) {
  return fmt::format("factor {} to {}; without one for {:g} s {}", agreement.least, agreement.most,
                     base::toSeconds(agreement.silence), without(agreement));
}

FeedFactor::FeedFactor(std::string source, const FactorAgreement& agreement)
    : m_agreement(agreement) {
  m_seen.source = source;
  m_count.source = std::move(source);
  fallBack(FactorState::Waiting, "No factor has come yet", {});
}

void FeedFactor::fallBack(FactorState state, std::string why, Instant now) {
  if (m_seen.state != state || m_seen.since == Instant{}) {
    m_seen.since = now;
  }
  m_seen.state = state;
  m_seen.factor = m_agreement.holdsInSilence ? 0.0 : 1.0;
  m_seen.why = fmt::format("{}: {}.", why, without(m_agreement));
  m_seen.refused.reset();
}

void FeedFactor::take(double factor, Instant now) {
  // Also false for what is not a number.
  if (!(factor >= m_agreement.least && factor <= m_agreement.most)) {
    refuse(fmt::format("The factor {:g} was not agreed: {:g} to {:g}, where 1 is 100 %", factor,
                       m_agreement.least, m_agreement.most),
           now);
    if (std::abs(factor) <= kFactorShownMax) {
      m_seen.refused = factor;
    }
    return;
  }
  ++m_count.values;
  m_heardAt = now;
  m_seen = {FactorState::Follows, factor, now, {}, m_count.source, std::nullopt};
}

void FeedFactor::refuse(std::string why, Instant now) {
  ++m_count.refused;
  fallBack(FactorState::Refused, std::move(why), now);
}

void FeedFactor::close(Instant now) {
  fallBack(FactorState::Closed, "The source has closed", now);
}

void FeedFactor::release(Instant now) {
  if (m_seen.holds()) {
    m_seen.state = FactorState::Released;
    m_seen.factor = 1.0;
    m_seen.since = now;
    m_seen.why = "The operator goes on without the source.";
  }
}

const FactorSeen& FeedFactor::seen(Instant now) {
  if (m_seen.state == FactorState::Follows && now - m_heardAt > m_agreement.silence) {
    ++m_count.silences;
    fallBack(FactorState::Silent,
             fmt::format("No factor for {:g} s", base::toSeconds(m_agreement.silence)), now);
  }
  return m_seen;
}

void FactorReader::turn(Instant now) {
  std::array<char, kFactorBytesMax> bytes;
  for (int reads = 0; reads < kFactorReadsMax && !m_isOver; ++reads) {
    const std::size_t count = m_source.read(bytes);
    m_reader.add({bytes.data(), count});
    while (const auto line = m_reader.next()) {
      if (m_hasBegun) {
        takeLine(*line, now);
      }
    }
    if (m_reader.isTooLong()) {
      m_reader = {};
      m_factor.refuse(std::string(kNoFactor), now);
    }
    if (count == 0) {
      if (m_source.isClosed()) {
        m_isOver = true;
        m_factor.close(now);
      }
      break;
    }
  }
  m_hasBegun = true;
}

void FactorReader::takeLine(std::string_view text, Instant now) {
  const base::Result<Line> line = parseLine(text);
  if (line && line->kind == Line::Kind::Feed) {
    m_factor.take(*line->factor, now);
  } else if (!line || line->kind != Line::Kind::Nothing) {
    m_factor.refuse(std::string(kNoFactor), now);
  }
}

}  // namespace rivulet::live
