# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Debian's toml++ as headers alone: its own file for CMake names a library for Linux.
add_library(tomlplusplus::tomlplusplus INTERFACE IMPORTED)
set_target_properties(tomlplusplus::tomlplusplus PROPERTIES
  INTERFACE_INCLUDE_DIRECTORIES ${rivulet_libraries}/include INTERFACE_COMPILE_DEFINITIONS TOML_HEADER_ONLY=1)
