import { Option } from 'commander'
import { EXPRESSIONS, type Explanation, FurrowError, findTargets } from 'furrow'
import { describeDriver, describeLink, didYouMean, explain, needsMesh } from 'furrow/internal'
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

export const activationsCommand = createCommand('activations')
  .description('show the activation of each area and its drivers')
  .argument('<face>', 'face with wrinkles (.glb, .vrm, .gltf)')
  .option('--set <target=weight...>', 'blendshape weights, 0 to 1', parseWeight)
  .addOption(
    new Option('--expression <name>', 'expression to apply').choices(EXPRESSIONS.map(({ name }) => name)),
  )
  .option('--input <name=value...>', 'custom inputs, e.g. age=50', assignmentParser())
  .option('--material <name>', 'material with wrinkles (default: the only one)')
  .addOption(allowOutsideOption())
  .option('--json', 'print the result as JSON')
  .addHelpText(
    'after',
    `
--set overrides the expression. Drivers that read joints or tension need an
animated mesh, so the command lists them without a value.

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
    : [
        ...explanations.flatMap(describe),
        ...others.map((text) => `not evaluated without an animated mesh: ${text}`),
      ]
  print(lines)
}

/**
 * Formats an area, e.g. `0.620 nose`, and below it the drivers and blendshapes that contribute, largest first. Omits
 * contributions of 0.
 */
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

/** Returns weights in the order of the mesh's blendshapes. Throws if a blendshape is unknown. */
function weightsOf(targetNames: readonly string[], set: Readonly<Record<string, number>>): Float64Array {
  const weights = new Float64Array(targetNames.length)
  for (const [name, weight] of Object.entries(set)) {
    const indices = findTargets(name, targetNames)
    if (indices.length === 0) {
      throw new FurrowError({
        code: 'unknown-name',
        who: WHO,
        problem: 'unknown blendshape',
        value: name,
        limit: targetNames.join(', ') || 'the mesh has none',
        remedy: didYouMean(name, targetNames, 'choose one of these'),
      })
    }
    for (const index of indices) weights[index] = weight
  }
  return weights
}
