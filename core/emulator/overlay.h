// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A machine and its emulator as two traces with the same set points, to be drawn together: their
/// positions, how far they are apart, and both paths with the path of the set points, from which
/// errors can be drawn larger. @threadsafety pure.
#pragma once

#include <array>
#include <memory>
#include <string>

#include "base/axes.h"
#include "base/result.h"
#include "emulator/emulator.h"
#include "emulator/training_run.h"
#include "trace/signal_set.h"

namespace rivulet::emulator {

/// What the two are called where they are drawn.
struct OverlayNames {
  std::string machine;
  std::string emulator;
  /// Of the signal "machine minus emulator" of X, Y and Z, in µm.
  std::array<std::string, base::kAxisCount> departure;
};

struct Overlay {
  std::shared_ptr<const trace::ShownTrace> machine;  ///< with the departures
  std::shared_ptr<const trace::ShownTrace> emulated;
};

/// @return as residualsOf
[[nodiscard]] base::Result<Overlay> overlayOf(const Emulator& emulator, const TrainingRun& run,
                                              const OverlayNames& names);

}  // namespace rivulet::emulator
