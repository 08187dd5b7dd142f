// Fibres that stand up from a surface: Estevez and Kulla 2017, "Production Friendly Microfacet Sheen
// BRDF", the distribution "Charlie" with their fit of its masking. The surface below is scaled by what
// the fibres leave, as KHR_materials_sheen does. Depends on constants.glsl. Directions are in a frame
// with the normal along +z, wo above.

struct Sheen {
  vec3 color;
  float roughness;
  float albedo;  // of white fibres for wo; see gloss_albedo.glsl
};

// Narrower distributions than that of roughness 0.2 are only seen along the surface.
float alphaOf(Sheen sheen) {
  return max(sheen.roughness * sheen.roughness, 0.04);
}

float sheenDistribution(float normal_z, float alpha) {
  float exponent = 1.0 / alpha;
  float sine2 = max(1.0 - normal_z * normal_z, 1.0e-6);
  return (2.0 + exponent) * pow(sine2, 0.5 * exponent) / (2.0 * PI);
}

float sheenFit(float cosine, float alpha) {
  float m = (1.0 - alpha) * (1.0 - alpha);
  float a = mix(21.5473, 25.3245, m);
  float b = mix(3.82987, 3.32435, m);
  float c = mix(0.19823, 0.16801, m);
  float d = mix(-1.97760, -1.27393, m);
  float e = mix(-4.32054, -4.85967, m);
  return a / (1.0 + b * pow(max(cosine, 1.0e-6), c)) + d * cosine + e;
}

float sheenLambda(float cosine, float alpha) {
  float folded = cosine < 0.5 ? cosine : 1.0 - cosine;
  float fit = sheenFit(folded, alpha);
  return exp(cosine < 0.5 ? fit : 2.0 * sheenFit(0.5, alpha) - fit);
}

// Of white fibres, times the cosine of wi.
float evalWhiteSheen(vec3 wo, vec3 wi, float alpha) {
  if (!(wi.z > 0.0)) return 0.0;
  vec3 normal = normalize(wo + wi);
  float masking = 1.0 / (1.0 + sheenLambda(wo.z, alpha) + sheenLambda(wi.z, alpha));
  return sheenDistribution(normal.z, alpha) * masking / (4.0 * max(wo.z, 1.0e-7));
}

// The fit of the masking lets narrow distributions reflect more than all near the horizon: there they
// are scaled down.
vec3 evalSheen(Sheen sheen, vec3 wo, vec3 wi) {
  return sheen.color * (evalWhiteSheen(wo, wi, alphaOf(sheen)) / max(sheen.albedo, 1.0));
}

// What its strongest colour reflects into all directions.
float sheenAlbedo(Sheen sheen) {
  return max(sheen.color.x, max(sheen.color.y, sheen.color.z)) * min(sheen.albedo, 1.0);
}

// Even over the hemisphere: fibres reflect towards the horizon, where a cosine samples little.
float pdfSheen(vec3 wi) {
  return wi.z > 0.0 ? 0.5 / PI : 0.0;
}

vec3 sampleSheen(vec2 random) {
  float z = 1.0 - random.x;
  float radius = sqrt(max(1.0 - z * z, 0.0));
  float angle = 2.0 * PI * random.y;
  return vec3(radius * cos(angle), radius * sin(angle), z);
}
