// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How long functions are and how much classes keep. A reader of C++ as clang-format leaves it: it
// follows namespaces and classes, and passes over bodies, parentheses and initialisers as a whole.

#include <QMap>
#include <QRegularExpression>

#include "rules.h"

namespace rivulet::tidy {

namespace {

constexpr int kLinesMax = 80;
constexpr int kMembersMax = 30;

/// Classes that may keep more, and why.
const QMap<QString, QString>& largeClasses() {
  static const QMap<QString, QString> all{
      {QStringLiteral("core/nc/modal/state.h:ModalState"),
       QStringLiteral("one member per modal group of a control")},
      {QStringLiteral("core/nc/syntax/language.h:Language"),
       QStringLiteral("one row of the table of dialects")},
      {QStringLiteral("app/service/service_session.h:Snapshot"),
       QStringLiteral("one member per variable of the service")},
      {QStringLiteral("core/job/splitter.cpp:Splitter"),
       QStringLiteral("the state of a program between two of its blocks")},
  };
  return all;
}

[[nodiscard]] bool isMeasured(const QString& path) {
  return (path.endsWith(u".h") || path.endsWith(u".cpp")) &&
         (path.startsWith(u"core/") || path.startsWith(u"app/") || path.startsWith(u"widgets/"));
}

/// The code without preprocessor lines.
[[nodiscard]] QString withoutDirectives(const QString& text) {
  static const QRegularExpression directive(QStringLiteral(R"re(^[ \t]*#(?:[^\n]*\\\n)*[^\n]*)re"),
                                            QRegularExpression::MultilineOption);
  QString code = codeOnly(text);
  for (QRegularExpressionMatchIterator match = directive.globalMatch(code); match.hasNext();) {
    const QRegularExpressionMatch one = match.next();
    for (qsizetype i = one.capturedStart(); i < one.capturedEnd(); ++i) {
      code[i] = code[i] == u'\n' ? u'\n' : u' ';
    }
  }
  return code;
}

/// `text` without what stands between `open` and `close`.
[[nodiscard]] QString without(const QString& text, QChar open, QChar close) {
  QString rest;
  int depth = 0;
  for (const QChar c : text) {
    depth -= c == close && depth > 0 ? 1 : 0;
    if (depth == 0) {
      rest += c;
    }
    depth += c == open ? 1 : 0;
  }
  return rest;
}

class Reader {
 public:
  explicit Reader(const Source& source)
      : m_path(source.path), m_code(withoutDirectives(source.text)) {}

  Findings read() {
    while (m_at < m_code.size()) {
      const QChar c = m_code[m_at];
      if (c == u'(' || c == u'[') {
        skipGroup();
      } else if (c == u'{') {
        open();
      } else if (c == u'}') {
        close();
      } else {
        if (c == u';') {
          endStatement();
        } else if (c == u':' && m_code.mid(m_at + 1, 1) != u":" && isLabel()) {
          m_head = m_at + 1;
        }
        ++m_at;
      }
    }
    return m_findings;
  }

 private:
  struct Scope {
    bool isClass = false;
    QString name;
    int line = 0;
    int members = 0;
  };

  [[nodiscard]] int lineAt(qsizetype at) const {
    return static_cast<int>(QStringView(m_code).left(at).count(u'\n')) + 1;
  }
  [[nodiscard]] QString head() const { return m_code.mid(m_head, m_at - m_head).simplified(); }

  /// From a bracket to behind the one that closes it.
  void skipGroup() {
    int depth = 0;
    do {
      const QChar c = m_code[m_at];
      depth += c == u'(' || c == u'[' || c == u'{' ? 1 : 0;
      depth -= c == u')' || c == u']' || c == u'}' ? 1 : 0;
      ++m_at;
    } while (depth > 0 && m_at < m_code.size());
  }

  [[nodiscard]] bool isLabel() const {
    static const QRegularExpression label(
        QStringLiteral(R"re(\b(?:public|protected|private|Q_SIGNALS)(?: Q_SLOTS)?$)re"));
    return label.match(head()).hasMatch();
  }

  void open() {
    static const QRegularExpression space(
        QStringLiteral(R"re(^(?:inline )?namespace\b|^extern\b)re"));
    static const QRegularExpression type(QStringLiteral(
        R"re((?:^|[>\]] )(?:class|struct|union)\b(?: alignas\([^)]*\)| \[\[[^\]]*\]\])*((?: \w+|::\w+|<.*>)*?)(?: final)?(?: : .*)?$)re"));
    const QString text = head();
    if (space.match(text).hasMatch()) {
      begin({false, {}, 0, 0});
    } else if (const auto found = type.match(text); found.hasMatch()) {
      begin({true, found.captured(1).simplified(), lineAt(m_at), 0});
    } else if (isFunction(text)) {
      function();
    } else {
      skipGroup();  // an initialiser, or the values of an enum
    }
  }

  void begin(Scope scope) {
    m_scopes.append(std::move(scope));
    m_head = ++m_at;
  }

  void close() {
    if (!m_scopes.isEmpty()) {
      const Scope scope = m_scopes.takeLast();
      if (scope.members > kMembersMax && !largeClasses().contains(m_path + u':' + scope.name)) {
        m_findings.append({m_path, scope.line,
                           QStringLiteral("%1 has %2 data members, and %3 are enough; group what "
                                          "changes together, or move a task to a class of its own")
                               .arg(scope.name)
                               .arg(scope.members)
                               .arg(kMembersMax)});
      }
    }
    m_head = ++m_at;
  }

  /// Whether the brace at hand begins a body. @param text  what stands before it
  [[nodiscard]] static bool isFunction(const QString& text) {
    static const QRegularExpression constructor(QStringLiteral(R"re(\)[^:]* : )re"));
    const QString outside = without(text, u'(', u')');
    if (!outside.contains(u"()") || text.startsWith(u"enum")) {
      return false;
    }
    const qsizetype assigned = outside.indexOf(u" = ");
    if (assigned >= 0 && assigned < outside.indexOf(u"()") && !outside.contains(u"operator")) {
      return false;
    }
    // Of a constructor, a brace behind a name initialises it.
    const bool initialises =
        constructor.match(outside).hasMatch() && !text.endsWith(u')') && !text.endsWith(u'}');
    return !initialises;
  }

  void function() {
    static const QRegularExpression named(QStringLiteral(
        R"re(((?:~?\w+(?:<[^()]*>)?::)*(?:operator\s*[^\s\w]+|operator\s+\w+|~?\w+))\s*\()re"));
    static const QStringList notNames{QStringLiteral("decltype"), QStringLiteral("alignas"),
                                      QStringLiteral("explicit"), QStringLiteral("requires")};
    const qsizetype head = m_head;
    const QString text = m_code.mid(m_head, m_at - m_head);
    qsizetype at = m_head;
    QString name;
    for (QRegularExpressionMatchIterator match = named.globalMatch(text);
         match.hasNext() && name.isEmpty();) {
      const QRegularExpressionMatch one = match.next();
      if (!notNames.contains(one.captured(1))) {
        name = one.captured(1);
        at = head + one.capturedStart(1);
      }
    }
    skipGroup();
    const int first = lineAt(at);
    const int lines = lineAt(m_at - 1) - first + 1;
    if (lines > kLinesMax) {
      m_findings.append({m_path, first,
                         QStringLiteral("%1 has %2 lines, and %3 are enough; make a function of a "
                                        "part that has a name, or a table of a long switch")
                             .arg(name)
                             .arg(lines)
                             .arg(kLinesMax)});
    }
    m_head = m_at;
  }

  void endStatement() {
    if (!m_scopes.isEmpty() && m_scopes.last().isClass) {
      m_scopes.last().members += membersIn(head());
    }
    m_head = m_at + 1;
  }

  /// Data members that a declaration makes.
  [[nodiscard]] static int membersIn(QString text) {
    static const QRegularExpression macro(QStringLiteral(R"re(^Q_\w+(?:\([^)]*\))?\s*)re"));
    static const QRegularExpression other(QStringLiteral(
        R"re(^(?:using|typedef|friend|static_assert|template|class|struct|union|enum)\b|\boperator\b)re"));
    static const QRegularExpression pointer(QStringLiteral(R"re(\((?:\w+::)*\*)re"));
    while (macro.match(text).hasMatch()) {
      text.remove(macro);
    }
    if (text.isEmpty() || other.match(text).hasMatch()) {
      return 0;
    }
    const bool isPointer = pointer.match(text).hasMatch();
    const QString outside = without(without(without(text, u'{', u'}'), u'<', u'>'), u'(', u')');
    const QString declared = outside.section(u'=', 0, 0);
    return declared.contains(u'(') && !isPointer
               ? 0
               : 1 + static_cast<int>(isPointer ? 0 : outside.count(u','));
  }

  const QString m_path;
  const QString m_code;
  qsizetype m_at = 0;
  qsizetype m_head = 0;  ///< where the present declaration begins
  QList<Scope> m_scopes;
  Findings m_findings;
};

}  // namespace

Findings checkSizes(const Sources& sources) {
  Findings findings;
  for (const Source& source : sources) {
    if (isMeasured(source.path)) {
      findings += Reader(source).read();
    }
  }
  return findings;
}

}  // namespace rivulet::tidy
