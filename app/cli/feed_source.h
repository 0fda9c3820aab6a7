// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What the operator wants of the feed: by keys, if standard input is a terminal, or by lines of a
/// file, a pipe or standard input. Asking never waits.
/// @threadsafety one object, one thread.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "cli/commands.h"
#include "cli/progress_lines.h"
#include "platform/terminal.h"
#include "run/factor_feed.h"
#include "streaming/run/feed_order.h"
#include "streaming/run/run.h"

namespace rivulet::cli {

class FeedSource {
 public:
  /// @param options  source: file or pipe; "-": standard input; empty: keys, if it is a terminal
  ///              that nobody else reads  @param isInputTaken  somebody else does
  /// @return FileUnreadable, and as `ProgressLines::open`
  [[nodiscard]] static base::Result<FeedSource> open(const OrderOptions& options,
                                                     bool isInputTaken);
  FeedSource(FeedSource&& other) noexcept;
  FeedSource& operator=(FeedSource&&) = delete;
  ~FeedSource();

  /// From now on a source of factors acts beside the operator. "Continue" while it holds, and the
  /// operator does not, goes on without it. @param factor  outlives this object
  void follow(run::FactorFeed& factor) { m_factor = &factor; }

  /// Reads what is available. The last order stays.
  [[nodiscard]] streaming::FeedOrder order(base::Instant now);
  /// A person has keys: nobody else can order anything after the program has been told to end.
  [[nodiscard]] bool hasKeys() const { return m_hasKeys && mayRead(); }
  /// Whoever gave the orders has gone, and the run is not to go on without.
  [[nodiscard]] bool hasGone() const { return m_isOver && m_endsRun; }
  /// How often it was ordered to continue.
  [[nodiscard]] int continues() const { return m_continues; }
  /// Says on standard error what has become of it, when that changes, and how far the run is to
  /// whoever wants to know.
  void tell(const streaming::LiveUpdate& update);

 private:
  FeedSource(int descriptor, bool isOwn, bool hasKeys)
      : m_descriptor(descriptor), m_isOwn(isOwn), m_hasKeys(hasKeys) {}
  /// Only the job in the foreground may ask its terminal.
  [[nodiscard]] bool mayRead() const;
  void takeKey(char key);
  /// An order to continue.
  void goOn();
  void takeLine(std::string_view line);
  void change(double percent);
  [[nodiscard]] static base::Result<FeedSource> openSource(const std::string& path,
                                                           bool isInputTaken);
  void tellSource(const live::FactorSeen& source, base::Instant now);

  int m_descriptor;  ///< < 0: there is none
  bool m_isOwn;
  bool m_hasKeys;
  std::unique_ptr<platform::SingleKeys> m_keys;  ///< of the terminal
  std::string m_line;
  streaming::FeedOrder m_order;
  int m_continues = 0;
  bool m_endsRun = false;  ///< the end of the orders is a stop
  bool m_isOver = false;   ///< they have ended
  std::optional<ProgressLines> m_progress;
  run::FactorFeed* m_factor = nullptr;
  bool m_releases = false;  ///< what the source holds
  std::optional<live::FactorSeen> m_said;
  base::Instant m_sayNext{};
  std::optional<streaming::FeedSeen> m_told;
};

/// Opens the source of factors of a run, and says on standard error what was agreed.
/// @return as `run::FactorFeed::open`
[[nodiscard]] base::Result<std::unique_ptr<run::FactorFeed>> openFactor(
    const streaming::RunSettings& settings);
/// What came of it, on standard output; nothing without a source.
void printFactor(const std::optional<streaming::FactorReport>& report);

}  // namespace rivulet::cli
