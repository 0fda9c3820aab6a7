// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Everything that makes a machine ready for streaming, in the order in which it is done; each step
/// is a page of its own, and its name says whether it is done. @threadsafety GUI thread.
#pragma once

#include <functional>
#include <vector>

#include "widgets/common/page.h"
#include "widgets/common/status_label.h"

class QTabWidget;

namespace rivulet::widgets {

class FoldingTabs;

class SetUpPage final : public Page {
  Q_OBJECT

 public:
  explicit SetUpPage(QWidget* parent = nullptr);

  /// @param title  in the present language, asked again when it changes
  void addStep(QWidget* step, std::function<QString()> title);
  /// @param status  Good: done; Attention: does not hold any more; Unknown: not done
  void setStatus(const QWidget* step, Status status);
  [[nodiscard]] QTabWidget* steps() const;

 protected:
  void retranslate() override;
  void restyle() override;

 private:
  struct Step {
    const QWidget* page;
    std::function<QString()> title;
    Status status = Status::Plain;
  };
  FoldingTabs* m_steps;
  std::vector<Step> m_list;
};

}  // namespace rivulet::widgets
