import type { Bone, Mesh, Object3D } from 'three'

/**
 * Lists the joints of an avatar, parents first. Each entry has the names of the parent and of the joint, as in the file. If the avatar has no
 * bones, lists all named nodes.
 */
export function jointsOf(root: Object3D): [from: string, joint: string][] {
  const nodes: Object3D[] = []
  root.traverse((node) => {
    if (!(node as Mesh).isMesh && nameOf(node) !== '' && node.parent && nameOf(node.parent) !== '')
      nodes.push(node)
  })
  const bones = nodes.filter((node) => (node as Bone).isBone && (node.parent as Bone).isBone)
  return (bones.length > 0 ? bones : nodes).map((node) => [nameOf(node.parent!), nameOf(node)])
}

/** GLTFLoader keeps the original name in `userData` if it renamed the node. */
function nameOf({ name, userData }: Object3D): string {
  return typeof userData.name === 'string' ? userData.name : name
}
