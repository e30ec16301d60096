import { FurrowError } from 'furrow'
import { parseStrokes, type StrokesDocument } from 'furrow/author'
import { didYouMean, WRINKLE_MAPS } from 'furrow/internal'
import { utf8 } from '../base/bytes.ts'
import { withCommandErrors } from '../base/errors.ts'
import { checkFileBytes } from '../base/file-size.ts'
import { parseJson } from '../base/json-file.ts'
import type { WrinkledFile } from './wrinkled-file.ts'

/** Most bytes of the strokes of a set: with the line breaks of a `.gltf`, ten times as many must be within `MAX_JSON_BYTES`. */
const MAX_STROKES_BYTES = 2 ** 22

/** A checked document of strokes as it is stored: an artist's numbers stay as they are, and defaults are left out. */
export interface StoredStrokes {
  strokes: readonly object[]
}

/**
 * Reads the strokes of a wrinkle set.
 *
 * @param layers names of the layers that strokes may be on.
 * @throws FurrowError when they are malformed, too large, or on a layer that does not exist.
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

/** Checks strokes in memory as `readStrokes` does those in a file. */
export function checkStrokes(
  strokes: StrokesDocument,
  layers: readonly string[],
  who: string,
): StoredStrokes {
  checkFileBytes(strokesBytes(strokes), 'the document of strokes', who, MAX_STROKES_BYTES)
  return checkedStrokes(strokes, layers, who)
}

/** The strokes in a file, or what is wrong with them: no renderer needs them, so that nothing else suffers. */
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

/** The bytes of strokes in a file. */
export function strokesBytes(strokes: object | undefined): number {
  return strokes === undefined ? 0 : utf8(JSON.stringify(strokes)).length
}

/** Names of the layers that strokes and furrows of a document are on. */
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
