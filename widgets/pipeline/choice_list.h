// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Lists in which the operator chooses one of a few texts. @threadsafety GUI thread.
#pragma once

#include <QStringList>

class QComboBox;
class QWidget;

namespace rivulet::widgets {

/// A list high enough for a finger, as wide as its texts.
[[nodiscard]] QComboBox* makeChoiceList(const char* name, QWidget* parent);

/// Texts in the present language; what is chosen stays. @param first  chosen at the beginning
void setChoices(QComboBox* list, const QStringList& texts, int first);

}  // namespace rivulet::widgets
