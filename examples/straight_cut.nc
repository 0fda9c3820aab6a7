; SPDX-FileCopyrightText: 2026 The Rivulet authors
; SPDX-License-Identifier: GPL-3.0-or-later
; A straight cut for steady_force.py
G90 G71 G94
G1 X120 F400
M30
