import type { WrinkleSetDocument } from 'furrow'
import { fileNamesOf } from 'furrow/internal'
import { addressOf, encodePortablePng, encodeSculpted, paintedArea, WRINKLES_FILE } from 'furrow-files'
import { MAP_NAMES, type MapName } from '../document/document.ts'
import { type DocumentToPack, type PackedLayer, packedLayers } from '../document/packed-layers.ts'
import { heightMapOf } from '../document/sculpted.ts'
import { strokesDocument } from '../document/stroke-document.ts'
import type { AvatarFile, FolderFile } from '../files/folder-files.ts'
import {
  automaticParts,
  type DrawnLayer,
  FACE_FOLDER,
  STUDIO_FILE,
  type StudioFile,
  TAKES,
  UNDER,
} from './studio-file.ts'
import { takeFile } from './take-file.ts'

const EXTENSIONS: Record<string, string> = { 'image/jpeg': 'jpg', 'image/webp': 'webp', 'image/avif': 'avif' }

/**
 * Makes the files of a project folder for `furrow pack`: `wrinkles.json`, `layers/NAME/*.png` (sculpted heights are in `sculpted.png`),
 * `areas/NAME.png` (with the convention `paper`), `strokes.json` and `face.glb`. Data that these files cannot contain is in `studio.json` and `takes/NAME.json`. A face with several files is in the folder `face`,
 * for `furrow pack --face`.
 *
 * @param face files of the avatar: the glTF or VRM file, followed by the files that it references.
 */
export function folderFiles(source: DocumentToPack, face: readonly AvatarFile[]): FolderFile[] {
  const { document } = source
  const layers = layerFiles(source)
  const areaNames = fileNamesOf(document.areas.map(({ name }) => name))
  const areaPaths = areaNames.map((name) => `areas/${name}.png`)
  const areaImages = document.areas.map(({ weights }, i) => ({
    path: areaPaths[i],
    content: encodePortablePng(paintedArea(weights)),
  }))
  const images = [...layers.images, ...areaImages]
  const { takes = [] } = document
  const takeNames = fileNamesOf(takes.map(({ name }) => name))
  const takeFiles = takes.map((take, i) => ({
    path: `${TAKES}/${takeNames[i]}.json`,
    content: takeFile(take),
  }))
  const strokes = strokesDocument(document)
  const set: WrinkleSetDocument = {
    version: 1,
    ...(document.mesh !== undefined && { mesh: document.mesh }),
    ...(document.material !== undefined && { material: document.material }),
    layers: layers.entries,
    areas: document.areas.map(({ name, layer, combine, activation }, i) => ({
      name,
      image: addressOf(areaPaths[i]),
      layer,
      ...(combine !== 'sum' && { combine }),
      ...(activation !== 0 && { activation }),
    })),
    ...(document.drivers.length > 0 && { drivers: [...document.drivers] }),
    areaSize: document.areaSize,
    ...(strokes && { strokes: 'strokes.json' }),
    ...(document.shapes && { shapes: document.shapes }),
  }
  const faceFiles = filesOfFace(face)
  const studio: StudioFile = {
    version: 1,
    scale: document.scale,
    mapSize: document.mapSize,
    ...(document.auto && { auto: document.auto }),
    ...automaticParts(document),
    layers: layers.drawn,
    ...(face.length > 0 && { face: { path: faceFiles[0].path, name: face[0].path } }),
    ...(takeFiles.length > 0 && { takes: takeFiles.map(({ path }) => path) }),
    files: [...images, ...takeFiles].map(({ path }) => path).sort(),
  }
  // Write the JSON files last, so that they never refer to images that are not written yet.
  return [
    ...faceFiles,
    ...images,
    ...takeFiles,
    ...(strokes ? [{ path: 'strokes.json', content: jsonFile(strokes) }] : []),
    { path: WRINKLES_FILE, content: jsonFile(set) },
    { path: STUDIO_FILE, content: jsonFile(studio) },
  ]
}

type LayerEntry = WrinkleSetDocument['layers'][number]

function layerFiles(source: DocumentToPack): {
  images: FolderFile[]
  entries: LayerEntry[]
  drawn: Record<string, DrawnLayer>
} {
  const names = fileNamesOf(source.document.layers.map(({ name }) => name))
  const images: FolderFile[] = []
  const replaced: [string, DrawnLayer][] = []
  const add = (folder: string, maps: PackedLayer['maps']) =>
    Object.fromEntries(
      MAP_NAMES.flatMap((map) => {
        const image = maps[map]
        if (!image) return []
        const { mimeType, bytes } =
          'bytes' in image ? image : { mimeType: 'image/png', bytes: encodePortablePng(image) }
        const path = `${folder}/${map}.${EXTENSIONS[mimeType] ?? 'png'}`
        images.push({ path, content: bytes })
        return [[map, addressOf(path)]]
      }),
    ) as { [Name in MapName]?: string }
  const entries = packedLayers(source).map(({ layer, maps, drawn, heightAmplitude }, i) => {
    const { name, kind, maps: own, normalScale, occlusionStrength, bloodAmplitude, onsetStrength } = layer
    const sculpted = `layers/${names[i]}/sculpted.png`
    if (layer.sculpted) images.push({ path: sculpted, content: encodeSculpted(heightMapOf(layer.sculpted)) })
    if (drawn.length > 0) {
      const covered = Object.fromEntries(drawn.flatMap((map) => (own[map] ? [[map, own[map]]] : [])))
      const under = add(`${UNDER}/${names[i]}`, covered)
      const amplitude = layer.heightAmplitude
      replaced.push([name, { drawn, under, ...(amplitude !== undefined && { heightAmplitude: amplitude }) }])
    }
    return {
      name,
      kind,
      ...add(`layers/${names[i]}`, maps),
      ...(normalScale !== 1 && { normalScale }),
      ...(occlusionStrength !== 1 && { occlusionStrength }),
      ...(heightAmplitude !== undefined && { heightAmplitude }),
      ...(bloodAmplitude !== undefined && { bloodAmplitude }),
      ...(onsetStrength !== undefined && { onsetStrength }),
      ...(layer.sculpted && { sculpted: addressOf(sculpted) }),
    } as LayerEntry
  })
  return { images, entries, drawn: Object.fromEntries(replaced) }
}

function filesOfFace(face: readonly AvatarFile[]): FolderFile[] {
  if (face.length === 1 && /\.(glb|vrm)$/i.test(face[0].path))
    return [{ path: 'face.glb', content: face[0].file }]
  return face.map(({ path, file }) => ({ path: `${FACE_FOLDER}/${path}`, content: file }))
}

function jsonFile(json: unknown): Uint8Array {
  return new TextEncoder().encode(`${JSON.stringify(json, null, 2)}\n`)
}
