// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "petri/state_space.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <limits>
#include <unordered_set>
#include <utility>

#include "base/hash.h"
#include "petri/marking.h"

namespace rivulet::petri {

namespace {

class Explorer {
 public:
  Explorer(const Net& net, const StateSpaceOptions& options)
      : m_net(net),
        m_options(options),
        m_evaluator(net, m_marking, nullptr),
        m_binder(net, m_marking, m_evaluator, false),
        m_firer(net, m_marking, m_evaluator),
        m_measured(net.colours.size()),
        m_isUrgent(net.transitions.size(), true),
        m_holds(net.invariants.size(), true) {
    for (std::size_t i = 0; i < net.colours.size(); ++i) {
      addMeasured(i, 0, m_measured[i]);
    }
    findUrgent();
    m_space.bounds.resize(net.places.size());
    m_space.fired.resize(net.transitions.size());
  }

  base::Result<StateSpace> explore() {
    m_marking = initialMarking(m_net);
    add();
    while (!m_open.empty()) {
      const Words state = std::move(m_open.front());
      m_open.pop_front();
      m_openBytes -= bytesOf(state);
      decode(state);
      inspect();
      follow(state);
      constexpr std::size_t kKnownBytes = 48;  // a node and its share of the table
      if (m_known.size() * kKnownBytes + m_openBytes > m_options.budget.left()) {
        return base::fail(m_options.budget.exceeded("The reachable markings"));
      }
      if (m_known.size() > m_options.statesMax) {
        return base::fail(
            PetriError::TooManyStates,
            fmt::format("More than {} markings are reachable; choose smaller capacities or raise "
                        "the limit.",
                        m_options.statesMax));
      }
    }
    m_space.states = m_known.size();
    for (std::size_t i = 0; i < m_holds.size(); ++i) {
      if (!m_holds[i]) {
        m_space.violated.push_back(m_net.invariants[i].name);
      }
    }
    return std::move(m_space);
  }

 private:
  /// Words of a colour set that are only measured.
  void addMeasured(ColourId colour, std::size_t start, std::vector<std::size_t>& words) const {
    const Colour& set = m_net.colours[colour];
    if (set.kind == ColourKind::List) {
      addMeasured(set.element, start, words);
    }
    for (const Field& field : set.fields) {
      if (field.isMeasured) {
        for (std::size_t i = 0; i < m_net.colours[field.colour].width; ++i) {
          words.push_back(start + field.offset + i);
        }
      } else {
        addMeasured(field.colour, start + field.offset, words);
      }
    }
  }

  void findUrgent() {
    std::vector<bool> isTimed(m_net.places.size());
    for (std::size_t i = 0; i < m_net.places.size(); ++i) {
      isTimed[i] = std::any_of(m_net.places[i].initial.begin(), m_net.places[i].initial.end(),
                               [](const Token& token) { return token.time > 0; });
    }
    for (const Transition& transition : m_net.transitions) {
      for (const OutputArc& arc : transition.outputs) {
        isTimed[arc.place] = isTimed[arc.place] || arc.hasDelay;
      }
    }
    for (std::size_t i = 0; i < m_net.transitions.size(); ++i) {
      m_isUrgent[i] = !m_net.transitions[i].asksTime;
      for (const InputArc& arc : m_net.transitions[i].inputs) {
        m_isUrgent[i] = m_isUrgent[i] && (arc.isEarly || !isTimed[arc.place]);
      }
    }
  }

  [[nodiscard]] Words encode() {
    Words state;
    for (std::size_t place = 0; place < m_marking.size(); ++place) {
      const Colour& colour = m_net.colours[m_net.places[place].colour];
      const std::vector<std::size_t>& measured = m_measured[m_net.places[place].colour];
      std::vector<Token>& tokens = m_marking[place];
      for (Token& token : tokens) {
        const bool isList = colour.kind == ColourKind::List;
        const Word items = isList ? token.value[0] : 1;
        for (Word item = 0; item < items && !measured.empty(); ++item) {
          const std::size_t start =
              isList ? 1 + static_cast<std::size_t>(item) * colour.width : std::size_t{0};
          for (const std::size_t word : measured) {
            token.value[start + word] = 0;
          }
        }
      }
      std::sort(tokens.begin(), tokens.end(),
                [](const Token& a, const Token& b) { return a.value < b.value; });
      state.push_back(static_cast<Word>(tokens.size()));
      for (const Token& token : tokens) {
        state.insert(state.end(), token.value.begin(), token.value.end());
      }
    }
    return state;
  }

  void decode(const Words& state) {
    std::size_t at = 0;
    for (std::size_t place = 0; place < m_marking.size(); ++place) {
      std::vector<Token>& tokens = m_marking[place];
      tokens.resize(static_cast<std::size_t>(state[at++]));
      for (Token& token : tokens) {
        const std::size_t size = m_net.sizeOf(m_net.places[place].colour, &state[at]);
        token.time = 0;
        token.value.assign(&state[at], &state[at] + size);
        at += size;
      }
    }
  }

  static std::size_t bytesOf(const Words& state) {
    return sizeof(Words) + state.capacity() * sizeof(Word);
  }

  void add() {
    Words state = encode();
    std::uint64_t hash = base::kHashBasis;
    for (const Word word : state) {
      hash = (hash ^ static_cast<std::uint64_t>(word)) * base::kHashPrime;
      hash ^= hash >> 32U;
    }
    if (m_known.insert(hash).second) {
      m_openBytes += bytesOf(state);
      m_open.push_back(std::move(state));
    }
  }

  void inspect() {
    const bool isFirst = m_inspected++ == 0;
    for (std::size_t place = 0; place < m_marking.size(); ++place) {
      const std::vector<Token>& tokens = m_marking[place];
      PlaceBounds& bounds = m_space.bounds[place];
      bounds.tokensMin = isFirst ? tokens.size() : std::min(bounds.tokensMin, tokens.size());
      bounds.tokensMax = std::max(bounds.tokensMax, tokens.size());
      const ColourKind kind = m_net.colours[m_net.places[place].colour].kind;
      if (kind != ColourKind::Int && kind != ColourKind::List) {
        continue;
      }
      for (const Token& token : tokens) {
        bounds.valueMin =
            bounds.hasValues ? std::min(bounds.valueMin, token.value[0]) : token.value[0];
        bounds.valueMax =
            bounds.hasValues ? std::max(bounds.valueMax, token.value[0]) : token.value[0];
        bounds.hasValues = true;
      }
    }
    for (std::size_t i = 0; i < m_holds.size(); ++i) {
      m_holds[i] = m_holds[i] && m_evaluator.scalar(m_net.invariants[i].condition, {}) != 0;
    }
    m_evaluator.release();
  }

  /// Fires all that a timed run could fire next.
  void follow(const Words& state) {
    struct Choice {
      std::size_t transition;
      Binding binding;
    };
    std::vector<Choice> choices;
    std::vector<Binding> bindings;
    int urgent = std::numeric_limits<int>::max();
    for (std::size_t i = 0; i < m_net.transitions.size(); ++i) {
      m_binder.all(m_net.transitions[i], bindings);
      for (const Binding& binding : bindings) {
        choices.push_back({i, binding});
      }
      if (!bindings.empty() && m_isUrgent[i]) {
        urgent = std::min(urgent, m_net.transitions[i].priority);
      }
    }
    if (choices.empty() && m_space.deadlocks++ == 0) {
      describeDeadlock();
    }
    for (const Choice& choice : choices) {
      const Transition& transition = m_net.transitions[choice.transition];
      if (transition.priority > urgent) {
        continue;
      }
      decode(state);
      m_firer.fire(transition, choice.binding, m_binder.frameOf(transition, choice.binding), 0,
                   [](std::size_t, const Words&, Word) {});
      ++m_space.firings;
      ++m_space.fired[choice.transition];
      add();
    }
  }

  void describeDeadlock() {
    for (std::size_t place = 0; place < m_marking.size(); ++place) {
      for (const Token& token : m_marking[place]) {
        m_space.deadlock +=
            fmt::format("{}{}: {}", m_space.deadlock.empty() ? "" : "; ", m_net.places[place].name,
                        m_net.textOf(m_net.places[place].colour, token.value.data()));
      }
    }
  }

  const Net& m_net;
  StateSpaceOptions m_options;
  Marking m_marking;
  Evaluator m_evaluator;
  Binder m_binder;
  Firer m_firer;
  std::vector<std::vector<std::size_t>> m_measured;  ///< by colour set
  std::vector<bool> m_isUrgent;
  std::vector<bool> m_holds;
  std::unordered_set<std::uint64_t> m_known;
  std::deque<Words> m_open;
  std::size_t m_openBytes = 0;
  std::size_t m_inspected = 0;
  StateSpace m_space;
};

}  // namespace

base::Result<StateSpace> exploreStates(const Net& net, const StateSpaceOptions& options) {
  return Explorer(net, options).explore();
}

}  // namespace rivulet::petri
