// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Opens files for reading.

#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

#include "osteon/core/error.hpp"

namespace osteon {

/// Returns a file opened for reading, byte by byte. Names have no special meanings: "-" is a file.
/// *Throws* input_error(unreadable) where there is no such file, where it is a folder, and where
/// the system refuses.
inline std::ifstream open_file(const std::string& name) {
  const auto refuse = [&](const std::string& why, const std::string& hint) {
    throw input_error(input_fault::unreadable, 0, name + ": cannot be opened: " + why, hint);
  };
  std::error_code ignored;
  const auto kind = std::filesystem::status(name, ignored).type();
  if (kind == std::filesystem::file_type::not_found) refuse("there is no such file", "check the name");
  if (kind == std::filesystem::file_type::directory) refuse("it is a folder", "name a file in it");
  std::ifstream in(name, std::ios::binary);
  if (!in) refuse("the system refuses", "check who may read the file");
  return in;
}

}  // namespace osteon
