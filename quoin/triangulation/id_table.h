// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace quoin {

/// Ids by what they stand for, of which the table knows the hash alone: 64 bits that should be spread evenly. All steps
/// O(1) expected on average. 8 to 16 bytes for each id.
class IdTable {
 public:
  static constexpr std::uint32_t none = 0xFFFFFFFF;

  /// Room for one more, with the hashes of all that are there. Where it throws, nothing has changed.
  template <class HashOf>
  void reserve_one(const HashOf& hash_of) {
    if (places_.size() >= 2 * (count_ + 1)) return;
    IdTable larger;
    larger.places_.resize(places_.empty() ? 16 : 2 * places_.size(), none);
    for (const std::uint32_t id : places_) {
      if (id != none) larger.put(id, hash_of(id));
    }
    *this = std::move(larger);
  }
  /// Takes no memory after `reserve_one`.
  void put(std::uint32_t id, std::uint64_t hash) {
    std::size_t at = place(hash);
    while (places_[at] != none) at = after(at);
    places_[at] = id;
    ++count_;
  }
  /// An id of this hash that is the one, or `none`.
  template <class IsIt>
  std::uint32_t find(std::uint64_t hash, const IsIt& is_it) const {
    if (places_.empty()) return none;
    for (std::size_t at = place(hash); places_[at] != none; at = after(at)) {
      if (is_it(places_[at])) return places_[at];
    }
    return none;
  }
  /// Of an id that is there.
  template <class HashOf>
  void take(std::uint32_t id, const HashOf& hash_of) {
    std::size_t hole = place(hash_of(id));
    while (places_[hole] != id) hole = after(hole);
    // Those that follow move back, if they were not put there for want of a place before the hole.
    for (std::size_t at = after(hole); places_[at] != none; at = after(at)) {
      const std::size_t wanted = place(hash_of(places_[at]));
      if (((at - wanted) & last()) < ((at - hole) & last())) continue;
      places_[hole] = places_[at];
      hole = at;
    }
    places_[hole] = none;
    --count_;
  }

 private:
  std::size_t last() const { return places_.size() - 1; }
  std::size_t place(std::uint64_t hash) const { return static_cast<std::size_t>(hash) & last(); }
  std::size_t after(std::size_t at) const { return (at + 1) & last(); }

  std::vector<std::uint32_t> places_;  ///< a power of two of them, half of them free or more
  std::size_t count_ = 0;
};

}  // namespace quoin
