// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// One trace, whatever it came from. @threadsafety pure.
#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include "base/budget.h"
#include "base/byte_source.h"
#include "base/executor.h"
#include "base/result.h"
#include "trace/control_trace.h"
#include "trace/import/import.h"
#include "trace/recording.h"

namespace rivulet::trace {

/// The recording of a run, the trace of a control, or a file of another tool. A copy shares what it
/// holds, which does not change.
class Trace {
 public:
  /// @param value  `Recording`, `ControlTrace` or `ImportedTrace`
  template <class T>
  explicit Trace(T value) : m_of(std::make_shared<const T>(std::move(value))) {}
  /// @param shared  of one of them, not null
  template <class T>
  explicit Trace(std::shared_ptr<T> shared) : m_of(std::shared_ptr<const T>(std::move(shared))) {}

  /// @return null: it is no recording
  [[nodiscard]] const Recording* recording() const { return get<Recording>(); }
  /// @return null: Rivulet has written it
  [[nodiscard]] const ImportedTrace* imported() const { return get<ImportedTrace>(); }
  /// Its own, or that in its recording. @return null: there is none
  [[nodiscard]] const ControlTrace* control() const;

  /// What happened between two times from the first sample. Blocks are not judged then: those
  /// before and after would be missing. @param fromS <= untilS
  [[nodiscard]] Trace cut(double fromS, double untilS) const;

 private:
  template <class T>
  [[nodiscard]] const T* get() const {
    const auto* held = std::get_if<std::shared_ptr<const T>>(&m_of);
    return held != nullptr ? held->get() : nullptr;
  }

  std::variant<std::shared_ptr<const Recording>, std::shared_ptr<const ControlTrace>,
               std::shared_ptr<const ImportedTrace>>
      m_of;
};

/// Reads a file of any of the three kinds. @param mapping  for tables of other tools
/// @param budget  without the bytes themselves  @param executor  null: one thread
/// @return errors of `parseRecording`, `parseControlTrace` and `importTrace`
[[nodiscard]] base::Result<Trace> parseTrace(std::string_view bytes,
                                             const TableMapping& mapping = {},
                                             const base::Budget& budget = {},
                                             base::Executor* executor = nullptr);

/// A table that is too large to be held while it is read. @return nothing: it is something else,
/// or not so large, and `parseTrace` reads it; errors of the source and of `importTrace`
[[nodiscard]] base::Result<std::optional<Trace>> readLargeTrace(base::ByteSource& bytes,
                                                                const TableMapping& mapping = {},
                                                                const base::Budget& budget = {},
                                                                base::Executor* executor = nullptr);

}  // namespace rivulet::trace
