// emscripten 3.1.6 takes a global fetch for a browser's, which reads no file; node has one since 18.
var fetch;
