// Shading normals, laid out as layout.h says. Depends on octahedral.glsl.
uniform sampler2D uNormals;
uniform vec2 uNormalsStep;

struct VertexNormals {
  vec3 n0;
  vec3 n1;
  vec3 n2;
};

// The geometric one where the triangle is flat.
VertexNormals fetchNormals(float triangle, vec3 geometric) {
  float texel = triangle * NORMAL_TEXELS;
  vec4 t0 = texture2D(uNormals, texelAddress(texel, uNormalsStep));
  vec4 t1 = texture2D(uNormals, texelAddress(texel + 1.0, uNormalsStep));
  bool flat_shaded = t1.z < 0.5;
  return VertexNormals(flat_shaded ? geometric : decodeOctahedral(t0.xy),
                       flat_shaded ? geometric : decodeOctahedral(t0.zw),
                       flat_shaded ? geometric : decodeOctahedral(t1.xy));
}

// The geometric one where the normals cancel out.
vec3 interpolatedNormal(VertexNormals normals, vec2 uv, vec3 geometric) {
  vec3 normal = interpolate(normals.n0, normals.n1, normals.n2, uv);
  float size = length(normal);
  return size > 1.0e-6 ? normal / size : geometric;
}
