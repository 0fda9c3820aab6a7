// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Which rights a run needs on the control, which of them this user has, and what to do about those
/// that are missing. @threadsafety GUI thread.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "opcua/rights.h"
#include "widgets/common/page.h"

class QGridLayout;
class QLabel;
class QPushButton;

namespace rivulet::widgets {

class StatusLabel;

/// A sentence of `opcua::rightTitle` and its like, in the present language.
[[nodiscard]] QString rightText(std::string_view sentence);

class RightsPage final : public Page {
  Q_OBJECT

 public:
  explicit RightsPage(QWidget* parent = nullptr);

  /// @param report  nothing: not asked yet @param error  why it could not be asked
  void setReport(const std::optional<opcua::RightsReport>& report, const base::Error& error = {});
  /// @param reason  why it cannot be asked now; empty: it can
  void setBlocked(const QString& reason);

 Q_SIGNALS:
  void examineRequested();

 private:
  void showReport();
  void addRow(const opcua::RightFinding& finding);

  std::optional<opcua::RightsReport> m_report;
  base::Error m_error;
  QString m_blocked;
  bool m_isAsking = false;
  QPushButton* m_examine =
      button({.text = QT_TR_NOOP("Check the rights"), .icon = "user", .id = "rights-examine"});
  StatusLabel* m_outcome = status({.id = "rights-outcome", .wraps = true});
  QGridLayout* m_rows;
  int m_nextRow = 0;
  std::vector<QWidget*> m_shown;
  QLabel* m_excess = value({.isMuted = true, .wraps = true});
};

}  // namespace rivulet::widgets
