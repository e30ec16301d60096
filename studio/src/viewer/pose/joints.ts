import type { Bone, Mesh, Object3D } from 'three'
import { fileName } from '../../open/rest-skeleton.ts'

/**
 * Lists the joints of an avatar, parents first. Each entry has the names of the parent and of the joint, as in the file. If the avatar has no
 * bones, lists all named nodes.
 */
export function jointsOf(root: Object3D): [from: string, joint: string][] {
  const nodes: Object3D[] = []
  root.traverse((node) => {
    if (!(node as Mesh).isMesh && fileName(node) !== '' && node.parent && fileName(node.parent) !== '')
      nodes.push(node)
  })
  const bones = nodes.filter((node) => (node as Bone).isBone && (node.parent as Bone).isBone)
  return (bones.length > 0 ? bones : nodes).map((node) => [fileName(node.parent!), fileName(node)])
}
