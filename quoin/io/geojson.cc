// SPDX-License-Identifier: Apache-2.0
//
// GeoJSON, RFC 7946.
#include <algorithm>
#include <array>
#include <iterator>
#include <nlohmann/json.hpp>

#include "quoin/io/drawing_formats.h"
#include "quoin/io/text_lines.h"

namespace quoin::io {

namespace {

using Json = nlohmann::json;

// A place in a document: keys and indices from the root.
struct Step {
  std::string key;        // of an object
  std::size_t index = 0;  // of an array, where the key is empty
  friend bool operator==(const Step&, const Step&) = default;
};

// Goes over characters and leaves word of how far.
class CountingIterator {
 public:
  using iterator_category = std::forward_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, const char** furthest) : at_(at), furthest_(furthest) {}
  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    *furthest_ = ++at_;
    return *this;
  }
  CountingIterator operator++(int) {
    const CountingIterator before = *this;
    ++*this;
    return before;
  }
  friend bool operator==(const CountingIterator& a, const CountingIterator& b) { return a.at_ == b.at_; }

 private:
  const char* at_;
  const char** furthest_;
};

// Reads until a place, if there is one, is reached or the text is no JSON. A second pass, for error messages only.
class Locator : public nlohmann::json_sax<Json> {
 public:
  explicit Locator(const std::vector<Step>* place) : place_(place) {}

  bool null() override { return value(); }
  bool boolean(bool) override { return value(); }
  bool number_integer(number_integer_t) override { return value(); }
  bool number_unsigned(number_unsigned_t) override { return value(); }
  bool number_float(number_float_t, const string_t&) override { return value(); }
  bool string(string_t&) override { return value(); }
  bool binary(binary_t&) override { return value(); }
  bool start_object(std::size_t) override { return open(); }
  bool start_array(std::size_t) override { return open(); }
  bool key(string_t& key) override {
    path_.back().key = key;
    return true;
  }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool parse_error(std::size_t, const std::string&, const Json::exception&) override { return false; }

 private:
  bool is_there() const { return place_ != nullptr && path_ == *place_; }
  bool value() {
    if (is_there()) return false;
    count_item();
    return true;
  }
  bool open() {
    if (is_there()) return false;
    path_.emplace_back();
    return true;
  }
  bool close() {
    path_.pop_back();
    count_item();
    return true;
  }
  void count_item() {
    if (!path_.empty() && path_.back().key.empty()) ++path_.back().index;
  }

  const std::vector<Step>* place_;
  std::vector<Step> path_;
};

class GeoJsonReader {
 public:
  GeoJsonReader(std::string_view text, const std::string& name, const Context& context)
      : text_(TextCursor(text, name).text()), name_(name), context_(context) {}

  Drawing run() {
    refuse_deep_nesting();
    Json root;
    try {
      root = Json::parse(text_.begin(), text_.end());
    } catch (const Json::exception& error) {
      const std::string_view what = error.what();  // "[json.exception.parse_error.101] parse error at ..."
      fail_at(nullptr, "", "not JSON that can be read: " + std::string(what.substr(what.find(']') + 2)));
    }
    const std::string type = type_of(root, "");
    if (type == "FeatureCollection") {
      features(root);
    } else if (type == "Feature") {
      feature(root, 1);
    } else {
      geometry(root, "", 1, nullptr);
    }
    drawing_.notes = notes_.list();
    return std::move(drawing_);
  }

 private:
  // Steps into a member or item for the time of a scope.
  class At {
   public:
    At(GeoJsonReader& reader, Step step) : reader_(reader) { reader_.place_.push_back(std::move(step)); }
    ~At() { reader_.place_.pop_back(); }
    At(const At&) = delete;
    At& operator=(const At&) = delete;

   private:
    GeoJsonReader& reader_;
  };

  [[noreturn]] void fail(std::string_view element, std::string_view what) const { fail_at(&place_, element, what); }

  // Without a place: where the text stops being JSON.
  [[noreturn]] void fail_at(const std::vector<Step>* place, std::string_view element, std::string_view what) const {
    const char* furthest = text_.data();
    Locator locator(place);
    Json::sax_parse(CountingIterator(text_.data(), &furthest), CountingIterator(text_.data() + text_.size(), &furthest),
                    &locator);
    const auto read = static_cast<std::size_t>(furthest - text_.data());
    fail_in_text(name_, line_of(text_, read > 0 ? read - 1 : 0), element, what);
  }

  void refuse_deep_nesting() const {
    std::size_t depth = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < text_.size(); ++i) {
      const char c = text_[i];
      if (in_string) {
        if (c == '\\') ++i;
        in_string = c != '"';
      } else if (c == '"') {
        in_string = true;
      } else if (c == '[' || c == '{') {
        if (++depth > max_nesting)
          fail_in_text(name_, line_of(text_, i), "", "arrays and objects are nested too deeply");
      } else if ((c == ']' || c == '}') && depth > 0) {
        --depth;
      }
    }
  }

  const Json& member(const Json& object, const char* key, const std::string& element) const {
    const auto found = object.find(key);
    if (found == object.end()) fail(element, "'" + std::string(key) + "' is missing");
    return *found;
  }

  std::string type_of(const Json& object, const std::string& element) {
    if (!object.is_object()) fail(element, "an object should stand here");
    const Json& type = member(object, "type", element);
    if (!type.is_string()) fail(element, "'type' is not a string");
    if (object.contains("crs")) notes_.count("reference systems (crs) are not kept", element);
    return type.get<std::string>();
  }

  // Calls item(value, index from 1) for each of a member array.
  template <class Item>
  void each_of(const Json& object, const char* key, const std::string& element, const Item& item) {
    const Json& list = member(object, key, element);
    const At at(*this, {key, 0});
    each(list, element, item);
  }

  template <class Item>
  void each(const Json& list, const std::string& element, const Item& item) {
    if (!list.is_array()) fail(element, "an array should stand here");
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (++polls_ % 256 == 0) context_.poll();
      const At at(*this, {"", i});
      item(list[i], i + 1);
    }
  }

  void features(const Json& collection) {
    each_of(collection, "features", "", [&](const Json& item, std::size_t index) {
      if (type_of(item, "feature " + std::to_string(index)) != "Feature")
        fail("feature " + std::to_string(index), "it is no Feature");
      feature(item, index);
    });
  }

  void feature(const Json& item, std::size_t index) {
    const std::string number = "feature " + std::to_string(index);
    std::string element = number;
    if (const auto id = item.find("id"); id != item.end()) {
      if (id->is_string() && !id->get_ref<const std::string&>().empty()) element = id->get<std::string>();
      if (id->is_number()) element = id->dump();
    }
    layer_.clear();
    if (const auto properties = item.find("properties"); properties != item.end() && properties->is_object()) {
      for (const auto& entry : properties->items()) {
        const bool is_text = entry.value().is_string() && !entry.value().get_ref<const std::string&>().empty();
        if (is_text && entry.key() == "name") {
          element = entry.value().get<std::string>();
        } else if (is_text && entry.key() == "layer") {
          layer_ = entry.value().get<std::string>();
        } else {
          notes_.count("properties other than name and layer are not kept", number);
        }
      }
    }
    const Json& shape = member(item, "geometry", number);
    if (shape.is_null()) return notes_.count("features without geometry add nothing", number);
    const At at(*this, {"geometry", 0});
    geometry(shape, "", index, &element);
  }

  // `whole` names a feature's own geometry, else it is called by prefix, type and index.
  void geometry(const Json& object, const std::string& prefix, std::size_t index, const std::string* whole) {
    const std::string part = whole != nullptr ? *whole : prefix + "geometry " + std::to_string(index);
    const std::string type = type_of(object, part);
    const auto named = [&](const char* kind) {
      return whole != nullptr ? *whole : prefix + kind + " " + std::to_string(index);
    };
    if (type == "GeometryCollection") {
      const std::string element = named("collection");
      return each_of(object, "geometries", element,
                     [&](const Json& item, std::size_t k) { geometry(item, element + ", ", k, nullptr); });
    }
    static constexpr std::array types = {"Point",      "LineString",      "Polygon",
                                         "MultiPoint", "MultiLineString", "MultiPolygon"};
    if (std::ranges::find(types, type) == types.end()) fail(part, io::quoted(type) + " is no type of geometry");
    const Json& coordinates = member(object, "coordinates", part);
    const At at(*this, {"coordinates", 0});
    if (coordinates.is_array() && coordinates.empty()) return notes_.count("empty geometries add nothing", part);
    if (type == "Point") return point(coordinates, named("point"));
    if (type == "LineString") return line(coordinates, named("linestring"));
    if (type == "Polygon") return area(coordinates, named("polygon"));
    if (type == "MultiPoint") return many(coordinates, named("multipoint"), "point", &GeoJsonReader::point);
    if (type == "MultiLineString")
      return many(coordinates, named("multilinestring"), "linestring", &GeoJsonReader::line);
    many(coordinates, named("multipolygon"), "polygon", &GeoJsonReader::area);
  }

  using One = void (GeoJsonReader::*)(const Json& coordinates, const std::string& element);

  void many(const Json& coordinates, const std::string& element, const std::string& kind, One one) {
    each(coordinates, element, [&](const Json& item, std::size_t k) {
      const std::string item_name = element + ", " + kind + " " + std::to_string(k);
      if (item.is_array() && item.empty()) return notes_.count("empty geometries add nothing", item_name);
      (this->*one)(item, item_name);
    });
  }

  void point(const Json& coordinates, const std::string& element) { add(element, position(coordinates, element)); }
  void line(const Json& coordinates, const std::string& element) { add(element, line_string(coordinates, element)); }
  void area(const Json& coordinates, const std::string& element) { add(element, polygon(coordinates, element)); }

  template <class Shape>
  void add(const std::string& element, Shape&& shape) {
    drawing_.elements.push_back({std::forward<Shape>(shape), element, layer_});
  }

  double coordinate(const Json& value, const std::string& element) const {
    if (!value.is_number()) fail(element, "a coordinate is no number");
    return plain(value.get<double>());
  }

  Point2 position(const Json& value, const std::string& element) {
    if (!value.is_array() || value.size() < 2 || value.size() > 4)
      fail(element, "a position is an array of two to four numbers");
    for (std::size_t i = 2; i < value.size(); ++i) coordinate(value[i], element);
    if (value.size() > 2) notes_.count("positions lose what goes beyond x and y", element);
    return {coordinate(value[0], element), coordinate(value[1], element)};
  }

  std::vector<Point2> positions(const Json& value, const std::string& element) {
    std::vector<Point2> points;
    each(value, element, [&](const Json& item, std::size_t) { points.push_back(position(item, element)); });
    return points;
  }

  DrawingPath line_string(const Json& value, const std::string& element) {
    DrawingPath path{positions(value, element), {}, false};
    if (path.points.size() < 2) fail(element, "a LineString has at least two positions");
    if (path.points.size() > 2 && path.points.front() == path.points.back()) close_at_repeated_end(path);
    return path;
  }

  DrawingPolygon polygon(const Json& value, const std::string& element) {
    DrawingPolygon polygon;
    each(value, element, [&](const Json& item, std::size_t index) {
      const std::string ring_name = element + ", ring " + std::to_string(index);
      DrawingPath ring{positions(item, ring_name), {}, false};
      if (!ring.points.empty() && ring.points.front() != ring.points.back())
        fail(ring_name, "the ring is not closed: its last position is not its first");
      if (!ring.points.empty()) close_at_repeated_end(ring);
      if (!can_bound(ring)) fail(ring_name, "the ring has too few positions");
      polygon.rings.push_back(std::move(ring));
    });
    return polygon;
  }

  std::string_view text_;
  const std::string& name_;
  const Context& context_;
  Drawing drawing_;
  DrawingNotes notes_;
  std::vector<Step> place_;
  std::string layer_;
  std::size_t polls_ = 0;
};

}  // namespace

Drawing read_geojson(std::string_view text, const std::string& name, const Context& context) {
  return GeoJsonReader(text, name, context).run();
}

}  // namespace quoin::io
