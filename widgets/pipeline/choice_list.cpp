// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/pipeline/choice_list.h"

#include <QComboBox>
#include <QSignalBlocker>
#include <algorithm>

#include "widgets/common/theme.h"

namespace rivulet::widgets {

QComboBox* makeChoiceList(const char* name, QWidget* parent) {
  auto* list = new QComboBox(parent);
  list->setObjectName(QLatin1String(name));
  list->setMinimumHeight(kTouchHeightPx);
  list->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  return list;
}

void setChoices(QComboBox* list, const QStringList& texts, int first) {
  const QSignalBlocker blocker(list);
  const int chosen = list->count() == 0 ? first : list->currentIndex();
  list->clear();
  list->addItems(texts);
  list->setCurrentIndex(std::clamp(chosen, 0, static_cast<int>(texts.size()) - 1));
}

}  // namespace rivulet::widgets
