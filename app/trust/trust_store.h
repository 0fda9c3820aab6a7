// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Which servers this user trusts: trust on first use. Every server is known by its address and the
/// fingerprint of the certificate that was accepted for it. @threadsafety reads and writes files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/file_lock.h"
#include "base/result.h"
#include "base/utc.h"
#include "opcua/revocation.h"
#include "opcua/security.h"

namespace rivulet::trust {

/// Larger files are not read as revocation lists.
inline constexpr std::uintmax_t kRevocationBytesMax = std::uintmax_t{1} << 24U;

struct KnownServer {
  std::string endpoint;     ///< as `TrustStore` compares it: lower case, without a slash at its end
  std::string fingerprint;  ///< of the accepted certificate; empty: none
  std::string security;     ///< allowed by name (`opcua::securityChoiceText`); empty: the strongest
  std::string user;         ///< as whom the window connected last; empty: anonymous
  std::string certificateFile;  ///< with whose certificate it connected last, instead of `user`
  std::string keyFile;          ///< of that certificate; empty: the same file
  std::string mapFile;  ///< with which map the window connected last; empty: it is a SINUMERIK
  std::string link;     ///< with which library the window connected last; empty: open62541
};

/// A certificate that was refused, and is kept.
struct RejectedServer {
  std::string endpoint;  ///< where it was shown
  opcua::CertificateFacts facts;
};

/// Keeps a certificate that was refused, for whoever decides whether to trust it; at most 32 in a
/// folder. The refusal does not depend on it, so an error is not reported.
void keepRejected(const std::filesystem::path& folder, const opcua::CertificateFacts& facts,
                  std::string_view der);

class TrustStore {
 public:
  explicit TrustStore(std::filesystem::path folder) : m_folder(std::move(folder)) {}

  /// All servers, in the order of their addresses. @return CertificateInvalid if the file is
  /// damaged: taking it for empty would forget what was accepted
  [[nodiscard]] base::Result<std::vector<KnownServer>> servers() const;
  /// What is known of one server; nothing if it is not known.
  [[nodiscard]] base::Result<std::optional<KnownServer>> find(std::string_view endpoint) const;

  /// Whether a server shows the certificate that was accepted for it. One that is refused is kept
  /// in the folder "rejected". @param now  UTC
  /// @return CertificateUnknown, CertificateChanged, CertificateInvalid
  [[nodiscard]] base::Result<void> check(const std::string& endpoint,
                                         const opcua::CertificateFacts& facts, std::string_view der,
                                         base::UtcMs now) const;

  /// A certificate that was accepted once; nothing if it is not kept any more.
  [[nodiscard]] std::optional<opcua::CertificateFacts> keptFacts(
      const std::string& fingerprint) const;

  /// Servers whose certificates were refused, in the order of their fingerprints.
  [[nodiscard]] std::vector<RejectedServer> rejected() const;
  /// Accepts one of them for the address where it was shown, whatever was accepted there before.
  /// @return Unreadable if it is not kept any more
  [[nodiscard]] base::Result<void> acceptRejected(const std::string& fingerprint) const;
  /// Removes one of them from what is kept.
  void dropRejected(const std::string& fingerprint) const;

  /// From now on, this certificate and no other one is trusted at this address.
  [[nodiscard]] base::Result<void> accept(const std::string& endpoint,
                                          const opcua::CertificateFacts& facts,
                                          std::string_view der) const;
  /// What is allowed by name at this address; empty: the strongest only.
  [[nodiscard]] base::Result<void> allow(const std::string& endpoint,
                                         const std::string& security) const;
  /// As whom the window connects next time, as `KnownServer` keeps it. Passwords are kept
  /// elsewhere.
  [[nodiscard]] base::Result<void> setLogin(const std::string& endpoint, const std::string& user,
                                            const std::string& certificateFile,
                                            const std::string& keyFile) const;
  /// How the window connects next time, as `KnownServer` keeps it.
  [[nodiscard]] base::Result<void> setControl(const std::string& endpoint,
                                              const std::string& mapFile,
                                              const std::string& link) const;
  /// @return whether the server was known
  [[nodiscard]] base::Result<bool> forget(const std::string& endpoint) const;

  /// The revocation lists of the folder "revoked". @return CertificateInvalid if one is damaged:
  /// without it, what it revokes would be accepted
  [[nodiscard]] base::Result<std::vector<opcua::RevocationList>> revocations() const;
  /// Takes a list over, in place of an older one of its issuer. @param bytes  DER or PEM
  /// @return CertificateInvalid, also if the list is older than the one that is there
  [[nodiscard]] base::Result<opcua::RevocationList> addRevocations(std::string_view bytes) const;
  /// @return CertificateInvalid if one of the lists names the certificate @param whose  "of the
  /// server"
  [[nodiscard]] base::Result<void> checkRevocation(std::string_view der,
                                                   std::string_view whose) const;

 private:
  /// For as long as the list is read, changed and saved: another program of this user may do the
  /// same, and must not take back what was accepted meanwhile. Makes the folder if it is missing.
  [[nodiscard]] base::Result<base::FileLock> lock() const;
  [[nodiscard]] base::Result<void> save(const std::vector<KnownServer>& servers) const;
  template <class Change>
  [[nodiscard]] base::Result<void> change(const std::string& endpoint, Change change) const;

  std::filesystem::path m_folder;
};

/// All revocation lists in a folder; none if it is not there. @return Unreadable,
/// CertificateInvalid
[[nodiscard]] base::Result<std::vector<opcua::RevocationList>> readRevocations(
    const std::filesystem::path& folder);

/// Fingerprint, subject and dates, as a person compares them, and `strangerText`.
[[nodiscard]] std::string describe(const opcua::CertificateFacts& facts);
/// Of a certificate that was made for another application: one sentence without its full stop.
/// @param facts  with `strangerUri`
[[nodiscard]] std::string strangerText(const opcua::CertificateFacts& facts);

}  // namespace rivulet::trust
