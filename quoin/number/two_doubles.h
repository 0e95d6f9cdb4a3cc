// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "quoin/number/error_free.h"
#include "quoin/number/rational.h"

namespace quoin {

/// The nearest double and what it leaves, if doubles hold that: the value is their sum, exactly.
std::optional<TwoDoubles> as_two_doubles(const Rational& value);

}  // namespace quoin
