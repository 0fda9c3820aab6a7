// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Any bytes are a certificate that a stranger shows: what is read of it can be shown to a person,
// and depends on nothing but its own bytes.

#include <algorithm>
#include <string>

#include "fuzz/require.h"
#include "opcua/certificate.h"

using namespace rivulet;
using tests::require;

namespace {

/// No character changes the line around it.
void checkText(const std::string& text) {
  require(std::none_of(text.begin(), text.end(),
                       [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }));
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = tests::textOf(data, size);
  const std::string_view leaf = opcua::leafOf(bytes);
  require(leaf.size() <= bytes.size() && bytes.substr(0, leaf.size()) == leaf);
  const std::string typed = opcua::fingerprintOf(bytes);
  require(typed.empty() || opcua::fingerprintOf(opcua::fingerprintText(typed)) == typed);
  const auto facts = opcua::readCertificate(bytes);
  if (!facts) {
    require(!facts.error().message.empty());
    return 0;
  }
  const auto again = opcua::readCertificate(leaf);
  require(again && *again == *facts);
  require(opcua::fingerprintOf(facts->fingerprint) == facts->fingerprint &&
          !facts->fingerprint.empty());
  checkText(facts->subject);
  checkText(facts->issuer);
  for (const auto& list : {facts->applicationUris, facts->hostNames}) {
    std::for_each(list.begin(), list.end(), &checkText);
  }
  require(opcua::daysLeft(*facts, facts->validTo) == 0);
  return 0;
}
