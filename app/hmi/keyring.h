// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Where passwords are kept: the keyring of the system (Secret Service or KWallet). Answers come
/// later, on the GUI thread. @threadsafety GUI thread.
#pragma once

#include <QString>
#include <functional>
#include <memory>

namespace rivulet::hmi {

class Keyring {
 public:
  enum class Outcome {
    Done,
    NotKept,  ///< there is no such password
    Missing,  ///< no keyring can be reached
    Refused,  ///< it is locked, or its user said no
  };

  virtual ~Keyring() = default;
  /// @param key  under which it is kept, "setter@opc.tcp://cell-4:4840"
  virtual void read(const QString& key,
                    std::function<void(Outcome, const QString& password)> answer) = 0;
  virtual void write(const QString& key, const QString& password,
                     std::function<void(Outcome)> answer) = 0;
  virtual void remove(const QString& key, std::function<void(Outcome)> answer) = 0;
};

/// That of the system; one that is missing if this build has none.
[[nodiscard]] std::unique_ptr<Keyring> systemKeyring();

}  // namespace rivulet::hmi
