// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Datagrams of a live source, over the real loopback.

#include <QSignalSpy>
#include <QTest>
#include <QUdpSocket>

#include "session/correction_feed.h"
#include "support/test_program.h"

using namespace rivulet;
using session::CorrectionFeed;

Q_DECLARE_METATYPE(rivulet::base::Vec3)

namespace {

void send(const CorrectionFeed& feed, const QByteArray& datagram) {
  QUdpSocket socket;
  QCOMPARE(socket.writeDatagram(datagram, QHostAddress(QHostAddress::LocalHost), feed.port()),
           static_cast<qint64>(datagram.size()));
}

}  // namespace

class TestCorrectionFeed : public QObject {
  Q_OBJECT

 private slots:
  void valuesArriveAndStay() {
    CorrectionFeed feed;
    QVERIFY(feed.open(0, 600'000));
    QVERIFY(feed.port() != 0 && feed.state().isOpen && !feed.state().hasValue);
    QSignalSpy values(&feed, &CorrectionFeed::valueArrived);
    send(feed, "X 0.01 Y -0.02");
    QTRY_COMPARE(feed.state().valueMm, (base::Vec3{0.01, -0.02, 0.0}));
    send(feed, "{\"z\": 0.03}\n");
    QTRY_COMPARE(feed.state().valueMm, (base::Vec3{0.01, -0.02, 0.03}));
    send(feed, "X 0.5\nX 0.6\nX 0.7");
    QTRY_COMPARE(feed.state().valueMm.x, 0.7);
    QCOMPARE(values.last().at(0).value<base::Vec3>(), (base::Vec3{0.7, -0.02, 0.03}));
    // A datagram that ends in a line ends the line.
    send(feed, "X 0.");
    send(feed, "9 nonsense");
    QTRY_COMPARE(feed.state().unknown, std::size_t{1});
    QCOMPARE(feed.state().valueMm.x, 0.0);
    QVERIFY(feed.state().hasValue && !feed.state().isSilent);
  }

  void silenceIsToldAndChangesNothing() {
    CorrectionFeed feed;
    QVERIFY(feed.open(0, 20));
    QSignalSpy values(&feed, &CorrectionFeed::valueArrived);
    send(feed, "X 0.01");
    QTRY_VERIFY(values.count() == 1);
    QTRY_VERIFY(feed.state().isSilent);
    QVERIFY(feed.state().hasValue);
    QCOMPARE(feed.state().valueMm.x, 0.01);
    QCOMPARE(values.count(), 1);
    feed.open(0, 600'000);
    send(feed, "X 0.02");
    QTRY_VERIFY(values.count() == 2);
    QVERIFY(!feed.state().isSilent);
    feed.forget();
    QVERIFY(feed.state().isOpen && !feed.state().hasValue);
    QCOMPARE(feed.state().valueMm, base::Vec3{});
    feed.close();
    QVERIFY(!feed.state().isOpen && feed.port() == 0);
  }

  void aPortThatIsTakenIsTold() {
    QUdpSocket other;
    QVERIFY(other.bind(QHostAddress(QHostAddress::LocalHost), 0));
    CorrectionFeed feed;
    QVERIFY(!feed.open(other.localPort(), 1000));
    QVERIFY(!feed.state().isOpen);
  }

  /// Whatever comes: no more than a line is kept, and nothing but numbers gets through.
  void rubbishIsLeftOut() {
    CorrectionFeed feed;
    QVERIFY(feed.open(0, 600'000));
    QSignalSpy values(&feed, &CorrectionFeed::valueArrived);
    send(feed, QByteArray(20'000, 'X'));
    send(feed, "X nan\nX inf\nX 1e999\nX\nXYZ\nX 1 X 2\n{\"x\": }\n{}\nX 0,5\n\xff\xfe\n");
    QTRY_COMPARE(feed.state().unknown, std::size_t{11});
    QCOMPARE(values.count(), 0);
    QVERIFY(!feed.state().hasValue);
  }
};

RIVULET_TEST(TestCorrectionFeed)
#include "tst_correction_feed.moc"
