// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A trace of what an OPC UA server has recorded of some variables. @threadsafety one thread.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/budget.h"
#include "base/result.h"
#include "base/utc.h"
#include "opcua/node_history.h"
#include "trace/signals.h"

namespace rivulet::trace_fetch {

/// A variable of the server and what its signal is called: "x_act=ns=2;s=Axis.X".
struct HistoryNode {
  std::string name;
  std::string address;
};
/// @return error BadAddress
[[nodiscard]] base::Result<HistoryNode> parseHistoryNode(std::string_view text);

struct HistoryRequest {
  std::vector<HistoryNode> nodes;
  base::UtcMs from = 0;
  base::UtcMs until = 0;  ///< > `from`
};

[[nodiscard]] bool isOpcUaAddress(std::string_view text);

/// Each node becomes a signal with its own times; where its status was bad there is no value.
/// @param budget  of the signals and their analysis
/// @return errors of `opcua::NodeHistory`; WrongAnswer: nothing was recorded in that time
[[nodiscard]] base::Result<trace::SignalTrace> fetchHistory(opcua::NodeHistory& server,
                                                            const HistoryRequest& request,
                                                            const base::Budget& budget);

}  // namespace rivulet::trace_fetch
