// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Which rights of an OPC UA user a run needs, which of them this user has, and which are more than
/// needed. Named as on a SINUMERIK (Access MyMachine /OPC UA, GiveUserAccess).
/// @threadsafety as the link.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/instant.h"
#include "opcua/connection.h"
#include "opcua/link.h"

namespace rivulet::opcua {

enum class RunRight { ReadVariables, WriteParameters, ReadPrograms, WritePrograms, SelectProgram };

struct RightFinding {
  RunRight right = RunRight::ReadVariables;
  std::optional<bool> isGiven;  ///< nothing: the server does not tell, and a test would change it
};

struct RightsReport {
  std::vector<RightFinding> findings;  ///< one per `RunRight`, in its order
  std::vector<std::string> excess;     ///< rights that no run needs, as the server names them
  bool isListed = false;               ///< the server has listed the user's rights
  bool isMapped = false;  ///< the control is no SINUMERIK: a map says where it has what
};

/// How long one question of `examineRights` waits for its answer.
inline constexpr base::Duration kRightsDeadline = std::chrono::seconds(5);

/// Asks without changing anything on the control.
/// @param cell  an R-parameter that the control has
/// @return the error of the link if it is lost
[[nodiscard]] base::Result<RightsReport> examineRights(Link& link, Control& control,
                                                       base::Duration deadline = kRightsDeadline,
                                                       const Variable& cell = rParameter(0));

/// The same for a connection, with the map that it was made with.
[[nodiscard]] base::Result<RightsReport> examineRights(const Connection& connection);

/// "read variables"
[[nodiscard]] std::string_view rightTitle(RunRight right);
/// What a run does with it, and what remains to the operator without it.
[[nodiscard]] std::string_view rightPurpose(RunRight right);
/// How it is given. @param isMapped  see `RightsReport`; else by the methods of a SINUMERIK
[[nodiscard]] std::string_view rightRemedy(RunRight right, bool isMapped);
/// Whether no run can do without it.
[[nodiscard]] bool isEssential(RunRight right);

}  // namespace rivulet::opcua
