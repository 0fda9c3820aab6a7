// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What will happen if Start is held now: one line for each thing an operator checks before a run,
/// with its state and, where something is in the way, a button that leads to the remedy. What is
/// not right or unusual comes first; what has passed is counted, and listed on demand.
/// @threadsafety GUI thread.
#pragma once

#include <QPointer>
#include <memory>
#include <vector>

#include "base/vec3.h"
#include "overview/program_view.h"
#include "widgets/common/page.h"
#include "widgets/common/status_label.h"

class QGridLayout;
class QLabel;
class QPushButton;

namespace rivulet::widgets {

struct PreflightItem {
  Status status = Status::Plain;
  QString name;
  QString text;    ///< one sentence
  QString remedy;  ///< text of the button; empty: none
  int remedyId = 0;
  bool isKept = false;  ///< to be seen also where nothing is wrong with it

  friend bool operator==(const PreflightItem&, const PreflightItem&) = default;
};

/// Where the tool goes first, for a picture.
struct FirstMove {
  std::shared_ptr<const overview::ProgramView> program;  ///< null: no picture
  /// From where the tool stands to the path, mm, in the frame of its points. One place: where it
  /// goes from there is not known here. Empty: neither is where it stands.
  std::vector<base::Vec3> wayMm;

  friend bool operator==(const FirstMove&, const FirstMove&) = default;
};

class PathCanvas;

class PreflightSheet final : public Page {
  Q_OBJECT

 public:
  /// What is confirmed elsewhere: by Start, or by the bar with the place of a run that was left.
  /// `StartHere`: at a line that the operator has chosen. `Raise`: of the tool, and `Back`: along
  /// the path, by Start.
  enum class Kind { Start, StartHere, Resume, Raise, Back };

  explicit PreflightSheet(QWidget* parent = nullptr);

  /// @param passed  nothing stands in the way
  void setItems(const std::vector<PreflightItem>& items, bool passed, Kind kind = Kind::Start);
  /// Beside the items, where the sheet is wide enough.
  void setFirstMove(const FirstMove& move);
  [[nodiscard]] const FirstMove& firstMove() const { return m_firstMove; }
  [[nodiscard]] PathCanvas* picture() const { return m_picture; }

 Q_SIGNALS:
  void remedyRequested(int remedyId);
  void closeRequested();

 protected:
  void retranslate() override;
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void showItems();
  void showPicture();
  void placePicture();
  /// @param row  in the grid
  void addItem(const PreflightItem& item, int row);
  void addPassed(const std::vector<PreflightItem>& passed, int row);
  void fold();

  std::vector<PreflightItem> m_items;
  bool m_passed = false;
  Kind m_kind = Kind::Start;
  bool m_isUnfolded = false;
  QPointer<QPushButton> m_foldButton;
  QLabel* m_title = heading({});
  StatusLabel* m_outcome = status({.wraps = true});
  QWidget* m_list = nullptr;
  QGridLayout* m_rows;
  FirstMove m_firstMove;
  PathCanvas* m_picture;
  QPushButton* m_close =
      button({.text = QT_TR_NOOP("Not now"), .icon = "dismiss"}, &PreflightSheet::closeRequested);
};

}  // namespace rivulet::widgets
