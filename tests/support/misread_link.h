// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A control that understands a program otherwise than it is written: it executes another text, and
/// gives back the one that was brought. @threadsafety one object, one thread.
#pragma once

#include <string>
#include <utility>

#include "opcua/forwarding_link.h"
#include "streaming/simulation/simulated_link.h"

namespace rivulet::tests {

/// The program as a wrong machine understands it.
class MisreadLink : public opcua::ForwardingLink, public opcua::Control {
 public:
  MisreadLink(streaming::SimulatedLink& link, std::string from, std::string to)
      : ForwardingLink(link), m_machine(link), m_from(std::move(from)), m_to(std::move(to)) {}
  base::Result<void> uploadProgram(const std::string& name, const std::string& text,
                                   bool overwrite) override {
    m_text = text;
    std::string misread = text;
    for (std::size_t at = misread.find(m_from); at != std::string::npos;
         at = misread.find(m_from, at + m_to.size())) {
      misread.replace(at, m_from.size(), m_to);
    }
    return m_machine.uploadProgram(name, misread, overwrite);
  }
  base::Result<std::string> downloadProgram(const std::string& name) override {
    const auto there = m_machine.downloadProgram(name);
    return there && !m_text.empty() ? base::Result<std::string>(m_text) : there;
  }
  base::Result<void> selectProgram(const std::string& name) override {
    return m_machine.selectProgram(name);
  }
  [[nodiscard]] bool isVirtualMachine() const override { return true; }
  [[nodiscard]] opcua::Abilities abilities() const override { return m_machine.abilities(); }
  base::Result<void> cycleStart() override { return m_machine.cycleStart(); }
  base::Result<void> reset() override { return m_machine.reset(); }
  base::Result<trace::ControlTrace> fetchTrace() override { return m_machine.fetchTrace(); }
  base::Result<trace::TracePiece> fetchTracePiece(const trace::TracePosition& from) override {
    return m_machine.fetchTracePiece(from);
  }

 private:
  streaming::SimulatedLink& m_machine;
  std::string m_from;
  std::string m_to;
  std::string m_text;
};

}  // namespace rivulet::tests
