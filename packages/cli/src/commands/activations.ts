import { Option } from 'commander'
import { EXPRESSIONS, FurrowError, findTargets } from 'furrow'
import {
  describeDriver,
  describeLink,
  didYouMean,
  type Explanation,
  explain,
  needsMesh,
} from 'furrow/internal'
import { targetNamesOf, targetOfMaterial } from 'furrow-files'
import { readWrinkledFile } from 'furrow-files/node'
import { createCommand } from '../command.ts'
import { allowOutsideOption, assignmentParser, parseWeight } from '../options.ts'
import { print } from '../print.ts'

const WHO = 'furrow activations'

interface Options {
  material?: string
  allowOutside?: boolean
  expression?: string
  set?: Record<string, number>
  input?: Record<string, number>
  json?: boolean
}

/** `furrow activations`: why a wrinkle shows. */
export const activationsCommand = createCommand('activations')
  .description('show the activation of each area of a face, and which link gave it')
  .argument('<face>', 'a face with wrinkles (.glb, .vrm, .gltf)')
  .option('--set <target=weight...>', 'blendshapes, 0 to 1, on top of the expression', parseWeight)
  .addOption(new Option('--expression <name>', 'an expression').choices(EXPRESSIONS.map(({ name }) => name)))
  .option(
    '--input <name=value...>',
    'inputs that an application would set, such as age=50',
    assignmentParser(),
  )
  .option('--material <name>', 'the material with the wrinkles (default: the only one)')
  .addOption(allowOutsideOption())
  .option('--json', 'print the result as JSON')
  .addHelpText(
    'after',
    `
Drivers that read joints or tension need the moving mesh: they are listed without a number.

Examples:
  $ furrow activations wrinkled.glb --set mouthSmileLeft=1 cheekSquintLeft=0.5
  $ furrow activations wrinkled.glb --expression angry --input age=60 --json`,
  )
  .action(activations)

async function activations(path: string, options: Options): Promise<void> {
  const { glb, material, maps } = await readWrinkledFile(path, WHO, options)
  const target = targetOfMaterial(glb.json, material, maps.drivers)
  const targetNames = target ? targetNamesOf(glb.json.meshes![target.mesh]) : []
  const weights = weightsOf(targetNames, { ...expressionTargets(options.expression), ...options.set })
  const explanations = explain(maps.drivers, maps.areas, {
    targetNames,
    weights,
    inputs: options.input,
  })
  const others = maps.drivers.filter(needsMesh).map(describeDriver)
  const lines = options.json
    ? JSON.stringify({
        file: path,
        areas: explanations,
        ...(others.length > 0 && { needMovingMesh: others }),
      })
    : [...explanations.flatMap(describe), ...others.map((text) => `needs the moving mesh: ${text}`)]
  print(lines)
}

/** `0.620  nose`, and below it what each driver and link contributed, largest first; zeros are left out. */
function describe({ area, activation, resting, parts }: Explanation): string[] {
  const lines = parts
    .filter((part) => part.activation > 0)
    .sort((a, b) => b.activation - a.activation)
    .flatMap(({ driver, activation, links }) => [
      `  ${number(activation)}  ${describeDriver(driver)}`,
      ...links
        .filter(({ value }) => value !== 0)
        .map(({ link, value }) => `        ${number(value)}  ${describeLink(link)}`),
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
    const indices = findTargets(name, targetNames)
    if (indices.length === 0) {
      throw new FurrowError({
        code: 'unknown-name',
        who: WHO,
        problem: 'no such blendshape',
        value: name,
        limit: targetNames.join(', ') || 'the mesh has none',
        remedy: didYouMean(name, targetNames, 'name one of these'),
      })
    }
    for (const index of indices) weights[index] = weight
  }
  return weights
}
