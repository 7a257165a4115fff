#!/usr/bin/env node
// Runs the program gearwright, compiled to WebAssembly. Verbs, options and exit status are those of
// the program.
"use strict";
require("./cli/gearwright.js");
