#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the axes did: examples/python/read_trace.py TRACE [PROGRAM]"""
import sys

import rivulet

trace = rivulet.analyse(sys.argv[1], program=sys.argv[2] if len(sys.argv) > 2 else None)
for remark in trace.report.get("remarks", []):
    print("note:", remark)
print("%d samples, %d standstills" % (trace.samples, trace.standstill_count))
for name, values in trace.signals.items():
    known = [value for value in values if value == value]  # not a number: nothing is known there
    if known:
        print("%-14s %10.3f to %10.3f %s" % (name, min(known), max(known), trace.units[name]))
