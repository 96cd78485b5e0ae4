// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The program's commands, one source file each. Each adds itself with its options and runs
/// when it is named.

#include <CLI/CLI.hpp>

namespace osteon::app {

void add_skeleton(CLI::App& program);
/// The result tells, after parsing, whether nothing was refuted.
const bool& add_verify(CLI::App& program);
void add_offset(CLI::App& program);
void add_roof(CLI::App& program);
void add_splits(CLI::App& program);
void add_ambiguity(CLI::App& program);
void add_generate(CLI::App& program);

}  // namespace osteon::app
