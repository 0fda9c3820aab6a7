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
  QLineEdit* m_search = lineEdit({.name = QT_TR_NOOP("Search the signals"),
                                  .placeholder = QT_TR_NOOP("Search"),
                                  .id = "signalSearch",
                                  .isTouch = true});
  QTreeWidget* m_tree;
  QPushButton* m_newPane =
      button({.text = QT_TR_NOOP("Pane"),
              .tip = QT_TR_NOOP("Show the signal in a pane of its own (Enter)"),
              .id = "signalNewPane"});
  QPushButton* m_add =
      button({.text = QT_TR_NOOP("Add"),
              .tip = QT_TR_NOOP("Show the signal in the current pane (Shift+Enter)"),
              .id = "signalAdd"});
  QPushButton* m_remove = button({.text = QT_TR_NOOP("Remove"),
                                  .tip = QT_TR_NOOP("Remove the signal from the panes (Delete)"),
                                  .id = "signalRemove"});
  QPushButton* m_columns = button({.text = QT_TR_NOOP("Columns…"),
                                   .tip = QT_TR_NOOP("Say what the columns of the file mean"),
                                   .id = "signalColumns"});
  QMenu* m_tables;
  QLineEdit* m_formula = lineEdit(
      {.tip = QT_TR_NOOP("A formula of signals, then Enter. Their names are in their tool tips."),
       .name = QT_TR_NOOP("Formula"),
       .id = "signalFormula",
       .isTouch = true});
  QLabel* m_formulaNote = label({.id = "signalFormulaNote", .wraps = true});
  base::Error m_formulaError;  ///< what the note says, while it is shown
};

}  // namespace rivulet::widgets
