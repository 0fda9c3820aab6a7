// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Method window for controls on which it has never run: the same cells and the same contract with
/// the client as on a SINUMERIK, written from the documentation of TwinCAT NC I and of the ISG
/// kernel. One program in two languages. What the documentation does not say is not used: no
/// blending of corners, no rotary axes, no online correction, no method credit.
#pragma once

#include <string>
#include <string_view>

#include "templates/methods/window.h"

namespace rivulet::templates {

/// The notation of a language with IF and WHILE.
class StructuredLanguage;

class UntriedWindowTemplate : public WindowTemplate {
 public:
  [[nodiscard]] std::unique_ptr<MethodTemplate> asSubprogram(std::string) const override {
    return nullptr;
  }
  [[nodiscard]] base::Result<void> check(const TemplateParameters& parameters) const override;
  [[nodiscard]] std::string program(const TemplateParameters& parameters, const CellMap& cells,
                                    int layoutNumber) const override;
  [[nodiscard]] std::string nameSuffix(const TemplateParameters& parameters) const override;

 protected:
  [[nodiscard]] virtual const StructuredLanguage& language() const = 0;

 private:
  void writeComments(Listing& out, const TemplateParameters& parameters,
                     const CellMap& cells) const;
  void writeStart(Listing& out, const CellMap& cells) const;
  void writeQuestion(Listing& out, const CellMap& cells) const;
  void writeTaking(Listing& out, const CellMap& cells) const;
  void writeMotion(Listing& out, const CellMap& cells) const;
  void writeWaiting(Listing& out, const CellMap& cells) const;
};

/// Beckhoff TwinCAT 3 NC I, GST interpreter. @source TF5100, GST reference manual
class TwinCatWindowTemplate final : public UntriedWindowTemplate {
 private:
  [[nodiscard]] const StructuredLanguage& language() const override;
};

/// ISG kernel, as in Beckhoff TwinCAT 3 CNC. @source TF5200, programming manual and external
/// variables
class IsgWindowTemplate final : public UntriedWindowTemplate {
 private:
  [[nodiscard]] const StructuredLanguage& language() const override;
};

}  // namespace rivulet::templates
