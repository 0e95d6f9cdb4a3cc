// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/test_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <new>

#include "quoin/base/large_vector.h"

namespace quoin::testing {
namespace {

constexpr std::int64_t never = -1;
thread_local std::int64_t before_failure = never;

void count_allocation() {
  if (before_failure == never) return;
  if (before_failure-- == 0) throw std::bad_alloc();
}

/// All forms of new end here, and all of delete in free: sanitizers and libraries pair some that others would mix.
void* allocate(std::size_t bytes) {
  count_allocation();
  void* const block = std::malloc(std::max<std::size_t>(bytes, 1));
  if (block == nullptr) throw std::bad_alloc();
  return block;
}

void* allocate(std::size_t bytes, std::align_val_t alignment) {
  count_allocation();
  const auto step = static_cast<std::size_t>(alignment);
  void* const block = std::aligned_alloc(step, (std::max<std::size_t>(bytes, 1) + step - 1) / step * step);
  if (block == nullptr) throw std::bad_alloc();
  return block;
}

template <class... Alignment>
void* allocate_or_null(std::size_t bytes, Alignment... alignment) noexcept {
  try {
    return allocate(bytes, alignment...);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}

}  // namespace

FailingAllocation::FailingAllocation(std::size_t others) {
  before_failure = static_cast<std::int64_t>(others);
}
FailingAllocation::~FailingAllocation() {
  before_failure = never;
}
bool FailingAllocation::has_failed() const {
  return before_failure == never;
}

TEST(FailingAllocation, FailsOnce) {
  const FailingAllocation failing(1);
  EXPECT_EQ(LargeVector<int>(3).size(), 3U);
  EXPECT_FALSE(failing.has_failed());
  EXPECT_THROW(LargeVector<int>(3), std::bad_alloc);
  EXPECT_TRUE(failing.has_failed());
  EXPECT_EQ(LargeVector<int>(3).size(), 3U);
}

}  // namespace quoin::testing

void* operator new(std::size_t bytes) {
  return quoin::testing::allocate(bytes);
}
void* operator new(std::size_t bytes, std::align_val_t alignment) {
  return quoin::testing::allocate(bytes, alignment);
}
void* operator new(std::size_t bytes, const std::nothrow_t& /*tag*/) noexcept {
  return quoin::testing::allocate_or_null(bytes);
}
void* operator new(std::size_t bytes, std::align_val_t alignment, const std::nothrow_t& /*tag*/) noexcept {
  return quoin::testing::allocate_or_null(bytes, alignment);
}
void operator delete(void* block) noexcept {
  std::free(block);
}
void operator delete(void* block, std::size_t /*bytes*/) noexcept {
  std::free(block);
}
void operator delete(void* block, std::align_val_t /*alignment*/) noexcept {
  std::free(block);
}
void operator delete(void* block, std::size_t /*bytes*/, std::align_val_t /*alignment*/) noexcept {
  std::free(block);
}
void operator delete(void* block, const std::nothrow_t& /*tag*/) noexcept {
  std::free(block);
}
void operator delete(void* block, std::align_val_t /*alignment*/, const std::nothrow_t& /*tag*/) noexcept {
  std::free(block);
}
void* operator new[](std::size_t bytes) {
  return quoin::testing::allocate(bytes);
}
void* operator new[](std::size_t bytes, std::align_val_t alignment) {
  return quoin::testing::allocate(bytes, alignment);
}
void* operator new[](std::size_t bytes, const std::nothrow_t& /*tag*/) noexcept {
  return quoin::testing::allocate_or_null(bytes);
}
void* operator new[](std::size_t bytes, std::align_val_t alignment, const std::nothrow_t& /*tag*/) noexcept {
  return quoin::testing::allocate_or_null(bytes, alignment);
}
void operator delete[](void* block) noexcept {
  std::free(block);
}
void operator delete[](void* block, std::size_t /*bytes*/) noexcept {
  std::free(block);
}
void operator delete[](void* block, std::align_val_t /*alignment*/) noexcept {
  std::free(block);
}
void operator delete[](void* block, std::size_t /*bytes*/, std::align_val_t /*alignment*/) noexcept {
  std::free(block);
}
void operator delete[](void* block, const std::nothrow_t& /*tag*/) noexcept {
  std::free(block);
}
void operator delete[](void* block, std::align_val_t /*alignment*/, const std::nothrow_t& /*tag*/) noexcept {
  std::free(block);
}
