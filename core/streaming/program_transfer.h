// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Brings the flexible program onto the control: written, read back, compared and selected as far
/// as the rights of the OPC UA user go. Nothing here starts it. @threadsafety runs on the calling
/// thread.
#pragma once

#include <string>

#include "base/result.h"
#include "opcua/link.h"

namespace rivulet::streaming {

/// Who brings the program onto the control.
enum class TransferWay {
  Link,    ///< Rivulet, through the methods of the server
  ByHand,  ///< a person, who stores the file, selects it and presses cycle start
};

/// What was done, and what is known of the program on the control. In every case the run goes on
/// only when that program has shown its layout number.
struct ProgramTransfer {
  bool written = false;   ///< by us; else it was there already
  bool compared = false;  ///< read back and found the same
  bool selected = false;  ///< by us; else a person has to

  friend bool operator==(const ProgramTransfer&, const ProgramTransfer&) = default;
};

/// Link: where the control refuses the write or has no method for it, the same program may be there
/// already. ByHand: writes and selects nothing; compares if it may read.
/// @return StreamError::TransferRefused if the program cannot be written, or not read back;
///         WrongProgram if what lies there differs; or what the control says
[[nodiscard]] base::Result<ProgramTransfer> transferProgram(opcua::Control& control,
                                                            const std::string& name,
                                                            const std::string& text,
                                                            TransferWay way);

}  // namespace rivulet::streaming
