// Two ways to find the same light: Veach 1997, section 9.2.

// Weight of the sample whose density is `pdf`, against another way with density `other`. The power
// heuristic, written so that large densities do not overflow, and two zeros are not divided.
float powerHeuristic(float pdf, float other) {
  float ratio = other / max(pdf, 1.0e-30);
  return 1.0 / (1.0 + ratio * ratio);
}
