// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "job/plan_writer.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "base/text.h"
#include "nc/nc_number.h"

namespace rivulet::job {

void PlanWriter::writeParts(std::size_t until) {
  bool isAfterNative = false;
  for (std::size_t at = 0; at < std::min(until, m_plan.parts.size()); ++at) {
    const Part& part = m_plan.parts[at];
    if (const auto* const native = std::get_if<NativeBlock>(&part)) {
      ++m_natives;
      if (!native->text.empty()) {
        writeNative(*native, isAfterNative);
        isAfterNative = !native->isInserted;
      }
      continue;
    }
    isAfterNative = false;
    if (const auto& stretch = std::get<Stretch>(part); stretch.number > 0) {
      line("; STRETCH {}: lines {} to {}, {} points", stretch.number,
           stretch.blocks.front().line.value, stretch.blocks.back().line.value, stretch.pointCount);
      line("G710 DIAMOF G40");
      cancelFrame();
      writeStreamed(stretch);
    }
  }
}

void PlanWriter::writeNative(const NativeBlock& native, bool isAfterNative) {
  line("; LINE {}{}: {}", native.file.empty() ? std::string() : native.file + " ",
       native.place.line.value, nativeReasonName(native.reason));
  writeDue(native, m_natives);
  if (isForeign()) {
    line("G17 G90 G94 G710 DIAMOF");  // a tool length of the others acts along Z in each plane
  } else if (!isAfterNative) {
    line("G710 DIAMOF");
    cancelFrame();
    for (const std::string& frame : native.frame) {
      line("{}", frame);
    }
    if (native.before.feedOverride == 1.0) {
      cancelOverride();
    }
    line("{}", modalWords(native.before));
    m_hasFrame = !native.frame.empty();
  }
  beforeText(textOf(native));
  put(textOf(native));
  written(native, m_natives);
  m_hasOverride = m_hasOverride || native.before.feedOverride != 1.0 ||
                  base::toUpper(native.text).find("OVR") != std::string::npos;
  m_hasFrame = m_hasFrame || native.setsFrame || native.reason == NativeReason::Subprogram;
}

void PlanWriter::append(const std::string& text) {
  m_text += text;
  m_text += '\n';
  m_lines += 1 + static_cast<unsigned>(std::count(text.begin(), text.end(), '\n'));
}

void PlanWriter::cancelFrame() {
  if (m_hasFrame) {
    line("TRANS");
    m_hasFrame = false;
  }
}

void PlanWriter::cancelOverride() {
  if (m_hasOverride) {
    line("OVR=100");
    m_hasOverride = false;
  }
}

std::string modalWords(const nc::ModalState& state) {
  static constexpr std::array<std::string_view, 4> kMotions{"G0", "G1", "G2", "G3"};
  std::string words;
  if (state.motion < nc::Motion::None) {
    words += fmt::format("{} ", kMotions[static_cast<std::size_t>(state.motion)]);
  }
  words += state.planeFirstAxis == 0 ? "G17" : state.planeFirstAxis == 2 ? "G18" : "G19";
  words += state.relative ? " G91" : " G90";
  const bool inches = state.lengthFactor != 1.0;
  words += !inches ? " G710" : state.feedFactor != 1.0 ? " G700" : " G70";
  words += !state.diameter ? " DIAMOF" : state.diameterIncrements ? " DIAMON" : " DIAM90";
  words += state.blockEnd == nc::BlockEnd::ExactStop ? " G60" : " G64";
  if (state.feedMode == nc::FeedMode::PerRevolution) {
    words += " G95";
    if (state.feedMmPerRev > 0.0) {
      words += " F" + nc::ncNumber(state.feedMmPerRev / state.lengthFactor);
    }
  } else if (state.feedMode == nc::FeedMode::InverseTime) {
    words += " G93";
  } else {
    words += " G94";
    if (state.feedMmPerS > 0.0) {
      words += " F" + nc::ncNumber(state.feedMmPerS * 60.0 / state.feedFactor);
    }
  }
  if (state.feedOverride != 1.0) {
    words += " OVR=" + nc::ncNumber(100.0 * state.feedOverride);
  }
  return words;
}

}  // namespace rivulet::job
