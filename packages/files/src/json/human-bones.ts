import type { GltfJson } from './gltf-json.ts'

/** Bones of VRM 1 that VRM 0 calls by the names of other bones. */
const VRM0_THUMBS: readonly (readonly [vrm0: RegExp, vrm1: string])[] = [
  [/ThumbProximal$/, 'ThumbMetacarpal'],
  [/ThumbIntermediate$/, 'ThumbProximal'],
]

/** Returns the names of the humanoid bones that a VRM file assigns to nodes, by index of the node. The names are those of VRM 1. */
export function humanBonesOf({ extensions = {} }: GltfJson): Map<number, string> {
  const found = new Map<number, string>()
  const one = (extensions.VRMC_vrm as Humanoid<Record<string, Bone>> | undefined)?.humanoid?.humanBones
  for (const [name, bone] of Object.entries(one ?? {}))
    if (typeof bone?.node === 'number') found.set(bone.node, name)
  if (found.size > 0) return found
  const zero = (extensions.VRM as Humanoid<Bone[]> | undefined)?.humanoid?.humanBones
  for (const { bone: name, node } of Array.isArray(zero) ? zero : []) {
    if (typeof node !== 'number' || typeof name !== 'string') continue
    const renamed = VRM0_THUMBS.find(([pattern]) => pattern.test(name))
    found.set(node, renamed ? name.replace(renamed[0], renamed[1]) : name)
  }
  return found
}

interface Bone {
  bone?: unknown
  node?: unknown
}

interface Humanoid<Bones> {
  humanoid?: { humanBones?: Bones }
}
