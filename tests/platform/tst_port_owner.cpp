// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "platform/port_owner.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <QTemporaryDir>
#include <QTest>

#include "base/file.h"
#include "support/test_program.h"

using namespace rivulet;
using platform::PortKind;

namespace {

/// A socket on a free port of 127.0.0.1.
class Bound {
 public:
  explicit Bound(int type) : m_socket(::socket(AF_INET, type | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t length = sizeof address;
    auto* const plain = reinterpret_cast<sockaddr*>(&address);
    if (::bind(m_socket, plain, length) != 0 || ::getsockname(m_socket, plain, &length) != 0 ||
        (type == SOCK_STREAM && ::listen(m_socket, 1) != 0)) {
      qFatal("no socket");
    }
    m_port = ntohs(address.sin_port);
  }
  ~Bound() { close(); }
  Bound(const Bound&) = delete;
  Bound& operator=(const Bound&) = delete;

  void close() {
    if (m_socket >= 0) {
      ::close(m_socket);
    }
    m_socket = -1;
  }
  [[nodiscard]] std::uint16_t port() const { return m_port; }

 private:
  int m_socket;
  std::uint16_t m_port = 0;
};

}  // namespace

class TestPortOwner : public QObject {
  Q_OBJECT

  QTemporaryDir m_table;

  [[nodiscard]] std::filesystem::path table() const { return m_table.path().toStdString(); }

 private Q_SLOTS:
  /// The kernel's own list knows what this program has opened.
  void findsItself() {
    const Bound server(SOCK_STREAM);
    const auto owners = platform::ownersOfPort(PortKind::TcpListener, server.port());
    QVERIFY(owners && *owners == std::set<uid_t>{geteuid()});
    QVERIFY(!platform::isPortOfAnother(PortKind::TcpListener, server.port()));
    const Bound socket(SOCK_DGRAM);
    QVERIFY(platform::ownersOfPort(PortKind::Udp, socket.port()) == std::set<uid_t>{geteuid()});
  }

  void nobodyHasAClosedPort() {
    Bound server(SOCK_STREAM);
    server.close();
    QVERIFY(platform::ownersOfPort(PortKind::TcpListener, server.port())->empty());
    QVERIFY(!platform::isPortOfAnother(PortKind::TcpListener, server.port()));
  }

  /// 4840 of user 4242 on IPv4, 4841 of the administrator on IPv6, 4842 is a connection.
  void findsOthers() {
    const std::string head = "  sl  local_address rem_address   st tx_queue rx_queue tr\n";
    const std::string rest = " 00000000:00000000 00:00000000 00000000 ";
    QVERIFY(base::writeFile(table() / "tcp",
                            head + "   0: 0100007F:12E8 00000000:0000 0A" + rest + "4242 0 1 1\n" +
                                "   1: 0100007F:12EA 0100007F:9999 01" + rest + "4242 0 1 1\n"));
    QVERIFY(base::writeFile(table() / "tcp6", head +
                                                  "   0: 00000000000000000000000001000000:12E9 "
                                                  "00000000000000000000000000000000:0000 0A" +
                                                  rest + "0 0 1 1\n"));
    const auto isStrange = [this](int port) {
      return platform::isPortOfAnother(PortKind::TcpListener, static_cast<std::uint16_t>(port),
                                       table());
    };
    QVERIFY(isStrange(4840));
    QVERIFY(!isStrange(4841));
    QVERIFY(!isStrange(4842));
    QVERIFY(platform::ownersOfPort(PortKind::TcpListener, 4841, table()) == std::set<uid_t>{0});
  }

  void saysNothingWithoutLists() {
    QVERIFY(!platform::ownersOfPort(PortKind::Udp, 4840, table() / "none"));
    QVERIFY(!platform::isPortOfAnother(PortKind::Udp, 4840, table() / "none"));
  }
};

RIVULET_TEST(TestPortOwner)
#include "tst_port_owner.moc"
