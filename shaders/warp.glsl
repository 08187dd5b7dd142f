// From the unit square to other domains. Depends on constants.glsl.

// Uniform on the unit disk, keeping neighbours together: Shirley and Chiu 1997.
vec2 sampleDisk(vec2 random) {
  vec2 p = 2.0 * random - 1.0;
  bool wide = abs(p.x) > abs(p.y);
  float radius = wide ? p.x : p.y;
  float ratio = (wide ? p.y : p.x) / (radius == 0.0 ? 1.0 : radius);
  float angle = wide ? 0.25 * PI * ratio : 0.5 * PI - 0.25 * PI * ratio;
  return vec2(radius * cos(angle), radius * sin(angle));
}

// Around +z, with density cos(theta) / pi.
vec3 sampleCosineHemisphere(vec2 random) {
  vec2 p = sampleDisk(random);
  return vec3(p.x, p.y, sqrt(max(1.0 - dot(p, p), 0.0)));
}

// Barycentric weights of vertices 1 and 2, uniform over a triangle: Heitz 2019, "A Low-Distortion
// Map Between Triangle and Square".
vec2 sampleTriangle(vec2 random) {
  return random.y > random.x ? vec2(0.5 * random.x, random.y - 0.5 * random.x)
                             : vec2(random.x - 0.5 * random.y, 0.5 * random.y);
}
