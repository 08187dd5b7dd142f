// The trace pass: one ray of every path. The camera pass is the same without a record to start from.
uniform float uSharpOnly;  // 1: follows only what leaves a surface in a sharp direction, else 0

void main() {
  vec2 pixel = pixelCenter();
  vec4 random = samplePoint(pixel);
#if FROM_CAMERA
  PathRay ray = cameraRay(pixel, random);
#else
  HitRecord start;
  bool live = readRecord(pixel, start);
  PathRay ray = scatteredRay(start, !live, random);
  bool sharp_only = uSharpOnly > 0.5;
  ray.wanted = ray.wanted && (!sharp_only || ray.pdf >= PDF_SHARP);
#endif
#if SHADOW_CATCHER && FROM_RECORD
  ray.wanted = ray.wanted && !isShadowCatcher(start);
#endif
#if FROM_RECORD
  playRoulette(ray, random.w);
#endif
  Hit hit = followRay(ray);

#if FROM_CAMERA
  float weight = 1.0;
#else
  float weight = emissionWeight(ray, hit, sharp_only);
#endif
  vec4 rounding = vec4(ray.random, random.w, lowBits(ray.random), lowBits(random.w));
  writeRecord(recordOf(ray, hit, weight), goesOn(ray, hit), rounding);
}
