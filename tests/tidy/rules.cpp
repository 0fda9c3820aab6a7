// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "rules.h"

#include <QMap>
#include <QRegularExpression>
#include <QSet>
#include <algorithm>

namespace rivulet::tidy {

namespace {

using Matches = QRegularExpressionMatchIterator;

[[nodiscard]] QRegularExpression pattern(const QString& text) {
  return QRegularExpression(text, QRegularExpression::MultilineOption);
}

[[nodiscard]] int lineOf(const QString& text, qsizetype offset) {
  return static_cast<int>(QStringView(text).left(offset).count(u'\n')) + 1;
}

[[nodiscard]] bool isCpp(const QString& path) {
  return path.endsWith(u".h") || path.endsWith(u".cpp");
}

[[nodiscard]] bool isCore(const Source& source) {
  return isCpp(source.path) && source.path.startsWith(u"core/");
}

/// One #include line.
struct Include {
  QString path;
  bool quoted;
  int line;
};

[[nodiscard]] QList<Include> includes(const Source& source) {
  static const QRegularExpression form =
      pattern(QStringLiteral(R"re(^[ \t]*#[ \t]*include[ \t]*(["<])([^">\n]+)[">])re"));
  const QString code = codeOnly(source.text, true);
  QList<Include> found;
  for (Matches match = form.globalMatch(code); match.hasNext();) {
    const QRegularExpressionMatch one = match.next();
    found.append({one.captured(2), one.captured(1) == u"\"", lineOf(code, one.capturedStart(1))});
  }
  return found;
}

/// The module a file below core belongs to: the one with the longest folder it lies in.
[[nodiscard]] const Module* moduleOf(const QList<Module>& all, QStringView pathBelowCore) {
  const Module* best = nullptr;
  for (const Module& module : all) {
    const bool inside = pathBelowCore.startsWith(module.folder) &&
                        pathBelowCore.mid(module.folder.size(), 1) == u"/";
    if (inside && (best == nullptr || module.folder.size() > best->folder.size())) {
      best = &module;
    }
  }
  return best;
}

/// Reports each match of `form` in the code of the C++ sources that `isMeant` chooses by their
/// path.
template <class IsMeant>
[[nodiscard]] Findings findInCode(const Sources& sources, const QRegularExpression& form,
                                  const QString& message, IsMeant isMeant) {
  Findings findings;
  for (const Source& source : sources) {
    if (!isCpp(source.path) || !isMeant(source.path)) {
      continue;
    }
    const QString code = codeOnly(source.text);
    for (Matches match = form.globalMatch(code); match.hasNext();) {
      findings.append({source.path, lineOf(code, match.next().capturedStart()), message});
    }
  }
  return findings;
}

/// The same in core.
template <class Allowed>
[[nodiscard]] Findings findInCoreCode(const Sources& sources, const QRegularExpression& form,
                                      const QString& message, Allowed allowed) {
  return findInCode(sources, form, message, [&allowed](const QString& path) {
    return path.startsWith(u"core/") && !allowed(path);
  });
}

/// A cycle of modules through `folder`, as "a > b > a"; empty if there is none.
[[nodiscard]] QString cycleThrough(const QString& folder, const QMap<QString, QStringList>& edges) {
  QMap<QString, QString> cameFrom;
  QStringList open{folder};
  while (!open.isEmpty()) {
    const QString current = open.takeFirst();
    for (const QString& next : edges.value(current)) {
      if (next == folder) {
        QStringList way{folder};
        for (QString step = current; step != folder; step = cameFrom.value(step)) {
          way.prepend(step);
        }
        way.prepend(folder);
        return way.join(QStringLiteral(" > "));
      }
      if (!cameFrom.contains(next)) {
        cameFrom.insert(next, current);
        open.append(next);
      }
    }
  }
  return {};
}

}  // namespace

QString codeOnly(const QString& text, bool keepStrings) {
  static const QRegularExpression rawStart(
      QStringLiteral(R"re(\G(?:u8|[uUL])?R"([^ ()\\\t\n]*)\()re"));
  QString code = text;
  const qsizetype size = text.size();
  const auto blank = [&](qsizetype from, qsizetype to) {
    for (qsizetype i = from; i < std::min(to, size); ++i) {
      if (code[i] != u'\n') {
        code[i] = u' ';
      }
    }
  };
  const auto isWord = [](QChar c) { return c.isLetterOrNumber() || c == u'_'; };

  qsizetype i = 0;
  while (i < size) {
    const QChar c = text[i];
    const QChar next = i + 1 < size ? text[i + 1] : QChar();
    if (c == u'/' && (next == u'/' || next == u'*')) {
      const bool line = next == u'/';
      qsizetype end = text.indexOf(line ? QStringLiteral("\n") : QStringLiteral("*/"), i + 2);
      end = end < 0 ? size : (line ? end : end + 2);
      blank(i, end);
      i = end;
    } else if (c == u'"') {
      qsizetype end = i + 1;
      while (end < size && text[end] != u'"' && text[end] != u'\n') {
        end += text[end] == u'\\' ? 2 : 1;
      }
      if (!keepStrings) {
        blank(i + 1, end);
      }
      i = end + 1;
    } else if (c == u'\'') {
      qsizetype end = i + 1;
      while (end < size && text[end] != u'\'' && text[end] != u'\n') {
        end += text[end] == u'\\' ? 2 : 1;
      }
      if (!keepStrings) {
        blank(i + 1, end);
      }
      i = end + 1;
    } else if (isWord(c)) {
      // A raw string's prefix is a word; so is a number, whose ' separates digits.
      const QRegularExpressionMatch raw = rawStart.match(text, i, QRegularExpression::NormalMatch);
      if (raw.hasMatch()) {
        const QString close = u')' + raw.captured(1) + u'"';
        qsizetype end = text.indexOf(close, raw.capturedEnd());
        end = end < 0 ? size : end;
        if (!keepStrings) {
          blank(raw.capturedEnd(), end);
        }
        i = end + close.size();
      } else {
        const bool number = c.isDigit();
        while (i < size && (isWord(text[i]) || (number && text[i] == u'\''))) {
          ++i;
        }
      }
    } else {
      ++i;
    }
  }
  return code;
}

QList<Module> modules(const Sources& sources) {
  static const QRegularExpression call =
      pattern(QStringLiteral(R"re(\brivulet_add_module\s*\(([^)]*)\))re"));
  static const QRegularExpression comment = pattern(QStringLiteral("#[^\n]*"));
  static const QRegularExpression blanks(QStringLiteral(R"re([\s"]+)re"));
  QList<Module> found;
  for (const Source& source : sources) {
    if (!source.path.startsWith(u"core/") || !source.path.endsWith(u"CMakeLists.txt")) {
      continue;
    }
    QString text = source.text;
    text.remove(comment);  // up to the line end, so lines keep their numbers
    for (Matches match = call.globalMatch(text); match.hasNext();) {
      const QRegularExpressionMatch one = match.next();
      const QStringList words = one.captured(1).split(blanks, Qt::SkipEmptyParts);
      if (words.isEmpty()) {
        continue;
      }
      Module module{words.first(), source.path, lineOf(text, one.capturedStart()), {}, {}};
      QString section;
      for (const QString& word : words.mid(1)) {
        if (word == u"SOURCES" || word == u"PUBLIC" || word == u"PRIVATE") {
          section = word;
        } else if (word.startsWith(u"rivulet::") && section != u"SOURCES") {
          QString folder = word.mid(static_cast<qsizetype>(sizeof("rivulet::")) - 1);
          folder.replace(QStringLiteral("::"), QStringLiteral("/"));
          (section == u"PUBLIC" ? module.publicModules : module.privateModules).append(folder);
        }
      }
      found.append(module);
    }
  }
  return found;
}

Findings checkEdges(const Sources& sources) {
  const QList<Module> all = modules(sources);
  QMap<QString, QStringList> edges;
  Findings findings;
  for (const Module& module : all) {
    edges.insert(module.folder, module.publicModules + module.privateModules);
  }
  for (const Module& module : all) {
    const QString cycle = cycleThrough(module.folder, edges);
    if (!cycle.isEmpty()) {
      findings.append({module.path, module.line,
                       QStringLiteral("the modules depend on each other in a circle (%1); move "
                                      "what they share to the folder nearer to base")
                           .arg(cycle)});
    }
  }
  for (const Source& source : sources) {
    if (!isCore(source)) {
      continue;
    }
    const Module* own = moduleOf(all, QStringView(source.path).mid(5));
    if (own == nullptr) {
      findings.append({source.path, 1,
                       QStringLiteral("no rivulet_add_module names this folder; add its "
                                      "CMakeLists.txt")});
      continue;
    }
    for (const Include& include : includes(source)) {
      if (!include.quoted) {
        continue;
      }
      if (!include.path.contains(u'/')) {
        // resources/embed.cmake generates one header per namespace, beside the build.
        if (!include.path.endsWith(u"_texts.h")) {
          findings.append({source.path, include.line,
                           QStringLiteral("\"%1\" is included by its name alone; include it by "
                                          "path from core")
                               .arg(include.path)});
        }
        continue;
      }
      const Module* other = moduleOf(all, include.path);
      if (other == nullptr) {
        findings.append({source.path, include.line,
                         QStringLiteral("\"%1\" lies in no core module; libraries are included "
                                        "with <>")
                             .arg(include.path)});
        continue;
      }
      if (other == own) {
        continue;
      }
      QString alias = other->folder;
      alias.replace(QStringLiteral("/"), QStringLiteral("::"));
      const bool isPublic = own->publicModules.contains(other->folder);
      const bool isPrivate = own->privateModules.contains(other->folder);
      if (!isPublic && !isPrivate) {
        findings.append({source.path, include.line,
                         QStringLiteral("\"%1\" is used without an edge; add rivulet::%2 to the "
                                        "PUBLIC list in %3, or do without it")
                             .arg(include.path, alias, own->path)});
      } else if (!isPublic && source.path.endsWith(u".h")) {
        findings.append({source.path, include.line,
                         QStringLiteral("a header hands \"%1\" on to those who include it; move "
                                        "rivulet::%2 from PRIVATE to PUBLIC in %3")
                             .arg(include.path, alias, own->path)});
      }
    }
  }
  return findings;
}

Findings checkNoQtInCore(const Sources& sources) {
  static const QRegularExpression qt(
      QStringLiteral(R"re(^(?:Q[A-Z]\w*|Qt[A-Z]?\w*(?:/.*)?|q[a-z]+\.h)$)re"));
  Findings findings;
  for (const Source& source : sources) {
    if (!isCore(source) || source.path.startsWith(u"core/opcua/qt/")) {
      continue;
    }
    for (const Include& include : includes(source)) {
      if (qt.match(include.path).hasMatch()) {
        findings.append({source.path, include.line,
                         QStringLiteral("core knows no Qt, but <%1> is included; use the standard "
                                        "library, or move the code to widgets or app")
                             .arg(include.path)});
      }
    }
  }
  return findings;
}

Findings checkSpdx(const Sources& sources) {
  static const QRegularExpression scripts(QStringLiteral(R"re(^(?:scripts|\.ci)/[^/.]+$)re"));
  // The two lines are put together here, for a licence checker reads this file as well.
  static const QString tag = QStringLiteral("SPDX-");
  static const QRegularExpression copyright(tag +
                                            QStringLiteral(R"re(FileCopyrightText: \d{4} \S)re"));
  static const QRegularExpression licence(tag + QStringLiteral(R"re(License-Identifier: \S)re"));
  Findings findings;
  for (const Source& source : sources) {
    const bool checked = isCpp(source.path) || source.path.endsWith(u"CMakeLists.txt") ||
                         source.path.endsWith(u".cmake") || scripts.match(source.path).hasMatch();
    if (!checked) {
      continue;
    }
    const QString head = source.text.section(u'\n', 0, 4);
    if (!copyright.match(head).hasMatch() || !licence.match(head).hasMatch()) {
      findings.append({source.path, 1,
                       QStringLiteral("the first lines do not name copyright and licence; start "
                                      "with the two SPDX lines of the other files")});
    }
  }
  return findings;
}

Findings checkPragmaOnce(const Sources& sources) {
  static const QRegularExpression once = pattern(QStringLiteral(R"re(^#pragma once$)re"));
  Findings findings;
  for (const Source& source : sources) {
    if (source.path.endsWith(u".h") && !once.match(codeOnly(source.text)).hasMatch()) {
      findings.append({source.path, 1,
                       QStringLiteral("the header can be included twice; put #pragma once before "
                                      "its first include")});
    }
  }
  return findings;
}

Findings checkJsonText(const Sources& sources) {
  static const QRegularExpression bare = pattern(QStringLiteral(R"re(\.dump\(\s*-?\d*\s*\))re"));
  return findInCode(sources, bare,
                    QStringLiteral("text that is no UTF-8 would end the program; give dump "
                                   "error_handler_t::replace"),
                    [](const QString& path) {
                      return path.startsWith(u"core/") || path.startsWith(u"app/") ||
                             path.startsWith(u"widgets/");
                    });
}

Findings checkNumbersOfAllLocales(const Sources& sources) {
  static const QRegularExpression reader(
      QStringLiteral(R"re(\b(?:sto(?:d|f|ld)|strto(?:d|f|ld)|atof|v?[fs]?scanf)\s*\()re"));
  return findInCode(sources, reader,
                    QStringLiteral("reads no decimal point where the locale has a comma; use "
                                   "base::parseNumber or std::from_chars"),
                    [](const QString&) { return true; });
}

Findings checkOwnHeaderFirst(const Sources& sources) {
  static const QRegularExpression include =
      pattern(QStringLiteral(R"re(^#include [<"]([^>"]+)[>"])re"));
  QSet<QString> headers;
  for (const Source& source : sources) {
    if (source.path.endsWith(u".h")) {
      headers.insert(source.path);
    }
  }
  Findings findings;
  for (const Source& source : sources) {
    const bool checked = source.path.endsWith(u".cpp") &&
                         (source.path.startsWith(u"core/") || source.path.startsWith(u"widgets/"));
    const QString header = source.path.chopped(4) + QStringLiteral(".h");
    if (!checked || !headers.contains(header)) {
      continue;
    }
    const QString first = include.match(codeOnly(source.text, true)).captured(1);
    if (first != header && first != header.section(u'/', 1)) {
      findings.append({source.path, 1,
                       QStringLiteral("the first include is not the header of the same name; put "
                                      "it first, which shows that it compiles alone")});
    }
  }
  return findings;
}

Findings checkBannedWords(const Sources& sources) {
  const auto readsTheWorld = [](const QString& path) {
    return path.startsWith(u"core/opcua/open62541/") || path.startsWith(u"core/machine/front/");
  };
  const auto nowhere = [](const QString&) { return false; };

  static const QRegularExpression clocks(QStringLiteral(
      R"re(\b(?:steady_clock|system_clock|high_resolution_clock|clock_gettime|nanosleep)\b)re"));
  Findings findings = findInCoreCode(
      sources, clocks,
      QStringLiteral("core reads no clock and does not sleep; take the time as an argument, or "
                     "ask the Link (now, wait)"),
      readsTheWorld);
  static const QRegularExpression sleeps(
      QStringLiteral(R"re(\b(?:sleep_for|sleep_until|usleep)\b)re"));
  findings += findInCoreCode(
      sources, sleeps,
      QStringLiteral("core does not sleep; wait for an event with a deadline instead"), nowhere);
  static const QRegularExpression threads(
      QStringLiteral(R"re(\bstd\s*::\s*(?:j?thread|async)\b)re"));
  findings += findInCoreCode(sources, threads,
                             QStringLiteral("core starts no thread; threads belong to app/session"),
                             nowhere);
  static const QRegularExpression random(
      QStringLiteral(R"re(\b(?:s?rand\s*\(|random_device\b))re"));
  findings += findInCoreCode(
      sources, random, QStringLiteral("random numbers are seeded; draw them from base/random"),
      nowhere);
  static const QRegularExpression environment(QStringLiteral(R"re(\b(?:secure_)?getenv\b)re"));
  findings += findInCoreCode(
      sources, environment,
      QStringLiteral("core reads no environment; take the value as an argument"), nowhere);
  return findings;
}

Findings checkEquationTags(const Sources& sources) {
  static const QRegularExpression tag(QStringLiteral(
      R"re(@source\s+\[(P\d+)\]\s+eqs?\.\s*(\(\d+\)(?:(?:,\s*|\s+and\s+)\(\d+\))*))re"));
  static const QRegularExpression number(QStringLiteral(R"re(\d+)re"));
  static const QRegularExpression test(QStringLiteral(R"re(\bvoid\s+\w*?(P\d+_eq_\d+)\w*\s*\()re"));
  QMap<QString, Finding> tagged;
  QMap<QString, Finding> tested;
  for (const Source& source : sources) {
    if (isCore(source)) {
      for (Matches match = tag.globalMatch(source.text); match.hasNext();) {
        const QRegularExpressionMatch one = match.next();
        for (Matches n = number.globalMatch(one.captured(2)); n.hasNext();) {
          const QString name = QStringLiteral("%1_eq_%2").arg(one.captured(1), n.next().captured());
          tagged.insert(name, {source.path, lineOf(source.text, one.capturedStart()),
                               QStringLiteral("the equation has no test; write a test function "
                                              "with %1 in its name")
                                   .arg(name)});
        }
      }
    } else if (isCpp(source.path) && source.path.startsWith(u"tests/")) {
      const QString code = codeOnly(source.text);
      for (Matches match = test.globalMatch(code); match.hasNext();) {
        const QRegularExpressionMatch one = match.next();
        const QString name = one.captured(1);
        tested.insert(name, {source.path, lineOf(code, one.capturedStart()),
                             QStringLiteral("no @source tag in core names the equation %1; correct "
                                            "the test's name or tag the function it tests")
                                 .arg(name)});
      }
    }
  }
  Findings findings;
  for (auto one = tagged.cbegin(); one != tagged.cend(); ++one) {
    if (!tested.contains(one.key())) {
      findings.append(one.value());
    }
  }
  for (auto one = tested.cbegin(); one != tested.cend(); ++one) {
    if (!tagged.contains(one.key())) {
      findings.append(one.value());
    }
  }
  return findings;
}

Findings checkNoTranslationInCore(const Sources& sources) {
  static const QRegularExpression translation(QStringLiteral(
      R"re(\b(?:tr|QT_TR_NOOP|QT_TRANSLATE_NOOP|QCoreApplication::translate)\s*\()re"));
  return findInCoreCode(
      sources, translation,
      QStringLiteral("core does not speak to the user; return a code, and let widgets/common "
                     "make a sentence of it"),
      [](const QString&) { return false; });
}

Findings checkNoMachinePaths(const Sources& sources) {
  static const QRegularExpression path(
      // LinuxCNC has its lock there on each machine.
      QStringLiteral(R"re((?<![\w.})>/~-])/(?:work|root|home|tmp)/(?!linuxcnc\.lock))re"));
  Findings findings;
  for (const Source& source : sources) {
    if (source.path.startsWith(u"tests/")) {
      continue;
    }
    for (Matches match = path.globalMatch(source.text); match.hasNext();) {
      findings.append({source.path, lineOf(source.text, match.next().capturedStart()),
                       QStringLiteral("a path of one machine; derive it from an argument, the "
                                      "source folder or mktemp")});
    }
  }
  return findings;
}

Findings checkNothingModal(const Sources& sources) {
  static const QRegularExpression modal(QStringLiteral(
      R"re(\bQ(?:File|Input|Color|Font)Dialog::get|\bQMessageBox::(?:about|question|warning|information|critical)\b|\bsetWindowModality\b|\bsetModal\(true|\w*(?:[dD]ialog|box|menu|sheet)(?:->|\.)(?:exec|open)\(\)|\bnew QFileDialog\b)re"));
  return findInCode(sources, modal,
                    QStringLiteral("a modal window keeps the mouse from Stop; ask with openSheet, "
                                   "askForFile or askWhereToSave"),
                    [](const QString& path) {
                      return path.startsWith(u"app/hmi/") || path.startsWith(u"widgets/");
                    });
}

Findings checkNoIostreamInCore(const Sources& sources) {
  Findings findings;
  for (const Source& source : sources) {
    if (!isCore(source)) {
      continue;
    }
    for (const Include& include : includes(source)) {
      if (include.path == u"iostream") {
        findings.append({source.path, include.line,
                         QStringLiteral("core neither prints nor reads a terminal; return the "
                                        "value, and let app print it")});
      }
    }
  }
  return findings;
}

}  // namespace rivulet::tidy
