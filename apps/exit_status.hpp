// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// How the program ends: one number for each kind of outcome, as `osteon --help` lists them.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace osteon::app {

/// Tells the caller of the program how it ended.
enum class exit_status : std::uint8_t {
  done = 0,     ///< the command did what it was told
  refuted = 1,  ///< `osteon verify` found a broken rule; its result names the rule
  /// the command line is wrong: an unknown option, a value out of range, options that exclude each
  /// other
  usage = 2,
  /// a file cannot be read, is not what the command takes, or needs more memory than there is
  bad_input = 3,
  undecided = 4,  ///< the chosen kernel cannot decide; the exact kernels can
  broken = 5,     ///< an internal invariant does not hold: a defect of Osteon
  /// a result could not be written, or not all of it: the disk is full, the pipe is closed, the
  /// folder is missing
  unwritten = 6
};

/// Lists all statuses with the words that `osteon --help` has for them, in the order of their
/// numbers.
inline constexpr std::array<std::pair<exit_status, std::string_view>, 7> exit_statuses = {{{exit_status::done, "done"},
                                                                                           {exit_status::refuted, "refuted (verify)"},
                                                                                           {exit_status::usage, "wrong usage"},
                                                                                           {exit_status::bad_input, "bad input"},
                                                                                           {exit_status::undecided, "the kernel could not decide"},
                                                                                           {exit_status::broken, "internal invariant violated"},
                                                                                           {exit_status::unwritten, "output could not be written"}}};

/// Returns the line of `osteon --help` that lists all statuses.
inline std::string describe_exit_statuses() {
  std::string text = "Exit status:";
  for (const auto& [status, meaning] : exit_statuses)
    text.append(status == exit_status::done ? " " : ", ").append(std::to_string(static_cast<int>(status))).append(" ").append(meaning);
  return text + ".";
}

}  // namespace osteon::app
