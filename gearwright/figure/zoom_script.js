// Controls the visible part of a picture. The wheel zooms about the pointer, a drag moves the
// picture, and a double click restores it. The keys + − 0 and the arrow keys do the same for the
// focused picture. Labels keep their size.
//
//   figureZoom(holder, on)   holder: the picture or an element around it, whose picture may change
//     on.always   the wheel zooms at once, not only after the pointer has moved on the picture
//     on.touch    one finger moves the picture, two fingers zoom
//     on.home()   restores the view; by default, the initial view is restored
//     on.moved()  called after each change of the view
//     on.settled()  called after the view has not changed for a moment
(function () {
  'use strict';
  var pause = 160;  // ms without a change of the view before on.settled() is called
  window.figureZoom = function (holder, on) {
    on = on || {};
    var armed = false, held = {}, settling = 0;

    function picture() { return holder.matches('svg') ? holder : holder.querySelector('svg'); }
    function seen(svg) {
      var v = svg.viewBox.baseVal;
      return {x: v.x, y: v.y, w: v.width, h: v.height};
    }
    function homeOf(svg) { return svg.figureHome || (svg.figureHome = seen(svg)); }
    function show(svg, box) {
      var k = box.w / homeOf(svg).w;
      svg.setAttribute('viewBox', [box.x, box.y, box.w, box.h].join(' '));
      Array.prototype.forEach.call(svg.querySelectorAll('.lb'), function (label) {
        label.figureAt = label.figureAt || label.getAttribute('transform');
        label.setAttribute('transform', k === 1 ? label.figureAt : label.figureAt + ' scale(' + k + ')');
      });
      if (on.moved) on.moved();
      clearTimeout(settling);
      if (on.settled) settling = setTimeout(on.settled, pause);
    }
    function place(svg, x, y) { return new DOMPoint(x, y).matrixTransform(svg.getScreenCTM().inverse()); }
    function zoom(factor, p) {
      var svg = picture(), home = homeOf(svg), box = seen(svg);
      var w = Math.min(home.w * 8, Math.max(home.w / 2000, box.w * factor)), f = w / box.w;
      show(svg, {x: p.x - (p.x - box.x) * f, y: p.y - (p.y - box.y) * f, w: w, h: box.h * f});
    }
    function move(across, up) {
      var svg = picture(), box = seen(svg);
      box.x -= across;
      box.y -= up;
      show(svg, box);
    }
    function reset() {
      if (on.home) on.home();
      else show(picture(), homeOf(picture()));
    }
    function middle() {
      var box = seen(picture());
      return {x: box.x + box.w / 2, y: box.y + box.h / 2};
    }

    // If a picture comes under the pointer while the user scrolls the page, the page must continue
    // to scroll. The wheel controls the picture only after the pointer itself has moved on it.
    window.addEventListener('scroll', function () { armed = false; }, {passive: true});
    holder.addEventListener('pointerleave', function () { armed = false; });
    holder.addEventListener('wheel', function (event) {
      var svg = picture();
      if (!svg || (!armed && !on.always && !event.ctrlKey && document.activeElement !== svg)) return;
      event.preventDefault();
      var lines = event.deltaMode === 1 ? 20 : 1;
      zoom(Math.exp(Math.max(-300, Math.min(300, event.deltaY * lines)) * 0.0018),
           place(svg, event.clientX, event.clientY));
    }, {passive: false});
    holder.addEventListener('pointerdown', function (event) {
      if (!picture() || event.button !== 0 || event.target.closest('button')) return;
      if (event.pointerType === 'touch' && !on.touch) return;
      held[event.pointerId] = {x: event.clientX, y: event.clientY};
      holder.setPointerCapture(event.pointerId);
      holder.classList.add('held');
    });
    holder.addEventListener('pointermove', function (event) {
      if (event.movementX || event.movementY) armed = true;
      var before = held[event.pointerId], svg = picture();
      if (!before || !svg) return;
      var now = held[event.pointerId] = {x: event.clientX, y: event.clientY};
      var other = Object.keys(held).filter(function (id) { return Number(id) !== event.pointerId; })[0];
      var from = place(svg, before.x, before.y), to = place(svg, now.x, now.y), share = 1;
      if (other !== undefined) {
        var fixed = held[other], about = place(svg, (now.x + fixed.x) / 2, (now.y + fixed.y) / 2);
        var apart = function (p) { return Math.hypot(p.x - fixed.x, p.y - fixed.y) || 1; };
        zoom(apart(before) / apart(now), about);
        share = 0.5;
      }
      move(share * (to.x - from.x), share * (to.y - from.y));
    });
    function release(event) {
      delete held[event.pointerId];
      if (!Object.keys(held).length) holder.classList.remove('held');
    }
    holder.addEventListener('pointerup', release);
    holder.addEventListener('pointercancel', release);
    holder.addEventListener('dblclick', function (event) { event.preventDefault(); reset(); });
    holder.addEventListener('keydown', function (event) {
      if (!picture() || event.ctrlKey || event.metaKey || event.altKey) return;
      var step = {ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[event.key];
      var box = seen(picture());
      if (event.key === '+' || event.key === '=') zoom(1 / 1.25, middle());
      else if (event.key === '-') zoom(1.25, middle());
      else if (event.key === '0') reset();
      else if (step) move(step[0] * box.w / 12, step[1] * box.h / 12);
      else return;
      event.preventDefault();
    });
    return {reset: reset};
  };
})();
