// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Windows with numbers: the program on the control takes none that has not been delivered, so a
/// client that is late makes the machine wait and never repeat. The client writes a window's
/// content, waits for the answer, and only then writes its number; it writes into a window again
/// only after the control has said that it holds a copy. Every request says the same when it is
/// made twice, so an answer that is lost costs time and nothing else.
///
/// Against writes that come from elsewhere (another client, a request of an earlier connection
/// that arrives late) each window carries a check number made of the run's number, its own number
/// and its content; the program refuses what does not fit.
///
/// Methods window, credit and file are this client. They differ in how the content of a window is
/// brought, and in what the control says of its motion.
/// @threadsafety one object, one thread.
#pragma once

#include <array>
#include <vector>

#include "streaming/methods/slots.h"

namespace rivulet::streaming {

class WindowedMethod : public Method {
 public:
  std::optional<Action> poll(base::Instant now) final;
  void handle(const Answer& answer, base::Instant now) final;
  bool answerLost(base::Instant now) final;
  void requestStop() final { m_stopWanted = true; }
  void requestHold(bool hold) final { m_holdWanted = hold; }
  const Progress& progress() const final { return m_progress; }
  std::optional<base::Error> failure() const final;
  bool waitsForClient() const final { return true; }
  std::string_view adviceWhenLost() const final;
  std::string_view adviceWhenStalled() const final;

 protected:
  /// @param saysExecuted  the program says which windows have been executed
  WindowedMethod(MethodSetup&& setup, bool saysExecuted);

  /// Brings the content of a window. @param points  of this window
  [[nodiscard]] virtual Action bring(std::size_t window, std::size_t points) = 0;
  /// Windows whose place may be filled again, counted from the first.
  [[nodiscard]] virtual std::size_t freed() const { return m_latched; }
  /// Shortest time until what the control has taken is executed, counted from its last sign.
  [[nodiscard]] virtual base::Duration takenTime() const;
  /// The same if the machine goes as slowly as the program may make it.
  [[nodiscard]] virtual base::Duration takenTimeMax() const { return takenTime(); }
  /// STOPREs passed.
  [[nodiscard]] virtual std::size_t stopsPassed() const { return m_executed; }

  [[nodiscard]] std::size_t windowBegin(std::size_t window) const;
  [[nodiscard]] base::Duration windowTime(std::size_t window) const;

  SlotPlan m_plan;
  std::size_t m_slots;         ///< k
  std::size_t m_latched = 0;   ///< windows the control has taken
  std::size_t m_executed = 0;  ///< windows the axes have passed, as far as known

 private:
  enum class Step { Claim, AwaitOwner, Content, Number, Run, Beat, Watch, Look };
  enum class Trouble { None, OtherClient, Restarted, Ended };
  enum class Timer {
    Beat,        ///< the next sign of life
    Look,        ///< all header cells are read again to see why nothing goes on
    WindowEnds,  ///< the window in motion, at the earliest
    Count,
  };

  /// Header cells in the order in which they are read.
  enum HeaderItem { Latched, Delivered, Owner, State, Run, Executed };

  [[nodiscard]] Action write(Step step, std::size_t points = 0);
  [[nodiscard]] Action read(Step step, std::span<const opcua::Variable> variables);
  void takeOwner(double owner, base::Instant now);
  void confirmNumber(base::Instant now);
  void confirmRun(base::Instant now);
  /// @param executed  as the control says; nothing where it does not
  void observe(double latched, std::optional<double> executed, const Answer& answer,
               base::Instant now);
  void look(const Answer& answer, base::Instant now);
  /// The next access, once the control obeys this run; nothing: the stream has nothing to bring.
  [[nodiscard]] std::optional<Action> pollContent();
  /// From now on the control is expected to go on to the end of what it has taken.
  void expectTaken(base::Instant now);
  /// Until when the axes have enough, and whether the client has something to bring.
  void estimateNeed();
  /// The value the run cell should have now.
  [[nodiscard]] int runWanted() const;

  std::vector<std::size_t> m_begins;  ///< first point of each window, and after the last one
  std::size_t m_windowCount;          ///< windows the points make
  std::array<opcua::Variable, 1> m_ownerCell;
  std::vector<opcua::Variable> m_watched;  ///< latched, and executed where the program says it
  std::vector<opcua::Variable> m_header;
  bool m_saysExecuted;
  Step m_step = Step::Claim;
  Trouble m_trouble = Trouble::None;
  bool m_waiting = false;
  bool m_stopWanted = false;
  bool m_holdWanted = false;
  bool m_renumber = false;  ///< the number on the control is not ours: it is written again
  bool m_owned = false;     ///< the control has granted us its cells
  int m_run = templates::WindowProtocol::kHold;       ///< value of the run cell, as confirmed
  int m_runAsked = templates::WindowProtocol::kHold;  ///< value in the write that is outstanding
  std::size_t m_filled = 0;                           ///< windows whose content is confirmed
  std::size_t m_delivered = 0;                        ///< windows whose number is confirmed
  base::Instant m_takenAt{};                          ///< when the control was seen to come further
  base::TimerTable<Timer> m_timers;
  double m_beat = 0.0;
  Progress m_progress;
};

/// The control copies each window; one that is copied has everything before it executed.
class WindowMethod : public WindowedMethod {
 public:
  explicit WindowMethod(MethodSetup setup) : WindowMethod(std::move(setup), false) {}

 protected:
  WindowMethod(MethodSetup&& setup, bool saysExecuted)
      : WindowedMethod(std::move(setup), saysExecuted) {}

 private:
  [[nodiscard]] Action bring(std::size_t window, std::size_t points) final;
};

/// The control copies windows while those before are in motion, so what has been executed is read
/// from a cell of its own.
class CreditMethod final : public WindowMethod {
 public:
  explicit CreditMethod(MethodSetup setup) : WindowMethod(std::move(setup), true) {}

 private:
  [[nodiscard]] base::Duration takenTime() const override;
  [[nodiscard]] base::Duration takenTimeMax() const override;
  [[nodiscard]] std::size_t stopsPassed() const override { return 0; }
};

/// A window is a subprogram that is transferred. The control executes it where it lies, so its
/// place is free only after it has been executed.
class FileMethod final : public WindowedMethod {
 public:
  explicit FileMethod(MethodSetup setup) : WindowedMethod(std::move(setup), true) {}

 private:
  [[nodiscard]] Action bring(std::size_t window, std::size_t points) override;
  [[nodiscard]] std::size_t freed() const override { return m_executed; }

  std::string m_name;  ///< of the window that is being transferred
  std::string m_text;
};

/// What the methods with windows are for a job: runs have numbers, and the program says how far it
/// came.
class WindowMethodType : public MethodType {
 public:
  [[nodiscard]] std::unique_ptr<Method> make(MethodSetup setup) const override;
  void complete(RunSettings& settings, std::uint64_t entropy) const override;
  [[nodiscard]] std::vector<std::size_t> pausesBefore(std::span<const gcode::StreamPoint> points,
                                                      std::size_t pointsPerLoop,
                                                      bool place) const override;
  [[nodiscard]] std::optional<Checkpoint> checkpoint(const RunSettings& settings,
                                                     const Resume& from) const final;
  [[nodiscard]] int windowsTakenMax(const templates::TemplateParameters&) const override {
    return 1;
  }
  [[nodiscard]] std::optional<ProgramEnd> askEnd(
      opcua::Link& link, const templates::CellMap& cells, const RunSettings& settings,
      std::span<const gcode::StreamPoint> points) const final;
};

class CreditMethodType final : public WindowMethodType {
 public:
  [[nodiscard]] std::unique_ptr<Method> make(MethodSetup setup) const override;
  /// Without pauses between windows there is nothing to place.
  void complete(RunSettings& settings, std::uint64_t entropy) const override;
  [[nodiscard]] std::vector<std::size_t> pausesBefore(std::span<const gcode::StreamPoint>,
                                                      std::size_t, bool) const override {
    return {};
  }
  [[nodiscard]] int windowsTakenMax(
      const templates::TemplateParameters& parameters) const override {
    return parameters.windowsAhead;
  }
};

class FileMethodType final : public WindowMethodType {
 public:
  [[nodiscard]] std::unique_ptr<Method> make(MethodSetup setup) const override;
};

}  // namespace rivulet::streaming
