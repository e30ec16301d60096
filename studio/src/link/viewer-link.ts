import { Vector3 } from 'three'
import type { AutoSettings } from '../document/document.ts'
import type { Orbit } from '../viewer/orbit.ts'
import type { Viewer } from '../viewer/viewer.ts'
import type { Link } from './link.ts'

/**
 * What a link says of a face as it is shown.
 *
 * @param auto what its wrinkles were made with; undefined where they are others.
 */
export function linkOf({ avatar, targets }: Viewer, { pose }: Orbit, auto: AutoSettings | undefined): Link {
  const { position, target } = pose
  return {
    model: avatar.address,
    pose: new Map(targets.map(({ name, read }) => [name, read()])),
    camera: [position.x, position.y, position.z, target.x, target.y, target.z],
    auto,
  }
}

/** Shows a face as a link says. Blendshapes that it does not have are left out. */
export function applyLink({ pose, camera }: Link, viewer: Viewer, orbit: Orbit): void {
  if (pose) for (const { name, write } of viewer.targets) write(pose.get(name) ?? 0)
  if (!camera) return
  const [x, y, z, ...target] = camera
  orbit.restore({ position: new Vector3(x, y, z), target: new Vector3(...target) }, null)
}
