import { FurrowError } from 'furrow'
import { parseStrokes, type StrokesDocument } from 'furrow/author'
import { didYouMean, WRINKLE_MAPS } from 'furrow/internal'
import { utf8 } from '../base/bytes.ts'
import { withCommandErrors } from '../base/errors.ts'
import { checkFileBytes } from '../base/file-size.ts'
import { parseJson } from '../base/json-file.ts'
import type { WrinkledFile } from './wrinkled-file.ts'

/**
 * Maximum size of the strokes of a wrinkle set, bytes. Indentation in a `.gltf` can make their JSON ten times as large.
 * The indented JSON must stay below `MAX_JSON_BYTES`.
 */
const MAX_STROKES_BYTES = 2 ** 22

/** Strokes document that has been checked. Numbers are as the artist wrote them, and defaults are not filled in. */
export interface StoredStrokes {
  seed?: number
  strokes: readonly object[]
}

/**
 * Reads the strokes (wrinkle lines) of a wrinkle set.
 *
 * @param layers names of the set's layers.
 * @throws FurrowError if the strokes are malformed or too large, or a stroke names a layer that does not exist.
 */
export function readStrokes(
  bytes: Uint8Array,
  path: string,
  layers: readonly string[],
  who: string,
): StoredStrokes {
  checkFileBytes(bytes.length, path, who, MAX_STROKES_BYTES)
  const json = parseJson(bytes, `the strokes ${path}`, who)
  return checkedStrokes(json, layers, `${who}: ${path}`)
}

export function checkStrokes(
  strokes: StrokesDocument,
  layers: readonly string[],
  who: string,
): StoredStrokes {
  checkFileBytes(strokesBytes(strokes), 'the document of strokes', who, MAX_STROKES_BYTES)
  return checkedStrokes(strokes, layers, who)
}

/**
 * Returns the strokes of a material. Describes malformed strokes in `problem` and does not throw, because renderers do
 * not need strokes.
 */
export function strokesIn(
  { glb, material, maps }: WrinkledFile,
  who: string,
): { strokes?: StoredStrokes; problem?: string } {
  const { strokes } = glb.json.materials![material].extensions![WRINKLE_MAPS] as { strokes?: unknown }
  if (strokes === undefined) return {}
  const names = maps.layers.map(({ name }) => name)
  try {
    return { strokes: checkedStrokes(strokes, names, who) }
  } catch (error) {
    if (!(error instanceof FurrowError)) throw error
    return { problem: error.message }
  }
}

/** Returns the bytes that strokes take as JSON. */
export function strokesBytes(strokes: object | undefined): number {
  return strokes === undefined ? 0 : utf8(JSON.stringify(strokes)).length
}

/** Returns the names of layers that have strokes or furrows. */
export function layersOf({ strokes, furrows }: StrokesDocument): string[] {
  return [...new Set([...strokes, furrows].flatMap((drawn) => drawn?.layer ?? []))]
}

function checkedStrokes(json: unknown, layers: readonly string[], who: string): StoredStrokes {
  const { strokes } = withCommandErrors(who, () => parseStrokes(json))
  for (const [i, { layer }] of strokes.entries()) {
    if (layer === undefined ? layers.length > 1 : !layers.includes(layer))
      throw noLayer(i, layer, layers, who)
  }
  return json as StoredStrokes
}

function noLayer(index: number, layer: string | undefined, layers: readonly string[], who: string) {
  return new FurrowError({
    code: 'unknown-name',
    who,
    problem: `strokes[${index}] ${layer === undefined ? 'names no layer' : 'is on an unknown layer'}`,
    value: layer,
    limit: layers.join(', '),
    remedy: didYouMean(layer, layers, 'name one of the layers'),
  })
}
