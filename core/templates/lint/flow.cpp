// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "templates/lint/flow.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <set>

namespace rivulet::templates {

namespace {

using machine::Expression;
using machine::NcProgram;
using machine::Statement;

/// More values than a loop over the cells of a control has passes.
constexpr std::size_t kValuesMax = 512;
constexpr std::size_t kCombinationsMax = 4096;

/// What stands for an unknown value: an R number computed from it differs from one to the other,
/// and no function of the language refuses them.
constexpr std::array<double, 2> kUnknowns{0.37, 0.93};

/// Answers with one value per followed variable and notes what was asked.
class Probe final : public machine::ValueSource {
 public:
  explicit Probe(double unknown) : m_unknown(unknown) {}

  std::map<int, double> chosen;
  mutable std::set<int> reads;
  mutable std::set<int> locals;
  mutable bool askedUnknown = false;

  [[nodiscard]] std::optional<double> value(int index) const override {
    reads.insert(index);
    askedUnknown = true;
    return m_unknown;
  }
  [[nodiscard]] std::optional<double> local(int slot, int element) const override {
    if (element == 0) {
      locals.insert(slot);
      if (const auto found = chosen.find(slot); found != chosen.end()) {
        return found->second;
      }
    }
    askedUnknown = true;
    return m_unknown;
  }
  [[nodiscard]] std::optional<double> system(machine::SystemVariable, int) const override {
    askedUnknown = true;
    return m_unknown;
  }

 private:
  double m_unknown;
};

void joinInto(Environment& into, const std::map<int, double>& chosen) {
  for (const auto& [slot, value] : chosen) {
    into[slot].add(value);
  }
}

/// Asks once with every variable at `value`.
Probe asked(const Expression& expression, double value) {
  Probe probe(value);
  machine::Alarm alarm;
  static_cast<void>(expression.evaluate(probe, alarm));
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
  std::vector<int> slots;
  std::set<int> reads;
  const auto fitsIn = [&](int slot) {
    const auto found = environment.find(slot);
    return found != environment.end() && !found->second.isUnknown && !found->second.values.empty();
  };
  for (const int slot : asked(expression, 0.0).locals) {
    if (fitsIn(slot)) {
      slots.push_back(slot);
    }
  }
  std::size_t combinations = 1;
  for (const int slot : slots) {
    combinations *= environment.at(slot).values.size();
    if (combinations > kCombinationsMax) {
      slots.clear();
      combinations = 1;
      break;
    }
  }
  evaluation.whereTrue = environment;
  evaluation.whereFalse = environment;
  for (const int slot : slots) {
    evaluation.whereTrue[slot] = {};
    evaluation.whereFalse[slot] = {};
  }
  for (std::size_t number = 0; number < combinations; ++number) {
    std::map<int, double> chosen;
    std::size_t rest = number;
    for (const int slot : slots) {
      const std::vector<double>& values = environment.at(slot).values;
      chosen[slot] = values[rest % values.size()];
      rest /= values.size();
    }
    std::array<Probe, kUnknowns.size()> probes{Probe(kUnknowns[0]), Probe(kUnknowns[1])};
    std::optional<double> value;
    for (Probe& probe : probes) {
      probe.chosen = chosen;
      machine::Alarm alarm;
      value = expression.evaluate(probe, alarm);
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

std::vector<const Expression*> expressionsOf(const Statement& statement) {
  std::vector<const Expression*> all;
  const auto add = [&all](const std::optional<Expression>& expression) {
    if (expression) {
      all.push_back(&*expression);
    }
  };
  if (const auto* assign = std::get_if<machine::AssignStatement>(&statement.what)) {
    all = {&assign->index, &assign->value};
  } else if (const auto* local = std::get_if<machine::LocalAssignStatement>(&statement.what)) {
    add(local->element);
    all.push_back(&local->value);
  } else if (const auto* fill = std::get_if<machine::FillStatement>(&statement.what)) {
    for (const std::optional<Expression>& value : fill->values) {
      add(value);
    }
  } else if (const auto* motion = std::get_if<machine::MotionStatement>(&statement.what)) {
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      for (const auto* words : {&motion->axes, &motion->centre}) {
        if ((*words)[axis]) {
          all.push_back(&(*words)[axis]->value);
        }
      }
      add(motion->through[axis]);
    }
    for (const std::optional<machine::Coordinate>& word : motion->rotary) {
      if (word) {
        all.push_back(&word->value);
      }
    }
    for (const auto* word : {&motion->radius, &motion->openingAngle, &motion->fullTurns,
                             &motion->feedMmPerMin, &motion->roundingMm}) {
      add(*word);
    }
  } else if (const auto* dwell = std::get_if<machine::DwellStatement>(&statement.what)) {
    all = {&dwell->seconds};
  } else if (const auto* jump = std::get_if<machine::JumpStatement>(&statement.what)) {
    add(jump->condition);
  } else if (const auto* branch = std::get_if<machine::BranchStatement>(&statement.what)) {
    add(branch->condition);
  } else if (const auto* repeat = std::get_if<machine::RepeatStatement>(&statement.what)) {
    add(repeat->times);
  } else if (const auto* call = std::get_if<machine::CallStatement>(&statement.what)) {
    add(call->times);
    for (const Expression& argument : call->arguments) {
      all.push_back(&argument);
    }
  } else if (const auto* frame = std::get_if<machine::FrameStatement>(&statement.what)) {
    for (const std::optional<Expression>& axis : frame->axes) {
      add(axis);
    }
    add(frame->inPlane);
  }
  return all;
}

std::vector<int> indexVariables(const NcProgram& program) {
  std::set<int> followed;
  for (const Statement& statement : program.statements()) {
    for (const Expression* expression : expressionsOf(statement)) {
      const Probe zeros = asked(*expression, 0.0);
      if (zeros.reads != asked(*expression, 1.0).reads) {
        followed.insert(zeros.locals.begin(), zeros.locals.end());
      }
    }
    if (const auto* assign = std::get_if<machine::AssignStatement>(&statement.what)) {
      const std::set<int> locals = asked(assign->index, 0.0).locals;
      followed.insert(locals.begin(), locals.end());
    }
  }
  // What they are computed from has to be followed too.
  for (std::size_t before = 0; before != followed.size();) {
    before = followed.size();
    for (const Statement& statement : program.statements()) {
      const auto* local = std::get_if<machine::LocalAssignStatement>(&statement.what);
      if (local != nullptr && followed.contains(local->slot)) {
        const std::set<int> locals = asked(local->value, 0.0).locals;
        followed.insert(locals.begin(), locals.end());
      }
    }
  }
  std::vector<int> slots;
  for (const int slot : followed) {
    if (program.elementsOf(slot) <= 1) {
      slots.push_back(slot);
    }
  }
  return slots;
}

Exits exitsOf(const NcProgram& program, std::size_t statement) {
  const auto& what = program.statements()[statement].what;
  Exits exits;
  const auto unless = [&](const std::optional<Expression>& condition) {
    exits.condition = condition ? &*condition : nullptr;
  };
  if (const auto* jump = std::get_if<machine::JumpStatement>(&what)) {
    unless(jump->condition);
    exits.whenTrue = program.findLabel(jump->label, jump->direction, statement);
    if (!exits.whenTrue && jump->direction == machine::JumpDirection::ForwardNoAlarm) {
      exits.whenTrue = statement + 1;
    }
    exits.misses = !exits.whenTrue;
    if (exits.condition != nullptr) {
      exits.whenFalse = statement + 1;
    }
  } else if (const auto* branch = std::get_if<machine::BranchStatement>(&what)) {
    unless(branch->condition);
    if (exits.condition != nullptr) {
      exits.whenTrue = statement + 1;
      exits.whenFalse = branch->target;
    } else {
      exits.whenTrue = branch->target;
    }
  } else if (const auto* repeat = std::get_if<machine::RepeatStatement>(&what)) {
    exits.whenTrue = statement + 1;
    exits.whenFalse = program.findLabel(repeat->label, machine::JumpDirection::Backward, statement);
    exits.misses = !exits.whenFalse;
  } else if (std::holds_alternative<machine::EndStatement>(what) ||
             std::holds_alternative<machine::ReturnStatement>(what) ||
             std::holds_alternative<machine::AlarmStatement>(what)) {
    exits.ends = true;
  } else {
    exits.whenTrue = statement + 1;
  }
  return exits;
}

}  // namespace rivulet::templates
