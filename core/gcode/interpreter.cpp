// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gcode/interpreter.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "base/contract.h"
#include "base/text.h"
#include "base/units.h"
#include "gcode/arc.h"
#include "gcode/lexer.h"

namespace rivulet::gcode {

namespace {

using base::Vec3;

enum class Motion : unsigned char { None, Rapid, Line, ArcClockwise, ArcCounter, Unsupported };

/// What a G function does to the path, as far as Rivulet is concerned.
enum class Effect : unsigned char {
  Unknown,
  Motion,    ///< G0 to G3
  Distance,  ///< G90, G91
  Plane,     ///< G17 to G19
  Units,
  Dwell,       ///< G4: the block's X, F, S, P and U are times
  None,        ///< no effect on the path
  Tolerance,   ///< no effect but a tolerance; P and Q of the block belong to it
  WorkOffset,  ///< no effect as long as it does not change under the tool
  Mode,        ///< not supported; the block still moves
  MotionMode,  ///< not supported; replaces G0 to G3
  Statement,   ///< not supported; takes the axis words of its block for itself
};

/// `key` is ten times the number, so that G91.1 has one.
Effect effectOf(int key) {
  switch (key) {
    case 0:
    case 10:
    case 20:
    case 30:
      return Effect::Motion;
    case 40:
      return Effect::Dwell;
    case 170:
    case 180:
    case 190:
      return Effect::Plane;
    case 200:
    case 210:
    case 700:
    case 710:
    case 7000:
    case 7100:
      return Effect::Units;
    case 900:
    case 910:
      return Effect::Distance;
    case 540:
    case 550:
    case 560:
    case 570:
    case 580:
    case 590:
    case 591:
    case 592:
    case 593:
    case 5000:
      return Effect::WorkOffset;
    case 90:   // exact stop of one block
    case 150:  // polar off
    case 400:  // cutter radius compensation off
    case 430:
    case 440:
    case 490:  // tool length: lives on the control
    case 431:
    case 600:
    case 601:
    case 602:
    case 603:
    case 6010:
    case 6020:
    case 6030:
    case 4500:
    case 4510:  // corners of a radius compensation that is off
    case 690:   // rotation off
    case 800:   // canned cycle off; see motionMode below
    case 911:   // centres of arcs are increments, as read here
    case 940:
    case 960:
    case 970:  // feed per minute; spindle
    case 980:
    case 990:   // return level of cycles
    case 2900:  // SINUMERIK language
      return Effect::None;
    case 610:
    case 611:
    case 640:
    case 6410:
    case 6420:
    case 6430:
    case 6440:
    case 6450:
      return Effect::Tolerance;
    case 410:
    case 420:
    case 930:
    case 950:
    case 160:
    case 901:
    case 434:
    case 435:
    case 2910:
    case 9310:
    case 9510:
    case 9610:
      return Effect::Mode;
    case 50:
    case 51:
    case 52:
    case 53:
    case 60:
    case 61:
    case 62:
    case 63:
    case 320:
    case 330:
    case 331:
    case 340:
    case 350:
    case 630:
    case 760:
    case 382:
    case 383:
    case 384:
    case 385:
    case 730:
    case 810:
    case 820:
    case 830:
    case 840:
    case 850:
    case 860:
    case 870:
    case 880:
    case 890:
    case 3310:
    case 3320:
      return Effect::MotionMode;
    case 100:
    case 250:
    case 260:
    case 270:
    case 280:
    case 281:
    case 290:
    case 300:
    case 301:
    case 500:
    case 510:
    case 520:
    case 530:
    case 680:
    case 740:
    case 750:
    case 921:
    case 922:
    case 923:
    case 920:
    case 1100:
    case 1110:
    case 1120:
    case 1530:
    case 650:
    case 660:
      return Effect::Statement;
    default:
      if (key >= 5050 && key <= 5990 && key % 10 == 0) {
        return Effect::WorkOffset;
      }
      return Effect::Unknown;
  }
}

enum class NameEffect : unsigned char {
  Unknown,
  None,       ///< no effect on the path, with or without a value or arguments
  End,        ///< ends the program
  Mode,       ///< not supported; the block still moves
  Statement,  ///< not supported; takes the rest of its block
};

struct KnownName {
  std::string_view name;
  NameEffect effect;
};

/// Names of the SINUMERIK language that CAM programs use without calculating.
constexpr std::array kNames{
    // Dynamics, look-ahead, compressor: how exactly and how softly, not where.
    KnownName{"SOFT", NameEffect::None},
    KnownName{"BRISK", NameEffect::None},
    KnownName{"DRIVE", NameEffect::None},
    KnownName{"FFWON", NameEffect::None},
    KnownName{"FFWOF", NameEffect::None},
    KnownName{"COMPOF", NameEffect::None},
    KnownName{"COMPON", NameEffect::None},
    KnownName{"COMPCAD", NameEffect::None},
    KnownName{"COMPCURV", NameEffect::None},
    KnownName{"COMPSURF", NameEffect::None},
    KnownName{"UPATH", NameEffect::None},
    KnownName{"SPATH", NameEffect::None},
    KnownName{"FIFOCTRL", NameEffect::None},
    KnownName{"STARTFIFO", NameEffect::None},
    KnownName{"STOPFIFO", NameEffect::None},
    KnownName{"STOPRE", NameEffect::None},
    KnownName{"CFC", NameEffect::None},
    KnownName{"CFTCP", NameEffect::None},
    KnownName{"CFIN", NameEffect::None},
    KnownName{"FNORM", NameEffect::None},
    KnownName{"CPRECON", NameEffect::None},
    KnownName{"CPRECOF", NameEffect::None},
    KnownName{"DYNNORM", NameEffect::None},
    KnownName{"DYNPOS", NameEffect::None},
    KnownName{"DYNROUGH", NameEffect::None},
    KnownName{"DYNSEMIFIN", NameEffect::None},
    KnownName{"DYNFINISH", NameEffect::None},
    KnownName{"RTLION", NameEffect::None},
    KnownName{"RTLIOF", NameEffect::None},
    KnownName{"ADIS", NameEffect::None},
    KnownName{"ADISPOS", NameEffect::None},
    KnownName{"CTOL", NameEffect::None},
    KnownName{"OTOL", NameEffect::None},
    KnownName{"CYCLE832", NameEffect::None},
    KnownName{"FGROUP", NameEffect::None},
    // States that are the default, or that guard and do not move.
    KnownName{"TRAFOOF", NameEffect::None},
    KnownName{"DIAMOF", NameEffect::None},
    KnownName{"CUT2D", NameEffect::None},
    KnownName{"CUT2DF", NameEffect::None},
    KnownName{"WALIMON", NameEffect::None},
    KnownName{"WALIMOF", NameEffect::None},
    KnownName{"CDOF", NameEffect::None},
    KnownName{"CDON", NameEffect::None},
    KnownName{"NORM", NameEffect::None},
    KnownName{"KONT", NameEffect::None},
    // Spindle and display.
    KnownName{"SPOS", NameEffect::None},
    KnownName{"LIMS", NameEffect::None},
    KnownName{"MSG", NameEffect::None},
    KnownName{"WORKPIECE", NameEffect::None},
    KnownName{"GROUP_BEGIN", NameEffect::None},
    KnownName{"GROUP_END", NameEffect::None},
    KnownName{"DISPLOF", NameEffect::None},
    KnownName{"SBLOF", NameEffect::None},
    KnownName{"SBLON", NameEffect::None},
    KnownName{"RET", NameEffect::End},
    // Another form of the path in a block that moves.
    KnownName{"RND", NameEffect::Mode},
    KnownName{"RNDM", NameEffect::Mode},
    KnownName{"CHF", NameEffect::Mode},
    KnownName{"CHR", NameEffect::Mode},
    KnownName{"AR", NameEffect::Mode},
    KnownName{"AP", NameEffect::Mode},
    KnownName{"RP", NameEffect::Mode},
    KnownName{"ANG", NameEffect::Mode},
    KnownName{"TURN", NameEffect::Mode},
    KnownName{"CIP", NameEffect::Mode},
    KnownName{"CT", NameEffect::Mode},
    KnownName{"INVCW", NameEffect::Mode},
    KnownName{"INVCCW", NameEffect::Mode},
    KnownName{"ASPLINE", NameEffect::Mode},
    KnownName{"BSPLINE", NameEffect::Mode},
    KnownName{"CSPLINE", NameEffect::Mode},
    KnownName{"POLY", NameEffect::Mode},
    KnownName{"DIAMON", NameEffect::Mode},
    KnownName{"DIAM90", NameEffect::Mode},
    KnownName{"SUPA", NameEffect::Statement},
    // Frames and transformations.
    KnownName{"TRANS", NameEffect::Statement},
    KnownName{"ATRANS", NameEffect::Statement},
    KnownName{"ROT", NameEffect::Statement},
    KnownName{"AROT", NameEffect::Statement},
    KnownName{"ROTS", NameEffect::Statement},
    KnownName{"AROTS", NameEffect::Statement},
    KnownName{"SCALE", NameEffect::Statement},
    KnownName{"ASCALE", NameEffect::Statement},
    KnownName{"MIRROR", NameEffect::Statement},
    KnownName{"AMIRROR", NameEffect::Statement},
    KnownName{"TRAORI", NameEffect::Statement},
    KnownName{"TRANSMIT", NameEffect::Statement},
    KnownName{"TRACYL", NameEffect::Statement},
    KnownName{"TOFRAME", NameEffect::Statement},
    KnownName{"PAROT", NameEffect::Statement},
    KnownName{"CYCLE800", NameEffect::Statement},
};

NameEffect nameEffect(std::string_view name) {
  const std::string key = base::toUpper(name);
  const auto* const found =
      std::find_if(kNames.begin(), kNames.end(), [&](const KnownName& k) { return k.name == key; });
  return found == kNames.end() ? NameEffect::Unknown : found->effect;
}

/// The values of one block, collected before anything is executed: on a control, the order of
/// words in a block does not matter.
struct Words {
  Vec3 axes{};
  Vec3 centre{};
  double feed = 0.0;
  double radius = 0.0;
  std::array<bool, base::kAxisCount> hasAxis{};
  std::array<bool, base::kAxisCount> hasCentre{};
  bool hasFeed = false;
  bool hasRadius = false;
  bool radiusIsWord = false;  ///< R12 instead of CR=12
  bool dwell = false;
  bool tolerance = false;
  bool taken = false;  ///< a statement takes the axis words: no motion
  bool ends = false;
  int motionKey = -1;
  int distanceKey = -1;
  int planeKey = -1;
  int unitsKey = -1;
  unsigned repeated = 0;             ///< bit per letter seen
  int motionColumn = 0;              ///< of the first axis, centre or radius word
  const Token* parameter = nullptr;  ///< P, Q or U, allowed with G4 and G64 only
  const Token* radiusToken = nullptr;
  const Token* centreTokens[base::kAxisCount] = {nullptr, nullptr, nullptr};
  const Token* axisTokens[base::kAxisCount] = {nullptr, nullptr, nullptr};

  [[nodiscard]] bool moves() const { return hasAxis[0] || hasAxis[1] || hasAxis[2]; }
  [[nodiscard]] bool hasAnyCentre() const { return hasCentre[0] || hasCentre[1] || hasCentre[2]; }
};

class Interpreter {
 public:
  Interpreter(std::string_view text, const LoadOptions& options)
      : m_text(text), m_options(options) {
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    m_position = {kUnknown, kUnknown, kUnknown};
    m_out.statistics.minMm = m_position;
    m_out.statistics.maxMm = m_position;
  }

  Interpretation run() {
    const auto lineFeeds = static_cast<std::size_t>(std::count(m_text.begin(), m_text.end(), '\n'));
    m_out.trajectory.points.reserve(std::min(lineFeeds + 1, kTrajectoryPointsMax));
    Lexer lexer(m_text);
    Block block;
    while (lexer.next(block)) {
      if (block.tokens.empty() || m_tailReported) {
        continue;
      }
      m_line = block.line;
      if (m_ended) {
        if (block.tokens.front().kind != TokenKind::Tape) {
          report(Severity::Warning, block.tokens.front().column,
                 DiagnosticCode::TextAfterProgramEnd, {});
          m_tailReported = true;
        }
        continue;
      }
      interpretBlock(block);
      if (m_out.trajectory.points.size() > kTrajectoryPointsMax) {
        report(Severity::Error, 1, DiagnosticCode::TooManyPoints,
               fmt::format("{}", kTrajectoryPointsMax));
        m_ended = m_tailReported = true;
      }
    }
    m_out.statistics.lines = lexer.lines();
    finish();
    return std::move(m_out);
  }

 private:
  // --- findings --------------------------------------------------------------------------

  void report(Severity severity, int column, DiagnosticCode code, std::string argument) {
    if (m_out.diagnostics.size() >= kDiagnosticsMax) {
      if (m_suppressed++ == 0) {
        m_suppressedLine = m_line;
      }
      m_suppressedWorst = std::max(m_suppressedWorst, severity);
      return;
    }
    m_out.diagnostics.push_back({severity, m_line, column, code, std::move(argument)});
  }

  void error(const Token& token, DiagnosticCode code) {
    error(token, code, std::string(token.text));
  }

  void error(const Token& token, DiagnosticCode code, std::string argument) {
    constexpr std::size_t kLongest = 60;
    if (argument.size() > kLongest) {
      argument.resize(kLongest);
      // A cut inside a UTF-8 character would make the text unreadable for the display.
      while (!argument.empty() && (static_cast<unsigned char>(argument.back()) & 0x80) != 0) {
        argument.pop_back();
      }
      argument += "...";
    }
    report(Severity::Error, token.column, code, std::move(argument));
  }

  /// Notes a word without effect on the path at its first place only: a program with M3 S500 in
  /// every block has one such finding, not a thousand that hide the others.
  void ignore(Severity severity, const Token& token, std::string argument) {
    if (std::find(m_ignoredNames.begin(), m_ignoredNames.end(), argument) != m_ignoredNames.end()) {
      return;
    }
    if (m_ignoredNames.size() < kDiagnosticsMax) {
      m_ignoredNames.push_back(argument);
    }
    report(severity, token.column, DiagnosticCode::IgnoredCode, std::move(argument));
  }

  template <std::size_t Size>
  void ignoreOnce(std::bitset<Size>& seen, std::size_t key, Severity severity, const Token& token) {
    if (!seen.test(key)) {
      seen.set(key);
      report(severity, token.column, DiagnosticCode::IgnoredCode, wordText(token));
    }
  }

  /// "G01" and "g 1" are G1 to the reader of a finding.
  static std::string wordText(const Token& token) {
    return fmt::format("{}{}", token.address, token.value);
  }

  // --- one block -------------------------------------------------------------------------

  void interpretBlock(const Block& block) {
    Words words;
    bool counts = false;
    for (const Token& token : block.tokens) {
      const bool isNumber =
          token.kind == TokenKind::Word && (token.address == 'N' || token.address == 'O');
      counts |= !isNumber && token.kind != TokenKind::Tape && token.kind != TokenKind::BlockSkip;
      read(token, words);
    }
    if (counts) {
      ++m_out.blocks;
    }
    if (block.tokens.front().kind == TokenKind::Tape) {
      // The first "%" starts the tape, one behind the blocks ends it.
      m_ended = m_out.blocks > 0;
      return;
    }
    execute(words);
    m_ended |= words.ends;
  }

  void read(const Token& token, Words& words) {
    switch (token.kind) {
      case TokenKind::Word:
        readWord(token, words);
        break;
      case TokenKind::Name:
      case TokenKind::NamedValue:
      case TokenKind::Call:
        readName(token, words);
        break;
      case TokenKind::TextWord:
        if (token.address == 'T') {
          ignore(Severity::Note, token, "T");
        } else {
          error(token, DiagnosticCode::UnknownWord);
        }
        break;
      case TokenKind::IndexedWord:
        ignore(Severity::Note, token, std::string(token.text));
        break;
      case TokenKind::Label:
        ignore(Severity::Note, token, std::string(token.text));
        break;
      case TokenKind::Expression:
        error(token, DiagnosticCode::UnsupportedExpression);
        break;
      case TokenKind::BlockSkip:
        ignore(Severity::Note, token, "/");
        break;
      case TokenKind::Tape:
        break;
      case TokenKind::UnexpectedCharacter:
        error(token, DiagnosticCode::UnexpectedCharacter);
        break;
      case TokenKind::NumberMissing:
        error(token, DiagnosticCode::NumberMissing, std::string(tokenName(token)));
        break;
      case TokenKind::NumberMalformed:
        error(token, DiagnosticCode::NumberMalformed);
        break;
      case TokenKind::CommentNotClosed:
        error(token, DiagnosticCode::CommentNotClosed, {});
        break;
    }
  }

  void readWord(const Token& token, Words& words) {
    const char address = token.address;
    if (address == 'G') {
      readG(token, words);
      return;
    }
    if (address == 'M') {
      readM(token, words);
      return;
    }
    if (address >= 'A' && address <= 'Z') {
      const unsigned bit = 1U << static_cast<unsigned>(address - 'A');
      if ((words.repeated & bit) != 0) {
        const bool path = std::string_view("XYZIJKRF").find(address) != std::string_view::npos;
        report(path ? Severity::Error : Severity::Warning, token.column,
               DiagnosticCode::RepeatedWord, std::string(1, address));
      }
      words.repeated |= bit;
    }
    switch (address) {
      case 'X':
      case 'Y':
      case 'Z': {
        const auto axis = static_cast<std::size_t>(address - 'X');
        words.axes.set(axis, token.value);
        words.hasAxis[axis] = true;
        words.axisTokens[axis] = &token;
        noteColumn(token, words);
        break;
      }
      case 'I':
      case 'J':
      case 'K': {
        const auto axis = static_cast<std::size_t>(address - 'I');
        words.centre.set(axis, token.value);
        words.hasCentre[axis] = true;
        words.centreTokens[axis] = &token;
        noteColumn(token, words);
        break;
      }
      case 'R':
        setRadius(token, words);
        words.radiusIsWord = true;
        break;
      case 'F':
        words.feed = token.value;
        words.hasFeed = true;
        m_feedToken = token;
        break;
      case 'N':
        break;
      case 'O':
        // A program number behind the first blocks starts another program: a subprogram.
        if (m_out.blocks > 0) {
          error(token, DiagnosticCode::UnknownWord);
        }
        break;
      case 'S':
      case 'T':
      case 'D':
      case 'H':
        if (!m_ignoredLetters.test(static_cast<std::size_t>(address - 'A'))) {
          m_ignoredLetters.set(static_cast<std::size_t>(address - 'A'));
          report(Severity::Note, token.column, DiagnosticCode::IgnoredCode,
                 std::string(1, address));
        }
        break;
      case 'P':
      case 'Q':
      case 'U':
        words.parameter = &token;
        break;
      default:
        error(token, DiagnosticCode::UnknownWord);
        break;
    }
  }

  static void noteColumn(const Token& token, Words& words) {
    if (words.motionColumn == 0) {
      words.motionColumn = token.column;
    }
  }

  void setRadius(const Token& token, Words& words) {
    if (words.hasRadius) {
      error(token, DiagnosticCode::RepeatedWord, "CR=");
    }
    words.radius = token.value;
    words.hasRadius = true;
    words.radiusToken = &token;
    noteColumn(token, words);
  }

  /// Two different functions of one group in a block contradict each other.
  void setModal(int& slot, int key, const Token& token) {
    if (slot >= 0 && slot != key) {
      error(token, DiagnosticCode::ConflictingGCodes,
            fmt::format("G{} {}", slot / 10, wordText(token)));
    }
    slot = key;
  }

  void readG(const Token& token, Words& words) {
    const double scaled = token.value * 10.0;
    const int key =
        token.value >= 0.0 && token.value < 1000.0 ? static_cast<int>(std::lround(scaled)) : -1;
    if (key < 0 || std::abs(scaled - key) > 1e-6) {
      error(token, DiagnosticCode::UnknownGCode, wordText(token));
      return;
    }
    switch (effectOf(key)) {
      case Effect::Motion:
        setModal(words.motionKey, key, token);
        break;
      case Effect::Distance:
        setModal(words.distanceKey, key, token);
        break;
      case Effect::Plane:
        setModal(words.planeKey, key, token);
        break;
      case Effect::Units:
        setModal(words.unitsKey, key, token);
        break;
      case Effect::Dwell:
        words.dwell = true;
        noteG(key, token);
        break;
      case Effect::None:
        if (key == 800 && m_motion == Motion::Unsupported) {
          m_motion = m_motionBeforeUnsupported;
        }
        noteG(key, token);
        break;
      case Effect::Tolerance:
        words.tolerance = true;
        noteG(key, token);
        break;
      case Effect::WorkOffset:
        selectWorkOffset(key, token);
        break;
      case Effect::Mode:
        error(token, DiagnosticCode::UnsupportedGCode, wordText(token));
        break;
      case Effect::MotionMode:
        error(token, DiagnosticCode::UnsupportedGCode, wordText(token));
        if (m_motion != Motion::Unsupported) {
          m_motionBeforeUnsupported = m_motion;
        }
        m_motion = Motion::Unsupported;
        break;
      case Effect::Statement:
        error(token, DiagnosticCode::UnsupportedGCode, wordText(token));
        words.taken = true;
        break;
      case Effect::Unknown:
        error(token, DiagnosticCode::UnknownGCode, wordText(token));
        break;
    }
  }

  void noteG(int key, const Token& token) {
    ignoreOnce(m_ignoredG, static_cast<std::size_t>(key), Severity::Note, token);
  }

  /// The streamed points carry no work offset: the one active at the control holds for all of
  /// them. So the program's first choice is a note; another one once the tool has moved would
  /// send it to a wrong place.
  void selectWorkOffset(int key, const Token& token) {
    if (m_moved && key != m_workOffset) {
      error(token, DiagnosticCode::UnsupportedGCode, wordText(token));
    } else {
      noteG(key, token);
    }
    m_workOffset = key;
  }

  void readM(const Token& token, Words& words) {
    const double value = token.value;
    if (!(value >= 0.0 && value < 10000.0) || value != std::floor(value)) {
      error(token, DiagnosticCode::ValueOutOfRange);
      return;
    }
    const auto number = static_cast<int>(value);
    switch (number) {
      case 2:
      case 17:
      case 30:
        words.ends = true;
        break;
      case 96:
      case 97:
      case 98:
      case 99:
        error(token, DiagnosticCode::UnsupportedGCode, wordText(token));
        break;
      default: {
        // Where the program wants the machine to wait for a person or a tool, a stream goes on.
        const bool waits = number == 0 || number == 1 || (number == 6 && m_moved);
        const auto key = static_cast<std::size_t>(number);
        if (waits && !m_warnedM.test(key)) {
          m_warnedM.set(key);
          report(Severity::Warning, token.column, DiagnosticCode::IgnoredCode, wordText(token));
        } else if (!waits) {
          ignoreOnce(m_ignoredM, key, Severity::Note, token);
        }
        break;
      }
    }
  }

  void readName(const Token& token, Words& words) {
    const std::string_view name = tokenName(token);
    if (token.kind == TokenKind::NamedValue && base::toUpper(name) == "CR") {
      setRadius(token, words);
      return;
    }
    switch (nameEffect(name)) {
      case NameEffect::None:
        ignore(Severity::Note, token, base::toUpper(name));
        break;
      case NameEffect::End:
        words.ends = true;
        break;
      case NameEffect::Mode:
        error(token, DiagnosticCode::UnsupportedGCode, base::toUpper(name));
        break;
      case NameEffect::Statement:
        error(token, DiagnosticCode::UnsupportedGCode, base::toUpper(name));
        words.taken = true;
        break;
      case NameEffect::Unknown:
        error(token, token.kind == TokenKind::Name ? DiagnosticCode::UnknownWord
                                                   : DiagnosticCode::UnsupportedExpression);
        break;
    }
  }

  // --- execution ---------------------------------------------------------------------------

  void execute(Words& words) {
    setModes(words);
    if (words.parameter != nullptr && !words.dwell && !words.tolerance && !words.taken &&
        m_motion != Motion::Unsupported) {
      error(*words.parameter, DiagnosticCode::UnknownWord);
    }
    if (words.dwell) {
      executeDwell(words);
      return;
    }
    if (words.hasFeed) {
      setFeed(words);
    }
    if (words.taken || m_motion == Motion::Unsupported) {
      return;
    }
    const bool arcMode = m_motion == Motion::ArcClockwise || m_motion == Motion::ArcCounter;
    if (!arcMode) {
      rejectArcWords(words);
    }
    if (words.moves() || (arcMode && words.hasAnyCentre())) {
      move(words);
    }
  }

  void setModes(const Words& words) {
    switch (words.unitsKey) {
      case 200:
      case 7000:
        m_lengthFactor = base::kMmPerInch;
        m_feedFactor = base::kMmPerInch;
        break;
      case 700:
        // G70 speaks of lengths only: the feed stays in the control's own unit, mm/min.
        m_lengthFactor = base::kMmPerInch;
        m_feedFactor = 1.0;
        break;
      case 210:
      case 710:
      case 7100:
        m_lengthFactor = 1.0;
        m_feedFactor = 1.0;
        break;
      default:
        break;
    }
    if (words.planeKey >= 0) {
      m_planeFirstAxis = words.planeKey == 170 ? 0 : (words.planeKey == 180 ? 2 : 1);
    }
    if (words.distanceKey >= 0) {
      m_relative = words.distanceKey == 910;
    }
    switch (words.motionKey) {
      case 0:
        m_motion = Motion::Rapid;
        break;
      case 10:
        m_motion = Motion::Line;
        break;
      case 20:
        m_motion = Motion::ArcClockwise;
        break;
      case 30:
        m_motion = Motion::ArcCounter;
        break;
      default:
        break;
    }
  }

  /// X, F, S, P and U of a dwell are times; what else it names would be lost.
  void executeDwell(const Words& words) {
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      if (words.hasAxis[axis] && axis != 0) {
        error(*words.axisTokens[axis], DiagnosticCode::UnknownWord);
      }
    }
    rejectArcWords(words);
  }

  void rejectArcWords(const Words& words) {
    if (words.hasRadius) {
      error(*words.radiusToken, DiagnosticCode::UnknownWord);
    }
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      if (words.hasCentre[axis]) {
        error(*words.centreTokens[axis], DiagnosticCode::UnknownWord);
      }
    }
  }

  void setFeed(const Words& words) {
    const double feedMmPerMin = words.feed * m_feedFactor;
    if (!(feedMmPerMin > 0.0)) {
      error(m_feedToken, DiagnosticCode::FeedNotPositive, base::formatNumber(words.feed));
      return;
    }
    if (!(feedMmPerMin <= kCoordinateMmMax)) {
      error(m_feedToken, DiagnosticCode::ValueOutOfRange);
      return;
    }
    m_feedMmPerS = base::mmPerSFromMmPerMin(feedMmPerMin);
    std::vector<double>& feeds = m_out.statistics.feedsMmPerMin;
    if (feeds.empty() || feeds.back() != feedMmPerMin) {
      feeds.push_back(feedMmPerMin);
    }
  }

  /// Takes the programmed axes over. @return the new position
  Vec3 targetOf(const Words& words) {
    Vec3 target = m_position;
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      if (!words.hasAxis[axis]) {
        continue;
      }
      double value = words.axes[axis] * m_lengthFactor;
      if (!(std::abs(value) <= kCoordinateMmMax)) {
        error(*words.axisTokens[axis], DiagnosticCode::ValueOutOfRange);
        continue;
      }
      if (m_relative) {
        if (std::isnan(m_position[axis])) {
          error(*words.axisTokens[axis], DiagnosticCode::RelativeFromUnknownPosition,
                std::string(1, base::kAxisNames[axis]));
          continue;
        }
        value += m_position[axis];
      }
      target.set(axis, value);
      // fmin and fmax pass over the NaN of an axis not seen before.
      m_out.statistics.minMm.set(axis, std::fmin(m_out.statistics.minMm[axis], value));
      m_out.statistics.maxMm.set(axis, std::fmax(m_out.statistics.maxMm[axis], value));
    }
    return target;
  }

  void move(const Words& words) {
    if (m_motion == Motion::None) {
      report(Severity::Warning, words.motionColumn, DiagnosticCode::MotionModeAssumed, {});
      m_motion = Motion::Line;
    }
    m_moved = true;
    const Vec3 target = targetOf(words);
    const bool rapid = m_motion == Motion::Rapid;
    if (!rapid && m_feedMmPerS == 0.0 && !m_feedMissingReported) {
      report(Severity::Warning, words.motionColumn, DiagnosticCode::FeedMissing, {});
      m_feedMissingReported = true;
    }
    Statistics& statistics = m_out.statistics;
    if (rapid || m_motion == Motion::Line) {
      ++statistics.motions[rapid ? 0 : 1];
      (rapid ? statistics.rapidLengthMm : statistics.cutLengthMm) += knownLength(target);
      append(target, rapid ? MoveKind::Rapid : MoveKind::Feed);
    } else {
      ++statistics.motions[m_motion == Motion::ArcClockwise ? 2 : 3];
      const std::optional<Arc> arc = arcOf(words, target);
      if (arc) {
        m_arcPoints.clear();
        statistics.cutLengthMm += flattenArc(*arc, m_options.chordToleranceMm, m_arcPoints);
        for (const Vec3& point : m_arcPoints) {
          append(point, MoveKind::ArcPiece);
        }
      } else {
        append(target, MoveKind::ArcPiece);
      }
    }
    m_position = target;
  }

  void append(Vec3 position, MoveKind kind) {
    m_out.trajectory.points.push_back(
        {position, kind == MoveKind::Rapid ? 0.0 : m_feedMmPerS, m_line, kind});
  }

  /// 0 if an axis comes from a place the program never named.
  [[nodiscard]] double knownLength(Vec3 target) const {
    double squares = 0.0;
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      const double step = target[axis] - m_position[axis];
      if (!std::isnan(step)) {
        squares += step * step;
      } else if (!std::isnan(target[axis])) {
        return 0.0;
      }
    }
    return std::sqrt(squares);
  }

  /// The arc of a block, if it can be known.
  std::optional<Arc> arcOf(const Words& words, Vec3 target) {
    const int column = words.motionColumn;
    const std::size_t first = m_planeFirstAxis;
    const std::size_t second = (first + 1) % base::kAxisCount;
    const std::size_t third = (first + 2) % base::kAxisCount;
    for (const std::size_t axis : {first, second, third}) {
      const bool needed = axis != third || words.hasAxis[third];
      if (needed && std::isnan(m_position[axis])) {
        report(Severity::Error, column, DiagnosticCode::ArcFromUnknownPosition,
               std::string(1, base::kAxisNames[axis]));
        return std::nullopt;
      }
    }
    if (words.hasCentre[third] && words.centre[third] != 0.0) {
      error(*words.centreTokens[third], DiagnosticCode::CentreOutsidePlane);
      return std::nullopt;
    }
    const bool hasCentre = words.hasCentre[first] || words.hasCentre[second];
    if (hasCentre && words.hasRadius) {
      report(Severity::Error, column, DiagnosticCode::ConflictingGCodes,
             words.radiusIsWord ? "I J K and R" : "I J K and CR=");
      return std::nullopt;
    }
    Arc arc{m_position, target, m_position, first, m_motion == Motion::ArcClockwise};
    if (words.hasRadius) {
      return arcOfRadius(words, arc, first, second);
    }
    if (!hasCentre) {
      report(Severity::Error, column, DiagnosticCode::ArcWithoutCentre, {});
      return std::nullopt;
    }
    for (const std::size_t axis : {first, second}) {
      const double offsetMm = words.hasCentre[axis] ? words.centre[axis] * m_lengthFactor : 0.0;
      if (!(std::abs(offsetMm) <= kCoordinateMmMax)) {
        error(*words.centreTokens[axis], DiagnosticCode::ValueOutOfRange);
        return std::nullopt;
      }
      arc.centreMm.set(axis, m_position[axis] + offsetMm);
    }
    const ArcRadii radii = arcRadii(arc);
    const double mismatchMm = std::abs(radii.endMm - radii.startMm);
    if (!(mismatchMm <= kArcRadiusToleranceMm)) {
      report(Severity::Error, column, DiagnosticCode::ArcRadiusMismatch,
             base::formatFixed(mismatchMm, 4));
      return std::nullopt;
    }
    if (!(std::min(radii.startMm, radii.endMm) > 0.0)) {
      report(Severity::Error, column, DiagnosticCode::ArcWithoutCentre, {});
      return std::nullopt;
    }
    return arc;
  }

  std::optional<Arc> arcOfRadius(const Words& words, Arc arc, std::size_t first,
                                 std::size_t second) {
    const double radiusMm = words.radius * m_lengthFactor;
    if (!(std::abs(radiusMm) <= kCoordinateMmMax)) {
      error(*words.radiusToken, DiagnosticCode::ValueOutOfRange);
      return std::nullopt;
    }
    const double halfChordMm =
        std::hypot(arc.endMm[first] - arc.startMm[first], arc.endMm[second] - arc.startMm[second]) /
        2.0;
    if (halfChordMm == 0.0) {
      // Any centre at the right distance would do: the control refuses this as well.
      report(Severity::Error, words.motionColumn, DiagnosticCode::ArcWithoutCentre, {});
      return std::nullopt;
    }
    if (radiusMm == 0.0 || halfChordMm - std::abs(radiusMm) > kArcRadiusToleranceMm) {
      report(Severity::Error, words.motionColumn, DiagnosticCode::ArcRadiusTooSmall,
             fmt::format("{} < {}", base::formatFixed(std::abs(radiusMm), 4),
                         base::formatFixed(halfChordMm, 4)));
      return std::nullopt;
    }
    arc.centreMm = arcCentre(arc, radiusMm);
    return arc;
  }

  void finish() {
    // Within a block the findings about the motion come after those about its words.
    std::stable_sort(m_out.diagnostics.begin(), m_out.diagnostics.end(),
                     [](const Diagnostic& a, const Diagnostic& b) {
                       return std::pair(a.line, a.column) < std::pair(b.line, b.column);
                     });
    if (m_suppressed > 0) {
      m_out.diagnostics.push_back({m_suppressedWorst, m_suppressedLine, 1,
                                   DiagnosticCode::MoreFindings, fmt::format("{}", m_suppressed)});
    }
    Statistics& statistics = m_out.statistics;
    std::vector<double>& feeds = statistics.feedsMmPerMin;
    std::sort(feeds.begin(), feeds.end());
    feeds.erase(std::unique(feeds.begin(), feeds.end()), feeds.end());
    statistics.points = m_out.trajectory.points.size();
  }

  std::string_view m_text;
  LoadOptions m_options;
  Interpretation m_out;

  // Modal state of the control.
  Vec3 m_position;
  double m_feedMmPerS = 0.0;
  double m_lengthFactor = 1.0;
  double m_feedFactor = 1.0;
  std::size_t m_planeFirstAxis = 0;
  Motion m_motion = Motion::None;
  Motion m_motionBeforeUnsupported = Motion::None;
  bool m_relative = false;
  bool m_moved = false;
  int m_workOffset = -1;

  // Reading.
  base::LineNumber m_line;
  bool m_ended = false;
  bool m_tailReported = false;
  Token m_feedToken;
  std::vector<Vec3> m_arcPoints;

  // Findings made once, and those left out.
  bool m_feedMissingReported = false;
  std::bitset<10000> m_ignoredG;
  std::bitset<10000> m_ignoredM;
  std::bitset<10000> m_warnedM;
  std::bitset<26> m_ignoredLetters;
  std::vector<std::string> m_ignoredNames;
  std::size_t m_suppressed = 0;
  base::LineNumber m_suppressedLine;
  Severity m_suppressedWorst = Severity::Note;
};

}  // namespace

Interpretation interpret(std::string_view text, const LoadOptions& options) {
  RIVULET_ASSERT(options.chordToleranceMm > 0.0);
  return Interpreter(text, options).run();
}

}  // namespace rivulet::gcode
