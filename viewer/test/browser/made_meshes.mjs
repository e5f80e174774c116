// Meshes of any size for the tests.

/** Without a negative zero, which nobody could tell from zero in a file that was written again. */
const short = (x) => Math.round(x * 1e6) / 1e6 + 0;

/** A closed bumpy torus of 2 * around * across triangles, as OBJ. */
export function torusObj(around, across) {
  const lines = [];
  for (let i = 0; i < around; ++i) {
    const u = (2 * Math.PI * i) / around;
    for (let j = 0; j < across; ++j) {
      const v = (2 * Math.PI * j) / across;
      const thick = 0.4 + 0.05 * Math.sin(6 * u) * Math.sin(4 * v);
      const far = 1 + thick * Math.cos(v);
      lines.push(`v ${[far * Math.cos(u), thick * Math.sin(v), -far * Math.sin(u)].map(short).join(' ')}`);
    }
  }
  const id = (i, j) => (i % around) * across + (j % across) + 1;
  for (let i = 0; i < around; ++i) {
    for (let j = 0; j < across; ++j) {
      lines.push(`f ${id(i, j)} ${id(i + 1, j)} ${id(i + 1, j + 1)}`, `f ${id(i, j)} ${id(i + 1, j + 1)} ${id(i, j + 1)}`);
    }
  }
  return lines.join('\n') + '\n';
}
