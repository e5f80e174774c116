// What the browser can draw with.

/** Whether the graphics are computed by the processor; null: there are none at all. */
export function softwareRendered(): boolean | null {
  const probe = document.createElement('canvas').getContext('webgl2');
  if (!probe) return null;
  const info = probe.getExtension('WEBGL_debug_renderer_info');
  const name = String(probe.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : probe.RENDERER));
  probe.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|software/i.test(name);
}

export function hasWebGL(): boolean {
  return softwareRendered() !== null;
}
