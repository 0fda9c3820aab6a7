// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/* The protocol of method window, as docs/methods.md has it, for `spin`: three windows in two
 * stretches, a network that loses, delays and doubles writes, one crash on each side, two clients.
 * Each window has one point, and a point is a number; the check number of a window is known by what
 * it was made of: run, window and point. What the client reads is taken for present: a late answer
 * only makes it slower.
 *
 * Names in capitals are mistakes that `tests/model/check` builds in, one at a time; each must be
 * found. With REPLAY, no client writes but a process that draws its writes, one after the other, and
 * what the program does is printed: tests/streaming/tst_window_model replays that on the program
 * itself. */

#define POINTS 3
#define SLOTS 2
#ifdef REPLAY
#define STRETCHES 1
#define lastOf(stretch) POINTS
#else
#define STRETCHES 2
#define lastOf(stretch) (stretch == 1 -> 2 : 3)
#endif

/* Writes that are late, lost or doubled. */
#ifndef FAULTS
#define FAULTS 2
#endif
/* Runs after that are not looked at: each needs a fault, or a client or machine that is not there. */
#ifndef RUNS_MAX
#define RUNS_MAX 5
#endif

/* The content goes first, then the number. */
#ifdef NUMBER_FIRST
#define FIRST DELIVERED
#define FIRST_VALUE next
#define SECOND CONTENT
#define SECOND_VALUE mine
#else
#define FIRST CONTENT
#define FIRST_VALUE mine
#define SECOND DELIVERED
#define SECOND_VALUE next
#endif

/* Values of the run cell, see WindowProtocol. */
#define HOLD 0
#define RUN 1
#define END 2

/* Cells. */
byte runCell, delivered, latched, asked, owner;
byte slotPoint[SLOTS];
byte checkRun[SLOTS], checkWindow[SLOTS], checkPoint[SLOTS]; /* one cell: the check number */
byte claim;   /* who has the cells; 0: nobody */
byte stretch; /* that the program waits in; 0: none yet */

/* The control. */
bool isActive; /* a program runs */
byte done;     /* points that the tool has passed: its place */
bool powerFails;

/* Clients 1 and 2. */
bool isKilled;  /* the first of them */
bool cameBack; /* it has been killed */
bool isGone[3];
bool reads[3];  /* between the look at a free claim and the write */
byte runsGiven; /* numbers; the next one is of whoever asks */

/* Writes on their way: kind, the value or the number of the run, window, point; and whether the
 * client had come back by then: nobody hears the answers of a connection that is gone. */
mtype = { CONTENT, DELIVERED, RUNCELL, ASKED };
chan net[2] = [1] of { mtype, byte, byte, byte, bool };
chan late = [FAULTS + 1] of { mtype, byte, byte, byte };
mtype = { NONE, DONE, LOST };
mtype answer[4] = NONE; /* being made */
mtype heard[3] = NONE;  /* by the client */
byte faults;

/* The control may look between two cells of a request, but serves one request after the other. */
#ifndef REPLAY
active proctype Server() {
  mtype kind;
  byte a, b, c, from;
  bool isNew, isApplied;
end_server:
  do
  :: atomic {
       if
       :: net[0] ? kind, a, b, c, isNew -> from = 1
       :: net[1] ? kind, a, b, c, isNew -> from = 2
       :: late ? kind, a, b, c -> from = 3
       fi;
       isApplied = true;
       if
       :: answer[from] = DONE
       :: from < 3 && faults < FAULTS -> faults++;
          if
          :: answer[from] = LOST; isApplied = false                       /* the request is lost */
          :: late ! kind, a, b, c; answer[from] = LOST; isApplied = false /* it comes later */
          :: late ! kind, a, b, c; answer[from] = DONE                    /* it comes twice */
          :: answer[from] = LOST                                          /* its answer is lost */
          fi
       fi;
       if
       :: !isApplied
       :: else ->
          if
          :: kind == DELIVERED -> delivered = a
          :: kind == RUNCELL -> runCell = a
          :: kind == ASKED -> asked = a
          :: kind == CONTENT -> slotPoint[(b - 1) % SLOTS] = c
          fi
       fi
     };
     atomic {
       if
       :: isApplied && kind == CONTENT ->
          checkRun[(b - 1) % SLOTS] = a;
          checkWindow[(b - 1) % SLOTS] = b;
          checkPoint[(b - 1) % SLOTS] = c
       :: else
       fi;
       if
       :: from == 2 || (from == 1 && isNew == cameBack) -> heard[from] = answer[from]
       :: else
       fi;
       kind = 0; a = 0; b = 0; c = 0; from = 0; isNew = false; isApplied = false;
       answer[0] = NONE; answer[1] = NONE; answer[2] = NONE; answer[3] = NONE
     }
  od
}

#endif

/* The program on the control: templates/methods/window. */
active proctype Control() {
  byte own, window, point;
  bool isWhole;
end_reset:
  (isActive || powerFails);
  {
    skip;
next_stretch:
    atomic {
      stretch = (stretch == 0 -> (done >= lastOf(1) -> 2 : 1) : stretch + 1);
      runCell = HOLD; delivered = 0; latched = 0; asked = 0; owner = 0;
#ifndef OWNER_IS_KEPT
      own = 0;
#endif
#ifndef SLOTS_ARE_KEPT
      checkRun[0] = 0; checkRun[1] = 0; /* the check cells */
#endif
      window = 0
    };
    do
    :: atomic { runCell == END -> goto ended }
    :: atomic { runCell == RUN &&
own > 0 && delivered > window && delivered <= window + SLOTS -> point = slotPoint[window % SLOTS] };
       atomic {
         isWhole = (checkWindow[window % SLOTS] == window + 1);
         isWhole = (isWhole && checkPoint[window % SLOTS] == point);
#ifndef CHECK_WITHOUT_RUN
         isWhole = (isWhole && checkRun[window % SLOTS] == own);
#endif
#ifndef NO_CHECK_NUMBER
         if
         :: isWhole
         :: !isWhole -> goto ended
         fi;
#endif
         isWhole = false;
         window++;
         latched = window
       };
       atomic { /* The motion. */
#ifdef REPLAY
         printf("takes %d moves %d\n", window, point);
#else
         assert(own > 0 && own <= runsGiven); /* never without a grant */
         assert(point == done + 1);           /* never twice, never left out */
#endif
         done = point;
         if
         :: done == lastOf(stretch) -> break
         :: else
         fi
       }
    :: atomic { runCell != END && own == 0 && asked > 0 -> own = asked; owner = own;
#ifdef REPLAY
                printf("obeys %d\n", own)
#endif
              }
#ifndef REPLAY
    :: atomic { runCell != END && (claim == 0 || isGone[claim]) &&
                (own == 0 || runCell == HOLD || delivered <= window) ->
                goto ended } /* no sign of its client */
#endif
    od;
    if
    :: stretch < STRETCHES -> goto next_stretch
    :: else
    fi;
ended:
#ifdef REPLAY
    printf("ends\n")
#else
    skip
#endif
  } unless { powerFails };
  d_step {
    powerFails = false;
    isActive = false; /* in reset; the cells and the place of the axes stay */
    own = 0; window = 0; isWhole = false; point = 0
  };
  goto end_reset
}

#ifdef REPLAY
/* Runs 1 and 2, windows 1 to 3; points as they should be, and others; a window whose check number is of
 * another point. */
proctype Writer() {
  byte steps, v, r, w, p;
  timeout; /* the program waits */
  atomic {
    if
    :: runCell = RUN; printf("run %d\n", RUN)
    :: asked = 1; printf("asked 1\n")
    fi
  };
  do
  :: timeout && isActive && steps < 16 ->
     steps++;
     select(v : 0 .. 9);
     select(r : 1 .. 2);
     select(w : 1 .. 3);
     select(p : 1 .. 3);
     atomic {
       if
       :: v <= 5 ->
          r = (v <= 4 -> 1 : r); /* often as it should be */
          p = (v <= 3 -> w : p);
          w = (v <= 2 -> latched + 1 : w);
          p = (v <= 2 -> w : p);
          slotPoint[(w - 1) % SLOTS] = p;
          checkRun[(w - 1) % SLOTS] = r;
          checkWindow[(w - 1) % SLOTS] = w;
          checkPoint[(w - 1) % SLOTS] = p;
          printf("content %d %d %d\n", r, w, p)
       :: v == 6 && r == 1 -> slotPoint[(w - 1) % SLOTS] = p; printf("point %d %d\n", w, p)
       :: v == 6 && r == 2 && asked == 0 -> asked = (p == 3 -> 2 : 1); printf("asked %d\n", asked)
       :: v == 6 && r == 2 && asked > 0 -> runCell = RUN; printf("run %d\n", RUN)
       :: v == 7 || v == 8 ->
          delivered = (r == 1 -> latched + 1 : w);
          printf("delivered %d\n", delivered)
       :: v == 9 && w == 3 && p == 3 -> runCell = END; printf("run %d\n", END)
       :: v == 9 && w == 2 -> runCell = HOLD; printf("run %d\n", HOLD)
       :: v == 9 && w == 3 && p != 3 -> runCell = RUN; printf("run %d\n", RUN)
       :: v == 9 && w == 1 && asked == 0 -> asked = 1; printf("asked 1\n")
       :: v == 9 && w == 1 && asked > 0 -> skip
       fi
     }
  :: timeout && (!isActive || steps == 16) -> break
  od
}

init {
  isActive = true;
  run Writer()
}
#else

/* A write; what is not answered is asked for again: it has the same effect twice. */
inline ask(kind, a, b, c) {
  heard[me] = NONE;
  net[me - 1] ! kind, a, b, c, cameBack
}

/* streaming/methods/window and streaming/recovery; the first one is killed once, and comes back. */
proctype Client(byte me) {
  byte mine, in, first, next, count;
  bool hasFirst;
  {
    /* The claim. */
    if
    :: atomic { claim == 0 || claim == me || isGone[claim] -> reads[me] = true };
       atomic { claim = me; reads[me] = false };
#ifndef CLAIM_AT_ONCE
       (!reads[3 - me]);
#endif
       if
       :: claim == me
       :: else -> goto quit
       fi
    :: claim != 0 && claim != me && !isGone[claim] -> goto quit /* it is told whose run it is */
    fi;
again:
    /* A program that still waits is ended first. */
    do
    :: atomic { !isActive -> break }
    :: atomic { isActive && runCell != END -> ask(RUNCELL, END, 0, 0) };
       atomic { heard[me] != NONE -> heard[me] = NONE }
    od;
    atomic {
#ifdef RESUMES_AT_DELIVERED
      first = (stretch == 2 -> 2 : 0) + delivered + 1;
#elif defined(RESUMES_AT_LATCHED)
      first = (stretch == 2 -> 2 : 0) + latched + 1;
#else
      first = done + 1; /* the place of the tool */
#endif
      if
      :: first > POINTS -> goto finished
      :: else
      fi;
      in = (first > lastOf(1) -> 2 : 1);
      stretch = 0; isActive = true
    };
    do
    :: in <= STRETCHES ->
       /* Until the program waits in this stretch. */
       if
       :: stretch == in
       :: stretch > in -> goto again /* late writes of an earlier run have moved it on */
       :: !isActive -> goto again
       fi;
       atomic {
         if
         :: runsGiven >= RUNS_MAX -> isGone[me] = true; goto quit
         :: else -> runsGiven++; mine = runsGiven
         fi
       };
       do
       :: atomic { owner == mine -> count = lastOf(in) - first + 1; next = 1; break }
       :: atomic { owner != mine && owner != 0 && isActive -> goto again }
       :: atomic { owner == 0 && isActive && asked != mine -> ask(ASKED, mine, 0, 0) };
          atomic { heard[me] != NONE -> heard[me] = NONE }
       :: atomic { !isActive -> goto again }
       od;
       do
       :: atomic { !isActive || stretch != in -> hasFirst = false; break }
       :: atomic { isActive && stretch == in && !hasFirst && next <= count && next <= latched + SLOTS ->
                   ask(FIRST, FIRST_VALUE, next, first + next - 1) };
          atomic { heard[me] != NONE -> hasFirst = (heard[me] == DONE); heard[me] = NONE }
       :: atomic { isActive && stretch == in && hasFirst ->
                   ask(SECOND, SECOND_VALUE, next, first + next - 1) };
          atomic { heard[me] != NONE ->
                   if
                   :: heard[me] == DONE -> hasFirst = false; next++
                   :: else
                   fi;
                   heard[me] = NONE }
       :: atomic { isActive && stretch == in && (next > count || next > SLOTS) && runCell == HOLD ->
                   ask(RUNCELL, RUN, 0, 0) };
          atomic { heard[me] != NONE -> heard[me] = NONE }
       :: atomic { isActive && stretch == in && !hasFirst && next > 1 && delivered != next - 1 ->
                   ask(DELIVERED, next - 1, 0, 0) }; /* it may have been overwritten meanwhile */
          atomic { heard[me] != NONE -> heard[me] = NONE }
       od;
       atomic {
         if
         :: done >= lastOf(in) -> first = lastOf(in) + 1; in++
         :: else -> goto again
         fi
       }
    :: in > STRETCHES -> break
    od;
finished:
    assert(done == POINTS);
    claim = 0;
    goto quit
  } unless { isKilled && me == 1 };
  d_step {
    isKilled = false; cameBack = true; isGone[1] = true; reads[1] = false; heard[1] = NONE;
    mine = 0; in = 0; first = 0; next = 0; count = 0; hasFirst = false
  };
  atomic { isGone[1] = false; run Client(1) };
quit:
  atomic { mine = 0; in = 0; first = 0; next = 0; count = 0; hasFirst = false }
}

/* One crash on each side, at any moment. */
#ifndef NO_KILL
active proctype Crashes() {
end_client:
  isKilled = true
}
#endif
#ifndef NO_POWER_LOSS
active proctype Power() {
end_power:
  powerFails = true
}
#endif

init {
  atomic {
    run Client(1);
    run Client(2)
  }
}
#endif
