// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The claim on the cells as part of a start: the name of this client is on the control while it
/// holds them, and a client that does not get them is told who has them.
/// @threadsafety one object, one thread.
#pragma once

#include <optional>

#include "opcua/link.h"
#include "streaming/run/driver.h"
#include "streaming/run/run.h"
#include "streaming/start/cell_claim.h"
#include "templates/cells.h"

namespace rivulet::streaming {

class StartClaim {
 public:
  /// @param cells     of the program, outlive the claim
  /// @param settings  of the run, outlive the claim. Without a user nothing is claimed.
  StartClaim(opcua::Link& link, opcua::Control& control, const templates::CellMap& cells,
             const RunSettings& settings)
      : m_link(link), m_control(control), m_cells(cells), m_settings(settings) {}

  /// Claims the cells and stores the name of the run, before anything else is written.
  /// @param number  of the run, 1 to `kRunNumberMax`
  /// @param notes   told if the name could not be stored
  /// @return Claimed: another client has them; Cancelled; ChannelBusy; or a link error
  [[nodiscard]] base::Result<void> take(int number, CellClaim::Hooks hooks, RunSink& notes);
  /// To be called before each step that changes the control. @return as `take`
  [[nodiscard]] base::Result<void> renew();
  /// After the run.
  void release();

  /// For what is done before the run: while it waits, the claim is repeated.
  [[nodiscard]] opcua::Link& link() {
    return m_claim ? static_cast<opcua::Link&>(*m_claim) : m_link;
  }
  /// ChannelBusy with the name of the run that is on the control; other errors unchanged.
  [[nodiscard]] base::Error withName(base::Error error);

 private:
  [[nodiscard]] base::Result<void> answer(const base::Result<std::optional<int>>& holder);
  [[nodiscard]] int labelCell() const;
  /// @return nothing: the control does not tell
  [[nodiscard]] std::optional<RunOrigin> originOf(int number);
  [[nodiscard]] base::Error claimedBy(int number);

  opcua::Link& m_link;
  opcua::Control& m_control;
  const templates::CellMap& m_cells;
  const RunSettings& m_settings;
  CellClaim::Hooks m_hooks;
  std::optional<CellClaim> m_claim;  ///< nothing: the cells are not claimed
};

}  // namespace rivulet::streaming
