import { Option } from 'commander'
import { AGES, EXPRESSIONS, type Explanation, explain, FurrowError, findTargets } from 'furrow'
import { createCommand } from '../command.ts'
import { targetNamesOf } from '../gltf/gltf-json.ts'
import { numberParser, parseWeight } from '../options.ts'
import { driverText, linkText } from '../wrinkles/driver-text.ts'
import { readWrinkledFile } from '../wrinkles/wrinkled-file.ts'

const WHO = 'furrow activations'

interface Options {
  material?: string
  expression?: string
  set?: Record<string, number>
  age: number
  json?: boolean
}

/** `furrow activations`: why a wrinkle shows. */
export const activationsCommand = createCommand('activations')
  .description('show the activation of each area of a face, and which link gave it')
  .argument('<face>', 'a face with wrinkles (.glb)')
  .option('--set <target=weight...>', 'blendshapes, 0 to 1, on top of the expression', parseWeight)
  .addOption(new Option('--expression <name>', 'an expression').choices(EXPRESSIONS.map(({ name }) => name)))
  .addOption(
    new Option('--age <years>', 'for areas driven by age, 0 to 120')
      .argParser(numberParser({ min: 0, max: 120, unit: 'years' }))
      .default(AGES.youngest),
  )
  .option('--material <name>', 'the material that has the wrinkles (default: the only one)')
  .option('--json', 'print it as JSON')
  .addHelpText(
    'after',
    `
Joints and tension move areas too, but need the moving mesh: such drivers are listed without a number.

Examples:
  $ furrow activations faces/human.glb --set mouthSmileLeft=1 cheekSquintLeft=0.5
  $ furrow activations faces/human.glb --expression angry --json`,
  )
  .action(activations)

async function activations(path: string, options: Options): Promise<void> {
  const { glb, material, maps } = await readWrinkledFile(path, WHO, options.material)
  const mesh = (glb.json.meshes ?? []).find(({ primitives }) =>
    primitives.some((primitive) => primitive.material === material),
  )
  const targetNames = mesh ? targetNamesOf(mesh) : []
  const weights = weightsOf(targetNames, { ...expressionTargets(options.expression), ...options.set })
  const explanations = explain(maps.drivers, maps.areas, { targetNames, weights, age: options.age })
  const others = maps.drivers.filter(({ type }) => type === 'bone' || type === 'tension').map(driverText)
  const text = options.json
    ? JSON.stringify({
        file: path,
        areas: explanations,
        ...(others.length > 0 && { needTheMovingMesh: others }),
      })
    : [...explanations.flatMap(describe), ...others.map((text) => `needs the moving mesh: ${text}`)].join(
        '\n',
      )
  process.stdout.write(`${text}\n`)
}

/** `nose 0.62`, and below it what gave it, the largest first; what gives nothing is left out. */
function describe({ area, activation, resting, parts }: Explanation): string[] {
  const lines = parts
    .filter((part) => part.activation > 0)
    .sort((a, b) => b.activation - a.activation)
    .flatMap(({ driver, activation, links }) => [
      `  ${number(activation)}  ${driverText(driver)}`,
      ...links
        .filter(({ value }) => value !== 0)
        .map(({ link, value }) => `        ${number(value)}  ${linkText(link)}`),
    ])
  return [
    `${number(activation)}  ${area}`,
    ...(resting > 0 ? [`  ${number(resting)}  at rest`] : []),
    ...lines,
  ]
}

const number = (value: number) => value.toFixed(3)

function expressionTargets(name: string | undefined): Readonly<Record<string, number>> {
  return EXPRESSIONS.find((expression) => expression.name === name)?.targets ?? {}
}

/** In the order of the mesh's blendshapes. Throws FurrowError where it has none of a name. */
function weightsOf(targetNames: readonly string[], set: Readonly<Record<string, number>>): Float64Array {
  const weights = new Float64Array(targetNames.length)
  for (const [name, weight] of Object.entries(set)) {
    const places = findTargets(name, targetNames)
    if (places.length === 0) {
      throw new FurrowError({
        code: 'unknown-name',
        who: WHO,
        what: 'no such blendshape',
        value: name,
        limit: targetNames.join(', ') || 'the mesh has none',
        remedy: 'name one of these',
      })
    }
    for (const place of places) weights[place] = weight
  }
  return weights
}
