// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What a certificate says, as text for people, the same wherever one is shown.
/// @threadsafety GUI thread.
#pragma once

#include <QString>
#include <string>
#include <string_view>
#include <vector>

#include "opcua/certificate.h"

namespace rivulet::widgets {

/// A fingerprint in four lines of eight bytes, as two of them are compared.
[[nodiscard]] QString fingerprintLines(std::string_view fingerprint);
/// "2026-11-23 to 2031-11-22"
[[nodiscard]] QString validityText(const opcua::CertificateFacts& facts);
/// Its name, or that nobody else has issued it.
[[nodiscard]] QString issuerText(const opcua::CertificateFacts& facts);
/// Text that came from outside, so that it can be shown: cut if it is very long, able to be broken
/// into lines, and without the characters that change the direction of the text around it.
[[nodiscard]] QString untrustedText(const std::string& text);
/// With commas, or that there is none.
[[nodiscard]] QString listText(const std::vector<std::string>& texts);

}  // namespace rivulet::widgets
