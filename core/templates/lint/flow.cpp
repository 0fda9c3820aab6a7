// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "templates/lint/flow.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <span>
#include <string_view>

#include "nc/eval/evaluate.h"

namespace rivulet::templates {

namespace {

using nc::Expression;
using nc::Statement;

/// More values than a loop over the cells of a control has passes.
constexpr std::size_t kValuesMax = 512;
constexpr std::size_t kCombinationsMax = 4096;

/// What stands for an unknown value: an R number computed from it differs from one to the other,
/// and no function of the language refuses them.
constexpr std::array<double, 2> kUnknowns{0.37, 0.93};

/// Answers with one value per followed variable and notes what was asked.
class Probe final : public nc::ValueSource {
 public:
  explicit Probe(double unknown) : m_unknown(unknown) {}

  std::map<std::string, double, std::less<>> chosen;
  mutable std::set<int> reads;
  mutable std::set<std::string, std::less<>> locals;
  mutable bool askedUnknown = false;

  [[nodiscard]] nc::Expected<double> r(int index) const override {
    reads.insert(index);
    askedUnknown = true;
    return m_unknown;
  }
  [[nodiscard]] nc::Expected<nc::Value> variable(std::string_view name,
                                                 std::span<const int> indices) const override {
    if (indices.empty()) {
      locals.emplace(name);
      if (const auto found = chosen.find(name); found != chosen.end()) {
        return found->second;
      }
    }
    askedUnknown = true;
    return m_unknown;
  }
  [[nodiscard]] nc::Expected<nc::Value> system(std::string_view,
                                               std::span<const nc::Value>) const override {
    askedUnknown = true;
    return m_unknown;
  }

 private:
  double m_unknown;
};

std::optional<double> valueOf(const Expression& expression, const Probe& probe) {
  const nc::Expected<double> value =
      nc::evaluateNumber(expression, probe, nc::sinumerikSemantics());
  if (!value && value.error().code == nc::FaultCode::NoSuchR && !probe.askedUnknown) {
    probe.reads.insert(-1);  // a number below 0, or far beyond any control's
  }
  return value ? std::optional(*value) : std::nullopt;
}

void joinInto(Environment& into, const std::map<std::string, double, std::less<>>& chosen) {
  for (const auto& [name, value] : chosen) {
    into[name].add(value);
  }
}

/// Asks once with every variable at `value`.
Probe asked(const Expression& expression, double value) {
  Probe probe(value);
  static_cast<void>(valueOf(expression, probe));
  return probe;
}

}  // namespace

void ValueSet::add(double value) {
  if (isUnknown) {
    return;
  }
  const auto at = std::lower_bound(values.begin(), values.end(), value);
  if (at != values.end() && *at == value) {
    return;
  }
  values.insert(at, value);
  if (values.size() > kValuesMax) {
    *this = unknown();
  }
}

bool ValueSet::join(const ValueSet& other) {
  if (isUnknown) {
    return false;
  }
  if (other.isUnknown) {
    *this = unknown();
    return true;
  }
  const std::size_t before = values.size();
  for (const double value : other.values) {
    add(value);
  }
  return isUnknown || values.size() != before;
}

bool Evaluation::asks(int cell) const {
  return std::binary_search(reads.begin(), reads.end(), cell);
}

Evaluation evaluate(const Expression& expression, const Environment& environment) {
  Evaluation evaluation;
  // The followed variables it may ask for.
  std::vector<std::string> names;
  std::set<int> reads;
  const auto fitsIn = [&](const std::string& slot) {
    const auto found = environment.find(slot);
    return found != environment.end() && !found->second.isUnknown && !found->second.values.empty();
  };
  for (const std::string& slot : asked(expression, 0.0).locals) {
    if (fitsIn(slot)) {
      names.push_back(slot);
    }
  }
  std::size_t combinations = 1;
  for (const std::string& slot : names) {
    combinations *= environment.at(slot).values.size();
    if (combinations > kCombinationsMax) {
      names.clear();
      combinations = 1;
      break;
    }
  }
  evaluation.whereTrue = environment;
  evaluation.whereFalse = environment;
  for (const std::string& slot : names) {
    evaluation.whereTrue[slot] = {};
    evaluation.whereFalse[slot] = {};
  }
  for (std::size_t number = 0; number < combinations; ++number) {
    std::map<std::string, double, std::less<>> chosen;
    std::size_t rest = number;
    for (const std::string& slot : names) {
      const std::vector<double>& values = environment.at(slot).values;
      chosen[slot] = values[rest % values.size()];
      rest /= values.size();
    }
    std::array<Probe, kUnknowns.size()> probes{Probe(kUnknowns[0]), Probe(kUnknowns[1])};
    std::optional<double> value;
    for (Probe& probe : probes) {
      probe.chosen = chosen;
      value = valueOf(expression, probe);
    }
    evaluation.hasUnknownIndex = evaluation.hasUnknownIndex || probes[0].reads != probes[1].reads;
    std::set_intersection(probes[0].reads.begin(), probes[0].reads.end(), probes[1].reads.begin(),
                          probes[1].reads.end(), std::inserter(reads, reads.end()));
    const bool isKnown = value && !probes[1].askedUnknown;
    if (isKnown) {
      evaluation.result.add(*value);
    } else {
      evaluation.result = ValueSet::unknown();
    }
    if (!isKnown || *value != 0.0) {
      evaluation.mayBeTrue = true;
      joinInto(evaluation.whereTrue, chosen);
    }
    if (!isKnown || *value == 0.0) {
      evaluation.mayBeFalse = true;
      joinInto(evaluation.whereFalse, chosen);
    }
  }
  evaluation.reads.assign(reads.begin(), reads.end());
  return evaluation;
}

std::vector<std::string> indexVariables(const nc::Tree& program) {
  std::set<std::string, std::less<>> followed;
  const auto follow = [&followed](const Probe& probe) {
    followed.insert(probe.locals.begin(), probe.locals.end());
  };
  std::set<std::string, std::less<>> arrays;
  for (const Statement& statement : program.statements) {
    nc::forEachExpression(statement, [&](const Expression& expression) {
      const Probe zeros = asked(expression, 0.0);
      if (zeros.reads != asked(expression, 1.0).reads) {
        follow(zeros);
      }
    });
    if (const auto* assignment = std::get_if<nc::Assignment>(&statement.what)) {
      if (assignment->target.op == nc::Op::R) {
        follow(asked(assignment->target.operands.front(), 0.0));
      }
    } else if (const auto* definition = std::get_if<nc::Definition>(&statement.what)) {
      if (!definition->sizes.empty()) {
        arrays.insert(definition->name);
      } else if (definition->name.starts_with("FOR ")) {
        followed.insert(definition->name);  // the limit of a loop
      }
    }
  }
  // What they are computed from has to be followed too.
  for (std::size_t before = 0; before != followed.size();) {
    before = followed.size();
    for (const Statement& statement : program.statements) {
      const auto* assignment = std::get_if<nc::Assignment>(&statement.what);
      if (assignment != nullptr && assignment->target.op == nc::Op::Variable &&
          followed.contains(assignment->target.name) && assignment->initial.values.front()) {
        follow(asked(*assignment->initial.values.front(), 0.0));
      }
    }
  }
  std::vector<std::string> names;
  std::set_difference(followed.begin(), followed.end(), arrays.begin(), arrays.end(),
                      std::back_inserter(names));
  return names;
}

Exits exitsOf(const nc::Tree& program, std::size_t statement) {
  const auto& what = program.statements[statement].what;
  Exits exits;
  const auto unless = [&](const std::optional<Expression>& condition) {
    exits.condition = condition ? &*condition : nullptr;
  };
  if (const auto* jump = std::get_if<nc::Jump>(&what)) {
    unless(jump->condition);
    exits.whenTrue = program.find(jump->label, jump->direction, statement);
    if (!exits.whenTrue && jump->direction == nc::JumpDirection::ForwardNoAlarm) {
      exits.whenTrue = statement + 1;
    }
    exits.misses = !exits.whenTrue;
    if (exits.condition != nullptr) {
      exits.whenFalse = statement + 1;
    }
  } else if (const auto* branch = std::get_if<nc::Branch>(&what)) {
    unless(branch->condition);
    if (exits.condition != nullptr) {
      exits.whenTrue = statement + 1;
      exits.whenFalse = branch->target;
    } else {
      exits.whenTrue = branch->target;
    }
  } else if (const auto* repeat = std::get_if<nc::RepeatLabel>(&what)) {
    exits.whenTrue = statement + 1;
    exits.whenFalse = program.find(repeat->label, nc::JumpDirection::Backward, statement);
    exits.misses = !exits.whenFalse;
  } else if (std::holds_alternative<nc::End>(what) || std::holds_alternative<nc::Return>(what) ||
             std::holds_alternative<nc::Faulty>(what)) {
    exits.ends = true;
  } else {
    exits.whenTrue = statement + 1;
  }
  return exits;
}

}  // namespace rivulet::templates
