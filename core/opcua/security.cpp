// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/security.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/text.h"
#include "opcua/error.h"
#include "opcua/node_map.h"

namespace rivulet::opcua {

namespace {

constexpr std::string_view kUriStem = "http://opcfoundation.org/UA/SecurityPolicy#";
constexpr std::string_view kStrongest = "strongest";

constexpr std::array<std::pair<SecurityPolicy, std::string_view>, 6> kPolicies{
    {{SecurityPolicy::None, "None"},
     {SecurityPolicy::Basic128Rsa15, "Basic128Rsa15"},
     {SecurityPolicy::Basic256, "Basic256"},
     {SecurityPolicy::Basic256Sha256, "Basic256Sha256"},
     {SecurityPolicy::Aes128Sha256RsaOaep, "Aes128_Sha256_RsaOaep"},
     {SecurityPolicy::Aes256Sha256RsaPss, "Aes256_Sha256_RsaPss"}}};

constexpr std::array<std::pair<MessageMode, std::string_view>, 3> kModes{
    {{MessageMode::None, "None"},
     {MessageMode::Sign, "Sign"},
     {MessageMode::SignAndEncrypt, "SignAndEncrypt"}}};

[[nodiscard]] bool sameWord(std::string_view left, std::string_view right) {
  return base::toUpper(left) == base::toUpper(right);
}

template <class Table>
[[nodiscard]] auto valueOf(const Table& table, std::string_view name)
    -> std::optional<typename Table::value_type::first_type> {
  for (const auto& [value, word] : table) {
    if (sameWord(word, name)) {
      return value;
    }
  }
  return std::nullopt;
}

/// Which of two offers is taken: the larger number. 0: it is not allowed.
[[nodiscard]] int rankOf(const ChannelSecurity& offer, const SecurityChoice& choice) {
  constexpr int kPreferred = 1000;
  const bool isNone = offer == ChannelSecurity{};
  if (isNone && choice.prefersNone && !choice.policy) {
    return kPreferred;
  }
  const bool isContradictory =
      (offer.policy == SecurityPolicy::None) != (offer.mode == MessageMode::None);
  const bool isPolicyAllowed =
      choice.policy ? *choice.policy == offer.policy : !isWeak(offer.policy);
  // Somebody in between could hide that a server encrypts, so Sign is taken by name only.
  const bool isModeAllowed =
      isNone || offer.mode == choice.mode.value_or(MessageMode::SignAndEncrypt);
  if (isContradictory || !isPolicyAllowed || !isModeAllowed) {
    return 0;
  }
  return 1 + static_cast<int>(offer.policy);
}

/// What the server would accept, as a list for people.
[[nodiscard]] std::string offeredText(std::span<const EndpointOffer> offers) {
  std::string text;
  for (const EndpointOffer& offer : offers) {
    const std::string name = securityText(offer.security);
    if (text.find(name) == std::string::npos) {
      text += (text.empty() ? "" : "; ") + name;
    }
  }
  return text.empty() ? "nothing" : text;
}

}  // namespace

std::string_view policyName(SecurityPolicy policy) {
  return kPolicies[static_cast<std::size_t>(policy)].second;
}

std::string policyUri(SecurityPolicy policy) {
  return std::string(kUriStem) + std::string(policyName(policy));
}

std::optional<SecurityPolicy> policyOfUri(std::string_view uri) {
  if (uri.substr(0, kUriStem.size()) != kUriStem) {
    return std::nullopt;
  }
  return valueOf(kPolicies, uri.substr(kUriStem.size()));
}

std::string_view modeName(MessageMode mode) {
  return kModes[static_cast<std::size_t>(mode) - 1].second;
}

std::string securityText(const ChannelSecurity& security) {
  return security.policy == SecurityPolicy::None
             ? "None"
             : fmt::format("{}, {}", policyName(security.policy), modeName(security.mode));
}

SecurityChoice unencrypted() {
  SecurityChoice choice;
  choice.policy = SecurityPolicy::None;
  return choice;
}

std::optional<SecurityChoice> securityChoiceOf(std::string_view text) {
  SecurityChoice choice;
  const std::size_t slash = text.find('/');
  const std::string_view name = text.substr(0, slash);
  if (!sameWord(name, kStrongest)) {
    choice.policy = valueOf(kPolicies, name);
    if (!choice.policy) {
      return std::nullopt;
    }
  }
  if (slash != std::string_view::npos) {
    choice.mode = valueOf(kModes, text.substr(slash + 1));
    if (!choice.mode || *choice.mode == MessageMode::None ||
        choice.policy == SecurityPolicy::None) {
      return std::nullopt;
    }
  }
  return choice;
}

std::string securityChoiceText(const SecurityChoice& choice) {
  std::string text(choice.policy ? policyName(*choice.policy) : kStrongest);
  if (choice.mode) {
    text += fmt::format("/{}", modeName(*choice.mode));
  }
  return text;
}

namespace {

[[nodiscard]] bool takes(const EndpointOffer& offer, LoginKind login) {
  switch (login) {
    case LoginKind::Anonymous:
      return offer.takesAnonymous;
    case LoginKind::UserName:
      return offer.takesUserName;
    case LoginKind::Certificate:
      break;
  }
  return offer.takesCertificate;
}

[[nodiscard]] const char* notTaken(LoginKind login) {
  switch (login) {
    case LoginKind::Anonymous:
      return "The server does not let anybody in without a user name. Give one, with its password.";
    case LoginKind::UserName:
      return "The server takes no user name with an encrypted password. Connect without a user, or "
             "set up encryption on the server.";
    case LoginKind::Certificate:
      break;
  }
  return "The server takes no certificate of a user. Give user name and password, or register the "
         "certificate on the server.";
}

}  // namespace

base::Result<std::size_t> chooseOffer(std::span<const EndpointOffer> offers,
                                      const SecurityChoice& choice, LoginKind login) {
  std::optional<std::size_t> best;
  int bestRank = 0;
  bool isOffered = false;
  for (std::size_t i = 0; i < offers.size(); ++i) {
    const int rank = rankOf(offers[i].security, choice);
    const bool letsIn = takes(offers[i], login);
    isOffered = isOffered || rank > 0;
    if (letsIn && rank > bestRank) {
      best = i;
      bestRank = rank;
    }
  }
  if (best) {
    return *best;
  }
  if (isOffered) {
    return base::fail(LinkError::LoginRefused, notTaken(login));
  }
  return base::fail(
      LinkError::EncryptionMissing,
      fmt::format("The server does not offer the protection that is asked for ({}). It offers: {}. "
                  "Set up encryption on the server, or allow one of these by its name.",
                  securityChoiceText(choice), offeredText(offers)));
}

std::vector<SecurityChoice> choicesByName(std::span<const EndpointOffer> offers, LoginKind login) {
  std::vector<ChannelSecurity> found;
  for (const EndpointOffer& offer : offers) {
    const SecurityChoice named{offer.security.policy, offer.security.mode, false};
    if (takes(offer, login) && rankOf(offer.security, named) > 0 &&
        std::find(found.begin(), found.end(), offer.security) == found.end()) {
      found.push_back(offer.security);
    }
  }
  std::sort(found.begin(), found.end(), [](const auto& left, const auto& right) {
    return std::pair(left.policy, left.mode) > std::pair(right.policy, right.mode);
  });
  std::vector<SecurityChoice> choices;
  for (const ChannelSecurity& security : found) {
    SecurityChoice choice;
    choice.policy = security.policy;
    if (security.mode == MessageMode::Sign) {
      choice.mode = security.mode;
    }
    choices.push_back(choice);
  }
  return choices;
}

std::string hostOf(std::string_view endpoint) {
  const std::size_t scheme = endpoint.find("://");
  std::string_view host = scheme == std::string_view::npos ? endpoint : endpoint.substr(scheme + 3);
  host = host.substr(0, host.find('/'));
  if (!host.empty() && host.front() == '[') {
    return std::string(host.substr(1, host.find(']') - 1));
  }
  return std::string(host.substr(0, host.find(':')));
}

std::uint16_t portOf(std::string_view endpoint) {
  const std::size_t scheme = endpoint.find("://");
  std::string_view rest = scheme == std::string_view::npos ? endpoint : endpoint.substr(scheme + 3);
  rest = rest.substr(0, rest.find('/'));
  const std::size_t bracket = rest.find(']');
  const std::size_t colon = rest.find(':', bracket == std::string_view::npos ? 0 : bracket);
  if (colon == std::string_view::npos) {
    return kPort;
  }
  constexpr int kPortMax = 65'535;
  const auto port = base::parseInteger(rest.substr(colon + 1));
  return port && *port > 0 && *port <= kPortMax ? static_cast<std::uint16_t>(*port) : 0;
}

bool isLoopback(std::string_view endpoint) {
  const std::string host = hostOf(endpoint);
  if (sameWord(host, "localhost") || host == "::1") {
    return true;
  }
  // 127.0.0.0/8, written as four numbers: a name may begin with "127." as well.
  return host.substr(0, 4) == "127." &&
         host.find_first_not_of("0123456789.") == std::string_view::npos;
}

Protection protectionOf(const ChannelSecurity& security, std::string_view endpoint) {
  if (security.policy == SecurityPolicy::None || security.mode == MessageMode::None) {
    return isLoopback(endpoint) ? Protection::LocalOnly : Protection::None;
  }
  if (isWeak(security.policy)) {
    return Protection::Weak;
  }
  return security.mode == MessageMode::SignAndEncrypt ? Protection::Encrypted : Protection::Signed;
}

}  // namespace rivulet::opcua
