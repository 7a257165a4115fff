// Since version 18, node has a global function fetch. emscripten 3.1.6 would use it as in a browser,
// but it cannot read files. This declaration hides it.
var fetch;
