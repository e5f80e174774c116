// Builds elements. Text always goes in as text, never as markup.

export type Child = Node | string | number | null | undefined | false;

type Props = {
  class?: string;
  on?: Record<string, (event: Event) => void>;
} & Record<string, unknown>;

/** An element; what is not `class` or `on` becomes an attribute, `true` an empty one. */
export function el<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  props: Props = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(props)) {
    if (value === undefined || value === null || value === false) continue;
    if (name === 'on') {
      for (const [event, handler] of Object.entries(props.on ?? {})) {
        element.addEventListener(event, handler);
      }
    } else {
      element.setAttribute(name, value === true ? '' : String(value));
    }
  }
  append(element, children);
  return element;
}

export function append(parent: Node, children: Child[]): void {
  for (const child of children) {
    if (child === null || child === undefined || child === false) continue;
    parent.appendChild(child instanceof Node ? child : document.createTextNode(String(child)));
  }
}

export function replace(parent: Element, ...children: Child[]): void {
  parent.replaceChildren();
  append(parent, children);
}

export function button(text: Child, onClick: () => void, props: Props = {}): HTMLButtonElement {
  return el('button', { type: 'button', ...props, on: { click: onClick } }, text);
}

/** A button that says which key does the same. */
export function keyButton(text: string, key: string, onClick: () => void, props: Props = {}): HTMLButtonElement {
  const made = button(text, onClick, { 'aria-keyshortcuts': key, ...props });
  made.append(' ', el('kbd', {}, key));
  return made;
}

/** Calls back with every move of the pointer until its button is let go. */
export function followPointer(move: (event: PointerEvent, first: boolean) => void): void {
  let first = true;
  const moved = (event: PointerEvent): void => {
    move(event, first);
    first = false;
  };
  const done = (): void => {
    window.removeEventListener('pointermove', moved);
    for (const end of ['pointerup', 'pointercancel']) window.removeEventListener(end, done);
  };
  window.addEventListener('pointermove', moved);
  for (const end of ['pointerup', 'pointercancel']) window.addEventListener(end, done);
}

/** An SVG picture as nodes, without anything that could run or reach out. */
export function picture(svgText: string): SVGElement | null {
  const parsed = new DOMParser().parseFromString(svgText, 'image/svg+xml');
  const root = parsed.documentElement;
  if (root.nodeName !== 'svg') return null;
  for (const node of [root, ...root.querySelectorAll('*')]) {
    if (/^(script|foreignObject|style|a|image|use|iframe)$/i.test(node.localName)) {
      node.remove();
      continue;
    }
    for (const attribute of [...node.attributes]) {
      if (/^on|href$|^style$/i.test(attribute.name)) node.removeAttribute(attribute.name);
    }
  }
  return document.importNode(root, true) as unknown as SVGElement;
}
