// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What a single run and a whole job have in common before anything moves: the claim of the cells,
/// the form of access, the wait for cycle start, and what the display is told.
/// @threadsafety one object, one thread.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "streaming/run/driver.h"
#include "streaming/run/ledger.h"
#include "streaming/run/run.h"
#include "streaming/start/start_claim.h"
#include "templates/flexible_program.h"

namespace rivulet::streaming {

class HostedRun {
 public:
  virtual ~HostedRun() = default;
  HostedRun(const HostedRun&) = delete;
  HostedRun& operator=(const HostedRun&) = delete;

 protected:
  /// @param flexible  the program on the control, outlives the run: its parameters are those of the
  ///                  run, whatever `settings` say  @param writer  null: nothing is recorded
  HostedRun(opcua::Link& link, opcua::Control& control, const templates::FlexibleProgram& flexible,
            const RunSettings& settings, RunOrders& orders, RunSink& sink,
            trace::RecordingWriter* writer);

  /// No two runs have the same by accident: the clock of the link counts nanoseconds, and no two
  /// clients were switched on in the same one. @param hash  of the program
  [[nodiscard]] std::uint64_t entropy(const std::string& hash) const;

  /// Before anything is written: another client may be about to start, too. A start that is
  /// cancelled meanwhile is no failure.
  [[nodiscard]] base::Result<void> claim(int number);
  [[nodiscard]] base::Result<void> renewClaim();

  /// Tries the forms of access, unless one is given, on cells that the run will overwrite anyway.
  /// @return the forms that were tried; nothing: none were
  [[nodiscard]] base::Result<std::optional<AccessForms>> chooseAccess();

  /// Clears the cells, then starts the program if the control starts on request. A number that is
  /// left from an earlier run must not be mistaken for one of this.
  [[nodiscard]] base::Result<void> startProgram(const std::vector<int>& cleared,
                                                const char* waitingFor);
  /// @param isOurs  asks the control; true: the program has been started and waits for the client
  [[nodiscard]] base::Result<void> awaitStart(base::Duration interval,
                                              const std::function<base::Result<bool>()>& isOurs);

  /// The program waits for its client, and nothing moves. Tries the feed cell: the control has to
  /// carry out what makes hold and override act at once. @return FeedCellIgnored, OtherClient
  [[nodiscard]] base::Result<void> requireFeedCell();
  /// What the operator wants of the feed, and the sign of life, where no driver does it.
  [[nodiscard]] base::Result<void> followFeed();

  void pause(base::Duration duration);
  void publish(RunState state, const char* waitingFor);
  /// Completes what is published. Nothing here.
  virtual void describeTo(LiveUpdate& /*update*/) const {}

  opcua::Link& m_link;
  opcua::Control& m_control;
  const templates::FlexibleProgram& m_flexible;
  const templates::CellMap& m_cells;
  RunSettings m_settings;
  RunOrders& m_orders;
  Ledger m_ledger;
  FeedControl m_feed;  ///< of the program on the control
  StartClaim m_claim;
  bool m_isCancelled = false;  ///< stopped before anything has moved
  /// From the request to cancel to its confirmation by the control.
  std::optional<base::Duration> m_cancelTime;

 private:
  [[nodiscard]] base::Result<void> unlessCancelled(base::Result<void> claimed);
  [[nodiscard]] base::Result<void> cancel();
  [[nodiscard]] base::Result<void> beat();
  /// Writes a value, and waits until the control makes an override of it that is above 0 if `most`
  /// is, and not larger. @param ignored  what to say if it does not
  [[nodiscard]] base::Result<void> awaitOverride(
      const opcua::Assignment& tried, double most,
      const std::function<std::string(double acts)>& ignored);
};

}  // namespace rivulet::streaming
