// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <algorithm>
#include <deque>
#include <memory>
#include <optional>
#include <string>

#include "opcua/control_map.h"
#include "opcua/rights.h"
#include "support/test_program.h"

using namespace rivulet;
using opcua::LinkError;
using opcua::RunRight;
using namespace std::chrono_literals;

namespace {

/// A server with a user who may do some things.
class Server : public opcua::Link, public opcua::Control {
 public:
  std::optional<std::string> listed;
  bool reads = true;
  std::optional<bool> writes = true;
  std::error_code onDownload = LinkError::ProgramMissing;
  std::error_code onSelect = LinkError::ProgramMissing;
  bool isLost = false;

  [[nodiscard]] base::Instant now() const override { return {}; }
  base::RequestId read(std::span<const opcua::Variable> variables, base::Duration,
                       opcua::Grouping) override {
    opcua::Event event;
    event.kind = isLost ? opcua::EventKind::ConnectionLost : opcua::EventKind::ReadDone;
    event.error = base::makeError(LinkError::ConnectionLost, "lost");
    event.request = base::RequestId{1};
    for (std::size_t i = 0; i < variables.size(); ++i) {
      opcua::Reading reading;
      if (!reads) {
        reading.status = LinkError::Rejected;
      }
      event.readings.push_back(reading);
    }
    m_events.push_back(event);
    return base::RequestId{1};
  }
  base::RequestId write(std::span<const opcua::Assignment>, base::Duration,
                        opcua::Grouping) override {
    m_isChanged = true;
    return base::RequestId{2};
  }
  base::RequestId store(const std::string&, const std::string&, base::Duration) override {
    m_isChanged = true;
    return base::RequestId{3};
  }
  std::optional<opcua::Event> wait(base::Instant) override {
    if (m_events.empty()) {
      return std::nullopt;
    }
    opcua::Event event = m_events.front();
    m_events.pop_front();
    return event;
  }
  base::Result<void> uploadProgram(const std::string&, const std::string&, bool) override {
    m_isChanged = true;
    return {};
  }
  base::Result<std::string> downloadProgram(const std::string&) override {
    return tl::unexpected(base::makeError(onDownload, "no"));
  }
  base::Result<void> selectProgram(const std::string&) override {
    return tl::unexpected(base::makeError(onSelect, "no"));
  }
  base::Result<std::string> accessRights() override {
    return listed ? base::Result<std::string>(*listed) : Control::accessRights();
  }
  base::Result<bool> mayWrite(const opcua::Variable&) override {
    return writes ? base::Result<bool>(*writes) : base::fail(LinkError::Rejected, "not told");
  }
  [[nodiscard]] bool isVirtualMachine() const override { return false; }
  [[nodiscard]] opcua::Abilities abilities() const override { return {}; }
  base::Result<void> cycleStart() override { return {}; }
  base::Result<void> reset() override { return {}; }
  base::Result<trace::ControlTrace> fetchTrace() override { return trace::ControlTrace{}; }

  [[nodiscard]] bool isChanged() const { return m_isChanged; }

 private:
  std::deque<opcua::Event> m_events;
  bool m_isChanged = false;
};

std::optional<bool> given(const opcua::RightsReport& report, RunRight right) {
  return report.findings[static_cast<std::size_t>(right)].isGiven;
}

}  // namespace

class TestRights : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aUserWithAllThatIsNeeded() {
    Server server;
    server.listed = "StateRead;StateWrite;FsRead;FsWrite;ApWrite";
    const auto report = opcua::examineRights(server, server, 1s);
    QVERIFY(report);
    for (const opcua::RightFinding& finding : report->findings) {
      QCOMPARE(finding.isGiven, std::optional(true));
    }
    QVERIFY(report->excess.empty());
    QVERIFY(!server.isChanged());
  }

  void whatTheServerDoesCountsMoreThanWhatItSays() {
    Server server;
    server.listed = "SinuReadAll;SinuWriteAll;FsRead;ApWrite";
    server.reads = false;
    server.writes = false;
    server.onDownload = LinkError::Rejected;
    server.onSelect = LinkError::Rejected;
    const auto report = opcua::examineRights(server, server, 1s);
    QVERIFY(report);
    for (const opcua::RightFinding& finding : report->findings) {
      QCOMPARE(finding.isGiven, std::optional(false));
    }
  }

  void withoutAListTheRestIsNotKnown() {
    Server server;
    server.writes = std::nullopt;
    const auto report = opcua::examineRights(server, server, 1s);
    QVERIFY(report);
    QVERIFY(!report->isListed);
    QCOMPARE(given(*report, RunRight::ReadVariables), std::optional(true));
    QCOMPARE(given(*report, RunRight::WriteParameters), std::optional<bool>());
    QCOMPARE(given(*report, RunRight::WritePrograms), std::optional<bool>());
    QVERIFY(!server.isChanged());
  }

  void moreThanNeededIsNamed() {
    Server server;
    server.listed = "StateRead;PlcWrite;;TeaWrite;StateWrite;";
    const auto report = opcua::examineRights(server, server, 1s);
    QVERIFY(report);
    QCOMPARE(report->excess, (std::vector<std::string>{"PlcWrite", "TeaWrite"}));
  }

  /// The methods of a SINUMERIK are no advice for somebody else's server.
  void aMappedControlHasItsOwnAdvice() {
    Server server;
    opcua::Connection connection;
    connection.link = &server;
    connection.control = &server;
    for (const bool isMapped : {false, true}) {
      connection.map = isMapped ? std::make_shared<const opcua::ControlMap>() : nullptr;
      const auto report = opcua::examineRights(connection);
      QVERIFY(report);
      QCOMPARE(report->isMapped, isMapped);
      for (const opcua::RightFinding& finding : report->findings) {
        const std::string advice(opcua::rightRemedy(finding.right, report->isMapped));
        QVERIFY(!advice.empty());
        QCOMPARE(advice.find("GiveUserAccess") == std::string::npos, isMapped);
        QCOMPARE(advice.find("map") != std::string::npos, isMapped);
      }
    }
  }

  void aLostConnectionIsAnError() {
    Server server;
    server.isLost = true;
    QVERIFY(!opcua::examineRights(server, server, 1s));
  }
};

RIVULET_TEST(TestRights)
#include "tst_rights.moc"
