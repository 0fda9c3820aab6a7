// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The house rules themselves, on small texts that keep and break them.

#include <QtTest>

#include "rules.h"
#include "support/test_program.h"

using namespace rivulet::tidy;

namespace {

/// "path:line" of each finding, in order.
QStringList places(const Findings& findings) {
  QStringList result;
  for (const Finding& finding : findings) {
    result.append(QStringLiteral("%1:%2").arg(finding.path).arg(finding.line));
  }
  return result;
}

Source file(const char* path, const char* text) {
  return {QString::fromUtf8(path), QString::fromUtf8(text)};
}

/// Two modules: lower (no edge) and upper, with `edges` in its call.
Sources twoModules(const char* edges) {
  return {file("core/lower/CMakeLists.txt", "rivulet_add_module(lower SOURCES a.cpp)\n"),
          file("core/upper/CMakeLists.txt",
               qPrintable(QStringLiteral("# says why\nrivulet_add_module(upper\n  SOURCES b.cpp\n"
                                         "  %1)\n")
                              .arg(QString::fromUtf8(edges))))};
}

}  // namespace

class TestTidyRules : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void codeOnlyDropsCommentsAndStringsAndKeepsLines() {
    const QString code =
        codeOnly(QStringLiteral("int a; // rand(\n/* getenv\n */ f(\"rand(\\\"x\");\n"
                                "auto c = '\"'; int n = 1'000; g();"));
    QCOMPARE(code.count(u'\n'), 3);
    QVERIFY(!code.contains(u"rand"));
    QVERIFY(!code.contains(u"getenv"));
    QVERIFY(code.contains(u"int a;"));
    QVERIFY(code.contains(u"1'000; g();"));
  }

  void codeOnlyKnowsRawStrings() {
    const QString code =
        codeOnly(QStringLiteral("auto a = R\"x(rand( \" )x\"; auto b = u8R\"(getenv)\"; end();"));
    QVERIFY(!code.contains(u"rand"));
    QVERIFY(!code.contains(u"getenv"));
    QVERIFY(code.contains(u"end();"));
    QVERIFY(codeOnly(QStringLiteral("#include \"a/b.h\" // c"), true).contains(u"\"a/b.h\""));
  }

  void modulesAreReadWithTheirEdges() {
    const Sources sources{
        file("core/machine/front/CMakeLists.txt",
             "rivulet_add_module(machine/front\n  SOURCES server.cpp # PUBLIC rivulet::no\n"
             "  PUBLIC rivulet::machine tl::expected\n"
             "  PRIVATE rivulet::opcua::open62541)\n")};
    const QList<Module> found = modules(sources);
    QCOMPARE(found.size(), 1);
    QCOMPARE(found[0].folder, QStringLiteral("machine/front"));
    QCOMPARE(found[0].publicModules, QStringList{QStringLiteral("machine")});
    QCOMPARE(found[0].privateModules, QStringList{QStringLiteral("opcua/open62541")});
    QCOMPARE(found[0].line, 1);
  }

  void anIncludeNeedsItsEdge() {
    const Source user = file("core/upper/b.cpp", "\n#include \"lower/a.h\"\n");
    QCOMPARE(places(checkEdges(twoModules("") << user)),
             QStringList{QStringLiteral("core/upper/b.cpp:2")});
    QVERIFY(checkEdges(twoModules("PUBLIC rivulet::lower") << user).isEmpty());
    QVERIFY(checkEdges(twoModules("PRIVATE rivulet::lower") << user).isEmpty());
  }

  void aHeadersEdgeIsPublic() {
    const Source header = file("core/upper/b.h", "#pragma once\n#include \"lower/a.h\"\n");
    QCOMPARE(places(checkEdges(twoModules("PRIVATE rivulet::lower") << header)),
             QStringList{QStringLiteral("core/upper/b.h:2")});
    QVERIFY(checkEdges(twoModules("PUBLIC rivulet::lower") << header).isEmpty());
  }

  void anEdgeIsNotInherited() {
    Sources sources = twoModules("PUBLIC rivulet::lower");
    sources << file("core/top/CMakeLists.txt",
                    "rivulet_add_module(top SOURCES c.cpp PUBLIC rivulet::upper)\n")
            << file("core/top/c.cpp", "#include \"upper/b.h\"\n#include \"lower/a.h\"\n");
    QCOMPARE(places(checkEdges(sources)), QStringList{QStringLiteral("core/top/c.cpp:2")});
  }

  void aNestedModuleIsNotItsParent() {
    const Sources sources{
        file("core/machine/CMakeLists.txt", "rivulet_add_module(machine SOURCES m.cpp)\n"),
        file("core/machine/front/CMakeLists.txt",
             "rivulet_add_module(machine/front SOURCES f.cpp)\n"),
        file("core/machine/m.cpp",
             "#include \"machine/parts/p.h\"\n#include \"machine/front/f.h\"\n")};
    QCOMPARE(places(checkEdges(sources)), QStringList{QStringLiteral("core/machine/m.cpp:2")});
  }

  void anIncludeNamesItsPathFromCore() {
    Sources sources = twoModules("");
    sources << file("core/upper/b.cpp",
                    "#include \"b.h\"\n#include \"upper_texts.h\"\n#include \"nowhere/c.h\"\n");
    QCOMPARE(places(checkEdges(sources)), QStringList({QStringLiteral("core/upper/b.cpp:1"),
                                                       QStringLiteral("core/upper/b.cpp:3")}));
  }

  void aSourceIncludesItsHeaderFirst() {
    const Sources sources{file("core/a/good.h", ""),
                          file("core/a/good.cpp", "// #include <b>\n#include \"a/good.h\"\n"),
                          file("core/a/late.h", ""),
                          file("core/a/late.cpp", "#include <vector>\n#include \"a/late.h\"\n"),
                          file("core/a/alone.cpp", "#include <vector>\n"),
                          file("widgets/w.h", ""),
                          file("widgets/w.cpp", "#include \"widgets/w.h\"\n"),
                          file("app/x.h", ""),
                          file("app/x.cpp", "#include <vector>\n")};
    QCOMPARE(places(checkOwnHeaderFirst(sources)),
             QStringList{QStringLiteral("core/a/late.cpp:1")});
  }

  void aFolderWithoutAModuleIsFound() {
    QCOMPARE(places(checkEdges({file("core/lost/a.cpp", "int a;\n")})),
             QStringList{QStringLiteral("core/lost/a.cpp:1")});
  }

  void edgesFormNoCircle() {
    Sources sources = twoModules("PUBLIC rivulet::lower");
    QVERIFY(checkEdges(sources).isEmpty());
    sources[0].text =
        QStringLiteral("rivulet_add_module(lower SOURCES a.cpp PRIVATE rivulet::upper)");
    const Findings findings = checkEdges(sources);
    QCOMPARE(places(findings), QStringList({QStringLiteral("core/lower/CMakeLists.txt:1"),
                                            QStringLiteral("core/upper/CMakeLists.txt:2")}));
    QVERIFY(findings[0].message.contains(u"lower > upper > lower"));
  }

  void coreKnowsNoQt_data() {
    QTest::addColumn<QString>("line");
    QTest::addColumn<bool>("found");
    QTest::newRow("class") << QStringLiteral("#include <QString>") << true;
    QTest::newRow("module") << QStringLiteral("#  include <QtCore/QString>") << true;
    QTest::newRow("umbrella") << QStringLiteral("#include <QtTest>") << true;
    QTest::newRow("old name") << QStringLiteral("#include \"qglobal.h\"") << true;
    QTest::newRow("standard library") << QStringLiteral("#include <queue>") << false;
    QTest::newRow("comment") << QStringLiteral("// #include <QString>") << false;
  }
  void coreKnowsNoQt() {
    QFETCH(QString, line);
    QFETCH(bool, found);
    QCOMPARE(checkNoQtInCore({{QStringLiteral("core/base/a.h"), line}}).isEmpty(), !found);
    QVERIFY(checkNoQtInCore({{QStringLiteral("core/opcua/qt/a.h"), line}}).isEmpty());
    QVERIFY(checkNoQtInCore({{QStringLiteral("widgets/a.h"), line}}).isEmpty());
  }

  void everyTextSourceNamesItsLicence_data() {
    QTest::addColumn<QString>("path");
    QTest::newRow("source") << QStringLiteral("widgets/common/a.cpp");
    QTest::newRow("CMake") << QStringLiteral("core/CMakeLists.txt");
    QTest::newRow("script") << QStringLiteral("scripts/test");
    QTest::newRow("check") << QStringLiteral(".ci/run");
  }
  void everyTextSourceNamesItsLicence() {
    QFETCH(QString, path);
    const QString tag = QStringLiteral("// SPDX-");
    const QString copyright = tag + QStringLiteral("FileCopyrightText: 2026 Somebody\n");
    const QString licence = tag + QStringLiteral("License-Identifier: GPL-3.0-or-later\n");
    QVERIFY(checkSpdx({{path, copyright + licence}}).isEmpty());
    QCOMPARE(checkSpdx({{path, licence}}).size(), 1);
    QCOMPARE(checkSpdx({{path, copyright}}).size(), 1);
    QCOMPARE(checkSpdx({{path, QString(10, u'\n') + copyright + licence}}).size(), 1);
  }

  void aHeaderHasPragmaOnce() {
    QVERIFY(checkPragmaOnce({file("core/base/a.h", "// why\n#pragma once\n")}).isEmpty());
    QVERIFY(checkPragmaOnce({file("core/base/a.cpp", "int a;\n")}).isEmpty());
    QCOMPARE(places(checkPragmaOnce({file("widgets/a.h", "// #pragma once\nint a;\n")})),
             QStringList{QStringLiteral("widgets/a.h:1")});
  }

  void jsonIsWrittenOfAnyText() {
    QCOMPARE(
        checkJsonText({file("app/cli/a.cpp", "f(json.dump(2) + x);\ng(json.dump());\n")}).size(),
        2);
    QVERIFY(
        checkJsonText({file("app/cli/a.cpp", "json.dump(2, ' ', false, replace);\n")}).isEmpty());
  }

  void numbersAreReadAlikeEverywhere() {
    QCOMPARE(places(checkNumbersOfAllLocales(
                 {file("tests/a/tst_a.cpp", "// std::stod(a)\nx = std::stod(a);\n"),
                  file("examples/b.cpp", "std::sscanf(a, \"%lf\", &x);\ny = strtod(a, nullptr);\n"),
                  file("core/c.cpp", "x = std::stoi(a) + *parseNumber(b) + custod(c);\n")})),
             (QStringList{QStringLiteral("tests/a/tst_a.cpp:2"), QStringLiteral("examples/b.cpp:1"),
                          QStringLiteral("examples/b.cpp:2")}));
  }

  void bannedWords_data() {
    QTest::addColumn<QString>("code");
    QTest::addColumn<bool>("inCore");
    QTest::addColumn<bool>("atTheEdge");
    const auto row = [](const char* code, bool inCore, bool atTheEdge) {
      QTest::newRow(code) << QString::fromUtf8(code) << inCore << atTheEdge;
    };
    row("std::chrono::steady_clock::now();", true, false);
    row("using Clock = std::chrono::system_clock;", true, false);
    row("nanosleep(&a, nullptr);", true, false);
    row("std::this_thread::sleep_for(1ms);", true, true);
    row("int a = rand();", true, true);
    row("std::srand (1);", true, true);
    row("std::thread t;", true, true);
    row("std::jthread t;", true, true);
    row("std::getenv(\"HOME\");", true, true);
    row("operand(1); strand(2);", false, false);
    row("// steady_clock\n/* rand() */ auto a = \"std::thread\";", false, false);
    row("std::this_thread::yield();", false, false);
  }
  void bannedWords() {
    QFETCH(QString, code);
    QFETCH(bool, inCore);
    QFETCH(bool, atTheEdge);
    QCOMPARE(!checkBannedWords({{QStringLiteral("core/base/a.cpp"), code}}).isEmpty(), inCore);
    for (const char* edge : {"core/opcua/open62541/a.cpp", "core/machine/front/a.cpp"}) {
      QCOMPARE(!checkBannedWords({{QString::fromUtf8(edge), code}}).isEmpty(), atTheEdge);
    }
    QVERIFY(checkBannedWords({{QStringLiteral("app/session/a.cpp"), code}}).isEmpty());
  }

  void everyEquationHasItsTestAndEveryTestItsEquation() {
    const Source code =
        file("core/feasibility/equations.h",
             "/// @source [P9] eq. (1)\nint a();\n/// pure.  @source [P9] eq. (3), (12)\n"
             "/// @source [P9] VI.A\n");
    const Source tests =
        file("tests/feasibility/tst_equations.cpp",
             "void marginP9_eq_1Holds() {}\n  void P9_eq_3() {}\n void xP9_eq_12() {}\n");
    QVERIFY(checkEquationTags({code, tests}).isEmpty());
    QCOMPARE(places(checkEquationTags({code})),
             QStringList({QStringLiteral("core/feasibility/equations.h:1"),
                          QStringLiteral("core/feasibility/equations.h:3"),
                          QStringLiteral("core/feasibility/equations.h:3")}));
    QCOMPARE(places(checkEquationTags({tests})).size(), 3);
    const Source other =
        file("tests/a/tst_a.cpp", "\nvoid onlyInAString() { f(\"void P9_eq_1()\"); }\n");
    QCOMPARE(checkEquationTags({code, other}).size(), 3);
  }

  void coreDoesNotTranslate() {
    const char* const text = "auto a = tr(\"x\"); ptr(1); attr(2);\n";
    QCOMPARE(checkNoTranslationInCore({file("core/base/a.cpp", text)}).size(), 1);
    QVERIFY(checkNoTranslationInCore({file("widgets/a.cpp", text)}).isEmpty());
    QVERIFY(checkNoTranslationInCore({file("core/base/a.cpp", "ptr(1); // tr(x)\n")}).isEmpty());
  }

  void noFileNamesAFolderOfOneMachine_data() {
    QTest::addColumn<QString>("line");
    QTest::addColumn<bool>("found");
    QTest::newRow("work") << QStringLiteral("auto a = \"/work/main\";") << true;
    QTest::newRow("root") << QStringLiteral("# see /root/x") << true;
    QTest::newRow("home") << QStringLiteral("cd /home/me") << true;
    QTest::newRow("tmp") << QStringLiteral("> /tmp/log") << true;
    QTest::newRow("relative") << QStringLiteral("frame/work/x ${A}/tmp/ https://a.b/root/")
                              << false;
    QTest::newRow("word") << QStringLiteral("N/A, and/or /working") << false;
  }
  void noFileNamesAFolderOfOneMachine() {
    QFETCH(QString, line);
    QFETCH(bool, found);
    QCOMPARE(!checkNoMachinePaths({{QStringLiteral("docs/a.md"), line}}).isEmpty(), found);
    QVERIFY(checkNoMachinePaths({{QStringLiteral("tests/a.cpp"), line}}).isEmpty());
  }

  void nothingKeepsTheMouseFromStop() {
    const QString code = QStringLiteral(
        "QFileDialog::getOpenFileName(this);\nQMessageBox::about(this, a, b);\n"
        "dialog->setModal(true);\ndialog->exec();\ndialog->open();\n"
        "dialog->setModal(false);\nfile->open(QIODevice::ReadOnly);\nQMessageBox::Cancel;\n");
    QStringList expected;
    for (int line = 1; line <= 5; ++line) {
      expected.append(QStringLiteral("widgets/a.cpp:%1").arg(line));
    }
    QCOMPARE(places(checkNothingModal({{QStringLiteral("widgets/a.cpp"), code}})), expected);
    QCOMPARE(checkNothingModal({{QStringLiteral("app/hmi/pages/a.cpp"), code}}).size(), 5);
    QVERIFY(checkNothingModal({{QStringLiteral("tests/a.cpp"), code}}).isEmpty());
  }

  void aFunctionOf81LinesIsNamed_data() {
    QTest::addColumn<QString>("head");
    QTest::addColumn<QString>("name");
    const auto row = [](const char* head, const char* name) {
      QTest::newRow(head) << QString::fromUtf8(head) << QString::fromUtf8(name);
    };
    row("void move() {", "move");
    row("std::array<int, 3> Axis::at(int i = {}) const noexcept {", "Axis::at");
    row("Axis::Axis(int i) : Base{i}, m_i(i) {", "Axis::Axis");
    row("bool operator==(Axis a, Axis b) {", "operator==");
    row("template <class T> [[nodiscard]] auto of(T t) -> T::Type {", "of");
    row("namespace a { struct B final : C<int> { public: explicit B(int i) {", "B");
    row("const auto kA = f({1}); enum class E { A }; int g() {", "g");
  }
  void aFunctionOf81LinesIsNamed() {
    QFETCH(QString, head);
    QFETCH(QString, name);
    const auto check = [&](int lines, const QString& path) {
      return checkSizes({{path, QStringLiteral("#define A {\\\n{\nint before;\n") + head +
                                    QString(lines - 1, u'\n') + u'}'}});
    };
    QVERIFY(check(80, QStringLiteral("core/a.cpp")).isEmpty());
    const Findings findings = check(81, QStringLiteral("core/a.cpp"));
    QCOMPARE(places(findings), QStringList{QStringLiteral("core/a.cpp:4")});
    QVERIFY2(findings[0].message.startsWith(name + QStringLiteral(" has 81 lines")),
             qPrintable(findings[0].message));
    QVERIFY(check(81, QStringLiteral("tests/a.cpp")).isEmpty());
  }

  void aClassOf31MembersIsNamed() {
    // One each; none; three.
    const QString members = QStringLiteral(
        "int m_a = f({1, 2});\nstd::map<int, T> m_b{{1, 2}};\nvoid (*m_run)(int, int);\n"
        "std::function<void(int, int)> m_c;\nstruct { int i; } m_d;\n");
    const QString others = QStringLiteral(
        "Q_OBJECT\npublic:\nusing X = int;\nclass Y;\nfriend class Z;\nenum E { A, B };\n"
        "A() : m_a{1} { int local; }\nvoid f(int a, int b) const;\nint g() { return 1; }\n"
        "friend bool operator<(A a, A b);\nstatic_assert(true);\nint x, y = 1, z;\n");
    const auto check = [&](int more, const QString& name) {
      return checkSizes(
          {{QStringLiteral("core/nc/modal/state.h"),
            QStringLiteral("class %1 final : public B {\n").arg(name) + others + members +
                QStringLiteral("int m_i;\n").repeated(more) + QStringLiteral("};\n")}});
    };
    QVERIFY(check(22, QStringLiteral("Axis")).isEmpty());
    const Findings findings = check(23, QStringLiteral("Axis"));
    QCOMPARE(places(findings), QStringList{QStringLiteral("core/nc/modal/state.h:1")});
    QVERIFY2(findings[0].message.startsWith(u"Axis has 31 data members"),
             qPrintable(findings[0].message));
    QVERIFY(check(23, QStringLiteral("ModalState")).isEmpty());
    QCOMPARE(check(23, QStringLiteral("Outer::Inner")).size(), 1);
  }

  void coreUsesNoTerminal() {
    QCOMPARE(places(checkNoIostreamInCore({file("core/base/a.cpp", "\n#include <iostream>\n")})),
             QStringList{QStringLiteral("core/base/a.cpp:2")});
    QVERIFY(checkNoIostreamInCore({file("app/cli/main.cpp", "#include <iostream>\n")}).isEmpty());
    QVERIFY(checkNoIostreamInCore({file("core/base/a.cpp", "#include <ostream>\n")}).isEmpty());
  }

  void aFindingReadsLikeACompilersMessage() {
    const Finding finding{QStringLiteral("core/a.h"), 7, QStringLiteral("do this")};
    QCOMPARE(finding.text(), QStringLiteral("core/a.h:7: do this"));
  }
};

RIVULET_TEST(TestTidyRules)
#include "tst_tidy_rules.moc"
