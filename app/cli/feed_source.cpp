// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/feed_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/descriptor.h"
#include "base/file.h"
#include "base/text.h"
#include "cli/status_line.h"
#include "permission/permission.h"
#include "platform/input.h"
#include "platform/log.h"

namespace rivulet::cli {

namespace {

constexpr double kKeyStep = 5.0;  ///< percent
constexpr double kSeenMm = 0.01;  ///< axes at rest tremble
/// Whoever has the command line has the machine: nobody has logged in.
constexpr double kPercentMax = permission::overridePercentMax(permission::Role::Engineer);
static_assert(kPercentMax == templates::FeedCell::kProductMax);

}  // namespace

base::Result<FeedSource> FeedSource::open(const OrderOptions& options, bool isInputTaken) {
  base::Result<FeedSource> source = openSource(options.source, isInputTaken);
  if (!source) {
    return source;
  }
  source->m_endsRun = options.endsRun;
  if (!options.progress.empty()) {
    base::Result<ProgressLines> progress = ProgressLines::open(options.progress);
    if (!progress) {
      return base::fail(progress.error());
    }
    source->m_progress.emplace(std::move(*progress));
  }
  return source;
}

base::Result<FeedSource> FeedSource::openSource(const std::string& path, bool isInputTaken) {
  if (path == "-") {
    return FeedSource(platform::kStandardInput, false, false);
  }
  if (path.empty()) {
    const bool hasKeys = !isInputTaken && platform::isInputTerminal();
    FeedSource source(hasKeys ? platform::kStandardInput : -1, false, hasKeys);
    source.m_keys = hasKeys ? platform::SingleKeys::take() : nullptr;
    if (source.m_keys) {
      fmt::print(stderr, "Keys: h hold, c continue, + and - override.\n");
    }
    return source;
  }
  const int descriptor = base::openToRead(path);
  if (descriptor < 0) {
    return base::fail(base::FileError::Unreadable,
                      "The source of orders cannot be opened. Check the path and its permissions.",
                      path);
  }
  return FeedSource(descriptor, true, false);
}

FeedSource::FeedSource(FeedSource&& other) noexcept
    : m_descriptor(std::exchange(other.m_descriptor, -1)),
      m_isOwn(other.m_isOwn),
      m_hasKeys(other.m_hasKeys),
      m_keys(std::move(other.m_keys)),
      m_line(std::move(other.m_line)),
      m_order(other.m_order),
      m_continues(other.m_continues),
      m_endsRun(other.m_endsRun),
      m_isOver(other.m_isOver),
      m_progress(std::move(other.m_progress)),
      m_factor(other.m_factor),
      m_releases(other.m_releases),
      m_said(std::move(other.m_said)),
      m_sayNext(other.m_sayNext),
      m_told(other.m_told) {
}

FeedSource::~FeedSource() {
  if (m_isOwn && m_descriptor >= 0) {
    base::closeFile(m_descriptor);
  }
}

bool FeedSource::mayRead() const {
  return m_descriptor >= 0 && (!m_hasKeys || platform::isInForeground());
}

streaming::FeedOrder FeedSource::order(base::Instant now) {
  std::array<char, 256> bytes;
  if (mayRead()) {
    const platform::Input read = platform::readNow(m_descriptor, bytes);
    m_isOver = read.bytes > 0 ? false : m_isOver || read.isAtEnd;
    for (std::size_t i = 0; i < read.bytes; ++i) {
      const char byte = bytes[i];
      if (m_hasKeys) {
        takeKey(byte);
      } else if (byte == '\n') {
        takeLine(base::trim(m_line));
        m_line.clear();
      } else if (m_line.size() < bytes.size()) {
        m_line += byte;
      }
    }
  }
  if (m_factor != nullptr) {
    m_factor->follow(m_order, std::exchange(m_releases, false), now);
  }
  return m_order;
}

void FeedSource::goOn() {
  if (m_order.liftMm > 0.0) {
    log::logger().warn("The tool is lifted: lower it first.");
    return;
  }
  m_releases = !m_order.holds;
  m_order.holds = false;
  ++m_continues;
}

void FeedSource::takeKey(char key) {
  switch (key) {
    case 'h':
      m_order.holds = true;
      break;
    case 'c':
      goOn();
      break;
    case '+':
    case '-':
      change(m_order.percent + (key == '+' ? kKeyStep : -kKeyStep));
      break;
    default:
      break;
  }
}

void FeedSource::takeLine(std::string_view line) {
  constexpr std::string_view kOverride = "override ";
  constexpr double kNone = -1.0;
  const double percent =
      line.starts_with(kOverride)
          ? base::parseNumber(base::trim(line.substr(kOverride.size()))).value_or(kNone)
          : kNone;
  constexpr std::string_view kLift = "lift ";
  const double liftMm =
      line.starts_with(kLift)
          ? base::parseNumber(base::trim(line.substr(kLift.size()))).value_or(kNone)
          : kNone;
  if (liftMm > 0.0 && liftMm <= templates::kLiftMmMax) {
    m_order.liftMm = liftMm;
  } else if (line == "lower") {
    m_order.liftMm = 0.0;
  } else if (line == "hold") {
    m_order.holds = true;
  } else if (line == "continue") {
    goOn();
  } else if (percent >= 0.0 && percent <= kPercentMax) {
    m_order.percent = percent;
  } else if (!line.empty()) {
    log::logger().warn(
        "\"{}\" is no order: write hold, continue, override and 0 to {:g}, lift and up to {:g} mm, "
        "or lower. It is ignored.",
        line, kPercentMax, templates::kLiftMmMax);
  }
}

void FeedSource::change(double percent) {
  m_order.percent = std::clamp(percent, 0.0, kPercentMax);
}

/// What acts in the place of its factors: once a second at most.
void FeedSource::tellSource(const live::FactorSeen& source, base::Instant now) {
  if ((m_said && source.isSaidLike(*m_said)) || now < m_sayNext) {
    return;
  }
  m_said = source;
  m_sayNext = now + std::chrono::seconds{1};
  if (source.why.empty()) {
    sayOverStatus("The feed follows its source.");
  } else {
    log::logger().warn(
        "Source of the feed: {}{}", source.why,
        source.holds() && m_descriptor >= 0
            ? " It goes on with the next factor; continue goes on without the source."
            : "");
  }
}

void FeedSource::tell(const streaming::LiveUpdate& update) {
  if (m_progress) {
    m_progress->tell(update);
  }
  if (m_factor != nullptr) {
    m_factor->tell(update);
  }
  if (update.feed && update.feed->source) {
    tellSource(*update.feed->source, update.at);
  }
  if (!update.feed || m_told == update.feed) {
    return;
  }
  const streaming::FeedSeen before = m_told.value_or(streaming::FeedSeen{});
  const streaming::FeedSeen& now = *update.feed;
  m_told = now;
  if (now.isIgnored && !before.isIgnored) {
    log::logger().error("The axes do not obey the override. Stop them at the control.");
  } else if (now.isForeign && !before.isForeign) {
    log::logger().warn(
        "Another client has set the override to {:g} %: it stays until you change it.",
        now.wantedPercent);
  } else if (now.stoodAfter && !before.stoodAfter) {
    sayOverStatus(fmt::format("Held: the axes stand, {:.3f} s after the order.",
                              base::toSeconds(*now.stoodAfter)));
  } else if (now.liftedMm && before.liftedMm &&
             std::abs(*now.liftedMm - *before.liftedMm) > kSeenMm) {
    sayOverStatus(fmt::format("Held: the tool is lifted by {:.3f} mm.", *now.liftedMm));
  } else if (now.wantedPercent != before.wantedPercent) {
    sayOverStatus(now.wantedPercent == templates::FeedCell::kHold
                      ? "Hold."
                      : fmt::format("Override {:g} %.", now.wantedPercent));
  }
}

base::Result<std::unique_ptr<run::FactorFeed>> openFactor(const streaming::RunSettings& settings) {
  auto factor = run::FactorFeed::open(settings);
  if (factor && *factor) {
    fmt::print(stderr, "{}\n", (*factor)->text());
  }
  return factor;
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
