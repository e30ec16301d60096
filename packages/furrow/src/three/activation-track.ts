import { type Mesh, NumberKeyframeTrack } from 'three'
import { wrongArgument } from '../core/argument.ts'
import { unknownArea } from '../core/check-areas.ts'
import { wrinklesOfMesh } from './mesh-wrinkles.ts'

/**
 * Creates a keyframe track that animates the activation of one area, i.e. of one controllable group of wrinkles. Put the track in an
 * `AnimationClip`, and play the clip with an `AnimationMixer` whose root is the mesh or an ancestor. Drivers add to the animated activation.
 *
 * @param mesh mesh with wrinkles. The track refers to the mesh by name, so it also animates copies with the same name.
 * @param area name of the area.
 * @param times increasing times in seconds.
 * @param values one activation (0..1) per time, interpolated linearly.
 * @throws FurrowError if `mesh` is not a mesh, the area is unknown, or `times` and `values` differ in length.
 */
export function activationTrack(
  mesh: Mesh,
  area: string,
  times: ArrayLike<number>,
  values: ArrayLike<number>,
): NumberKeyframeTrack {
  if (!mesh?.uuid) throw wrongArgument('activationTrack', 'mesh', mesh, 'a Mesh of three.js')
  if (typeof area !== 'string') throw wrongArgument('activationTrack', 'area', area, 'a name')
  const wrinkles = wrinklesOfMesh(mesh)
  if (wrinkles && !wrinkles.hasArea(area)) throw unknownArea(area, wrinkles.areaNames, 'activationTrack')
  if (!(times?.length > 0) || times.length !== values?.length) {
    throw wrongArgument(
      'activationTrack',
      'number of values',
      values?.length,
      `one for each of ${times?.length} times`,
    )
  }
  const name = `${mesh.name || mesh.uuid}.wrinkles[${area}].activation`
  return new NumberKeyframeTrack(name, Array.from(times), Array.from(values))
}
