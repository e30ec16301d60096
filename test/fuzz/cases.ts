import { mkdirSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import type { Command } from 'commander'
import { activationsCommand } from '../../packages/cli/src/commands/activations.ts'
import { arrayCommand } from '../../packages/cli/src/commands/array.ts'
import { autoCommand } from '../../packages/cli/src/commands/auto.ts'
import { bakeCommand } from '../../packages/cli/src/commands/bake.ts'
import { importCommand } from '../../packages/cli/src/commands/import.ts'
import { inspectCommand } from '../../packages/cli/src/commands/inspect.ts'
import { normalsCommand } from '../../packages/cli/src/commands/normals.ts'
import { packCommand } from '../../packages/cli/src/commands/pack.ts'
import { strokesCommand } from '../../packages/cli/src/commands/strokes.ts'
import { unpackCommand } from '../../packages/cli/src/commands/unpack.ts'
import { uvCommand } from '../../packages/cli/src/commands/uv.ts'
import { validateCommand } from '../../packages/cli/src/commands/validate.ts'
import { preparePicture } from '../../packages/cli/src/render/prepare.ts'
import type { Bases } from './bases.ts'
import { damageGlb } from './damage-glb.ts'
import { hostileImage } from './damage-images.ts'
import { damageJson, textOf } from './damage-json.ts'
import type { Random } from './random.ts'
import { writeFace } from './write-face.ts'

/** One run of a command on a damaged file. */
export interface Case {
  run(): Promise<unknown>
  /** Paths of the faces that the command may write, and of the faces that they are made from. */
  faces: { output: string; input: string }[]
  /** Total size of the input files, bytes. */
  bytes: number
}

/** Writes the input files of a case and adds up their sizes. */
class Folder {
  readonly root: string
  bytes = 0

  constructor(root: string) {
    this.root = root
  }

  path(name: string): string {
    return join(this.root, name)
  }

  readonly write = (name: string, bytes: Buffer | string): string => {
    mkdirSync(join(this.path(name), '..'), { recursive: true })
    writeFileSync(this.path(name), bytes)
    this.bytes += bytes.length
    return this.path(name)
  }
}

type CaseMaker = (bases: Bases, random: Random, folder: Folder) => Pick<Case, 'run'> & Partial<Case>

const runs = (command: Command, ...args: string[]) => ({
  run: () => command.parseAsync(args, { from: 'user' }),
})

const damagedFace = ({ faces }: Bases, random: Random, names = [...faces.keys()]) =>
  damageGlb(faces.get(random.pick(names))!, random)

/** Writes a damaged face and returns its path. */
const writeDamaged = (bases: Bases, random: Random, folder: Folder, names?: string[]) =>
  writeFace(damagedFace(bases, random, names), random, folder.write)

const PACKED = ['packed.glb', 'packed-array.glb']
const BARE = ['plain.glb', 'skinned.glb', 'sparse.glb', 'quantised.glb', 'meshopt.glb', 'draco.glb']

function damagedJson(document: Buffer, random: Random): string {
  const json = JSON.parse(document.toString())
  for (let changes = random.pick([1, 1, 2, 3]); changes > 0; changes--) damageJson(json, random)
  return textOf(json)
}

/** Writes the files of a wrinkle set, one of them damaged. */
function writeWrinkles(bases: Bases, random: Random, folder: Folder): void {
  const documents = ['wrinkles.json', 'wrinkles.json', 'strokes.json']
  const damaged = random.pick(random.chance(0.6) ? documents : [...bases.folder.keys()])
  for (const [name, bytes] of bases.folder) {
    if (name !== damaged) folder.write(name, bytes)
    else folder.write(name, name.endsWith('.json') ? damagedJson(bytes, random) : hostileImage(random, bytes))
  }
}

const PRESET = {
  version: 1,
  age: 60,
  seeds: { chin: 3 },
  strengths: { glabella: 2 },
  regions: ['chin', 'nose'],
}

/** Names for the output file. The extension selects the format. `.glb` is listed twice, to pick it more often. */
const OUTPUTS = ['out.glb', 'out.glb', 'out.vrm', 'out.gltf']

const CASES: Record<string, CaseMaker> = {
  activations: (bases, random, folder) => {
    const input = writeDamaged(bases, random, folder, PACKED)
    const options = random.pick([['--set', 'browInnerUp=1'], ['--expression', 'surprised'], ['--json']])
    return runs(activationsCommand, input, ...options)
  },
  array: (bases, random, folder) => {
    if (random.chance(0.5)) {
      const array = folder.write('array.ktx2', hostileImage(random, bases.array))
      return runs(arrayCommand, array, '--extract', folder.path('out'))
    }
    const images = ['a', 'b'].map((name) =>
      folder.write(`${name}.png`, random.chance(0.6) ? bases.height : hostileImage(random, bases.height)),
    )
    const compress = random.pick(['zstd', 'none', 'uastc', 'etc1s'])
    return runs(arrayCommand, ...images, '-o', folder.path('out.ktx2'), '--compress', compress)
  },
  auto: (bases, random, folder) => {
    const [input, output] = [writeDamaged(bases, random, folder), folder.path(random.pick(OUTPUTS))]
    // Slow options are picked less often.
    const strokes = ['--strokes', folder.path('strokes.json')]
    const rare = [['--ktx2'], ['--report', folder.path('report')], ['--age', '80'], strokes]
    const options = random.chance(0.3) ? random.pick(rare) : []
    if (random.chance(0.1)) {
      const preset = damagedJson(Buffer.from(JSON.stringify(PRESET)), random)
      options.push('--preset', folder.write('preset.json', preset))
    }
    const small = ['--size', '512', '--areas', '4', '--age', '20', '--replace']
    return { ...runs(autoCommand, input, '-o', output, ...small, ...options), faces: [{ output, input }] }
  },
  bake: (bases, random, folder) => {
    const intact = folder.write('whole.glb', bases.faces.get('plain.glb')!)
    const files = [writeDamaged(bases, random, folder), intact]
    const outputs = ['-o', folder.path('out.png'), '--height', folder.path('height.png')]
    const small = ['--size', '32', '--samples', '1']
    return runs(bakeCommand, ...(random.chance(0.5) ? files : files.reverse()), ...outputs, ...small)
  },
  import: (bases, random, folder) => {
    const face = random.chance(0.4) ? damagedFace(bases, random, BARE) : bases.faces.get(random.pick(BARE))!
    const [input, output] = [folder.write('face.glb', face), folder.path(random.pick(OUTPUTS))]
    const normals = [...bases.folder].find(([path]) => path.endsWith('normal.png'))![1]
    for (const [path, image] of [
      ['neutral.png', bases.height],
      ['happy.png', normals],
      ['happy_baseColor.png', normals],
    ] as const) {
      folder.write(`scans/${path}`, random.chance(0.8) ? image : hostileImage(random, image))
    }
    const maps = {
      neutral: { normal: 'neutral.png' },
      expressions: [{ name: 'happy', at: 0.5, normal: 'happy.png' }],
    }
    if (random.chance(0.4))
      folder.write('scans/expressions.json', damagedJson(Buffer.from(JSON.stringify(maps)), random))
    const options = random.pick([[], ['--ktx2'], ['--size', '64'], ['--json']])
    return {
      ...runs(importCommand, folder.path('scans'), '--face', input, '-o', output, ...options),
      faces: [{ output, input }],
    }
  },
  inspect: (bases, random, folder) => {
    const face = writeDamaged(bases, random, folder, random.chance(0.7) ? PACKED : BARE)
    return runs(inspectCommand, face, ...(random.chance(0.5) ? ['--sheet', folder.path('out.png')] : []))
  },
  normals: (bases, random, folder) => {
    const height = folder.write('height.png', hostileImage(random, bases.height))
    return runs(normalsCommand, height, '-o', folder.path('out.png'), '--strength', '4')
  },
  pack: (bases, random, folder) => {
    const isFace = random.chance(0.4)
    const face = isFace ? damagedFace(bases, random, BARE) : bases.faces.get(random.pick(BARE))!
    const [input, output] = [folder.write('face.glb', face), folder.path(random.pick(OUTPUTS))]
    writeWrinkles(bases, random, folder)
    const options = random.pick([[], ['--ktx2'], ['--size', '32'], ['--morph-normals']])
    return { ...runs(packCommand, folder.root, '-o', output, ...options), faces: [{ output, input }] }
  },
  'render (preparation)': (bases, random, folder) => {
    if (random.chance(0.6)) {
      const input = writeDamaged(bases, random, folder)
      return { run: () => preparePicture({ input }) }
    }
    const input = folder.write('face.glb', bases.faces.get('plain.glb')!)
    writeWrinkles(bases, random, folder)
    const wrinkles = folder.path('wrinkles.json')
    return { run: () => preparePicture({ input, wrinkles }) }
  },
  strokes: (bases, random, folder) => {
    const isFace = random.chance(0.7)
    const face = isFace
      ? writeDamaged(bases, random, folder)
      : folder.write('face.glb', bases.faces.get('plain.glb')!)
    const strokes = folder.write('strokes.json', isFace ? bases.strokes : damagedJson(bases.strokes, random))
    const maps = ['-o', folder.path('out.png'), '--normal', folder.path('normal.png')]
    const areas = ['--areas', folder.path('out')]
    const outputs = random.pick([
      [...maps, ...areas, '--layer', 'age'],
      [...maps, '--layer', 'expression'],
      areas,
    ])
    return runs(strokesCommand, strokes, '--face', face, ...outputs)
  },
  unpack: (bases, random, folder) => {
    const input = writeDamaged(bases, random, folder, PACKED)
    const output = folder.path('out')
    return {
      ...runs(unpackCommand, input, '-o', output),
      faces: [{ output: join(output, 'face.glb'), input }],
    }
  },
  uv: (bases, random, folder) => {
    const input = writeDamaged(bases, random, folder)
    const options = random.pick([[], ['--mesh', 'skin']])
    return runs(uvCommand, input, '-o', folder.path('out.png'), '--size', '128', ...options)
  },
  validate: (bases, random, folder) => {
    const options = random.pick([[], ['--all'], ['--json']])
    return runs(validateCommand, writeDamaged(bases, random, folder), ...options)
  },
}

/** Names of the commands that read users' files. */
export const COMMANDS = Object.keys(CASES)

/** Writes the damaged files of a case into a folder. */
export function makeCase(command: string, bases: Bases, random: Random, root: string): Case {
  const folder = new Folder(root)
  const made = CASES[command]!(bases, random, folder)
  return { faces: [], ...made, bytes: folder.bytes }
}
