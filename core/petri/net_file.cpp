// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "petri/net_file.h"

#include <fmt/format.h>
#include <nets_texts.h>

#include <toml++/toml.h>
#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "base/file.h"
#include "base/text.h"
#include "petri/expression.h"
#include "petri/marking.h"

namespace rivulet::petri {

namespace {

using base::Result;

constexpr std::size_t kInstancesMax = 10'000;  // of pages: one that contains itself ends here

/// A place of an instance of a page, by the name it has there.
using PlacesOfPage = std::map<std::string, std::size_t>;

class NetReader {
 public:
  NetReader(const toml::table& root, std::string origin, const ParameterValues& parameters,
            const base::Budget& budget)
      : m_root(root), m_origin(std::move(origin)), m_parameters(parameters), m_budget(budget) {}

  Result<Net> read() {
    m_net.name = text(m_root, "name");
    m_net.timeUnit = text(m_root, "time_unit");
    checkKeys(m_root, "",
              {"name", "time_unit", "title", "parameters", "colours", "measured", "functions",
               "pages", "top", "invariants"});
    readParameters();
    readColours();
    readFunctions();
    const std::string top = text(m_root, "top");
    if (!m_error) {
      readPage(top, top, 0, {}, m_constants);
    }
    readInvariants();
    if (m_error) {
      return base::fail(*m_error);
    }
    return std::move(m_net);
  }

 private:
  // --- TOML -----------------------------------------------------------------------------------
  void failNow(PetriError code, const std::string& message) {
    if (!m_error) {
      m_error = base::makeError(code, message, m_origin);
    }
  }
  void failAt(const std::string& where, const base::Error& error) {
    if (!m_error) {
      m_error = base::Error{error.code, fmt::format("{}: {}", where, error.message), m_origin};
    }
  }
  /// A page stands for all that is on it, as often as it is used.
  void hold(double bytes) {
    m_held += bytes;
    const double nodes = 2.0 * static_cast<double>(m_net.nodes.size() * sizeof(Node));
    if (auto fits = m_budget.require(m_held + nodes, "The net"); !fits && !m_error) {
      m_error = fits.error();
      m_error->context = m_origin;
    }
  }
  std::string text(const toml::table& table, const std::string& key) {
    const std::optional<std::string> value = table[key].value<std::string>();
    if (!value) {
      failNow(PetriError::NotANet, fmt::format("The net needs a text \"{}\".", key));
    }
    return value.value_or("");
  }
  static const toml::table& tableOf(const toml::table& parent, const std::string& key) {
    static const toml::table kNone;
    const toml::table* const found = parent[key].as_table();
    return found == nullptr ? kNone : *found;
  }
  void checkKeys(const toml::table& table, const std::string& where,
                 const std::set<std::string_view>& known) {
    for (const auto& [key, value] : table) {
      if (known.count(key.str()) == 0) {
        failNow(PetriError::NotANet,
                fmt::format("{}: \"{}\" has no meaning; known are {}.",
                            where.empty() ? "The net" : where, key.str(), fmt::join(known, ", ")));
      }
    }
  }
  /// A text, or several.
  std::vector<std::string> texts(const toml::node& node, const std::string& where) {
    std::vector<std::string> all;
    if (const auto one = node.value<std::string>()) {
      all.push_back(*one);
    } else if (const toml::array* const array = node.as_array()) {
      for (const toml::node& element : *array) {
        all.push_back(element.value<std::string>().value_or(""));
      }
    } else {
      failNow(PetriError::NotANet, fmt::format("{} must be a text or a list of texts.", where));
    }
    return all;
  }

  // --- declarations -----------------------------------------------------------------------------
  NodeId constant(Word value) {
    Node node;
    node.value = value;
    m_net.nodes.push_back(node);
    return static_cast<NodeId>(m_net.nodes.size() - 1);
  }

  void readParameters() {
    const toml::table& table = tableOf(m_root, "parameters");
    for (const auto& [key, node] : table) {
      const std::string name(key.str());
      const auto value = node.value<std::int64_t>();
      if (!value) {
        failNow(PetriError::NotANet, fmt::format("Parameter {} must be a whole number.", name));
        return;
      }
      const auto changed = m_parameters.find(name);
      const Word used = changed == m_parameters.end() ? *value : changed->second;
      m_net.parameters[name] = used;
      m_constants[name] = constant(used);
    }
    for (const auto& [name, value] : m_parameters) {
      if (!table.contains(name)) {
        std::vector<std::string> known;
        for (const auto& [key, node] : table) {
          known.emplace_back(key.str());
        }
        failNow(PetriError::Unknown, fmt::format("There is no parameter \"{}\"; there are {}.",
                                                 name, fmt::join(known, ", ")));
      }
    }
  }

  std::size_t colourOf(const std::string& name, const std::string& where) {
    const auto found = std::find_if(m_net.colours.begin(), m_net.colours.end(),
                                    [&](const Colour& colour) { return colour.name == name; });
    if (found == m_net.colours.end()) {
      failNow(PetriError::Unknown, fmt::format("{}: colour set \"{}\" is not known.", where, name));
      return kInt;
    }
    return static_cast<std::size_t>(found - m_net.colours.begin());
  }

  void readColours() {
    for (const auto& [name, kind] :
         {std::pair{"INT", ColourKind::Int}, std::pair{"BOOL", ColourKind::Bool},
          std::pair{"STRING", ColourKind::String}, std::pair{"UNIT", ColourKind::Unit},
          std::pair{"LIST", ColourKind::List}}) {
      Colour colour;
      colour.name = name;
      colour.kind = kind;
      m_net.colours.push_back(std::move(colour));
    }
    // In TOML the order of keys is lost: a colour set is read when those it needs are known.
    std::map<std::string, std::string> left;
    for (const auto& [key, node] : tableOf(m_root, "colours")) {
      left[std::string(key.str())] = node.value<std::string>().value_or("");
    }
    bool goesOn = true;
    while (!left.empty() && goesOn && !m_error) {
      goesOn = false;
      for (auto at = left.begin(); at != left.end();) {
        if (readColour(at->first, at->second)) {
          at = left.erase(at);
          goesOn = true;
        } else {
          ++at;
        }
      }
    }
    if (!left.empty()) {
      failNow(
          PetriError::NotANet,
          fmt::format("Colour set {}: \"{}\" must be \"record a:INT b:STRING …\" or \"list TASK\" "
                      "of colour sets that are defined.",
                      left.begin()->first, left.begin()->second));
    }
    for (const auto& [key, node] : tableOf(m_root, "measured")) {
      Colour& colour = m_net.colours[colourOf(std::string(key.str()), "measured")];
      for (const std::string& name : texts(node, "measured")) {
        const auto field = std::find_if(colour.fields.begin(), colour.fields.end(),
                                        [&](const Field& one) { return one.name == name; });
        if (field == colour.fields.end()) {
          failNow(PetriError::Unknown,
                  fmt::format("measured: {} has no field \"{}\".", colour.name, name));
          return;
        }
        field->isMeasured = true;
      }
    }
  }

  bool readColour(const std::string& name, const std::string& declaration) {
    const auto known = [&](std::string_view wanted) -> std::optional<std::size_t> {
      for (std::size_t i = 0; i < m_net.colours.size(); ++i) {
        if (m_net.colours[i].name == wanted) {
          return i;
        }
      }
      return std::nullopt;
    };
    std::vector<std::string> words;
    for (std::size_t at = 0; at < declaration.size();) {
      const std::size_t end = std::min(declaration.find_first_of(" \n", at), declaration.size());
      if (end > at) {
        words.push_back(declaration.substr(at, end - at));
      }
      at = end + 1;
    }
    Colour colour;
    colour.name = name;
    if (words.size() == 2 && words[0] == "list") {
      const auto element = known(words[1]);
      if (!element || m_net.colours[*element].kind == ColourKind::List) {
        return false;
      }
      colour.kind = ColourKind::List;
      colour.element = *element;
      colour.width = m_net.colours[*element].width;
    } else if (words.size() > 1 && words[0] == "record") {
      colour.kind = ColourKind::Record;
      colour.width = 0;
      for (std::size_t i = 1; i < words.size(); ++i) {
        const std::size_t colon = words[i].find(':');
        const auto field =
            colon == std::string::npos ? std::nullopt : known(words[i].substr(colon + 1));
        if (!field || m_net.colours[*field].kind == ColourKind::List) {
          return false;
        }
        colour.fields.push_back({words[i].substr(0, colon), *field, colour.width, false});
        colour.width += m_net.colours[*field].width;
      }
    } else {
      return false;
    }
    m_net.colours.push_back(std::move(colour));
    return true;
  }

  /// A function may call those that stand before it.
  void readFunctions() {
    const toml::array* const functions = m_root["functions"].as_array();
    Scope scope;
    scope.constants = m_constants;
    for (std::size_t i = 0; functions != nullptr && i < functions->size(); ++i) {
      const std::string declaration = (*functions)[i].value<std::string>().value_or("");
      if (auto done = parseFunction(m_net, scope, declaration); !done) {
        failAt("functions", done.error());
      }
    }
  }

  void readInvariants() {
    Scope scope;
    scope.constants = m_constants;
    for (std::size_t i = 0; i < m_net.places.size(); ++i) {
      scope.places[m_net.places[i].name] = i;
    }
    for (const auto& [key, node] : tableOf(m_root, "invariants")) {
      const std::string name(key.str());
      const std::string condition = node.value<std::string>().value_or("");
      auto root = parseExpression(m_net, scope, condition);
      if (!root) {
        failAt("Invariant " + name, root.error());
        return;
      }
      if (m_net.nodes[*root].colour != kBool) {
        failNow(PetriError::WrongColour,
                fmt::format("Invariant {}: \"{}\" is not a condition.", name, condition));
        return;
      }
      m_net.invariants.push_back({name, *root, condition});
    }
  }

  // --- pages ------------------------------------------------------------------------------------
  using Constants = std::map<std::string, NodeId>;

  /// @param parent  index of the page it stands on
  void readPage(const std::string& page, const std::string& path, std::size_t parent,
                const PlacesOfPage& sockets, const Constants& constants) {
    const toml::table* const table = m_root["pages"][page].as_table();
    if (table == nullptr) {
      failNow(PetriError::Unknown, fmt::format("{}: page \"{}\" is not known.", path, page));
      return;
    }
    if (++m_instances > kInstancesMax) {
      failNow(PetriError::NotANet, fmt::format("Page \"{}\" contains itself.", page));
    }
    checkKeys(*table, "Page " + page, {"places", "transitions", "substitutions"});
    const std::size_t self = m_net.pages.size();
    m_net.pages.push_back({path, parent, {}});
    const auto draw = [&](PageNode::Kind kind, const std::string& name, std::size_t index,
                          const toml::node& node) {
      constexpr double kDrawnBytes = 2.0 * (sizeof(PageNode) + sizeof(Transition));
      hold(kDrawnBytes + 4.0 * static_cast<double>(path.size() + name.size()));
      if (!m_error) {
        m_net.pages[self].nodes.push_back(nodeOf(kind, name, index, node));
      }
    };
    PlacesOfPage places;
    for (const auto& [key, node] : tableOf(*table, "places")) {
      const std::string name(key.str());
      if (!m_error) {
        readPlace(name, node, path, sockets, constants, places);
        draw(PageNode::Kind::Place, name, places[name], node);
      }
    }
    for (const auto& [name, place] : sockets) {
      if (places.count(name) == 0) {
        failNow(PetriError::Unknown,
                fmt::format("{}: page {} has no place \"{}\" to connect.", path, page, name));
      }
    }
    for (const auto& [key, node] : tableOf(*table, "transitions")) {
      const std::string name(key.str());
      if (!m_error) {
        readTransition(path + '.' + name, node, places, constants);
        draw(PageNode::Kind::Transition, name, m_net.transitions.size() - 1, node);
      }
    }
    for (const auto& [key, node] : tableOf(*table, "substitutions")) {
      const std::string name(key.str());
      if (!m_error) {
        draw(PageNode::Kind::Substitution, name, m_net.pages.size(), node);
        readSubstitution(path + '.' + name, node, self, places, constants);
      }
    }
  }

  /// @param node  a table; "at" says where it is drawn
  PageNode nodeOf(PageNode::Kind kind, const std::string& name, std::size_t index,
                  const toml::node& node) {
    PageNode made;
    made.kind = kind;
    made.name = name;
    made.index = index;
    if (!node.is_table()) {
      return made;  // its reader says what is wrong
    }
    const toml::table& table = *node.as_table();
    made.isPort = table["port"].value_or(false);
    made.isFusion = table.contains("fusion");
    if (const toml::node* const at = table.get("at")) {
      const toml::array* const both = at->as_array();
      const auto column =
          both == nullptr || both->size() != 2 ? std::nullopt : both->get(0)->value<double>();
      const auto row = column ? both->get(1)->value<double>() : std::nullopt;
      if (!row) {
        failNow(PetriError::NotANet,
                fmt::format("{}: \"at\" must be a column and a row, as [1, 2].", name));
        return made;
      }
      made.hasPosition = true;
      made.column = *column;
      made.row = *row;
    }
    return made;
  }

  void readPlace(const std::string& name, const toml::node& node, const std::string& path,
                 const PlacesOfPage& sockets, const Constants& constants, PlacesOfPage& places) {
    const std::string full = path + '.' + name;
    const toml::table* const table = node.as_table();
    if (table == nullptr) {
      failNow(PetriError::NotANet, fmt::format("{}: a place needs at least a colour.", full));
      return;
    }
    checkKeys(*table, full, {"colour", "initial", "port", "fusion", "observer", "at"});
    const std::size_t colour = colourOf((*table)["colour"].value_or(std::string()), full);
    const auto join = [&](std::size_t index, const std::string& with) {
      places[name] = index;
      if (m_net.places[index].colour != colour) {
        failNow(PetriError::WrongColour,
                fmt::format("{} holds {}, but {} holds {}: they are one place.", full,
                            m_net.colours[colour].name, with,
                            m_net.colours[m_net.places[index].colour].name));
      }
    };
    if (const auto socket = sockets.find(name); socket != sockets.end()) {
      join(socket->second, m_net.places[socket->second].name);
      return;
    }
    if ((*table)["port"].value_or(false)) {
      failNow(PetriError::NotANet, fmt::format("{} is a port and must be connected.", full));
      return;
    }
    const std::string fusion = (*table)["fusion"].value_or(std::string());
    if (const auto known = m_fusions.find(fusion); known != m_fusions.end()) {
      join(known->second, m_net.places[known->second].name);
    } else {
      Place place;
      place.name = fusion.empty() ? full : fusion;
      place.colour = colour;
      place.isObserver = (*table)["observer"].value_or(false);
      m_net.places.push_back(place);
      places[name] = m_net.places.size() - 1;
      if (!fusion.empty()) {
        m_fusions[fusion] = places[name];
      }
    }
    if (const toml::node* const initial = table->get("initial")) {
      for (const std::string& token : texts(*initial, full + ".initial")) {
        readToken(places[name], token, constants);
      }
    }
  }

  /// "count`value @ time"; count and time may be missing.
  void readToken(std::size_t index, const std::string& token, const Constants& constants) {
    Scope scope;
    scope.constants = constants;
    const Marking nothing(m_net.places.size());
    Evaluator evaluator(m_net, nothing, nullptr);
    const std::string where = m_net.places[index].name;
    const auto number = [&](std::string_view part) -> Word {
      auto root = parseExpression(m_net, scope, part);
      if (!root || m_net.nodes[*root].colour != kInt) {
        failAt(where, root ? base::makeError(PetriError::WrongColour,
                                             fmt::format("\"{}\" is not a number.", part))
                           : root.error());
        return 0;
      }
      return evaluator.scalar(*root, {});
    };
    std::string_view value = token;
    Word count = 1;
    Word time = 0;
    if (const std::size_t tick = value.find('`'); tick != std::string_view::npos) {
      count = number(value.substr(0, tick));
      value.remove_prefix(tick + 1);
    }
    if (const std::size_t at = value.find('@'); at != std::string_view::npos) {
      time = number(value.substr(at + 1));
      value = value.substr(0, at);
    }
    auto root = parseExpression(m_net, scope, value);
    if (!root) {
      failAt(where, root.error());
      return;
    }
    if (count < 0) {
      failNow(PetriError::NotANet, fmt::format("{} cannot have {} tokens.", where, count));
      return;
    }
    hold(2.0 * static_cast<double>(count) * static_cast<double>(sizeof(Token) + sizeof(Words)));
    if (m_error) {
      return;
    }
    if (checkColour(*root, index, where, value)) {
      Token made;
      made.time = time;
      evaluator.evaluate(*root, {}, made.value);
      hold(2.0 * static_cast<double>(count) *
           static_cast<double>(made.value.size() * sizeof(Word)));
      if (m_error) {
        return;
      }
      m_net.places[index].initial.insert(m_net.places[index].initial.end(),
                                         static_cast<std::size_t>(count), made);
    }
  }

  bool checkColour(NodeId value, std::size_t place, const std::string& where,
                   std::string_view inscription) {
    const ColourId expected = m_net.places[place].colour;
    if (fits(m_net, m_net.nodes[value].colour, expected)) {
      return true;
    }
    failNow(PetriError::WrongColour,
            fmt::format("{}: \"{}\" is a value of {}, but place {} holds {}.", where, inscription,
                        m_net.colours[m_net.nodes[value].colour].name, m_net.places[place].name,
                        m_net.colours[expected].name));
    return false;
  }

  void readSubstitution(const std::string& path, const toml::node& node, std::size_t parent,
                        const PlacesOfPage& places, const Constants& constants) {
    const toml::table* const table = node.as_table();
    if (table == nullptr) {
      failNow(PetriError::NotANet, fmt::format("{}: a substitution needs a page.", path));
      return;
    }
    checkKeys(*table, path, {"page", "sockets", "with", "at"});
    PlacesOfPage sockets;
    for (const auto& [key, socket] : tableOf(*table, "sockets")) {
      const std::string name = socket.value<std::string>().value_or("");
      const auto found = places.find(name);
      if (found == places.end()) {
        failNow(PetriError::Unknown, fmt::format("{}: place \"{}\" is not known.", path, name));
        return;
      }
      sockets[std::string(key.str())] = found->second;
    }
    Constants inner = constants;
    for (const auto& [key, value] : tableOf(*table, "with")) {
      Scope scope;
      scope.constants = constants;
      const std::string expression = value.is_integer()
                                         ? std::to_string(value.value_or(std::int64_t{0}))
                                         : value.value<std::string>().value_or("");
      auto root = parseExpression(m_net, scope, expression);
      if (!root) {
        failAt(path, root.error());
        return;
      }
      inner[std::string(key.str())] = *root;
    }
    readPage((*table)["page"].value_or(std::string()), path, parent, sockets, inner);
  }

  // --- transitions ------------------------------------------------------------------------------
  /// An inscription of an arc as it is written.
  struct Inscription {
    std::size_t place = 0;
    std::string text;
  };

  std::vector<Inscription> inscriptions(const toml::table& table, const std::string& path,
                                        const PlacesOfPage& places) {
    std::vector<Inscription> all;
    for (const auto& [key, node] : table) {
      const auto found = places.find(std::string(key.str()));
      if (found == places.end()) {
        failNow(PetriError::Unknown,
                fmt::format("{}: place \"{}\" is not known.", path, key.str()));
        return all;
      }
      for (const std::string& one : texts(node, path)) {
        all.push_back({found->second, one});
      }
    }
    return all;
  }

  void readTransition(const std::string& path, const toml::node& node, const PlacesOfPage& places,
                      const Constants& constants) {
    const toml::table* const table = node.as_table();
    if (table == nullptr) {
      failNow(PetriError::NotANet, fmt::format("{}: a transition needs arcs.", path));
      return;
    }
    checkKeys(*table, path, {"priority", "guard", "in", "let", "out", "at"});
    Transition transition;
    transition.name = path;
    transition.priority = static_cast<int>((*table)["priority"].value_or(std::int64_t{0}));
    Scope scope;
    scope.constants = constants;
    readInputs(transition, inscriptions(tableOf(*table, "in"), path, places), scope);
    if (const auto guard = (*table)["guard"].value<std::string>(); guard && !m_error) {
      readGuard(transition, *guard, scope);
    }
    readLets(transition, tableOf(*table, "let"), scope);
    for (const Inscription& inscription :
         m_error ? std::vector<Inscription>{}
                 : inscriptions(tableOf(*table, "out"), path, places)) {
      readOutput(transition, inscription, scope);
    }
    if (transition.inputs.empty()) {
      failNow(PetriError::NotANet,
              fmt::format("{}: without an input it could fire for ever; add an arc \"in\".", path));
    }
    if (transition.outputs.size() > kVariablesMax || transition.inputs.size() > kVariablesMax) {
      failNow(PetriError::NotANet,
              fmt::format("{} has more than {} arcs of a kind.", path, kVariablesMax));
    }
    m_net.transitions.push_back(std::move(transition));
  }

  static bool isName(std::string_view text) {
    return !text.empty() && base::isNameLetter(text.front()) &&
           std::all_of(text.begin(), text.end(),
                       [](char c) { return base::isNameLetter(c) || base::isDigit(c); });
  }

  /// Arcs that bind variables first, then those that compare with them.
  void readInputs(Transition& transition, const std::vector<Inscription>& inscriptions,
                  Scope& scope) {
    const auto isKnown = [&](const std::string& name) {
      return name == "now" || name == "true" || name == "false" ||
             scope.constants.count(name) != 0 ||
             std::any_of(scope.variables.begin(), scope.variables.end(),
                         [&](const Scope::Variable& one) { return one.name == name; });
    };
    std::vector<std::pair<Inscription, InputArc>> comparing;
    for (const Inscription& inscription : inscriptions) {
      InputArc arc;
      arc.place = inscription.place;
      std::string_view pattern = inscription.text;
      if (const std::size_t at = pattern.find("@any"); at != std::string_view::npos) {
        arc.isEarly = true;
        pattern = pattern.substr(0, at);
      }
      arc.text = inscription.text;
      const std::string name(base::trim(pattern));
      if (isName(name) && !isKnown(name)) {
        arc.binds = true;
        arc.variable = static_cast<std::uint32_t>(scope.variables.size());
        scope.variables.push_back({name, m_net.places[inscription.place].colour});
        transition.inputs.push_back(std::move(arc));
      } else {
        comparing.push_back({{inscription.place, name}, std::move(arc)});
      }
    }
    for (auto& [inscription, arc] : comparing) {
      auto root = parseExpression(m_net, scope, inscription.text);
      if (!root) {
        failAt(transition.name, root.error());
        return;
      }
      if (!checkColour(*root, arc.place, transition.name, inscription.text)) {
        return;
      }
      if (m_net.colours[m_net.places[arc.place].colour].width != 1 ||
          m_net.colours[m_net.places[arc.place].colour].kind == ColourKind::List) {
        failNow(PetriError::WrongColour,
                fmt::format("{}: a token of {} is taken by a variable and compared in the guard.",
                            transition.name, m_net.places[arc.place].name));
      }
      arc.value = *root;
      transition.inputs.push_back(std::move(arc));
    }
    for (const InputArc& arc : transition.inputs) {
      if (m_net.places[arc.place].isObserver) {
        failNow(PetriError::NotANet,
                fmt::format("{}: nothing can be taken from {}, which only records.",
                            transition.name, m_net.places[arc.place].name));
      }
    }
  }

  void readLets(Transition& transition, const toml::table& table, Scope& scope) {
    for (const auto& [key, node] : table) {
      const std::string value = node.value<std::string>().value_or("");
      auto root = m_error ? base::Result<NodeId>(NodeId{0}) : parseExpression(m_net, scope, value);
      if (!root) {
        failAt(transition.name, root.error());
        return;
      }
      scope.variables.push_back({std::string(key.str()), m_net.nodes[*root].colour});
      transition.lets.push_back(*root);
    }
    if (scope.variables.size() > kVariablesMax) {
      failNow(PetriError::NotANet,
              fmt::format("{} has more than {} variables.", transition.name, kVariablesMax));
    }
  }

  void readOutput(Transition& transition, const Inscription& inscription, const Scope& scope) {
    OutputArc arc;
    arc.place = inscription.place;
    arc.text = inscription.text;
    std::string_view value = inscription.text;
    if (const std::size_t at = value.find("@+"); at != std::string_view::npos) {
      auto delay = parseExpression(m_net, scope, value.substr(at + 2));
      if (!delay || m_net.nodes[*delay].colour != kInt) {
        failAt(transition.name,
               delay ? base::makeError(
                           PetriError::WrongColour,
                           fmt::format("The delay of \"{}\" is not a number.", inscription.text))
                     : delay.error());
        return;
      }
      arc.hasDelay = true;
      arc.delay = *delay;
      value = value.substr(0, at);
    }
    auto root = parseExpression(m_net, scope, value);
    if (!root) {
      failAt(transition.name, root.error());
      return;
    }
    if (checkColour(*root, arc.place, transition.name, value)) {
      arc.value = *root;
      transition.outputs.push_back(std::move(arc));
    }
  }

  /// Each condition goes to the first arc after which all its variables are known.
  void readGuard(Transition& transition, const std::string& guard, const Scope& scope) {
    auto root = parseExpression(m_net, scope, guard);
    if (!root) {
      failAt(transition.name, root.error());
      return;
    }
    if (m_net.nodes[*root].colour != kBool) {
      failNow(PetriError::WrongColour,
              fmt::format("{}: guard \"{}\" is not a condition.", transition.name, guard));
      return;
    }
    transition.guardText = guard;
    std::vector<NodeId> conditions;
    splitConditions(m_net, *root, conditions);
    for (const NodeId condition : conditions) {
      bool asksTime = false;
      bool isMeasured = false;
      std::size_t arc = 0;
      bool hasVariables = false;
      visitNodes(m_net, condition, [&](const Node& node) {
        asksTime = asksTime || node.op == Op::Now;
        isMeasured = isMeasured || node.isMeasured;
        for (std::size_t i = 0; node.op == Op::Variable && i < transition.inputs.size(); ++i) {
          if (transition.inputs[i].binds && transition.inputs[i].variable == node.index) {
            arc = std::max(arc, i);
            hasVariables = true;
          }
        }
      });
      transition.asksTime = transition.asksTime || asksTime;
      if (isMeasured && !asksTime) {
        failNow(PetriError::NotANet,
                fmt::format("{}: guard \"{}\" depends on a field that is only measured.",
                            transition.name, guard));
      }
      if (asksTime && !transition.inputs.empty()) {
        transition.inputs.back().timedGuards.push_back(condition);
      } else if (hasVariables) {
        transition.inputs[arc].guards.push_back(condition);
      } else {
        transition.guards.push_back(condition);
      }
    }
  }

  const toml::table& m_root;
  std::string m_origin;
  const ParameterValues& m_parameters;
  base::Budget m_budget;
  double m_held = 0.0;  ///< bytes
  Net m_net;
  Constants m_constants;
  std::map<std::string, std::size_t> m_fusions;
  std::size_t m_instances = 0;
  std::optional<base::Error> m_error;
};

}  // namespace

Result<Net> parseNet(std::string_view text, const std::string& origin,
                     const ParameterValues& parameters, const base::Budget& budget) {
  constexpr double kTreeBytes = 80.0;  // a byte of the text, in the tree of its parser
  const double tree = kTreeBytes * static_cast<double>(text.size());
  if (auto fits = budget.require(tree, "The net"); !fits) {
    return base::fail(fits.error().code, fits.error().message, origin);
  }
  if (base::hasEndlessKey(text)) {
    return base::fail(PetriError::NotANet, "A key has too many parts.", origin);
  }
  toml::table root;
  try {
    root = toml::parse(text);
  } catch (const toml::parse_error& error) {
    return base::fail(
        PetriError::NotANet,
        fmt::format("Line {} is not TOML: {}.", error.source().begin.line, error.description()),
        origin);
  }
  return NetReader(root, origin, parameters, budget.without(static_cast<std::uint64_t>(tree)))
      .read();
}

Result<Net> loadNet(const std::string& nameOrPath, const ParameterValues& parameters,
                    const base::Budget& budget) {
  for (const auto& net : nets::kEmbeddedTexts) {
    if (net.name == nameOrPath) {
      return parseNet(net.text, "net " + nameOrPath, parameters);
    }
  }
  if (nameOrPath.find('/') == std::string::npos && !nameOrPath.ends_with(".toml")) {
    return base::fail(PetriError::Unknown,
                      fmt::format("There is no net \"{}\". Give one of {}, or the path of a .toml "
                                  "file.",
                                  nameOrPath, fmt::join(netNames(), ", ")));
  }
  auto text = base::readFile(nameOrPath, budget);
  if (!text) {
    return base::fail(text.error());
  }
  return parseNet(*text, nameOrPath, parameters, budget.without(text->capacity()));
}

std::vector<std::string> netNames() {
  std::vector<std::string> names;
  for (const auto& net : nets::kEmbeddedTexts) {
    names.emplace_back(net.name);
  }
  return names;
}

}  // namespace rivulet::petri
