// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What a streaming method runs on the control: its cells and its program. One class per method, in
/// `methods/`; `methodTemplate` is where they are registered. Others use `planCells` and
/// `generateTemplate`. @threadsafety pure.
#pragma once

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

  /// The settings of this method alone; axes and N have been checked.
  [[nodiscard]] virtual base::Result<void> check(const TemplateParameters& parameters) const = 0;

  /// Where everything lies, whether it fits the control or not. @param parameters have been checked
  [[nodiscard]] virtual CellMap cells(const TemplateParameters& parameters) const = 0;

  /// Largest N that fits the R-parameters of the control; 0 if none does. At least one axis.
  [[nodiscard]] virtual int pointsMax(const TemplateParameters& parameters) const = 0;

  /// The program. @param layoutNumber  what it writes into its layout cell
  [[nodiscard]] virtual std::string program(const TemplateParameters& parameters,
                                            const CellMap& cells, int layoutNumber) const = 0;

  /// Letters that tell variants apart in the file name.
  [[nodiscard]] virtual std::string nameSuffix(const TemplateParameters& parameters) const = 0;

  /// Cells of the longest request the client makes while it streams.
  [[nodiscard]] virtual int longestWrite(const TemplateParameters& parameters) const = 0;
};

[[nodiscard]] const MethodTemplate& methodTemplate(base::MethodKind method);

/// As `planCells`, whether the cells fit the control or not.
[[nodiscard]] base::Result<CellMap> planCellsAnywhere(const TemplateParameters& parameters);

}  // namespace rivulet::templates
