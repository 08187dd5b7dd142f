// What ES 3.0's language calls otherwise, so that the other files serve both.
#define texture2D texture
#define gl_FragColor fragmentColor
out highp vec4 fragmentColor;
