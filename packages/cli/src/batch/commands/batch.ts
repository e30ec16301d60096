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
import { checkEntries } from '../plan.ts'
import { ProcessPool } from '../processes/process-pool.ts'
import { redisEngine } from '../queue/redis-engine.ts'
import { type Batch, runBatch } from '../run-batch.ts'
import { openScratch } from '../scratch.ts'
import { isRemote } from '../stores/store-of.ts'
import { countsText } from '../summary.ts'

const WHO = 'furrow batch'

/** Default maximum number of thumbnails. Without a GPU, a thumbnail takes one or two seconds. */
const DEFAULT_THUMBNAILS = 200

/** Folder of the results if there is no output folder, or if it is remote. */
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

/** Options of `furrow batch`. All other options are passed to the command that it runs. */
const OWN_OPTIONS: readonly Option[] = [
  new Option('-o, --output <folder>', 'folder of the outputs, local or s3://'),
  new Option('--command <name>', 'command to run').choices(JOB_COMMAND_NAMES).default('auto'),
  new Option('--manifest <file>', 'read the inputs from a manifest (.jsonl)'),
  new Option(
    '--results <folder>',
    `folder of results and report (default: a local output folder, or ${DEFAULT_RESULTS})`,
  ),
  new Option('--shard <i/n>', 'process only part i of n, e.g. 3/8').argParser(parseShard),
  new Option('--redis <url>', 'send the jobs to workers; see furrow worker').conflicts([
    'jobs',
    'memory',
    'timeout',
  ]),
  ...LIMIT_OPTIONS,
  new Option('--thumbnails <count>', 'maximum number of thumbnails, 0 for none')
    .argParser(numberParser({ min: 0, max: 100_000, integer: true }))
    .default(DEFAULT_THUMBNAILS),
  new Option('--json', 'print the counts as JSON'),
]

export const batchCommand = addOwnOptions(createCommand('batch'))
  .description('run a command on many files in parallel')
  .argument('[inputs...]', 'files, quoted patterns, http(s) or s3 URLs')
  .allowUnknownOption()
  .addHelpText(
    'after',
    `
Other options, e.g. --age, are passed to the command that runs on each input.
If a batch was interrupted, run it again to resume it. results.jsonl contains
one line per input. The exit code is 1 if an input failed.

The inputs of --command pack are folders. An s3:// URL that ends in / means all
files below it. Each line of a manifest is a JSON object with the field input,
and optionally output and options.

Examples:
  $ furrow batch 'avatars/**/*.glb' -o wrinkled --age 40
  $ furrow batch s3://avatars/in/ -o s3://avatars/out --redis redis://10.0.0.5`,
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
  if (inputs.length > 0 === (manifest !== undefined)) throw inputsError(inputs.length)
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
    entries:
      redis === undefined ? entries : entries.map((entry) => withAbsolutePaths(entry, options.command)),
    results: join(results, `results${part}.jsonl`),
    page: join(results, `report${part}.html`),
    thumbnails,
  }
  // The results must not overwrite the manifest, which may be in the same folder.
  checkReplaced([todo.results, todo.page], WHO)
  const counts =
    redis === undefined ? await runHere(todo, options) : await runBatch(todo, redisEngine(redis, version))
  if (counts.failed > 0) process.exitCode = 1
  const files = { results: todo.results, page: todo.page }
  print(json ? JSON.stringify({ ...counts, ...files }) : [countsText(counts), todo.results, todo.page])
}

/** Runs the batch on this machine, in child processes. They end when this process ends. */
async function runHere(todo: Batch, options: Options) {
  const { concurrency, limits } = limitsOf(options)
  const pool = new ProcessPool(limits)
  const unregister = onInterruption(() => pool.close())
  const scratch = openScratch({ endsBySignal: true })
  try {
    return await runBatch(todo, localEngine({ pool, limits, scratch: scratch.path }, concurrency))
  } finally {
    pool.close()
    scratch.remove()
    unregister()
  }
}

/**
 * Parses the arguments that are not options of `furrow batch`: inputs, and options of the command.
 *
 * @param words arguments in their original order.
 */
function parsePassed(
  name: JobCommandName,
  words: readonly string[],
): { inputs: string[]; passed: JobOptions } {
  // Includes the options of `furrow batch`, although they are already parsed. So the parser can suggest one of them for a
  // misspelt option.
  const parser = addOwnOptions(createCommand('batch')).argument('[inputs...]')
  const options = passedOptions(name)
  for (const option of options) parser.addOption(option)
  parser.action(() => {}).parse([...words], { from: 'user' })
  return { inputs: parser.args, passed: givenOptions(parser, options) }
}

/**
 * Returns an input with its output path: the path from the manifest, or the name of the input inside the output folder.
 */
function entryOf({ name, output, ...entry }: Listed, writes: boolean, folder: string | undefined): Entry {
  if (!writes) return entry
  if (output !== undefined) {
    if (/\.(glb|vrm)$/i.test(output)) return { ...entry, output }
    throw invalidOutput(entry.input, 'the output is not a .glb or .vrm file', output)
  }
  if (folder === undefined) throw invalidOutput(entry.input, 'no output')
  const parts = (name ?? nameOf(entry.input)).split(/[\\/]/)
  // Unlike paths, S3 keys may contain `..`.
  if (parts.includes('..')) throw invalidOutput(entry.input, 'the output would be outside the folder')
  const last = parts.pop()!
  const file = /\.(glb|vrm)$/i.test(last) ? last : `${last.replace(/\.gltf$/i, '')}.glb`
  const path = [...parts, file].join('/')
  return { ...entry, output: isRemote(folder) ? `${folder.replace(/\/$/, '')}/${path}` : join(folder, path) }
}

/** Input from the command line or a manifest. `name` is the path of its output, relative to the output folder. */
interface Listed extends Entry {
  name?: string
}

function invalidOutput(input: string, problem: string, value?: string): FurrowError {
  const remedy = 'choose a folder with -o, or an output ending in .glb or .vrm in the manifest'
  return new FurrowError({ code: 'usage', who: WHO, problem: `${input}: ${problem}`, value, remedy })
}

function inputsError(count: number): FurrowError {
  return new FurrowError({
    code: 'usage',
    who: WHO,
    problem: count === 0 ? 'no inputs' : 'inputs on the command line and in a manifest',
    remedy: "give files, a quoted pattern such as 'avatars/**/*.glb', or --manifest",
  })
}

/** Makes local paths absolute, because a worker may run in another folder. */
function withAbsolutePaths({ input, output, options, ...rest }: Entry, command: JobCommandName): Entry {
  const absolute = (address: string) => (isRemote(address) ? address : resolve(address))
  const files: readonly string[] = JOB_COMMANDS[command].files
  const moved = Object.entries(options).map(([name, value]) => {
    return [name, files.includes(name) && typeof value === 'string' ? resolve(value) : value] as const
  })
  return {
    ...rest,
    input: absolute(input),
    ...(output !== undefined && { output: absolute(output) }),
    options: Object.fromEntries(moved),
  }
}
