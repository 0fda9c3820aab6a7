// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Methods window and credit for LinuxCNC: the same cells and the same contract with the client as
/// on a SINUMERIK, in the language of LinuxCNC (O-words, pins of the HAL).
#pragma once

#include "templates/methods/window.h"

namespace rivulet::templates {

/// The axes stop between windows: M66 makes the interpreter wait for them.
class LinuxCncWindowTemplate : public WindowTemplate {
 public:
  [[nodiscard]] std::unique_ptr<MethodTemplate> asSubprogram(std::string name) const override;
  [[nodiscard]] base::Result<void> check(const TemplateParameters& parameters) const override;
  [[nodiscard]] std::string program(const TemplateParameters& parameters, const CellMap& cells,
                                    int layoutNumber) const override;
  [[nodiscard]] std::string nameSuffix(const TemplateParameters& parameters) const override;

 protected:
  [[nodiscard]] virtual bool isCredit() const { return false; }
  [[nodiscard]] std::string_view endWord() const override { return "M2"; }
  // What the loop of a whole job does otherwise.
  virtual void writeBeginning(Listing& out, const CellMap& cells) const;
  virtual void writeOwner(Listing& out) const;
  void writeDone(Listing& out, const CellMap& cells) const override;

 private:
  void writeComments(Listing& out, const TemplateParameters& parameters,
                     const CellMap& cells) const;
  void writeStart(Listing& out, const CellMap& cells, int layoutNumber) const;
  void writeWait(Listing& out, const TemplateParameters& parameters, const CellMap& cells) const;
  void writeTaking(Listing& out, const CellMap& cells) const;
  void writeMotion(Listing& out, const CellMap& cells) const;
};

/// No stop while windows are delivered in time. The interpreter asks for the next window while the
/// axes execute earlier ones.
class LinuxCncCreditTemplate : public LinuxCncWindowTemplate {
 public:
  [[nodiscard]] std::unique_ptr<MethodTemplate> asSubprogram(std::string name) const override;
  [[nodiscard]] base::Result<void> check(const TemplateParameters& parameters) const override;
  [[nodiscard]] std::string nameSuffix(const TemplateParameters& parameters) const override;

 private:
  [[nodiscard]] bool isCredit() const override { return true; }
};

}  // namespace rivulet::templates
