// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Adaptive feed of a run: its source of factors, from the opening to the last reply, and what was
/// agreed with it. The same for command line, window and service.
/// @threadsafety one object, on the thread of the run; nothing waits.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "live/feed_factor.h"
#include "streaming/run/run.h"

namespace rivulet::run {

/// All that is agreed with the source of these settings; nothing: they have none.
[[nodiscard]] std::optional<live::FactorAgreement> agreedFactor(
    const streaming::RunSettings& settings);

/// "The feed follows tcp:4002: factor 0.2 to 1.2; without one for 1 s the axes are held."
[[nodiscard]] std::string followsText(const std::string& source,
                                      const live::FactorAgreement& agreement);

class FactorFeed {
 public:
  /// Listens from now on.
  /// @return null: the settings have no source; NotOpened, NotAgreed
  [[nodiscard]] static base::Result<std::unique_ptr<FactorFeed>> open(
      const streaming::RunSettings& settings);

  /// See `followsText`.
  [[nodiscard]] std::string text() const;
  /// Reads what has come, and completes the order with it.
  /// @param goesOn  while the source holds, the operator goes on without it: see `live::FeedFactor`
  void follow(streaming::FeedOrder& order, bool goesOn, base::Instant now);
  /// Tells the sender what has become of its factors.
  void tell(const streaming::LiveUpdate& update);
  /// The last reply. Completes the report.
  void finish(std::string_view outcome, std::optional<streaming::FactorReport>& report);

 private:
  FactorFeed(std::unique_ptr<live::Source> source, const live::FactorAgreement& agreement);

  std::unique_ptr<live::Source> m_source;
  live::FactorAgreement m_agreement;
  live::FeedFactor m_factor;
  live::FactorReader m_reader;
  live::Progress m_told;
};

}  // namespace rivulet::run
