// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/user.h"

#include <fmt/format.h>

#include "base/sha256.h"
#include "base/text.h"

namespace rivulet::machine {

namespace {

/// The server waits while a password is checked. With so many iterations a running stream loses
/// less time than a reserve of a window bridges.
constexpr int kIterations = 20'000;
constexpr int kIterationsMax = 1'000'000;
constexpr std::string_view kScheme = "pbkdf2-sha256";
constexpr std::size_t kHashDigits = 64;

/// Takes the text up to the next colon off the front.
[[nodiscard]] std::string_view takeField(std::string_view& text) {
  const std::string_view field = text.substr(0, text.find(':'));
  text.remove_prefix(field.size() == text.size() ? text.size() : field.size() + 1);
  return field;
}

}  // namespace

const std::set<std::string>& userRights() {
  static const std::set<std::string> rights{"ApWrite",      "FsRead",    "FsWrite",   "SinuReadAll",
                                            "SinuWriteAll", "StateRead", "StateWrite"};
  return rights;
}

HashedPassword hashPassword(std::string_view password, const std::string& salt) {
  return {kIterations, salt, base::passwordHashHex(password, salt, kIterations)};
}

std::string passwordText(const HashedPassword& password) {
  return fmt::format("{}:{}:{}:{}", kScheme, password.iterations, password.salt, password.hash);
}

std::optional<HashedPassword> passwordOfText(std::string_view text) {
  const std::string_view scheme = takeField(text);
  const auto iterations = base::parseInteger(takeField(text));
  HashedPassword password;
  password.salt = takeField(text);
  password.hash = text;
  if (scheme != kScheme || !iterations || *iterations < 1 || *iterations > kIterationsMax ||
      password.salt.empty() || password.hash.size() != kHashDigits) {
    return std::nullopt;
  }
  password.iterations = *iterations;
  return password;
}

bool isPassword(const HashedPassword& hashed, std::string_view password) {
  const std::string hash = base::passwordHashHex(password, hashed.salt, hashed.iterations);
  unsigned difference = hash.size() == hashed.hash.size() ? 0 : 1;
  for (std::size_t i = 0; i < hash.size() && i < hashed.hash.size(); ++i) {
    difference |= static_cast<unsigned char>(hash[i] ^ hashed.hash[i]);
  }
  return difference == 0;
}

}  // namespace rivulet::machine
