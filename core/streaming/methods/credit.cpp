// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/methods/window.h"

namespace rivulet::streaming {

base::Duration CreditMethod::takenTime() const {
  base::Duration sum{};
  for (std::size_t window = m_executed; window < std::max(m_latched, m_executed + 1); ++window) {
    sum += windowTime(window);
  }
  return sum;
}

base::Duration CreditMethod::takenTimeMax() const {
  const bool slows = m_plan.settings().parameters.slowDown;
  return slows ? takenTime() * 100 / templates::WindowProtocol::kSlowestPercent : takenTime();
}

std::unique_ptr<Method> CreditMethodType::make(MethodSetup setup) const {
  return std::make_unique<CreditMethod>(std::move(setup));
}

void CreditMethodType::complete(RunSettings& settings, std::uint64_t entropy) const {
  settings.placePauses = false;
  WindowMethodType::complete(settings, entropy);
}

}  // namespace rivulet::streaming
