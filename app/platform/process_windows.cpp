// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "platform/process.h"

#include <windows.h>

#include <shellapi.h>

#include <array>
#include <cstdlib>
#include <cwchar>
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

/// libstdc++ makes names of files from text by this function. The C library's knows the code pages
/// of Windows, and UTF-8 is none of them: it would take each byte for a letter. All texts here are
/// UTF-8, so the programs have this one instead; it is linked because each of them asks for its
/// `arguments`. A letter of four bytes becomes two units of UTF-16: three bytes are taken with the
/// first, which leaves the second in `state`, and one with the second. A byte that is no UTF-8
/// becomes U+FFFD, so that such a name is of no file.
extern "C" std::size_t mbrtowc(wchar_t* to, const char* from, std::size_t size,
                               std::mbstate_t* state) {
  wchar_t unused = L'\0';
  wchar_t& unit = to != nullptr ? *to : unused;
  static thread_local std::mbstate_t own{};
  std::mbstate_t& left = state != nullptr ? *state : own;
  if (from == nullptr || size == 0) {
    left = {};
    return 0;
  }
  if (left != std::mbstate_t{}) {
    unit = static_cast<wchar_t>(left);
    left = {};
    return 1;
  }
  const auto lead = static_cast<unsigned char>(*from);
  const std::size_t length = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
  std::array<wchar_t, 2> units{};
  const int count = length <= size ? MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, from,
                                                         static_cast<int>(length), units.data(), 2)
                                   : 0;
  unit = count > 0 ? units[0] : L'\xFFFD';
  if (count == 2) {
    left = units[1];
    return length - 1;
  }
  return count == 0 ? 1 : unit == L'\0' ? 0 : length;
}
