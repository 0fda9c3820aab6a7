// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <QtTest>
#include <atomic>
#include <thread>

#include "support/test_program.h"
#include "trace_fetch/http.h"

using namespace rivulet;
using namespace rivulet::trace_fetch;

namespace {

/// Sends the same bytes to whoever connects, again and again, or says nothing.
class Server {
 public:
  /// @param times  that the bytes are sent to each; 0: nothing is sent, and nothing closed
  Server(std::string bytes, std::size_t times) : m_bytes(std::move(bytes)), m_times(times) {
    m_listener = socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof(address);
    void* const raw = &address;
    auto* const any = static_cast<sockaddr*>(raw);
    if (bind(m_listener, any, size) != 0 || listen(m_listener, 4) != 0 ||
        getsockname(m_listener, any, &size) != 0) {
      qFatal("no server on 127.0.0.1");
    }
    m_port = ntohs(address.sin_port);
    m_thread = std::thread([this] { serve(); });
  }
  ~Server() {
    m_isOver = true;
    shutdown(m_listener, SHUT_RDWR);
    m_thread.join();
    close(m_listener);
  }
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  [[nodiscard]] std::string url() const { return fmt::format("http://127.0.0.1:{}/x", m_port); }
  [[nodiscard]] std::size_t sent() const { return m_sent; }

 private:
  void serve() {
    std::vector<int> open;
    while (!m_isOver) {
      const int client = accept(m_listener, nullptr, nullptr);
      if (client < 0) {
        continue;
      }
      open.push_back(client);
      std::array<char, 4096> request{};
      if (recv(client, request.data(), request.size(), 0) <= 0) {
        continue;
      }
      for (std::size_t i = 0; i < m_times && !m_isOver; ++i) {
        if (send(client, m_bytes.data(), m_bytes.size(), MSG_NOSIGNAL) < 0) {
          break;
        }
        m_sent += m_bytes.size();
      }
      if (m_times > 0) {
        shutdown(client, SHUT_RDWR);
      }
    }
    for (const int client : open) {
      close(client);
    }
  }

  std::string m_bytes;
  std::size_t m_times;
  int m_listener = -1;
  int m_port = 0;
  std::atomic<bool> m_isOver = false;
  std::atomic<std::size_t> m_sent = 0;
  std::thread m_thread;
};

base::Result<std::string> answer(const std::string& url, const HttpLimits& limits = {}) {
  return (*makeHttpReader(limits))->get(url);
}

std::string response(std::string_view status, std::string_view body) {
  return fmt::format("HTTP/1.1 {}\r\nContent-Length: {}\r\nConnection: close\r\n\r\n{}", status,
                     body.size(), body);
}

}  // namespace

class TestHttp : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { qputenv("no_proxy", "*"); }
  void readsAnAnswer();
  void passesOnTheRefusalOfAnAgent();
  void saysWhatIsNotThere();
  void waitsForNobody();
  void stopsATooLargeAnswer();
  void readsNothingElse();
};

void TestHttp::readsAnAnswer() {
  const Server server(response("200 OK", "hello"), 1);
  QCOMPARE(answer(server.url()).value_or("nothing"), std::string("hello"));
}

/// Agents refuse with a status and a document that says why; what others say of an error is of no
/// use. Redirections lead to other hosts.
void TestHttp::passesOnTheRefusalOfAnAgent() {
  const Server agent(response("404 Not Found", "<MTConnectError/>"), 1);
  QCOMPARE(answer(agent.url()).value_or("nothing"), std::string("<MTConnectError/>"));
  const Server other(response("404 Not Found", "<html/>"), 1);
  const auto none = answer(other.url());
  QVERIFY(!none && none.error().code == FetchError::WrongAnswer);
  QVERIFY(none.error().message.find("HTTP status 404") != std::string::npos);
  QCOMPARE(none.error().context, other.url());
  const Server moved("HTTP/1.1 302 Found\r\nLocation: " + agent.url() +
                         "\r\nContent-Length: 0\r\nConnection: close\r\n\r\n",
                     1);
  QVERIFY(answer(moved.url()).error().message.find("302") != std::string::npos);
}

void TestHttp::saysWhatIsNotThere() {
  std::string url;
  {
    const Server gone("", 1);
    url = gone.url();
  }
  const auto none = answer(url);
  QVERIFY(!none && none.error().code == FetchError::NotReachable && isOfConnection(none.error()));
  const auto noName = answer("http://no-such-host.invalid:5000/probe");
  QVERIFY(!noName && noName.error().code == FetchError::NotReachable);
  QVERIFY(noName.error().message.find("no host of this name") != std::string::npos);
}

/// Who listens and says nothing keeps a reader without a limit for ever.
void TestHttp::waitsForNobody() {
  const Server silent("", 0);
  HttpLimits limits;
  limits.answerMax = std::chrono::milliseconds{200};
  const auto none = answer(silent.url(), limits);
  QVERIFY(!none && none.error().code == FetchError::TimedOut && isOfConnection(none.error()));
}

/// 500 MB are not held, and not even received.
void TestHttp::stopsATooLargeAnswer() {
  const std::string piece(1'000'000, ' ');
  const Server large("HTTP/1.1 200 OK\r\nContent-Length: 500000000\r\n\r\n" + piece, 500);
  HttpLimits limits;
  limits.bytesMax = 3'000'000;
  const auto none = answer(large.url(), limits);
  QVERIFY(!none && none.error().code == FetchError::TooLarge);
  QVERIFY(none.error().message.find("more than 3 MB") != std::string::npos);
  QVERIFY(large.sent() < 100'000'000);
}

/// No files, and no protocol but the two.
void TestHttp::readsNothingElse() {
  for (const char* url : {"file:///etc/hostname", "ftp://127.0.0.1/x", "http://127.0.0.1:99999/"}) {
    const auto none = answer(url);
    QVERIFY2(!none && none.error().code == FetchError::BadAddress, url);
  }
}

RIVULET_TEST(TestHttp)
#include "tst_http.moc"
