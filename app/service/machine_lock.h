// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// One service for one machine: a lock that this computer's services share, by the machine's
/// address. It ends with the process, however that ends. Services on other computers are told apart
/// by the claim of the cells. @threadsafety owns a lock; shares nothing.
#pragma once

#include <filesystem>
#include <string>
#include <utility>

#include "base/file_lock.h"
#include "base/result.h"

namespace rivulet::service {

enum class ServiceError {
  MachineTaken = 1,  ///< another service has it
  LockFailed,        ///< the lock's file cannot be made
  BadSettings,       ///< a setting of a job is not known, or out of range
  NotAJob,           ///< the program cannot be run as it is
};

[[nodiscard]] std::error_code make_error_code(ServiceError code);

class MachineLock {
 public:
  /// @param folder  of the locks; made if it is missing  @param endpoint  of the machine
  /// @return MachineTaken, LockFailed
  [[nodiscard]] static base::Result<MachineLock> take(const std::filesystem::path& folder,
                                                      const std::string& endpoint);

 private:
  explicit MachineLock(base::FileLock lock) : m_lock(std::move(lock)) {}

  base::FileLock m_lock;
};

/// The same for every way to write the address of a machine on this computer.
[[nodiscard]] std::string plainEndpoint(std::string endpoint);

}  // namespace rivulet::service

template <>
struct std::is_error_code_enum<rivulet::service::ServiceError> : std::true_type {};
