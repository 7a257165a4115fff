(function () {
  'use strict';
  var table = document.querySelector('table.designs');
  if (!table) return;
  var body = table.tBodies[0], heads = table.tHead.rows[0].cells;
  var rows = Array.prototype.slice.call(body.rows);  // in the order of rank

  function key(row, column) {
    var text = row.cells[column].getAttribute('data-v');
    return text === '' ? null : Number(text);
  }
  function sort(column, direction) {
    var sign = direction === 'ascending' ? 1 : -1;
    rows.map(function (row, i) {
      return {row: row, key: key(row, column), rank: i};
    }).sort(function (a, b) {
      if (a.key === null || b.key === null) {
        return (a.key === null) - (b.key === null) || a.rank - b.rank;
      }
      return sign * (a.key - b.key) || a.rank - b.rank;
    }).forEach(function (entry) { body.appendChild(entry.row); });
    Array.prototype.forEach.call(heads, function (head, i) {
      if (i === column) head.setAttribute('aria-sort', direction);
      else head.removeAttribute('aria-sort');
    });
  }
  Array.prototype.forEach.call(heads, function (head, column) {
    var button = document.createElement('button');
    button.type = 'button';
    while (head.firstChild) button.appendChild(head.firstChild);
    head.appendChild(button);
    button.addEventListener('click', function () {
      var now = head.getAttribute('aria-sort'), first = head.getAttribute('data-first');
      var other = first === 'ascending' ? 'descending' : 'ascending';
      sort(column, now === first ? other : first);
    });
  });
  var hint = document.getElementById('sort-hint');
  if (hint) hint.hidden = false;
})();
