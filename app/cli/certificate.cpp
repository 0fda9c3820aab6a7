// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "opcua/open62541/encryption.h"
#include "platform/utc_now.h"
#include "trust/own_certificate.h"
#include "trust/trust_store.h"

namespace rivulet::cli {

namespace {

using nlohmann::ordered_json;

using Lists = std::vector<opcua::RevocationList>;

/// Nothing: the issuer does not say.
std::string nextText(const opcua::RevocationList& list) {
  return list.nextAt ? base::utcText(*list.nextAt) : std::string();
}

ordered_json asJson(const opcua::CertificateFacts& facts, const std::string& file,
                    const std::vector<trust::KnownServer>& servers, const Lists& lists) {
  ordered_json json{{"file", file},
                    {"subject", facts.subject},
                    {"fingerprint", facts.fingerprint},
                    {"valid_from", base::utcText(facts.validFrom)},
                    {"valid_to", base::utcText(facts.validTo)},
                    {"days_left", opcua::daysLeft(facts, utc::now())},
                    {"encryption", opcua::encryptionLibrary()},
                    {"servers", ordered_json::array()},
                    {"revocation_lists", ordered_json::array()}};
  for (const trust::KnownServer& server : servers) {
    json["servers"].push_back({{"endpoint", server.endpoint},
                               {"fingerprint", server.fingerprint},
                               {"security", server.security}});
  }
  for (const opcua::RevocationList& list : lists) {
    json["revocation_lists"].push_back({{"issuer", list.issuer},
                                        {"issued", base::utcText(list.issuedAt)},
                                        {"next", nextText(list)},
                                        {"certificates", list.serials.size()}});
  }
  return json;
}

void printText(const opcua::CertificateFacts& facts, const std::string& file,
               const std::vector<trust::KnownServer>& servers, const Lists& lists) {
  fmt::print("Certificate of this user: {}\n  {}\n  {} days left\n", file, trust::describe(facts),
             opcua::daysLeft(facts, utc::now()));
  fmt::print("Encryption by {}\n", opcua::encryptionLibrary());
  fmt::print("{}\n", servers.empty() ? "No server is trusted yet." : "Servers:");
  for (const trust::KnownServer& server : servers) {
    fmt::print("  {}\n    {}{}\n", server.endpoint,
               server.fingerprint.empty() ? "no certificate accepted"
                                          : opcua::fingerprintText(server.fingerprint),
               server.security.empty() ? "" : fmt::format(", allowed: {}", server.security));
  }
  for (const opcua::RevocationList& list : lists) {
    const bool isOld = list.nextAt && *list.nextAt < utc::now();
    fmt::print("Revocation list of {}, {}: {} certificates{}\n", list.issuer,
               base::utcText(list.issuedAt), list.serials.size(),
               isOld ? "; it has ended, ask the issuer for the next one" : "");
  }
}

}  // namespace

Exit certificate(const CertificateOptions& options) {
  const std::filesystem::path folder = trust::trustFolder();
  const trust::TrustStore store(folder);
  if (!options.forget.empty()) {
    const auto forgotten = store.forget(options.forget);
    if (!forgotten) {
      return reportError(forgotten.error(), options.json);
    }
    if (!*forgotten) {
      return reportError(
          base::makeError(base::FileError::Unreadable,
                          "This server is not known. See rivulet-cli certificate.", options.forget),
          options.json);
    }
  }
  if (!options.revocationList.empty()) {
    const auto bytes = base::readFile(options.revocationList, trust::kRevocationBytesMax);
    const auto added = bytes ? store.addRevocations(*bytes) : base::fail(bytes.error());
    if (!added) {
      return reportError(
          base::makeError(added.error().code, added.error().message, options.revocationList),
          options.json);
    }
  }
  const auto own = options.renew ? trust::renewCertificate(folder, trust::kClient)
                                 : trust::ownCertificate(folder, trust::kClient);
  if (!own) {
    return reportError(own.error(), options.json);
  }
  if (!options.exportFile.empty()) {
    if (const auto done = base::writeFile(options.exportFile, own->certificate); !done) {
      return reportError(done.error(), options.json);
    }
  }
  const auto facts = opcua::readCertificate(own->certificate);
  const auto servers = store.servers();
  const auto lists = store.revocations();
  if (!facts || !servers || !lists) {
    return reportError(!facts     ? facts.error()
                       : !servers ? servers.error()
                                  : lists.error(),
                       options.json);
  }
  const std::string file = trust::certificatePath(folder, trust::kClient).string();
  if (options.json) {
    printJson(asJson(*facts, file, *servers, *lists));
  } else {
    printText(*facts, file, *servers, *lists);
  }
  return Exit::Done;
}

}  // namespace rivulet::cli
