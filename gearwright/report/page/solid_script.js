(function () {
  'use strict';
  // The pair in space, from the bytes of its GLB file: a drag turns the view, the wheel zooms, the
  // slider turns the gears. It is drawn only after changes.
  var vertexSource =
    'attribute vec3 p;attribute vec3 n;uniform mat4 view,model;uniform mat4 project;varying vec3 normal,place;' +
    'void main(){vec4 q=view*model*vec4(p,1.);place=q.xyz;normal=mat3(view)*mat3(model)*n;gl_Position=project*q;}';
  var fragmentSource =
    'precision mediump float;varying vec3 normal,place;uniform vec3 colour;' +
    'void main(){vec3 n=normalize(normal);vec3 e=normalize(-place);float d=abs(dot(n,e));' +
    'vec3 h=normalize(e+vec3(.3,.6,.5));float s=pow(max(dot(n,h),0.),40.);' +
    'gl_FragColor=vec4(pow(colour*(.25+.85*d)+vec3(.25*s),vec3(1./2.2)),1.);}';

  function multiply(a, b) {  // column by column
    var m = new Float32Array(16);
    for (var c = 0; c < 4; ++c)
      for (var r = 0; r < 4; ++r) {
        var sum = 0;
        for (var k = 0; k < 4; ++k) sum += a[4 * k + r] * b[4 * c + k];
        m[4 * c + r] = sum;
      }
    return m;
  }
  function aboutZ(angle) {
    var c = Math.cos(angle), s = Math.sin(angle);
    return [c, s, 0, 0, -s, c, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  }
  function aboutX(angle) {
    var c = Math.cos(angle), s = Math.sin(angle);
    return [1, 0, 0, 0, 0, c, s, 0, 0, -s, c, 0, 0, 0, 0, 1];
  }
  function aboutY(angle) {
    var c = Math.cos(angle), s = Math.sin(angle);
    return [c, 0, -s, 0, 0, 1, 0, 0, s, 0, c, 0, 0, 0, 0, 1];
  }
  function moved(x, y, z) { return [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1]; }
  function perspective(aspect, near, far) {
    var f = 3.2 * Math.min(1, aspect / 1.4);  // a narrow picture also contains the whole pair
    return [f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, (far + near) / (near - far), -1, 0, 0,
            2 * far * near / (near - far), 0];
  }

  // Header, then the JSON chunk and the binary one.
  function parts(base64) {
    var text = atob(base64), bytes = new Uint8Array(text.length);
    for (var i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
    var data = new DataView(bytes.buffer), length = data.getUint32(12, true), json = '';
    for (var j = 0; j < length; ++j) json += String.fromCharCode(bytes[20 + j]);
    var gltf = JSON.parse(json), begin = 28 + length;
    function array(index, type) {
      var accessor = gltf.accessors[index], view = gltf.bufferViews[accessor.bufferView];
      var each = accessor.type === 'VEC3' ? 3 : 1, from = begin + (view.byteOffset || 0);
      return new type(bytes.buffer.slice(from, from + 4 * each * accessor.count));
    }
    return gltf.nodes.map(function (node) {
      var p = gltf.meshes[node.mesh].primitives[0];
      return {place: node.matrix || moved(0, 0, 0), positions: array(p.attributes.POSITION, Float32Array),
              normals: array(p.attributes.NORMAL, Float32Array), indices: array(p.indices, Uint32Array),
              low: gltf.accessors[p.attributes.POSITION].min, high: gltf.accessors[p.attributes.POSITION].max,
              colour: gltf.materials[p.material].pbrMetallicRoughness.baseColorFactor.slice(0, 3)};
    });
  }

  function show(figure) {
    var canvas = figure.querySelector('canvas'), slider = figure.querySelector('input');
    var button = figure.querySelector('button'), output = figure.querySelector('output');
    var gl = canvas.getContext('webgl', {antialias: true, preserveDrawingBuffer: true});
    if (!gl || !gl.getExtension('OES_element_index_uint')) return false;
    function shader(kind, source) {
      var s = gl.createShader(kind);
      gl.shaderSource(s, source);
      gl.compileShader(s);
      return s;
    }
    var program = gl.createProgram();
    gl.attachShader(program, shader(gl.VERTEX_SHADER, vertexSource));
    gl.attachShader(program, shader(gl.FRAGMENT_SHADER, fragmentSource));
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) return false;
    gl.useProgram(program);
    gl.enable(gl.DEPTH_TEST);
    function uniform(name) { return gl.getUniformLocation(program, name); }
    var at = {view: uniform('view'), model: uniform('model'), project: uniform('project'), colour: uniform('colour')};
    function buffer(target, array) {
      var b = gl.createBuffer();
      gl.bindBuffer(target, b);
      gl.bufferData(target, array, gl.STATIC_DRAW);
      return b;
    }
    var low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    var turns = figure.getAttribute('data-turns').split(' ').map(parseFloat);
    var pitch = parseFloat(figure.getAttribute('data-pitch')) * Math.PI / 180;
    var bodies = parts(figure.getAttribute('data-glb')).map(function (part, index) {
      for (var corner = 0; corner < 8; ++corner) {
        var p = [0, 1, 2].map(function (k) { return (corner >> k & 1 ? part.high : part.low)[k]; });
        for (var k = 0; k < 3; ++k) {
          var m = part.place, q = m[k] * p[0] + m[4 + k] * p[1] + m[8 + k] * p[2] + m[12 + k];
          low[k] = Math.min(low[k], q);
          high[k] = Math.max(high[k], q);
        }
      }
      return {place: part.place, turn: turns[index] || 0, colour: part.colour, count: part.indices.length,
              positions: buffer(gl.ARRAY_BUFFER, part.positions), normals: buffer(gl.ARRAY_BUFFER, part.normals),
              indices: buffer(gl.ELEMENT_ARRAY_BUFFER, part.indices)};
    });
    var middle = [0, 1, 2].map(function (k) { return (low[k] + high[k]) / 2; });
    var size = Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
    var start = {yaw: 0.5, pitch: -0.4, away: 1.25};
    var yaw = start.yaw, tilt = start.pitch, away = start.away, t = 0, asked = false;

    function draw() {
      asked = false;
      var ratio = Math.min(2, window.devicePixelRatio || 1);
      var w = Math.max(1, Math.round(canvas.clientWidth * ratio)), h = Math.max(1, Math.round(canvas.clientHeight * ratio));
      if (canvas.width !== w || canvas.height !== h) { canvas.width = w; canvas.height = h; }
      gl.viewport(0, 0, w, h);
      gl.clearColor(0, 0, 0, 0);
      gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
      var far = away * size;
      var view = multiply(moved(0, 0, -far), multiply(aboutX(tilt), multiply(aboutY(yaw), moved(-middle[0], -middle[1], -middle[2]))));
      gl.uniformMatrix4fv(at.view, false, view);
      gl.uniformMatrix4fv(at.project, false, new Float32Array(perspective(w / h, 0.05 * far, far + 2 * size)));
      bodies.forEach(function (body) {
        gl.uniformMatrix4fv(at.model, false, multiply(body.place, aboutZ(body.turn * t * pitch)));
        gl.uniform3fv(at.colour, body.colour);
        [['p', body.positions], ['n', body.normals]].forEach(function (pair) {
          var slot = gl.getAttribLocation(program, pair[0]);
          gl.bindBuffer(gl.ARRAY_BUFFER, pair[1]);
          gl.enableVertexAttribArray(slot);
          gl.vertexAttribPointer(slot, 3, gl.FLOAT, false, 0, 0);
        });
        gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, body.indices);
        gl.drawElements(gl.TRIANGLES, body.count, gl.UNSIGNED_INT, 0);
      });
      if (output) output.textContent = (t * pitch * 180 / Math.PI).toFixed(2) + '°';
    }
    function ask() {
      if (!asked) requestAnimationFrame(draw);
      asked = true;
    }
    function turnBy(dx, dy) {
      yaw += dx;
      tilt = Math.max(-1.57, Math.min(1.57, tilt + dy));
      ask();
    }
    function come(factor) {
      away = Math.max(0.35, Math.min(6, away * factor));
      ask();
    }
    function restore() {
      yaw = start.yaw;
      tilt = start.pitch;
      away = start.away;
      ask();
    }
    var held = null;
    canvas.addEventListener('pointerdown', function (e) {
      held = [e.clientX, e.clientY];
      canvas.setPointerCapture(e.pointerId);
    });
    canvas.addEventListener('pointermove', function (e) {
      if (!held) return;
      turnBy((e.clientX - held[0]) / 150, (e.clientY - held[1]) / 150);
      held = [e.clientX, e.clientY];
    });
    ['pointerup', 'pointercancel'].forEach(function (name) {
      canvas.addEventListener(name, function () { held = null; });
    });
    canvas.addEventListener('wheel', function (e) {
      if (document.activeElement !== canvas) return;  // the user scrolls the page past the picture
      e.preventDefault();
      come(Math.exp(e.deltaY * 0.001));
    }, {passive: false});
    canvas.addEventListener('dblclick', restore);
    canvas.addEventListener('keydown', function (e) {
      var known = true;
      if (e.key === 'ArrowLeft') turnBy(-0.1, 0);
      else if (e.key === 'ArrowRight') turnBy(0.1, 0);
      else if (e.key === 'ArrowUp') turnBy(0, -0.1);
      else if (e.key === 'ArrowDown') turnBy(0, 0.1);
      else if (e.key === '+' || e.key === '=') come(0.9);
      else if (e.key === '-') come(1 / 0.9);
      else if (e.key === '0') restore();
      else known = false;
      if (known) e.preventDefault();
    });
    var running = 0, last = null;
    function step(now) {
      if (last !== null) t = (t + (now - last) / 3000) % 1;
      last = now;
      slider.value = t;
      draw();
      running = requestAnimationFrame(step);
    }
    function stop() {
      if (running) cancelAnimationFrame(running);
      running = 0;
      last = null;
      button.textContent = 'Turn';
    }
    if (slider) {
      slider.addEventListener('input', function () {
        stop();
        t = parseFloat(slider.value);
        ask();
      });
      button.addEventListener('click', function () {
        if (running) { stop(); return; }
        button.textContent = 'Stop';
        running = requestAnimationFrame(step);
      });
    }
    window.addEventListener('resize', ask);
    draw();
    return true;
  }
  Array.prototype.slice.call(document.querySelectorAll('figure.solid')).forEach(function (figure) {
    var good = false;
    try { good = show(figure); } catch (e) { good = false; }
    if (!good) {
      figure.querySelector('canvas').hidden = true;
      figure.querySelector('.no-solid').hidden = false;
    }
    var controls = figure.querySelector('.solid-turn');
    if (controls) controls.hidden = !good;
  });
})();
