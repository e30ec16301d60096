import { Option } from 'commander'
import { FurrowError } from 'furrow'
import { cannotRead, withCommandErrors } from 'furrow-files'
import { describe, expect, it, vi } from 'vitest'
import { createCommand } from '../../../packages/cli/src/command.ts'
import { numberParser, parseWeight } from '../../../packages/cli/src/options.ts'
import { runCommand } from '../../commands.ts'

/** Returns the value that `work` throws or rejects with. */
async function failure(work: () => unknown): Promise<unknown> {
  try {
    return await work()
  } catch (error) {
    return error
  }
}

describe('library errors in a command', () => {
  const parts = {
    code: 'out-of-range',
    problem: 'too large',
    value: 9,
    limit: '0..1',
    remedy: 'scale it',
  } as const

  it('name the command, keep all other parts, and have the original as cause', async () => {
    const original = new FurrowError({ who: 'bakeMaps', ...parts })
    const error = await failure(() =>
      withCommandErrors('furrow bake', () => {
        throw original
      }),
    )
    expect(error).toMatchObject({ who: 'furrow bake', ...parts, cause: original })
  })

  it('name a remedy if memory is insufficient', async () => {
    const error = await failure(() => withCommandErrors('furrow bake', () => new Float64Array(2 ** 52)))
    expect(error).toMatchObject({ name: 'FurrowError', code: 'unsupported', who: 'furrow bake' })
    expect((error as Error).message).toContain('choose a smaller --size')
  })

  it('are rethrown unchanged if they are bugs', async () => {
    const bug = new TypeError('x is not a function')
    const error = await failure(() =>
      withCommandErrors('furrow bake', () => {
        throw bug
      }),
    )
    expect(error).toBe(bug)
  })

  it('do not occur on success, and the result is returned', () => {
    expect(withCommandErrors('furrow bake', () => 7)).toBe(7)
  })
})

describe('file errors', () => {
  it('have a code, and the first line of their cause', async () => {
    const cause = new Error('broken header\n  at decoder')
    expect(cannotRead('furrow pack', 'the face a.glb', cause)).toMatchObject({
      code: 'unreadable',
      message: 'furrow pack: cannot read the face a.glb (broken header); check the path',
      cause,
    })
    const missing = await failure(() => runCommand('bake', 'none.glb', 'none.glb', '-o', 'x.png'))
    expect(missing).toMatchObject({ code: 'unreadable', who: 'furrow bake' })
  })
})

describe('the command line', () => {
  const run = (...args: string[]) => {
    const command = createCommand('knit')
      .argument('<yarn>')
      .requiredOption('-o, --output <file>', 'the result')
      .option('--rows <count>', 'rows', numberParser({ min: 1, max: 9, unit: 'cm', integer: true }))
      .option('--set <name=value...>', 'weights', parseWeight)
      .addOption(new Option('--stitch <kind>', 'stitch').choices(['plain', 'purl']).default('plain'))
      .addOption(new Option('--crochet', 'instead').conflicts('rows'))
    let options: unknown
    command.action((_, given) => {
      options = given
    })
    return command.parseAsync(args, { from: 'user' }).then(() => options)
  }

  it('is read with its defaults', async () => {
    expect(await run('wool', '-o', 'x')).toEqual({ output: 'x', stitch: 'plain' })
    expect(await run('wool', '-o', 'x', '--rows', '3', '--set', 'a=1', 'b=c=0.5')).toEqual({
      output: 'x',
      stitch: 'plain',
      rows: 3,
      set: { a: 1, 'b=c': 0.5 },
    })
  })

  it('refuses empty values, such as those of unset variables', async () => {
    const problem = (...args: string[]) =>
      failure(() => run(...args)).then((error) => (error as FurrowError).problem)
    expect(await problem('', '-o', 'x')).toBe("argument 'yarn' is empty")
    expect(await problem('wool', '-o', '')).toBe("option '-o, --output <file>' is empty")
    expect(await problem('wool', '--output=')).toBe("option '-o, --output <file>' is empty")
  })

  it('says that files must precede options with several values', async () => {
    const command = createCommand('knit')
      .argument('<yarn>')
      .addOption(new Option('--colours <names...>').choices(['red', 'blue']))
    const error = await failure(() => command.parseAsync(['--colours', 'red', 'wool.txt'], { from: 'user' }))
    expect((error as Error).message).toMatch(/; put files before this option; see furrow knit --help$/)
  })

  it.each<[string[], string]>([
    [['wool'], "required option '-o, --output <file>' not specified"],
    [['-o', 'x'], "missing required argument 'yarn'"],
    [['wool', '-o', 'x', '--purl'], "unknown option '--purl'"],
    [['wool', 'silk', '-o', 'x'], 'too many arguments. Expected 1 argument but got 2'],
    [
      ['wool', '-o', 'x', '--stitch', 'cable'],
      "option '--stitch <kind>' argument 'cable' is invalid. Allowed choices are plain, purl",
    ],
    [
      ['wool', '-o', 'x', '--rows', '2.5'],
      "option '--rows <count>' argument '2.5' is invalid. It must be an integer from 1 to 9 cm",
    ],
    [
      ['wool', '-o', 'x', '--crochet', '--rows', '2'],
      "option '--crochet' cannot be used with option '--rows <count>'",
    ],
  ])('%j is refused in one line, and nothing is printed', async (args, problem) => {
    const write = vi.spyOn(process.stderr, 'write')
    const error = await failure(() => run(...args))
    expect(error).toBeInstanceOf(FurrowError)
    expect(error).toMatchObject({ code: 'usage', who: 'furrow knit', problem })
    expect((error as Error).message).toMatch(/; see furrow knit --help$/)
    expect(write).not.toHaveBeenCalled()
    write.mockRestore()
  })

  it.each(['', ' ', 'x', '0', '10', '1e1', 'NaN', 'Infinity', '2.5'])(
    '%j is not an integer from 1 to 9',
    (text) => {
      expect(() => numberParser({ min: 1, max: 9, integer: true })(text)).toThrow('an integer from 1 to 9.')
    },
  )
})
