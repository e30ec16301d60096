import type { WrinkleSetDocument } from 'furrow'
import { fileNamesOf, isFileName, type StrokesDocument } from 'furrow/author'
import { addressOf, type Pixels, paintedArea, WRINKLES_FILE } from 'furrow-files'
import {
  type ImageFile,
  MAP_NAMES,
  type MapName,
  type StudioDocument,
  type StudioLayer,
} from '../document/document.ts'
import type { AvatarFile, FolderFile } from '../files/folder-files.ts'
import {
  automaticParts,
  type DrawnLayer,
  FACE_FOLDER,
  STUDIO_FILE,
  type StudioFile,
  UNDER,
} from './studio-file.ts'

/** Maps of a layer as drawn from its strokes. */
export type DrawnMaps = Pick<StudioLayer, 'maps' | 'heightAmplitude'>

/** Encodes pixels as PNG, exactly. */
export type EncodePng = (pixels: Pixels) => Promise<Uint8Array>

const EXTENSIONS: Record<string, string> = { 'image/jpeg': 'jpg', 'image/webp': 'webp', 'image/avif': 'avif' }

/**
 * The files of the folder that `furrow pack` reads: `wrinkles.json`, `layers/NAME/*.png`, `areas/NAME.png` in the paper's convention,
 * `strokes.json` and `face.glb`; and `studio.json` with what they cannot say. A face with files beside it is in `face/` with these, for
 * `furrow pack --face`.
 *
 * @param face the avatar's files; the first is the face.
 * @param drawn by the names of layers with strokes: their maps, which stand in the folder in the place of those they were drawn over.
 */
export async function folderFiles(
  document: StudioDocument,
  face: readonly AvatarFile[],
  drawn: ReadonlyMap<string, DrawnMaps>,
  encode: EncodePng,
): Promise<FolderFile[]> {
  const layers = layerFiles(document, drawn, await flatNormal(document, drawn, encode))
  const areaNames = fileNamesOf(document.areas.map(({ name }) => name))
  const areaPaths = areaNames.map((name) => `areas/${name}.png`)
  const areaImages = await Promise.all(document.areas.map(({ weights }) => encode(paintedArea(weights))))
  const images = [...layers.images, ...areaPaths.map((path, i) => ({ path, content: areaImages[i] }))]
  const strokes = strokesOf(document)
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
    files: images.map(({ path }) => path).sort(),
  }
  // Documents last: what is interrupted leaves those that fit the old images.
  return [
    ...faceFiles,
    ...images,
    ...(strokes ? [{ path: 'strokes.json', content: jsonFile(strokes) }] : []),
    { path: WRINKLES_FILE, content: jsonFile(set) },
    { path: STUDIO_FILE, content: jsonFile(studio) },
  ]
}

type LayerEntry = WrinkleSetDocument['layers'][number]

function layerFiles(
  { layers }: StudioDocument,
  drawnMaps: ReadonlyMap<string, DrawnMaps>,
  flat: ImageFile | undefined,
): { images: FolderFile[]; entries: LayerEntry[]; drawn: Record<string, DrawnLayer> } {
  const names = fileNamesOf(layers.map(({ name }) => name))
  const images: FolderFile[] = []
  const drawn: [string, DrawnLayer][] = []
  const add = (folder: string, maps: StudioLayer['maps']) =>
    Object.fromEntries(
      MAP_NAMES.flatMap((map) => {
        const image = maps[map]
        if (!image) return []
        const path = `${folder}/${map}.${EXTENSIONS[image.mimeType] ?? 'png'}`
        images.push({ path, content: image.bytes })
        return [[map, addressOf(path)]]
      }),
    ) as { [Name in MapName]?: string }
  const entries = layers.map((layer, i) => {
    const { name, kind, maps: own, normalScale, occlusionStrength, bloodAmplitude } = layer
    const { maps: made = {}, heightAmplitude = layer.heightAmplitude } = drawnMaps.get(name) ?? {}
    const instead = own.normal || made.normal || !flat ? made : { ...made, normal: flat }
    const isReplaced = MAP_NAMES.filter((map) => instead[map])
    if (isReplaced.length > 0) {
      const covered = Object.fromEntries(Object.entries(own).filter(([map]) => instead[map as MapName]))
      const under = add(`${UNDER}/${names[i]}`, covered)
      const amplitude = layer.heightAmplitude
      drawn.push([
        name,
        { drawn: isReplaced, under, ...(amplitude !== undefined && { heightAmplitude: amplitude }) },
      ])
    }
    return {
      name,
      kind,
      ...add(`layers/${names[i]}`, { ...own, ...instead }),
      ...(normalScale !== 1 && { normalScale }),
      ...(occlusionStrength !== 1 && { occlusionStrength }),
      ...(heightAmplitude !== undefined && { heightAmplitude }),
      ...(bloodAmplitude !== undefined && { bloodAmplitude }),
    } as LayerEntry
  })
  return { images, entries, drawn: Object.fromEntries(drawn) }
}

/** A normal map of smooth skin, for layers that have none yet; undefined where all have one. */
async function flatNormal(
  { layers, mapSize }: StudioDocument,
  drawn: ReadonlyMap<string, DrawnMaps>,
  encode: EncodePng,
): Promise<ImageFile | undefined> {
  if (layers.every(({ name, maps }) => maps.normal ?? drawn.get(name)?.maps.normal)) return undefined
  const data = new Uint8Array(3 * mapSize ** 2).fill(128)
  for (let i = 2; i < data.length; i += 3) data[i] = 255
  const bytes = await encode({ width: mapSize, height: mapSize, channels: 3, data })
  return { mimeType: 'image/png', bytes }
}

/** The document of strokes; undefined where there are none. Shapes that it could not have are left out: names no file can have, no strokes. */
function strokesOf(document: StudioDocument): StrokesDocument | undefined {
  if (document.strokes.length === 0) return undefined
  const groups = new Set(document.strokes.map(({ group }) => group))
  const areas = document.strokeAreas?.filter(({ name, shapes, within }) => {
    const all = within ? [...shapes, within] : shapes
    return isFileName(name) && all.every((shape) => !('group' in shape) || groups.has(shape.group))
  })
  return {
    version: 1,
    scale: document.scale,
    size: document.mapSize,
    strokes: document.strokes.map(({ isAutomatic, ...stroke }) => stroke),
    ...(document.furrows && { furrows: document.furrows }),
    ...(areas && areas.length > 0 && { areas }),
  }
}

function filesOfFace(face: readonly AvatarFile[]): FolderFile[] {
  if (face.length === 1 && /\.(glb|vrm)$/i.test(face[0].path))
    return [{ path: 'face.glb', content: face[0].file }]
  return face.map(({ path, file }) => ({ path: `${FACE_FOLDER}/${path}`, content: file }))
}

function jsonFile(json: unknown): Uint8Array {
  return new TextEncoder().encode(`${JSON.stringify(json, null, 2)}\n`)
}
