// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "preparation/user_file.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>
#include <utility>

#include "base/file.h"
#include "platform/user_folders.h"

namespace rivulet::preparation {

using nlohmann::json;

namespace {

std::string member(const json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::optional<KeptUser> userOf(const json& object) {
  if (!object.is_object()) {
    return std::nullopt;
  }
  const auto role = permission::roleOfName(member(object, "role"));
  KeptUser user{member(object, "name"), role.value_or(permission::Role::Operator),
                member(object, "salt"), member(object, "hash")};
  return role && !user.name.empty() ? std::optional(std::move(user)) : std::nullopt;
}

std::optional<UserFile> fileOf(const std::string& text) {
  const json object = json::parse(text, nullptr, false);
  if (!object.is_object()) {
    return std::nullopt;
  }
  UserFile file;
  const auto users = object.find("users");
  if (users != object.end() && users->is_array()) {
    for (const json& value : *users) {
      auto user = userOf(value);
      if (!user) {
        return std::nullopt;
      }
      file.users.push_back(std::move(*user));
    }
  }
  const auto idle = object.find("idle_minutes");
  if (idle != object.end() && idle->is_number_integer()) {
    file.idleMinutes = std::max(0, idle->get<int>());
  }
  const bool hasEngineer =
      std::any_of(file.users.begin(), file.users.end(),
                  [](const KeptUser& user) { return user.role == permission::Role::Engineer; });
  return hasEngineer ? std::optional(std::move(file)) : std::nullopt;
}

}  // namespace

std::filesystem::path userFileOfUser() {
  return folders::configHome() / "rivulet" / "users.json";
}

base::Result<UserFile> readUsers(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) {
    return UserFile{};
  }
  const auto text = base::readFile(path);
  if (!text) {
    return base::fail(text.error());
  }
  auto file = fileOf(*text);
  if (!file) {
    // A damaged file must not make an engineer of everybody.
    return base::fail(std::make_error_code(std::errc::invalid_argument),
                      "The file of users is damaged. Restore it, or delete it to set the users up "
                      "again.",
                      path.string());
  }
  return *std::move(file);
}

}  // namespace rivulet::preparation
