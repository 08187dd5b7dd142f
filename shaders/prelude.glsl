// What every fragment shader begins with.
//
// Some drivers compute mediump in 16 bits. Samplers without a precision are lowp, gl_FragCoord and
// gl_FragColor are mediump, and a highp local beside them does not help on Mesa. So samplers are
// declared highp, gl_FragCoord is copied before any arithmetic, and what is written passes through
// a sum that the compiler cannot see through: uZero is always 0.
precision highp float;
precision highp int;
precision highp sampler2D;

uniform vec4 uZero;

vec2 pixelCenter() {
  vec2 center = gl_FragCoord.xy;
  return center;
}

// Once, and under no condition: Mesa would choose between the values in 16 bits after all.
void writeTexel(vec4 texel) {
  gl_FragColor = texel + uZero;
}
