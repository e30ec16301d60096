import type { Orbit } from './orbit.ts'
import type { Viewer } from './viewer.ts'

/**
 * Remembers the state that a user has set on a viewer. Another avatar begins with its own pose.
 *
 * @returns steps that set it on another viewer. Each may throw, e.g. where a mode or look is not supported.
 */
export function snapshot(viewer: Viewer, orbit: Orbit): (next: Viewer, nextOrbit: Orbit) => (() => void)[] {
  const { avatar, mode, look, driven } = viewer
  const { pose, view } = orbit
  const values = new Map([...viewer.targets, ...viewer.areas].map((dial) => [dial.name, dial.read()]))
  return (next, nextOrbit) => [
    () => {
      if (next.avatar.root !== avatar.root) return nextOrbit.goTo(view ?? 'front', true)
      for (const [name, value] of driven.inputs) next.driven.inputs.set(name, value)
      for (const dial of [...next.targets, ...next.areas]) dial.write(values.get(dial.name) ?? 0)
      nextOrbit.restore(pose, view)
    },
    () => {
      next.mode = mode
    },
    () => {
      next.look = look
    },
  ]
}
