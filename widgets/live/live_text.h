// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What was agreed with a live source, and how it went, in the operator's language.
/// @threadsafety GUI thread.
#pragma once

#include <QString>

#include "live/feed_factor.h"
#include "live/setup.h"
#include "live/summary.h"

namespace rivulet::widgets {

/// "-10.000 to 10.000 mm". @param axis  0 to 2
[[nodiscard]] QString boxText(const live::Agreement& agreed, std::size_t axis);
/// "hold after 5 s, end after 60 s".
[[nodiscard]] QString silenceText(const live::Limits& limits);
/// "median 471 ms, 99 % 544 ms; in theory 73 to 585 ms".
[[nodiscard]] QString delayText(const live::Summary& summary);
/// "10,000 of tcp:4001, executed to line 9,998; 12 points merged".
[[nodiscard]] QString linesText(const live::Summary& summary);
/// "73 to 585 ms"; empty: not known.
[[nodiscard]] QString theoryText(base::Duration least, base::Duration most);

/// What becomes of a source of factors: a sentence without its full stop.
[[nodiscard]] QString feedSourceText(const live::FactorSeen& seen);

}  // namespace rivulet::widgets
