// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Whether a port answers, over real sockets.

#include <QSignalSpy>
#include <QTcpServer>
#include <QTest>

#include "session/port_check.h"
#include "support/test_program.h"

using namespace rivulet;

class TestPortCheck : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void saysWhetherSomethingAnswers() {
    QTcpServer server;
    QVERIFY(server.listen(QHostAddress::LocalHost));
    const QString endpoint =
        QStringLiteral("opc.tcp://127.0.0.1:%1/machine").arg(server.serverPort());
    session::PortCheck check;
    QSignalSpy looked(&check, &session::PortCheck::looked);
    check.look(endpoint);
    check.look(endpoint);  // that one is in progress
    QTRY_COMPARE(looked.size(), 1);
    QCOMPARE(looked.front(), (QVariantList{endpoint, true}));
    server.close();
    check.look(endpoint);
    QTRY_COMPARE(looked.size(), 2);
    QCOMPARE(looked.back(), (QVariantList{endpoint, false}));
    check.look(QStringLiteral("no address"));
    QTRY_COMPARE(looked.size(), 3);
    QCOMPARE(looked.back().at(1), QVariant(false));
  }
};

RIVULET_TEST(TestPortCheck)
#include "tst_port_check.moc"
