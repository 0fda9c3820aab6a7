// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Windows with numbers: the program on the control copies only delivered windows, so a late client
/// makes the machine wait and never repeat. The client writes a window's content, waits for the
/// answer, and only then writes its number. It writes into a window again only after the control
/// has confirmed that it has a copy. Every request has the same effect if it is made twice, so a
/// lost answer costs only time.
///
/// Against writes from elsewhere (another client, a late request of an earlier connection), each
/// window carries a check number derived from the run's number, its own number and its content. The
/// program rejects a window that does not match.
///
/// Methods window, credit and file are this client. They differ in how the content of a window is
/// delivered, and in what the control reports about its motion.
/// @threadsafety one object, one thread.
#pragma once

#include <array>
#include <memory>
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
  /// @param saysExecuted  the program reports which windows have been executed
  WindowedMethod(MethodSetup&& setup, bool saysExecuted);

  /// Delivers the content of a window. @param points  of this window
  [[nodiscard]] virtual Action bring(std::size_t window, std::size_t points) = 0;
  /// Number of windows, from the first, whose place may be filled again.
  [[nodiscard]] virtual std::size_t freed() const { return m_latched; }
  /// Shortest time until all copied windows are executed, counted from the last sign of progress.
  [[nodiscard]] virtual base::Duration takenTime() const;
  /// The same if the machine moves as slowly as the program can make it.
  [[nodiscard]] virtual base::Duration takenTimeMax() const { return takenTime(); }
  /// STOPREs passed.
  [[nodiscard]] virtual std::size_t stopsPassed() const { return m_executed; }

  [[nodiscard]] std::size_t windowBegin(std::size_t window) const;
  [[nodiscard]] base::Duration windowTime(std::size_t window) const;
  /// No window comes after the one that ends before this point.
  [[nodiscard]] bool isLast(std::size_t end) const {
    return end == m_plan.pointCount() && !isOpen();
  }

 private:
  std::unique_ptr<live::PointSupplier> m_list;  ///< of the points of the setup, if it has no other
  live::PointSupplier& m_supplier;

 protected:
  SlotPlan m_plan;
  std::size_t m_slots;         ///< k
  std::size_t m_latched = 0;   ///< windows the control has taken
  std::size_t m_executed = 0;  ///< windows the axes have passed, as far as known

 private:
  enum class Step { Claim, AwaitOwner, Content, Number, Run, Watch, Look };
  enum class Trouble { None, OtherClient, Restarted, Ended };
  enum class Timer {
    Look,        ///< all header cells are read again to find out why there is no progress
    WindowEnds,  ///< the window in motion, at the earliest
    Count,
  };

  /// Header cells in the order in which they are read.
  enum HeaderItem { Latched, Delivered, Owner, State, Run, Executed };

  [[nodiscard]] Action write(Step step, std::size_t points = 0);
  [[nodiscard]] Action read(Step step, std::span<const opcua::Variable> variables);
  /// Reads cells that the control changes by itself, not more often than it makes sense.
  [[nodiscard]] std::optional<Action> watch(Step step, std::span<const opcua::Variable> variables,
                                            base::Instant now);
  void takeOwner(double owner, base::Instant now);
  void confirmNumber(base::Instant now);
  void confirmRun(base::Instant now);
  /// @param executed  as reported by the control; nothing if it does not report it
  void observe(double latched, std::optional<double> executed, const Answer& answer,
               base::Instant now);
  void look(const Answer& answer, base::Instant now);
  /// The next access after the control has accepted this run; nothing: there is nothing to deliver.
  [[nodiscard]] std::optional<Action> pollContent();
  /// From now on the control is expected to continue to the end of the copied windows.
  void expectTaken(base::Instant now);
  /// Until when the axes have points, and whether the client has something to deliver.
  void estimateNeed();
  /// @return false: the supplier has none now
  bool takeWindow(base::Instant now);
  /// Takes the next window if all that were taken are filled and there is room for it.
  void pullWindow(base::Instant now);
  /// More windows may come.
  [[nodiscard]] bool isOpen() const { return !m_isClosed; }
  /// Tells the supplier which windows move and how many points have been executed.
  void tellSupplier(base::Instant now);
  /// The value the run cell should have now.
  [[nodiscard]] int runWanted() const;

  std::vector<std::size_t> m_begins{0};  ///< first point of each window, and after the last one
  std::size_t m_windowCount = 0;         ///< windows that were taken
  std::array<opcua::Variable, 1> m_ownerCell;
  std::vector<opcua::Variable> m_watched;  ///< latched, and executed where the program says it
  std::vector<opcua::Variable> m_header;
  bool m_saysExecuted;
  Step m_step = Step::Claim;
  Trouble m_trouble = Trouble::None;
  bool m_waiting = false;
  bool m_stopWanted = false;
  bool m_holdWanted = false;
  bool m_isClosed = false;   ///< no more windows come: the last one is marked, or the end is asked
  std::size_t m_begun = 0;   ///< windows that are in motion or executed
  bool m_endWanted = false;  ///< that there are no more was known only after the last window
  bool m_renumber = false;   ///< the number on the control is not this run's: it is written again
  bool m_owned = false;      ///< the control has granted its cells to this run
  int m_run = templates::WindowProtocol::kHold;       ///< value of the run cell, as confirmed
  int m_runAsked = templates::WindowProtocol::kHold;  ///< value in the write that is outstanding
  std::size_t m_filled = 0;                           ///< windows whose content is confirmed
  std::size_t m_delivered = 0;                        ///< windows whose number is confirmed
  base::Instant m_takenAt{};  ///< when the control was last seen to progress
  base::TimerTable<Timer> m_timers;
  Progress m_progress;
};

/// The control copies each window; when one is copied, everything before it has been executed.
class WindowMethod : public WindowedMethod {
 public:
  /// With a supplier, what has been executed is read too: it is told.
  explicit WindowMethod(MethodSetup setup)
      : WindowMethod(std::move(setup), setup.supplier != nullptr) {}

 protected:
  WindowMethod(MethodSetup&& setup, bool saysExecuted)
      : WindowedMethod(std::move(setup), saysExecuted) {}

 private:
  [[nodiscard]] Action bring(std::size_t window, std::size_t points) final;
};

/// The control copies windows while earlier ones are in motion, so the number of executed windows
/// is read from a separate cell.
class CreditMethod final : public WindowMethod {
 public:
  explicit CreditMethod(MethodSetup setup) : WindowMethod(std::move(setup), true) {}

 private:
  [[nodiscard]] base::Duration takenTime() const override;
  [[nodiscard]] base::Duration takenTimeMax() const override;
  [[nodiscard]] std::size_t stopsPassed() const override { return 0; }
};

/// A window is a subprogram that is transferred. The control executes it without a copy, so its
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

/// The methods with windows as seen by a job: runs have numbers, and the program reports how far it
/// came.
class WindowMethodType : public MethodType {
 public:
  [[nodiscard]] std::unique_ptr<Method> make(MethodSetup setup) const override;
  void complete(RunSettings& settings, std::uint64_t entropy) const override;
  [[nodiscard]] std::vector<std::size_t> pausesBefore(std::span<const gcode::StreamPoint> points,
                                                      std::size_t pointsPerLoop,
                                                      WindowCut cut) const override;
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
                                                      std::size_t, WindowCut) const override {
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
