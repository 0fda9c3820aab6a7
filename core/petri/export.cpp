// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "petri/export.h"

#include <fmt/format.h>

#include <map>
#include <vector>

namespace rivulet::petri {

namespace {

std::string xmlText(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '&':
        escaped += "&amp;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string dotText(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    escaped += c == '"' || c == '\\' ? std::string{'\\', c} : std::string(1, c);
  }
  return escaped;
}

/// "3`5 ++ 1`(7)": the initial tokens, equal ones counted.
std::string markingText(const Net& net, const Place& place) {
  std::map<std::string, int> counts;
  for (const Token& token : place.initial) {
    ++counts[net.textOf(place.colour, token.value.data())];
  }
  std::string text;
  for (const auto& [value, count] : counts) {
    text += fmt::format("{}{}`{}", text.empty() ? "" : " ++ ", count, value);
  }
  return text;
}

std::string named(std::string_view element, std::string_view text) {
  return text.empty()
             ? std::string()
             : fmt::format("        <{0}><text>{1}</text></{0}>\n", element, xmlText(text));
}

/// "Top.CNC" of "Top.CNC.B1".
std::string pageOf(const std::string& name) {
  const std::size_t dot = name.rfind('.');
  return dot == std::string::npos ? std::string() : name.substr(0, dot);
}

std::string lastName(const std::string& name) {
  const std::size_t dot = name.rfind('.');
  return dot == std::string::npos ? name : name.substr(dot + 1);
}

}  // namespace

std::string pnmlOf(const Net& net) {
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<pnml xmlns=\"http://www.pnml.org/version-2009/grammar/pnml\">\n"
      "  <net id=\"net\" type=\"http://www.pnml.org/version-2009/grammar/highlevelnet\">\n"
      "    <name><text>{}</text></name>\n"
      "    <page id=\"page\">\n",
      xmlText(net.name));
  for (std::size_t i = 0; i < net.places.size(); ++i) {
    text += fmt::format("      <place id=\"p{}\">\n", i) + named("name", net.places[i].name) +
            named("type", net.colours[net.places[i].colour].name) +
            named("hlinitialMarking", markingText(net, net.places[i])) + "      </place>\n";
  }
  for (std::size_t i = 0; i < net.transitions.size(); ++i) {
    const Transition& transition = net.transitions[i];
    text += fmt::format("      <transition id=\"t{}\">\n", i) + named("name", transition.name) +
            named("condition", transition.guardText) +
            fmt::format(
                "        <toolspecific tool=\"Rivulet\" version=\"1\"><priority>{}"
                "</priority></toolspecific>\n      </transition>\n",
                transition.priority);
  }
  std::size_t arcs = 0;
  const auto arc = [&](const std::string& source, const std::string& target,
                       const std::string& inscription) {
    text += fmt::format("      <arc id=\"a{}\" source=\"{}\" target=\"{}\">\n", arcs++, source,
                        target) +
            named("hlinscription", inscription) + "      </arc>\n";
  };
  for (std::size_t i = 0; i < net.transitions.size(); ++i) {
    for (const InputArc& input : net.transitions[i].inputs) {
      arc(fmt::format("p{}", input.place), fmt::format("t{}", i), input.text);
    }
    for (const OutputArc& output : net.transitions[i].outputs) {
      arc(fmt::format("t{}", i), fmt::format("p{}", output.place), output.text);
    }
  }
  return text + "    </page>\n  </net>\n</pnml>\n";
}

std::string graphvizOf(const Net& net) {
  std::string text = fmt::format(
      "digraph \"{}\" {{\n  rankdir=LR;\n  node [fontname=\"sans-serif\", fontsize=10];\n",
      dotText(net.name));
  std::map<std::string, std::string> pages;
  for (std::size_t i = 0; i < net.places.size(); ++i) {
    const Place& place = net.places[i];
    pages[pageOf(place.name)] +=
        fmt::format("    p{} [shape=ellipse{}, label=\"{}\\n{}\"];\n", i,
                    place.isObserver ? ", style=dashed" : "", dotText(lastName(place.name)),
                    dotText(net.colours[place.colour].name));
  }
  for (std::size_t i = 0; i < net.transitions.size(); ++i) {
    pages[pageOf(net.transitions[i].name)] += fmt::format(
        "    t{} [shape=box, label=\"{}\"];\n", i, dotText(lastName(net.transitions[i].name)));
  }
  std::size_t cluster = 0;
  for (const auto& [page, nodes] : pages) {
    text += page.empty() ? nodes
                         : fmt::format("  subgraph cluster_{} {{\n    label=\"{}\";\n{}  }}\n",
                                       cluster++, dotText(page), nodes);
  }
  for (std::size_t i = 0; i < net.transitions.size(); ++i) {
    for (const InputArc& input : net.transitions[i].inputs) {
      text += fmt::format("  p{} -> t{};\n", input.place, i);
    }
    for (const OutputArc& output : net.transitions[i].outputs) {
      text += fmt::format("  t{} -> p{};\n", i, output.place);
    }
  }
  return text + "}\n";
}

}  // namespace rivulet::petri
