import { copyFileSync, existsSync, mkdirSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { NodeIO } from '@gltf-transform/core'
import { ALL_EXTENSIONS } from '@gltf-transform/extensions'
import { simplify, weld } from '@gltf-transform/functions'
import { MeshoptSimplifier } from 'meshoptimizer/simplifier'
import sharp from 'sharp'

const SCAN = fileURLToPath(new URL('../../../shared/real-face/ict-face.glb', import.meta.url))
/** Width and height of the normal maps in projects, texels. */
const MAP_SIZE = 1024
/** Fraction of the vertices of `faces/human.glb` to keep. 2,200 vertices remain. */
const LOW_RATIO = 0.17
/** Number of quads along each side of the sheet, which then has two million triangles. */
const SHEET_SIDE = 1000

/**
 * Writes the files that the benchmark's cases use into a folder.
 *
 * @param server result of `serve`, which loads modules of packages and tests.
 * @returns paths of the `avatars` by name, of the low-polygon avatar `low`, and of a flat `sheet` of two million triangles. `project(count)` writes a
 *   project with `count` wrinkle lines and returns its folder.
 */
export async function writeFiles(server, folder, { hasSheet }) {
  const { writeAvatars } = await server.ssrLoadModule('/test/pages/avatars.ts')
  const { sheet } = await server.ssrLoadModule('/test/pages/sheet.ts')
  const at = (name) => join(folder, name)
  await writeAvatars(folder)
  await writeLow(at('plain.glb'), at('low.glb'))
  if (hasSheet) writeFileSync(at('sheet.glb'), await sheet(SHEET_SIDE))
  const lines = await automaticLines(server, at('plain.glb'))
  return {
    avatars: { ...(existsSync(SCAN) && { scan: SCAN }), human: at('plain.glb'), vrm: at('turned.vrm') },
    low: at('low.glb'),
    sheet: hasSheet ? at('sheet.glb') : null,
    project: (count) => writeProject(at(`lines-${count}`), at('plain.glb'), lines, count),
  }
}

async function writeLow(from, to) {
  const io = new NodeIO().registerExtensions(ALL_EXTENSIONS)
  const document = await io.read(from)
  await document.transform(weld(), simplify({ simplifier: MeshoptSimplifier, ratio: LOW_RATIO, error: 1 }))
  await io.write(to, document)
}

/** Creates automatic wrinkles for a face. Returns a strokes document: the lines, and `scale`, the millimetres per unit of the face's positions. */
async function automaticLines(server, path) {
  const { autoWrinkles } = await server.ssrLoadModule('/packages/furrow/src/author/index.ts')
  const { strokesOf } = await server.ssrLoadModule('/packages/furrow/internal/index.ts')
  const { findSkin } = await server.ssrLoadModule('/packages/files/src/index.ts')
  const { readDocument } = await server.ssrLoadModule('/packages/files/src/node.ts')
  const { skin } = findSkin(await readDocument(path, 'bench'), path, 'bench')
  return strokesOf(autoWrinkles(skin, { size: 256 }))
}

/** Writes a project with `count` lines in one layer. The image of its only area is black, so the face does not show these lines until they are edited. */
async function writeProject(folder, face, { strokes, scale }, count) {
  mkdirSync(join(folder, 'areas'), { recursive: true })
  mkdirSync(join(folder, 'layers/lines'), { recursive: true })
  copyFileSync(face, join(folder, 'face.glb'))
  const image = (path, side, background) =>
    sharp({ create: { width: side, height: side, channels: 3, background } })
      .png()
      .toFile(join(folder, path))
  await image('areas/all.png', 128, '#000')
  await image('layers/lines/normal.png', MAP_SIZE, '#8080ff')
  const json = (path, data) => writeFileSync(join(folder, path), JSON.stringify(data))
  json('wrinkles.json', {
    version: 1,
    layers: [{ name: 'lines', kind: 'detail', normal: 'layers/lines/normal.png' }],
    areas: [{ name: 'all', image: 'areas/all.png', activation: 1 }],
    strokes: 'strokes.json',
  })
  json('strokes.json', { version: 1, scale, size: MAP_SIZE, strokes: manyLines(strokes, count) })
  return folder
}

/** Returns `count` lines: the automatic lines, followed by copies that are shifted in texture coordinates. */
function manyLines(strokes, count) {
  return Array.from({ length: count }, (_, i) => {
    const { layer: _layer, ...stroke } = strokes[i % strokes.length]
    const offset = 0.004 * Math.floor(i / strokes.length)
    const points = stroke.points.map(([u, v]) => [u + offset, v + 0.7 * offset])
    return { ...stroke, group: 'all', points }
  })
}
