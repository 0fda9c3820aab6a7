// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The languages of the window: which there are, which one the computer gets, and its numbers.

#include <QDir>
#include <QTest>

#include "language/translator.h"
#include "support/test_program.h"

using namespace rivulet::language;

class TestTranslator : public QObject {
  Q_OBJECT

 private slots:
  /// A language without its texts would show English; texts without a language, nothing.
  void everyTranslationIsALanguage() {
    QStringList codes;
    for (const Language& language : languages()) {
      codes.append(language.code);
    }
    QCOMPARE(codes.first(), QStringLiteral("en"));
    codes.sort();
    QStringList files;
    for (const QString& code : codes) {
      files.append(QStringLiteral("rivulet_%1.ts").arg(code));
    }
    const QDir folder(QStringLiteral(RIVULET_SOURCE_DIR "/translations"));
    QCOMPARE(folder.entryList({QStringLiteral("*.ts")}, QDir::Files, QDir::Name), files);
    for (const QString& code : codes) {
      QVERIFY2(QFile::exists(QStringLiteral(":/rivulet/i18n/rivulet_%1.qm").arg(code)),
               qPrintable(code));
    }
  }

  void textsAndNumbersFollow_data() {
    QTest::addColumn<QString>("stop");
    QTest::addColumn<QChar>("point");
    QTest::addRow("en") << QStringLiteral("Stop") << QChar('.');
    QTest::addRow("de") << QStringLiteral("Stopp") << QChar(',');
    QTest::addRow("fr") << QStringLiteral("Arrêt") << QChar(',');
    QTest::addRow("it") << QStringLiteral("Stop") << QChar(',');
    QTest::addRow("es") << QStringLiteral("Parada") << QChar(',');
    QTest::addRow("xx") << QStringLiteral("Stop") << QChar('.');
  }
  void textsAndNumbersFollow() {
    QFETCH(QString, stop);
    QFETCH(QChar, point);
    Translator translator;
    translator.setLanguage(QLatin1String(QTest::currentDataTag()));
    QCOMPARE(QCoreApplication::translate("rivulet::widgets::RunPanel", "Stop"), stop);
    QCOMPARE(QLocale().decimalPoint(), QString(point));
  }

  void oneIsSingular_data() {
    QTest::addColumn<QString>("one");
    QTest::addColumn<QString>("many");
    QTest::addRow("en") << QStringLiteral("1 message") << QStringLiteral("1,200 messages");
    QTest::addRow("de") << QStringLiteral("1 Meldung") << QStringLiteral("1.200 Meldungen");
    QTest::addRow("fr") << QStringLiteral("1 message") << QStringLiteral("1\u202F200 messages");
    QTest::addRow("it") << QStringLiteral("1 messaggio") << QStringLiteral("1.200 messaggi");
    QTest::addRow("es") << QStringLiteral("1 aviso") << QStringLiteral("1200 avisos");
  }
  void oneIsSingular() {
    QFETCH(QString, one);
    QFETCH(QString, many);
    Translator translator;
    translator.setLanguage(QLatin1String(QTest::currentDataTag()));
    const auto text = [](int count) {
      return QCoreApplication::translate("rivulet::widgets::LogView", "%Ln messages", nullptr,
                                         count);
    };
    QCOMPARE(text(1), one);
    QCOMPARE(text(1200), many);
  }

  void theFirstKnownLanguageOfTheSystem_data() {
    QTest::addColumn<QStringList>("wanted");
    QTest::addColumn<QString>("language");
    QTest::newRow("of Quebec") << QStringList{"fr-CA", "fr"} << QStringLiteral("fr");
    QTest::newRow("as in LANG") << QStringList{"it_CH"} << QStringLiteral("it");
    QTest::newRow("of a continent") << QStringList{"es-419"} << QStringLiteral("es");
    QTest::newRow("with a script") << QStringList{"de-Latn-AT"} << QStringLiteral("de");
    QTest::newRow("the second") << QStringList{"pt-BR", "es-ES", "en"} << QStringLiteral("es");
    QTest::newRow("English before") << QStringList{"en-GB", "fr"} << QStringLiteral("en");
    QTest::newRow("unknown") << QStringList{"ja", "fil"} << QStringLiteral("en");
    QTest::newRow("none") << QStringList() << QStringLiteral("en");
  }
  void theFirstKnownLanguageOfTheSystem() {
    QFETCH(QStringList, wanted);
    QFETCH(QString, language);
    QCOMPARE(languageFor(wanted), language);
  }

  /// 1,200 is 1.2 in Spain and 1200 in Mexico.
  void numbersAreThoseOfTheRegion() {
    const QLocale mexico(QLocale::Spanish, QLocale::Mexico);
    QCOMPARE(localeFor(QStringLiteral("es"), mexico).decimalPoint(), QStringLiteral("."));
    QCOMPARE(localeFor(QStringLiteral("fr"), mexico).decimalPoint(), QStringLiteral(","));
    const QLocale spain(QLocale::Spanish, QLocale::Spain);
    QCOMPARE(localeFor(QStringLiteral("es"), spain).decimalPoint(), QStringLiteral(","));
    QCOMPARE(localeFor(QStringLiteral("en"), QLocale::c()).decimalPoint(), QStringLiteral("."));
  }
};

RIVULET_TEST(TestTranslator)
#include "tst_translator.moc"
