// SPDX-License-Identifier: MIT

/// \file
/// The program osteon. Results on standard output, messages on standard error, exit status by kind of error.

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <new>

#include "commands.hpp"
#include "osteon/core/error.hpp"

namespace osteon::app {
namespace {

enum status : int { done = 0, refuted = 1, usage = 2, bad_input = 3, undecided = 4, broken = 5 };

int run(int argc, char** argv) {
  CLI::App program("Exact straight skeletons of polygons and polyhedra.", "osteon");
  program.require_subcommand(1);
  program.set_version_flag("--version", "osteon 0.1.0");
  program.footer(
      "Exit status: 0 done, 1 refuted (verify), 2 wrong usage, 3 bad input, 4 the kernel could not decide, 5 internal invariant "
      "violated.\nExample:\n  osteon skeleton "
      "model.obj --summary");
  add_skeleton(program);
  const bool& holds = add_verify(program);
  add_offset(program);
  add_roof(program);
  add_splits(program);
  add_ambiguity(program);
  add_generate(program);
  try {
    program.parse(argc, argv);
    return holds ? done : refuted;
  } catch (const CLI::ParseError& e) {
    return program.exit(e) == 0 ? done : usage;
  } catch (const input_error& e) {
    fmt::print(stderr, "osteon: {}\n", e.what());
    return bad_input;
  } catch (const degenerate_error& e) {
    fmt::print(stderr, "osteon: {}, as the sqrt and rational kernels are\n", e.what());
    return undecided;
  } catch (const unsupported_error& e) {
    fmt::print(stderr, "osteon: {}\n", e.what());
    return bad_input;
  } catch (const undecided_error& e) {
    fmt::print(stderr, "osteon: {}\n", e.what());
    return undecided;
  } catch (const invariant_error& e) {
    fmt::print(stderr, "osteon: {}\nThis is a defect of osteon; please report it with the input.\n", e.what());
    return broken;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "osteon: the input needs more memory than there is; hint: give a smaller model\n");
    return bad_input;
  } catch (const std::exception& e) {
    fmt::print(stderr, "osteon: {}\n", e.what());
    return broken;
  }
}

}  // namespace
}  // namespace osteon::app

int main(int argc, char** argv) { return osteon::app::run(argc, argv); }
