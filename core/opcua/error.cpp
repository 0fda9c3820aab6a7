// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/error.h"

#include "base/error.h"

namespace rivulet::opcua {

std::error_code make_error_code(LinkError code) {
  static const base::NamedCategory category("opcua");
  return {static_cast<int>(code), category};
}

bool mayBeFalsified(const std::error_code& code) {
  return code == LinkError::Rejected || code == LinkError::BadValue ||
         code == LinkError::VariableMissing || code == LinkError::NotWritable ||
         code == LinkError::MethodMissing || code == LinkError::ProgramMissing ||
         code == LinkError::TooManyItems;
}

std::string_view remedyForItem(const std::error_code& status) {
  if (status == LinkError::NotWritable) {
    return "Give this OPC UA user access to it on the control.";
  }
  if (status == LinkError::VariableMissing) {
    return "Check the server, and the number of R-parameters on the control (MD28050).";
  }
  if (status == LinkError::BadValue) {
    return "The answer was damaged on its way, or is not a number. Check network and server, then "
           "resume.";
  }
  return "The control rejected it. Check its messages.";
}

}  // namespace rivulet::opcua
