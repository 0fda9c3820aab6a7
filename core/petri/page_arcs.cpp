// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "petri/page_arcs.h"

#include <utility>

namespace rivulet::petri {

namespace {

using Kind = PageNode::Kind;

/// Adds what a transition does with a place.
void addArcs(const Transition& transition, std::size_t place, bool withTexts, PageArc& arc) {
  for (const InputArc& input : transition.inputs) {
    if (input.place == place) {
      arc.takes = true;
      if (withTexts) {
        arc.taken.push_back(input.text);
      }
    }
  }
  for (const OutputArc& output : transition.outputs) {
    if (output.place == place) {
      arc.puts = true;
      if (withTexts) {
        arc.put.push_back(output.text);
      }
    }
  }
}

/// Adds what the transitions of a page, and of those on it, do with a place.
void addArcsBelow(const Net& net, std::size_t page, std::size_t place, PageArc& arc) {
  for (const PageNode& node : net.pages[page].nodes) {
    if (node.kind == Kind::Transition) {
      addArcs(net.transitions[node.index], place, false, arc);
    } else if (node.kind == Kind::Substitution) {
      addArcsBelow(net, node.index, place, arc);
    }
  }
}

/// Whether a place is a port of a page: fusion places are reached without a line.
bool isPortOf(const Net& net, std::size_t page, std::size_t place) {
  for (const PageNode& node : net.pages[page].nodes) {
    if (node.kind == Kind::Place && node.isPort && node.index == place) {
      return true;
    }
  }
  return false;
}

}  // namespace

std::vector<PageArc> arcsOfPage(const Net& net, std::size_t page) {
  const std::vector<PageNode>& nodes = net.pages[page].nodes;
  std::vector<PageArc> arcs;
  for (std::size_t node = 0; node < nodes.size(); ++node) {
    for (std::size_t place = 0; place < nodes.size(); ++place) {
      if (nodes[node].kind == Kind::Place || nodes[place].kind != Kind::Place) {
        continue;
      }
      PageArc arc;
      arc.place = place;
      arc.node = node;
      if (nodes[node].kind == Kind::Transition) {
        addArcs(net.transitions[nodes[node].index], nodes[place].index, true, arc);
      } else if (isPortOf(net, nodes[node].index, nodes[place].index)) {
        addArcsBelow(net, nodes[node].index, nodes[place].index, arc);
      }
      if (arc.takes || arc.puts) {
        arcs.push_back(std::move(arc));
      }
    }
  }
  return arcs;
}

bool isOnPage(const Net& net, std::size_t transition, std::size_t page) {
  for (const PageNode& node : net.pages[page].nodes) {
    if ((node.kind == Kind::Transition && node.index == transition) ||
        (node.kind == Kind::Substitution && isOnPage(net, transition, node.index))) {
      return true;
    }
  }
  return false;
}

}  // namespace rivulet::petri
