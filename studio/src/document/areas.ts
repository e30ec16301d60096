import { type Combine, FurrowError, type GrayImage } from 'furrow'
import { MAX_AREAS } from 'furrow/internal'
import type { StudioArea, StudioDocument } from './document.ts'
import { copyDrivers, mirrorDriver, removeFromDrivers, renameInDrivers } from './drivers.ts'
import { changed, checkCount, checkNewName, findNamed, freeName, replaceNamed } from './names.ts'
import { checkRange } from './ranges.ts'
import { otherSide } from './sides.ts'
import { removeShapes, renameInShapes } from './stroke-areas.ts'
import { edited } from './strokes.ts'

/** Fields of an area that `setArea` can change. */
export type AreaFields = Partial<Pick<StudioArea, 'layer' | 'combine' | 'activation'>>

/**
 * Adds an area of influence.
 *
 * @throws FurrowError if the name is taken, the layer is unknown, the size of the weights is not `areaSize`, or there are already 256 areas.
 */
export function addArea(document: StudioDocument, area: StudioArea): StudioDocument {
  checkNewName(document.areas, area.name, 'area')
  findNamed(document.layers, area.layer, 'layer')
  checkSize(document, area.weights)
  checkCount(document.areas, MAX_AREAS, 'area')
  return { ...document, areas: [...document.areas, area] }
}

export function addEmptyArea(document: StudioDocument, name: string): StudioDocument {
  return addArea(document, emptyArea(document, name))
}

/** Returns an area of the first layer that covers nothing. */
export function emptyArea({ areaSize: side, layers }: StudioDocument, name: string): StudioArea {
  const weights = { width: side, height: side, data: new Uint8Array(side * side) }
  const combine: Combine = 'sum'
  return { name, layer: layers[0].name, combine, activation: 0, weights }
}

/**
 * Removes an area, its shapes in `strokeAreas`, and the drivers that activate it. Drivers that read the area lose that input. Strokes whose
 * group has the name of the area stay.
 */
export function removeArea(document: StudioDocument, name: string): StudioDocument {
  findNamed(document.areas, name, 'area')
  return {
    ...document,
    areas: document.areas.filter((area) => area.name !== name),
    drivers: removeFromDrivers(document.drivers, name),
    ...removeShapes(document, name),
  }
}

/** Renames an area, also where drivers, strokes and `strokeAreas` refer to it. */
export function renameArea(document: StudioDocument, name: string, newName: string): StudioDocument {
  if (newName === name) return document
  checkNewName(document.areas, newName, 'area')
  return {
    ...document,
    // Mark the area as hand-edited. Otherwise, new automatic wrinkles would replace it by an area with the old name.
    areas: replaceNamed(document.areas, name, 'area', ({ isAutomatic: _, ...area }) => ({
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

/** Copies an area and the drivers that activate it. The copy gets a free name. */
export function duplicateArea(document: StudioDocument, name: string): StudioDocument {
  const copy = freeName(document.areas, name)
  const { isAutomatic: _, ...area } = findNamed(document.areas, name, 'area')
  const added = addArea(document, { ...area, name: copy })
  return { ...added, drivers: [...document.drivers, ...copyDrivers(document.drivers, name, copy)] }
}

/**
 * Mirrors an area to the other side of the face. If an area with the mirrored name exists, for example `browRight` for `browLeft`, replaces its
 * weights. Otherwise adds an area with this name, and drivers that read the mirrored blendshapes.
 *
 * @param weights mirror image of the area's weights.
 */
export function mirrorArea(document: StudioDocument, name: string, weights: GrayImage): StudioDocument {
  const other = mirroredName(document, name)
  if (document.areas.some((area) => area.name === other)) return paintArea(document, other, weights)
  const { isAutomatic: _, ...area } = findNamed(document.areas, name, 'area')
  const added = addArea(document, { ...area, name: other, weights })
  const drivers = copyDrivers(document.drivers, name, other).map(mirrorDriver)
  return { ...added, drivers: [...document.drivers, ...drivers] }
}

/** Returns the name of an area's mirror image: with the side swapped, or a free name if the name has no side. */
export function mirroredName({ areas }: StudioDocument, name: string): string {
  const other = otherSide(name)
  return other === name ? freeName(areas, name) : other
}

/** @throws FurrowError if the layer is unknown or the activation is outside 0..1. */
export function setArea(document: StudioDocument, name: string, fields: AreaFields): StudioDocument {
  if (fields.layer !== undefined) findNamed(document.layers, fields.layer, 'layer')
  checkRange(`activation of ${name} at rest`, fields.activation, 0, 1)
  return {
    ...document,
    areas: replaceNamed(document.areas, name, 'area', (area) => ({ ...area, ...fields })),
  }
}

/** Replaces the weights of an area by painted ones, and marks the area as hand-edited. */
export function paintArea(document: StudioDocument, name: string, weights: GrayImage): StudioDocument {
  checkSize(document, weights)
  const paint = ({ isAutomatic: _, ...area }: StudioArea) => ({ ...area, weights })
  return { ...document, areas: replaceNamed(document.areas, name, 'area', paint) }
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
