// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "petri/simulator.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/contract.h"

namespace rivulet::petri {

Simulator::Simulator(const Net& net, std::uint64_t seed)
    : m_net(net),
      m_marking(initialMarking(net)),
      m_random(seed),
      m_draws(seed != 0),
      m_evaluator(net, m_marking, &m_random),
      m_binder(net, m_marking, m_evaluator, true),
      m_firer(net, m_marking, m_evaluator),
      m_counts(net.transitions.size()),
      m_bindings(net.transitions.size()),
      m_isStale(net.transitions.size(), 1),
      m_takers(net.places.size()),
      m_byPriority(net.transitions.size()) {
  for (std::size_t i = 0; i < net.transitions.size(); ++i) {
    for (const InputArc& arc : net.transitions[i].inputs) {
      m_takers[arc.place].push_back(i);
    }
    noteTouched(net.transitions[i]);
  }
  std::iota(m_byPriority.begin(), m_byPriority.end(), std::size_t{0});
  std::stable_sort(m_byPriority.begin(), m_byPriority.end(), [&](std::size_t a, std::size_t b) {
    return net.transitions[a].priority < net.transitions[b].priority;
  });
}

void Simulator::noteTouched(const Transition& transition) {
  std::vector<Touched> touched;
  const auto add = [&](std::size_t place) {
    const bool isKnown = std::any_of(touched.begin(), touched.end(),
                                     [place](const Touched& one) { return one.place == place; });
    if (!isKnown && !m_net.places[place].isObserver) {
      touched.push_back({place, false});
    }
  };
  for (const InputArc& arc : transition.inputs) {
    add(arc.place);
  }
  for (const OutputArc& arc : transition.outputs) {
    add(arc.place);
  }
  for (Touched& one : touched) {
    const auto isHere = [&one](const auto& arc) { return arc.place == one.place; };
    const auto taken = std::find_if(transition.inputs.begin(), transition.inputs.end(), isHere);
    const auto put = std::find_if(transition.outputs.begin(), transition.outputs.end(), isHere);
    if (taken == transition.inputs.end() || put == transition.outputs.end() || !taken->binds ||
        taken->isEarly || put->hasDelay) {
      continue;
    }
    const Node& value = m_net.nodes[put->value];
    one.isPutBack =
        value.op == Op::Variable && value.index == taken->variable &&
        std::count_if(transition.inputs.begin(), transition.inputs.end(), isHere) == 1 &&
        std::count_if(transition.outputs.begin(), transition.outputs.end(), isHere) == 1;
  }
  m_touched.push_back(std::move(touched));
}

std::optional<std::size_t> Simulator::choose() {
  m_candidates.clear();
  int priority = 0;
  Word soonest = kNever;
  for (const std::size_t i : m_byPriority) {
    if (!m_candidates.empty() && m_net.transitions[i].priority != priority) {
      break;
    }
    Binding& binding = m_bindings[i];
    if (m_isStale[i] != 0) {
      binding = m_binder.earliest(m_net.transitions[i], m_now);
      m_isStale[i] = 0;
    }
    if (binding.time <= m_now) {
      if (!m_draws) {
        return i;
      }
      priority = m_net.transitions[i].priority;
      m_candidates.push_back(i);
    } else {
      soonest = std::min(soonest, binding.time);
    }
  }
  if (!m_candidates.empty()) {
    return m_candidates[m_random.below(m_candidates.size())];
  }
  // Nothing is enabled now: time goes on to the first moment at which something is.
  if (soonest == kNever) {
    return std::nullopt;
  }
  m_now = soonest;
  for (std::size_t i = 0; i < m_net.transitions.size(); ++i) {
    if (m_net.transitions[i].asksTime) {
      m_isStale[i] = 1;
    }
  }
  return choose();
}

void Simulator::execute(std::size_t transition, const Binding& binding) {
  const Transition& fired = m_net.transitions[transition];
  const Binding taken = binding;
  const Evaluator::Frame frame = m_binder.frameOf(fired, taken);
  m_firer.fire(fired, taken, frame, m_now, [&](std::size_t place, const Words& value, Word time) {
    if (m_recorder) {
      m_recorder({place, time, &value});
    }
  });
  for (const Touched& touched : m_touched[transition]) {
    // The only token of a place, put back as it was, was available and is: no binding changes.
    if (touched.isPutBack && m_marking[touched.place].size() == 1) {
      continue;
    }
    for (const std::size_t taker : m_takers[touched.place]) {
      m_isStale[taker] = 1;
    }
  }
  ++m_firings;
  ++m_counts[transition];
  if (m_watcher) {
    m_watcher(transition, m_now);
  }
}

std::optional<std::size_t> Simulator::next(Word until) {
  if (!m_next) {
    const Word before = m_now;
    m_next = choose();
    if (m_next && m_now > until) {
      m_now = std::max(before, until);
      m_next.reset();
    }
  }
  return m_next;
}

bool Simulator::step(Word until) {
  const std::optional<std::size_t> transition = next(until);
  if (!transition) {
    return false;
  }
  m_next.reset();
  execute(*transition, m_bindings[*transition]);
  return true;
}

bool Simulator::run(Word until) {
  return *run(until, [](std::size_t) { return base::Result<void>(); });
}

base::Result<bool> Simulator::run(Word until,
                                  const std::function<base::Result<void>(std::size_t)>& mayHold) {
  constexpr std::uint64_t kFirings = 256;  // that are not asked for
  std::uint64_t next = m_firings + kFirings;
  while (step(until)) {
    if (m_firings < next) {
      continue;
    }
    // The rarer the longer it takes, so that no run takes much longer for it.
    const std::size_t bytes = memoryBytes(m_marking);
    next = m_firings + kFirings + bytes / (8 * sizeof(Token));
    if (auto may = mayHold(bytes); !may) {
      return base::fail(may.error());
    }
  }
  return std::any_of(m_bindings.begin(), m_bindings.end(),
                     [](const Binding& binding) { return binding.time != kNever; });
}

bool Simulator::fire(std::size_t transition, Word time,
                     const std::function<bool(const Evaluator::Frame&)>& accepts) {
  RIVULET_ASSERT(time >= m_now);
  const Transition& wanted = m_net.transitions[transition];
  const auto binding = m_binder.firstAccepted(wanted, time, accepts);
  if (!binding) {
    return false;
  }
  m_now = time;
  m_next.reset();
  execute(transition, *binding);
  return true;
}

bool Simulator::isEnabled(std::size_t transition, Word time) {
  return m_binder
      .firstAccepted(m_net.transitions[transition], time,
                     [](const Evaluator::Frame&) { return true; })
      .has_value();
}

std::vector<std::string> Simulator::violations() {
  std::vector<std::string> names;
  for (const Invariant& invariant : m_net.invariants) {
    if (m_evaluator.scalar(invariant.condition, {}) == 0) {
      names.push_back(invariant.name);
    }
  }
  m_evaluator.release();
  return names;
}

}  // namespace rivulet::petri
