// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// What is around every example: notes and errors on standard error, the status, and no
/// result that is lost in silence.

#include <cstdio>
#include <exception>
#include <iostream>
#include <osteon/osteon.hpp>

namespace example {

/// Reads a polygon and says on standard error what was repaired.
inline osteon::polygon read(const char* file) {
  const osteon::polygon p = osteon::read_polygon(file);
  for (const auto& note : p.notes()) std::fprintf(stderr, "note: %s\n", note.c_str());
  return p;
}

/// Runs an example. Returns the program's status: 0 done, 3 bad input, 5 another error, 6 the
/// result could not be written.
template <class Body>
int run(Body body) {
  try {
    body();
    if (std::cout.flush() && std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return 0;
    std::perror("the result could not be written");
    return 6;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return dynamic_cast<const osteon::input_error*>(&e) != nullptr ? 3 : 5;
  }
}

}  // namespace example
