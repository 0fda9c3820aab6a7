// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The program of a method with windows as the loop of a whole job, see `JobLoop`.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "templates/job_loop.h"
#include "templates/methods/window.h"

namespace rivulet::templates {

/// A method's program as a subprogram.
template <class Base>
class SubprogramTemplate final : public Base {
 public:
  explicit SubprogramTemplate(std::string name) : m_name(std::move(name)) {}

 protected:
  [[nodiscard]] std::string_view endWord() const override { return "M17"; }

  void writeHead(Listing& out) const override {
    out.line("PROC {}(REAL RIV_JOB,REAL RIV_STR,REAL RIV_RUN)", m_name);
    out.line(
        "; Called by the main program of a whole job: number of the job, of the stretch, and of");
    out.line("; the run to be obeyed. Stretch 0 waits for the client and moves nothing.");
  }

  /// The main program has done so: the override is that of the whole job.
  void writeFeedCell(Listing&, const CellMap&) const override {}

  /// The number comes last: who sees it knows that the cells are those of this stretch.
  void writeReady(Listing& out, const CellMap& cells) const override {
    out.line("RIV_OWN=RIV_RUN");
    out.line("R{}=RIV_OWN", cells.owner);
    out.line("R{}=RIV_JOB*{}+RIV_STR", JobProtocol::callCell(cells),
             JobProtocol::kStretchesMax + 1);
  }

  void writeLeaving(Listing& out, const CellMap& cells) const override {
    out.line("IF (RIV_STR==0) AND (R{}=={}) AND (RIV_OWN>0) GOTOF RIV_RETURN", cells.run,
             WindowProtocol::kRun);
  }

  /// The client has to see that the stretch was executed before the control goes on.
  void writeDone(Listing& out, const CellMap& cells) const override {
    out.line("RIV_IDLE=0");
    out.line("RIV_EXECUTED:");
    out.line("STOPRE");
    out.line("IF R{}==RIV_STR+{} GOTOF RIV_RETURN", cells.run, JobProtocol::goOn(0));
    out.line("IF R{}=={} GOTOF RIV_STOPPED", cells.run, WindowProtocol::kEnd);
    out.line("IF R{}==RIV_BEAT GOTOF RIV_ASLEEP", cells.heartbeat);
    out.line("RIV_BEAT=R{} RIV_IDLE=0", cells.heartbeat);
    out.line("RIV_ASLEEP:");
    out.line("RIV_IDLE=RIV_IDLE+1");
    out.line("IF RIV_IDLE>{} GOTOF RIV_LOST", kSilentPassesMax);
    out.line("G4 F0.02");
    out.line("GOTOB RIV_EXECUTED");
    out.line("RIV_RETURN:");
    out.line("R{}={}", cells.state, static_cast<int>(WindowState::Done));
    out.line("R{}=-RIV_JOB*{}-RIV_STR", JobProtocol::callCell(cells),
             JobProtocol::kStretchesMax + 1);
  }

 private:
  /// Passes of 20 ms or more in which the client neither lets the job go on nor gives a sign of
  /// life.
  static constexpr int kSilentPassesMax = 1000;

  std::string m_name;
};

}  // namespace rivulet::templates
