#!/usr/bin/env node
// The program gearwright, compiled to WebAssembly: its words, options and exit status are the program's.
"use strict";
require("./cli/gearwright.js");
