// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The CNC in six tasks of [P3]: its Petri net. @threadsafety GUI thread.
#pragma once

#include "widgets/common/page.h"

namespace rivulet::widgets {

class NetPanel;

class ParallelPage final : public Page {
  Q_OBJECT

 public:
  explicit ParallelPage(QWidget* parent = nullptr);

  [[nodiscard]] NetPanel* net() const { return m_net; }

 protected:
  void retranslate() override {}

 private:
  NetPanel* m_net;
};

}  // namespace rivulet::widgets
