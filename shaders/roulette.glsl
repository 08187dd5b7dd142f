// Russian roulette: of weak paths some end, and those that go on make up for them. What a path still
// brings is worth less than what it costs when it carries less than a quarter of the light.

const float WEAK = 0.25;

uniform float uRoulette;  // 1: weak paths may end before this bounce, else 0

// The probability that a path of this throughput goes on.
float survivalOf(vec3 throughput) {
  float largest = max(throughput.r, max(throughput.g, throughput.b));
  return uRoulette > 0.5 ? clamp(largest / WEAK, LEAST_THROUGHPUT, 1.0) : 1.0;
}

// `random` is uniform in [0, 1), and so again for a path that goes on.
void playRoulette(inout PathRay ray, inout float random) {
  float survival = survivalOf(ray.throughput);
  ray.wanted = ray.wanted && random < survival;
  ray.throughput /= survival;
  random = min(random / survival, 0.99999994);
}
