// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Every test runs in the locale of whoever starts it, as a Qt program does: a comma as decimal
// point or a dotless i must not change what is read or written.

#include <clocale>

namespace {

[[maybe_unused]] const char* const kLocale = std::setlocale(LC_ALL, "");

}  // namespace
