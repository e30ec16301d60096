import { FurrowError } from 'furrow'
import { firstLine, fromUtf8 } from 'furrow-files'
import { readBytes } from 'furrow-files/node'
import type { JobCommandName } from '../jobs/job-commands.ts'
import { type JobOptions, manifestWords, parseJobOptions } from '../jobs/job-options.ts'

const WHO = 'furrow batch'

export interface ManifestLine {
  input: string
  output?: string
  options: JobOptions
}

const FIELDS = ['input', 'output', 'options']

/**
 * Reads a manifest. Each line is a JSON object, e.g. `{"input": "a.glb", "output": "out/a.glb", "options": {"age":
 * 40}}`.
 *
 * @param shared options for all lines. Options of a line override them.
 * @throws FurrowError with the number of the first invalid line.
 */
export async function readManifest(
  path: string,
  command: JobCommandName,
  shared: JobOptions,
): Promise<ManifestLine[]> {
  const text = fromUtf8(await readBytes(path, WHO, 'the manifest'))
  const lines = text.replace(/^\ufeff/, '').split(/\r?\n/)
  return lines.flatMap((line, i) => {
    return line.trim() === '' ? [] : [parseLine(line, `${path}, line ${i + 1}`, command, shared)]
  })
}

function parseLine(line: string, where: string, command: JobCommandName, shared: JobOptions): ManifestLine {
  let json: unknown
  try {
    json = JSON.parse(line)
  } catch (error) {
    throw invalidLine(where, `is not JSON (${firstLine(error)})`)
  }
  if (typeof json !== 'object' || json === null || Array.isArray(json)) {
    throw invalidLine(where, 'is not an object')
  }
  const unknown = Object.keys(json).find((name) => !FIELDS.includes(name))
  if (unknown !== undefined) throw invalidLine(where, `has an unknown field "${unknown}"`)
  const { input, output, options = {} } = json as Record<string, unknown>
  if (typeof input !== 'string' || input === '') throw invalidLine(where, 'has no "input"')
  if (output !== undefined && (typeof output !== 'string' || output === '')) {
    throw invalidLine(where, 'has an "output" that is not text')
  }
  const own = parseJobOptions(command, manifestWords(options, where))
  return { input, ...(output !== undefined && { output }), options: { ...shared, ...own } }
}

function invalidLine(where: string, problem: string): FurrowError {
  return new FurrowError({
    who: WHO,
    problem: `${where} ${problem}`,
    limit: '{ "input": "a.glb", "output": "out/a.glb", "options": { "age": 40 } }',
    remedy: 'correct the line',
  })
}
