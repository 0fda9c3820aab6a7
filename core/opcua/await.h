// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// One request at a time, for use outside a stream: send, then wait for the answer, whatever else
/// arrives meanwhile. @threadsafety runs on the calling thread.
#pragma once

#include <span>
#include <vector>

#include "opcua/link.h"

namespace rivulet::opcua {

/// Waits for the answer to a request that has been sent.
/// @return the error of the request or of the link; DeadlineExceeded after twice the deadline
[[nodiscard]] base::Result<Event> awaitAnswer(Link& link, base::RequestId id,
                                              base::Duration deadline);

/// Reads some variables. Each reading has its own status.
[[nodiscard]] base::Result<std::vector<Reading>> readNow(Link& link,
                                                         std::span<const Variable> variables,
                                                         base::Duration deadline);

/// The same for variables that are numbers; one that cannot be read is an error.
[[nodiscard]] base::Result<std::vector<double>> readNumbers(Link& link,
                                                            std::span<const Variable> variables,
                                                            base::Duration deadline);

/// Writes some cells; one that cannot be written is an error.
[[nodiscard]] base::Result<void> writeNow(Link& link, std::span<const Assignment> assignments,
                                          base::Duration deadline);

/// Waits without asking anything. @return the error of the link if it is lost
[[nodiscard]] base::Result<void> sleepUntil(Link& link, base::Instant until);

}  // namespace rivulet::opcua
