// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The one way that results take out of the program: every write is checked, and a file
/// appears whole or not at all. POSIX only.

#include <functional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace osteon::app {

/// Tells that a result could not be written, or not all of it. The text names the output, the cause
/// and a hint.
struct output_error : std::runtime_error {
  /// Describes a failed system call on the output `name`; `cause` is its errno.
  output_error(const std::string& name, int cause);
};

/// Makes failed writes visible as errors: a closed pipe or a file size limit does not end the
/// process, and a standard stream that the caller has closed is not mistaken for a file that is
/// opened later. Call it once, before anything is opened.
void prepare_output();

/// Returns the stream of standard output, the only one that may write there. Where standard output
/// is a terminal, lines appear when they are complete. *Throws* output_error from any operation
/// that writes.
std::ostream& standard_output();

/// Writes what standard output still holds back. Call it at the end of every command. *Throws*
/// output_error.
void flush_standard_output();

/// The place of one result: a file, or standard output.
class destination {
 public:
  /// Looks at a file's name, empty for standard output, so that a missing folder is told before a
  /// long computation and not after it. Nothing is created yet. *Throws* output_error.
  explicit destination(std::string file);

  /// Calls `text` with a stream and checks that all arrives.
  ///
  /// A regular or new file is written under another name in its folder and renamed in the end. So
  /// the file holds the old content or the whole new one, also when writing fails or a signal ends
  /// the program. The file keeps its permissions, and a symbolic link keeps pointing to it.
  /// Whatever else has a name (a device, a pipe, `/dev/stdout`) is written to directly. *Throws*
  /// output_error, and what `text` throws.
  void write(const std::function<void(std::ostream&)>& text) const;
  /// Writes a text that is complete already.
  void write(std::string_view text) const;

 private:
  enum class way { standard_output, directly, by_renaming };

  std::string name_;    // as the user gave it
  std::string target_;  // where its symbolic links lead
  way way_ = way::standard_output;
};

}  // namespace osteon::app
