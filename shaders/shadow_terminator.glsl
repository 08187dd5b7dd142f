// Where a ray starts that leaves a triangle with vertex normals, so that the triangle itself does not
// cut off light which the surface that it stands for would get: after Hanika 2021, "Hacking the
// Shadow Terminator", Ray Tracing Gems II, chapter 4.

// How far `point` is to rise along the triangle's normal to lie on the plane that touches the surface at
// a vertex; 0 where it is above that already. Normals that lean by more than 60 degrees speak of
// no curvature, and so the rise is below a quarter of the longest edge. Normals are unit, and on the
// side on which the ray goes on.
float riseToTangent(vec3 point, vec3 vertex, vec3 normal, vec3 geometric) {
  float lean = dot(normal, geometric);
  return lean > 0.5 ? max(dot(vertex - point, normal), 0.0) * lean : 0.0;
}
