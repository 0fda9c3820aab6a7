// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The house rules, on the tree as it is.

#include <QDirIterator>
#include <QFile>
#include <QtTest>

#include "rules.h"
#include "support/test_program.h"

using namespace rivulet::tidy;

namespace {

/// Folders of the tree that hold text of ours; a file of the root is named by itself.
const QStringList kFolders{
    QStringLiteral("app"),       QStringLiteral("core"),  QStringLiteral("widgets"),
    QStringLiteral("resources"), QStringLiteral("tests"), QStringLiteral("translations"),
    QStringLiteral("scripts"),   QStringLiteral(".ci"),   QStringLiteral("docs"),
    QStringLiteral("examples"),  QStringLiteral("bench")};
const QStringList kText{QStringLiteral("h"),     QStringLiteral("cpp"), QStringLiteral("txt"),
                        QStringLiteral("cmake"), QStringLiteral("md"),  QStringLiteral("json"),
                        QStringLiteral("toml"),  QStringLiteral("ui"),  QStringLiteral("qrc"),
                        QStringLiteral("qss"),   QStringLiteral("ts"),  QStringLiteral("")};

Sources readTree() {
  const QDir root(QStringLiteral(RIVULET_SOURCE_DIR));
  QStringList paths;
  for (const QFileInfo& info : root.entryInfoList(QDir::Files)) {
    paths.append(info.fileName());
  }
  for (const QString& folder : kFolders) {
    QDirIterator files(root.filePath(folder), QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext()) {
      paths.append(root.relativeFilePath(files.next()));
    }
  }
  paths.sort();
  Sources sources;
  for (const QString& path : paths) {
    QFile file(root.filePath(path));
    if (kText.contains(QFileInfo(path).suffix()) && file.open(QIODevice::ReadOnly)) {
      sources.append({path, QString::fromUtf8(file.readAll())});
    }
  }
  return sources;
}

}  // namespace

class TestTidy : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    m_sources = readTree();
    QVERIFY2(m_sources.size() > 30, "the tree is not where the build says");
    QVERIFY2(!modules(m_sources).isEmpty(), "no rivulet_add_module was found in core");
  }

  void edges() { none(checkEdges(m_sources)); }
  void noQtInCore() { none(checkNoQtInCore(m_sources)); }
  void spdx() { none(checkSpdx(m_sources)); }
  void jsonText() { none(checkJsonText(m_sources)); }
  void numbersOfAllLocales() { none(checkNumbersOfAllLocales(m_sources)); }
  void pragmaOnce() { none(checkPragmaOnce(m_sources)); }
  void ownHeaderFirst() { none(checkOwnHeaderFirst(m_sources)); }
  void bannedWords() { none(checkBannedWords(m_sources)); }
  void equationTags() { none(checkEquationTags(m_sources)); }
  void noTranslationInCore() { none(checkNoTranslationInCore(m_sources)); }
  void noMachinePaths() { none(checkNoMachinePaths(m_sources)); }
  void nothingModal() { none(checkNothingModal(m_sources)); }
  void sizes() { none(checkSizes(m_sources)); }
  void noIostreamInCore() { none(checkNoIostreamInCore(m_sources)); }

 private:
  /// Fails with every finding, not only the first.
  static void none(const Findings& findings) {
    if (findings.isEmpty()) {
      return;
    }
    QStringList lines;
    for (const Finding& finding : findings) {
      lines.append(finding.text());
    }
    const QByteArray text = '\n' + lines.join(u'\n').toUtf8();
    QFAIL(text.constData());
  }

  Sources m_sources;
};

RIVULET_TEST(TestTidy)
#include "tst_tidy.moc"
