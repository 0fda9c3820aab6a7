// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/methods/position.h"
#include "streaming/methods/signal.h"
#include "streaming/methods/window.h"

namespace rivulet::streaming {

std::unique_ptr<Method> makeMethod(MethodSetup setup) {
  switch (setup.settings.parameters.method) {
    case base::MethodKind::Position:
      return std::make_unique<PositionMethod>(std::move(setup));
    case base::MethodKind::Signal:
      return std::make_unique<SignalMethod>(std::move(setup));
    case base::MethodKind::Window:
    case base::MethodKind::Credit:
    case base::MethodKind::File:
      break;
  }
  return std::make_unique<WindowMethod>(std::move(setup));
}

}  // namespace rivulet::streaming
