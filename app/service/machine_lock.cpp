// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "service/machine_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

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
  const int descriptor = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (descriptor < 0) {
    return base::fail(ServiceError::LockFailed,
                      "The lock of the machine cannot be made. Check the rights of its folder.",
                      path.string());
  }
  if (flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
    std::array<char, 32> owner{};
    const auto size = read(descriptor, owner.data(), owner.size() - 1);
    close(descriptor);
    return base::fail(
        ServiceError::MachineTaken,
        fmt::format("Another service (process {}) already streams to this machine. Stop it, or "
                    "give this one another machine.",
                    size > 0 ? std::string(owner.data()) : std::string("unknown")),
        endpoint);
  }
  const std::string own = std::to_string(getpid());
  const bool isWritten =
      ftruncate(descriptor, 0) == 0 &&
      pwrite(descriptor, own.data(), own.size(), 0) == static_cast<ssize_t>(own.size());
  static_cast<void>(isWritten);  // only for the sentence of the next one
  return MachineLock(descriptor);
}

MachineLock::~MachineLock() {
  if (m_descriptor >= 0) {
    close(m_descriptor);
  }
}

MachineLock::MachineLock(MachineLock&& other) noexcept
    : m_descriptor(std::exchange(other.m_descriptor, -1)) {
}

}  // namespace rivulet::service
