import { readFileSync } from 'node:fs'
import type { Option } from 'commander'
import { describe, expect, it } from 'vitest'
import { COMMAND_NAMES, commandOf } from '../../commands.ts'
import { Workshop } from './workshop.ts'

/** Page that explains the options of each command. Only the options of `render` have no page. */
const PAGES = {
  activations: 'docs/drivers.md',
  array: 'docs/array.md',
  auto: 'docs/auto.md',
  bake: 'docs/bake.md',
  batch: 'docs/batch.md',
  import: 'docs/import.md',
  inspect: 'docs/inspect.md',
  live: 'docs/live.md',
  normals: 'docs/normals.md',
  pack: 'docs/pack.md',
  strokes: 'docs/strokes.md',
  unpack: 'docs/pack.md',
  uv: 'docs/pack.md',
  validate: 'docs/inspect.md',
  worker: 'docs/batch-machines.md',
}

const shop = new Workshop()
const commands = await Promise.all(COMMAND_NAMES.map(commandOf))

it('all commands are tested', () => {
  const registered = readFileSync('packages/cli/src/main.ts', 'utf8').matchAll(/^ {2}(\w+)Command,$/gm)
  expect([...registered].map(([, name]) => name)).toEqual(COMMAND_NAMES)
})

it.each(Object.entries(PAGES))('every option of %s is explained in %s', (name, path) => {
  const page = readFileSync(path, 'utf8')
  const { options } = commands.find((command) => command.name() === name)!
  const missing = options.filter(({ short, long }) => ![short, long].some((flag) => page.includes(flag!)))
  expect(missing.map(({ flags }) => flags)).toEqual([])
})

it('the README names the help of render, which has no page', () => {
  expect(COMMAND_NAMES).toHaveLength(Object.keys(PAGES).length + 1)
  expect(readFileSync('README.md', 'utf8')).toContain('`npx furrow render --help` lists all options')
})

it.each(commands)('the help of $_name has examples', (command) => {
  command.outputHelp()
  expect(shop.printed).toMatch(new RegExp(`^Examples?:\n  \\$ furrow ${command.name()} `, 'm'))
})

describe('an option', () => {
  const choices = (option: Option) => option.argChoices?.join(' ')
  const parse = (option: Option, text: string) => option.parseArg!(text, undefined)

  /** Returns the choices of an option, or the rule that its error about an invalid value states. */
  function ruleOf(option: Option): string {
    try {
      return `takes ${parse(option, '?')}`
    } catch (error) {
      return choices(option) ?? (error as Error).message.replace(/^It must be (.*)\.$/, '$1')
    }
  }

  const parsed = commands.flatMap((command) =>
    command.options
      .filter(({ parseArg }) => parseArg)
      .map((option) => ({ name: `${command.name()} ${option.long}`, option, rule: ruleOf(option) })),
  )

  it('rejects invalid values', () => {
    const weights = 'NAME=VALUE with a value from 0 to 1; put files before this option'
    const expressions = 'neutral surprised angry happy disgusted sad leftBrow rightBrow leftWink rightWink'
    expect(Object.fromEntries(parsed.map(({ name, rule }) => [name, rule]))).toEqual({
      'activations --set': weights,
      'activations --expression': expressions,
      'activations --input': 'NAME=VALUE with a finite value; put files before this option',
      'array --compress': 'none zstd uastc etc1s',
      'auto --age': 'a number from 20 to 80 years',
      'auto --strength': 'a number from 0 to 2',
      'auto --size': '512 1024 2048 4096',
      'auto --seed': 'an integer from 0 to 2147483647',
      'auto --symmetry': 'a number from 0 to 1',
      'auto --cloth': 'silk shirt denim leather',
      'auto --kind': 'MESH=KIND, with one of the kinds skin, cloth, hard',
      'auto --layers': 'an integer from 1 to 4',
      'auto --areas': 'an integer from 1 to 64',
      'auto --regions':
        'foreheadInner foreheadOuter glabella noseRoot nose crowsFeet underEye nasolabial mouthCorner upperLip lowerLip chin neck bag hood cheek jowl',
      'bake --size': 'an integer from 16 to 8192',
      'bake --cage': 'a number from 0.001 to 100000 mm',
      'bake --samples': '1 4 9 16',
      'bake --tangents': 'mikktspace derivative',
      'bake --margin': 'an integer from 0 to 8192',
      'bake --bits': '8 16',
      'bake --rays': 'an integer from 1 to 4096',
      'bake --reach': 'a number from 0.001 to 100000 mm',
      'batch --command': 'auto pack validate inspect',
      'batch --shard': 'I/N, from 1/N to N/N, for part I of N',
      'batch --jobs': 'an integer from 1 to 1024',
      'batch --memory': 'an integer from 256 to 1048576 MB',
      'batch --timeout': 'a number from 1 to 86400 seconds',
      'batch --thumbnails': 'an integer from 0 to 100000',
      'import --from': 'character-creator metahuman expressions',
      'import --size': 'an integer from 64 to 8192 texels',
      'import --green': 'up down',
      'import --power': 'NAME=VALUE with a value from 0.25 to 2; put files before this option',
      'normals --depth': 'a number from 0.000001 to 1000000 mm',
      'normals --width': 'a number from 0.000001 to 1000000 mm',
      'normals --strength': 'a number from -100000 to 100000 texels',
      'normals --green': 'up down',
      'normals --edges': 'wrap clamp',
      'live --devices': 'an IP address, e.g. 127.0.0.1',
      'live --host': 'an IP address, e.g. 127.0.0.1',
      'live --phone': 'an IP address, e.g. 127.0.0.1',
      'live --port': 'an integer from 0 to 65535',
      'live --sources': 'live-link-face vmc ifacialmocap openseeface',
      'live --udp-port': 'NAME=VALUE with a value from 0 to 65535; put files before this option',
      'normals --bits': '8 16',
      'pack --area-size': 'an integer from 2 to 8192 texels',
      'pack --share': '1 3 4',
      'pack --size': 'an integer from 2 to 8192 texels',
      'render --expression': expressions,
      'render --set': weights,
      'render --activation': weights,
      'render --size': 'WIDTHxHEIGHT with sides from 16 to 8192 pixels',
      'render --view': 'front left right three-quarter close',
      'render --renderer': 'webgl webgpu',
      'render --mode': 'default paper composed off',
      'render --relief': 'off on near',
      'strokes --size': 'an integer from 16 to 8192 texels',
      'uv --size': 'an integer from 64 to 8192 texels',
      'worker --jobs': 'an integer from 1 to 1024',
      'worker --memory': 'an integer from 256 to 1048576 MB',
      'worker --timeout': 'a number from 1 to 86400 seconds',
    })
  })

  const numbers = parsed.flatMap(({ name, option, rule }) => {
    const [, kind, min, max] = /^an? (integer|number) from (\S+) to (\S+)/.exec(rule) ?? []
    return kind === undefined ? [] : [[name, option, Number(min), Number(max), kind === 'integer'] as const]
  })

  it.each(numbers)(
    '%s accepts the ends of its range and nothing beyond',
    (_, option, min, max, isInteger) => {
      expect([parse(option, `${min}`), parse(option, `${max}`)]).toEqual([min, max])
      const step = isInteger ? 1 : Math.abs(min) / 2 || 0.5
      for (const text of [
        `${min - step}`,
        `${max + step}`,
        '',
        'NaN',
        ...(isInteger ? [`${min + 0.5}`] : []),
      ])
        expect(() => parse(option, text), text).toThrow('It must be')
    },
  )

  it.each(['15x600', '800x15', '8193x600', '800'])('of render rejects a size of %s', (text) => {
    const size = parsed.find(({ name }) => name === 'render --size')!.option
    expect(() => parse(size, text)).toThrow('sides from 16 to 8192 pixels')
    expect(parse(size, '16x8192')).toEqual({ width: 16, height: 8192 })
  })
})
