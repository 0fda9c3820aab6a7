// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "platform/terminal.h"

#include <windows.h>

#include <array>

namespace rivulet::platform {

namespace {

/// A pipe is no console, and neither is the null device, which the C library takes for a terminal.
bool isConsole(DWORD standard) {
  DWORD mode = 0;
  return GetConsoleMode(GetStdHandle(standard), &mode) != 0;
}

HANDLE openConsole(const wchar_t* name) {
  return CreateFileW(name, GENERIC_READ | GENERIC_WRITE, FILE_SHARE_READ | FILE_SHARE_WRITE,
                     nullptr, OPEN_EXISTING, 0, nullptr);
}

}  // namespace

bool isInputTerminal() {
  return isConsole(STD_INPUT_HANDLE);
}

bool isErrorTerminal() {
  return isConsole(STD_ERROR_HANDLE);
}

bool isInForeground() {
  return true;
}

struct SingleKeys::Mode {};

SingleKeys::SingleKeys(std::unique_ptr<Mode> before) : m_before(std::move(before)) {
}

/// The console brings each key at once to whoever asks for keys (`readNow`).
std::unique_ptr<SingleKeys> SingleKeys::take() {
  return isInputTerminal() ? std::unique_ptr<SingleKeys>(new SingleKeys(std::make_unique<Mode>()))
                           : nullptr;
}

SingleKeys::~SingleKeys() = default;

bool askInSecret(const std::string& question, std::string& answer) {
  HANDLE input = openConsole(L"CONIN$");
  HANDLE output = openConsole(L"CONOUT$");
  DWORD before = 0;
  const bool isThere = output != INVALID_HANDLE_VALUE && GetConsoleMode(input, &before) != 0 &&
                       SetConsoleMode(input, ENABLE_LINE_INPUT | ENABLE_PROCESSED_INPUT) != 0;
  if (isThere) {
    DWORD count = 0;
    const auto print = [&](const std::string& text) {
      WriteConsoleA(output, text.data(), static_cast<DWORD>(text.size()), &count, nullptr);
    };
    print(question);
    constexpr DWORD kLineMax = 1024;
    std::array<wchar_t, kLineMax> line{};
    if (ReadConsoleW(input, line.data(), kLineMax - 1, &count, nullptr) == 0) {
      count = 0;
    }
    while (count > 0 && (line[count - 1] == L'\n' || line[count - 1] == L'\r')) {
      --count;
    }
    std::array<char, 4 * kLineMax> bytes{};
    const int size =
        WideCharToMultiByte(CP_UTF8, 0, line.data(), static_cast<int>(count), bytes.data(),
                            static_cast<int>(bytes.size()), nullptr, nullptr);
    answer.assign(bytes.data(), static_cast<std::size_t>(size));
    print("\r\n");
    SetConsoleMode(input, before);
  }
  for (HANDLE handle : {input, output}) {
    if (handle != INVALID_HANDLE_VALUE) {
      CloseHandle(handle);
    }
  }
  return isThere;
}

}  // namespace rivulet::platform
