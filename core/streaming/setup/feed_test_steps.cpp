// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/setup/feed_test_steps.h"

#include <array>

namespace rivulet::streaming {

using base::Result;
using opcua::Variable;

Result<double> FeedTestSteps::number(const Variable& variable) {
  const auto read = numbers({&variable, 1});
  return read ? Result<double>(read->front()) : Result<double>(base::fail(read.error()));
}

Result<void> FeedTestSteps::want(double percent) {
  m_wanted = percent;
  return set(TestCell::Wanted, percent);
}

Result<FeedTestSteps::Look> FeedTestSteps::look() {
  using enum TestCell;
  m_beats += 1.0;
  Result<void> on = proceed(m_step);
  on = on ? set(Beat, m_beats) : on;
  if (!on) {
    return base::fail(on.error());
  }
  pause();
  const std::array<Variable, 9> watched{cell(Wanted), cell(Acts),   cell(Done),
                                        cell(Moved),  cell(Late),   cell(Moving),
                                        cell(Step),   cell(Lifted), cell(InAir)};
  const auto seen = numbers(watched);
  if (!seen) {
    return base::fail(seen.error());
  }
  if ((*seen)[0] != m_wanted) {
    m_foreign = (*seen)[0];
  }
  return Look{(*seen)[1], (*seen)[2], (*seen)[3], (*seen)[4],
              (*seen)[5], (*seen)[6], (*seen)[7], (*seen)[8]};
}

}  // namespace rivulet::streaming
