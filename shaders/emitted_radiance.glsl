// What a surface emits towards where the path came from.
vec3 emittedRadiance(HitRecord record, Surface surface) {
#if TRIANGLE_LIGHTS || UNLIT
  Emission emission = fetchEmission(surface.material);
#if EMISSION_TEXTURES
  emission.radiance *= lookUpColor(surface.material, EMISSION_TEXTURE, surface.texcoords).rgb;
#endif
#if UNLIT && VERTEX_COLORS
  float colored = fetchMaterial(surface.material, TEXTURE_FACTORS).w;
  emission.radiance *= mix(vec3(1.0), surface.color.rgb, colored);
#endif
  bool emits = record.back < 0.5 || emission.both_sides;
  return emits ? emission.radiance : vec3(0.0);
#else
  return vec3(0.0);
#endif
}
