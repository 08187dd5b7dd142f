// Light from outside the scene, from a picture of all directions: equirectangular, its top row up,
// its centre in the direction +x and +z to the right of it, turned about +y. The same functions as in
// environment.glsl. Texels of the pictures are in rows from the top.
uniform sampler2D uEnvironmentPicture;
uniform vec2 uEnvironmentSize;       // in pixels
uniform sampler2D uEnvironmentCells; // see renderer/passes/environment_map.h
uniform vec2 uEnvironmentCellsSize;
uniform vec3 uEnvironmentScale;
uniform vec2 uEnvironmentRotation;   // cosine and sine of the angle

// In the picture, in [0, 1]^2 from its upper left corner.
vec2 environmentPoint(vec3 direction) {
  float c = uEnvironmentRotation.x;
  float s = uEnvironmentRotation.y;
  float x = c * direction.x - s * direction.z;
  float z = s * direction.x + c * direction.z;
  // The arc tangent of two zeros is not defined. The arc cosine is off by 1e-4 on some devices.
  float radius = sqrt(x * x + z * z);
  float around = radius > 1.0e-12 ? atan(z, x) : 0.0;
  return vec2(0.5 + around / (2.0 * PI), atan(radius, direction.y) / PI);
}

// Around the left and right edges.
vec3 environmentTexel(vec2 texel) {
  float x = texel.x - uEnvironmentSize.x * floor(texel.x / uEnvironmentSize.x);
  float y = clamp(texel.y, 0.0, uEnvironmentSize.y - 1.0);
  return texture2D(uEnvironmentPicture, (vec2(x, y) + 0.5) / uEnvironmentSize).rgb;
}

// Bilinear, by hand: devices need not filter floats.
vec3 environmentAt(vec2 point) {
  vec2 at = point * uEnvironmentSize - 0.5;
  vec2 low = floor(at);
  vec2 part = at - low;
  vec3 above = mix(environmentTexel(low), environmentTexel(low + vec2(1.0, 0.0)), part.x);
  vec3 below = mix(environmentTexel(low + vec2(0.0, 1.0)), environmentTexel(low + 1.0), part.x);
  return uEnvironmentScale * mix(above, below, part.y);
}

vec3 environmentRadiance(vec3 direction) {
  return environmentAt(environmentPoint(direction));
}

vec4 environmentCell(vec2 cell) {
  return texture2D(uEnvironmentCells, (cell + 0.5) / uEnvironmentCellsSize);
}

// Density per solid angle of a sample towards the environment.
float environmentPdf(vec3 direction, float cosine) {
  vec2 cell = floor(environmentPoint(direction) * uEnvironmentCellsSize);
  return environmentCell(min(cell, uEnvironmentCellsSize - 1.0)).z;
}

vec2 environmentCellAt(float index) {
  float row = floor((index + 0.5) / uEnvironmentCellsSize.x);
  return vec2(index - row * uEnvironmentCellsSize.x, row);
}

struct EnvironmentSample {
  vec3 direction;
  vec3 radiance;
  float pdf;  // per solid angle
};

// A direction in which the environment's light is looked for: a cell by the alias table, in which all
// directions are alike. Radiance and density are those of the point that was chosen, since finding
// it again from the direction may end in another cell.
EnvironmentSample sampleEnvironment(Frame frame, vec4 random) {
  float count = uEnvironmentCellsSize.x * uEnvironmentCellsSize.y;
  float index = min(floor(random.z * count), count - 1.0);
  vec4 entry = environmentCell(environmentCellAt(index));
  vec2 cell = environmentCellAt(random.w < entry.x ? index : entry.y);
  vec2 rows = vec2(cell.y, cell.y + 1.0) * (PI / uEnvironmentCellsSize.y);
  float y = mix(cos(rows.x), cos(rows.y), random.y);
  float radius = sqrt(max(1.0 - y * y, 0.0));
  float u = (cell.x + random.x) / uEnvironmentCellsSize.x;
  float x = -radius * cos(2.0 * PI * u);
  float z = -radius * sin(2.0 * PI * u);
  float c = uEnvironmentRotation.x;
  float s = uEnvironmentRotation.y;
  return EnvironmentSample(vec3(c * x + s * z, y, c * z - s * x),
                           environmentAt(vec2(u, atan(radius, y) / PI)), environmentCell(cell).z);
}
