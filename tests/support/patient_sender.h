// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// An OPC UA server whose variables bring live points. @threadsafety that of `PlainServer`.
#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <string>

#include "support/plain_server.h"

namespace rivulet::tests {

inline constexpr int kPoints = 40;
inline const std::map<std::string, double> kNumbers{
    {"n", 0.0}, {"x", 0.0}, {"y", 0.0}, {"f", 0.0}, {"accepted", -1.0}, {"executed", -1.0}};
inline const std::string kWords =
    "[points]\n"
    "n = \"ns=1;s=n\"\n"
    "x = \"ns=1;s=x\"\n"
    "y = \"ns=1;s=y\"\n"
    "f = \"ns=1;s=f\"\n";
inline const std::string kExecuted =
    "[replies]\n"
    "executed = \"ns=1;s=executed\"\n";
inline const std::string kReplies = kExecuted + "accepted = \"ns=1;s=accepted\"\n";

inline double angleOf(int point) {
  return 0.05 * point;
}

/// A circle from 0, 0 whose next point is there when the one before was accepted, again for each
/// run.
class PatientSender {
 public:
  void operator()(PlainServer& server) {
    const double accepted = server.number("accepted");
    m_mostExecuted = std::max(m_mostExecuted.load(), server.number("executed"));
    // A run that begins has accepted nothing.
    if (accepted < m_sent || m_sent == m_most || (m_sent == 0 && accepted != 0.0)) {
      return;
    }
    if (m_sent == kPoints) {
      server.set("n", -1.0);
      m_sent = 0;
      return;
    }
    ++m_sent;
    server.set("x", 5.0 * (std::cos(angleOf(m_sent)) - 1.0));
    server.set("y", m_sent == m_poisoned ? std::nan("") : 5.0 * std::sin(angleOf(m_sent)));
    server.set("f", 900.0);
    server.set("n", m_sent);
  }

  int m_sent = 0;
  int m_most = -1;      ///< no point and no end comes after it
  int m_poisoned = -1;  ///< this point has a Y that is no number
  std::atomic<double> m_mostExecuted = 0.0;
};

}  // namespace rivulet::tests
