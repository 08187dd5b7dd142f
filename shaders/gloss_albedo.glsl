// What a white rough surface reflects when light is reflected once: a table over direction and
// roughness, made by renderer/passes/gloss_table.cpp. In x what goes with the reflectance at normal
// incidence, in y with that at the horizon.
uniform sampler2D uGlossTable;

// Between the texels' centres, by hand: devices need not filter floats.
vec2 fetchGlossAlbedo(float cosine, float roughness) {
  vec2 at = vec2(sqrt(clamp(cosine, 0.0, 1.0)), roughness) * (GLOSS_TABLE_SIZE - 1.0);
  vec2 low = min(floor(at), GLOSS_TABLE_SIZE - 2.0);
  vec2 part = at - low;
  vec2 address = (low + 0.5) / GLOSS_TABLE_SIZE;
  vec2 texel = vec2(1.0 / GLOSS_TABLE_SIZE, 0.0);
  vec2 below = mix(texture2D(uGlossTable, address).xy,
                   texture2D(uGlossTable, address + texel.xy).xy, part.x);
  vec2 above = mix(texture2D(uGlossTable, address + texel.yx).xy,
                   texture2D(uGlossTable, address + texel.xx).xy, part.x);
  return mix(below, above, part.y);
}
