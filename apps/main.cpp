// SPDX-License-Identifier: MIT

/// \file
/// The program osteon. Results on standard output, messages on standard error, exit status by
/// kind of outcome.

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "commands.hpp"
#include "exit_status.hpp"
#include "osteon/osteon.hpp"
#include "output.hpp"

namespace osteon::app {
namespace {

exit_status fail(exit_status status, const std::string& message) {
  fmt::print(stderr, "osteon: {}\n", message);
  return status;
}

/// What is wrong with the command line, and which `--help` to look at.
std::string describe_misuse(const CLI::App* program, const CLI::Error& e) {
  std::string help = "osteon";
  for (const auto* command : program->get_subcommands()) help += " " + command->get_name();
  std::string what = e.what();
  if (program->get_subcommands().empty()) {
    const std::vector<std::string> unknown = program->remaining();
    what = unknown.empty() ? "a command is required" : fmt::format("'{}' is no {}", unknown[0], unknown[0].starts_with('-') ? "option" : "command");
  }
  return fmt::format("osteon: {}; hint: `{} --help` lists what can be given\n", what, help);
}

exit_status run(int argc, char** argv) {
  CLI::App program("Exact straight skeletons of polygons and polyhedra.", "osteon");
  program.get_formatter()->label("SUBCOMMAND", "COMMAND");
  program.get_formatter()->label("Subcommands", "Commands");
  program.require_subcommand(1);
  program.set_version_flag("--version", "osteon " + std::string(version()));
  program.failure_message(describe_misuse);
  program.footer("`osteon COMMAND --help` has the options of a command, with examples.\n" + describe_exit_statuses() +
                 "\nExamples:\n  osteon generate star -o star.obj\n  osteon skeleton star.obj --summary");
  for (const auto add : add_commands) add(program);
  try {
    program.parse(argc, argv);
    return exit_status::done;
  } catch (const CLI::RuntimeError& e) {
    return static_cast<exit_status>(e.get_exit_code());
  } catch (const CLI::ParseError& e) {
    return program.exit(e, standard_output(), std::cerr) == 0 ? exit_status::done : exit_status::usage;
  }
}

/// Runs a body that returns a status; errors become statuses, too.
template <class Body>
exit_status with_messages(Body body) {
  try {
    return body();
  } catch (const output_error& e) {
    return fail(exit_status::unwritten, e.what());
  } catch (const input_error& e) {
    return fail(exit_status::bad_input, e.what());
  } catch (const degenerate_error& e) {
    return fail(exit_status::undecided, std::string(e.what()) + ": --kernel sqrt or --kernel rational");
  } catch (const unsupported_error& e) {
    return fail(exit_status::bad_input, e.what());
  } catch (const undecided_error& e) {
    return fail(exit_status::undecided, std::string(e.what()) + ": --kernel sqrt or --kernel rational");
  } catch (const invariant_error& e) {
    return fail(exit_status::broken, std::string(e.what()) + "\nThis is a defect of osteon; please report it with the input.");
  } catch (const std::bad_alloc&) {
    return fail(exit_status::bad_input, "the input needs more memory than there is; hint: give a smaller model");
  } catch (const std::exception& e) {
    return fail(exit_status::broken, e.what());
  }
}

/// Runs the command, and writes what standard output still holds. What was printed before an error
/// is a result, too.
exit_status run_and_flush(int argc, char** argv) {
  const exit_status status = with_messages([&] { return run(argc, argv); });
  const exit_status flushed = with_messages([] {
    flush_standard_output();
    return exit_status::done;
  });
  return flushed == exit_status::done || status > exit_status::refuted ? status : flushed;
}

}  // namespace
}  // namespace osteon::app

int main(int argc, char** argv) {
  osteon::app::prepare_output();
  return static_cast<int>(osteon::app::run_and_flush(argc, argv));
}
