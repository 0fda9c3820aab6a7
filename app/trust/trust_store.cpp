// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trust/trust_store.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "base/file.h"
#include "base/private_file.h"
#include "base/sha256.h"
#include "opcua/error.h"
#include "trust/own_certificate.h"
#include "trust/private_file.h"

namespace rivulet::trust {

namespace fs = std::filesystem;
using nlohmann::json;
using opcua::LinkError;

namespace {

constexpr const char* kFile = "servers.json";
constexpr const char* kLock = "servers.lock";
constexpr const char* kDer = ".der";
constexpr const char* kAddress = ".address";
constexpr std::uintmax_t kAddressBytesMax = 4096;
constexpr const char* kTrusted = "trusted";
constexpr const char* kRejected = "rejected";
constexpr const char* kRevoked = "revoked";
constexpr const char* kCrl = ".crl";
constexpr const char* kFormat = "rivulet-servers";
constexpr int kVersion = 1;
constexpr std::uintmax_t kListBytesMax = std::uintmax_t{1} << 20U;
/// A stranger can show as many certificates as he likes; only so many are kept.
constexpr std::size_t kRejectedMax = 32;

/// The members of a server in the file.
constexpr std::array<std::pair<const char*, std::string KnownServer::*>, 8> kMembers{{
    {"endpoint", &KnownServer::endpoint},
    {"fingerprint", &KnownServer::fingerprint},
    {"security", &KnownServer::security},
    {"user", &KnownServer::user},
    {"user-certificate", &KnownServer::certificateFile},
    {"user-key", &KnownServer::keyFile},
    {"map", &KnownServer::mapFile},
    {"link", &KnownServer::link},
}};

std::string keyOf(std::string_view endpoint) {
  std::string key(endpoint);
  std::transform(key.begin(), key.end(), key.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  while (!key.empty() && key.back() == '/') {
    key.pop_back();
  }
  return key;
}

tl::unexpected<base::Error> damaged(const fs::path& path) {
  return base::fail(LinkError::CertificateInvalid,
                    "The list of trusted servers is damaged. Move the file away; every server is "
                    "then asked about again.",
                    path.string());
}

std::string dateText(base::UtcMs at) {
  constexpr std::size_t kDateLength = 10;
  return base::utcText(at).substr(0, kDateLength);
}

}  // namespace

std::string describe(const opcua::CertificateFacts& facts) {
  const std::string stranger =
      facts.strangerUri.empty() ? std::string() : ". " + strangerText(facts);
  return fmt::format("{}, valid from {} to {}, fingerprint {}{}", facts.subject,
                     dateText(facts.validFrom), dateText(facts.validTo),
                     opcua::fingerprintText(facts.fingerprint), stranger);
}

std::string strangerText(const opcua::CertificateFacts& facts) {
  return fmt::format(
      "This certificate was made for another application ({}) than the server says it is ({}): it "
      "may have been copied. Ask who looks after the control",
      facts.applicationUris.empty() ? "none" : facts.applicationUris.front(), facts.strangerUri);
}

void keepRejected(const fs::path& folder, const opcua::CertificateFacts& facts,
                  std::string_view der) {
  if (!base::makePrivateFolder(folder)) {
    return;
  }
  std::error_code status;
  const auto count = std::count_if(
      fs::directory_iterator(folder, status), fs::directory_iterator(),
      [](const fs::directory_entry& entry) { return entry.path().extension() == kDer; });
  const fs::path file = folder / (facts.fingerprint + kDer);
  if (!status && (fs::exists(file, status) || static_cast<std::size_t>(count) < kRejectedMax)) {
    (void)base::writeFile(file, der);
  }
}

base::Result<std::vector<KnownServer>> TrustStore::servers() const {
  const fs::path path = m_folder / kFile;
  std::error_code status;
  if (!fs::exists(path, status)) {
    return std::vector<KnownServer>{};
  }
  const auto text = base::readFile(path, kListBytesMax);
  if (!text) {
    return base::fail(text.error());
  }
  const json file = json::parse(*text, nullptr, false);
  if (!file.is_object() || file.value("format", json()) != kFormat || !file.contains("servers") ||
      !file["servers"].is_array()) {
    return damaged(path);
  }
  std::vector<KnownServer> servers;
  for (const json& entry : file["servers"]) {
    KnownServer server;
    for (const auto& [name, member] : kMembers) {
      if (entry.is_object() && entry.contains(name) && entry[name].is_string()) {
        server.*member = entry[name].get<std::string>();
      }
    }
    const bool isFingerprint = server.fingerprint.empty() ||
                               opcua::fingerprintOf(server.fingerprint) == server.fingerprint;
    const bool isSecurity =
        server.security.empty() || opcua::securityChoiceOf(server.security).has_value();
    if (server.endpoint.empty() || !isFingerprint || !isSecurity) {
      return damaged(path);
    }
    servers.push_back(server);
  }
  return servers;
}

base::Result<std::optional<KnownServer>> TrustStore::find(std::string_view endpoint) const {
  const auto known = servers();
  if (!known) {
    return base::fail(known.error());
  }
  const std::string key = keyOf(endpoint);
  const auto server = std::find_if(known->begin(), known->end(),
                                   [&](const KnownServer& one) { return one.endpoint == key; });
  return server == known->end() ? std::nullopt : std::optional(*server);
}

base::Result<void> TrustStore::check(const std::string& endpoint,
                                     const opcua::CertificateFacts& facts, std::string_view der,
                                     base::UtcMs now) const {
  const auto known = find(endpoint);
  if (!known) {
    return base::fail(known.error());
  }
  const std::string accepted = *known ? (*known)->fingerprint : std::string();
  if (accepted != facts.fingerprint) {
    const fs::path kept = m_folder / kRejected;
    keepRejected(kept, facts, der);
    std::error_code status;
    if (fs::exists(kept / (facts.fingerprint + kDer), status)) {
      (void)base::writeFile(kept / (facts.fingerprint + kAddress), endpoint);
    }
    if (accepted.empty()) {
      return base::fail(LinkError::CertificateUnknown,
                        fmt::format("This server is not known yet. Its certificate: {}. Compare "
                                    "the fingerprint with the one that the control shows, then "
                                    "accept it.",
                                    describe(facts)));
    }
    return base::fail(
        LinkError::CertificateChanged,
        fmt::format("The server shows another certificate than the one that was accepted ({}). "
                    "Either it was renewed, or somebody stands between. The new one: {}. Ask who "
                    "looks after the control before accepting it.",
                    opcua::fingerprintText(accepted), describe(facts)));
  }
  if (!opcua::isValidAt(facts, now)) {
    return base::fail(LinkError::CertificateInvalid,
                      fmt::format("The certificate of the server is valid from {} to {} only. Set "
                                  "the clocks of both computers, or renew it on the control.",
                                  dateText(facts.validFrom), dateText(facts.validTo)));
  }
  return checkRevocation(der, "of the server");
}

std::optional<opcua::CertificateFacts> TrustStore::keptFacts(const std::string& fingerprint) const {
  if (fingerprint.empty()) {
    return std::nullopt;
  }
  const auto der = base::readFile(m_folder / kTrusted / (fingerprint + kDer), kCertificateBytesMax);
  const auto facts = der ? opcua::readCertificate(*der) : base::fail(der.error());
  return facts && facts->fingerprint == fingerprint ? std::optional(*facts) : std::nullopt;
}

std::vector<RejectedServer> TrustStore::rejected() const {
  std::vector<RejectedServer> list;
  std::error_code status;
  for (const fs::directory_entry& entry : fs::directory_iterator(m_folder / kRejected, status)) {
    const fs::path& path = entry.path();
    if (path.extension() != kDer) {
      continue;
    }
    const auto der = base::readFile(path, kCertificateBytesMax);
    const auto facts = der ? opcua::readCertificate(*der) : base::fail(der.error());
    const auto address =
        base::readFile(fs::path(path).replace_extension(kAddress), kAddressBytesMax);
    // Without its address it cannot be accepted, and says nothing.
    if (facts && address && path.stem() == facts->fingerprint) {
      list.push_back({*address, *facts});
    }
  }
  std::sort(list.begin(), list.end(), [](const RejectedServer& left, const RejectedServer& right) {
    return left.facts.fingerprint < right.facts.fingerprint;
  });
  return list;
}

base::Result<void> TrustStore::acceptRejected(const std::string& fingerprint) const {
  const fs::path file = m_folder / kRejected / (opcua::fingerprintOf(fingerprint) + kDer);
  const auto der = base::readFile(file, kCertificateBytesMax);
  if (!der) {
    return base::fail(der.error());
  }
  const auto facts = opcua::readCertificate(*der);
  const auto address = base::readFile(fs::path(file).replace_extension(kAddress), kAddressBytesMax);
  if (!facts || !address) {
    return base::fail(!facts ? facts.error() : address.error());
  }
  return accept(*address, *facts, *der);
}

void TrustStore::dropRejected(const std::string& fingerprint) const {
  std::error_code ignored;
  for (const char* ending : {kDer, kAddress}) {
    fs::remove(m_folder / kRejected / (fingerprint + ending), ignored);
  }
}

base::Result<base::FileLock> TrustStore::lock() const {
  if (auto made = base::makePrivateFolder(m_folder); !made) {
    return base::fail(made.error());
  }
  return base::FileLock::take(m_folder / kLock);
}

template <class Change>
base::Result<void> TrustStore::change(const std::string& endpoint, Change change) const {
  const auto changing = lock();
  auto known = changing ? servers() : base::fail(changing.error());
  if (!known) {
    return base::fail(known.error());
  }
  const std::string key = keyOf(endpoint);
  auto server = std::lower_bound(
      known->begin(), known->end(), key,
      [](const KnownServer& one, const std::string& wanted) { return one.endpoint < wanted; });
  if (server == known->end() || server->endpoint != key) {
    server = known->emplace(server);
    server->endpoint = key;
  }
  change(*server);
  return save(*known);
}

base::Result<void> TrustStore::accept(const std::string& endpoint,
                                      const opcua::CertificateFacts& facts,
                                      std::string_view der) const {
  const fs::path folder = m_folder / kTrusted;
  if (auto made = base::makePrivateFolder(folder); !made) {
    return made;
  }
  if (auto kept = base::writeFile(folder / (facts.fingerprint + kDer), der); !kept) {
    return kept;
  }
  auto accepted =
      change(endpoint, [&](KnownServer& server) { server.fingerprint = facts.fingerprint; });
  if (accepted) {
    dropRejected(facts.fingerprint);
  }
  return accepted;
}

base::Result<void> TrustStore::allow(const std::string& endpoint,
                                     const std::string& security) const {
  return change(endpoint, [&](KnownServer& server) { server.security = security; });
}

base::Result<void> TrustStore::setLogin(const std::string& endpoint, const std::string& user,
                                        const std::string& certificateFile,
                                        const std::string& keyFile) const {
  return change(endpoint, [&](KnownServer& server) {
    server.user = user;
    server.certificateFile = certificateFile;
    server.keyFile = keyFile;
  });
}

base::Result<void> TrustStore::setControl(const std::string& endpoint, const std::string& mapFile,
                                          const std::string& link) const {
  return change(endpoint, [&](KnownServer& server) {
    server.mapFile = mapFile;
    server.link = link;
  });
}

base::Result<bool> TrustStore::forget(const std::string& endpoint) const {
  const auto changing = lock();
  auto known = changing ? servers() : base::fail(changing.error());
  if (!known) {
    return base::fail(known.error());
  }
  const std::string key = keyOf(endpoint);
  const auto count =
      std::erase_if(*known, [&](const KnownServer& server) { return server.endpoint == key; });
  if (count == 0) {
    return false;
  }
  if (auto saved = save(*known); !saved) {
    return base::fail(saved.error());
  }
  return true;
}

base::Result<std::vector<opcua::RevocationList>> readRevocations(const fs::path& folder) {
  std::vector<opcua::RevocationList> lists;
  std::error_code status;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, status)) {
    const auto bytes = base::readFile(entry.path(), kRevocationBytesMax);
    auto list = bytes ? opcua::readRevocationList(*bytes) : base::fail(bytes.error());
    if (!list) {
      return base::fail(list.error().code, list.error().message, entry.path().string());
    }
    lists.push_back(std::move(*list));
  }
  return lists;
}

base::Result<std::vector<opcua::RevocationList>> TrustStore::revocations() const {
  return readRevocations(m_folder / kRevoked);
}

base::Result<opcua::RevocationList> TrustStore::addRevocations(std::string_view bytes) const {
  auto list = opcua::readRevocationList(bytes);
  if (!list) {
    return list;
  }
  // One file for each issuer, so a newer list takes the place of an older one.
  const fs::path folder = m_folder / kRevoked;
  const fs::path file = folder / (base::sha256Hex(list->issuerDer) + kCrl);
  if (const auto old = base::readFile(file, kRevocationBytesMax)) {
    const auto kept = opcua::readRevocationList(*old);
    if (kept && kept->issuedAt > list->issuedAt) {
      return base::fail(LinkError::CertificateInvalid,
                        fmt::format("A newer revocation list of this issuer is there already, of "
                                    "{}. This one is of {}. Ask the issuer for the newest.",
                                    dateText(kept->issuedAt), dateText(list->issuedAt)),
                        list->issuer);
    }
  }
  auto done = base::makePrivateFolder(folder);
  if (done) {
    done = base::writeFile(file, bytes);
  }
  return done ? std::move(list) : base::fail(done.error());
}

base::Result<void> TrustStore::checkRevocation(std::string_view der, std::string_view whose) const {
  const auto lists = revocations();
  if (!lists) {
    return base::fail(lists.error());
  }
  if (opcua::isRevoked(*lists, der)) {
    return base::fail(
        LinkError::CertificateInvalid,
        fmt::format("The certificate {} has been revoked by its issuer. Have a new one "
                    "made, then connect again.",
                    whose));
  }
  return {};
}

base::Result<void> TrustStore::save(const std::vector<KnownServer>& servers) const {
  json list = json::array();
  for (const KnownServer& server : servers) {
    json entry;
    for (const auto& [name, member] : kMembers) {
      if (!(server.*member).empty()) {
        entry[name] = server.*member;
      }
    }
    list.push_back(entry);
  }
  const json file{{"format", kFormat}, {"version", kVersion}, {"servers", list}};
  return base::writeFile(
      m_folder / kFile,
      file.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

}  // namespace rivulet::trust
