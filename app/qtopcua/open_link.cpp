// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "qtopcua/open_link.h"

#include <array>
#include <utility>

#ifdef RIVULET_WITH_QTOPCUA
#include "qtopcua/qt_opcua_link.h"
#endif

namespace rivulet::qtopcua {

namespace {

constexpr std::array<std::pair<opcua::LinkKind, std::string_view>, 2> kNames{
    {{opcua::LinkKind::Open62541, "open62541"}, {opcua::LinkKind::QtOpcUa, "qtopcua"}}};

}  // namespace

std::string_view linkName(opcua::LinkKind kind) {
  return kNames[static_cast<std::size_t>(kind)].second;
}

std::optional<opcua::LinkKind> linkFromName(std::string_view name) {
  for (const auto& [kind, text] : kNames) {
    if (text == name) {
      return kind;
    }
  }
  return std::nullopt;
}

bool isAvailable(opcua::LinkKind kind) {
#ifdef RIVULET_WITH_QTOPCUA
  return kind == opcua::LinkKind::Open62541 || kind == opcua::LinkKind::QtOpcUa;
#else
  return kind == opcua::LinkKind::Open62541;
#endif
}

base::Result<opcua::Connection> openLink(opcua::LinkKind kind,
                                         const opcua::ConnectOptions& options) {
  if (kind == opcua::LinkKind::Open62541) {
    return opcua::openConnection(options);
  }
#ifdef RIVULET_WITH_QTOPCUA
  return openQtConnection(options);
#else
  return base::fail(opcua::LinkKindError::NotBuilt,
                    "This build has no Qt OPC UA. Connect with open62541, or build Rivulet where "
                    "Qt OPC UA is installed.",
                    options.endpoint);
#endif
}

}  // namespace rivulet::qtopcua
