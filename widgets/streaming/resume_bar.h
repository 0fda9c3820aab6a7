// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A bar above the bottom of the window: the control has been asked where an interrupted run was
/// left, and the bar shows where it would resume. Nothing moves until the operator confirms it
/// here. Hidden while there is no such run. @threadsafety GUI thread.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/id.h"
#include "base/vec3.h"
#include "widgets/common/notice_bar.h"

namespace rivulet::widgets {

/// Where a run would resume, or start in the middle of the program.
struct ResumePlace {
  std::size_t point = 0;  ///< index of the first to be executed
  std::size_t points = 0;
  base::LineNumber line;             ///< of that point
  base::Vec3 positionMm;             ///< of that point, workpiece frame
  std::optional<double> approachMm;  ///< straight distance from the tool to it, if known
  /// Index of the first point that differs from the program of the interrupted run, if one does.
  std::optional<std::size_t> changedFrom;
  /// The program that was left still stands on the control: the path that it executes first, at
  /// most. Nothing: it has ended.
  std::optional<double> restMm{};

  /// The operator has chosen the line; no run was left there.
  bool isChosen = false;
  double feedMmPerS = 0.0;  ///< then: commanded for the move to the point
  bool isRapid = false;     ///< then: that move is a rapid
  /// A whole job goes on; the rest is of such a job.
  bool isJob = false;
  int stretch = 0;                 ///< with which it goes on, or that comes next; 0: none is left
  std::string block;               ///< of the control, with which it goes on; empty: with a point
  std::vector<std::string> steps;  ///< what the control does first, one NC text each
  std::vector<std::string> notRestored;  ///< earlier blocks whose effect only the control knows
};

/// What a program that still stands does once the resume is confirmed; empty: it has ended.
[[nodiscard]] QString restText(const ResumePlace& place);

class ResumeBar final : public NoticeBar {
  Q_OBJECT

 public:
  explicit ResumeBar(QWidget* parent = nullptr);

  void showAsking();
  void showPlace(const ResumePlace& place);
  /// @param reason  a sentence
  void showRefusal(const QString& reason);
  void showNothing();
  /// The place, while one is shown.
  [[nodiscard]] const std::optional<ResumePlace>& place() const { return m_place; }

 Q_SIGNALS:
  /// The operator has seen the place and wants to resume there.
  void goOnRequested();
  void dismissed();

 protected:
  void retranslate() override;

 private:
  enum class State { Nothing, Asking, Place, Refusal };
  void setState(State state);
  [[nodiscard]] QString placeText() const;
  [[nodiscard]] QString jobText() const;

  State m_state = State::Nothing;
  std::optional<ResumePlace> m_place;
  QString m_reason;
  HoldButton* m_goOn;
  QPushButton* m_dismiss;
};

}  // namespace rivulet::widgets
