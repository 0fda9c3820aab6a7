// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "job/main_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "base/text.h"
#include "job/linuxcnc_text.h"
#include "job/main_program.h"
#include "job/plan_writer.h"
#include "nc/syntax/lexer.h"
#include "nc/syntax/parser.h"
#include "templates/feed_cell.h"
#include "templates/linuxcnc_protocol.h"

namespace rivulet::job {

namespace {

using templates::JobProtocol;
using templates::WindowProtocol;

/// Before a native block a client may stop or hold the job, except where blocks belong together.
bool mayWaitBefore(NativeReason reason) {
  return reason >= NativeReason::Tool;
}

/// A block without the words that end a program: what it does besides is done before. Nothing that
/// stands behind RET is executed.
std::string withoutEnd(std::string_view block) {
  nc::Lexer lexer(block, nc::Dialect::Sinumerik);
  nc::Block words;
  std::string left;
  const char* at = block.data();
  while (lexer.next(words)) {
    for (const nc::Token& token : words.tokens) {
      const nc::EndWord end = nc::endWordOf(token);
      if (end == nc::EndWord::None) {
        left.append(at, token.text.data() + token.text.size());
      } else if (end == nc::EndWord::Ret) {
        return left;
      }
      at = token.text.data() + token.text.size();
    }
  }
  return left;
}

/// When the number of a block is told, and where the client may stop the job: the same on all
/// controls.
class MainWriter : public PlanWriter {
 public:
  MainWriter(const Plan& plan, const templates::JobLoop& loop, int number)
      : PlanWriter(plan), m_loop(loop), m_number(number) {
    for (const Part& part : plan.parts) {
      const auto* const native = std::get_if<NativeBlock>(&part);
      if (native == nullptr || !native->text.empty()) {
        m_last = native;
      }
    }
    m_lastText = m_last != nullptr ? withoutEnd(m_last->text) : std::string();
  }

  base::Result<std::string> write() {
    writeHead();
    writeParts(plan().parts.size());
    writeStandstill();
    writeBlock(doneNumber(plan()));
    writeEnd();
    return m_failure ? base::Result<std::string>(tl::unexpected(*m_failure)) : take();
  }

 protected:
  /// All up to the wait of the loop for its client.
  virtual void writeHead() = 0;
  /// What follows is interpreted when the axes have executed what is before it.
  virtual void writeStandstill() = 0;
  /// The block cell gets the number when the axes have got there: what is interpreted is far ahead
  /// of them, and a reset would leave the number of a block that nobody has executed.
  virtual void writeNumber(int value) = 0;
  /// The same with the motion that follows. @param before  number in the cell
  /// @return false: not here, it is told with a later one
  virtual bool writeNumberWithMotion(int before, int value) = 0;
  virtual void writeCall(const Stretch& stretch) = 0;
  /// Stop and hold: while the run cell says so, and to the end if it says that.
  virtual void writeWait(int number) = 0;
  virtual void writeEnd() = 0;

  void writeBlock(int value) {
    writeNumber(value);
    m_block = value;
  }
  /// @param failure  the first counts
  void fail(base::Error failure) { m_failure = m_failure.value_or(std::move(failure)); }

  [[nodiscard]] const templates::JobLoop& loop() const { return m_loop; }
  [[nodiscard]] int number() const { return m_number; }
  [[nodiscard]] const NativeBlock* native() const { return m_native; }

 private:
  void writeStreamed(const Stretch& stretch) override {
    // The loop clears its cells when it is interpreted: not before the native blocks are done.
    cancelOverride();
    writeStandstill();
    writeBlock(-m_due);
    writeCall(stretch);
    writeBlock(0);
    m_due = 0;
  }

  void writeDue(const NativeBlock& native, int number) override {
    m_native = &native;
    m_due = number;
    m_isDueWithMotion = false;
    if (&native == m_last && base::trim(m_lastText).empty()) {
      return;
    }
    if (mayWaitBefore(native.reason)) {
      writeStandstill();
      writeBlock(-(number - 1));
      writeWait(++m_waits);
      writeBlock(number);
    } else if (native.reason == NativeReason::Retract) {
      writeStandstill();
      writeBlock(number);
    } else {
      m_isDueWithMotion = true;
    }
  }

  void beforeText(const std::string& text) override {
    if (m_isDueWithMotion && writeNumberWithMotion(m_block, m_due)) {
      m_block = m_due;
    }
    leaveLinesOfLoop(text);
  }

  /// A trace of the control names lines alone: where the loop moves, this program does not.
  void leaveLinesOfLoop(const std::string& text) {
    const auto count = 1 + static_cast<unsigned>(std::count(text.begin(), text.end(), '\n'));
    const auto isTaken = [this, count](std::uint32_t motion) {
      return motion > lineCount() && motion <= lineCount() + count;
    };
    while (std::any_of(m_loop.motionLines.begin(), m_loop.motionLines.end(), isTaken)) {
      append(";");
    }
  }

  [[nodiscard]] const std::string& textOf(const NativeBlock& native) const override {
    return &native == m_last ? m_lastText : native.text;
  }

  const templates::JobLoop& m_loop;
  int m_number;
  const NativeBlock* m_last = nullptr;    ///< with which the job ends; null: with a stretch
  std::string m_lastText;                 ///< without the end of the program
  const NativeBlock* m_native = nullptr;  ///< the present one
  std::optional<base::Error> m_failure;
  int m_waits = 0;
  int m_due = 0;    ///< the last native block since the stretch; 0: none
  int m_block = 0;  ///< in the block cell, where the program is
  bool m_isDueWithMotion = false;
};

class SinumerikMain final : public MainWriter {
 public:
  using MainWriter::MainWriter;

 private:
  void writeHead() override {
    line("; RIVULET JOB {}: {} OF {}", number(), plan().program.hash, plan().program.name);
    line("; {} stretches are streamed by the client, {} blocks are executed here.",
         plan().stretchCount(), plan().nativeCount());
    line("; Do not edit: the client relies on every line. Needs {}.", loop().name);
    line("; Nothing moves before the client has connected.");
    line("EXTERN {}(REAL,REAL,REAL)", subprogramName(loop()));
    line("DEF REAL RIV_RUN");
    for (const std::string& block : templates::feedCellBlocks(loop().cells)) {
      line("{}", block);
    }
    line("{}({},0,0)", subprogramName(loop()), number());
    line("IF R{}<>{} GOTOF RIV_END", loop().cells.state,
         static_cast<int>(templates::WindowState::Done));
    line("RIV_RUN=R{}", loop().cells.owner);
    writeBlock(0);
    line("R{}={}", loop().cells.run, JobProtocol::goOn(0));
  }
  void writeStandstill() override { line("STOPRE"); }
  void writeNumber(int value) override { line("R{}={}", blockCell(loop()), value); }
  /// In the main run, with the block that follows; too late, if that is not one of the main run.
  bool writeNumberWithMotion(int before, int value) override {
    line("WHEN $R{0}=={1} DO $R{0}={2}", blockCell(loop()), before, value);
    return true;
  }
  void writeCall(const Stretch& stretch) override {
    line("{}({},{},RIV_RUN+{})", subprogramName(loop()), number(), stretch.number, stretch.number);
    line("IF R{}<>{} GOTOF RIV_END", loop().cells.state,
         static_cast<int>(templates::WindowState::Done));
  }
  void writeWait(int wait) override {
    line("RIV_W{}:", wait);
    line("STOPRE");
    line("IF R{}=={} GOTOF RIV_END", loop().cells.run, WindowProtocol::kEnd);
    line("IF R{}<>{} GOTOF RIV_G{}", loop().cells.run, WindowProtocol::kHold, wait);
    line("G4 F0.02");
    line("GOTOB RIV_W{}", wait);
    line("RIV_G{}:", wait);
  }
  void writeEnd() override {
    line("RIV_END:");
    line("M30");
  }
};

/// One file: the loop is a subroutine at its beginning.
class LinuxCncMain final : public MainWriter {
 public:
  LinuxCncMain(const Plan& plan, const templates::JobLoop& loop, int number)
      : MainWriter(plan, loop, number), m_text(plan.program.dialect) {}

 private:
  using Protocol = templates::LinuxCncProtocol;
  /// O-words before it are those of the loop.
  static constexpr int kFirstWait = 100'000;

  void put(const std::string& text) override {
    if (text.starts_with(";")) {
      append(text);
      return;
    }
    const bool isOwnPoint = plan().program.dialect == nc::Dialect::LinuxCnc && native() != nullptr;
    m_text.setFixedPoint(isOwnPoint ? native()->fixedPoint : std::string());
    const auto blocks = m_text.convert(text);
    if (!blocks) {
      const NativeBlock* const block = native();
      const std::string& file =
          block == nullptr || block->file.empty() ? plan().program.name : block->file;
      fail(base::makeError(
          JobError::NotTranslated,
          fmt::format("LinuxCNC has no words for this block: {} ({}). Take it out of the program.",
                      block == nullptr ? text : block->source, blocks.error()),
          block == nullptr ? file : fmt::format("{}:{}", file, block->place.line.value)));
    } else if (!blocks->empty()) {
      append(*blocks);
    }
  }
  template <class... Arguments>
  void own(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
    append(fmt::format(text, std::forward<Arguments>(arguments)...));
  }

  void writeHead() override {
    std::string_view text = loop().text;
    append(std::string(text.substr(0, text.size() - 1)));  // less the end of its last line
    own("; RIVULET JOB {}: {} OF {}", number(), plan().program.hash, plan().program.name);
    own("; {} stretches are streamed by the client, {} blocks are executed here.",
        plan().stretchCount(), plan().nativeCount());
    own("; Do not edit: the client relies on every line.");
    own("; Nothing moves before the client has connected.");
    own("o<{}> call [{}] [0] [0]", loop().name, number());
    m_text.loopCalled();
    own("#<riv_run>=#<_hal[{}{:02}]>", Protocol::kOutputPin, static_cast<int>(Protocol::Owner));
    writeBlock(0);
  }
  void writeStandstill() override { own("M66 E0 L0"); }
  void writeNumber(int value) override {
    own("M68 E{} Q{}", static_cast<int>(Protocol::Block), value);
  }
  bool writeNumberWithMotion(int, int value) override {
    if (m_text.compensates()) {
      return false;  // LinuxCNC has no outputs there
    }
    own("M67 E{} Q{}", static_cast<int>(Protocol::Block), value);
    return true;
  }
  void writeCall(const Stretch& stretch) override {
    own("o<{}> call [{}] [{}] [#<riv_run>+{}]", loop().name, number(), stretch.number,
        stretch.number);
    m_text.loopCalled();
  }
  void writeWait(int wait) override {
    const std::string run = fmt::format("#<_hal[{}{}]>", Protocol::kCellPin, loop().cells.run);
    const int label = kFirstWait + 2 * wait;
    own("o{} while [{} EQ {}]", label, run, WindowProtocol::kHold);
    own("G4 P0.02");
    own("M66 E0 L0");
    own("o{} endwhile", label);
    own("o{} if [{} EQ {}]", label + 1, run, WindowProtocol::kEnd);
    writeEnd();
    own("o{} endif", label + 1);
  }
  void writeEnd() override {
    own("M52 P0");
    own("M2");
  }

  LinuxCncText m_text;
};

}  // namespace

base::Result<std::string> mainProgramOf(const Plan& plan, const templates::JobLoop& loop,
                                        int number) {
  return loop.isOwnFile ? SinumerikMain(plan, loop, number).write()
                        : LinuxCncMain(plan, loop, number).write();
}

}  // namespace rivulet::job
