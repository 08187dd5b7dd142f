// What white rough surfaces reflect in all directions when light is reflected once: a table over
// direction and roughness, made by renderer/passes/gloss_table.cpp. Of microfacets, in x what goes
// with the reflectance at normal incidence, in y with that at the horizon; in z, of the fibres of
// sheen.glsl.
uniform sampler2D uGlossTable;

// Between the texels' centres, by hand: devices need not filter floats.
vec4 fetchAlbedos(float cosine, float roughness) {
  vec2 at = vec2(sqrt(clamp(cosine, 0.0, 1.0)), roughness) * (GLOSS_TABLE_SIZE - 1.0);
  vec2 low = min(floor(at), GLOSS_TABLE_SIZE - 2.0);
  vec2 part = at - low;
  vec2 first = (low + 0.5) / GLOSS_TABLE_SIZE;
  vec2 last = (low + 1.5) / GLOSS_TABLE_SIZE;
  vec4 below = mix(texture2D(uGlossTable, first),
                   texture2D(uGlossTable, vec2(last.x, first.y)), part.x);
  vec4 above = mix(texture2D(uGlossTable, vec2(first.x, last.y)),
                   texture2D(uGlossTable, last), part.x);
  return mix(below, above, part.y);
}

vec2 fetchGlossAlbedo(float cosine, float roughness) {
  vec4 albedos = fetchAlbedos(cosine, roughness);
  return vec2(albedos.x, albedos.y);
}

float fetchSheenAlbedo(float cosine, float roughness) {
  return fetchAlbedos(cosine, roughness).z;
}
