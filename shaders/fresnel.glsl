// How much of the light a smooth boundary reflects.

// Schlick 1994, from `normal_incidence` straight on to `grazing` at the horizon.
vec3 fresnelSchlick(vec3 normal_incidence, float grazing, float cosine) {
  float m = clamp(1.0 - cosine, 0.0, 1.0);
  float m2 = m * m;
  return normal_incidence + (vec3(grazing) - normal_incidence) * (m2 * m2 * m);
}

// Of a dielectric, straight on. `ior` is that of one side against the other, either way round.
float normalReflectance(float ior) {
  float ratio = (ior - 1.0) / (ior + 1.0);
  return ratio * ratio;
}

// And, for Schlick's formula, at the horizon: 1, but for boundaries that bend next to nothing and so
// are next to invisible. Reached at an index of refraction of 1.33, that of water.
float grazingReflectance(float ior) {
  return min(50.0 * normalReflectance(ior), 1.0);
}

// The cosine, below the boundary, of a ray that meets it with `cosine`, or 0 where all is
// reflected. `ior`: that of the far side against the near one.
float refractedCosine(float cosine, float ior) {
  // The square in this form keeps its digits where the boundary hardly bends.
  return sqrt(max((ior - 1.0) * (ior + 1.0) + cosine * cosine, 0.0)) / ior;
}

// Of a dielectric, the mean of both polarisations: 1 where all is reflected.
float fresnelDielectric(float cosine, float ior) {
  float refracted = refractedCosine(cosine, ior);
  float parallel = (ior * cosine - refracted) / max(ior * cosine + refracted, 1.0e-30);
  float perpendicular = (cosine - ior * refracted) / max(cosine + ior * refracted, 1.0e-30);
  return min(0.5 * (parallel * parallel + perpendicular * perpendicular), 1.0);
}
