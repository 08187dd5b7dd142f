// How light samples are divided among the kinds of light that a scene has: shares that sum to one,
// of the environment, of triangles that emit, and of lights without triangles.
uniform vec3 uLightShares;
