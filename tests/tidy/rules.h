// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The house rules as functions from source texts to findings. A rule knows no disk, so that its
/// own tests can hand it small texts that break it; `tst_tidy` hands it the whole tree.
/// @threadsafety pure.
#pragma once

#include <QList>
#include <QString>
#include <QStringList>

namespace rivulet::tidy {

/// One file of the tree.
struct Source {
  QString path;  ///< from the root of the tree, with '/', e.g. "core/base/text.h"
  QString text;
};
using Sources = QList<Source>;

/// One place that breaks a rule.
struct Finding {
  QString path;
  int line;         ///< from 1
  QString message;  ///< what is wrong and what to do

  /// "file:line: message", which editors can jump to.
  [[nodiscard]] QString text() const {
    return QStringLiteral("%1:%2: %3").arg(path).arg(line).arg(message);
  }
};
using Findings = QList<Finding>;

/// `text` with every comment blanked, and what stands in string and character literals too unless
/// `keepStrings`. Line ends stay, so lines keep their numbers.
[[nodiscard]] QString codeOnly(const QString& text, bool keepStrings = false);

/// One call of rivulet_add_module.
struct Module {
  QString folder;              ///< below core, e.g. "machine/front"
  QString path;                ///< the CMakeLists.txt the call stands in
  int line = 0;                ///< of the call
  QStringList publicModules;   ///< folders named as rivulet::… after PUBLIC
  QStringList privateModules;  ///< the same after PRIVATE
};

/// The modules that the CMakeLists.txt files below core define.
[[nodiscard]] QList<Module> modules(const Sources& sources);

/// Each include from one core folder into another has its edge in CMake, a header's edge is
/// PUBLIC, core includes by path from its root, and the edges form no cycle.
[[nodiscard]] Findings checkEdges(const Sources& sources);
/// Core knows no Qt; only core/opcua/qt may.
[[nodiscard]] Findings checkNoQtInCore(const Sources& sources);
/// Each source, CMake file and script names its copyright and licence.
[[nodiscard]] Findings checkSpdx(const Sources& sources);
/// JSON is written with bytes that are no UTF-8 replaced: else a file name or a program in another
/// encoding ends the whole program.
[[nodiscard]] Findings checkJsonText(const Sources& sources);
/// Numbers are read alike in each locale: std::stod and the like take "0,5" for a number where the
/// comma is the decimal point, and "0.5" for 0.
[[nodiscard]] Findings checkNumbersOfAllLocales(const Sources& sources);
/// Each header has `#pragma once`.
[[nodiscard]] Findings checkPragmaOnce(const Sources& sources);
/// A source includes the header of its own name first, so that building it shows that the header
/// compiles alone; headers without a source are built alone by rivulet_header_check.
[[nodiscard]] Findings checkOwnHeaderFirst(const Sources& sources);
/// Core asks no clock, does not sleep, starts no thread, draws no unseeded number and reads no
/// environment; core/opcua/open62541 and core/machine/front may read clocks and sleep.
[[nodiscard]] Findings checkBannedWords(const Sources& sources);
/// Each `@source [Pk] eq. (n)` in core has a test function with `Pk_eq_n` in its name, and the
/// other way round.
[[nodiscard]] Findings checkEquationTags(const Sources& sources);
/// Core does not translate: it hands out codes, widgets and app make sentences of them.
[[nodiscard]] Findings checkNoTranslationInCore(const Sources& sources);
/// No file outside tests names a folder of the machine it was written on.
[[nodiscard]] Findings checkNoMachinePaths(const Sources& sources);
/// Nothing in the window is modal: a question is a sheet in place of the page, so that Stop can be
/// pressed. Only widgets/common/sheet_area makes dialogs of files.
[[nodiscard]] Findings checkNothingModal(const Sources& sources);
/// In core, app and widgets, a function has at most 80 lines, from that of its name to its closing
/// brace, and a class at most 30 data members. What may have more is listed in sizes.cpp.
[[nodiscard]] Findings checkSizes(const Sources& sources);
/// Core neither prints nor reads a terminal: no <iostream>.
[[nodiscard]] Findings checkNoIostreamInCore(const Sources& sources);

}  // namespace rivulet::tidy
