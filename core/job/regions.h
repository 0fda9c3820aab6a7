// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Regions of a program that are native from one block to another. @threadsafety plain values.
#pragma once

#include <optional>
#include <string_view>

#include "job/native_reason.h"
#include "nc/exec/block_words.h"
#include "nc/modal/state.h"

namespace rivulet::job {

class Regions {
 public:
  /// Of the region in progress; nothing: there is none.
  [[nodiscard]] std::optional<NativeReason> reason() const;

  /// A word of the block, upper case: "TRAORI", "G41". @param isEmptyCall  CYCLE800()
  void word(std::string_view name, bool isEmptyCall);
  void compensationOff();  ///< G40
  void curve() { m_curve = true; }
  void modalCall(bool isOn) { m_modalCall = isOn; }
  /// The words of the block have taken effect.
  void blockExecuted(const nc::BlockWords& words, const nc::ModalState& state);

 private:
  enum class Compensation : unsigned char { Off, On, Leaving };
  bool m_transforms = false;
  bool m_modalCall = false;
  bool m_curve = false;
  int m_cornerMotions = 0;  ///< still to come, that a rounding takes
  Compensation m_compensation = Compensation::Off;
};

}  // namespace rivulet::job
