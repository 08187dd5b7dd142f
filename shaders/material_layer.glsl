// What a surface's BSDF is made of, but for its colour and what lies over it; see layout.h.
struct Layer {
  float metallic;
  float roughness;
  float specular;
  float ior;
  float transmission;
};
