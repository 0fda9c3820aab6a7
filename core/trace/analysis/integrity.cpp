// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Which point of the program did a block execute?
//
// Only the end of a block is known. As long as each block ends at the point due, there is nothing
// to decide: the run is faultless, and no search is made. At the first block that ends elsewhere,
// there are three possibilities: an old point was executed again (a slot was read before its new
// value arrived), points were lost (a slot was overwritten before it was read), or the end is not a
// point of the program (a slot was read between the writes of two axes).
//
// Two numbers describe the state of the stream: the point `due` (the one after the farthest
// accepted point) and the point `last` executed. They differ while old points are repeated:
//
//   program 1 2 3 4 5 6 7 8, slots of 4       last   due
//   1 2 3 4     as they should be             4      5
//   1 2 3 4     the loop, once more           4      5    the due point waits
//   5 2 7 8     slot 2 came late: 6 is lost   8      9    2 is a repetition, 7 jumps over 6
//
// So a block is first tried as `due`, then as the point after `last`, which follows a repeated
// section. If neither fits, all points at this place are candidates: the nearest few on both sides
// of `due`. Closed contours and paths that go there and back visit a place more than once. Then the
// following blocks decide: each candidate is followed as if it were the right one, and the one that
// explains the most blocks is chosen. If several explain the same number, the nearest to the due
// point is chosen, and among these the earlier one, because repeating a slot is a smaller fault
// than losing a section.
//
// The counts do not depend on each single decision: executions and distinct points are counted, and
// skipped points and points out of order are determined from the whole run at the end.
//
// Blocks are judged as they come, so that a run of any length can be judged while it lasts: only
// the blocks that decide between candidates are waited for. Until the first fault, one number says
// which points have been executed; from then on, each point takes twelve bytes and a bit.

#include "trace/analysis/integrity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <utility>

#include "base/contract.h"
#include "trace/analysis/path_match.h"

namespace rivulet::trace {
namespace {

using base::AxisPosition;
using base::Vec3;
using Kind = IntegrityFault::Kind;

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
constexpr std::size_t kFaultsMax = 100;
/// A block shorter than this moves no axis.
constexpr double kHoldMm = 1e-9;
constexpr double kHoldDeg = 1e-9;
/// Number of candidates examined on each side of the due point.
constexpr std::size_t kCandidatesPerSide = 4;
/// Number of blocks followed to decide between candidates: more than in any window in use.
constexpr std::size_t kLookAheadBlocks = 256;

/// Millimetres and degrees have the same tolerance.
bool isSame(const gcode::StreamPoint& point, const AxisPosition& place, double tolerance,
            const base::RotarySet& rotaryAxes) {
  return base::distance(point.positionMm, place.mm) <= tolerance &&
         base::differenceDeg(point.rotaryDeg, place.deg, rotaryAxes) <= tolerance;
}

AxisPosition endOf(const ExecutedBlock& block) {
  return {block.targetMm, block.targetDeg};
}

}  // namespace

/// Finds the points at a place: points sorted by the cell of a grid they lie in.
class PointGrid {
 public:
  PointGrid(const std::vector<gcode::StreamPoint>& points, double toleranceMm,
            const base::RotarySet& rotaryAxes)
      : m_points(points),
        m_toleranceMm(toleranceMm),
        m_rotaryAxes(rotaryAxes),
        m_cellMm(std::max(4 * toleranceMm, 1e-6)) {
    m_entries.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec3 at = points[i].positionMm;
      if (isInside(at)) {
        m_entries.emplace_back(key(cell(at.x), cell(at.y), cell(at.z)), i);
      }
    }
    std::sort(m_entries.begin(), m_entries.end());
  }

  /// The nearest few points before and after `due` that are at `place`, ascending.
  [[nodiscard]] std::vector<std::size_t> at(const AxisPosition& place, std::size_t due) const {
    std::vector<std::size_t> found;
    if (!isInside(place.mm)) {
      return found;
    }
    const auto low = place.mm - Vec3{m_toleranceMm, m_toleranceMm, m_toleranceMm};
    const auto high = place.mm + Vec3{m_toleranceMm, m_toleranceMm, m_toleranceMm};
    // A cell is wider than the tolerance, so there are at most two cells per axis.
    for (std::int64_t x = cell(low.x); x <= cell(high.x); ++x) {
      for (std::int64_t y = cell(low.y); y <= cell(high.y); ++y) {
        for (std::int64_t z = cell(low.z); z <= cell(high.z); ++z) {
          collect(key(x, y, z), place, due, found);
        }
      }
    }
    std::sort(found.begin(), found.end());
    // Two cells may share a key, whose points are then found twice.
    found.erase(std::unique(found.begin(), found.end()), found.end());
    const auto split = std::lower_bound(found.begin(), found.end(), due);
    const auto behind = static_cast<std::size_t>(found.end() - split);
    found.resize(found.size() - behind + std::min(behind, kCandidatesPerSide));
    const auto before =
        static_cast<std::size_t>(std::lower_bound(found.begin(), found.end(), due) - found.begin());
    if (before > kCandidatesPerSide) {
      found.erase(found.begin(),
                  found.begin() + static_cast<std::ptrdiff_t>(before - kCandidatesPerSide));
    }
    return found;
  }

 private:
  using Entry = std::pair<std::uint64_t, std::size_t>;

  /// Cell numbers must fit into an integer; a machine is smaller by orders of magnitude.
  [[nodiscard]] bool isInside(Vec3 at) const {
    constexpr double kCellMax = 1e15;
    return base::isFinite(at) && std::abs(at.x) < kCellMax * m_cellMm &&
           std::abs(at.y) < kCellMax * m_cellMm && std::abs(at.z) < kCellMax * m_cellMm;
  }
  [[nodiscard]] std::int64_t cell(double mm) const {
    return static_cast<std::int64_t>(std::floor(mm / m_cellMm));
  }
  [[nodiscard]] static std::uint64_t key(std::int64_t x, std::int64_t y, std::int64_t z) {
    std::uint64_t mixed = 0;
    for (const std::int64_t part : {x, y, z}) {
      mixed = (mixed ^ static_cast<std::uint64_t>(part)) * 0x9E3779B97F4A7C15ULL;
      mixed ^= mixed >> 29;
    }
    return mixed;
  }
  [[nodiscard]] bool isAt(std::size_t index, const AxisPosition& place) const {
    return isSame(m_points[index], place, m_toleranceMm, m_rotaryAxes);
  }

  void collect(std::uint64_t cellKey, const AxisPosition& place, std::size_t due,
               std::vector<std::size_t>& found) const {
    const auto split = std::lower_bound(m_entries.begin(), m_entries.end(), Entry{cellKey, due});
    std::size_t count = 0;
    for (auto it = split; it != m_entries.end() && it->first == cellKey; ++it) {
      if (isAt(it->second, place)) {
        found.push_back(it->second);
        if (++count == kCandidatesPerSide) {
          break;
        }
      }
    }
    count = 0;
    for (auto it = split; it != m_entries.begin() && std::prev(it)->first == cellKey; --it) {
      if (isAt(std::prev(it)->second, place)) {
        found.push_back(std::prev(it)->second);
        if (++count == kCandidatesPerSide) {
          break;
        }
      }
    }
  }

  const std::vector<gcode::StreamPoint>& m_points;
  double m_toleranceMm;
  base::RotarySet m_rotaryAxes;
  double m_cellMm;
  std::vector<Entry> m_entries;
};

class IntegrityJudge::Impl {
 public:
  Impl(const std::vector<gcode::StreamPoint>& points, double toleranceMm,
       const base::RotarySet& rotaryAxes, bool isGrowing)
      : m_points(points),
        m_toleranceMm(toleranceMm),
        m_rotaryAxes(rotaryAxes),
        m_isGrowing(isGrowing) {}

  void add(std::span<const ExecutedBlock> blocks);
  [[nodiscard]] Integrity finish();

 private:
  /// First executions from the first that was not that of the next point on.
  struct Late {
    std::vector<bool> isExecuted;      ///< by point
    std::vector<std::uint32_t> order;  ///< points in the order of their first executions
    std::vector<base::Instant> from;   ///< the same: when the block began
  };

  [[nodiscard]] bool matches(const ExecutedBlock& block, std::size_t point) const {
    return point < m_points.size() &&
           isSame(m_points[point], endOf(block), m_toleranceMm, m_rotaryAxes);
  }
  [[nodiscard]] static bool isHold(const ExecutedBlock& block) {
    return block.lengthMm < kHoldMm && block.turnDeg < kHoldDeg;
  }
  [[nodiscard]] bool isDecidable(const ExecutedBlock& block) const;
  void judgeFirst();
  void judgeHold(const ExecutedBlock& block);
  void judgeMotion(const ExecutedBlock& block);
  void execute(const ExecutedBlock& block, std::size_t point);
  [[nodiscard]] bool isExecuted(std::size_t point) const;
  void passOverDuePointsHere(const ExecutedBlock& block);
  [[nodiscard]] std::size_t choose(const ExecutedBlock& block);
  [[nodiscard]] std::size_t explained(std::size_t point) const;
  void addFault(Kind kind, std::size_t point, base::Instant at);
  void keepFirstFaults();
  void findSkipped();
  void findOutOfOrder();

  const std::vector<gcode::StreamPoint>& m_points;
  double m_toleranceMm;
  base::RotarySet m_rotaryAxes;
  bool m_isGrowing;
  std::deque<ExecutedBlock> m_blocks;  ///< the one to be judged next, and those after it
  std::size_t m_inTurn = 0;            ///< points executed before the first that was not next
  std::optional<Late> m_late;          ///< made at the first fault
  std::size_t m_due = 0;
  std::size_t m_last = kNone;
  std::optional<AxisPosition> m_position;  ///< position of the axes; unknown before the first block
  bool m_inOrder = true;
  std::optional<PointGrid> m_grid;  ///< made at the first fault
  Integrity m_result;
  std::vector<IntegrityFault> m_faults;
};

void IntegrityJudge::Impl::add(std::span<const ExecutedBlock> blocks) {
  for (const ExecutedBlock& block : blocks) {
    m_blocks.push_back(block);
    while (m_blocks.size() >= kLookAheadBlocks && isDecidable(m_blocks.front())) {
      judgeFirst();
    }
  }
}

Integrity IntegrityJudge::Impl::finish() {
  m_isGrowing = false;
  while (!m_blocks.empty()) {
    judgeFirst();
  }
  m_result.judged = true;
  m_result.executed = m_inTurn + (m_late ? m_late->order.size() : 0);
  if (m_late) {
    findSkipped();
  }
  if (!m_inOrder) {
    findOutOfOrder();
  }
  keepFirstFaults();
  m_result.faults = std::move(m_faults);
  return std::move(m_result);
}

/// A block that fits is judged alike whatever points follow; for another, all have to be known.
bool IntegrityJudge::Impl::isDecidable(const ExecutedBlock& block) const {
  return !m_isGrowing ||
         (m_due < m_points.size() && (isHold(block) || matches(block, m_due) ||
                                      (m_last != kNone && matches(block, m_last + 1))));
}

void IntegrityJudge::Impl::judgeFirst() {
  const ExecutedBlock& block = m_blocks.front();
  if (isHold(block)) {
    judgeHold(block);
  } else {
    judgeMotion(block);
  }
  m_blocks.pop_front();
}

/// Of equally early faults those that were found first.
void IntegrityJudge::Impl::keepFirstFaults() {
  std::stable_sort(m_faults.begin(), m_faults.end(),
                   [](const IntegrityFault& a, const IntegrityFault& b) { return a.at < b.at; });
  m_faults.resize(std::min(m_faults.size(), kFaultsMax));
}

void IntegrityJudge::Impl::addFault(Kind kind, std::size_t point, base::Instant at) {
  m_faults.push_back({kind, base::PointIndex{static_cast<std::uint32_t>(point)}, at});
  if (m_faults.size() >= 2 * kFaultsMax) {
    keepFirstFaults();
  }
}

void IntegrityJudge::Impl::judgeHold(const ExecutedBlock& block) {
  // A block that moves nothing cannot be wrong. It executes the point due if the axes are there
  // already: since the block before, a tool length or a retract may have changed where they are.
  m_position = endOf(block);
  if (matches(block, m_due)) {
    execute(block, m_due);
  }
}

void IntegrityJudge::Impl::judgeMotion(const ExecutedBlock& block) {
  if (!matches(block, m_due)) {
    passOverDuePointsHere(block);
  }
  const std::size_t point = choose(block);
  m_position = endOf(block);
  if (point == kNone) {
    ++m_result.foreign;
    addFault(Kind::Foreign, std::min(m_due, m_points.empty() ? 0 : m_points.size() - 1),
             block.from);
    return;
  }
  execute(block, point);
}

/// Due points at which the axes are already need no block: they were executed on arrival.
void IntegrityJudge::Impl::passOverDuePointsHere(const ExecutedBlock& block) {
  while (m_position && m_last != kNone && m_due == m_last + 1 && m_due < m_points.size() &&
         base::distance(m_points[m_due].positionMm, m_points[m_last].positionMm) < kHoldMm &&
         base::differenceDeg(m_points[m_due].rotaryDeg, m_points[m_last].rotaryDeg, m_rotaryAxes) <
             kHoldDeg) {
    execute(block, m_due);
  }
}

bool IntegrityJudge::Impl::isExecuted(std::size_t point) const {
  return point < m_inTurn ||
         (m_late && point < m_late->isExecuted.size() && m_late->isExecuted[point]);
}

void IntegrityJudge::Impl::execute(const ExecutedBlock& block, std::size_t point) {
  m_last = point;
  m_due = std::max(m_due, point + 1);
  if (isExecuted(point)) {
    ++m_result.repeated;
    addFault(Kind::Repeated, point, block.from);
    return;
  }
  if (!m_late && point == m_inTurn) {
    ++m_inTurn;
    return;
  }
  if (!m_late) {
    m_late.emplace();
  }
  if (point >= m_late->isExecuted.size()) {
    m_late->isExecuted.resize(std::max(point + 1, m_points.size()));
  }
  m_inOrder = m_inOrder && (m_late->order.empty() || m_late->order.back() < point);
  m_late->isExecuted[point] = true;
  m_late->order.push_back(static_cast<std::uint32_t>(point));
  m_late->from.push_back(block.from);
}

std::size_t IntegrityJudge::Impl::choose(const ExecutedBlock& block) {
  if (matches(block, m_due)) {
    return m_due;
  }
  if (m_last != kNone && matches(block, m_last + 1)) {
    return m_last + 1;
  }
  if (!m_grid) {
    m_grid.emplace(m_points, m_toleranceMm, m_rotaryAxes);
  }
  const std::vector<std::size_t> candidates = m_grid->at(endOf(block), m_due);
  if (candidates.size() < 2) {
    return candidates.empty() ? kNone : candidates.front();
  }
  const auto distanceToDue = [this](std::size_t point) {
    return point < m_due ? m_due - point : point - m_due;
  };
  std::size_t best = kNone;
  std::size_t bestExplained = 0;
  for (const std::size_t point : candidates) {  // ascending: of equals the earlier one stays
    const std::size_t count = explained(point);
    if (best == kNone || count > bestExplained ||
        (count == bestExplained && distanceToDue(point) < distanceToDue(best))) {
      best = point;
      bestExplained = count;
    }
  }
  return best;
}

/// Number of blocks from the first on that fit without another jump if it executed `point`.
std::size_t IntegrityJudge::Impl::explained(std::size_t point) const {
  std::size_t due = std::max(m_due, point + 1);
  std::size_t last = point;
  std::size_t count = 1;
  const std::size_t end = std::min(m_blocks.size(), kLookAheadBlocks);
  for (std::size_t i = 1; i < end; ++i) {
    if (isHold(m_blocks[i])) {
      continue;
    }
    if (matches(m_blocks[i], due)) {
      last = due++;
    } else if (matches(m_blocks[i], last + 1)) {
      due = std::max(due, ++last + 1);
    } else {
      break;
    }
    ++count;
  }
  return count;
}

/// A point is skipped if it was never executed although a later one was.
void IntegrityJudge::Impl::findSkipped() {
  constexpr auto kNever = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> turnOf(m_points.size() - m_inTurn, kNever);
  for (std::size_t i = 0; i < m_late->order.size(); ++i) {
    turnOf[m_late->order[i] - m_inTurn] = static_cast<std::uint32_t>(i);
  }
  std::uint32_t passedBy = kNever;  // the earliest execution of a later point
  for (std::size_t i = turnOf.size(); i-- > 0;) {
    if (turnOf[i] != kNever) {
      passedBy = std::min(passedBy, turnOf[i]);
    } else if (passedBy != kNever) {
      ++m_result.skipped;
      addFault(Kind::Skipped, m_inTurn + i, m_late->from[passedBy]);
    }
  }
}

/// The longest ascending subsequence of the first executions is what was in order (patience
/// sorting: `tails[k]` is the smallest end of an ascending sequence of k + 1 points). The points
/// before the first fault belong to it.
void IntegrityJudge::Impl::findOutOfOrder() {
  const std::vector<std::uint32_t>& order = m_late->order;
  std::vector<std::uint32_t> tails;
  std::vector<std::uint32_t> rank(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto place = std::lower_bound(tails.begin(), tails.end(), order[i]);
    rank[i] = static_cast<std::uint32_t>(place - tails.begin());
    if (place == tails.end()) {
      tails.push_back(order[i]);
    } else {
      *place = order[i];
    }
  }
  // Backwards: the last point of each rank that is below its successor belongs to the sequence.
  std::size_t wanted = tails.size();
  std::size_t successor = m_points.size();
  for (std::size_t i = order.size(); i-- > 0;) {
    if (wanted > 0 && rank[i] == wanted - 1 && order[i] < successor) {
      successor = order[i];
      --wanted;
    } else {
      ++m_result.outOfOrder;
      addFault(Kind::OutOfOrder, order[i], m_late->from[i]);
    }
  }
}

namespace {

/// A control that does not record its blocks is judged by its set points.
Integrity judgeSamples(const std::vector<gcode::StreamPoint>& points, const ControlTrace& trace) {
  std::vector<gcode::StreamPoint> streamed = points;
  for (gcode::StreamPoint& point : streamed) {
    point.kind = gcode::MoveKind::Feed;  // each counts, also those of an arc
  }
  const ProgramPath path(std::move(streamed), trace.samples.front().commandMm);
  const PathMatch match = matchPath(motionOf(trace), path);
  Integrity result;
  result.judged = match.judged && match.undecided == 0;
  result.executed = match.executed;
  result.repeated = match.repeated;
  result.skipped = match.skipped;
  result.foreign = match.foreign + (match.departure ? 1 : 0);
  for (const PathFault& fault : match.faults) {
    const auto kind = fault.kind == PathFault::Kind::Repeated  ? Kind::Repeated
                      : fault.kind == PathFault::Kind::Skipped ? Kind::Skipped
                                                               : Kind::Foreign;
    result.faults.push_back({kind, fault.point, fault.at});
  }
  return result;
}

}  // namespace

IntegrityJudge::IntegrityJudge(const std::vector<gcode::StreamPoint>& points, double toleranceMm,
                               const base::RotarySet& rotaryAxes, PointsOfRun known) {
  RIVULET_ASSERT(toleranceMm >= 0.0);
  RIVULET_ASSERT(points.size() <= std::numeric_limits<std::uint32_t>::max());
  m_impl = std::make_unique<Impl>(points, toleranceMm, rotaryAxes, known == PointsOfRun::Growing);
}

IntegrityJudge::~IntegrityJudge() = default;

void IntegrityJudge::add(std::span<const ExecutedBlock> blocks) {
  m_impl->add(blocks);
}

Integrity IntegrityJudge::finish() {
  return m_impl->finish();
}

Integrity judgeIntegrity(const std::vector<gcode::StreamPoint>& points,
                         const std::vector<ExecutedBlock>& blocks, double toleranceMm,
                         const base::RotarySet& rotaryAxes) {
  IntegrityJudge judge(points, toleranceMm, rotaryAxes, PointsOfRun::Known);
  judge.add(blocks);
  return judge.finish();
}

RunJudge::RunJudge(const std::vector<gcode::StreamPoint>& points, const base::RotarySet& rotaryAxes,
                   PointsOfRun known)
    : m_points(points),
      m_bySamples(!base::any(rotaryAxes)),  // only places of X, Y and Z are compared
      m_blocks(points, kPointToleranceMm, rotaryAxes, known) {
}

void RunJudge::add(const ControlTrace& piece) {
  m_isTruncated = m_isTruncated || piece.truncated;
  if (m_isTruncated) {
    return;
  }
  if ((!piece.blocks.empty() || piece.hasOwnBlocksOnly) && !m_hasBlocks) {
    m_hasBlocks = true;
    m_withoutBlocks = {};
  }
  m_hasSamples = m_hasSamples || !piece.samples.empty();
  m_blocks.add(piece.blocks);
  if (!m_hasBlocks && m_bySamples) {
    m_withoutBlocks.cycle = piece.cycle;
    m_withoutBlocks.rotaryAxes = piece.rotaryAxes;
    m_withoutBlocks.samples.insert(m_withoutBlocks.samples.end(), piece.samples.begin(),
                                   piece.samples.end());
  }
}

Integrity RunJudge::finish() {
  if (m_isTruncated) {
    return {};
  }
  if (m_hasBlocks || !m_hasSamples || m_points.empty()) {
    return m_blocks.finish();
  }
  return m_bySamples ? judgeSamples(m_points, m_withoutBlocks) : Integrity{};
}

Integrity judgeRun(const std::vector<gcode::StreamPoint>& points, const ControlTrace& trace,
                   const base::RotarySet& rotaryAxes) {
  RunJudge judge(points, rotaryAxes, PointsOfRun::Known);
  judge.add(trace);
  return judge.finish();
}

}  // namespace rivulet::trace
