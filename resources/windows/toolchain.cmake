# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later

# MinGW as Debian packages it (g++-mingw-w64-x86-64-posix): 64-bit programs for Windows 10 or newer. scripts/windows
# makes the libraries that are looked for.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)

get_filename_component(rivulet_libraries "${CMAKE_CURRENT_LIST_DIR}/../../build/windows-libraries/prefix" ABSOLUTE)
set(CMAKE_FIND_ROOT_PATH ${rivulet_libraries} /usr/x86_64-w64-mingw32)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(tomlplusplus_DIR ${CMAKE_CURRENT_LIST_DIR})
set(ENV{PKG_CONFIG_LIBDIR} ${rivulet_libraries}/lib/pkgconfig)

# Windows 10: what is older lacks timers of less than 15 ms.
add_compile_definitions(_WIN32_WINNT=0x0A00 WINVER=0x0A00 WIN32_LEAN_AND_MEAN NOMINMAX UNICODE _UNICODE)
# A program is one file: no library of the compiler has to be beside it.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static")
# fmt and others put more sections into an object than the format has by default.
set(CMAKE_CXX_FLAGS_INIT "-Wa,-mbig-obj")
