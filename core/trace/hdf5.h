// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// HDF5 files in memory: rows of numbers out of any of them, and signals into one whose structure
/// is in docs/traces.md. Nothing outside the bytes is read or written, whatever the file refers to.
/// @threadsafety any thread; calls wait for each other.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/budget.h"
#include "base/instant.h"
#include "base/result.h"
#include "trace/export.h"
#include "trace/packed_points.h"
#include "trace/remark.h"
#include "trace/signals.h"

namespace rivulet::trace {

/// By its first bytes, also if a block of another program precedes it (MATLAB).
[[nodiscard]] bool isHdf5(std::string_view bytes);

/// False: this program was built without the library. The functions below fail with
/// ImportError::NoHdf5 then.
[[nodiscard]] bool hasHdf5();

/// One row of numbers of a file.
struct Hdf5Row {
  std::string folder;     ///< "axes/x"; empty: the root
  std::string name;       ///< its attribute `name`, or else that of the dataset
  std::string unit;       ///< its attribute `unit` or `units`; empty: it has none
  std::size_t count = 0;  ///< of values that the file declares
  PackedValues values;    ///< shorter, if the file was cut off; NaN: cannot be read

  [[nodiscard]] std::string path() const { return folder.empty() ? name : folder + "/" + name; }
};

struct Hdf5Content {
  std::vector<Hdf5Row>
      rows;  ///< folder by folder, in the order in which they were made, or by name
  std::vector<SignalEvent> events;  ///< of files that `printHdf5` made
  std::vector<Remark> remarks;
};

/// All datasets of one dimension (others of which are 1) that hold numbers.
/// @param budget  without the bytes; of the rows and their analysis
/// @return error ImportError::NotATable: damaged, or there are none; BudgetError::Exceeded
[[nodiscard]] base::Result<Hdf5Content> readHdf5(std::string_view bytes,
                                                 const base::Budget& budget = {});

/// The samples between two instants, both included, without loss; compressed, with checksums.
/// @param events  those that begin or end between them are written
/// @param timeName, timeUnit  as `printSignals`
[[nodiscard]] base::Result<std::string> printHdf5(const std::vector<ExportedSignal>& exported,
                                                  const std::vector<SignalEvent>& events,
                                                  base::Instant from, base::Instant to,
                                                  std::string_view timeName,
                                                  std::string_view timeUnit);

}  // namespace rivulet::trace
