// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pipeline/figure13.h"

namespace rivulet::pipeline {

namespace {

constexpr petri::Word kUsPerMs = 1000;
/// Values of the parameter `policy` of the net.
constexpr petri::Word kOrdered = 0;
constexpr petri::Word kDataFlow = 1;
constexpr petri::Word kPrinted = 2;

}  // namespace

petri::ParameterValues figure13Parameters(petri::Word cycleMs, petri::Word policy) {
  return {{"position_cycle", kUsPerMs * cycleMs},
          {"policy", policy},
          {"processors", Figure13Reading{}.processors},
          {"execution", kUsPerMs * Figure13Reading{}.executionMs}};
}

petri::ParameterValues figure13Parameters(const Figure13Reading& reading, petri::Word cycleMs,
                                          bool dataFlow) {
  return {{"position_cycle", kUsPerMs * cycleMs},
          {"policy", dataFlow ? kDataFlow : (reading.asPrinted ? kPrinted : kOrdered)},
          {"processors", reading.processors},
          {"execution", kUsPerMs * reading.executionMs},
          {"task_cycle", kUsPerMs * reading.taskCycleMs}};
}

std::vector<Figure13Reading> figure13Readings() {
  struct Timing {
    petri::Word executionMs;
    petri::Word taskCycleMs;
  };
  std::vector<Figure13Reading> readings;
  for (const bool asPrinted : {true, false}) {
    for (const Timing& timing : {Timing{10, 0}, Timing{10, 5}, Timing{5, 5}}) {
      for (const petri::Word processors : {4, 5, 6}) {
        readings.push_back({asPrinted, timing.executionMs, timing.taskCycleMs, processors});
      }
    }
  }
  return readings;
}

LevelReader::LevelReader(const petri::Net& net) : m_place(net.placeOf("datarec")) {
  const petri::ColourId drec = net.places[m_place].colour;
  m_time = net.offsetOf(drec, "tm");
  m_number = net.offsetOf(drec, "BNO");
  m_data = net.offsetOf(drec, "data");
}

std::optional<BufferLevel> LevelReader::read(const petri::Recorded& recorded) const {
  if (recorded.place != m_place) {
    return std::nullopt;
  }
  const petri::Words& value = *recorded.value;
  return BufferLevel{static_cast<std::size_t>(value[m_number] - 1),
                     static_cast<double>(value[m_time]) / kNetUnitsPerS,
                     static_cast<double>(value[m_data])};
}

}  // namespace rivulet::pipeline
