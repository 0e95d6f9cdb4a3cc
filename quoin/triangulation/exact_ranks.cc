// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/exact_ranks.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "quoin/base/large_vector.h"

namespace quoin {

namespace {

constexpr std::size_t poll_interval = 256;
constexpr std::size_t few = 8;
constexpr int bits_of_keys = 190;

struct Place {
  std::uint64_t key;  ///< of the lower end, in the order of doubles
  std::uint32_t item;
};

/// Doubles in their order, zeros alike.
std::uint64_t ordered_bits(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x + 0.0);
  return (bits >> 63) != 0 ? ~bits : bits | std::uint64_t{1} << 63;
}

/// By key, equal ones in the order they have: digit by digit, those that do not differ left out.
void sort_places(LargeVector<Place>& places, const Context& context) {
  constexpr int digit_bits = 11;
  constexpr std::size_t digits = std::size_t{1} << digit_bits;
  std::uint64_t all = ~std::uint64_t{0};
  std::uint64_t any = 0;
  for (const Place& place : places) {
    all &= place.key;
    any |= place.key;
  }
  LargeVector<Place> sorted(places.size());
  for (int shift = 0; shift < 64; shift += digit_bits) {
    if (((all ^ any) >> shift) % digits == 0) continue;
    context.poll();
    std::vector<std::size_t> next(digits + 1, 0);
    for (const Place& place : places) ++next[(place.key >> shift) % digits + 1];
    for (std::size_t d = 1; d < digits; ++d) next[d] += next[d - 1];
    for (const Place& place : places) sorted[next[(place.key >> shift) % digits]++] = place;
    std::swap(places, sorted);
  }
}

class Ranking {
 public:
  Ranking(std::span<const Interval> bounds, const std::function<ExactQuotient(std::uint32_t)>& exact,
          const Context& context)
      : bounds_(bounds), exact_(exact), context_(context) {}

  ExactRanks run() {
    result_.rank.resize(bounds_.size());
    LargeVector<Place> places(bounds_.size());
    for (std::uint32_t i = 0; i < bounds_.size(); ++i) places[i] = {ordered_bits(bounds_[i].lower()), i};
    sort_places(places, context_);
    std::vector<std::uint32_t> cluster;
    double end = -std::numeric_limits<double>::infinity();
    for (const Place& place : places) {
      const Interval& bounds = bounds_[place.item];
      if (!cluster.empty() && bounds.lower() > end) {
        finish(cluster);
        cluster.clear();
      }
      end = cluster.empty() ? bounds.upper() : std::max(end, bounds.upper());
      cluster.push_back(place.item);
    }
    finish(cluster);
    return std::move(result_);
  }

 private:
  /// Items that overlap, in the order of the lower ends.
  void finish(std::vector<std::uint32_t>& cluster) {
    if (cluster.size() <= 1) {
      if (!cluster.empty()) add_rank(cluster);
      return;
    }
    const auto is_point = [this](std::uint32_t i) { return bounds_[i].is_point(); };
    if (std::all_of(cluster.begin(), cluster.end(), is_point)) return add_rank(cluster);  // all at one place
    sort(cluster);
  }

  void sort(std::span<std::uint32_t> items) {
    if (items.size() <= few) return sort_exactly(items);
    double largest = 0;
    for (const std::uint32_t i : items) {
      largest = std::max({largest, std::fabs(bounds_[i].lower()), std::fabs(bounds_[i].upper())});
    }
    if (largest == 0) return sort_exactly(items);
    const int shift = bits_of_keys - std::ilogb(std::min(largest, std::numeric_limits<double>::max()));
    std::vector<std::pair<Integer, std::uint32_t>> keys;
    keys.reserve(items.size());
    for (const std::uint32_t i : items) {
      if (keys.size() % poll_interval == 0) context_.poll();
      keys.emplace_back(exact_(i).scaled_floor(shift), i);
    }
    std::sort(keys.begin(), keys.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    context_.poll();
    for (std::size_t i = 0; i < keys.size(); ++i) items[i] = keys[i].second;
    for (std::size_t begin = 0, i = 1; i <= keys.size(); ++i) {
      if (i < keys.size() && keys[i].first == keys[begin].first) continue;
      sort_exactly(items.subspan(begin, i - begin));
      begin = i;
    }
  }

  /// Splits by the number of one of them, drawn from the middle; the larger part is left to the loop.
  void sort_exactly(std::span<std::uint32_t> items) {
    while (items.size() > 1) {
      const ExactQuotient pivot = exact_(items[items.size() / 2]);
      std::size_t below = 0;
      std::size_t above = items.size();
      for (std::size_t i = 0; i < above;) {
        if (++calls_ % poll_interval == 0) context_.poll();
        const Sign sign = compare(exact_(items[i]), pivot);
        if (sign == Sign::negative) {
          std::swap(items[below++], items[i++]);
        } else if (sign == Sign::positive) {
          std::swap(items[--above], items[i]);
        } else {
          ++i;
        }
      }
      sort_exactly(items.first(below));
      add_rank(items.subspan(below, above - below));
      items = items.subspan(above);
    }
    if (!items.empty()) add_rank(items);
  }

  void add_rank(std::span<const std::uint32_t> items) {
    const auto rank = static_cast<std::uint32_t>(result_.first.size());
    std::uint32_t least = items[0];
    std::uint32_t closest = items[0];
    for (const std::uint32_t i : items) {
      result_.rank[i] = rank;
      least = std::min(least, i);
      const double width = bounds_[i].upper() - bounds_[i].lower();
      const double width_of_closest = bounds_[closest].upper() - bounds_[closest].lower();
      if (width < width_of_closest || (width == width_of_closest && i < closest)) closest = i;
    }
    const Interval& bounds = bounds_[closest];
    const double middle = bounds.lower() / 2 + bounds.upper() / 2;
    const double inside = std::clamp(bounds.is_point() ? bounds.lower() : middle, bounds.lower(), bounds.upper());
    result_.first.push_back(least);
    // The numbers ascend, so the largest middle so far is as close as its own.
    result_.value.push_back(result_.value.empty() ? inside : std::max(inside, result_.value.back()));
  }

  std::span<const Interval> bounds_;
  const std::function<ExactQuotient(std::uint32_t)>& exact_;
  const Context& context_;
  ExactRanks result_;
  std::size_t calls_ = 0;
};

}  // namespace

ExactRanks exact_ranks(std::span<const Interval> bounds, const std::function<ExactQuotient(std::uint32_t)>& exact,
                       const Context& context) {
  return Ranking(bounds, exact, context).run();
}

}  // namespace quoin
