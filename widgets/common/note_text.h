// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Notes of a run, and why its axes stood, in the language of the operator. Core and recordings
/// have them in English.
/// @threadsafety GUI thread.
#pragma once

#include <QString>

namespace rivulet::widgets {

/// @return the note itself if it is none that is known. What a library or a control has said stays
///         in its own words.
[[nodiscard]] QString noteText(const QString& note);

}  // namespace rivulet::widgets
