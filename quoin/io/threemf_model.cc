// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/threemf_model.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <utility>

#include "quoin/io/text_lines.h"
#include "quoin/io/threemf_xml.h"

namespace quoin::io {

namespace {

constexpr std::string_view core_namespace = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
constexpr std::string_view production_namespace = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06";
constexpr std::string_view material_namespace = "http://schemas.microsoft.com/3dmanufacturing/material/2015/02";
constexpr std::array<std::string_view, 6> units = {"micron", "millimeter", "centimeter", "inch", "foot", "meter"};
constexpr std::array<std::string_view, 5> types = {"model", "solidsupport", "support", "surface", "other"};
constexpr std::array<std::string_view, 7> materials = {"basematerials",  "colorgroup",         "texture2d",
                                                       "texture2dgroup", "compositematerials", "multiproperties",
                                                       "pbspecular"};
constexpr std::string_view colors_are_lost = "materials and colours are not kept";

// Sums that stay at the largest number.
std::uint64_t saturated_sum(std::uint64_t a, std::uint64_t b) {
  return a > std::numeric_limits<std::uint64_t>::max() - b ? std::numeric_limits<std::uint64_t>::max() : a + b;
}

std::string_view local_part(std::string_view name) {
  return name.substr(name.rfind(':') + 1);
}

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t at = text.find_first_not_of(" \t\r\n"); at < text.size();
       at = text.find_first_not_of(" \t\r\n", at)) {
    const std::size_t end = std::min(text.find_first_of(" \t\r\n", at), text.size());
    words.push_back(text.substr(at, end - at));
    at = end;
  }
  return words;
}

class ModelReader {
 public:
  ModelReader(std::string_view text, const std::string& part, const std::string& name, const OtherModel& other,
              DrawingNotes& notes, const Context& context)
      : xml_(text, name, context), other_(other), notes_(notes) {
    model_.part = part;
  }

  ThreemfModel run() {
    xml_.root();
    begin();
    xml_.children([&] {
      if (is_core("resources")) {
        xml_.children([&] { is_core("object") ? object() : skip(); });
      } else if (is_core("build")) {
        build();
      } else {
        skip();
      }
    });
    xml_.end();
    return std::move(model_);
  }

 private:
  // The root: its prefix, namespaces, unit, and the extensions that it requires.
  void begin() {
    const XmlTag& tag = xml_.tag();
    if (local_part(tag.name) != "model") xml_.fail("the element 'model' should stand here");
    prefix_ = tag.name.substr(0, tag.name.size() - 5);
    for (const XmlAttribute& a : tag.attributes) {
      if (a.name.starts_with("xmlns:")) namespaces_.emplace(a.name.substr(6), a.value);
      if (a.name == "xmlns") namespaces_.emplace(std::string_view(), a.value);
    }
    const std::string_view of_root = namespace_of(prefix_.substr(0, prefix_.empty() ? 0 : prefix_.size() - 1));
    if (of_root != core_namespace) xml_.fail("the model is not of the namespace " + std::string(core_namespace));
    if (const XmlAttribute* extensions = tag.find("requiredextensions")) {
      for (const std::string_view prefix : words_of(extensions->value)) require_extension(prefix);
    }
    const XmlAttribute* unit = tag.find("unit");
    if (unit == nullptr) return;
    if (std::ranges::find(units, unit->value) == units.end()) xml_.fail(io::quoted(unit->value) + " is no unit of 3MF");
    model_.unit = unit->value;
  }

  std::string_view namespace_of(std::string_view prefix) const {
    const auto found = namespaces_.find(prefix);
    return found == namespaces_.end() ? std::string_view() : found->second;
  }

  void require_extension(std::string_view prefix) const {
    const std::string_view extension = namespace_of(prefix);
    if (extension.empty()) xml_.fail("the required extension " + io::quoted(prefix) + " is not declared");
    const bool is_known =
        extension == core_namespace || extension == production_namespace || extension == material_namespace;
    if (!is_known) {
      xml_.fail("the model requires the extension " + io::quoted(prefix) + " (" +
                std::string(extension.substr(0, 200)) + "), which is not read");
    }
  }

  // Whether the tag that was read last is this element of the core specification.
  bool is_core(std::string_view element) const {
    const std::string_view name = xml_.tag().name;
    if (name.size() != prefix_.size() + element.size() || !name.ends_with(element) || !name.starts_with(prefix_))
      return false;
    if (!prefix_.empty()) return true;
    const XmlAttribute* own = xml_.tag().find("xmlns");
    return own == nullptr || own->value == core_namespace;
  }

  // Passes over an element that is not read, with a note.
  void skip() {
    const std::string_view name = xml_.tag().name;
    if (std::ranges::find(materials, local_part(name)) != materials.end()) {
      notes_.count(colors_are_lost, "");
    } else {
      notes_.count("elements " + io::quoted(name) + " are not read", element_);
    }
    xml_.skip();
  }

  void object() {
    ThreemfObject& object = model_.objects.emplace_back();
    object.id = xml_.index("id");
    if (object.id == 0 || object.id >= 1U << 31) xml_.fail("the id of an object should be from 1 to 2147483647");
    if (model_.by_id.contains(object.id)) xml_.fail("the object " + std::to_string(object.id) + " is there twice");
    element_ = "object " + std::to_string(object.id);
    const XmlTag& tag = xml_.tag();
    if (const XmlAttribute* name = tag.find("name")) object.name = xml_decoded(name->value);
    if (const XmlAttribute* type = tag.find("type")) {
      if (std::ranges::find(types, type->value) == types.end())
        xml_.fail(io::quoted(type->value) + " is no type of objects");
      object.is_left_out = type->value == "support" || type->value == "solidsupport" || type->value == "other";
      if (object.is_left_out) notes_.count("objects of type " + io::quoted(type->value) + " are left out", element_);
    }
    if (tag.find("pid") != nullptr) notes_.count(colors_are_lost, element_);
    const std::size_t line = xml_.line();
    bool has_content = false;
    xml_.children([&] {
      if (!is_core("mesh") && !is_core("components")) return skip();
      if (std::exchange(has_content, true)) xml_.fail("an object has more than one mesh or list of components");
      if (object.is_left_out) return xml_.skip();
      is_core("mesh") ? mesh(object) : components(object);
    });
    if (!has_content) {
      xml_.fail("the object " + std::to_string(object.id) + " of line " + std::to_string(line) +
                " has neither a mesh nor components");
    }
    // Only now, so that no component is the object itself.
    model_.by_id.emplace(object.id, &object);
    element_.clear();
  }

  void mesh(ThreemfObject& object) {
    bool has_vertices = false;
    bool has_triangles = false;
    bool has_colors = false;
    xml_.children([&] {
      if (is_core("vertices")) {
        if (std::exchange(has_vertices, true)) xml_.fail("a mesh has two lists of vertices");
        xml_.children([&] { is_core("vertex") ? vertex(object) : skip(); });
      } else if (is_core("triangles")) {
        if (!has_vertices) xml_.fail("triangles stand before the vertices");
        if (std::exchange(has_triangles, true)) xml_.fail("a mesh has two lists of triangles");
        xml_.children([&] { is_core("triangle") ? triangle(object, has_colors) : skip(); });
      } else {
        skip();
      }
    });
    if (!has_vertices || !has_triangles) xml_.fail("a mesh without vertices or without triangles");
    if (has_colors) notes_.count(colors_are_lost, element_);
    object.vertices.shrink_to_fit();
    object.triangles.shrink_to_fit();
    object.corners = object.vertices.size() + object.triangles.size() / 3;
  }

  void vertex(ThreemfObject& object) {
    if (object.vertices.size() == std::numeric_limits<std::uint32_t>::max()) xml_.fail("too many vertices");
    object.vertices.push_back({xml_.number("x"), xml_.number("y"), xml_.number("z")});
    xml_.skip();
  }

  void triangle(ThreemfObject& object, bool& has_colors) {
    for (const std::string_view corner : {"v1", "v2", "v3"}) {
      const std::uint32_t v = xml_.index(corner);
      if (v >= object.vertices.size()) xml_.fail("vertex " + std::to_string(v) + " is not there");
      object.triangles.push_back(v);
    }
    has_colors |= xml_.tag().attributes.size() > 3 && xml_.tag().find("pid") != nullptr;
    xml_.skip();
  }

  void components(ThreemfObject& object) {
    xml_.children([&] {
      if (!is_core("component")) return skip();
      const ThreemfUse use = read_use();
      const ThreemfObject& part = *use.object;
      object.components.push_back(use);
      object.depth = std::max(object.depth, part.depth + 1);
      if (object.depth > max_nesting) xml_.fail("components nest deeper than " + std::to_string(max_nesting));
      object.uses = saturated_sum(object.uses, part.uses);
      object.corners = saturated_sum(object.corners, part.corners);
      xml_.skip();
    });
    if (object.components.empty()) xml_.fail("a list of components is empty");
  }

  void build() {
    xml_.children([&] {
      if (!is_core("item")) return skip();
      model_.items.push_back(read_use());
      xml_.skip();
    });
  }

  ThreemfUse read_use() {
    ThreemfUse use;
    use.line = xml_.line();
    const ThreemfModel& model = named_model();
    const std::uint32_t id = xml_.index("objectid");
    const auto found = model.by_id.find(id);
    if (found == model.by_id.end()) {
      xml_.fail("the object " + std::to_string(id) + " is not defined " +
                (&model == &model_ ? "before this line" : "in the part " + io::quoted(model.part)));
    }
    use.object = found->second;
    if (const XmlAttribute* transform = xml_.tag().find("transform")) use.place = transformation(*transform);
    return use;
  }

  // Of the part that an attribute of the extension for production names, else this one.
  const ThreemfModel& named_model() const {
    for (const XmlAttribute& a : xml_.tag().attributes) {
      if (!a.name.ends_with(":path")) continue;
      const std::string_view prefix = a.name.substr(0, a.name.size() - 5);
      const XmlAttribute* own = xml_.tag().find("xmlns:" + std::string(prefix));
      if ((own != nullptr ? own->value : namespace_of(prefix)) != production_namespace)
        xml_.fail("the attribute " + io::quoted(a.name) + " belongs to no extension that is read");
      std::string path = xml_decoded(a.value);
      if (!path.starts_with('/')) xml_.fail("the path " + io::quoted(path) + " does not begin with '/'");
      path.erase(0, 1);
      if (is_word(path, lower_case_part())) return model_;
      if (!other_) xml_.fail("only the model that the package names may name objects of other parts");
      const ThreemfModel& named = other_(path);
      if (named.part.empty()) xml_.fail("the part " + io::quoted(path) + " is not there");
      if (named.unit != model_.unit)
        xml_.fail("the part " + io::quoted(path) + " is in another unit, " + named.unit + ", than this one, " +
                  model_.unit);
      return named;
    }
    return model_;
  }

  std::string lower_case_part() const {
    std::string text = model_.part;
    for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return text;
  }

  // Twelve numbers, the rows of the matrix that stands behind a row vector.
  Transformation transformation(const XmlAttribute& attribute) const {
    const std::vector<std::string_view> words = words_of(attribute.value);
    if (words.size() != 12) xml_.fail("a transform of " + std::to_string(words.size()) + " numbers, not 12");
    std::array<std::array<double, 4>, 3> rows{};
    for (std::size_t k = 0; k < 12; ++k) rows[k % 3][k / 3] = xml_.number({attribute.name, words[k], 0});
    Transformation result = Transformation::from_doubles(rows);
    if (result.determinant().sign() == Sign::zero) xml_.fail("the transform flattens space: its determinant is 0");
    return result;
  }

  ThreemfXml xml_;
  const OtherModel& other_;
  DrawingNotes& notes_;
  ThreemfModel model_;
  std::string_view prefix_;  // of the core's elements, with its colon
  std::unordered_map<std::string_view, std::string_view> namespaces_;
  std::string element_;  // for notes
};

}  // namespace

ThreemfModel read_threemf_model(std::string_view text, const std::string& part, const std::string& name,
                                const OtherModel& other, DrawingNotes& notes, const Context& context) {
  return ModelReader(text, part, name, other, notes, context).run();
}

}  // namespace quoin::io
