import { JsonReader, MAX_NAME_LENGTH } from 'furrow/internal'
import { jsonFile } from 'furrow-files'
import { framesOf, MAX_FRAMES, MAX_TAKE_SHAPES, TAKE_RATE, type Take, weightsOf } from '../document/take.ts'

/** Makes the file of a take in a project folder: names of blendshapes, and the weights of each in one list. */
export function takeFile({ name, motion, range }: Take): Uint8Array {
  const { names } = motion
  // Numbers with five decimals restore the rounded weights of a take exactly.
  const weights = names.map((_, i) => Array.from(weightsOf(motion, i), (weight) => Number(weight.toFixed(5))))
  return jsonFile({ version: 1, name, ...(range && { range }), rate: TAKE_RATE, names, weights })
}

/**
 * Reads a file that `takeFile` made.
 *
 * @param path path of the file, for errors.
 * @throws FurrowError for the first missing or invalid field.
 */
export function parseTakeFile(json: unknown, path: string): Take {
  const reader = new JsonReader(path)
  const fields = reader.object(json, 'the take')
  reader.integer(fields.version, 'version', 1, 1)
  reader.integer(fields.rate, 'rate', TAKE_RATE, TAKE_RATE)
  const names = parseShapeNames(reader, fields.names, 'names')
  const lists = reader.array(fields.weights, 'weights', names.length, names.length)
  const frames = reader.array(lists[0], 'weights[0]', 2, MAX_FRAMES).length
  const weights = new Float32Array(frames * names.length)
  for (const [i, list] of lists.entries()) {
    const numbers = reader.array(list, `weights[${i}]`, frames, frames)
    for (const [k, weight] of numbers.entries())
      weights[i * frames + k] = reader.number(weight, `weights[${i}]`, 0, 1, '')
  }
  const motion = { names, weights }
  return {
    name: reader.name(fields.name, 'name'),
    motion,
    ...(fields.range !== undefined && { range: parseRange(reader, fields.range, 'range', framesOf(motion)) }),
  }
}

/** Reads in and out points, seconds. */
export function parseRange(
  reader: JsonReader,
  value: unknown,
  path: string,
  frames = MAX_FRAMES,
): [number, number] {
  const [start, end] = reader.array(value, path, 2, 2)
  const last = (frames - 1) / TAKE_RATE
  const from = reader.number(start, `${path}[0]`, 0, last, 'seconds')
  return [from, reader.number(end, `${path}[1]`, from, last, 'seconds')]
}

export function parseShapeNames(reader: JsonReader, value: unknown, path: string): string[] {
  return reader
    .array(value, path, 1, MAX_TAKE_SHAPES)
    .map((name, i) => reader.text(name, `${path}[${i}]`, MAX_NAME_LENGTH))
}
