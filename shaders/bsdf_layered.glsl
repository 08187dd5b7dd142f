// The BSDF of scenes with more than Lambert surfaces: glTF's model in lobes. A boundary reflects, and
// of what it lets through a share is scattered by the diffuse base, another goes on through glass; a
// metal only reflects. Fibres may lie over that, and a clear coat over all. Dispatches on the scene's
// effects: lobes that no material has are not there. Depends on bsdf_layers.glsl. Directions are in a
// frame with the normal along +z, wo above.

// Whether light from a single direction can be reflected: what light samples are for.
bool spreads(Bsdf bsdf) {
  float spread = largestOf(diffuseReflectance(bsdf));
  if (!isMirror(bsdf)) spread += largestOf(reflectedShare(bsdf)) + glassOf(bsdf);
#if SHEEN
  spread += largestOf(bsdf.sheen.color);
#endif
#if CLEARCOAT
  if (!isSmooth(bsdf.coat)) spread += bsdf.coat.strength;
#endif
  return spread > 0.0;
}

#if ROUGH_GLASS
// Through a rough boundary, and its reflection.
float evalRoughPassage(Bsdf bsdf, vec3 wo, vec3 wi) {
#if THIN_WALLS
  if (bsdf.thin > 0.5)
    return evalThinWall(wo, wi, alphaOf(bsdf), bsdf.ior, bsdf.gloss_albedo.x + bsdf.gloss_albedo.y);
#endif
  return evalRoughGlass(wo, wi, alphaOf(bsdf), bsdf.ior, bsdf.glass_albedo);
}

float pdfRoughPassage(Bsdf bsdf, vec3 wo, vec3 wi) {
#if THIN_WALLS
  if (bsdf.thin > 0.5) return pdfThinWall(wo, wi, alphaOf(bsdf), bsdf.ior);
#endif
  return pdfRoughGlass(wo, wi, alphaOf(bsdf), bsdf.ior);
}

vec3 sampleRoughPassage(Bsdf bsdf, vec3 wo, vec2 random, float choice) {
#if THIN_WALLS
  if (bsdf.thin > 0.5) return sampleThinWall(wo, alphaOf(bsdf), bsdf.ior, random, choice);
#endif
  return sampleRoughGlass(wo, alphaOf(bsdf), bsdf.ior, random, choice);
}
#endif

#if GLASS
vec3 sampleSmoothPassage(Bsdf bsdf, vec3 wo, float random) {
#if THIN_WALLS
  if (bsdf.thin > 0.5) return sampleThinPane(wo, bsdf.ior, random);
#endif
  return sampleGlass(wo, bsdf.ior, random);
}
#endif

// Times the cosine of wi. Without what only single directions have.
vec3 evalBsdf(Bsdf bsdf, vec3 wo, vec3 wi) {
  vec3 f = evalLambert(diffuseReflectance(bsdf)) * max(wi.z, 0.0);
  if (!isMirror(bsdf)) {
#if GLOSS
    f += evalGloss(wo, wi, alphaOf(bsdf), normalReflectanceOf(bsdf), grazingReflectanceOf(bsdf),
                   bsdf.gloss_albedo);
#endif
#if ROUGH_GLASS
    vec3 tint = wi.z > 0.0 ? vec3(1.0) : bsdf.base_color;
    f += tint * (glassOf(bsdf) * evalRoughPassage(bsdf, wo, wi));
#endif
  }
#if SHEEN
  f = f * belowSheen(bsdf) + evalSheen(bsdf.sheen, wo, wi);
#endif
#if CLEARCOAT
  f = f * belowClearcoat(bsdf, wo) + vec3(evalClearcoat(bsdf.coat, wo, wi));
#endif
  return f;
}

float pdfBsdf(Bsdf bsdf, vec3 wo, vec3 wi) {
  LobeChances chances = lobeChances(bsdf, wo);
  float pdf = chances.diffuse * pdfLambert(wi);
  if (!isMirror(bsdf)) {
#if GLOSS
    pdf += chances.reflection * pdfGloss(wo, wi, alphaOf(bsdf));
#endif
#if ROUGH_GLASS
    pdf += chances.glass * pdfRoughPassage(bsdf, wo, wi);
#endif
  }
#if SHEEN
  pdf += chances.sheen * pdfSheen(wi);
#endif
#if CLEARCOAT
  pdf += chances.clearcoat * pdfClearcoat(bsdf.coat, wo, wi);
#endif
  return pdf;
}

// The direction of a mirror or of glass, `chance` being how often its lobe is taken.
BsdfSample deltaSample(vec3 wi, vec3 reflectance, float chance, float random) {
  return BsdfSample(wi, reflectance / max(chance, 1.0e-20), PDF_DELTA, random);
}

BsdfSample sampleBsdf(Bsdf bsdf, vec3 wo, vec3 random) {
  LobeChances chances = lobeChances(bsdf, wo);
  LobeChoice choice = chooseLobe(chances, random.z);
  vec2 square = vec2(random.x, random.y);
  float left = clamp((random.z - choice.from) / max(choice.chance, 1.0e-20), 0.0, 0.99999994);
  vec3 wi = sampleLambert(square);
#if MIRROR
  if (choice.lobe == LOBE_REFLECTION && isMirror(bsdf)) {
    vec3 reflectance = fresnelSchlick(normalReflectanceOf(bsdf), grazingReflectanceOf(bsdf), wo.z);
    return deltaSample(mirrorDirection(wo), reflectance * belowLayers(bsdf, wo), choice.chance, left);
  }
#endif
#if GLOSS
  if (choice.lobe == LOBE_REFLECTION) wi = sampleGloss(wo, alphaOf(bsdf), square);
#endif
#if GLASS
  if (choice.lobe == LOBE_GLASS && isMirror(bsdf)) {
    vec3 through = sampleSmoothPassage(bsdf, wo, square.x);
    vec3 tint = through.z > 0.0 ? vec3(1.0) : bsdf.base_color;
    return deltaSample(through, tint * (glassOf(bsdf) * belowLayers(bsdf, wo)), choice.chance, left);
  }
#endif
#if ROUGH_GLASS
  if (choice.lobe == LOBE_GLASS) {
    wi = sampleRoughPassage(bsdf, wo, square, left);
    left = fract(left * 4096.0);
  }
#endif
#if SHEEN
  if (choice.lobe == LOBE_SHEEN) wi = sampleSheen(square);
#endif
#if CLEARCOAT
  if (choice.lobe == LOBE_CLEARCOAT) {
    wi = sampleClearcoat(bsdf.coat, wo, square);
    if (isSmooth(bsdf.coat))
      return deltaSample(wi, vec3(clearcoatAlbedo(bsdf.coat, wo)), choice.chance, left);
  }
#endif
  float pdf = pdfBsdf(bsdf, wo, wi);
  if (!(pdf > 0.0)) return BsdfSample(vec3(0.0, 0.0, 1.0), vec3(0.0), 1.0, left);
  return BsdfSample(wi, evalBsdf(bsdf, wo, wi) / pdf, min(pdf, 0.1 * PDF_DELTA), left);
}
