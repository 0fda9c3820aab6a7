// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gcode/interpreter.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/contract.h"
#include "base/text.h"
#include "base/units.h"
#include "gcode/block_observer.h"
#include "gcode/fact_counter.h"
#include "gcode/findings.h"
#include "gcode/path_builder.h"
#include "gcode/program_variables.h"
#include "nc/exec/executor.h"
#include "nc/flow/cursor.h"
#include "nc/syntax/language.h"

namespace rivulet::gcode {

namespace {

using nc::BlockWords;
using nc::Token;
using nc::TokenKind;

/// Blocks between two calls of `LoadOptions::progress`.
constexpr std::size_t kProgressBlocks = 16384;

/// What is left of a block where blocks with "/" are left out: the words before it, if any.
std::span<const Token> beforeBlockSkip(std::span<const Token> block) {
  const auto skip = std::find_if(block.begin(), block.end(), [](const Token& token) {
    return token.kind == TokenKind::BlockSkip;
  });
  const auto isNumber = [](const Token& token) {
    return token.kind == TokenKind::Word && token.address == 'N';
  };
  return skip == block.end() || !std::all_of(block.begin(), skip, isNumber)
             ? std::span(block.begin(), skip)
             : std::span<const Token>();
}

std::size_t lineFeedsOf(std::string_view text) {
  std::size_t count = 0;
  for (std::size_t at = text.find('\n'); at != text.npos; at = text.find('\n', at + 1)) {
    ++count;
  }
  return count;
}

/// The lines of a text by their number, which seldom goes back. @pre the text outlives it
class SourceLines {
 public:
  explicit SourceLines(std::string_view text) : m_text(text), m_lexer(text) {}

  [[nodiscard]] std::size_t memoryBytes() const {
    return m_begins.capacity() * sizeof(m_begins[0]) + m_sizes.capacity() * sizeof(m_sizes[0]);
  }
  [[nodiscard]] std::string_view at(base::LineNumber line) {
    if (line.value < m_lexer.lines() && m_begins.empty()) {
      index();
    }
    if (!m_begins.empty()) {
      const std::size_t index = line.value - std::size_t{1};
      return index < m_begins.size() ? m_text.substr(m_begins[index], m_sizes[index])
                                     : std::string_view();
    }
    while (m_lexer.lines() < line.value) {
      const std::optional<std::string_view> next = m_lexer.nextLine();
      if (!next) {
        return {};
      }
      m_last = *next;
    }
    return m_last;
  }

 private:
  void index() {
    const std::size_t lines = lineFeedsOf(m_text) + 1;
    m_begins.reserve(lines);
    m_sizes.reserve(lines);
    nc::Lexer lexer(m_text);
    while (const std::optional<std::string_view> line = lexer.nextLine()) {
      m_begins.push_back(static_cast<std::size_t>(line->data() - m_text.data()));
      m_sizes.push_back(static_cast<std::uint32_t>(line->size()));
    }
  }

  std::string_view m_text;
  nc::Lexer m_lexer;
  std::string_view m_last;  ///< that it read
  std::vector<std::size_t> m_begins;
  std::vector<std::uint32_t> m_sizes;
};

class Interpreter final : private nc::CallObserver {
 public:
  Interpreter(std::string_view text, const LoadOptions& options, nc::DialectGuess guess,
              BlockObserver* observer)
      : m_text(text),
        m_options(options),
        m_observer(observer),
        m_language(nc::languageOf(guess.dialect)),
        m_findings(options.accepted),
        m_variables(
            m_language.comparison, [this](char axis) { return m_executor.positionOf(axis); },
            [this](char axis) { return machinePosition(axis); },
            [this](int number) { return knownNumber(number); },
            [this] { return m_executor.state().lengthFactor != 1.0; }),
        m_cursorOptions(cursorOptions()),
        m_flow(text, guess.dialect, m_variables, m_cursorOptions),
        m_path(options, m_out.trajectory, m_out.statistics, m_findings),
        m_executorOptions{.centres = options.centres,
                          .arcLineIsSaid = options.settings.contains(ControlSetting::Arc),
                          .placeIsSaid = options.settings.contains(ControlSetting::Place),
                          .unitIsSaid = options.units.has_value(),
                          .runsCannedCycles = m_language.hasCannedCycles && observer == nullptr},
        m_to(sinks()),
        m_executor(m_language, m_executorOptions, m_variables, m_to) {
    if (m_language.hasTurningCycles && !guess.lathe.empty()) {
      nc::ModalState& state = m_executor.state();
      state.isLathe = true;
      state.diameter = true;
      state.diameterIncrements = true;
      state.planeFirstAxis = 2;
      m_findings.reportProgram(Severity::Warning, DiagnosticCode::LatheAssumed, guess.lathe);
    }
    if (options.defaultFeedMmPerS > 0.0) {
      nc::ModalState& state = m_executor.state();
      state.feedMmPerS = options.defaultFeedMmPerS;
      state.feedDegPerS = options.defaultFeedMmPerS;
      state.feedIsDefault = true;
    }
    if (options.units == FileUnits::Inches) {
      m_executor.state().lengthFactor = base::kMmPerInch;
      m_executor.state().feedFactor = base::kMmPerInch;
    }
    if (!guess.contradiction.empty()) {
      m_findings.reportProgram(Severity::Error, DiagnosticCode::TwoDialects,
                               guess.evidence + ", " + guess.contradiction);
    }
    m_out.otherDialects = std::move(guess.others);
    m_watchesReading = !m_out.otherDialects.empty() || m_language.mayCountIncrements;
    m_out.dialect = guess.dialect;
    m_out.dialectEvidence = std::move(guess.evidence);
  }

  Interpretation run() {
    const std::size_t lineFeeds = lineFeedsOf(m_text);
    m_out.trajectory.points.reserve(
        std::min(lineFeeds + 1, m_options.budget.items(sizeof(TrajectoryPoint))));
    if (m_language.semicolonEndsBlock &&
        nc::semicolonOf(m_text, m_language) == nc::Semicolon::EndsBlock) {
      m_dependsOnDialect = true;
      m_findings.reportProgram(Severity::Warning, DiagnosticCode::SemicolonEndsBlock, {});
    }
    if (m_text.substr(0, 4096).find('\0') != std::string_view::npos) {
      m_findings.report(Severity::Error, 1, DiagnosticCode::NotAnyDialect, {});
    }
    std::size_t untilProgress = kProgressBlocks;
    while (!m_ended) {
      const nc::Cursor::Step step = m_flow.next();
      if (step == nc::Cursor::Step::End) {
        break;
      }
      if (--untilProgress == 0) {
        untilProgress = kProgressBlocks;
        if (!goesOn(lineFeeds)) {
          m_out.cancelled = true;
          break;
        }
      }
      if (step == nc::Cursor::Step::Block && m_flow.words().tokens.empty()) {
        continue;
      }
      const nc::Place place = m_flow.place();
      m_findings.setPlace(place.line, m_flow.fileName(place.file));
      if (step == nc::Cursor::Step::Report) {
        Token statement;
        statement.column = place.column;
        begin({});
        settle(m_flow.outcome(), statement);
        end();
        continue;
      }
      const nc::Words& block = m_flow.words();
      std::span<const Token> used = block.tokens;
      if (m_options.blockSkip) {
        used = beforeBlockSkip(used);
        if (used.empty()) {
          continue;
        }
      }
      if (m_options.noPoint == NoPoint::Increments && m_language.mayCountIncrements) {
        used = inUnits(used);
      }
      begin(used);
      m_facts.leaveOut(m_flow.isMade());
      interpretBlock(used);
      end();
      if (isTooLarge()) {
        m_isPartial = true;
        break;
      }
    }
    if (m_flow.isCut() || memoryBytes() > m_options.budget.left()) {
      m_out.refused = m_options.budget.exceeded("The program");
      return std::move(m_out);
    }
    finish();
    return std::move(m_out);
  }

 private:
  [[nodiscard]] std::optional<double> knownNumber(int number) {
    const auto position = [this](char axis) { return m_executor.positionOf(axis); };
    return m_language.knownNumber != nullptr
               ? m_language.knownNumber(number, m_executor.state(), position)
               : std::nullopt;
  }

  /// Known where each part of the chain is: place, frame, work offset, and no tool.
  [[nodiscard]] std::optional<double> machinePosition(char axis) {
    const nc::ModalState& state = m_executor.state();
    const bool isFollowed = state.lengthFactor == 1.0 && state.tipWord.empty() &&
                            !m_path.namesTool() && !m_variables.setsControl() &&
                            (m_observer == nullptr || m_observer->knowsFrame());
    const std::optional<double> place = m_executor.positionOf(axis);
    if (!isFollowed || !m_options.workOffsetMm || !place || state.diameter) {
      return std::nullopt;
    }
    const nc::Position& at = m_executor.start();
    const auto index = static_cast<std::size_t>(axis - 'X');
    if (*place != at.programmedMm[index]) {
      return std::nullopt;  // within a spline
    }
    const double workpieceMm = at.frame.toWorkpiece(at.programmedMm)[index];
    const std::optional<base::Vec3> offsetMm = m_options.workOffsetMm(state.workOffset);
    return offsetMm && !std::isnan(workpieceMm) ? std::optional(workpieceMm + (*offsetMm)[index])
                                                : std::nullopt;
  }

  [[nodiscard]] nc::Sinks sinks() {
    const nc::Sinks own{m_path, m_findings, m_facts};
    return m_observer != nullptr ? m_observer->observe(m_language, own) : own;
  }

  /// Subprograms from elsewhere are kept for an observer.
  [[nodiscard]] nc::CursorOptions cursorOptions() {
    nc::CursorOptions made{m_options.blockSkip, m_options.repeatedLinesMax, m_options.subprogram,
                           m_options.budget,    m_options.toolRadiusMm,     this};
    if (m_observer != nullptr && m_options.subprogram) {
      made.load = [this](std::string_view name) {
        std::optional<nc::LoadedText> loaded = m_options.subprogram(name);
        if (loaded) {
          LoadedFile& file = m_loaded[loaded->fileName];
          file.text = loaded->text;
          file.lines.emplace(file.text);
        }
        return loaded;
      };
    }
    return made;
  }

  [[nodiscard]] std::string_view lineText(const nc::Place& place) {
    if (place.file == 0) {
      if (!m_lines) {
        m_lines.emplace(m_text);
      }
      return m_lines->at(place.line);
    }
    std::optional<SourceLines>& lines = m_loaded[m_flow.fileName(place.file)].lines;
    return lines ? lines->at(place.line) : std::string_view();
  }

  void begin(std::span<const Token> tokens) {
    if (m_observer != nullptr) {
      const nc::Place place = m_flow.place();
      m_observer->begin({place, m_flow.fileName(place.file), lineText(place), tokens,
                         m_flow.isInSubprogram(), m_variables},
                        m_executor);
    }
  }

  void end() {
    if (m_observer != nullptr) {
      m_observer->end(m_executor, m_out.trajectory.points.size());
    }
  }

  [[nodiscard]] bool goesOn(std::size_t lines) const {
    const double share =
        lines == 0 ? 1.0 : static_cast<double>(m_flow.linesRead()) / static_cast<double>(lines + 1);
    return !m_options.progress || m_options.progress(std::min(1.0, share));
  }

  /// What the same text could mean on another control, or on one with other settings.
  void noteReading(const Token& token) {
    if (token.kind != TokenKind::Word) {
      m_dependsOnDialect |= token.kind != TokenKind::Comment && token.kind != TokenKind::Tape &&
                            token.kind != TokenKind::BlockSkip;
    } else if (isLength(token.address)) {
      double& largest = token.hasPoint ? m_largestWithPoint : m_largestWithoutPoint;
      largest = std::max(largest, std::abs(token.value));
      m_hasPoints |= token.hasPoint;
    } else if (token.address == 'G') {
      m_dependsOnDialect = m_dependsOnDialect || !meansTheSame(token.value);
    } else if (token.address == 'M') {
      m_dependsOnDialect |= token.value >= 96.0 && token.value <= 99.0;
    }
  }

  static bool isLength(char address) {
    return (address >= 'X' && address <= 'Z') || (address >= 'U' && address <= 'W') ||
           (address >= 'I' && address <= 'K') || address == 'R';
  }

  /// G functions that move, or set what moves, alike on all controls.
  static bool meansTheSame(double g) {
    static constexpr std::array kSame{0.0,  1.0,  2.0,  3.0,  4.0,  17.0, 18.0, 19.0, 20.0,
                                      21.0, 40.0, 49.0, 53.0, 54.0, 55.0, 56.0, 57.0, 58.0,
                                      59.0, 61.0, 64.0, 80.0, 90.0, 91.0, 94.0};
    return std::find(kSame.begin(), kSame.end(), g) != kSame.end();
  }

  /// The block with its lengths and angles counted in least increments (IS-B): 0.001 mm or degree,
  /// 0.0001 inch.
  [[nodiscard]] std::span<const Token> inUnits(std::span<const Token> block) {
    bool inches = m_executor.state().lengthFactor != 1.0;
    for (const Token& token : block) {
      if (token.kind == TokenKind::Word && token.address == 'G') {
        inches = token.value == 20.0 || (inches && token.value != 21.0);
      }
    }
    m_counted.assign(block.begin(), block.end());
    for (Token& token : m_counted) {
      const bool isAngle = token.address >= 'A' && token.address <= 'C';
      if (token.kind == TokenKind::Word && !token.hasPoint &&
          (isAngle || token.address == 'Q' || isLength(token.address))) {
        token.value /= inches && !isAngle ? 10'000.0 : 1'000.0;
        token.hasPoint = true;
      }
    }
    return m_counted;
  }

  /// So far, beside the text.
  [[nodiscard]] std::size_t memoryBytes() const {
    const auto bytesOf = [](const auto& list) { return base::Budget::bytesOf(list); };
    const Trajectory& path = m_out.trajectory;
    return bytesOf(path.points) + bytesOf(path.rotary) + bytesOf(path.toolDirections) +
           bytesOf(path.arcs) + bytesOf(path.events) + 2 * bytesOf(path.toolNames) +
           bytesOf(m_out.statistics.feedsMmPerMin) + m_flow.memoryBytes() +
           (m_observer != nullptr ? m_observer->memoryBytes() : 0) +
           (m_lines ? m_lines->memoryBytes() : 0);
  }

  /// What loops and calls repeat has a lower limit than what the file holds.
  [[nodiscard]] bool isTooLarge() {
    const std::size_t repeated = m_flow.repeatedLines();
    if (repeated > 0 && m_out.trajectory.points.size() > nc::kRepeatedPointsMax) {
      m_findings.report(Severity::Error, 1, DiagnosticCode::TooManyPoints,
                        fmt::format("{}", nc::kRepeatedPointsMax));
      return true;
    }
    if (memoryBytes() > m_options.budget.left()) {
      return true;
    }
    if (m_observer != nullptr && repeated > nc::kRepeatedNativeBlocksMax &&
        m_observer->nativeBlocks() > m_flow.fileLines() + nc::kRepeatedNativeBlocksMax) {
      m_findings.report(Severity::Error, 1, DiagnosticCode::TooManyNativeBlocks,
                        fmt::format("{}", nc::kRepeatedNativeBlocksMax));
      return true;
    }
    return false;
  }

  void interpretBlock(std::span<const Token> block) {
    BlockWords words;
    words.line = m_flow.line();
    bool counts = false;
    for (const Token& token : block) {
      const bool isNumber =
          token.kind == TokenKind::Word && (token.address == 'N' || token.address == 'O');
      counts |= !isNumber && token.kind != TokenKind::Tape && token.kind != TokenKind::BlockSkip &&
                token.kind != TokenKind::Comment;
      if (m_watchesReading) {
        noteReading(token);
      }
      m_executor.read(token, words);
    }
    if (counts) {
      ++m_out.blocks;
    }
    if (block.front().kind == TokenKind::Tape) {
      return;
    }
    m_executor.execute(words);
    if (m_observer != nullptr) {
      m_observer->executed(words, m_executor);
    }
    if (words.rare) {
      executeFlow(words);
    }
    callModally(words);
    if (words.ends) {
      endProgram();
    }
  }

  void entered(const nc::Tree& program) override { m_executor.enterCall(program.saves); }
  void left() override { m_executor.leaveCall(); }

  void endProgram() {
    m_executor.finishCurve();
    // M30 in a subprogram of the ISO dialects ends everything.
    const bool returns = m_language.namesAreCalls && m_flow.isInSubprogram();
    if (!returns || !m_flow.leaveSubprogram()) {
      m_ended = true;
    }
  }

  void executeFlow(BlockWords& words) {
    const nc::RareWords rare = std::move(*words.rare);
    if (rare.statement) {
      settle(m_flow.execute(*rare.statement), *rare.statement);
    }
    if (rare.call) {
      // PART(1,2), PART P3 and L123.
      const auto times = static_cast<int>(std::clamp(words.p.value_or(1.0), 0.0, 1e6));
      settle(m_flow.call(*rare.call, times), *rare.call);
    }
    if (rare.call98 || rare.call97 || rare.isMacro()) {
      callByNumber(words, rare);
    }
    if (rare.modalMacroOff) {
      m_modalMacro.reset();
    }
    if (rare.returns && words.p) {
      returnTo(static_cast<int>(std::clamp(*words.p, 0.0, 1e9)));
    } else if (rare.returns && !m_flow.leaveSubprogram()) {
      m_executor.finishCurve();
      m_ended = true;
      if (!m_language.namesAreCalls) {
        m_to.faults.report(Severity::Warning, 1, DiagnosticCode::RunsAgain, {});
      }
    }
  }

  /// M98, M97, G65 and G66.
  void callByNumber(const BlockWords& words, const nc::RareWords& rare) {
    if (!words.p) {
      m_to.faults.report(Severity::Error, 1, DiagnosticCode::NumberMissing, "P");
      return;
    }
    MacroCall call{static_cast<int>(std::clamp(*words.p, 0.0, 1e9)),
                   static_cast<int>(std::clamp(words.l.value_or(1.0), 0.0, 1e6)), rare.arguments};
    Token token;
    if (rare.call97) {
      settle(m_flow.callBlock(call.number, call.times), token);
      return;
    }
    if (rare.isMacro() && isOfMacroA(rare)) {
      m_to.faults.error(token, DiagnosticCode::UnsupportedGCode,
                        fmt::format("G65 H{:.0f}", rare.arguments.at(kArgumentH)));
      return;
    }
    if (rare.modalMacro) {
      if (m_modalMacro) {
        // One within another is a matter of levels that is not followed here.
        m_to.faults.error(token, DiagnosticCode::UnsupportedGCode, "G66");
      }
      m_modalMacro = std::move(call);
      return;
    }
    constexpr int kNumbers = 10000;
    if (call.number >= kNumbers && !words.l && rare.call98 && m_language.packsRounds) {
      call.times = call.number / kNumbers;
      call.number %= kNumbers;
    }
    settle(m_flow.callNumber(call.number, call.times,
                             rare.macroCall ? std::optional(call.arguments) : std::nullopt),
           token);
  }

  /// H of custom macro A says what is calculated, and P then is the variable that gets the result.
  [[nodiscard]] static bool isOfMacroA(const nc::RareWords& rare) {
    return rare.hasVariableP && rare.arguments.contains(kArgumentH);
  }

  /// M99 P50.
  void returnTo(int block) {
    Token token;
    if (m_language.returnTo == nc::ReturnTo::Nowhere) {
      m_to.faults.error(token, DiagnosticCode::UnknownWord, "P");
      m_ended = !m_flow.leaveSubprogram();
      return;
    }
    const bool stays = m_language.returnTo == nc::ReturnTo::Itself || !m_flow.isInSubprogram();
    settle(m_flow.leaveTo(block, stays), token);
  }

  /// G66 and MCALL: behind each block that moves, but not behind those of the macro itself.
  void callModally(const BlockWords& words) {
    if (!(m_modalMacro || m_modalCall) || !words.moves() || words.taken || words.ends ||
        (m_modalCallDepth && m_flow.depth() > *m_modalCallDepth)) {
      return;
    }
    m_modalCallDepth = m_flow.depth();
    if (m_modalCall) {
      settle(m_flow.callAgain(*m_modalCall), Token());
      return;
    }
    settle(m_flow.callNumber(m_modalMacro->number, m_modalMacro->times, m_modalMacro->arguments),
           Token());
  }

  void settle(const nc::Outcome& outcome, const Token& token) {
    if (const auto* const fault = std::get_if<nc::Fault>(&outcome)) {
      const bool isRefused = fault->code == DiagnosticCode::UnsupportedGCode ||
                             fault->code == DiagnosticCode::CycleNotRun;
      if (isRefused) {
        m_facts.forget(std::nullopt);
      } else {
        m_facts.incomplete();
      }
      // An unknown position is no matter for the control here: the block has not been read.
      const bool isUnknown = fault->code == DiagnosticCode::RelativeFromUnknownPosition ||
                             fault->code == DiagnosticCode::ArcFromUnknownPosition;
      if (nc::isFinding(fault->code) && !isUnknown) {
        m_to.faults.report(Severity::Error, token.column, fault->code, fault->argument);
      } else {
        m_to.faults.fault(token.column, *fault);
      }
      if (fault->code == nc::FaultCode::AlarmRaised) {
        m_executor.finishCurve();
        m_ended = true;
      }
    } else if (const auto* const missing = std::get_if<nc::SubprogramMissing>(&outcome)) {
      m_to.faults.error(token, DiagnosticCode::SubprogramMissing, missing->name);
    } else if (const auto* const unsupported = std::get_if<nc::Unsupported>(&outcome)) {
      m_facts.incomplete();
      m_to.faults.error(token, DiagnosticCode::UnsupportedExpression, unsupported->word);
    } else if (const auto* const ignored = std::get_if<nc::Ignored>(&outcome)) {
      if (!ignored->word.empty()) {
        m_to.faults.ignore(token, ignored->word);
      }
    } else if (const auto* const modal = std::get_if<nc::ModalCall>(&outcome)) {
      m_modalCall = modal->call;
      if (m_modalCall) {
        return;
      }
      if (m_observer != nullptr) {
        m_observer->modalCall(modal->name);
      }
      if (!modal->name.empty()) {
        // A cycle of the control, or a subprogram that is not at hand.
        const bool isCycle =
            nc::nameEffect(m_language.dialect, modal->name) != nc::NameEffect::Unknown;
        m_to.faults.error(token, DiagnosticCode::CycleNotRun,
                          (isCycle ? "" : "MCALL ") + modal->name);
        m_facts.otherMotion();
      }
    }
  }

  void finish() {
    m_executor.finishCurve();
    if (m_observer != nullptr) {
      m_observer->finish(m_out.trajectory.points.size());
    }
    if (const std::optional<base::LineNumber> line = m_flow.endlessLoop()) {
      m_findings.setPlace(*line, m_flow.fileName(0));
      m_findings.report(Severity::Error, 1, DiagnosticCode::EndlessLoop,
                        fmt::format("{}", m_flow.repeatedLines()));
      m_facts.incomplete();
      m_isPartial = true;
    }
    Statistics& statistics = m_out.statistics;
    if (!m_isPartial && !m_out.cancelled) {
      reportUnreached();
    }
    statistics.lines = m_out.cancelled ? 0 : m_flow.fileLines();
    if (m_out.blocks == 0 && m_flow.holdsPrograms()) {
      m_out.blocks = 1;  // headings alone
    }
    m_out.facts = m_facts.take();
    if (m_out.facts.centreReading != CentreReading::AsProgrammed &&
        m_options.centres == CentreReading::AsProgrammed) {
      m_findings.reportProgram(Severity::Note, DiagnosticCode::CentreReading,
                               std::string(centreReadingName(m_out.facts.centreReading)));
    }
    if (m_out.trajectory.points.empty() && !m_out.cancelled) {
      m_findings.reportProgram(Severity::Warning, DiagnosticCode::NoMotion, {});
    }
    reportScale();
    m_out.facts.dependsOnDialect = m_dependsOnDialect;
    m_out.diagnostics = m_findings.take();
    std::vector<double>& feeds = statistics.feedsMmPerMin;
    std::sort(feeds.begin(), feeds.end());
    feeds.erase(std::unique(feeds.begin(), feeds.end()), feeds.end());
    statistics.points = m_out.trajectory.points.size();
  }

  /// "120 x 80 x 5", the size of the path in mm.
  [[nodiscard]] std::string sizeText(double factor) const {
    const Statistics& statistics = m_out.statistics;
    std::string text;
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      if (std::isfinite(statistics.minMm[axis])) {
        const double size = (statistics.maxMm[axis] - statistics.minMm[axis]) * factor;
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", base::kAxisNames[axis],
                            base::formatFixed(size, 3));
      }
    }
    return text + " mm";
  }

  /// Where settings of the control decide how large the path is, and where it cannot be so large.
  void reportScale() {
    const base::Vec3& least = m_out.statistics.minMm;
    const bool isKnown = std::isfinite(least.x) || std::isfinite(least.y) || std::isfinite(least.z);
    if (!isKnown || m_out.cancelled) {
      return;
    }
    const auto both = [this](double factor) {
      return fmt::format("{}; {}", sizeText(1.0), sizeText(factor));
    };
    bool isReported = false;
    if (m_language.unitIsOfMachine && !m_options.units && m_out.facts.movesBeforeUnits) {
      m_findings.reportProgram(Severity::Warning, DiagnosticCode::UnitsNotSaid,
                               both(base::kMmPerInch));
      isReported = true;
    }
    // Beyond any machine that counts whole units, or a program of a control that may count.
    constexpr double kWholeUnitsMost = 1000.0;
    const bool isLarge = m_largestWithoutPoint >= kWholeUnitsMost &&
                         m_largestWithoutPoint > 10.0 * m_largestWithPoint;
    const bool isOfControl = !m_hasPoints && m_largestWithoutPoint > 0.0 &&
                             (!m_out.dialectEvidence.empty() || m_options.dialect);
    if (m_language.mayCountIncrements && !m_options.noPoint && (isLarge || isOfControl)) {
      const bool inches = m_out.facts.units == FileUnits::Inches;
      m_findings.reportProgram(Severity::Warning, DiagnosticCode::NoDecimalPoint,
                               both(inches ? 1e-4 : 1e-3));
      isReported = true;
    }
    constexpr double kLargestMachineMm = 10'000.0;
    const base::Vec3 size = m_out.statistics.maxMm - m_out.statistics.minMm;
    if (!isReported && (size.x >= kLargestMachineMm || size.y >= kLargestMachineMm ||
                        size.z >= kLargestMachineMm)) {
      m_findings.reportProgram(Severity::Warning, DiagnosticCode::SizeUnlikely, sizeText(1.0));
    }
  }

  /// What the file holds and nobody executes may be what its author meant to be executed.
  void reportUnreached() {
    constexpr std::size_t kReportedMax = 100;
    std::vector<nc::Unreached> all = m_flow.unreached();
    all.resize(std::min(all.size(), kReportedMax));
    for (const nc::Unreached& each : all) {
      using What = nc::Unreached::What;
      std::string lines = each.first == each.last
                              ? fmt::format("line {}", each.first.value)
                              : fmt::format("lines {} to {}", each.first.value, each.last.value);
      if (each.what != What::Blocks && !each.program.empty()) {
        lines = fmt::format("{} ({})", each.program, lines);
      }
      m_findings.setPlace(each.first, m_flow.fileName(0));
      m_findings.report(each.what == What::MainProgram ? Severity::Error
                        : each.dependsOnValues         ? Severity::Note
                                                       : Severity::Warning,
                        1,
                        each.what == What::MainProgram  ? DiagnosticCode::AnotherMainProgram
                        : each.what == What::Subprogram ? DiagnosticCode::NeverCalled
                                                        : DiagnosticCode::NeverExecuted,
                        std::move(lines));
    }
  }

  /// O word, rounds and # variables of a call.
  struct MacroCall {
    int number = 0;
    int times = 1;
    std::map<int, double> arguments;
  };
  static constexpr int kArgumentH = 11;

  std::string_view m_text;
  const LoadOptions& m_options;
  BlockObserver* m_observer;
  std::optional<SourceLines> m_lines;  ///< of the program file, for the observer
  struct LoadedFile {
    std::string text;
    std::optional<SourceLines> lines;
  };
  std::map<std::string, LoadedFile> m_loaded;
  const nc::Language& m_language;
  Interpretation m_out;
  Findings m_findings;
  FactCounter m_facts;
  ProgramVariables m_variables;
  nc::CursorOptions m_cursorOptions;
  nc::Cursor m_flow;
  PathBuilder m_path;
  nc::ExecutorOptions m_executorOptions;
  nc::Sinks m_to;
  nc::Executor m_executor;
  std::vector<Token> m_counted;                 ///< a block that counts in increments
  std::optional<MacroCall> m_modalMacro;        ///< G66
  std::optional<nc::Call> m_modalCall;          ///< MCALL of a program
  std::optional<std::size_t> m_modalCallDepth;  ///< of the program that it was called in last
  bool m_ended = false;
  bool m_isPartial = false;       ///< given up before the end
  bool m_watchesReading = false;  ///< something depends on how it is read
  bool m_dependsOnDialect = false;
  bool m_hasPoints = false;
  double m_largestWithPoint = 0.0;
  double m_largestWithoutPoint = 0.0;
};

}  // namespace

Interpretation interpret(std::string_view text, const LoadOptions& options,
                         std::string_view fileName, BlockObserver* observer) {
  RIVULET_ASSERT(options.chordToleranceMm > 0.0);
  nc::DialectGuess guess = detectDialect(text, fileName);
  if (options.dialect) {
    guess.dialect = *options.dialect;
    guess.evidence.clear();
    guess.others.clear();
    guess.contradiction.clear();
  }
  return Interpreter(text, options, std::move(guess), observer).run();
}

}  // namespace rivulet::gcode
