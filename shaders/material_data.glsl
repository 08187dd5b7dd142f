// The materials' texture, laid out as layout.h says.
uniform sampler2D uMaterials;
uniform vec2 uMaterialsSize;

vec3 fetchBaseColor(float material) {
  return texture2D(uMaterials, texelAddress(material * MATERIAL_TEXELS, uMaterialsSize)).rgb;
}

struct Emission {
  vec3 radiance;
  float density;  // of light samples on the surface, per square metre
  bool both_sides;
};

Emission fetchEmission(float material) {
  float texel = material * MATERIAL_TEXELS;
  bool both_sides = texture2D(uMaterials, texelAddress(texel, uMaterialsSize)).a > 0.5;
  vec4 emission = texture2D(uMaterials, texelAddress(texel + 1.0, uMaterialsSize));
  return Emission(emission.rgb, emission.a, both_sides);
}
