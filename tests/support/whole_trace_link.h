// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A link in virtual time that gives the control's trace only as a whole, after the run.
/// @threadsafety one thread.
#pragma once

#include "opcua/forwarding_link.h"

namespace rivulet::tests {

class WholeTraceLink final : public opcua::ForwardingLink {
 public:
  using ForwardingLink::ForwardingLink;
  base::RequestId readTrace(const trace::TracePosition&, base::Duration) override { return {}; }
};

}  // namespace rivulet::tests
