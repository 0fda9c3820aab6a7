// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What can be shown: a tree of signals with a search, and a line for formulas. Enter or a double
/// click shows a signal in a pane of its own, dragging in the pane where it is let go.
/// @threadsafety GUI thread.
#pragma once

#include <functional>
#include <vector>

#include "base/result.h"
#include "trace/signal_set.h"
#include "widgets/common/page.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QMenu;
class QTreeWidget;
class QTreeWidgetItem;

namespace rivulet::widgets {

class SignalPanel final : public Page {
  Q_OBJECT

 public:
  /// @param isShown  tells whether a pane shows a formula
  explicit SignalPanel(std::function<bool(const QString&)> isShown, QWidget* parent = nullptr);

  void setOffers(std::vector<trace::SignalOffer> offers);
  /// The files are tables: what their columns mean can be said. @param names  empty: none is one
  void setTables(const QStringList& names);
  /// Marks anew what is shown.
  void refresh();
  /// Says what is wrong with a formula.
  void showFormulaError(const base::Error& error);

 Q_SIGNALS:
  void paneRequested(const QString& formula);
  void addRequested(const QString& formula);
  void removeRequested(const QString& formula);
  /// Of one of the tables.
  void columnsRequested(int table);

 protected:
  void retranslate() override;
  void restyle() override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void fill();
  void filter();
  [[nodiscard]] QString currentFormula() const;
  void activate(bool inOwnPane);
  void addFormula();
  void showButtons();

  std::function<bool(const QString&)> m_isShown;
  std::vector<trace::SignalOffer> m_offers;
  QLineEdit* m_search;
  QTreeWidget* m_tree;
  QPushButton* m_newPane;
  QPushButton* m_add;
  QPushButton* m_remove;
  QPushButton* m_columns;
  QMenu* m_tables;
  QLineEdit* m_formula;
  QLabel* m_formulaNote;
};

}  // namespace rivulet::widgets
