import type { Orbit } from './orbit.ts'
import type { Viewer } from './viewer.ts'

/**
 * Stores the user's settings of a viewer: pose, camera, mode and look.
 *
 * @returns function that returns the steps to apply the settings to another viewer. The steps set the pose only if the viewer has the same
 * avatar. Each step can throw, for example for an unsupported mode.
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
