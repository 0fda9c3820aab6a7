// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "templates/method_template.h"

#include "templates/methods/loop.h"
#include "templates/methods/window.h"

namespace rivulet::templates {

const MethodTemplate& methodTemplate(base::MethodKind method) {
  static const PositionTemplate position;
  static const SignalTemplate signal;
  static const WindowTemplate window;
  static const CreditTemplate credit;
  static const FileTemplate file;
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

}  // namespace rivulet::templates
