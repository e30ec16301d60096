import { isObject } from '../core/argument.ts'

/** Bones of VRM 1 that VRM 0 calls by the names of other bones. */
const VRM0_THUMBS: readonly (readonly [vrm0: RegExp, vrm1: string])[] = [
  [/ThumbProximal$/, 'ThumbMetacarpal'],
  [/ThumbIntermediate$/, 'ThumbProximal'],
]

interface HumanoidJson {
  humanoid?: { humanBones?: unknown }
}

/**
 * Returns the names of the humanoid bones that a VRM file assigns to nodes, by index of the node. The names are those of VRM 1.
 *
 * @param json JSON of the file. Malformed parts are ignored.
 */
export function humanBonesOf({ extensions }: { extensions?: object | undefined }): Map<number, string> {
  const { VRMC_vrm: one, VRM: zero } = (extensions ?? {}) as Record<string, HumanoidJson | undefined>
  const found = new Map<number, string>()
  const bones = one?.humanoid?.humanBones
  for (const [name, bone] of Object.entries(isObject(bones) ? bones : {}))
    if (typeof bone?.node === 'number') found.set(bone.node, name)
  if (found.size > 0) return found
  const list = zero?.humanoid?.humanBones
  for (const { bone: name, node } of Array.isArray(list) ? list : []) {
    if (typeof node !== 'number' || typeof name !== 'string') continue
    const renamed = VRM0_THUMBS.find(([pattern]) => pattern.test(name))
    found.set(node, renamed ? name.replace(renamed[0], renamed[1]) : name)
  }
  return found
}
