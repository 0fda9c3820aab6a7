// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Nets for other tools. @threadsafety pure.
#pragma once

#include <string>

#include "petri/net.h"

namespace rivulet::petri {

/// PNML (ISO/IEC 15909-2): places, transitions and arcs. Inscriptions, guards and initial markings
/// are texts in the language of the net; priorities are tool-specific.
[[nodiscard]] std::string pnmlOf(const Net& net);

/// For Graphviz (`dot -Tsvg`): each page a box of its own.
[[nodiscard]] std::string graphvizOf(const Net& net);

}  // namespace rivulet::petri
