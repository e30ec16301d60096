import { Document, NodeIO } from '@gltf-transform/core'
import { ALL_EXTENSIONS } from '@gltf-transform/extensions'
import type { Curve, WrinkleDriver } from 'furrow'
import { FurrowWrinkleMaps, type MaterialWrinkles } from 'furrow/gltf'
import { MeshoptDecoder, MeshoptEncoder } from 'meshoptimizer'
import { accessorsOf } from '../../accessors.ts'
import { noise } from '../../noise.ts'

export const NAME = 'FURROW_wrinkle_maps'

export const silent = { debug() {}, info() {}, warn() {}, error() {} }

export function createIO(): NodeIO {
  return new NodeIO()
    .setLogger(silent)
    .registerExtensions([...ALL_EXTENSIONS, FurrowWrinkleMaps])
    .registerDependencies({ 'meshopt.decoder': MeshoptDecoder, 'meshopt.encoder': MeshoptEncoder })
}

const CURVE: Curve = [
  [0, 0],
  [0.5, 0.2],
  [1, 1],
]

/** A driver of every type with all defaults filled in, and one of an unknown type. */
export const DRIVERS: WrinkleDriver[] = [
  {
    type: 'morph',
    area: 'brow',
    targets: [{ name: 'browInnerUp', weight: 0.5, curve: CURVE }],
    rule: 'max',
    curve: CURVE,
  },
  { type: 'weather', area: 'nose', joint: 'jaw', nested: { angles: [1, 2] } },
  { type: 'area', area: 'nose', areas: [{ name: 'brow', weight: -1 }], rule: 'sum', curve: CURVE },
  { type: 'conflict', targets: ['browInnerUp', 'browDown'] },
  { type: 'bone', area: 'nose', joints: ['head', 'jaw'], measure: 'angle', axis: [1, 0, 0], curve: CURVE },
  { type: 'tension', area: 'brow', measure: 'stretch', direction: [0, -1], curve: CURVE },
  {
    type: 'muscle',
    name: 'frontalis',
    area: 'brow',
    kind: 'sheet',
    origin: [0, 1, 0],
    insertion: [0, 0.5, 0.1],
    angle: 0.4,
    width: 0.02,
    inner: 0.5,
    outer: 1.5,
    strength: 0.2,
  },
  { type: 'age', area: 'brow', curve: CURVE },
  { type: 'time', area: 'brow', attack: 0.1, release: 0.6 },
  {
    type: 'expression',
    name: 'doubt',
    targets: [{ name: 'browInnerUp', weight: 0.7 }],
    activations: [{ area: 'nose', activation: 0.2 }],
  },
]

/** Strokes document with every kind of curve and shape. */
export const SHAPES = [
  { mesh: 'Head', target: 'key_12', shape: 'browInnerUp' },
  { target: 'slider', extras: { by: 'hand' } },
]

export const STROKES = {
  version: 1,
  scale: 1000,
  size: 64,
  strokes: [
    {
      group: 'brow',
      layer: 'up',
      curve: 'spline',
      points: [
        [0.25, 0.125],
        [0.5, 0.5],
      ],
      width: 4,
      depth: 0.5,
      depths: [1, 0.25],
      taper: 0.5,
      shoulder: [1, 0.5],
      bank: [6, 8],
      lean: 0.25,
      softness: 0.5,
      waviness: 0.25,
    },
    {
      layer: 'down',
      curve: 'bezier',
      points: [
        [0, 0],
        [0, 1],
        [1, 1],
        [1, 0],
      ],
      width: 3,
      depth: 0.25,
    },
  ],
  furrows: {
    size: 2,
    depth: 0.1,
    stretch: 1.5,
    seed: 3,
    layer: 'up',
    regions: [{ at: [0.5, 0.5], radius: 30, size: 1, depth: 0.05 }],
  },
  areas: [
    {
      name: 'brow',
      shapes: [
        {
          polygon: [
            [0, 0],
            [1, 0],
            [1, 1],
          ],
          feather: 8,
        },
      ],
      within: { group: 'brow', radius: 6, feather: 8 },
    },
  ],
}

/** Creates a quad with one blendshape, two layers with every slot, and five areas in the channels of two images. */
export async function createSample(): Promise<Document> {
  const document = new Document().setLogger(silent)
  const texture = async (name: string, seed: number, channels: 3 | 4 = 3) =>
    document
      .createTexture(name)
      .setMimeType('image/png')
      .setImage((await noise(seed, channels)) as Uint8Array<ArrayBuffer>)
  const accessor = accessorsOf(document)
  const vectors = (type: 'VEC3' | 'VEC2', ...values: number[]) => accessor(type, Float32Array.from(values))
  const material = document.createMaterial('skin').setNormalTexture(await texture('smooth', 0))
  material.setBaseColorTexture(await texture('colour', 1))
  const target = document
    .createPrimitiveTarget('browInnerUp')
    .setAttribute('POSITION', vectors('VEC3', 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0))
  const primitive = document
    .createPrimitive()
    .setAttribute('POSITION', vectors('VEC3', 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0))
    .setAttribute('NORMAL', vectors('VEC3', 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1))
    .setAttribute('TEXCOORD_0', vectors('VEC2', 0, 1, 1, 1, 0, 0, 1, 0))
    .setIndices(accessor('SCALAR', Uint16Array.of(0, 1, 2, 2, 1, 3)))
    .setMaterial(material)
    .addTarget(target)
  const mesh = document
    .createMesh('skin')
    .addPrimitive(primitive)
    .setExtras({ targetNames: ['browInnerUp'] })
  document.createScene().addChild(document.createNode('skin').setMesh(mesh))

  const extension = document.createExtension(FurrowWrinkleMaps)
  const shade = await texture('shade', 5)
  const up = extension
    .createLayer('up')
    .setTexture('normalTexture', await texture('up', 2))
    .setTexture('baseColorTexture', await texture('flushed', 3))
    .setTexture('roughnessTexture', await texture('dry', 4))
    .setTexture('occlusionTexture', shade)
    .setTexture('heightTexture', await texture('relief', 6))
    .setNormalScale(0.5)
    .setOcclusionStrength(0.25)
    .setHeightAmplitude(0.004)
    .setTexture('bloodTexture', shade)
    .setBloodAmplitude(0.5)
    .setTexture('onsetTexture', shade)
    .setOnsetStrength(0.75)
    .setUnknownFields({ later: { deep: [1, 2] } })
  const down = extension
    .createLayer('down')
    .setKind('detail')
    .setTexture('normalTexture', await texture('down', 7))
  const wrinkles = extension.createMaterialWrinkles().addLayer(up).addLayer(down).setDrivers(DRIVERS)
  wrinkles.setStrokes(STROKES).setShapes(SHAPES).setExtras({ by: 'hand' }).setUnknownFields({ revision: 7 })
  const areaTextures = [await texture('weights 0', 8), await texture('weights 1', 9)]
  for (const [i, name] of ['brow', 'nose', 'cheek', 'chin', 'eye'].entries()) {
    const area = extension.createArea(name).setTexture(areaTextures[Math.floor(i / 3)], i % 3)
    wrinkles.addArea(area.setLayer(i % 2 ? down : up))
    if (i === 4) area.setCombine('max').setActivation(0.5).setExtras({ side: 'left' })
  }
  material.setExtension(NAME, wrinkles)
  return document
}

export function wrinkleMapsOf(document: Document): MaterialWrinkles {
  const material = document
    .getRoot()
    .listMaterials()
    .find((item) => item.getName() === 'skin')!
  return material.getExtension<MaterialWrinkles>(NAME)!
}

/** Returns the content of the extension that tools must preserve, as plain data, with images by name. */
export function summary(document: Document) {
  const wrinkles = wrinkleMapsOf(document)
  const slots = ['normal', 'baseColor', 'roughness', 'occlusion', 'height', 'blood', 'onset'] as const
  return {
    extras: wrinkles.getExtras(),
    unknown: wrinkles.getUnknownFields(),
    drivers: wrinkles.getDrivers(),
    strokes: wrinkles.getStrokes(),
    shapes: wrinkles.getShapes(),
    layers: wrinkles.listLayers().map((layer) => ({
      name: layer.getName(),
      kind: layer.getKind(),
      numbers: [
        layer.getNormalScale(),
        layer.getOcclusionStrength(),
        layer.getHeightAmplitude(),
        layer.getBloodAmplitude(),
        layer.getOnsetStrength(),
      ],
      textures: slots.map((slot) => layer.getTexture(`${slot}Texture`)?.getName()),
      unknown: layer.getUnknownFields(),
    })),
    areas: wrinkles.listAreas().map((area) => ({
      name: area.getName(),
      layer: area.getLayer()?.getName(),
      texture: area.getTexture()?.getName(),
      channel: area.getChannel(),
      combine: area.getCombine(),
      activation: area.getActivation(),
      extras: area.getExtras(),
    })),
  }
}
