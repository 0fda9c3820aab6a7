// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Every file of the tree says whose it is and under which licence, as REUSE wants it.

#include <QProcess>
#include <QStandardPaths>
#include <QtTest>

#include "support/patience.h"
#include "support/test_program.h"

class TestReuse : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyFileHasItsLicence() {
    const QString program = QStandardPaths::findExecutable(QStringLiteral("reuse"));
    if (program.isEmpty()) {
      QSKIP("the program reuse is not installed (Debian: apt-get install reuse)");
    }
    QProcess reuse;
    reuse.setProcessChannelMode(QProcess::MergedChannels);
    reuse.start(program, {QStringLiteral("--root"), QStringLiteral(RIVULET_SOURCE_DIR),
                          QStringLiteral("lint")});
    QVERIFY2(reuse.waitForFinished(rivulet::tests::kRunMs), qPrintable(reuse.errorString()));
    const QByteArray said = reuse.readAll();
    QVERIFY2(reuse.exitStatus() == QProcess::NormalExit && reuse.exitCode() == 0, said.constData());
  }
};

RIVULET_TEST(TestReuse)
#include "tst_reuse.moc"
