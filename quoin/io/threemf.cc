// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "quoin/base/error.h"
#include "quoin/io/placement.h"
#include "quoin/io/readers.h"
#include "quoin/io/text_lines.h"
#include "quoin/io/threemf_model.h"
#include "quoin/io/threemf_relationships.h"
#include "quoin/io/zip_archive.h"

namespace quoin::io {

namespace {

constexpr std::string_view relationships_path = "_rels/.rels";
constexpr std::string_view usual_path = "3D/3dmodel.model";
constexpr std::uint64_t bytes_of_use = 1024;  // roughly, with its transform while it is placed

std::uint64_t saturated_product(std::uint64_t a, std::uint64_t b) {
  return b != 0 && a > std::numeric_limits<std::uint64_t>::max() / b ? std::numeric_limits<std::uint64_t>::max()
                                                                     : a * b;
}

// The parts of a package that hold models, each read once.
class Package {
 public:
  Package(std::string_view bytes, const std::string& name, const Context& context)
      : archive_(bytes, name), name_(name), context_(context) {}

  ThreemfModel root(DrawingNotes& notes, std::vector<std::string>& warnings) {
    const std::string path = root_path(warnings);
    const std::optional<UnpackedPart> part = archive_.read(path, context_);
    if (!part) throw InputError(name_ + ": a zip archive, but no 3MF file: it has no part " + io::quoted(path));
    const OtherModel other = [&](const std::string& named) -> const ThreemfModel& { return model(named, notes); };
    return read_threemf_model(part->text(), part->name, name_ + ": " + part->name, other, notes, context_);
  }

  const std::map<std::string, ThreemfModel>& others() const { return others_; }

 private:
  std::string root_path(std::vector<std::string>& warnings) {
    const std::optional<UnpackedPart> part = archive_.read(std::string(relationships_path), context_);
    if (!part) {
      warnings.push_back(
          "the part '_rels/.rels', which tells where the model is, is missing: taken is '3D/3dmodel.model'");
      return std::string(usual_path);
    }
    const std::optional<std::string> path = threemf_model_path(part->text(), name_ + ": " + part->name, context_);
    if (!path) {
      throw InputError(name_ +
                       ": a zip archive, but no 3MF file: '_rels/.rels' names no 3D model, as '3D/3dmodel.model' is");
    }
    return *path;
  }

  // Without a name where there is no such part.
  const ThreemfModel& model(const std::string& path, DrawingNotes& notes) {
    const auto [place, is_new] = others_.try_emplace(path);
    if (!is_new) return place->second;
    const std::optional<UnpackedPart> part = archive_.read(path, context_);
    if (part)
      place->second = read_threemf_model(part->text(), part->name, name_ + ": " + part->name, {}, notes, context_);
    return place->second;
  }

  ZipArchive archive_;
  const std::string& name_;
  const Context& context_;
  std::map<std::string, ThreemfModel> others_;
};

// Gives names that were given before a number.
class DifferentNames {
 public:
  std::string name(const ThreemfObject& object) {
    const std::string own = object.name.empty() ? "object " + std::to_string(object.id) : object.name;
    std::string result = own;
    for (std::size_t& count = last_[own]; !given_.insert(result).second;) {
      count = count == 0 ? 2 : count + 1;
      result = own + " " + std::to_string(count);
    }
    return result;
  }

 private:
  std::set<std::string> given_;
  std::map<std::string, std::size_t> last_;
};

// Puts what the build names into one mesh.
class Builder {
 public:
  Builder(MeshFile& file, std::string name, const Context& context)
      : file_(file), name_(std::move(name)), context_(context) {}

  void run(const ThreemfModel& model) {
    require_room(model);
    DifferentNames names;
    for (const ThreemfUse& item : model.items) {
      item_ = names.name(*item.object);
      item_line_ = item.line;
      meshes_ = {};
      add(*item.object, item.place.value_or(Transformation()));
    }
    const bool is_anonymous =
        model.items.size() == 1 && file_.groups.size() == 1 && model.items[0].object->name.empty();
    if (is_anonymous) file_.groups.clear();
    if (model.items.size() == 1) file_.mesh.name = model.items[0].object->name;
  }

  const std::set<const ThreemfObject*>& used() const { return used_; }
  const RoundingCount& rounding() const { return rounding_; }

 private:
  // Components may name an object many times over, so that a small file can stand for a large mesh.
  void require_room(const ThreemfModel& model) const {
    std::uint64_t bytes = 0;
    for (const ThreemfUse& item : model.items) {
      const std::uint64_t of_uses = saturated_product(item.object->uses, bytes_of_use + item.object->name.size());
      const std::uint64_t of_corners = saturated_product(item.object->corners, 24);
      if (of_uses > max_unpacked_bytes || of_corners > max_unpacked_bytes) fail(item.line, too_large);
      bytes += of_uses + of_corners;
      if (bytes > max_unpacked_bytes) fail(item.line, too_large);
    }
  }

  void add(const ThreemfObject& object, const Transformation& place) {
    used_.insert(&object);
    if (object.is_left_out) return;
    for (const ThreemfUse& use : object.components) {
      context_.poll();
      add(*use.object, use.place ? place * *use.place : place);
    }
    if (object.components.empty()) add_mesh(object, Placement(place));
  }

  void add_mesh(const ThreemfObject& object, const Placement& placement) {
    Mesh& mesh = file_.mesh;
    file_.groups.push_back({item_, meshes_.name(object), mesh.face_count()});
    const std::size_t first = mesh.vertices.size();
    if (first + object.vertices.size() > std::numeric_limits<std::uint32_t>::max()) fail(item_line_, too_large);
    for (const Point3& p : object.vertices) {
      if (mesh.vertices.size() % 256 == 0) context_.poll();
      const Point3 image = placement.image(p, rounding_);
      if (!std::isfinite(image.x) || !std::isfinite(image.y) || !std::isfinite(image.z))
        fail(item_line_, "the transforms of the item move a vertex beyond the largest double");
      mesh.vertices.push_back(image);
    }
    for (std::size_t t = 0; t < object.triangles.size(); t += 3) {
      if (t % 4096 == 0) context_.poll();
      const std::size_t second = placement.is_mirror() ? 2 : 1;
      for (const std::size_t corner : {std::size_t{0}, second, 3 - second})
        mesh.corners.push_back(static_cast<std::uint32_t>(first + object.triangles[t + corner]));
      mesh.face_begin.push_back(mesh.corners.size());
    }
  }

  [[noreturn]] void fail(std::size_t line, std::string_view what) const { fail_in_text(name_, line, "", what); }

  static constexpr std::string_view too_large = "the build stands for a mesh of more than 4 GB";

  MeshFile& file_;
  std::string name_;  // of the part
  const Context& context_;
  std::string item_;
  std::size_t item_line_ = 0;
  DifferentNames meshes_;  // of the item
  std::set<const ThreemfObject*> used_;
  RoundingCount rounding_;
};

// Objects that neither the build nor a component of what it names stands for.
void note_unused(const ThreemfModel& model, const std::set<const ThreemfObject*>& used, DrawingNotes& notes) {
  for (const ThreemfObject& object : model.objects) {
    if (!used.contains(&object))
      notes.count("objects that the build does not name are left out", "object " + std::to_string(object.id));
  }
}

}  // namespace

MeshFile read_threemf(std::string_view bytes, const std::string& name, const Context& context) {
  MeshFile file;
  file.report.format = MeshFormat::threemf;
  std::vector<std::string>& warnings = file.report.warnings;
  DrawingNotes notes;
  Package package(bytes, name, context);
  const ThreemfModel model = package.root(notes, warnings);
  if (model.unit != "millimeter")
    warnings.push_back("the unit of coordinates is " + model.unit + ", and they stay as they are");
  if (model.items.empty()) warnings.push_back("the build names no object");
  Builder builder(file, name + ": " + model.part, context);
  builder.run(model);
  note_unused(model, builder.used(), notes);
  for (const auto& [path, other] : package.others()) note_unused(other, builder.used(), notes);
  for (const std::string& note : notes.list()) warnings.push_back(note);
  const RoundingCount& rounding = builder.rounding();
  if (rounding.coordinates > 0) {
    warnings.push_back("coordinates that transforms made are rounded to doubles: " +
                       std::to_string(rounding.coordinates) + ", by at most " + upper_decimals(rounding.largest));
  }
  return file;
}

}  // namespace quoin::io
