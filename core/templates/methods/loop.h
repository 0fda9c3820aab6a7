// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The methods of [P1]: a loop over N slots, as in Algorithm I. They differ in where the loop
/// waits.
#pragma once

#include "templates/listing.h"
#include "templates/method_template.h"

namespace rivulet::templates {

class LoopTemplate : public MethodTemplate {
 public:
  [[nodiscard]] base::Result<void> check(const TemplateParameters& parameters) const override;
  [[nodiscard]] CellMap cells(const TemplateParameters& parameters) const override;
  [[nodiscard]] int pointsMax(const TemplateParameters& parameters) const override;
  [[nodiscard]] std::string program(const TemplateParameters& parameters, const CellMap& cells,
                                    int layoutNumber) const override;
  [[nodiscard]] std::string nameSuffix(const TemplateParameters& parameters) const override;

 protected:
  /// Comments before and among those of the cells.
  virtual void writeNotes(Listing& out, const LoopSettings& settings) const = 0;
  virtual void writeSignalCell(Listing& out, const CellMap& cells) const = 0;
  /// The blocks of one pass of the loop.
  virtual void writeLoop(Listing& out, const LoopSettings& settings,
                         const CellMap& cells) const = 0;
};

/// Method 1, after Algorithm II: one STOPRE per loop.
class PositionTemplate final : public LoopTemplate {
 public:
  [[nodiscard]] int longestWrite(const TemplateParameters& parameters) const override;

 private:
  void writeNotes(Listing&, const LoopSettings&) const override {}
  void writeSignalCell(Listing&, const CellMap&) const override {}
  void writeLoop(Listing& out, const LoopSettings& settings, const CellMap& cells) const override;
};

/// Method 2, after Algorithm III: two windows, and a signal cell that names the last one passed.
class SignalTemplate final : public LoopTemplate {
 public:
  [[nodiscard]] int pointsMin() const override { return 2; }
  [[nodiscard]] bool isForStudy(const TemplateParameters& parameters) const override {
    return parameters.signalStop == SignalStop::OncePerLoop;
  }
  [[nodiscard]] std::string nameSuffix(const TemplateParameters& parameters) const override;
  [[nodiscard]] int longestWrite(const TemplateParameters& parameters) const override;

 private:
  void writeNotes(Listing& out, const LoopSettings& settings) const override;
  void writeSignalCell(Listing& out, const CellMap& cells) const override;
  void writeLoop(Listing& out, const LoopSettings& settings, const CellMap& cells) const override;
};

}  // namespace rivulet::templates
