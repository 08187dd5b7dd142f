// The BSDF of scenes with more than Lambert surfaces: glTF's model in lobes. A boundary reflects, and
// of what it lets through a share is scattered by the diffuse base, another goes on through glass; a
// metal only reflects. Dispatches on the scene's effects: lobes that no material has are not there.
// Directions are in a frame with the normal along +z, wo above.

struct Bsdf {
  vec3 base_color;
  float metallic;      // 1: a metal, whose reflectance at normal incidence is the base colour
  float roughness;     // 0: exact mirror
  float specular;      // strength of a dielectric's reflection; 0: none
  float ior;           // of the side behind against that in front
  float transmission;  // share of what enters that goes on through
  vec2 gloss_albedo;   // for wo; see gloss_albedo.glsl
};

float largestOf(vec3 v) {
  return max(v.x, max(v.y, v.z));
}

float alphaOf(Bsdf bsdf) {
  return max(bsdf.roughness * bsdf.roughness, 1.0e-6);
}

float glassOf(Bsdf bsdf) {
  return (1.0 - bsdf.metallic) * bsdf.transmission;
}

// Of the reflecting boundary, but for that of glass: at normal incidence, and at the horizon.
vec3 normalReflectanceOf(Bsdf bsdf) {
  float dielectric = (1.0 - bsdf.metallic) * (1.0 - bsdf.transmission) * bsdf.specular;
  return bsdf.base_color * bsdf.metallic + vec3(dielectric * normalReflectance(bsdf.ior));
}

float grazingReflectanceOf(Bsdf bsdf) {
  return bsdf.metallic + (1.0 - bsdf.metallic) * (1.0 - bsdf.transmission) * bsdf.specular;
}

vec3 reflectedShare(Bsdf bsdf) {
#if GLOSS || MIRROR
  return glossAlbedo(normalReflectanceOf(bsdf), grazingReflectanceOf(bsdf), bsdf.gloss_albedo);
#else
  return vec3(0.0);
#endif
}

// What the boundary lets through to the base and back.
vec3 diffuseReflectance(Bsdf bsdf) {
  float share = (1.0 - bsdf.metallic) * (1.0 - bsdf.transmission) * (1.0 - largestOf(reflectedShare(bsdf)));
  return bsdf.base_color * max(share, 0.0);
}

// How often each lobe is sampled; they add up to 1, or to 0 where nothing is reflected.
struct LobeChances {
  float diffuse;
  float reflection;
  float glass;
};

LobeChances lobeChances(Bsdf bsdf) {
  float diffuse = largestOf(diffuseReflectance(bsdf));
  float reflection = largestOf(reflectedShare(bsdf));
  float glass = 0.0;
#if GLASS || ROUGH_GLASS
  glass = glassOf(bsdf);
#endif
  float scale = 1.0 / max(diffuse + reflection + glass, 1.0e-20);
  return LobeChances(diffuse * scale, reflection * scale, glass * scale);
}

bool isMirror(Bsdf bsdf) {
#if MIRROR || GLASS
  return bsdf.roughness == 0.0;
#else
  return false;
#endif
}

// Whether light from a single direction can be reflected: what light samples are for.
bool spreads(Bsdf bsdf) {
  float spread = largestOf(diffuseReflectance(bsdf));
  if (!isMirror(bsdf)) spread += largestOf(reflectedShare(bsdf)) + glassOf(bsdf);
  return spread > 0.0;
}

// Times the cosine of wi. Without what only single directions have.
vec3 evalBsdf(Bsdf bsdf, vec3 wo, vec3 wi) {
  vec3 f = evalLambert(diffuseReflectance(bsdf)) * max(wi.z, 0.0);
  if (isMirror(bsdf)) return f;
#if GLOSS
  f += evalGloss(wo, wi, alphaOf(bsdf), normalReflectanceOf(bsdf), grazingReflectanceOf(bsdf),
                 bsdf.gloss_albedo);
#endif
#if ROUGH_GLASS
  vec3 tint = wi.z > 0.0 ? vec3(1.0) : bsdf.base_color;
  f += tint * (glassOf(bsdf) * evalRoughGlass(wo, wi, alphaOf(bsdf), bsdf.ior));
#endif
  return f;
}

float pdfBsdf(Bsdf bsdf, vec3 wo, vec3 wi) {
  LobeChances chances = lobeChances(bsdf);
  float pdf = chances.diffuse * pdfLambert(wi);
  if (isMirror(bsdf)) return pdf;
#if GLOSS
  pdf += chances.reflection * pdfGloss(wo, wi, alphaOf(bsdf));
#endif
#if ROUGH_GLASS
  pdf += chances.glass * pdfRoughGlass(wo, wi, alphaOf(bsdf), bsdf.ior);
#endif
  return pdf;
}

// The direction of a mirror or of glass, `chance` being how often its lobe is taken.
BsdfSample deltaSample(vec3 wi, vec3 reflectance, float chance, float random) {
  return BsdfSample(wi, reflectance / max(chance, 1.0e-20), PDF_DELTA, random);
}

BsdfSample sampleBsdf(Bsdf bsdf, vec3 wo, vec3 random) {
  LobeChances chances = lobeChances(bsdf);
  vec2 square = vec2(random.x, random.y);
  float to_reflection = random.z - chances.diffuse;
  float to_glass = to_reflection - chances.reflection;
  vec3 wi = sampleLambert(square);
  float left = random.z / max(chances.diffuse, 1.0e-20);
#if GLOSS || MIRROR
  float left_reflection = clamp(to_reflection / max(chances.reflection, 1.0e-20), 0.0, 0.99999994);
  bool reflects = to_reflection >= 0.0 && to_glass < 0.0;
  if (reflects) left = left_reflection;
#endif
#if MIRROR
  if (reflects && isMirror(bsdf)) {
    vec3 reflectance = fresnelSchlick(normalReflectanceOf(bsdf), grazingReflectanceOf(bsdf), wo.z);
    return deltaSample(mirrorDirection(wo), reflectance, chances.reflection, left);
  }
#endif
#if GLOSS
  if (reflects) wi = sampleGloss(wo, alphaOf(bsdf), square);
#endif
#if GLASS || ROUGH_GLASS
  bool enters = to_glass >= 0.0 && chances.glass > 0.0;
  if (enters) left = clamp(to_glass / chances.glass, 0.0, 0.99999994);
#endif
#if GLASS
  if (enters && isMirror(bsdf)) {
    vec3 through = sampleGlass(wo, bsdf.ior, square.x);
    vec3 tint = through.z > 0.0 ? vec3(1.0) : bsdf.base_color;
    return deltaSample(through, tint * glassOf(bsdf), chances.glass, left);
  }
#endif
#if ROUGH_GLASS
  if (enters) {
    wi = sampleRoughGlass(wo, alphaOf(bsdf), bsdf.ior, square, left);
    left = fract(left * 4096.0);
  }
#endif
  float pdf = pdfBsdf(bsdf, wo, wi);
  if (!(pdf > 0.0)) return BsdfSample(vec3(0.0, 0.0, 1.0), vec3(0.0), 1.0, left);
  return BsdfSample(wi, evalBsdf(bsdf, wo, wi) / pdf, pdf, left);
}
