// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The program's commands, one source file each. Each adds itself with its options and runs
/// when it is named.

#include <CLI/CLI.hpp>
#include <array>

namespace osteon::app {

/// Adds a command with its options to the program.
///@{
void add_skeleton(CLI::App& program);
void add_verify(CLI::App& program);
void add_offset(CLI::App& program);
void add_roof(CLI::App& program);
void add_splits(CLI::App& program);
void add_ambiguity(CLI::App& program);
void add_generate(CLI::App& program);
///@}

/// All commands, in the order in which `--help` lists them.
inline constexpr std::array add_commands = {add_skeleton, add_verify, add_offset, add_roof, add_splits, add_ambiguity, add_generate};

}  // namespace osteon::app
