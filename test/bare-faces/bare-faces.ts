import { createHash } from 'node:crypto'
import { existsSync, mkdirSync, readFileSync, renameSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { makeBare } from './make-bare.ts'

const fromHere = (path: string) => fileURLToPath(new URL(path, import.meta.url))

/** Face without wrinkles, textures, tangents or morph normals. Its blendshape names end in `_L` and `_R`, and its skin is the mesh `face`. */
export interface BareFace {
  readonly name: string
  readonly path: string
  /** Name of the skin's material. */
  readonly material: string
  /** Path of a strokes document made for the face's UV layout. */
  readonly strokes: string
}

const SCAN = fromHere('../../../shared/real-face/ict-face.glb')

/** List with the scanned face. Empty if its file is missing, because the file is not part of the repository. */
export const SCANS: readonly BareFace[] = existsSync(SCAN)
  ? [{ name: 'scan', path: SCAN, material: 'face', strokes: fromHere('scan-strokes.json') }]
  : []

/** A shipped face without its wrinkles, and the scanned face if present. */
export const BARE_FACES: readonly BareFace[] = [
  {
    name: 'bare human-2',
    path: await cachedBare(),
    material: 'skin',
    strokes: fromHere('../../faces/human/drawn.json'),
  },
  ...SCANS,
]

/** Returns the path of a copy of `human-2.glb` without wrinkles. The file is cached by a hash of its sources. */
async function cachedBare(): Promise<string> {
  const face = fromHere('../../faces/human-2.glb')
  const hash = createHash('sha256')
  for (const source of [face, fromHere('make-bare.ts')]) hash.update(readFileSync(source))
  const folder = fromHere('../../node_modules/.cache/furrow-tests')
  const path = join(folder, `bare-${hash.digest('hex').slice(0, 16)}.glb`)
  if (!existsSync(path)) {
    mkdirSync(folder, { recursive: true })
    // Test files run in parallel. Only a complete file gets the final name, so no test reads half a file.
    const part = `${path}.${process.pid}`
    writeFileSync(part, await makeBare(face))
    renameSync(part, path)
  }
  return path
}
