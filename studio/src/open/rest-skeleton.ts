import type { SkinJoint } from 'furrow/author'
import { skinJoints } from 'furrow/internal'
import { readBoundSkin } from 'furrow/internal/three'
import type { Mesh, Object3D } from 'three'
import type { GLTFParser } from 'three/addons/loaders/GLTFLoader.js'

/** Returns the name of a node in the file. GLTFLoader keeps it in `userData` if it renamed the node. */
export function fileName({ name, userData }: Object3D): string {
  return typeof userData.name === 'string' ? userData.name : name
}

/** Reads the joints that move a mesh, in world space. Returns undefined if no skeleton moves it. */
export type JointReader = (mesh: Mesh) => SkinJoint[] | undefined

/**
 * Creates the reader for the meshes of a file, which must be in its rest pose.
 *
 * @param rotations rotations that animations give nodes: quaternions (x, y, z, w), by index of the node.
 */
export function jointReader(
  parser: GLTFParser,
  rotations: ReadonlyMap<number, readonly number[][]> = new Map(),
): JointReader {
  return (mesh) => {
    const bound = readBoundSkin(parser, mesh)
    return bound && skinJoints(parser.json, bound.skin, bound.binds, rotations)
  }
}
