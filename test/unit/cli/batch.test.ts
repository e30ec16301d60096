import {
  existsSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { afterAll, describe, expect, it, vi } from 'vitest'
import { listInputs, nameOf } from '../../../packages/cli/src/batch/inputs/list-inputs.ts'
import { readManifest } from '../../../packages/cli/src/batch/inputs/manifest.ts'
import { isInShard, parseShard } from '../../../packages/cli/src/batch/inputs/shard.ts'
import { type Job, keyOf } from '../../../packages/cli/src/batch/jobs/job.ts'
import { parseJobOptions, wordsOf } from '../../../packages/cli/src/batch/jobs/job-options.ts'
import { parseJob } from '../../../packages/cli/src/batch/jobs/records.ts'
import { runJob } from '../../../packages/cli/src/batch/jobs/run-job.ts'
import { checkEntries, makePlan } from '../../../packages/cli/src/batch/plan.ts'
import type { ProcessEnd } from '../../../packages/cli/src/batch/processes/process-pool.ts'
import { batchPage } from '../../../packages/cli/src/batch/report/page.ts'
import { MAX_ROWS } from '../../../packages/cli/src/batch/report/rows.ts'
import { openResults, type ResultLine, readResults } from '../../../packages/cli/src/batch/results.ts'
import { runConcurrently } from '../../../packages/cli/src/batch/run-concurrently.ts'
import { runTasks } from '../../../packages/cli/src/batch/run-tasks.ts'
import { files } from '../../../packages/cli/src/batch/stores/local-files.ts'
import { isTransient, withRetries } from '../../../packages/cli/src/batch/stores/retries.ts'
import { countsOf, countsText, Rate } from '../../../packages/cli/src/batch/summary.ts'

const root = mkdtempSync(join(tmpdir(), 'furrow-batch-'))
afterAll(() => rmSync(root, { recursive: true }))

const write = (name: string, content: string) => {
  const path = join(root, name)
  mkdirSync(join(path, '..'), { recursive: true })
  writeFileSync(path, content)
  return path
}

const options = (...words: string[]) => parseJobOptions('auto', words)
const line = (input: string, more: Partial<ResultLine> = {}): ResultLine => ({
  ...{ key: input, command: 'auto', input, output: `out/${input}`, status: 'done', warnings: [] },
  ...{ bytes: 2000, seconds: 1, attempts: 1 },
  ...more,
})

describe('a job key', () => {
  const job = { command: 'auto', identity: 'sha256:1', options: options('--age', '40') } as const
  const key = keyOf('1.0.0', job)

  it('depends on version, command, content and options', () => {
    const others = [
      keyOf('1.0.1', job),
      keyOf('1.0.0', { ...job, command: 'inspect' }),
      keyOf('1.0.0', { ...job, identity: 'sha256:2' }),
      keyOf('1.0.0', { ...job, options: options('--age', '41') }),
      keyOf('1.0.0', { ...job, options: {} }),
    ]
    expect(new Set([key, ...others]).size).toBe(6)
  })

  it('does not depend on how the options are written', () => {
    const [a, b] = [options('--age', '40.0', '--furrows'), options('--furrows', '--age=40')]
    expect(keyOf('1', { ...job, options: a })).toBe(keyOf('1', { ...job, options: b }))
    expect(wordsOf(options('--regions', 'neck', 'chin', '--size', '512'))).toEqual([
      '--regions',
      'neck',
      'chin',
      '--size',
      '512',
    ])
  })

  it('refuses options that the command lacks', () => {
    expect(() => options('--agee', '40')).toThrow(
      /^furrow batch: unknown option '--agee'; did you mean "--age"/,
    )
    expect(() => options('--age', '400')).toThrow(/20 to 80 years/)
    expect(() => options('--output', 'x.glb')).toThrow(/unknown option/)
  })
})

describe('the content of a path', () => {
  it('includes its bytes, and those of the files to which a .gltf refers', async () => {
    const [a, b] = [write('a.glb', 'one'), write('b.glb', 'one')]
    expect(await files.identify(a, 'file')).toBe(await files.identify(b, 'file'))
    const gltf = write('c/face.gltf', '{"buffers": [{"uri": "face.bin"}]}')
    const without = await files.identify(gltf, 'file')
    write('c/face.bin', '1')
    const first = await files.identify(gltf, 'file')
    write('c/face.bin', '2')
    expect(new Set([without, first, await files.identify(gltf, 'file')]).size).toBe(3)
  })

  it.each([1, 30])('is read from %i files without a warning of Node', async (count) => {
    const warned = vi.fn()
    process.on('warning', warned)
    const images = Array.from({ length: count }, (_, i) => ({
      uri: write(`many/${i}.png`, `${i}`) && `${i}.png`,
    }))
    const gltf = write('many/face.gltf', JSON.stringify({ images }))
    await files.identify(gltf, 'file')
    await files.identify(join(root, 'many'), 'folder')
    // Node emits warnings in the next tick.
    await new Promise((done) => setTimeout(done))
    process.off('warning', warned)
    expect(warned).not.toHaveBeenCalled()
  })

  it('includes everything in a folder, with names', async () => {
    write('d/x.png', '1')
    const first = await files.identify(join(root, 'd'), 'folder')
    write('e/y.png', '1')
    expect(await files.identify(join(root, 'e'), 'folder')).not.toBe(first)
  })

  it('is refused if it changed since the batch began', async () => {
    const path = write('f.glb', 'one')
    const identity = await files.identify(path, 'file')
    expect(await files.fetch(path, identity, 'file', root)).toBe(path)
    write('f.glb', 'two')
    await expect(files.fetch(path, identity, 'file', root)).rejects.toThrow(
      /has changed since the batch started/,
    )
  })
})

describe('inputs', () => {
  it('are named by their path below the fixed part of the pattern', async () => {
    for (const name of ['a.glb', 'x/b.glb', 'x/c.txt']) write(`in/${name}`, name)
    const found = await listInputs([`${root}/in/**/*.glb`, join(root, 'in/a.glb')], 'file')
    expect(found.map(({ input }) => input)).toEqual([join(root, 'in/a.glb'), join(root, 'in/x/b.glb')])
    expect(found[1].name).toBe('x/b.glb')
    expect(nameOf('https://example.com/faces/a%20b.vrm?v=1')).toBe('a b.vrm')
    expect(nameOf('https://example.com/..%2f..%2fa.glb')).toBe('a.glb')
  })

  it.each([
    ['nothing.glb', 'it does not exist'],
    ['none/*.glb', 'no match'],
    [tmpdir(), 'it is a folder'],
  ])('are refused: %s', async (pattern, problem) => {
    await expect(listInputs([pattern], 'file')).rejects.toThrow(problem)
  })

  it('may not share an output, and none may be an output', async () => {
    const entry = (input: string, output: string) => ({ input, output, options: {} })
    await expect(checkEntries([entry('a', 'x.glb'), entry('b', './x.glb')], 'auto')).rejects.toThrow(
      'a and b have the same output',
    )
    await expect(checkEntries([entry('a', './b'), entry('b', 'y')], 'auto')).rejects.toThrow(
      'an output is a file that the batch reads',
    )
    await checkEntries([entry('a', 'x'), entry('b', 'y')], 'auto')
  })

  it('may not share an output through links either', async () => {
    const input = write('linked/in/a.glb', 'a')
    const link = join(root, 'linked/link')
    symlinkSync(join(root, 'linked/in'), link)
    symlinkSync(input, join(root, 'linked/a.glb'))
    const entry = (output: string) => ({ input, output, options: {} })
    for (const output of [join(link, 'a.glb'), join(root, 'linked/a.glb')])
      await expect(checkEntries([entry(output)], 'auto')).rejects.toThrow(
        'an output is a file that the batch reads',
      )
    const twice = ['in/new/b.glb', 'link/new/b.glb'].map((path) => entry(join(root, 'linked', path)))
    await expect(checkEntries(twice, 'auto')).rejects.toThrow('have the same output')
  })

  it('may not refer to a file that is an output', async () => {
    write('parts/face.gltf', '{"buffers": [{"uri": "face.glb"}], "images": [{"uri": "../outside.glb"}]}')
    for (const name of ['parts/face.glb', 'parts/wrinkles.glb', 'outside.glb', 'other.gltf'])
      write(name, name)
    write('parts/wrinkles.json', '{"layers": [{"normal": "../outside.glb"}]}')
    const at = (name: string) => join(root, name)
    const [auto, pack] = [at('parts/face.gltf'), at('parts')]
    const refused = [
      ['auto', auto, 'parts/face.glb', {}],
      ['auto', auto, 'outside.glb', {}],
      ['pack', pack, 'parts/wrinkles.glb', {}],
      ['pack', pack, 'outside.glb', {}],
      ['pack', at('d'), 'parts/face.glb', { face: auto }],
    ] as const
    for (const [command, input, output, options] of refused) {
      const entries = [{ input, output: at(output), options }]
      await expect(checkEntries(entries, command), output).rejects.toThrow(
        'an output is a file that the batch reads',
      )
    }
    await checkEntries([{ input: auto, output: at('parts/new.glb'), options: {} }], 'auto')
  })

  it('must be valid URLs if they look like URLs', async () => {
    for (const input of ['http://', 'https://[a/b.glb'])
      await expect(listInputs([input], 'file')).rejects.toThrow(`no input at ${input} (invalid URL)`)
  })

  it('are split into shards without overlap', () => {
    const inputs = Array.from({ length: 1000 }, (_, i) => `avatars/${i}.glb`)
    const shards = Array.from({ length: 8 }, (_, i) =>
      inputs.filter((one) => isInShard(one, parseShard(`${i + 1}/8`))),
    )
    expect(shards.flat().sort()).toEqual(inputs.sort())
    for (const shard of shards) expect(shard.length).toBeGreaterThan(90)
    for (const text of ['0/2', '3/2', '1', 'a/b']) expect(() => parseShard(text)).toThrow('It must be I/N')
  })
})

describe('a manifest', () => {
  it('has options per line, which override the common ones', async () => {
    const path = write(
      'jobs.jsonl',
      '\ufeff{"input": "a.glb", "output": "x/a.glb", "options": {"age": 60, "furrows": true}}\r\n\n{"input": "s3://b/c.glb"}\n',
    )
    expect(await readManifest(path, 'auto', options('--age', '40', '--size', '512'))).toEqual([
      { input: 'a.glb', output: 'x/a.glb', options: { age: '60', furrows: true, size: '512' } },
      { input: 's3://b/c.glb', options: { age: '40', size: '512' } },
    ])
  })

  it.each([
    ['{"input": "a"', 'line 2 is not JSON'],
    ['["a"]', 'line 2 is not an object'],
    ['{"output": "a"}', 'line 2 has no "input"'],
    ['{"input": "a", "age": 40}', 'line 2 has an unknown field "age"'],
    ['{"input": "a", "options": {"age": {}}}', 'line 2: invalid value of the option age'],
    ['{"input": "a", "options": 40}', 'line 2: "options" is not an object'],
    ['{"input": "a", "options": {"years": 40}}', "unknown option '--years'"],
  ])('with %s is refused', async (text, problem) => {
    const path = write('wrong.jsonl', `{"input": "a"}\n${text}\n`)
    await expect(readManifest(path, 'auto', {})).rejects.toThrow(problem)
  })
})

describe('a job', () => {
  const done: ProcessEnd = {
    end: 'report',
    report: { lines: ['{"file": "x", "errors": 0}'], warnings: [], exitCode: 0, memory: 1 },
  }
  const input = () => write('job.glb', 'face')

  async function run(...ends: ProcessEnd[]) {
    const identity = await files.identify(input(), 'file')
    const job: Job = { key: 'k', command: 'validate', input: input(), identity, options: {} }
    const pool = { run: vi.fn(async () => ends.shift()!) }
    const limits = { memory: 2 ** 30, seconds: 60 }
    return { outcome: await runJob(job, { pool, limits, scratch: root }), pool }
  }

  it('is done if its process succeeds', async () => {
    const { outcome, pool } = await run(done)
    expect(outcome).toMatchObject({ status: 'done', attempts: 1, result: { errors: 0 }, memory: 1 })
    expect(pool.run).toHaveBeenCalledWith({ command: 'validate', words: [join(root, 'job.glb'), '--json'] })
  })

  it.each([{ end: 'memory' }, { end: 'crash', reason: 'SIGSEGV' }] as const)(
    'is retried once if its process ends by $end',
    async (end) => {
      expect((await run(end, done)).outcome).toMatchObject({ status: 'done', attempts: 2 })
      expect((await run(end, end)).outcome).toMatchObject({ status: 'failed', kind: end.end, attempts: 2 })
    },
  )

  it('is not retried if it takes too long', async () => {
    const { outcome } = await run({ end: 'time' })
    expect(outcome).toMatchObject({ status: 'failed', kind: 'time', attempts: 1 })
    expect(outcome.reason).toMatch(/limit of 60 s; raise --timeout/)
  })

  it('is not retried if its file is refused, and the reason names the input', async () => {
    const failure = `furrow validate: ${join(root, 'job.glb')} is empty; name another`
    const { outcome } = await run({ ...done, report: { ...done.report, exitCode: 1, failure } })
    expect(outcome).toMatchObject({ status: 'failed', kind: 'file', attempts: 1, reason: failure })
  })

  it('leaves nothing behind, whatever its outcome', async () => {
    const scratch = mkdtempSync(join(root, 'scratch-'))
    const identity = await files.identify(input(), 'file')
    const job: Job = { key: 'k', command: 'auto', input: input(), identity, output: 'out.glb', options: {} }
    const pool = {
      run: vi.fn(async ({ words }: { words: string[] }): Promise<ProcessEnd> => {
        writeFileSync(join(words.at(-1)!, '..', '.furrow-1.tmp'), 'half a face')
        return { end: 'crash', reason: 'SIGSEGV' }
      }),
    }
    const outcome = await runJob(job, { pool, limits: { memory: 2 ** 30, seconds: 60 }, scratch })
    expect(outcome).toMatchObject({ status: 'failed', kind: 'crash' })
    expect(readdirSync(scratch)).toEqual([])
  })

  it('fails without a process if its input is missing', async () => {
    const job: Job = { key: 'k', command: 'auto', input: 'gone.glb', identity: 'sha256:0', options: {} }
    const pool = { run: vi.fn() }
    const outcome = await runJob(job, { pool, limits: { memory: 1, seconds: 1 }, scratch: root })
    expect(outcome).toMatchObject({ status: 'failed', kind: 'machine', attempts: 0 })
    expect(pool.run).not.toHaveBeenCalled()
  })
})

it('only temporary errors are retried', async () => {
  const reset = Object.assign(new Error('reset'), { code: 'ECONNRESET' })
  expect(isTransient(new Error('outer', { cause: reset }))).toBe(true)
  for (const status of [429, 503]) expect(isTransient({ status })).toBe(true)
  for (const error of [{ status: 404 }, { code: 'ENOENT' }, { code: 'ENOSPC' }, undefined, 'text']) {
    expect(isTransient(error)).toBe(false)
  }
  const work = vi.fn(async () => {
    throw reset
  })
  await expect(withRetries(work, [1, 1])).rejects.toBe(reset)
  expect(work).toHaveBeenCalledTimes(3)
})

it('runConcurrently does everything once, limits its concurrency and stops at an error', async () => {
  let [now, most] = [0, 0]
  const seen: number[] = []
  await runConcurrently([1, 2, 3, 4, 5], 2, async (item) => {
    most = Math.max(most, ++now)
    await new Promise((done) => setTimeout(done, 2))
    seen.push(item)
    now--
  })
  expect([seen.sort(), most]).toEqual([[1, 2, 3, 4, 5], 2])
  const begun: number[] = []
  const failing = runConcurrently([1, 2, 3, 4], 1, async (item) => {
    begun.push(item)
    if (item === 2) throw new Error('two')
  })
  await expect(failing).rejects.toThrow('two')
  expect(begun).toEqual([1, 2])
})

describe('a plan', () => {
  const source = { command: 'auto', version: '1', progress: () => {} } as const
  const entry = (name: string) => ({ input: join(root, name), output: join(root, 'out', name), options: {} })

  it('has one job for identical inputs, and copies the output', async () => {
    for (const name of ['p/a.glb', 'p/b.glb']) write(name, 'same')
    write('p/c.glb', 'other')
    const plan = await makePlan([entry('p/a.glb'), entry('p/b.glb'), entry('p/c.glb'), entry('p/gone.glb')], {
      ...source,
      earlier: new Map(),
    })
    expect(plan.tasks.map(({ entries }) => entries.length)).toEqual([2, 1])
    expect(plan.failed).toMatchObject([
      { input: join(root, 'p/gone.glb'), status: 'failed', kind: 'machine' },
    ])
    const lines: ResultLine[] = []
    const made: string[] = []
    const engine: Parameters<typeof runTasks>[1] = async (jobs, onOutcome) => {
      for (const job of jobs) {
        made.push(job.output!)
        await files.put(job.output!, Buffer.from('result'))
        await onOutcome(job, { status: 'done', warnings: [], bytes: 6, seconds: 1, attempts: 1 })
      }
    }
    await runTasks(plan.tasks, engine, (added) => void lines.push(...added))
    expect(made).toHaveLength(2)
    expect(readFileSync(join(root, 'out/p/b.glb'), 'utf8')).toBe('result')
    expect(lines.map(({ sameAs }) => sameAs)).toEqual([undefined, join(root, 'p/a.glb'), undefined])

    const results = openResults(join(root, 'results.jsonl'))
    for (const one of lines) results.add(one)
    results.close()
    // Simulates a batch that was interrupted while it wrote a line.
    writeFileSync(join(root, 'results.jsonl'), '{"key": "cut', { flag: 'a' })
    const earlier = readResults(join(root, 'results.jsonl'))
    writeFileSync(join(root, 'out/p/c.glb'), 'res')
    const again = await makePlan([entry('p/a.glb'), entry('p/b.glb'), entry('p/c.glb')], {
      ...source,
      earlier,
    })
    expect(again.kept).toHaveLength(2)
    expect(again.tasks.map(({ job }) => job.input)).toEqual([join(root, 'p/c.glb')])
    const other = await makePlan([entry('p/a.glb')], { ...source, version: '2', earlier })
    expect(other.tasks).toHaveLength(1)
    const more = openResults(join(root, 'results.jsonl'))
    more.add(line('later'))
    more.close()
    expect([...readResults(join(root, 'results.jsonl')).values()].at(-1)!.input).toBe('later')
  })

  // /dev/full is a device of Linux on which every write fails, as on a full disk.
  it.runIf(existsSync('/dev/full'))('ends with one line if the results cannot be written', () => {
    const results = openResults('/dev/full')
    expect(() => results.add(line('a'))).toThrow(/^furrow batch: cannot write \/dev\/full \(.*full/)
    results.close()
  })

  it('skips refused inputs, and retries other failures', async () => {
    write('p/a.glb', 'same')
    const first = await makePlan([entry('p/a.glb')], { ...source, earlier: new Map() })
    const { key, input, output } = first.tasks[0].job
    const failed = (kind: ResultLine['kind']) => {
      const earlier = line(input, { key, output: output!, status: 'failed', kind: kind!, reason: 'r' })
      return makePlan([entry('p/a.glb')], {
        ...source,
        earlier: new Map([[JSON.stringify([key, output]), earlier]]),
      })
    }
    expect((await failed('file')).tasks).toHaveLength(0)
    for (const kind of ['memory', 'time', 'crash', 'machine'] as const) {
      expect((await failed(kind)).tasks).toHaveLength(1)
    }
  })
})

describe('stored results', () => {
  const good = line('a.glb')

  it.each<[unknown, string]>([
    [null, 'a result must be an object'],
    [5, 'a result must be an object'],
    [{ ...good, input: 5 }, 'input must be text'],
    [{ ...good, status: 'maybe' }, 'status is unknown'],
    [{ ...good, warnings: 5 }, 'warnings must be an array'],
    [{ ...good, warnings: [{}] }, 'warnings[0] must be text'],
    [{ ...good, seconds: '1' }, 'seconds must be a number'],
    [{ ...good, bytes: -1 }, 'bytes is out of range'],
    [{ ...good, result: [] }, 'result must be an object'],
    [{ ...good, status: 'failed' }, 'reason must be text'],
  ])('are ignored if they are %j, with one line for all', (wrong, problem) => {
    const lines = [good, wrong, line('b.glb'), wrong]
    const path = write('bad.jsonl', `${lines.map((each) => JSON.stringify(each)).join('\n')}\n{"cut`)
    const warned = vi.spyOn(console, 'error').mockImplementation(() => {})
    expect([...readResults(path).values()]).toEqual([good, line('b.glb')])
    expect(warned.mock.calls).toHaveLength(1)
    expect(warned.mock.calls[0][0]).toContain(
      `furrow batch: ignored 2 invalid lines in ${path}, first in line 2`,
    )
    expect(warned.mock.calls[0][0]).toContain(problem)
    warned.mockRestore()
  })

  it('keep any text, and lose unknown fields', () => {
    const known = line('f\u00e4ce \u{1f600}.glb'.repeat(5000))
    const path = write('more.jsonl', JSON.stringify({ ...known, place: '../../etc', __proto__: null }))
    expect([...readResults(path).values()]).toEqual([known])
  })
})

describe('a queued job', () => {
  const job: Job = { key: 'k', command: 'auto', input: 'a', identity: 'i', output: 'a.glb', options: {} }

  it('is read as it was queued', () => {
    const options = parseJobOptions('auto', ['--age', '40', '--furrows', '--regions', 'neck', 'chin'])
    expect(parseJob(JSON.parse(JSON.stringify({ ...job, options })), 'test')).toEqual({ ...job, options })
  })

  it.each<[unknown, string]>([
    [null, 'a job must be an object'],
    [{ ...job, command: 'worker' }, 'command is unknown'],
    [{ ...job, input: undefined }, 'input must be text'],
    [{ ...job, output: '/home/me/.bashrc' }, 'invalid output for the command'],
    [{ ...job, command: 'validate' }, 'invalid output for the command'],
    [{ ...job, options: { report: '/home/me' } }, "unknown option '--report'"],
    [{ ...job, options: { strokes: 'x.json' } }, "unknown option '--strokes'"],
    [{ ...job, options: 5 }, '"options" is not an object'],
  ])('is refused if it is %j', (wrong, problem) => {
    expect(() => parseJob(wrong, 'test')).toThrow(problem)
  })
})

describe('the results page', () => {
  const page = (lines: ResultLine[]) =>
    batchPage({
      ...{ command: 'auto', lines, summary: 'all', results: 'results.jsonl', notes: ['no browser'] },
      linkTo: (output) => output,
      thumbnails: ({ key, status }) => (status === 'done' ? [`${key}-1.webp`, `${key}-2.webp`] : undefined),
    })

  it('shows failures, then warnings, then other inputs, with pictures and reasons', () => {
    const text = page([
      line('c.glb'),
      line('b.glb', { warnings: ['<odd>'] }),
      line('a.glb', { status: 'failed', reason: 'no face' }),
    ])
    const rows = [...text.matchAll(/<tr class="(\w+)">.*?<\/tr>/gs)]
    expect(rows.map(([, state]) => state)).toEqual(['failed', 'warned', 'done'])
    expect(rows[0][0]).toContain('no face')
    expect(rows[0][0]).not.toContain('<img')
    expect(rows[1][0]).toContain('&lt;odd&gt;')
    expect(rows[2][0]).toMatch(/b?c\.glb-1\.webp.*c\.glb-2\.webp/s)
    expect(text).toContain('no browser')
  })

  it('is not larger than allowed', () => {
    const text = page(Array.from({ length: MAX_ROWS + 5 }, (_, i) => line(`${i}.glb`)))
    expect(text.match(/<tr class/g)).toHaveLength(MAX_ROWS)
    expect(text).toContain('results.jsonl</a>.')
  })
})

it('counts the outcomes', () => {
  const lines = [
    line('a'),
    line('b', { sameAs: 'a' }),
    line('c', { status: 'failed' }),
    line('d', { warnings: ['w'] }),
  ]
  expect(countsText(countsOf(lines, 1))).toBe(
    '3 of 4 done, 1 failed, 1 with warnings, 1 identical to others, 1 from an earlier run',
  )
  expect(new Rate(0).text(10, 110, 20_000)).toBe('30.0/min, 200 s left'.replace('200 s', '4 min'))
  expect(new Rate(0).text(100, 150, 20_000)).toBe('5.0/s, 10 s left')
})
