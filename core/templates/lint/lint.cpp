// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "templates/lint/lint.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string_view>
#include <utility>
#include <variant>

#include "base/error.h"
#include "base/text.h"
#include "machine/main_run.h"
#include "machine/motion_sink.h"
#include "machine/sync_action.h"
#include "nc/cycles/drilling.h"
#include "nc/eval/evaluate.h"
#include "nc/exec/block_reader.h"
#include "nc/syntax/programs.h"
#include "templates/feed_cell.h"
#include "templates/flexible_program.h"
#include "templates/lint/flow.h"

namespace rivulet::templates {

namespace {

using nc::Statement;
using nc::Words;

constexpr int kUnknownNameAlarm = 12550;

/// Asks a synchronized action with one cell at a value, everything else being `others`.
class CorrectionProbe final : public nc::ValueSource {
 public:
  CorrectionProbe(int cell, double value, double others)
      : m_cell(cell), m_value(value), m_others(others) {}
  [[nodiscard]] nc::Expected<double> r(int index) const override {
    return index == m_cell ? m_value : m_others;
  }
  [[nodiscard]] nc::Expected<nc::Value> variable(std::string_view name,
                                                 std::span<const int>) const override {
    const bool isAxis = name.size() == 1 && std::string_view("XYZ").find(name) != name.npos;
    return isAxis ? nc::Value(std::string(name)) : nc::Value(m_others);
  }
  [[nodiscard]] nc::Expected<nc::Value> system(std::string_view,
                                               std::span<const nc::Value>) const override {
    return m_others;
  }

 private:
  int m_cell;
  double m_value;
  double m_others;
};

/// Cycles of the main run with one value in the feed cell, everything else being `others` until an
/// action writes it. Timers stand before they are started. Overlays follow at the end of a cycle.
class OverrideProbe final : public machine::MainRun {
 public:
  OverrideProbe(int cell, double value, double others) : m_others(others) { m_r[cell] = value; }
  /// One cycle. What is not written in it is 100 %. @return the override
  double cycle(machine::SyncActions& actions) {
    m_overridePercent = 100.0;
    // An action with an alarm, as for what is not a number, ends; the others go on.
    static_cast<void>(actions.run(*this, 0));
    for (int axis = 0; axis < static_cast<int>(base::kAxisCount); ++axis) {
      const auto asked = m_written.find({machine::SystemVariable::AaOff, axis});
      if (asked != m_written.end()) {
        m_written[{machine::SystemVariable::AaOffVal, axis}] = asked->second;
      }
    }
    return m_overridePercent;
  }
  void pass(double seconds) {
    for (auto& [timer, value] : m_timers) {
      value += value >= 0.0 ? seconds : 0.0;
    }
  }

  [[nodiscard]] std::optional<double> systemValue(machine::SystemVariable variable,
                                                  int index) const override {
    if (variable == machine::SystemVariable::AcTimer) {
      const auto timer = m_timers.find(index);
      return timer != m_timers.end() ? timer->second : -1.0;
    }
    const auto written = m_written.find({variable, index});
    return written != m_written.end() ? written->second : m_others;
  }
  bool setSystemValue(machine::SystemVariable variable, int index, double value) override {
    if (variable == machine::SystemVariable::AcOvr) {
      m_overridePercent = value;
    } else if (variable == machine::SystemVariable::AcTimer) {
      m_timers[index] = value;
    } else {
      m_written[{variable, index}] = value;
    }
    return true;
  }
  [[nodiscard]] std::optional<double> rValue(int index) const override {
    const auto found = m_r.find(index);
    return found != m_r.end() ? found->second : m_others;
  }
  bool setRValue(int index, double value) override {
    m_r[index] = value;
    return true;
  }

 private:
  std::map<int, double> m_r;
  std::map<int, double> m_timers;
  std::map<std::pair<machine::SystemVariable, int>, double> m_written;
  double m_others;
  double m_overridePercent = 100.0;
};

/// The value of F, whatever it is made of.
nc::Expression feedOf(const Words& words) {
  const auto found = std::find_if(words.tokens.begin(), words.tokens.end(),
                                  [](const nc::Token& token) { return token.address == 'F'; });
  const nc::Expression* const value = found == words.tokens.end() ? nullptr : found->calculated();
  return value != nullptr ? *value : nc::Expression::constant(found->value);
}

/// What a block says whatever its values are.
struct BlockSummary {
  std::optional<machine::Alarm> alarm;  ///< the control would complain: nothing else is known
  std::optional<bool> rapid;            ///< of the motion it names
  std::optional<bool> relative;         ///< G90, G91
  bool namesFeed = false;
  bool dwells = false;
  bool moves = false;  ///< names an axis, also a rotary one the machine has not
};

BlockSummary summaryOf(const Words& words) {
  BlockSummary made;
  machine::AlarmSink alarms;
  machine::MotionSink path({}, alarms);
  nc::WordObserver observer;
  nc::ModalState state;
  nc::Variables variables(nc::sinumerikSemantics());
  nc::BlockReader reader(nc::languageOf(nc::Dialect::Sinumerik), false, state, variables,
                         {path, alarms, observer});
  nc::BlockWords block;
  std::vector<nc::Token> tokens = words.tokens;
  for (nc::Token& token : tokens) {
    const bool isWord =
        token.kind == nc::TokenKind::Expression || token.kind == nc::TokenKind::Assignment;
    if (isWord && token.calculated() != nullptr) {
      token.kind = token.address != 0 ? nc::TokenKind::Word : nc::TokenKind::NamedValue;
      token.value = 1.0;
      token.reference = (*token.calculation)->reference;
    }
    reader.read(token, block);
  }
  made.alarm = alarms.take();
  if (block.g.motion != nullptr || (block.rare && block.rare->threePointArc)) {
    made.rapid = block.g.motion != nullptr && block.g.motion->function == nc::G::Rapid;
  }
  if (block.g.distance != nullptr) {
    made.relative = state.relative;
  }
  made.namesFeed = block.feed != nullptr && !block.dwell;
  made.dwells = block.dwell;
  made.moves = !made.alarm && !block.dwell &&
               (block.hasAnyCentre() || block.axes.hasAny(0, nc::kFirstFurther));
  return made;
}

/// What is known when control arrives at a statement. "Must" facts hold on every path to it, "may"
/// facts on one at least.
struct State {
  Environment values;
  bool mustFeed = false;
  bool mustLayout = false;
  bool mayLayout = false;
  bool mustRun = false;        ///< the run cell was asked
  bool mustDelivered = false;  ///< asked since the last STOPRE and motion (method window)
  bool mustStand = true;       ///< a STOPRE since the last motion
  bool mayRapid = false;
  bool mayRelative = false;
  std::set<int> mayStale;  ///< cells read since the last STOPRE

  /// @return true if something has changed
  bool join(const State& other) {
    bool changed = false;
    for (const auto& [slot, values_] : other.values) {
      changed = values[slot].join(values_) || changed;
    }
    const auto must = [&changed](bool& mine, bool theirs) {
      changed = changed || (mine && !theirs);
      mine = mine && theirs;
    };
    const auto may = [&changed](bool& mine, bool theirs) {
      changed = changed || (!mine && theirs);
      mine = mine || theirs;
    };
    must(mustFeed, other.mustFeed);
    must(mustLayout, other.mustLayout);
    must(mustRun, other.mustRun);
    must(mustDelivered, other.mustDelivered);
    must(mustStand, other.mustStand);
    may(mayLayout, other.mayLayout);
    may(mayRapid, other.mayRapid);
    may(mayRelative, other.mayRelative);
    const std::size_t before = mayStale.size();
    mayStale.insert(other.mayStale.begin(), other.mayStale.end());
    return changed || mayStale.size() != before;
  }
};

class Linter {
 public:
  Linter(const nc::Tree& program, const FlexibleProgram& meant)
      : m_program(program),
        m_statements(program.statements),
        m_parameters(meant.parameters),
        m_cells(meant.cells),
        m_isWindow(base::hasWindows(m_parameters.method)),
        m_goesOn(base::goesOn(m_parameters.method)),
        m_layoutNumber(meant.layoutNumber) {
    for (int slot = 0; slot < m_cells.slotCount(); ++slot) {
      const std::vector<int> numbers = m_cells.slotCells(slot);
      m_slotCells.insert(numbers.begin(), numbers.end());
    }
    m_stopCell = m_isWindow ? m_cells.run : m_cells.stop;
    for (const nc::Definition& parameter : program.parameters) {
      m_defined.insert(parameter.name);
    }
    for (const Statement& statement : m_statements) {
      if (const auto* definition = std::get_if<nc::Definition>(&statement.what)) {
        m_defined.insert(definition->name);
      }
    }
  }

  std::vector<LintFinding> run() {
    lookAtBlocks();
    follow();
    m_reports = true;
    for (std::size_t i = 0; i < m_statements.size(); ++i) {
      if (m_isReached[i]) {
        static_cast<void>(step(i, m_before[i]));
      }
    }
    lookAtLoops();
    lookAtWhole();
    std::stable_sort(m_findings.begin(), m_findings.end(),
                     [](const auto& a, const auto& b) { return a.line < b.line; });
    return std::move(m_findings);
  }

 private:
  void add(LintRule rule, LintSeverity severity, base::LineNumber line, std::string message) {
    if (m_reports && m_found.insert({rule, line.value}).second) {
      m_findings.push_back({rule, severity, line, std::move(message)});
    }
  }
  void error(LintRule rule, base::LineNumber line, std::string message) {
    add(rule, LintSeverity::Error, line, std::move(message));
  }
  void warn(LintRule rule, base::LineNumber line, std::string message) {
    add(rule, LintSeverity::Warning, line, std::move(message));
  }
  /// What all following lines have in common is reported once.
  void errorOnce(LintRule rule, base::LineNumber line, std::string message) {
    if (m_reports && m_toldOnce.insert(rule).second) {
      error(rule, line, std::move(message));
    }
  }

  // --- block by block ---------------------------------------------------------------------

  /// Method file: the client writes it, and it moves nothing unless it is the window asked for.
  [[nodiscard]] bool isOwnSubprogram(const std::string& name) const {
    bool isOwn = false;
    for (int file = 0; file < m_cells.files; ++file) {
      isOwn = isOwn || name + ".SPF" == windowFileName(file);
    }
    return isOwn;
  }

  /// What the control would say of the block whatever the values; nothing: it reads it.
  [[nodiscard]] std::optional<machine::Alarm> alarmOf(const Statement& statement) const {
    if (const auto* faulty = std::get_if<nc::Faulty>(&statement.what)) {
      return machine::alarmOf(faulty->fault);
    }
    if (const auto* words = std::get_if<Words>(&statement.what)) {
      if (std::optional<machine::Alarm> alarm = summaryOf(*words).alarm) {
        return alarm;
      }
    }
    std::optional<nc::Fault> fault;
    const auto look = [&](const nc::Expression& node) {
      if (node.op == nc::Op::Variable && !m_defined.contains(node.name)) {
        fault = nc::Fault{nc::FaultCode::NotDefined, node.name, node.place};
      } else if (node.op == nc::Op::System && !machine::systemVariableOf(node.name)) {
        fault = nc::Fault{nc::FaultCode::OnlyOnControl, node.name, node.place};
      }
    };
    const std::function<void(const nc::Expression&)> visit = [&](const nc::Expression& node) {
      look(node);
      for (const nc::Expression& operand : node.operands) {
        // The axis of a variable of the main run is no variable.
        if (node.op != nc::Op::System || operand.op != nc::Op::Variable) {
          visit(operand);
        }
      }
    };
    nc::forEachExpression(statement, visit);
    if (const auto* assignment = std::get_if<nc::Assignment>(&statement.what)) {
      const nc::Op op = assignment->target.op;
      look(assignment->target);
      if (op == nc::Op::System || op == nc::Op::MainR) {
        fault = nc::Fault{nc::FaultCode::ControlWritten, {}, assignment->target.place};
      }
    }
    return fault ? std::optional(machine::alarmOf(*fault)) : std::nullopt;
  }

  [[nodiscard]] Exits exitsOf(std::size_t at) const {
    Exits exits = templates::exitsOf(m_program, at);
    exits.ends = exits.ends || m_alarms.contains(at);
    return exits;
  }

  void lookAtBlocks() {
    m_reports = true;
    for (std::size_t i = 0; i < m_statements.size(); ++i) {
      const Statement& statement = m_statements[i];
      if (const std::optional<machine::Alarm> alarm = alarmOf(statement)) {
        m_alarms.insert(i);
        const bool isName = alarm->number == kUnknownNameAlarm;
        error(isName ? LintRule::UnknownName : LintRule::Syntax, statement.place.line,
              fmt::format("The control would stop here with alarm {}: {} Correct the block.",
                          alarm->number, alarm->text));
      } else if (const auto* modal = std::get_if<nc::RepeatedCall>(&statement.what)) {
        if (modal->call) {
          warn(LintRule::NotChecked, statement.place.line,
               fmt::format("What MCALL {} moves is not checked.", modal->call->name));
        }
      } else if (const auto* call = std::get_if<nc::Call>(&statement.what)) {
        if (nc::isDrillingCycle(call->name) || nc::isHolePattern(call->name)) {
          warn(LintRule::NotChecked, statement.place.line,
               fmt::format("What the cycle {} moves is not checked.", call->name));
        } else if (call->isPlainName) {
          error(LintRule::UnknownName, statement.place.line,
                fmt::format("{} is neither a word of the control nor a variable of this program. "
                            "Correct the name, or define it with DEF.",
                            call->name));
        } else if (!isOwnSubprogram(call->name)) {
          warn(LintRule::NotChecked, statement.place.line,
               fmt::format("The subprogram {} is not checked. Write its blocks into this program.",
                           call->name));
        }
      } else if (const auto* sync = std::get_if<nc::Synchronized>(&statement.what)) {
        lookAtSync(statement.place.line, *sync);
      } else if (exitsOf(i).misses) {
        const auto* jump = std::get_if<nc::Jump>(&statement.what);
        const auto* repeat = std::get_if<nc::RepeatLabel>(&statement.what);
        const std::string& label = jump != nullptr ? jump->label : repeat->label;
        error(LintRule::MissingLabel, statement.place.line,
              fmt::format("There is no label {} in the direction of the jump. Write the label, or "
                          "correct the direction of the jump.",
                          label));
      }
    }
    m_reports = false;
  }

  /// The override is that of the client, whatever else lowers it. Method credit tells besides how
  /// far the axes are.
  void lookAtSync(base::LineNumber line, const nc::Synchronized& action) {
    for (const nc::Assignment& assignment : action.assignments) {
      const nc::Expression& target = assignment.target;
      if (target.name == "$AA_OFF" && m_cells.corrects()) {
        lookAtCorrection(line, action, assignment);
        continue;
      }
      const bool isR = target.op == nc::Op::MainR;
      const ValueSet index = isR ? evaluate(target.operands.front(), {}).result : ValueSet{};
      const bool isCertain = !index.isUnknown && index.values.size() == 1;
      const int cell = isCertain ? static_cast<int>(index.values.front()) : -1;
      if (m_cells.hasFeedCell() &&
          (target.name == "$AC_OVR" || (isCertain && cell == m_cells.overrideActs))) {
        m_overrideLine = line;  // looked at as a whole
      } else if (watchesClient(m_cells) &&
                 (target.name == "$AC_TIMER" || target.name == "$AC_PARAM")) {
        m_overrideLine = std::max(m_overrideLine, line);  // the same
      } else if (isR && isCertain && isClients(cell)) {
        error(LintRule::ClientCellOverwritten, line,
              fmt::format(
                  "A synchronized action writes R{}, which belongs to the client. Remove this.",
                  cell));
      } else if (!isR || !isCertain || !m_goesOn || cell != m_cells.executed) {
        warn(LintRule::NotChecked, line,
             "The effect of this synchronized action is not checked. Remove it.");
      }
    }
  }

  /// What an action lays over an axis: nothing, or what the client asks within the limit.
  void lookAtCorrection(base::LineNumber line, const nc::Synchronized& action,
                        const nc::Assignment& assignment) {
    const std::vector<nc::Expression>& indices = assignment.target.operands;
    const std::size_t axis =
        indices.size() == 1 && indices[0].name.size() == 1
            ? std::min(std::string_view("XYZ").find(indices[0].name), base::kAxisCount)
            : base::kAxisCount;
    const int cell = axis < base::kAxisCount ? m_cells.correction[axis] : -1;
    const double limitMm = correctionSteps(m_parameters) / 1000.0;
    const double leastMm = m_cells.lifts ? 0.0 : -limitMm;
    constexpr double kSameMm = 1e-9;
    constexpr int kSteps = 1000;
    // Far beyond the limit, at it, and all between; then what is no number.
    std::vector<double> values{1e9,
                               -1e9,
                               limitMm + 1e-4,
                               -limitMm - 1e-4,
                               limitMm,
                               -limitMm,
                               std::numeric_limits<double>::quiet_NaN()};
    for (int step = -kSteps; step <= kSteps; ++step) {
      values.push_back(2.0 * limitMm * step / kSteps);
    }
    bool isBounded = cell >= 0;
    bool follows = cell >= 0;
    bool isZero = true;
    bool onlyHeld = true;
    for (const double others : {0.0, 0.37, 1e6}) {
      for (const double value : values) {
        const CorrectionProbe probe(cell, value, others);
        const auto valueOf = [&probe](const nc::Expression& expression) {
          return nc::evaluateNumber(expression, probe, nc::sinumerikSemantics());
        };
        const auto holds =
            action.condition ? valueOf(*action.condition) : nc::Expected<double>(1.0);
        const auto laid = valueOf(*assignment.initial.values.front());
        const bool isDue = holds && *holds != 0.0;
        const bool isNothing = !isDue || (laid && *laid == 0.0);
        // Where a condition cannot be answered, the control gives an alarm and lays nothing.
        isBounded = isBounded &&
                    (!isDue || (laid && *laid >= leastMm - kSameMm && *laid <= limitMm + kSameMm));
        isZero = isZero && isNothing;
        const bool isHeld = others <= FeedCell::kHold;  // the feed cell is one of them
        onlyHeld = onlyHeld && (!m_cells.lifts || isHeld || isNothing);
        if (value >= leastMm && value <= limitMm && (!m_cells.lifts || isHeld)) {
          follows = follows && isDue && laid && std::abs(*laid - value) <= kSameMm;
        }
      }
    }
    if (!isBounded) {
      error(LintRule::CorrectionUnbounded, line,
            fmt::format("The action may apply more than {:.3f} mm to an axis, or a value that is "
                        "not a number, or a value to an axis without a correction. Let it act only "
                        "while the cell of the axis is within the limit.",
                        limitMm));
    } else if (!onlyHeld) {
      error(LintRule::CorrectionUnbounded, line,
            fmt::format("The action may lift the tool while R{} lets the path go on. Let it act "
                        "only while R{} is 0.",
                        m_cells.overrideWanted, m_cells.overrideWanted));
    } else if (follows && action.trigger != nc::Trigger::When &&
               action.trigger != nc::Trigger::Every) {
      m_corrected.insert(cell);
    } else if (!isZero) {
      error(LintRule::CorrectionUnbounded, line,
            fmt::format("The action applies another value to the axis than that of R{}. Write $R{} "
                        "there, in each cycle in which it is within the limit.",
                        cell, cell));
    }
  }

  /// As they are until the program ends: an action that is written there again does not count.
  /// @param others   values of all that the actions do not know  @param without  numbers of actions
  [[nodiscard]] machine::SyncActions actionsOf(double others, const std::set<int>& without) const {
    machine::SyncActions actions;
    std::set<int> known = without;
    const CorrectionProbe values(-1, 0.0, others);
    for (const Statement& statement : m_statements) {
      const auto* const action = std::get_if<nc::Synchronized>(&statement.what);
      if (action == nullptr || action->id == 0 || !known.insert(action->id).second) {
        continue;
      }
      if (auto made = machine::frozen(*action, values)) {
        actions.add(std::make_shared<const machine::SyncAction>(std::move(*made)), 0);
      }
    }
    return actions;
  }

  /// @param factor  where the program has one
  [[nodiscard]] OverrideProbe probeOf(double wanted, double factor, double others) const {
    OverrideProbe mainRun(m_cells.overrideWanted, wanted, others);
    if (m_cells.hasFactor()) {
      mainRun.setRValue(m_cells.factor, factor);
    }
    return mainRun;
  }

  /// Values of its cell that make a difference; 1 where there is none.
  [[nodiscard]] std::vector<double> factorsToTry() const {
    if (!m_cells.hasFactor()) {
      return {1.0};
    }
    const double least = m_cells.factorLeast;
    const double most = m_cells.factorMost;
    constexpr double kBeside = 0.001;
    return {1.0,
            least,
            most,
            0.5 * (1.0 + least),
            least - kBeside,
            most + kBeside,
            0.0,
            -1.0,
            250.0,
            1e308,
            std::numeric_limits<double>::quiet_NaN()};
  }

  /// What the actions make of the feed cell in a cycle while the client lives.
  [[nodiscard]] double overrideAt(double wanted, double factor, double others,
                                  const std::set<int>& without) const {
    machine::SyncActions actions = actionsOf(others, without);
    OverrideProbe mainRun = probeOf(wanted, factor, others);
    mainRun.setRValue(m_cells.heartbeat, others + 1.0);
    double percent = 0.0;
    for (int cycle = 0; cycle < 3; ++cycle) {  // one to see the sign of life; then in every one
      percent = mainRun.cycle(actions);
    }
    return percent;
  }

  /// What the axes do while the client gives no sign. @return empty: they stand; else what happens
  [[nodiscard]] std::string lackOfWatch(double others, const std::set<int>& without) const {
    constexpr double kAgo = 0.01;
    constexpr int kCycles = 3;
    const double limitS = m_cells.silenceLimitS;
    machine::SyncActions actions = actionsOf(others, without);
    OverrideProbe mainRun = probeOf(FeedCell::kProgrammed, 1.0, others);
    const auto percent = [&](double afterS) {
      mainRun.pass(afterS);
      double last = 0.0;
      for (int cycle = 0; cycle < kCycles; ++cycle) {
        last = mainRun.cycle(actions);
      }
      return last;
    };
    const auto beat = [&](double value) { mainRun.setRValue(m_cells.heartbeat, value); };
    if (percent(0.0) > FeedCell::kHold) {
      return "the axes could move before its first one";
    }
    for (const double value : {others + 1.0, others - 3.5, 1e9}) {  // whatever it changes to
      beat(value);
      if (!(percent(0.0) > FeedCell::kHold) || !(percent(limitS - kAgo) > FeedCell::kHold)) {
        return "the axes would stand although it lives";
      }
      if (percent(2.0 * kAgo) > FeedCell::kHold) {
        return fmt::format("the axes would go on after {:g} s", limitS);
      }
    }
    beat(std::numeric_limits<double>::quiet_NaN());
    if (percent(kAgo) > FeedCell::kHold) {
      return "what is not a number would count as one";
    }
    return {};
  }

  /// @return false: a fault has been found
  bool obeysFeedCell(double factor, const std::set<int>& cancelled) {
    constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
    const auto cells = [&](double wanted) {
      return fmt::format("{} in R{}{}", wanted, m_cells.overrideWanted,
                         m_cells.hasFactor() ? fmt::format(" and {} in R{}", factor, m_cells.factor)
                                             : std::string());
    };
    for (const double others : {0.0, 0.37, 1e6}) {
      for (const double wanted : {0.0, 0.001, 40.0, 100.0, FeedCell::kMax, FeedCell::kMax + 0.001,
                                  250.0, 1e9, -0.001, -1.0, kNoNumber}) {
        const double allowed = overrideOf(m_cells, wanted, factor);
        const double lowered = overrideAt(wanted, factor, others, {});
        const double plain = overrideAt(wanted, factor, others, cancelled);
        if (!(lowered <= allowed) || !(plain <= allowed)) {
          error(LintRule::FeedRaised, m_overrideLine,
                fmt::format("With {} the override is not at most {:g} %: the axes would "
                            "move faster than the client has commanded. Let the actions write "
                            "$AC_OVR as in the generated program.",
                            cells(wanted), allowed));
          return false;
        }
        if (plain != allowed || (allowed > 0.0 && lowered <= 0.0)) {
          error(LintRule::FeedCellIgnored, m_overrideLine,
                fmt::format("With {} the override is {:g} % instead of {:g} %. Let the "
                            "actions write $AC_OVR as in the generated program.",
                            cells(wanted), plain, allowed));
          return false;
        }
      }
    }
    return true;
  }

  /// Whoever lets the path go on finds the tool lowered first. @return false: a fault has been
  /// found
  bool waitsForTool(double others, const std::set<int>& cancelled) {
    constexpr std::size_t kZ = base::kAxisCount - 1;
    const double limitMm = correctionSteps(m_parameters) / 1000.0;
    for (const double liftedMm : {0.001, limitMm}) {
      machine::SyncActions actions = actionsOf(others, cancelled);
      OverrideProbe mainRun = probeOf(FeedCell::kHold, 1.0, others);
      mainRun.setRValue(m_cells.heartbeat, others + 1.0);
      mainRun.setRValue(m_cells.correction[kZ], liftedMm);
      static_cast<void>(mainRun.cycle(actions));
      mainRun.setSystemValue(machine::SystemVariable::AaOffVal, kZ, liftedMm);
      mainRun.setRValue(m_cells.overrideWanted, FeedCell::kProgrammed);
      const double lifted = mainRun.cycle(actions);
      const double lowered = mainRun.cycle(actions);
      if (lifted > FeedCell::kHold || !(lowered > FeedCell::kHold)) {
        error(LintRule::FeedRaised, m_overrideLine,
              fmt::format("With {:g} in R{} a tool that is {:g} mm above its path {}. Let the "
                          "actions hold the axes and lower the tool as in the generated program.",
                          FeedCell::kProgrammed, m_cells.overrideWanted, liftedMm,
                          lifted > FeedCell::kHold ? "would go on there" : "is not lowered"));
        return false;
      }
    }
    return true;
  }

  void lookAtFeedCell() {
    // The main program of a whole job has the feed cell, its loop does not touch the override.
    if (!m_program.parameters.empty()) {
      if (std::any_of(m_statements.begin(), m_statements.end(), writesOverride)) {
        error(LintRule::FeedCellIgnored, m_overrideLine,
              "Only the main program of a whole job may write $AC_OVR. Remove this.");
      }
      return;
    }
    std::set<int> cancelled;
    for (const Statement& statement : m_statements) {
      if (const auto* const cancel = std::get_if<nc::Cancel>(&statement.what)) {
        const ValueSet id = evaluate(cancel->id, {}).result;
        cancelled.insert(
            id.isUnknown || id.values.size() != 1 ? 0 : static_cast<int>(id.values.front()));
      }
    }
    for (const double factor : factorsToTry()) {
      if (!obeysFeedCell(factor, cancelled)) {
        return;
      }
    }
    for (const double others : {0.0, 0.37, 1e6}) {
      if (m_cells.lifts && !waitsForTool(others, cancelled)) {
        return;
      }
      const std::string lack =
          watchesClient(m_cells) ? lackOfWatch(others, cancelled) : std::string();
      if (!lack.empty()) {
        error(LintRule::ClientNotWatched, m_overrideLine,
              fmt::format("Without a sign of the client in R{}, {}. Let the actions watch it as in "
                          "the generated program.",
                          m_cells.heartbeat, lack));
        return;
      }
    }
  }

  static bool writesOverride(const Statement& statement) {
    const auto* const action = std::get_if<nc::Synchronized>(&statement.what);
    return action != nullptr &&
           std::any_of(action->assignments.begin(), action->assignments.end(),
                       [](const nc::Assignment& each) { return each.target.name == "$AC_OVR"; });
  }

  // --- along all paths --------------------------------------------------------------------

  void follow() {
    m_before.resize(m_statements.size());
    m_isReached.assign(m_statements.size() + 1, false);
    State first;
    for (const std::string& name : indexVariables(m_program)) {
      first.values[name].add(0.0);
    }
    std::deque<std::size_t> due;
    const auto arrive = [&](std::size_t at, const State& state) {
      if (at >= m_statements.size()) {
        m_isReached[m_statements.size()] = true;
      } else if (!m_isReached[at]) {
        m_isReached[at] = true;
        m_before[at] = state;
        due.push_back(at);
      } else if (m_before[at].join(state) && std::find(due.begin(), due.end(), at) == due.end()) {
        due.push_back(at);
      }
    };
    arrive(0, first);
    while (!due.empty()) {
      const std::size_t at = due.front();
      due.pop_front();
      const State after = step(at, m_before[at]);
      const Exits exits = exitsOf(at);
      if (exits.ends) {
        continue;
      }
      State whenTrue = after;
      State whenFalse = after;
      bool mayBeTrue = true;
      bool mayBeFalse = true;
      if (exits.condition != nullptr) {
        Evaluation evaluation = evaluate(*exits.condition, after.values);
        mayBeTrue = evaluation.mayBeTrue;
        mayBeFalse = evaluation.mayBeFalse;
        whenTrue.values = std::move(evaluation.whereTrue);
        whenFalse.values = std::move(evaluation.whereFalse);
      }
      if (exits.whenTrue && mayBeTrue) {
        arrive(*exits.whenTrue, whenTrue);
      }
      if (exits.whenFalse && mayBeFalse) {
        arrive(*exits.whenFalse, whenFalse);
      }
    }
  }

  /// What holds behind a statement; in the last pass, what is wrong with it.
  State step(std::size_t at, const State& before) {
    const Statement& statement = m_statements[at];
    State after = before;
    if (statement.readsMainRun) {
      stop(after);
    }
    std::vector<int> reads;
    nc::forEachExpression(statement, [&](const nc::Expression& expression) {
      const Evaluation evaluation = evaluate(expression, before.values);
      reads.insert(reads.end(), evaluation.reads.begin(), evaluation.reads.end());
      lookAtReads(statement, evaluation, after);
    });
    const auto set = [&](const std::string& name, const nc::Initial* initial) {
      const auto followed = after.values.find(name);
      if (followed != after.values.end()) {
        const bool isKnown = initial != nullptr && initial->values.front();
        followed->second = isKnown ? evaluate(*initial->values.front(), before.values).result
                                   : ValueSet{false, {0.0}};
      }
    };
    if (std::holds_alternative<nc::PreprocessingStop>(statement.what)) {
      stop(after);
    } else if (const auto* words = std::get_if<Words>(&statement.what)) {
      move(statement.place.line, *words, reads, after);
    } else if (const auto* assignment = std::get_if<nc::Assignment>(&statement.what)) {
      if (assignment->target.op == nc::Op::R) {
        write(statement.place.line, *assignment, after);
      } else if (assignment->target.operands.empty()) {
        set(assignment->target.name, &assignment->initial);
      }
    } else if (const auto* definition = std::get_if<nc::Definition>(&statement.what)) {
      set(definition->name, definition->initial ? &*definition->initial : nullptr);
    }
    if (exitsOf(at).condition != nullptr) {
      const auto asks = [&reads](int cell) {
        return std::find(reads.begin(), reads.end(), cell) != reads.end();
      };
      after.mustRun = after.mustRun || asks(m_cells.run);
      after.mustDelivered = after.mustDelivered || (m_isWindow && asks(m_cells.delivered));
    }
    return after;
  }

  static void stop(State& state) {
    state.mustStand = true;
    state.mustDelivered = false;
    state.mayStale.clear();
  }

  [[nodiscard]] bool isWindowCell(int cell) const {
    return m_isWindow && cell >= m_cells.windowCount(0) && cell <= m_cells.last();
  }

  void checkRange(base::LineNumber line, int cell) {
    if (cell < 0 || cell >= m_parameters.rParameterCount) {
      error(LintRule::RParameterOutOfRange, line,
            fmt::format("R{} does not exist: this control has R0 to R{}. Use fewer points per "
                        "loop, or have MD28050 raised to at least {}.",
                        cell, m_parameters.rParameterCount - 1, cell + 1));
    }
  }

  void lookAtReads(const Statement& statement, const Evaluation& evaluation, State& state) {
    const base::LineNumber line = statement.place.line;
    if (evaluation.hasUnknownIndex) {
      warn(LintRule::RParameterUnbounded, line,
           "It cannot be determined before the run which R-parameter is read. Compute the number "
           "only from variables of the program, within bounds that it checks.");
    }
    // In a loop over the slots the same words read another slot in each pass.
    const bool isCertain = evaluation.reads.size() == 1;
    for (const int cell : evaluation.reads) {
      checkRange(line, cell);
      if (isWindowCell(cell)) {
        if (!state.mustStand && !m_goesOn) {
          errorOnce(LintRule::StopreMissing, line,
                    fmt::format("A window is copied from R{} on a path without STOPRE since the "
                                "last motion: the control may have read it before the client wrote "
                                "it. Put a STOPRE before the check of R{}.",
                                cell, m_cells.delivered));
        } else if (!state.mustDelivered) {
          errorOnce(LintRule::HandshakeMissing, line,
                    fmt::format("A window is copied from R{} on a path that has not checked R{} "
                                "since the last motion: the client may still be writing it. Copy "
                                "it only after a condition on R{}.",
                                cell, m_cells.delivered, m_cells.delivered));
        }
      } else if (!m_isWindow && m_slotCells.contains(cell)) {
        if (!state.mustRun) {
          errorOnce(LintRule::HandshakeMissing, line,
                    fmt::format("R{} is read on a path that has not waited for the client: R{} was "
                                "not checked. Wait in a loop until R{} is 1.",
                                cell, m_cells.run, m_cells.run));
        }
        if (isCertain && state.mayStale.contains(cell)) {
          errorOnce(LintRule::StopreMissing, line,
                    fmt::format("R{} is read again on a path without STOPRE since the last read: "
                                "the control would run ahead of the client and repeat the point. "
                                "Put a STOPRE on every path from the last point to the next pass.",
                                cell));
        }
      }
    }
    for (const int cell : evaluation.reads) {
      if (m_slotCells.contains(cell)) {
        m_slotsRead.insert(cell);
        if (isCertain) {
          state.mayStale.insert(cell);
        }
      }
    }
  }

  void move(base::LineNumber line, const Words& words, const std::vector<int>& reads,
            State& state) {
    const BlockSummary block = summaryOf(words);
    if (block.alarm) {
      return;
    }
    state.mayRapid = block.rapid.value_or(state.mayRapid);
    state.mayRelative = block.relative.value_or(state.mayRelative);
    if (block.namesFeed) {
      state.mustFeed = true;
      const Evaluation feed = evaluate(feedOf(words), state.values);
      m_usesClientFeed = m_usesClientFeed || feed.asks(m_cells.feed);
    }
    if (!block.moves) {
      return;
    }
    if (!state.mustFeed) {
      errorOnce(LintRule::FeedMissing, line,
                m_isWindow
                    ? "The axes move on a path that has set no feed. Write F with the feed of the "
                      "window into the block."
                    : fmt::format("The axes move on a path that has set no feed. Write F=R{} into "
                                  "the block.",
                                  m_cells.feed));
    }
    if (!state.mustLayout) {
      errorOnce(
          LintRule::LayoutNumberMissing, line,
          fmt::format("The axes move on a path that has not written R{}={}: the client would not "
                      "recognise the program. Write it before the waiting loop, after a STOPRE.",
                      m_cells.layout, m_layoutNumber));
    }
    if (state.mayRapid) {
      warn(LintRule::RapidMotion, line,
           "The block moves with G0, at rapid speed regardless of the feed. Write G1.");
    }
    if (state.mayRelative) {
      error(LintRule::RelativeMotion, line,
            "The block may move by increments (G91), but the client sends positions. Write G90 "
            "before the loop.");
    }
    for (const int cell : reads) {
      if (isWindowCell(cell)) {
        error(LintRule::MotionFromCells, line,
              fmt::format("The axes move to the present value of R{}, which has not been checked. "
                          "Copy the window, check its check number, and move from the copy.",
                          cell));
        break;
      }
    }
    state.mustStand = false;
    state.mustDelivered = false;
  }

  void write(base::LineNumber line, const nc::Assignment& assign, State& state) {
    const Evaluation index = evaluate(assign.target.operands.front(), state.values);
    const Evaluation value = evaluate(*assign.initial.values.front(), state.values);
    if (index.result.isUnknown) {
      warn(LintRule::RParameterUnbounded, line,
           "It cannot be determined before the run which R-parameter is written. Compute the "
           "number only from variables of the program.");
      return;
    }
    for (const double number : index.result.values) {
      // What is beyond all cells stays so.
      const int cell = static_cast<int>(std::clamp(number, -1.0, 1e6));
      checkRange(line, cell);
      if (cell == m_cells.layout) {
        writeLayout(line, value.result, state);
      } else if (state.mayLayout && isClients(cell)) {
        error(LintRule::ClientCellOverwritten, line,
              fmt::format("R{} belongs to the client as soon as the layout number is in R{}, but "
                          "it is overwritten here. Set it before R{}={}.",
                          cell, m_cells.layout, m_cells.layout, m_layoutNumber));
      } else if (!m_isWindow && cell == m_cells.signal &&
                 base::methodTraits(m_parameters.method).portion == base::Portion::HalfLoop &&
                 !state.mustStand) {
        signalAhead(line);
      } else if (m_goesOn && (cell == m_cells.executed || cell == m_cells.state) &&
                 !state.mustStand) {
        error(
            LintRule::SignalAhead, line,
            fmt::format(
                "R{} is written on a path without STOPRE since the last motion: the client would "
                "consider points executed that the axes have not reached. Put a STOPRE before it.",
                cell));
      }
    }
  }

  void signalAhead(base::LineNumber line) {
    const bool isWanted = m_parameters.signalStop == SignalStop::OncePerLoop;
    add(LintRule::SignalAhead, isWanted ? LintSeverity::Warning : LintSeverity::Error, line,
        fmt::format("R{} is set on a path without STOPRE since the last motion: the control sets "
                    "it before the axes have passed the points, and the client overwrites them too "
                    "early. Put a STOPRE before it.",
                    m_cells.signal));
  }

  void writeLayout(base::LineNumber line, const ValueSet& value, State& state) {
    state.mayLayout = true;
    const bool isRight = !value.isUnknown && value.values.size() == 1 &&
                         value.values.front() == static_cast<double>(m_layoutNumber);
    state.mustLayout = true;  // a wrong one is told of here, not at every motion
    if (!isRight) {
      error(LintRule::WrongLayoutNumber, line,
            fmt::format(
                "R{} must be set to {} for this method, these points, cells and axes; here it is "
                "set to {}. Write R{}={}, or choose the settings for which the program was made.",
                m_cells.layout, m_layoutNumber,
                value.isUnknown || value.values.empty() ? std::string("a computed value")
                                                        : fmt::format("{}", value.values.front()),
                m_cells.layout, m_layoutNumber));
    }
  }

  [[nodiscard]] bool isClients(int cell) const {
    if (m_slotCells.contains(cell) || isWindowCell(cell) || cell == m_cells.run) {
      return true;
    }
    return m_isWindow ? cell == m_cells.delivered || cell == m_cells.client ||
                            cell == m_cells.heartbeat || cell == m_cells.overrideWanted ||
                            (m_cells.hasFactor() && cell == m_cells.factor)
                      : cell == m_cells.stop || cell == m_cells.feed;
  }

  [[nodiscard]] static bool moves(const Statement& statement) {
    const auto* words = std::get_if<Words>(&statement.what);
    return words != nullptr && summaryOf(*words).moves;
  }

  // --- loops ------------------------------------------------------------------------------

  [[nodiscard]] std::vector<std::size_t> nextOf(std::size_t at) const {
    const Exits exits = exitsOf(at);
    std::vector<std::size_t> next;
    for (const auto& exit : {exits.whenTrue, exits.whenFalse}) {
      if (!exits.ends && exit && *exit < m_statements.size() && m_isReached[*exit]) {
        next.push_back(*exit);
      }
    }
    return next;
  }

  /// Statements that can be come to from `from`, without passing one that is `closed`.
  [[nodiscard]] std::vector<bool> reachedFrom(std::size_t from,
                                              const std::vector<bool>& closed) const {
    std::vector<bool> reached(m_statements.size(), false);
    std::vector<std::size_t> due{from};
    while (!due.empty()) {
      const std::size_t at = due.back();
      due.pop_back();
      for (const std::size_t next : nextOf(at)) {
        if (!reached[next] && !closed[next]) {
          reached[next] = true;
          due.push_back(next);
        }
      }
    }
    return reached;
  }

  [[nodiscard]] std::vector<int> conditionReads(std::size_t at) const {
    const Exits exits = exitsOf(at);
    return exits.condition == nullptr ? std::vector<int>{}
                                      : evaluate(*exits.condition, m_before[at].values).reads;
  }

  void lookAtLoops() {
    const std::size_t count = m_statements.size();
    std::vector<bool> asksStop(count, false);
    std::vector<bool> stops(count, false);
    for (std::size_t at = 0; at < count; ++at) {
      if (!m_isReached[at]) {
        continue;
      }
      const std::vector<int> reads = conditionReads(at);
      asksStop[at] = std::find(reads.begin(), reads.end(), m_stopCell) != reads.end();
      stops[at] = std::holds_alternative<nc::PreprocessingStop>(m_statements[at].what) ||
                  m_statements[at].readsMainRun;
      // A loop with motion in it goes round once per window: only one without waits.
      stops[at] = stops[at] || (m_goesOn && moves(m_statements[at]));
    }
    // A question whose answers all lead back to it stops nothing.
    const std::vector<bool> candidates = asksStop;
    for (std::size_t at = 0; at < count; ++at) {
      if (!candidates[at]) {
        continue;
      }
      std::vector<bool> closed = candidates;
      closed[at] = false;
      const std::vector<std::size_t> next = nextOf(at);
      const bool ends = next.size() < 2;  // one answer goes behind the last block
      asksStop[at] = ends || std::any_of(next.begin(), next.end(), [&](std::size_t to) {
                       return to != at && !reachedFrom(to, closed)[at];
                     });
    }
    findCycles(asksStop, [this](const std::vector<std::size_t>& cycle) {
      if (!lasts(cycle) || waitsForOverlay(cycle)) {
        return;
      }
      error(
          LintRule::StopCheckMissing, m_statements[cycle.back()].place.line,
          fmt::format("The loop from line {} to here can repeat without checking R{}: a stop of "
                      "the client would not be seen. Add a condition on R{} that leaves the loop.",
                      m_statements[cycle.front()].place.line.value, m_stopCell, m_stopCell));
    });
    findCycles(stops, [this](const std::vector<std::size_t>& cycle) {
      if (m_goesOn && endsByItself(cycle)) {
        return;
      }
      for (const std::size_t at : cycle) {
        for (const int cell : conditionReads(at)) {
          if (isClients(cell) || (cell == m_cells.signal && !m_isWindow)) {
            error(
                LintRule::StopreMissing, m_statements[at].place.line,
                fmt::format(
                    "The loop checks R{} repeatedly without a STOPRE: the control may never see "
                    "what the client writes. {}",
                    cell,
                    m_goesOn ? "Count its passes, and leave it for a STOPRE if there are too many."
                             : "Put a STOPRE into the loop, before the check."));
            return;
          }
        }
      }
    });
  }

  /// Calls `found` with each set of statements that lie on common cycles, `closed` ones left out.
  template <class Found>
  void findCycles(const std::vector<bool>& closed, Found found) const {
    const std::size_t count = m_statements.size();
    std::vector<bool> isDone(count, false);
    for (std::size_t at = 0; at < count; ++at) {
      if (closed[at] || isDone[at] || !m_isReached[at]) {
        continue;
      }
      const std::vector<bool> reached = reachedFrom(at, closed);
      if (!reached[at]) {
        continue;
      }
      std::vector<std::size_t> cycle;
      for (std::size_t other = 0; other < count; ++other) {
        if (reached[other] && reachedFrom(other, closed)[at]) {
          cycle.push_back(other);
          isDone[other] = true;
        }
      }
      found(cycle);
    }
  }

  /// It can be left by a question that asks no R-parameter and nothing of the main run: passes
  /// are counted.
  [[nodiscard]] bool endsByItself(const std::vector<std::size_t>& cycle) const {
    return std::any_of(cycle.begin(), cycle.end(), [&](std::size_t at) {
      const std::vector<std::size_t> next = nextOf(at);
      return next.size() > 1 && conditionReads(at).empty() &&
             std::any_of(next.begin(), next.end(), [&](std::size_t to) {
               return std::find(cycle.begin(), cycle.end(), to) == cycle.end();
             });
    });
  }

  /// At the end of a program with correction: the axes go back to the path. It asks the main run,
  /// moves nothing and counts its passes.
  [[nodiscard]] bool waitsForOverlay(const std::vector<std::size_t>& cycle) const {
    bool asksMainRun = false;
    bool counts = false;
    for (const std::size_t at : cycle) {
      if (std::holds_alternative<Words>(m_statements[at].what) && !dwells(at)) {
        return false;
      }
      const std::vector<std::size_t> next = nextOf(at);
      const bool asks = next.size() > 1 && conditionReads(at).empty();
      asksMainRun = asksMainRun || (asks && m_statements[at].readsMainRun);
      counts = counts || (asks && !m_statements[at].readsMainRun &&
                          std::any_of(next.begin(), next.end(), [&](std::size_t to) {
                            return std::find(cycle.begin(), cycle.end(), to) == cycle.end();
                          }));
    }
    return m_cells.corrects() && asksMainRun && counts;
  }

  [[nodiscard]] bool dwells(std::size_t at) const {
    const auto* const words = std::get_if<Words>(&m_statements[at].what);
    return words != nullptr && summaryOf(*words).dwells;
  }

  /// A loop that does not wait and ends by what it computes needs no question for a stop.
  [[nodiscard]] bool lasts(const std::vector<std::size_t>& cycle) const {
    bool leaves = false;
    for (const std::size_t at : cycle) {
      const auto& what = m_statements[at].what;
      if (dwells(at) || std::holds_alternative<nc::PreprocessingStop>(what) ||
          !conditionReads(at).empty()) {
        return true;
      }
      for (const std::size_t next : nextOf(at)) {
        leaves = leaves || std::find(cycle.begin(), cycle.end(), next) == cycle.end();
      }
    }
    return !leaves;
  }

  // --- the program as a whole -------------------------------------------------------------

  void lookAtWhole() {
    const base::LineNumber last =
        m_statements.empty() ? base::LineNumber{} : m_statements.back().place.line;
    if (m_statements.empty() || m_isReached[m_statements.size()]) {
      warn(LintRule::NoEnd, last, "The program has no end after its last line. End it with M30.");
    }
    const bool hasErrors = std::any_of(m_findings.begin(), m_findings.end(), [](const auto& f) {
      return f.severity == LintSeverity::Error;
    });
    if (hasErrors) {
      return;  // what is not reached because of an error is not told again
    }
    if (m_cells.hasFeedCell()) {
      lookAtFeedCell();
    }
    for (const int cell : m_slotCells) {
      if (!m_slotsRead.contains(cell)) {
        error(LintRule::SlotNotRead, last,
              fmt::format("R{}, into which the client writes a coordinate, is never read: the "
                          "point would be left out. Move to all slots of the method.",
                          cell));
        return;
      }
    }
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      const int cell = m_cells.correction[axis];
      if (cell >= 0 && !m_corrected.contains(cell)) {
        error(LintRule::CorrectionIgnored, last,
              fmt::format(
                  "R{} is never applied to {}: the client would assume a correction that does not "
                  "take place. Write a synchronized action that applies it, within the limit.",
                  cell, base::kAxisNames[axis]));
      }
    }
    if (!m_isWindow && !m_usesClientFeed) {
      warn(LintRule::FeedNotFromClient, last,
           fmt::format("R{}, the feed of the client, is never used: the feasibility verdict would "
                       "not apply. Write F=R{} into the blocks.",
                       m_cells.feed, m_cells.feed));
    }
  }

  const nc::Tree& m_program;
  std::set<std::string, std::less<>> m_defined;  ///< variables
  std::set<std::size_t> m_alarms;                ///< statements the control complains about
  const std::vector<Statement>& m_statements;
  const TemplateParameters& m_parameters;
  const CellMap& m_cells;
  bool m_isWindow;
  bool m_goesOn;
  int m_layoutNumber;
  int m_stopCell = 0;
  std::set<int> m_slotCells;
  std::set<int> m_slotsRead;
  std::set<int> m_corrected;        ///< cells an action lays over their axis
  base::LineNumber m_overrideLine;  ///< of the last action that has to do with the override
  bool m_usesClientFeed = false;
  bool m_reports = false;
  std::vector<State> m_before;
  std::vector<bool> m_isReached;  ///< the last: the end of the text
  std::set<std::pair<LintRule, std::uint32_t>> m_found;
  std::set<LintRule> m_toldOnce;
  std::vector<LintFinding> m_findings;
};

}  // namespace

std::error_code make_error_code(LintError code) {
  static const base::NamedCategory category("lint");
  return {static_cast<int>(code), category};
}

std::string_view lintRuleName(LintRule rule) {
  static constexpr std::array<std::string_view, 25> kNames{
      "syntax",
      "unknown-name",
      "missing-label",
      "r-parameter-out-of-range",
      "r-parameter-unbounded",
      "wrong-layout-number",
      "layout-number-missing",
      "handshake-missing",
      "stopre-missing",
      "signal-ahead",
      "stop-check-missing",
      "feed-missing",
      "feed-not-from-client",
      "slot-not-read",
      "client-cell-overwritten",
      "motion-from-cells",
      "relative-motion",
      "rapid-motion",
      "not-checked",
      "no-end",
      "feed-raised",
      "correction-unbounded",
      "correction-ignored",
      "feed-cell-ignored",
      "client-not-watched",
  };
  return kNames[static_cast<std::size_t>(rule) - 1];
}

namespace {

/// The paths of programs for LinuxCNC are not followed: only the generated program, whose behaviour
/// on LinuxCNC is tested, is accepted, be it with other comments.
std::vector<LintFinding> compareWithGenerated(std::string_view text,
                                              const FlexibleProgram& generated) {
  const auto blocks = [](std::string_view program) {
    std::vector<std::pair<unsigned, std::string_view>> list;
    unsigned number = 0;
    while (!program.empty()) {
      ++number;
      const std::string_view line = program.substr(0, program.find('\n'));
      program.remove_prefix(std::min(line.size() + 1, program.size()));
      const std::string_view block = base::trim(line.substr(0, line.find(';')));
      if (!block.empty()) {
        list.emplace_back(number, block);
      }
    }
    return list;
  };
  const auto is = blocks(text);
  const auto meant = blocks(generated.text);
  const auto [here, there] =
      std::mismatch(is.begin(), is.end(), meant.begin(), meant.end(),
                    [](const auto& a, const auto& b) { return a.second == b.second; });
  std::vector<LintFinding> findings;
  if (here != is.end() || there != meant.end()) {
    const unsigned line = here != is.end() ? here->first : is.empty() ? 1 : is.back().first;
    findings.push_back({LintRule::NotChecked, LintSeverity::Error, base::LineNumber{line},
                        "differs from the program that is generated for LinuxCNC with these "
                        "settings. Other programs are not checked: generate it anew."});
  }
  return findings;
}

}  // namespace

std::vector<LintFinding> lintProgram(std::string_view text, const FlexibleProgram& meant) {
  if (meant.parameters.target == TargetControl::LinuxCnc) {
    return compareWithGenerated(text, meant);
  }
  const std::shared_ptr<const nc::Tree> program = nc::parseSinumerik(std::string(text));
  return Linter(*program, meant).run();
}

const LintFinding* firstError(const std::vector<LintFinding>& findings) {
  const auto found = std::find_if(findings.begin(), findings.end(), [](const LintFinding& finding) {
    return finding.severity == LintSeverity::Error;
  });
  return found == findings.end() ? nullptr : &*found;
}

base::Result<void> requireSound(const FlexibleProgram& program) {
  const std::vector<LintFinding> findings = lintProgram(program.text, program);
  if (const LintFinding* finding = firstError(findings)) {
    return base::fail(LintError::Rejected,
                      fmt::format("The flexible program is not written to the control. Line {}: {}",
                                  finding->line.value, finding->message));
  }
  return {};
}

}  // namespace rivulet::templates
