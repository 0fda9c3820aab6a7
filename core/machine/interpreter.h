// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Executes an NC program block by block, as the pre-run of the control does: values of
/// R-parameters are latched, and assignments take effect, in the moment of the call.
/// @threadsafety one object, one thread.
#pragma once

#include <memory>
#include <string>
#include <variant>

#include "base/instant.h"
#include "machine/nc_program.h"
#include "machine/prepared.h"
#include "machine/r_parameters.h"

namespace rivulet::machine {

struct InterpreterOptions {
  base::Vec3 startMm;        ///< where the axes stand: end of the "block before the first"
  double rapidMmPerS = 0.0;  ///< path speed of G0
  double roundingMm = 0.0;   ///< deviation at corners that G64 allows
  Dynamics dynamics = Dynamics::Brisk;  ///< until BRISK or SOFT is programmed
  bool cacheUntilStopre = false;        ///< R values from outside are seen only after a STOPRE
};

class Interpreter {
 public:
  /// @param parameters  must outlive the interpreter
  Interpreter(std::shared_ptr<const NcProgram> program, RParameters& parameters,
              const InterpreterOptions& options);

  /// Interprets the next block. After an alarm or the end it must not be called again.
  [[nodiscard]] Prepared next();

  /// To be called when a STOPRE has been waited for: values are read afresh from here on.
  void refresh();

 private:
  /// Reads through the cache where the control is said to read R only after a STOPRE.
  class View final : public RSource {
   public:
    explicit View(const Interpreter& owner) : m_owner(owner) {}
    [[nodiscard]] std::optional<double> value(int index) const override;

   private:
    const Interpreter& m_owner;
  };

  [[nodiscard]] Prepared execute(const Statement& statement);
  [[nodiscard]] Prepared assign(const AssignStatement& statement);
  [[nodiscard]] Prepared move(const MotionStatement& statement, base::LineNumber line);
  [[nodiscard]] Prepared jump(const JumpStatement& statement);
  [[nodiscard]] Prepared branch(const BranchStatement& statement);

  std::shared_ptr<const NcProgram> m_program;
  RParameters& m_parameters;
  std::vector<double> m_cache;  // empty: read live
  std::size_t m_next = 0;
  base::Vec3 m_endMm;
  double m_feedMmPerS = 0.0;
  double m_rapidMmPerS;
  double m_roundingMm;
  Dynamics m_dynamics;
  bool m_rapid = false;  // reset default G1
  bool m_absolute = true;
  bool m_exactStop = true;  // reset default G60
};

}  // namespace rivulet::machine
