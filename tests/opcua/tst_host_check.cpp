// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <QtTest>

#include "opcua/error.h"
#include "opcua/host_check.h"
#include "support/test_program.h"

using namespace rivulet;
using opcua::LinkError;

namespace {

/// No further handle can be opened while this object lives.
class NoHandles {
 public:
  NoHandles() {
    getrlimit(RLIMIT_NOFILE, &m_before);
    // The lowest number that is free is the first that may not be used.
    const int lowest = open("/dev/null", O_RDONLY | O_CLOEXEC);
    close(lowest);
    rlimit limit = m_before;
    limit.rlim_cur = static_cast<rlim_t>(lowest);
    setrlimit(RLIMIT_NOFILE, &limit);
  }
  ~NoHandles() { setrlimit(RLIMIT_NOFILE, &m_before); }
  NoHandles(const NoHandles&) = delete;
  NoHandles& operator=(const NoHandles&) = delete;

 private:
  rlimit m_before{};
};

}  // namespace

class TestHostCheck : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void addressesOfNumbersNeedNoNameServer() {
    for (const char* endpoint : {"opc.tcp://127.0.0.1:4840", "opc.tcp://[::1]:4840/path",
                                 "opc.tcp://localhost:4840", "192.168.214.1", ""}) {
      QVERIFY2(opcua::requireHost(endpoint), endpoint);
    }
  }

  void aNameThatNobodyKnowsIsNamed() {
    // RFC 6761: this ending never exists.
    const auto unknown = opcua::requireHost("opc.tcp://no-such-control.invalid:4840");
    QVERIFY(!unknown);
    QVERIFY(unknown.error().code == LinkError::HostUnknown);
    QVERIFY2(unknown.error().message.find("no-such-control.invalid") != std::string::npos,
             unknown.error().message.c_str());
  }

  void aProgramWithoutHandlesDoesNotBlameTheNetwork() {
    std::error_code code;
    {
      const NoHandles none;
      const auto refused = opcua::requireHost("opc.tcp://127.0.0.1:4840");
      code = refused ? std::error_code() : refused.error().code;
    }
    QVERIFY(code == LinkError::NoHandles);
    QVERIFY(opcua::requireHost("opc.tcp://127.0.0.1:4840"));
  }
};

RIVULET_TEST(TestHostCheck)
#include "tst_host_check.moc"
