import { FurrowError } from 'furrow'
import { targetFinder } from 'furrow/internal'
import { AnimationClip, type Mesh, NumberKeyframeTrack, type Object3D } from 'three'
import type { Capture } from './live-link-face.ts'

/**
 * Converts a facial capture to an animation clip for all meshes of `face` that have any of its blendshapes. The names of blendshapes can have
 * any spelling that drivers accept.
 *
 * @throws FurrowError if the face has none of the blendshapes.
 */
export function captureClip({ name, times, weights }: Capture, face: Object3D): AnimationClip {
  const tracks: NumberKeyframeTrack[] = []
  face.traverse((object) => {
    const { morphTargetDictionary: dictionary } = object as Mesh
    if (!dictionary) return
    const targets = Object.keys(dictionary)
    const find = targetFinder(targets)
    for (const [blendshape, values] of weights) {
      for (const index of find(blendshape)) {
        const path = `${object.uuid}.morphTargetInfluences[${dictionary[targets[index]]}]`
        tracks.push(new NumberKeyframeTrack(path, times, values))
      }
    }
  })
  if (tracks.length === 0) throw missingBlendshapesError(name)
  return new AnimationClip(name, times[times.length - 1], tracks)
}

function missingBlendshapesError(name: string): FurrowError {
  return new FurrowError({
    code: 'unknown-name',
    who: 'Studio',
    problem: `the face has none of the blendshapes in ${name}`,
    limit: 'names of ARKit, such as browInnerUp',
    remedy: 'name its blendshapes so, or open another avatar',
  })
}
