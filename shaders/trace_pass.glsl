// The trace pass: one ray of every path. The camera pass is the same without a record to start from.
uniform sampler2D uRecord;
uniform float uDeltaOnly;  // 1: follows only what mirrors and glass send on, else 0

void main() {
  vec2 pixel = pixelCenter();
  vec4 random = samplePoint(pixel);
#if FROM_CAMERA
  PathRay ray = cameraRay(pixel, random);
#else
  vec4 texel = texture2D(uRecord, pictureAddress(pixel));
  PathRay ray = scatteredRay(decodeHitRecord(texel), isEnded(texel), random);
#endif
#if (MIRROR || GLASS) && FROM_RECORD
  ray.wanted = ray.wanted && (uDeltaOnly < 0.5 || ray.pdf >= PDF_DELTA);
#endif
  Hit hit = closestHit(ray.origin, ray.direction, ray.wanted);

#if FROM_CAMERA
  float weight = 1.0;
#else
  float weight = emissionWeight(ray, hit);
#endif
  vec4 rounding = vec4(ray.random, random.w, lowBits(ray.random), lowBits(random.w));
  vec4 record = encodeHitRecord(recordOf(ray, hit, weight), rounding);
  writeTexel(goesOn(ray, hit) ? record : vec4(0.0));
}
