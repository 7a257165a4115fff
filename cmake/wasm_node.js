// emscripten 3.1.6 takes a global fetch for that of a browser, which reads no file. Node has had
// one since version 18.
var fetch;
