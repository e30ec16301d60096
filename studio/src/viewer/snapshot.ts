import type { Orbit } from './orbit.ts'
import type { Viewer } from './viewer.ts'

/**
 * Captures the user's settings of a viewer. A different avatar keeps its own pose.
 *
 * @returns steps that apply the settings to another viewer. Each can throw, for example if a mode is unsupported.
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
