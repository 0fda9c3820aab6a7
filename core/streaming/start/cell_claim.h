// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The claim of a client on the cells of its run, from before the first write to the control until
/// the program obeys the run (from then on the owner cell protects it).
///
/// A control has no atomic test-and-set for R-parameters, so this is Fischer's algorithm: read the
/// cell; if it is free, write the number of the own run; wait for `kSettle`; the claim holds if the
/// number is still there. The last of several writers wins, and the others see its number.
///
/// Why two clients cannot both hold: let A write before B. B found the cell free, so B's read came
/// before A's write. B's write follows B's read within `kQuick`, which is less than `kSettle`, so
/// it is there when A looks again, and A gives way. A client that takes longer than `kQuick`
/// between read and confirmed write cannot count on that. It watches the cell for `kLapse` instead,
/// and a holder repeats its number at least every `kRenewed` while it may rely on it, so the late
/// client finds the holder's number there and gives way. A holder that finds its own number after a
/// pause needs only `kSettle` again: nobody else can have held the cells meanwhile, and a quick
/// write of another shows within that time.
///
/// The number is negative while it is a claim and carries a counter, so that a living claim
/// changes. One that has not changed for `kLapse` belongs to a client that died before its start,
/// and lapses: it does not lock anybody out. A run in progress writes its heartbeat, which is
/// positive, into the same cell.
///
/// What remains: a client whose requests are held up by the network for longer than `kLapse` and
/// are then carried out. The program on the control obeys only one run then, too.
/// @threadsafety one object, one thread; as the link below it.
#pragma once

#include <functional>
#include <optional>

#include "base/instant.h"
#include "base/result.h"
#include "opcua/forwarding_link.h"

namespace rivulet::streaming {

/// A link that repeats the claim while somebody waits for an answer on it.
class CellClaim final : public opcua::ForwardingLink {
 public:
  static constexpr base::Duration kSettle = std::chrono::milliseconds{1000};
  static constexpr base::Duration kQuick = std::chrono::milliseconds{600};
  static constexpr base::Duration kLapse = std::chrono::seconds{10};
  static constexpr base::Duration kRenewed = kLapse / 2;
  static constexpr base::Duration kBeatInterval = std::chrono::milliseconds{300};
  static_assert(kQuick < kSettle && kBeatInterval < kRenewed);

  /// What there is to do beside waiting. All may be empty.
  struct Hooks {
    std::function<bool()> isCancelled;  ///< asked several times a second
    std::function<void()> waits;        ///< once: for the claim of a client that may be dead
  };

  /// @param cell  R number  @param number  of the run, 1 to `kRunNumberMax`
  /// @param deadline  of one request
  CellClaim(opcua::Link& link, int cell, int number, base::Duration deadline)
      : ForwardingLink(link), m_cell(cell), m_number(number), m_deadline(deadline) {}

  /// Claims the cells; nothing else is changed on the control.
  /// @return nothing: they are claimed; else the number of the run that has them. ChannelBusy (a
  ///         program was started meanwhile), Cancelled, or a link error
  [[nodiscard]] base::Result<std::optional<int>> take(const Hooks& hooks);
  /// To be called before each step that changes the control: claims the cells again if they may
  /// have been lost since, because nothing could be sent for too long. @return as `take`
  [[nodiscard]] base::Result<std::optional<int>> renew(const Hooks& hooks);
  /// Gives up the claim, if it stands. Errors do not matter: it lapses.
  void release();

  std::optional<opcua::Event> wait(base::Instant until) override;

 private:
  struct Seen {
    double value = 0.0;
    base::Instant asked{};  ///< when the request was sent
  };

  [[nodiscard]] opcua::Assignment nextBeat();
  [[nodiscard]] base::Result<Seen> look();
  [[nodiscard]] base::Result<Seen> awaitFree(const Hooks& hooks, std::optional<int>& holder);
  [[nodiscard]] base::Result<void> pause(const Hooks& hooks);

  int m_cell;
  int m_number;
  base::Duration m_deadline;
  bool m_isHeld = false;
  double m_beats = 0.0;
  base::Instant m_nextBeat{};
  base::Instant m_renewedAt{};  ///< when the last confirmed beat was sent
  std::optional<base::RequestId> m_beatPending;
};

/// Run whose claim a number in the cell is; nothing: it is none.
[[nodiscard]] std::optional<int> claimantOf(double value);

}  // namespace rivulet::streaming
