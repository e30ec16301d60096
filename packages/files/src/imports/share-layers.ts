import type { GrayImage } from 'furrow'
import { shownCells } from './area-cells.ts'

/** An area that needs a layer. */
export interface AreaToPlace {
  weights: GrayImage
  /** Strength of the wrinkles per cell. Where areas compete for one layer, the stronger wrinkles stay. */
  strengths: Float32Array
}

/** Layer of each area, and the cells that areas had to give up. */
export interface Placement {
  /** Index of the layer, per area. */
  layers: number[]
  layerCount: number
  /** Weights per area. Cells in which another area of the layer has stronger wrinkles are 0. */
  weights: GrayImage[]
  /** Cells that each area gave up. */
  lost: number[]
}

/**
 * Distributes areas over layers. Areas of one layer must not overlap, because a layer has one map. Large areas choose first, and each takes
 * the first layer in which it overlaps nothing. If there is none, it shares a layer in which it loses least: each cell then shows the
 * area with the stronger wrinkles.
 *
 * @param most maximum number of layers.
 */
export function placeAreas(areas: readonly AreaToPlace[], most: number): Placement {
  const shown = areas.map(({ weights }) => shownCells(weights).data)
  const sizes = shown.map((cells) => cells.reduce((sum, cell) => sum + cell, 0))
  const layers = areas.map(() => 0)
  const members: number[][] = []
  const clashOf = (area: number, layer: number) => {
    let clash = 0
    for (const other of members[layer] ?? []) {
      for (let i = 0; i < shown[area].length; i++) {
        if (shown[area][i] && shown[other][i])
          clash += 1 + Math.min(areas[area].strengths[i], areas[other].strengths[i])
      }
    }
    return clash
  }
  const order = [...areas.keys()].sort((a, b) => sizes[b] - sizes[a] || a - b)
  for (const area of order) {
    const clashes = Array.from({ length: Math.min(most, members.length + 1) }, (_, layer) =>
      clashOf(area, layer),
    )
    const layer = clashes.indexOf(Math.min(...clashes))
    layers[area] = layer
    members[layer] = [...(members[layer] ?? []), area]
  }
  const weights = areas.map((area) => ({ ...area.weights, data: area.weights.data.slice() }))
  const lost = areas.map(() => 0)
  for (const [layer, areasOfLayer] of members.entries()) {
    if (layer >= most) continue
    for (const area of areasOfLayer) {
      for (const other of areasOfLayer) {
        if (other !== area)
          lost[area] += giveUp(weights[area], areas[area], areas[other], shown[other], area > other)
      }
    }
  }
  return { layers, layerCount: members.length, weights, lost }
}

/** Clears the cells of an area that show another area with stronger wrinkles. Returns their number. */
function giveUp(
  weights: GrayImage,
  own: AreaToPlace,
  other: AreaToPlace,
  shownByOther: Uint8Array,
  losesTies: boolean,
): number {
  let count = 0
  for (let i = 0; i < weights.data.length; i++) {
    if (weights.data[i] === 0 || !shownByOther[i]) continue
    const difference = other.strengths[i] - own.strengths[i]
    if (difference < 0 || (difference === 0 && !losesTies)) continue
    if (own.strengths[i] > 0) count++
    weights.data[i] = 0
  }
  return count
}
