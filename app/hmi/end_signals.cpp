// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/end_signals.h"

#include <fcntl.h>
#include <unistd.h>

#include <QSocketNotifier>
#include <array>
#include <csignal>

#include "base/contract.h"

namespace rivulet::hmi {

namespace {

constexpr std::array kSignals{SIGHUP, SIGINT, SIGTERM};
/// A handler may do next to nothing: it writes into this pipe, and the event loop reads.
std::array<int, 2> pipeEnds{-1, -1};

extern "C" void writeToPipe(int /*number*/) {
  const char byte = 1;
  [[maybe_unused]] const ssize_t written = ::write(pipeEnds[1], &byte, 1);
}

}  // namespace

EndSignals::EndSignals(QObject* parent) : QObject(parent) {
  const bool isOpen = ::pipe2(pipeEnds.data(), O_CLOEXEC | O_NONBLOCK) == 0;
  RIVULET_ASSERT(isOpen);
  auto* notifier = new QSocketNotifier(pipeEnds[0], QSocketNotifier::Read, this);
  connect(notifier, &QSocketNotifier::activated, this, [this] {
    char byte = 0;
    while (::read(pipeEnds[0], &byte, 1) == 1) {
    }
    Q_EMIT received();
  });
  for (const int number : kSignals) {
    std::signal(number, &writeToPipe);
  }
}

EndSignals::~EndSignals() {
  for (const int number : kSignals) {
    std::signal(number, SIG_DFL);
  }
  ::close(pipeEnds[0]);
  ::close(pipeEnds[1]);
}

}  // namespace rivulet::hmi
