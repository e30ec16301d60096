import type { Skin, SkinJoint, SkinSkeleton } from 'furrow/author'
import { joinParts, type PartInfluences } from 'furrow/internal'
import { placementOf } from 'furrow/internal/three'
import { humanBonesOf } from 'furrow-files'
import {
  type AnimationClip,
  type BufferGeometry,
  type KeyframeTrack,
  Matrix4,
  type Mesh,
  type Object3D,
  PropertyBinding,
  Quaternion,
  type SkinnedMesh,
} from 'three'
import type { GLTF } from 'three/addons/loaders/GLTFLoader.js'

/** Maximum number of rotations per joint that are read from animations. Longer animations are sampled. */
const MAX_ROTATIONS = 256

/** Returns the name of a node in the file. GLTFLoader keeps it in `userData` if it renamed the node. */
export function fileName({ name, userData }: Object3D): string {
  return typeof userData.name === 'string' ? userData.name : name
}

/** Reads the joints that move a mesh, in world space. Returns undefined if no skeleton moves it. */
export type JointReader = (mesh: Mesh) => SkinJoint[] | undefined

/** Creates the reader for the meshes of a file, which must be in its rest pose. */
export function jointReader({ scene, animations, parser }: GLTF): JointReader {
  const bones = humanBonesOf(parser.json)
  const motion = rotationsOf(scene, animations)
  return (mesh) => {
    const { skeleton } = mesh as SkinnedMesh
    if (!skeleton) return undefined
    const toWorld = placementOf(mesh)
    const binds = skeleton.boneInverses.map((inverse) => inverse.clone().invert().premultiply(toWorld))
    return skeleton.bones.map((bone, i) => {
      const parent = nearestJoint(bone, skeleton.bones)
      const node = parser.associations.get(bone)?.nodes
      const humanBone = node === undefined ? undefined : bones.get(node)
      const isDirect = parent >= 0 && bone.parent === skeleton.bones[parent]
      const rest = isDirect
        ? rotationOf(binds[parent]).invert().multiply(rotationOf(binds[i]))
        : bone.quaternion
      return {
        name: fileName(bone) || String(node),
        parent,
        bind: binds[i].toArray(),
        ...(humanBone !== undefined && { humanBone }),
        rotations: fromRest(motion.get(bone) ?? [], rest),
      }
    })
  }
}

/** Returns the skeleton of a skin, with joints and weights in the order of the vertices of `skinOf`. */
export function skeletonOf(
  meshes: readonly Mesh[],
  joints: readonly SkinJoint[] | undefined,
): SkinSkeleton | undefined {
  if (!joints) return undefined
  const parts = meshes.map(({ geometry }) => {
    const { count } = geometry.attributes.position
    return {
      count,
      indices: geometry.index?.array ?? Uint32Array.from({ length: count }, (_, i) => i),
      readPositions() {},
      readUvs() {},
      readOffsets() {},
      influences: influencesOf(geometry),
    }
  })
  return joinParts(parts, [], undefined, undefined, joints).skeleton
}

/** Returns a skin that no joints move. */
export function withoutSkeleton({ skeleton: _, ...skin }: Skin): Skin {
  return skin
}

/** Reads the influences of all sets of four joints. three.js uses the first set, and GLTFLoader keeps the others as custom attributes. */
function influencesOf({ attributes }: BufferGeometry): PartInfluences | undefined {
  const sets = [[attributes.skinIndex, attributes.skinWeight]]
  for (let i = 1; attributes[`joints_${i}`] && attributes[`weights_${i}`]; i++)
    sets.push([attributes[`joints_${i}`], attributes[`weights_${i}`]])
  if (!sets[0][0] || !sets[0][1]) return undefined
  const count = 4 * sets.length
  return {
    count,
    read(vertices, joints, weights) {
      for (const [set, [joint, weight]] of sets.entries()) {
        for (let i = 0; i < vertices.length; i++) {
          for (let k = 0; k < 4; k++) {
            joints[count * i + 4 * set + k] = joint.getComponent(vertices[i], k)
            weights[count * i + 4 * set + k] = weight.getComponent(vertices[i], k)
          }
        }
      }
    },
  }
}

/** Returns the index of the nearest ancestor of a node that is a joint; -1 if there is none. */
function nearestJoint(node: Object3D, joints: readonly Object3D[]): number {
  for (let above = node.parent; above; above = above.parent) {
    const index = joints.indexOf(above)
    if (index >= 0) return index
  }
  return -1
}

function rotationOf(matrix: Matrix4): Quaternion {
  return new Quaternion().setFromRotationMatrix(new Matrix4().extractRotation(matrix))
}

/** Returns the rotations that animations give each node. */
function rotationsOf(root: Object3D, animations: readonly AnimationClip[]): Map<Object3D, Quaternion[]> {
  const found = new Map<Object3D, Quaternion[]>()
  for (const track of animations.flatMap(({ tracks }) => tracks)) {
    const { nodeName, propertyName } = PropertyBinding.parseTrackName(track.name)
    if (propertyName !== 'quaternion') continue
    const node = PropertyBinding.findNode(root, nodeName) as Object3D | undefined
    if (node) found.set(node, [...(found.get(node) ?? []), ...quaternionsOf(track)])
  }
  return found
}

function quaternionsOf(track: KeyframeTrack): Quaternion[] {
  // A cubic spline stores two tangents with each rotation.
  const size = track.getValueSize()
  const first = size === 12 ? 4 : 0
  const keys = track.times.length
  const every = Math.max(1, Math.ceil(keys / MAX_ROTATIONS))
  return Array.from({ length: Math.ceil(keys / every) }, (_, i) =>
    new Quaternion().fromArray(track.values, size * i * every + first),
  )
}

/** Returns rotations relative to the rest pose, packed. */
function fromRest(rotations: readonly Quaternion[], rest: Quaternion): Float32Array {
  const inverse = rest.clone().invert()
  return Float32Array.from(rotations.flatMap((rotation) => inverse.clone().multiply(rotation).toArray()))
}
