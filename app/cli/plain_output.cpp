// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/plain_output.h"

#include <string_view>

#include "sim/core/plain_text.h"

namespace torsio::cli {

PlainOutput::PlainOutput(std::ostream& stream, bool returns)
    : stream_(stream), before_(stream.rdbuf()), returns_(returns) {
  stream_.rdbuf(this);
}

PlainOutput::~PlainOutput() {
  (void)pass(true);
  before_->pubsync();
  stream_.rdbuf(before_);
}

PlainOutput::int_type PlainOutput::overflow(int_type byte) {
  if (!traits_type::eq_int_type(byte, traits_type::eof())) {
    waiting_ += traits_type::to_char_type(byte);
    return pass(false) ? byte : traits_type::eof();
  }
  return traits_type::not_eof(byte);
}

std::streamsize PlainOutput::xsputn(const char* bytes, std::streamsize count) {
  if (returns_ && waiting_.empty() && std::string_view(bytes, static_cast<std::size_t>(count)) == "\r") {
    return before_->sputn(bytes, count);
  }
  waiting_.append(bytes, static_cast<std::size_t>(count));
  return pass(false) ? count : 0;
}

int PlainOutput::sync() {
  return before_->pubsync();
}

/// Hands on what is complete, or all of it; false when it is not taken.
bool PlainOutput::pass(bool all) {
  const std::size_t taken = all ? waiting_.size() : completeBytes(waiting_);
  const std::string out = plainText(std::string_view(waiting_).substr(0, taken));
  waiting_.erase(0, taken);
  return before_->sputn(out.data(), static_cast<std::streamsize>(out.size())) ==
         static_cast<std::streamsize>(out.size());
}

}  // namespace torsio::cli
