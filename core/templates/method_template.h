// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The part of a streaming method that runs on the control: its cells and its program. One class
/// per method, in `methods/`; `methodTemplate` registers them. Other code uses `makeProgram`.
/// @threadsafety pure.
#pragma once

#include <memory>
#include <string>

#include "templates/cells.h"

namespace rivulet::templates {

class MethodTemplate {
 public:
  MethodTemplate() = default;
  MethodTemplate(const MethodTemplate&) = delete;
  MethodTemplate& operator=(const MethodTemplate&) = delete;
  virtual ~MethodTemplate() = default;

  /// Smallest N.
  [[nodiscard]] virtual int pointsMin() const { return 1; }

  /// Checks only the settings of this method; axes and N have been checked.
  [[nodiscard]] virtual base::Result<void> check(const TemplateParameters& parameters) const = 0;

  /// Plans all cells, whether they fit the control or not. @param parameters  have been checked
  [[nodiscard]] virtual CellMap cells(const TemplateParameters& parameters) const = 0;

  /// Largest N that fits the R-parameters of the control; 0 if none does. At least one axis.
  [[nodiscard]] virtual int pointsMax(const TemplateParameters& parameters) const = 0;

  /// The program. @param layoutNumber  the number that it writes into its layout cell
  [[nodiscard]] virtual std::string program(const TemplateParameters& parameters,
                                            const CellMap& cells, int layoutNumber) const = 0;

  /// Letters that distinguish variants in the file name.
  [[nodiscard]] virtual std::string nameSuffix(const TemplateParameters& parameters) const = 0;

  /// It breaks what its method promises on purpose.
  [[nodiscard]] virtual bool isForStudy(const TemplateParameters& /*parameters*/) const {
    return false;
  }

  /// Cells of the client's longest request during a run.
  [[nodiscard]] virtual int longestWrite(const TemplateParameters& parameters) const = 0;

  /// The same program as the loop of a whole job; null: whole jobs do not run with this method.
  [[nodiscard]] virtual std::unique_ptr<MethodTemplate> asSubprogram(std::string /*name*/) const {
    return nullptr;
  }
};

/// Of the parameters' method, for their make of control; without one for it, that for SINUMERIK.
[[nodiscard]] const MethodTemplate& methodTemplate(const TemplateParameters& parameters);
/// Whether there is one for their make of control.
[[nodiscard]] bool hasTemplate(const TemplateParameters& parameters);

/// One that is not in the table of this folder, see `streaming::registerMethod`. It has to last.
/// Before anything asks for it, on one thread.
void addTemplate(base::MethodKind method, TargetControl target, const MethodTemplate& added);

/// For `makeProgram`. @return the errors of `requireProgram`
[[nodiscard]] base::Result<CellMap> planCells(const TemplateParameters& parameters);

}  // namespace rivulet::templates
