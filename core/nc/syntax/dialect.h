// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The languages NC programs are written in. @threadsafety pure.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rivulet::nc {

enum class Dialect : unsigned char {
  Sinumerik,  ///< Siemens 840D, 828D, ONE
  Fanuc,      ///< and what follows it: Mitsubishi, Mazak EIA, Mach3
  Haas,       ///< follows Fanuc, with rules of its own
  LinuxCnc,   ///< RS-274/NGC with O words
  Grbl,
  Heidenhain,  ///< plain text (Klartext): read by a language of its own
  FluidNc,     ///< follows GRBL, with the O words and calculations of RS-274/NGC
};

inline constexpr std::array kDialects{Dialect::Sinumerik, Dialect::Fanuc, Dialect::Haas,
                                      Dialect::LinuxCnc,  Dialect::Grbl,  Dialect::Heidenhain,
                                      Dialect::FluidNc};

/// "sinumerik", "fanuc", "haas", "linuxcnc", "grbl", "heidenhain", "fluidnc": for files and
/// options.
[[nodiscard]] std::string_view dialectName(Dialect dialect);
/// @param name  as above; "iso" is "fanuc"
[[nodiscard]] std::optional<Dialect> dialectOfName(std::string_view name);

struct DialectGuess {
  Dialect dialect = Dialect::Fanuc;
  std::string evidence;  ///< the text that decided, "" if nothing did
  /// The words that show a program for a lathe: a turning cycle (G70 to G73 with P and Q), or
  /// several of G50 S, G96, G97, G99, T0101, U and W where no Y is; "": none.
  std::string lathe;
  /// What else the text may be, the likeliest first; empty: the evidence decides.
  std::vector<Dialect> others;
  /// Words that only another control has, strong as those that decided; "": none.
  std::string contradiction;
};

/// Looks at the words of the first 2000 lines and at the ending of the file's name. Without
/// evidence it is Fanuc, whose words mean the same in all dialects but Heidenhain's.
/// @threadsafety pure.
[[nodiscard]] DialectGuess detectDialect(std::string_view text, std::string_view fileName = {});

}  // namespace rivulet::nc
