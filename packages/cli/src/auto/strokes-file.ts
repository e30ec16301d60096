import { type AutoWrinkles, strokesOf } from 'furrow/author'

/** The lines of automatic wrinkles as a document of strokes, each on a line of its own. */
export function strokesFile(wrinkles: AutoWrinkles): Buffer {
  const { strokes, ...head } = strokesOf(wrinkles)
  const lines = strokes.map((stroke) => `    ${JSON.stringify(stroke)}`).join(',\n')
  const fields = Object.entries(head).map(([name, value]) => `  "${name}": ${JSON.stringify(value)},\n`)
  return Buffer.from(`{\n${fields.join('')}  "strokes": [\n${lines}\n  ]\n}\n`)
}
