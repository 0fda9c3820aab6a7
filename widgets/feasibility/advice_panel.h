// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Beside the chart: what could be changed, in order of gain, one click each; and sliders of N, δ
/// and F with the verdict on what is under the finger. @threadsafety GUI thread.
#pragma once

#include <optional>
#include <vector>

#include "feasibility/advice.h"
#include "widgets/common/page.h"
#include "widgets/feasibility/feed_scale.h"

class QLabel;
class QSlider;
class QVBoxLayout;

namespace rivulet::widgets {

class StatusLabel;

class AdvicePanel final : public Page {
  Q_OBJECT

 public:
  explicit AdvicePanel(QWidget* parent = nullptr);

  /// @param pointsPerLoopMax  largest N that fits
  void setOperatingPoint(const feasibility::OperatingPoint& point, int pointsPerLoopMax,
                         const FeedScale& scale = {});
  /// The verdict on the operating point. Nothing: no program.
  void setVerdict(const std::optional<feasibility::Verdict>& verdict);
  /// On what is under the finger. Ignored if the sliders have moved on.
  void setTurned(const feasibility::OperatingPoint& point,
                 const std::optional<feasibility::Verdict>& verdict);
  /// Advice is being looked for.
  void setBusy();
  void setAdvice(const std::vector<feasibility::Advice>& list);
  void setEditable(bool isEditable);

  /// "N 9 instead of 7: largest feed 829 → 1,090 mm/min", or "largest override 83 → 109 %".
  [[nodiscard]] static QString adviceText(const feasibility::Advice& advice,
                                          const FeedScale& scale = {});

 Q_SIGNALS:
  /// A slider is being moved; nothing is set.
  void turnRequested(const rivulet::feasibility::OperatingPoint& point);
  void operatingPointRequested(const rivulet::feasibility::OperatingPoint& point);

 protected:
  void retranslate() override;
  void restyle() override;

 private:
  enum Knob { Points, Delta, Feed, KnobCount };

  void buildKnobs(QVBoxLayout* layout);
  void placeKnobs();
  void takeKnobs(bool isReleased);
  void showKnobs();
  void showVerdict();
  void showAdvice();

  QVBoxLayout* m_adviceRows;
  QWidget* m_adviceBox;
  StatusLabel* m_adviceNote = status({.wraps = true});
  std::array<QLabel*, KnobCount> m_names{};
  std::array<QLabel*, KnobCount> m_values{};
  std::array<QSlider*, KnobCount> m_knobs{};
  StatusLabel* m_verdictLabel = status({.wraps = true});

  feasibility::OperatingPoint m_point;  ///< as set
  feasibility::OperatingPoint m_under;  ///< under the finger
  std::optional<feasibility::Verdict> m_verdict;
  std::optional<feasibility::Verdict> m_turned;  ///< of `m_under`; nothing: not known yet
  int m_pointsPerLoopMax = 2;
  double m_deltaMmMax = 1.0;
  FeedScale m_scale;
  double m_feedShownMax = 1000.0;  ///< as `FeedScale::shown`, at the right end of the slider
  int m_feedSteps = 1;
  bool m_isPlacing = false;
  bool m_isBusy = false;
  bool m_isEditable = true;
  std::vector<feasibility::Advice> m_list;
};

}  // namespace rivulet::widgets
