import { readFileSync, writeFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { type Document, Logger, type Mesh, NodeIO, type Primitive } from '@gltf-transform/core'
import { ALL_EXTENSIONS } from '@gltf-transform/extensions'
import draco3d from 'draco3d'
import { driversOf, type GrayImage } from 'furrow'
import { faceShapeFinder } from 'furrow/internal'
import { type WrinkledFile, weightsOf } from 'furrow-files'
import { readWrinkledFile } from 'furrow-files/node'
import { MeshoptDecoder } from 'meshoptimizer/decoder'
import { MeshoptEncoder } from 'meshoptimizer/encoder'
import { beforeAll } from 'vitest'
import { imageOf } from '../../../packages/files/src/gltf/texture-image.ts'
import { decodeImage } from '../../../packages/files/src/images/codec.node.ts'
import { driven } from '../../driven.ts'
import type { Workshop } from './workshop.ts'

export const HUMAN = fileURLToPath(new URL('../../../faces/human.glb', import.meta.url))

/** Poses to compare, as weights of ARKit blendshapes. */
const POSES: readonly Readonly<Record<string, number>>[] = [
  { browInnerUp: 1, browOuterUpLeft: 1, browOuterUpRight: 1 },
  { browDownLeft: 1, browDownRight: 1 },
  { browOuterUpLeft: 0.7 },
  { mouthSmileLeft: 1, cheekSquintLeft: 0.5 },
  { mouthSmileRight: 0.8, mouthSmileLeft: 0.8 },
  { eyeSquintRight: 1, noseSneerRight: 1 },
  { mouthPucker: 1 },
  { jawOpen: 1 },
]

let io: NodeIO | undefined

/** Returns an IO of glTF-Transform that supports all compressed formats. */
export async function anyIO(): Promise<NodeIO> {
  if (io) return io
  await Promise.all([MeshoptDecoder.ready, MeshoptEncoder.ready])
  io = new NodeIO()
    .setLogger(new Logger(Logger.Verbosity.SILENT))
    .registerExtensions(ALL_EXTENSIONS)
    .registerDependencies({
      'draco3d.decoder': await draco3d.createDecoderModule(),
      'draco3d.encoder': await draco3d.createEncoderModule(),
      'meshopt.decoder': MeshoptDecoder,
      'meshopt.encoder': MeshoptEncoder,
    })
  return io
}

/** Reads the shipped face, or another file. Wrinkles are dropped, because `anyIO` does not know their extension. */
export async function plainFace(path = HUMAN): Promise<Document> {
  return (await anyIO()).readBinary(new Uint8Array(readFileSync(path)))
}

export function meshOf(document: Document, name: string): Mesh {
  return document
    .getRoot()
    .listMeshes()
    .find((mesh) => mesh.getName() === name)!
}

export function targetNamesOf(mesh: Mesh): string[] {
  return mesh.getExtras().targetNames as string[]
}

/** Changes every element of an attribute of primitives or morph targets. */
export function mapAttribute(
  primitives: readonly (Primitive | ReturnType<Primitive['listTargets']>[number])[],
  semantic: string,
  change: (values: number[]) => number[],
): void {
  const done = new Set<unknown>()
  for (const primitive of primitives) {
    const accessor = primitive.getAttribute(semantic)
    if (!accessor || done.has(accessor)) continue
    done.add(accessor)
    for (let i = 0; i < accessor.getCount(); i++) accessor.setElement(i, change(accessor.getElement(i, [])))
  }
}

/** File made by `furrow auto`. */
export interface AutoOutput {
  /** Path of the input. */
  plain: string
  /** Path of the output. */
  path: string
  file: WrinkledFile
  areas: ReadonlyMap<string, GrayImage>
  /** Output of the command on stdout. */
  printed: string
  /** Output of the command on stderr. */
  warned: string
}

/** Writes a document, runs `furrow auto`, and reads the result. */
export async function makeWrinkles(
  workshop: Workshop,
  name: string,
  document: Document,
  ...options: string[]
): Promise<AutoOutput> {
  const plain = workshop.path(`${name}.glb`)
  writeFileSync(plain, await (await anyIO()).writeBinary(document))
  return wrinklesOf(workshop, plain, ...options)
}

/** Runs `furrow auto` on a file, and reads the result. */
export async function wrinklesOf(
  workshop: Workshop,
  plain: string,
  ...options: string[]
): Promise<AutoOutput> {
  const path = plain.replace(/\.glb$/, '-wrinkled.glb')
  workshop.printed = ''
  workshop.warned = ''
  await workshop.run('auto', plain, '-o', path, '--size', '512', ...options)
  const file = await readWrinkledFile(path, 'test')
  const weights = await Promise.all(file.maps.areas.map((_, i) => weightsOf(file, i, 'test')))
  const areas = new Map(file.maps.areas.map(({ name: area }, i) => [area, weights[i]!]))
  return { plain, path, file, areas, printed: workshop.printed, warned: workshop.warned }
}

/** Runs `furrow auto` on the shipped face before the first test of a file. Returns a function that returns the result. */
export function plainWrinkles(workshop: Workshop): () => AutoOutput {
  let made: AutoOutput
  beforeAll(async () => {
    made = await makeWrinkles(workshop, 'face', await plainFace())
  })
  return () => made
}

export function activationsOf(
  { file }: AutoOutput,
  pose: Readonly<Record<string, number>>,
): Map<string, number> {
  const { meshes = [] } = file.glb.json
  const mesh = meshes.find(({ primitives }) => primitives.some(({ material }) => material === file.material))!
  const names = mesh.extras!.targetNames as string[]
  const weights = new Float32Array(names.length)
  const find = faceShapeFinder(names)
  for (const [shape, weight] of Object.entries(pose))
    for (const target of find(shape)) weights[target] = weight
  return new Map(
    Object.entries(driven(driversOf('morph', file.maps.drivers), names).activations({ weights })),
  )
}

/** Returns the largest difference of any activation over all `POSES`. */
export function activationsApart(a: AutoOutput, b: AutoOutput): number {
  return Math.max(
    ...POSES.flatMap((pose) => {
      const [first, second] = [activationsOf(a, pose), activationsOf(b, pose)]
      return [...first].map(([area, value]) => Math.abs(value - (second.get(area) ?? 0)))
    }),
  )
}

/** Returns the largest mean difference of an area's weights, in levels of 255. The mean is over texels where either weight is not 0. */
export function areasApart(a: AutoOutput, b: AutoOutput, names = [...a.areas.keys()]): number {
  return Math.max(...names.map((name) => levelsApart(a.areas.get(name)!.data, b.areas.get(name)!.data)))
}

export function levelsApart(first: ArrayLike<number>, second: ArrayLike<number>): number {
  let [sum, count] = [0, 0]
  for (let i = 0; i < first.length; i++) {
    if (first[i] === 0 && second[i] === 0) continue
    sum += Math.abs(first[i]! - second[i]!)
    count++
  }
  return count > 0 ? sum / count : 0
}

/** Returns the largest mean angle, degrees, between the normals of a layer. The mean is over texels where at least one normal is not flat. */
export async function normalsApart(a: AutoOutput, b: AutoOutput): Promise<number> {
  const angles = await Promise.all(
    a.file.maps.layers.map(async (_, layer) => {
      const [first, second] = await Promise.all([a, b].map(({ file }) => normalsOf(file, layer)))
      return meanAngle(first!, second!)
    }),
  )
  return Math.max(...angles)
}

async function normalsOf(file: WrinkledFile, layer: number): Promise<Uint8Array> {
  const image = imageOf(file.glb, file.maps.layers[layer]!.normalTexture.index, 'test')
  return (await decodeImage(image.bytes, 'normals', 'test')).data
}

/** Returns the mean angle between two normal maps with three bytes per texel, degrees. */
function meanAngle(first: Uint8Array, second: Uint8Array): number {
  let [sum, count] = [0, 0]
  for (let i = 0; i < first.length; i += 3) {
    const [a, b] = [first, second].map((data) => [0, 1, 2].map((k) => data[i + k]! / 127.5 - 1)) as [
      number[],
      number[],
    ]
    if (Math.max(Math.hypot(a[0]!, a[1]!), Math.hypot(b[0]!, b[1]!)) < 0.05) continue
    const cosine = a.reduce((dot, value, k) => dot + value * b[k]!, 0) / Math.hypot(...a) / Math.hypot(...b)
    sum += (Math.acos(Math.min(1, cosine)) * 180) / Math.PI
    count++
  }
  return count > 0 ? sum / count : 0
}
