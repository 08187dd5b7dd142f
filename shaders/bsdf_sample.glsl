// What sampling a BSDF gives.
struct BsdfSample {
  vec3 wi;       // unit; below the surface where the light goes through it
  vec3 weight;   // f * cosine / pdf; zero where no light comes from there
  float pdf;     // per solid angle, of wi; PDF_DELTA where only this direction counts
  float random;  // what is left of the random number that chose among the lobes: uniform in [0, 1)
};

// Far above any density, and its square is still a float.
const float PDF_DELTA = 1.0e15;

// What reflects as sharply as this: a light sample in such a direction is worth far more than it
// brings elsewhere, so after the last bounce rays still look for light in these directions.
const float PDF_SHARP = 2.0;
