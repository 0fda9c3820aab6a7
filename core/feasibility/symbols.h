// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// clang-format off
/// @file
/// Paper symbols, their names here and their units; and the keys of the papers.
///
/// [P1]  S. Menetrey, H. Schlegel, M. Dix: Trajectory Control of Computerized Numerical Control
///       Machines from External Python Program Using OPC UA. Chemnitz University of Technology.
///
/// [P2]  A. Tiwari, Y. Wang, K. Saleeby, A. L. N. Reddy, S. Bukkapatnam: Learning digital emulators
///       for closed architecture machine tool controllers. Journal of Manufacturing Systems, 2023.
///       Its symbols are in emulator/paper.
///
/// | [P1]      | here                            | unit  | meaning                                    |
/// |-----------|---------------------------------|-------|--------------------------------------------|
/// | F         | feedMmPerS                      | mm/s  | path feed (mm/min in the paper)            |
/// | d_min     | pointDistanceMmMin              | mm    | smallest distance of neighbouring points   |
/// | d_min^N   | windowLengthMmMin               | mm    | smallest path length of ⌊N/2⌋ steps        |
/// | δ         | deltaMm                         | mm    | distance at which a point counts as reached|
/// | N         | pointsPerLoop                   | -     | points per loop of the flexible program    |
/// | Δt        | pollTime                        | time  | duration of one client loop                |
/// | 4.3 ms    | accessTime                      | time  | one OPC UA read or write of one node       |
// clang-format on
#pragma once

namespace rivulet::feasibility {

inline constexpr int kPaperAxes = 3;  ///< X, Y, Z of each point: [P1] V.B.a

}  // namespace rivulet::feasibility
