// A model as glTF has it: parts of one material each, and variants that give other materials.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "assets/generate/geometry/mesh.h"

namespace glimt::assets {

// Rows from the top; colours are sRGB, normals are linear.
struct Picture {
  std::string name;  // of the file, without ".png"
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;  // three bytes a pixel
};

// In the terms of glTF's materials and their extensions; what is left as it is is not written.
struct Material {
  dvec3 base_color{0.8};
  double metallic = 0;
  double roughness = 0.5;
  double clearcoat = 0;
  double clearcoat_roughness = 0;
  dvec3 sheen_color{0};
  double sheen_roughness = 0.5;
  double transmission = 0;         // through a thin wall
  double alpha = 1;                // below 1: lets the rest of the light by
  dvec3 emission{0};               // radiance, of the front
  std::string base_color_picture;  // multiplies base_color
  std::string normal_picture;
};

// Bare metal, and what is not one.
Material metal(const dvec3& color, double roughness);
Material plain(const dvec3& color, double roughness);

struct Part {
  std::string name;
  std::string material;
  Mesh mesh;
  double crease = 35;  // degrees; see surface_normals.h
};

// Takes the place of the materials of the same name.
struct Variant {
  std::string name;
  std::map<std::string, Material> materials;
};

struct Model {
  std::map<std::string, Material> materials;
  std::vector<Variant> variants;  // the first looks as the model without one
  std::vector<Part> parts;
  std::vector<Picture> pictures;

  void add(const std::string& name, const std::string& material, const Mesh& mesh,
           double crease = 35) {
    parts.push_back({name, material, mesh, crease});
  }
};

}  // namespace glimt::assets
