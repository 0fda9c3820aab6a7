// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "service/machine_lock.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "base/descriptor.h"
#include "base/file.h"
#include "platform/process.h"
#include "report/run_store.h"

namespace rivulet::service {

std::error_code make_error_code(ServiceError code) {
  static const base::NamedCategory category("service");
  return {static_cast<int>(code), category};
}

std::string plainEndpoint(std::string endpoint) {
  std::transform(endpoint.begin(), endpoint.end(), endpoint.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  while (endpoint.ends_with('/')) {
    endpoint.pop_back();
  }
  constexpr std::string_view kScheme = "opc.tcp://";
  for (const std::string_view here : {"localhost:", "[::1]:"}) {
    if (endpoint.starts_with(std::string(kScheme) + std::string(here))) {
      endpoint.replace(kScheme.size(), here.size(), "127.0.0.1:");
    }
  }
  return endpoint;
}

base::Result<MachineLock> MachineLock::take(const std::filesystem::path& folder,
                                            const std::string& endpoint) {
  std::error_code status;
  std::filesystem::create_directories(folder, status);
  const std::filesystem::path path =
      folder / (report::plainName(plainEndpoint(endpoint)) + ".lock");
  auto lock = base::FileLock::tryToTake(path);
  if (!lock) {
    return base::fail(ServiceError::LockFailed,
                      "The lock of the machine cannot be made. Check the rights of its folder.",
                      path.string());
  }
  if (!*lock) {
    const auto owner = base::readFile(path);
    return base::fail(
        ServiceError::MachineTaken,
        fmt::format("Another service (process {}) already streams to this machine. Stop it, or "
                    "give this one another machine.",
                    owner && !owner->empty() ? *owner : "unknown"),
        endpoint);
  }
  // Only for the sentence of the next one.
  const int descriptor = (*lock)->descriptor();
  static_cast<void>(base::cutTo(descriptor, 0) &&
                    base::writeWhole(descriptor, std::to_string(platform::processId())) == 0);
  return MachineLock(std::move(**lock));
}

}  // namespace rivulet::service
