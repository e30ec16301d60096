import { type Mesh, NumberKeyframeTrack } from 'three'
import { wrongArgument } from '../core/argument.ts'
import { unknownArea } from '../core/check-areas.ts'
import { addedTo } from './added-to.ts'

/**
 * Creates key frames of an area's activation at rest, for an `AnimationClip` that three.js's `AnimationMixer` plays on the mesh or an
 * ancestor of it. Drivers add to it.
 *
 * @param mesh with wrinkles; bound by its name, as in clips of files, so that copies play it too.
 * @param area name of the area.
 * @param times seconds, increasing.
 * @param values 0..1, one per time, interpolated linearly.
 * @throws FurrowError when it is not a mesh, its wrinkles have no such area, or there are not as many values as times.
 */
export function activationTrack(
  mesh: Mesh,
  area: string,
  times: ArrayLike<number>,
  values: ArrayLike<number>,
): NumberKeyframeTrack {
  if (!mesh?.uuid) throw wrongArgument('activationTrack', 'a mesh', mesh, 'a Mesh of three.js')
  if (typeof area !== 'string') throw wrongArgument('activationTrack', 'an area', area, 'a name')
  const wrinkles = addedTo(mesh)
  if (wrinkles && !wrinkles.hasArea(area)) throw unknownArea(area, wrinkles.areaNames, 'activationTrack')
  if (!(times?.length > 0) || times.length !== values?.length) {
    throw wrongArgument('activationTrack', 'values', values?.length, `one for each of ${times?.length} times`)
  }
  const name = `${mesh.name || mesh.uuid}.wrinkles[${area}].activation`
  return new NumberKeyframeTrack(name, Array.from(times), Array.from(values))
}
