#!/bin/sh
# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later

# A circle of 10 mm, computed while the machine moves. The end of the pipe is the end of the path.
# Options for rivulet-cli may follow: examples/circle.sh --endpoint opc.tcp://127.0.0.1:4840
[ $# -eq 0 ] && set -- --simulate --preset dmu75-arrays

awk 'BEGIN {
  print "comment a circle around X-10 Y0"
  for (i = 1; i <= 630; i++) {
    printf "X%.4f Y%.4f\n", 10 * (cos(i / 100) - 1), 10 * sin(i / 100)
  }
}' | ${RIVULET_CLI:-rivulet-cli} stream --live - --box -25 5 -15 15 0 100 --points 13 "$@"
