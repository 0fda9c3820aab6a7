// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Sentences that core knows and others translate.
#pragma once

/// Marks a sentence that is shown: in English by the log and the command line, and the source of
/// its translation, which lupdate finds by this name (scripts/translations). "%1" is its parameter.
#define RIVULET_SENTENCE(context, sentence) sentence
