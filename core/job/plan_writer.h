// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Goes through a plan and writes it as one NC program: what stands before a native block, so that
/// it runs in the modal state of the source program, and what stands in place of a stretch. Blocks
/// are written in the language of a SINUMERIK. @threadsafety pure.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <iterator>
#include <string>
#include <utility>

#include "job/plan.h"

namespace rivulet::job {

/// The words that put a control into the modal state, "G1 G17 G90 G710 DIAMOF G64 G94 F500".
[[nodiscard]] std::string modalWords(const nc::ModalState& state);

class PlanWriter {
 public:
  /// @param plan  outlives the object
  explicit PlanWriter(const Plan& plan) : m_plan(plan) {}
  virtual ~PlanWriter() = default;
  PlanWriter(const PlanWriter&) = delete;
  PlanWriter& operator=(const PlanWriter&) = delete;

 protected:
  /// What stands in place of a stretch.
  virtual void writeStreamed(const Stretch& stretch) = 0;
  /// Before a native block. @param number  of it, from 1
  virtual void writeDue(const NativeBlock& native, int number) = 0;
  /// What is written of a native block.
  [[nodiscard]] virtual const std::string& textOf(const NativeBlock& native) const {
    return native.text;
  }
  /// Just before the text of a native block.
  virtual void beforeText(const std::string& /*text*/) {}
  /// The text of a native block has just been written.
  virtual void written(const NativeBlock& /*native*/, int /*number*/) {}
  /// Takes blocks of the plan. @param text  one line or several
  virtual void put(const std::string& text) { append(text); }

  /// @param until  the first part that is left out, index in `Plan::parts`
  void writeParts(std::size_t until);
  template <class... Arguments>
  void line(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
    put(fmt::format(text, std::forward<Arguments>(arguments)...));
  }
  /// As it is. @param text  one line or several
  void append(const std::string& text);
  /// Only if there is one: after TRANS an increment counts from the coordinates before it, even if
  /// nothing has changed but the tool.
  void cancelFrame();
  /// The feed of streamed points has the override in it already.
  void cancelOverride();

  [[nodiscard]] const Plan& plan() const { return m_plan; }
  [[nodiscard]] bool isForeign() const { return m_plan.program.dialect != nc::Dialect::Sinumerik; }
  [[nodiscard]] unsigned lineCount() const { return m_lines; }
  [[nodiscard]] std::string take() { return std::move(m_text); }

 private:
  void writeNative(const NativeBlock& native, bool isAfterNative);

  const Plan& m_plan;
  std::string m_text;
  unsigned m_lines = 0;
  int m_natives = 0;
  bool m_hasFrame = false;     ///< the control may have one
  bool m_hasOverride = false;  ///< the same
};

}  // namespace rivulet::job
