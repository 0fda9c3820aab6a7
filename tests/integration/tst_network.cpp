// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The real link over a network with faults, to the real server of a virtual machine.

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <QtTest>
#include <algorithm>
#include <array>
#include <string_view>
#include <thread>

#include "opcua/open62541/client_wire.h"
#include "support/fault_proxy.h"
#include "support/loopback_machine.h"
#include "support/soiled_stack.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace std::chrono_literals;
using opcua::Event;
using opcua::EventKind;
using opcua::Grouping;
using opcua::LinkError;
using opcua::rParameter;
using tests::FaultKind;
using tests::FaultProxy;
using tests::LoopbackMachine;
using tests::NetworkFault;

namespace {

constexpr base::Duration kPatience = 60s;

NetworkFault fault(FaultKind kind, base::Duration duration = {}, base::Duration delay = {}) {
  NetworkFault fault;
  fault.kind = kind;
  fault.duration = duration;
  fault.delay = delay;
  return fault;
}

base::Result<std::unique_ptr<opcua::UaLink>> connectTo(const std::string& endpoint,
                                                       base::Duration deadline = 20s) {
  opcua::ConnectOptions options;
  options.security = opcua::unencrypted();
  options.endpoint = endpoint;
  options.connectDeadline = deadline;
  return opcua::UaLink::connect(options);
}

/// One value, asked for with this deadline; the event that ends the request.
Event readOnce(opcua::Link& link, base::Duration deadline) {
  const std::vector<opcua::Variable> asked{rParameter(1)};
  const base::RequestId id = link.read(asked, deadline, Grouping::List);
  for (;;) {
    tests::soilStack();
    auto event = link.wait(link.now() + kPatience);
    RIVULET_ASSERT(event.has_value());
    if (event->request == id || event->kind == EventKind::ConnectionLost) {
      return std::move(*event);
    }
  }
}

/// Of channel, token, sequence and request.
const std::string kNumbers(16, '\x07');
const std::string kReadResponse{'\x01', '\x00', '\x7a', '\x02'};

std::string chunk(std::string_view kind, const std::string& body) {
  const auto size = static_cast<std::uint32_t>(8 + body.size());
  std::string bytes(kind);
  for (unsigned shift = 0; shift < 32; shift += 8) {
    bytes += static_cast<char>(size >> shift);
  }
  return bytes + body;
}

/// Says the same to whoever has said something, and hangs up.
class Stranger {
 public:
  explicit Stranger(std::string_view words) : m_words(words) {
    sockaddr_in address{};
    socklen_t size = sizeof address;
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    auto* const place = reinterpret_cast<sockaddr*>(&address);
    RIVULET_ASSERT(bind(m_listener, place, size) == 0 && listen(m_listener, 8) == 0 &&
                   getsockname(m_listener, place, &size) == 0);
    m_port = ntohs(address.sin_port);
    m_thread = std::thread([this] { serve(); });
  }
  Stranger(const Stranger&) = delete;
  Stranger& operator=(const Stranger&) = delete;
  ~Stranger() {
    shutdown(m_listener, SHUT_RDWR);
    m_thread.join();
    close(m_listener);
  }
  [[nodiscard]] std::string endpoint() const {
    return "opc.tcp://127.0.0.1:" + std::to_string(m_port);
  }

 private:
  void serve() const {
    for (int client = 0; (client = accept(m_listener, nullptr, nullptr)) >= 0;) {
      std::array<char, 256> heard{};
      if (recv(client, heard.data(), heard.size(), 0) > 0) {
        send(client, m_words.data(), m_words.size(), MSG_NOSIGNAL);
      }
      close(client);
    }
  }

  std::string_view m_words;
  int m_listener = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  std::uint16_t m_port = 0;
  std::thread m_thread;
};

}  // namespace

class TestNetwork : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// The library knows a request for as long as its answer may come: an answer to a request it has
  /// forgotten makes it close the connection.
  void anAnswerMaySurviveItsDeadline() {
    const LoopbackMachine cell;
    FaultProxy proxy(cell.endpoint());
    const auto link = connectTo(proxy.endpoint());
    QVERIFY2(link.has_value(), link ? "" : link.error().text().c_str());
    proxy.begin(fault(FaultKind::Stall, 2500ms));
    while (!proxy.hasStruck()) {
      QVERIFY(!(*link)->wait((*link)->now() + 1ms));
    }
    int late = 0;
    Event event = readOnce(**link, 100ms);
    while (event.kind == EventKind::RequestFailed) {
      QVERIFY(event.error.code == LinkError::DeadlineExceeded);
      ++late;
      event = readOnce(**link, 100ms);
    }
    QVERIFY2(event.kind == EventKind::ReadDone, event.error.text().c_str());
    QVERIFY(late > 3);
    // What was asked in vain is bounded, however long nobody answers.
    QVERIFY(proxy.requests() < 40U);
    QVERIFY(cell.server().requestsServed() <= 6U);
  }

  /// Left to it, the library would clear a response that it has never written: in place of an end
  /// of the connection, the end of the program.
  void anAnswerOfNoTypeEndsTheConnection() {
    const LoopbackMachine cell;
    FaultProxy proxy(cell.endpoint());
    const auto link = connectTo(proxy.endpoint());
    QVERIFY2(link.has_value(), link ? "" : link.error().text().c_str());
    NetworkFault flip = fault(FaultKind::FlipAnswer);
    flip.bit = 8 * 24 + 3;  // how the number of the type is written
    proxy.begin(flip);
    const Event lost = readOnce(**link, kPatience);
    QCOMPARE(lost.kind, EventKind::ConnectionLost);
    QVERIFY(lost.error.code == LinkError::ConnectionLost);
    QVERIFY2(lost.error.text().find("An answer of the server cannot be read") != std::string::npos,
             lost.error.text().c_str());
    QVERIFY(!(*link)->reset());
  }

  void theTypesOfAnswersAreFoundHoweverTheyAreCut() {
    const std::string hello = chunk("ACKF", std::string(20, '\x01'));
    const std::string whole = chunk("MSGF", kNumbers + kReadResponse + std::string(300, '\x09'));
    const std::string first = chunk("MSGC", kNumbers + kReadResponse);
    const std::string next = chunk("MSGC", kNumbers + std::string(90, '\x09'));
    const std::string last = chunk("MSGF", kNumbers + '\x09');
    const std::string aborted = chunk("MSGA", kNumbers + std::string(8, '\x09'));
    const std::string good = hello + whole + first + next + last + whole + first + aborted + whole;
    const std::string untyped = chunk("MSGF", kNumbers + std::string(300, '\x09'));
    for (std::size_t cut = 0; cut <= good.size() + untyped.size(); ++cut) {
      opcua::AnswerTypes types;
      const std::string bytes = good + untyped;
      const bool isFirstTaken = types.take(std::string_view(bytes).substr(0, cut));
      // Seen as soon as its type is there.
      QCOMPARE(isFirstTaken, cut < good.size() + 24 + 19);
      if (isFirstTaken) {
        QVERIFY(!types.take(std::string_view(bytes).substr(cut)));
      }
    }
    opcua::AnswerTypes bytewise;
    QVERIFY(std::all_of(good.begin(), good.end(), [&](const char& one) {
      return bytewise.take({&one, 1});
    }));
    for (const std::string& bad : {chunk("MSGF", kNumbers), chunk("MSGF", kNumbers + '\x01'),
                                   chunk("MSGF", "short"), last + last}) {
      opcua::AnswerTypes types;
      QVERIFY(!types.take(bad));
    }
  }

  void silenceIsSeenAndEndsTheConnection() {
    const LoopbackMachine cell;
    FaultProxy proxy(cell.endpoint());
    opcua::ConnectOptions options;
    options.security = opcua::unencrypted();
    options.endpoint = proxy.endpoint();
    options.silenceMax = 1s;
    const auto link = opcua::UaLink::connect(options);
    QVERIFY2(link.has_value(), link ? "" : link.error().text().c_str());
    QCOMPARE(readOnce(**link, kPatience).kind, EventKind::ReadDone);
    QVERIFY((*link)->silence() == 0s);
    proxy.begin(fault(FaultKind::HalfOpen));
    while (!proxy.hasStruck()) {
      QVERIFY(!(*link)->wait((*link)->now() + 1ms));
    }
    QVERIFY((*link)->silence() == 0s);  // nothing was asked
    const Event late = readOnce(**link, 200ms);
    QVERIFY(late.error.code == LinkError::DeadlineExceeded);
    QVERIFY((*link)->silence() >= 200ms);
    const Event lost = readOnce(**link, kPatience);
    QCOMPARE(lost.kind, EventKind::ConnectionLost);
    QVERIFY(lost.error.code == LinkError::ConnectionLost);
    QVERIFY2(lost.error.text().find("network") != std::string::npos, lost.error.text().c_str());
    QVERIFY(lost.at - late.sent >= 1s);
  }

  /// Whatever the other side sends, connecting and closing come to an end.
  void whoEchoesIsLeft() {
    FaultProxy echo("");
    echo.begin(fault(FaultKind::Echo));
    const auto refused = connectTo(echo.endpoint(), 1s);
    QVERIFY(!refused);
    QVERIFY(refused.error().code == LinkError::NotReachable);

    const LoopbackMachine cell;
    FaultProxy proxy(cell.endpoint());
    auto link = connectTo(proxy.endpoint());
    QVERIFY2(link.has_value(), link ? "" : link.error().text().c_str());
    proxy.begin(fault(FaultKind::Echo));
    while (!proxy.hasStruck()) {
      QVERIFY(!(*link)->wait((*link)->now() + 1ms));
    }
    const Event lost = readOnce(**link, kPatience);
    QCOMPARE(lost.kind, EventKind::ConnectionLost);
    link->reset();
  }

  /// The system's buffers are full, and the library waits for room in them.
  void whoTakesNoDataIsLeft() {
    const LoopbackMachine cell;
    FaultProxy proxy(cell.endpoint());
    opcua::ConnectOptions options;
    options.security = opcua::unencrypted();
    options.endpoint = proxy.endpoint();
    options.silenceMax = 1s;
    auto link = opcua::UaLink::connect(options);
    QVERIFY2(link.has_value(), link ? "" : link.error().text().c_str());
    proxy.begin(fault(FaultKind::Stall, kPatience));
    while (!proxy.hasStruck()) {
      QVERIFY(!(*link)->wait((*link)->now() + 1ms));
    }
    const auto refused = (*link)->uploadProgram("A.MPF", std::string(12'000'000, ';'), true);
    QVERIFY(!refused);
    QVERIFY2(refused.error().code == LinkError::ConnectionLost, refused.error().text().c_str());
    link->reset();
  }

  void whoClosesAtOnceIsAskedSeldom() {
    FaultProxy proxy("");
    proxy.begin(fault(FaultKind::AcceptAndClose, kPatience));
    const auto refused = connectTo(proxy.endpoint(), 1500ms);
    QVERIFY(!refused);
    QVERIFY(refused.error().code == LinkError::NotReachable);
    QVERIFY2(proxy.connections() <= 8U, std::to_string(proxy.connections()).c_str());
    QVERIFY(proxy.connections() >= 2U);
  }

  /// A port at which something else answers is not said to be an overloaded control.
  void whoSpeaksAnotherLanguageIsNoServer_data() {
    QTest::addColumn<std::string>("words");
    QTest::newRow("HTTP") << std::string("HTTP/1.1 400 Bad Request\r\nConnection: close\r\n\r\n");
    QTest::newRow("SSH") << std::string("SSH-2.0-OpenSSH_9.2\r\n");
    QTest::newRow("zeros") << std::string(64, '\0');
    QTest::newRow("high bytes") << std::string(64, '\xee');
  }
  void whoSpeaksAnotherLanguageIsNoServer() {
    QFETCH(const std::string, words);
    const Stranger stranger(words);
    const auto refused = connectTo(stranger.endpoint(), 2s);
    QVERIFY(!refused);
    const std::string said = refused.error().text();
    QVERIFY2(said.find("not an OPC UA server. Check the port") != std::string::npos, said.c_str());
    QVERIFY2(said.find("fewer points") == std::string::npos, said.c_str());
  }

  /// The deadline is for each answer: connecting takes a dozen of them.
  void longRoundTripsConnect() {
    const LoopbackMachine cell;
    FaultProxy proxy(cell.endpoint(), 150ms);
    const auto link = connectTo(proxy.endpoint(), 1s);
    QVERIFY2(link.has_value(), link ? "" : link.error().text().c_str());
    QCOMPARE(readOnce(**link, kPatience).kind, EventKind::ReadDone);
  }

  void aFaultIsDrawnTheSameAgain() {
    std::set<FaultKind> kinds;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
      const NetworkFault first = tests::drawNetworkFault(seed, 4s);
      const NetworkFault again = tests::drawNetworkFault(seed, 4s);
      QVERIFY(first.kind == again.kind && first.after == again.after &&
              first.duration == again.duration && first.delay == again.delay &&
              first.place == again.place && first.seed == again.seed);
      QVERIFY(first.after < 4s && first.duration < 10s);
      kinds.insert(first.kind);
    }
    QCOMPARE(kinds.size(), static_cast<std::size_t>(FaultKind::Count) - 1);
  }
};

RIVULET_TEST(TestNetwork)
#include "tst_network.moc"
