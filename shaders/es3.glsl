// What ES 3.0's language calls otherwise, so that the other files serve both.
#define texture2D texture
#define gl_FragColor fragmentColor
layout(location = 0) out highp vec4 fragmentColor;
