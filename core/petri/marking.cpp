// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "petri/marking.h"

#include <algorithm>

#include "base/contract.h"

namespace rivulet::petri {

Marking initialMarking(const Net& net) {
  Marking marking(net.places.size());
  for (std::size_t i = 0; i < marking.size(); ++i) {
    marking[i] = net.places[i].initial;
  }
  return marking;
}

// --- values ---------------------------------------------------------------------------------

Words& Evaluator::scratch() {
  if (m_used == m_scratch.size()) {
    m_scratch.emplace_back();
  }
  Words& words = m_scratch[m_used++];
  words.clear();
  return words;
}

const Word* Evaluator::locate(NodeId id, const Frame& frame) {
  const Node& node = m_net.nodes[id];
  switch (node.op) {
    case Op::Variable:
      return frame[node.index];
    case Op::Member:
      return locate(node.operands[0], frame) + node.index;
    case Op::Head: {
      const Word* const list = locate(node.operands[0], frame);
      RIVULET_ASSERT(list[0] >= 0);
      return list + 1;
    }
    default: {
      Words& words = scratch();
      // A list may be read one element too far: the head of an empty one is zeros.
      evaluate(id, frame, words);
      words.resize(words.size() + m_net.colours[node.colour].width + 1);
      return words.data();
    }
  }
}

void Evaluator::fillFrame(const Node& call, const Frame& frame, Frame& inner) {
  for (std::size_t i = 0; i < call.operands.size(); ++i) {
    inner[i] = locate(call.operands[i], frame);
  }
}

Word Evaluator::scalar(NodeId id, const Frame& frame) {
  const Node& node = m_net.nodes[id];
  const auto left = [&] { return scalar(node.operands[0], frame); };
  const auto right = [&] { return scalar(node.operands[1], frame); };
  switch (node.op) {
    case Op::Constant:
      return node.value;
    case Op::Now:
      return m_now;
    case Op::Negate:
      return -left();
    case Op::Not:
      return left() == 0 ? 1 : 0;
    case Op::Add:
      return left() + right();
    case Op::Subtract:
      return left() - right();
    case Op::Multiply:
      return left() * right();
    case Op::Divide:
    case Op::Modulo: {
      const Word number = left();
      const Word divisor = right();
      if (divisor == 0) {
        return 0;
      }
      const Word rest = ((number % divisor) + divisor) % divisor;
      return node.op == Op::Modulo ? rest : (number - rest) / divisor;
    }
    case Op::Less:
      return left() < right() ? 1 : 0;
    case Op::LessEqual:
      return left() <= right() ? 1 : 0;
    case Op::Equal:
    case Op::NotEqual: {
      const std::size_t width = m_net.colours[m_net.nodes[node.operands[0]].colour].width;
      bool isEqual = false;
      if (width == 1) {
        isEqual = left() == right();
      } else {
        const Word* const one = locate(node.operands[0], frame);
        isEqual = std::equal(one, one + width, locate(node.operands[1], frame));
      }
      return isEqual == (node.op == Op::Equal) ? 1 : 0;
    }
    case Op::And:
      return left() != 0 && right() != 0 ? 1 : 0;
    case Op::Or:
      return left() != 0 || right() != 0 ? 1 : 0;
    case Op::If:
      return scalar(node.operands[left() != 0 ? 1 : 2], frame);
    case Op::Call: {
      Frame inner;
      fillFrame(node, frame, inner);
      return scalar(m_net.functions[node.index].body, inner);
    }
    case Op::Length:
      return *locate(node.operands[0], frame);
    case Op::Uniform: {
      const Word low = left();
      const Word high = right();
      return m_random == nullptr || high <= low
                 ? low
                 : low + static_cast<Word>(
                             m_random->below(static_cast<std::uint64_t>(high - low) + 1));
    }
    case Op::Tokens:
      return countTokens(node, frame);
    default:
      return *locate(id, frame);
  }
}

Word Evaluator::countTokens(const Node& node, const Frame& frame) {
  const Place& place = m_net.places[node.index];
  const Colour& colour = m_net.colours[place.colour];
  const bool isList = colour.kind == ColourKind::List;
  const bool chooses = !node.operands.empty();
  const Word wanted = chooses ? scalar(node.operands[0], frame) : 0;
  Word count = 0;
  for (const Token& token : m_marking[node.index]) {
    const Word items = isList ? token.value[0] : 1;
    for (Word i = 0; i < items; ++i) {
      const std::size_t start = isList ? 1 + static_cast<std::size_t>(i) * colour.width : 0;
      count += !chooses || token.value[start + node.offsets[0]] == wanted ? 1 : 0;
    }
  }
  return count;
}

void Evaluator::evaluate(NodeId id, const Frame& frame, Words& out) {
  const Node& node = m_net.nodes[id];
  switch (node.op) {
    case Op::Construct:
      for (const NodeId operand : node.operands) {
        evaluate(operand, frame, out);
      }
      return;
    case Op::Update: {
      const std::size_t start = out.size();
      evaluate(node.operands[0], frame, out);
      for (std::size_t i = 0; i < node.offsets.size(); ++i) {
        const NodeId operand = node.operands[i + 1];
        if (m_net.colours[m_net.nodes[operand].colour].width == 1) {
          out[start + node.offsets[i]] = scalar(operand, frame);
        } else {
          const Word* const value = locate(operand, frame);
          std::copy_n(value, m_net.colours[m_net.nodes[operand].colour].width,
                      out.begin() + static_cast<std::ptrdiff_t>(start + node.offsets[i]));
        }
      }
      return;
    }
    case Op::If:
      evaluate(node.operands[scalar(node.operands[0], frame) != 0 ? 1 : 2], frame, out);
      return;
    case Op::Call: {
      Frame inner;
      fillFrame(node, frame, inner);
      evaluate(m_net.functions[node.index].body, inner, out);
      return;
    }
    case Op::Tail: {
      const Word* const list = locate(node.operands[0], frame);
      const std::size_t width = m_net.colours[node.colour].width;
      const Word rest = std::max<Word>(list[0] - 1, 0);
      out.push_back(rest);
      out.insert(out.end(), list + 1 + width,
                 list + 1 + width + width * static_cast<std::size_t>(rest));
      return;
    }
    case Op::Append: {
      const std::size_t start = out.size();
      evaluate(node.operands[0], frame, out);
      ++out[start];
      evaluate(node.operands[1], frame, out);
      return;
    }
    case Op::Sort:
      sort(node, frame, out);
      return;
    case Op::Variable:
    case Op::Member:
    case Op::Head: {
      const Word* const words = locate(id, frame);
      out.insert(out.end(), words, words + m_net.sizeOf(node.colour, words));
      return;
    }
    default:
      out.push_back(scalar(id, frame));
  }
}

/// By insertion: lists are short, and all but the last element are in order already.
void Evaluator::sort(const Node& node, const Frame& frame, Words& out) {
  const std::size_t start = out.size();
  evaluate(node.operands[0], frame, out);
  const std::size_t width = m_net.colours[node.colour].width;
  Word* const items = out.data() + start + 1;
  const auto count = static_cast<std::size_t>(out[start]);
  const NodeId body = m_net.functions[node.index].body;
  Frame pair;
  for (std::size_t i = 1; i < node.operands.size(); ++i) {
    pair[i + 1] = locate(node.operands[i], frame);
  }
  for (std::size_t i = 1; i < count; ++i) {
    for (std::size_t k = i; k > 0; --k) {
      Word* const later = items + k * width;
      pair[0] = later;
      pair[1] = later - width;
      if (scalar(body, pair) == 0) {
        break;
      }
      std::swap_ranges(later, later + width, later - width);
    }
  }
}

// --- bindings -------------------------------------------------------------------------------

bool Binder::holds(const std::vector<NodeId>& guards) {
  return std::all_of(guards.begin(), guards.end(),
                     [&](NodeId guard) { return m_evaluator.scalar(guard, m_frame) != 0; });
}

/// Tries the tokens of one arc after another. `found` returns true to end the search.
template <class Found>
bool Binder::search(const Transition& transition, std::size_t arc, Word time, const Found& found) {
  if (arc == transition.inputs.size()) {
    if (m_isTimed && transition.asksTime) {
      m_evaluator.setNow(time);
      for (const InputArc& input : transition.inputs) {
        if (!holds(input.timedGuards)) {
          return false;
        }
      }
    }
    m_binding.time = time;
    return found(m_binding);
  }
  const InputArc& input = transition.inputs[arc];
  const std::vector<Token>& tokens = m_marking[input.place];
  for (std::uint32_t i = 0; i < tokens.size(); ++i) {
    const Token& token = tokens[i];
    const Word ready = m_isTimed && !input.isEarly ? std::max(time, token.time) : time;
    if (ready >= m_bound) {
      continue;
    }
    bool isTaken = false;
    for (std::size_t before = 0; before < arc && !isTaken; ++before) {
      isTaken = transition.inputs[before].place == input.place && m_binding.tokens[before] == i;
    }
    if (isTaken) {
      continue;
    }
    if (input.binds) {
      m_frame[input.variable] = token.value.data();
    } else if (m_evaluator.scalar(input.value, m_frame) != token.value[0]) {
      continue;
    }
    if (!holds(input.guards)) {
      continue;
    }
    m_binding.tokens[arc] = i;
    if (search(transition, arc + 1, ready, found)) {
      return true;
    }
  }
  return false;
}

Binding Binder::earliest(const Transition& transition, Word now) {
  Binding best;
  for (const InputArc& input : transition.inputs) {
    if (m_marking[input.place].empty()) {
      return best;
    }
  }
  m_bound = kNever;
  m_evaluator.setNow(now);
  if (holds(transition.guards)) {
    search(transition, 0, now, [&](const Binding& binding) {
      best = binding;
      m_bound = binding.time;
      return binding.time <= now;
    });
  }
  m_evaluator.release();
  return best;
}

void Binder::all(const Transition& transition, std::vector<Binding>& bindings) {
  m_bound = kNever;
  bindings.clear();
  if (!holds(transition.guards)) {
    return;
  }
  search(transition, 0, 0, [&](const Binding& binding) {
    const bool isKnown = std::any_of(bindings.begin(), bindings.end(), [&](const Binding& earlier) {
      for (std::size_t i = 0; i < transition.inputs.size(); ++i) {
        const auto& tokens = m_marking[transition.inputs[i].place];
        if (tokens[earlier.tokens[i]].value != tokens[binding.tokens[i]].value) {
          return false;
        }
      }
      return true;
    });
    if (!isKnown) {
      bindings.push_back(binding);
    }
    return false;
  });
  m_evaluator.release();
}

std::optional<Binding> Binder::firstAccepted(
    const Transition& transition, Word now,
    const std::function<bool(const Evaluator::Frame&)>& accepts) {
  std::optional<Binding> first;
  m_bound = now + 1;
  m_evaluator.setNow(now);
  if (holds(transition.guards)) {
    search(transition, 0, now, [&](const Binding& binding) {
      if (accepts(m_frame)) {
        first = binding;
      }
      return first.has_value();
    });
  }
  m_evaluator.release();
  return first;
}

Evaluator::Frame Binder::frameOf(const Transition& transition, const Binding& binding) const {
  Evaluator::Frame frame{};
  for (std::size_t i = 0; i < transition.inputs.size(); ++i) {
    const InputArc& input = transition.inputs[i];
    if (input.binds) {
      frame[input.variable] = m_marking[input.place][binding.tokens[i]].value.data();
    }
  }
  return frame;
}

// --- firing ---------------------------------------------------------------------------------

void Firer::produce(const Transition& transition, Evaluator::Frame frame, Word now) {
  m_evaluator.setNow(now);
  std::size_t variable = 0;
  for (const InputArc& input : transition.inputs) {
    variable += input.binds ? 1 : 0;
  }
  for (const NodeId value : transition.lets) {
    frame[variable] = m_evaluator.locate(value, frame);
    ++variable;
  }
  m_made.resize(std::max(m_made.size(), transition.outputs.size()));
  for (std::size_t i = 0; i < transition.outputs.size(); ++i) {
    const OutputArc& output = transition.outputs[i];
    Token& token = m_made[i];
    if (!m_pool.empty()) {
      token.value = std::move(m_pool.back());
      m_pool.pop_back();
    }
    token.value.clear();
    m_evaluator.evaluate(output.value, frame, token.value);
    token.time = now;
    if (output.hasDelay) {
      token.time += std::max<Word>(m_evaluator.scalar(output.delay, frame), 0);
    }
  }
  m_evaluator.release();
}

void Firer::consume(const Transition& transition, const Binding& binding) {
  for (std::size_t i = 0; i < transition.inputs.size(); ++i) {
    const std::size_t place = transition.inputs[i].place;
    std::size_t index = binding.tokens[i];
    // Tokens of the same place that are gone already have moved it.
    for (std::size_t before = 0; before < i; ++before) {
      if (transition.inputs[before].place == place && binding.tokens[before] < binding.tokens[i]) {
        --index;
      }
    }
    std::vector<Token>& tokens = m_marking[place];
    recycle(std::move(tokens[index].value));
    tokens.erase(tokens.begin() + static_cast<std::ptrdiff_t>(index));
  }
}

}  // namespace rivulet::petri
