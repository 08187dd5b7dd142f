// The materials' texture, laid out as layout.h says.
uniform sampler2D uMaterials;
uniform vec2 uMaterialsStep;

vec4 fetchMaterial(float material, float texel) {
  return texture2D(uMaterials, texelAddress(material * MATERIAL_TEXELS + texel, uMaterialsStep));
}

struct Emission {
  vec3 radiance;
  float density;  // of light samples on the surface, per square metre
  bool both_sides;
};

Emission fetchEmission(float material) {
  vec4 texel = fetchMaterial(material, 1.0);
  return Emission(texel.rgb, abs(texel.a), texel.a < 0.0);
}
