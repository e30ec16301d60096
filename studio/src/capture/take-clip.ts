import { AnimationClip, type Mesh, NumberKeyframeTrack, type Object3D } from 'three'
import { durationOf, framesOf, TAKE_RATE, type TakeMotion, weightsOf } from '../document/take.ts'
import { columnsOf } from './take-columns.ts'

/**
 * Converts a motion to an animation clip for all meshes of a face. The names of blendshapes can have any spelling that drivers accept.
 * Blendshapes that the motion lacks stay at 0, so that a take looks the same after every expression.
 */
export function takeClip(motion: TakeMotion, face: Object3D): AnimationClip {
  const times = Float32Array.from({ length: framesOf(motion) }, (_, i) => i / TAKE_RATE)
  const rest = { times: Float32Array.of(0), weights: Float32Array.of(0) }
  const tracks: NumberKeyframeTrack[] = []
  face.traverse((object) => {
    const { morphTargetDictionary: dictionary } = object as Mesh
    if (!dictionary) return
    const names = Object.keys(dictionary)
    const columns = columnsOf(motion.names, names)
    for (const [i, name] of names.entries()) {
      const column = columns.get(i)
      const moved = column === undefined ? rest : { times, weights: weightsOf(motion, column) }
      const path = `${object.uuid}.morphTargetInfluences[${dictionary[name]}]`
      tracks.push(new NumberKeyframeTrack(path, moved.times, moved.weights))
    }
  })
  return new AnimationClip('', durationOf(motion), tracks)
}
