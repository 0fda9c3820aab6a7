// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/methods/position.h"
#include "streaming/methods/signal.h"

namespace rivulet::streaming {

std::unique_ptr<Method> makeMethod(MethodSetup setup) {
  if (setup.settings.parameters.method == base::MethodKind::Position) {
    return std::make_unique<PositionMethod>(std::move(setup));
  }
  return std::make_unique<SignalMethod>(std::move(setup));
}

}  // namespace rivulet::streaming
