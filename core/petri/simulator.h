// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Plays a net. Of the transitions that are enabled at the present time, one of the lowest priority
/// number fires; time goes on when none is enabled. With seed 0 the first of several fires, in the
/// order of the net; else one is drawn. The same net and seed give the same run, to the bit.
/// @threadsafety one object, one thread. The net outlives it.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/random.h"
#include "base/result.h"
#include "petri/marking.h"
#include "petri/net.h"

namespace rivulet::petri {

/// A token of an observer place.
struct Recorded {
  std::size_t place = 0;
  Word time = 0;
  const Words* value = nullptr;  ///< valid during the call
};

class Simulator {
 public:
  explicit Simulator(const Net& net, std::uint64_t seed = 0);

  /// What observer places record; may be empty.
  void setRecorder(std::function<void(const Recorded&)> recorder) {
    m_recorder = std::move(recorder);
  }
  /// Called with each transition that fires, after it.
  void setWatcher(std::function<void(std::size_t transition, Word time)> watcher) {
    m_watcher = std::move(watcher);
  }

  /// Fires until the time is after `until` or nothing can fire any more.
  /// @return whether it can go on
  bool run(Word until);
  /// The same, of a net that may make tokens without end.
  /// @param mayHold  asked now and then with the bytes of the marking  @return its error
  base::Result<bool> run(Word until, const std::function<base::Result<void>(std::size_t)>& mayHold);
  /// Fires one transition. @return false if none will ever be enabled, or not up to `until`
  bool step(Word until = kNever - 1);
  /// The transition that `step` fires next; time goes on to the moment at which it is enabled.
  /// @return nothing if none will ever be enabled, or not up to `until`
  std::optional<std::size_t> next(Word until = kNever - 1);

  /// Fires a given transition at a given time, with the first binding for which `accepts` holds.
  /// For the replay of recorded events; time does not go on otherwise.
  /// @return false if it is not enabled then
  bool fire(std::size_t transition, Word time,
            const std::function<bool(const Evaluator::Frame&)>& accepts);

  /// Whether a transition could fire at a time; nothing fires. For the replay of recorded events.
  [[nodiscard]] bool isEnabled(std::size_t transition, Word time);

  [[nodiscard]] Word now() const { return m_now; }
  [[nodiscard]] std::uint64_t firings() const { return m_firings; }
  /// How often each transition has fired.
  [[nodiscard]] const std::vector<std::uint64_t>& counts() const { return m_counts; }
  [[nodiscard]] const Marking& marking() const { return m_marking; }
  /// Names of the invariants that do not hold in this marking.
  [[nodiscard]] std::vector<std::string> violations();

 private:
  void execute(std::size_t transition, const Binding& binding);
  [[nodiscard]] std::optional<std::size_t> choose();
  void noteTouched(const Transition& transition);

  const Net& m_net;
  Marking m_marking;
  base::Random m_random;
  bool m_draws;
  Evaluator m_evaluator;
  Binder m_binder;
  Firer m_firer;
  Word m_now = 0;
  std::uint64_t m_firings = 0;
  std::vector<std::uint64_t> m_counts;
  std::optional<std::size_t> m_next;               ///< chosen and not yet fired
  std::vector<Binding> m_bindings;                 ///< first one of each transition
  std::vector<char> m_isStale;                     ///< the binding has to be searched again
  std::vector<std::vector<std::size_t>> m_takers;  ///< transitions by place they take from
  /// A place that a transition takes from or puts to.
  struct Touched {
    std::size_t place = 0;
    bool isPutBack = false;  ///< it puts back what it has taken: nothing changes if that is all
  };
  std::vector<std::vector<Touched>> m_touched;  ///< by transition
  std::vector<std::size_t> m_byPriority;
  std::vector<std::size_t> m_candidates;
  std::function<void(const Recorded&)> m_recorder;
  std::function<void(std::size_t, Word)> m_watcher;
};

}  // namespace rivulet::petri
