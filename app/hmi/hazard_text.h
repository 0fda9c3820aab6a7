// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What a machine cannot do of a whole job, in the language of the window.
/// @threadsafety GUI thread.
#pragma once

#include <QString>

#include "session/hazards.h"

namespace rivulet::hmi {

/// One sentence: what, where and by how much, and what to do.
[[nodiscard]] QString hazardText(const forecast::Hazard& hazard);
/// Those that keep the job from starting, or those that do not; a line for each.
/// @return empty: there are none
[[nodiscard]] QString hazardsText(const session::Hazards& hazards, bool stop);

}  // namespace rivulet::hmi
