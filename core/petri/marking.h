// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A marking, and what expressions and transitions are in it: values of expressions, and bindings,
/// the choices of tokens with which a transition can fire. Simulator and state space share it.
/// @threadsafety one object, one thread.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "base/random.h"
#include "petri/net.h"

namespace rivulet::petri {

/// Tokens of each place, in the order in which they came.
using Marking = std::vector<std::vector<Token>>;

[[nodiscard]] Marking initialMarking(const Net& net);
/// What its tokens take, bytes. O(tokens)
[[nodiscard]] std::size_t memoryBytes(const Marking& marking);

inline constexpr Word kNever = std::numeric_limits<Word>::max();

/// A token for each input arc of a transition.
struct Binding {
  Word time = kNever;  ///< from when on; kNever: there is none
  std::array<std::uint32_t, kVariablesMax> tokens{};
};

/// Evaluates expressions; keeps its memory from one to the next. An expression is compiled when it
/// is met first: functions are put in where they are called if no argument is worked out twice for
/// it, and what depends on constants alone is worked out.
class Evaluator {
 public:
  /// Values of the variables; not owned.
  using Frame = std::array<const Word*, kVariablesMax>;

  /// @param net  may get more nodes meanwhile
  /// @param random  for `uniform`; null: it gives its lower bound
  Evaluator(const Net& net, const Marking& marking, base::Random* random)
      : m_net(net), m_marking(marking), m_random(random) {}

  void setNow(Word now) { m_now = now; }
  /// A number, truth value or text.
  [[nodiscard]] Word scalar(NodeId node, const Frame& frame) {
    return scalarOf(codeOf(node), frame);
  }
  /// Appends the value.
  void evaluate(NodeId node, const Frame& frame, Words& out) { append(codeOf(node), frame, out); }
  /// Where the value is, without a copy if it exists already; valid until `release`.
  [[nodiscard]] const Word* locate(NodeId node, const Frame& frame) {
    return find(codeOf(node), frame);
  }
  /// Gives back the memory of earlier values that were not copied.
  void release() {
    m_used = 0;
    m_scalarsUsed = 0;
  }

 private:
  using Code = std::uint32_t;
  static constexpr Code kNoCode = std::numeric_limits<Code>::max();
  static constexpr std::size_t kOperandsNear = 3;

  /// A node as it is executed: in one piece.
  struct Instruction {
    Op op = Op::Constant;
    bool isScalar = false;     ///< neither a record nor a list
    std::uint32_t index = 0;   ///< as `Node::index`
    std::uint32_t offset = 0;  ///< Variable and Head: words from there
    std::uint32_t width = 1;   ///< words, of a list: of one element
    ColourId colour = kInt;
    Word value = 0;
    std::array<Code, kOperandsNear> operands{};  ///< the first ones
    std::uint32_t first = 0;                     ///< of all of them in `m_operands`
    std::uint32_t count = 0;
    std::uint32_t offsets = 0;  ///< Update, Tokens: first one in `m_offsets`
    std::uint32_t cost = 1;     ///< instructions that it takes
    bool draws = false;
  };

  [[nodiscard]] Code codeOf(NodeId node) {
    return node < m_codes.size() && m_codes[node] != kNoCode ? m_codes[node] : compileRoot(node);
  }
  Code compileRoot(NodeId node);
  /// @param arguments  what stands for the variables; null: themselves
  Code compile(NodeId node, const std::vector<Code>* arguments);
  Code compileCall(const Node& node, const std::vector<Code>& arguments);
  [[nodiscard]] std::optional<Code> simplified(const Instruction& made,
                                               const std::vector<Code>& operands);
  Code add(Instruction made, const std::vector<Code>& operands);

  [[nodiscard]] Word scalarOf(Code code, const Frame& frame);
  void append(Code code, const Frame& frame, Words& out);
  [[nodiscard]] const Word* find(Code code, const Frame& frame);
  Words& scratch();
  void fillFrame(const Instruction& call, const Frame& frame, Frame& inner);
  void sort(const Instruction& made, const Frame& frame, Words& out);
  [[nodiscard]] Word countTokens(const Instruction& made, const Frame& frame);

  const Net& m_net;
  const Marking& m_marking;
  base::Random* m_random;
  Word m_now = 0;
  std::vector<Code> m_codes;  ///< by node
  std::vector<Instruction> m_program;
  std::vector<Code> m_operands;
  std::vector<std::uint32_t> m_offsets;
  std::deque<Words> m_scratch;
  std::size_t m_used = 0;
  std::deque<Word> m_scalars;  ///< arguments of functions
  std::size_t m_scalarsUsed = 0;
};

/// Finds the bindings of transitions.
class Binder {
 public:
  /// @param isTimed  false: tokens are available at once and timed guards hold
  Binder(const Net& net, const Marking& marking, Evaluator& evaluator, bool isTimed)
      : m_net(net), m_marking(marking), m_evaluator(evaluator), m_isTimed(isTimed) {}

  /// The binding that is possible first; of several the first in the order of the tokens.
  [[nodiscard]] Binding earliest(const Transition& transition, Word now);
  /// All bindings; untimed. Those with equal tokens count once.
  void all(const Transition& transition, std::vector<Binding>& bindings);
  /// The first binding that is possible up to `now` and that `accepts` takes.
  [[nodiscard]] std::optional<Binding> firstAccepted(
      const Transition& transition, Word now,
      const std::function<bool(const Evaluator::Frame&)>& accepts);
  /// The values of the variables of a binding.
  [[nodiscard]] Evaluator::Frame frameOf(const Transition& transition,
                                         const Binding& binding) const;

 private:
  template <class Found>
  bool search(const Transition& transition, std::size_t arc, Word time, const Found& found);
  [[nodiscard]] bool holds(const std::vector<NodeId>& guards);

  const Net& m_net;
  const Marking& m_marking;
  Evaluator& m_evaluator;
  bool m_isTimed;
  Evaluator::Frame m_frame{};
  Binding m_binding;
  Word m_bound = kNever;  ///< only earlier bindings are of interest
};

/// Fires a transition: takes the tokens of a binding and puts the new ones.
class Firer {
 public:
  Firer(const Net& net, Marking& marking, Evaluator& evaluator)
      : m_net(net), m_marking(marking), m_evaluator(evaluator) {}

  /// @param record  called with place, value and time of each token of an observer place
  template <class Record>
  void fire(const Transition& transition, const Binding& binding, const Evaluator::Frame& frame,
            Word now, const Record& record) {
    produce(transition, frame, now);
    consume(transition, binding);
    for (std::size_t i = 0; i < transition.outputs.size(); ++i) {
      const std::size_t place = transition.outputs[i].place;
      Token& token = m_made[i];
      if (m_net.places[place].isObserver) {
        record(place, token.value, token.time);
        recycle(std::move(token.value));
      } else {
        m_marking[place].push_back(std::move(token));
      }
    }
  }

 private:
  void produce(const Transition& transition, Evaluator::Frame frame, Word now);
  void consume(const Transition& transition, const Binding& binding);
  void recycle(Words&& words) { m_pool.push_back(std::move(words)); }

  const Net& m_net;
  Marking& m_marking;
  Evaluator& m_evaluator;
  std::vector<Token> m_made;
  std::vector<Words> m_pool;  ///< memory of tokens that are gone
};

}  // namespace rivulet::petri
