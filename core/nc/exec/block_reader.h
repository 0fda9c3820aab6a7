// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Takes the words of one block into `BlockWords`, as numbers. What holds for the whole block
/// wherever it stands (G91, DIAMON, G94) takes effect at once. @threadsafety one object, one
/// thread.
#pragma once

#include <deque>
#include <optional>
#include <string>

#include "nc/eval/variables.h"
#include "nc/exec/block_words.h"
#include "nc/exec/sink.h"
#include "nc/modal/state.h"
#include "nc/modal/vocabulary.h"
#include "nc/syntax/language.h"

namespace rivulet::nc {

/// True for those that the executor makes: G73, G81 to G83, G85 and G89 of RS-274.
/// @param key  ten times the number
[[nodiscard]] bool isCannedCycle(int key);

class BlockReader {
 public:
  /// All outlive the reader.
  /// @param runsCannedCycles  see `ExecutorOptions`
  BlockReader(const Language& language, bool runsCannedCycles, ModalState& state,
              Variables& variables, Sinks to);

  /// @param token  lives as long as `words`
  void read(const Token& token, BlockWords& words);
  /// The block has been executed. Its `BlockWords` are not to be used any more.
  void endBlock() {
    if (!m_calculated.empty()) {
      m_calculated.clear();
    }
    if (!m_pending.empty()) {
      assignPending();
    }
    if (m_tool.isNamed) {
      compareLength();
    }
  }
  /// The tool has moved: another work offset would send it to a wrong place.
  void setMoved() { m_moved = true; }
  /// @param number  of the further offsets of G54.1 and G154
  void selectWorkOffset(int key, const Token& token, double number = 0.0);

 private:
  // Kinds of tokens.
  void readWord(const Token& token, BlockWords& words);
  void readUnreadable(const Token& token);
  void readText(const Token& token, BlockWords& words);
  void readIndexed(const Token& token, BlockWords& words);
  void readCalculated(const Token& token, BlockWords& words);
  void readIndexedAxis(const Token& token, BlockWords& words);
  void readAssignment(const Token& token, BlockWords& words);
  void assign(const Token& token, BlockWords& words);
  void assignLater(const Token& token);
  void assignPending();
  void compareLength();
  void readArgument(const Token& token, RareWords& call) const;
  [[nodiscard]] bool isVariable(const Token& token) const;
  [[nodiscard]] std::optional<double> numberOf(const Token& token);
  [[nodiscard]] bool isVacant(const Expression& value) const;

  // Letters.
  void reportRepetition(const Token& token);
  void readAxis(const Token& token, BlockWords& words);
  void readCentre(const Token& token, BlockWords& words);
  void readFurtherAxis(const Token& token, BlockWords& words);
  void readRadius(const Token& token, BlockWords& words);
  void readFeed(const Token& token, BlockWords& words);
  void readNumber(const Token& /*token*/, BlockWords& /*words*/) {}
  void readMachineWord(const Token& token, BlockWords& words);
  void readP(const Token& token, BlockWords& words);
  void readQ(const Token& token, BlockWords& words);
  void readL(const Token& token, BlockWords& words);
  void readPolarSign(const Token& token, BlockWords& words);
  void readE(const Token& token, BlockWords& words);
  void refuseWord(const Token& token, BlockWords& words);
  static void noteColumn(const Token& token, BlockWords& words);
  void setRadius(const Token& token, BlockWords& words);

  // G and M functions.
  void readG(const Token& token, BlockWords& words);
  void readM(const Token& token, BlockWords& words);
  void readG(const GRow& row, const Token& token, BlockWords& words);
  void readBlockG(const GRow& row, const Token& token, BlockWords& words);
  void setFeedMode(FeedMode mode);
  void setModal(const GRow*& slot, const GRow& row, const Token& token);
  void readDistance(const GRow& row, const Token& token, BlockWords& words);
  void readSpindleMode(const GRow& row, const Token& token, BlockWords& words);
  void readBlockEnd(const GRow& row, const Token& token, BlockWords& words);
  void beginCannedCycle(int key, BlockWords& words);
  void readForeignMotion(GEffect effect, const Token& token, BlockWords& words);
  void beginForeignMotion(BlockWords& words);
  void readTurningCycle(const Token& token, BlockWords& words);

  // Names.
  void readName(const Token& token, BlockWords& words);
  void readNamedAddress(const Token& token, const std::string& name, BlockWords& words);
  void setNamed(const std::string& name, const Token& token, BlockWords& words);
  void readFeedGroup(const Token& token, const std::string& name);
  void readFeedName(NameEffect effect, const Token& token, const std::string& name,
                    BlockWords& words);
  void readUnknownName(const Token& token, BlockWords& words);
  void readCycle(const Token& token, const std::string& name, BlockWords& words);
  void forgetArguments(const Token& token);

  /// Which length G43 takes, beside the tool that M6 has put into the spindle.
  struct ToolWords {
    bool isNamed = false;  ///< the block has one of them
    bool changes = false;  ///< M6
    bool takesLength = false;
    std::optional<double> length;  ///< H
    int lengthColumn = 1;
    std::optional<double> next;  ///< T
    std::optional<double> inSpindle;
  };
  ToolWords m_tool;

  const Language& m_language;
  const bool m_runsCannedCycles;
  const GTable& m_g;
  ModalState& m_state;
  Variables& m_variables;
  Sinks m_to;
  std::deque<Token> m_calculated;  ///< of the present block
  /// A variable that gets its value when the block has been executed.
  struct Pending {
    Token token;
    Expression target;
    Value value;
  };
  std::vector<Pending> m_pending;
  bool m_moved = false;
};

}  // namespace rivulet::nc
