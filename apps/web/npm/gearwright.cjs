#!/usr/bin/env node
// Runs the program gearwright, compiled to WebAssembly. It has the same verbs, options and exit statuses as
// the native program.
"use strict";
require("./cli/gearwright.js");
