// SPDX-License-Identifier: Apache-2.0
//
// Path data: SVG 1.1 section 8.3, SVG 2 section 9.3.
#include "quoin/io/svg_path.h"

#include <cmath>
#include <utility>

#include "quoin/io/drawing_arcs.h"
#include "quoin/io/drawing_formats.h"

namespace quoin::io {

void SvgPen::go(double x, double y, bool is_relative) {
  if (is_relative) {
    x_.add(x);
    y_.add(y);
    note_rounding();
  } else {
    x_.set(x);
    y_.set(y);
  }
}

void SvgPen::note_rounding() {
  if (!std::isfinite(x_.value()) || !std::isfinite(y_.value()))
    cursor_.fail(element_, "a relative coordinate leads beyond the largest double");
  const double error = x_.error() + y_.error();
  if (error > 0) notes_.moved("sums of relative coordinates are rounded", element_, error);
}

void SvgPen::move(double x, double y, bool is_relative) {
  end_open();
  go(x, y, is_relative);
  first_x_ = x_;
  first_y_ = y_;
  path_.points.push_back(here());
}

// After Z the next edge begins where the subpath before began.
void SvgPen::begin_subpath() {
  if (path_.points.empty()) path_.points.push_back(here());
}

void SvgPen::line(double x, double y, bool is_relative) {
  begin_subpath();
  go(x, y, is_relative);
  append_edge(path_, 0, here());
}

void SvgPen::horizontal(double x, bool is_relative) {
  begin_subpath();
  if (is_relative) {
    x_.add(x);
    note_rounding();
  } else {
    x_.set(x);
  }
  append_edge(path_, 0, here());
}

void SvgPen::vertical(double y, bool is_relative) {
  begin_subpath();
  if (is_relative) {
    y_.add(y);
    note_rounding();
  } else {
    y_.set(y);
  }
  append_edge(path_, 0, here());
}

void SvgPen::arc(double radius, bool is_large, bool is_positive, double x, double y, bool is_relative) {
  begin_subpath();
  const Point2 start = here();
  go(x, y, is_relative);
  const Point2 end = here();
  if (radius == 0) notes_.count("arcs of radius zero are straight", element_);
  if (radius == 0 || start == end) return append_edge(path_, 0, end);
  const auto bulge = bulge_of_radius(start, end, radius, is_large, is_positive);
  if (!bulge) cursor_.fail(element_, "the arc's radius is too large for its chord");
  if (bulge->radius_change > 0) notes_.moved("radii of arcs are adjusted", element_, bulge->radius_change);
  if (bulge->distance > 0) notes_.moved("arcs are rounded", element_, bulge->distance);
  append_edge(path_, bulge->bulge, end);
}

void SvgPen::close() {
  begin_subpath();
  if (path_.points.size() > 1 && path_.points.front() == path_.points.back()) {
    close_at_repeated_end(path_);
  } else {
    close_with_edge(path_, 0);
  }
  paths_.push_back(std::exchange(path_, {}));
  x_ = first_x_;
  y_ = first_y_;
}

void SvgPen::end_open() {
  if (path_.points.size() == 1) notes_.count("moves that no edge follows add nothing", element_);
  if (path_.points.size() > 1) paths_.push_back(path_);
  path_ = {};
}

std::vector<DrawingPath> SvgPen::take() {
  end_open();
  return std::exchange(paths_, {});
}

namespace {

class PathData {
 public:
  PathData(TextCursor& cursor, const std::string& element, DrawingNotes& notes, const Context& context)
      : cursor_(cursor), element_(element), pen_(cursor, element, notes), context_(context) {}

  std::vector<DrawingPath> run() {
    char command = '\0';
    for (;;) {
      cursor_.skip_space();
      if (cursor_.at_end()) return pen_.take();
      if (++steps_ % 256 == 0) context_.poll();
      const char next = cursor_.peek();
      const bool is_number = (next >= '0' && next <= '9') || next == '.' || next == '+' || next == '-' || next == ',';
      if (!is_number) {
        command = begin_command(command, next);
      } else if (command == '\0' || command == 'Z' || command == 'z') {
        cursor_.fail(element_, "a command should stand here, and " + cursor_.found() + " does");
      } else {
        cursor_.accept(',');
        // Pairs behind a move are lines.
        if (command == 'M') command = 'L';
        if (command == 'm') command = 'l';
      }
      run_command(command);
    }
  }

 private:
  char begin_command(char before, char next) {
    static constexpr std::string_view read = "MmLlHhVvZzAa";
    static constexpr std::string_view curves = "CcSsQqTt";
    if (curves.find(next) != std::string_view::npos)
      cursor_.fail(element_, std::string("command '") + next + "': curves are not supported");
    if (next == '\0' || read.find(next) == std::string_view::npos)
      cursor_.fail(element_, cursor_.found() + " is no command of path data");
    if (before == '\0' && next != 'M' && next != 'm') cursor_.fail(element_, "path data begins with M");
    cursor_.move_to(cursor_.position() + 1);
    return next;
  }

  void run_command(char command) {
    const bool is_relative = command >= 'a';
    switch (command) {
      case 'Z':
      case 'z':
        return pen_.close();
      case 'H':
      case 'h':
        return pen_.horizontal(cursor_.number(element_), is_relative);
      case 'V':
      case 'v':
        return pen_.vertical(cursor_.number(element_), is_relative);
      case 'A':
      case 'a':
        return arc(is_relative);
      default: {
        const double x = cursor_.number(element_);
        cursor_.skip_comma();
        const double y = cursor_.number(element_);
        if (command == 'M' || command == 'm') return pen_.move(x, y, is_relative);
        return pen_.line(x, y, is_relative);
      }
    }
  }

  // The turn of an ellipse's axis means nothing for a circle.
  void arc(bool is_relative) {
    const double rx = number();
    const double ry = number();
    number();
    const bool is_large = flag();
    const bool is_positive = flag();
    const double x = number();
    const double y = cursor_.number(element_);
    if (std::fabs(rx) != std::fabs(ry)) cursor_.fail(element_, "command 'A': elliptical arcs are not supported");
    pen_.arc(std::fabs(rx), is_large, is_positive, x, y, is_relative);
  }

  double number() {
    const double value = cursor_.number(element_);
    cursor_.skip_comma();
    return value;
  }

  bool flag() {
    const char value = cursor_.peek();
    if (value != '0' && value != '1') cursor_.fail(element_, "an arc's flag is 0 or 1, not " + cursor_.found());
    cursor_.move_to(cursor_.position() + 1);
    cursor_.skip_comma();
    return value == '1';
  }

  TextCursor& cursor_;
  const std::string& element_;
  SvgPen pen_;
  const Context& context_;
  std::size_t steps_ = 0;
};

}  // namespace

std::vector<DrawingPath> read_path_data(TextCursor& cursor, const std::string& element, DrawingNotes& notes,
                                        const Context& context) {
  return PathData(cursor, element, notes, context).run();
}

}  // namespace quoin::io
