// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "templates/methods/untried.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace rivulet::templates {

namespace {

/// The program's own variables, which no client writes.
enum Variable {
  Latched,  ///< windows copied; executed as well, since the axes stop after each
  Owner,    ///< run that the program obeys
  Beat,     ///< heartbeat, as read last
  Idle,     ///< passes without a window and without a change of the heartbeat
  Window,   ///< first cell of the next window
  Cell,     ///< that is read
  Points,   ///< of the window; negative: the last one
  Feed,     ///< mm/min
  Sum,      ///< by which the check number is wrong
  Count,    ///< of the points to move to
  Go,       ///< a window can be taken
  Asked,    ///< value of a cell
  End,      ///< state with which the program ends; 0: it goes on
  Copies,   ///< the first copied value of the window
};
constexpr std::array<std::string_view, Copies> kNames{"Latched", "Owner",  "Beat", "Idle", "Window",
                                                      "Cell",    "Points", "Feed", "Sum",  "Count",
                                                      "Go",      "Asked",  "End"};

/// Below this a check number is right.
constexpr double kSumMax = 0.000001;

}  // namespace

class StructuredLanguage {
 public:
  StructuredLanguage() = default;
  StructuredLanguage(const StructuredLanguage&) = delete;
  StructuredLanguage& operator=(const StructuredLanguage&) = delete;
  virtual ~StructuredLanguage() = default;

  [[nodiscard]] virtual TargetControl target() const = 0;
  /// Of the cells, in a title.
  [[nodiscard]] virtual std::string_view source() const = 0;
  /// A letter of the file's name.
  [[nodiscard]] virtual std::string_view letter() const = 0;
  /// Largest number of a cell.
  [[nodiscard]] virtual int cellMax() const = 0;
  [[nodiscard]] virtual std::string comment(std::string_view text) const = 0;
  /// What a person has to set up. One line each.
  [[nodiscard]] virtual std::vector<std::string> notes(const CellMap& cells) const = 0;
  [[nodiscard]] virtual std::string name(int variable) const = 0;
  /// Declarations and units. @param copies  values of a window
  virtual void begin(Listing& out, int copies) const = 0;
  virtual void end(Listing& out) const = 0;
  virtual void assign(Listing& out, int variable, const std::string& value) const = 0;
  /// The cell whose number is in a variable.
  virtual void read(Listing& out, int variable, int numberIn) const = 0;
  virtual void write(Listing& out, int cell, const std::string& value) const = 0;
  /// @param comparison  "<", ">" or "=" of numbers
  virtual void beginIf(Listing& out, const std::string& left, std::string_view comparison,
                       const std::string& right) const = 0;
  virtual void otherwise(Listing& out) const = 0;
  virtual void endIf(Listing& out) const = 0;
  virtual void beginWhileZero(Listing& out, int variable) const = 0;
  virtual void endWhile(Listing& out) const = 0;
  /// Until all blocks before it have been executed.
  virtual void awaitAxes(Listing& out) const = 0;
  /// 20 ms.
  virtual void pause(Listing& out) const = 0;
  /// "G1" to copied values. @param feed  variable
  virtual void move(Listing& out, std::string_view letters, int firstCopy, int feed) const = 0;
};

namespace {

class GstLanguage final : public StructuredLanguage {
 public:
  [[nodiscard]] TargetControl target() const override { return TargetControl::TwinCat; }
  [[nodiscard]] std::string_view source() const override { return "R-PARAMETERS, TWINCAT NC I"; }
  [[nodiscard]] std::string_view letter() const override { return "T"; }
  /// R900 to R999 are shared by all channels.
  [[nodiscard]] int cellMax() const override { return 899; }
  [[nodiscard]] std::string comment(std::string_view text) const override {
    return fmt::format("//{}", text);
  }
  [[nodiscard]] std::vector<std::string> notes(const CellMap&) const override {
    return {
        " For the GST interpreter. No OPC UA server of TwinCAT shows R-parameters: a PLC program",
        " copies them from and to an array of it (ItpReadRParamsEx, ItpWriteRParamsEx)."};
  }
  [[nodiscard]] std::string name(int variable) const override {
    return variable < Copies ? fmt::format("riv{}", kNames[static_cast<std::size_t>(variable)])
                             : fmt::format("rivCopy{}", variable - Copies);
  }
  void begin(Listing& out, int copies) const override {
    out.line("{{");
    out.line("VAR");
    for (int variable = 0; variable < Copies + copies; ++variable) {
      const bool isNumberOfCell = variable == Window || variable == Cell;
      out.line("  {} : {};", name(variable), isNumberOfCell ? "LINT" : "LREAL");
    }
    out.line("END_VAR");
    out.line("unitLengthSet(unitLengthMillimeter);");
    out.line("unitTimeSet(unitTimeSecond);");
    out.line("unitVelocitySet(unitLengthMillimeter, unitTimeMinute);");
    out.line("! G90");
  }
  void end(Listing& out) const override {
    out.line("}}");
    out.line("M30");
  }
  void assign(Listing& out, int variable, const std::string& value) const override {
    out.line("{} := {};", name(variable), value);
  }
  void read(Listing& out, int variable, int numberIn) const override {
    out.line("{} := rGet({});", name(variable), name(numberIn));
  }
  void write(Listing& out, int cell, const std::string& value) const override {
    out.line("R{} := {};", cell, value);
  }
  void beginIf(Listing& out, const std::string& left, std::string_view comparison,
               const std::string& right) const override {
    out.line("IF {} {} {} THEN", left, comparison, right);
  }
  void otherwise(Listing& out) const override { out.line("ELSE"); }
  void endIf(Listing& out) const override { out.line("END_IF;"); }
  void beginWhileZero(Listing& out, int variable) const override {
    out.line("WHILE {} = 0 DO", name(variable));
  }
  void endWhile(Listing& out) const override { out.line("END_WHILE;"); }
  void awaitAxes(Listing& out) const override { out.line("sync();"); }
  void pause(Listing& out) const override { out.line("! G04 X0.02"); }
  void move(Listing& out, std::string_view letters, int firstCopy, int feed) const override {
    std::string words;
    for (const char letter : letters) {
      words += fmt::format("{}{{{}}} ", letter, name(firstCopy++));
    }
    out.line("! G01 {}F{{{}}}", words, name(feed));
  }
};

class IsgLanguage final : public StructuredLanguage {
 public:
  [[nodiscard]] TargetControl target() const override { return TargetControl::Isg; }
  [[nodiscard]] std::string_view source() const override {
    return "EXTERNAL VARIABLES, ISG KERNEL";
  }
  [[nodiscard]] std::string_view letter() const override { return "I"; }
  [[nodiscard]] int cellMax() const override { return std::numeric_limits<int>::max(); }
  /// A comment in parentheses has none in it.
  [[nodiscard]] std::string comment(std::string_view text) const override {
    std::string inner(text);
    std::replace(inner.begin(), inner.end(), '(', '[');
    std::replace(inner.begin(), inner.end(), ')', ']');
    return fmt::format("({})", inner);
  }
  [[nodiscard]] std::vector<std::string> notes(const CellMap& cells) const override {
    std::vector<std::string> notes{
        fmt::format(
            " R<n> is V.E.RIVULET[n]. In the list of external variables: name RIVULET, type "
            "REAL64,"),
        fmt::format(" array_elements {}, access_rights READ_WRITE, synchronisation FALSE.",
                    cells.last() + 1)};
    for (int variable = 0; variable < Copies; ++variable) {
      notes.push_back(
          fmt::format(" {} {}", name(variable), kNames[static_cast<std::size_t>(variable)]));
    }
    notes.push_back(fmt::format(" {} and on: copy of the window", name(Copies)));
    return notes;
  }
  /// There is no P0.
  [[nodiscard]] std::string name(int variable) const override {
    return fmt::format("P{}", variable + 1);
  }
  void begin(Listing& out, int) const override { out.line("G90 G94"); }
  void end(Listing& out) const override { out.line("M30"); }
  void assign(Listing& out, int variable, const std::string& value) const override {
    out.line("{} = {}", name(variable), value);
  }
  void read(Listing& out, int variable, int numberIn) const override {
    out.line("{} = V.E.RIVULET[{}]", name(variable), name(numberIn));
  }
  void write(Listing& out, int cell, const std::string& value) const override {
    out.line("V.E.RIVULET[{}] = {}", cell, value);
  }
  void beginIf(Listing& out, const std::string& left, std::string_view comparison,
               const std::string& right) const override {
    out.line("$IF {} {} {}", left, comparison == "=" ? "==" : comparison, right);
  }
  void otherwise(Listing& out) const override { out.line("$ELSE"); }
  void endIf(Listing& out) const override { out.line("$ENDIF"); }
  void beginWhileZero(Listing& out, int variable) const override {
    out.line("$WHILE {} == 0", name(variable));
  }
  void endWhile(Listing& out) const override { out.line("$ENDWHILE"); }
  void awaitAxes(Listing& out) const override { out.line("#FLUSH WAIT"); }
  void pause(Listing& out) const override { out.line("#TIME 0.02"); }
  void move(Listing& out, std::string_view letters, int firstCopy, int feed) const override {
    std::string words;
    for (const char letter : letters) {
      words += fmt::format("{}{} ", letter, name(firstCopy++));
    }
    out.line("G01 {}F{}", words, name(feed));
  }
};

/// Lines of another language as comments of this one.
void writeAsComments(Listing& out, const StructuredLanguage& language, std::string_view lines) {
  while (!lines.empty()) {
    const std::string_view line = lines.substr(0, lines.find('\n'));
    lines.remove_prefix(std::min(line.size() + 1, lines.size()));
    out.line("{}", language.comment(line.substr(line.empty() ? 0 : 1)));
  }
}

}  // namespace

const StructuredLanguage& TwinCatWindowTemplate::language() const {
  static const GstLanguage language;
  return language;
}

const StructuredLanguage& IsgWindowTemplate::language() const {
  static const IsgLanguage language;
  return language;
}

base::Result<void> UntriedWindowTemplate::check(const TemplateParameters& parameters) const {
  const std::string_view title = targetTitle(language().target());
  if (parameters.correctionLimitMm != 0.0) {
    return base::fail(
        TemplateError::NotOnTarget,
        fmt::format("There is no online correction for {}: choose a limit of 0.", title));
  }
  if (base::any(parameters.rotaryAxes)) {
    return base::fail(
        TemplateError::NotOnTarget,
        fmt::format("The program for {} moves only X, Y and Z: leave out rotary axes.", title));
  }
  if (base::Result<void> windows = WindowTemplate::check(parameters); !windows) {
    return windows;
  }
  const int last = cells(parameters).last();
  if (last > language().cellMax()) {
    return base::fail(TemplateError::DoesNotFit,
                      fmt::format("The cells reach R{}, but for {} R{} is the last: choose fewer "
                                  "points or windows.",
                                  last, title, language().cellMax()));
  }
  return {};
}

std::string UntriedWindowTemplate::nameSuffix(const TemplateParameters& parameters) const {
  return WindowTemplate::nameSuffix(parameters) + std::string(language().letter());
}

std::string UntriedWindowTemplate::program(const TemplateParameters& parameters,
                                           const CellMap& cells, int layoutNumber) const {
  const StructuredLanguage& in = language();
  Listing out;
  writeComments(out, parameters, cells);
  in.begin(out, cells.pointsPerLoop * copiedPerPoint(cells));
  writeStart(out, cells);
  // A client that sees this number knows that the other cells have been reset.
  in.write(out, cells.layout, std::to_string(layoutNumber));
  in.beginWhileZero(out, End);
  in.awaitAxes(out);
  in.write(out, cells.latched, in.name(Latched));
  in.write(out, cells.executed, in.name(Latched));
  writeQuestion(out, cells);
  in.beginIf(out, in.name(Go), ">", "0");
  writeTaking(out, cells);
  writeMotion(out, cells);
  in.otherwise(out);
  writeWaiting(out, cells);
  in.endIf(out);
  in.endWhile(out);
  in.awaitAxes(out);
  in.write(out, cells.executed, in.name(Latched));
  in.write(out, cells.state, in.name(End));
  in.end(out);
  return out.take();
}

void UntriedWindowTemplate::writeComments(Listing& out, const TemplateParameters& parameters,
                                          const CellMap& cells) const {
  const StructuredLanguage& in = language();
  const Wording wording{in.source(), "copied by this program: their cells may be written again"};
  out.line("{}", in.comment(" UNTRIED: WRITTEN FROM DOCUMENTATION, NEVER RUN ON A CONTROL."));
  out.line("{}", in.comment(
                     " Whoever runs it first does so without a tool and with a hand on the stop."));
  Listing lines;
  writeTitle(lines, parameters, cells, wording);
  writeHeaderCells(lines, cells, wording);
  writeAsComments(out, in, lines.take());
  for (const std::string& note : in.notes(cells)) {
    out.line("{}", in.comment(note));
  }
}

void UntriedWindowTemplate::writeStart(Listing& out, const CellMap& cells) const {
  const StructuredLanguage& in = language();
  for (const int cell : {cells.run, cells.delivered, cells.latched, cells.executed, cells.state,
                         cells.client, cells.owner}) {
    in.write(out, cell, "0");
  }
  for (const int variable : {Latched, Owner, Idle, End}) {
    in.assign(out, variable, "0");
  }
  in.assign(out, Window, std::to_string(cells.windowCount(0)));
  in.awaitAxes(out);
  in.assign(out, Cell, std::to_string(cells.heartbeat));
  in.read(out, Beat, Cell);
}

/// Sets `Go` if a window can be taken, `End` if the client wants the end.
void UntriedWindowTemplate::writeQuestion(Listing& out, const CellMap& cells) const {
  const StructuredLanguage& in = language();
  in.assign(out, Go, "0");
  in.assign(out, Cell, std::to_string(cells.run));
  in.read(out, Asked, Cell);
  in.beginIf(out, in.name(Asked), ">", std::to_string(WindowProtocol::kRun));
  in.assign(out, End, std::to_string(static_cast<int>(WindowState::Stopped)));
  in.otherwise(out);
  in.beginIf(out, in.name(Asked), ">", std::to_string(WindowProtocol::kHold));
  in.beginIf(out, in.name(Owner), ">", "0");
  in.assign(out, Cell, std::to_string(cells.delivered));
  in.read(out, Asked, Cell);
  in.assign(out, Asked, fmt::format("{} - {}", in.name(Asked), in.name(Latched)));
  in.beginIf(out, in.name(Asked), ">", "0");
  in.beginIf(out, in.name(Asked), "<", std::to_string(cells.windows + 1));
  in.assign(out, Go, "1");
  for (int level = 0; level < 5; ++level) {
    in.endIf(out);
  }
}

/// First a copy, then the check of the copy: whatever is written meanwhile, and by whom, the axes
/// move to the positions sent by the client of this run.
void UntriedWindowTemplate::writeTaking(Listing& out, const CellMap& cells) const {
  const StructuredLanguage& in = language();
  const auto take = [&](int variable, int offset) {
    in.assign(out, Cell, fmt::format("{} + {}", in.name(Window), offset));
    in.read(out, variable, Cell);
  };
  in.assign(out, Idle, "0");
  take(Points, WindowProtocol::Count);
  take(Feed, WindowProtocol::Feed);
  take(Sum, WindowProtocol::Check);
  std::vector<std::string> terms;
  for (int place = 0; place < cells.pointsPerLoop; ++place) {
    for (int value = 0; value < copiedPerPoint(cells); ++value) {
      const int number = place * copiedPerPoint(cells) + value;
      take(Copies + number, WindowProtocol::WindowCells + place * cells.slotStride + value);
      terms.push_back(fmt::format("{:.6f} * {}", WindowProtocol::checkFactor(number),
                                  in.name(Copies + number)));
    }
  }
  in.assign(out, Sum,
            fmt::format("{} + {} * {} + {} + {} * {} + {} * {} - {}", in.name(Owner),
                        WindowProtocol::kCheckNumber, in.name(Latched),
                        WindowProtocol::kCheckNumber, WindowProtocol::kCheckCount, in.name(Points),
                        WindowProtocol::kCheckFeed, in.name(Feed), in.name(Sum)));
  for (const std::string& term : terms) {
    in.assign(out, Sum, fmt::format("{} + {}", in.name(Sum), term));
  }
  // No comparison holds for a value that is not a number: such a window is damaged too.
  in.assign(out, End, std::to_string(static_cast<int>(WindowState::Damaged)));
  in.beginIf(out, in.name(Sum), "<", fmt::format("{:.6f}", kSumMax));
  in.beginIf(out, in.name(Sum), ">", fmt::format("-{:.6f}", kSumMax));
  in.assign(out, End, "0");
  in.endIf(out);
  in.endIf(out);
}

void UntriedWindowTemplate::writeMotion(Listing& out, const CellMap& cells) const {
  const StructuredLanguage& in = language();
  in.beginIf(out, in.name(End), "=", "0");
  in.assign(out, Latched, fmt::format("{} + 1", in.name(Latched)));
  in.write(out, cells.latched, in.name(Latched));
  in.assign(out, Window, fmt::format("{} + {}", in.name(Window), cells.windowStride));
  in.beginIf(out, in.name(Window), ">", std::to_string(cells.windowCount(cells.windows - 1)));
  in.assign(out, Window, std::to_string(cells.windowCount(0)));
  in.endIf(out);
  in.assign(out, Count, in.name(Points));
  in.beginIf(out, in.name(Points), "<", "0");
  in.assign(out, Count, fmt::format("0 - {}", in.name(Points)));
  in.endIf(out);
  const std::string letters = lettersOf(cells);
  for (int place = 0; place < cells.pointsPerLoop; ++place) {
    const int first = Copies + place * copiedPerPoint(cells);
    const int feed = cells.feedPerPoint ? first + static_cast<int>(letters.size()) : int{Feed};
    in.beginIf(out, in.name(Count), ">", std::to_string(place));
    in.move(out, letters, first, feed);
    in.endIf(out);
  }
  in.beginIf(out, in.name(Points), "<", "1");
  in.assign(out, End, std::to_string(static_cast<int>(WindowState::Done)));
  in.endIf(out);
  in.endIf(out);
}

/// Nothing to do: the program looks whether the client is there, and obeys the first run that asks.
void UntriedWindowTemplate::writeWaiting(Listing& out, const CellMap& cells) const {
  const StructuredLanguage& in = language();
  in.assign(out, Cell, std::to_string(cells.heartbeat));
  in.read(out, Asked, Cell);
  in.beginIf(out, in.name(Asked), "=", in.name(Beat));
  in.assign(out, Idle, fmt::format("{} + 1", in.name(Idle)));
  in.otherwise(out);
  in.assign(out, Beat, in.name(Asked));
  in.assign(out, Idle, "0");
  in.endIf(out);
  in.beginIf(out, in.name(Idle), ">", std::to_string(kSilentPassesMax));
  in.beginIf(out, in.name(End), "=", "0");
  in.assign(out, End, std::to_string(static_cast<int>(WindowState::Abandoned)));
  in.endIf(out);
  in.endIf(out);
  in.beginIf(out, in.name(Owner), "=", "0");
  in.assign(out, Cell, std::to_string(cells.client));
  in.read(out, Owner, Cell);
  in.write(out, cells.owner, in.name(Owner));
  in.endIf(out);
  in.pause(out);
}

}  // namespace rivulet::templates
