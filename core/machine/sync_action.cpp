// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/sync_action.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rivulet::machine {

namespace {

/// The main run as the source of an expression: every R is read there.
class MainRunSource final : public ValueSource {
 public:
  explicit MainRunSource(const MainRun& mainRun) : m_mainRun(mainRun) {}
  std::optional<double> value(int index) const override { return m_mainRun.rValue(index); }
  std::optional<double> system(SystemVariable variable, int index) const override {
    return m_mainRun.systemValue(variable, index);
  }

 private:
  const MainRun& m_mainRun;
};

}  // namespace

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
    Alarm problem;
    bool holds = true;
    if (action.condition) {
      const std::optional<double> value = action.condition->evaluate(source, problem);
      if (!value) {
        alarm = problem;
        return false;
      }
      holds = *value != 0.0;
    }
    const bool rises = holds && !active.held;
    active.held = holds;
    active.latched = active.latched || holds;
    const bool due = action.trigger == SyncTrigger::When    ? holds && !active.done
                     : action.trigger == SyncTrigger::Every ? rises
                     : action.trigger == SyncTrigger::From  ? active.latched
                                                            : holds;
    if (!due) {
      return true;
    }
    active.done = true;
    for (const SyncAssignment& assignment : action.assignments) {
      const std::optional<double> index = assignment.index.evaluate(source, problem);
      const std::optional<double> value =
          index ? assignment.value.evaluate(source, problem) : std::nullopt;
      if (!value) {
        alarm = problem;
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
