// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// A stream whose beginning can be looked at before it is read.

#include <cstddef>
#include <istream>
#include <streambuf>
#include <string>
#include <string_view>
#include <utility>

#include "osteon/core/error.hpp"

namespace osteon {

/// A text that begins again: the first characters of a stream, and behind them the rest of it. The
/// stream itself is left where the beginning ends, and must live longer.
class rewound {
 public:
  /// Reads the beginning of a stream, at most 64 KiB. `name` is for messages.
  /// *Throws* input_error(unreadable) where nothing can be read.
  rewound(std::istream& in, const std::string& name) : buffer_(beginning_of(in, name), in.rdbuf()), stream_(&buffer_) {}
  rewound(const rewound&) = delete;
  rewound& operator=(const rewound&) = delete;

  /// Returns the beginning of the text; valid until the text is read.
  std::string_view beginning() const { return buffer_.beginning(); }
  /// Returns the whole text, to be read once.
  std::istream& stream() { return stream_; }

 private:
  static constexpr std::size_t chunk = 1U << 16U;

  class buffer : public std::streambuf {
   public:
    buffer(std::string beginning, std::streambuf* rest) : text_(std::move(beginning)), rest_(rest) {
      setg(text_.data(), text_.data(), text_.data() + text_.size());
    }
    std::string_view beginning() const { return text_; }

   protected:
    int_type underflow() override {
      text_.resize(chunk);
      const auto n = rest_->sgetn(text_.data(), static_cast<std::streamsize>(text_.size()));
      setg(text_.data(), text_.data(), text_.data() + n);
      return n > 0 ? traits_type::to_int_type(text_[0]) : traits_type::eof();
    }

   private:
    std::string text_;
    std::streambuf* rest_;
  };

  static std::string beginning_of(std::istream& in, const std::string& name) {
    if (!in.good()) throw input_error(input_fault::unreadable, 0, name + ": the file cannot be read", "check the file");
    std::string text(chunk, '\0');
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(in.gcount()));
    if (in.bad()) throw input_error(input_fault::unreadable, 0, name + ": reading failed", "check the file");
    return text;
  }

  buffer buffer_;
  std::istream stream_;
};

}  // namespace osteon
