// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "petri/net.h"

#include <algorithm>

#include "base/contract.h"
#include "base/error.h"

namespace rivulet::petri {

std::error_code make_error_code(PetriError code) {
  static const base::NamedCategory category("petri");
  return {static_cast<int>(code), category};
}

std::size_t Net::placeOf(const std::string& placeName) const {
  const auto at = std::find_if(places.begin(), places.end(),
                               [&](const Place& place) { return place.name == placeName; });
  return static_cast<std::size_t>(at - places.begin());
}

std::size_t Net::transitionOf(const std::string& transitionName) const {
  const auto at =
      std::find_if(transitions.begin(), transitions.end(),
                   [&](const Transition& transition) { return transition.name == transitionName; });
  return static_cast<std::size_t>(at - transitions.begin());
}

std::size_t Net::offsetOf(ColourId colour, const std::string& field) const {
  for (const Field& candidate : colours[colour].fields) {
    if (candidate.name == field) {
      return candidate.offset;
    }
  }
  RIVULET_ASSERT(false && "the record has the field");
  return 0;
}

std::string Net::textOf(ColourId colour, const Word* words) const {
  const Colour& set = colours[colour];
  std::string text;
  switch (set.kind) {
    case ColourKind::Int:
      return std::to_string(*words);
    case ColourKind::Bool:
      return *words != 0 ? "true" : "false";
    case ColourKind::String:
      return '"' + texts[static_cast<std::size_t>(*words)] + '"';
    case ColourKind::Unit:
      return "()";
    case ColourKind::Record:
      for (const Field& field : set.fields) {
        text += (text.empty() ? "" : ", ") + field.name + " = " +
                textOf(field.colour, words + field.offset);
      }
      return set.name + '{' + text + '}';
    case ColourKind::List:
      for (Word i = 0; i < words[0]; ++i) {
        text += (text.empty() ? "" : ", ") +
                textOf(set.element, words + 1 + static_cast<std::size_t>(i) * set.width);
      }
      return '[' + text + ']';
  }
  return text;
}

}  // namespace rivulet::petri
