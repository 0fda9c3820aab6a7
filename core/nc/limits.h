// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What one program may take of this computer. Beyond it the program is refused with a sentence: a
/// file must not be able to take its memory, or its time without end. @threadsafety constants.
#pragma once

#include <cstddef>
#include <cstdint>

namespace rivulet::nc {

// Files.
/// Bytes of a file beside a program that is called: 16 MiB. Subprograms are small.
inline constexpr std::uintmax_t kSubprogramBytesMax = std::uintmax_t{16} * 1024 * 1024;

// What is read.
/// Brackets within brackets of a calculation.
inline constexpr int kBracketsMax = 60;
/// Operators of one chain such as 1+2+3: each adds a level to the tree.
inline constexpr int kChainMax = 1000;
/// IF, WHILE and the like within each other.
inline constexpr std::size_t kStructuresMax = 16;

// What is executed.
/// Programs that call each other, with the main program: NC Programming 12/2019
/// (6FC5398-2EP40-0BA0), 3.2.1.3. Other controls have fewer.
inline constexpr std::size_t kLevelsMax = 16;
/// Rounds of one call or REPEAT.
inline constexpr double kRoundsMax = 9999.0;
/// Statements executed again by loops and calls before a program counts as endless.
inline constexpr std::size_t kRepeatedLinesMax = 5'000'000;
/// The same of plain text, whose blocks take four times as long.
inline constexpr std::size_t kRepeatedPlainTextMax = 1'250'000;
/// Those of them that a job leaves to the control.
inline constexpr std::size_t kRepeatedNativeBlocksMax = 100'000;
/// Points of one trajectory, where its loops and calls repeat blocks. How much memory they may take
/// else, the reader's `base::Budget` says.
inline constexpr std::size_t kRepeatedPointsMax = 3'000'000;

// Variables.
/// Elements of one array, and of all variables with names.
inline constexpr std::size_t kElementsMax = 100'000;
/// # variables that have a value.
inline constexpr std::size_t kNumbersMax = 100'000;

}  // namespace rivulet::nc
