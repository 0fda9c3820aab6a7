// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Adaptive feed: which source multiplies the override of a run, within which bounds, and what acts
/// without a factor. All of it is agreed before the start. During a run, what becomes of the
/// source.
/// @threadsafety GUI thread.
#pragma once

#include <optional>

#include "streaming/run/feed_order.h"
#include "widgets/common/page.h"

namespace rivulet::widgets {

/// A source and the bounds of its factors.
struct FactorChoice {
  live::FactorSource source;
  double least = 0.0;  ///< both 0 without a source
  double most = 0.0;

  friend bool operator==(const FactorChoice&, const FactorChoice&) = default;
};

class FactorPanel final : public Page {
  Q_OBJECT

 public:
  explicit FactorPanel(QWidget* parent = nullptr);

  /// Shows what is chosen; does not signal.
  void setChoice(const FactorChoice& choice);
  /// During a run nothing can be changed.
  void setEditable(bool editable);
  /// Of the run in progress; nothing: there is none, or its program has no feed cell.
  void setFeed(const std::optional<streaming::FeedSeen>& feed);

 Q_SIGNALS:
  void choiceChanged(const rivulet::widgets::FactorChoice& choice);

 private:
  void takeChoice();
  void showAll();
  void showStatus();

  FactorChoice m_choice;
  std::optional<live::FactorSeen> m_seen;
  bool m_editable = true;
  bool m_isShowing = false;  ///< fields are being filled, not edited

  QGroupBox* m_group = group({.text = QT_TR_NOOP("Adaptive feed")});
  QComboBox* m_source =
      list({.tip = QT_TR_NOOP("A sensor or script that sends lines such as feed 0.85: 85 % of your "
                              "override, until the next one. Pause and Stop always act."),
            .items = {QT_TR_NOOP("None"), QT_TR_NOOP("TCP on this computer"),
                      QT_TR_NOOP("UDP on this computer")},
            .id = "factor-source"});
  WholeNumberField* m_port;
  NumberField* m_least;
  NumberField* m_most;
  NumberField* m_silence;
  QComboBox* m_without =
      list({.items = {QT_TR_NOOP("Hold the axes"), QT_TR_NOOP("Your override alone")},
            .id = "factor-without"});
  Form* m_form;
  StatusLabel* m_status = status({.id = "factor-status", .wraps = true});
};

}  // namespace rivulet::widgets
