import { FurrowError } from 'furrow'
import { didYouMean, JsonReader } from 'furrow/internal'
import type { FoundSkin } from './find-skin.ts'

/** Poses of a skeleton: rotations per joint. */
export type JointPoses = ReadonlyMap<string, readonly (readonly number[])[]>

const MAX_POSES = 1000
/** Quaternions may differ from length 1 by this. */
const TOLERANCE = 0.01

/**
 * Reads poses: `{ "poses": [{ "name": "kneel", "joints": { "LeftLeg": [x, y, z, w] } }] }`. Each quaternion is the rotation of a joint from its
 * rest pose, in the joint's own frame.
 *
 * @throws FurrowError with the path of a field that is malformed or unknown.
 */
export function parsePoses(json: unknown, who: string): JointPoses {
  const read = new JsonReader(who)
  const root = read.object(json, 'the poses', ['poses'])
  const found = new Map<string, number[][]>()
  for (const [i, item] of read.array(root.poses, 'poses', 1, MAX_POSES).entries()) {
    const path = `poses[${i}]`
    const pose = read.object(item, path, ['name', 'joints'])
    for (const [name, value] of Object.entries(read.object(pose.joints, `${path}.joints`))) {
      const at = `${path}.joints.${name}`
      const rotation = read
        .array(value, at, 4, 4)
        .map((part, k) => read.number(part, `${at}[${k}]`, -1, 1, ''))
      const size = Math.sqrt(rotation.reduce((sum, part) => sum + part ** 2, 0))
      if (Math.abs(size - 1) > TOLERANCE)
        read.fail(`${at} is no rotation`, size, 'length 1', 'normalise the quaternion')
      found.set(name, [...(found.get(name) ?? []), rotation])
    }
  }
  return found
}

/**
 * Adds poses to the skeletons of surfaces, as if animations showed them.
 *
 * @throws FurrowError if no surface has a joint.
 */
export function withPoses(surfaces: readonly FoundSkin[], poses: JointPoses, who: string): FoundSkin[] {
  const names = [
    ...new Set(surfaces.flatMap(({ skin }) => skin.skeleton?.joints ?? []).map(({ name }) => name)),
  ]
  for (const name of poses.keys()) {
    if (names.includes(name)) continue
    throw new FurrowError({
      code: 'unknown-name',
      who,
      problem: 'no joint has this name',
      value: name,
      limit: names.join(', '),
      remedy: didYouMean(name, names, 'correct --poses'),
    })
  }
  return surfaces.map(({ skin, ...surface }) => {
    const { skeleton } = skin
    if (!skeleton) return { ...surface, skin }
    const joints = skeleton.joints.map((joint) => {
      const more = poses.get(joint.name) ?? []
      return { ...joint, rotations: [...Array.from(joint.rotations ?? []), ...more.flat()] }
    })
    return { ...surface, skin: { ...skin, skeleton: { ...skeleton, joints } } }
  })
}
