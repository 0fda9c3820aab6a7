// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "opcua/open62541/status.h"

#include <fmt/format.h>

#include "base/contract.h"
#include "opcua/link.h"
#include "opcua/security.h"

namespace rivulet::opcua {

LinkError linkErrorOf(UA_StatusCode status, Operation operation) {
  if (meansConnectionLost(status)) {
    return LinkError::ConnectionLost;
  }
  switch (status) {
    case UA_STATUSCODE_BADTIMEOUT:
    case UA_STATUSCODE_BADREQUESTTIMEOUT:
      return LinkError::DeadlineExceeded;
    case UA_STATUSCODE_BADNODEIDUNKNOWN:
    case UA_STATUSCODE_BADNODEIDINVALID:
      return operation == Operation::Call ? LinkError::MethodMissing : LinkError::VariableMissing;
    case UA_STATUSCODE_BADATTRIBUTEIDINVALID:  // SINUMERIK: browsable, but not on this machine
    case UA_STATUSCODE_BADINDEXRANGEINVALID:
    case UA_STATUSCODE_BADINDEXRANGENODATA:
      return LinkError::VariableMissing;
    case UA_STATUSCODE_BADMETHODINVALID:
    case UA_STATUSCODE_BADNOTIMPLEMENTED:
      return LinkError::MethodMissing;
    case UA_STATUSCODE_BADNOTWRITABLE:
    case UA_STATUSCODE_BADWRITENOTSUPPORTED:
      return LinkError::NotWritable;
    case UA_STATUSCODE_BADUSERACCESSDENIED:
      return operation == Operation::Write ? LinkError::NotWritable : LinkError::Rejected;
    case UA_STATUSCODE_BADTYPEMISMATCH:
    case UA_STATUSCODE_BADOUTOFRANGE:
      return LinkError::BadValue;
    case UA_STATUSCODE_BADTOOMANYOPERATIONS:
    case UA_STATUSCODE_BADREQUESTTOOLARGE:
    case UA_STATUSCODE_BADRESPONSETOOLARGE:
    case UA_STATUSCODE_BADENCODINGLIMITSEXCEEDED:
      return LinkError::TooManyItems;
    case UA_STATUSCODE_BADNOTFOUND:
    case UA_STATUSCODE_BADNOENTRYEXISTS:
      return LinkError::ProgramMissing;
    case UA_STATUSCODE_BADINVALIDSTATE:
      return LinkError::ChannelNotInReset;
    case UA_STATUSCODE_BADBROWSENAMEDUPLICATED:
    case UA_STATUSCODE_BADENTRYEXISTS:
    case UA_STATUSCODE_BADALREADYEXISTS:
      return LinkError::FileExists;
    default:
      return LinkError::Rejected;
  }
}

bool meansConnectionLost(UA_StatusCode status) {
  switch (status) {
    case UA_STATUSCODE_BADSECURECHANNELCLOSED:
    case UA_STATUSCODE_BADSECURECHANNELIDINVALID:
    case UA_STATUSCODE_BADCONNECTIONCLOSED:
    case UA_STATUSCODE_BADCONNECTIONREJECTED:
    case UA_STATUSCODE_BADNOTCONNECTED:
    case UA_STATUSCODE_BADDISCONNECT:  // Qt OPC UA: before it says that the connection is lost
    case UA_STATUSCODE_BADSERVERNOTCONNECTED:
    case UA_STATUSCODE_BADSESSIONCLOSED:
    case UA_STATUSCODE_BADSESSIONIDINVALID:
    case UA_STATUSCODE_BADCOMMUNICATIONERROR:
    case UA_STATUSCODE_BADSHUTDOWN:
      return true;
    default:
      return false;
  }
}

std::string sentenceOf(LinkError error) {
  switch (error) {
    case LinkError::NotReachable:
      return "No OPC UA server answers. Check the address and the network, and that the server is "
             "running.";
    case LinkError::ConnectionLost:
      return "The connection to the control is lost. Check network and server, then connect "
             "again.";
    case LinkError::DeadlineExceeded:
      return "The control did not answer in time; the request may still have been carried out.";
    case LinkError::VariableMissing:
      return "The control has no such variable. Check the range of R-parameters it has.";
    case LinkError::NotWritable:
      return "The variable cannot be written. Grant the OPC UA user write access on the control.";
    case LinkError::BadValue:
      return "The value cannot be used: it is not a finite number or has another type.";
    case LinkError::Rejected:
      return "The server refused the request. Check the rights of the OPC UA user.";
    case LinkError::NamespaceMissing:
      return "The server is not a SINUMERIK: it has no namespace SinumerikVarProvider.";
    case LinkError::MethodMissing:
      return "The server does not offer this method.";
    case LinkError::ProgramMissing:
      return "There is no such program on the control. Upload it first.";
    case LinkError::ChannelNotInReset:
      return "The channel is not in reset. Press Reset on the control, then try again.";
    case LinkError::FileExists:
      return "A program of this name is already on the control. Overwrite it or choose another "
             "name.";
    case LinkError::TooManyItems:
      return "The request has more items than the link or the server accepts. Split it.";
    case LinkError::EncryptionMissing:
      return "The server does not offer the protection that is asked for. Set up encryption on it.";
    case LinkError::CertificateUnknown:
      return "The certificate of the server is not known. Compare its fingerprint with the one "
             "that "
             "the server shows, then accept it.";
    case LinkError::CertificateChanged:
      return "The server has another certificate than the one that was accepted. Find out why "
             "before accepting it.";
    case LinkError::CertificateInvalid:
      return "The certificate cannot be used. Create a new one.";
    case LinkError::ClientNotTrusted:
      return "The server does not trust the certificate of this computer. Accept it on the server.";
    case LinkError::LoginRefused:
      return "The server refuses user name or password. Check both.";
    case LinkError::HostUnknown:
      return "The name of the server is not known on this network. Check it, or give the IP "
             "address.";
    case LinkError::NoHandles:
      return "Too many files and connections are open on this computer. Close other programs.";
    case LinkError::NoHistory:
      return "The server keeps no history of this node. Have it recorded at the server, or choose "
             "a node whose attribute Historizing is true.";
  }
  base::contractViolated("every LinkError has a sentence", __FILE__, __LINE__);
}

namespace {

/// A request or an answer that could not be understood. The rights of the user are not to blame.
bool meansDamage(UA_StatusCode status) {
  switch (status) {
    case UA_STATUSCODE_BADDECODINGERROR:
    case UA_STATUSCODE_BADENCODINGERROR:
    case UA_STATUSCODE_BADUNKNOWNRESPONSE:
    case UA_STATUSCODE_BADDATAENCODINGINVALID:
    case UA_STATUSCODE_BADSTRUCTUREMISSING:
    case UA_STATUSCODE_BADINVALIDARGUMENT:
    case UA_STATUSCODE_BADSERVICEUNSUPPORTED:
    case UA_STATUSCODE_BADTIMESTAMPSTORETURNINVALID:
    case UA_STATUSCODE_BADREQUESTHEADERINVALID:
    case UA_STATUSCODE_BADREQUESTTYPEINVALID:
    case UA_STATUSCODE_BADMAXAGEINVALID:
    case UA_STATUSCODE_BADNOTHINGTODO:
      return true;
    default:
      return false;
  }
}

}  // namespace

base::Error requestError(UA_StatusCode status, Operation operation, const std::string& context) {
  if (meansSessionEnded(status)) {
    return sessionEnded(context);
  }
  const LinkError error = linkErrorOf(status, operation);
  const std::string sentence =
      meansDamage(status)
          ? "A request or its answer was damaged on its way. Check the network, then try again."
          : sentenceOf(error);
  return base::makeError(error, fmt::format("{} ({})", sentence, UA_StatusCode_name(status)),
                         context);
}

base::Error connectError(UA_StatusCode status, const std::string& endpoint) {
  // The library says so of an address that it cannot read, and a server of one that is not its own.
  const bool isAddress =
      endpoint.starts_with("opc.tcp://") && !hostOf(endpoint).empty() && portOf(endpoint) != 0;
  if (status == UA_STATUSCODE_BADTCPENDPOINTURLINVALID && !isAddress) {
    return base::makeError(LinkError::NotReachable,
                           "This is not an OPC UA address. Example: opc.tcp://host:4840.",
                           endpoint);
  }
  const StatusAdvice* advice = adviceOn(status);
  if (advice == nullptr) {
    return base::makeError(
        LinkError::NotReachable,
        fmt::format("{} ({})", sentenceOf(LinkError::NotReachable), UA_StatusCode_name(status)),
        endpoint);
  }
  return base::makeError(
      advice->whileConnecting,
      fmt::format("Cannot connect: {}. {} ({})", advice->cause, advice->nextStep, advice->name),
      endpoint);
}

base::Error silenceError(base::Duration silenceMax, const std::string& endpoint) {
  return base::makeError(
      LinkError::ConnectionLost,
      fmt::format("Nothing has come from the control for {:.0f} s: the network is interrupted, or "
                  "the server hangs. Check cable, switch and server, then connect again.",
                  base::toSeconds(silenceMax)),
      endpoint);
}

bool meansSessionEnded(UA_StatusCode status) {
  return status == UA_STATUSCODE_BADSESSIONIDINVALID || status == UA_STATUSCODE_BADSESSIONCLOSED;
}

base::Error sessionEnded(const std::string& endpoint) {
  return base::makeError(LinkError::ConnectionLost,
                         "The server has ended the session of this client; the network is not to "
                         "blame. Connect again for a new session, then go on.",
                         endpoint);
}

base::Error unreadableAnswer(const std::string& endpoint) {
  return base::makeError(LinkError::ConnectionLost,
                         "An answer of the server cannot be read: it was damaged on its way, or "
                         "the server is faulty. The connection was closed. Check the network, then "
                         "connect again.",
                         endpoint);
}

base::Error unknownForm(std::string_view method) {
  return base::makeError(LinkError::Rejected,
                         "The server's method returns a form that Rivulet does not know.",
                         std::string(method));
}

base::Error onlyVirtual(const std::string& endpoint) {
  return base::makeError(
      LinkError::MethodMissing,
      "Only a virtual machine can do this. On a real control use the keys of its panel.", endpoint);
}

base::Result<void> commandResult(int status, const std::string& subject,
                                 const std::string& detail) {
  const auto failed = [&](LinkError error) {
    return base::fail(error, detail.empty() ? sentenceOf(error) : detail, subject);
  };
  switch (static_cast<SelectStatus>(status)) {
    case SelectStatus::Done:
      return {};
    case SelectStatus::NoSuchProgram:
      return failed(LinkError::ProgramMissing);
    case SelectStatus::NotInReset:
      return failed(LinkError::ChannelNotInReset);
    case SelectStatus::NoSuchChannel:
    case SelectStatus::Rejected:
      break;
  }
  return failed(LinkError::Rejected);
}

}  // namespace rivulet::opcua
