// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "support/test_program.h"

#include <QTemporaryDir>
#include <QtTest>
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#ifdef QT_WIDGETS_LIB
#include <QApplication>
using Application = QApplication;
#else
using Application = QCoreApplication;
#endif

namespace {

std::map<std::string, rivulet::tests::MakeTest>& allTests() {
  static std::map<std::string, rivulet::tests::MakeTest> tests;
  return tests;
}

std::string stem(std::string_view path) {
  const std::size_t slash = path.find_last_of('/');
  const std::string_view name = slash == path.npos ? path : path.substr(slash + 1);
  return std::string(name.substr(0, name.find('.')));
}

/// Each test has folders of its own for what a user keeps: it finds no runs, machines or settings of
/// others, and leaves none.
int run(rivulet::tests::MakeTest make, std::vector<char*> arguments) {
  const QTemporaryDir home;
  qputenv("XDG_CONFIG_HOME", home.filePath(QStringLiteral("config")).toUtf8());
  qputenv("XDG_DATA_HOME", home.filePath(QStringLiteral("data")).toUtf8());
  qputenv("XDG_STATE_HOME", home.filePath(QStringLiteral("state")).toUtf8());
  return QTest::qExec(make().get(), static_cast<int>(arguments.size()), arguments.data());
}

}  // namespace

bool rivulet::tests::addTest(const char* file, MakeTest make) {
  return allTests().emplace(stem(file), make).second;
}

int main(int argc, char** argv) {
  // Every test runs in the locale of whoever starts it, as a Qt program does: a comma as decimal
  // point or a dotless i must not change what is read or written.
  std::setlocale(LC_ALL, "");
  Application application(argc, argv);
  QCoreApplication::setAttribute(Qt::AA_Use96Dpi);  // as QTEST_MAIN does
  std::vector<char*> arguments(argv, argv + argc);

  if (argc > 1 && std::string_view(argv[1]).starts_with("tst_")) {
    const auto test = allTests().find(argv[1]);
    if (test == allTests().end()) {
      std::fprintf(stderr, "%s: there is no %s here\n", argv[0], argv[1]);
      return 2;
    }
    arguments.erase(arguments.begin() + 1);
    return run(test->second, arguments);
  }
  int failures = 0;
  for (const auto& [name, make] : allTests()) {
    failures += run(make, arguments);
  }
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
