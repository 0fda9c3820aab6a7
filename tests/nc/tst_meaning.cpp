// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// What programs mean, case by case: the tables in tests/nc/meaning/<dialect>/*.toml say which path
/// a few lines of program give, and which page of a manual says so. docs/programs.md tells how a
/// case is written. Every difference is printed at the end.

#include <fmt/format.h>

#include <toml++/toml.h>
#include <QtTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "base/text.h"
#include "base/units.h"
#include "gcode/program.h"
#include "nc/evaluated_path.h"
#include "support/test_program.h"

using namespace rivulet;

namespace {

constexpr std::array kAxes{'X', 'Y', 'Z', 'A', 'B', 'C'};
constexpr std::array kCentres{'I', 'J', 'K'};
constexpr double kTolerance = 1e-9;
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// One line of `path`, or one move of the trajectory. mm, degrees, mm/min (degrees/min if it only
/// turns); NaN: not known, or nothing is said of it.
struct Step {
  std::array<double, kAxes.size()> axes{kUnknown, kUnknown, kUnknown, kUnknown, kUnknown, kUnknown};
  double feedPerMin = kUnknown;
  std::optional<bool> rapid;
  bool arc = false;
  std::optional<bool> counterclockwise;  ///< seen from the positive third axis of its plane
  std::array<double, kCentres.size()> centre{kUnknown, kUnknown, kUnknown};
  double turnDeg = kUnknown;
};

std::string printed(const Step& step) {
  std::string text;
  const auto add = [&text](std::string_view name, double value) {
    if (!std::isnan(value)) {
      text += fmt::format("{}{}{:.12g}", text.empty() ? "" : " ", name, value + 0.0);
    }
  };
  for (std::size_t i = 0; i < kAxes.size(); ++i) {
    add(std::string(1, kAxes[i]), step.axes[i]);
  }
  if (step.rapid && *step.rapid) {
    text += " rapid";
  }
  if (step.arc) {
    text += !step.counterclockwise ? " arc" : *step.counterclockwise ? " ccw" : " cw";
  }
  for (std::size_t i = 0; i < kCentres.size(); ++i) {
    add(std::string(1, kCentres[i]), step.centre[i]);
  }
  add("turn=", step.turnDeg);
  add("F", step.feedPerMin);
  return text.empty() ? "(no axis)" : text;
}

struct Case {
  std::string name;
  std::string program;
  std::vector<Step> path;
  bool hasPath = false;
  std::optional<Step> end;
  std::string refused;    ///< what a finding that stops the load must name; empty: none stops it
  std::string mayRefuse;  ///< the same, where the path would be right as well
  std::vector<std::string> findings;
  std::vector<std::string> words;  ///< for the machine, in this order
  std::string pending;
  double tolerance = kTolerance;
  gcode::LoadOptions options;
  std::map<std::string, std::string> files;
};

/// A case that is not written as it must be.
struct Malformed {
  std::string what;
};

double numberOf(std::string_view word, std::string_view digits) {
  const std::optional<double> value = base::parseNumber(digits);
  if (!value) {
    throw Malformed{fmt::format("\"{}\" is not a word of a path", word)};
  }
  return *value;
}

/// "X10 Y5 ccw I5 J0 F300"; what it does not name is as in the step before.
Step stepOf(const std::string& line, const Step& before) {
  Step step;
  step.axes = before.axes;
  std::istringstream words(line);
  for (std::string word; words >> word;) {
    if (word == "rapid") {
      step.rapid = true;
    } else if (word == "arc" || word == "cw" || word == "ccw") {
      step.arc = true;
      if (word != "arc") {
        step.counterclockwise = word == "ccw";
      }
    } else if (word.starts_with("turn=")) {
      step.turnDeg = numberOf(word, std::string_view(word).substr(5));
    } else if (word[0] == 'F') {
      step.feedPerMin = numberOf(word, std::string_view(word).substr(1));
      step.rapid = false;
    } else if (const auto* axis = std::find(kAxes.begin(), kAxes.end(), word[0]);
               axis != kAxes.end()) {
      step.axes[static_cast<std::size_t>(axis - kAxes.begin())] =
          numberOf(word, std::string_view(word).substr(1));
    } else if (const auto* centre = std::find(kCentres.begin(), kCentres.end(), word[0]);
               centre != kCentres.end()) {
      step.centre[static_cast<std::size_t>(centre - kCentres.begin())] =
          numberOf(word, std::string_view(word).substr(1));
    } else {
      throw Malformed{fmt::format("\"{}\" is not a word of a path", word)};
    }
  }
  return step;
}

std::vector<Step> stepsOf(const std::string& text) {
  std::vector<Step> steps;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    line.resize(std::min(line.find('#'), line.size()));
    if (line.find_first_not_of(" \t") != std::string::npos) {
      steps.push_back(stepOf(line, steps.empty() ? Step{} : steps.back()));
    }
  }
  return steps;
}

std::string textOf(const toml::table& table, std::string_view key) {
  const toml::node* const node = table.get(key);
  if (node == nullptr) {
    return {};
  }
  if (!node->is_string()) {
    throw Malformed{fmt::format("{} must be a text", key)};
  }
  return **node->as_string();
}

std::vector<std::string> textsOf(const toml::table& table, std::string_view key) {
  std::vector<std::string> texts;
  if (const toml::array* const array = table[key].as_array()) {
    for (const toml::node& each : *array) {
      texts.push_back(each.value_or(std::string()));
    }
  }
  return texts;
}

Case caseOf(const toml::table& table, nc::Dialect dialect) {
  static constexpr std::array<std::string_view, 16> kKeys{
      "name",  "program", "path",    "end",       "refused", "findings",   "words", "pending",
      "files", "source",  "checked", "tolerance", "accept",  "block_skip", "note",  "may_refuse"};
  for (const auto& [key, value] : table) {
    if (std::find(kKeys.begin(), kKeys.end(), key.str()) == kKeys.end()) {
      throw Malformed{fmt::format("{} is not a key of a case", key.str())};
    }
  }
  Case made;
  made.name = textOf(table, "name");
  made.program = textOf(table, "program");
  made.refused = textOf(table, "refused");
  made.mayRefuse = textOf(table, "may_refuse");
  made.findings = textsOf(table, "findings");
  made.words = textsOf(table, "words");
  made.pending = textOf(table, "pending");
  made.hasPath = table.contains("path");
  made.path = stepsOf(textOf(table, "path"));
  made.tolerance = table["tolerance"].value_or(kTolerance);
  if (table.contains("end")) {
    made.end = stepOf(textOf(table, "end"), {});
  }
  if (made.name.empty() || made.program.empty() || textOf(table, "source").empty()) {
    throw Malformed{"a case needs name, program and source"};
  }
  if (!made.hasPath && !made.end && made.refused.empty() && made.words.empty()) {
    throw Malformed{"a case needs path, end, words or refused: else nothing can be wrong"};
  }
  if (const toml::table* const files = table["files"].as_table()) {
    for (const auto& [name, text] : *files) {
      made.files[std::string(name.str())] = text.value_or(std::string());
    }
  }
  made.options.dialect = dialect;
  made.options.keepArcs = true;
  made.options.repeatedLinesMax = 5000;
  made.options.blockSkip = table["block_skip"].value_or(false);
  made.options.accepted = textsOf(table, "accept");
  return made;
}

// --- what Rivulet makes of it -------------------------------------------------------------------

/// The moves of the trajectory; those that go nowhere are none.
std::vector<Step> movesOf(const gcode::Trajectory& trajectory) {
  std::vector<Step> moves;
  auto arc = trajectory.arcs.begin();
  for (std::size_t i = 0; i < trajectory.points.size(); ++i) {
    const gcode::TrajectoryPoint& point = trajectory.points[i];
    Step move;
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      move.axes[axis] = point.positionMm[axis];
    }
    for (std::size_t axis = 0; !trajectory.rotary.empty() && axis < base::kRotaryAxisCount;
         ++axis) {
      move.axes[base::kAxisCount + axis] = trajectory.rotary[i].degrees[axis];
    }
    move.rapid = point.kind == gcode::MoveKind::Rapid;
    if (!*move.rapid) {
      move.feedPerMin = base::mmPerMinFromMmPerS(point.feedMmPerS);
    }
    if (point.kind == gcode::MoveKind::Arc) {
      for (; arc != trajectory.arcs.end() && arc->point < i;) {
        ++arc;
      }
      move.arc = true;
      double greatest = 0.0;
      for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
        move.centre[axis] = arc->centreMm[axis];
        greatest = std::abs(arc->axis[axis]) > std::abs(greatest) ? arc->axis[axis] : greatest;
      }
      move.counterclockwise = greatest > 0.0;
      move.turnDeg = arc->sweepRad * 180.0 / std::acos(-1.0);
    }
    const auto stays = [&](std::size_t axis) {
      const double before = moves.empty() ? kUnknown : moves.back().axes[axis];
      return move.axes[axis] == before || (std::isnan(move.axes[axis]) && std::isnan(before));
    };
    bool moved = move.arc;
    for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
      moved = moved || !stays(axis);
    }
    if (moved) {
      moves.push_back(move);
    }
  }
  return moves;
}

std::string wordOf(const gcode::PathEvent& event, const gcode::Trajectory& trajectory) {
  const auto letter = [&event](std::string_view name) {
    return fmt::format("{}{:g}", name, event.value);
  };
  switch (event.kind) {
    case nc::MachineWord::Spindle:
      return letter("S");
    case nc::MachineWord::M:
      return letter("M");
    case nc::MachineWord::Tool:
      return letter("T");
    case nc::MachineWord::Dwell:
      return letter("dwell ");
    case nc::MachineWord::Edge:
      return letter("D");
    case nc::MachineWord::NamedTool:
      return "T=" + trajectory.toolNames[static_cast<std::size_t>(event.value)];
  }
  return {};
}

// --- where they differ --------------------------------------------------------------------------

/// A trajectory names no axis that the program has not; what the case leaves out is not compared.
bool differs(double expected, double got, double tolerance, bool always) {
  if (std::isnan(expected)) {
    return always && !std::isnan(got);
  }
  return !(std::abs(expected - got) <= tolerance);
}

bool differs(const Step& expected, const Step& got, double tolerance) {
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
    if (differs(expected.axes[axis], got.axes[axis], tolerance, true)) {
      return true;
    }
  }
  for (std::size_t axis = 0; axis < kCentres.size(); ++axis) {
    if (differs(expected.centre[axis], got.centre[axis], tolerance, false)) {
      return true;
    }
  }
  const double feedTolerance = tolerance * std::max(1.0, std::abs(expected.feedPerMin));
  return expected.arc != got.arc || (expected.rapid && expected.rapid != got.rapid) ||
         (expected.counterclockwise && expected.counterclockwise != got.counterclockwise) ||
         differs(expected.turnDeg, got.turnDeg, tolerance, false) ||
         differs(expected.feedPerMin, got.feedPerMin, feedTolerance, false);
}

/// As a word of its own, in large or small letters.
bool isNamed(const std::string& sought, const std::string& text) {
  const std::string word = base::toUpper(sought);
  const std::string sentence = base::toUpper(text);
  const auto isPart = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
  for (std::size_t at = sentence.find(word); at != std::string::npos;
       at = sentence.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const bool startsWord = at == 0 || !isPart(word.front()) || !isPart(sentence[at - 1]);
    const bool endsWord = end == sentence.size() || !isPart(word.back()) || !isPart(sentence[end]);
    if (startsWord && endsWord) {
      return true;
    }
  }
  return false;
}

/// With its further files beside it.
base::Result<gcode::Program> programOf(const Case& which) {
  if (which.files.empty()) {
    gcode::LoadOptions options = which.options;
    options.subprogram = [](std::string_view) { return std::nullopt; };
    return gcode::interpretProgram("case", which.program, options);
  }
  const QTemporaryDir folder;
  const std::filesystem::path path = folder.path().toStdString();
  for (const auto& [name, text] : which.files) {
    std::ofstream(path / name, std::ios::binary) << text;
  }
  std::ofstream(path / "case", std::ios::binary) << which.program;
  return gcode::loadProgram(path / "case", which.options);
}

/// @return one line each; none: Rivulet reads the program as the case says
std::vector<std::string> differencesOf(const Case& which) {
  const base::Result<gcode::Program> program = programOf(which);
  std::vector<std::string> errors;
  std::vector<std::string> sentences;
  if (!program) {
    errors.push_back(program.error().message);
    sentences = errors;
  } else {
    for (const gcode::Diagnostic& diagnostic : program->diagnostics) {
      sentences.push_back(gcode::describe(diagnostic));
      if (diagnostic.severity == gcode::Severity::Error) {
        errors.push_back(fmt::format("line {}: {}", diagnostic.line.value, sentences.back()));
      }
    }
  }
  const auto names = [](const std::vector<std::string>& in, const std::string& word) {
    return std::any_of(in.begin(), in.end(),
                       [&word](const std::string& each) { return isNamed(word, each); });
  };
  std::vector<std::string> differences;
  if (!which.mayRefuse.empty() && names(errors, which.mayRefuse)) {
    return differences;
  }
  if (which.refused.empty() && !errors.empty()) {
    differences.push_back("expected a program that is understood\n      got " + errors.front());
  } else if (!which.refused.empty() && !names(errors, which.refused)) {
    differences.push_back(fmt::format("expected {} to be refused by name\n      got {}",
                                      which.refused,
                                      errors.empty() ? "no refusal" : errors.front()));
  }
  for (const std::string& finding : which.findings) {
    if (!names(sentences, finding)) {
      differences.push_back(
          fmt::format("expected a finding that names \"{}\"\n      got none", finding));
    }
  }
  if (!program) {
    return differences;
  }
  const std::vector<Step> moves = movesOf(program->trajectory);
  for (std::size_t i = 0; which.hasPath && i < std::max(moves.size(), which.path.size()); ++i) {
    const bool both = i < moves.size() && i < which.path.size();
    if (!both || differs(which.path[i], moves[i], which.tolerance)) {
      differences.push_back(
          fmt::format("move {}: expected {}\n      got {}", i + 1,
                      i < which.path.size() ? printed(which.path[i]) : "the end of the path",
                      i < moves.size() ? printed(moves[i]) : "the end of the path"));
      break;  // what follows differs for the same reason
    }
  }
  if (which.end) {
    Step last = moves.empty() ? Step{} : moves.back();
    last.arc = which.end->arc;
    if (differs(*which.end, last, which.tolerance)) {
      differences.push_back(
          fmt::format("end: expected {}\n      got {}", printed(*which.end), printed(last)));
    }
  }
  std::string said;
  auto expected = which.words.begin();
  for (const gcode::PathEvent& event : program->trajectory.events) {
    const std::string word = wordOf(event, program->trajectory);
    said += said.empty() ? word : ", " + word;
    expected += expected != which.words.end() && *expected == word ? 1 : 0;
  }
  if (expected != which.words.end()) {
    differences.push_back(fmt::format("expected the word {}\n      got {}", *expected, said));
  }
  return differences;
}

/// What the second evaluator makes of it.
std::vector<Step> movesOf(const tests::Evaluation& evaluation) {
  std::vector<Step> moves;
  for (const tests::EvaluatedMove& each : tests::withoutRests(evaluation.moves)) {
    Step move;
    move.axes = each.end;
    move.rapid = each.kind == tests::EvaluatedMove::Kind::Rapid;
    move.feedPerMin = *move.rapid ? kUnknown : each.feed;
    move.arc = each.kind == tests::EvaluatedMove::Kind::Arc;
    if (move.arc) {
      move.centre = {each.centre.x, each.centre.y, each.centre.z};
      move.turnDeg = each.sweepDeg;
      move.counterclockwise = each.axis.x + each.axis.y + each.axis.z > 0.0;
    }
    moves.push_back(move);
  }
  return moves;
}

tests::Evaluation evaluationOf(const Case& which, const std::string& folder) {
  return tests::evaluate(folder, which.program,
                         [&which](std::string_view name) -> std::optional<std::string> {
                           for (const auto& [file, text] : which.files) {
                             if (tests::isFileOf(file, name)) {
                               return text;
                             }
                           }
                           return std::nullopt;
                         });
}

/// @return where it does not find the path of the case; ""; it does
std::string secondDifference(const Case& which, const std::vector<Step>& moves) {
  for (std::size_t i = 0; which.hasPath && i < std::max(moves.size(), which.path.size()); ++i) {
    const bool both = i < moves.size() && i < which.path.size();
    if (!both || differs(which.path[i], moves[i], which.tolerance)) {
      return fmt::format("move {}: expected {}, evaluated {}", i + 1,
                         i < which.path.size() ? printed(which.path[i]) : "the end of the path",
                         i < moves.size() ? printed(moves[i]) : "the end of the path");
    }
  }
  Step last = moves.empty() ? Step{} : moves.back();
  last.arc = which.end && which.end->arc;
  return which.end && differs(*which.end, last, which.tolerance)
             ? fmt::format("end: expected {}, evaluated {}", printed(*which.end), printed(last))
             : std::string();
}

std::filesystem::path casesFolder() {
  return std::filesystem::path(RIVULET_SOURCE_DIR) / "tests/nc/meaning";
}

/// Folders of controls that Rivulet reads as one dialect.
nc::Dialect dialectOfFolder(const std::string& folder) {
  return nc::dialectOfName(folder).value_or(nc::Dialect::Fanuc);
}

}  // namespace

class TestMeaning : public QObject {
  Q_OBJECT

  struct Count {
    std::size_t cases = 0;
    std::size_t pending = 0;
  };
  std::map<std::string, Count> m_counts;
  std::vector<std::string> m_pending;
  std::vector<std::string> m_differences;

  /// Reads a case from its text, as a file holds it.
  static std::vector<std::string> judged(const char* text) {
    const toml::table file = toml::parse(std::string_view(text));
    return differencesOf(caseOf(file, nc::Dialect::LinuxCnc));
  }

 private Q_SLOTS:
  /// A wrong case must fail, else a right one says nothing.
  void tellsDifferences_data() {
    QTest::addColumn<QByteArray>("expectation");
    QTest::addColumn<QByteArray>("difference");  // part of it; empty: there is none
    const auto row = [](const char* name, const char* expectation, const char* difference) {
      QTest::newRow(name) << QByteArray(expectation) << QByteArray(difference);
    };
    const char* const right = "path = '''\nX0 Y0 rapid\nX10 F100\nX20 Y10 ccw J10 I10 F100'''";
    row("right", right, "");
    row("right end", "end = 'X20 Y10'", "");
    row("end", "end = 'X20 Y11'", "got X20 Y10");
    row("place", "path = '''\nX0 Y0\nX11\nX20 Y10 ccw'''", "move 2: expected X11 Y0");
    row("a move too few", "path = '''\nX0 Y0\nX10'''", "move 3: expected the end");
    row("a move too many", "path = '''\nX0 Y0\nX10\nX20 Y10 ccw\nX9'''", "got the end");
    row("feed", "path = '''\nX0 Y0\nX10 F99\nX20 Y10 ccw'''", "F99");
    row("rapid for feed", "path = '''\nX0 Y0\nX10 rapid\nX20 Y10 ccw'''", "move 2");
    row("direction", "path = '''\nX0 Y0\nX10\nX20 Y10 cw'''", "move 3");
    row("centre", "path = '''\nX0 Y0\nX10\nX20 Y10 ccw I10 J11'''", "move 3");
    row("line for arc", "path = '''\nX0 Y0\nX10\nX20 Y10'''", "move 3");
    row("angle", "path = '''\nX0 Y0\nX10\nX20 Y10 ccw turn=91'''", "move 3");
    row("axis not named", "path = '''\nX0 Y0 Z0\nX10\nX20 Y10 ccw'''", "move 1");
    row("axis left out", "path = '''\nX0\nX10\nX20 Y10 ccw'''", "move 1");
    row("refused", "refused = 'G1'", "got no refusal");
    row("word", "words = ['S500']", "got S1000");
    row("words in order", "words = ['M3', 'S1000']", "expected the word S1000");
    row("finding", "findings = ['G99']\nend = 'X20 Y10'", "expected a finding");
  }
  void tellsDifferences() {
    QFETCH(const QByteArray, expectation);
    QFETCH(const QByteArray, difference);
    const std::vector<std::string> differences =
        judged(("name = 'a'\nsource = 'b'\nprogram = '''\nG21 G90 G17\nS1000 M3\nG0 X0 Y0\nG1 X10 "
                "F100\nG3 X20 Y10 J10\nM2'''\n" +
                expectation)
                   .constData());
    QCOMPARE(differences.empty(), difference.isEmpty());
    if (!differences.empty()) {
      QVERIFY2(differences.front().find(difference.toStdString()) != std::string::npos,
               differences.front().c_str());
    }
  }

  void namesWhatIsRefused() {
    const char* const text = "name = 'a'\nsource = 'b'\nprogram = '''\nG21\nG0 X1\nG88 Z1\nM2'''\n";
    QVERIFY(judged((std::string(text) + "refused = 'G88'").c_str()).empty());
    QVERIFY(!judged((std::string(text) + "refused = 'G8'").c_str()).empty());
    QVERIFY(!judged((std::string(text) + "end = 'X1'").c_str()).empty());
    QVERIFY(judged((std::string(text) + "end = 'X1 Z1'\nmay_refuse = 'G88'").c_str()).empty());
    QVERIFY(!judged((std::string(text) + "end = 'X1'\nmay_refuse = 'G8'").c_str()).empty());
  }

  void casesHold_data() {
    QTest::addColumn<QString>("folder");
    QTest::addColumn<QString>("file");
    for (const auto& entry : std::filesystem::recursive_directory_iterator(casesFolder())) {
      if (entry.path().extension() == ".toml") {
        const std::string folder = entry.path().parent_path().filename().string();
        QTest::newRow((folder + "/" + entry.path().stem().string()).c_str())
            << QString::fromStdString(folder) << QString::fromStdString(entry.path().string());
      }
    }
  }
  void casesHold() {
    QFETCH(const QString, folder);
    QFETCH(const QString, file);
    const std::string row = QTest::currentDataTag();
    const std::size_t before = m_differences.size();
    try {
      const toml::table table = toml::parse_file(file.toStdString());
      const toml::array* const cases = table["case"].as_array();
      QVERIFY2(cases != nullptr, "the file has no [[case]]");
      std::set<std::string> names;
      for (const toml::node& each : *cases) {
        const Case made = caseOf(*each.as_table(), dialectOfFolder(folder.toStdString()));
        if (!names.insert(made.name).second) {
          throw Malformed{fmt::format("two cases have the name \"{}\"", made.name)};
        }
        judge(made, folder.toStdString(), row);
      }
    } catch (const Malformed& malformed) {
      m_differences.push_back(fmt::format("{}: {}", row, malformed.what));
    } catch (const toml::parse_error& fault) {
      m_differences.push_back(
          fmt::format("{}: line {}: {}", row, fault.source().begin.line, fault.description()));
    }
    QVERIFY2(m_differences.size() == before, "see the differences at the end");
  }

  /// An evaluator that shares nothing with the reader finds the same paths, as far as it follows.
  void secondEvaluator() {
    std::map<std::string, int> stopped;
    std::string differing;
    int followed = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(casesFolder())) {
      if (entry.path().extension() != ".toml") {
        continue;
      }
      const std::string folder = entry.path().parent_path().filename().string();
      const toml::table table = toml::parse_file(entry.path().string());
      for (const toml::node& each : *table["case"].as_array()) {
        const Case made = caseOf(*each.as_table(), dialectOfFolder(folder));
        const bool isPath = (made.hasPath || made.end) && made.refused.empty();
        if (!isPath || made.options.blockSkip || !made.options.accepted.empty()) {
          continue;
        }
        const tests::Evaluation evaluation = evaluationOf(made, folder);
        if (!evaluation.cannotFollow.empty()) {
          ++stopped[evaluation.cannotFollow];
          continue;
        }
        ++followed;
        const std::string difference = secondDifference(made, movesOf(evaluation));
        if (!difference.empty()) {
          differing += fmt::format("{}/{}: {}: {}\n", folder, entry.path().stem().string(),
                                   made.name, difference);
        }
      }
    }
    fmt::print("second evaluator: {} cases followed, not followed:", followed);
    for (const auto& [word, times] : stopped) {
      fmt::print(" {}{}{};", word, times > 1 ? " x " : "", times > 1 ? std::to_string(times) : "");
    }
    fmt::print("\n");
    fmt::print("{}", differing);
    QVERIFY2(differing.empty(), "see the differences above");
    QVERIFY(followed > 100);
  }

  void cleanupTestCase() {
    for (const std::string& line : m_pending) {
      fmt::print("pending: {}\n", line);
    }
    Count all;
    for (const auto& [folder, count] : m_counts) {
      fmt::print("{}: {} cases, {} of them pending\n", folder, count.cases, count.pending);
      all.cases += count.cases;
      all.pending += count.pending;
    }
    fmt::print("all: {} cases, {} of them pending\n", all.cases, all.pending);
    for (const std::string& line : m_differences) {
      fmt::print("DIFFERENT: {}\n", line);
    }
    std::fflush(stdout);
  }

 private:
  void judge(const Case& made, const std::string& folder, const std::string& row) {
    Count& count = m_counts[folder];
    ++count.cases;
    const std::vector<std::string> differences = differencesOf(made);
    const std::string name = fmt::format("{}: {}", row, made.name);
    if (made.pending.empty()) {
      for (const std::string& difference : differences) {
        m_differences.push_back(fmt::format("{}\n      {}", name, difference));
      }
    } else if (differences.empty()) {
      m_differences.push_back(name + "\n      is right now: take \"pending\" out of the case");
    } else {
      ++count.pending;
      m_pending.push_back(
          fmt::format("{} ({})\n      {}", name, made.pending, differences.front()));
    }
  }
};

RIVULET_TEST(TestMeaning)
#include "tst_meaning.moc"
