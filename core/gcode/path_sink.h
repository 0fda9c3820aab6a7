// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What a program that is read for its path comes to: trajectory, figures, facts and findings.
/// @threadsafety one object, one thread.
#pragma once

#include <string>

#include "gcode/fact_counter.h"
#include "gcode/findings.h"
#include "gcode/path_builder.h"
#include "gcode/program.h"
#include "nc/exec/sink.h"

namespace rivulet::gcode {

class PathSink final : public nc::Sink {
 public:
  /// All outlive the sink.
  PathSink(const LoadOptions& options, Trajectory& trajectory, Statistics& statistics,
           Findings& findings, FactCounter& facts);

  /// Where what is to come belongs. @param line  of the program itself
  void setLine(base::LineNumber line) { m_line = line; }

  void line(const nc::Position& from, base::Vec3 targetMm, const nc::Move& move) override;
  void arc(const nc::Position& from, const nc::Arc& arc, const nc::Move& move) override;
  void spaceArc(const nc::Position& from, const nc::SpaceArc& arc, base::Vec3 targetMm,
                const nc::Move& move) override;
  void spline(const nc::Position& from, const nc::Spline& spline, const nc::Move& move) override;
  void unknownWay(const nc::Position& from, base::Vec3 targetMm, const nc::Move& move) override;

  void report(Severity severity, int column, nc::FaultCode code, std::string argument) override;
  void fault(int column, const nc::Fault& fault) override;
  void ignore(const nc::Token& token, std::string word) override;
  void ignoreG(int key, const nc::Token& token) override;
  void ignoreM(Severity severity, int number, const nc::Token& token) override;
  void ignoreLetter(const nc::Token& token) override;

  void machineWord(nc::MachineWord kind, double value) override;
  void toolName(std::string_view name) override;

  void programmed(int g, const nc::AxisValues& axes) override { m_facts.motion(g, axes); }
  void programmedArc(const nc::AxisValues& axes, const nc::Arc& arc,
                     const nc::ArcWords& words) override {
    m_facts.arc(arc.clockwise ? 2 : 3, axes, arc, words);
  }
  void programmedForMachine(int g, const nc::AxisValues& axes) override {
    m_facts.machineMotion(g, axes);
  }
  void programmedOther() override { m_facts.otherMotion(); }
  void programmedFeed(double feed, std::optional<double> mmPerMin) override;
  void programmedUnits(bool inches) override { m_facts.units(inches); }
  void forgetPosition(std::optional<std::size_t> axis) override { m_facts.forget(axis); }

 private:
  void count(const nc::Move& move);
  /// One block may not fill the memory, however large its arc and small the tolerance.
  [[nodiscard]] bool hasFewChords(const nc::Position& from, double sweepRad, double radiusMm,
                                  const nc::Move& move);

  Trajectory& m_trajectory;
  Statistics& m_statistics;
  Findings& m_findings;
  FactCounter& m_facts;
  PathBuilder m_path;
  base::LineNumber m_line;
};

}  // namespace rivulet::gcode
