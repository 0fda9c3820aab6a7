// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// An emulator in the words of somebody who runs a machine. @threadsafety GUI thread.
#pragma once

#include <QString>

#include "emulator/axis_model.h"
#include "widgets/common/status_label.h"
#include "widgets/emulator/emulator_view.h"

namespace rivulet::widgets {

/// "Position gain".
[[nodiscard]] QString parameterName(emulator::AxisParameter parameter);
/// One sentence, without terms of control engineering.
[[nodiscard]] QString parameterMeaning(emulator::AxisParameter parameter);
/// Unit as it is written on a screen, where times are in ms.
[[nodiscard]] QString parameterUnit(emulator::AxisParameter parameter);
/// A value in this unit, without it. @param value  in the unit of the model
[[nodiscard]] QString parameterText(emulator::AxisParameter parameter, double value);

/// A number with as many digits as say something. @param digits  significant ones, > 0
[[nodiscard]] QString significantText(double value, int digits);
/// "0.523 µm", "1.25 mm".
[[nodiscard]] QString errorLengthText(double mm);

/// The transfer function from set point to actual position with its numbers, as
/// emulator::responseAt computes it: "G(s) = …", with "W(s) = …" where there is a speed loop. s in
/// 1/s. Lines are separated by line feeds.
[[nodiscard]] QString transferFunctionText(const emulator::AxisParameters& parameters);

/// What an emulator is good for, and what not; Attention if what it was tested on speaks against
/// it, or is too little.
struct EmulatorRemark {
  Status status = Status::Good;
  QString text;
};
[[nodiscard]] EmulatorRemark emulatorRemark(const EmulatorView& view);

}  // namespace rivulet::widgets
