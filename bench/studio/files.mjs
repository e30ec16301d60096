import { copyFileSync, existsSync, mkdirSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { NodeIO } from '@gltf-transform/core'
import { ALL_EXTENSIONS } from '@gltf-transform/extensions'
import { simplify, weld } from '@gltf-transform/functions'
import { MeshoptSimplifier } from 'meshoptimizer/simplifier'
import sharp from 'sharp'

const SCAN = fileURLToPath(new URL('../../../shared/real-face/ict-face.glb', import.meta.url))
/** Side of the maps of projects. */
const MAP = 1024
/** Of the vertices of the shipped face: 2,200 stay. */
const LOW = 0.17
/** Of a sheet of two million triangles. */
const SIDE = 1000

/**
 * Writes the files that the studio is measured with into a folder.
 *
 * @param server of `serve`, for the sources of packages and tests.
 * @returns paths of `avatars`, of the avatar `low` with few polygons and of the `sheet` of two million triangles; `project` makes a folder
 *   with a number of lines.
 */
export async function writeFiles(server, folder, { hasSheet }) {
  const { writeAvatars } = await server.ssrLoadModule('/test/pages/avatars.ts')
  const { sheet } = await server.ssrLoadModule('/test/pages/sheet.ts')
  const at = (name) => join(folder, name)
  await writeAvatars(folder)
  await writeLow(at('plain.glb'), at('low.glb'))
  if (hasSheet) writeFileSync(at('sheet.glb'), await sheet(SIDE))
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
  await document.transform(weld(), simplify({ simplifier: MeshoptSimplifier, ratio: LOW, error: 1 }))
  await io.write(to, document)
}

/** The lines of the face's own wrinkles, and its scale. */
async function automaticLines(server, path) {
  const { autoWrinkles } = await server.ssrLoadModule('/packages/furrow/src/author/index.ts')
  const { strokesOf } = await server.ssrLoadModule('/packages/furrow/internal/index.ts')
  const { findSkin } = await server.ssrLoadModule('/packages/files/src/index.ts')
  const { readDocument } = await server.ssrLoadModule('/packages/files/src/node.ts')
  const { skin } = findSkin(await readDocument(path, 'bench'), path, 'bench')
  return strokesOf(autoWrinkles(skin, { size: 256 }))
}

/** A project's folder: one layer with a number of lines, and one area that shows all of it at rest. */
async function writeProject(folder, face, { strokes, scale }, count) {
  mkdirSync(join(folder, 'areas'), { recursive: true })
  mkdirSync(join(folder, 'layers/lines'), { recursive: true })
  copyFileSync(face, join(folder, 'face.glb'))
  const image = (path, side, background) =>
    sharp({ create: { width: side, height: side, channels: 3, background } })
      .png()
      .toFile(join(folder, path))
  await image('areas/all.png', 128, '#000')
  await image('layers/lines/normal.png', MAP, '#8080ff')
  const json = (path, data) => writeFileSync(join(folder, path), JSON.stringify(data))
  json('wrinkles.json', {
    version: 1,
    layers: [{ name: 'lines', kind: 'detail', normal: 'layers/lines/normal.png' }],
    areas: [{ name: 'all', image: 'areas/all.png', activation: 1 }],
    strokes: 'strokes.json',
  })
  json('strokes.json', { version: 1, scale, size: MAP, strokes: manyLines(strokes, count) })
  return folder
}

/** The automatic lines of the face, and again beside themselves until there are enough. */
function manyLines(strokes, count) {
  return Array.from({ length: count }, (_, i) => {
    const { layer: _layer, ...stroke } = strokes[i % strokes.length]
    const aside = 0.004 * Math.floor(i / strokes.length)
    const points = stroke.points.map(([u, v]) => [u + aside, v + 0.7 * aside])
    return { ...stroke, group: 'all', points }
  })
}
