// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Finds out in which forms a control lets R-parameters be accessed. What a control claims proves
/// nothing: each form writes numbers of its own into cells the caller has named, and they must
/// stand there and nowhere beside when they are read one by one. Afterwards the cells are as they
/// were.
/// @threadsafety runs on the calling thread.
#pragma once

#include "base/result.h"
#include "opcua/link.h"
#include "streaming/access_forms.h"

namespace rivulet::streaming {

/// R-parameters nobody uses meanwhile, both ends included. The first and the last are not written:
/// they must not change when arrays between them are.
struct ScratchCells {
  static constexpr int kCountMin = 4;
  int first = 0;
  int last = 0;
};

/// Tries every form. The channel must be in reset. Costs about three accesses per cell for single
/// access and two requests for each other form.
/// @return VariableMissing (fewer than four cells, or one does not exist), ChannelBusy,
/// NotWritable,
///         or what the link says; the message tells if the cells could not be put back
[[nodiscard]] base::Result<AccessForms> probeAccess(opcua::Link& link, const ScratchCells& cells,
                                                    base::Duration deadline);

}  // namespace rivulet::streaming
