// A smooth boundary between two dielectrics: one part of the light is reflected, the rest goes on,
// bent by Snell's law. Depends on fresnel.glsl and mirror.glsl. Directions are in a frame with the
// normal along +z, wo above; `ior` is that of the far side against the near one.

// Below.
vec3 refractedDirection(vec3 wo, float ior) {
  return normalize(vec3(-wo.x / ior, -wo.y / ior, -refractedCosine(wo.z, ior)));
}

// Reflects as often as the boundary does, so that the weight of either is 1.
vec3 sampleGlass(vec3 wo, float ior, float random) {
  bool reflects = random < fresnelDielectric(wo.z, ior);
  return reflects ? mirrorDirection(wo) : refractedDirection(wo, ior);
}
