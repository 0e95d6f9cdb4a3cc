// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace quoin {

namespace detail {

/// Where the system has them.
void ask_for_huge_pages(void* block, std::size_t bytes) noexcept;

}  // namespace detail

/// Allocates blocks of megabytes on boundaries of huge pages and asks the system for such: touching fresh memory then
/// costs a fraction, and so does reaching memory here and there. Smaller blocks are ordinary.
template <class T>
class LargeAllocator {
 public:
  using value_type = T;
  LargeAllocator() = default;
  template <class U>
  LargeAllocator(const LargeAllocator<U>&) {}  // NOLINT(google-explicit-constructor)

  T* allocate(std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    if (bytes < threshold) return static_cast<T*>(::operator new (bytes, std::align_val_t{alignment}));
    T* const block = static_cast<T*>(::operator new ((bytes + page - 1) / page * page, std::align_val_t{page}));
    detail::ask_for_huge_pages(block, bytes / page * page);  // whole pages only: no more than is asked for
    return block;
  }
  void deallocate(T* block, std::size_t count) {
    if (count * sizeof(T) < threshold) {
      ::operator delete (block, std::align_val_t{alignment});
    } else {
      ::operator delete (block, std::align_val_t{page});
    }
  }
  friend bool operator==(const LargeAllocator&, const LargeAllocator&) { return true; }

 private:
  static constexpr std::size_t alignment = alignof(T) > alignof(std::max_align_t) ? alignof(T)
                                                                                  : alignof(std::max_align_t);
  static constexpr std::size_t page = std::size_t{1} << 21;
  static constexpr std::size_t threshold = 2 * page;
};

/// For arrays that grow to millions of elements.
template <class T>
using LargeVector = std::vector<T, LargeAllocator<T>>;

/// The same, but elements that are made without a value have none, so that the threads that fill them touch the memory
/// first. For types that may be copied as bytes.
template <class T>
class UnsetAllocator : public LargeAllocator<T> {
  // Such objects begin with their memory (implicit lifetime).
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

 public:
  using value_type = T;
  template <class U>
  struct rebind {  // NOLINT(readability-identifier-naming): the name that the standard asks for
    using other = UnsetAllocator<U>;
  };
  UnsetAllocator() = default;
  template <class U>
  UnsetAllocator(const UnsetAllocator<U>&) {}  // NOLINT(google-explicit-constructor)

  template <class U>
  void construct(U* /*place*/) {}
  template <class U, class... Values>
  void construct(U* place, Values&&... values) {
    ::new (static_cast<void*>(place)) U(std::forward<Values>(values)...);
  }
};
template <class T>
using UnsetVector = std::vector<T, UnsetAllocator<T>>;

}  // namespace quoin
