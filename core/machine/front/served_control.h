// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What the OPC UA server shows and commands: the virtual machine, or a real control behind a
/// bridge. The server knows no other interface of a control.
/// @threadsafety one object, one thread at a time: that of the server.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/axes.h"
#include "base/instant.h"
#include "base/result.h"
#include "machine/config.h"
#include "machine/machine.h"
#include "opcua/link.h"
#include "trace/trace_piece.h"

namespace rivulet::machine {

/// As the virtual machine presents itself.
inline constexpr std::string_view kProductName = "Rivulet virtual machine";
inline constexpr std::string_view kApplicationUri = "urn:rivulet:machine";

/// Between which values a variable is in normal operation, in its unit.
struct ValueRange {
  double low = 0.0;
  double high = 0.0;
};

/// What does not change while the server runs.
struct ServedFacts {
  std::string name;            ///< of the preset or the machine; clients see when it has changed
  std::string product;         ///< as the server presents itself
  std::string applicationUri;  ///< of a server without a certificate
  bool isVirtual = true;       ///< no real axis moves
  opcua::Abilities abilities;  ///< which methods beside those of the file system there are
  bool tracePieces = false;    ///< `takeTrace`
  /// Rotary axes of the channel, in the order after X, Y and Z: 0 to 2 for A, B, C.
  std::vector<std::size_t> rotaryAxes;
  base::Duration samplingMin{};  ///< shortest sampling and publishing interval
  ArrayAccess arrays;
  UserManagement users;

  // What clients see as ranges of the variables; nothing: not known.
  /// Of X Y Z in mm and of A B C in degrees, machine coordinates.
  std::array<std::optional<ValueRange>, base::kAxisCount + base::kRotaryAxisCount> travel;
  std::optional<ValueRange> feedMmPerMin;
  std::optional<ValueRange> spindlePerMin;
};

class ServedControl {
 public:
  ServedControl() = default;
  ServedControl(const ServedControl&) = delete;
  ServedControl& operator=(const ServedControl&) = delete;
  virtual ~ServedControl() = default;

  [[nodiscard]] virtual const ServedFacts& facts() const = 0;
  /// Whether the control has a variable. What it does not have gets no node.
  /// @param folder,name  as on a SINUMERIK, e.g. "State", "actTNumber"; no folder for functions of
  ///                     groups ("ncFktAct", "acAuxfuMValue")
  [[nodiscard]] virtual bool shows(std::string_view folder, std::string_view name) const = 0;

  /// Goes on to the present. @param until not before `now()` (earlier: no effect)
  virtual void advance(base::Instant until) = 0;
  [[nodiscard]] virtual base::Instant now() const = 0;
  [[nodiscard]] virtual MachineState state() const = 0;

  [[nodiscard]] virtual bool hasRParameter(int index) const = 0;
  /// @param index hasRParameter
  [[nodiscard]] virtual double rParameter(int index) const = 0;
  /// @param index hasRParameter
  virtual void writeRParameter(int index, double value) = 0;

  // The time that access takes; a control that is not simulated takes it anyway, so it returns
  // at once.
  /// @param arrival  of a request whose nodes are served after it
  virtual void beginRequest(AccessKind kind, base::Instant arrival) = 0;
  /// @param at  the present @return when the next node of the request is done
  [[nodiscard]] virtual base::Instant serveNode(base::Instant at) = 0;
  /// @return of writing a program of this size
  [[nodiscard]] virtual base::Duration programTime(std::size_t bytes) const = 0;

  // Programs; the errors are those of `Machine`.
  virtual base::Result<void> storeProgram(const std::string& name, std::string text,
                                          bool overwrite) = 0;
  [[nodiscard]] virtual base::Result<std::string> programText(const std::string& name) = 0;
  virtual base::Result<void> selectProgram(const std::string& name) = 0;
  virtual base::Result<void> cycleStart() = 0;
  virtual void reset() = 0;
  /// The control's own trace since the last cycle start, as `trace::printControlTrace` writes it. A
  /// control whose samples arrive late may wait for them.
  [[nodiscard]] virtual std::string traceText() = 0;
  /// The next part of it, see `Machine::takeTrace`; only if `ServedFacts::tracePieces`.
  [[nodiscard]] virtual trace::TracePiece takeTrace(const trace::TracePosition& /*from*/) {
    return {};
  }
};

/// The virtual machine as such a control.
class ServedMachine final : public ServedControl {
 public:
  /// @param machine  outlives this object
  explicit ServedMachine(Machine& machine);

  [[nodiscard]] const ServedFacts& facts() const override { return m_facts; }
  [[nodiscard]] bool shows(std::string_view folder, std::string_view name) const override;
  void advance(base::Instant until) override { m_machine.advance(until); }
  [[nodiscard]] base::Instant now() const override { return m_machine.now(); }
  [[nodiscard]] MachineState state() const override { return m_machine.state(); }
  [[nodiscard]] bool hasRParameter(int index) const override {
    return m_machine.hasRParameter(index);
  }
  [[nodiscard]] double rParameter(int index) const override { return m_machine.rParameter(index); }
  void writeRParameter(int index, double value) override {
    m_machine.writeRParameter(index, value);
  }
  void beginRequest(AccessKind kind, base::Instant arrival) override {
    m_machine.beginRequest(kind, arrival);
  }
  [[nodiscard]] base::Instant serveNode(base::Instant) override { return m_machine.serveNode(); }
  [[nodiscard]] base::Duration programTime(std::size_t bytes) const override;
  base::Result<void> storeProgram(const std::string& name, std::string text,
                                  bool overwrite) override {
    return m_machine.storeProgram(name, std::move(text), overwrite);
  }
  [[nodiscard]] base::Result<std::string> programText(const std::string& name) override {
    return m_machine.programText(name);
  }
  base::Result<void> selectProgram(const std::string& name) override {
    return m_machine.selectProgram(name);
  }
  base::Result<void> cycleStart() override { return m_machine.cycleStart(); }
  void reset() override { m_machine.reset(); }
  [[nodiscard]] std::string traceText() override;
  [[nodiscard]] trace::TracePiece takeTrace(const trace::TracePosition& from) override {
    return m_machine.takeTrace(from);
  }

 private:
  Machine& m_machine;
  ServedFacts m_facts;
};

}  // namespace rivulet::machine
