// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/methods/position.h"
#include "streaming/methods/signal.h"
#include "streaming/methods/window.h"

namespace rivulet::streaming {

const MethodType& methodType(base::MethodKind method) {
  static const PositionMethodType position;
  static const SignalMethodType signal;
  static const WindowMethodType window;
  static const CreditMethodType credit;
  static const FileMethodType file;
  switch (method) {
    case base::MethodKind::Position:
      return position;
    case base::MethodKind::Signal:
      return signal;
    case base::MethodKind::Credit:
      return credit;
    case base::MethodKind::File:
      return file;
    case base::MethodKind::Window:
      break;
  }
  return window;
}

}  // namespace rivulet::streaming
