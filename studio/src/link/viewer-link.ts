import type { Signal } from '@preact/signals'
import { Vector3 } from 'three'
import type { AutoSettings } from '../document/document.ts'
import type { LightDirection } from '../viewer/light-direction.ts'
import type { Orbit } from '../viewer/orbit.ts'
import { KEY_LIGHT } from '../viewer/staging.ts'
import type { Viewer } from '../viewer/viewer.ts'
import type { Link } from './link.ts'

/** Face in the viewer, with the camera and the direction of the key light. */
export interface ShownScene {
  viewer: Viewer
  orbit: Orbit
  light: Signal<LightDirection>
}

/**
 * Makes a link to the current state of a scene.
 *
 * @param auto settings of the face's automatic wrinkles. Undefined for other wrinkles.
 */
export function linkOf({ viewer, orbit, light }: ShownScene, auto: AutoSettings | undefined): Link {
  const { avatar, targets } = viewer
  const { position, target } = orbit.pose
  const { yaw, pitch } = light.peek()
  return {
    model: avatar.address,
    pose: new Map(targets.map(({ name, read }) => [name, read()])),
    camera: [position.x, position.y, position.z, target.x, target.y, target.z],
    light: yaw === KEY_LIGHT.yaw && pitch === KEY_LIGHT.pitch ? undefined : { yaw, pitch },
    auto,
  }
}

/** Applies the pose, the light and the camera of a link. Ignores blendshapes that the face lacks. */
export function applyLink({ pose, camera, light }: Link, scene: ShownScene): void {
  const { viewer, orbit } = scene
  scene.light.value = light ?? KEY_LIGHT
  if (pose) for (const { name, write } of viewer.targets) write(pose.get(name) ?? 0)
  if (!camera) return
  const [x, y, z, ...target] = camera
  orbit.restore({ position: new Vector3(x, y, z), target: new Vector3(...target) }, null)
}
