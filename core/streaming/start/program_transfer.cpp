// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/start/program_transfer.h"

#include <fmt/format.h>

#include "streaming/run/run.h"

namespace rivulet::streaming {

namespace {

using base::Result;
using opcua::LinkError;

/// The user has no right, or the server has no method: the operator can do it at the control.
bool isRefusal(const base::Error& error) {
  return error.code == LinkError::Rejected || error.code == LinkError::MethodMissing ||
         error.code == LinkError::NotWritable;
}

base::Error refused(const base::Error& cause) {
  return base::makeError(
      StreamError::TransferRefused,
      fmt::format("The control does not let Rivulet write and read part programs ({}) Grant the "
                  "OPC UA user these rights, or copy the program to the control by hand.",
                  cause.message),
      cause.context);
}

/// Some controls store line ends of their own; the blocks are the same.
std::string withPlainLineEnds(std::string text) {
  std::erase(text, '\r');
  return text;
}

/// A request or a program that was falsified on its way: made again, it is right.
constexpr int kAttemptsMax = 3;

bool mayBeFalsified(const base::Error& error) {
  return opcua::mayBeFalsified(error.code) || error.code == StreamError::WrongProgram;
}

/// The answer to a call that is made again if it is refused.
template <class Call>
auto persistently(const Call& call) {
  auto answer = call();
  for (int attempt = 1; attempt < kAttemptsMax && !answer && mayBeFalsified(answer.error());
       ++attempt) {
    answer = call();
  }
  return answer;
}

/// @return true: the same; false: it may not be read
Result<bool> compare(opcua::Control& control, const std::string& name, const std::string& text) {
  const Result<std::string> there = persistently([&] { return control.downloadProgram(name); });
  if (!there) {
    return isRefusal(there.error()) ? Result<bool>(false) : Result<bool>(base::fail(there.error()));
  }
  if (withPlainLineEnds(*there) != withPlainLineEnds(text)) {
    return base::fail(StreamError::WrongProgram,
                      "The program on the control differs from the one for these settings. Delete "
                      "it there and start again.",
                      name);
  }
  return true;
}

/// @return true: done; false: the operator has to
Result<bool> select(opcua::Control& control, const std::string& name) {
  const Result<void> done = persistently([&] { return control.selectProgram(name); });
  if (!done) {
    return isRefusal(done.error()) ? Result<bool>(false) : Result<bool>(base::fail(done.error()));
  }
  return true;
}

}  // namespace

Result<ProgramTransfer> storeProgram(opcua::Control& control, const std::string& name,
                                     const std::string& text, TransferWay way) {
  ProgramTransfer transfer;
  Result<void> written;
  Result<bool> compared = false;
  for (int attempt = 0; attempt < kAttemptsMax; ++attempt) {
    if (way == TransferWay::Link) {
      written = persistently([&] { return control.uploadProgram(name, text, true); });
      if (!written && !isRefusal(written.error())) {
        return base::fail(written.error());
      }
      transfer.written = written.has_value();
    }
    compared = compare(control, name, text);
    if (!transfer.written || compared || !mayBeFalsified(compared.error())) {
      break;
    }
  }
  if (!written && (!compared || !*compared)) {
    return base::fail(refused(written.error()));
  }
  const bool isAwaited =
      way == TransferWay::ByHand && !compared && compared.error().code == LinkError::ProgramMissing;
  if (isAwaited) {
    return transfer;  // the operator has not stored it yet
  }
  if (!compared) {
    return base::fail(compared.error());
  }
  if (way == TransferWay::Link && !*compared) {
    return base::fail(refused(base::makeError(LinkError::Rejected, "It may not be read.", name)));
  }
  transfer.compared = *compared;
  return transfer;
}

Result<ProgramTransfer> transferProgram(opcua::Control& control, const std::string& name,
                                        const std::string& text, TransferWay way) {
  Result<ProgramTransfer> transfer = storeProgram(control, name, text, way);
  if (transfer && way == TransferWay::Link) {
    const Result<bool> selected = select(control, name);
    if (!selected) {
      return base::fail(selected.error());
    }
    transfer->selected = *selected;
  }
  return transfer;
}

}  // namespace rivulet::streaming
