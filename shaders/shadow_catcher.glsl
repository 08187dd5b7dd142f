// Surfaces of which the camera sees the shadows on them alone. To all other rays they are what they are.
bool isShadowCatcher(HitRecord record) {
  bool hit = record.triangle < TRIANGLE_UNKNOWN;
  float material = fetchTriangle(hit ? record.triangle : 0.0).material;
  return isSeen() && hit && fetchMaterial(material, 5.0).a > 0.5;
}
