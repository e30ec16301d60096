/** Worker that draws wrinkle strokes into the maps of layers. */

import { expose, transfer } from 'comlink'
import { type SkinCanvas, type Stroke, StrokeLayer, skinCanvas } from 'furrow/author'
import type { Bounds } from 'furrow/internal'
import { holdLifeLock } from '../workers/life.ts'
import { applyChanges } from './changes.ts'
import { copyRect } from './copy-rect.ts'
import type { DrawingService, DrawingSurface, MapPatch } from './messages.ts'
import { Preparation } from './preparation.ts'
import { SculptedSheet } from './sculpted-sheet.ts'

interface Sheet {
  layer: StrokeLayer
  strokes: Stroke[]
  /** Absent before the layer gets its first sculpted heights. */
  sculpted?: SculptedSheet
}

let surface: DrawingSurface
let canvas: SkinCanvas
const sheets = new Map<string, Sheet>()
const preparation = new Preparation()

const service: DrawingService = {
  begin(next) {
    void preparation.run(null)
    surface = next
    canvas = skinCanvas(next.mesh, next.size, next.size, next.scale)
    sheets.clear()
  },
  addLayer(name, { base, hasOnset }) {
    const options = { frame: surface.frame, onset: hasOnset, ...(base && { base }) }
    sheets.set(name, { layer: new StrokeLayer(canvas, options), strokes: [] })
  },
  draw(name, changes, sculpted) {
    const sheet = sheets.get(name)!
    sheet.strokes = applyChanges(sheet.strokes, changes)
    const changed = sheet.layer.draw(sheet.strokes)
    if (sculpted) {
      sheet.sculpted ??= new SculptedSheet(surface.size)
      for (const bounds of sheet.sculpted.update(sculpted))
        changed.push(sheet.layer.sculpt(sheet.sculpted.heights, bounds))
    }
    const patches = changed.map((bounds) => patchOf(sheet.layer, bounds))
    return transfer(
      patches,
      patches.flatMap(({ normal, occlusion, onset }) =>
        [normal, occlusion, onset].flatMap((map) => map?.buffer ?? []),
      ),
    )
  },
  prepare(stroke) {
    return preparation.run(stroke ? stepsOf(stroke) : null)
  },
  heights(name) {
    const heights = sheets.get(name)!.layer.heights.data.slice()
    return transfer(heights, [heights.buffer])
  },
}

function stepsOf({ layer, index }: { layer: string; index: number }): Iterator<unknown> {
  const sheet = sheets.get(layer)!
  return sheet.layer.prepare(sheet.strokes[index])
}

function patchOf({ normal, occlusion, onset }: StrokeLayer, bounds: Bounds): MapPatch {
  return {
    bounds,
    normal: copyRect(normal, bounds, 4),
    occlusion: copyRect(occlusion, bounds, 1),
    ...(onset && { onset: copyRect(onset, bounds, 1) }),
  }
}

expose(service)
holdLifeLock()
