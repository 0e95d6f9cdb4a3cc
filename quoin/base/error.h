// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>

namespace quoin {

/// Everything the library throws on purpose.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The caller's data is refused; the message names the file, line, byte or element.
class InputError : public Error {
 public:
  using Error::Error;
};

/// A file could not be opened, read or written; the message names it and says why.
class FileError : public Error {
 public:
  using Error::Error;
};

/// The operation was cancelled or ran out of time through its Context; its inputs are untouched.
class Cancelled : public Error {
 public:
  using Error::Error;
};

/// A promise of the library itself was broken; the message holds what reproduces it.
class InternalError : public Error {
 public:
  using Error::Error;
};

}  // namespace quoin
