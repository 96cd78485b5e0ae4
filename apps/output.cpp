// SPDX-License-Identifier: MIT

#include "output.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <random>
#include <streambuf>
#include <system_error>
#include <utility>
#include <vector>

namespace osteon::app {
namespace {

const char* hint_for(int cause) {
  switch (cause) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
      return "make room on the disk, or write to another one";
    case EPIPE:
      return "the program that reads must read to the end";
    case EBADF:
      return "standard output is closed; open it or name a file";
    case ENOENT:
    case ENOTDIR:
      return "make the folder first, or name another one";
    case EISDIR:
      return "name a file in that folder";
    case EACCES:
    case EPERM:
    case EROFS:
      return "choose a place where you may write";
    default:
      return "check the name and the disk";
  }
}

/// A stream's buffer over a file descriptor. What cannot be written is an error at once.
class descriptor_buffer : public std::streambuf {
 public:
  /// `by_line`: lines are written when they are complete. Does not close the descriptor.
  descriptor_buffer(int descriptor, std::string name, bool by_line)
      : descriptor_(descriptor), name_(std::move(name)), by_line_(by_line), text_(1U << 16U) {
    empty();
  }

 protected:
  int_type overflow(int_type c) override {
    write_all();
    if (!traits_type::eq_int_type(c, traits_type::eof())) sputc(traits_type::to_char_type(c));
    return traits_type::not_eof(c);
  }
  std::streamsize xsputn(const char* text, std::streamsize size) override {
    const std::streamsize taken = std::streambuf::xsputn(text, size);
    if (by_line_ && std::memchr(text, '\n', static_cast<std::size_t>(size)) != nullptr) write_all();
    return taken;
  }
  int sync() override {
    write_all();
    return 0;
  }

 private:
  void empty() { setp(text_.data(), text_.data() + text_.size()); }

  void write_all() {
    const char* next = pbase();
    const char* const end = pptr();
    empty();  // what has failed once is not tried again
    while (next < end) {
      const ssize_t written = ::write(descriptor_, next, static_cast<std::size_t>(end - next));
      if (written >= 0)
        next += written;
      else if (errno != EINTR)
        throw output_error(name_, errno);
    }
  }

  int descriptor_;
  std::string name_;
  bool by_line_;
  std::vector<char> text_;
};

/// A stream over a file descriptor whose operations throw output_error.
class descriptor_stream : public std::ostream {
 public:
  descriptor_stream(int descriptor, std::string name, bool by_line = false) : std::ostream(nullptr), buffer_(descriptor, std::move(name), by_line) {
    rdbuf(&buffer_);
    exceptions(std::ios::badbit);
  }

 private:
  descriptor_buffer buffer_;
};

/// A file descriptor that closes itself.
class descriptor {
 public:
  explicit descriptor(int number) : number_(number) {}
  descriptor(const descriptor&) = delete;
  descriptor& operator=(const descriptor&) = delete;
  ~descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  int number() const { return number_; }
  /// Returns whether all that was written has arrived.
  bool close() { return ::close(std::exchange(number_, -1)) == 0; }

 private:
  int number_;
};

// ---- signals: a file that is not finished goes when they end the program

constexpr std::array<int, 3> ending_signals = {SIGHUP, SIGINT, SIGTERM};
std::array<char, PATH_MAX> unfinished{};  // the file's name; empty where there is none

extern "C" void remove_unfinished(int number) {
  if (unfinished[0] != '\0') ::unlink(unfinished.data());
  std::signal(number, SIG_DFL);
  std::raise(number);
}

/// While it lives, signals wait.
class signals_blocked {
 public:
  signals_blocked() {
    sigset_t set;
    sigemptyset(&set);
    for (const int s : ending_signals) sigaddset(&set, s);
    sigprocmask(SIG_BLOCK, &set, &before_);
  }
  signals_blocked(const signals_blocked&) = delete;
  signals_blocked& operator=(const signals_blocked&) = delete;
  ~signals_blocked() { sigprocmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t before_{};
};

// ---- files

bool is_same(const struct stat& a, const struct stat& b) { return a.st_dev == b.st_dev && a.st_ino == b.st_ino; }

/// Where symbolic links lead, whether a file is there or not.
std::string follow_links(const std::string& name) {
  namespace fs = std::filesystem;
  fs::path at = name;
  std::error_code failed;
  for (int links = 0; fs::is_symlink(fs::symlink_status(at, failed)); ++links) {
    if (links == 40) throw output_error(name, ELOOP);
    const fs::path next = fs::read_symlink(at, failed);
    if (failed) throw output_error(name, failed.value());
    at = next.is_absolute() ? next : at.parent_path() / next;
  }
  return at.string();
}

std::string folder_of(const std::string& file) {
  const std::string folder = std::filesystem::path(file).parent_path().string();
  return folder.empty() ? "." : folder;
}

/// A new file beside `target`, which takes its place in the end or goes.
class unfinished_file {
 public:
  unfinished_file(const std::string& target, const std::string& name) : target_(target), name_(name) {
    const std::filesystem::path folder = folder_of(target);
    std::random_device random;
    while (file_ < 0) {
      fresh_ = (folder / (".osteon-" + std::to_string(random()) + ".part")).string();
      if (fresh_.size() >= unfinished.size()) throw output_error(name_, ENAMETOOLONG);
      const signals_blocked now;
      file_ = ::open(fresh_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (file_ >= 0)
        std::copy_n(fresh_.c_str(), fresh_.size() + 1, unfinished.begin());
      else if (errno != EEXIST && errno != EINTR)
        throw output_error(name_, errno);
    }
    keep_permissions();
  }
  unfinished_file(const unfinished_file&) = delete;
  unfinished_file& operator=(const unfinished_file&) = delete;
  ~unfinished_file() {
    if (file_ >= 0) ::close(file_);
    const signals_blocked now;
    if (!fresh_.empty()) ::unlink(fresh_.c_str());
    unfinished[0] = '\0';
  }

  int number() const { return file_; }

  void finish() {
    if (::close(std::exchange(file_, -1)) != 0) throw output_error(name_, errno);
    const signals_blocked now;
    if (::rename(fresh_.c_str(), target_.c_str()) != 0) throw output_error(name_, errno);
    fresh_.clear();
    unfinished[0] = '\0';
  }

 private:
  void keep_permissions() const {
    struct stat before {};
    if (::stat(target_.c_str(), &before) != 0) return;
    if (::fchown(file_, before.st_uid, before.st_gid) != 0 && ::fchown(file_, static_cast<uid_t>(-1), before.st_gid) != 0) {
      // Another owner's file in a folder of ours: it becomes ours.
    }
    if (::fchmod(file_, before.st_mode & 07777) != 0) throw output_error(name_, errno);
  }

  std::string target_;
  std::string name_;
  std::string fresh_;
  int file_ = -1;
};

}  // namespace

output_error::output_error(const std::string& name, int cause)
    : std::runtime_error(name + ": cannot be written (" + std::generic_category().message(cause) + "); hint: " + hint_for(cause)) {}

void prepare_output() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  for (const int s : ending_signals) {
    struct sigaction action {};
    sigaction(s, nullptr, &action);
    if (action.sa_handler == SIG_IGN) continue;  // nohup
    action = {};
    action.sa_handler = remove_unfinished;
    sigaction(s, &action, nullptr);
  }
  // A folder takes the place of a closed stream, since nothing can be written to it.
  int fresh = 0;
  do fresh = ::open("/", O_RDONLY | O_DIRECTORY);
  while (fresh >= 0 && fresh <= STDERR_FILENO);
  if (fresh >= 0) ::close(fresh);
}

std::ostream& standard_output() {
  static descriptor_stream stream(STDOUT_FILENO, "standard output", ::isatty(STDOUT_FILENO) == 1);
  return stream;
}

void flush_standard_output() { standard_output().flush(); }

destination::destination(std::string file) : name_(std::move(file)), target_(name_) {
  if (name_.empty()) return;
  struct stat found {};
  struct stat other {};
  if (::stat(name_.c_str(), &found) != 0) {
    if (errno != ENOENT) throw output_error(name_, errno);
    way_ = way::by_renaming;
    target_ = follow_links(name_);
  } else if (S_ISDIR(found.st_mode)) {
    throw output_error(name_, EISDIR);
  } else if (::fstat(STDOUT_FILENO, &other) == 0 && is_same(found, other)) {
    return;
  } else if (!S_ISREG(found.st_mode)) {
    way_ = way::directly;
  } else {
    way_ = way::by_renaming;
    target_ = follow_links(name_);
    // A link of /proc leads to an open file, which may have lost the name that the link tells.
    if (::stat(target_.c_str(), &other) != 0 || !is_same(found, other)) way_ = way::directly;
  }
  const std::string touched = way_ == way::directly ? name_ : folder_of(target_);
  if (::access(touched.c_str(), W_OK) != 0) throw output_error(name_, errno);
  if (S_ISREG(found.st_mode) && ::access(name_.c_str(), W_OK) != 0) throw output_error(name_, errno);
}

void destination::write(const std::function<void(std::ostream&)>& text) const {
  const auto write_to = [&](int file) {
    descriptor_stream out(file, name_);
    text(out);
    out.flush();
  };
  if (way_ == way::standard_output) {
    text(standard_output());
  } else if (way_ == way::directly) {
    descriptor file(::open(name_.c_str(), O_WRONLY | O_TRUNC | O_NOCTTY | O_CLOEXEC));
    if (file.number() < 0) throw output_error(name_, errno);
    write_to(file.number());
    if (!file.close()) throw output_error(name_, errno);
  } else {
    unfinished_file file(target_, name_);
    write_to(file.number());
    file.finish();
  }
}

void destination::write(std::string_view text) const {
  write([text](std::ostream& out) { out << text; });
}

}  // namespace osteon::app
