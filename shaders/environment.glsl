// Light from outside the scene, the same from everywhere. Depends on lambert.glsl.
uniform vec3 uEnvironmentRadiance;

vec3 environmentRadiance(vec3 direction) {
  return uEnvironmentRadiance;
}

// Density per solid angle of a sample towards the environment, `cosine` being that of the direction
// with the shading normal: like a Lambert surface, since the light is even.
float environmentPdf(vec3 direction, float cosine) {
  return pdfLambert(vec3(0.0, 0.0, cosine));
}

struct EnvironmentSample {
  vec3 direction;
  vec3 radiance;
  float pdf;  // per solid angle
};

// A direction in which the environment's light is looked for.
EnvironmentSample sampleEnvironment(Frame frame, vec4 random) {
  vec3 local = sampleLambert(random.xy);
  return EnvironmentSample(fromFrame(frame, local), uEnvironmentRadiance, pdfLambert(local));
}
