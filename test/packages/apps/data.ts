// Uses `furrow`, `furrow/author` and `furrow/auto` in an app without other packages.
import { EXPRESSIONS, FurrowError, parseWrinkleSetDocument, type WrinkleSetDocument } from 'furrow'
import { bumpToNormal, type NormalMap } from 'furrow/author'
import { autoWrinklesInWorker } from 'furrow/auto'

const set: WrinkleSetDocument = parseWrinkleSetDocument({
  version: 1,
  layers: [{ name: 'expression', normal: 'normal.png' }],
  areas: [{ name: 'nose', image: 'nose.png' }],
})

let message = ''
try {
  parseWrinkleSetDocument({ version: 2 })
} catch (error) {
  if (error instanceof FurrowError) message = error.message
}

const flat: NormalMap = bumpToNormal({ width: 2, height: 1, data: new Float32Array(2) })

let inNode = ''
try {
  await autoWrinklesInWorker({ positions: [], uvs: [], indices: [], targets: [] }, { age: 60 })
} catch (error) {
  if (error instanceof FurrowError) inNode = error.problem
}

console.info(
  JSON.stringify({
    areas: set.areas.map(({ name }) => name),
    surprised: EXPRESSIONS.some(({ name }) => name === 'surprised'),
    message,
    inNode,
    normal: [...flat.data],
  }),
)
