// What a surface reflects of one light sample where nothing stands in its way.

#if TRIANGLE_LIGHTS || ENVIRONMENT || PUNCTUAL_LIGHTS
struct Reflection {
  vec3 to;  // from where the surface is left towards the light; times `far`, as in LightSample
  float far;
  vec3 radiance;
  bool possible;
  bool behind;  // whether the light comes through the surface
};

// `alone`: no ray will come upon the light by chance, but where the surface is sharp.
Reflection reflectionOf(LightSample light, Surface surface, Frame frame, Bsdf bsdf, vec3 wo,
                        bool alone) {
  vec3 wi = toFrame(frame, light.direction);
#if ROUGH_GLASS
  bool behind = wi.z < 0.0;
  bool possible = light.possible && (!behind || dot(light.direction, surface.geometric) < 0.0);
#else
  bool behind = false;
  bool possible = light.possible && wi.z > 0.0;
#endif
  float pdf = LIGHT_SAMPLE_WORTH * light.pdf;
  float pdf_by_chance = pdfBsdf(bsdf, wo, wi);
  bool by_chance = light.by_chance && (!alone || pdf_by_chance >= PDF_SHARP);
  float weight = by_chance ? powerHeuristic(pdf, pdf_by_chance) : 1.0;
  vec3 radiance = evalBsdf(bsdf, wo, wi) * light.radiance * (weight / light.pdf);
  return Reflection(light.to, light.far, radiance, possible, behind);
}
#endif
