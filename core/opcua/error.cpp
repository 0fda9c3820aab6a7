// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/error.h"

#include <array>

#include "base/error.h"

namespace rivulet::opcua {

namespace {

/// docs/trust.md has the same table; a test compares them.
constexpr std::array<StatusAdvice, 63> kAdvice{{
    {0x800A0000, "BadTimeout", "the server does not answer in time",
     "Check that this is the port of the OPC UA server, the network and the load of the server, "
     "then try again.",
     LinkError::NotReachable},
    {0x80850000, "BadRequestTimeout", "the server does not answer in time",
     "Check that this is the port of the OPC UA server, the network and the load of the server, "
     "then try again.",
     LinkError::NotReachable},
    {0x80AE0000, "BadConnectionClosed", "nothing answers at the address, or the server hangs up",
     "Check address, port and network, and that the server is running.", LinkError::NotReachable},
    {0x80AC0000, "BadConnectionRejected", "no service accepts connections at this address",
     "Check address and port, and that the OPC UA server is switched on.", LinkError::NotReachable},
    {0x808A0000, "BadNotConnected", "the connection could not be opened",
     "Check address, port and network, then try again.", LinkError::NotReachable},
    {0x800D0000, "BadServerNotConnected", "the connection could not be opened",
     "Check address, port and network, then try again.", LinkError::NotReachable},
    {0x80AD0000, "BadDisconnect", "the server has ended the connection",
     "Try again; if it repeats, read the messages of the server.", LinkError::NotReachable},
    {0x80050000, "BadCommunicationError", "the network failed",
     "Check cable, switch and firewall, then try again.", LinkError::NotReachable},
    {0x807D0000, "BadTcpServerTooBusy", "the server has too many connections",
     "Close another OPC UA client, or wait a minute.", LinkError::NotReachable},
    {0x807E0000, "BadTcpMessageTypeInvalid", "what answers is not an OPC UA server",
     "Check the port of the OPC UA server.", LinkError::NotReachable},
    {0x80830000, "BadTcpEndpointUrlInvalid", "the server does not take this address for its own",
     "Connect by the host name or number that the server shows, like opc.tcp://host:4840.",
     LinkError::NotReachable},
    // The first messages are small: what answers speaks another language, as HTTP.
    {0x80800000, "BadTcpMessageTooLarge", "what answers is not an OPC UA server",
     "Check the port of the OPC UA server.", LinkError::NotReachable},
    {0x80810000, "BadTcpNotEnoughResources", "the server is out of memory",
     "Close other clients, or restart the server.", LinkError::NotReachable},
    {0x80820000, "BadTcpInternalError", "the server has failed",
     "Read the messages of the server, or restart it.", LinkError::NotReachable},
    {0x807F0000, "BadTcpSecureChannelUnknown", "the server has forgotten this connection",
     "Connect again.", LinkError::NotReachable},
    {0x80860000, "BadSecureChannelClosed", "the server has closed the encrypted channel",
     "Connect again; if it repeats, check that the server trusts this computer's certificate.",
     LinkError::NotReachable},
    {0x80220000, "BadSecureChannelIdInvalid", "the server has forgotten this connection",
     "Connect again.", LinkError::NotReachable},
    {0x80870000, "BadSecureChannelTokenUnknown", "the keys of the channel were not renewed in time",
     "Connect again.", LinkError::NotReachable},
    {0x80130000, "BadSecurityChecksFailed",
     "the server does not trust this computer's certificate, or a message was changed on its way",
     "Accept the certificate of Rivulet on the server (list of trusted clients), then connect "
     "again.",
     LinkError::ClientNotTrusted},
    {0x801A0000, "BadCertificateUntrusted", "the server does not trust this computer's certificate",
     "Accept the certificate of Rivulet on the server (list of trusted clients), then connect "
     "again.",
     LinkError::ClientNotTrusted},
    {0x80120000, "BadCertificateInvalid",
     "a certificate is damaged or does not belong to the connection",
     "Create a new certificate (rivulet-cli certificate --renew), and accept it on the server.",
     LinkError::ClientNotTrusted},
    {0x80140000, "BadCertificateTimeInvalid", "a certificate has ended, or a clock is wrong",
     "Set the clocks of both computers; renew the certificate that has ended.",
     LinkError::ClientNotTrusted},
    {0x80150000, "BadCertificateIssuerTimeInvalid", "the certificate of an issuer has ended",
     "Renew it, or accept the certificate itself on the server.", LinkError::ClientNotTrusted},
    {0x80160000, "BadCertificateHostNameInvalid", "a certificate was made for another host name",
     "Connect by the name in the certificate, or create a new one on the server.",
     LinkError::ClientNotTrusted},
    {0x80170000, "BadCertificateUriInvalid",
     "the application's name is not the one in its certificate",
     "Create a new certificate (rivulet-cli certificate --renew), and accept it on the server.",
     LinkError::ClientNotTrusted},
    {0x80180000, "BadCertificateUseNotAllowed", "the certificate is not meant for this use",
     "Create a new certificate (rivulet-cli certificate --renew), and accept it on the server.",
     LinkError::ClientNotTrusted},
    {0x80190000, "BadCertificateIssuerUseNotAllowed",
     "the issuer's certificate may not issue certificates", "Use a certificate of another issuer.",
     LinkError::ClientNotTrusted},
    {0x801D0000, "BadCertificateRevoked", "the certificate has been revoked",
     "Create a new certificate, and accept it on the server.", LinkError::ClientNotTrusted},
    {0x801E0000, "BadCertificateIssuerRevoked", "the certificate of the issuer has been revoked",
     "Use a certificate of another issuer.", LinkError::ClientNotTrusted},
    {0x801B0000, "BadCertificateRevocationUnknown",
     "the server has no revocation list of the issuer",
     "Load the list on the server, or accept the certificate itself there.",
     LinkError::ClientNotTrusted},
    {0x801C0000, "BadCertificateIssuerRevocationUnknown",
     "the server has no revocation list of the issuer",
     "Load the list on the server, or accept the certificate itself there.",
     LinkError::ClientNotTrusted},
    {0x810D0000, "BadCertificateChainIncomplete", "the certificate of an issuer is missing",
     "Load it on the server, or accept the certificate itself there.", LinkError::ClientNotTrusted},
    {0x81140000, "BadCertificatePolicyCheckFailed",
     "the key of the certificate is too short for this security policy",
     "Create a new certificate with a key of 2048 bits or more.", LinkError::ClientNotTrusted},
    {0x80590000, "BadNoValidCertificates", "the server found no certificate that it may use",
     "Create a certificate on the server, and accept that of Rivulet there.",
     LinkError::ClientNotTrusted},
    {0x80580000, "BadApplicationSignatureInvalid", "the server could not check who is asking",
     "Create a new certificate (rivulet-cli certificate --renew), and accept it on the server.",
     LinkError::ClientNotTrusted},
    {0x80240000, "BadNonceInvalid", "the server or this computer has repeated a random number",
     "Try again; if it repeats, restart the server.", LinkError::NotReachable},
    {0x80540000, "BadSecurityModeRejected", "the server does not allow this kind of protection",
     "Allow encryption on the server, or choose another --security.", LinkError::EncryptionMissing},
    {0x80550000, "BadSecurityPolicyRejected", "the server does not allow this kind of protection",
     "Allow encryption on the server, or choose another --security.", LinkError::EncryptionMissing},
    {0x80E60000, "BadSecurityModeInsufficient", "the server asks for encryption",
     "Connect with --security strongest.", LinkError::EncryptionMissing},
    {0x80200000, "BadIdentityTokenInvalid", "the server does not take this kind of login",
     "Give a user name and password, or allow anonymous access on the server.",
     LinkError::LoginRefused},
    {0x80210000, "BadIdentityTokenRejected", "the server refuses this user",
     "Check user name and password, or that the user's certificate is registered on the server and "
     "not revoked. After several wrong ones a server locks the user for some time.",
     LinkError::LoginRefused},
    {0x801F0000, "BadUserAccessDenied", "the server refuses this user",
     "Check user name and password, or that the user's certificate is registered on the server and "
     "not revoked. After several wrong ones a server locks the user for some time.",
     LinkError::LoginRefused},
    {0x80570000, "BadUserSignatureInvalid", "the login could not be checked",
     "Check user name and password, or that the key is the one of the user's certificate.",
     LinkError::LoginRefused},
    {0x80560000, "BadTooManySessions", "the server has no session left",
     "Close another OPC UA client.", LinkError::Rejected},
    {0x80250000, "BadSessionIdInvalid", "the server has ended the session", "Connect again.",
     LinkError::NotReachable},
    {0x80260000, "BadSessionClosed", "the server has ended the session", "Connect again.",
     LinkError::NotReachable},
    {0x80270000, "BadSessionNotActivated", "the session was not activated", "Connect again.",
     LinkError::NotReachable},
    {0x800E0000, "BadServerHalted", "the server has stopped", "Start the OPC UA server.",
     LinkError::NotReachable},
    {0x800C0000, "BadShutdown", "the server is shutting down",
     "Wait until it has started again, then connect.", LinkError::NotReachable},
    {0x804F0000, "BadServerUriInvalid", "another server answers at this address",
     "Check address and port.", LinkError::NotReachable},
    {0x800B0000, "BadServiceUnsupported", "the server cannot do this",
     "Check that it is the OPC UA server of the control.", LinkError::NotReachable},
    {0x80100000, "BadTooManyOperations", "the request has too many items",
     "Choose fewer points per window.", LinkError::NotReachable},
    {0x80B80000, "BadRequestTooLarge", "the request is larger than the server takes",
     "Choose fewer points per window.", LinkError::NotReachable},
    {0x80B90000, "BadResponseTooLarge", "the answer is larger than the server sends",
     "Choose fewer points per window.", LinkError::NotReachable},
    {0x80080000, "BadEncodingLimitsExceeded", "a message is larger than allowed",
     "Choose fewer points per window.", LinkError::NotReachable},
    {0x80030000, "BadOutOfMemory", "the server or this computer is out of memory",
     "Close other programs, or restart the server.", LinkError::NotReachable},
    {0x80040000, "BadResourceUnavailable", "the server is short of resources",
     "Close other clients, or restart the server.", LinkError::NotReachable},
    {0x80020000, "BadInternalError", "the server or the OPC UA library has failed",
     "Try again; if it repeats, restart the server.", LinkError::NotReachable},
    {0x80010000, "BadUnexpectedError", "the server has failed",
     "Try again; if it repeats, restart the server.", LinkError::NotReachable},
    {0x80090000, "BadUnknownResponse", "the answer could not be understood",
     "Check the network, then try again.", LinkError::NotReachable},
    {0x80070000, "BadDecodingError", "a message was damaged on its way",
     "Check the network, then try again.", LinkError::NotReachable},
    {0x80060000, "BadEncodingError", "a message could not be written", "Try again.",
     LinkError::NotReachable},
    {0x80BE0000, "BadProtocolVersionUnsupported", "the server speaks another version of OPC UA",
     "Update the server.", LinkError::NotReachable},
}};

}  // namespace

std::error_code make_error_code(LinkError code) {
  static const base::NamedCategory category("opcua");
  return {static_cast<int>(code), category};
}

bool mayBeFalsified(const std::error_code& code) {
  return code == LinkError::Rejected || code == LinkError::BadValue ||
         code == LinkError::VariableMissing || code == LinkError::NotWritable ||
         code == LinkError::MethodMissing || code == LinkError::ProgramMissing ||
         code == LinkError::TooManyItems;
}

std::string_view remedyForItem(const std::error_code& status) {
  if (status == LinkError::NotWritable) {
    return "Give this OPC UA user access to it on the control.";
  }
  if (status == LinkError::VariableMissing) {
    return "Check the server, and the number of R-parameters on the control (MD28050).";
  }
  if (status == LinkError::BadValue) {
    return "The answer was damaged on its way, or is not a number. Check network and server, then "
           "resume.";
  }
  return "The control rejected it. Check its messages.";
}

std::span<const StatusAdvice> statusAdvice() {
  return kAdvice;
}

const StatusAdvice* adviceOn(std::uint32_t code) {
  for (const StatusAdvice& advice : kAdvice) {
    if (advice.code == code) {
      return &advice;
    }
  }
  return nullptr;
}

}  // namespace rivulet::opcua
