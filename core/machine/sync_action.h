// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Synchronized actions: evaluated in every interpolation cycle of the main run, in the order of
/// their numbers; those without a number hold for the next block of the main run alone, a dwell
/// included. An action becomes active when the block that follows it begins. `$R` is read and
/// written in the main run; a plain `R10` is the value at interpretation. IDS actions outlive
/// the program, until the channel is reset or another program starts. @threadsafety one object, one
/// thread.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "machine/alarm.h"
#include "machine/main_run.h"
#include "nc/syntax/tree.h"

namespace rivulet::machine {

struct SyncAssignment {
  std::optional<SystemVariable> variable;  ///< none: $R
  nc::Expression index;                    ///< axis or element as a number
  nc::Expression value;
};

/// A `nc::Synchronized` as it is executed: all but variables of the main run has become a number.
struct SyncAction {
  int id = 0;             ///< 0: for the next block alone
  bool isStatic = false;  ///< IDS
  nc::Trigger trigger = nc::Trigger::Always;
  std::optional<nc::Expression> condition;
  std::vector<SyncAssignment> assignments;
};

/// What the interpretation of the block makes of it. @param values  of the program, at this moment
[[nodiscard]] nc::Expected<SyncAction> frozen(const nc::Synchronized& action,
                                              const nc::ValueSource& values);

class SyncActions {
 public:
  /// @param block  number of the block that follows, counted by the planner
  void add(std::shared_ptr<const SyncAction> action, std::uint64_t block);
  void cancel(int id);
  /// The program has ended: all but the static ones go.
  void endProgram();
  void clear() { m_active.clear(); }
  [[nodiscard]] bool isEmpty() const { return m_active.empty(); }

  /// One cycle. @param blocksFinished  blocks the main run has finished
  /// @return the alarm of an action that failed; it is cancelled
  std::optional<Alarm> run(MainRun& mainRun, std::uint64_t blocksFinished);

 private:
  struct Active {
    std::shared_ptr<const SyncAction> action;
    std::uint64_t block = 0;
    bool held = false;     ///< the condition, in the cycle before
    bool latched = false;  ///< From: it has held once
    bool done = false;     ///< When: it has been executed
  };

  std::vector<Active> m_active;  // by number
};

}  // namespace rivulet::machine
