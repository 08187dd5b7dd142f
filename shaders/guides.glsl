// What the denoiser knows of a pixel beside its light; see guide.glsl. Sums over uGuideRays paths.
uniform sampler2D uLooks;
uniform sampler2D uPlaces;
uniform float uGuideRays;

// Stands for the variance of a pixel that is left as it is.
const float STAYS = -1.0;

struct Guide {
  vec3 color;
  float coverage;  // share of the paths that met a surface
  vec3 normal;     // its mean over these: shorter than 1 where they differ
  float depth;
};

Guide fetchGuide(vec2 at) {
  vec4 look = texture2D(uLooks, at) / uGuideRays;
  vec4 place = texture2D(uPlaces, at) / (uGuideRays * max(look.a, 1.0e-3));
  return Guide(look.rgb, look.a, place.xyz, place.w);
}

// Light is compared and mixed as the share of it that a surface's own colour does not explain, so that
// textures stay sharp. Darker colours explain nothing.
const float LEAST_COLOR = 0.02;

vec3 demodulator(Guide guide) {
  return max(guide.color, vec3(LEAST_COLOR));
}
