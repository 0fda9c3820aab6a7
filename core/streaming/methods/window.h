// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Windows with numbers: the program on the control enters none that has not been delivered, so a
/// client that is late makes the machine wait and never repeat. The client writes a window's
/// content, waits for the answer, and only then writes its number; it writes into a window again
/// only after the control has said that it holds a copy. Every request says the same when it is
/// made twice, so an answer that is lost costs time and nothing else.
///
/// Against writes that come from elsewhere (another client, a request of an earlier connection
/// that arrives late) each window carries a check number made of the run's number, its own number
/// and its content; the program refuses what does not fit.
///
/// Method credit is the same client. Its program copies windows while those before are under way,
/// so what has been executed is read from a cell of its own. With method file a window is a
/// subprogram that is transferred; it is taken while it is executed, not copied, so its place is
/// free once it has been executed.
/// @threadsafety one object, one thread.
#pragma once

#include <array>
#include <vector>

#include "streaming/methods/slots.h"

namespace rivulet::streaming {

class WindowMethod final : public Method {
 public:
  explicit WindowMethod(MethodSetup setup);

  std::optional<Action> poll(base::Instant now) override;
  void handle(const Answer& answer, base::Instant now) override;
  bool answerLost(base::Instant now) override;
  void requestStop() override { m_stopWanted = true; }
  void requestHold(bool hold) override { m_holdWanted = hold; }
  const Progress& progress() const override { return m_progress; }
  std::optional<base::Error> failure() const override;

 private:
  enum class Step { Claim, AwaitOwner, Content, Number, Run, Beat, Watch, Look };
  enum class Trouble { None, OtherClient, Restarted, Ended };

  [[nodiscard]] Action write(Step step, std::size_t points = 0);
  [[nodiscard]] Action read(Step step, std::span<const opcua::Variable> variables);
  void addContent(std::size_t window);
  /// Method file: the same window as a subprogram.
  [[nodiscard]] Action store(std::size_t window);
  /// @param executed  as the control says; method credit only
  void observe(double latched, double executed, const Answer& answer, base::Instant now);
  void look(const Answer& answer, base::Instant now);
  [[nodiscard]] std::size_t windowBegin(std::size_t window) const;
  [[nodiscard]] base::Duration windowTime(std::size_t window) const;
  /// Shortest time until what the control has taken is executed, counted from its last sign.
  [[nodiscard]] base::Duration takenTime() const;
  /// The same, as long as it may well last.
  [[nodiscard]] base::Duration takenTimeMax() const;
  /// Until when the axes have enough, and whether the client has something to bring.
  void reckonNeed();
  /// The value the run cell should have now.
  [[nodiscard]] double runWanted() const;

  SlotPlan m_plan;
  std::size_t m_perWindow;
  std::size_t m_slots;                ///< k
  std::vector<std::size_t> m_begins;  ///< first point of each window, and behind the last one
  std::size_t m_windowCount;          ///< windows the points make
  std::array<opcua::Variable, 1> m_ownerCell;
  bool m_saysExecuted;  ///< the program says what has been executed: all but method window
  bool m_isCredit;
  std::string m_fileName;  ///< method file: of the window under way, and its text
  std::string m_fileText;
  std::vector<opcua::Variable> m_watched;  ///< latched; method credit: and executed
  std::vector<opcua::Variable> m_header;
  Step m_step = Step::Claim;
  bool m_waiting = false;
  bool m_stopWanted = false;
  bool m_holdWanted = false;
  bool m_renumber = false;       ///< the number on the control is not ours: it is written again
  base::Instant m_windowEnds{};  ///< the window in motion, at the earliest
  Trouble m_trouble = Trouble::None;
  bool m_owned = false;         ///< the control has granted us its cells
  double m_run = 0.0;           ///< value of the run cell, as far as confirmed
  double m_runAsked = 0.0;      ///< value in the write under way
  std::size_t m_filled = 0;     ///< windows whose content is confirmed
  std::size_t m_delivered = 0;  ///< windows whose number is confirmed
  std::size_t m_latched = 0;    ///< windows the control has copied
  std::size_t m_executed = 0;   ///< windows the axes have passed, as far as known
  base::Instant m_takenAt{};    ///< when the control was seen to come further
  base::Instant m_nextBeat{};
  base::Instant m_nextLook{};
  double m_beat = 0.0;
  Progress m_progress;
};

}  // namespace rivulet::streaming
