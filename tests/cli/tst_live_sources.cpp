// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Points that arrive over real sockets while a rivulet-machine moves: what a sender is told, and
/// what becomes of bad input.

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>
#include <memory>
#include <nlohmann/json.hpp>

#include "report/report_reader.h"
#include "report/run_history.h"
#include "support/live_run.h"
#include "support/machine_process.h"
#include "support/patience.h"
#include "support/test_program.h"

using namespace rivulet;
using nlohmann::json;
using Run = tests::LiveRun;

namespace {

using tests::kRunMs;
const std::string kSimulated = "--simulate --preset dmu75-arrays --points 13";

/// The other end of a socket.
class Sender {
 public:
  explicit Sender(const std::string& source) {
    const std::string rest = source.substr(source.find(':') + 1);
    sockaddr_in internet{};
    sockaddr_un local{};
    internet.sin_family = AF_INET;
    internet.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    local.sun_family = AF_UNIX;
    const bool isLocal = source.starts_with("unix:");
    if (isLocal) {
      std::copy(rest.begin(), rest.end(), local.sun_path);
    } else {
      internet.sin_port = htons(static_cast<std::uint16_t>(std::stoi(rest)));
    }
    m_socket = ::socket(isLocal ? AF_UNIX : AF_INET,
                        source.starts_with("udp:") ? SOCK_DGRAM : SOCK_STREAM, 0);
    const auto* const address = isLocal ? reinterpret_cast<const sockaddr*>(&local)
                                        : reinterpret_cast<const sockaddr*>(&internet);
    if (::connect(m_socket, address, isLocal ? sizeof local : sizeof internet) != 0) {
      qFatal("cannot connect to %s", source.c_str());
    }
  }
  ~Sender() { close(); }
  Sender(const Sender&) = delete;
  Sender& operator=(const Sender&) = delete;

  void close() {
    if (m_socket >= 0) {
      ::close(m_socket);
    }
    m_socket = -1;
  }
  void send(const std::string& text) { ::send(m_socket, text.data(), text.size(), MSG_NOSIGNAL); }
  /// As much as the other side takes. @return bytes
  std::size_t flood(std::string_view text) {
    const ssize_t count = ::send(m_socket, text.data(), text.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    return count > 0 ? static_cast<std::size_t>(count) : 0;
  }
  /// The next reply; null: the other side has closed, or says nothing for a long time.
  json reply() {
    while (m_text.find('\n') == std::string::npos) {
      pollfd asked{m_socket, POLLIN, 0};
      std::array<char, 4096> bytes;
      const int ready = ::poll(&asked, 1, kRunMs);
      if (ready < 0 && errno == EINTR) {
        continue;  // Qt may hear of the end of a program by a signal
      }
      const ssize_t count = ready > 0 ? ::read(m_socket, bytes.data(), bytes.size()) : 0;
      if (count <= 0) {
        return {{"end", "nobody is there"}};
      }
      m_text.append(bytes.data(), static_cast<std::size_t>(count));
    }
    const std::size_t end = m_text.find('\n');
    json line = json::parse(m_text.substr(0, end), nullptr, false);
    m_text.erase(0, end + 1);
    return line;
  }
  /// The last reply.
  json end() {
    json line = reply();
    while (line.is_object() && !line.contains("end")) {
      line = reply();
    }
    return line;
  }

 private:
  int m_socket = -1;
  std::string m_text;
};

/// Points in a circle that begins where the tool is.
std::string circle(const json& toolAt, int first, int count, bool numbered = false) {
  std::string text;
  for (int i = first; i < first + count; ++i) {
    const double angle = 0.05 * i;
    text += fmt::format("{}X{:.4f} Y{:.4f}\r\n", numbered ? fmt::format("N{} ", i) : "",
                        toolAt.value("x", 0.0) + 5.0 * (std::cos(angle) - 1.0),
                        toolAt.value("y", 0.0) + 5.0 * std::sin(angle));
  }
  return text;
}

}  // namespace

class TestLiveSources : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    m_machine = std::make_unique<tests::MachineProcess>(
        QStringLiteral(RIVULET_MACHINE),
        QStringList{QStringLiteral("--preset"), QStringLiteral("dmu75-arrays")});
    QVERIFY(!m_machine->endpoint().isEmpty());
  }

  void aSenderIsToldHowFarTheRunIs() {
    const report::RunHistory history(m_folder.path().toStdString() + "/rivulet/history");
    const std::size_t before = history.list().runs.size();
    Run overOpcUa = start(unixSource(), onMachine());
    Run simulated = start("tcp:0");
    for (Run* run : {&overOpcUa, &simulated}) {
      Sender sender(run->source);
      const json at = sender.reply();
      QCOMPARE(at.value("executed", 9), 0);
      sender.send(circle(at, 1, 30));
      json reply = sender.reply();
      while (reply.value("executed", 99) < 30) {
        reply = sender.reply();
      }
      QCOMPARE(reply.value("line", 0), 30);
      sender.send(circle(at, 31, 10) + "end\n");
      const json end = sender.end();
      QCOMPARE(end.value("end", ""), std::string("completed"));
      QCOMPARE(end.value("executed", 0), 40);
      QCOMPARE(run->finish(), 0);
      QVERIFY2(run->isRight(), run->report.dump(1).c_str());
      QCOMPARE(run->number("executed"), 40U);
      QCOMPARE(run->report["live"]["delay_ms"].size(), 6U);
    }
    // A live run is a run: with its path and a recording, although none was asked for. A simulation
    // leaves nothing.
    const auto runs = history.list().runs;
    QCOMPARE(runs.size(), before + 1);
    QCOMPARE(runs.front().total, std::size_t{40});
    QVERIFY(runs.front().ownsRecording && !runs.front().recording.empty());
    const auto kept = report::readFinishedRun(history.reportFile(runs.front().id));
    QVERIFY(kept && kept->sketch.size() == 40);
  }

  /// One sentence each, all good points are executed, and nothing else.
  void badInput() {
    struct Row {
      std::string text;
      const char* says;
    };
    const std::array<Row, 6> rows{
        {{"X nan\nX0\n", "line 41: X has no finite number."},
         {"GET / HTTP/1.1\r\n", "line 41: This is no point."},
         {"X250\n", "line 41: A step of "},
         {"X1.", "line 41: The source was closed in the middle"},
         {"", "line 40: The source was closed without `end`."},
         {std::string(100'000, '7'), "line 41: The line has more than 1000 characters."}}};
    std::vector<std::unique_ptr<Run>> runs;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      runs.push_back(std::make_unique<Run>(m_folder.path(),
                                           "--live " + unixSource() + std::to_string(i) + " " +
                                               (rows[i].text.empty() ? onMachine() : kSimulated)));
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
      Sender sender(runs[i]->source);
      const json at = sender.reply();
      sender.send(circle(at, 1, 40) + rows[i].text);
      sender.close();
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
      Run& run = *runs[i];
      QCOMPARE(run.finish(), 1);
      QVERIFY2(run.isRight(), run.report.dump(1).c_str());
      QVERIFY2(run.error().find(rows[i].says) != std::string::npos, run.error().c_str());
      QCOMPARE(run.number("executed"), 40U);
    }
  }

  /// A second source slows the cut down, holds it by what was not agreed, and lets it go. Nothing
  /// moves before its first factor.
  void aSourceOfFactors() {
    const std::string factors = "unix:" + m_folder.filePath(QStringLiteral("feed")).toStdString();
    Run run =
        start(unixSource(),
              onMachine() + " --feed-factor 0.2 1.2 --feed-silence 60 --feed-from " + factors);
    Sender points(run.source);
    Sender feed(factors);
    points.send(circle(points.reply(), 1, 400) + "end\n");
    const auto await = [&feed](double percent) {
      json reply = feed.reply();
      while (!reply.contains("end") && reply.value("percent", -1.0) != percent) {
        reply = feed.reply();
      }
      return reply;
    };
    const json before = await(0.0);
    QCOMPARE(before.value("executed", 9), 0);
    QCOMPARE(before.value("feed_mm_per_min", 9.0), 0.0);
    Sender second(factors);
    QVERIFY(second.reply().contains("error"));
    feed.send("feed 0.5\n");
    QVERIFY(!await(50.0).contains("end"));
    feed.send("feed 250\n");
    QVERIFY(!await(0.0).contains("end"));
    feed.send("feed 1.2\n");
    QVERIFY(!await(120.0).contains("end"));
    QCOMPARE(feed.end().value("end", ""), std::string("completed"));
    QCOMPARE(run.finish(), 0);
    QVERIFY2(run.isRight(), run.report.dump(1).c_str());
    QCOMPARE(run.number("executed"), 400U);
    const json& factor = run.report["factor"];
    QCOMPARE(factor.value("source", ""), factors);
    QCOMPARE(factor.value("values", 0), 2);
    QCOMPARE(factor.value("refused", 0), 1);
    const auto holds =
        std::count_if(run.report["feed"].begin(), run.report["feed"].end(), [](const json& event) {
          return event.value("source", false) && event.value("percent", 9.0) == 0.0;
        });
    QCOMPARE(holds, std::ptrdiff_t{2});
  }

  /// Where it would wait behind points, a factor ends the stream.
  void aFactorAmongPoints() {
    Run run = start(unixSource());
    Sender sender(run.source);
    sender.send(circle(sender.reply(), 1, 40) + "feed 0.5\n");
    QCOMPARE(run.finish(), 1);
    QCOMPARE(run.number("executed"), 40U);
    QVERIFY2(run.error().find("A factor of the feed would wait here") != std::string::npos,
             run.error().c_str());
  }

  void nothing() {
    Run run = start(unixSource(), kSimulated + " --end-after 2 --hold-after 1");
    QCOMPARE(run.finish(), 1);
    QCOMPARE(run.number("executed"), 0U);
    QVERIFY2(run.error().find("Nothing has come from the source for 2 s.") != std::string::npos,
             run.error().c_str());
  }

  /// A million lines a second would be sent, if anybody read them.
  void aFlood() {
    Run run = start(unixSource());
    Sender sender(run.source);
    const json at = sender.reply();
    const std::string text = circle(at, 1, 1'000'000);
    std::size_t sent = 0;
    while (const std::size_t bytes = sender.flood(std::string_view(text).substr(sent))) {
      sent += bytes;
    }
    const auto lines = static_cast<std::size_t>(
        std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(sent), '\n'));
    QVERIFY(lines < 1'000'000);
    json reply = sender.reply();
    while (reply.value("executed", 99) < 14) {
      reply = sender.reply();
    }
    run.stop();
    QCOMPARE(sender.end().value("end", ""), std::string("stopped"));
    QCOMPARE(run.finish(), 0);
    QVERIFY2(run.isRight(), run.report.dump(1).c_str());
    QVERIFY(run.number("executed") >= 14);
    QVERIFY(run.number("accepted") < lines);
  }

  void datagramsAreNumbered() {
    const json at{{"x", 0.0}, {"y", 0.0}};  // where the simulated tool is
    for (const bool isLost : {false, true}) {
      Run run = start("udp:0");
      Sender sender(run.source);
      sender.send(circle(at, 1, 20, true));
      sender.send(circle(at, isLost ? 22 : 21, 10, true));
      sender.send("end");
      QCOMPARE(run.finish(), isLost ? 1 : 0);
      QVERIFY2(run.isRight(), run.report.dump(1).c_str());
      QCOMPARE(run.number("executed"), isLost ? 20U : 30U);
      QCOMPARE(run.error().find("N21 was expected after N20, but N22 came") != std::string::npos,
               isLost);
    }
  }

  /// The first one has the source: what others send moves nothing, and they are told.
  void datagramsOfOneSender() {
    const json at{{"x", 0.0}, {"y", 0.0}};
    Run run = start("udp:0");
    Sender sender(run.source);
    Sender stranger(run.source);
    sender.send(circle(at, 1, 20, true));
    stranger.send(circle(at, 21, 10, true));
    QCOMPARE(stranger.reply().value("error", ""), std::string("Another sender has this source."));
    stranger.send("end");
    sender.send(circle(at, 21, 10, true));
    sender.send("end");
    QCOMPARE(run.finish(), 0);
    QVERIFY2(run.isRight(), run.report.dump(1).c_str());
    QCOMPARE(run.number("executed"), 30U);
  }

  void aPipeWithoutAControl() {
    Run run(m_folder.path(),
            "--live - --simulate --preset dmu75-arrays --method credit --points 13");
    run.send(circle(json{{"x", 0.0}, {"y", 0.0}}, 1, 200));
    QCOMPARE(run.finish(), 0);
    QVERIFY2(run.isRight(), run.report.dump(1).c_str());
    QCOMPARE(run.number("executed"), 200U);
  }

  /// examples/: the force stays within 10 %, which the program itself finds out.
  void aForceIsKept() {
    Run run(m_folder.path(), "--live tcp:0 --simulate --preset ideal --full-within 20 --points 4");
    QProcess follower;
    follower.start(QStringLiteral(RIVULET_FOLLOW_SURFACE),
                   {QString::fromStdString(run.source.substr(4))});
    QVERIFY(follower.waitForFinished(kRunMs));
    QVERIFY2(follower.exitCode() == 0, follower.readAllStandardOutput().constData());
    QCOMPARE(run.finish(), 0);
    QVERIFY(run.isRight());
    QCOMPARE(run.number("executed"), 150U);
  }

  void whatIsNoSource() {
    for (const char* source : {"tcp:x", "http:1", "opcua:", "opcua:/nowhere.toml", "unix:"}) {
      Run run(m_folder.path(), std::string("--simulate --live ") + source);
      QCOMPARE(run.finish(), 2);
    }
  }

 private:
  std::string unixSource() {
    return "unix:" + m_folder.filePath(QStringLiteral("points")).toStdString();
  }
  [[nodiscard]] std::string onMachine() const {
    return "--points 13 --endpoint " + m_machine->endpoint().toStdString();
  }
  Run start(const std::string& source, const std::string& control = kSimulated) {
    return Run(m_folder.path(), "--live " + source + " " + control);
  }

  QTemporaryDir m_folder;
  std::unique_ptr<tests::MachineProcess> m_machine;
};

RIVULET_TEST(TestLiveSources)
#include "tst_live_sources.moc"
