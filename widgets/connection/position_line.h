// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Where the tool is and how fast it moves, in one line on every page; below the position what is
/// to go, below the feed what is commanded. Then tool and spindle, with cutting edge, work offset
/// and coolant, as far as the control serves them: what it does not is left out. The digits are as
/// large as the width permits; where they would be small, the axes have the line to themselves, and
/// all else stands in a second one. What is older than half a second is grey, crossed out, and has
/// its age; a point that stands in for the position of the axes says so. What is not known is a
/// dash, and its tool tip says why.
/// @threadsafety GUI thread.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "widgets/common/page.h"
#include "widgets/connection/machine_view.h"

class QHBoxLayout;

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
    QLabel* detail;  ///< to go; of the feed, what is commanded
  };
  struct Equipment {
    QWidget* group;
    QLabel* name;
    QLabel* value;
    ElidedLabel* detail;
  };

  void showAll();
  void showFreshness();
  void showToGo();
  void showFeedSet();
  void showTool();
  void showSpindle();
  /// Of tool and spindle: what it means, where it is from, and how old it is.
  void describe(const Equipment& shown, const QString& text);
  /// Why the distance to go is not known, or where it is from.
  [[nodiscard]] QString toGoHint() const;
  void showValue(QLabel* label, const QString& text, Freshness freshness, const QColor& color);
  /// As large as the width permits.
  struct Fit {
    double digitsPt = 0.0;
    double othersPt = 0.0;  ///< of feed, tool and spindle
    double detailPt = 0.0;
    int gapPx = 0;  ///< on both sides of the line between two readouts
  };
  [[nodiscard]] Fit fitIn(bool inTwoRows) const;
  void fitFonts();
  /// Of the only row, or of the two.
  struct Heights {
    int upperPx = 0;
    int lowerPx = 0;
  };
  [[nodiscard]] Heights heights(bool inTwoRows) const;
  /// @param widths  of the groups, px
  void fixGroups(const std::vector<std::pair<QWidget*, int>>& widths, Heights rows);
  void setRows(bool areTwo);
  [[nodiscard]] bool isShown(std::size_t readout) const;
  /// The longest lines below the values of feed, tool and spindle.
  [[nodiscard]] static int feedSetPx(const QFont& detail);
  [[nodiscard]] int edgePx(const QFont& detail) const;
  [[nodiscard]] int setPx(const QFont& detail) const;

  MachineView m_machine;
  /// X Y Z, then A B C, which are hidden if the machine has none, then the feed.
  static constexpr std::size_t kAxisReadouts = base::kAxisCount + base::kRotaryAxisCount;
  static constexpr std::size_t kFeed = kAxisReadouts;
  std::array<Readout, kAxisReadouts + 1> m_readouts{};
  Equipment m_tool{};
  Equipment m_spindle{};
  StatusLabel* m_freshness;
  QHBoxLayout* m_upper;
  QHBoxLayout* m_lower;  ///< empty while all have room in the upper one
  bool m_isInTwoRows = false;
  bool m_hasWords = true;  ///< there is room for "to go"
};

}  // namespace rivulet::widgets
