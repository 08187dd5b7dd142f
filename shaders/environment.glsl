// Light from outside the scene, the same from everywhere. Depends on lambert.glsl.
uniform vec3 uEnvironmentRadiance;

vec3 environmentRadiance(vec3 direction) {
  return uEnvironmentRadiance;
}

// Density per solid angle of a sample towards the environment, in the surface's frame: like the
// Lambert surface itself, since the light is even.
float environmentPdf(vec3 wi) {
  return pdfLambert(wi);
}
