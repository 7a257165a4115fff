// Shows the values of the nearest curve, or of a map, at the pointer.
(function () {
  'use strict';
  var near = 32, touch = 6;  // px, greatest distance from the pointer: vertically to a curve,
                             // horizontally to a vertical line
  var shown = null;

  function axisOf(plot, name) {
    var words = plot.getAttribute('data-' + name).split(' '), n = words.slice(0, 4).map(Number);
    var digits = Math.max(0, 3 - Math.floor(Math.log10(Math.abs(n[1] - n[0]))));
    return function (px) {
      var share = (px - n[2]) / (n[3] - n[2]);
      var value = words.length > 4 ? n[0] * Math.pow(n[1] / n[0], share) : n[0] + share * (n[1] - n[0]);
      return value.toFixed(Math.min(9, digits)).replace(/^-(?=[0.]*$)/, '').replace('-', '−');
    };
  }
  // Pieces of a path as lists of points, px.
  function piecesOf(path) {
    if (!path.pieces) {
      path.pieces = path.getAttribute('d').split('M').filter(Boolean).map(function (piece) {
        return piece.split('L').map(function (point) { return point.split(' ').map(Number); });
      });
    }
    return path.pieces;
  }
  // Returns the candidate point that is nearest to the pointer. A candidate is a point at which a
  // path crosses the vertical through the pointer, or the point of a vertical line that is level
  // with the pointer.
  function passing(plot, at) {
    var best = null;
    plot.querySelectorAll('path[data-name]').forEach(function (path) {
      piecesOf(path).forEach(function (piece) {
        for (var i = 1; i < piece.length; ++i) {
          var a = piece[i - 1], b = piece[i];
          var upright = a[0] === b[0], y = at.y, far = Math.abs(a[0] - at.x);
          if (upright ? far > touch || (a[1] - at.y) * (b[1] - at.y) > 0 : (a[0] - at.x) * (b[0] - at.x) > 0) continue;
          if (!upright) {
            y = a[1] + (at.x - a[0]) / (b[0] - a[0]) * (b[1] - a[1]);
            far = Math.abs(y - at.y);
          }
          if (far < near && (!best || far < best.far))
            best = {far: far, x: upright ? a[0] : at.x, y: y, name: path.getAttribute('data-name')};
        }
      });
    });
    return best;
  }
  function add(parent, tag, attributes, text) {
    var node = document.createElementNS(parent.namespaceURI, tag);
    Object.keys(attributes).forEach(function (name) { node.setAttribute(name, attributes[name]); });
    if (text) node.textContent = text;
    return parent.appendChild(node);
  }
  document.addEventListener('pointermove', function (event) {
    if (shown) shown.remove();
    shown = null;
    var svg = event.target.closest && event.target.closest('svg');
    var plot = svg && svg.querySelector('g.plot');
    if (!plot || event.buttons) return;
    var at = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
    var found = passing(plot, at), map = event.target.getAttribute('data-value');
    if (!found && map) found = {x: at.x, y: at.y, name: map};
    if (!found) return;
    var bare = plot.hasAttribute('data-bare'), x = axisOf(plot, 'x')(found.x), y = axisOf(plot, 'y')(found.y);
    var ends = plot.getAttribute('data-x').split(' ').map(Number), left = found.x < (ends[2] + ends[3]) / 2;
    shown = add(svg, 'g', {'class': 'readout'});
    add(shown, 'circle', {cx: found.x, cy: found.y, r: 3.5});
    var words = add(shown, 'text', {x: found.x + (left ? 9 : -9), y: found.y - 9, 'class': 'halo' + (left ? '' : ' e')},
        bare ? found.name : found.far === undefined ? found.name + ' at ' + x + '; ' + y : found.name + ': ' + y + ' at ' + x);
    // Long words are moved into the picture.
    var box = words.getBBox(), view = svg.viewBox.baseVal;
    var beyond = Math.max(0, box.x + box.width + 6 - view.x - view.width);
    if (beyond) words.setAttribute('transform', 'translate(' + -beyond + ' 0)');
  });
})();
