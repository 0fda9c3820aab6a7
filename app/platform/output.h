// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What a program prints may come to a full disk, a file that must not grow, a pipe whose reader
/// has gone, or nowhere. None of this ends a program, least of all one that streams to a machine:
/// what cannot be written is lost, and said at the end. @threadsafety main thread.
#pragma once

#include <string>

namespace rivulet::output {

/// First of all in `main`. Standard input, output and error that are closed lead nowhere from now
/// on: else the next file that is opened, or the connection to a control, would get what is
/// printed. Printing to standard output succeeds, whatever comes of it. SIGPIPE and SIGXFSZ do
/// nothing.
void guard();

/// Something that was printed could not be written: who prints until somebody stops it can end.
[[nodiscard]] bool isLost();

/// Writes what is left. @return one sentence if not all that was printed could be written, else
/// empty; a reader that has gone wants no more, and is no error
[[nodiscard]] std::string failure();

}  // namespace rivulet::output
