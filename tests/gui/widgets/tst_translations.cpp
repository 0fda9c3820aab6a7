// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// German is complete: every text of the sources is in the file, and each one is translated.

#include <QFile>
#include <QProcess>
#include <QProcessEnvironment>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

#include "support/test_program.h"

namespace {

struct Message {
  QString context;
  QString source;
  QString translation;
  bool isFinished = true;
};

QList<Message> messagesOf(const QString& path) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) {
    return {};
  }
  QList<Message> messages;
  QXmlStreamReader xml(&file);
  QString context;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) {
      continue;
    }
    if (xml.name() == QLatin1String("name")) {
      context = xml.readElementText();
    } else if (xml.name() == QLatin1String("message")) {
      messages.append({context, {}, {}, true});
    } else if (xml.name() == QLatin1String("source")) {
      messages.last().source = xml.readElementText();
    } else if (xml.name() == QLatin1String("translation")) {
      messages.last().isFinished = !xml.attributes().hasAttribute(QLatin1String("type"));
      messages.last().translation = xml.readElementText();
    }
  }
  return messages;
}

QStringList placeholders(const QString& text) {
  static const QRegularExpression pattern(QStringLiteral("%\\d"));
  QStringList found;
  for (auto match = pattern.globalMatch(text); match.hasNext();) {
    found.append(match.next().captured());
  }
  found.sort();
  found.removeDuplicates();
  return found;
}

}  // namespace

class TestTranslations : public QObject {
  Q_OBJECT

 private slots:
  void germanIsComplete() {
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("rivulet_de.ts"));
    QVERIFY(QFile::copy(QStringLiteral(RIVULET_SOURCE_DIR "/translations/rivulet_de.ts"), path));
    QVERIFY(QFile::setPermissions(path, QFile::ReadOwner | QFile::WriteOwner));
    QProcess update;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("LUPDATE"), QStringLiteral(RIVULET_LUPDATE));
    update.setProcessEnvironment(environment);
    update.start(QStringLiteral(RIVULET_SOURCE_DIR "/scripts/translations"), {path});
    QVERIFY(update.waitForFinished());
    QCOMPARE(update.exitCode(), 0);
    const QList<Message> messages = messagesOf(path);
    QVERIFY(messages.size() > 300);
    for (const Message& message : messages) {
      QVERIFY2(message.isFinished && !message.translation.isEmpty(),
               qPrintable(message.context + ": " + message.source));
    }
  }

  void everyPlaceholderIsKept() {
    for (const Message& message :
         messagesOf(QStringLiteral(RIVULET_SOURCE_DIR "/translations/rivulet_de.ts"))) {
      QVERIFY2(placeholders(message.source) == placeholders(message.translation),
               qPrintable(message.source));
    }
  }
};

RIVULET_TEST(TestTranslations)
#include "tst_translations.moc"
