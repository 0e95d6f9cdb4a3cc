// SPDX-License-Identifier: Apache-2.0
#include "quoin/solid/placement.h"

#include <gtest/gtest.h>

#include "quoin/base/error.h"
#include "quoin/solid/test_solids.h"

namespace quoin {

using namespace testing;

TEST(Placement, TranslatesExactly) {
  const Solid s = solid(shapes::tetrahedron(1));
  const RationalPoint3 by{Rational(1) / Rational(3), Rational(0x1p-80), Rational(7)};
  const Solid moved = translated(s, by, one_thread);
  EXPECT_EQ(volume_of(moved), volume_of(s));
  expect_same_set(translated(moved, by * Rational(-1), one_thread), s);
  EXPECT_TRUE(translated(Solid(), by, one_thread).is_empty());
  EXPECT_THROW(translated(s, {Rational(Integer(1) << 1100), Rational(0), Rational(0)}, one_thread), InputError);
  EXPECT_THROW(translated(~s, by, one_thread), InputError);
}

TEST(Placement, ReflectionNegatesAllPoints) {
  const Solid s = solid(shapes::tetrahedron(1)) | box({0, 0, 0}, {1, 2, 3});
  const Solid r = reflected(s, {}, one_thread);
  EXPECT_EQ(volume_of(r), volume_of(s));
  EXPECT_TRUE(SolidLocator(r.boundary(), one_thread).locate(Point3{-1, -2, -3}).place == Place::on_vertex);
  EXPECT_FALSE(SolidLocator(r.boundary(), one_thread).locate(Point3{1, 2, 3}).place != Place::out);
  expect_same_set(reflected(r, {}, one_thread), s);
}

}  // namespace quoin
