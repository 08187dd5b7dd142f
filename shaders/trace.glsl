// From a hit record, or from the camera, to the next hit record.
struct PathRay {
  vec3 origin;
  vec3 direction;
  vec3 throughput;
  float pdf;     // of the direction, per solid angle
  float cosine;  // of the direction, against the shading normal where it starts
  float random;  // uniform in [0, 1), not used up by choosing the direction
  bool wanted;   // false for a path that has ended
};

#if FROM_CAMERA
PathRay cameraRay(vec2 pixel, vec4 random) {
  vec2 at = pixel - 0.5 + random.xy;
#if ORTHOGRAPHIC
  CameraRay ray = parallelRay(at);
#elif LENS
  CameraRay ray = lensRay(pixel, at);
#else
  CameraRay ray = pinholeRay(at);
#endif
  return PathRay(ray.origin, ray.direction, vec3(1.0), 0.0, 1.0, random.z, true);
}
#endif

#if FROM_RECORD
PathRay scatteredRay(HitRecord record, bool ended, vec4 random) {
  bool wanted = !ended && record.triangle < TRIANGLE_UNKNOWN;
  Surface surface = surfaceOf(record);
  Frame frame = frameAround(surface.normal);
  vec3 wo = outgoing(frame, record.direction);
  BsdfSample bounce = sampleBsdf(fetchBsdf(surface, wo), wo, random.xyz);
  vec3 direction = fromFrame(frame, bounce.wi);
  // A direction that the shading normal allows may lead below the triangle. Where the ray starts
  // above it, it may still pass its edge; otherwise it meets the triangle again, from the same side.
  vec3 origin = leaveSurface(surface.position, surface.geometric, surface.error_scale);
  side_left = 2.0 * record.back - 1.0;
#if GLASS || ROUGH_GLASS
  if (bounce.wi.z < 0.0) {
    origin = passSurface(surface);
    side_left = -side_left;
    wanted = wanted && dot(direction, surface.geometric) < 0.0;
  }
#endif
  return PathRay(origin, direction, record.throughput * bounce.weight, bounce.pdf, bounce.wi.z,
                 bounce.random, wanted);
}

// Weight of emission found by this ray against sampling it as a light.
float emissionWeight(PathRay ray, Hit hit, bool alone) {
  float weight = 1.0;
  vec3 shares = lightShares(alone);
#if TRIANGLE_LIGHTS
  if (hit.triangle < TRIANGLE_UNKNOWN) {
    float density = LIGHT_SAMPLE_WORTH * fetchEmission(hit.material).density * shares.y;
    float cosine = 0.25 * abs(facingOf(hit.volumes)) / hit.area;
    weight = powerHeuristic(ray.pdf, density * hit.t * hit.t / max(cosine, 1.0e-7));
  }
#endif
#if ENVIRONMENT
  if (hit.triangle == TRIANGLE_NONE)
    weight = powerHeuristic(ray.pdf, LIGHT_SAMPLE_WORTH * shares.x *
                                         environmentPdf(ray.direction, ray.cosine));
#endif
  return weight;
}
#endif

// Where the ray comes to.
Hit followRay(inout PathRay ray) {
#if ALPHA
  alpha_random = ray.random;
#endif
  Hit hit = closestHit(ray.origin, ray.direction, ray.wanted);
#if ALPHA
  ray.random = alpha_random;
#endif
  return hit;
}

HitRecord recordOf(PathRay ray, Hit hit, float weight) {
  vec3 throughput = ray.throughput;
#if ABSORPTION
  throughput *= transmittanceAlong(hit);
#endif
  return HitRecord(hit.triangle, facingOf(hit.volumes) > 0.0 ? 1.0 : 0.0, weightsOf(hit.volumes),
                   ray.direction, throughput, weight);
}

// Whether there is anything to add or to follow where the ray has come to.
bool goesOn(PathRay ray, Hit hit) {
  bool goes_on = ray.wanted;
#if !ENVIRONMENT
  goes_on = goes_on && hit.triangle != TRIANGLE_NONE;
#endif
  return goes_on;
}
