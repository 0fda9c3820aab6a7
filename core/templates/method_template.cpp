// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "templates/method_template.h"

#include "templates/methods/linuxcnc.h"
#include "templates/methods/loop.h"
#include "templates/methods/untried.h"
#include "templates/methods/window.h"

namespace rivulet::templates {

const MethodTemplate& methodTemplate(const TemplateParameters& parameters) {
  static const PositionTemplate position;
  static const SignalTemplate signal;
  static const WindowTemplate window;
  static const CreditTemplate credit;
  static const FileTemplate file;
  static const LinuxCncWindowTemplate linuxCncWindow;
  static const LinuxCncCreditTemplate linuxCncCredit;
  static const TwinCatWindowTemplate twinCatWindow;
  static const IsgWindowTemplate isgWindow;
  const bool isLinuxCnc = parameters.target == TargetControl::LinuxCnc;
  // Of other methods there is no program for these, see `planCells`.
  if (parameters.target == TargetControl::TwinCat) {
    return twinCatWindow;
  }
  if (parameters.target == TargetControl::Isg) {
    return isgWindow;
  }
  switch (parameters.method) {
    case base::MethodKind::Position:
      return position;
    case base::MethodKind::Signal:
      return signal;
    case base::MethodKind::Credit:
      return isLinuxCnc ? static_cast<const MethodTemplate&>(linuxCncCredit) : credit;
    case base::MethodKind::File:
      return file;
    case base::MethodKind::Window:
      break;
  }
  return isLinuxCnc ? static_cast<const MethodTemplate&>(linuxCncWindow) : window;
}

}  // namespace rivulet::templates
