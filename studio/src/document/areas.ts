import { type Combine, FurrowError, type GrayImage } from 'furrow'
import { MAX_AREAS } from 'furrow/internal'
import type { StudioArea, StudioDocument } from './document.ts'
import { driversOfNewArea, onOtherSide, renameInDrivers, withoutArea } from './drivers.ts'
import { changed, checkCount, checkNewName, freeName, named, withNamed } from './names.ts'
import { checkRange } from './ranges.ts'
import { otherSide } from './sides.ts'
import { renameInShapes, withoutShapes } from './stroke-areas.ts'
import { edited } from './strokes.ts'

/** Fields of an area that are set as they are. */
export type AreaFields = Partial<Pick<StudioArea, 'layer' | 'combine' | 'activation'>>

/** @throws FurrowError when its name is taken, its layer unknown, its weights are of another size, or there are 256. */
export function addArea(document: StudioDocument, area: StudioArea): StudioDocument {
  checkNewName(document.areas, area.name, 'area')
  named(document.layers, area.layer, 'layer')
  checkSize(document, area.weights)
  checkCount(document.areas, MAX_AREAS, 'area')
  return { ...document, areas: [...document.areas, area] }
}

/** A new area that is empty, on the first layer. */
export function addEmptyArea(document: StudioDocument, name: string): StudioDocument {
  const { areaSize: side, layers } = document
  const weights = { width: side, height: side, data: new Uint8Array(side * side) }
  const combine: Combine = 'sum'
  return addArea(document, { name, layer: layers[0].name, combine, activation: 0, weights })
}

/** Removes an area, and the drivers that activate it; those that read it read it no more. */
export function removeArea(document: StudioDocument, name: string): StudioDocument {
  named(document.areas, name, 'area')
  return {
    ...document,
    areas: document.areas.filter((area) => area.name !== name),
    drivers: withoutArea(document.drivers, name),
    ...withoutShapes(document, name),
  }
}

/** Renames an area, in drivers, strokes and their shapes too. */
export function renameArea(document: StudioDocument, name: string, newName: string): StudioDocument {
  if (newName === name) return document
  checkNewName(document.areas, newName, 'area')
  return {
    ...document,
    // Under another name, an automatic area would not be found again.
    areas: withNamed(document.areas, name, 'area', ({ isAutomatic: _, ...area }) => ({
      ...area,
      name: newName,
    })),
    drivers: renameInDrivers(document.drivers, name, newName),
    strokes: changed(document.strokes, (stroke) =>
      stroke.group === name ? edited({ ...stroke, group: newName }) : stroke,
    ),
    ...renameInShapes(document, name, newName),
  }
}

/** Copies an area with the drivers that activate it, under another name. */
export function duplicateArea(document: StudioDocument, name: string): StudioDocument {
  const copy = freeName(document.areas, name)
  const { isAutomatic: _, ...area } = named(document.areas, name, 'area')
  const added = addArea(document, { ...area, name: copy })
  return { ...added, drivers: [...document.drivers, ...driversOfNewArea(document.drivers, name, copy)] }
}

/**
 * Shows an area on the other side of the face too: the area that is called so gets these weights; where there is none it is added, with the
 * drivers of the first one reading the blendshapes of the other side.
 *
 * @param weights the mirror image of the area's.
 */
export function mirrorArea(document: StudioDocument, name: string, weights: GrayImage): StudioDocument {
  const other = mirroredName(document, name)
  if (document.areas.some((area) => area.name === other)) return paintArea(document, other, weights)
  const { isAutomatic: _, ...area } = named(document.areas, name, 'area')
  const added = addArea(document, { ...area, name: other, weights })
  const drivers = driversOfNewArea(document.drivers, name, other).map(onOtherSide)
  return { ...added, drivers: [...document.drivers, ...drivers] }
}

/** What the mirror image of an area is called. */
export function mirroredName({ areas }: StudioDocument, name: string): string {
  const other = otherSide(name)
  return other === name ? freeName(areas, name) : other
}

/** @throws FurrowError when the layer is unknown or the activation outside 0..1. */
export function setArea(document: StudioDocument, name: string, fields: AreaFields): StudioDocument {
  if (fields.layer !== undefined) named(document.layers, fields.layer, 'layer')
  checkRange(`activation of ${name} at rest`, fields.activation, 0, 1)
  return { ...document, areas: withNamed(document.areas, name, 'area', (area) => ({ ...area, ...fields })) }
}

/** Replaces the weights of an area: what was painted. It is automatic no more. */
export function paintArea(document: StudioDocument, name: string, weights: GrayImage): StudioDocument {
  checkSize(document, weights)
  const paint = ({ isAutomatic: _, ...area }: StudioArea) => ({ ...area, weights })
  return { ...document, areas: withNamed(document.areas, name, 'area', paint) }
}

function checkSize({ areaSize }: StudioDocument, { width, height }: GrayImage): void {
  if (width === areaSize && height === areaSize) return
  throw new FurrowError({
    who: 'Studio',
    problem: 'an area has another size than the others',
    value: `${width} x ${height}`,
    limit: `${areaSize} x ${areaSize} texels`,
    remedy: 'resample it',
  })
}
