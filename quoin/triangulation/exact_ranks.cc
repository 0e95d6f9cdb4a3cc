// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/exact_ranks.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>

#include "quoin/base/large_vector.h"
#include "quoin/base/polled_resize.h"

namespace quoin {

namespace {

constexpr std::size_t poll_interval = 256;
constexpr std::size_t many_places = 65536;  // what is done between polls where places are only moved
constexpr std::size_t few = 8;
constexpr int bits_of_keys = 190;

struct Place {
  std::uint64_t key;  ///< of the lower end, in the order of doubles
  std::uint32_t item;
  float width;  ///< of the interval over the magnitude of its lower end, or more
};

float width_of(const Interval& bounds) {
  if (bounds.is_point()) return 0;
  const double width = (bounds.upper() - bounds.lower()) / std::fabs(bounds.lower());
  // Twice as much is more than what is rounded anywhere; a width that is no number is endless, too.
  return width < 0x1p100 && std::fabs(bounds.lower()) > 0x1p-900 ? static_cast<float>(2 * width)
                                                                 : std::numeric_limits<float>::infinity();
}

/// Doubles in their order, zeros alike.
std::uint64_t ordered_bits(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x + 0.0);
  return (bits >> 63) != 0 ? ~bits : bits | std::uint64_t{1} << 63;
}
double of_ordered_bits(std::uint64_t key) {
  return std::bit_cast<double>((key >> 63) != 0 ? key & ~(std::uint64_t{1} << 63) : ~key);
}

/// By key: by the leading bits, digit by digit, then those that have these alike.
void sort_places(LargeVector<Place>& places, const Context& context) {
  constexpr int digit_bits = 11;
  constexpr int passes = 3;
  constexpr int first_shift = 64 - passes * digit_bits;
  constexpr std::size_t digits = std::size_t{1} << digit_bits;
  const auto digit = [](const Place& place, int pass) {
    return (place.key >> (first_shift + pass * digit_bits)) % digits;
  };
  std::array<std::vector<std::size_t>, passes> next;
  next.fill(std::vector<std::size_t>(digits + 1, 0));
  const auto for_each_place = [&](const auto& visit) {
    for (std::size_t begin = 0; begin < places.size(); begin += many_places) {
      context.poll();
      for (std::size_t i = begin; i < std::min(places.size(), begin + many_places); ++i) visit(places[i]);
    }
  };
  for_each_place([&](const Place& place) {
    for (int pass = 0; pass < passes; ++pass) ++next[pass][digit(place, pass) + 1];
  });
  LargeVector<Place> sorted;
  resize_and_poll(sorted, places.size(), context);
  for (int pass = 0; pass < passes; ++pass) {
    if (std::find(next[pass].begin(), next[pass].end(), places.size()) != next[pass].end()) continue;  // one digit
    std::partial_sum(next[pass].begin(), next[pass].end(), next[pass].begin());
    for_each_place([&](const Place& place) { sorted[next[pass][digit(place, pass)]++] = place; });
    std::swap(places, sorted);
  }
  const auto is_less = [](const Place& a, const Place& b) { return a.key < b.key; };
  std::size_t steps = 0;
  for (std::size_t begin = 0; begin < places.size();) {
    if (steps++ % many_places == 0) context.poll();
    std::size_t end = begin + 1;
    while (end < places.size() && places[end].key >> first_shift == places[begin].key >> first_shift) ++end;
    const auto from = places.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto to = places.begin() + static_cast<std::ptrdiff_t>(end);
    if (end - begin > 1 && !std::is_sorted(from, to, is_less)) std::sort(from, to, is_less);
    begin = end;
  }
}

class Ranking {
 public:
  Ranking(std::span<const Interval> bounds, const NumberSource& source, const Context& context)
      : bounds_(bounds), source_(source), context_(context) {}

  ExactRanks run() {
    resize_and_poll(result_.rank, bounds_.size(), context_);
    LargeVector<Place> places;
    resize_and_poll(places, bounds_.size(), context_);
    for (std::uint32_t i = 0; i < bounds_.size(); ++i) {
      if (i % many_places == 0) context_.poll();
      places[i] = {ordered_bits(bounds_[i].lower()), i, width_of(bounds_[i])};
    }
    sort_places(places, context_);
    result_.first.reserve(places.size());
    std::vector<std::uint32_t> cluster;
    std::size_t steps = 0;
    for (std::size_t begin = 0; begin < places.size();) {
      if (steps++ % many_places == 0) context_.poll();
      double end = upper_end(places[begin]);
      std::size_t i = begin + 1;
      for (; i < places.size() && of_ordered_bits(places[i].key) <= end; ++i) end = std::max(end, upper_end(places[i]));
      cluster.clear();
      for (std::size_t j = begin; j < i; ++j) cluster.push_back(places[j].item);
      finish(cluster);
      begin = i;
    }
    return std::move(result_);
  }

 private:
  double upper_end(const Place& place) const {
    const double lower = of_ordered_bits(place.key);
    if (place.width == 0) return lower;
    if (std::isinf(place.width)) return bounds_[place.item].upper();
    return lower + static_cast<double>(place.width) * std::fabs(lower);
  }

  /// Items that overlap.
  void finish(std::span<std::uint32_t> cluster) {
    if (cluster.size() == 1) {
      result_.rank[cluster[0]] = static_cast<std::uint32_t>(result_.first.size());
      result_.first.push_back(cluster[0]);
      return;
    }
    const auto is_point = [this](std::uint32_t i) { return bounds_[i].is_point(); };
    if (std::all_of(cluster.begin(), cluster.end(), is_point)) return add_rank(cluster);  // all at one place
    look_closer(cluster);
  }

  void look_closer(std::span<std::uint32_t> items) {
    std::vector<std::pair<Interval, std::uint32_t>> close;
    close.reserve(items.size());
    for (const std::uint32_t i : items) {
      if (close.size() % poll_interval == 0) context_.poll();
      close.emplace_back(bounds_[i].is_narrow() ? bounds_[i] : source_.closer(i), i);
    }
    std::sort(close.begin(), close.end(), [](const auto& a, const auto& b) {
      return a.first.lower() < b.first.lower() || (a.first.lower() == b.first.lower() && a.second < b.second);
    });
    context_.poll();
    for (std::size_t i = 0; i < items.size(); ++i) items[i] = close[i].second;
    for (std::size_t begin = 0; begin < items.size();) {
      double end = close[begin].first.upper();
      double largest = 0;
      std::size_t i = begin;
      for (; i < items.size() && close[i].first.lower() <= end; ++i) {
        end = std::max(end, close[i].first.upper());
        largest = std::max({largest, std::fabs(close[i].first.lower()), std::fabs(close[i].first.upper())});
      }
      sort(items.subspan(begin, i - begin), largest);
      begin = i;
    }
  }

  /// By their leading bits; none is larger in magnitude.
  void sort(std::span<std::uint32_t> items, double largest) {
    if (items.size() <= few) return sort_exactly(items);
    if (largest == 0) return sort_exactly(items);
    const int shift = bits_of_keys - std::ilogb(std::min(largest, std::numeric_limits<double>::max()));
    std::vector<std::pair<Integer, std::uint32_t>> keys;
    keys.reserve(items.size());
    for (const std::uint32_t i : items) {
      if (keys.size() % poll_interval == 0) context_.poll();
      keys.emplace_back(source_.exact(i).scaled_floor(shift), i);
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

  void sort_exactly(std::span<std::uint32_t> items) {
    split(items, 2 * static_cast<int>(std::bit_width(items.size())));
  }

  /// By the number of one of them from the middle; where that has gone wrong too often, by comparisons.
  void split(std::span<std::uint32_t> items, int depth) {
    while (items.size() > 1) {
      if (depth-- == 0) return sort_by_comparisons(items);
      const ExactQuotient pivot = source_.exact(items[items.size() / 2]);
      std::size_t below = 0;
      std::size_t above = items.size();
      for (std::size_t i = 0; i < above;) {
        const Sign sign = compare(exact(items[i]), pivot);
        if (sign == Sign::negative) {
          std::swap(items[below++], items[i++]);
        } else if (sign == Sign::positive) {
          std::swap(items[--above], items[i]);
        } else {
          ++i;
        }
      }
      split(items.first(below), depth);
      add_rank(items.subspan(below, above - below));
      items = items.subspan(above);
    }
    if (!items.empty()) add_rank(items);
  }

  void sort_by_comparisons(std::span<std::uint32_t> items) {
    std::sort(items.begin(), items.end(),
              [this](std::uint32_t a, std::uint32_t b) { return compare(exact(a), exact(b)) == Sign::negative; });
    for (std::size_t begin = 0, i = 1; i <= items.size(); ++i) {
      if (i < items.size() && compare(exact(items[begin]), exact(items[i])) == Sign::zero) continue;
      add_rank(items.subspan(begin, i - begin));
      begin = i;
    }
  }

  ExactQuotient exact(std::uint32_t item) {
    if (++calls_ % poll_interval == 0) context_.poll();
    return source_.exact(item);
  }

  void add_rank(std::span<const std::uint32_t> items) {
    const auto rank = static_cast<std::uint32_t>(result_.first.size());
    std::uint32_t least = items[0];
    for (const std::uint32_t i : items) {
      result_.rank[i] = rank;
      least = std::min(least, i);
    }
    result_.first.push_back(least);
  }

  std::span<const Interval> bounds_;
  const NumberSource& source_;
  const Context& context_;
  ExactRanks result_;
  std::size_t calls_ = 0;
};

}  // namespace

std::vector<std::uint32_t> ExactRanks::order() const {
  std::vector<std::uint32_t> next(first.size() + 1, 0);
  for (const std::uint32_t r : rank) ++next[r + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<std::uint32_t> items(rank.size());
  for (std::uint32_t i = 0; i < rank.size(); ++i) items[next[rank[i]]++] = i;
  return items;
}

ExactRanks exact_ranks(std::span<const Interval> bounds, const NumberSource& source, const Context& context) {
  return Ranking(bounds, source, context).run();
}

}  // namespace quoin
