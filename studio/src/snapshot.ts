import type { Orbit } from './orbit.ts'
import type { Viewer } from './viewer.ts'

/**
 * Remembers what a user set on one viewer.
 *
 * @returns steps that put it on another one, each of which may throw: the mode or the look may not fit there.
 */
export function snapshot(viewer: Viewer, orbit: Orbit): (next: Viewer, turn: Orbit) => (() => void)[] {
  const { loaded, mode, look } = viewer
  const { pose, view } = orbit
  const values = new Map([...viewer.targets, ...viewer.areas].map((dial) => [dial.name, dial.read()]))
  return (next, turn) => [
    () => {
      for (const dial of [...next.targets, ...next.areas]) dial.write(values.get(dial.name) ?? 0)
    },
    () => {
      if (next.loaded === loaded) turn.restore(pose, view)
      else turn.goTo(view ?? 'front', true)
    },
    () => {
      next.mode = mode
    },
    () => {
      next.look = look
    },
  ]
}
