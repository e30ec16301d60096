import { FurrowError } from 'furrow'
import type { Pixels } from '../../images/pixels.ts'
import { targetNamesOf } from '../../json/gltf-json.ts'
import type { AreaToPack, LayerToPack } from '../../pack/set-to-pack.ts'
import { largestWeights } from '../combine-weights.ts'
import { type FaceToImport, faceColours, faceNormalMap } from '../face-maps.ts'
import type { ImportedSet, ImportSettings } from '../imported-set.ts'
import { LayerCanvas, normalBytes } from '../layer-canvas.ts'
import type { SourceFiles } from '../source-files.ts'
import { coloursOf, normalsOf, readSourceImage } from '../source-image.ts'
import { CURVES } from './curves.ts'
import { metahumanDrivers } from './metahuman-drivers.ts'
import { animatedMaps, MaskReader, unreadFiles } from './metahuman-files.ts'
import { isDeltaColour, overlaid } from './overlay.ts'

/** Width and height of the areas in texels. */
const AREA_SIZE = 256

/**
 * Converts the animated maps of a MetaHuman. Each of the three maps becomes a layer, each mask an area.
 *
 * @throws FurrowError if a map or a mask is missing or invalid.
 */
export async function convertMetahuman(
  files: SourceFiles,
  face: FaceToImport,
  { size, green }: ImportSettings,
  who: string,
): Promise<ImportedSet> {
  const maps = animatedMaps(files)
  if (maps.normals.size === 0) throw noMaps(files, who)
  const read = (path: string) => readSourceImage(files, path, who, size)
  const lost: string[] = []
  const own = await faceNormalMap(face, size, who)
  if (!own) lost.push('the face has no normal map, so its resting skin is smooth; export it with textures')
  const base = own && normalsOf(own, false)
  const skin = await faceColours(face, size, who)
  const colours = new Map<number, Uint8Array>()
  for (const [set, path] of maps.colours) colours.set(set, coloursOf(await read(path)))
  const isDelta = [...colours.values()].some(isDeltaColour)
  if (isDelta)
    lost.push('colour deltas are taken as an overlay in linear space, as no documentation states the formula')
  const masks = new MaskReader(files, who)
  const layers: LayerToPack[] = []
  const areas: AreaToPack[] = []
  for (const [set, path] of [...maps.normals].sort(([a], [b]) => a - b)) {
    const layer = `wrinkles ${set}`
    const curves = CURVES.filter((curve) => curve.set === set)
    const weights = await Promise.all(curves.map((curve) => masks.read(curve, AREA_SIZE)))
    const shown = largestWeights(weights)
    const canvas = new LayerCanvas(size)
    const normals = normalsOf(await read(path), green === 'down')
    canvas.paint('normal', [
      { weights: shown, colourAt: (i) => wrinkledNormal(base, normals, 3 * i, isDelta) },
    ])
    const colour = colours.get(set)
    if (colour) paintColours(canvas, colour, isDelta ? skin : undefined, isDelta, shown, lost)
    layers.push({ name: layer, kind: 'replace', maps: canvas.maps() })
    areas.push(...curves.map(({ area }, i) => ({ name: area, layer, weights: async () => weights[i] })))
  }
  const { drivers, kind } = metahumanDrivers(targetNamesOf(face.glb.json.meshes![face.target.mesh]))
  if (kind === 'arkit')
    lost.push("the face has no blendshape of MetaHuman's controls; ARKit's nearest drive the areas")
  if (kind === 'inputs')
    lost.push('the face has no known blendshape; the page sets inputs with the names of the rig curves')
  const names = new Set(areas.map(({ name }) => name))
  return {
    set: {
      areaSize: AREA_SIZE,
      layers,
      areas,
      drivers: drivers.filter((driver) => 'area' in driver && names.has(String(driver.area))),
    },
    lost,
    unread: unreadFiles(files, maps),
  }
}

/**
 * Returns the bytes of a wrinkled normal. The source changes only x and y, so z stays that of the resting skin.
 *
 * @param at index of x.
 */
function wrinkledNormal(
  base: Float32Array | undefined,
  normals: Float32Array,
  at: number,
  isDelta: boolean,
): [number, number, number] {
  const [x, y, z] = base ? base.subarray(at, at + 3) : [0, 0, 1]
  return isDelta
    ? normalBytes(x + normals[at], y + normals[at + 1], z)
    : normalBytes(normals[at], normals[at + 1], z)
}

function paintColours(
  canvas: LayerCanvas,
  colour: Uint8Array,
  skin: Pixels | undefined,
  isDelta: boolean,
  weights: Parameters<LayerCanvas['paint']>[1][number]['weights'],
  lost: string[],
): void {
  if (isDelta && !skin) {
    const text = 'the colour deltas, because the face has no base colour texture'
    if (!lost.includes(text)) lost.push(text)
    return
  }
  const rest = skin && coloursOf(skin)
  canvas.paint('baseColor', [
    {
      weights,
      colourAt: (i) => {
        const own = colour.subarray(3 * i, 3 * i + 3)
        return rest ? overlaid(rest.subarray(3 * i, 3 * i + 3), own) : own
      },
    },
  ])
}

function noMaps({ name }: SourceFiles, who: string): FurrowError {
  return new FurrowError({
    who,
    problem: `no animated normal map in ${name}`,
    limit: 'Head_Normal_Animated_WM1, T_Face_Normal_Animated_WM1 or head_wm1_normal_map, up to 3',
    remedy: 'export the animated maps of the head',
  })
}
