// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Asks how far the tool is to be driven back along the path, and how fast. Nothing moves: the way
/// is shown before. @threadsafety GUI thread.
#pragma once

#include <QDialog>

class QCheckBox;

namespace rivulet::widgets {

class NumberField;

class BackDialog final : public QDialog {
  Q_OBJECT

 public:
  /// @param feedMmPerMin  that is proposed, > 0  @param feedMmPerMinMax  no feed is larger
  BackDialog(double feedMmPerMin, double feedMmPerMinMax, QWidget* parent = nullptr);

 Q_SIGNALS:
  /// @param lengthMm  of the way; 0: to where the last rapid ended
  void chosen(double lengthMm, double feedMmPerMin);

 private:
  QCheckBox* m_toRapid;
  NumberField* m_lengthMm;
  NumberField* m_feedMmPerMin;
};

}  // namespace rivulet::widgets
