// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/front/address_space.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "base/units.h"
#include "machine/front/listening.h"
#include "machine/front/server.h"
#include "opcua/node_map.h"
#include "opcua/open62541/handle.h"

namespace rivulet::machine {

/// What a number measures; its unit and its range follow from it.
enum class Quantity {
  None,          ///< a number without a unit, or a text
  Position,      ///< of an axis in the workpiece, or a distance: its range depends on frames
  MachinePlace,  ///< of an axis in machine coordinates
  PathFeed,
  SpindleSpeed,
};

/// Number or text of the machine's state that a variable shows.
struct VariableRow {
  std::string_view folder;  ///< below "/Channel/"
  std::string_view name;
  std::string_view description;        ///< "{}" is the letter of the axis
  bool perAxis = false;                ///< those of the spindle have the number 1
  std::size_t type = UA_TYPES_DOUBLE;  ///< of the node, as on the control
  double (*number)(const MachineState&, std::size_t axis) = nullptr;
  std::string (*text)(const MachineState&, std::size_t axis) = nullptr;
  Quantity quantity = Quantity::None;
};

namespace {

/// Of X Y Z in mm, then of A B C in degrees.
double ofAxis(base::Vec3 mm, const base::RotaryDeg& deg, std::size_t axis) {
  return axis < base::kAxisCount ? mm[axis] : deg[axis - base::kAxisCount];
}
double actual(const MachineState& state, std::size_t axis) {
  return ofAxis(state.actualMm, state.actualDeg, axis);
}
double command(const MachineState& state, std::size_t axis) {
  return ofAxis(state.commandMm, state.commandDeg, axis);
}
double toGo(const MachineState& state, std::size_t axis) {
  return ofAxis(state.distanceToGoMm, state.distanceToGoDeg, axis);
}
/// In machine coordinates.
double machineActual(const MachineState& state, std::size_t axis) {
  return ofAxis(state.actualMm + state.zeroMm, state.actualDeg, axis);
}
double machineCommand(const MachineState& state, std::size_t axis) {
  return ofAxis(state.commandMm + state.zeroMm, state.commandDeg, axis);
}
double toolNumber(const MachineState& state, std::size_t /*axis*/) {
  return state.equipment.tool;
}
double edgeNumber(const MachineState& state, std::size_t /*axis*/) {
  return state.equipment.edge;
}
std::string toolName(const MachineState& state, std::size_t /*axis*/) {
  return state.equipment.toolName;
}
double spindleSpeed(const MachineState& state, std::size_t /*axis*/) {
  return std::abs(state.equipment.spindlePerMin);
}
double spindleCommand(const MachineState& state, std::size_t /*axis*/) {
  return std::abs(state.equipment.spindleCommandPerMin);
}
double spindleTurn(const MachineState& state, std::size_t /*axis*/) {
  return static_cast<double>(opcua::turnOf(state.equipment.spindlePerMin));
}
std::string workOffset(const MachineState& state, std::size_t /*axis*/) {
  return fmt::format("G{}", state.equipment.workOffset);
}
double floodFunction(const MachineState& state, std::size_t /*axis*/) {
  return state.equipment.flood ? opcua::kFloodOn : opcua::kCoolantOff;
}
double mistFunction(const MachineState& state, std::size_t /*axis*/) {
  return state.equipment.mist ? opcua::kMistOn : opcua::kCoolantOff;
}
double feed(const MachineState& state, std::size_t /*axis*/) {
  return base::mmPerMinFromMmPerS(state.feedMmPerS);
}
double feedCommand(const MachineState& state, std::size_t /*axis*/) {
  return base::mmPerMinFromMmPerS(state.feedCommandMmPerS);
}
double programStatus(const MachineState& state, std::size_t /*axis*/) {
  return static_cast<double>(state.program);
}
double channelStatus(const MachineState& state, std::size_t /*axis*/) {
  return static_cast<double>(state.channel);
}
double alarm(const MachineState& state, std::size_t /*axis*/) {
  return state.alarm;
}
double line(const MachineState& state, std::size_t /*axis*/) {
  return state.line;
}
double bufferLevel(const MachineState& state, std::size_t /*axis*/) {
  return state.bufferedBlocks;
}
std::string programName(const MachineState& state, std::size_t /*axis*/) {
  return state.programName;
}
std::string message(const MachineState& state, std::size_t /*axis*/) {
  return state.message;
}
char axisLetter(std::size_t axis) {
  return std::string_view("XYZABC")[axis];
}
std::string axisName(const MachineState& /*state*/, std::size_t axis) {
  return std::string(1, axisLetter(axis));
}

/// A number of the channel.
constexpr VariableRow scalar(std::string_view folder, std::string_view name, std::size_t type,
                             double (*number)(const MachineState&, std::size_t),
                             std::string_view description, Quantity quantity = Quantity::None) {
  return {folder, name, description, false, type, number, nullptr, quantity};
}
/// A length or an angle per axis.
constexpr VariableRow axes(std::string_view folder, std::string_view name,
                           double (*number)(const MachineState&, std::size_t),
                           std::string_view description, Quantity quantity = Quantity::Position) {
  return {folder, name, description, true, UA_TYPES_DOUBLE, number, nullptr, quantity};
}
constexpr VariableRow text(std::string_view folder, std::string_view name,
                           std::string (*value)(const MachineState&, std::size_t),
                           std::string_view description, bool perAxis = false) {
  return {folder, name, description, perAxis, UA_TYPES_STRING, nullptr, value};
}

// Some values have two names.
constexpr std::string_view kActual = "Actual position of axis {} in the workpiece.";
constexpr std::string_view kToGo = "Distance of axis {} to the end of its block.";
constexpr std::string_view kMachineActual = "Actual position of axis {} in machine coordinates.";
constexpr std::string_view kProgram = "Name of the selected program.";

constexpr std::array kRows{
    axes("GeometricAxis", "aaAcsRel", actual, kActual),
    axes("GeometricAxis", "aaDtew", toGo, kToGo),
    text("GeometricAxis", "name", axisName, "Letter of axis {}.", true),
    axes("GeometricAxis", "actToolBasePos", actual, kActual),
    axes("GeometricAxis", "cmdToolBasePos", command, "Set point of axis {} in the workpiece."),
    axes("GeometricAxis", "toolBaseDistToGo", toGo, kToGo),
    axes("MachineAxis", "measPos1", machineActual, kMachineActual, Quantity::MachinePlace),
    axes("MachineAxis", "actToolBasePos", machineActual, kMachineActual, Quantity::MachinePlace),
    axes("MachineAxis", "cmdContrPos", machineCommand,
         "Set point of axis {} in machine coordinates.", Quantity::MachinePlace),
    scalar("State", "actFeedRateIpo", UA_TYPES_DOUBLE, feed,
           "Actual feed along the path; in degrees per minute while only rotary axes turn.",
           Quantity::PathFeed),
    scalar("State", "cmdFeedRateIpo", UA_TYPES_DOUBLE, feedCommand,
           "Commanded feed along the path; in degrees per minute while only rotary axes turn.",
           Quantity::PathFeed),
    scalar("State", "progStatus", UA_TYPES_UINT16, programStatus,
           "Program: 1 interrupted, 2 stopped, 3 running, 4 waiting, 5 aborted."),
    scalar("State", "chanStatus", UA_TYPES_UINT16, channelStatus,
           "Channel: 0 reset, 1 active, 2 interrupted."),
    scalar("State", "chanAlarm", UA_TYPES_UINT32, alarm, "Number of the alarm; 0 for none."),
    scalar("State", "actTNumber", UA_TYPES_UINT32, toolNumber,
           "Number of the tool in the spindle; 0 for none."),
    scalar("State", "actDNumber", UA_TYPES_UINT32, edgeNumber,
           "Number of the active edge of the tool."),
    text("State", "actToolIdent", toolName, "Name of the tool in the spindle."),
    scalar("Spindle", "actSpeed", UA_TYPES_DOUBLE, spindleSpeed,
           "Actual speed of the spindle, without its direction.", Quantity::SpindleSpeed),
    scalar("Spindle", "cmdSpeed", UA_TYPES_DOUBLE, spindleCommand,
           "Commanded speed of the spindle, without its direction.", Quantity::SpindleSpeed),
    scalar("Spindle", "turnState", UA_TYPES_UINT16, spindleTurn,
           "Spindle: 0 turns clockwise, 1 turns counterclockwise, 2 stands."),
    text("ProgramInfo", "progName", programName, kProgram),
    text("ProgramInfo", "selectedWorkPProg", programName, kProgram),
    scalar("ProgramInfo", "actLineNumber", UA_TYPES_UINT32, line, "Line of the block in motion."),
    text("ProgramInfo", "msg", message, "Message of the program to the operator."),
    scalar("ChannelDiagnose", "ipoBufLevel", UA_TYPES_UINT16, bufferLevel,
           "Number of prepared blocks that are not finished."),
};

/// Variables of which only some elements are served; none is the first, so none is listed.
struct ElementRow {
  opcua::Variable variable;
  VariableRow row;
};
constexpr std::array kElements{
    ElementRow{{opcua::VariableKind::GFunction, opcua::kWorkOffsetGroup},
               text({}, "ncFktAct", workOffset, "Active G function of the work offset.")},
    ElementRow{{opcua::VariableKind::MFunction, opcua::kFloodGroup},
               scalar({}, "acAuxfuMValue", UA_TYPES_DOUBLE, floodFunction,
                      "Active M function of flood coolant: 8 on, 9 off.")},
    ElementRow{{opcua::VariableKind::MFunction, opcua::kMistGroup},
               scalar({}, "acAuxfuMValue", UA_TYPES_DOUBLE, mistFunction,
                      "Active M function of mist coolant: 7 on, 9 off.")},
};

constexpr std::string_view kSpindle = "Spindle";
struct FolderRow {
  std::string_view name;
  std::string_view description;
};
constexpr std::array kFolders{
    FolderRow{"Parameter", "R-parameters of the channel; browsing lists only R1."},
    FolderRow{"GeometricAxis", "Axes in the workpiece; browsing lists only the first."},
    FolderRow{"MachineAxis", "Axes in machine coordinates; browsing lists only the first."},
    FolderRow{"State", "State of the channel."},
    FolderRow{"ProgramInfo", "The program that is selected or running."},
    FolderRow{"ChannelDiagnose", "How far the control has prepared the program."},
    FolderRow{kSpindle, "The spindle."}};

std::string descriptionOf(const VariableNode& node) {
  if (node.row == nullptr && node.count == 0) {
    return fmt::format("R-parameter {}, for NC programs and clients.", node.index);
  }
  if (node.row == nullptr) {
    return fmt::format("R-parameters {} to {}, for NC programs and clients.", node.index,
                       node.index + node.count - 1);
  }
  return node.row->perAxis ? fmt::format(fmt::runtime(node.row->description),
                                         axisLetter(static_cast<std::size_t>(node.index)))
                           : std::string(node.row->description);
}

/// A unit of measurement by its common code (UNECE Recommendation 20). The number of a unit is the
/// code, one character for each byte (OPC 10000-8, 5.6.4.3).
struct Unit {
  std::string_view code;
  std::string_view symbol;
  std::string_view name;
};

/// @pre it measures something
Unit unitOf(const VariableNode& node) {
  switch (node.row->quantity) {
    case Quantity::PathFeed:
      return {"H81", "mm/min", "millimetre per minute"};
    case Quantity::SpindleSpeed:
      return {"RPM", "r/min", "revolutions per minute"};
    default:
      return static_cast<std::size_t>(node.index) < base::kAxisCount
                 ? Unit{"MMT", "mm", "millimetre"}
                 : Unit{"DD", "\u00b0", "degree [unit of angle]"};
  }
}

std::optional<ValueRange> rangeOf(const VariableNode& node) {
  const ServedFacts& facts = node.service->control().facts();
  switch (node.row == nullptr ? Quantity::None : node.row->quantity) {
    case Quantity::MachinePlace:
      return facts.travel[static_cast<std::size_t>(node.index)];
    case Quantity::PathFeed:
      return facts.feedMmPerMin;
    case Quantity::SpindleSpeed:
      return facts.spindlePerMin;
    default:
      return std::nullopt;
  }
}

/// The variable type of the standard that has just these properties.
UA_UInt32 variableTypeOf(const VariableNode& node) {
  if (node.row == nullptr || node.row->quantity == Quantity::None) {
    return UA_NS0ID_BASEDATAVARIABLETYPE;
  }
  return rangeOf(node) ? UA_NS0ID_ANALOGITEMTYPE : UA_NS0ID_ANALOGUNITTYPE;
}

UA_StatusCode setNumber(UA_Variant& variant, double value, std::size_t type) {
  switch (type) {
    case UA_TYPES_UINT16: {
      const auto number = static_cast<UA_UInt16>(value);
      return UA_Variant_setScalarCopy(&variant, &number, &UA_TYPES[type]);
    }
    case UA_TYPES_UINT32: {
      const auto number = static_cast<UA_UInt32>(value);
      return UA_Variant_setScalarCopy(&variant, &number, &UA_TYPES[type]);
    }
    default:
      return UA_Variant_setScalarCopy(&variant, &value, &UA_TYPES[UA_TYPES_DOUBLE]);
  }
}

/// Waits until the variable service has done its work on the node.
void serve(const VariableNode& node, AccessKind kind) {
  const ArrayCharge charge = node.service->control().facts().arrays.charge;
  const int times = charge == ArrayCharge::Element ? std::max(node.count, 1) : 1;
  for (int i = 0; i < times; ++i) {
    node.service->serve(kind);
  }
}

UA_StatusCode onRead(UA_Server* /*server*/, const UA_NodeId* /*sessionId*/,
                     void* /*sessionContext*/, const UA_NodeId* /*nodeId*/, void* nodeContext,
                     UA_Boolean withSourceTime, const UA_NumericRange* range,
                     UA_DataValue* value) noexcept {
  const auto& node = *static_cast<const VariableNode*>(nodeContext);
  if (range != nullptr) {  // arrays are addressed by their identifiers
    value->hasStatus = true;
    value->status = UA_STATUSCODE_BADINDEXRANGEINVALID;
    return UA_STATUSCODE_GOOD;
  }
  serve(node, AccessKind::Read);
  const ServedControl& control = node.service->control();
  UA_StatusCode status = UA_STATUSCODE_GOOD;
  if (node.count > 0) {
    std::vector<UA_Double> values;
    for (int element = 0; element < node.count; ++element) {
      values.push_back(control.rParameter(node.index + element));
    }
    status = UA_Variant_setArrayCopy(&value->value, values.data(), values.size(),
                                     &UA_TYPES[UA_TYPES_DOUBLE]);
  } else if (node.row == nullptr) {
    status = setNumber(value->value, control.rParameter(node.index), UA_TYPES_DOUBLE);
  } else {
    const MachineState state = control.state();
    if (node.row->text != nullptr) {
      const std::string shown = node.row->text(state, static_cast<std::size_t>(node.index));
      const UA_String string = opcua::borrow(shown);
      status = UA_Variant_setScalarCopy(&value->value, &string, &UA_TYPES[UA_TYPES_STRING]);
    } else {
      const double number = node.row->number(state, static_cast<std::size_t>(node.index));
      status = setNumber(value->value, number, node.row->type);
    }
  }
  value->hasValue = status == UA_STATUSCODE_GOOD;
  if (withSourceTime) {
    value->hasSourceTimestamp = true;
    value->sourceTimestamp = UA_DateTime_now();
  }
  return status;
}

/// Only R-parameters have it. The library has checked the type already.
UA_StatusCode onWrite(UA_Server* /*server*/, const UA_NodeId* /*sessionId*/,
                      void* /*sessionContext*/, const UA_NodeId* /*nodeId*/, void* nodeContext,
                      const UA_NumericRange* range, const UA_DataValue* value) noexcept {
  const auto& node = *static_cast<const VariableNode*>(nodeContext);
  if (range != nullptr) {
    return UA_STATUSCODE_BADINDEXRANGEINVALID;
  }
  const auto* number =
      value->hasValue ? opcua::scalarOf<UA_Double>(value->value, UA_TYPES_DOUBLE) : nullptr;
  if (number == nullptr) {
    return UA_STATUSCODE_BADTYPEMISMATCH;
  }
  if (!std::isfinite(*number)) {
    return UA_STATUSCODE_BADOUTOFRANGE;
  }
  node.service->serve(AccessKind::Write);
  node.service->control().writeRParameter(node.index, *number);
  return UA_STATUSCODE_GOOD;
}

/// An array of R-parameters. The library has checked type and length already.
UA_StatusCode onWriteArray(UA_Server* /*server*/, const UA_NodeId* /*sessionId*/,
                           void* /*sessionContext*/, const UA_NodeId* /*nodeId*/, void* nodeContext,
                           const UA_NumericRange* range, const UA_DataValue* value) noexcept {
  const auto& node = *static_cast<const VariableNode*>(nodeContext);
  if (range != nullptr) {
    return UA_STATUSCODE_BADINDEXRANGEINVALID;
  }
  const auto count = static_cast<std::size_t>(node.count);
  if (!value->hasValue || !UA_Variant_hasArrayType(&value->value, &UA_TYPES[UA_TYPES_DOUBLE]) ||
      value->value.arrayLength != count) {
    return UA_STATUSCODE_BADTYPEMISMATCH;
  }
  const std::span numbers(static_cast<const UA_Double*>(value->value.data), count);
  if (!std::all_of(numbers.begin(), numbers.end(),
                   [](double each) { return std::isfinite(each); })) {
    return UA_STATUSCODE_BADOUTOFRANGE;
  }
  serve(node, AccessKind::Write);
  ServedControl& control = node.service->control();
  const bool firstOnly = control.facts().arrays.write == ArrayWrite::FirstOnly;
  for (int element = 0; element < (firstOnly ? 1 : node.count); ++element) {
    control.writeRParameter(node.index + element, numbers[static_cast<std::size_t>(element)]);
  }
  return UA_STATUSCODE_GOOD;
}

/// Appends a text to those of a node in the store, which releases it.
UA_StatusCode addText(UA_LocalizedTextListEntry*& list, const UA_LocalizedText& text) {
  auto* entry =
      static_cast<UA_LocalizedTextListEntry*>(UA_calloc(1, sizeof(UA_LocalizedTextListEntry)));
  if (entry == nullptr) {
    return UA_STATUSCODE_BADOUTOFMEMORY;
  }
  entry->next = list;
  list = entry;
  return UA_LocalizedText_copy(&text, &entry->localizedText);
}

/// More arrays than any client uses; a client that tries all of them must not fill the memory.
constexpr std::size_t kArrayNodesMax = 10'000;

constexpr std::string_view kRoot = "Sinumerik";
constexpr std::string_view kChannel = "/Channel";

}  // namespace

base::Result<void> AddressSpace::build() {
  const std::string uri(opcua::kNamespaceUri);
  m_namespace = UA_Server_addNamespace(m_server, uri.c_str());
  UA_StatusCode status = addFolder({}, kRoot, kRoot, "The control, with the names of a SINUMERIK.");
  if (status == UA_STATUSCODE_GOOD) {
    status = addFolder(kRoot, kChannel, "Channel", "The first channel, the only one.");
  }
  for (const FolderRow& folder : kFolders) {
    if (status == UA_STATUSCODE_GOOD) {
      status = addFolder(kChannel, fmt::format("{}/{}", kChannel, folder.name), folder.name,
                         folder.description);
    }
  }
  if (status == UA_STATUSCODE_GOOD) {
    status = addParameters();
  }
  const auto isThere = [this](const VariableRow& row) {
    return m_service.control().shows(row.folder, row.name);
  };
  for (const VariableRow& row : kRows) {
    if (status == UA_STATUSCODE_GOOD && isThere(row)) {
      status = addVariable(row);
    }
  }
  for (const ElementRow& element : kElements) {
    if (status == UA_STATUSCODE_GOOD && isThere(element.row)) {
      status =
          addNode({}, opcua::nodeIdentifier(element.variable), element.row.name, &element.row, 0);
    }
  }
  if (status != UA_STATUSCODE_GOOD) {
    return base::fail(
        FrontError::SetUpFailed,
        fmt::format("The server's variables cannot be set up ({}).", UA_StatusCode_name(status)));
  }
  return {};
}

UA_StatusCode AddressSpace::addFolder(std::string_view parent, std::string_view identifier,
                                      std::string_view name, std::string_view description) {
  UA_ObjectAttributes attributes = UA_ObjectAttributes_default;
  attributes.displayName.text = opcua::borrow(name);
  attributes.description = localized(description);
  UA_QualifiedName browseName{m_namespace, opcua::borrow(name)};
  const UA_NodeId parentId = parent.empty() ? opcua::standardNodeId(UA_NS0ID_OBJECTSFOLDER)
                                            : opcua::borrowNodeId(m_namespace, parent);
  return UA_Server_addObjectNode(m_server, opcua::borrowNodeId(m_namespace, identifier), parentId,
                                 opcua::standardNodeId(UA_NS0ID_ORGANIZES), browseName,
                                 opcua::standardNodeId(UA_NS0ID_FOLDERTYPE), attributes, nullptr,
                                 nullptr);
}

UA_StatusCode AddressSpace::addParameters() {
  constexpr std::string_view kFolder = "/Channel/Parameter";
  const ServedControl& control = m_service.control();
  UA_StatusCode status = UA_STATUSCODE_GOOD;
  for (int number = 0; control.hasRParameter(number) && status == UA_STATUSCODE_GOOD; ++number) {
    status = addNode({}, opcua::nodeIdentifier(opcua::rParameter(number)), "R", nullptr, number);
    if (status == UA_STATUSCODE_GOOD) {
      status = addNode({}, fmt::format("{}/R[{}]", kFolder, number), "R", nullptr, number);
    }
    ++m_parameterCount;
  }
  if (status == UA_STATUSCODE_GOOD && control.hasRParameter(1)) {
    status = addNode(kFolder, fmt::format("{}/R", kFolder), "R", nullptr, 1);
  }
  return status;
}

UA_StatusCode AddressSpace::addVariable(const VariableRow& row) {
  const std::string folder = fmt::format("{}/{}", kChannel, row.folder);
  const std::string identifier = fmt::format("{}/{}", folder, row.name);
  UA_StatusCode status = addNode(folder, identifier, row.name, &row, 0);
  const ServedFacts& facts = m_service.control().facts();
  const auto axisCount = row.folder == kSpindle ? 1
                         : row.perAxis
                             ? static_cast<int>(base::kAxisCount + facts.rotaryAxes.size())
                             : 0;
  for (int axis = 0; axis < axisCount; ++axis) {
    const auto place = static_cast<std::size_t>(axis);
    const int index =
        place < base::kAxisCount
            ? axis
            : static_cast<int>(base::kAxisCount + facts.rotaryAxes[place - base::kAxisCount]);
    for (const std::string& alias : {fmt::format("{}[u1,{}]", identifier, axis + 1),
                                     fmt::format("{}[{}]", identifier, axis + 1)}) {
      if (status == UA_STATUSCODE_GOOD) {
        status = addNode({}, alias, row.name, &row, index);
      }
    }
  }
  return status;
}

UA_StatusCode AddressSpace::addNode(std::string_view folder, std::string_view identifier,
                                    std::string_view name, const VariableRow* row, int index) {
  m_nodes.push_back({&m_service, row, index, 0});
  const VariableNode& node = m_nodes.back();
  const std::string description = descriptionOf(node);
  UA_VariableAttributes attributes = UA_VariableAttributes_default;
  attributes.displayName.text = opcua::borrow(name);
  attributes.description = localized(description);
  attributes.dataType = UA_TYPES[row == nullptr ? UA_TYPES_DOUBLE : row->type].typeId;
  attributes.valueRank = UA_VALUERANK_SCALAR;
  attributes.accessLevel = UA_ACCESSLEVELMASK_READ;
  UA_DataSource source{};
  source.read = &onRead;
  if (row == nullptr) {
    attributes.accessLevel |= UA_ACCESSLEVELMASK_WRITE;
    source.write = &onWrite;
  }
  // A node without a parent exists but is never found by browsing.
  const bool listed = !folder.empty();
  const UA_NodeId id = opcua::borrowNodeId(m_namespace, identifier);
  UA_StatusCode status = UA_Server_addNode_begin(
      m_server, UA_NODECLASS_VARIABLE, id,
      listed ? opcua::borrowNodeId(m_namespace, folder) : UA_NodeId{},
      listed ? opcua::standardNodeId(UA_NS0ID_HASCOMPONENT) : UA_NodeId{},
      {m_namespace, opcua::borrow(name)}, opcua::standardNodeId(variableTypeOf(node)), &attributes,
      &UA_TYPES[UA_TYPES_VARIABLEATTRIBUTES], &m_nodes.back(), nullptr);
  if (status == UA_STATUSCODE_GOOD) {
    status = UA_Server_setVariableNode_dataSource(m_server, id, source);
  }
  // The library adds what its type says and is not there yet, so the properties come first.
  if (status == UA_STATUSCODE_GOOD && variableTypeOf(node) != UA_NS0ID_BASEDATAVARIABLETYPE) {
    status = addUnit(identifier, node);
  }
  return status == UA_STATUSCODE_GOOD ? UA_Server_addNode_finish(m_server, id) : status;
}

UA_StatusCode AddressSpace::addUnit(std::string_view identifier, const VariableNode& node) {
  const UA_NodeId owner = opcua::borrowNodeId(m_namespace, identifier);
  const auto add = [&](std::string_view name, const UA_Variant& value,
                       std::string_view description) {
    const std::string place = opcua::memberIdentifier(identifier, name);
    return addProperty(m_server, owner, opcua::borrowNodeId(m_namespace, place),
                       {0, opcua::borrow(name)}, value, description);
  };
  const Unit unit = unitOf(node);
  UA_EUInformation information{};
  information.namespaceUri = opcua::borrow("http://www.opcfoundation.org/UA/units/un/cefact");
  for (const char letter : unit.code) {
    constexpr int kByte = 256;
    information.unitId = information.unitId * kByte + letter;
  }
  information.displayName.text = opcua::borrow(unit.symbol);
  information.description = localized(unit.name);
  UA_StatusCode status =
      add("EngineeringUnits", opcua::borrowScalar(information, UA_TYPES_EUINFORMATION),
          "Unit of the value.");
  if (const auto range = rangeOf(node)) {
    UA_Range limits{range->low, range->high};
    status |= add("EURange", opcua::borrowScalar(limits, UA_TYPES_RANGE),
                  "Range of the value in normal operation.");
  }
  return status;
}

int AddressSpace::arrayLengthMax() const {
  const ArrayAccess& arrays = m_service.control().facts().arrays;
  return arrays.count || arrays.range ? m_parameterCount : 0;
}

const UA_Node* AddressSpace::arrayNode(UA_Nodestore& store, const UA_NodeId& id) {
  if (id.namespaceIndex != m_namespace || id.identifierType != UA_NODEIDTYPE_STRING ||
      m_arrayCount == kArrayNodesMax) {
    return nullptr;
  }
  const std::optional<opcua::ParameterArray> array =
      opcua::arrayOf(opcua::view(id.identifier.string));
  const ServedControl& control = m_service.control();
  const ArrayAccess& arrays = control.facts().arrays;
  if (!array || !control.hasRParameter(array->first + array->count - 1) ||
      !(array->form == opcua::Grouping::ArrayCount ? arrays.count : arrays.range)) {
    return nullptr;
  }
  UA_Node* node = store.newNode(store.context, UA_NODECLASS_VARIABLE);
  if (node == nullptr) {
    return nullptr;
  }
  // Straight into the store: the server is in the middle of looking for it.
  UA_VariableNode& variable = node->variableNode;
  const UA_QualifiedName browseName{m_namespace, opcua::borrow("R")};
  const auto dimension = static_cast<UA_UInt32>(array->count);
  UA_StatusCode status = UA_NodeId_copy(&id, &variable.head.nodeId);
  status |= UA_QualifiedName_copy(&browseName, &variable.head.browseName);
  status |= UA_Array_copy(&dimension, 1, reinterpret_cast<void**>(&variable.arrayDimensions),
                          &UA_TYPES[UA_TYPES_UINT32]);
  const VariableNode described{&m_service, nullptr, array->first, array->count};
  status |= addText(variable.head.displayName, {{}, browseName.name});
  status |= addText(variable.head.description, localized(descriptionOf(described)));
  UA_ExpandedNodeId type{};
  type.nodeId = opcua::standardNodeId(variableTypeOf(described));
  status |= UA_Node_addReference(node, UA_REFERENCETYPEINDEX_HASTYPEDEFINITION, true, &type, 0);
  if (status != UA_STATUSCODE_GOOD) {
    store.deleteNode(store.context, node);
    return nullptr;
  }
  m_nodes.push_back(described);
  variable.head.context = &m_nodes.back();
  variable.head.constructed = true;
  variable.arrayDimensionsSize = 1;
  variable.dataType = UA_TYPES[UA_TYPES_DOUBLE].typeId;
  variable.valueRank = UA_VALUERANK_ONE_DIMENSION;
  variable.accessLevel = UA_ACCESSLEVELMASK_READ;
  variable.valueSource = UA_VALUESOURCE_DATASOURCE;
  variable.value.dataSource.read = &onRead;
  if (arrays.write != ArrayWrite::Refused) {
    variable.accessLevel |= UA_ACCESSLEVELMASK_WRITE;
    variable.value.dataSource.write = &onWriteArray;
  }
  if (store.insertNode(store.context, node, nullptr) != UA_STATUSCODE_GOOD) {
    return nullptr;  // the store has released everything
  }
  ++m_arrayCount;
  return store.getNode(store.context, &id, UA_NODEATTRIBUTESMASK_ALL, UA_REFERENCETYPESET_ALL,
                       UA_BROWSEDIRECTION_BOTH);
}

}  // namespace rivulet::machine
