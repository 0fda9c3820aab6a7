// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Why something cannot be started, in the language of the operator. @threadsafety GUI thread.
#pragma once

#include <QString>

#include "streaming/start/start_policy.h"

namespace rivulet::widgets {

/// One sentence; empty if nothing stands in the way.
[[nodiscard]] QString blockedText(const std::optional<streaming::Blocked>& blocked);

}  // namespace rivulet::widgets
