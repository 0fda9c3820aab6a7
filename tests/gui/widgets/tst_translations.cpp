// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Every translation is complete: every text of the sources is in its file, and each one is
// translated, with the same placeholders and keys.

#include <QDir>
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

/// The text of a translation; of one with plural forms the last form.
QString textOf(QXmlStreamReader& xml) {
  QString text;
  QString form;
  for (;;) {
    const QXmlStreamReader::TokenType token = xml.readNext();
    if (token == QXmlStreamReader::StartElement) {
      form = xml.readElementText();
    } else if (token == QXmlStreamReader::Characters) {
      text += xml.text();
    } else {
      return form.isEmpty() ? text : form;
    }
  }
}

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
      messages.last().translation = textOf(xml);
    }
  }
  return messages;
}

/// What the pattern finds, sorted, each once.
QStringList found(const char* pattern, const QString& text) {
  QStringList all;
  for (auto match = QRegularExpression(QLatin1String(pattern)).globalMatch(text);
       match.hasNext();) {
    all.append(match.next().captured());
  }
  all.sort();
  all.removeDuplicates();
  return all;
}

QStringList filesOf(const QString& folder) {
  QStringList paths;
  for (const QFileInfo& file : QDir(folder).entryInfoList({QStringLiteral("*.ts")})) {
    paths.append(file.filePath());
  }
  return paths;
}

QString where(const QString& path, const Message& message) {
  return QStringLiteral("%1: %2: %3 -> %4")
      .arg(QFileInfo(path).baseName(), message.context, message.source, message.translation);
}

const QString kFolder = QStringLiteral(RIVULET_SOURCE_DIR "/translations");

}  // namespace

class TestTranslations : public QObject {
  Q_OBJECT

 private slots:
  void everyTextIsTranslated() {
    QTemporaryDir folder;
    for (const QString& path : filesOf(kFolder)) {
      const QString copy = folder.filePath(QFileInfo(path).fileName());
      QVERIFY(QFile::copy(path, copy));
      QVERIFY(QFile::setPermissions(copy, QFile::ReadOwner | QFile::WriteOwner));
    }
    const QStringList copies = filesOf(folder.path());
    QVERIFY(copies.size() >= 4);
    QProcess update;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("LUPDATE"), QStringLiteral(RIVULET_LUPDATE));
    update.setProcessEnvironment(environment);
    update.start(QStringLiteral(RIVULET_SOURCE_DIR "/scripts/translations"), copies);
    QVERIFY(update.waitForFinished());
    QCOMPARE(update.exitCode(), 0);
    for (const QString& path : copies) {
      const QList<Message> messages = messagesOf(path);
      QVERIFY(messages.size() > (path.endsWith(QLatin1String("_en.ts")) ? 10 : 300));
      for (const Message& message : messages) {
        QVERIFY2(message.isFinished && !message.translation.isEmpty(),
                 qPrintable(where(path, message)));
      }
    }
  }

  void placeholdersAndBreaksAreKept() {
    for (const QString& path : filesOf(kFolder)) {
      for (const Message& message : messagesOf(path)) {
        for (const char* pattern : {"%[\\dp]", "%L?n", "<[^>]*>"}) {
          QVERIFY2(found(pattern, message.source) == found(pattern, message.translation),
                   qPrintable(where(path, message)));
        }
        QVERIFY2(
            message.source.count(QLatin1Char('\n')) == message.translation.count(QLatin1Char('\n')),
            qPrintable(where(path, message)));
      }
    }
  }

  /// A text has a key where the English one has, and no other of its window has the same.
  void keysAreKeptAndUnique() {
    for (const QString& path : filesOf(kFolder)) {
      QMap<QString, QString> textOfKey;
      for (const Message& message : messagesOf(path)) {
        const QStringList keys = found("&\\S", message.translation);
        QVERIFY2(keys.size() == found("&\\S", message.source).size(),
                 qPrintable(where(path, message)));
        for (const QString& key : keys) {
          QString& text = textOfKey[message.context + key.toLower()];
          QVERIFY2(text.isEmpty(), qPrintable(where(path, message) + ", also " + text));
          text = message.translation;
        }
      }
    }
  }
};

RIVULET_TEST(TestTranslations)
#include "tst_translations.moc"
