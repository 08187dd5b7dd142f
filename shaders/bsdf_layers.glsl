// A surface in layers, and how the light is shared out among them, for bsdf_layered.glsl. Dispatches
// on the scene's effects. Depends on fresnel.glsl and the files of the lobes. Directions are in a
// frame with the normal along +z, wo above.

struct Bsdf {
  vec3 base_color;
  float metallic;      // 1: a metal, whose reflectance at normal incidence is the base colour
  float roughness;     // 0: exact mirror
  float specular;      // strength of a dielectric's reflection; 0: none
  float ior;           // of the side behind against that in front
  float transmission;  // share of what enters that goes on through
  vec2 gloss_albedo;   // for wo; see gloss_albedo.glsl
#if ROUGH_GLASS
  float glass_albedo;  // for wo; see gloss_albedo.glsl
#endif
#if THIN_WALLS
  float thin;  // 1: light passes without being bent, else 0
#endif
#if SHEEN
  Sheen sheen;
#endif
#if CLEARCOAT
  Clearcoat coat;
#endif
};

float largestOf(vec3 v) {
  return max(v.x, max(v.y, v.z));
}

float alphaOf(Bsdf bsdf) {
  return max(bsdf.roughness * bsdf.roughness, 1.0e-6);
}

bool isMirror(Bsdf bsdf) {
#if MIRROR || GLASS
  return bsdf.roughness == 0.0;
#else
  return false;
#endif
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
  float dielectric = (1.0 - bsdf.metallic) * (1.0 - bsdf.transmission) * bsdf.specular;
  return bsdf.metallic + dielectric * grazingReflectance(bsdf.ior);
}

vec3 reflectedShare(Bsdf bsdf) {
#if GLOSS || MIRROR
  return glossAlbedo(normalReflectanceOf(bsdf), grazingReflectanceOf(bsdf), bsdf.gloss_albedo);
#else
  return vec3(0.0);
#endif
}

// What the boundary lets through to the base and back. All of the surface but its glass has it.
vec3 diffuseReflectance(Bsdf bsdf) {
  float base = (1.0 - bsdf.metallic) * (1.0 - bsdf.transmission);
  float boundary = bsdf.metallic + base;
  float passed = 1.0 - largestOf(reflectedShare(bsdf)) / max(boundary, 1.0e-20);
  return bsdf.base_color * (base * max(passed, 0.0));
}

#if SHEEN
// What fibres leave to what they stand on.
float belowSheen(Bsdf bsdf) {
  return 1.0 - sheenAlbedo(bsdf.sheen);
}
#endif

#if CLEARCOAT
float belowClearcoat(Bsdf bsdf, vec3 wo) {
  return 1.0 - clearcoatAlbedo(bsdf.coat, wo);
}
#endif

// What all that lies over the boundary leaves to it.
float belowLayers(Bsdf bsdf, vec3 wo) {
  float share = 1.0;
#if SHEEN
  share *= belowSheen(bsdf);
#endif
#if CLEARCOAT
  share *= belowClearcoat(bsdf, wo);
#endif
  return share;
}

// How often each lobe is sampled; they add up to 1, or to 0 where nothing is reflected.
struct LobeChances {
  float diffuse;
  float reflection;
  float glass;
  float sheen;
  float clearcoat;
};

LobeChances lobeChances(Bsdf bsdf, vec3 wo) {
  float below = belowLayers(bsdf, wo);
  float diffuse = largestOf(diffuseReflectance(bsdf)) * below;
  float reflection = largestOf(reflectedShare(bsdf)) * below;
  float glass = 0.0;
  float sheen = 0.0;
  float clearcoat = 0.0;
#if GLASS || ROUGH_GLASS
  glass = glassOf(bsdf) * below;
#endif
#if SHEEN
  sheen = sheenAlbedo(bsdf.sheen);
#endif
#if CLEARCOAT
  clearcoat = clearcoatAlbedo(bsdf.coat, wo);
  sheen *= 1.0 - clearcoat;
#endif
  float scale = 1.0 / max(diffuse + reflection + glass + sheen + clearcoat, 1.0e-20);
  return LobeChances(diffuse * scale, reflection * scale, glass * scale, sheen * scale,
                     clearcoat * scale);
}

const float LOBE_DIFFUSE = 0.0;
const float LOBE_REFLECTION = 1.0;
const float LOBE_GLASS = 2.0;
const float LOBE_SHEEN = 3.0;
const float LOBE_CLEARCOAT = 4.0;

// A lobe, and the interval of random numbers that choose it.
struct LobeChoice {
  float lobe;
  float from;
  float chance;
};

// The same, or the next lobe where the random number is beyond. The last one with a chance also gets
// what is left to 1 by rounding.
LobeChoice orElse(LobeChoice choice, float random, float lobe, float chance) {
  float end = choice.from + choice.chance;
  if (chance > 0.0 && random >= end) return LobeChoice(lobe, end, chance);
  return choice;
}

LobeChoice chooseLobe(LobeChances chances, float random) {
  LobeChoice choice = LobeChoice(LOBE_DIFFUSE, 0.0, chances.diffuse);
#if GLOSS || MIRROR
  choice = orElse(choice, random, LOBE_REFLECTION, chances.reflection);
#endif
#if GLASS || ROUGH_GLASS
  choice = orElse(choice, random, LOBE_GLASS, chances.glass);
#endif
#if SHEEN
  choice = orElse(choice, random, LOBE_SHEEN, chances.sheen);
#endif
#if CLEARCOAT
  choice = orElse(choice, random, LOBE_CLEARCOAT, chances.clearcoat);
#endif
  return choice;
}
