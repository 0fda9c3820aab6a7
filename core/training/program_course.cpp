// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "training/program_course.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "machine/path_piece.h"

namespace rivulet::training {

namespace {

using base::Vec3;
using machine::PathPiece;
using machine::PreparedMotion;

struct Piece {
  PathPiece path;
  double mmPerSMax = 0.0;
  double mmPerS2Max = 0.0;
  bool stops = false;  ///< at its end
  double endMmPerS = 0.0;
};

double accelerationOf(const PathPiece& path, const TrapezoidRules& rules, bool exactStop) {
  double least = 1e9;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (const double share = path.axisShare(axis); share > 1e-9) {
      least = std::min(least, rules.accelerationMmPerS2[axis] / share);
    }
  }
  return exactStop ? rules.exactStopShare * least : least;
}

Piece makePiece(const PathPiece& path, double feedMmPerS, bool exactStop,
                const TrapezoidRules& rules) {
  Piece piece{path, feedMmPerS, accelerationOf(path, rules, exactStop)};
  if (!path.isStraight()) {
    piece.mmPerSMax = std::min(
        feedMmPerS, std::sqrt(rules.acrossShare * piece.mmPerS2Max / path.curvaturePerMm()));
    piece.mmPerS2Max *= rules.alongShare;
  }
  return piece;
}

std::vector<Piece> piecesOf(std::span<const PreparedMotion> blocks, Vec3 startMm,
                            const TrapezoidRules& rules) {
  std::vector<Piece> pieces;
  Vec3 at = startMm;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const PreparedMotion& block = blocks[i];
    const bool exactStop = block.end == machine::BlockEnd::ExactStop;
    if (!block.arc && base::distance(at, block.targetMm) < 1e-9) {
      continue;
    }
    PathPiece path = block.arc ? PathPiece::arc(at, block.targetMm, *block.arc)
                               : PathPiece::line(at, block.targetMm);
    // What the corner before this block has taken from it.
    if (!pieces.empty() && !pieces.back().stops && !pieces.back().path.isStraight() && !block.arc) {
      path.trimStart(base::distance(pieces.back().path.at(pieces.back().path.lengthMm()), at));
    }
    std::optional<machine::CornerArc> corner;
    if (!exactStop && i + 1 < blocks.size() && !block.arc && !blocks[i + 1].arc) {
      const PathPiece next = PathPiece::line(block.targetMm, blocks[i + 1].targetMm);
      corner = machine::roundCorner(block.targetMm, path.tangent(0.0), next.tangent(0.0),
                                    std::min(0.9 * path.lengthMm(), 0.5 * next.lengthMm()),
                                    block.rounding, block.roundingMm);
    }
    if (corner) {
      path.trimEnd(corner->cutMm);
    }
    pieces.push_back(makePiece(path, block.feedMmPerS, exactStop, rules));
    pieces.back().stops = !corner;
    if (corner) {
      const double feed = std::min(block.feedMmPerS, blocks[i + 1].feedMmPerS);
      pieces.push_back(makePiece(corner->firstHalf, feed, false, rules));
      pieces.push_back(makePiece(corner->secondHalf, feed, false, rules));
    }
    at = block.targetMm;
  }
  double next = 0.0;  // speed at which the following piece may be entered
  for (std::size_t i = pieces.size(); i-- > 0;) {
    Piece& piece = pieces[i];
    piece.endMmPerS = piece.stops ? 0.0 : std::min(next, piece.mmPerSMax);
    next = std::min(piece.mmPerSMax, std::sqrt(piece.endMmPerS * piece.endMmPerS +
                                               2.0 * piece.mmPerS2Max * piece.path.lengthMm()));
  }
  return pieces;
}

/// Positions at the end of each cycle.
std::vector<Vec3> travel(const std::vector<Piece>& pieces, const TrapezoidRules& rules) {
  const double h = rules.cycleS;
  std::vector<Vec3> places;
  double mm = 0.0;
  double mmPerS = 0.0;
  for (std::size_t i = 0; i < pieces.size();) {
    const Piece* piece = &pieces[i];
    const double left = piece->path.lengthMm() - mm;
    const double half = 0.5 * piece->mmPerS2Max * h;
    // The speed from which the rest is just enough to brake.
    const double square = half * half + piece->endMmPerS * piece->endMmPerS +
                          piece->mmPerS2Max * (2.0 * left - mmPerS * h);
    const double allowed =
        std::max(piece->endMmPerS, square > half * half ? std::sqrt(square) - half : 0.0);
    const double next = std::clamp(std::min(allowed, piece->mmPerSMax),
                                   mmPerS - piece->mmPerS2Max * h, mmPerS + piece->mmPerS2Max * h);
    mm = next > 0.0 ? mm + 0.5 * (mmPerS + next) * h : piece->path.lengthMm();
    mmPerS = std::max(0.0, next);
    while (i < pieces.size() && mm >= piece->path.lengthMm() - 1e-9) {
      mm = piece->stops ? 0.0 : mm - piece->path.lengthMm();
      mmPerS = piece->stops ? 0.0 : mmPerS;
      if (piece->stops) {
        places.push_back(piece->path.at(piece->path.lengthMm()));
      }
      ++i;
      piece = i < pieces.size() ? &pieces[i] : piece;
      if (mm == 0.0 && mmPerS == 0.0) {
        break;
      }
    }
    if (i < pieces.size() && mm > 0.0) {
      places.push_back(piece->path.at(mm));
    }
  }
  return places;
}

}  // namespace

std::vector<Vec3> trapezoidCourse(std::span<const PreparedMotion> blocks, Vec3 startMm,
                                  const TrapezoidRules& rules) {
  const std::vector<Vec3> places = travel(piecesOf(blocks, startMm, rules), rules);
  const auto at = [&](std::size_t index, std::size_t back) {
    return index < back ? startMm : places[std::min(index - back, places.size() - 1)];
  };
  std::vector<Vec3> setPoints;
  for (std::size_t i = 0; !places.empty() && i < places.size() + 3; ++i) {
    setPoints.push_back((1.0 / 6.0) * (at(i, 1) + 4.0 * at(i, 2) + at(i, 3)));
  }
  return setPoints;
}

}  // namespace rivulet::training
