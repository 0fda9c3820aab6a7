// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "platform/process.h"

#include <windows.h>

#include <shellapi.h>

#include <array>
#include <cstdlib>
#include <memory>

namespace rivulet::platform {

namespace {

constexpr DWORD kNameMax = 257;

std::string utf8Of(const wchar_t* text) {
  const int size = WideCharToMultiByte(CP_UTF8, 0, text, -1, nullptr, 0, nullptr, nullptr);
  std::string bytes(static_cast<std::size_t>(size > 0 ? size : 1), '\0');
  WideCharToMultiByte(CP_UTF8, 0, text, -1, bytes.data(), size, nullptr, nullptr);
  bytes.pop_back();  // the zero at the end
  return bytes;
}

std::wstring wideOf(const char* text) {
  const int size = MultiByteToWideChar(CP_UTF8, 0, text, -1, nullptr, 0);
  std::wstring wide(static_cast<std::size_t>(size > 0 ? size : 1), L'\0');
  MultiByteToWideChar(CP_UTF8, 0, text, -1, wide.data(), size);
  wide.pop_back();
  return wide;
}

}  // namespace

std::string userName() {
  std::array<wchar_t, kNameMax> name{};
  DWORD size = kNameMax;
  return GetUserNameW(name.data(), &size) != 0 ? utf8Of(name.data()) : "unknown";
}

std::string hostName() {
  std::array<wchar_t, kNameMax> name{};
  DWORD size = kNameMax;
  return GetComputerNameExW(ComputerNameDnsHostname, name.data(), &size) != 0 ? utf8Of(name.data())
                                                                              : std::string();
}

int processId() {
  return static_cast<int>(GetCurrentProcessId());
}

std::optional<std::string> variable(const char* name) {
  const wchar_t* value = _wgetenv(wideOf(name).c_str());
  return value != nullptr ? std::optional(utf8Of(value)) : std::nullopt;
}

/// What `main` gets is in the code page of the system, which lacks most letters.
std::vector<std::string> arguments(int argc, const char* const* argv) {
  int count = 0;
  const std::unique_ptr<LPWSTR[], decltype(&LocalFree)> words(
      CommandLineToArgvW(GetCommandLineW(), &count), &LocalFree);
  if (!words) {
    return {argv, argv + argc};
  }
  std::vector<std::string> texts;
  for (int i = 0; i < count; ++i) {
    texts.push_back(utf8Of(words[static_cast<std::size_t>(i)]));
  }
  return texts;
}

}  // namespace rivulet::platform
