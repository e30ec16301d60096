import { fromUtf8, utf8 } from './bytes.ts'
import { cannotRead, firstLine } from './errors.ts'
import { kindOf } from './file-kind.ts'
import { depthProblem } from './json-depth.ts'

/**
 * Parses the bytes of a JSON file.
 *
 * @param name name of the file, for errors.
 * @throws FurrowError if the file is not JSON, or nested too deeply.
 */
export function parseJson(bytes: Uint8Array, name: string, who: string): unknown {
  const hints = { limit: 'JSON', remedy: 'correct the file, or choose another one' }
  let json: unknown
  try {
    json = JSON.parse(fromUtf8(bytes))
  } catch (error) {
    const kind = kindOf(bytes)
    const problem = kind === undefined || kind === 'text' ? firstLine(error) : `it is ${kind}`
    throw cannotRead(who, name, new Error(problem, { cause: error }), hints)
  }
  const problem = depthProblem(json)
  if (problem) throw cannotRead(who, name, new Error(problem), { remedy: 'correct the file' })
  return json
}

/** Encodes an object as JSON. Each item of a list, e.g. a stroke or an area, gets its own line. */
export function jsonFile(object: object): Uint8Array {
  const fields = Object.entries(object).map(([name, value]) => `  "${name}": ${fieldText(value)}`)
  return utf8(`{\n${fields.join(',\n')}\n}\n`)
}

function fieldText(value: unknown): string {
  if (!Array.isArray(value)) return JSON.stringify(value)
  return `[\n${value.map((item) => `    ${JSON.stringify(item)}`).join(',\n')}\n  ]`
}
