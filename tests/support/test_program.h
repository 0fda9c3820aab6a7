// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

/// One program per folder holds all test classes of that folder. Each class has a file of its own,
/// tst_<name>.cpp, which ends with
///
///   RIVULET_TEST(TestName)
///   #include "tst_<name>.moc"
///
/// and a line rivulet_add_test(tst_<name> …) in the folder's CMakeLists.txt. The program runs the
/// class whose file is named first on its command line, or all of them:
///
///   tests_gcode                       every class of tests/gcode
///   tests_gcode tst_arc               one class
///   tests_gcode tst_arc fullCircle    one of its functions; all arguments of Qt Test follow here

#include <QObject>
#include <memory>

namespace rivulet::tests {

using MakeTest = std::unique_ptr<QObject> (*)();

/// Adds a test class under the name of its file without folder and ending. Returns true. To be
/// called before main() only, as RIVULET_TEST does.
bool addTest(const char* file, MakeTest make);

}  // namespace rivulet::tests

#define RIVULET_TEST(Class)                                                              \
  namespace {                                                                            \
  [[maybe_unused]] const bool k##Class##IsAdded = rivulet::tests::addTest(               \
      __FILE__, []() -> std::unique_ptr<QObject> { return std::make_unique<Class>(); }); \
  }
