// What ES 3.0's language calls otherwise, so that full_screen.vert serves both.
#define attribute in
