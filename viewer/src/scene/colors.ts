// The colours of the 3D view come from the style sheet, so that light and dark are one place.

export interface Palette {
  ground: string;
  front: string;
  back: string;
  line: string;
  arrow: string;
  changed: string;
  selected: string;
  next: string;
  twin: string;
  wrong: string;
  right: string;
  ink: string;
  muted: string;
}

export function palette(element: Element): Palette {
  const style = getComputedStyle(element);
  const read = (name: string): string => style.getPropertyValue(`--view-${name}`).trim();
  return {
    ground: read('ground'),
    front: read('front'),
    back: read('back'),
    line: read('line'),
    arrow: read('arrow'),
    changed: read('changed'),
    selected: read('selected'),
    next: read('next'),
    twin: read('twin'),
    wrong: read('wrong'),
    right: read('right'),
    ink: read('ink'),
    muted: read('muted'),
  };
}
