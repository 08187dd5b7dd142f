// Normals from a picture, in the frame that its own coordinates span on the triangle: x to its right, y
// to its top, z along the shading normal. Depends on texture_data.glsl.

// The shading normal after the picture's. `normal` is unit and on the triangle's front. A triangle
// whose coordinates span no area keeps it.
vec3 mappedNormal(TriangleData data, VertexTexcoords vertices, vec4 texcoords, vec3 normal) {
  TextureUse use = fetchTextureUse(data.material, NORMAL_TEXTURE);
  vec2 at0 = texturePoint(use, vertices.t0);
  vec2 along1 = texturePoint(use, vertices.t1) - at0;
  vec2 along2 = texturePoint(use, vertices.t2) - at0;
  float area = along1.x * along2.y - along1.y * along2.x;
  float side = area < 0.0 ? -1.0 : 1.0;
  vec3 edge1 = data.v1 - data.v0;
  vec3 edge2 = data.v2 - data.v0;
  vec3 right = side * (edge1 * along2.y - edge2 * along1.y);
  vec3 down = side * (edge2 * along1.x - edge1 * along2.x);
  vec3 tangent = right - normal * dot(normal, right);
  float size = length(tangent);
  // The picture may be mirrored on the surface: then its top is on the other side.
  vec3 across = cross(normal, tangent);
  vec3 bitangent = dot(across, down) > 0.0 ? -across : across;
  vec3 bump = lookUpNumbers(data.material, NORMAL_TEXTURE, texcoords).xyz * 2.0 - 1.0;
  vec2 slope = bump.xy * fetchMaterial(data.material, TEXTURE_FACTORS).z;
  vec3 bent = (tangent * slope.x + bitangent * slope.y) / max(size, 1.0e-30) + normal * bump.z;
  float bent_size = length(bent);
  bool spans = use.rectangle.z > 0.0 && abs(area) > 1.0e-12 && size > 0.0 && bent_size > 1.0e-6;
  return spans ? bent / bent_size : normal;
}

// A normal that is turned away from where the path came from would be seen from behind: it is bent
// back until it is seen at a grazing angle.
vec3 turnedToViewer(vec3 normal, vec3 arrived) {
  float facing = -dot(normal, arrived);
  return facing < 0.01 ? normalize(normal - arrived * (0.01 - facing)) : normal;
}
