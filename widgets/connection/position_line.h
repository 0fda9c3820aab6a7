// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Where the tool is and how fast it moves, in one line on every page. The digits are as large as
/// the width permits. What is older than half a second is grey, crossed out, and has its age; a
/// point that stands in for the position of the axes says so.
/// @threadsafety GUI thread.
#pragma once

#include <array>

#include "widgets/common/page.h"
#include "widgets/connection/machine_view.h"

namespace rivulet::widgets {

class ElidedLabel;
class StatusLabel;

class PositionLine final : public Page {
  Q_OBJECT

 public:
  explicit PositionLine(QWidget* parent = nullptr);

  void setMachineState(const MachineView& machine);

  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  void retranslate() override;
  void restyle() override;
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Readout {
    QWidget* group;
    QLabel* name;
    QLabel* value;
  };

  void showAll();
  void showFreshness();
  /// Actual feed and, during a run, the commanded one.
  [[nodiscard]] QString feedLine() const;
  void fitFonts();

  MachineView m_machine;
  /// X Y Z, then A B C, which are hidden if the machine has none, then the feed.
  static constexpr std::size_t kAxisReadouts = base::kAxisCount + base::kRotaryAxisCount;
  static constexpr std::size_t kFeed = kAxisReadouts;
  std::array<Readout, kAxisReadouts + 1> m_readouts{};
  StatusLabel* m_freshness;
};

}  // namespace rivulet::widgets
