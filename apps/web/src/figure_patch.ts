// Replaces a figure by the next one while a value changes. Nodes that both figures have are kept, and only
// attributes and texts that differ are set, because the browser lays out and paints only what has changed.

/** Returns the nodes of a markup, which are not part of the page. */
export function nodesOf(html: string): DocumentFragment {
  const template = document.createElement("template");
  template.innerHTML = html;
  return template.content;
}

/** Makes the children of `old` equal to those of `fresh`. */
export function patchChildren(old: Node, fresh: Node): void {
  let [to, from] = [old.firstChild, fresh.firstChild];
  while (to && from) {
    const next: [ChildNode | null, ChildNode | null] = [to.nextSibling, from.nextSibling];
    patchNode(to, from);
    [to, from] = next;
  }
  while (to) {
    const next: ChildNode | null = to.nextSibling;
    to.remove();
    to = next;
  }
  while (from) {
    const next: ChildNode | null = from.nextSibling;
    old.appendChild(from);
    from = next;
  }
}

function patchNode(old: ChildNode, fresh: ChildNode): void {
  if (old.nodeName !== fresh.nodeName) return old.replaceWith(fresh);
  if (old.isEqualNode(fresh)) return;
  if (old instanceof Element && fresh instanceof Element) {
    patchAttributes(old, fresh);
    patchChildren(old, fresh);
  } else if (old.nodeValue !== fresh.nodeValue) old.nodeValue = fresh.nodeValue;
}

function patchAttributes(old: Element, fresh: Element): void {
  for (const { name, value } of fresh.attributes)
    if (old.getAttribute(name) !== value) old.setAttribute(name, value);
  if (old.attributes.length > fresh.attributes.length)
    for (const { name } of [...old.attributes]) if (!fresh.hasAttribute(name)) old.removeAttribute(name);
  // Scripts of the figures store values of the previous figure in properties of its elements.
  const stored = old as unknown as Record<string, unknown>;
  for (const name of Object.keys(stored)) delete stored[name];
}
