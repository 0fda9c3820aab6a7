// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// In place of hdf5_file.cpp where the library is not there.
#include "trace/hdf5.h"
#include "trace/import/import_error.h"

namespace rivulet::trace {

namespace {

tl::unexpected<base::Error> notBuiltIn() {
  return base::fail(ImportError::NoHdf5,
                    "This Rivulet was built without HDF5. Use CSV, or build it with libhdf5-dev.");
}

}  // namespace

bool hasHdf5() {
  return false;
}

base::Result<Hdf5Content> readHdf5(std::string_view, const base::Budget&) {
  return notBuiltIn();
}

base::Result<std::string> printHdf5(const std::vector<ExportedSignal>&,
                                    const std::vector<SignalEvent>&, base::Instant, base::Instant,
                                    std::string_view, std::string_view) {
  return notBuiltIn();
}

}  // namespace rivulet::trace
