import type { Bone, Mesh, Object3D } from 'three'

/**
 * The joints of an avatar, each after the one that it hangs on, by their names in the file: its bones, or all nodes with a name where it has
 * none.
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

/** GLTFLoader keeps the name in the file where it had to change it. */
function nameOf({ name, userData }: Object3D): string {
  return typeof userData.name === 'string' ? userData.name : name
}
