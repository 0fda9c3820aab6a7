// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "petri/expression.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "base/text.h"

namespace rivulet::petri {

bool fits(const Net& net, ColourId value, ColourId expected) {
  return value == expected || (value == kAnyList && net.colours[expected].kind == ColourKind::List);
}

namespace {

/// Operators between two values; a higher level binds closer.
struct Operator {
  std::string_view word;
  Op op;
  int level;
  bool swapped = false;
};
constexpr std::array<Operator, 13> kOperators{{{"orelse", Op::Or, 0},
                                               {"andalso", Op::And, 1},
                                               {"=", Op::Equal, 2},
                                               {"<>", Op::NotEqual, 2},
                                               {"<", Op::Less, 2},
                                               {"<=", Op::LessEqual, 2},
                                               {">", Op::Less, 2, true},
                                               {">=", Op::LessEqual, 2, true},
                                               {"+", Op::Add, 3},
                                               {"-", Op::Subtract, 3},
                                               {"*", Op::Multiply, 4},
                                               {"div", Op::Divide, 4},
                                               {"mod", Op::Modulo, 4}}};
constexpr int kLevels = 5;

/// One expression, read from left to right; the first fault is kept and ends the reading.
class ExpressionParser {
 public:
  ExpressionParser(Net& net, const Scope& scope, std::string_view text)
      : m_net(net), m_scope(scope), m_text(text) {
    advance();
  }

  base::Result<NodeId> parse() {
    const NodeId root = expression();
    if (!m_error && !m_word.empty()) {
      failNow(PetriError::NotANet, fmt::format("\"{}\" is not expected here", m_word));
    }
    if (m_error) {
      return base::fail(*m_error);
    }
    return root;
  }

 private:
  static constexpr int kDepthMax = 200;

  // --- words --------------------------------------------------------------------------------
  void advance() {
    while (m_at < m_text.size() && (base::isBlank(m_text[m_at]) || m_text[m_at] == '\n')) {
      ++m_at;
    }
    const std::size_t begin = m_at;
    if (m_at == m_text.size()) {
      m_word = {};
      return;
    }
    const char first = m_text[m_at++];
    const auto at = [&](std::size_t i) { return i < m_text.size() ? m_text[i] : '\0'; };
    if (base::isNameLetter(first)) {
      while (base::isNameLetter(at(m_at)) || base::isDigit(at(m_at))) {
        ++m_at;
      }
    } else if (base::isDigit(first)) {
      while (base::isDigit(at(m_at))) {
        ++m_at;
      }
    } else if (first == '"') {
      while (m_at < m_text.size() && m_text[m_at] != '"') {
        ++m_at;
      }
      if (m_at == m_text.size()) {
        failNow(PetriError::NotANet, "a text is not closed by \"");
      } else {
        ++m_at;
      }
    } else if ((first == '<' && (at(m_at) == '=' || at(m_at) == '>')) ||
               (first == '>' && at(m_at) == '=')) {
      ++m_at;
    }
    m_word = m_text.substr(begin, m_at - begin);
  }
  bool take(std::string_view word) {
    if (m_error || m_word != word) {
      return false;
    }
    advance();
    return true;
  }
  void expect(std::string_view word) {
    if (!take(word)) {
      failNow(PetriError::NotANet,
              fmt::format("\"{}\" is expected {}", word,
                          m_word.empty() ? "at the end" : fmt::format("before \"{}\"", m_word)));
    }
  }

  // --- nodes --------------------------------------------------------------------------------
  void failNow(PetriError code, std::string message) {
    if (!m_error) {
      m_error = base::makeError(code, fmt::format("{} in \"{}\".", message, m_text));
      m_word = {};
    }
  }
  NodeId add(Node node) {
    m_net.nodes.push_back(std::move(node));
    return static_cast<NodeId>(m_net.nodes.size() - 1);
  }
  NodeId make(Op op, ColourId colour, std::vector<NodeId> operands, std::uint32_t index = 0) {
    Node node;
    node.op = op;
    node.colour = colour;
    node.operands = std::move(operands);
    node.index = index;
    return add(std::move(node));
  }
  NodeId constant(Word value, ColourId colour) {
    Node node;
    node.value = value;
    node.colour = colour;
    return add(std::move(node));
  }
  [[nodiscard]] ColourId colourOf(NodeId node) const { return m_net.nodes[node].colour; }
  [[nodiscard]] const std::string& nameOf(ColourId colour) const {
    return m_net.colours[colour].name;
  }
  void need(NodeId node, ColourId colour, std::string_view what) {
    if (!m_error && !fits(m_net, colourOf(node), colour)) {
      failNow(PetriError::WrongColour, fmt::format("{} is a value of {}, but {} is needed", what,
                                                   nameOf(colourOf(node)), nameOf(colour)));
    }
  }

  // --- grammar ------------------------------------------------------------------------------
  NodeId expression() {
    if (++m_depth > kDepthMax) {
      failNow(PetriError::NotANet, "the nesting is too deep");
    }
    NodeId result = 0;
    if (take("if")) {
      const NodeId condition = expression();
      need(condition, kBool, "the condition of \"if\"");
      expect("then");
      const NodeId yes = expression();
      expect("else");
      const NodeId no = expression();
      if (!m_error) {
        const ColourId colour = colourOf(yes) == kAnyList ? colourOf(no) : colourOf(yes);
        need(no, colour, "the value after \"else\"");
        result = make(Op::If, colour, {condition, yes, no});
      }
    } else {
      result = binary(0);
    }
    --m_depth;
    return m_error ? 0 : result;
  }

  NodeId binary(int level) {
    if (level == kLevels) {
      return unary();
    }
    NodeId left = binary(level + 1);
    for (;;) {
      const auto* const found =
          std::find_if(kOperators.begin(), kOperators.end(), [&](const Operator& candidate) {
            return candidate.level == level && candidate.word == m_word;
          });
      if (m_error || found == kOperators.end()) {
        return left;
      }
      advance();
      NodeId right = binary(level + 1);
      if (m_error) {
        return 0;
      }
      const bool isLogic = level < 2;
      const bool compares = level == 2;
      const bool isEquality = found->op == Op::Equal || found->op == Op::NotEqual;
      need(left,
           isLogic      ? kBool
           : isEquality ? colourOf(left)
                        : kInt,
           fmt::format("the left side of \"{}\"", found->word));
      need(right,
           isLogic      ? kBool
           : isEquality ? colourOf(left)
                        : kInt,
           fmt::format("the right side of \"{}\"", found->word));
      if (isEquality && m_net.colours[colourOf(left)].kind == ColourKind::List) {
        failNow(PetriError::WrongColour, "lists cannot be compared");
      }
      if (found->swapped) {
        std::swap(left, right);
      }
      left = make(found->op, isLogic || compares ? kBool : kInt, {left, right});
    }
  }

  NodeId unary() {
    if (take("-")) {
      const NodeId operand = unary();
      need(operand, kInt, "what follows \"-\"");
      return make(Op::Negate, kInt, {operand});
    }
    if (take("not")) {
      const NodeId operand = unary();
      need(operand, kBool, "what follows \"not\"");
      return make(Op::Not, kBool, {operand});
    }
    NodeId value = primary();
    while (!m_error) {
      if (take(".")) {
        value = member(value);
      } else if (m_word == "{") {
        value = update(value);
      } else {
        break;
      }
    }
    return value;
  }

  const Field* field(ColourId colour) {
    const auto& fields = m_net.colours[colour].fields;
    const auto found = std::find_if(fields.begin(), fields.end(),
                                    [&](const Field& one) { return one.name == m_word; });
    if (found == fields.end()) {
      failNow(PetriError::Unknown, fmt::format("{} has no field \"{}\"", nameOf(colour), m_word));
      return nullptr;
    }
    return &*found;
  }

  NodeId member(NodeId record) {
    const Field* const found = field(colourOf(record));
    if (found == nullptr) {
      return 0;
    }
    const bool isMeasured = found->isMeasured;
    const NodeId node =
        make(Op::Member, found->colour, {record}, static_cast<std::uint32_t>(found->offset));
    m_net.nodes[node].isMeasured = isMeasured;
    advance();
    return node;
  }

  NodeId update(NodeId record) {
    const ColourId colour = colourOf(record);
    std::vector<NodeId> operands{record};
    std::vector<std::uint32_t> offsets;
    fieldValues(colour, [&](const Field& one, NodeId value) {
      offsets.push_back(static_cast<std::uint32_t>(one.offset));
      operands.push_back(value);
    });
    const NodeId node = make(Op::Update, colour, std::move(operands));
    m_net.nodes[node].offsets = std::move(offsets);
    return node;
  }

  NodeId construct(ColourId colour) {
    std::vector<NodeId> operands(m_net.colours[colour].fields.size());
    std::vector<bool> isSet(operands.size());
    fieldValues(colour, [&](const Field& one, NodeId value) {
      const auto index = static_cast<std::size_t>(&one - m_net.colours[colour].fields.data());
      operands[index] = value;
      isSet[index] = true;
    });
    for (std::size_t i = 0; i < isSet.size() && !m_error; ++i) {
      if (!isSet[i]) {
        failNow(PetriError::WrongColour,
                fmt::format("field \"{}\" of {} has no value", m_net.colours[colour].fields[i].name,
                            nameOf(colour)));
      }
    }
    return make(Op::Construct, colour, std::move(operands));
  }

  template <class Take>
  void fieldValues(ColourId colour, const Take& takeValue) {
    expect("{");
    do {
      const Field* const found = m_error ? nullptr : field(colour);
      if (found == nullptr) {
        return;
      }
      advance();
      expect("=");
      const NodeId value = expression();
      need(value, found->colour, fmt::format("the value of field \"{}\"", found->name));
      takeValue(*found, value);
    } while (take(","));
    expect("}");
  }

  NodeId primary() {
    if (m_error || m_word.empty()) {
      failNow(PetriError::NotANet, "a value is missing");
      return 0;
    }
    if (base::isDigit(m_word.front())) {
      return number();
    }
    if (m_word.front() == '"') {
      const std::string text(m_word.substr(1, m_word.size() - 2));
      advance();
      const auto found = std::find(m_net.texts.begin(), m_net.texts.end(), text);
      const auto index = found - m_net.texts.begin();
      if (found == m_net.texts.end()) {
        m_net.texts.push_back(text);
      }
      return constant(index, kString);
    }
    if (take("(")) {
      if (take(")")) {
        return constant(0, kUnit);
      }
      const NodeId inner = expression();
      expect(")");
      return inner;
    }
    if (take("[")) {
      expect("]");
      return constant(0, kAnyList);
    }
    if (base::isNameLetter(m_word.front())) {
      return named();
    }
    failNow(PetriError::NotANet, fmt::format("\"{}\" is not expected here", m_word));
    return 0;
  }

  NodeId number() {
    Word value = 0;
    for (const char digit : m_word) {
      if (value > Word{100'000'000'000'000'000}) {
        failNow(PetriError::NotANet, fmt::format("{} is too large", m_word));
        return 0;
      }
      value = 10 * value + (digit - '0');
    }
    advance();
    return constant(value, kInt);
  }

  NodeId named() {
    const std::string name(m_word);
    advance();
    if (name == "true" || name == "false") {
      return constant(name == "true" ? 1 : 0, kBool);
    }
    if (name == "now") {
      return make(Op::Now, kInt, {});
    }
    const auto& variables = m_scope.variables;
    for (std::size_t i = 0; i < variables.size(); ++i) {
      if (variables[i].name == name) {
        return make(Op::Variable, variables[i].colour, {}, static_cast<std::uint32_t>(i));
      }
    }
    if (const auto found = m_scope.constants.find(name); found != m_scope.constants.end()) {
      return found->second;
    }
    if (m_word == "(") {
      return call(name);
    }
    const auto& colours = m_net.colours;
    const auto colour = std::find_if(colours.begin(), colours.end(),
                                     [&](const Colour& one) { return one.name == name; });
    if (colour != colours.end() && colour->kind == ColourKind::Record) {
      return construct(static_cast<ColourId>(colour - colours.begin()));
    }
    failNow(PetriError::Unknown, fmt::format("\"{}\" is not known", name));
    return 0;
  }

  NodeId call(const std::string& name) {
    advance();
    if (name == "tokens") {
      return tokens();
    }
    std::size_t comparator = m_net.functions.size();
    if (name == "sort") {
      comparator = functionOf(std::string(m_word));
      advance();
      expect(",");
    }
    std::vector<NodeId> arguments;
    if (!take(")")) {
      do {
        arguments.push_back(expression());
      } while (take(","));
      expect(")");
    }
    if (m_error) {
      return 0;
    }
    if (const std::optional<NodeId> node = builtIn(name, arguments, comparator)) {
      return *node;
    }
    const std::size_t index = functionOf(name);
    if (m_error) {
      return 0;
    }
    const std::vector<ColourId> parameters = m_net.functions[index].parameters;
    count(name, arguments, parameters.size());
    for (std::size_t i = 0; i < arguments.size() && !m_error; ++i) {
      need(arguments[i], parameters[i], fmt::format("argument {} of \"{}\"", i + 1, name));
    }
    return m_error ? 0
                   : make(Op::Call, colourOf(m_net.functions[index].body), std::move(arguments),
                          static_cast<std::uint32_t>(index));
  }

  std::size_t functionOf(const std::string& name) {
    const auto& functions = m_net.functions;
    const auto found = std::find_if(functions.begin(), functions.end(),
                                    [&](const Function& one) { return one.name == name; });
    if (found == functions.end()) {
      failNow(PetriError::Unknown, fmt::format("function \"{}\" is not known", name));
    }
    return static_cast<std::size_t>(found - functions.begin());
  }

  void count(const std::string& name, const std::vector<NodeId>& arguments, std::size_t expected) {
    if (arguments.size() != expected) {
      failNow(PetriError::NotANet, fmt::format("\"{}\" has {} arguments, but needs {}", name,
                                               arguments.size(), expected));
    }
  }

  bool isList(const std::string& name, NodeId node) {
    if (m_net.colours[colourOf(node)].kind != ColourKind::List) {
      failNow(PetriError::WrongColour,
              fmt::format("\"{}\" needs a list, not a value of {}", name, nameOf(colourOf(node))));
    }
    return !m_error;
  }

  std::optional<NodeId> builtIn(const std::string& name, std::vector<NodeId>& arguments,
                                std::size_t comparator) {
    static const std::map<std::string, std::size_t> kArguments{
        {"head", 1}, {"tail", 1}, {"length", 1}, {"empty", 1},  {"ins", 2},
        {"sort", 1}, {"min", 2},  {"max", 2},    {"uniform", 2}};
    const auto known = kArguments.find(name);
    if (known == kArguments.end()) {
      return std::nullopt;
    }
    const bool sorts = name == "sort";
    if (!sorts || arguments.empty()) {
      count(name, arguments, known->second);
    }
    if (m_error) {
      return 0;
    }
    if (name == "min" || name == "max" || name == "uniform") {
      need(arguments[0], kInt, fmt::format("argument 1 of \"{}\"", name));
      need(arguments[1], kInt, fmt::format("argument 2 of \"{}\"", name));
      if (name == "uniform") {
        return make(Op::Uniform, kInt, std::move(arguments));
      }
      const NodeId less = make(Op::Less, kBool, arguments);
      return name == "min" ? make(Op::If, kInt, {less, arguments[0], arguments[1]})
                           : make(Op::If, kInt, {less, arguments[1], arguments[0]});
    }
    const NodeId list = arguments[0];
    if (!isList(name, list)) {
      return 0;
    }
    const ColourId colour = colourOf(list);
    const ColourId element = m_net.colours[colour].element;
    if (name == "head") {
      return make(Op::Head, element, {list});
    }
    if (name == "tail") {
      return make(Op::Tail, colour, {list});
    }
    if (name == "length" || name == "empty") {
      const NodeId length = make(Op::Length, kInt, {list});
      return name == "length" ? length : make(Op::Equal, kBool, {length, constant(0, kInt)});
    }
    if (name == "ins") {
      need(arguments[1], element, "the element to insert");
      return make(Op::Append, colour, std::move(arguments));
    }
    const Function& compares = m_net.functions[comparator];
    std::vector<ColourId> needed{element, element};
    for (std::size_t i = 1; i < arguments.size(); ++i) {
      needed.push_back(colourOf(arguments[i]));
    }
    if (compares.parameters != needed || colourOf(compares.body) != kBool) {
      failNow(PetriError::WrongColour,
              fmt::format("function \"{}\" does not compare two values of {} with these arguments",
                          compares.name, nameOf(element)));
    }
    return make(Op::Sort, colour, std::move(arguments), static_cast<std::uint32_t>(comparator));
  }

  /// tokens(Place) or tokens(Place, field, value): of these only.
  NodeId tokens() {
    std::string name;
    while (!m_word.empty() && m_word != "," && m_word != ")") {
      name += m_word;
      advance();
    }
    const auto found = m_scope.places.find(name);
    if (found == m_scope.places.end()) {
      failNow(PetriError::Unknown, fmt::format("place \"{}\" is not known", name));
      return 0;
    }
    std::vector<NodeId> operands;
    std::vector<std::uint32_t> offsets;
    if (take(",")) {
      const Colour& set = m_net.colours[m_net.places[found->second].colour];
      const ColourId record =
          set.kind == ColourKind::List ? set.element : m_net.places[found->second].colour;
      const Field* const chosen = field(record);
      if (chosen == nullptr) {
        return 0;
      }
      offsets.push_back(static_cast<std::uint32_t>(chosen->offset));
      advance();
      expect(",");
      operands.push_back(expression());
    }
    expect(")");
    if (m_error) {
      return 0;
    }
    const NodeId node =
        make(Op::Tokens, kInt, std::move(operands), static_cast<std::uint32_t>(found->second));
    m_net.nodes[node].offsets = std::move(offsets);
    return node;
  }

  Net& m_net;
  const Scope& m_scope;
  std::string_view m_text;
  std::string_view m_word;
  std::size_t m_at = 0;
  int m_depth = 0;
  std::optional<base::Error> m_error;
};

}  // namespace

base::Result<NodeId> parseExpression(Net& net, const Scope& scope, std::string_view text) {
  return ExpressionParser(net, scope, text).parse();
}

base::Result<void> parseFunction(Net& net, const Scope& scope, std::string_view text) {
  const auto wrong = [&] {
    return base::fail(PetriError::NotANet,
                      fmt::format("A function is written \"fun name(a:INT, b:INT) = expression\", "
                                  "not \"{}\".",
                                  text));
  };
  const std::size_t open = text.find('(');
  const std::size_t close = text.find(')');
  const std::size_t equals = text.find('=', close == std::string_view::npos ? 0 : close);
  if (!text.starts_with("fun ") || open == std::string_view::npos ||
      close == std::string_view::npos || close < open || equals == std::string_view::npos ||
      !base::trim(text.substr(close + 1, equals - close - 1)).empty()) {
    return wrong();
  }
  Function function;
  function.name = base::trim(text.substr(4, open - 4));
  Scope inner;
  inner.constants = scope.constants;
  std::string_view parameters = text.substr(open + 1, close - open - 1);
  while (!base::trim(parameters).empty()) {
    const std::size_t comma = std::min(parameters.find(','), parameters.size());
    const std::string_view one = parameters.substr(0, comma);
    parameters.remove_prefix(std::min(comma + 1, parameters.size()));
    const std::size_t colon = one.find(':');
    if (colon == std::string_view::npos) {
      return wrong();
    }
    const std::string colour(base::trim(one.substr(colon + 1)));
    const auto found = std::find_if(net.colours.begin(), net.colours.end(),
                                    [&](const Colour& set) { return set.name == colour; });
    if (found == net.colours.end()) {
      return base::fail(PetriError::Unknown,
                        fmt::format("Colour set \"{}\" is not known in \"{}\".", colour, text));
    }
    const auto id = static_cast<ColourId>(found - net.colours.begin());
    inner.variables.push_back({std::string(base::trim(one.substr(0, colon))), id});
    function.parameters.push_back(id);
  }
  if (inner.variables.size() > kVariablesMax) {
    return base::fail(PetriError::NotANet,
                      fmt::format("\"{}\" has more than {} parameters.", text, kVariablesMax));
  }
  auto body = parseExpression(net, inner, text.substr(equals + 1));
  if (!body) {
    return base::fail(body.error());
  }
  function.body = *body;
  net.functions.push_back(std::move(function));
  return {};
}

void splitConditions(const Net& net, NodeId condition, std::vector<NodeId>& parts) {
  const Node& node = net.nodes[condition];
  if (node.op == Op::And) {
    splitConditions(net, node.operands[0], parts);
    splitConditions(net, node.operands[1], parts);
  } else {
    parts.push_back(condition);
  }
}

void visitNodes(const Net& net, NodeId root, const std::function<void(const Node&)>& visit) {
  const Node& node = net.nodes[root];
  visit(node);
  for (const NodeId operand : node.operands) {
    visitNodes(net, operand, visit);
  }
  if (node.op == Op::Call || node.op == Op::Sort) {
    visitNodes(net, net.functions[node.index].body, [&](const Node& inner) {
      if (inner.op != Op::Variable) {
        visit(inner);
      }
    });
  }
}

}  // namespace rivulet::petri
