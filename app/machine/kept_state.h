// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What a control keeps when its power fails: R-parameters, part programs and, by absolute
/// encoders, the positions of the axes. The virtual machine keeps them in a folder, so that it can
/// be killed at any moment. Not kept, as on a control: the selected program's execution, overlays,
/// alarms.
///
/// R-parameters and positions are one snapshot of one moment: `state` has room for two, which are
/// written in turn with a number and a hash, so one of them is whole at any time. The blocks
/// executed before that moment are in `executed.txt` for whoever judges a run afterwards; the
/// snapshot says how many bytes of it belong to it. The snapshot survives the death of the program;
/// a loss of power of the computer may take it back by some seconds, as a whole.
/// @threadsafety one object, one thread; the folder belongs to one program at a time.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/file_lock.h"
#include "base/result.h"
#include "machine/config.h"
#include "machine/machine.h"

namespace rivulet::machine {

class KeptState {
 public:
  /// Opens the folder, or makes it. @param config  gets the positions that were kept
  /// @return FileError: the folder is in use, cannot be written, or is of another machine
  [[nodiscard]] static base::Result<KeptState> open(const std::filesystem::path& folder,
                                                    MachineConfig& config);
  ~KeptState();
  KeptState(KeptState&& other) noexcept;
  KeptState& operator=(KeptState&&) = delete;

  /// Gives a machine that has just been switched on what was kept.
  void restore(Machine& machine) const;
  /// Keeps what the machine is and has executed now. @return NotWritable
  base::Result<void> keep(const Machine& machine);

 private:
  KeptState(std::filesystem::path folder, base::FileLock file, int executed)
      : m_folder(std::move(folder)), m_file(std::move(file)), m_executed(executed) {}
  [[nodiscard]] bool load();
  void keepBlocks(const Machine& machine);
  base::Result<void> keepPrograms(const Machine& machine);

  std::filesystem::path m_folder;
  base::FileLock m_file;  ///< "state"
  int m_executed = -1;
  std::uint64_t m_number = 0;         ///< of the snapshot written last
  std::uint64_t m_executedBytes = 0;  ///< of `executed.txt` that belong to it
  std::vector<double> m_values;       ///< of the snapshot: positions, then R-parameters
  std::map<std::string, std::uint64_t> m_programs;  ///< hashes of those on disk
  base::Instant m_lastFrom{};                       ///< of the last block written
  std::size_t m_blocks = 0;                         ///< of the machine's trace that are written
};

}  // namespace rivulet::machine
