import { join, resolve } from 'node:path'
import { Option } from 'commander'
import { FurrowError } from 'furrow'
import { createCommand } from '../../command.ts'
import { onInterruption } from '../../interruption.ts'
import { numberParser } from '../../options.ts'
import { checkFolder, checkReplaced } from '../../outputs.ts'
import { print } from '../../print.ts'
import { version } from '../../version.ts'
import type { Entry } from '../inputs/entry.ts'
import { listInputs, nameOf } from '../inputs/list-inputs.ts'
import { readManifest } from '../inputs/manifest.ts'
import { isInShard, parseShard, type Shard } from '../inputs/shard.ts'
import { JOB_COMMAND_NAMES, JOB_COMMANDS, type JobCommandName, passedOptions } from '../jobs/job-commands.ts'
import { givenOptions, type JobOptions } from '../jobs/job-options.ts'
import { LIMIT_OPTIONS, type LimitOptions, limitsOf } from '../limits.ts'
import { localEngine } from '../local-engine.ts'
import { isRemote } from '../places/places.ts'
import { checkEntries } from '../plan.ts'
import { ProcessPool } from '../processes/process-pool.ts'
import { redisEngine } from '../queue/redis-engine.ts'
import { type Batch, runBatch } from '../run-batch.ts'
import { openScratch } from '../scratch.ts'
import { countsText } from '../summary.ts'

const WHO = 'furrow batch'

/** Faces that are drawn for the page by default: without a GPU each takes a second or two. */
const DEFAULT_THUMBNAILS = 200

/** The folder of results where outputs go to no folder of this machine. */
const DEFAULT_RESULTS = 'furrow-batch'

interface Options extends LimitOptions {
  output?: string
  command: JobCommandName
  manifest?: string
  results?: string
  shard?: Shard
  redis?: string
  thumbnails: number
  json?: boolean
}

/** The options of a batch itself. */
const OWN_OPTIONS: readonly Option[] = [
  new Option('-o, --output <folder>', 'where outputs go: a folder, or s3://bucket/folder'),
  new Option('--command <name>', 'what to do with every input').choices(JOB_COMMAND_NAMES).default('auto'),
  new Option('--manifest <file>', 'a list of inputs, one JSON object per line: input, output, options'),
  new Option(
    '--results <folder>',
    `where results.jsonl and report.html go (default: the folder of outputs, or ${DEFAULT_RESULTS})`,
  ),
  new Option('--shard <i/n>', 'do one of n parts, 1/n to n/n: each on a machine of its own').argParser(
    parseShard,
  ),
  new Option('--redis <url>', 'hand the jobs to the workers at this Redis, see furrow worker').conflicts([
    'jobs',
    'memory',
    'timeout',
  ]),
  ...LIMIT_OPTIONS,
  new Option('--thumbnails <count>', 'faces that the page shows at most; 0 for none')
    .argParser(numberParser({ min: 0, max: 100_000, integer: true }))
    .default(DEFAULT_THUMBNAILS),
  new Option('--json', 'print the counts as JSON'),
]

/** `furrow batch`: one of several commands on many files. */
export const batchCommand = addOwnOptions(createCommand('batch'))
  .description('run auto, pack, validate or inspect on many files, on all cores or many machines')
  .argument(
    '[inputs...]',
    "files, patterns in quotes ('avatars/**/*.glb'), http and s3 addresses; folders for pack; s3://bucket/folder/ is all in it",
  )
  .allowUnknownOption()
  .addHelpText(
    'after',
    `
Options of the command, such as --age of furrow auto, are passed on. Started again, it goes on where it was. The exit code is 1
if an input failed.

Examples:
  $ furrow batch 'avatars/**/*.glb' -o wrinkled --age 40
  $ furrow batch --manifest jobs.jsonl --jobs 8 --memory 2048 --timeout 120 -o wrinkled
  $ furrow batch 'wrinkled/*.glb' --command validate --results checked
  $ furrow batch s3://avatars/in/ -o s3://avatars/out --redis redis://10.0.0.5:6379
  $ furrow batch 'avatars/*.glb' -o wrinkled --shard 3/8`,
  )
  .action(batch)

function addOwnOptions(command: ReturnType<typeof createCommand>) {
  for (const option of OWN_OPTIONS) command.addOption(option)
  return command
}

async function batch(
  _: string[],
  options: Options,
  { args }: ReturnType<typeof createCommand>,
): Promise<void> {
  const { inputs, passed } = parsePassed(options.command, args)
  const { output, manifest, shard, redis, thumbnails, json } = options
  const { reads, writes } = JOB_COMMANDS[options.command]
  if (inputs.length > 0 === (manifest !== undefined)) throw wrongInputs(inputs.length)
  if (output !== undefined && !isRemote(output)) await checkFolder(output, WHO)
  const listed: Listed[] =
    manifest === undefined
      ? (await listInputs(inputs, reads)).map((one) => ({ ...one, options: passed }))
      : await readManifest(manifest, options.command, passed)
  const all = listed.map((one) => entryOf(one, writes, output))
  await checkEntries(all, options.command)
  const entries = shard ? all.filter(({ input }) => isInShard(input, shard)) : all
  const results = options.results ?? (output === undefined || isRemote(output) ? DEFAULT_RESULTS : output)
  await checkFolder(results, WHO)
  const part = shard ? `-${shard.index}-of-${shard.count}` : ''
  const todo: Batch = {
    command: options.command,
    entries: redis === undefined ? entries : entries.map((entry) => absolute(entry, options.command)),
    results: join(results, `results${part}.jsonl`),
    page: join(results, `report${part}.html`),
    thumbnails,
  }
  // A manifest may be in the folder of results.
  checkReplaced([todo.results, todo.page], WHO)
  const counts =
    redis === undefined ? await runHere(todo, options) : await runBatch(todo, redisEngine(redis, version))
  if (counts.failed > 0) process.exitCode = 1
  const files = { results: todo.results, page: todo.page }
  print(json ? JSON.stringify({ ...counts, ...files }) : [countsText(counts), todo.results, todo.page])
}

/** On this machine, in processes that are gone when this one is. */
async function runHere(todo: Batch, options: Options) {
  const { lanes, limits } = limitsOf(options)
  const pool = new ProcessPool(limits)
  const takeBack = onInterruption(() => pool.close())
  const scratch = openScratch({ endsBySignal: true })
  try {
    return await runBatch(todo, localEngine({ pool, limits, scratch: scratch.path }, lanes))
  } finally {
    pool.close()
    scratch.remove()
    takeBack()
  }
}

/**
 * Parses what the batch itself did not know: options of the command that it runs, and inputs among them.
 *
 * @param words in their order, without the batch's own options.
 */
function parsePassed(
  name: JobCommandName,
  words: readonly string[],
): { inputs: string[]; passed: JobOptions } {
  // Its own options are there for the suggestion that follows a misspelt one.
  const parser = addOwnOptions(createCommand('batch')).argument('[inputs...]')
  const options = passedOptions(name)
  for (const option of options) parser.addOption(option)
  parser.action(() => {}).parse([...words], { from: 'user' })
  return { inputs: parser.args, passed: givenOptions(parser, options) }
}

/** Where the result of an input goes: what a manifest says, or its name below the folder of outputs. */
function entryOf({ name, output, ...entry }: Listed, writes: boolean, folder: string | undefined): Entry {
  if (!writes) return entry
  if (output !== undefined) {
    if (/\.(glb|vrm)$/i.test(output)) return { ...entry, output }
    throw wrongOutput(entry.input, 'its output is no .glb and no .vrm', output)
  }
  if (folder === undefined) throw wrongOutput(entry.input, 'it has no output')
  const parts = (name ?? nameOf(entry.input)).split(/[\\/]/)
  // Keys of S3 may hold anything.
  if (parts.includes('..')) throw wrongOutput(entry.input, 'its output would be outside of the folder')
  const last = parts.pop()!
  const file = /\.(glb|vrm)$/i.test(last) ? last : `${last.replace(/\.gltf$/i, '')}.glb`
  const path = [...parts, file].join('/')
  return { ...entry, output: isRemote(folder) ? `${folder.replace(/\/$/, '')}/${path}` : join(folder, path) }
}

/** An input, as a list or a manifest has it. */
interface Listed extends Entry {
  name?: string
}

function wrongOutput(input: string, problem: string, value?: string): FurrowError {
  const remedy = 'name a folder with -o, or an output ending in .glb or .vrm in the manifest'
  return new FurrowError({ code: 'usage', who: WHO, problem: `${input}: ${problem}`, value, remedy })
}

function wrongInputs(count: number): FurrowError {
  return new FurrowError({
    code: 'usage',
    who: WHO,
    problem: count === 0 ? 'no inputs' : 'inputs both on the command line and in a manifest',
    remedy: "name files, a pattern in quotes such as 'avatars/**/*.glb', or --manifest",
  })
}

/** Paths that mean the same wherever a worker was started. */
function absolute({ input, output, options, ...rest }: Entry, command: JobCommandName): Entry {
  const whole = (address: string) => (isRemote(address) ? address : resolve(address))
  const files: readonly string[] = JOB_COMMANDS[command].files
  const moved = Object.entries(options).map(([name, value]) => {
    return [name, files.includes(name) && typeof value === 'string' ? resolve(value) : value] as const
  })
  return {
    ...rest,
    input: whole(input),
    ...(output !== undefined && { output: whole(output) }),
    options: Object.fromEntries(moved),
  }
}
