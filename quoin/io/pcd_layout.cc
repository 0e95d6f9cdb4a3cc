// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/pcd_layout.h"

#include <algorithm>
#include <optional>

#include "quoin/base/error.h"
#include "quoin/io/text_lines.h"

namespace quoin::io {

namespace {

using Words = std::vector<std::string_view>;

class LayoutReader {
 public:
  LayoutReader(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  PcdLayout run() {
    while (true) {
      const Words words = take_line();
      if (words.empty()) continue;
      if (words[0] == "DATA") {
        read_data(words);
        break;
      }
      take(words);
    }
    check_counts();
    return std::move(layout_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(name_ + ":" + std::to_string(layout_.lines) + ": " + what);
  }

  Words take_line() {
    ++layout_.lines;
    const std::size_t end = bytes_.find('\n', layout_.size);
    if (end == std::string_view::npos) fail("the file ends within the header");
    std::string_view line = bytes_.substr(layout_.size, end - layout_.size);
    layout_.size = end + 1;
    line = line.substr(0, line.find('#'));
    Words words;
    constexpr std::string_view blanks = " \t\r\v\f";
    for (std::size_t i = 0; (i = line.find_first_not_of(blanks, i)) != std::string_view::npos;) {
      const std::size_t word_end = std::min(line.find_first_of(blanks, i), line.size());
      words.push_back(line.substr(i, word_end - i));
      i = word_end;
    }
    return words;
  }

  void take(const Words& words) {
    const std::string_view keyword = words[0];
    if (keyword == "VERSION") {
      if (words.size() != 2 || !(words[1].ends_with(".7") || words[1].ends_with(".6") || words[1].ends_with(".5")))
        fail("only versions .5, .6 and .7 are read");
    } else if (keyword == "FIELDS" || keyword == "COLUMNS") {
      if (!layout_.fields.empty()) fail("FIELDS stands here for the second time");
      for (std::size_t i = 1; i < words.size(); ++i) layout_.fields.push_back({std::string(words[i])});
      if (layout_.fields.empty()) fail("FIELDS names none");
    } else if (keyword == "SIZE") {
      for_fields(words, [&](PcdField& f, std::string_view word) { f.size = size(word); });
    } else if (keyword == "TYPE") {
      for_fields(words, [&](PcdField& f, std::string_view word) { f.type = type(word); });
    } else if (keyword == "COUNT") {
      for_fields(words, [&](PcdField& f, std::string_view word) { f.count = field_count(word); });
    } else if (keyword == "WIDTH" && words.size() == 2) {
      width_ = count(words[1]);
    } else if (keyword == "HEIGHT" && words.size() == 2) {
      height_ = count(words[1]);
    } else if (keyword == "POINTS" && words.size() == 2) {
      points_ = count(words[1]);
    } else if (keyword == "VIEWPOINT" && words.size() == 8) {
      read_viewpoint(words);
    } else {
      fail(quoted(keyword) + " does not belong here");
    }
  }

  template <class Take>
  void for_fields(const Words& words, const Take& take) {
    if (words.size() != layout_.fields.size() + 1) {
      fail(quoted(words[0]) + " has " + std::to_string(words.size() - 1) + " words for " +
           std::to_string(layout_.fields.size()) + " fields");
    }
    for (std::size_t i = 0; i < layout_.fields.size(); ++i) take(layout_.fields[i], words[i + 1]);
  }

  std::uint64_t count(std::string_view word) const {
    if (word.empty() || word.size() > 18 || word.find_first_not_of("0123456789") != std::string_view::npos)
      fail(quoted(word) + " is not a count");
    return std::stoull(std::string(word));
  }

  std::size_t field_count(std::string_view word) const {
    const std::uint64_t value = count(word);
    if (value == 0 || value > bytes_.size()) fail("a count of " + quoted(word) + " does not fit the file's size");
    return value;
  }

  std::size_t size(std::string_view word) const {
    const std::uint64_t value = count(word);
    if (value != 1 && value != 2 && value != 4 && value != 8) fail(quoted(word) + " is no size of numbers");
    return value;
  }

  char type(std::string_view word) const {
    if (word != "I" && word != "U" && word != "F") fail(quoted(word) + " is no type of numbers");
    return word[0];
  }

  void read_viewpoint(const Words& words) {
    for (std::size_t i = 1; i < words.size(); ++i) {
      double value = 0;
      if (!parse_number(words[i], value)) fail(quoted(words[i]) + " is not a finite number");
      layout_.has_viewpoint = layout_.has_viewpoint || value != (i == 4 ? 1 : 0);
    }
  }

  void read_data(const Words& words) {
    if (words.size() == 2 && words[1] == "ascii") return;
    if (words.size() == 2 && words[1] == "binary") {
      layout_.data = PcdLayout::Data::binary;
    } else if (words.size() == 2 && words[1] == "binary_compressed") {
      layout_.data = PcdLayout::Data::compressed;
    } else {
      fail("DATA should be ascii, binary or binary_compressed");
    }
  }

  void check_counts() {
    if (layout_.fields.empty()) fail("the header names no FIELDS");
    for (const PcdField& f : layout_.fields) {
      if (f.type == 'F' && f.size < 4) fail("a floating number has 4 or 8 bytes");
    }
    if (width_ && *width_ != 0 && height_ && *height_ > (std::uint64_t{1} << 62) / *width_)
      fail("WIDTH times HEIGHT does not fit the file's size");
    if (width_ && height_ && points_ && *width_ * *height_ != *points_) fail("POINTS is not WIDTH times HEIGHT");
    if (!points_ && !width_) fail("the header names no number of POINTS");
    layout_.points = points_ ? *points_ : *width_ * height_.value_or(1);
    if (layout_.data != PcdLayout::Data::compressed && layout_.points > bytes_.size())
      fail("a count of " + std::to_string(layout_.points) + " points does not fit the file's size");
  }

  std::string_view bytes_;
  std::string name_;
  PcdLayout layout_;
  std::optional<std::uint64_t> width_;
  std::optional<std::uint64_t> height_;
  std::optional<std::uint64_t> points_;
};

}  // namespace

std::size_t PcdLayout::point_size() const {
  std::size_t sum = 0;
  for (const PcdField& f : fields) sum += f.bytes();
  return sum;
}

PcdLayout read_pcd_layout(std::string_view bytes, const std::string& name) {
  return LayoutReader(bytes, name).run();
}

}  // namespace quoin::io
