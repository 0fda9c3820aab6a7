// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "support/drawn_job.h"

#include <QtTest>
#include <algorithm>
#include <array>
#include <cmath>

#include "base/random.h"
#include "base/text.h"
#include "opcua/await.h"
#include "streaming/recovery/run_on_control.h"
#include "streaming/simulation/simulated_link.h"

namespace rivulet::tests {

namespace {

std::string rounded(base::Vec3 mm) {
  std::string text;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    text += std::to_string(std::lround(mm[axis] * 100.0)) + ' ';
  }
  return text;
}

std::string joined(const std::vector<std::string>& ends) {
  std::string text;
  for (const std::string& end : ends) {
    text += end + "\n";
  }
  return text;
}

/// Where the axes are, and whether a program is active.
std::array<double, 4> told(opcua::Link& link) {
  const std::array<opcua::Variable, 4> all{{{opcua::VariableKind::ActualPosition, 0},
                                            {opcua::VariableKind::ActualPosition, 1},
                                            {opcua::VariableKind::ActualPosition, 2},
                                            {opcua::VariableKind::ChannelStatus, 0}}};
  const auto numbers = opcua::readNumbers(link, all, std::chrono::seconds{1});
  std::array<double, 4> place{};
  for (std::size_t i = 0; numbers && i < all.size(); ++i) {
    place[i] = (*numbers)[i];
  }
  return place;
}
bool isSame(const streaming::JobRest& a, const streaming::JobRest& b) {
  constexpr double kRoundedMm = 0.05;
  const auto pointOf = [](const streaming::JobRest& rest) {
    return rest.resume ? std::optional(rest.resume->point) : std::nullopt;
  };
  return a.part == b.part && pointOf(a) == pointOf(b) &&
         a.toolMm.has_value() == b.toolMm.has_value() &&
         (!a.toolMm || base::distance(*a.toolMm, *b.toolMm) <= kRoundedMm);
}
std::string textOf(const base::Result<streaming::JobRest>& rest) {
  return rest ? "part " + std::to_string(rest->part) + " point " +
                    std::to_string(rest->resume ? rest->resume->point : 0)
              : rest.error().text();
}

}  // namespace

machine::MachineConfig mill() {
  return *machine::loadPreset("dmu75-mill");
}

job::Plan planOf(const std::string& text) {
  gcode::LoadOptions options;
  options.dialect = gcode::Dialect::Sinumerik;
  const auto plan = job::makePlan("PART.MPF", text, options);
  if (!plan || !plan->isWhole()) {
    qFatal("the test's program is no job");
  }
  return *plan;
}

std::string drawPart(std::uint64_t seed, int pointsMax) {
  base::Random random(seed);
  const auto below = [&random](int n) {
    return static_cast<int>(random.uniform() * static_cast<double>(n));
  };
  std::string text = "G54\nT1 D1 M6\nS3000 M3\nG0 X0 Y0\nZ30\n";
  const int sections = 2 + below(6);
  for (int section = 0; section < sections; ++section) {
    switch (below(6)) {
      case 0:
        text += "SUPA G0 Z200 D0\nT" + std::to_string(1 + below(6)) + " M6\nD1\nS" +
                std::to_string(1000 + below(5000)) + " M3\nG0 X0 Y0\nZ30\n";
        break;
      case 1:
        text += "G5" + std::to_string(4 + below(3)) + "\nG0 X1 Y1\nZ30\n";
        break;
      case 2:
        text += "F300\nMCALL CYCLE81(20,0,2,-5)\nX10 Y10\nX30\nMCALL\nG0 X0 Y0\nZ30\n";
        break;
      case 3:
        text += "M8\nG4 F0.5\n";
        break;
      case 4:
        text += "M9\nS" + std::to_string(1000 + below(5000)) + " M4\n";
        break;
      default:
        text += "G4 F1\n";
    }
    text += "G0 X0.1 Y0.2\nG1 Z-1 F3000\n";
    // Steps of a few mm on a drawn zigzag.
    const int points = 5 + below(pointsMax - 4);
    double x = 0.0;
    double y = 0.0;
    for (int point = 0; point < points; ++point) {
      x += 0.5 + 3.0 * random.uniform();
      y += 6.0 * random.uniform() - 3.0;
      if (x > 60.0) {
        x -= 60.0;
      }
      text += "X" + base::formatFixed(x, 6) + " Y" + base::formatFixed(y, 6) + "\n";
    }
    text += "G0 Z30\n";
  }
  return text + "M5 M9\nM30\n";
}

trace::ControlTrace traceOfSource(const std::string& text) {
  machine::Machine machine(mill(), 1);
  streaming::SimulatedLink link(machine);
  if (!link.uploadProgram("PART.MPF", text, true) || !link.selectProgram("PART.MPF") ||
      !link.cycleStart()) {
    qFatal("the source does not start");
  }
  while (machine.state().channel != machine::ChannelStatus::Reset) {
    (void)link.wait(link.now() + std::chrono::milliseconds{100});
  }
  return *link.fetchTrace();
}

std::vector<std::string> motions(const trace::ControlTrace& trace) {
  std::vector<std::string> ends;
  for (const trace::ExecutedBlock& block : trace.blocks) {
    if (block.lengthMm > 0.01) {
      ends.push_back(rounded(block.targetMm));
    }
  }
  return ends;
}

std::vector<std::string> toolChanges(const trace::ControlTrace& trace) {
  std::vector<std::string> tools;
  for (const trace::ControlEvent& event : trace.events) {
    if (event.kind == trace::ControlEvent::Kind::ToolChange) {
      tools.push_back(std::to_string(std::lround(event.value)));
    }
  }
  return tools;
}

bool isAtNextEnd(const trace::ControlTrace& source, std::size_t motionsBefore,
                 const streaming::JobRest& rest,
                 const std::function<base::Result<base::Vec3>(std::size_t part)>& zeroAt) {
  constexpr double kNoMotionMm = 0.01;
  for (const trace::ExecutedBlock& block : source.blocks) {
    if (block.lengthMm <= kNoMotionMm || motionsBefore-- > 0) {
      continue;
    }
    // In the frame of its own part, which is the one that is left or one beside it.
    for (std::size_t part = rest.part > 0 ? rest.part - 1 : 0; part <= rest.part + 1; ++part) {
      const auto zero = zeroAt(part);
      const auto zeroOfRest = zeroAt(rest.part);
      if (zero && zeroOfRest && rest.toolMm &&
          base::distance(block.targetMm + *zero, *rest.toolMm + *zeroOfRest) <= kNoMotionMm) {
        return true;
      }
    }
    return false;
  }
  return false;
}

void JobJudge::add(const std::vector<std::string>& part, bool mayBeComplete) {
  m_all += "next part:\n" + joined(part);
  if (!m_wrong.empty()) {
    return;
  }
  std::set<std::size_t> done;
  const std::size_t extras = m_isFirst ? 0 : std::min(m_extraMax, part.size());
  for (const std::size_t before : m_done) {
    for (std::size_t extra = 0; extra <= extras; ++extra) {
      // What was interrupted is in both.
      for (std::size_t from = before - std::min<std::size_t>(before, m_isFirst ? 0 : 1);
           from <= before + (m_mayBeComplete ? 1 : 0); ++from) {
        const std::size_t count = part.size() - extra;
        if (from + count <= m_source.size() &&
            std::equal(part.begin() + static_cast<std::ptrdiff_t>(extra), part.end(),
                       m_source.begin() + static_cast<std::ptrdiff_t>(from))) {
          done.insert(std::max(before, from + count));
        }
      }
    }
  }
  if (done.empty()) {
    m_wrong = "what was done is not what comes next\n";
  } else {
    m_done = std::move(done);
  }
  m_isFirst = false;
  m_mayBeComplete = mayBeComplete;
}

std::string JobJudge::verdict() const {
  const bool isWhole = m_done.contains(m_source.size());
  return m_wrong.empty() && isWhole ? std::string()
                                    : (m_wrong.empty() ? "what was done is not all\n" : m_wrong) +
                                          m_all + "source:\n" + joined(m_source);
}
const job::Plan& LeftJob::begin() {
  keeper.isOfThisStart = false;
  return restart ? restart->plan : plan;
}

base::Result<base::Vec3> LeftJob::zeroAt(std::size_t part) const {
  return forecast::zeroAt(plan, mill(), inSource({part, {}, {}}).part);
}

base::Result<void> LeftJob::goOn(opcua::Link& link, opcua::Control& control,
                                 const streaming::RunSettings& settings) {
  if (keeper.isOfThisStart) {
    kept = restart;
  }
  const auto ask = [&](streaming::ActiveProgram active = streaming::ActiveProgram::IsEnded) {
    return streaming::whereJobWasLeft(
        link, kept ? kept->plan : plan, settings, *keeper.last,
        [this](std::size_t part) { return zeroAt(part); }, active);
  };
  // What is computed while the program stands moves nothing, and is what comes.
  const auto stood = told(link);
  const auto foreseen = ask(streaming::ActiveProgram::Stays);
  constexpr double kSettlesMm = 0.001;
  const auto stands = told(link);
  const bool isActive = stood.back() != opcua::kChannelReset;  // else they may still brake
  if (isActive && !std::equal(stood.begin(), stood.end(), stands.begin(),
                              [](double a, double b) { return std::abs(a - b) <= kSettlesMm; })) {
    return base::fail(streaming::StreamError::WrongProgram, "a question moved the axes");
  }
  auto rest = ask();
  if (rest.has_value() != foreseen.has_value() || (rest && !isSame(*rest, *foreseen))) {
    return base::fail(streaming::StreamError::WrongProgram,
                      "not as foreseen: " + textOf(foreseen) + " became " + textOf(rest));
  }
  standing += foreseen && foreseen->restMm ? 1 : 0;
  withinWindow += foreseen && foreseen->restMm.value_or(0.0) > 0.0 ? 1 : 0;
  if (!rest && rest.error().code == streaming::StreamError::ChannelBusy) {
    const auto found = streaming::findRun(link, control, 0, std::chrono::seconds{3});
    if (!found) {
      return base::fail(found.error());
    }
    if (*found) {  // else it has ended meanwhile
      if (base::Result<void> ended = streaming::endRun(link, **found, settings); !ended) {
        return ended;
      }
    }
    rest = ask();
  }
  if (!rest) {
    return base::fail(rest.error());
  }
  auto made = forecast::restartAt(plan, mill(), inSource(*rest));
  if (!made) {
    return base::fail(made.error());
  }
  restart = *std::move(made);
  return {};
}

}  // namespace rivulet::tests
