// What white rough surfaces reflect in all directions when light is reflected once: a table over
// direction and roughness, made by renderer/passes/gloss_table.cpp, in squares one upon the other. In
// the first, of microfacets, in x what goes with the reflectance at normal incidence, in y with that at
// the horizon; in z, of the fibres of sheen.glsl. In the others, what rough glass of some index of
// refraction reflects and lets through: in x where light enters, in y where it leaves.
uniform sampler2D uGlossTable;
uniform float uGlossTableSquares;

// Between the texels' centres, by hand: devices need not filter floats.
vec4 fetchAlbedos(float square, float cosine, float roughness) {
  vec2 at = vec2(pow(clamp(cosine, 0.0, 1.0), 1.0 / 3.0), pow(roughness, 2.0 / 3.0)) *
            (GLOSS_TABLE_SIZE - 1.0);
  vec2 low = min(floor(at), vec2(GLOSS_TABLE_SIZE - 2.0));
  vec2 part = at - low;
  vec2 texel = vec2(1.0, 1.0 / uGlossTableSquares) / GLOSS_TABLE_SIZE;
  vec2 first = (low + vec2(0.5, 0.5 + square * GLOSS_TABLE_SIZE)) * texel;
  vec2 last = first + texel;
  vec4 below = mix(texture2D(uGlossTable, first),
                   texture2D(uGlossTable, vec2(last.x, first.y)), part.x);
  vec4 above = mix(texture2D(uGlossTable, vec2(first.x, last.y)),
                   texture2D(uGlossTable, last), part.x);
  return mix(below, above, part.y);
}

vec2 fetchGlossAlbedo(float cosine, float roughness) {
  vec4 albedos = fetchAlbedos(0.0, cosine, roughness);
  return vec2(albedos.x, albedos.y);
}

// Fibres have no less roughness than 0.2, so that is where their rows begin.
float fetchSheenAlbedo(float cosine, float roughness) {
  float from_least = clamp((roughness - 0.2) / 0.8, 0.0, 1.0);
  return fetchAlbedos(0.0, cosine, pow(from_least, 1.5)).z;
}

float fetchGlassAlbedo(float square, float cosine, float roughness, bool leaving) {
  vec4 albedos = fetchAlbedos(square, cosine, roughness);
  return leaving ? albedos.y : albedos.x;
}
