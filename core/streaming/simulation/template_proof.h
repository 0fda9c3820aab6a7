// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Proves a flexible program: the production client drives it on a virtual machine in virtual time,
/// on time and late, over a bad network, until it is stopped or the client is gone. The motion is
/// judged by the machine's own trace. @threadsafety pure; runs on the calling thread.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "machine/config.h"
#include "templates/lint/lint.h"

namespace rivulet::streaming {

/// One situation, in a number of runs.
struct ProofCase {
  std::string name;        ///< "on-time", "late-client", ...
  bool isRequired = true;  ///< false: not guaranteed by the method, for information
  std::size_t runs = 0;
  std::size_t failures = 0;
  std::string message;  ///< the first failure: expected and actual behaviour

  [[nodiscard]] bool holds() const { return failures == 0; }
};

struct TemplateProof {
  std::vector<templates::LintFinding> findings;
  std::vector<ProofCase> cases;  ///< none if a finding is an error: such a program is not run

  /// No finding is an error, and every required case has passed.
  [[nodiscard]] bool holds() const;
};

/// @param text     the program
/// @param meant    the program for which the client takes it
/// @param machine  whose number of R-parameters is set to that of `meant`; rotary axes it lacks are
///                 added
/// @return NotOnTarget
[[nodiscard]] base::Result<TemplateProof> proveTemplate(std::string_view text,
                                                        const templates::FlexibleProgram& meant,
                                                        const machine::MachineConfig& machine);

/// A program for a real control first runs on the virtual one: it is proved on the machine of the
/// paper.
/// @return nothing if it passes; else LintError::Rejected, or the errors of `proveTemplate`
[[nodiscard]] base::Result<void> requireProven(const templates::FlexibleProgram& program);

}  // namespace rivulet::streaming
