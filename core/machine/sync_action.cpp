// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/sync_action.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rivulet::machine {

namespace {

/// A variable of a program cannot begin with $.
bool isResolved(std::string_view name, std::size_t indices) {
  return indices == 2 && name.starts_with('$');
}

/// The main run as the source of an expression: every R is read there.
class MainRunSource final : public nc::ValueSource {
 public:
  explicit MainRunSource(const MainRun& mainRun) : m_mainRun(mainRun) {}
  nc::Expected<double> r(int index) const override {
    const std::optional<double> value = m_mainRun.rValue(index);
    return value ? nc::Expected<double>(*value)
                 : nc::fail(nc::FaultCode::NoSuchR, fmt::format("{}", index));
  }
  nc::Expected<nc::Value> system(std::string_view name,
                                 std::span<const nc::Value> indices) const override {
    return systemValue(m_mainRun, name, indices);
  }
  /// What `resolve` has made of a variable of the main run.
  nc::Expected<nc::Value> variable(std::string_view name,
                                   std::span<const int> indices) const override {
    if (!isResolved(name, indices.size())) {
      return ValueSource::variable(name, indices);
    }
    const std::optional<double> value =
        m_mainRun.systemValue(static_cast<SystemVariable>(indices[0]), indices[1]);
    return value ? nc::Expected<nc::Value>(*value) : nc::fail(nc::FaultCode::IndexOutsideArray);
  }

 private:
  const MainRun& m_mainRun;
};

/// An index of a variable of the main run that is known before: a number, or the name of an axis.
std::optional<nc::Value> knownIndex(const nc::Expression& operand) {
  if (operand.op == nc::Op::Number) {
    return nc::Value(operand.number);
  }
  const bool isName =
      operand.op == nc::Op::Text || (operand.op == nc::Op::Variable && operand.operands.empty());
  return isName ? std::optional<nc::Value>(operand.name) : std::nullopt;
}

/// Looks up the variables of the main run once and not in every cycle: a node whose index is known
/// becomes one with two indices, the `SystemVariable` and its element. What is at fault stays as it
/// is: the fault belongs to the cycle.
void resolve(nc::Expression& node) {
  for (nc::Expression& operand : node.operands) {
    resolve(operand);
  }
  const std::optional<SystemVariable> variable =
      node.op == nc::Op::System ? systemVariableOf(node.name) : std::nullopt;
  if (!variable) {
    return;
  }
  std::vector<nc::Value> indices;
  for (const nc::Expression& operand : node.operands) {
    const std::optional<nc::Value> index = knownIndex(operand);
    if (!index) {
      return;
    }
    indices.push_back(*index);
  }
  if (const nc::Expected<int> element = systemIndex(node.name, indices)) {
    node.op = nc::Op::Variable;
    node.operands = {nc::Expression::constant(static_cast<double>(*variable)),
                     nc::Expression::constant(*element)};
  }
}

/// Freezes an expression, and knows all variables of the main run in it.
nc::Expected<nc::Expression> made(const nc::Expression& expression, const nc::ValueSource& values) {
  nc::Expected<nc::Expression> frozen = nc::freeze(expression, values, nc::sinumerikSemantics());
  std::string unknown;
  if (frozen) {
    nc::forEachNode(*frozen, [&unknown](const nc::Expression& node) {
      if (node.op == nc::Op::System && !systemVariableOf(node.name)) {
        unknown = node.name;
      }
    });
  }
  if (!unknown.empty()) {
    return nc::fail(nc::FaultCode::OnlyOnControl, std::move(unknown));
  }
  if (frozen) {
    resolve(*frozen);
  }
  return frozen;
}

}  // namespace

nc::Expected<SyncAction> frozen(const nc::Synchronized& action, const nc::ValueSource& values) {
  SyncAction result;
  result.id = action.id;
  result.isStatic = action.isStatic;
  result.trigger = action.trigger;
  if (action.condition) {
    nc::Expected<nc::Expression> condition = made(*action.condition, values);
    if (!condition) {
      return nc::fail(condition.error());
    }
    result.condition = std::move(*condition);
  }
  for (const nc::Assignment& assignment : action.assignments) {
    const nc::Expression& target = assignment.target;
    SyncAssignment& to = result.assignments.emplace_back();
    if (target.op == nc::Op::System) {
      to.variable = systemVariableOf(target.name);
      const auto indices = nc::systemIndices(target, values, nc::sinumerikSemantics());
      if (!to.variable) {
        return nc::fail(nc::FaultCode::OnlyOnControl, target.name);
      }
      const nc::Expected<int> index =
          indices ? systemIndex(target.name, *indices) : nc::fail(indices.error());
      if (!index) {
        return nc::fail(index.error());
      }
      to.index = nc::Expression::constant(*index);
    } else {
      nc::Expected<nc::Expression> index = made(target.operands.front(), values);
      if (!index) {
        return nc::fail(index.error());
      }
      to.index = std::move(*index);
    }
    nc::Expected<nc::Expression> value = made(*assignment.initial.values.front(), values);
    if (!value) {
      return nc::fail(value.error());
    }
    to.value = std::move(*value);
  }
  return result;
}

void SyncActions::add(std::shared_ptr<const SyncAction> action, std::uint64_t block) {
  if (action->id != 0) {
    cancel(action->id);  // the same number again takes its place
  }
  const auto place = std::find_if(m_active.begin(), m_active.end(), [&](const Active& active) {
    return active.action->id > action->id;
  });
  m_active.insert(place, {std::move(action), block, false, false, false});
}

void SyncActions::cancel(int id) {
  std::erase_if(m_active, [id](const Active& active) { return active.action->id == id; });
}

void SyncActions::endProgram() {
  std::erase_if(m_active, [](const Active& active) { return !active.action->isStatic; });
}

std::optional<Alarm> SyncActions::run(MainRun& mainRun, std::uint64_t blocksFinished) {
  std::optional<Alarm> alarm;
  const MainRunSource source(mainRun);
  const auto execute = [&](Active& active) -> bool {
    const SyncAction& action = *active.action;
    const nc::Semantics& semantics = nc::sinumerikSemantics();
    bool holds = true;
    if (action.condition) {
      const nc::Expected<double> value = nc::evaluateNumber(*action.condition, source, semantics);
      if (!value) {
        alarm = alarmOf(value.error());
        return false;
      }
      holds = *value != 0.0;
    }
    const bool rises = holds && !active.held;
    active.held = holds;
    active.latched = active.latched || holds;
    const bool due = action.trigger == nc::Trigger::When    ? holds && !active.done
                     : action.trigger == nc::Trigger::Every ? rises
                     : action.trigger == nc::Trigger::From  ? active.latched
                                                            : holds;
    if (!due) {
      return true;
    }
    active.done = true;
    for (const SyncAssignment& assignment : action.assignments) {
      const nc::Expected<double> index = nc::evaluateNumber(assignment.index, source, semantics);
      const nc::Expected<double> value =
          index ? nc::evaluateNumber(assignment.value, source, semantics) : index;
      if (!value) {
        alarm = alarmOf(value.error());
        return false;
      }
      const int place = static_cast<int>(std::lround(std::clamp(*index, -1.0, 1e6)));
      const bool written = assignment.variable
                               ? mainRun.setSystemValue(*assignment.variable, place, *value)
                               : mainRun.setRValue(place, *value);
      if (!written) {
        alarm = Alarm{17020, fmt::format("A synchronized action writes what does not exist "
                                         "(index {}).",
                                         place)};
        return false;
      }
    }
    return true;
  };
  std::erase_if(m_active, [&](Active& active) {
    if (active.action->id == 0 && blocksFinished > active.block) {
      return true;  // its block is over
    }
    return blocksFinished >= active.block && !execute(active);
  });
  return alarm;
}

}  // namespace rivulet::machine
