// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The variables of the main run: read by synchronized actions in every interpolation cycle, and by
/// the pre-run after an implicit preprocessing stop. @threadsafety one object, one thread.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "nc/eval/evaluate.h"

namespace rivulet::machine {

/// Variables of the main run; names as on the control.
enum class SystemVariable {
  AaIm,          ///< $AA_IM[axis]: set point with overlays, mm
  AaIw,          ///< $AA_IW[axis]: set point without overlays, mm
  AaDtew,        ///< $AA_DTEW[axis]: distance to the block's end, mm
  AaOff,         ///< $AA_OFF[axis]: overlay, mm; writable
  AcDtew,        ///< $AC_DTEW: path length to the block's end, mm
  AcPathn,       ///< $AC_PATHN: share of the block passed, 0 to 1
  AcOvr,         ///< $AC_OVR: path override, %; writable, holds for one cycle
  AcTimer,       ///< $AC_TIMER[n]: s, counts up unless negative; writable
  AcMarker,      ///< $AC_MARKER[n]; writable
  AcParam,       ///< $AC_PARAM[n]; writable
  AaOffVal,      ///< $AA_OFF_VAL[axis]: present overlay of the axis, mm
  MaAaOffMode,   ///< $MA_AA_OFF_MODE[axis]: MD36750, bits
  SaAaOffLimit,  ///< $SA_AA_OFF_LIMIT[axis]: SD43350, largest overlay, mm
  AcIpoBuf,      ///< $AC_IPO_BUF: blocks not finished; the program may read it without a stop
};

/// Numbers of timers, markers and parameters.
inline constexpr int kSystemElements = 32;

class MainRun {
 public:
  virtual ~MainRun() = default;
  /// @param index axis (0 to 2) or element; 0 if there is none
  /// @return nothing for an index that does not exist
  [[nodiscard]] virtual std::optional<double> systemValue(SystemVariable variable,
                                                          int index) const = 0;
  /// @return false if the variable cannot be written or the index does not exist
  virtual bool setSystemValue(SystemVariable variable, int index, double value) = 0;
  [[nodiscard]] virtual std::optional<double> rValue(int index) const = 0;
  virtual bool setRValue(int index, double value) = 0;
};

/// The variable of the main run with this name ("$AC_OVR"); nothing if there is none.
[[nodiscard]] std::optional<SystemVariable> systemVariableOf(std::string_view name);

/// Axis (X, Y, Z as a text) or element; 0 where the variable has none. @return fault IndexMissing
[[nodiscard]] nc::Expected<int> systemIndex(std::string_view name,
                                            std::span<const nc::Value> indices);

/// The value of "$AA_IM" with index "X". @return fault OnlyOnControl, IndexMissing,
/// IndexOutsideArray
[[nodiscard]] nc::Expected<nc::Value> systemValue(const MainRun& mainRun, std::string_view name,
                                                  std::span<const nc::Value> indices);

}  // namespace rivulet::machine
