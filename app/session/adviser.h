// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Looks for settings that stream a program faster, and judges settings while they are being
/// turned, outside the GUI thread: both depend on every point of the program. What has been
/// overtaken by a later request is not reported.
/// @threadsafety GUI thread; the work itself runs in the pool (`session/background.h`).
#pragma once

#include <QObject>
#include <atomic>
#include <memory>
#include <optional>
#include <vector>

#include "feasibility/advice.h"
#include "overview/program_view.h"
#include "session/rehearsal.h"

namespace rivulet::session {

struct AdviceJob {
  std::shared_ptr<const overview::ProgramView> view;  ///< at least 2 points
  feasibility::AdviceQuestion question;               ///< without `complete`
  /// For the simulation; N, δ, method, F or override are replaced.
  streaming::RunSettings settings;
  std::shared_ptr<const machine::MachineConfig> machine{};  ///< as `RehearsalJob::machine`
};

/// Advice whose largest feeds also ran without a wrong point in the simulation; where it did not, a
/// lower feed that did stands in its place. @param stop  set by another thread: give up
/// @threadsafety pure
[[nodiscard]] std::vector<feasibility::Advice> simulatedAdvice(const AdviceJob& job,
                                                               const std::atomic<bool>& stop);

/// The verdict on settings that are being turned.
struct TurnedVerdict {
  feasibility::OperatingPoint point;
  std::optional<feasibility::Verdict> verdict;
  base::Error error;  ///< why there is none
};

class Adviser final : public QObject {
  Q_OBJECT

 public:
  explicit Adviser(QObject* parent = nullptr) : QObject(parent) {}
  ~Adviser() override;

  /// `advised` answers.
  void advise(AdviceJob job);
  /// The verdict on the operating point of the question; `turned` answers.
  void judge(AdviceJob job);
  /// Nothing is reported any more of what was asked.
  void cancel();

 Q_SIGNALS:
  void advised(const std::shared_ptr<const std::vector<rivulet::feasibility::Advice>>& list);
  void turned(const rivulet::session::TurnedVerdict& verdict);

 private:
  std::shared_ptr<std::atomic<bool>> m_stopAdvice;  ///< of the work in progress; null: none
  std::shared_ptr<std::atomic<bool>> m_stopVerdict;
};

}  // namespace rivulet::session
