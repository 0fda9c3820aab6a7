// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Methods with numbered windows: the program copies a window only after its number has been
/// delivered. `WindowedTemplate` is common to the three methods.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "templates/listing.h"
#include "templates/method_template.h"

namespace rivulet::templates {

/// Header cells, the waiting loop and the ends of the program.
class WindowedTemplate : public MethodTemplate {
 public:
  [[nodiscard]] base::Result<void> check(const TemplateParameters& parameters) const override;
  [[nodiscard]] std::string nameSuffix(const TemplateParameters& parameters) const override;

 protected:
  /// Passes of the waiting loop without a window and without a change of the heartbeat, before the
  /// program ends. A pass takes 20 ms or more.
  static constexpr int kSilentPassesMax = 1000;

  /// Comments in the programs of these methods.
  struct Wording {
    std::string_view source;   ///< "R-PARAMETERS"
    std::string_view latched;  ///< meaning of the cell `latched`
  };

  /// The header cells, and the slots of the chosen axes after them.
  [[nodiscard]] CellMap header(const TemplateParameters& parameters) const;
  /// Gives the factor of the override its cell after all others, if there is to be one.
  static void takeFactor(CellMap& cells, const TemplateParameters& parameters);
  void writeTitle(Listing& out, const TemplateParameters& parameters, const CellMap& cells,
                  const Wording& wording) const;
  void writeHeaderCells(Listing& out, const CellMap& cells, const Wording& wording) const;
  void writeResets(Listing& out, const CellMap& cells) const;
  /// Puts the feed cell into force, unless a program that calls this one has done so.
  virtual void writeFeedCell(Listing& out, const CellMap& cells) const;
  /// The axes have stopped; the program checks for news, and ends if the client is gone.
  void writeWaiting(Listing& out, const CellMap& cells) const;
  /// Last block of the program, on each way.
  [[nodiscard]] virtual std::string_view endWord() const { return "M30"; }
  /// A way out of the waiting loop that needs no window. Nothing here.
  virtual void writeLeaving(Listing&, const CellMap&) const {}
  /// @param stands  the axes stand here; else a STOPRE comes first, and all that was copied has
  ///                been executed after it
  void writeEnd(Listing& out, const CellMap& cells, std::string_view label, WindowState state,
                bool stands) const;
};

/// Copies each window, checks the copy and moves from the copy.
class WindowTemplate : public WindowedTemplate {
 public:
  [[nodiscard]] base::Result<void> check(const TemplateParameters& parameters) const override;
  [[nodiscard]] CellMap cells(const TemplateParameters& parameters) const override;
  [[nodiscard]] int pointsMax(const TemplateParameters& parameters) const override;
  [[nodiscard]] std::string program(const TemplateParameters& parameters, const CellMap& cells,
                                    int layoutNumber) const override;
  [[nodiscard]] std::string nameSuffix(const TemplateParameters& parameters) const override;
  [[nodiscard]] int longestWrite(const TemplateParameters& parameters) const override;
  [[nodiscard]] std::unique_ptr<MethodTemplate> asSubprogram(std::string name) const override;

 protected:
  // What the loop of a whole job does in addition. Nothing here.
  virtual void writeHead(Listing&) const {}
  virtual void writeReady(Listing&, const CellMap&) const {}
  virtual void writeDone(Listing&, const CellMap&) const {}
  /// What method credit does in addition. Nothing here.
  virtual void writeNotes(Listing&, const CreditSettings&) const {}
  [[nodiscard]] virtual std::string_view variables() const { return ""; }
  virtual void writeSlowDown(Listing&, const CreditSettings&, const CellMap&) const {}
  virtual void writeAsking(Listing&, const CreditSettings&, const CellMap&) const {}
  virtual void writeTaken(Listing&, const CellMap&) const {}
  virtual void writeLastTaken(Listing&, const CreditSettings&) const {}
  /// Where the program continues after a window.
  [[nodiscard]] virtual std::string_view next() const { return "RIV_NEXT"; }
  /// True if the axes have stopped whenever the program asks for a window.
  [[nodiscard]] virtual bool standsBetweenWindows() const { return true; }

 private:
  void writeComments(Listing& out, const TemplateParameters& parameters,
                     const CellMap& cells) const;
  void writeStart(Listing& out, const TemplateParameters& parameters, const CellMap& cells,
                  int layoutNumber) const;
  void writeCopies(Listing& out, const CellMap& cells) const;
  void writeUnpacking(Listing& out, const CellMap& cells) const;
  void writeCopyAndCheck(Listing& out, const CellMap& cells) const;
  void writeMotion(Listing& out, const TemplateParameters& parameters, const CellMap& cells) const;
};

/// As method window, without a stop between windows. Experimental.
class CreditTemplate : public WindowTemplate {
 public:
  [[nodiscard]] std::unique_ptr<MethodTemplate> asSubprogram(std::string name) const override;
  [[nodiscard]] std::string nameSuffix(const TemplateParameters& parameters) const override;

 private:
  void writeNotes(Listing& out, const CreditSettings& settings) const override;
  [[nodiscard]] std::string_view variables() const override { return ",RIV_TURN,RIV_DRY"; }
  void writeSlowDown(Listing& out, const CreditSettings& settings,
                     const CellMap& cells) const override;
  void writeAsking(Listing& out, const CreditSettings& settings,
                   const CellMap& cells) const override;
  void writeTaken(Listing& out, const CellMap& cells) const override;
  void writeLastTaken(Listing& out, const CreditSettings& settings) const override;
  [[nodiscard]] std::string_view next() const override { return "RIV_MORE"; }
  [[nodiscard]] bool standsBetweenWindows() const override { return false; }
};

/// Calls a subprogram for each window, and continues only if its answer is right.
class FileTemplate final : public WindowedTemplate {
 public:
  [[nodiscard]] base::Result<void> check(const TemplateParameters& parameters) const override;
  [[nodiscard]] CellMap cells(const TemplateParameters& parameters) const override;
  [[nodiscard]] int pointsMax(const TemplateParameters& parameters) const override;
  [[nodiscard]] std::string program(const TemplateParameters& parameters, const CellMap& cells,
                                    int layoutNumber) const override;
  [[nodiscard]] int longestWrite(const TemplateParameters& parameters) const override;
};

}  // namespace rivulet::templates
