// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Why the trace of another tool cannot be imported.
#pragma once

#include <system_error>

namespace rivulet::trace {

enum class ImportError {
  NotATable = 1,  ///< no rows of numbers, and no other format that is known
  BadMapping,     ///< a column that is not there, a role that is not known, or no position
  RoleTwice,      ///< two columns are to be the same; its role is the context
  NoHdf5,         ///< HDF5, and this program was built without its library
  AgentRefused,   ///< an MTConnectError, which is no trace
};

[[nodiscard]] std::error_code make_error_code(ImportError code);

}  // namespace rivulet::trace

template <>
struct std::is_error_code_enum<rivulet::trace::ImportError> : std::true_type {};
