import { mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { dirname, join } from 'node:path'
import { checkWrinkles, decodeGlb, type Finding, type Glb, runKhronosValidator } from 'furrow-files'
import { readGlbFile } from 'furrow-files/node'
import sharp from 'sharp'
import { packCommand } from '../../packages/cli/src/commands/pack.ts'
import { faceFiles } from '../../packages/cli/src/face-outputs.ts'
import { seeded } from '../random.ts'
import { runAlone } from './pack-faces.ts'
import { vrmFile } from './vrm-file.ts'
import { type WrinkleJson, wrinkledFile } from './wrinkled-file.ts'

/** Files by path, base64. */
export type EncodedFiles = Record<string, string>

/** Face, and the result of packing the project into this face with `furrow pack`. */
export interface ExportCase {
  name: string
  /** Path of the face among `files`. */
  face: string
  files: EncodedFiles
  options: { ktx2?: boolean; size?: number }
  /** Packed face, base64. */
  packed: string
  findings: Finding[]
}

/** Invalid face, and the findings of `furrow validate`. */
export interface InvalidFace {
  name: string
  /** Bytes of the `.glb`, base64. */
  file: string
  findings: Finding[]
}

/** Inputs and expected results of the studio's export. */
export interface ExportCases {
  /** Files of the project. */
  project: EncodedFiles
  cases: ExportCase[]
  invalid: InvalidFace[]
}

const SIDE = 32

/**
 * Packs one project into faces in several formats, with maps as images and as KTX 2 arrays.
 *
 * @param root an empty folder.
 */
export async function exportCases(root: string): Promise<ExportCases> {
  const project = await projectFiles()
  writeFiles(join(root, 'project'), project)
  const glb = Buffer.from(await wrinkledFile())
  const faces: [face: string, files: Record<string, Uint8Array>][] = [
    ['face.glb', { 'face.glb': glb }],
    ['avatar.vrm', { 'avatar.vrm': await vrmFile(true) }],
    ['parts.gltf', await gltfFiles(glb)],
  ]
  const cases: ExportCase[] = []
  for (const [face, files] of faces) {
    writeFiles(join(root, 'faces'), files)
    for (const options of [{}, { ktx2: true }, { size: 20 }]) {
      const output = join(root, `${cases.length}.glb`)
      const words = Object.entries(options).flatMap(([name, value]) =>
        value === true ? [`--${name}`] : [`--${name}`, String(value)],
      )
      const path = join(root, 'faces', face)
      await runAlone(packCommand, [join(root, 'project'), '--face', path, '-o', output, '--json', ...words])
      cases.push({
        name: [face, ...words].join(' '),
        face,
        files: encoded(files),
        options,
        packed: readFileSync(output, 'base64'),
        findings: await findingsOf(await readGlbFile(output, 'test')),
      })
    }
  }
  return { project: encoded(project), cases, invalid: await Promise.all(ERRORS.map(invalidFace)) }
}

// biome-ignore lint/suspicious/noExplicitAny: tests edit the JSON of the file in ways that no type allows
const ERRORS: [name: string, spoil: (wrinkles: WrinkleJson) => unknown, edit: (json: any) => unknown][] = [
  ['an area on a missing layer', ({ areas }) => Object.assign(areas[1], { layer: 3 }), () => {}],
  ['a scene without a face', () => {}, ({ scenes }) => scenes[0].nodes.pop()],
  [
    'wrong bounds',
    () => {},
    ({ accessors }) => Object.assign(accessors[0], { max: [0, 0, 0], min: [0, 0, 0] }),
  ],
  ['data that make the Khronos validator give up', () => {}, misalign],
]

function misalign({ accessors }: { accessors: object[] }): void {
  const indices = { bufferView: 0, byteOffset: 1, componentType: 5125 }
  Object.assign(accessors[0], { sparse: { count: 1, indices, values: { bufferView: 0 } } })
}

async function invalidFace([name, spoil, edit]: (typeof ERRORS)[number]): Promise<InvalidFace> {
  const bytes = Buffer.from(await wrinkledFile(spoil, edit))
  const glb = decodeGlb(bytes, 'face.glb', 'test')
  return { name, file: bytes.toString('base64'), findings: await findingsOf(glb) }
}

async function findingsOf(glb: Glb): Promise<Finding[]> {
  return [...(await checkWrinkles(glb)), ...(await runKhronosValidator(glb))]
}

/** Makes maps and areas in formats that users save: gray, indexed, 16-bit, with a colour profile. Adds one unrelated file. */
async function projectFiles(): Promise<Record<string, Uint8Array>> {
  const colours = (seed: number) => sharp(noise(seed, 3), { raw: raw(3) })
  const gray = (seed: number) => sharp(noise(seed, 1), { raw: raw(1) }).toColourspace('b-w')
  const document = {
    version: 1,
    layers: [{ name: 'age' }, { name: 'smile', kind: 'detail', normalScale: 0.5 }],
    areas: ['brow', 'cheek', 'chin', 'eye', 'nose'].map((name, i) => ({
      name,
      layer: i % 2 ? 'smile' : 'age',
    })),
    drivers: [{ type: 'morph', area: 'brow', targets: [{ name: 'missing' }] }],
    areaSize: 16,
  }
  return {
    'wrinkles.json': Buffer.from(JSON.stringify(document)),
    'notes.txt': Buffer.from('paint the chin'),
    'layers/age/normal.png': await colours(1).png().toBuffer(),
    'layers/age/roughness.png': await gray(2).png().toBuffer(),
    'layers/smile/normal.png': await colours(3).toColourspace('rgb16').png().toBuffer(),
    'layers/smile/baseColor.png': await colours(4).png({ palette: true, progressive: true }).toBuffer(),
    'areas/brow.png': await gray(5).png().toBuffer(),
    'areas/cheek.png': await gray(6).toColourspace('grey16').png().toBuffer(),
    'areas/chin.png': await colours(7).png({ palette: true }).toBuffer(),
    'areas/eye.png': await colours(8).ensureAlpha().withIccProfile('p3').png().toBuffer(),
    'areas/nose.png': await gray(9).resize(100, 60).png({ progressive: true }).toBuffer(),
  }
}

/** Converts a `.glb` to a `.gltf` with separate buffer and images. */
async function gltfFiles(glb: Uint8Array): Promise<Record<string, Uint8Array>> {
  const files = await faceFiles(decodeGlb(glb, 'face.glb', 'test'), 'parts.gltf', 'test')
  return Object.fromEntries(files.map(({ path, bytes }) => [path, bytes]))
}

const raw = <N extends 1 | 3>(channels: N) => ({ width: SIDE, height: SIDE, channels })

function noise(seed: number, channels: number): Uint8Array {
  const next = seeded(seed)
  return Uint8Array.from({ length: SIDE * SIDE * channels }, () => Math.floor(256 * next()))
}

function writeFiles(folder: string, files: Record<string, Uint8Array>): void {
  for (const [path, bytes] of Object.entries(files)) {
    mkdirSync(dirname(join(folder, path)), { recursive: true })
    writeFileSync(join(folder, path), bytes)
  }
}

function encoded(files: Record<string, Uint8Array>): EncodedFiles {
  const entries = Object.entries(files)
  return Object.fromEntries(entries.map(([path, bytes]) => [path, Buffer.from(bytes).toString('base64')]))
}
