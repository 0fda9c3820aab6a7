// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Adaptive feed of a run of the command line: a source of factors, and what was agreed with it.
/// @threadsafety one object, one thread; nothing waits.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "live/feed_factor.h"
#include "streaming/run/run.h"
#include "templates/cells.h"

namespace rivulet::cli {

struct FactorOptions {
  std::string source;  ///< see `sources::openSource`; empty: none
  double silenceS = base::toSeconds(live::FactorAgreement{}.silence);
  std::string inSilence = "hold";  ///< hold, override
};

class FactorFeed {
 public:
  /// Listens from now on, and says on standard error what was agreed. @param bounds  of the factor
  /// @return null: there is no source; NotOpened, NotAgreed
  [[nodiscard]] static base::Result<std::unique_ptr<FactorFeed>> open(
      const FactorOptions& options, const templates::WindowSettings& bounds);

  /// Reads what has come.
  [[nodiscard]] const live::FactorSeen& seen(base::Instant now);
  /// See `live::FeedFactor`.
  void release(base::Instant now) { m_factor.release(now); }
  /// Tells the sender what has become of its factors.
  void tell(const streaming::LiveUpdate& update);
  /// The last reply. Completes the report.
  void finish(std::string_view outcome, std::optional<streaming::FactorReport>& report);

 private:
  FactorFeed(std::unique_ptr<live::Source> source, const live::FactorAgreement& agreement);

  std::unique_ptr<live::Source> m_source;
  live::FeedFactor m_factor;
  live::FactorReader m_reader;
  live::Progress m_told;
};

/// What came of it, on standard output; nothing without a source.
void printFactor(const std::optional<streaming::FactorReport>& report);

}  // namespace rivulet::cli
