// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "petri/marking.h"

#include <algorithm>

#include "base/budget.h"
#include "base/contract.h"

namespace rivulet::petri {

Marking initialMarking(const Net& net) {
  Marking marking(net.places.size());
  for (std::size_t i = 0; i < marking.size(); ++i) {
    marking[i] = net.places[i].initial;
  }
  return marking;
}

std::size_t memoryBytes(const Marking& marking) {
  std::size_t bytes = 0;
  for (const std::vector<Token>& tokens : marking) {
    constexpr std::size_t kPieceBytes = 24;  // what each piece of memory takes besides
    bytes += base::Budget::bytesOf(tokens, tokens.size() / 4);
    for (const Token& token : tokens) {
      bytes += token.value.capacity() * sizeof(Word) + kPieceBytes;
    }
  }
  return bytes;
}

// --- compiling ------------------------------------------------------------------------------

namespace {

/// Cheap enough to be worked out again wherever an argument stands.
constexpr std::uint32_t kCheap = 4;
/// Beyond it functions are called.
constexpr std::size_t kProgramMax = 20'000;

/// How often a variable stands in an expression.
std::size_t usesOf(const Net& net, NodeId id, std::uint32_t variable) {
  const Node& node = net.nodes[id];
  std::size_t uses = node.op == Op::Variable && node.index == variable ? 1 : 0;
  for (const NodeId operand : node.operands) {
    uses += usesOf(net, operand, variable);
  }
  return uses;
}

bool isSingle(const Colour& colour) {
  return colour.kind != ColourKind::List && colour.kind != ColourKind::Record;
}

/// Depends on its operands alone, which are one word each.
bool isPlain(Op op) {
  switch (op) {
    case Op::Negate:
    case Op::Not:
    case Op::Add:
    case Op::Subtract:
    case Op::Multiply:
    case Op::Divide:
    case Op::Modulo:
    case Op::Less:
    case Op::LessEqual:
    case Op::Equal:
    case Op::NotEqual:
    case Op::And:
    case Op::Or:
      return true;
    default:
      return false;
  }
}

}  // namespace

Evaluator::Code Evaluator::compileRoot(NodeId node) {
  const Code code = compile(node, nullptr);
  if (node >= m_codes.size()) {
    m_codes.resize(m_net.nodes.size(), kNoCode);
  }
  m_codes[node] = code;
  return code;
}

Evaluator::Code Evaluator::add(Instruction made, const std::vector<Code>& operands) {
  made.first = static_cast<std::uint32_t>(m_operands.size());
  made.count = static_cast<std::uint32_t>(operands.size());
  for (std::size_t i = 0; i < operands.size(); ++i) {
    if (i < kOperandsNear) {
      made.operands[i] = operands[i];
    }
    made.cost += m_program[operands[i]].cost;
    made.draws = made.draws || m_program[operands[i]].draws;
  }
  m_operands.insert(m_operands.end(), operands.begin(), operands.end());
  m_program.push_back(made);
  return static_cast<Code>(m_program.size() - 1);
}

Evaluator::Code Evaluator::compile(NodeId id, const std::vector<Code>* arguments) {
  const Node& node = m_net.nodes[id];
  if (node.op == Op::Variable && arguments != nullptr) {
    return (*arguments)[node.index];
  }
  std::vector<Code> operands;
  operands.reserve(node.operands.size());
  for (const NodeId operand : node.operands) {
    operands.push_back(compile(operand, arguments));
  }
  if (node.op == Op::Call) {
    return compileCall(node, operands);
  }
  const Colour& colour = m_net.colours[node.colour];
  Instruction made;
  made.op = node.op;
  made.isScalar = isSingle(colour);
  made.index = node.index;
  made.width = static_cast<std::uint32_t>(colour.width);
  made.colour = node.colour;
  made.value = node.value;
  made.draws = node.op == Op::Uniform;
  made.offsets = static_cast<std::uint32_t>(m_offsets.size());
  m_offsets.insert(m_offsets.end(), node.offsets.begin(), node.offsets.end());
  if (node.op == Op::Sort) {
    made.index = codeOf(m_net.functions[node.index].body);
    made.draws = m_program[made.index].draws;
  }
  if (const auto code = simplified(made, operands)) {
    return *code;
  }
  return add(made, operands);
}

/// The function itself in place of its call, unless that would work an argument out more than once.
Evaluator::Code Evaluator::compileCall(const Node& node, const std::vector<Code>& arguments) {
  const NodeId body = m_net.functions[node.index].body;
  bool isPutIn = m_program.size() < kProgramMax;
  for (std::size_t i = 0; i < arguments.size() && isPutIn; ++i) {
    const Instruction& argument = m_program[arguments[i]];
    isPutIn = !argument.draws &&
              (argument.cost <= kCheap || usesOf(m_net, body, static_cast<std::uint32_t>(i)) <= 1);
  }
  if (isPutIn) {
    return compile(body, &arguments);
  }
  const Colour& colour = m_net.colours[node.colour];
  Instruction made;
  made.op = Op::Call;
  made.isScalar = isSingle(colour);
  made.width = static_cast<std::uint32_t>(colour.width);
  made.colour = node.colour;
  made.index = codeOf(body);
  made.cost += m_program[made.index].cost;
  made.draws = m_program[made.index].draws;
  return add(made, arguments);
}

/// What takes no instruction of its own.
std::optional<Evaluator::Code> Evaluator::simplified(const Instruction& made,
                                                     const std::vector<Code>& operands) {
  const auto isConstant = [&](Code code) { return m_program[code].op == Op::Constant; };
  if (made.op == Op::If && isConstant(operands[0])) {
    return operands[m_program[operands[0]].value != 0 ? 1 : 2];
  }
  if (made.op == Op::Member &&
      (m_program[operands[0]].op == Op::Variable || m_program[operands[0]].op == Op::Head)) {
    Instruction part = m_program[operands[0]];
    part.offset += made.index;
    part.isScalar = made.isScalar;
    part.width = made.width;
    part.colour = made.colour;
    m_program.push_back(part);
    return static_cast<Code>(m_program.size() - 1);
  }
  if (isPlain(made.op) && std::all_of(operands.begin(), operands.end(), isConstant)) {
    Instruction constant;
    constant.isScalar = true;
    constant.colour = made.colour;
    constant.value = scalarOf(add(made, operands), {});
    return add(constant, {});
  }
  return std::nullopt;
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

const Word* Evaluator::find(Code code, const Frame& frame) {
  const Instruction& made = m_program[code];
  switch (made.op) {
    case Op::Variable:
      return frame[made.index] + made.offset;
    case Op::Member:
      return find(made.operands[0], frame) + made.index;
    case Op::Head: {
      const Word* const list = find(made.operands[0], frame);
      RIVULET_ASSERT(list[0] >= 0);
      return list + 1 + made.offset;
    }
    default: {
      if (made.isScalar) {
        const Word value = scalarOf(code, frame);
        if (m_scalarsUsed == m_scalars.size()) {
          m_scalars.emplace_back();
        }
        Word& kept = m_scalars[m_scalarsUsed++];
        kept = value;
        return &kept;
      }
      Words& words = scratch();
      // A list may be read one element too far: the head of an empty one is zeros.
      append(code, frame, words);
      words.resize(words.size() + made.width + 1);
      return words.data();
    }
  }
}

void Evaluator::fillFrame(const Instruction& call, const Frame& frame, Frame& inner) {
  for (std::size_t i = 0; i < call.count; ++i) {
    inner[i] = find(m_operands[call.first + i], frame);
  }
}

Word Evaluator::scalarOf(Code code, const Frame& frame) {
  const Instruction& made = m_program[code];
  const auto left = [&] { return scalarOf(made.operands[0], frame); };
  const auto right = [&] { return scalarOf(made.operands[1], frame); };
  switch (made.op) {
    case Op::Constant:
      return made.value;
    case Op::Variable:
      return frame[made.index][made.offset];
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
      return made.op == Op::Modulo ? rest : (number - rest) / divisor;
    }
    case Op::Less:
      return left() < right() ? 1 : 0;
    case Op::LessEqual:
      return left() <= right() ? 1 : 0;
    case Op::Equal:
    case Op::NotEqual: {
      const std::size_t width = m_program[made.operands[0]].width;
      bool isEqual = false;
      if (width == 1) {
        isEqual = left() == right();
      } else {
        const Word* const one = find(made.operands[0], frame);
        isEqual = std::equal(one, one + width, find(made.operands[1], frame));
      }
      return isEqual == (made.op == Op::Equal) ? 1 : 0;
    }
    case Op::And:
      return left() != 0 && right() != 0 ? 1 : 0;
    case Op::Or:
      return left() != 0 || right() != 0 ? 1 : 0;
    case Op::If:
      return scalarOf(made.operands[left() != 0 ? 1 : 2], frame);
    case Op::Call: {
      Frame inner;
      fillFrame(made, frame, inner);
      return scalarOf(made.index, inner);
    }
    case Op::Length:
      return *find(made.operands[0], frame);
    case Op::Uniform: {
      const Word low = left();
      const Word high = right();
      return m_random == nullptr || high <= low
                 ? low
                 : low + static_cast<Word>(
                             m_random->below(static_cast<std::uint64_t>(high - low) + 1));
    }
    case Op::Tokens:
      return countTokens(made, frame);
    default:
      return *find(code, frame);
  }
}

Word Evaluator::countTokens(const Instruction& made, const Frame& frame) {
  const Place& place = m_net.places[made.index];
  const Colour& colour = m_net.colours[place.colour];
  const bool isList = colour.kind == ColourKind::List;
  const bool chooses = made.count != 0;
  const Word wanted = chooses ? scalarOf(made.operands[0], frame) : 0;
  Word count = 0;
  for (const Token& token : m_marking[made.index]) {
    const Word items = isList ? token.value[0] : 1;
    for (Word i = 0; i < items; ++i) {
      const std::size_t start = isList ? 1 + static_cast<std::size_t>(i) * colour.width : 0;
      count += !chooses || token.value[start + m_offsets[made.offsets]] == wanted ? 1 : 0;
    }
  }
  return count;
}

void Evaluator::append(Code code, const Frame& frame, Words& out) {
  const Instruction& made = m_program[code];
  switch (made.op) {
    case Op::Construct:
      for (std::size_t i = 0; i < made.count; ++i) {
        append(m_operands[made.first + i], frame, out);
      }
      return;
    case Op::Update: {
      const std::size_t start = out.size();
      append(made.operands[0], frame, out);
      for (std::size_t i = 0; i + 1 < made.count; ++i) {
        const Code operand = m_operands[made.first + i + 1];
        const std::size_t at = start + m_offsets[made.offsets + i];
        const std::size_t width = m_program[operand].width;
        if (width == 1) {
          out[at] = scalarOf(operand, frame);
        } else {
          const Word* const value = find(operand, frame);
          std::copy_n(value, width, out.begin() + static_cast<std::ptrdiff_t>(at));
        }
      }
      return;
    }
    case Op::If:
      append(made.operands[scalarOf(made.operands[0], frame) != 0 ? 1 : 2], frame, out);
      return;
    case Op::Call: {
      Frame inner;
      fillFrame(made, frame, inner);
      append(made.index, inner, out);
      return;
    }
    case Op::Tail: {
      const Word* const list = find(made.operands[0], frame);
      const std::size_t width = made.width;
      const Word rest = std::max<Word>(list[0] - 1, 0);
      out.push_back(rest);
      out.insert(out.end(), list + 1 + width,
                 list + 1 + width + width * static_cast<std::size_t>(rest));
      return;
    }
    case Op::Append: {
      const std::size_t start = out.size();
      append(made.operands[0], frame, out);
      ++out[start];
      append(made.operands[1], frame, out);
      return;
    }
    case Op::Sort:
      sort(made, frame, out);
      return;
    case Op::Variable:
    case Op::Member:
    case Op::Head: {
      const Word* const words = find(code, frame);
      out.insert(out.end(), words, words + m_net.sizeOf(made.colour, words));
      return;
    }
    default:
      out.push_back(scalarOf(code, frame));
  }
}

/// By insertion: lists are short, and all but the last element are in order already.
void Evaluator::sort(const Instruction& made, const Frame& frame, Words& out) {
  const std::size_t start = out.size();
  append(made.operands[0], frame, out);
  const std::size_t width = made.width;
  Word* const items = out.data() + start + 1;
  const auto count = static_cast<std::size_t>(out[start]);
  Frame pair;
  for (std::size_t i = 1; i < made.count; ++i) {
    pair[i + 1] = find(m_operands[made.first + i], frame);
  }
  for (std::size_t i = 1; i < count; ++i) {
    for (std::size_t k = i; k > 0; --k) {
      Word* const later = items + k * width;
      pair[0] = later;
      pair[1] = later - width;
      if (scalarOf(made.index, pair) == 0) {
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
    m_evaluator.release();
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
