// Ray against the box of a node: the slab test. Depends on node_data.glsl.

// Distances to the planes of a box's two corners.
Corners distancesTo(vec3 packed_corners, GridRay ray) {
  Corners box = unpackCorners(packed_corners);
  return Corners(box.first * ray.inverse + ray.offset, box.second * ray.inverse + ray.offset);
}

// Where a ray is inside a box, as distances; nowhere, if it leaves before it enters.
struct Passage {
  float enter;
  float leave;
};

// By the distances to the planes where the ray enters and leaves, as far as t.
Passage passageOf(vec3 near, vec3 far, float t) {
  return Passage(max(max(near.x, near.y), max(near.z, 0.0)),
                 min(min(far.x, far.y), min(far.z, t)) * BOX_SLACK);
}

bool isMet(Passage passage) {
  return passage.enter <= passage.leave;
}

// For a box whose corners are in no order.
Passage passageThrough(vec3 packed_corners, GridRay ray, float t) {
  Corners planes = distancesTo(packed_corners, ray);
  return passageOf(min(planes.first, planes.second), max(planes.first, planes.second), t);
}
