/** Maximum nesting depth of JSON. The limit protects recursive code from stack overflow. */
const MAX_DEPTH = 128

/** Returns an error text if JSON is nested too deeply, otherwise undefined. */
export function depthProblem(json: unknown): string | undefined {
  let level = [json].filter(isObject)
  for (let depth = 0; depth < MAX_DEPTH; depth++) {
    level = level.flatMap((value) => Object.values(value).filter(isObject))
    if (level.length === 0) return undefined
  }
  return `its JSON is more than ${MAX_DEPTH} levels deep`
}

const isObject = (value: unknown): value is object => typeof value === 'object' && value !== null
