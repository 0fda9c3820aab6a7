// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Follows a surface that it does not know by the force on it; surface and sensor are simulated.
// Exit code 0: the force stayed within 10 % of 20 N. docs/live.md says how to start it.

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>

constexpr double kNewtonPerMm = 100.0;
constexpr double kWantedN = 20.0;
constexpr double kStepMm = 0.1;
constexpr int kLead = 4;  // points on their way: what is measured is this old
constexpr int kPoints = 150;

int main(int count, char** words) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(count > 1 ? std::stoi(words[1]) : 4001));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const int wire = socket(AF_INET, SOCK_STREAM, 0);
  if (connect(wire, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0) {
    return 2;
  }
  std::FILE* const run = fdopen(wire, "r+");
  double x0 = 0.0, z0 = 0.0, heightBefore = 0.0, xBefore = 1e9, slope = 0.0, worstN = 0.0;
  int sent = 0;
  char reply[1000];
  while (std::fgets(reply, sizeof reply, run) != nullptr &&
         std::strstr(reply, "\"end\"") == nullptr) {
    const auto number = [&](const char* name) {
      double value = 0.0;
      std::from_chars(std::strstr(reply, name) + std::strlen(name), std::end(reply), value);
      return value;
    };
    const double x = number("\"x\":"), z = number("\"z\":");
    x0 = sent == 0 ? x : x0, z0 = sent == 0 ? z : z0;
    const double surfaceMm = z0 + kWantedN / kNewtonPerMm + 0.5 * (1.0 - std::cos((x - x0) / 5.0));
    const double forceN = kNewtonPerMm * (surfaceMm - z);  // all that the sensor knows
    worstN = std::max(worstN, std::abs(forceN - kWantedN));
    const double height = z + forceN / kNewtonPerMm;
    slope = x > xBefore ? (height - heightBefore) / (x - xBefore) : slope;
    heightBefore = height, xBefore = x;
    for (; sent < std::min(static_cast<int>(number("\"executed\":")) + kLead, kPoints); ++sent) {
      const double next = x0 + kStepMm * (sent + 1);
      const double surface = height + slope * (next - x);
      std::fprintf(run, "X%.4f Z%.4f\n", next, surface - kWantedN / kNewtonPerMm);
    }
    std::fputs(sent == kPoints ? "end\n" : "", run);
    std::fflush(run);
  }
  std::printf("%d points, force %.0f N, worst deviation %.2f N\n", sent, kWantedN, worstN);
  return sent == kPoints && worstN < 0.1 * kWantedN ? 0 : 1;
}
