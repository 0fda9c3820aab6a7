// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The CNC in six tasks of [P3]: the tasks at work, and their Petri net. @threadsafety GUI thread.
#pragma once

#include "widgets/common/page.h"

namespace rivulet::widgets {

class FoldingTabs;
class NetPanel;
class TaskPanel;

class ParallelPage final : public Page {
  Q_OBJECT

 public:
  explicit ParallelPage(QWidget* parent = nullptr);

  [[nodiscard]] NetPanel* net() const { return m_net; }
  [[nodiscard]] TaskPanel* tasks() const { return m_tasks; }

 protected:
  void retranslate() override;

 private:
  FoldingTabs* m_tabs;
  NetPanel* m_net;
  TaskPanel* m_tasks;
};

}  // namespace rivulet::widgets
