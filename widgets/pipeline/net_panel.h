// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Plays the Petri net of a parallel CNC: a page of the net with its tokens, what each place of it
/// holds, and the levels of the buffers over the net's time. @threadsafety GUI thread.
#pragma once

#include "petri/net.h"
#include "widgets/common/page.h"
#include "widgets/common/table_model.h"
#include "widgets/pipeline/net_state.h"

class QCheckBox;
class QComboBox;
class QTableView;

namespace rivulet::widgets {

class CurveChart;
class ElidedLabel;
class NetCanvas;
class StatusLabel;

class NetPanel final : public Page {
  Q_OBJECT

 public:
  explicit NetPanel(QWidget* parent = nullptr);
  ~NetPanel() override;

  void setState(NetState state);
  [[nodiscard]] NetCanvas* canvas() const { return m_canvas; }

 Q_SIGNALS:
  /// Another cycle or policy: the net begins anew.
  void choiceChanged(const rivulet::widgets::NetChoice& choice);
  void stepRequested();
  void playRequested(bool plays);
  void restartRequested();
  void speedChosen(double firingsPerS);

 protected:
  void retranslate() override;

 private:
  /// A row of the table of places.
  struct PlaceRow {
    std::size_t node = 0;
    QString name;
    QString count;
    QString value;
  };

  void connectParts();
  void fillLists();
  void listPages();
  void showPage(int page);
  void showState();
  void showPlaces();
  void showSelection();
  void emitChoice();

  NetState m_state;
  const petri::Net* m_listed{nullptr};  ///< whose pages are listed; for comparison only

  QComboBox* m_cycle;
  QComboBox* m_policy;
  QComboBox* m_pages;
  QCheckBox* m_follow =
      checkBox({.text = QT_TR_NOOP("Follow"),
                .tip = QT_TR_NOOP("Show the page on which the next transition fires"),
                .id = "netFollow",
                .isTouch = true});
  QPushButton* m_step = button(
      {.text = QT_TR_NOOP("Step"), .tip = QT_TR_NOOP("Fire one transition"), .id = "netStep"},
      &NetPanel::stepRequested);
  QPushButton* m_play = button({.text = QT_TR_NOOP("Play"),
                                .tip = QT_TR_NOOP("Fire one transition after another"),
                                .id = "netPlay"});
  QPushButton* m_restart = button({.text = QT_TR_NOOP("Back to start"),
                                   .tip = QT_TR_NOOP("The tokens as they were at the beginning"),
                                   .id = "netRestart"},
                                  &NetPanel::restartRequested);
  QComboBox* m_speed;
  StatusLabel* m_note;
  NetCanvas* m_canvas;
  CurveChart* m_levels;
  QTableView* m_table;
  TableModel<PlaceRow>* m_places;
  ElidedLabel* m_detail;
};

}  // namespace rivulet::widgets
