import { type Area, driversOf, type GrayImage, type Layer, type RgbaImage } from 'furrow'
import type { Bounds } from 'furrow/internal'
import { scaleLayer, updateArea, updateLayer } from 'furrow/three'
import type { Wrinkles } from '../../../stage/stage.ts'
import type { StudioArea, StudioDocument, StudioLayer } from '../document/document.ts'
import type { Viewer } from './viewer.ts'

/** Decoded maps of a layer. */
export interface LayerMaps {
  readonly normal: RgbaImage
  readonly baseColor?: RgbaImage
  readonly roughness?: GrayImage
  readonly occlusion?: GrayImage
  readonly blood?: GrayImage
  readonly onset?: GrayImage
}

/** Document with the maps of its layers, in layer order. */
export interface DrawnDocument {
  readonly document: StudioDocument
  readonly maps: readonly LayerMaps[]
  /** For each layer whose maps were updated in place: the rectangles, in texels, that changed since the previous document. */
  readonly changes: ReadonlyMap<LayerMaps, readonly Bounds[]>
}

/** Shows the wrinkles of a document on the face. Applies only the changes since the last document. */
export class DocumentView {
  #viewer: Viewer | null = null
  #shown: DrawnDocument | null = null

  /** @throws FurrowError if the wrinkles do not fit the face. The face is then shown without wrinkles. */
  show(viewer: Viewer, drawn: DrawnDocument | null): void {
    const before = viewer === this.#viewer ? this.#shown : null
    this.#viewer = viewer
    this.#shown = drawn
    if (!drawn || drawn.document.areas.length === 0) {
      if (viewer.wrinkles) viewer.setWrinkles(null)
      return
    }
    const { document, maps } = drawn
    if (before && viewer.wrinkles && canUpdate(before, drawn)) {
      updateMaps(viewer.wrinkles, drawn)
      if (drawn.changes.size > 0) viewer.refreshOnset()
      scaleLayers(viewer.wrinkles, before.document, document)
      changeAreas(viewer, before.document, document)
      if (haveDriversChanged(before.document, document)) viewer.setDrivers(document.drivers)
      return
    }
    const layers = document.layers.map((layer, i) => engineLayer(layer, maps[i]))
    const areas = document.areas.map(engineArea)
    viewer.setWrinkles({ set: { layers, areas }, drivers: [...document.drivers] })
  }
}

/** Whether the existing wrinkles can be updated to show another document. Otherwise, they must be created again. */
function canUpdate(before: DrawnDocument, after: DrawnDocument): boolean {
  const old = new Map(before.document.areas.map((area) => [area.name, area]))
  return (
    before.document.layers.length === after.document.layers.length &&
    before.document.layers.every((layer, i) => haveSameKind(layer, after.document.layers[i])) &&
    before.document.areaSize === after.document.areaSize &&
    before.maps.every((maps, i) => maps === after.maps[i]) &&
    after.document.areas.every((area) => haveSameFields(old.get(area.name) ?? area, area))
  )
}

/** Whether two layers have the same name and kind. Ignores strengths, because `scaleLayers` can update them. */
function haveSameKind(a: StudioLayer, b: StudioLayer): boolean {
  return a.name === b.name && a.kind === b.kind
}

function haveSameFields(a: StudioArea, b: StudioArea): boolean {
  return a.layer === b.layer && a.combine === b.combine
}

/** Whether the drivers changed, or a driver measures the tension of an area whose weights changed. */
function haveDriversChanged(before: StudioDocument, after: StudioDocument): boolean {
  if (before.drivers !== after.drivers) return true
  const weights = ({ areas }: StudioDocument, area: string) =>
    areas.find(({ name }) => name === area)?.weights
  return driversOf('tension', after.drivers).some(
    ({ area }) => weights(before, area) !== weights(after, area),
  )
}

/** Uploads the changed rectangles. */
function updateMaps(wrinkles: Wrinkles, { document, maps, changes }: DrawnDocument): void {
  for (const [i, { name, isOnsetDrawn }] of document.layers.entries()) {
    const { normal, occlusion, onset } = maps[i]
    const drawn = { normal, occlusion: occlusion!, ...(onset && isOnsetDrawn && { onset }) }
    for (const bounds of changes.get(maps[i]) ?? []) updateLayer(wrinkles, name, drawn, bounds)
  }
}

function scaleLayers(wrinkles: Wrinkles, before: StudioDocument, after: StudioDocument): void {
  for (const [i, layer] of after.layers.entries()) {
    const { name, normalScale, occlusionStrength, bloodAmplitude = 0, onsetStrength = 1 } = layer
    if (layer !== before.layers[i])
      scaleLayer(wrinkles, name, { normalScale, occlusionStrength, bloodAmplitude, onsetStrength })
  }
}

/** Adds, updates and removes areas. Removes areas last, because wrinkles always need at least one area. */
function changeAreas(viewer: Viewer, before: StudioDocument, after: StudioDocument): void {
  if (before.areas === after.areas) return
  const old = new Map(before.areas.map((area) => [area.name, area]))
  const names = new Set(after.areas.map(({ name }) => name))
  for (const area of after.areas) {
    const known = old.get(area.name)
    if (!known) viewer.addArea(engineArea(area))
    else if (known.weights !== area.weights) updateArea(viewer.wrinkles!, area.name, area.weights)
    if (known && known.activation !== area.activation) viewer.driven.setResting(area.name, area.activation)
  }
  for (const { name } of before.areas) if (!names.has(name)) viewer.removeArea(name)
}

function engineLayer(layer: StudioLayer, maps: LayerMaps): Layer {
  const { name, kind, normalScale, occlusionStrength, bloodAmplitude = 0, onsetStrength = 1 } = layer
  return { name, kind, normalScale, occlusionStrength, bloodAmplitude, onsetStrength, ...maps }
}

function engineArea({ name, layer, combine, activation, weights }: StudioArea): Area {
  return { name, layer, combine, activation, weights }
}
