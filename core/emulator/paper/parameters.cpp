// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "emulator/paper/parameters.h"

namespace rivulet::emulator::paper {

namespace {

constexpr std::string_view kOscillatorX = "MOSC controller transfer function (axis X)";
constexpr std::string_view kOscillatorY = "MOSC controller transfer function (axis Y)";
constexpr std::string_view kPid = "PID block parameters";
constexpr std::string_view kGainY = "MOSC controller gains (axis Y)";
constexpr std::string_view kGainX = "MOSC controller gains (axis X)";
constexpr std::string_view kLoop = "Control loop gains";
constexpr std::string_view kDisturbance = "Feedback disturbance";
constexpr std::string_view kIdentification = "Identification errors";

}  // namespace

const std::array<ParameterInfo, kParameterCount>& parameterTable() {
  static constexpr std::array<ParameterInfo, kParameterCount> kTable{{
      {1, kOscillatorX, "frequency of X element 1", "rad/s", 2.0, 0.5, 8.0},
      {2, kOscillatorX, "frequency of X element 2", "rad/s", 5.0, 1.0, 20.0},
      {3, kOscillatorX, "frequency of X element 3", "rad/s", 12.0, 2.0, 50.0},
      {4, kOscillatorX, "frequency of X element 4", "rad/s", 30.0, 5.0, 120.0},
      {5, kOscillatorX, "damping ratio of X element 1", "", 0.7, 0.1, 1.5},
      {6, kOscillatorX, "damping ratio of X element 2", "", 0.7, 0.1, 1.5},
      {7, kOscillatorX, "damping ratio of X element 3", "", 0.7, 0.1, 1.5},
      {8, kOscillatorX, "damping ratio of X element 4", "", 0.7, 0.1, 1.5},
      {9, kOscillatorY, "frequency of Y element 1", "rad/s", 2.0, 0.5, 8.0},
      {10, kOscillatorY, "frequency of Y element 2", "rad/s", 30.0, 5.0, 120.0},
      {11, kOscillatorY, "damping ratio of Y element 1", "", 0.7, 0.1, 1.5},
      {12, kOscillatorY, "damping ratio of Y element 2", "", 0.7, 0.1, 1.5},
      {13, kPid, "proportional part of the speed controller, of the rule's value", "", 1.0, 0.5,
       2.0},
      {14, kPid, "integral part of the speed controller, of the rule's value", "", 1.0, 0.2, 2.0},
      {15, kPid, "proportional part of the power controller, of the rule's value", "", 1.0, 0.5,
       2.0},
      {16, kPid, "integral part of the power controller, of the rule's value", "", 1.0, 0.2, 2.0},
      {17, kGainY, "gain of Y element 1", "1/s", 1.0, 0.1, 8.0},
      {18, kGainY, "gain of Y element 2", "1/s", 1.0, 0.1, 8.0},
      {19, kGainX, "gain of X element 1", "1/s", 1.0, 0.1, 8.0},
      {20, kGainX, "gain of X element 2", "1/s", 1.0, 0.1, 8.0},
      {21, kGainX, "gain of X element 3", "1/s", 1.0, 0.1, 8.0},
      {22, kGainX, "gain of X element 4", "1/s", 1.0, 0.1, 8.0},
      {23, kLoop, "proportional gain of the position controller", "1/s", 15.0, 5.0, 40.0},
      {24, kLoop, "gain of the position controller", "", 1.0, 0.5, 2.0},
      {25, kLoop, "gain of the speed controller", "", 1.0, 0.5, 2.0},
      {26, kLoop, "gain of the power controller", "", 1.0, 0.5, 2.0},
      {27, kDisturbance, "disturbance of the current fed back, times κ3", "", 0.1, 0.01, 1.0},
      {28, kIdentification, "identified to true κ1, gain of the speed feedback", "", 1.0, 0.5, 2.0},
      {29, kIdentification, "identified to true κ2, gain of the current feedback", "", 1.0, 0.5,
       2.0},
      {30, kIdentification, "identified to true κ4, lag of the power controller", "", 1.0, 0.5,
       2.0},
      {31, kIdentification, "identified to true κ6, gain of the electronics", "", 1.0, 0.5, 2.0},
      {32, kIdentification, "identified to true κ7, decay of the electronics", "", 1.0, 0.5, 2.0},
      {33, kIdentification, "identified to true κ8, gain of the motor", "", 1.0, 0.5, 2.0},
      {34, kIdentification, "identified to true κ9, decay of the motor", "", 1.0, 0.5, 2.0},
  }};
  return kTable;
}

Parameters nominalParameters() {
  Parameters values{};
  for (const ParameterInfo& info : parameterTable()) {
    values[static_cast<std::size_t>(info.index - 1)] = info.nominal;
  }
  return values;
}

}  // namespace rivulet::emulator::paper
