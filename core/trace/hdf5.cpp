// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/hdf5.h"

namespace rivulet::trace {

bool isHdf5(std::string_view bytes) {
  constexpr std::string_view kSignature{"\x89HDF\r\n\x1a\n", 8};
  constexpr std::size_t kUserBlockMax = std::size_t{1} << 16U;
  if (bytes.substr(0, kSignature.size()) == kSignature) {
    return true;
  }
  for (std::size_t at = 512; at <= kUserBlockMax && at < bytes.size(); at *= 2) {
    if (bytes.substr(at, kSignature.size()) == kSignature) {
      return true;
    }
  }
  return false;
}

}  // namespace rivulet::trace
