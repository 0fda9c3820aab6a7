// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/kept_state.h"

#include <fmt/format.h>

#include <array>
#include <cstring>
#include <string_view>
#include <utility>

#include "base/descriptor.h"
#include "base/file.h"
#include "base/hash.h"
#include "base/units.h"

namespace rivulet::machine {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kMagic = 0x31204554'41545352ULL;
constexpr std::size_t kPositions = base::kAxisCount + base::kRotaryAxisCount;

struct SlotHead {
  std::uint64_t magic = kMagic;
  std::uint64_t number = 0;  ///< the higher one counts
  std::uint64_t executedBytes = 0;
  std::uint64_t hash = 0;  ///< of the values, with number and bytes
};

std::uint64_t hashOfSlot(const SlotHead& head, const std::vector<double>& values) {
  std::string bytes(values.size() * sizeof(double), '\0');
  std::memcpy(bytes.data(), values.data(), bytes.size());
  return base::hashOfFile(bytes) ^ ((head.number + 1) * base::kHashPrime) ^ head.executedBytes;
}

std::size_t slotBytes(std::size_t values) {
  return sizeof(SlotHead) + values * sizeof(double);
}

base::Error unusable(const fs::path& folder, const std::string& why) {
  return base::makeError(base::FileError::NotWritable, why, folder.string());
}

fs::path programsOf(const fs::path& folder) {
  return folder / "programs";
}

}  // namespace

base::Result<KeptState> KeptState::open(const fs::path& folder, MachineConfig& config) {
  std::error_code ignored;  // opening says what is wrong
  fs::create_directories(programsOf(folder), ignored);
  auto file = base::FileLock::tryToTake(folder / "state");
  if (file && !*file) {
    return base::fail(
        unusable(folder, "Another rivulet-machine uses this folder. Choose another one."));
  }
  const int executed = file ? base::openToWrite(folder / "executed.txt") : -1;
  if (executed < 0) {
    return base::fail(unusable(folder,
                               "The folder for the state of the machine cannot be written. "
                               "Choose another one."));
  }
  KeptState state(folder, std::move(**file), executed);
  state.m_values.resize(kPositions + static_cast<std::size_t>(config.rParameterCount));
  const bool isNew = fs::file_size(folder / "state", ignored) == 0;
  if (!isNew && !state.load()) {
    return base::fail(unusable(folder,
                               "The state in this folder is damaged, or of a machine with another "
                               "number of R-parameters. Choose another folder, or delete it."));
  }
  if (!base::cutTo(executed, state.m_executedBytes)) {
    return base::fail(unusable(folder, "The folder for the state cannot be written."));
  }
  if (state.m_number > 0) {
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      config.axes[axis].startMm = state.m_values[axis];
    }
    for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
      if (config.rotaryAxes[axis]) {
        config.rotaryAxes[axis]->startDeg = state.m_values[base::kAxisCount + axis];
      }
    }
  }
  return state;
}

KeptState::KeptState(KeptState&& other) noexcept
    : m_folder(std::move(other.m_folder)),
      m_file(std::move(other.m_file)),
      m_executed(std::exchange(other.m_executed, -1)),
      m_number(other.m_number),
      m_executedBytes(other.m_executedBytes),
      m_values(std::move(other.m_values)),
      m_programs(std::move(other.m_programs)),
      m_lastFrom(other.m_lastFrom),
      m_blocks(other.m_blocks) {
}

KeptState::~KeptState() {
  if (m_executed >= 0) {
    base::closeFile(m_executed);
  }
}

bool KeptState::load() {
  const std::size_t bytes = slotBytes(m_values.size());
  std::vector<double> values(m_values.size());
  for (std::size_t slot = 0; slot < 2; ++slot) {
    const std::string text = base::readAt(m_file.descriptor(), slot * bytes, bytes);
    if (text.size() != bytes) {
      continue;
    }
    SlotHead head;
    std::memcpy(&head, text.data(), sizeof head);
    std::memcpy(values.data(), text.data() + sizeof head, bytes - sizeof head);
    if (head.magic == kMagic && head.number > m_number && head.hash == hashOfSlot(head, values)) {
      m_number = head.number;
      m_executedBytes = head.executedBytes;
      m_values = values;
    }
  }
  return m_number > 0;
}

void KeptState::restore(Machine& machine) const {
  if (m_number > 0) {
    for (std::size_t i = kPositions; i < m_values.size(); ++i) {
      machine.writeRParameter(static_cast<int>(i - kPositions), m_values[i]);
    }
  }
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(programsOf(m_folder), ignored)) {
    if (base::Result<std::string> text = base::readFile(entry.path())) {
      static_cast<void>(
          machine.storeProgram(entry.path().filename().string(), std::move(*text), true));
    }
  }
}

void KeptState::keepBlocks(const Machine& machine) {
  const std::vector<trace::ExecutedBlock>& blocks = machine.trace().blocks;
  if (blocks.size() < m_blocks || (m_blocks > 0 && blocks[m_blocks - 1].from != m_lastFrom)) {
    m_blocks = 0;  // of another start
  }
  std::string text;
  for (; m_blocks < blocks.size(); ++m_blocks) {
    const trace::ExecutedBlock& block = blocks[m_blocks];
    text += fmt::format("{} {} {} {} {} {} {} {}\n", block.targetMm.x, block.targetMm.y,
                        block.targetMm.z, block.targetDeg[0], block.targetDeg[1],
                        block.targetDeg[2], block.lengthMm, block.turnDeg);
    m_lastFrom = block.from;
  }
  if (!text.empty() && base::writeAt(m_executed, text, m_executedBytes) == 0) {
    m_executedBytes += text.size();
  }
}

base::Result<void> KeptState::keepPrograms(const Machine& machine) {
  for (const std::string& name : machine.programNames()) {
    const base::Result<std::string> text = machine.programText(name);
    if (!text || name.find('/') != std::string::npos) {
      continue;
    }
    const std::uint64_t hash = base::hashOfFile(*text);
    if (const auto known = m_programs.find(name);
        known != m_programs.end() && known->second == hash) {
      continue;
    }
    if (base::Result<void> written = base::writeFile(programsOf(m_folder) / name, *text);
        !written) {
      return written;
    }
    m_programs[name] = hash;
  }
  return {};
}

base::Result<void> KeptState::keep(const Machine& machine) {
  if (base::Result<void> kept = keepPrograms(machine); !kept) {
    return kept;
  }
  const std::uint64_t before = m_executedBytes;
  keepBlocks(machine);
  const MachineState now = machine.state();
  std::vector<double> values;
  values.reserve(m_values.size());
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    values.push_back(now.actualMm[axis] + now.zeroMm[axis]);
  }
  values.insert(values.end(), now.actualDeg.begin(), now.actualDeg.end());
  for (int cell = 0; machine.hasRParameter(cell); ++cell) {
    values.push_back(machine.ncRParameter(cell));
  }
  if (m_number > 0 && values == m_values && before == m_executedBytes) {
    return {};
  }
  m_values = std::move(values);
  SlotHead head;
  head.number = ++m_number;
  head.executedBytes = m_executedBytes;
  head.hash = hashOfSlot(head, m_values);
  std::string slot(slotBytes(m_values.size()), '\0');
  std::memcpy(slot.data(), &head, sizeof head);
  std::memcpy(slot.data() + sizeof head, m_values.data(), m_values.size() * sizeof(double));
  if (base::writeAt(m_file.descriptor(), slot, (m_number % 2) * slot.size()) != 0) {
    return base::fail(unusable(m_folder, "The state of the machine cannot be written."));
  }
  return {};
}

}  // namespace rivulet::machine
