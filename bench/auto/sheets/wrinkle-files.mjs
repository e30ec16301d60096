import { execFile } from 'node:child_process'
import { createHash } from 'node:crypto'
import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync } from 'node:fs'
import { availableParallelism } from 'node:os'
import { join } from 'node:path'
import { promisify } from 'node:util'
import { importSource } from '../../../scripts/lib/import-source.mjs'
import { say } from '../../../scripts/lib/run.mjs'

/**
 * Runs `furrow auto`. Skips results that the same generator has written.
 *
 * @param jobs `name` of the result, its `input`, the `root` of a built checkout, and further `options` of the command.
 * @param folder folder of the results.
 * @returns paths by name.
 */
export async function wrinkleFiles(jobs, folder) {
  const { runConcurrently } = await importSource('packages/cli/src/batch/run-concurrently.ts')
  mkdirSync(folder, { recursive: true })
  const stamps = new Map([...new Set(jobs.map(({ root }) => root))].map((root) => [root, stampOf(root)]))
  const wanted = jobs.map((job) => ({
    ...job,
    file: join(folder, `${job.name}-${stamps.get(job.root)}.glb`),
  }))
  const missing = wanted.filter(({ file }) => !existsSync(file))
  await runConcurrently(missing, availableParallelism(), async ({ name, input, root, options, file }, i) => {
    for (const old of readdirSync(folder).filter((old) => old.startsWith(`${name}-`)))
      rmSync(join(folder, old))
    const command = join(root, 'packages/cli/dist/main.js')
    await promisify(execFile)(process.execPath, [command, 'auto', input, '-o', file, ...options])
    say(`wrinkles ${i + 1}/${missing.length}: ${name}`)
  })
  return new Map(wanted.map(({ name, file }) => [name, file]))
}

/** Returns a hash of the built generator of a checkout. */
function stampOf(root) {
  const hash = createHash('sha256')
  for (const part of ['furrow', 'files']) {
    const built = join(root, 'packages/cli/dist', part)
    const names = readdirSync(built, { recursive: true }).filter((name) => name.endsWith('.js'))
    for (const name of names.sort()) hash.update(readFileSync(join(built, name)))
  }
  return hash.digest('hex').slice(0, 8)
}
