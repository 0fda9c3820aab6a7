// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Finds out which forms of access to R-parameters a control understands. A confirmation by the
/// control proves nothing: each form writes its own numbers into cells named by the caller, and
/// these numbers must be there, and in no neighbouring cell, when the cells are read one by one.
/// Afterwards the cells have their old values.
/// @threadsafety runs on the calling thread.
#pragma once

#include "base/result.h"
#include "opcua/link.h"
#include "streaming/control/access_forms.h"

namespace rivulet::streaming {

/// R-parameters that nobody uses meanwhile, both ends included. The first and the last are not
/// written: they must not change when arrays between them are written.
struct ScratchCells {
  static constexpr int kCountMin = 4;
  int first = 0;
  int last = 0;
};

/// A value that was confirmed may be readable only from the next interpolation cycle on: it is read
/// this often before it counts as not written.
inline constexpr int kReadBackTries = 3;

/// Tries every form. The channel must be in reset. Costs about three accesses per cell for single
/// access and two requests for each other form.
/// @return VariableMissing (fewer than four cells, or one does not exist), ChannelBusy,
/// NotWritable,
/// or the error of the link; the message says if the cells could not be restored
[[nodiscard]] base::Result<AccessForms> probeAccess(opcua::Link& link, const ScratchCells& cells,
                                                    base::Duration deadline);

}  // namespace rivulet::streaming
