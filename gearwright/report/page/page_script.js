(function () {
  'use strict';
  var svgs = document.querySelectorAll('svg.zoom');
  Array.prototype.forEach.call(svgs, function (svg) {
    var zoom = figureZoom(svg);
    svg.classList.add('live');
    window.addEventListener('beforeprint', zoom.reset);
  });
  // On paper all details are open, and long tables are in an appendix, under the names of their
  // sections.
  var moved = [], emptied = [], appendix = document.createElement('section');
  function heading(tag, words) {
    appendix.appendChild(document.createElement(tag)).textContent = words;
  }
  window.addEventListener('beforeprint', function () {
    Array.prototype.forEach.call(document.querySelectorAll('details'), function (d) { d.open = true; });
    if (moved.length) return;
    var last = null;
    appendix.textContent = '';
    heading('h2', 'Tables');
    Array.prototype.forEach.call(document.querySelectorAll('main details.fold'), function (d) {
      var section = d.closest('section'), name = section && section.querySelector('h2');
      if (name && section !== last) heading('h3', name.textContent);
      last = section;
      moved.push([d, d.parentNode.insertBefore(document.createComment(''), d)]);
      if (section) d.className += ' ' + section.className;
      appendix.appendChild(d);
    });
    if (moved.length) document.querySelector('main').appendChild(appendix);
    // A section whose tables were all moved consists of its heading only, and is hidden.
    Array.prototype.forEach.call(document.querySelectorAll('main section'), function (s) {
      if (s.children.length === 1 && s !== appendix) { s.hidden = true; emptied.push(s); }
    });
  });
  window.addEventListener('afterprint', function () {
    moved.forEach(function (m) { m[1].parentNode.replaceChild(m[0], m[1]); });
    emptied.forEach(function (s) { s.hidden = false; });
    moved = [];
    emptied = [];
    appendix.remove();
  });
  var hint = document.getElementById('hint');
  if (hint && svgs.length) hint.hidden = false;
})();
