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

// A direction in which the environment's light is looked for.
vec3 sampleEnvironmentDirection(Frame frame, vec4 random) {
  return fromFrame(frame, sampleLambert(random.xy));
}
