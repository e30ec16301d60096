import { damageBytes } from './damage-bytes.ts'
import { hostileImage } from './damage-images.ts'
import { damageJson, textOf } from './damage-json.ts'
import { type Anything, type GlbParts, imageBytes, joinGlb, setImage, splitGlb } from './glb-parts.ts'
import type { Random } from './random.ts'

const EXTENSION = 'FURROW_wrinkle_maps'

/** Returns a damaged copy of a `.glb`, with one to three changes of its JSON, buffer or images, or a damaged container. */
export function damageGlb(face: Buffer, random: Random): Buffer {
  if (random.chance(0.08)) return damageContainer(face, random)
  let parts = splitGlb(face)
  for (let changes = random.pick([1, 1, 2, 3]); changes > 0; changes--) {
    try {
      parts = random.pick(DAMAGES)(parts, random) ?? parts
    } catch {
      // An earlier change removed the data that this one needs.
    }
  }
  return joinGlb(parts, textOf(parts.json))
}

type Damage = (parts: GlbParts, random: Random) => GlbParts | undefined

/** Returns a function that changes the part of the JSON that `find` returns. */
const below =
  (find: (json: Anything, random: Random) => Anything): Damage =>
  ({ json }, random) => {
    damageJson(find(json, random), random)
    return undefined
  }

const one = (list: Anything[], random: Random) => random.pick(list)

const DAMAGES: Damage[] = [
  below((json) => json),
  below((json, random) => one([json.accessors, json.bufferViews], random)),
  below((json, random) => one(json.accessors, random)),
  below((json, random) => one(json.bufferViews, random)),
  below((json) => json.meshes),
  below((json, random) => one([json.nodes, json.skins ?? json.nodes, json.scenes], random)),
  below((json, random) => one([json.images, json.textures, json.samplers ?? json.images], random)),
  wrinkles,
  wrinkles,
  wrinkles,
  damageAccessor,
  damageAccessor,
  damageNodes,
  damagePrimitive,
  damageImage,
  damageImage,
  damageData,
]

function wrinkles({ json }: GlbParts, random: Random): undefined {
  const extension = json.materials[0].extensions[EXTENSION]
  damageJson(random.chance(0.5) ? extension : random.pick(Object.values(extension)), random)
}

const COUNTS = [0, 1, 2, 3, 1000, 65_537, 1_500_000, 1e8, 1e9, 2 ** 31, 1e308]

function damageAccessor({ json }: GlbParts, random: Random): undefined {
  const accessor = random.pick<Anything>(json.accessors)
  const view = json.bufferViews[accessor.bufferView ?? 0]
  const sparse = {
    count: random.pick(COUNTS),
    indices: {
      bufferView: random.int(json.bufferViews.length),
      componentType: random.pick([5121, 5123, 5125, 5126]),
    },
    values: { bufferView: random.int(json.bufferViews.length), byteOffset: random.pick([0, 1, 4, 1e9]) },
  }
  random.pick([
    () => Object.assign(accessor, { count: random.pick(COUNTS) }),
    () => Object.assign(accessor, { sparse }),
    () => Object.assign(accessor, { sparse: { ...sparse, ...accessor.sparse, count: random.pick(COUNTS) } }),
    () => Object.assign(view, { byteStride: random.pick([0, 0.5, 1, 3, 4, 252, 1e9]) }),
    () =>
      Object.assign(accessor, { componentType: random.pick([5120, 5121, 5122, 5123, 5125, 5126, 5124, 0]) }),
    () =>
      Object.assign(accessor, {
        type: random.pick(['SCALAR', 'VEC2', 'VEC3', 'VEC4', 'MAT2', 'MAT3', 'MAT4']),
      }),
    () => Object.assign(accessor, { normalized: true }),
    () => Object.assign(accessor, { byteOffset: random.pick([1, 2, 3, 4, 1e6]) }),
    () => delete accessor.bufferView && Object.assign(accessor, { count: random.pick(COUNTS) }),
    () => Object.assign(accessor, { bufferView: random.int(json.bufferViews.length) }),
  ])()
}

function damageNodes({ json }: GlbParts, random: Random): undefined {
  const { nodes } = json
  const length = random.pick([10, 100, 1000, 20_000])
  const first = nodes.length
  const chain = (last: Anything) => {
    for (let i = 0; i < length; i++) nodes.push({ children: [first + i + 1] })
    nodes.push(last)
    json.scenes[0].nodes.push(first)
  }
  random.pick([
    () => chain({ name: 'end' }),
    () => chain({ mesh: 0 }),
    () => chain({ children: [first] }),
    () => Object.assign(nodes[0], { children: [0] }),
    () => Object.assign(nodes[0], { children: [1], skin: random.pick([0, 1, 99]) }),
    () =>
      Object.assign(random.pick<Anything>(nodes), {
        matrix: Array.from({ length: 16 }, () => random.pick([0, 1, 1e30])),
      }),
    () => Object.assign(random.pick<Anything>(nodes), { scale: [0, 1e-30, 1e30] }),
    () => json.scenes[0].nodes.push(random.int(nodes.length), random.int(nodes.length)),
  ])()
}

function damagePrimitive({ json }: GlbParts, random: Random): undefined {
  const mesh = random.pick<Anything>(json.meshes)
  const primitive = random.pick<Anything>(mesh.primitives)
  const accessor = () => random.int(json.accessors.length + 1)
  random.pick([
    () => Object.assign(primitive, { indices: accessor() }),
    () => Object.assign(primitive, { mode: random.pick([0, 1, 5, 6, 7, 4.5]) }),
    () =>
      Object.assign(primitive.attributes, { [random.pick(Object.keys(primitive.attributes))]: accessor() }),
    () => Object.assign(primitive.attributes, { TEXCOORD_1: accessor(), TANGENT: accessor() }),
    () =>
      primitive.targets.push(
        ...Array.from({ length: random.pick([1, 50, 2000]) }, () => ({ POSITION: accessor() })),
      ),
    () =>
      mesh.primitives.push(
        ...Array.from({ length: random.pick([1, 50, 3000]) }, () => structuredClone(primitive)),
      ),
    () =>
      Object.assign(mesh, { extras: { targetNames: random.pick<Anything>([7, [1, {}], [null], 'abc']) } }),
    () => delete primitive.material,
    () => delete primitive.attributes.POSITION,
  ])()
}

function damageImage(parts: GlbParts, random: Random): GlbParts {
  const image = random.int(parts.json.images.length)
  const mimeType = random.chance(0.2)
    ? random.pick(['image/png', 'image/jpeg', 'image/ktx2', 'image/webp'])
    : undefined
  return setImage(parts, image, hostileImage(random, imageBytes(parts, image)), mimeType)
}

function damageData({ json, bin }: GlbParts, random: Random): GlbParts {
  const damaged = damageBytes(bin, random)
  if (random.chance(0.5)) json.buffers[0].byteLength = random.pick([damaged.length, 0, 1e9, 2 ** 32])
  return { json, bin: damaged }
}

/** Returns a copy of a `.glb` with damage to headers, chunks or arbitrary bytes. */
function damageContainer(face: Buffer, random: Random): Buffer {
  if (random.chance(0.5)) return damageBytes(face, random)
  const damaged = Buffer.from(face)
  const at = random.pick([0, 4, 8, 12, 16, 20, 20 + face.readUInt32LE(12), 24 + face.readUInt32LE(12)])
  damaged.writeUInt32LE(random.pick([0, 1, 3, 2 ** 31, 2 ** 32 - 1, face.length, face.length - 1]), at)
  return damaged
}
