// How light samples are divided: this share of them goes to the environment, the rest to triangles
// that emit. 1 or 0 where the scene has only one of the two.
uniform float uEnvironmentShare;
