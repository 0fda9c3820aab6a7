// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Transfers the flexible program to the control: written, read back, compared and selected, as far
/// as the rights of the OPC UA user permit. Nothing here starts it. @threadsafety runs on the
/// calling thread.
#pragma once

#include <string>

#include "base/result.h"
#include "opcua/link.h"

namespace rivulet::streaming {

/// Who transfers the program to the control.
enum class TransferWay {
  Link,    ///< Rivulet, through the methods of the server
  ByHand,  ///< the operator, who stores the file, selects it and presses cycle start
};

/// What was done, and what is known of the program on the control. In every case the run continues
/// only after that program has shown its layout number.
struct ProgramTransfer {
  bool written = false;   ///< by us; else it was there already
  bool compared = false;  ///< read back and identical
  bool selected = false;  ///< by us; else the operator has to

  friend bool operator==(const ProgramTransfer&, const ProgramTransfer&) = default;
};

/// Link: if the control refuses the write or has no method for it, the same program may already be
/// there. ByHand: writes and selects nothing; compares if it may read.
/// @return StreamError::TransferRefused if the program cannot be written, or not read back;
/// WrongProgram if the program there differs; or the error of the control
[[nodiscard]] base::Result<ProgramTransfer> transferProgram(opcua::Control& control,
                                                            const std::string& name,
                                                            const std::string& text,
                                                            TransferWay way);
/// The same without selecting it: for a subprogram.
[[nodiscard]] base::Result<ProgramTransfer> storeProgram(opcua::Control& control,
                                                         const std::string& name,
                                                         const std::string& text, TransferWay way);

}  // namespace rivulet::streaming
