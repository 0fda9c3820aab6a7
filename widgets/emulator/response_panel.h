// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// For those who want it: the learned axes as Bode plot and step response. @threadsafety GUI
/// thread.
#pragma once

#include <vector>

#include "emulator/identification.h"
#include "widgets/common/page.h"

class QLabel;

namespace rivulet::widgets {

class CurveChart;

class ResponsePanel final : public Page {
  Q_OBJECT

 public:
  explicit ResponsePanel(QWidget* parent = nullptr);
  void setAxes(std::vector<emulator::LearnedAxis> axes);

 protected:
  void retranslate() override;

 private:
  std::vector<emulator::LearnedAxis> m_axes;
  CurveChart* m_gain;
  CurveChart* m_phase;
  CurveChart* m_step;
  QLabel* m_bandwidths = value({.id = "emulatorBandwidths", .wraps = true});
  QLabel* m_formulas = value({.id = "emulatorFormulas", .wraps = true});  ///< transfer functions
};

}  // namespace rivulet::widgets
