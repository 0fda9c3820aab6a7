// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Look-ahead and interpolation. Prepared motion blocks go in at one end; one set point per
/// interpolation cycle comes out. @threadsafety one object, one thread; `step` allocates only
/// when a block ends and its record is kept.
///
/// How it works. Each block is a straight line with a path speed it may not exceed, an
/// acceleration its axes can follow, and a speed at which it may be entered: the speed step of
/// each axis at the corner must stay within the axis's acceleration times one cycle (times the
/// overload factor), and a chain of short blocks is treated as the curve it approximates, whose
/// centripetal acceleration the axes must bear. From the last block, where the path must be able
/// to stand, a backward pass lowers the entry speeds to what braking allows. Within a block the
/// motion is time-optimal between its entry and exit speed (accelerate, cruise, brake) and is
/// evaluated in closed form, so that the result does not depend on where the cycles fall.
#pragma once

#include <array>
#include <deque>
#include <optional>
#include <vector>

#include "base/instant.h"
#include "machine/config.h"
#include "machine/prepared.h"
#include "trace/control_trace.h"

namespace rivulet::machine {

class PathPlanner {
 public:
  PathPlanner(const MachineConfig& config, base::Vec3 startMm);

  /// Appends a block behind the last one.
  void append(const PreparedMotion& motion);
  void append(const PreparedDwell& dwell);

  /// Blocks taken over and not finished.
  [[nodiscard]] int blockCount() const { return static_cast<int>(m_blocks.size()); }
  [[nodiscard]] bool isStanding() const { return m_speedMmPerS == 0.0; }

  /// One interpolation cycle ending at `end`. Blocks that end within it are reported.
  void step(base::Instant end, std::vector<trace::ExecutedBlock>& executed);

  /// Brake to a stand on the path and forget the rest.
  void abort() { m_aborting = true; }

  [[nodiscard]] base::Vec3 commandMm() const { return m_commandMm; }
  [[nodiscard]] double speedMmPerS() const { return m_speedMmPerS; }
  [[nodiscard]] double feedCommandMmPerS() const;
  [[nodiscard]] base::Vec3 distanceToGoMm() const;
  [[nodiscard]] base::LineNumber line() const { return m_line; }
  /// End point of the last block taken over: where the path will stand.
  [[nodiscard]] base::Vec3 endMm() const { return m_endMm; }

 private:
  struct Block {
    base::LineNumber line;
    base::Vec3 fromMm;
    base::Vec3 toMm;
    base::Vec3 direction;
    double lengthMm = 0.0;
    double speedMmPerSMax = 0.0;
    double accelerationMmPerS2 = 0.0;
    double cornerMmPerSMax = 0.0;  ///< from the corner to the block before
    double entryMmPerSMax = 0.0;   ///< corner and braking together
    bool exactStop = false;
    double dwellS = 0.0;
    std::optional<base::Instant> startedAt;
  };

  [[nodiscard]] double cornerSpeed(const Block& before, const Block& after) const;
  [[nodiscard]] double exitSpeed(std::size_t index) const;
  void planBackwards();
  /// Moves along the first block for at most `seconds`. @return the time left
  double advanceFirst(double seconds);
  void finishFirst(base::Instant at, std::vector<trace::ExecutedBlock>& executed);

  MachineConfig m_config;
  double m_cycleS;
  std::deque<Block> m_blocks;
  double m_pathMm = 0.0;  ///< on the first block
  double m_speedMmPerS = 0.0;
  double m_dwellLeftS = 0.0;
  bool m_aborting = false;
  base::Vec3 m_commandMm;
  base::Vec3 m_endMm;
  base::LineNumber m_line;
};

}  // namespace rivulet::machine
