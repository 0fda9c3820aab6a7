// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include <QtTest>
#include <functional>

#include "support/test_program.h"
#include "trace/import/import.h"
#include "trace/import/import_error.h"
#include "trace_fetch/agent.h"

using namespace rivulet;
using namespace rivulet::trace_fetch;

namespace {

/// Observations of X, one per sequence number, the first of which it may have forgotten.
class FakeAgent : public HttpReader {
 public:
  [[nodiscard]] base::Result<std::string> get(const std::string& url) override {
    asked.push_back(url.substr(url.find(":5000") + 5));
    if (before) {
      before(asked.back());
    }
    const std::size_t request = url.rfind('/', url.find('?'));
    const std::string name = url.substr(request + 1, url.find('?') - request - 1);
    if (name == "probe") {
      return std::string("<MTConnectDevices><DataItem id=\"x\" name=\"Xact\"/></MTConnectDevices>");
    }
    if (name == "current") {
      const std::uint64_t at = url.find("at=") == std::string::npos ? last : numberOf(url, "at=");
      return at < first || at > last ? refusal() : page(at, at, at + 1);
    }
    const std::uint64_t from = numberOf(url, "from=");
    const std::uint64_t count = numberOf(url, "count=");
    if (from < first || from > last + 1 || count > bufferSize) {
      return refusal();
    }
    const std::uint64_t end = std::min(from + count, last + 1);
    return page(from, end - 1, end);
  }

  std::uint64_t first = 1;
  std::uint64_t last = 100;
  std::uint64_t instance = 7;
  std::uint64_t bufferSize = 1000;
  bool saysNext = true;
  std::function<void(const std::string& url)> before;
  std::vector<std::string> asked;

 private:
  static std::uint64_t numberOf(const std::string& url, std::string_view name) {
    return std::stoull(url.substr(url.find(name) + name.size()));
  }
  static std::string refusal() {
    return "<MTConnectError><Errors><Error errorCode=\"OUT_OF_RANGE\">not kept"
           "</Error></Errors></MTConnectError>";
  }
  [[nodiscard]] std::string page(std::uint64_t from, std::uint64_t until,
                                 std::uint64_t next) const {
    std::string text = fmt::format(
        "<?xml version=\"1.0\"?>\n<MTConnectStreams><Header instanceId=\"{}\" bufferSize=\"{}\" "
        "firstSequence=\"{}\" lastSequence=\"{}\" {}/><Streams><DeviceStream name=\"m\">"
        "<ComponentStream component=\"Linear\" name=\"X\"><Samples>",
        instance, bufferSize, first, last,
        saysNext ? fmt::format("nextSequence=\"{}\"", next) : std::string());
    for (std::uint64_t i = from; i <= until; ++i) {
      text += fmt::format(
          "<Position dataItemId=\"x\" sequence=\"{0}\" "
          "timestamp=\"2026-01-02T03:{1:02}:{2:02}.{3:02}Z\">{0}</Position>",
          i, i / 6000, i / 100 % 60, i % 100);
    }
    return text + "</Samples></ComponentStream></DeviceStream></Streams></MTConnectStreams>";
  }
};

/// Over after some waits, before each of which something may happen.
class Waits : public RecordingTime {
 public:
  Waits(int waits, std::function<void()> before) : m_left(waits), m_before(std::move(before)) {}
  [[nodiscard]] bool isOver() override { return m_left == 0; }
  void wait() override {
    m_before();
    --m_left;
  }

 private:
  int m_left;
  std::function<void()> m_before;
};

AgentAddress addressOf(std::string_view text) {
  auto address = parseAgentAddress(text);
  if (!address) {
    qWarning("%s", address.error().message.c_str());
    return {};
  }
  return *address;
}

struct Fetched {
  trace::ImportedTrace trace;
  std::string error;
  std::error_code code;
};

Fetched fetched(FakeAgent& agent, std::string_view url, RecordingTime* time = nullptr,
                const base::Budget& budget = {}) {
  const auto text = fetchFromAgent(addressOf(url), agent, time, budget);
  if (!text) {
    return {{}, text.error().message, text.error().code};
  }
  auto trace = trace::importTrace(*text);
  return trace ? Fetched{std::move(*trace), {}, {}}
               : Fetched{{}, trace.error().message, trace.error().code};
}

/// "1-40,51-60": values are their sequence numbers. What is held at the end is there twice.
std::string values(const Fetched& fetched) {
  std::string text;
  double before = -1.0;
  for (const trace::Signal& signal : fetched.trace.trace.signalList) {
    for (const double value : signal.values) {
      if (value == before) {
        continue;
      }
      text += value == before + 1.0 ? "" : fmt::format("{}{}", text.empty() ? "" : ",", value);
      before = value;
    }
  }
  return fmt::format("{}..{}", text, before);
}

bool says(const Fetched& fetched, std::string_view words) {
  return std::any_of(fetched.trace.trace.remarks.begin(), fetched.trace.trace.remarks.end(),
                     [words](const trace::Remark& remark) {
                       return trace::remarkText(remark).find(words) != std::string::npos;
                     });
}

constexpr const char* kAgent = "http://host:5000";

}  // namespace

class TestAgent : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void understandsAddresses_data();
  void understandsAddresses();
  void refusesAddresses_data();
  void refusesAddresses();
  void readsAllThatIsKept();
  void asksForNoMoreThanTheBuffer();
  void endsWhereTheAgentStoodAtFirst();
  void goesOnWhileItRecords();
  void saysWhatTheAgentHasForgotten();
  void givesUpOnAnAgentThatForgetsFaster();
  void stopsWhereTheAgentWasRestarted();
  void repeatsTheWordsOfTheAgent();
  void refusesWhatIsNoAgent();
  void isBounded();
};

void TestAgent::understandsAddresses_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QByteArray>("base");
  const auto row = [](const char* text, const char* base) {
    QTest::newRow(text) << QByteArray(text) << QByteArray(base);
  };
  row("http://host:5000", "http://host:5000");
  row("http://host:5000/", "http://host:5000");
  row("https://host/mill/sample?count=5", "https://host/mill");
  row("http://host:5000/current", "http://host:5000");
  row("http://host:5000/mill/probe/", "http://host:5000/mill");
  row("http://sample", "http://sample");  // a host of that name
  row("http://[::1]:5000/mill#top", "http://[::1]:5000/mill");
}

void TestAgent::understandsAddresses() {
  QFETCH(QByteArray, text);
  QFETCH(QByteArray, base);
  QVERIFY(isAgentAddress(text.toStdString()));
  QCOMPARE(addressOf(text.toStdString()).base, base.toStdString());
  QVERIFY(!isAgentAddress("http.csv") && !isAgentAddress("opc.tcp://host"));
  const AgentAddress all = addressOf("http://h/sample?path=//Linear[@name=%22X%22]&from=5&count=6");
  QCOMPARE(all.path, std::string("//Linear[@name=%22X%22]"));
  QCOMPARE(all.from.value_or(0), std::uint64_t{5});
  QCOMPARE(all.count, std::uint64_t{6});
}

void TestAgent::refusesAddresses_data() {
  QTest::addColumn<QByteArray>("words");
  const auto row = [](const char* text, const char* words) {
    QTest::newRow(text) << QByteArray(words);
  };
  row("http://", "names no host");
  row("http:///sample", "names no host");
  row("http://me:secret@host/", "password");
  row("http://host/sample?interval=100", "\"interval=100\" is no parameter");
  row("http://host/sample?count=0", "count=0");
  row("http://host/sample?from=-1", "from=-1");
  row("http://host/sample?from=", "from=");
}

void TestAgent::refusesAddresses() {
  QFETCH(QByteArray, words);
  const auto address = parseAgentAddress(QTest::currentDataTag());
  QVERIFY(!address && address.error().code == FetchError::BadAddress);
  QVERIFY2(address.error().message.find(words.toStdString()) != std::string::npos,
           address.error().message.c_str());
}

/// A reader that takes from + count for the next page, or the last page for all, misses some.
void TestAgent::readsAllThatIsKept() {
  FakeAgent agent;
  agent.first = 11;
  const Fetched all = fetched(agent, "http://host:5000/mill?count=30&path=//X");
  QCOMPARE(all.error, std::string());
  QCOMPARE(values(all), std::string("11..100"));
  QVERIFY(all.trace.trace.signalList[0].name == "Xact");  // by the description
  const std::vector<std::string> expected{"/mill/probe",
                                          "/mill/current?path=//X",
                                          "/mill/current?path=//X&at=11",
                                          "/mill/sample?path=//X&from=11&count=30",
                                          "/mill/sample?path=//X&from=41&count=30",
                                          "/mill/sample?path=//X&from=71&count=30"};
  QCOMPARE(std::vector<std::string>(agent.asked.begin(), agent.asked.begin() + 6), expected);
  agent.asked.clear();
  QCOMPARE(values(fetched(agent, "http://host:5000?from=50")), std::string("50..100"));
}

/// Agents refuse to be asked for more than they can hold.
void TestAgent::asksForNoMoreThanTheBuffer() {
  FakeAgent agent;
  agent.bufferSize = 64;
  QCOMPARE(values(fetched(agent, kAgent)), std::string("1..100"));
}

/// An agent gets new values faster than it is read: without an end of its own the reader never
/// ends.
void TestAgent::endsWhereTheAgentStoodAtFirst() {
  FakeAgent agent;
  agent.before = [&agent](const std::string& url) {
    agent.last += url.starts_with("/sample") ? 50 : 0;
  };
  const Fetched all = fetched(agent, "http://host:5000?count=50");
  QCOMPARE(values(all), std::string("1..100"));
}

void TestAgent::goesOnWhileItRecords() {
  FakeAgent agent;
  Waits time(3, [&agent] { agent.last += 10; });
  QCOMPARE(values(fetched(agent, kAgent, &time)), std::string("1..130"));
  FakeAgent still;
  Waits none(3, [] {});
  QCOMPARE(values(fetched(still, kAgent, &none)), std::string("1..100"));
}

/// A reader that goes on with what is there draws a straight line over what it has not seen.
void TestAgent::saysWhatTheAgentHasForgotten() {
  FakeAgent agent;
  int pages = 0;
  agent.before = [&agent, &pages](const std::string& url) {
    if (url.starts_with("/sample") && ++pages == 2) {
      agent.first = 61;
    }
  };
  const Fetched part = fetched(agent, "http://host:5000?count=40");
  QCOMPARE(values(part), std::string("1,61..100"));
  QVERIFY(says(part, "no longer had: 20."));
  FakeAgent calm;
  QVERIFY(!says(fetched(calm, kAgent), "no longer had"));
}

void TestAgent::givesUpOnAnAgentThatForgetsFaster() {
  FakeAgent agent;
  agent.last = 1'000'000;
  agent.before = [&agent](const std::string& url) {
    agent.first += url.starts_with("/sample") ? 100 : 0;
  };
  const Fetched none = fetched(agent, "http://host:5000?count=10");
  QVERIFY(none.code == FetchError::WrongAnswer);
  QVERIFY(none.error.find("forgets faster") != std::string::npos);
}

/// Sequence numbers begin again: who goes on asks for numbers of another life.
void TestAgent::stopsWhereTheAgentWasRestarted() {
  FakeAgent agent;
  int pages = 0;
  agent.before = [&agent, &pages](const std::string& url) {
    if (url.starts_with("/sample") && ++pages == 2) {
      agent.instance = 8;
    }
  };
  const Fetched part = fetched(agent, "http://host:5000?count=40");
  QCOMPARE(values(part), std::string("1..80"));
  QVERIFY(says(part, "started again"));
}

void TestAgent::repeatsTheWordsOfTheAgent() {
  FakeAgent agent;
  agent.first = 50;
  const Fetched none = fetched(agent, "http://host:5000?from=10");
  QVERIFY(none.code == trace::ImportError::AgentRefused);
  QCOMPARE(none.error,
           std::string("The MTConnect agent refused what it was asked: not kept (OUT_OF_RANGE)."));
}

void TestAgent::refusesWhatIsNoAgent() {
  class Page : public HttpReader {
   public:
    explicit Page(std::string text) : m_text(std::move(text)) {}
    [[nodiscard]] base::Result<std::string> get(const std::string& /*url*/) override {
      return m_text;
    }

   private:
    std::string m_text;
  };
  Page page("<html><body>Hello</body></html>");
  const auto none = fetchFromAgent(addressOf(kAgent), page, nullptr, base::Budget());
  QVERIFY(!none && none.error().code == FetchError::WrongAnswer);
  QVERIFY(none.error().message.find("no MTConnect agent") != std::string::npos);
  Page other("<MTConnectAssets/>");
  const auto assets = fetchFromAgent(addressOf(kAgent), other, nullptr, base::Budget());
  QCOMPARE(assets.error().message,
           std::string("The agent answers with MTConnectAssets instead of MTConnectDevices. Check "
                       "the address."));
  FakeAgent silent;
  silent.saysNext = false;
  QVERIFY(fetched(silent, kAgent).error.find("nextSequence") != std::string::npos);
}

void TestAgent::isBounded() {
  FakeAgent agent;
  agent.last = 5000;
  const Fetched none = fetched(agent, kAgent, nullptr, base::Budget(100'000));
  QVERIFY(none.code == base::BudgetError::Exceeded);
  QVERIFY(none.error.find("path=XPATH") != std::string::npos);
}

RIVULET_TEST(TestAgent)
#include "tst_agent.moc"
