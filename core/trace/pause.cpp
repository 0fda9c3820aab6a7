// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/pause.h"

namespace rivulet::trace {

std::string_view pauseOriginName(PauseOrigin origin) {
  switch (origin) {
    case PauseOrigin::Measured:
      return "measured";
    case PauseOrigin::Inferred:
      return "inferred";
    case PauseOrigin::Predicted:
      return "predicted";
  }
  return "measured";
}

}  // namespace rivulet::trace
