// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "emulator/design.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/random.h"
#include "base/units.h"
#include "emulator/emulator_error.h"

namespace rivulet::emulator {

namespace {

/// A parameter of which nothing is known is known to this, relative.
constexpr double kUnknown = 1.0;
/// Quantile of the simultaneous intervals that a file has: 99 %, some parameters at once.
constexpr double kIntervalReach = 3.0;
constexpr double kLogStep = 1e-3;
constexpr double kRunOutS = 0.3;  ///< stands at the end, until the axes have settled
constexpr double kMoveMmMin = 0.2;

struct AxisInformation {
  std::vector<ParameterEstimate> known;
  Eigen::MatrixXd prior;
  Eigen::MatrixXd after;
};

Eigen::MatrixXd priorOf(const LearnedAxis& axis, bool usesIntervals) {
  const auto count = static_cast<Eigen::Index>(axis.estimates.size());
  Eigen::MatrixXd prior = Eigen::MatrixXd::Zero(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const ParameterEstimate& one = axis.estimates[static_cast<std::size_t>(i)];
    double deviation = kUnknown;
    if (usesIntervals && one.low > 0.0 && one.high > one.low) {
      deviation = std::min(kUnknown, std::log(one.high / one.low) / (2.0 * kIntervalReach));
    }
    prior(i, i) = 1.0 / (deviation * deviation);
  }
  return prior;
}

/// Changes of the observed positions by the logarithms of the parameters.
Eigen::MatrixXd sensitivities(const LearnedAxis& axis, const SetPointGrid& grid,
                              const std::vector<double>& atS) {
  const auto rows = static_cast<Eigen::Index>(atS.size());
  Eigen::MatrixXd changes(rows, static_cast<Eigen::Index>(axis.estimates.size()));
  const std::vector<AxisState> at = predict(axis.parameters, grid, atS);
  for (std::size_t i = 0; i < axis.estimates.size(); ++i) {
    AxisParameters moved = axis.parameters;
    moved[axis.estimates[i].parameter] *= std::exp(kLogStep);
    const std::vector<AxisState> beside = predict(moved, grid, atS);
    for (Eigen::Index row = 0; row < rows; ++row) {
      const auto index = static_cast<std::size_t>(row);
      changes(row, static_cast<Eigen::Index>(i)) = (beside[index].mm - at[index].mm) / kLogStep;
    }
  }
  return changes;
}

std::vector<AxisInformation> informationOfAxes(const Emulator& emulator, const PlannedMoves& run,
                                               const DesignOptions& options) {
  std::vector<double> atS;
  const double endS = run.periodS * static_cast<double>(run.setPointsMm.size() - 1);
  for (double at = 0.0; at <= endS; at += options.spacingS) {
    atS.push_back(at);
  }
  std::vector<AxisInformation> all;
  for (const LearnedAxis& axis : emulator.axes) {
    const auto index = static_cast<std::size_t>(std::ranges::find(base::kAxisNames, axis.axis) -
                                                base::kAxisNames.begin());
    AxisTrack track{axis.axis, {}, {}};
    for (const base::Vec3& mm : run.setPointsMm) {
      track.reference.push_back(mm[index]);
    }
    const auto [low, high] = std::ranges::minmax(track.reference);
    AxisInformation& of = all.emplace_back();
    of.known = axis.estimates;
    of.prior = priorOf(axis, options.usesIntervals);
    of.after = of.prior;
    if (high - low > 0.0) {
      const Eigen::MatrixXd s =
          sensitivities(axis, setPointGrid(track, run.periodS, axis.goesStraight), atS);
      of.after += s.transpose() * s / (options.noiseMm * options.noiseMm);
    }
  }
  return all;
}

double logDeterminant(const Eigen::MatrixXd& matrix) {
  const Eigen::LDLT<Eigen::MatrixXd> factors(matrix);
  return factors.vectorD().array().max(1e-300).log().sum();
}

double logDeterminant(const std::vector<AxisInformation>& all) {
  double sum = 0.0;
  for (const AxisInformation& one : all) {
    sum += logDeterminant(one.after);
  }
  return sum;
}

class Search {
 public:
  Search(const Emulator& emulator, const DesignBox& box, const PlanMoves& plan,
         const DesignOptions& options)
      : m_emulator(emulator),
        m_box(box),
        m_plan(plan),
        m_options(options),
        m_random(options.seed) {}

  ProposedProgram run() {
    ProposedProgram best = judged(randomMoves());
    for (int i = 0; i < m_options.exchanges; ++i) {
      if (m_options.progress &&
          !m_options.progress(static_cast<double>(i) / static_cast<double>(m_options.exchanges))) {
        break;
      }
      ProposedProgram other = judged(exchanged(best.moves));
      if (other.logDeterminant > best.logDeterminant) {
        best = std::move(other);
      }
    }
    return best;
  }

 private:
  [[nodiscard]] double between(double low, double high) {
    return low + (high - low) * m_random.uniform();
  }

  DesignMove randomMove() {
    DesignMove move;
    for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
      move.toMm.set(axis, between(m_box.minMm[axis], m_box.maxMm[axis]));
    }
    // As many slow moves as fast ones.
    move.feedMmPerS = m_box.feedMmPerSMin *
                      std::pow(m_box.feedMmPerSMax / m_box.feedMmPerSMin, m_random.uniform());
    const double room =
        0.5 * std::min(m_box.maxMm.x - m_box.minMm.x, m_box.maxMm.y - m_box.minMm.y);
    if (room > kMoveMmMin && m_random.uniform() < 0.25) {
      move.radiusMm = between(0.1, 1.0) * room;
    }
    return move;
  }

  std::vector<DesignMove> randomMoves() {
    std::vector<DesignMove> moves;
    for (int i = 0; i < 200; ++i) {
      moves.push_back(randomMove());
    }
    return moves;
  }

  /// Another move in the place of one, before one, or none; or a short way there and back, which
  /// shows the friction.
  std::vector<DesignMove> exchanged(std::vector<DesignMove> moves) {
    const std::size_t at =
        std::min(moves.size() - 1,
                 static_cast<std::size_t>(m_random.uniform() * static_cast<double>(moves.size())));
    const auto place = moves.begin() + static_cast<std::ptrdiff_t>(at);
    const double kind = m_random.uniform();
    if (kind < 0.4) {
      *place = randomMove();
    } else if (kind < 0.6) {
      moves.insert(place, randomMove());
    } else if (kind < 0.75) {
      place->feedMmPerS = randomMove().feedMmPerS;
    } else if (kind < 0.85 && moves.size() > 2) {
      moves.erase(place);
    } else {
      DesignMove there = *place;
      there.radiusMm = 0.0;
      there.feedMmPerS = randomMove().feedMmPerS;
      DesignMove back = there;
      const double share = between(0.02, 0.3);
      for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
        const double reach = share * (m_box.maxMm[axis] - m_box.minMm[axis]);
        there.toMm.set(axis, std::clamp(there.toMm[axis] + between(-reach, reach),
                                        m_box.minMm[axis], m_box.maxMm[axis]));
      }
      moves.insert(place + 1, {there, back});
    }
    return moves;
  }

  /// Moves as they fit into the box: circles that do not become lines.
  std::vector<DesignMove> inBox(const std::vector<DesignMove>& moves) const {
    std::vector<DesignMove> kept;
    base::Vec3 atMm = m_box.minMm;
    for (DesignMove move : moves) {
      if (move.radiusMm > 0.0) {
        const bool fits = atMm.x + 2.0 * move.radiusMm <= m_box.maxMm.x &&
                          atMm.y - move.radiusMm >= m_box.minMm.y &&
                          atMm.y + move.radiusMm <= m_box.maxMm.y;
        if (fits) {
          move.toMm = atMm;
        } else {
          move.radiusMm = 0.0;
        }
      }
      if (move.radiusMm == 0.0 && base::distance(move.toMm, atMm) < kMoveMmMin) {
        continue;
      }
      atMm = move.toMm;
      kept.push_back(move);
    }
    return kept;
  }

  /// As many of the moves as there is time for.
  ProposedProgram judged(const std::vector<DesignMove>& asked) {
    std::vector<DesignMove> moves = inBox(asked);
    double seconds = 0.0;  // at least
    base::Vec3 atMm = m_box.minMm;
    for (std::size_t i = 0; i < moves.size(); ++i) {
      seconds += (moves[i].radiusMm > 0.0 ? 2.0 * 3.14159265358979323846 * moves[i].radiusMm
                                          : base::distance(moves[i].toMm, atMm)) /
                 moves[i].feedMmPerS;
      atMm = moves[i].toMm;
      if (seconds > m_box.durationS) {
        moves.resize(i);
      }
    }
    PlannedMoves planned = m_plan(m_box.minMm, moves);
    const auto room = static_cast<std::size_t>((m_box.durationS - kRunOutS) / planned.periodS);
    while (planned.setPointsMm.size() > room && moves.size() > 1) {
      moves.pop_back();
      planned = m_plan(m_box.minMm, moves);
    }
    const auto runOut = static_cast<std::size_t>(kRunOutS / planned.periodS);
    planned.setPointsMm.insert(planned.setPointsMm.end(), runOut, planned.setPointsMm.back());
    ProposedProgram program = informationOf(m_emulator, planned, m_options);
    program.moves = std::move(moves);
    program.durationS = planned.periodS * static_cast<double>(planned.setPointsMm.size() - 1);
    return program;
  }

  const Emulator& m_emulator;
  const DesignBox& m_box;
  const PlanMoves& m_plan;
  const DesignOptions& m_options;
  base::Random m_random;
};

base::Result<void> requireBox(const Emulator& emulator, const DesignBox& box) {
  bool moves = false;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    if (!(box.minMm[axis] <= box.maxMm[axis])) {
      return base::fail(
          EmulatorError::BadNumbers,
          fmt::format("The box must have a lower and an upper end in {}.", base::kAxisNames[axis]));
    }
    const bool isMoved = box.maxMm[axis] - box.minMm[axis] > 2.0 * kMoveMmMin;
    moves = moves || (isMoved && emulator.find(base::kAxisNames[axis]) != nullptr);
  }
  if (!(box.feedMmPerSMin > 0.0 && box.feedMmPerSMin <= box.feedMmPerSMax &&
        box.durationS > 2.0 * kRunOutS)) {
    return base::fail(EmulatorError::BadNumbers,
                      "The feeds must be greater than 0 and ascend, and the program needs a second "
                      "at least.");
  }
  if (!moves) {
    return base::fail(EmulatorError::NoMotion,
                      "None of the axes that the emulator knows can move in this box: make it "
                      "larger.");
  }
  return {};
}

}  // namespace

ProposedProgram informationOf(const Emulator& emulator, const PlannedMoves& run,
                              const DesignOptions& options) {
  const std::vector<AxisInformation> all = informationOfAxes(emulator, run, options);
  ProposedProgram result;
  result.logDeterminant = logDeterminant(all);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Eigen::MatrixXd before = all[i].prior.inverse();
    const Eigen::MatrixXd after = all[i].after.inverse();
    for (std::size_t k = 0; k < all[i].known.size(); ++k) {
      const auto row = static_cast<Eigen::Index>(k);
      result.gains.push_back({emulator.axes[i].axis, all[i].known[k].parameter,
                              std::sqrt(before(row, row)), std::sqrt(after(row, row))});
    }
  }
  return result;
}

base::Result<ProposedProgram> proposeProgram(const Emulator& emulator, const DesignBox& box,
                                             const PlanMoves& plan, const DesignOptions& options) {
  if (auto good = requireBox(emulator, box); !good) {
    return base::fail(good.error());
  }
  return Search(emulator, box, plan, options).run();
}

std::string programText(base::Vec3 startMm, std::span<const DesignMove> moves) {
  std::string text =
      fmt::format("G64 G90 G17\nG0 X{:.3f} Y{:.3f} Z{:.3f}\n", startMm.x, startMm.y, startMm.z);
  base::Vec3 atMm = startMm;
  for (const DesignMove& move : moves) {
    const double feed = base::mmPerMinFromMmPerS(move.feedMmPerS);
    if (move.radiusMm > 0.0) {
      text += fmt::format("G3 X{:.3f} Y{:.3f} I{:.3f} J0 F{:.0f}\n", atMm.x, atMm.y, move.radiusMm,
                          feed);
    } else {
      text += fmt::format("G1 X{:.3f} Y{:.3f} Z{:.3f} F{:.0f}\n", move.toMm.x, move.toMm.y,
                          move.toMm.z, feed);
      atMm = move.toMm;
    }
  }
  return text + "M30\n";
}

}  // namespace rivulet::emulator
