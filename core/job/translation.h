// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Words of other dialects in the language of a SINUMERIK: what is common, and nothing else.
/// @threadsafety plain values.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/axes.h"
#include "base/vec3.h"
#include "job/plan.h"
#include "nc/syntax/language.h"

namespace rivulet::job {

/// A word that the control executes, as the reader of the program has understood it.
struct ForeignWord {
  enum class Kind : unsigned char {
    Tool,
    NamedTool,
    M,
    Spindle,
    Dwell,         ///< seconds
    G,             ///< key as in `nc::gTable`
    LengthCell,    ///< H, and D of the dialects that have no H
    Line,          ///< `text` is a line for the control
    Compensation,  ///< the same, which compensates the radius
    Other,         ///< see `text`
  };
  Kind kind = Kind::Other;
  double value = 0.0;
  std::string text;  ///< as written, for messages; of a named tool its name
};

/// A move to a fixed point or in machine coordinates, mm; nothing: the axis is not named.
struct HomeMove {
  bool toFixedPoint = false;  ///< G28, G30: the values are those of a point on the way
  std::array<std::optional<double>, base::kAxisCount> targetMm{};
  std::array<std::optional<double>, base::kRotaryAxisCount> targetDeg{};
};

struct Translation {
  std::vector<std::string> before;  ///< lines that precede the motion of the block
  std::vector<std::string> after;
  std::vector<std::string> missing;  ///< words without a translation
  /// Why a tool length cannot be set, and which.
  std::vector<std::pair<RefusalCode, std::string>> refused;
  /// The offset of another tool than the one in the spindle, whose length is taken: "H3 (T2)".
  std::string assumedLength;
};

/// The settable frame for a G function of the other dialects. @param key  as in `nc::gTable`
[[nodiscard]] std::optional<std::string> workOffsetOf(int key);

class Translator {
 public:
  /// @param accepted  words that the user has accepted, as `LoadOptions::accepted`
  Translator(const Profile& profile, const std::vector<std::string>& accepted)
      : m_profile(profile), m_accepted(accepted) {}

  /// An M function that means the same on both controls; others are the profile's.
  [[nodiscard]] static bool knowsM(nc::Dialect dialect, int number);
  /// One that the language itself defines: what it does to the path, the tool or the order of
  /// blocks no machine's table can say.
  [[nodiscard]] static bool isOfLanguage(nc::Dialect dialect, int number);
  /// Of one that is known.
  [[nodiscard]] static NativeReason reasonOfM(int number);
  /// The words of one block. @param home  nothing: the block has no such move
  [[nodiscard]] Translation translate(const std::vector<ForeignWord>& words,
                                      const std::optional<HomeMove>& home,
                                      const nc::Language& language);
  /// The lines for the tool axis of such a move, with the offset in force.
  [[nodiscard]] std::vector<std::string> wayUp(const HomeMove& home) const;
  /// The offset of an earlier tool that the source still has in force, and the tool it has changed
  /// to: "H1 (T2)". The control cannot have it. Empty: there is none.
  [[nodiscard]] const std::string& foreignLength() const { return m_foreignLength; }
  /// The word that needs a tool before any tool change: the one in the spindle is taken, because
  /// nobody has said otherwise. Empty: there is none.
  [[nodiscard]] const std::string& assumedTool() const { return m_assumedTool; }

 private:
  /// What the control has of the length and the radius of its tool.
  enum class Offset : unsigned char {
    None,    ///< D0
    Tool,    ///< D1
    Radius,  ///< D1, with a length of 0
  };
  void translateM(int number, const ForeignWord& word, std::string& before, Translation& out);
  /// @param changes  the block changes the tool @param line  words before the motion
  void translateWord(const ForeignWord& word, bool changes, std::string& line, Translation& out);
  [[nodiscard]] std::string toolChange() const;
  void changeTool(const nc::Language& language);
  [[nodiscard]] bool setLength(const std::vector<ForeignWord>& words, const nc::Language& language,
                               Translation& out);
  [[nodiscard]] bool isOwnLength(const std::string& number, const std::string& word,
                                 Translation& out);
  void writeOffset(Offset before, bool changes, std::string& line, std::vector<std::string>& first,
                   Translation& out) const;
  [[nodiscard]] std::vector<std::string> offsetLines() const;
  void goHome(const HomeMove& home, Translation& out) const;
  [[nodiscard]] bool isAccepted(const std::string& word) const;

  const Profile& m_profile;
  const std::vector<std::string>& m_accepted;
  std::optional<std::string> m_tool;          ///< the last one named
  std::optional<std::string> m_inSpindle;     ///< the tool that M6 has changed to
  std::optional<std::string> m_lengthNumber;  ///< H of the source, the last one named but 0
  bool m_hasLength = false;                   ///< the source has asked for one
  Offset m_offset = Offset::Tool;             ///< as the operator has left it
  std::string m_foreignLength;
  std::string m_assumedTool;
};

}  // namespace rivulet::job
