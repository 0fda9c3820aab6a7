// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The operator's settings for a run. @threadsafety plain values.
#pragma once

#include "templates/cells.h"

namespace rivulet::widgets {

/// How R-parameters are to be written and read.
enum class AccessOrder : unsigned char {
  Automatic,  ///< method window: the best form that is proved before the start; otherwise lists
  Array,      ///< the best array form that is proved, or no start
  List,
  Single,
};

struct StreamSettings {
  templates::TemplateParameters parameters;  ///< method, N, layout, axes
  double deltaMm = 0.3;                      ///< δ, > 0; used by method position
  double feedMmPerS = 500.0 / 60.0;          ///< > 0
  AccessOrder access = AccessOrder::Automatic;
  bool transferByHand = false;  ///< a person copies the template to the control; not stored
};

}  // namespace rivulet::widgets
