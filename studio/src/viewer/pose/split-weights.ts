import { AnimationClip, type KeyframeTrack, NumberKeyframeTrack } from 'three'

/**
 * A clip of a file with a track per blendshape in the place of one for all of a mesh: muscles make that list longer, and three.js then
 * writes beyond the track's own numbers.
 */
export function splitWeights({ name, duration, tracks }: AnimationClip): AnimationClip {
  return new AnimationClip(
    name,
    duration,
    tracks.flatMap((track) => (/\.morphTargetInfluences$/.test(track.name) ? splitTrack(track) : track)),
  )
}

/** How GLTFLoader has a track interpolated; types do not know of it. */
interface Interpolated {
  createInterpolant: { isInterpolantFactoryMethodGLTFCubicSpline?: true }
}

function splitTrack(track: KeyframeTrack): KeyframeTrack[] {
  const { createInterpolant } = track as unknown as Interpolated
  const isCubic = createInterpolant.isInterpolantFactoryMethodGLTFCubicSpline
  // A cubic key frame is all in-tangents, all values and all out-tangents.
  const count = track.getValueSize() / (isCubic ? 3 : 1)
  return Array.from({ length: count }, (_, target) => {
    const values = track.values.filter((_, i) => i % count === target)
    const part = new NumberKeyframeTrack(`${track.name}[${target}]`, track.times, values)
    if (isCubic) Object.assign(part, { createInterpolant })
    else part.setInterpolation(track.getInterpolation())
    return part
  })
}
