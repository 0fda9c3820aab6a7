// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/signal_file.h"

#include <string>

#include "base/contract.h"
#include "base/file.h"
#include "base/text.h"
#include "trace/hdf5.h"

namespace rivulet::trace {

namespace {

enum class Format { None, Table, Hdf5 };

Format formatOf(const std::filesystem::path& path) {
  const std::string suffix = base::toUpper(path.extension().string());
  if (suffix == ".CSV") {
    return Format::Table;
  }
  return suffix == ".H5" || suffix == ".HDF5" ? Format::Hdf5 : Format::None;
}

}  // namespace

SignalFile signalFileOf(const ShownTrace& shown) {
  SignalFile file;
  for (const Channel& channel : shown.signalSet.channels()) {
    if (!channel.samples->empty()) {
      file.exported.push_back({channel.name, channel.unit, channel.samples});
    }
  }
  file.events = shown.events;
  file.from = base::Instant::min();
  file.to = base::Instant::max() - base::Duration{1};
  return file;
}

bool isSignalFile(const std::filesystem::path& path) {
  return formatOf(path) != Format::None;
}

base::Result<void> saveSignals(const std::filesystem::path& path, const SignalFile& file) {
  RIVULET_ASSERT(isSignalFile(path));
  if (formatOf(path) == Format::Table) {
    return base::writeFile(
        path, printSignals(file.exported, file.from, file.to, file.timeName, file.timeUnit));
  }
  const auto image =
      printHdf5(file.exported, file.events, file.from, file.to, file.timeName, file.timeUnit);
  return image ? base::writeFile(path, *image) : base::Result<void>(base::fail(image.error()));
}

}  // namespace rivulet::trace
